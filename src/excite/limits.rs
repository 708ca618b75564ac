//! Limits of a joint, with defaults for limits missing in the robot file.

use std::f64::consts::PI;

use super::error::LimitsError;

/// Limits of one joint; rad (m for a prismatic joint) and its time derivatives, N m (N).
#[derive(Debug, Clone, PartialEq)]
pub struct JointLimits {
    /// Name of the joint, for messages.
    pub name: String,
    /// Lower and upper position.
    pub position: [f64; 2],
    /// Largest speed.
    pub velocity: f64,
    /// Largest acceleration.
    pub acceleration: f64,
    /// Largest jerk, if limited.
    pub jerk: Option<f64>,
    /// Largest torque, if limited.
    pub torque: Option<f64>,
}

/// A limit missing in the file, and its replacement.
#[derive(Debug, Clone, PartialEq)]
pub struct Missing {
    /// Name of the joint.
    pub joint: String,
    /// `position`, `acceleration`, `torque`, `links`, `collision`.
    pub limit: &'static str,
    /// Description of the replacement.
    pub taken: String,
    /// Value of the replacement: rad or m, or s.
    pub value: Option<f64>,
}

impl JointLimits {
    /// Takes the limits of a file. The speed limit is required, and so are position limits of a
    /// prismatic joint. A revolute joint without position limits is kept within one turn either
    /// way. Without an acceleration limit a joint may reach its speed limit in `acceleration_time`,
    /// s.
    ///
    /// # Errors
    /// Names the missing key.
    pub fn new(
        name: &str,
        revolute: bool,
        limits: &dh_codegen::robot::Limits,
        acceleration_time: f64,
        missing: &mut Vec<Missing>,
    ) -> Result<Self, LimitsError> {
        let mut note = |limit: &'static str, taken: String, value: Option<f64>| {
            missing.push(Missing { joint: name.to_string(), limit, taken, value });
        };
        let velocity = limits.velocity.filter(|v| *v > 0.0).ok_or_else(|| LimitsError::Velocity(name.into()))?;
        let position = match limits.position {
            Some(range) => range,
            None if revolute => {
                note("position", "no limit in the file: kept within one turn either way".into(), None);
                [-2.0 * PI, 2.0 * PI]
            }
            None => return Err(LimitsError::Position(name.into())),
        };
        let acceleration = limits.acceleration.unwrap_or_else(|| {
            let taken = velocity / acceleration_time;
            let how = format!("no limit in the file: full speed in {acceleration_time} s");
            note("acceleration", how, Some(taken));
            taken
        });
        if limits.torque.is_none() {
            note("torque", "no limit in the file: not checked".into(), None);
        }
        Ok(Self { name: name.to_string(), position, velocity, acceleration, jerk: limits.jerk, torque: limits.torque })
    }

    /// Lower and upper bound of the derivative of this order; `None` if it is not limited.
    pub fn range(&self, order: usize) -> Option<[f64; 2]> {
        let both = |x: f64| [-x, x];
        match order {
            0 => Some(self.position),
            1 => Some(both(self.velocity)),
            2 => Some(both(self.acceleration)),
            _ => self.jerk.map(both),
        }
    }
}
