//! Newton-Euler (Featherstone, table 5.1), composite rigid bodies (table 6.2), forward dynamics by the mass matrix.

use dh_codegen::arm::param::DriveTerm;
use nalgebra::{DMatrix, DVector};

use super::{Force, Motion6, Numeric};

impl Numeric {
    /// Torques, N m, without friction, rotors and offset; gravity only if asked for.
    fn rnea(&self, q: &[f64], dq: &[f64], ddq: &[f64], phi: &[f64], gravity: bool) -> DVector<f64> {
        let (x, s, inertia) = (self.transforms(q), self.axes(), self.inertias(phi));
        let mut velocity = Motion6::zero();
        let mut acceleration = Motion6 {
            w: nalgebra::Vector3::zeros(),
            v: if gravity { -self.gravity } else { nalgebra::Vector3::zeros() },
        };
        let mut forces = Vec::with_capacity(self.rows());
        for i in 0..self.rows() {
            let (rate, second) = self.bodies[i].dof.map_or((0.0, 0.0), |k| (dq[k], ddq[k]));
            let joint = s[i].scaled(rate);
            velocity = x[i].motion(&velocity) + joint;
            acceleration = x[i].motion(&acceleration) + s[i].scaled(second) + velocity.cross(&joint);
            forces.push(inertia[i].times(&acceleration) + velocity.cross_force(&inertia[i].times(&velocity)));
        }
        let mut tau = DVector::zeros(self.dof());
        let mut outer = Force::zero();
        for i in (0..self.rows()).rev() {
            let force = forces[i] + outer;
            if let Some(k) = self.bodies[i].dof {
                tau[k] = s[i].dot(&force);
            }
            outer = x[i].force_back(&force);
        }
        tau
    }

    /// Torques of the actuators, N m: rigid body, gravity, rotors, friction, offset.
    pub fn inverse_dynamics(&self, q: &[f64], dq: &[f64], ddq: &[f64], phi: &[f64]) -> DVector<f64> {
        let mut tau = self.rnea(q, dq, ddq, phi, true) + self.friction(dq, phi);
        for (k, rotor) in self.drive(DriveTerm::IA, phi).iter().enumerate() {
            tau[k] += rotor * ddq[k];
        }
        tau
    }

    /// Viscous and Coulomb friction and offset, N m; no Coulomb friction at rest.
    pub fn friction(&self, dq: &[f64], phi: &[f64]) -> DVector<f64> {
        let [fv, fc, fo] = [DriveTerm::FV, DriveTerm::FC, DriveTerm::FO].map(|t| self.drive(t, phi));
        DVector::from_fn(self.dof(), |k, _| {
            let sign = if dq[k] == 0.0 { 0.0 } else { dq[k].signum() };
            fv[k] * dq[k] + fc[k] * sign + fo[k]
        })
    }

    /// Gravity torques, N m.
    pub fn gravity(&self, q: &[f64], phi: &[f64]) -> DVector<f64> {
        let zero = vec![0.0; self.dof()];
        self.rnea(q, &zero, &zero, phi, true)
    }

    /// Coriolis and centrifugal torques, N m.
    pub fn coriolis(&self, q: &[f64], dq: &[f64], phi: &[f64]) -> DVector<f64> {
        self.rnea(q, dq, &vec![0.0; self.dof()], phi, false)
    }

    /// Mass matrix, `n x n`, rotors on the diagonal.
    pub fn mass_matrix(&self, q: &[f64], phi: &[f64]) -> DMatrix<f64> {
        let (x, s) = (self.transforms(q), self.axes());
        let mut composite = self.inertias(phi);
        let mut mass = DMatrix::zeros(self.dof(), self.dof());
        for i in (0..self.rows()).rev() {
            if i > 0 {
                composite[i - 1] = composite[i - 1].plus(&x[i].inertia_back(&composite[i]));
            }
            let Some(k) = self.bodies[i].dof else { continue };
            let mut force = composite[i].times(&s[i]);
            mass[(k, k)] = s[i].dot(&force);
            for j in (1..=i).rev() {
                force = x[j].force_back(&force);
                if let Some(l) = self.bodies[j - 1].dof {
                    mass[(k, l)] = s[j - 1].dot(&force);
                    mass[(l, k)] = mass[(k, l)];
                }
            }
        }
        for (k, rotor) in self.drive(DriveTerm::IA, phi).iter().enumerate() {
            mass[(k, k)] += rotor;
        }
        mass
    }

    /// Accelerations that torques cause; `None` where the mass matrix is not positive definite.
    pub fn forward_dynamics(&self, q: &[f64], dq: &[f64], tau: &[f64], phi: &[f64]) -> Option<DVector<f64>> {
        let zero = vec![0.0; self.dof()];
        let bias = self.rnea(q, dq, &zero, phi, true) + self.friction(dq, phi);
        Some(self.mass_matrix(q, phi).cholesky()?.solve(&(DVector::from_column_slice(tau) - bias)))
    }
}
