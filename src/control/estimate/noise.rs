//! Estimate of the torque noise from the log itself, without an identification.

use super::bias::{inside, within};
use super::torques::Torques;
use crate::control::estimate::residual_torque::pick;
use crate::data::signal::{Filter, Motion, white_noise};
use crate::identify::regression::rows::Rows;
use crate::model::Arm;

/// Sums over logs, per joint, in a first pass.
pub struct NoisePass<'a> {
    arm: &'a dyn Arm,
    torques: &'a dyn Torques,
    filter: Option<Filter>,
    free: Vec<[f64; 2]>,
    nothing_touches: bool,
    rows: Rows,
    /// Sum and sum of squares of the residual torque without contact.
    left: [Vec<f64>; 2],
    count: usize,
    /// Sum of the white-noise variance of the raw residual torque, times samples.
    squares: Vec<f64>,
    seen: usize,
    gain: f64,
}

impl<'a> NoisePass<'a> {
    /// Creates a pass; `free` are the stretches without contact, s. It may be empty.
    pub fn new(
        arm: &'a dyn Arm,
        torques: &'a dyn Torques,
        filter: Option<Filter>,
        free: &[[f64; 2]],
        nothing_touches: bool,
    ) -> Self {
        let zero = || vec![0.0; arm.dof()];
        Self {
            rows: Rows::new(arm),
            left: [zero(), zero()],
            squares: zero(),
            arm,
            torques,
            filter,
            free: within(free, filter),
            nothing_touches,
            count: 0,
            seen: 0,
            gain: 1.0,
        }
    }

    /// Adds a segment of motion.
    pub fn absorb(&mut self, motion: &Motion) {
        let picked = pick(self.arm, &self.rows, self.torques, motion, self.filter);
        let (count, len) = (picked.time.len(), motion.states.len);
        self.gain = self.filter.map_or(1.0, |f| f.noise_gain(motion.period.recip()));
        for s in 0..count {
            if self.nothing_touches || inside(&self.free, picked.time[s]) {
                self.count += 1;
                for j in 0..self.arm.dof() {
                    let e = picked.external[j * count + s];
                    self.left[0][j] += e;
                    self.left[1][j] += e * e;
                }
            }
        }
        self.seen += len;
        for (j, sum) in self.squares.iter_mut().enumerate() {
            let left: Vec<f64> = (j * len..(j + 1) * len).map(|k| picked.model[k] - picked.tau[k]).collect();
            *sum += len as f64 * white_noise([&left[..]].into_iter()).powi(2);
        }
    }

    /// Root mean square residual torque without contact, N m, about its mean if the mean is removed
    /// as a bias. Model errors count as noise. `None` if no sample is known to be free of contact.
    pub fn left(&self, about_mean: bool) -> Option<Vec<f64>> {
        let n = self.count as f64;
        let rms = |j: usize| {
            let mean = if about_mean { self.left[0][j] / n } else { 0.0 };
            (self.left[1][j] / n - mean * mean).max(0.0).sqrt().max(1e-9)
        };
        (self.count > 0).then(|| (0..self.squares.len()).map(rms).collect())
    }

    /// Sample-to-sample noise after the low-pass, N m: white noise only, without model errors.
    pub fn white(&self) -> Vec<f64> {
        let n = self.seen.max(1) as f64;
        self.squares.iter().map(|s| self.gain * (s / n).sqrt().max(1e-9)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::identify::planar::{Normal, Planar, motion};
    use crate::model::States;

    /// A model whose torque is zero.
    struct Nothing;

    impl Torques for Nothing {
        fn along(&self, _: &[f64], _: &States, _: &[f64], _: &[f64], out: &mut [f64]) {
            out.fill(0.0);
        }
    }

    /// For a residual with a bias, the deviation about its mean is the noise alone, and the root
    /// mean square is that of bias and noise.
    #[test]
    fn a_bias_is_no_noise_where_it_is_taken_off() {
        let arm = Planar::new();
        let mut motion = motion(&arm, 40.0, 200.0, 0.0);
        let (len, mut normal) = (motion.states.len, Normal::new(3));
        for (j, [bias, noise]) in [[4.0, 0.5], [-1.0, 2.0]].into_iter().enumerate() {
            motion.tau[j * len..(j + 1) * len].iter_mut().for_each(|t| *t = bias + noise * normal.next());
        }
        let mut pass = NoisePass::new(&arm, &Nothing, None, &[], true);
        pass.absorb(&motion);
        let [about, all] = [true, false].map(|about_mean| pass.left(about_mean).unwrap());
        for (j, [bias, noise]) in [[4.0_f64, 0.5], [-1.0, 2.0]].into_iter().enumerate() {
            assert!((about[j] / noise - 1.0).abs() < 0.05, "{about:?}");
            assert!((all[j] / bias.hypot(noise) - 1.0).abs() < 0.05, "{all:?}");
            assert!((pass.white()[j] / noise - 1.0).abs() < 0.05, "{:?}", pass.white());
        }
        let nowhere = NoisePass::new(&arm, &Nothing, None, &[], false);
        assert!(nowhere.left(true).is_none());
    }
}
