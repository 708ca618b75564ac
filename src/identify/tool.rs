//! Identifies the ten inertial parameters of a body in the arm's hand, and finds the matching tool
//! of a table (the paper's section II.E).
//!
//! Unloaded and loaded logs -> [`Carrying`] arms -> factors -> [`identify_tool`] -> [`Carried`].

mod body;
mod carrying;
mod catalogue;
mod found;
mod identify;
mod interpolate;
mod pca;
mod recognise;
mod robot_errors;
pub(crate) mod shape;
mod table;

pub use body::{Body, moving};
pub use carrying::{Carrying, names};
pub use catalogue::{FLANGE, MINI_ROLLERS, RollerSeries, WALL_ROLLERS, catalogue};
pub use found::{Found, InToolFrame, look_up};
pub use identify::{Carried, LogError, RobotErrors, ToolError, ToolSettings, identify_tool};
pub use interpolate::{Interval, Relative, interpolate};
pub use pca::Pca;
pub use recognise::{Candidate, RecogniseSettings, Recognition, recognise};
pub use shape::{Assembly, Axis};
pub use table::{Entry, Tolerance};
