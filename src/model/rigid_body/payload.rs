//! Regressor of a carried body.

use nalgebra::{DMatrix, Matrix6};

use super::Numeric;
use super::rnea::Sweep;
use super::spatial::body_regressor;

impl Numeric {
    /// Regressor `Y`, `n x 10`, of the torques `Y pi` of a carried body. `pi` are its ten
    /// parameters (`M MSX .. YZ`) in the tool frame, about its origin; without a tool in the last
    /// DH frame.
    pub fn payload_regressor(&self, q: &[f64], dq: &[f64], ddq: &[f64]) -> DMatrix<f64> {
        self.check("q", q.len());
        self.check("dq", dq.len());
        self.check("ddq", ddq.len());
        let mut work = self.workspace();
        self.outward(&mut work, &Sweep { q, dq, ddq, base_acceleration: self.base_acceleration() });
        let mut y = DMatrix::zeros(self.dof, 10);
        if let (Some(v), Some(a)) = (work.v.last(), work.a.last()) {
            let to_last: Matrix6<f64> = self.tool.matrix().transpose();
            let forces = to_last * body_regressor(&self.tool.motion(v), &self.tool.motion(a));
            self.carry_inward(&work, self.rows.len() - 1, &forces, 0, &mut y);
        }
        y
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::rigid_body::random::Family;
    use crate::numerics::prng::Random;
    use dh_codegen::arm::param;
    use nalgebra::DVector;

    /// A payload is equivalent to a tool: added to the last link it changes the torques by the
    /// same.
    #[test]
    fn payload_adds_what_a_heavier_tool_does() {
        let mut random = Random::new(71);
        for case in 0..100 {
            let bare = random.robot(&Family { tool: 0.7, ..Family::default() });
            let mut loaded = bare.clone();
            let payload = random.inertia();
            match &mut loaded.tool {
                Some(tool) => tool.inertia = Some(tool.inertia.unwrap_or_default().plus(&payload)),
                None => {
                    let last = loaded.links.last_mut().unwrap();
                    *last = Some(last.unwrap().plus(&payload));
                }
            }
            let (numeric, s) = (Numeric::new(&bare), random.state(&bare));
            let torque =
                |robot: &_| numeric.inverse_dynamics(&s.q, &s.dq, &s.ddq, &param::standard_values(robot).unwrap());
            let (before, after) = (torque(&bare), torque(&loaded));
            let gained =
                numeric.payload_regressor(&s.q, &s.dq, &s.ddq) * DVector::from_column_slice(&payload.to_array());
            assert!((&after - &before - gained).amax() < 1e-11 * (1.0 + after.amax()), "case {case}");
        }
    }
}
