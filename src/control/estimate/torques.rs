//! Models of the torque sensors' readings.

use crate::identify::regression::rows::Rows;
use crate::model::{Arm, States, TorqueModel};

/// Predicts the readings of the torque sensors along a recorded motion.
pub trait Torques: Sync {
    /// Computes the torques at the sensors without contact, N m, joint-major like the states.
    /// `time`, s, has one evenly spaced value per sample. `sign`, if given, is the sign of each
    /// velocity, zero within its noise; `temperature`, deg C, may be empty.
    fn along(&self, time: &[f64], states: &States, sign: &[f64], temperature: &[f64], out: &mut [f64]);

    /// Computes the same torques for a part of a recording that began at `begun`, s.
    fn since(&self, _begun: f64, time: &[f64], states: &States, sign: &[f64], temperature: &[f64], out: &mut [f64]) {
        self.along(time, states, sign, temperature, out);
    }

    /// Breakaway level of a joint's static friction from its friction law, N m; `None` if the law
    /// has none.
    fn breakaway(&self, _joint: usize) -> Option<f64> {
        None
    }

    /// Gain of a joint's sensor: reading per true torque.
    fn gain(&self, _joint: usize) -> f64 {
        1.0
    }
}

/// A model with effects: drives with memory, sensor errors, delayed torques. The external wrench is
/// then estimated with the delay of the torques.
pub struct Effected<'a>(pub &'a dyn TorqueModel);

impl Torques for Effected<'_> {
    fn along(&self, time: &[f64], states: &States, _: &[f64], temperature: &[f64], out: &mut [f64]) {
        self.0.torques_along(time, states, temperature, out);
    }

    fn since(&self, begun: f64, time: &[f64], states: &States, _: &[f64], temperature: &[f64], out: &mut [f64]) {
        self.0.torques_since(begun, time, states, temperature, out);
    }

    fn breakaway(&self, joint: usize) -> Option<f64> {
        self.0.breakaways().get(joint).copied().flatten()
    }

    fn gain(&self, joint: usize) -> f64 {
        self.0.sensors().get(joint).map_or(1.0, |s| s[0]).clamp(0.01, 100.0)
    }
}

/// A model linear in its base parameters: the rigid arm with viscous and Coulomb friction, rotors
/// and offsets.
pub struct Linear<'a> {
    arm: &'a dyn Arm,
    rows: Rows,
    beta: Vec<f64>,
}

impl<'a> Linear<'a> {
    /// Creates a model with these base parameters.
    pub fn new(arm: &'a dyn Arm, beta: &[f64]) -> Self {
        Self { arm, rows: Rows::new(arm), beta: beta.to_vec() }
    }
}

impl Torques for Linear<'_> {
    fn along(&self, _: &[f64], states: &States, sign: &[f64], _: &[f64], out: &mut [f64]) {
        let len = states.len;
        let mut entries = Vec::new();
        self.rows.evaluate(self.arm, states, sign, &mut entries);
        out.fill(0.0);
        for (entry, &(row, column)) in entries.chunks_exact(len.max(1)).zip(self.arm.base_pattern()) {
            let out = &mut out[row * len..(row + 1) * len];
            out.iter_mut().zip(entry).for_each(|(t, w)| *t += w * self.beta[column]);
        }
    }
}
