//! From motion and torque to base parameters, with standard deviations that can be believed.
//!
//! [`Motion`](crate::signal::Motion)s -> [`Stack`]: one triangular factor per joint -> [`solve`]: weighted least squares on the small
//! stacked factors -> [`Identification`]. The log passes once; weights, essential parameters, validation and standard deviations
//! all come from the factors. Sees a robot only as an [`Arm`](crate::arm::Arm); prints nothing.

mod accuracy;
mod batches;
mod essential;
mod recover;
mod result;
mod rows;
mod sign;
mod solve;
mod spectrum;
mod stack;
mod statistics;
mod trace;
mod triangle;
mod wls;

#[cfg(test)]
mod planar;
#[cfg(test)]
mod tests;

pub use accuracy::{Accuracy, accuracy};
pub use essential::{Dropped, Essential};
pub use recover::{RecoverError, implausible_links, recover_standard};
pub use result::{Condition, Confused, Estimate, Identification, LogSummary, Standing};
pub use solve::{IdentifyError, IdentifySettings, solve};
pub use stack::{DeadZone, Factors, JointFactor, Stack, StackSettings};
pub use statistics::Noise;
pub use trace::{Trace, TraceJoint, Tracer};
pub use triangle::Triangle;
