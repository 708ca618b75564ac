//! Stretch of filtered motion and torque, ready for the model.

use std::ops::Range;

use super::{Band, DeadZone};
use crate::model::States;

/// Filtered motion and torque of consecutive, evenly spaced samples of one segment.
///
/// Only the samples in `core` are used; the samples around it allow quantities computed from the
/// motion to be filtered as well.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Motion {
    /// Index of the segment within the log, from 0.
    pub segment: usize,
    /// Time of the first sample, s.
    pub start: f64,
    /// Time at which the segment begins, s; before `start` if filters must settle first.
    pub segment_start: f64,
    /// Sampling period, s.
    pub period: f64,
    /// Positions, velocities, accelerations, joint-major.
    pub states: States,
    /// Torques, joint-major, `dof * len`, N m.
    pub tau: Vec<f64>,
    /// Sign of each velocity (zero at rest), filtered by the same low-pass as the torque,
    /// joint-major; empty if velocities are set to zero. The low-pass rounds the steps of the
    /// Coulomb torque, and this series shows how. Where a joint is held at a reversal, the sign
    /// passes linearly from one level to the other. The signs of
    /// [`crate::data::signal::Prepare::sums`] follow those of the joints.
    pub sign: Vec<f64>,
    /// Samples to be used.
    pub core: Range<usize>,
    /// Interval between used samples.
    pub stride: usize,
    /// Standard deviation of the velocity error that the noise of `q` causes behind the filter,
    /// rad/s, per joint.
    pub velocity_noise: Vec<f64>,
    /// Standard deviation of the white noise of the recorded positions, rad, per joint
    /// ([`white_noise`](crate::data::signal::white_noise)). Unlike `velocity_noise` it contains no
    /// motion beyond the cutoff. Empty if velocities are not derived from positions.
    pub position_noise: Vec<f64>,
    /// Standard deviations of the errors of position, velocity and acceleration behind the
    /// low-pass, rad, rad/s, rad/s^2, per joint. They are due to passed noise and removed motion,
    /// up to twice its cutoff. Empty if derivatives are not computed from positions, or a segment
    /// is too short.
    pub error: Vec<[f64; 3]>,
    /// Standard deviation of the sensors' white noise that remains in `tau`, N m, per joint.
    pub torque_noise: Vec<f64>,
    /// Standard deviation of the remaining error of sample times that were estimated from the
    /// motion, s; 0 if the clock was not corrected.
    pub clock_error: f64,
    /// Whether each joint is at rest
    /// ([`Prepare::dead_zone`](crate::data::signal::Prepare::dead_zone)). Dry friction is then
    /// undetermined within its breakaway level, and `sign` is 0. Joint-major, followed by the
    /// velocity sums; empty if velocities are set to zero.
    pub resting: Vec<bool>,
    /// Definition of rest used for `resting`.
    pub dead_zone: DeadZone,
    /// Whether each joint sticks (does not move beyond the noise of its encoder), joint-major;
    /// empty if velocities are not derived from filtered positions.
    pub stuck: Vec<bool>,
    /// Highest frequency that the low-pass left in the torque, Hz; `None` if the torque was not
    /// filtered.
    pub bandwidth: Option<f64>,
    /// Effect of the low-pass on the positions, for all samples.
    pub band: Band,
    /// Temperatures as recorded, joint-major, deg C; empty if not requested or not recorded.
    pub temperature: Vec<f64>,
    /// Motor positions as recorded, referred to the joint side of the gears, joint-major, rad;
    /// empty if not requested or not recorded.
    pub motor: Vec<f64>,
    /// Joint torques measured behind the gears, as recorded, joint-major, N m; `tau` is then the
    /// torque of the gears alone. Empty if not requested.
    pub load: Vec<f64>,
    /// External wrench as recorded, `fx .. mz` one after the other, `6 * len`, N and N m, filtered
    /// like the torque; empty if not requested or not recorded.
    pub wrench: Vec<f64>,
}

/// A block of used samples of a motion, joint-major.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct MotionBlock {
    /// Positions, velocities, accelerations.
    pub states: States,
    /// Torques, N m.
    pub tau: Vec<f64>,
    /// [`Motion::sign`].
    pub sign: Vec<f64>,
    /// [`Motion::resting`].
    pub resting: Vec<bool>,
}

impl Motion {
    /// Indices of the samples to be used.
    pub fn picks(&self) -> impl ExactSizeIterator<Item = usize> + use<> {
        self.core.clone().step_by(self.stride.max(1))
    }

    /// Number of joints.
    pub fn dof(&self) -> usize {
        self.velocity_noise.len()
    }

    /// Time of a sample, s.
    pub fn time(&self, sample: usize) -> f64 {
        self.start + sample as f64 * self.period
    }

    /// Copies the used samples from number `from` on, at most `rows`, into `block`. Returns their
    /// number.
    pub fn gather(&self, from: usize, rows: usize, block: &mut MotionBlock) -> usize {
        let MotionBlock { states, tau, sign, resting } = block;
        let stride = self.stride.max(1);
        let first = self.core.start + from * stride;
        let count = if first >= self.core.end { 0 } else { (self.core.end - first).div_ceil(stride).min(rows) };
        let len = self.states.len;
        let pick = |source: &[f64], out: &mut Vec<f64>| {
            out.clear();
            for row in source.chunks_exact(len) {
                if stride == 1 {
                    out.extend_from_slice(&row[first..first + count]);
                } else {
                    out.extend((0..count).map(|i| row[first + i * stride]));
                }
            }
        };
        if count > 0 {
            states.len = count;
            pick(&self.states.q, &mut states.q);
            pick(&self.states.dq, &mut states.dq);
            pick(&self.states.ddq, &mut states.ddq);
            pick(&self.tau, tau);
            sign.clear();
            if self.sign.len() >= self.dof() * len {
                pick(&self.sign, sign);
            }
            resting.clear();
            for row in self.resting.chunks_exact(len) {
                resting.extend((0..count).map(|i| row[first + i * stride]));
            }
        }
        count
    }
}
