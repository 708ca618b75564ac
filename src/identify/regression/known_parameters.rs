//! Removes the torque of known parameters from the factors, without reading the log again.

use crate::identify::regression::accumulator::{Factors, JointFactor};
use crate::identify::regression::batches::Batches;
use crate::identify::regression::r_factor::RFactor;
use crate::model::{Arm, Description, States};

/// An arm with some known base parameters: only the others are identified.
pub struct Known<'a> {
    arm: &'a dyn Arm,
    /// Value of each known base parameter.
    values: Vec<Option<f64>>,
    description: Description,
    /// Indices of the remaining entries in the whole arm's pattern.
    entries: Vec<usize>,
}

impl<'a> Known<'a> {
    /// `values`: value of each base parameter of `arm`, or `None`; parameters beyond the end of
    /// `values` are unknown.
    pub fn new(arm: &'a dyn Arm, values: &[Option<f64>]) -> Self {
        let all = arm.base_parameters();
        let values: Vec<Option<f64>> = (0..all.len()).map(|c| values.get(c).copied().flatten()).collect();
        let mut place = vec![None; all.len()];
        let mut base = Vec::new();
        for (column, parameter) in all.iter().enumerate().filter(|(c, _)| values[*c].is_none()) {
            place[column] = Some(base.len());
            base.push(parameter.clone());
        }
        let left = |(entry, &(row, column)): (usize, &(usize, usize))| place[column].map(|c| (entry, (row, c)));
        let (entries, pattern) = arm.base_pattern().iter().enumerate().filter_map(left).unzip();
        Self { description: Description { base, pattern, ..arm.description().clone() }, arm, values, entries }
    }

    /// Factors of a log of the whole arm, without the torque of the known parameters: `[W_u, tau -
    /// W_k beta_k] = [W tau] T`. So `R T` replaces the log.
    pub fn factors(&self, whole: &Factors) -> Factors {
        let joints = whole.joints.iter().map(|joint| self.joint(joint)).collect();
        Factors { name: whole.name.clone(), joints, seconds: whole.seconds, parameters: self.description.base.len() }
    }

    fn joint(&self, whole: &JointFactor) -> JointFactor {
        let n = whole.columns.len();
        let unknown: Vec<usize> = (0..n).filter(|&i| self.values[whole.columns[i]].is_none()).collect();
        // Coefficients of the torque minus its known part, over the whole joint's columns.
        let mut rest: Vec<f64> = whole.columns.iter().map(|&c| -self.values[c].unwrap_or(0.0)).collect();
        rest.push(1.0);
        let mut place = vec![0; self.values.len()];
        let mut next = 0;
        for (column, value) in self.values.iter().enumerate() {
            place[column] = next;
            next += usize::from(value.is_none());
        }
        let mut triangle = RFactor::new(unknown.len() + 1);
        let mut block = Vec::with_capacity((n + 1) * (unknown.len() + 1));
        for &i in &unknown {
            block.extend((0..=n).map(|row| if row <= i { whole.triangle.get(row, i) } else { 0.0 }));
        }
        block.extend(whole.triangle.apply(&rest));
        triangle.absorb(&mut block, n + 1);
        let mut batches = Batches::new();
        batches.size = whole.batches.size;
        batches.grams = whole.batches.grams.iter().map(|gram| congruent(gram, n + 1, &unknown, &rest)).collect();
        JointFactor {
            columns: unknown.iter().map(|&i| place[whole.columns[i]]).collect(),
            triangle,
            samples: whole.samples,
            independent: whole.independent,
            range: whole.range,
            reach: whole.reach,
            batches,
        }
    }

    /// All base parameters of the whole arm, given the unknown ones.
    pub fn whole(&self, unknown: &[f64]) -> Vec<f64> {
        let mut unknown = unknown.iter();
        self.values.iter().map(|known| known.or_else(|| unknown.next().copied()).unwrap_or(0.0)).collect()
    }
}

/// Product `T' G T`, column-major. `T` selects the columns `unknown` and appends the sum of all
/// columns weighted by `rest`.
fn congruent(gram: &[f64], n: usize, unknown: &[usize], rest: &[f64]) -> Vec<f64> {
    let m = unknown.len();
    let turned: Vec<f64> = (0..n).map(|i| (0..n).map(|k| gram[i + k * n] * rest[k]).sum()).collect();
    let mut out = vec![0.0; (m + 1) * (m + 1)];
    for (p, &i) in unknown.iter().enumerate() {
        for (q, &k) in unknown.iter().enumerate() {
            out[p + q * (m + 1)] = gram[i + k * n];
        }
        out[p + m * (m + 1)] = turned[i];
        out[m + p * (m + 1)] = turned[i];
    }
    out[m + m * (m + 1)] = turned.iter().zip(rest).map(|(a, b)| a * b).sum();
    out
}

impl Arm for Known<'_> {
    fn description(&self) -> &Description {
        &self.description
    }
    fn base_regressor(&self, states: &States, out: &mut [f64]) {
        let len = states.len;
        let mut whole = vec![0.0; self.arm.base_pattern().len() * len];
        self.arm.base_regressor(states, &mut whole);
        for (to, &entry) in out.chunks_exact_mut(len.max(1)).zip(&self.entries) {
            to.copy_from_slice(&whole[entry * len..(entry + 1) * len]);
        }
    }
    fn inverse_dynamics(&self, states: &States, standard: &[f64], out: &mut [f64]) {
        self.arm.inverse_dynamics(states, standard, out);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::identify::{
        AccumulatorSettings, IdentifySettings, QrAccumulator,
        planar::{Planar, motion},
        solve,
    };

    /// Factors from which known parameters were removed equal those of a log whose torque never
    /// contained them.
    #[test]
    fn taking_out_of_the_factors_is_taking_out_of_the_torque() {
        let arm = Planar::new();
        let truth = arm.beta();
        let mut whole = motion(&arm, 10.0, 100.0, 0.3);
        let len = whole.states.len;
        let wave = |k: usize| 0.1 * (k as f64 * 0.7).sin() + 0.05 * (k as f64 * 0.031).cos();
        whole.tau.iter_mut().enumerate().for_each(|(k, tau)| *tau += wave(k));
        let known: Vec<Option<f64>> = (0..truth.len()).map(|c| (c % 3 == 1).then(|| 1.2 * truth[c])).collect();
        let rest = Known::new(&arm, &known);
        let mut less = whole.clone();
        let beta: Vec<f64> = known.iter().map(|k| k.unwrap_or(0.0)).collect();
        let mut share = vec![0.0; 2 * len];
        crate::identify::planar::torque(&arm, &whole.states, &beta, &mut share);
        less.tau.iter_mut().zip(&share).for_each(|(tau, share)| *tau -= share);
        let stacked = |arm: &dyn Arm, motion| {
            let mut stack = QrAccumulator::new("log", arm, AccumulatorSettings::default());
            stack.absorb(motion);
            stack.finish()
        };
        let one = solve(&rest, &[rest.factors(&stacked(&arm, &whole))], &[], &IdentifySettings::default()).unwrap();
        let other = solve(&rest, &[stacked(&rest, &less)], &[], &IdentifySettings::default()).unwrap();
        assert_eq!(one.parameters.len(), truth.len() - known.iter().flatten().count());
        for (a, b) in one.parameters.iter().zip(&other.parameters) {
            assert_eq!(a.name, b.name);
            assert!((a.value - b.value).abs() < 1e-9 && (a.std / b.std - 1.0).abs() < 1e-6, "{a:?} {b:?}");
        }
        let whole = rest.whole(&one.values());
        assert!(known.iter().zip(&whole).all(|(k, w)| k.is_none_or(|k| k == *w)));
    }

    /// Compares with the Gram matrix of columns that are selected and summed first.
    #[test]
    fn a_gram_matrix_is_that_of_the_columns() {
        let a = nalgebra::DMatrix::from_fn(7, 4, |i, k| ((3 * i + 5 * k * k + i * k) % 11) as f64 - 5.0);
        let (unknown, rest) = ([2, 0], [0.5, -2.0, 3.0, 1.0]);
        let gram = a.tr_mul(&a);
        let mut b = a.select_columns(&unknown).insert_column(2, 0.0);
        b.set_column(2, &(&a * nalgebra::DVector::from_column_slice(&rest)));
        let found = congruent(gram.as_slice(), 4, &unknown, &rest);
        let wanted = b.tr_mul(&b);
        assert!(found.iter().zip(wanted.as_slice()).all(|(f, w)| (f - w).abs() < 1e-9), "{found:?} {wanted}");
    }
}
