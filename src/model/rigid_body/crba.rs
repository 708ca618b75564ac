//! Mass matrix by the composite-rigid-body algorithm, RBDA table 6.2.

use dh_codegen::arm::param::DriveTerm;
use nalgebra::DMatrix;

use super::Numeric;
use super::Workspace;
use super::body;

impl Numeric {
    /// `M(q)`, `n x n`, with the rotor inertias `IA` on its diagonal.
    pub fn mass_matrix(&self, q: &[f64], phi: &[f64]) -> DMatrix<f64> {
        let mut m = DMatrix::zeros(self.dof, self.dof);
        self.mass_matrix_into(&mut self.workspace(), q, phi, &mut m);
        m
    }

    /// [`Numeric::mass_matrix`] without allocation; `m` is `n x n`.
    pub fn mass_matrix_into(&self, work: &mut Workspace, q: &[f64], phi: &[f64], m: &mut DMatrix<f64>) {
        self.check("q", q.len());
        self.check_phi(phi);
        assert_eq!(m.shape(), (self.dof, self.dof), "m is n x n");
        for (i, row) in self.rows.iter().enumerate() {
            work.x[i] = row.transform(row.of(q));
            work.inertia[i] = body(phi, i);
        }
        for i in (0..self.rows.len()).rev() {
            let composite = work.inertia[i];
            if i > 0 {
                work.inertia[i - 1] = work.inertia[i - 1] + work.x[i].inertia_to_parent(&composite);
            }
            let Some(j) = self.rows[i].joint else { continue };
            let mut force = composite.times(&self.rows[i].axis);
            m[(j, j)] = self.rows[i].axis.dot(&force);
            for k in (0..i).rev() {
                force = work.x[k + 1].force_to_parent(&force);
                if let Some(l) = self.rows[k].joint {
                    let entry = self.rows[k].axis.dot(&force);
                    (m[(j, l)], m[(l, j)]) = (entry, entry);
                }
            }
        }
        for drive in &self.drives {
            if let (Some(j), DriveTerm::IA) = (drive.joint, drive.term) {
                m[(j, j)] += phi[drive.column];
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::rigid_body::random::Family;
    use crate::numerics::prng::Random;

    #[test]
    fn columns_are_torques_of_unit_accelerations_and_the_matrix_is_positive_definite() {
        let mut random = Random::new(31);
        for case in 0..200 {
            let mut robot = random.robot(&Family::default());
            robot.gravity = [0.0; 3];
            let (numeric, q) = (Numeric::new(&robot), random.state(&robot).q);
            let mut phi = random.phi(&robot);
            for drive in numeric.drives.iter().filter(|d| d.term == DriveTerm::FO) {
                phi[drive.column] = 0.0;
            }
            let m = numeric.mass_matrix(&q, &phi);
            let zero = vec![0.0; robot.dof()];
            for j in 0..robot.dof() {
                let mut unit = zero.clone();
                unit[j] = 1.0;
                let column = numeric.inverse_dynamics(&q, &zero, &unit, &phi);
                assert!((m.column(j) - column).amax() < 1e-12 * (1.0 + m.amax()), "case {case}");
            }
            assert_eq!(m, m.transpose());
            assert!(m.cholesky().is_some(), "case {case}");
        }
    }
}
