//! Named constants of the robot file, m and rad.

#![allow(non_upper_case_globals)]

/// `D1` of the robot file.
pub const D1: f64 = 0.1807;

/// `A2` of the robot file.
pub const A2: f64 = -0.6127;

/// `A3` of the robot file.
pub const A3: f64 = -0.57155;

/// `D4` of the robot file.
pub const D4: f64 = 0.17415;

/// `D5` of the robot file.
pub const D5: f64 = 0.11985;

/// `D6` of the robot file.
pub const D6: f64 = 0.11655;
