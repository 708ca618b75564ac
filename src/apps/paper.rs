//! Reruns of the paper's experiments (Katsumata et al., *Optimal exciting motion for fast robot
//! identification*). Each function returns rows with our value, the paper's value and a verdict.
//!
//! `robot file + effects -> simulate -> signal -> identify`; each table or figure of the paper has
//! a file of its own. The "real" robot is simulated; its known properties are in [`lwr`]. The
//! module prints nothing and touches no file: the robot is built in.

pub mod chain;
pub mod diagnosis;
mod error;
pub mod excitation;
pub mod fig10;
pub mod fig6;
pub mod force;
pub mod honesty;
pub mod identification;
mod loaded;
pub mod lwr;
mod many;
pub mod motions;
pub mod painting;
pub mod table2;
pub mod table3;
mod tally;
pub mod tool;
mod verdict;

#[cfg(test)]
mod tests;

pub use error::{DesignObstacle, ReproduceError};
pub use excitation::{Excitation, ExcitationSettings, excitation};
pub use force::{Force, ForceSettings, force};
pub use identification::{Experiment, IdentificationSettings, identification};
pub use painting::{Painting, PaintingSettings, painting};
pub use tally::Tally;
pub use verdict::Verdict;

/// Progress callback, called from any thread with the present step and the share done, 0 to 1.
pub type Watch<'a> = &'a (dyn Fn(&str, f64) + Sync);
