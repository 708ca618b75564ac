//! Torques with every known effect of a robot file.

use super::arm::States;

/// An arm whose torque sensors can be foretold: bodies, drives, and every effect that is known of
/// them.
///
/// Torques are what the sensors say, N m, joint-major like the states, `dof * len`.
pub trait TorqueModel: Sync {
    /// Degrees of freedom, `n`.
    fn dof(&self) -> usize;

    /// From the present state alone: friction with memory has slipped (`sign(dq)`), gears are warm,
    /// nothing is late.
    fn torques(&self, states: &States, out: &mut [f64]);

    /// Along recorded motion: bristles bend, gears warm and torques are late with `time` (s, one
    /// per sample; where it does not rise another recording begins). `temperature` (deg C,
    /// joint-major) may be empty.
    fn torques_along(&self, time: &[f64], states: &States, temperature: &[f64], out: &mut [f64]);

    /// The same of a part of a recording that began at `begun`, s: gears have been warming since
    /// then, and laws count their time from it.
    fn torques_since(&self, _begun: f64, time: &[f64], states: &States, temperature: &[f64], out: &mut [f64]) {
        self.torques_along(time, states, temperature, out);
    }

    /// How late each joint's torque is, s.
    fn delays(&self) -> Vec<f64>;

    /// Calibration of each joint's torque sensor: gain, and offset (N m) that is added. True
    /// torques, as a controller has to command them, are `(measured - offset) / gain`.
    fn sensors(&self) -> Vec<[f64; 2]>;

    /// Breakaway level of each joint's static friction, N m, where a law of its drive gives one.
    fn breakaways(&self) -> Vec<Option<f64>> {
        vec![None; self.dof()]
    }
}
