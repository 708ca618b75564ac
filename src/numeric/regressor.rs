//! The regressor: each unit parameter's spatial force, carried to the joints inside of it.

use dh_codegen::arm::param::{DriveTerm, Inertial, Parameter};
use nalgebra::{DMatrix, DVector, Vector3};

use super::{Inertia6, Motion6, Numeric, SpatialTransform};

impl Numeric {
    /// Velocity and acceleration (gravity in it) of every body.
    fn motions(&self, q: &[f64], dq: &[f64], ddq: &[f64]) -> Vec<(Motion6, Motion6)> {
        let (x, s) = (self.transforms(q), self.axes());
        let mut velocity = Motion6::zero();
        let mut acceleration = Motion6 { w: Vector3::zeros(), v: -self.gravity };
        (0..self.rows())
            .map(|i| {
                let (rate, second) = self.bodies[i].dof.map_or((0.0, 0.0), |k| (dq[k], ddq[k]));
                let joint = s[i].scaled(rate);
                velocity = x[i].motion(&velocity) + joint;
                acceleration = x[i].motion(&acceleration) + s[i].scaled(second) + velocity.cross(&joint);
                (velocity, acceleration)
            })
            .collect()
    }

    /// Torques of all joints for one unit parameter of a body that moves like this.
    fn column(
        &self,
        x: &[SpatialTransform],
        s: &[Motion6],
        row: usize,
        motion: &(Motion6, Motion6),
        which: Inertial,
    ) -> DVector<f64> {
        let unit = Inertia6::unit(which);
        let mut force = unit.times(&motion.1) + motion.0.cross_force(&unit.times(&motion.0));
        let mut tau = DVector::zeros(self.dof());
        for i in (0..=row).rev() {
            if let Some(k) = self.bodies[i].dof {
                tau[k] = s[i].dot(&force);
            }
            force = x[i].force_back(&force);
        }
        tau
    }

    /// `n x P`: `tau = W phi`.
    pub fn regressor(&self, q: &[f64], dq: &[f64], ddq: &[f64]) -> DMatrix<f64> {
        let (x, s, motions) = (self.transforms(q), self.axes(), self.motions(q, dq, ddq));
        let mut w = DMatrix::zeros(self.dof(), self.parameters.len());
        for (column, parameter) in self.parameters.iter().enumerate() {
            match *parameter {
                Parameter::Link(row, which) => w.set_column(column, &self.column(&x, &s, row, &motions[row], which)),
                Parameter::Drive(row, term) => {
                    let Some(k) = self.bodies[row].dof else { continue };
                    w[(k, column)] = match term {
                        DriveTerm::IA => ddq[k],
                        DriveTerm::FV => dq[k],
                        DriveTerm::FC => {
                            if dq[k] == 0.0 {
                                0.0
                            } else {
                                dq[k].signum()
                            }
                        }
                        DriveTerm::FO => 1.0,
                    };
                }
            }
        }
        w
    }

    /// `n x 10`: columns of a body in the tool frame.
    pub fn payload_regressor(&self, q: &[f64], dq: &[f64], ddq: &[f64]) -> DMatrix<f64> {
        let (x, s, motions) = (self.transforms(q), self.axes(), self.motions(q, dq, ddq));
        let mut w = DMatrix::zeros(self.dof(), 10);
        let Some(last) = self.rows().checked_sub(1) else { return w };
        let to_tool = SpatialTransform::from_pose(&self.tool);
        let (velocity, acceleration) = (to_tool.motion(&motions[last].0), to_tool.motion(&motions[last].1));
        for (column, which) in Inertial::ALL.into_iter().enumerate() {
            let unit = Inertia6::unit(which);
            let mut force = unit.times(&acceleration) + velocity.cross_force(&unit.times(&velocity));
            force = to_tool.force_back(&force);
            for i in (0..=last).rev() {
                if let Some(k) = self.bodies[i].dof {
                    w[(k, column)] = s[i].dot(&force);
                }
                force = x[i].force_back(&force);
            }
        }
        w
    }
}
