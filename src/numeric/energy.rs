//! Energies, from velocities and heights.

use dh_codegen::arm::param::DriveTerm;

use super::{Motion6, Numeric};

impl Numeric {
    /// Kinetic energy, J, rotors included.
    pub fn kinetic_energy(&self, q: &[f64], dq: &[f64], phi: &[f64]) -> f64 {
        let (x, s, inertia) = (self.transforms(q), self.axes(), self.inertias(phi));
        let mut velocity = Motion6::zero();
        let mut energy = 0.0;
        for i in 0..self.rows() {
            velocity = x[i].motion(&velocity) + s[i].scaled(self.bodies[i].dof.map_or(0.0, |k| dq[k]));
            energy += 0.5 * velocity.dot(&inertia[i].times(&velocity));
        }
        energy + self.drive(DriveTerm::IA, phi).iter().zip(dq).map(|(rotor, v)| 0.5 * rotor * v * v).sum::<f64>()
    }

    /// Potential energy of the links, J, zero at the base frame's origin.
    pub fn potential_energy(&self, q: &[f64], phi: &[f64]) -> f64 {
        let inertia = self.inertias(phi);
        self.frames(q)
            .iter()
            .zip(&inertia)
            .map(|(pose, i)| -self.gravity.dot(&(pose.translation.vector * i.mass + pose.rotation * i.moment)))
            .sum()
    }
}
