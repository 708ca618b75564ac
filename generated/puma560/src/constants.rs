//! Named constants of the robot file, m and rad.

#![allow(non_upper_case_globals)]

/// `A2` of the robot file.
pub const A2: f64 = 0.4318;

/// `A3` of the robot file.
pub const A3: f64 = -0.0203;

/// `D2` of the robot file.
pub const D2: f64 = 0.2435;

/// `D3` of the robot file.
pub const D3: f64 = -0.0934;

/// `D4` of the robot file.
pub const D4: f64 = 0.4331;
