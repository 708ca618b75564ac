//! Rigid-body algorithms of a serial arm, run on numbers: the oracle of the tests and the baseline
//! of the benches.
//!
//! `Robot -> rows (transform(q), axis) -> one recursive sweep per algorithm, in spatial vectors ->
//! nalgebra`
//!
//! Written from R. Featherstone, *Rigid Body Dynamics Algorithms* (Springer 2008; "RBDA" below).
//! Invariant: this module shares nothing with the code generator but the robot's type and the order
//! of the parameters ([`dh_codegen::arm::param`]), so that agreement between the two means
//! something.
//!
//! Everywhere there are `n` degrees of freedom and `P` standard parameters `phi` in the order of
//! `param::standard`. `q` is in rad or m, one entry per moving row. Torques are in N m (N for a
//! prismatic joint), those of the actuators on the links, positive in the direction in which `q`
//! grows. Parameters are given at each call, so one [`Numeric`] serves any estimate. A tool counts
//! only through its pose here: `param::standard_values` folds its inertia into the last link's.
//!
//! Every method panics when an argument has the wrong length (`q`, `dq`, `ddq`, `tau`: `n`; `phi`:
//! `P`), and says which.

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
    /// Index into `q`; `None` for a drive on a fixed row, which does nothing.
    joint: Option<usize>,
    term: DriveTerm,
}

/// A robot, ready to compute.
#[derive(Debug, Clone)]
pub struct Numeric {
    rows: Vec<Row>,
    dof: usize,
    /// In the world frame, m/s^2.
    gravity: Vector3<f64>,
    /// From the world frame to frame 0.
    base: Plucker,
    /// From the last DH frame to the tool frame; the identity without a tool.
    tool: Plucker,
    drives: Vec<DriveColumn>,
    parameters: usize,
}

/// Scratch for the intermediate results of one call, so that repeated calls through the `_into`
/// methods allocate nothing.
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
    /// From a robot's rows, gravity, tool pose and the list of its drive parameters.
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

    /// Scratch for the `_into` methods; of this robot only.
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

    /// Spatial acceleration of the base that stands for gravity (RBDA, section 5.3): upwards, as
    /// the free fall is not felt; in frame 0.
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

/// The ten parameters of row `i`.
fn body(phi: &[f64], i: usize) -> SpatialInertia {
    SpatialInertia::from_parameters(&phi[10 * i..10 * i + 10])
}

/// Sign with `sign(0) = 0`, unlike `f64::signum`: a joint at rest shows no Coulomb friction.
fn sign(x: f64) -> f64 {
    if x == 0.0 { 0.0 } else { x.signum() }
}

#[cfg(test)]
mod tests {
    use super::base::{Reduction, Torques};
    use super::*;
    use dh_codegen::robot::JointKind;

    /// Robots that cannot move, with rows and without, have results of size zero and nothing to
    /// stumble over.
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
