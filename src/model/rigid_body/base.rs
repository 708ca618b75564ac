//! Numeric determination of base parameters: number and choice of the combinations of standard
//! parameters that affect the torques.
//!
//! `random states -> stacked regressor W -> columns scaled -> QR -> singular values (rank, gap) ->
//! independent columns -> K`
//!
//! M. Gautier, *Numerical calculation of the base inertial parameters of robots*, J. Robotic
//! Systems 8(4), 1991; Khalil and Dombre, *Modeling, Identification and Control of Robots*,
//! appendix 5. With independent columns `W_b` and the others `W_d = W_b K`, the torques are `W phi
//! = W_b (phi_b + K phi_d)`.
//!
//! `samples` random states give `n * samples` equations; fewer than `P` of them cannot determine
//! the rank. Twenty-five states are plenty for seven axes.

use dh_codegen::arm::param::{self, Inertial, Parameter};
use dh_codegen::robot::{JointKind, Robot};
use nalgebra::{DMatrix, DVector};
use thiserror::Error;

use super::Numeric;
use crate::numerics::prng::Random;

/// Torques under consideration.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Torques {
    /// Torques of motions: inertia, gravity, drives.
    Motion,
    /// Torques of the links' weight at rest.
    Gravity,
}

/// Number of base parameters.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rank {
    /// Number of independent columns of the regressor.
    pub rank: usize,
    /// Smallest kept singular value over the largest that counts as zero (at least the rounding
    /// error). A decision is safe at 1e6 and a guess at 10.
    pub gap: f64,
}

/// Base parameters of a robot: a choice of independent columns and how the others group with them.
#[derive(Debug, Clone, PartialEq)]
pub struct Reduction {
    /// Independent standard parameters (the leaders), ascending: the columns of `W_b`.
    pub independent: Vec<usize>,
    /// The others, ascending: the columns of `W_d`. If the column of `K` is zero, the parameter
    /// does not affect the torques.
    pub dependent: Vec<usize>,
    /// `K`, independent x dependent; rounding errors are set to exact zeros.
    pub grouping: DMatrix<f64>,
    /// Rank, and how safe its decision is.
    pub rank: Rank,
}

/// Contradiction between the singular values and the order of preference about the number of
/// independent columns.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[error("{found} columns are independent in the given order but the rank is {rank} (gap {gap:.1e}); try more samples")]
pub struct Undecided {
    /// Rank by singular values.
    pub rank: usize,
    /// Independent columns found.
    pub found: usize,
    /// Gap of the singular values.
    pub gap: f64,
}

/// Number of base parameters of the full model, drives included.
pub fn rank(robot: &Robot, seed: u64, samples: usize) -> Rank {
    rank_of(robot, Torques::Motion, seed, samples)
}

/// Number of parameter combinations that affect these torques.
pub fn rank_of(robot: &Robot, torques: Torques, seed: u64, samples: usize) -> Rank {
    Stacked::new(robot, torques, seed, samples).spectrum().rank
}

/// Orthonormal basis, `P x (P - rank)`, of the changes of the standard parameters that do not
/// affect the torques.
pub fn null_space(robot: &Robot, torques: Torques, seed: u64, samples: usize) -> DMatrix<f64> {
    let stacked = Stacked::new(robot, torques, seed, samples);
    let spectrum = stacked.spectrum();
    let p = stacked.scale.len();
    let nullity = p - spectrum.rank.rank;
    if nullity == 0 {
        return DMatrix::zeros(p, 0);
    }
    // W diag(1/scale) y = 0: back to x = y / scale, then orthonormalise.
    let mut basis = spectrum.right.columns(spectrum.rank.rank, nullity).into_owned();
    for (mut row, scale) in basis.row_iter_mut().zip(&stacked.scale) {
        row /= *scale;
    }
    basis.qr().q()
}

/// Order of preference equivalent to Khalil's and Gautier's closed-form rules. First come `ZZ XX XY
/// XZ YZ MSX MSY` from base to tip (and `M` of prismatic rows), then the drives, and last the
/// parameters that the rules group first: `MSZ`, `M`, `YY`.
pub fn customary_order(robot: &Robot) -> Vec<usize> {
    let class = |p: &Parameter| match *p {
        Parameter::Link(row, Inertial::M) if robot.joints[row].kind == JointKind::Prismatic => 0,
        Parameter::Link(_, Inertial::MSZ) => 2,
        Parameter::Link(_, Inertial::M) => 3,
        Parameter::Link(_, Inertial::YY) => 4,
        Parameter::Link(..) => 0,
        Parameter::Drive(..) => 1,
    };
    let standard = param::standard(robot);
    let mut order: Vec<usize> = (0..standard.len()).collect();
    // Stable sort; ZZ comes before the others, so that it is named where they depend on each other.
    order.sort_by_key(|&k| match standard[k] {
        Parameter::Link(row, which) => (class(&standard[k]), row, which != Inertial::ZZ),
        Parameter::Drive(row, _) => (class(&standard[k]), row, false),
    });
    order
}

impl Reduction {
    /// Keeps the leaders that come first in an order of preference (indices into
    /// `param::standard`). Omitted ones follow in [`customary_order`], those out of range are
    /// ignored. A column is kept if it is independent of those kept before.
    pub fn preferring(robot: &Robot, order: &[usize], seed: u64, samples: usize) -> Result<Self, Undecided> {
        let stacked = Stacked::new(robot, Torques::Motion, seed, samples);
        let spectrum = stacked.spectrum();
        let mut pending = vec![true; stacked.scale.len()];
        let mut kept = Kept::new();
        for &k in order.iter().chain(&customary_order(robot)) {
            if pending.get(k).copied().unwrap_or(false) {
                pending[k] = false;
                kept.offer(&stacked.triangle, k, spectrum.tolerance);
            }
        }
        let (found, Rank { rank, gap }) = (kept.columns.len(), spectrum.rank);
        if found != rank { Err(Undecided { rank, found, gap }) } else { Ok(kept.reduction(&stacked, spectrum.rank)) }
    }

    /// Leaders in [`customary_order`].
    pub fn customary(robot: &Robot, seed: u64, samples: usize) -> Result<Self, Undecided> {
        Self::preferring(robot, &[], seed, samples)
    }

    /// The best conditioned leaders, by QR with column pivoting: the column farthest from the span
    /// of those kept comes next.
    pub fn pivoted(robot: &Robot, seed: u64, samples: usize) -> Self {
        let stacked = Stacked::new(robot, Torques::Motion, seed, samples);
        let spectrum = stacked.spectrum();
        let mut rest = stacked.triangle.clone();
        let mut kept = Kept::new();
        for _ in 0..spectrum.rank.rank {
            let norm = |k: usize| rest.column(k).norm_squared();
            let Some(k) = (0..rest.ncols()).max_by(|&a, &b| norm(a).total_cmp(&norm(b))) else { break };
            kept.offer(&stacked.triangle, k, 0.0);
            if let Some(q) = kept.basis.last() {
                rest -= q * q.tr_mul(&rest);
            }
            rest.column_mut(k).fill(0.0);
        }
        kept.reduction(&stacked, spectrum.rank)
    }

    /// Base parameters `phi_b + K phi_d` of standard ones, in the order of
    /// [`Reduction::independent`].
    ///
    /// # Panics
    /// If `phi` is shorter than `P`.
    pub fn base_values(&self, phi: &[f64]) -> DVector<f64> {
        let pick = |columns: &[usize]| DVector::from_iterator(columns.len(), columns.iter().map(|&k| phi[k]));
        pick(&self.independent) + &self.grouping * pick(&self.dependent)
    }

    /// Base regressor: the independent columns of a regressor.
    ///
    /// # Panics
    /// If `y` has fewer than `P` columns.
    pub fn base_regressor(&self, y: &DMatrix<f64>) -> DMatrix<f64> {
        y.select_columns(&self.independent)
    }
}

/// The stacked regressor with columns of unit norm, reduced to `P x P` by an orthogonal
/// transformation.
struct Stacked {
    triangle: DMatrix<f64>,
    /// Norms of the original columns; one for a column of zeros.
    scale: Vec<f64>,
}

struct Spectrum {
    rank: Rank,
    /// Threshold between kept singular values and those that count as zero.
    tolerance: f64,
    /// Right singular vectors, by descending singular value.
    right: DMatrix<f64>,
}

impl Stacked {
    fn new(robot: &Robot, torques: Torques, seed: u64, samples: usize) -> Self {
        let (numeric, mut random) = (Numeric::new(robot), Random::new(seed));
        let (n, p) = (numeric.dof(), numeric.parameters());
        // Zero rows keep the factors at least P x P.
        let mut w = DMatrix::zeros((n * samples).max(p), p);
        for sample in 0..samples {
            let state = random.state(robot);
            let y = match torques {
                Torques::Motion => numeric.regressor(&state.q, &state.dq, &state.ddq),
                Torques::Gravity => numeric.gravity_regressor(&state.q),
            };
            w.rows_mut(n * sample, n).copy_from(&y);
        }
        let longest = w.column_iter().map(|c| c.norm()).fold(0.0, f64::max);
        let scale = w.column_iter_mut().map(|mut column| {
            let norm = column.norm();
            // Columns that cancel up to rounding must not be normalised.
            if norm <= 1e-13 * longest {
                column.fill(0.0);
                return 1.0;
            }
            column /= norm;
            norm
        });
        let scale = scale.collect();
        let triangle = if p == 0 { w } else { w.qr().r() };
        Self { triangle, scale }
    }

    fn spectrum(&self) -> Spectrum {
        let p = self.scale.len();
        let rounding = f64::EPSILON * p as f64;
        let none = Spectrum {
            rank: Rank { rank: 0, gap: f64::INFINITY },
            tolerance: rounding,
            right: DMatrix::identity(p, p),
        };
        if self.triangle.iter().all(|&x| x == 0.0) {
            return none; // of no column at all, too
        }
        let svd = self.triangle.clone().svd(false, true);
        let Some(v_t) = svd.v_t else { return none };
        let floor = rounding * svd.singular_values[0];
        let value = |k: usize| svd.singular_values.get(k).copied().unwrap_or(0.0).max(floor);
        let gap = |rank: usize| value(rank - 1) / value(rank);
        let rank = (1..=p).max_by(|&a, &b| gap(a).total_cmp(&gap(b))).unwrap_or(0);
        Spectrum {
            rank: Rank { rank, gap: gap(rank) },
            tolerance: (value(rank - 1) * value(rank)).sqrt(),
            right: v_t.transpose(),
        }
    }
}

/// Kept columns, and an orthonormal basis of their span (Gram-Schmidt, twice for stability).
struct Kept {
    columns: Vec<usize>,
    basis: Vec<DVector<f64>>,
}

impl Kept {
    fn new() -> Self {
        Self { columns: Vec::new(), basis: Vec::new() }
    }

    /// Keeps column `k` of `w` if its distance from the span is above `tolerance`.
    fn offer(&mut self, w: &DMatrix<f64>, k: usize, tolerance: f64) {
        let mut rest = w.column(k).into_owned();
        for _ in 0..2 {
            for q in &self.basis {
                rest.axpy(-q.dot(&rest), q, 1.0);
            }
        }
        let norm = rest.norm();
        if norm > tolerance {
            self.columns.push(k);
            self.basis.push(rest / norm);
        }
    }

    /// `K` from `Q' W_b K = Q' W_d`.
    fn reduction(mut self, stacked: &Stacked, rank: Rank) -> Reduction {
        self.columns.sort_unstable();
        let (p, b) = (stacked.scale.len(), self.columns.len());
        let dependent: Vec<usize> = (0..p).filter(|k| self.columns.binary_search(k).is_err()).collect();
        let mut grouping = DMatrix::zeros(b, dependent.len());
        if b > 0 && !dependent.is_empty() {
            let q_t = DMatrix::from_fn(b, p, |i, j| self.basis[i][j]);
            let of = |columns: &[usize]| &q_t * stacked.triangle.select_columns(columns);
            // Q spans the kept columns, so the matrix is invertible.
            if let Some(k) = of(&self.columns).qr().solve(&of(&dependent)) {
                grouping = k;
            }
        }
        for (j, mut column) in grouping.column_iter_mut().enumerate() {
            // Clean while columns have unit norm: an entry is then relative to its leader.
            column.iter_mut().filter(|k| k.abs() < 1e-9).for_each(|k| *k = 0.0);
            for (entry, &leader) in column.iter_mut().zip(&self.columns) {
                *entry *= stacked.scale[dependent[j]] / stacked.scale[leader];
            }
        }
        Reduction { independent: self.columns, dependent, grouping, rank }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::rigid_body::random::Family;
    use crate::model::rigid_body::samples::*;

    fn assert_rank(robot: &Robot, expected: usize) {
        let found = rank(robot, 1, 30);
        assert_eq!(found.rank, expected, "{} {found:?}", robot.name);
        assert!(found.gap > 1e6, "{} {found:?}", robot.name);
    }

    fn assert_gravity_rank(robot: &Robot, expected: usize) {
        let found = rank_of(robot, Torques::Gravity, 1, 40);
        assert_eq!(found.rank, expected, "{} {found:?}", robot.name);
        assert!(found.gap > 1e6, "{} {found:?}", robot.name);
    }

    #[test]
    fn six_axes_have_36() {
        for robot in [puma560(), ur5e()] {
            assert_rank(&robot, 36);
            assert_rank(&with_rotors(robot.clone()), 40);
            assert_rank(&with_friction(robot.clone()), 36 + 18);
            assert_rank(&tilted(robot.clone()), 38);
            assert_gravity_rank(&robot, 10);
        }
    }

    #[test]
    fn seven_axes_have_43() {
        for robot in [kuka_lwr4(), kuka_iiwa14(), franka_panda(), kinova_gen3()] {
            assert_rank(&robot, 43);
            assert_rank(&with_rotors(robot.clone()), 48);
            assert_rank(&with_friction(robot.clone()), 43 + 21);
            assert_rank(&tilted(robot.clone()), 45);
            assert_gravity_rank(&robot, 12);
        }
    }

    #[test]
    fn parallel_axes_have_few() {
        assert_rank(&planar_2r(), 6);
        assert_rank(&scara(), 8);
    }

    #[test]
    fn nothing_is_shown_by_no_state() {
        assert_eq!(rank(&planar_2r(), 1, 0).rank, 0);
        let all = null_space(&planar_2r(), Torques::Motion, 1, 0);
        assert_eq!(all.shape(), (20, 20));
    }

    #[test]
    fn reductions_keep_the_torques() {
        let mut random = Random::new(111);
        for case in 0..60 {
            let robot = random.robot(&Family::default());
            let numeric = Numeric::new(&robot);
            let samples = 20 + 2 * numeric.parameters() / numeric.dof();
            let customary = Reduction::customary(&robot, case, samples).unwrap();
            let pivoted = Reduction::pivoted(&robot, case, samples);
            let null = null_space(&robot, Torques::Motion, case, samples);
            assert_eq!(customary.independent.len(), pivoted.independent.len());
            assert_eq!(null.ncols(), customary.dependent.len());
            let (phi, phi_null) = (random.phi(&robot), null.clone() * null.transpose());
            assert!((&phi_null * &phi_null - &phi_null).norm() < 1e-11, "orthonormal");
            for _ in 0..5 {
                let s = random.state(&robot);
                let y = numeric.regressor(&s.q, &s.dq, &s.ddq);
                let tau = numeric.inverse_dynamics(&s.q, &s.dq, &s.ddq, &phi);
                let scale = 1.0 + tau.amax() + y.amax();
                for reduction in [&customary, &pivoted] {
                    let reduced = reduction.base_regressor(&y) * reduction.base_values(&phi);
                    assert!((reduced - &tau).amax() < 1e-8 * scale, "case {case}");
                }
                assert!((&y * &null).amax() < 1e-9 * scale, "case {case}");
            }
            assert!(customary.rank.gap > 1e6, "case {case}: {:?}", customary.rank);
        }
    }

    #[test]
    fn preference_is_heard() {
        let robot = planar_2r();
        // ZZ1 = 6, M2 = 10: the rules keep ZZ1, MSX1 and group M2 with them.
        let customary = Reduction::customary(&robot, 1, 20).unwrap();
        assert_eq!(customary.independent, [1, 2, 6, 11, 12, 16]);
        let first = Reduction::preferring(&robot, &[10], 1, 20).unwrap();
        assert_eq!(first.independent, [2, 6, 10, 11, 12, 16]);
        let names = param::standard(&robot);
        let m2 = customary.dependent.iter().position(|&k| names[k].name() == "M2").unwrap();
        let column: Vec<f64> = customary.grouping.column(m2).iter().copied().collect();
        for (k, expected) in column.iter().zip([0.5, 0.0, 0.25, 0.0, 0.0, 0.0]) {
            assert!((k - expected).abs() < 1e-12, "{column:?}");
        }
    }
}
