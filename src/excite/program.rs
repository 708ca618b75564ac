//! The task as a nonlinear program over the variables of all joints: value, gradient, bounds, constraints.

use crate::arm::{Gradient, States};

use super::columns::Columns;
use super::constraints::{Constraint, Constraints};
use super::curve::Curve;
use super::information::{Information, Scaling};
use super::subproblem::Row;
use super::task::Task;

/// Times at which something is evaluated, with the rows that lead from variables to states.
pub(super) struct Grid {
    pub(super) times: Vec<f64>,
    /// Per derivative, `times * count`.
    rows: [Vec<f64>; 3],
    count: usize,
}

impl Grid {
    pub(super) fn new(curve: &Curve, rate: f64) -> Self {
        let times = crate::trajectory::times(curve.design_duration(), rate);
        let rows = [0, 1, 2].map(|order| times.iter().flat_map(|&t| curve.row(t, order)).collect());
        Self { times, rows, count: curve.count() }
    }

    /// States of all joints at all times, for variables `x`.
    pub(super) fn states(&self, x: &[f64]) -> States {
        let len = self.times.len();
        let part = |rows: &[f64]| -> Vec<f64> {
            let joint = |x: &[f64]| -> Vec<f64> {
                rows.chunks(self.count).map(|row| row.iter().zip(x).map(|(r, x)| r * x).sum()).collect()
            };
            x.chunks(self.count).flat_map(joint).collect()
        };
        States { len, q: part(&self.rows[0]), dq: part(&self.rows[1]), ddq: part(&self.rows[2]) }
    }

    /// Adds what a derivative by the state of joint `j` at time `s` is by the variables of that joint.
    fn back(&self, s: usize, by: [f64; 3], to: &mut [f64]) {
        for (rows, by) in self.rows.iter().zip(by) {
            if by != 0.0 {
                let row = &rows[s * self.count..(s + 1) * self.count];
                to.iter_mut().zip(row).for_each(|(to, r)| *to += by * r);
            }
        }
    }
}

/// Which constraint, at which time of the grid.
pub(super) type Watched = (usize, usize);

/// A task on grids of some fineness.
pub(super) struct Program<'a> {
    task: &'a Task<'a>,
    columns: Columns<'a>,
    scaling: Scaling,
    measure: Grid,
    pub(super) guard: Grid,
    pub(super) list: Vec<Constraint>,
    constraints: Constraints<'a>,
    /// Rows of one joint and how much of the half range they may use, per derivative.
    bounds: Vec<(usize, Vec<Vec<f64>>, f64)>,
    count: usize,
    /// Divides the criterion, so that values are of order one per column.
    unit: f64,
}

impl<'a> Program<'a> {
    /// `measure`: samples per second of the criterion; `guard`: of the constraints; `refine`: hull pieces per interval.
    pub(super) fn new(task: &'a Task<'a>, measure: f64, guard: f64, refine: usize) -> Self {
        let columns = task.smooth_columns();
        let constraints = task.constraints();
        let list = constraints.list();
        let orders = 0..=3;
        let bounds = orders
            .filter(|&order| task.limits.iter().any(|l| l.range(order).is_some()))
            .map(|order| {
                let bound = task.curve.bound(order, refine);
                (order, bound.rows, bound.share)
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

    /// The criterion per column and its gradient; `None` where it is not defined (information without full rank).
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
        let mut gradient = vec![0.0; self.variables()];
        for (j, to) in gradient.chunks_mut(self.count).enumerate() {
            for s in 0..len {
                let at = j * len + s;
                self.measure.back(s, [by.q[at], by.dq[at], by.ddq[at]], to);
            }
        }
        gradient.iter_mut().for_each(|g| *g /= self.unit);
        gradient.iter().all(|g| g.is_finite()).then_some((value / self.unit, gradient))
    }

    /// Every constraint at every time of the guard grid.
    pub(super) fn guarded(&self, x: &[f64]) -> Vec<f64> {
        self.constraints.values(&self.list, &self.guard.states(x))
    }

    /// States at the times of some watched constraints.
    fn gathered(&self, x: &[f64], watched: &[Watched]) -> (States, Vec<Constraint>) {
        let (n, len) = (self.task.dof(), watched.len());
        let all = self.guard.states(x);
        let pick = |part: &[f64]| -> Vec<f64> {
            (0..n).flat_map(|j| watched.iter().map(move |&(_, s)| (j, s))).map(|(j, s)| part[j * all.len + s]).collect()
        };
        let states = States { len, q: pick(&all.q), dq: pick(&all.dq), ddq: pick(&all.ddq) };
        (states, watched.iter().map(|&(c, _)| self.list[c]).collect())
    }

    /// Gradients of watched constraints by the variables, one after the other.
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

    /// Calls with joint, row, lower and upper bound of every bound of position and its derivatives.
    fn each_bound(&self, mut visit: impl FnMut(usize, &[f64], f64, f64)) {
        for (order, rows, share) in &self.bounds {
            for (j, limits) in self.task.limits.iter().enumerate() {
                let Some([low, high]) = limits.range(*order) else { continue };
                let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
                let half = half * share * if *order == 0 { 1.0 } else { self.task.share } * (1.0 - 1e-6);
                for row in rows {
                    visit(j, row, middle - half, middle + half);
                }
            }
        }
    }

    /// Bounds on a step `d` from `x` that a step of size `radius` could break, with how far it could take them.
    pub(super) fn bound_rows(&self, x: &[f64], radius: f64) -> Vec<(Row, f64)> {
        let mut out = Vec::new();
        self.each_bound(|j, row, low, high| {
            let value: f64 = row.iter().zip(&x[j * self.count..]).map(|(r, x)| r * x).sum();
            let reach = radius * row.iter().map(|r| r.abs()).sum::<f64>();
            // Rows of unit size, as the solver likes them.
            let size = row.iter().fold(0.0_f64, |m, r| m.max(r.abs()));
            for (sign, room) in [(1.0, high - value), (-1.0, value - low)] {
                if room < reach {
                    let values = row.iter().map(|r| sign * r / size).collect();
                    let row = Row { first: j * self.count, values, bound: room / size, soft: false };
                    out.push((row, reach / size));
                }
            }
        });
        out
    }

    /// The largest share of the way from `x` along `d` that the bounds allow.
    pub(super) fn room(&self, x: &[f64], d: &[f64]) -> f64 {
        let mut share: f64 = 1.0;
        self.each_bound(|j, row, low, high| {
            let at = |v: &[f64]| -> f64 { row.iter().zip(&v[j * self.count..]).map(|(r, v)| r * v).sum() };
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
