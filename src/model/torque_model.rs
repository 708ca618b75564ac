//! Torques with every known effect of a robot file.

use super::arm::States;

/// An arm whose torque sensor readings can be predicted: bodies, drives, and all their known
/// effects.
///
/// Torques are sensor readings, N m, joint-major like the states, `dof * len`.
pub trait TorqueModel: Sync {
    /// Degrees of freedom, `n`.
    fn dof(&self) -> usize;

    /// Torques from the present state alone: friction with memory has slipped (`sign(dq)`), gears
    /// are warm, and there is no delay.
    fn torques(&self, states: &States, out: &mut [f64]);

    /// Torques along recorded motion: bristles bend, gears warm up and torques are delayed with
    /// `time` (s, one per sample; a decrease marks the next recording). `temperature` (deg C,
    /// joint-major) may be empty.
    fn torques_along(&self, time: &[f64], states: &States, temperature: &[f64], out: &mut [f64]);

    /// The same for a part of a recording that began at `begun`, s: gears have been warming up
    /// since then, and laws count their time from it.
    fn torques_since(&self, _begun: f64, time: &[f64], states: &States, temperature: &[f64], out: &mut [f64]) {
        self.torques_along(time, states, temperature, out);
    }

    /// Delay of each joint's torque, s.
    fn delays(&self) -> Vec<f64>;

    /// Calibration of each joint's torque sensor: gain, and offset (N m) that is added. True
    /// torques, as a controller commands them, are `(measured - offset) / gain`.
    fn sensors(&self) -> Vec<[f64; 2]>;

    /// Breakaway level of each joint's static friction, N m, where a law of its drive gives one.
    fn breakaways(&self) -> Vec<Option<f64>> {
        vec![None; self.dof()]
    }
}
