//! Kinetic and potential energy and their regressors.

use dh_codegen::arm::param::DriveTerm;
use nalgebra::DVector;

use super::Numeric;
use super::body;
use super::rnea::Sweep;
use super::spatial::Motion;

impl Numeric {
    /// Kinetic energy, J, `1/2 sum v . I v`, including rotors (`IA dq^2 / 2`).
    pub fn kinetic_energy(&self, q: &[f64], dq: &[f64], phi: &[f64]) -> f64 {
        self.check("q", q.len());
        self.check("dq", dq.len());
        self.check_phi(phi);
        let mut work = self.workspace();
        self.outward(&mut work, &Sweep { q, dq, ddq: &[], base_acceleration: Motion::zero() });
        let bodies: f64 = work.v.iter().enumerate().map(|(i, v)| v.dot(&body(phi, i).times(v))).sum();
        0.5 * (bodies + self.rotors().map(|(column, j)| phi[column] * dq[j] * dq[j]).sum::<f64>())
    }

    /// Potential energy, J, `-sum (M g . p + g . R MS)`: zero for a mass at the world frame's
    /// origin.
    pub fn potential_energy(&self, q: &[f64], phi: &[f64]) -> f64 {
        self.check_phi(phi);
        let poses = self.poses(q);
        let moments = poses.iter().enumerate().map(|(i, pose)| {
            let body = body(phi, i);
            self.gravity.dot(&(pose.origin * body.m + pose.rotation * body.h))
        });
        -moments.sum::<f64>()
    }

    /// Regressor of the kinetic energy, `P` entries: its product with `phi` is the energy.
    pub fn kinetic_energy_regressor(&self, q: &[f64], dq: &[f64]) -> DVector<f64> {
        self.check("q", q.len());
        self.check("dq", dq.len());
        let mut work = self.workspace();
        self.outward(&mut work, &Sweep { q, dq, ddq: &[], base_acceleration: Motion::zero() });
        let mut y = DVector::zeros(self.parameters);
        for (i, Motion { w, v }) in work.v.iter().enumerate() {
            let s = v.cross(w);
            let columns = [
                v.dot(v) / 2.0,
                s.x,
                s.y,
                s.z,
                w.x * w.x / 2.0,
                w.y * w.y / 2.0,
                w.z * w.z / 2.0,
                w.x * w.y,
                w.x * w.z,
                w.y * w.z,
            ];
            y.rows_mut(10 * i, 10).copy_from_slice(&columns);
        }
        for (column, j) in self.rotors() {
            y[column] = dq[j] * dq[j] / 2.0;
        }
        y
    }

    /// Regressor of the potential energy, `P` entries: its product with `phi` is the energy.
    pub fn potential_energy_regressor(&self, q: &[f64]) -> DVector<f64> {
        let mut y = DVector::zeros(self.parameters);
        for (i, pose) in self.poses(q).iter().enumerate() {
            y[10 * i] = -self.gravity.dot(&pose.origin);
            y.fixed_rows_mut::<3>(10 * i + 1).copy_from(&-pose.rotation.tr_mul(&self.gravity));
        }
        y
    }

    /// Column and joint of every rotor inertia.
    fn rotors(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        self.drives.iter().filter(|d| d.term == DriveTerm::IA).filter_map(|d| Some((d.column, d.joint?)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::rigid_body::random::Family;
    use crate::numerics::prng::Random;

    #[test]
    fn energies_by_independent_routes() {
        let mut random = Random::new(81);
        for case in 0..100 {
            let robot = random.robot(&Family::default());
            let (numeric, phi, s) = (Numeric::new(&robot), random.phi(&robot), random.state(&robot));
            let (p, dq) = (DVector::from_column_slice(&phi), DVector::from_column_slice(&s.dq));
            let (kinetic, potential) =
                (numeric.kinetic_energy(&s.q, &s.dq, &phi), numeric.potential_energy(&s.q, &phi));
            let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-11 * (1.0 + a.abs()), "case {case}: {a} {b}");
            near(kinetic, numeric.kinetic_energy_regressor(&s.q, &s.dq).dot(&p));
            near(kinetic, 0.5 * dq.dot(&(numeric.mass_matrix(&s.q, &phi) * &dq)));
            near(potential, numeric.potential_energy_regressor(&s.q).dot(&p));
        }
    }

    /// `d(T + U)/dt = tau . dq - (FV dq^2 + FC |dq| + FO dq)`.
    #[test]
    fn power_is_the_rate_of_energy() {
        let mut random = Random::new(82);
        for case in 0..100 {
            let robot = random.robot(&Family::default());
            let (numeric, phi, s) = (Numeric::new(&robot), random.phi(&robot), random.state(&robot));
            let energy = |t: f64| {
                let q: Vec<f64> = (0..s.q.len()).map(|j| s.q[j] + t * s.dq[j] + 0.5 * t * t * s.ddq[j]).collect();
                let dq: Vec<f64> = (0..s.q.len()).map(|j| s.dq[j] + t * s.ddq[j]).collect();
                numeric.kinetic_energy(&q, &dq, &phi) + numeric.potential_energy(&q, &phi)
            };
            let h = 1e-4;
            // Fourth order, so that the step can be large compared to rounding.
            let rate = (8.0 * (energy(h) - energy(-h)) - (energy(2.0 * h) - energy(-2.0 * h))) / (12.0 * h);
            let tau = numeric.inverse_dynamics(&s.q, &s.dq, &s.ddq, &phi);
            let lost: f64 = robot.moving().iter().zip(&s.dq).fold(0.0, |sum, (&row, dq)| {
                let d = &robot.joints[row].drive;
                let level = d.viscous_friction.unwrap_or(0.0) * dq + d.coulomb_friction.unwrap_or(0.0) * dq.signum();
                sum + (level + d.offset.unwrap_or(0.0)) * dq
            });
            let power = tau.dot(&DVector::from_column_slice(&s.dq)) - lost;
            let scale = 1.0 + tau.norm() * DVector::from_column_slice(&s.dq).norm();
            assert!((rate - power).abs() < 1e-7 * scale, "case {case}: {rate} {power}");
        }
    }

    /// `dU/dq = g(q)`.
    #[test]
    fn gravity_is_the_slope_of_the_potential() {
        let mut random = Random::new(83);
        for _ in 0..50 {
            let robot = random.robot(&Family::default());
            let (numeric, phi, s) = (Numeric::new(&robot), random.phi(&robot), random.state(&robot));
            let g = numeric.gravity(&s.q, &phi);
            for j in 0..robot.dof() {
                let at = |t: f64| {
                    let mut q = s.q.clone();
                    q[j] += t;
                    numeric.potential_energy(&q, &phi)
                };
                let slope = (at(1e-5) - at(-1e-5)) / 2e-5;
                assert!((slope - g[j]).abs() < 1e-6 * (1.0 + at(0.0).abs() + g.amax()));
            }
        }
    }
}
