//! Measured data: logs, filtered motion, trajectories.

pub mod log;
pub mod signal;
pub mod trajectory;
