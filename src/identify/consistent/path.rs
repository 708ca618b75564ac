//! Follows the central path to a neighbourhood of the minimum by a primal-dual method.
//!
//! A body `Z` and its dual force `S`, exerted by the cone, satisfy `S Z = t 1`; `t` decreases to
//! the value set by the distance to the prior. Steps are Newton's in the scaling of Nesterov and
//! Todd, in which body and force are alike (Y. Nesterov, M. Todd, *Self-scaled barriers*, 1997; M.
//! Todd, K. Toh, R. Tutuncu, SIAM J. Optimization 8(3), 1998). This needs some tens of steps, where
//! primal steps alone need hundreds in long valleys. With `G' S G = G^-1 Z G^-T = diag(lambda)` a
//! step changes the scaled body by `D` and the scaled force by `t / lambda - lambda - D`.

use nalgebra::{DMatrix, DVector, Matrix4, SymmetricEigen, Vector4};

use super::newton::{Problem, Stalled, Wall, Weights};
use super::stacked::Stacked;
use crate::model::pseudo_inertia::{basis, coordinates, symmetric};

/// A cone in the Nesterov-Todd scaling.
struct Scaled {
    g: Matrix4<f64>,
    inverse: Matrix4<f64>,
    lambda: Vector4<f64>,
}

impl Scaled {
    fn new(body: &Matrix4<f64>, force: &Matrix4<f64>) -> Option<Self> {
        let (l, k) = (body.cholesky()?.l(), force.cholesky()?.l());
        let svd = (k.transpose() * l).svd(false, true);
        let lambda = svd.singular_values;
        let half = lambda.map(f64::sqrt);
        let v_t = svd.v_t?;
        let g = l * v_t.transpose() * Matrix4::from_diagonal(&half.map(f64::recip));
        let inverse = Matrix4::from_diagonal(&half) * v_t * l.try_inverse()?;
        g.iter().chain(inverse.iter()).all(|x| x.is_finite()).then_some(Self { g, inverse, lambda })
    }

    /// Largest step, up to 1, that covers at most nine tenths of the distance to the boundary for
    /// `diag(lambda) + step D`.
    fn longest(&self, d: &Matrix4<f64>) -> f64 {
        let root = Matrix4::from_diagonal(&self.lambda.map(|x| x.sqrt().recip()));
        let least = SymmetricEigen::new(root * d * root).eigenvalues.min();
        if least < 0.0 { (0.9 / -least).min(1.0) } else { 1.0 }
    }
}

/// A positive linear function and its dual force.
struct Single {
    row: Vec<(usize, f64)>,
    bound: f64,
    /// Coefficient of the function in the objective's linear term.
    linear: f64,
    floor: f64,
    force: f64,
}

impl Single {
    fn slack(&self, v: &DVector<f64>) -> f64 {
        self.row.iter().map(|&(i, a)| a * v[i]).sum::<f64>() - self.bound
    }
}

/// Least-squares rows of bodies, single functions and weak priors in the scaling, for the target
/// `t`.
fn rows(
    problem: &Problem,
    v: &DVector<f64>,
    (scaled, floors, singles): (&[Scaled], &[f64], &[Single]),
    t: f64,
    mu: f64,
) -> (DMatrix<f64>, DVector<f64>) {
    let rows = 10 * scaled.len() + singles.len() + problem.free.len();
    let (mut a, mut b) = (DMatrix::zeros(rows, v.len()), DVector::zeros(rows));
    let mut row = 0;
    for ((link, cone), floor) in problem.links.iter().zip(scaled).zip(floors) {
        for k in 0..10 {
            let d = coordinates(&(cone.inverse * basis(k) * cone.inverse.transpose()));
            a.view_mut((row, link.start + k), (10, 1)).copy_from(&d);
        }
        let linear = cone.g.transpose() * cone.g * (floor / (1.0 - problem.margin));
        let target = Matrix4::from_diagonal(&cone.lambda.map(|x| t.max(*floor) / x));
        b.rows_mut(row, 10).copy_from(&coordinates(&(target - linear)));
        row += 10;
    }
    for s in singles {
        let x = s.slack(v);
        let g = (x / s.force).sqrt();
        s.row.iter().for_each(|&(i, c)| a[(row, i)] += c / g);
        b[row] = g * (t.max(s.floor) / x - s.linear);
        row += 1;
    }
    for &(i, v0) in &problem.free {
        a[(row, i)] = mu.sqrt();
        b[row] = mu.sqrt() * (v0 - v[i]);
        row += 1;
    }
    (a, b)
}

/// Forces that balance the bodies at `t`, or at their floor; those of `singles` are set. `None`
/// outside a cone.
fn balancing(
    problem: &Problem,
    v: &DVector<f64>,
    floors: &[f64],
    singles: &mut [Single],
    t: f64,
) -> Option<Vec<Matrix4<f64>>> {
    singles.iter_mut().for_each(|s| s.force = t.max(s.floor) / s.slack(v).max(f64::MIN_POSITIVE));
    let bodies = problem.links.iter().map(|link| problem.inside(v.as_slice(), link.start));
    bodies.zip(floors).map(|(body, floor)| Some(body.cholesky()?.inverse() * t.max(*floor))).collect()
}

/// Coordinates near the minimum of [`Problem::value`], and the number of steps.
pub(super) fn near(
    problem: &Problem,
    stacked: &Stacked<'_>,
    start: &[f64],
    weights: Weights,
) -> Result<(DVector<f64>, usize), Stalled> {
    const MOST: usize = 200;
    let mut v = DVector::from_column_slice(start);
    let floors: Vec<f64> = problem.links.iter().map(|l| weights.w * l.share).collect();
    let mut singles: Vec<Single> = problem
        .scalars
        .iter()
        .map(|s| {
            let floor = if s.known { weights.w } else { weights.mu };
            Single { row: vec![(s.index, 1.0)], bound: 0.0, linear: floor, floor, force: 0.0 }
        })
        .chain(problem.walls.iter().map(|Wall { a, b }| Single {
            row: a.clone(),
            bound: *b,
            linear: 0.0,
            floor: weights.mu,
            force: 0.0,
        }))
        .collect();
    let degree = (4 * floors.len() + singles.len()).max(1) as f64;

    // Starts with a target as strong as the pull of the misfit.
    let gradient = problem.j.tr_mul(&(&problem.j * &v - &problem.z));
    let pull = gradient.dot(&v).abs() / degree;
    let mut t = pull.clamp(1.0, 1e12).max(weights.w).max(weights.mu);
    let outside = Stalled { w: weights.w, steps: 0, decrement: f64::INFINITY };
    let mut forces = balancing(problem, &v, &floors, &mut singles, t).ok_or(outside)?;

    let (mut settled, mut resets) = (0, 0);
    let mut last = 1.0_f64;
    for steps in 0..MOST {
        let now = t;
        let halt = move || Stalled { w: now, steps, decrement: f64::INFINITY };
        // Excess of bodies and singles above their own floor; one that has reached it adds nothing.
        let mut sum = 0.0;
        let mut scaled = Vec::with_capacity(forces.len());
        for ((link, force), floor) in problem.links.iter().zip(&mut forces).zip(&floors) {
            let body = problem.inside(v.as_slice(), link.start);
            let cone = match Scaled::new(&body, force) {
                Some(cone) => cone,
                // Rounding moved the force out of its cone: it is replaced by one that balances the
                // body.
                None => {
                    resets += 1;
                    *force = body.cholesky().filter(|_| resets < 20).ok_or_else(halt)?.inverse() * t.max(*floor);
                    Scaled::new(&body, force).ok_or_else(halt)?
                }
            };
            sum += cone.lambda.iter().map(|l| (l * l - floor).max(0.0)).sum::<f64>();
            scaled.push(cone);
        }
        sum += singles.iter().map(|s| (s.force * s.slack(&v) - s.floor).max(0.0)).sum::<f64>();
        // After a long step the target may fall fast; after a short one bodies and forces first
        // return to the central path.
        t = (sum / degree)
            * if last > 0.9 {
                0.1
            } else if last > 0.5 {
                0.4
            } else {
                0.9
            };

        let (a, b) = rows(problem, &v, (&scaled, &floors, &singles), t, weights.mu);
        let (step, _) = stacked.step(&v, &a, &b).ok_or_else(halt)?;

        let (mut length, mut changes) = (1.0_f64, Vec::new());
        for ((link, cone), floor) in problem.links.iter().zip(&scaled).zip(&floors) {
            let d = symmetric(&step.as_slice()[link.start..link.start + 10]);
            let body = cone.inverse * d * cone.inverse.transpose();
            let body = (body + body.transpose()) * 0.5;
            let force = Matrix4::from_diagonal(&cone.lambda.map(|x| t.max(*floor) / x - x)) - body;
            length = length.min(cone.longest(&body)).min(cone.longest(&force));
            changes.push(cone.inverse.transpose() * force * cone.inverse);
        }
        let shorten = |x: f64, d: f64, length: f64| if d < 0.0 { length.min(-0.9 * x / d) } else { length };
        let mut single_changes = Vec::new();
        for s in &singles {
            let (x, d) = (s.slack(&v), s.row.iter().map(|&(i, c)| c * step[i]).sum::<f64>());
            let force = t.max(s.floor) / x - s.force - s.force / x * d;
            length = shorten(x, d, shorten(s.force, force, length));
            single_changes.push(force);
        }
        if length.is_nan() || length <= 1e-6 {
            // Stuck at the boundary: forces that balance the bodies push away from it.
            resets += 1;
            if resets >= 20 {
                return Err(halt());
            }
            t = (10.0 * t).max(sum / degree);
            forces = balancing(problem, &v, &floors, &mut singles, t).ok_or_else(halt)?;
            last = 0.0;
            continue;
        }
        v.axpy(length, &step, 1.0);
        for (force, change) in forces.iter_mut().zip(&changes) {
            *force += change * length;
            *force = (*force + force.transpose()) * 0.5;
        }
        singles.iter_mut().zip(single_changes).for_each(|(s, change)| s.force += length * change);
        last = length;
        let down = floors.iter().chain(singles.iter().map(|s| &s.floor)).all(|f| t <= *f);
        settled = if down && length >= 1.0 { settled + 1 } else { 0 };
        if settled >= 3 {
            return Ok((v, steps + 1));
        }
    }
    // Newton's method checks whether this is near enough.
    Ok((v, MOST))
}

#[cfg(test)]
mod tests {
    use super::super::newton::{Link, Scalar};
    use super::*;
    use crate::numerics::prng::Random;

    /// Some tens of steps lead to the neighbourhood, from which Newton's method needs a few, even
    /// if a body's prior requires a force a million times that of a barrier.
    #[test]
    fn the_path_ends_where_floors_differ() {
        let mut random = Random::new(3);
        for w in [1.0, 1e-6] {
            let n = 12;
            let j = DMatrix::from_fn(20, n, |_, _| 1e3 * random.uniform(-1.0, 1.0));
            let truth = DVector::from_fn(n, |i, _| if i < 4 { 2.0 } else { 0.3 });
            let mut z = &j * &truth;
            z.iter_mut().for_each(|z| *z += 50.0 * random.uniform(-1.0, 1.0));
            let problem = Problem {
                j,
                z,
                links: vec![Link { start: 0, share: 0.7 }],
                scalars: vec![Scalar { index: 10, known: true }, Scalar { index: 11, known: false }],
                free: Vec::new(),
                walls: vec![Wall { a: vec![(0, 1.0), (10, -2.0)], b: 0.0 }],
                equal: None,
                margin: 1e-3,
            };
            let mut start = vec![0.0; n];
            start[..4].fill(1.0);
            (start[10], start[11]) = (0.2, 1.0);
            let weights = Weights { w, mu: 1e-6 };
            let stacked = Stacked::new(&problem);
            let (near, far) = near(&problem, &stacked, &start, weights).unwrap();
            let (_, all) = problem.follow(&start, weights).unwrap();
            assert!(near.iter().all(|x| x.is_finite()) && far < 40 && all - far < 10, "{w}: {far}, then {}", all - far);
        }
    }
}
