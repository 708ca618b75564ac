//! Estimates the torque errors caused by errors of the recorded motion: the part of a residual that
//! is not due to the model.
//!
//! To first order the torque error of joint `i` is `sum_j (dt_i/dq_j) e_j + (dt_i/ddq_j) f_j + M_ij
//! g_j`, with `e f g` the errors of joint `j`'s position, velocity and acceleration. Encoder errors
//! are independent, so the variances add. The derivatives of the torque are difference quotients of
//! the model at samples spread over the log.

use crate::data::signal::{Motion, repeatability};
use crate::model::{Arm, States};
use crate::numerics::sums::squared_differences;

/// Most samples per stretch at which the derivatives are evaluated.
const SAMPLES: usize = 256;
/// Most stretches of motion that are kept: with [`SAMPLES`] of each, 3 MB for seven joints.
const STRETCHES: usize = 64;
/// Steps of the difference quotients: position, velocity, acceleration.
const STEPS: [f64; 3] = [1e-4, 1e-3, 1.0];

/// Standard deviation of each joint's torque, N m, due to errors of the motion. `errors`: standard
/// deviations of position, velocity and acceleration, per joint. The steps of friction are left
/// out.
pub fn torque_of_errors(arm: &dyn Arm, beta: &[f64], states: &States, errors: &[[f64; 3]]) -> Vec<f64> {
    let (dof, len) = (arm.dof(), states.len);
    if len == 0 || errors.len() != dof {
        return vec![0.0; dof];
    }
    let torque = |states: &States| {
        let mut out = vec![0.0; arm.base_pattern().len() * len];
        arm.base_regressor(states, &mut out);
        let mut rows = vec![0.0; dof * len];
        for (entry, &(row, column)) in out.chunks_exact(len).zip(arm.base_pattern()) {
            let friction = arm.base_parameters()[column].leader.is_coulomb();
            if beta[column] != 0.0 && !friction {
                rows[row * len..(row + 1) * len].iter_mut().zip(entry).for_each(|(t, w)| *t += w * beta[column]);
            }
        }
        rows
    };
    let plain = torque(states);
    let mut variance = vec![0.0; dof];
    for (joint, error) in errors.iter().enumerate() {
        for (order, (error, step)) in error.iter().zip(STEPS).enumerate().filter(|(_, (error, _))| **error > 0.0) {
            let mut moved = states.clone();
            let series = [&mut moved.q, &mut moved.dq, &mut moved.ddq][order].as_mut_slice();
            series[joint * len..(joint + 1) * len].iter_mut().for_each(|x| *x += step);
            let there = torque(&moved);
            for (row, variance) in variance.iter_mut().enumerate() {
                let span = row * len..(row + 1) * len;
                let squares: f64 =
                    there[span.clone()].iter().zip(&plain[span]).map(|(a, b)| ((a - b) / step).powi(2)).sum();
                *variance += squares / len as f64 * error * error;
            }
        }
    }
    variance.into_iter().map(f64::sqrt).collect()
}

/// At most `most` samples spread over a series of states, joint-major.
pub fn thinned(states: &States, most: usize) -> States {
    let step = states.len.div_ceil(most.max(1)).max(1);
    let picks: Vec<usize> = (0..states.len).step_by(step).collect();
    states.gather(&picks)
}

/// Composition of the residual per joint, N m: standard deviations whose squares add up.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ErrorBudget {
    /// White noise of the torque sensor.
    pub sensor: Vec<f64>,
    /// Errors of encoders and derivatives.
    pub motion: Vec<f64>,
    /// Error due to the remaining error of the rows' times.
    pub clock: Vec<f64>,
    /// Difference of the torque where the log repeats a motion, including the effects of sensor,
    /// motion and clock; `None` if no motion is repeated. Not part of the sum.
    pub repeatability: Option<Vec<f64>>,
    /// Remaining model error.
    pub left: Vec<f64>,
}

impl ErrorBudget {
    /// Root sum of squares of sensor, motion and clock, per joint, N m.
    pub fn floor(&self) -> Vec<f64> {
        let parts = self.sensor.iter().zip(&self.motion).zip(&self.clock);
        parts.map(|((s, m), c)| (s * s + m * m + c * c).sqrt()).collect()
    }

    /// Root sum of squares of motion and clock, per joint, N m.
    pub fn of_motion(&self) -> Vec<f64> {
        self.motion.iter().zip(&self.clock).map(|(m, c)| m.hypot(*c)).collect()
    }

    /// Limits the sensor to a model's error (per joint, N m), of which it is a part: at low rates the
    /// motion's own torque looks like noise. Limits motion and clock such that together with the
    /// sensor they do not exceed that error, since both are computed from estimates of the encoders'
    /// noise.
    pub fn within(mut self, error: &[f64]) -> Self {
        for (j, error) in error.iter().enumerate() {
            self.sensor[j] = self.sensor[j].min(*error);
            let (own, most) =
                (self.motion[j].hypot(self.clock[j]), (error.powi(2) - self.sensor[j].powi(2)).max(0.0).sqrt());
            if own > most {
                self.motion[j] *= most / own;
                self.clock[j] *= most / own;
            }
        }
        self
    }

    /// Sets the remaining part of a model's error, per joint, N m.
    pub fn of_errors(mut self, errors: &[f64]) -> Self {
        self.left = errors.iter().zip(self.floor()).map(|(e, f)| (e * e - f * f).max(0.0).sqrt()).collect();
        self
    }

    /// Joints, from 0, whose error is due more to the motion than to sensor and model together.
    pub fn limited_by_motion(&self) -> Vec<usize> {
        let of = |j: &usize| self.motion[*j].hypot(self.clock[*j]) > self.sensor[*j].hypot(self.left[*j]);
        (0..self.left.len()).filter(of).collect()
    }
}

/// Collects the data for a budget while logs are streamed.
#[derive(Debug, Clone, Default)]
pub struct BudgetCollector {
    /// Every `step`th stretch: states and errors of the motion.
    parts: Vec<(States, Vec<[f64; 3]>)>,
    step: usize,
    stretches: usize,
    /// Sums of squares of the torque noise behind the low-pass, and of the torque errors due to the
    /// clock.
    sensor: Vec<f64>,
    clock: Vec<f64>,
    samples: f64,
    /// Sums of squares of the differences between repetitions, and the time from which they are
    /// computed, s.
    repeats: (Vec<f64>, f64),
}

impl BudgetCollector {
    /// Adds a stretch of motion.
    pub fn absorb(&mut self, motion: &Motion) {
        let (dof, len) = (motion.dof(), motion.states.len);
        if len == 0 || motion.error.len() != dof {
            return;
        }
        self.sensor.resize(dof, 0.0);
        self.clock.resize(dof, 0.0);
        let weight = motion.core.len() as f64;
        for (j, tau) in motion.tau.chunks_exact(len).enumerate() {
            let noise = motion.torque_noise.get(j).copied().unwrap_or(0.0);
            self.sensor[j] += weight * noise * noise;
            let steps = squared_differences(&tau[1..], tau);
            self.clock[j] += weight * (motion.clock_error / motion.period).powi(2) * steps / len as f64;
        }
        if let Some((rms, seconds)) = repeatability(&motion.states.q, &motion.tau, len, motion.period) {
            self.repeats.0.resize(dof, 0.0);
            self.repeats.0.iter_mut().zip(rms).for_each(|(sum, rms)| *sum += seconds * rms * rms);
            self.repeats.1 += seconds;
        }
        self.samples += weight;
        if self.stretches.is_multiple_of(self.step.max(1)) {
            self.parts.push((thinned(&motion.states, SAMPLES), motion.error.clone()));
        }
        self.stretches += 1;
        if self.parts.len() > STRETCHES {
            let mut place = 0..;
            self.parts.retain(|_| place.next().is_some_and(|k: usize| k.is_multiple_of(2)));
            self.step = 2 * self.step.max(1);
        }
    }

    /// Number of stretches kept.
    #[cfg(test)]
    pub(in crate::identify) fn kept(&self) -> usize {
        self.parts.len()
    }

    /// Budget of a model with base parameters `beta` whose residual is `errors`, N m, per joint.
    pub fn finish(&self, arm: &dyn Arm, beta: &[f64], errors: &[f64]) -> Option<ErrorBudget> {
        let dof = arm.dof();
        if self.parts.is_empty() || self.sensor.len() != dof {
            return None;
        }
        let most = (SAMPLES / self.parts.len()).max(8);
        let mut motion = vec![0.0; dof];
        for (states, error) in &self.parts {
            let states = thinned(states, most);
            let one = torque_of_errors(arm, beta, &states, error);
            motion.iter_mut().zip(one).for_each(|(sum, s)| *sum += s * s / self.parts.len() as f64);
        }
        let root = |sum: &f64| (sum / self.samples.max(1.0)).sqrt();
        let budget = ErrorBudget {
            sensor: self.sensor.iter().map(root).collect(),
            clock: self.clock.iter().map(root).collect(),
            motion: motion.into_iter().map(f64::sqrt).collect(),
            repeatability: (self.repeats.1 > 0.0)
                .then(|| self.repeats.0.iter().map(|sum| (sum / self.repeats.1).sqrt()).collect()),
            left: Vec::new(),
        };
        Some(budget.of_errors(errors))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_reckoned_of_motion_is_no_more_than_a_model_errs() {
        let budget = ErrorBudget {
            sensor: vec![0.3, 0.3, 0.3],
            motion: vec![0.4, 3.0, 1.0],
            clock: vec![0.0, 4.0, 0.0],
            repeatability: None,
            left: vec![0.0; 3],
        };
        let found = budget.within(&[1.0, 0.5, 0.2]);
        // Unchanged if below the error; otherwise scaled down to it in proportion; zero if the
        // sensor alone exceeds it, which is limited, too.
        let wanted = [[0.4, 0.0], [0.24, 0.32], [0.0, 0.0]];
        for (j, [motion, clock]) in wanted.into_iter().enumerate() {
            assert!((found.motion[j] - motion).abs() < 1e-12 && (found.clock[j] - clock).abs() < 1e-12, "{found:?}");
        }
        assert!((found.floor()[1] - 0.5).abs() < 1e-12);
        assert_eq!(found.sensor, [0.3, 0.3, 0.2]);
    }

    /// Squares add up: 0.3, 0.4 and 1.2 N m make 1.3 N m.
    #[test]
    fn what_is_left_is_beside_the_floor() {
        let budget = ErrorBudget {
            sensor: vec![0.3, 2.0],
            motion: vec![0.4, 0.0],
            clock: vec![0.0; 2],
            ..ErrorBudget::default()
        };
        let left = budget.of_errors(&[1.3, 1.0]).left;
        assert!((left[0] - 1.2).abs() < 1e-12 && left[1] == 0.0, "{left:?}");
    }
}
