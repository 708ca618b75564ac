//! The task as a nonlinear program over the variables of all joints: value, gradient, bounds,
//! constraints.

use crate::model::{Gradient, States};

use super::columns::Columns;
use super::constraints::{Constraint, Constraints};
use super::curve::Curve;
use super::information::{Information, Scaling, dot};
use super::subproblem::Row;
use super::task::Task;

/// Times of evaluation, with the linear map from variables to states. A variable affects a joint
/// during a part of the time only.
pub(super) struct Grid {
    pub(super) times: Vec<f64>,
    /// Per derivative and variable: index of the first time with a weight, and the weights from
    /// there on.
    weights: [Vec<(usize, Vec<f64>)>; 3],
}

impl Grid {
    pub(super) fn new(curve: &Curve, rate: f64) -> Self {
        let times = crate::data::trajectory::times(curve.design_duration(), rate);
        let weights = [0, 1, 2].map(|order| {
            let rows: Vec<Vec<f64>> = times.iter().map(|&t| curve.row(t, order)).collect();
            let of = |k: usize| {
                let counts = |row: &Vec<f64>| row[k] != 0.0;
                let first = rows.iter().position(counts).unwrap_or(0);
                let end = rows.iter().rposition(counts).map_or(first, |last| last + 1);
                (first, rows[first..end].iter().map(|row| row[k]).collect())
            };
            (0..curve.count()).map(of).collect()
        });
        Self { times, weights }
    }

    /// States of all joints at all times, for variables `x`.
    pub(super) fn states(&self, x: &[f64]) -> States {
        let len = self.times.len();
        let part = |weights: &[(usize, Vec<f64>)]| -> Vec<f64> {
            let mut all = vec![0.0; x.len() / weights.len() * len];
            for (to, x) in all.chunks_mut(len).zip(x.chunks(weights.len())) {
                for ((first, weights), x) in weights.iter().zip(x) {
                    to[*first..].iter_mut().zip(weights).for_each(|(to, w)| *to += w * x);
                }
            }
            all
        };
        let [q, dq, ddq] = &self.weights;
        States { len, q: part(q), dq: part(dq), ddq: part(ddq) }
    }

    /// Converts derivatives with respect to the states at all times to those with respect to the
    /// variables.
    fn pull(&self, by: &Gradient) -> Vec<f64> {
        let len = self.times.len();
        let mut to = vec![0.0; by.q.len() / len * self.weights[0].len()];
        for (weights, by) in self.weights.iter().zip([&by.q, &by.dq, &by.ddq]) {
            for (to, by) in to.chunks_mut(weights.len()).zip(by.chunks(len)) {
                for (to, (first, weights)) in to.iter_mut().zip(weights) {
                    *to += dot(&by[*first..*first + weights.len()], weights);
                }
            }
        }
        to
    }

    /// Adds a derivative with respect to the state of one joint at time `s`, converted to the
    /// variables of that joint.
    fn back(&self, s: usize, by: [f64; 3], to: &mut [f64]) {
        for (weights, by) in self.weights.iter().zip(by).filter(|(_, by)| *by != 0.0) {
            for (to, (first, weights)) in to.iter_mut().zip(weights) {
                *to += by * s.checked_sub(*first).and_then(|s| weights.get(s)).unwrap_or(&0.0);
            }
        }
    }
}

/// Bounds of a derivative, the same rows for every joint.
struct Bounds {
    order: usize,
    rows: Vec<Weights>,
    /// Share of the half range that the rows may use.
    share: f64,
}

/// A row without the zeros at its ends.
struct Weights {
    /// First variable of the joint that has a weight.
    first: usize,
    values: Vec<f64>,
    /// Sum of absolute values; `size` is the largest.
    sum: f64,
    size: f64,
}

impl Weights {
    fn new(row: &[f64]) -> Self {
        let first = row.iter().position(|v| *v != 0.0).unwrap_or(0);
        let end = row.iter().rposition(|v| *v != 0.0).map_or(first, |last| last + 1);
        let values = row[first..end].to_vec();
        let (sum, size) = values.iter().fold((0.0, 0.0_f64), |(sum, size), v| (sum + v.abs(), size.max(v.abs())));
        Self { first, values, sum, size }
    }
}

/// A bound that a step could violate.
pub(super) struct Bound<'p> {
    weights: &'p Weights,
    /// Index of the first variable.
    first: usize,
    sign: f64,
    /// Distance to the bound.
    room: f64,
    /// Largest possible change by a step.
    reach: f64,
}

impl Bound<'_> {
    /// Whether a step that goes this share of its way could violate it.
    pub(super) fn near(&self, share: f64) -> bool {
        self.room < share * self.reach
    }

    /// Whether this step violates it.
    pub(super) fn broken(&self, d: &[f64]) -> bool {
        let values = &self.weights.values;
        let value: f64 = values.iter().zip(&d[self.first..]).map(|(r, d)| r * d).sum();
        self.sign * value > self.room * (1.0 + 1e-6) + 1e-12 * self.weights.size
    }

    /// Row scaled to unit size, for the solver's conditioning.
    pub(super) fn row(&self) -> Row {
        let Weights { values, size, .. } = self.weights;
        let values = values.iter().map(|r| self.sign * r / size).collect();
        Row { first: self.first, values, bound: self.room / size, soft: false }
    }
}

/// Index of a constraint, and of its time on the grid.
pub(super) type Watched = (usize, usize);

/// A task on grids of a given fineness.
pub(super) struct Program<'a> {
    task: &'a Task<'a>,
    columns: Columns<'a>,
    scaling: Scaling,
    measure: Grid,
    pub(super) guard: Grid,
    pub(super) list: Vec<Constraint>,
    constraints: Constraints<'a>,
    bounds: Vec<Bounds>,
    count: usize,
    /// Divisor of the criterion, so that values are of order one per column.
    unit: f64,
}

impl<'a> Program<'a> {
    /// Creates a program. `measure`: sampling rate of the criterion, Hz; `guard`: that of the
    /// constraints, Hz; `refine`: number of hull pieces per interval.
    pub(super) fn new(task: &'a Task<'a>, measure: f64, guard: f64, refine: usize) -> Self {
        let columns = task.smooth_columns(measure);
        let constraints = task.constraints();
        let list = constraints.list();
        let orders = 0..=3;
        let bounds = orders
            .filter(|&order| task.limits.iter().any(|l| l.range(order).is_some()))
            .map(|order| {
                let bound = task.curve.bound(order, refine);
                Bounds { order, rows: bound.rows.iter().map(|row| Weights::new(row)).collect(), share: bound.share }
            })
            .collect();
        let unit = match task.criterion {
            super::Criterion::LogDet | super::Criterion::Hadamard => columns.count().max(1) as f64,
            _ => 1.0,
        };
        Self {
            scaling: task.scaling(task.rate / measure),
            measure: Grid::new(&task.curve, measure),
            guard: Grid::new(&task.curve, guard),
            columns,
            list,
            constraints,
            bounds,
            count: task.curve.count(),
            unit,
            task,
        }
    }

    /// Number of variables.
    pub(super) fn variables(&self) -> usize {
        self.count * self.task.dof()
    }

    /// The criterion per column and its gradient; `None` if it is undefined (information without
    /// full rank).
    pub(super) fn objective(&self, x: &[f64], power: f64) -> Option<(f64, Vec<f64>)> {
        let states = self.measure.states(x);
        let mut information = Information::new(&self.columns, &states, &self.scaling);
        if !self.task.criterion.by_gram() {
            information.sharpen(&self.columns, &self.scaling);
        }
        let (value, slope) = information.judge(&self.task.criterion, power)?;
        if !value.is_finite() {
            return None;
        }
        let (n, len) = (self.task.dof(), states.len);
        let mut by = Gradient { q: vec![0.0; n * len], dq: vec![0.0; n * len], ddq: vec![0.0; n * len] };
        information.pull(&self.columns, &states, &self.scaling, &slope, &mut by);
        let mut gradient = self.measure.pull(&by);
        gradient.iter_mut().for_each(|g| *g /= self.unit);
        gradient.iter().all(|g| g.is_finite()).then_some((value / self.unit, gradient))
    }

    /// Value of every constraint at every time of the guard grid.
    pub(super) fn guarded(&self, x: &[f64]) -> Vec<f64> {
        self.constraints.values(&self.list, &self.guard.states(x))
    }

    /// States at the times of the watched constraints.
    fn gathered(&self, x: &[f64], watched: &[Watched]) -> (States, Vec<Constraint>) {
        let samples: Vec<usize> = watched.iter().map(|&(_, s)| s).collect();
        (self.guard.states(x).gather(&samples), watched.iter().map(|&(c, _)| self.list[c]).collect())
    }

    /// Gradients of watched constraints with respect to the variables, one after the other.
    pub(super) fn gradients(&self, x: &[f64], watched: &[Watched]) -> Vec<Vec<f64>> {
        if watched.is_empty() {
            return Vec::new();
        }
        let (states, which) = self.gathered(x, watched);
        let by = self.constraints.gradients(&which, &vec![1.0; which.len()], &states);
        let row = |(k, &(_, s)): (usize, &Watched)| {
            let mut row = vec![0.0; self.variables()];
            for (j, to) in row.chunks_mut(self.count).enumerate() {
                let at = j * states.len + k;
                self.guard.back(s, [by.q[at], by.dq[at], by.ddq[at]], to);
            }
            row
        };
        watched.iter().enumerate().map(row).collect()
    }

    /// Gradient of a weighted sum of watched constraints.
    pub(super) fn weighted(&self, x: &[f64], watched: &[Watched], weights: &[f64]) -> Vec<f64> {
        let mut sum = vec![0.0; self.variables()];
        if watched.is_empty() {
            return sum;
        }
        let (states, which) = self.gathered(x, watched);
        let by = self.constraints.gradients(&which, weights, &states);
        for (k, &(_, s)) in watched.iter().enumerate() {
            for (j, to) in sum.chunks_mut(self.count).enumerate() {
                let at = j * states.len + k;
                self.guard.back(s, [by.q[at], by.dq[at], by.ddq[at]], to);
            }
        }
        sum
    }

    /// Calls `visit` with first variable, row, lower and upper bound of every bound of position and
    /// its derivatives.
    fn each_bound<'p>(&'p self, mut visit: impl FnMut(usize, &'p Weights, f64, f64)) {
        for Bounds { order, rows, share } in &self.bounds {
            for (j, limits) in self.task.limits.iter().enumerate() {
                let Some([low, high]) = limits.range(*order) else { continue };
                let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
                let half = half * share * if *order == 0 { 1.0 } else { self.task.share } * (1.0 - 1e-6);
                for row in rows {
                    visit(j * self.count + row.first, row, middle - half, middle + half);
                }
            }
        }
    }

    /// Bounds that a step from `x` of size `radius` could violate.
    pub(super) fn bounds(&self, x: &[f64], radius: f64) -> Vec<Bound<'_>> {
        let mut out = Vec::new();
        self.each_bound(|first, weights, low, high| {
            let value: f64 = weights.values.iter().zip(&x[first..]).map(|(r, x)| r * x).sum();
            let reach = radius * weights.sum;
            for (sign, room) in [(1.0, high - value), (-1.0, value - low)] {
                if room < reach {
                    out.push(Bound { weights, first, sign, room, reach });
                }
            }
        });
        out
    }

    /// Largest share of the way from `x` along `d` that the bounds allow.
    pub(super) fn room(&self, x: &[f64], d: &[f64]) -> f64 {
        let mut share: f64 = 1.0;
        self.each_bound(|first, weights, low, high| {
            let at = |v: &[f64]| -> f64 { weights.values.iter().zip(&v[first..]).map(|(r, v)| r * v).sum() };
            let (value, step) = (at(x), at(d));
            if value + step > high {
                share = share.min((high - value).max(0.0) / step);
            } else if value + step < low {
                share = share.min((low - value).min(0.0) / step);
            }
        });
        share
    }
}
