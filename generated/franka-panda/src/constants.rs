//! Named constants of the robot file, m and rad.

#![allow(non_upper_case_globals)]

/// `L1` of the robot file.
pub const L1: f64 = 0.333;

/// `L2` of the robot file.
pub const L2: f64 = 0.316;

/// `L3` of the robot file.
pub const L3: f64 = 0.384;

/// `A` of the robot file.
pub const A: f64 = 0.0825;
