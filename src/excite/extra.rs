//! Additional columns of the regressor from a caller: friction laws to cover, hypotheses to
//! separate.

use crate::model::{Gradient, States};

/// Columns in addition to the base regressor's.
pub trait Extra: Sync {
    /// Number of columns.
    fn columns(&self) -> usize;

    /// Row (joint) and column of each non-zero entry.
    fn pattern(&self) -> &[(usize, usize)];

    /// Writes entry `k` of the pattern at sample `s` to `out[k * len + s]`. A sample's entries
    /// depend only on that sample's state.
    fn evaluate(&self, states: &States, out: &mut [f64]);

    /// Adds the derivative of `sum of seeds * entries` with respect to the states. By default by
    /// central differences, six evaluations per joint.
    fn vjp(&self, states: &States, seeds: &[f64], to: &mut Gradient) {
        let (len, n) = (states.len, states.q.len() / states.len.max(1));
        let mut out = vec![0.0; self.pattern().len() * len];
        for part in 0..3 {
            for j in 0..n {
                for (sign, step) in [(1.0, 1e-6), (-1.0, -1e-6)] {
                    let mut moved = states.clone();
                    let column = part_of([&mut moved.q, &mut moved.dq, &mut moved.ddq], part);
                    column[j * len..(j + 1) * len].iter_mut().for_each(|v| *v += step);
                    self.evaluate(&moved, &mut out);
                    let target = part_of([&mut to.q, &mut to.dq, &mut to.ddq], part);
                    for (at, (value, seed)) in out.iter().zip(seeds).enumerate() {
                        target[j * len + at % len] += sign * seed * value / 2e-6;
                    }
                }
            }
        }
    }
}

fn part_of(parts: [&mut Vec<f64>; 3], part: usize) -> &mut Vec<f64> {
    let [q, dq, ddq] = parts;
    match part {
        0 => q,
        1 => dq,
        _ => ddq,
    }
}

/// Columns of a richer friction law; a motion that determines them all visits low and high speeds
/// in both directions. The columns are per joint `|v|` (viscous friction that differs with
/// direction), `exp(-(v/vs)^2) sign v` (Stribeck) and, if the model has no offset, 1 (Coulomb
/// friction that differs with direction).
pub struct FrictionCoverage {
    /// Speed `vs` below which a speed is low, per joint.
    slow: Vec<f64>,
    /// Speed over which a sign changes smoothly, per joint.
    turn: Vec<f64>,
    pattern: Vec<(usize, usize)>,
    offset: bool,
}

impl FrictionCoverage {
    /// Columns for joints with these largest speeds; a tenth of them counts as low. `offset`: with
    /// the column of ones.
    pub fn new(speeds: &[f64], offset: bool) -> Self {
        let each = 2 + usize::from(offset);
        Self {
            slow: speeds.iter().map(|v| 0.1 * v).collect(),
            turn: speeds.iter().map(|v| 0.02 * v).collect(),
            pattern: (0..speeds.len() * each).map(|k| (k / each, k)).collect(),
            offset,
        }
    }
}

impl Extra for FrictionCoverage {
    fn columns(&self) -> usize {
        self.pattern.len()
    }

    fn pattern(&self) -> &[(usize, usize)] {
        &self.pattern
    }

    fn evaluate(&self, states: &States, out: &mut [f64]) {
        let (len, each) = (states.len, 2 + usize::from(self.offset));
        for (k, column) in out.chunks_mut(len.max(1)).enumerate() {
            let j = k / each;
            for (value, v) in column.iter_mut().zip(&states.dq[j * len..]) {
                let sign = (v / self.turn[j]).tanh();
                let low = (-(v / self.slow[j]).powi(2)).exp();
                *value = [v * sign, low * sign, 1.0][k % each];
            }
        }
    }

    fn vjp(&self, states: &States, seeds: &[f64], to: &mut Gradient) {
        let (len, each) = (states.len, 2 + usize::from(self.offset));
        for (k, column) in seeds.chunks(len.max(1)).enumerate() {
            let j = k / each;
            for (s, seed) in column.iter().enumerate() {
                let v = states.dq[j * len + s];
                let sign = (v / self.turn[j]).tanh();
                let dsign = (1.0 - sign * sign) / self.turn[j];
                let low = (-(v / self.slow[j]).powi(2)).exp();
                let dlow = -2.0 * v / self.slow[j].powi(2) * low;
                to.dq[j * len + s] += seed * [sign + v * dsign, dlow * sign + low * dsign, 0.0][k % each];
            }
        }
    }
}

/// The columns of one after those of another.
pub(super) struct Both<'a> {
    parts: [&'a dyn Extra; 2],
    pattern: Vec<(usize, usize)>,
}

impl<'a> Both<'a> {
    pub(super) fn new(first: &'a dyn Extra, second: &'a dyn Extra) -> Self {
        let moved = second.pattern().iter().map(|&(row, column)| (row, column + first.columns()));
        Self { pattern: first.pattern().iter().copied().chain(moved).collect(), parts: [first, second] }
    }
}

impl Extra for Both<'_> {
    fn columns(&self) -> usize {
        self.parts[0].columns() + self.parts[1].columns()
    }

    fn pattern(&self) -> &[(usize, usize)] {
        &self.pattern
    }

    fn evaluate(&self, states: &States, out: &mut [f64]) {
        let (first, second) = out.split_at_mut(self.parts[0].pattern().len() * states.len);
        self.parts[0].evaluate(states, first);
        self.parts[1].evaluate(states, second);
    }

    fn vjp(&self, states: &States, seeds: &[f64], to: &mut Gradient) {
        let (first, second) = seeds.split_at(self.parts[0].pattern().len() * states.len);
        self.parts[0].vjp(states, first, to);
        self.parts[1].vjp(states, second, to);
    }
}
