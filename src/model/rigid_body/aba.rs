//! Forward dynamics by the articulated-body algorithm, RBDA table 7.1, and by the mass matrix.

use dh_codegen::arm::param::DriveTerm;
use nalgebra::{DMatrix, DVector};

use super::Numeric;
use super::Workspace;
use super::body;
use super::rnea::drive_factor;
use super::spatial::{Force, Motion};

impl Numeric {
    /// Accelerations `ddq`, `n`, rad/s^2 or m/s^2, under the torques `tau`; friction, offset and
    /// rotor inertia included.
    ///
    /// With parameters that no real bodies have, an inertia may vanish and the result be
    /// non-finite.
    pub fn forward_dynamics(&self, q: &[f64], dq: &[f64], tau: &[f64], phi: &[f64]) -> DVector<f64> {
        let mut ddq = DVector::zeros(self.dof);
        self.forward_dynamics_into(&mut self.workspace(), q, dq, tau, phi, ddq.as_mut_slice());
        ddq
    }

    /// [`Numeric::forward_dynamics`] without allocation; `ddq` has `n` entries.
    pub fn forward_dynamics_into(
        &self,
        work: &mut Workspace,
        q: &[f64],
        dq: &[f64],
        tau: &[f64],
        phi: &[f64],
        ddq: &mut [f64],
    ) {
        self.check("q", q.len());
        self.check("dq", dq.len());
        self.check("tau", tau.len());
        self.check("ddq", ddq.len());
        self.check_phi(phi);
        // `ddq` first holds the torque that remains for the bodies.
        ddq.copy_from_slice(tau);
        for drive in &self.drives {
            if let Some(j) = drive.joint {
                ddq[j] -= phi[drive.column] * drive_factor(drive.term, dq[j], 0.0);
            }
        }
        let mut v = Motion::zero();
        for (i, row) in self.rows.iter().enumerate() {
            let (x, joint) = (row.transform(row.of(q)), row.axis * row.of(dq));
            v = x.motion(&v) + joint;
            let body = body(phi, i);
            work.x[i] = x;
            work.a[i] = v.cross(&joint); // c
            work.f[i] = v.cross_force(&body.times(&v)); // p^A
            work.articulated[i] = body.into(); // I^A
            work.d[i] = 0.0;
        }
        // In this model a rotor adds inertia to its joint and to nothing else: it enters D alone
        // (RBDA, chapter 9, on gears).
        for drive in &self.drives {
            if drive.term == DriveTerm::IA {
                work.d[drive.row] += phi[drive.column];
            }
        }
        for (i, row) in self.rows.iter().enumerate().rev() {
            let (mut inertia, mut bias) = (work.articulated[i], work.f[i]);
            if let Some(j) = row.joint {
                let u = inertia.times(&row.axis);
                let d = work.d[i] + row.axis.dot(&u);
                ddq[j] -= row.axis.dot(&bias);
                inertia = inertia.minus_dyad(&u, d);
                bias += inertia.times(&work.a[i]) + u * (ddq[j] / d);
                (work.u[i], work.d[i]) = (u, d);
            } else {
                bias += inertia.times(&work.a[i]);
                (work.u[i], work.d[i]) = (Force::zero(), 1.0);
            }
            if i > 0 {
                work.articulated[i - 1] = work.articulated[i - 1] + work.x[i].articulated_to_parent(&inertia);
                work.f[i - 1] += work.x[i].force_to_parent(&bias);
            }
        }
        let mut a = self.base_acceleration();
        for (i, row) in self.rows.iter().enumerate() {
            a = work.x[i].motion(&a) + work.a[i];
            if let Some(j) = row.joint {
                ddq[j] = (ddq[j] - a.dot(&work.u[i])) / work.d[i];
                a += row.axis * ddq[j];
            }
        }
    }

    /// The same accelerations from `M(q) ddq = tau - tau(q, dq, 0)` by Cholesky (RBDA, section
    /// 6.1). `None` if `M` is not positive definite.
    pub fn forward_dynamics_by_mass_matrix(
        &self,
        q: &[f64],
        dq: &[f64],
        tau: &[f64],
        phi: &[f64],
    ) -> Option<DVector<f64>> {
        self.check("tau", tau.len());
        let bias = self.inverse_dynamics(q, dq, &vec![0.0; self.dof], phi);
        let left = DVector::from_column_slice(tau) - bias;
        Some(self.mass_matrix(q, phi).cholesky()?.solve(&left))
    }

    /// `M(q)^-1`, `n x n`; `None` if `M` is not positive definite.
    pub fn inverse_mass_matrix(&self, q: &[f64], phi: &[f64]) -> Option<DMatrix<f64>> {
        Some(self.mass_matrix(q, phi).cholesky()?.inverse())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::rigid_body::random::Family;
    use crate::numerics::prng::Random;

    #[test]
    fn three_routes_agree() {
        let mut random = Random::new(41);
        for case in 0..300 {
            let robot = random.robot(&Family::default());
            let (numeric, phi, s) = (Numeric::new(&robot), random.phi(&robot), random.state(&robot));
            let tau = numeric.inverse_dynamics(&s.q, &s.dq, &s.ddq, &phi);
            let ddq = DVector::from_column_slice(&s.ddq);
            let aba = numeric.forward_dynamics(&s.q, &s.dq, tau.as_slice(), &phi);
            let by_mass = numeric.forward_dynamics_by_mass_matrix(&s.q, &s.dq, tau.as_slice(), &phi).unwrap();
            let inverse = numeric.inverse_mass_matrix(&s.q, &phi).unwrap();
            // Effect of a rounding error in tau on ddq.
            let bound =
                1e-13 * inverse.norm() * (1.0 + tau.norm() + numeric.mass_matrix(&s.q, &phi).norm() * ddq.norm());
            assert!((&aba - &ddq).amax() < bound, "case {case}: {aba} {ddq}");
            assert!((&by_mass - &ddq).amax() < bound, "case {case}: {by_mass} {ddq}");
        }
    }
}
