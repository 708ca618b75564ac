//! Named constants of the robot file, m and rad.

#![allow(non_upper_case_globals)]

/// `L1` of the robot file.
pub const L1: f64 = 0.5;

/// `L2` of the robot file.
pub const L2: f64 = 0.4;
