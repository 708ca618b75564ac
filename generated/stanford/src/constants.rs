//! Named constants of the robot file, m and rad.

#![allow(non_upper_case_globals)]

/// `D1` of the robot file.
pub const D1: f64 = 0.412;

/// `D2` of the robot file.
pub const D2: f64 = 0.154;

/// `D6` of the robot file.
pub const D6: f64 = 0.263;
