//! Traits that every robot implements, so that code is written once for all of them: a description,
//! kinematics, dynamics, and the inverse.
//!
//! `N` is the number of joints. Parameters are vectors of the robot's own length, associated types
//! of [`Dynamics`]. `S` is the scalar: `f64` unless said otherwise, `f32`, or a pack of states.

use super::ik::{Arm, PoseError, Query, Reference, Solutions};
use super::runtime::Scalar;

/// Top three rows of a homogeneous matrix: axes of a frame as columns, then its origin, m.
pub type Pose<S = f64> = [[S; 4]; 3];

/// An array of scalars whose length is the robot's.
pub trait Vector<S>: Copy + AsRef<[S]> + AsMut<[S]> {
    /// All zero.
    fn zero() -> Self;

    /// Entry by entry.
    fn from_fn(mut entry: impl FnMut(usize) -> S) -> Self {
        let mut all = Self::zero();
        for (k, place) in all.as_mut().iter_mut().enumerate() {
            *place = entry(k);
        }
        all
    }
}

impl<S: Scalar, const N: usize> Vector<S> for [S; N] {
    fn zero() -> Self {
        [S::default(); N]
    }
}

/// Names, sizes and limits.
pub trait Description {
    /// Name of the robot.
    const NAME: &'static str;
    /// Degrees of freedom.
    const DOF: usize;
    /// Rows of the DH table, fixed ones too.
    const ROWS: usize;
    /// Standard parameters: ten per row, then the drives'.
    const STANDARD: usize;
    /// Base parameters.
    const BASE: usize;
    /// Joints, in the order of `q`.
    const JOINT_NAMES: &'static [&'static str];
    /// Standard parameters, in the order of the regressor's columns.
    const STANDARD_NAMES: &'static [&'static str];
    /// Base parameters, in the order of the base regressor's columns.
    const BASE_NAMES: &'static [&'static str];
    /// Gravity in the world frame, m/s^2.
    const GRAVITY: [f64; 3];
    /// Lower and upper position of each joint, rad or m.
    const POSITION_LIMITS: &'static [Option<[f64; 2]>];
    /// Largest speeds, rad/s or m/s.
    const VELOCITY_LIMITS: &'static [Option<f64>];
    /// Largest accelerations, rad/s^2 or m/s^2.
    const ACCELERATION_LIMITS: &'static [Option<f64>];
    /// Largest torques or forces, N m or N.
    const TORQUE_LIMITS: &'static [Option<f64>];
}

/// Frames and their velocities.
pub trait Kinematics<const N: usize, S: Scalar = f64>: Description {
    /// The last DH frame in the world frame.
    fn forward_kinematics(&self, q: &[S; N]) -> Pose<S>;
    /// The tool frame in the world frame.
    fn tool_pose(&self, q: &[S; N]) -> Pose<S>;
    /// Jacobian of the last DH frame's origin in world axes: rows 0-2 linear, 3-5 angular.
    fn jacobian(&self, q: &[S; N]) -> [[S; N]; 6];
    /// Jacobian of the tool frame's origin, likewise.
    fn tool_jacobian(&self, q: &[S; N]) -> [[S; N]; 6];
    /// `dJ/dt dq` of the last DH frame: linear, m/s^2, then angular, rad/s^2.
    fn jacobian_dot_velocity(&self, q: &[S; N], dq: &[S; N]) -> [S; 6];
}

/// Torques, accelerations, energies, and their regressors.
pub trait Dynamics<const N: usize, S: Scalar = f64>: Kinematics<N, S> {
    /// Standard parameters, `[S; STANDARD]`.
    type Standard: Vector<S>;
    /// Base parameters, `[S; BASE]`.
    type Base: Vector<S>;

    /// Standard parameters of the robot file; `None` where some links have none there.
    fn standard_values(&self) -> Option<Self::Standard>;
    /// Base parameters from standard ones.
    fn base_parameters(&self, phi: &Self::Standard) -> Self::Base;
    /// Torques from the standard parameters, N m, with the effects of the robot file.
    fn inverse_dynamics(&self, q: &[S; N], dq: &[S; N], ddq: &[S; N], phi: &Self::Standard) -> [S; N];
    /// Torques from the base parameters, N m.
    fn inverse_dynamics_base(&self, q: &[S; N], dq: &[S; N], ddq: &[S; N], beta: &Self::Base) -> [S; N];
    /// Mass matrix, kg m^2.
    fn mass_matrix(&self, q: &[S; N], beta: &Self::Base) -> [[S; N]; N];
    /// Coriolis and centrifugal torques, N m.
    fn coriolis(&self, q: &[S; N], dq: &[S; N], beta: &Self::Base) -> [S; N];
    /// Gravity torques, N m.
    fn gravity(&self, q: &[S; N], beta: &Self::Base) -> [S; N];
    /// Accelerations under torques `tau`, rad/s^2.
    fn forward_dynamics(&self, q: &[S; N], dq: &[S; N], tau: &[S; N], beta: &Self::Base) -> [S; N];
    /// `tau = W phi`, a row for each joint.
    fn regressor(&self, q: &[S; N], dq: &[S; N], ddq: &[S; N]) -> [Self::Standard; N];
    /// `tau = W_b beta`, a row for each joint.
    fn base_regressor(&self, q: &[S; N], dq: &[S; N], ddq: &[S; N]) -> [Self::Base; N];
    /// Regressor of a body fixed to the tool frame: `M MSX MSY MSZ XX YY ZZ XY XZ YZ`.
    fn payload_regressor(&self, q: &[S; N], dq: &[S; N], ddq: &[S; N]) -> [[S; 10]; N];
    /// Kinetic energy, J per unit of each standard parameter.
    fn kinetic_energy_regressor(&self, q: &[S; N], dq: &[S; N]) -> Self::Standard;
    /// Potential energy, J per unit of each standard parameter.
    fn potential_energy_regressor(&self, q: &[S; N]) -> Self::Standard;
}

/// Postures of a pose.
pub trait InverseKinematics<const N: usize>: Kinematics<N> {
    /// Postures that bring the last DH frame to a pose.
    ///
    /// # Errors
    /// If an entry is not finite, or the first three columns are no rotation.
    fn inverse_kinematics(&self, pose: &Pose, query: &Query<'_, N>) -> Result<Solutions<N>, PoseError>;

    /// Postures that bring the tool frame to a pose.
    ///
    /// # Errors
    /// Like [`InverseKinematics::inverse_kinematics`].
    fn tool_inverse_kinematics(&self, pose: &Pose, query: &Query<'_, N>) -> Result<Solutions<N>, PoseError>;

    /// The arm's lines and limits: velocities within limits ([`Arm::velocities`]), small steps
    /// ([`Arm::approach`]), paths ([`Arm::follow`]).
    fn arm(&self) -> Arm<N>;

    /// Redundancy parameter of a posture: its swivel angle or the position of the locked joint;
    /// zero for other arms.
    fn redundancy(&self, q: &[f64; N], reference: &Reference) -> f64;
}
