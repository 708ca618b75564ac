//! Named constants of the robot file, m and rad.

#![allow(non_upper_case_globals)]

/// `H` of the robot file.
pub const H: f64 = 0.4;

/// `L1` of the robot file.
pub const L1: f64 = 0.325;

/// `L2` of the robot file.
pub const L2: f64 = 0.275;
