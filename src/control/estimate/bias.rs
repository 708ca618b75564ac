//! Bias removal: subtracts the mean residual torque over stretches without contact.
//!
//! Every constant part is removed: a sensor's offset, and of the torque error `W d` that the
//! parameter error `d` causes its mean over the stretch, `mean(W) d`. The remainder is
//! `(W - mean(W)) d`: the band narrows near the poses of the stretch and widens away from them. The
//! mean's own noise is added.

use nalgebra::DMatrix;

use super::torques::Torques;
use crate::control::estimate::residual_torque::pick;
use crate::data::signal::{Filter, Motion};
use crate::identify::regression::rows::Rows;
use crate::model::Arm;

/// Mean residual torque and mean regressor over stretches without contact.
#[derive(Debug, Clone, PartialEq)]
pub struct Bias {
    /// Model minus measured torque, one per joint, N m.
    pub torque: Vec<f64>,
    /// Mean regressor, `n x B`.
    pub(super) regressor: DMatrix<f64>,
    /// Total duration of the samples in the mean, s.
    pub seconds: f64,
}

/// Builds a [`Bias`] in a first pass over the logs.
pub struct BiasPass<'a> {
    arm: &'a dyn Arm,
    torques: &'a dyn Torques,
    filter: Option<Filter>,
    /// Stretches without contact, start and end, s.
    free: Vec<[f64; 2]>,
    rows: Rows,
    sum: Bias,
    count: usize,
}

impl<'a> BiasPass<'a> {
    /// Creates a pass over `free`: stretches without contact, start and end of each, s.
    pub fn new(arm: &'a dyn Arm, torques: &'a dyn Torques, filter: Option<Filter>, free: &[[f64; 2]]) -> Self {
        let regressor = DMatrix::zeros(arm.dof(), arm.base_parameters().len());
        let sum = Bias { torque: vec![0.0; arm.dof()], regressor, seconds: 0.0 };
        Self { rows: Rows::new(arm), arm, torques, filter, free: within(free, filter), sum, count: 0 }
    }

    /// Adds a segment of motion.
    pub fn absorb(&mut self, motion: &Motion) {
        let picked = pick(self.arm, &self.rows, self.torques, motion, self.filter);
        let count = picked.time.len();
        for (s, _) in picked.time.iter().enumerate().filter(|(_, t)| inside(&self.free, **t)) {
            self.count += 1;
            self.sum.seconds += motion.period * motion.stride.max(1) as f64;
            for (j, sum) in self.sum.torque.iter_mut().enumerate() {
                *sum += picked.external[j * count + s];
            }
            for (k, &(row, column)) in self.arm.base_pattern().iter().enumerate() {
                self.sum.regressor[(row, column)] += picked.entries[k * count + s];
            }
        }
    }

    /// Returns the mean; `None` if no sample lay in a stretch.
    pub fn finish(mut self) -> Option<Bias> {
        if self.count == 0 {
            return None;
        }
        let n = self.count as f64;
        self.sum.torque.iter_mut().for_each(|t| *t /= n);
        self.sum.regressor /= n;
        Some(self.sum)
    }
}

/// Shrinks the stretches, s, by what a low-pass smears into them: a step leaves less than a
/// thousandth after four periods of the cutoff. At least half of a short stretch remains.
pub(super) fn within(stretches: &[[f64; 2]], filter: Option<Filter>) -> Vec<[f64; 2]> {
    let margin = filter.map_or(0.0, |f| 4.0 / f.cutoff);
    let inner = |&[from, to]: &[f64; 2]| {
        let margin = margin.min(0.25 * (to - from));
        [from + margin, to - margin]
    };
    stretches.iter().map(inner).collect()
}

/// Whether a time, s, lies in one of the stretches.
pub(super) fn inside(stretches: &[[f64; 2]], time: f64) -> bool {
    stretches.iter().any(|[from, to]| (*from..=*to).contains(&time))
}
