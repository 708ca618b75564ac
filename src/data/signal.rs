//! Converts measured samples to filtered joint motion: even clock, zero-phase low-pass, central
//! differences.
//!
//! Rows of a log -> even clock -> low-pass, forward and backward -> derivatives -> [`Motion`]. Logs
//! of any length are processed as a stream in bounded memory. Independent of robots.

mod band;
mod breakaway_band;
mod clock;
mod deserved;
mod difference;
mod encoder_steps;
mod even;
mod lowered;
mod motion;
mod overlapped;
mod prepare;
mod repeat;
mod resample;
mod rest;
mod stiction;
mod torque_noise;

pub use crate::numerics::butterworth::{CutoffError, low_pass};
pub use crate::numerics::sos::{Biquad, Sos};
pub use band::Band;
pub use difference::{central, central_second};
pub use lowered::lower_cutoff;
pub use motion::{Motion, MotionBlock};
pub use overlapped::{each_motion, each_motion_in_turn};
pub use prepare::{Derivatives, Filter, Prepare, PrepareError, Prepared, Preparer};
pub use repeat::repeatability;
pub use resample::resample;
pub use rest::{DeadZone, white_noise};
pub use torque_noise::{noise_between_reversals, noise_with_memory};

#[cfg(test)]
mod tests;
