//! Solves the constrained least squares by another method, for the tests: clarabel on cones that
//! approximate the true one from outside.
//!
//! `Z` is positive semidefinite if `V' Z V` is for every `V` of two columns. A 2 x 2 matrix is
//! positive semidefinite exactly if `(a + c, a - c, 2 b)` lies in the second-order cone. The method
//! starts with the six pairs of axes, solves, adds the pair of eigenvectors of the smallest
//! eigenvalues if one is negative, and repeats. Each round's optimum is below the true one; the
//! last violates no constraint by more than the tolerance.

use clarabel::algebra::CscMatrix;
use clarabel::solver::SupportedConeT::{NonnegativeConeT, SecondOrderConeT, ZeroConeT};
use clarabel::solver::{DefaultSettings, DefaultSolver, IPSolver, SolverError, SolverStatus};
use nalgebra::Vector4;

use super::newton::Problem;
use crate::model::pseudo_inertia::basis;

/// Reason why no optimum was found.
#[derive(Debug, thiserror::Error)]
pub(super) enum Halted {
    /// The solver rejects the problem.
    #[error(transparent)]
    Refused(#[from] SolverError),
    /// The solver ends without a solution in this round.
    #[error("clarabel: {status:?} in round {round}")]
    Unsolved { status: SolverStatus, round: usize },
    /// The constraints are still violated; largest violation of each round.
    #[error("still violated after {} rounds: {trace:?}", .trace.len())]
    StillViolated { trace: Vec<f64> },
}

/// Coordinates at the optimum of `1/2 |J v - z|^2` under the constraints, and the number of rounds.
pub(super) fn by_cuts(problem: &Problem, tolerance: f64, rounds: usize) -> Result<(Vec<f64>, usize), Halted> {
    let n = problem.j.ncols();
    let axis = |i: usize| Vector4::from_fn(|k, _| f64::from(u8::from(k == i)));
    let mut pairs: Vec<(usize, Vector4<f64>, Vector4<f64>)> = Vec::new();
    for link in &problem.links {
        for (i, k) in [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)] {
            pairs.push((link.start, axis(i), axis(k)));
        }
    }
    let mut trace = Vec::new();
    for round in 0..rounds {
        let mut rows: Vec<(Vec<(usize, f64)>, f64)> = Vec::new(); // s = a'v - b, in its cone
        let mut cones = Vec::new();
        if let Some(equal) = &problem.equal {
            rows.push((equal.a.clone(), equal.b));
            cones.push(ZeroConeT(1));
        }
        let linear = rows.len();
        rows.extend(problem.scalars.iter().map(|s| (vec![(s.index, 1.0)], 0.0)));
        rows.extend(problem.walls.iter().map(|w| (w.a.clone(), w.b)));
        cones.push(NonnegativeConeT(rows.len() - linear));
        for (start, u, v) in &pairs {
            let form = |x: &Vector4<f64>, y: &Vector4<f64>, k: usize| (x.transpose() * basis(k) * y)[(0, 0)];
            let all = |f: &dyn Fn(usize) -> f64| (0..10).map(|k| (start + k, f(k))).collect::<Vec<_>>();
            rows.push((all(&|k| form(u, u, k) + form(v, v, k)), 2.0 * problem.margin));
            rows.push((all(&|k| form(u, u, k) - form(v, v, k)), 0.0));
            rows.push((all(&|k| 2.0 * form(u, v, k)), 0.0));
            cones.push(SecondOrderConeT(3));
        }
        // The residual y = J v - z has separate variables: the objective is |y|^2 / 2.
        let data = problem.j.nrows();
        let first = rows.len();
        for row in 0..data {
            let mut a: Vec<(usize, f64)> = (0..n).map(|k| (k, problem.j[(row, k)])).filter(|a| a.1 != 0.0).collect();
            a.push((n + row, -1.0));
            rows.push((a, problem.z[row]));
        }
        cones.push(ZeroConeT(rows.len() - first));
        let (mut i, mut k, mut values, mut b) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        for (row, (a, bound)) in rows.iter().enumerate() {
            for &(column, value) in a {
                i.push(row);
                k.push(column);
                values.push(-value);
            }
            b.push(-bound);
        }
        let a = CscMatrix::new_from_triplets(rows.len(), n + data, i, k, values);
        let diagonal = |at: usize| f64::from(u8::from(at >= n));
        let p = CscMatrix::new_from_triplets(
            n + data,
            n + data,
            (0..n + data).collect(),
            (0..n + data).collect(),
            (0..n + data).map(diagonal).collect(),
        );
        let q = vec![0.0; n + data];
        let settings = DefaultSettings {
            verbose: false,
            tol_gap_abs: 1e-11,
            tol_gap_rel: 1e-11,
            tol_feas: 1e-11,
            iterative_refinement_reltol: 1e-16,
            iterative_refinement_abstol: 1e-16,
            iterative_refinement_max_iter: 50,
            iterative_refinement_stop_ratio: 1.5,
            max_iter: 300,
            ..DefaultSettings::default()
        };
        let mut solver = DefaultSolver::new(&p, &q, &a, &b, &cones, settings)?;
        solver.solve();
        let solution = &solver.solution;
        if !matches!(
            solution.status,
            SolverStatus::Solved | SolverStatus::AlmostSolved | SolverStatus::InsufficientProgress
        ) {
            return Err(Halted::Unsolved { status: solution.status, round });
        }
        let v = solution.x[..n].to_vec();
        let mut worst: f64 = 0.0;
        for link in &problem.links {
            let eigen = problem.inside(&v, link.start).symmetric_eigen();
            let mut order = [0, 1, 2, 3];
            order.sort_by(|&a, &b| eigen.eigenvalues[a].total_cmp(&eigen.eigenvalues[b]));
            let smallest = eigen.eigenvalues[order[0]];
            worst = worst.max(-smallest);
            if smallest < -tolerance {
                let column = |k: usize| eigen.eigenvectors.column(order[k]).into_owned();
                (1..4).for_each(|k| pairs.push((link.start, column(0), column(k))));
            }
        }
        trace.push(worst);
        if worst <= tolerance {
            return Ok((v, round + 1));
        }
    }
    Err(Halted::StillViolated { trace })
}
