//! Limits of a joint, with the defaults that stand for what a robot file leaves out.

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
    /// Largest jerk, where it is limited.
    pub jerk: Option<f64>,
    /// Largest torque, where it is limited.
    pub torque: Option<f64>,
}

/// Limits missing in the file, and their replacements.
#[derive(Debug, Clone, PartialEq)]
pub struct Missing {
    /// Name of the joint.
    pub joint: String,
    /// `position`, `acceleration`, `torque`, `links`, `collision`.
    pub limit: &'static str,
    /// The replacement.
    pub taken: String,
    /// Replacements, rad or m and seconds.
    pub value: Option<f64>,
}

impl JointLimits {
    /// From a file's limits. The speed must be there, and the travel of a prismatic joint. A
    /// revolute joint without travel turns without end and is kept within one turn either way;
    /// without acceleration limit it may reach its speed in half a second (`acceleration_time`).
    ///
    /// # Errors
    /// Names the key that is missing.
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

    /// Lower and upper bound of the derivative of this order, where there is one.
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
