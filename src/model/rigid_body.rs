//! Numeric rigid-body algorithms of a serial arm: reference for the tests and baseline of the
//! benchmarks.
//!
//! `Robot -> rows (transform(q), axis) -> one recursive sweep per algorithm, in spatial vectors ->
//! nalgebra`
//!
//! Written from R. Featherstone, *Rigid Body Dynamics Algorithms* (Springer 2008; "RBDA" below).
//! Invariant: this module shares only the robot's type and the order of the parameters
//! ([`dh_codegen::arm::param`]) with the code generator, so that the two are independent.
//!
//! Throughout, there are `n` degrees of freedom and `P` standard parameters `phi` in the order of
//! `param::standard`. `q` is in rad or m, one entry per moving row. Torques are in N m (N for a
//! prismatic joint), those of the actuators on the links, positive in the direction of increasing
//! `q`. Parameters are passed to each call, so one [`Numeric`] serves any estimate. Only the pose
//! of a tool matters here: `param::standard_values` adds its inertia to the last link's.
//!
//! Every method panics with the name of the argument if an argument has the wrong length (`q`,
//! `dq`, `ddq`, `tau`: `n`; `phi`: `P`).

mod aba;
pub mod base;
mod coriolis_matrix;
mod crba;
mod energy;
mod kinematics;
mod payload;
#[cfg(test)]
mod published;
pub mod random;
mod regressor;
mod rnea;
mod row;
#[doc(hidden)]
pub mod samples;
pub mod spatial;

use dh_codegen::arm::param::{self, DriveTerm, Parameter};
use dh_codegen::robot::Robot;
use nalgebra::{Matrix3, Vector3};

use row::Row;
use spatial::{ArticulatedInertia, Force, Motion, Plucker, SpatialInertia};

/// A column of a drive parameter.
#[derive(Debug, Clone, Copy)]
struct DriveColumn {
    /// Index into `phi`.
    column: usize,
    /// Index of the row.
    row: usize,
    /// Index into `q`; `None` for a drive on a fixed row, which has no effect.
    joint: Option<usize>,
    term: DriveTerm,
}

/// A robot prepared for numeric evaluation.
#[derive(Debug, Clone)]
pub struct Numeric {
    rows: Vec<Row>,
    dof: usize,
    /// Gravity in the world frame, m/s^2.
    gravity: Vector3<f64>,
    /// Transform from the world frame to frame 0.
    base: Plucker,
    /// Transform from the last DH frame to the tool frame; the identity without a tool.
    tool: Plucker,
    drives: Vec<DriveColumn>,
    parameters: usize,
}

/// Buffers for intermediate results, so that repeated calls of the `_into` methods allocate
/// nothing.
#[derive(Debug, Clone)]
pub struct Workspace {
    x: Vec<Plucker>,
    v: Vec<Motion>,
    a: Vec<Motion>,
    f: Vec<Force>,
    inertia: Vec<SpatialInertia>,
    articulated: Vec<ArticulatedInertia>,
    u: Vec<Force>,
    d: Vec<f64>,
}

impl Numeric {
    /// Built from a robot's rows, gravity, tool pose and drive parameters.
    pub fn new(robot: &Robot) -> Self {
        let mut moving = vec![None; robot.joints.len()];
        for (joint, row) in robot.moving().into_iter().enumerate() {
            moving[row] = Some(joint);
        }
        let rows =
            robot.joints.iter().zip(&moving).map(|(row, &joint)| Row::new(robot.convention, row, joint)).collect();
        let standard = param::standard(robot);
        let drives = standard.iter().enumerate().filter_map(|(column, p)| match *p {
            Parameter::Drive(row, term) => Some(DriveColumn { column, row, joint: moving[row], term }),
            Parameter::Link(..) => None,
        });
        let pose = |rotation: [[f64; 3]; 3], origin: [f64; 3]| Plucker {
            rotation: Matrix3::from(rotation).transpose(), // `from` reads columns
            origin: Vector3::from(origin),
        };
        let tool = robot.tool.as_ref().map_or_else(Plucker::identity, |tool| pose(tool.rotation(), tool.xyz));
        let base = robot.base.as_ref().map_or_else(Plucker::identity, |base| pose(base.rotation(), base.xyz));
        Self {
            rows,
            dof: robot.dof(),
            gravity: Vector3::from(robot.gravity),
            base,
            tool,
            drives: drives.collect(),
            parameters: standard.len(),
        }
    }

    /// Degrees of freedom, `n`.
    pub fn dof(&self) -> usize {
        self.dof
    }

    /// Number of standard parameters, `P`.
    pub fn parameters(&self) -> usize {
        self.parameters
    }

    /// Buffers for the `_into` methods, for this robot only.
    pub fn workspace(&self) -> Workspace {
        let rows = self.rows.len();
        Workspace {
            x: vec![Plucker::identity(); rows],
            v: vec![Motion::zero(); rows],
            a: vec![Motion::zero(); rows],
            f: vec![Force::zero(); rows],
            inertia: vec![SpatialInertia::zero(); rows],
            articulated: vec![SpatialInertia::zero().into(); rows],
            u: vec![Force::zero(); rows],
            d: vec![0.0; rows],
        }
    }

    /// Spatial acceleration of the base equivalent to gravity (RBDA, section 5.3), in frame 0:
    /// upwards, since free fall is unaccelerated.
    fn base_acceleration(&self) -> Motion {
        Motion { w: Vector3::zeros(), v: -self.base.rotation.tr_mul(&self.gravity) }
    }

    fn check(&self, name: &str, length: usize) {
        assert_eq!(length, self.dof, "{name} has one entry per moving row");
    }

    fn check_phi(&self, phi: &[f64]) {
        assert_eq!(phi.len(), self.parameters, "phi has the entries of param::standard");
    }
}

/// Spatial inertia of row `i`.
fn body(phi: &[f64], i: usize) -> SpatialInertia {
    SpatialInertia::from_parameters(&phi[10 * i..10 * i + 10])
}

/// Sign with `sign(0) = 0`, unlike `f64::signum`: a joint at rest has no Coulomb friction here.
fn sign(x: f64) -> f64 {
    if x == 0.0 { 0.0 } else { x.signum() }
}

#[cfg(test)]
mod tests {
    use super::base::{Reduction, Torques};
    use super::*;
    use dh_codegen::robot::JointKind;

    /// Immobile robots, with rows and without, have results of size zero and cause no error.
    #[test]
    fn a_robot_without_joints_computes_nothing() {
        let mut fixed = samples::with_rotors(samples::planar_2r());
        fixed.joints.iter_mut().for_each(|j| j.kind = JointKind::Fixed);
        let mut empty = samples::planar_2r();
        empty.joints.clear();
        for robot in [fixed, empty] {
            let (numeric, rows) = (Numeric::new(&robot), robot.joints.len());
            let phi = vec![1.0; numeric.parameters()];
            assert_eq!(numeric.dof(), 0);
            assert_eq!(numeric.frames(&[]).len(), rows);
            assert_eq!(numeric.jacobian(&[]).ncols(), 0);
            assert_eq!(numeric.jacobian_dot_dq(&[], &[]).norm(), 0.0);
            assert_eq!(numeric.inverse_dynamics(&[], &[], &[], &phi).len(), 0);
            assert_eq!(numeric.forward_dynamics(&[], &[], &[], &phi).len(), 0);
            assert_eq!(numeric.mass_matrix(&[], &phi).len(), 0);
            assert_eq!(numeric.coriolis_matrix(&[], &[], &phi).len(), 0);
            assert_eq!(numeric.regressor(&[], &[], &[]).shape(), (0, phi.len()));
            assert_eq!(numeric.payload_regressor(&[], &[], &[]).shape(), (0, 10));
            assert_eq!(numeric.kinetic_energy(&[], &[], &phi), 0.0);
            assert!(numeric.potential_energy(&[], &phi).is_finite());
            assert_eq!(base::rank(&robot, 1, 10).rank, 0);
            assert_eq!(base::null_space(&robot, Torques::Motion, 1, 10).ncols(), phi.len());
            assert_eq!(Reduction::pivoted(&robot, 1, 10).base_values(&phi).len(), 0);
            assert_eq!(Reduction::customary(&robot, 1, 10).unwrap().dependent.len(), phi.len());
        }
    }

    #[test]
    #[should_panic(expected = "dq has one entry per moving row")]
    fn a_wrong_length_is_named() {
        let numeric = Numeric::new(&samples::planar_2r());
        let _ = numeric.inverse_dynamics(&[0.0; 2], &[0.0; 3], &[0.0; 2], &[0.0; 20]);
    }
}
