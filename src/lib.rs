//! From a robot's DH table to closed-form Rust, and from a recorded motion to an identified model.

pub mod arm;
pub mod cli;
pub mod identify;
pub mod interpreted;
pub mod log;
pub mod numeric;
pub mod report;
pub mod signal;
