//! Drag at the contact: tangential friction, learned from the force estimate and predicted before
//! the estimate shows it.
//!
//! A roller dragged along its axis resists with half of the pressing force, within a tenth of a
//! second. The estimate shows it one low-pass later; by then the springs of the joint loop have
//! yielded, both tangentially and along the normal. But the time and direction of sliding are
//! planned. With `v_k` the planned velocity along each axis of the tool, drag is `-mu_k s(v_k) F`.
//! The three `mu_k` are learned during the motion: a gradient step per period on the difference of
//! the estimate to the prediction with the same delay.

use super::model::Tool;

/// Friction coefficients along the tool's axes, and the prediction through the estimate's low-pass.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Drag {
    coefficients: [f64; 3],
    /// Direction of sliding along each axis, -1 to 1; `late` is the same through the three poles of
    /// the estimate.
    sign: [f64; 3],
    late: [[f64; 3]; 3],
    axes: [[f64; 3]; 3],
}

/// Planned speed at which friction reaches two thirds of its level, m/s: some multiples of the tool
/// speed that a joint's smallest step per period causes.
const CREEP: f64 = 5e-3;
/// Learning rate, 1/s: a stroke of half a second is the most informative part.
const PACE: f64 = 5.0;
/// Largest friction coefficient; a sliding force above this is not friction.
const MOST: f64 = 1.5;

impl Drag {
    /// Clears the learned values.
    pub fn reset(&mut self) {
        *self = Self::default();
    }

    /// Coefficients along the tool's axes learned so far.
    pub fn coefficients(&self) -> &[f64; 3] {
        &self.coefficients
    }

    /// Updates the planned sliding directions; `share` is the fraction of its way that each pole of
    /// the estimate's low-pass covers in a period.
    pub(super) fn slide<const N: usize>(&mut self, tool: &Tool<N>, dq: &[f64; N], normal: &[f64; 3], share: f64) {
        let velocity: [f64; 3] = core::array::from_fn(|i| (0..N).map(|j| tool.jacobian[i][j] * dq[j]).sum());
        for k in 0..3 {
            let axis = [tool.rotation[0][k], tool.rotation[1][k], tool.rotation[2][k]];
            let out = dot(&axis, normal);
            let axis: [f64; 3] = core::array::from_fn(|i| axis[i] - out * normal[i]);
            let v = dot(&axis, &velocity);
            let size = v.abs();
            let sign = v * (size + CREEP) / (v * v + CREEP * size + CREEP * CREEP);
            // An axis along the normal has a zero tangential part, and no NaN must enter.
            (self.axes[k], self.sign[k]) = (axis, if sign.is_finite() { sign } else { 0.0 });
            let mut from = self.sign[k];
            for stage in &mut self.late {
                stage[k] += share * (from - stage[k]);
                from = stage[k];
            }
        }
    }

    /// Learns from an estimated tangential push of the tool, given relative to its normal push.
    pub(super) fn learn(&mut self, aside: &[f64; 3], dt: f64) {
        let late = self.late[2];
        let size: f64 = late.iter().map(|s| s * s).sum();
        let share = PACE * dt / (1.0 + PACE * dt * size);
        for k in 0..3 {
            let left = dot(aside, &self.axes[k]) - self.coefficients[k] * late[k] * dot(&self.axes[k], &self.axes[k]);
            let learned = self.coefficients[k] + share * late[k] * left;
            if learned.is_finite() {
                self.coefficients[k] = learned.clamp(0.0, MOST);
            }
        }
    }

    /// Tangential push of the tool relative to its normal push: now, and with the estimate's delay.
    pub(super) fn predicted(&self) -> [[f64; 3]; 2] {
        [self.sign, self.late[2]].map(|sign| {
            core::array::from_fn(|i| (0..3).map(|k| self.coefficients[k] * sign[k] * self.axes[k][i]).sum())
        })
    }
}

fn dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
