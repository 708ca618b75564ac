//! The Coriolis matrix of the Christoffel symbols.
//!
//! Algorithm 1 of S. Echeandia and P. Wensing, *Numerical methods to compute the Coriolis matrix
//! and Christoffel symbols for rigid-body systems*, J. Computational and Nonlinear Dynamics 16(9),
//! 2021. Each body's gyroscopic force is factored with `B(I, v) = 1/2 ((v x*) I - I (v x) + (I v)
//! x*)`. Of all factors with `B v = v x* I v` it is the one that leads to the Christoffel symbols.

use nalgebra::{DMatrix, Matrix6, Vector6};

use super::Numeric;
use super::body;
use super::rnea::Sweep;
use super::spatial::Motion;

impl Numeric {
    /// `C(q, dq)`, `n x n`: `C dq` is [`Numeric::coriolis`] and `dM/dt - 2 C` is skew;
    /// `C_ij = sum_k 1/2 (dM_ij/dq_k + dM_ik/dq_j - dM_jk/dq_i) dq_k`.
    pub fn coriolis_matrix(&self, q: &[f64], dq: &[f64], phi: &[f64]) -> DMatrix<f64> {
        self.check("q", q.len());
        self.check("dq", dq.len());
        self.check_phi(phi);
        let mut work = self.workspace();
        self.outward(&mut work, &Sweep { q, dq, ddq: &[], base_acceleration: Motion::zero() });
        let mut c = DMatrix::zeros(self.dof, self.dof);
        let (mut inertia, mut factor) = (Matrix6::zeros(), Matrix6::zeros());
        let axes: Vec<Vector6<f64>> = self.rows.iter().map(|row| row.axis.to_vector()).collect();
        // The axes are constant in their frames, so their rates are those of the frames: S' = v x
        // S.
        let rates: Vec<Vector6<f64>> =
            self.rows.iter().zip(&work.v).map(|(row, v)| v.cross(&row.axis).to_vector()).collect();
        for i in (0..self.rows.len()).rev() {
            let (body, v) = (body(phi, i), work.v[i]);
            let own = body.matrix();
            inertia += own;
            factor += 0.5 * (v.cross_force_matrix() * own - own * v.cross_matrix() + body.times(&v).crossed_matrix());
            if let Some(j) = self.rows[i].joint {
                let mut f1 = inertia * rates[i] + factor * axes[i];
                let mut f2 = inertia * axes[i];
                let mut f3 = factor.tr_mul(&axes[i]);
                c[(j, j)] = axes[i].dot(&f1);
                for k in (0..i).rev() {
                    let to_parent = work.x[k + 1].matrix().transpose();
                    (f1, f2, f3) = (to_parent * f1, to_parent * f2, to_parent * f3);
                    if let Some(l) = self.rows[k].joint {
                        c[(l, j)] = axes[k].dot(&f1);
                        c[(j, l)] = rates[k].dot(&f2) + axes[k].dot(&f3);
                    }
                }
            }
            let x = work.x[i].matrix();
            inertia = x.transpose() * inertia * x;
            factor = x.transpose() * factor * x;
        }
        c
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::rigid_body::random::Family;
    use crate::numerics::prng::Random;
    use nalgebra::DVector;

    /// The torque `c(q, dq)` is quadratic in `dq`, so its symmetric bilinear form gives the
    /// Christoffel matrix exactly: `C(q, dq) e_j = (c(dq + e_j) - c(dq - e_j)) / 4`.
    #[test]
    fn matrix_is_the_polarisation_of_the_torque() {
        let mut random = Random::new(91);
        for case in 0..100 {
            let robot = random.robot(&Family::default());
            let (numeric, phi, s) = (Numeric::new(&robot), random.phi(&robot), random.state(&robot));
            let c = numeric.coriolis_matrix(&s.q, &s.dq, &phi);
            let torque = numeric.coriolis(&s.q, &s.dq, &phi);
            let scale = 1.0 + torque.amax() + c.amax();
            assert!((&c * DVector::from_column_slice(&s.dq) - &torque).amax() < 1e-11 * scale, "case {case}");
            for j in 0..robot.dof() {
                let shifted = |t: f64| {
                    let mut dq = s.dq.clone();
                    dq[j] += t;
                    numeric.coriolis(&s.q, &dq, &phi)
                };
                let column = (shifted(1.0) - shifted(-1.0)) / 4.0;
                assert!((c.column(j) - column).amax() < 1e-11 * scale, "case {case}");
            }
        }
    }

    #[test]
    fn rate_of_the_mass_matrix_is_the_matrix_and_its_transpose() {
        let mut random = Random::new(92);
        for case in 0..100 {
            let robot = random.robot(&Family::default());
            let (numeric, phi, s) = (Numeric::new(&robot), random.phi(&robot), random.state(&robot));
            let c = numeric.coriolis_matrix(&s.q, &s.dq, &phi);
            let mass = |t: f64| {
                let q: Vec<f64> = s.q.iter().zip(&s.dq).map(|(q, dq)| q + t * dq).collect();
                numeric.mass_matrix(&q, &phi)
            };
            let h = 1e-4;
            let rate = (8.0 * (mass(h) - mass(-h)) - (mass(2.0 * h) - mass(-2.0 * h))) / (12.0 * h);
            let skew = rate - 2.0 * &c;
            assert!((&skew + skew.transpose()).amax() < 1e-7 * (1.0 + mass(0.0).amax() + c.amax()), "case {case}");
        }
    }
}
