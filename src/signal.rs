//! From measured samples to filtered joint motion: even clock, zero-phase low-pass, central differences.
//!
//! Rows of a log -> even clock -> low-pass, forward and backward -> derivatives -> [`Motion`]. A log of any length streams through
//! in bounded memory. Knows no robot.

mod band;
mod burst;
mod butterworth;
mod difference;
mod even;
mod motion;
mod prepare;
mod rest;
mod sos;
mod stick;

pub use band::Band;
pub use butterworth::{CutoffError, low_pass};
pub use difference::{central, central_second};
pub use even::even;
pub use motion::{Motion, MotionBlock};
pub use prepare::{Derivatives, Filter, Prepare, PrepareError, Prepared, Preparer, each_motion};
pub use rest::{DeadZone, white_noise};
pub use sos::{Biquad, Sos};
