//! The convex subproblem of one step, solved by clarabel: `min g d + d B d / 2 + mu s` within
//! bounds, `c + C d <= s`, `0 <= s`, `|d| <= delta`.

use clarabel::algebra::CscMatrix;
use clarabel::solver::{DefaultSettingsBuilder, DefaultSolver, IPSolver, NonnegativeConeT, SolverStatus};
use nalgebra::DMatrix;

/// A row `values d <= bound`; if soft, `<= bound + s`.
pub(super) struct Row {
    /// Index of the first variable with a weight.
    pub(super) first: usize,
    pub(super) values: Vec<f64>,
    pub(super) bound: f64,
    pub(super) soft: bool,
}

/// Step, slack and multipliers of the rows.
pub(super) struct Step {
    pub(super) d: Vec<f64>,
    pub(super) slack: f64,
    pub(super) multipliers: Vec<f64>,
}

/// Solves the subproblem; `None` if the solver fails.
pub(super) fn solve(hessian: &DMatrix<f64>, gradient: &[f64], rows: &[Row], penalty: f64, radius: f64) -> Option<Step> {
    let n = gradient.len();
    // Upper triangle of B, then the slack, whose square keeps the problem strictly convex.
    let (mut column_start, mut row_index, mut entries) = (vec![0], Vec::new(), Vec::new());
    for k in 0..n {
        for i in 0..=k {
            row_index.push(i);
            entries.push(hessian[(i, k)]);
        }
        column_start.push(entries.len());
    }
    row_index.push(n);
    entries.push(1e-6 * penalty);
    column_start.push(entries.len());
    let p = CscMatrix::new(n + 1, n + 1, column_start, row_index, entries);
    let mut q = gradient.to_vec();
    q.push(penalty);

    let m = rows.len() + 1 + 2 * n;
    let mut columns: Vec<Vec<(usize, f64)>> = vec![Vec::new(); n + 1];
    let mut b = Vec::with_capacity(m);
    for (i, row) in rows.iter().enumerate() {
        for (k, value) in row.values.iter().enumerate() {
            if *value != 0.0 {
                columns[row.first + k].push((i, *value));
            }
        }
        if row.soft {
            columns[n].push((i, -1.0));
        }
        b.push(row.bound);
    }
    columns[n].push((rows.len(), -1.0));
    b.push(0.0);
    for k in 0..n {
        for (i, sign) in [(rows.len() + 1 + 2 * k, 1.0), (rows.len() + 2 + 2 * k, -1.0)] {
            columns[k].push((i, sign));
            b.push(radius);
        }
    }
    let (mut column_start, mut row_index, mut entries) = (vec![0], Vec::new(), Vec::new());
    for column in &columns {
        row_index.extend(column.iter().map(|e| e.0));
        entries.extend(column.iter().map(|e| e.1));
        column_start.push(entries.len());
    }
    let a = CscMatrix::new(m, n + 1, column_start, row_index, entries);
    let settings = DefaultSettingsBuilder::default()
        .verbose(false)
        .max_iter(60)
        .tol_gap_abs(1e-7)
        .tol_gap_rel(1e-7)
        .tol_feas(1e-8)
        .presolve_enable(false)
        .build()
        .ok()?;
    let mut solver = DefaultSolver::new(&p, &q, &a, &b, &[NonnegativeConeT(m)], settings).ok()?;
    solver.solve();
    match solver.solution.status {
        SolverStatus::Solved
        | SolverStatus::AlmostSolved
        | SolverStatus::MaxIterations
        | SolverStatus::InsufficientProgress => {}
        _ => return None,
    }
    let x = &solver.solution.x;
    if x.iter().any(|v| !v.is_finite()) {
        return None;
    }
    Some(Step { d: x[..n].to_vec(), slack: x[n].max(0.0), multipliers: solver.solution.z[..rows.len()].to_vec() })
}
