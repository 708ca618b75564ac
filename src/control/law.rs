//! The control law: joint loop (equation 13), force loop (equation 15), force estimate (equation
//! 14), and the monitoring of all of them.
//!
//! ```text
//! F_d - F -> [PI, limits] -> displacement along the normal -> [inverse kinematics] -> q_d -> [PD + gravity] -> torques
//!        ^                                                                                       |
//!        +---- (J^T)^+ (torques - model), or a sensor <------------------------------------ arm, wall
//! ```
//!
//! Uses `core` alone: no allocation, no panic, no square root. The caller provides the robot as
//! [`Model`] and [`Body`].

mod contact;
mod controller;
mod drag;
mod error;
mod estimate;
mod force;
mod joint;
mod least;
mod limits;
mod machine;
mod model;
mod rest;
mod settings;
mod stop;
mod watch;

pub use controller::{Command, Controller};
pub use drag::Drag;
pub use error::ControllerError;
pub use estimate::{Estimator, EstimatorSettings};
pub use force::{ForceLoop, ForceSettings};
pub use joint::JointLoop;
pub use least::damped;
pub use limits::Limits;
pub use machine::{Arrival, Bounds, Fault, Machine, Reaction, Seen, Status, Touch, Wanted};
pub use model::{Body, Model, Tool, moved};
pub use settings::{Settings, Target};
pub use watch::{Sample, Watch};
