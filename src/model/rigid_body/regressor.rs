//! Regressor of the torques, which are linear in the standard parameters: `tau = Y(q, dq, ddq)
//! phi`.

use nalgebra::{DMatrix, SMatrix};

use super::Numeric;
use super::Workspace;
use super::rnea::{Sweep, drive_factor};
use super::spatial::{Force, body_regressor};

impl Numeric {
    /// `Y`, `n x P`, in the order of `param::standard`: each body's regressor ([`body_regressor`]),
    /// propagated inward from joint to joint, followed by the drives' columns.
    pub fn regressor(&self, q: &[f64], dq: &[f64], ddq: &[f64]) -> DMatrix<f64> {
        let mut y = DMatrix::zeros(self.dof, self.parameters);
        self.regressor_into(&mut self.workspace(), q, dq, ddq, &mut y);
        y
    }

    /// [`Numeric::regressor`] without allocation; `y` is `n x P`.
    pub fn regressor_into(&self, work: &mut Workspace, q: &[f64], dq: &[f64], ddq: &[f64], y: &mut DMatrix<f64>) {
        self.check("q", q.len());
        self.check("dq", dq.len());
        self.check("ddq", ddq.len());
        assert_eq!(y.shape(), (self.dof, self.parameters), "y is n x P");
        self.link_columns(work, &Sweep { q, dq, ddq, base_acceleration: self.base_acceleration() }, y);
        for drive in &self.drives {
            if let Some(j) = drive.joint {
                y[(j, drive.column)] = drive_factor(drive.term, dq[j], ddq[j]);
            }
        }
    }

    /// Regressor of the gravity torque, `n x P`: `g(q) = Y phi`. The drives' columns are zero.
    pub fn gravity_regressor(&self, q: &[f64]) -> DMatrix<f64> {
        self.check("q", q.len());
        let mut y = DMatrix::zeros(self.dof, self.parameters);
        let sweep = Sweep { q, dq: &[], ddq: &[], base_acceleration: self.base_acceleration() };
        self.link_columns(&mut self.workspace(), &sweep, &mut y);
        y
    }

    fn link_columns(&self, work: &mut Workspace, sweep: &Sweep<'_>, y: &mut DMatrix<f64>) {
        self.outward(work, sweep);
        y.fill(0.0);
        for i in 0..self.rows.len() {
            let forces = body_regressor(&work.v[i], &work.a[i]);
            self.carry_inward(work, i, &forces, 10 * i, y);
        }
    }

    /// Propagates forces on frame `i`, one per column, moment first, inward, and writes their joint
    /// torques to the columns of `y` from `first`.
    pub(super) fn carry_inward(
        &self,
        work: &Workspace,
        i: usize,
        forces: &SMatrix<f64, 6, 10>,
        first: usize,
        y: &mut DMatrix<f64>,
    ) {
        for (k, column) in forces.column_iter().enumerate() {
            let mut force = Force { n: column.fixed_rows::<3>(0).into(), f: column.fixed_rows::<3>(3).into() };
            for l in (0..=i).rev() {
                if let Some(j) = self.rows[l].joint {
                    y[(j, first + k)] = self.rows[l].axis.dot(&force);
                }
                force = work.x[l].force_to_parent(&force);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::rigid_body::random::Family;
    use crate::numerics::prng::Random;
    use nalgebra::DVector;

    #[test]
    fn regressor_times_parameters_is_the_newton_euler_torque() {
        let mut random = Random::new(61);
        for case in 0..300 {
            let robot = random.robot(&Family::default());
            let (numeric, phi, s) = (Numeric::new(&robot), random.phi(&robot), random.state(&robot));
            let phi_vector = DVector::from_column_slice(&phi);
            let tau = numeric.inverse_dynamics(&s.q, &s.dq, &s.ddq, &phi);
            let linear = numeric.regressor(&s.q, &s.dq, &s.ddq) * &phi_vector;
            assert!((&tau - linear).amax() < 1e-12 * (1.0 + tau.amax()), "case {case}");
            let (g, linear) = (numeric.gravity(&s.q, &phi), numeric.gravity_regressor(&s.q) * &phi_vector);
            assert!((&g - linear).amax() < 1e-12 * (1.0 + g.amax()), "case {case}");
        }
    }
}
