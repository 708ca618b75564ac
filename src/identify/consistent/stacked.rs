//! Newton steps of one problem: its equations are reduced to an upper trapezoid once, and each step
//! annihilates the rows of prior and barrier below it.

use nalgebra::{DMatrix, DVector};

use super::newton::Problem;
use crate::identify::regression::r_factor::{Mirror, dot};

/// Equations `J`, `z` of a problem, stored as `R = Q'J` and `Q'z`.
///
/// The equations are placed above the rows of the prior, which are smaller by many powers of ten:
/// reflections keep the digits of small rows below large ones, and lose them above (Cox and Higham,
/// *Stability of Householder QR factorization for weighted least squares problems*, 1998).
pub(super) struct Stacked<'a> {
    problem: &'a Problem,
    /// Trapezoid `R` with at most as many rows as columns.
    r: DMatrix<f64>,
    qz: DVector<f64>,
}

impl<'a> Stacked<'a> {
    pub(super) fn new(problem: &'a Problem) -> Self {
        let qr = problem.j.clone().qr();
        let mut qz = problem.z.clone();
        qr.q_tr_mul(&mut qz);
        let r = qr.unpack_r();
        let qz = qz.rows(0, r.nrows()).into_owned();
        Self { problem, r, qz }
    }

    /// Step `d` from `v` that minimises `|J (v + d) - z|^2 + |A d - b|^2` and preserves `e'v`, and
    /// the slope along it. Each variable occurs in a row of `A`, and rows are sparse: ten entries
    /// for links, some for walls, one for others.
    pub(super) fn step(&self, v: &DVector<f64>, a: &DMatrix<f64>, b: &DVector<f64>) -> Option<(DVector<f64>, f64)> {
        let n = self.r.ncols();
        let missing = &self.qz - &self.r * v;
        let (r, y) = self.triangle(&missing, a, b)?;
        let mut step = r.solve_upper_triangular(&y)?;
        if let Some(equal) = &self.problem.equal {
            let mut e = DVector::zeros(n);
            equal.a.iter().for_each(|&(i, a)| e[i] += a);
            let direction = r.solve_upper_triangular(&r.tr_solve_upper_triangular(&e)?)?;
            let along = e.dot(&step) / e.dot(&direction);
            step.axpy(-along, &direction, 1.0);
        }
        let slope = -missing.dot(&(&self.r * &step)) - b.dot(&(a * &step));
        step.iter().all(|d| d.is_finite()).then_some((step, slope))
    }

    /// Factor and right-hand side of `[R; A] d = [missing; b]`; `None` if there are fewer equations
    /// than unknowns.
    fn triangle(
        &self,
        missing: &DVector<f64>,
        a: &DMatrix<f64>,
        b: &DVector<f64>,
    ) -> Option<(DMatrix<f64>, DVector<f64>)> {
        let (p, n) = self.r.shape();
        let mut top = self.r.clone().insert_column(n, 0.0);
        top.set_column(n, missing);
        let (mut block, filled) = by_first_entry(a, b);
        let rows = b.len();
        for k in 0..n {
            let used = k.saturating_sub(p);
            let active = used..filled[k];
            if active.is_empty() && k >= p {
                return None;
            }
            let (left, right) = block.split_at_mut((k + 1) * rows);
            let x = &left[k * rows..][active];
            // The pivot is a row of the trapezoid, or below it the first active row of the block.
            let (pivot, v) = if k < p { (top[(k, k)], x) } else { (x[0], &x[1..]) };
            let squares = dot(v, v);
            if squares == 0.0 || pivot * pivot + squares < f64::MIN_POSITIVE {
                continue;
            }
            let norm = (pivot * pivot + squares).sqrt();
            let beta = if pivot > 0.0 { -norm } else { norm };
            let head = pivot - beta;
            let scale = 2.0 / (head * head + squares);
            let mirror = Mirror { v, head, scale };
            match k < p {
                true => mirror.apply(right, rows, used, Some((&mut top.as_mut_slice()[(k + 1) * p..], k, p))),
                false => mirror.apply(right, rows, used, None),
            }
            if k < p {
                top[(k, k)] = beta;
            } else {
                left[k * rows + used] = beta;
            }
        }
        let entry = |i: usize, k: usize| if i < p { top[(i, k)] } else { block[k * rows + i - p] };
        let r = DMatrix::from_fn(n, n, |i, k| if i <= k { entry(i, k) } else { 0.0 });
        Some((r, DVector::from_fn(n, |i, _| entry(i, n))))
    }
}

/// Matrix `[A b]`, column-major, rows sorted by their first nonzero column; and for each column the
/// number of rows that have begun.
fn by_first_entry(a: &DMatrix<f64>, b: &DVector<f64>) -> (Vec<f64>, Vec<usize>) {
    let (rows, n) = a.shape();
    let mut order = Vec::with_capacity(rows);
    let mut begun = vec![false; rows];
    let mut filled = Vec::with_capacity(n);
    for k in 0..n {
        for i in 0..rows {
            if !begun[i] && a[(i, k)] != 0.0 {
                begun[i] = true;
                order.push(i);
            }
        }
        filled.push(order.len());
    }
    // Rows without entries are no equations and are placed at the end.
    order.extend((0..rows).filter(|&i| !begun[i]));
    let columns = a.column_iter().map(|c| c.into_owned()).chain([b.clone()]);
    (columns.flat_map(|column| order.iter().map(move |&i| column[i]).collect::<Vec<_>>()).collect(), filled)
}

#[cfg(test)]
mod tests {
    use super::super::newton::{Link, Wall};
    use super::*;
    use crate::numerics::prng::Random;

    /// The gradient vanishes after a step, except for the part that preserves `e'v`: for more and
    /// for fewer equations than unknowns, with columns that occur in no equation and with a wall
    /// across.
    #[test]
    fn steps_meet_the_conditions_of_the_minimum() {
        let mut random = Random::new(5);
        for (rows, n) in [(5, 23), (23, 23), (60, 23), (0, 13)] {
            let mut normal = || random.uniform(-1.0, 1.0);
            let mut j = DMatrix::from_fn(rows, n, |_, _| 1e3 * normal());
            (0..rows).for_each(|i| j[(i, 2)] = 0.0);
            let z = DVector::from_fn(rows, |_, _| 1e3 * normal());
            let links = vec![Link { start: 0, share: 1.0 }];
            let wall = Wall { a: vec![(1, 1.0), (n - 1, -2.0)], b: 0.0 };
            let problem = Problem {
                j,
                z,
                links,
                scalars: Vec::new(),
                free: Vec::new(),
                walls: vec![wall.clone()],
                equal: None,
                margin: 0.0,
            };
            let below = n + 1;
            let mut a = DMatrix::zeros(below, n);
            (0..n).for_each(|i| a[(i, i)] = 1e-3 * (2.0 + normal()));
            (0..10).for_each(|i| (0..10).for_each(|k| a[(i, k)] += 1e-3 * normal()));
            wall.a.iter().for_each(|&(i, c)| a[(n, i)] += c);
            let b = DVector::from_fn(below, |_, _| 1e-3 * normal());
            let v = DVector::from_fn(n, |_, _| normal());
            for equal in [None, Some(Wall { a: vec![(0, 1.0), (3, 2.0)], b: 0.0 })] {
                let problem = Problem { equal, ..problem.clone() };
                let (step, slope) = Stacked::new(&problem).step(&v, &a, &b).unwrap();
                // The conditions of the minimum, evaluated independently.
                let missing = &problem.z - &problem.j * (&v + &step);
                let gradient = problem.j.tr_mul(&missing) + a.tr_mul(&(&b - &a * &step));
                let pull = problem.equal.as_ref().map_or(0.0, |_| gradient[0]);
                let along: Vec<f64> = problem.equal.iter().flat_map(|e| e.a.iter().map(|&(i, _)| step[i])).collect();
                for (i, g) in gradient.iter().enumerate() {
                    let expected = match (problem.equal.is_some(), i) {
                        (true, 0) => pull,
                        (true, 3) => 2.0 * pull,
                        _ => 0.0,
                    };
                    assert!((g - expected).abs() < 1e-6 * (1.0 + pull.abs()), "{rows} x {n}, {i}: {g} {expected}");
                }
                if let [first, fourth] = along[..] {
                    assert!((first + 2.0 * fourth).abs() < 1e-9);
                }
                let direct = -(&problem.z - &problem.j * &v).dot(&(&problem.j * &step)) - b.dot(&(&a * &step));
                assert!((slope - direct).abs() < 1e-9 * direct.abs(), "{slope} {direct}");
            }
        }
    }
}
