//! Closed-form kinematics and dynamics of `ur10e`: 6 degrees of freedom, 58 base parameters.
//!
//! Written by denavit 0.1.0 from the robot file with digest 857c86307a0c5043. Do not edit it:
//! change the file and run `denavit generate` again.
//!
//! SI units: m, rad, s, kg, N m. Torques are those of the actuators on the links. Poses and
//! Jacobians are in the world frame: frame 0 of the table where the robot file has no `base`.
//! Tensors are about the frame's origin. Nothing is allocated; nothing but `core` is used. Kernels
//! (module `kernel`) take sines and cosines (`Trig`); the functions here take `q`. All are generic
//! over `runtime::Scalar`: `f64`, `f32` and packs of states run the same text. With the feature
//! `dispatch` (needs `std`) module `dispatch` has them for `f64` with the instructions of the
//! processor at hand.
//!
//! ```
//! use ur10e as arm;
//!
//! // Frames: rows of homogeneous matrices, m. Every posture found reaches the pose.
//! let q = [0.3, -0.4, 0.5, -0.6, 0.7, -0.8];
//! let pose = arm::forward_kinematics(&q);
//! let query = arm::ik::Query { near: Some(&q), ..Default::default() };
//! let postures = arm::inverse_kinematics(&pose, &query).expect("a pose");
//! for posture in postures.as_slice() {
//!     let reached = arm::forward_kinematics(&posture.q);
//!     assert!((0..3).all(|row| (reached[row][3] - pose[row][3]).abs() < 1e-9));
//! }
//!
//! // Torques: they are linear in the parameters.
//! let phi = arm::STANDARD_VALUES.expect("the robot file has the parameters of every link");
//! let beta = arm::base_parameters(&phi);
//! let (dq, ddq) = ([0.1; arm::DOF], [0.2; arm::DOF]);
//! let tau = arm::inverse_dynamics_base(&q, &dq, &ddq, &beta);
//! let regressor = arm::base_regressor(&q, &dq, &ddq);
//! for (row, tau) in regressor.iter().zip(tau) {
//!     let sum: f64 = row.iter().zip(&beta).map(|(w, b)| w * b).sum();
//!     assert!((sum - tau).abs() < 1e-9 * (1.0 + tau.abs()));
//! }
//! ```
//!
//! | function | result | multiplications | additions |
//! |---|---|---|---|
//! | [`frames`]: DH frames of all rows in the world frame | 6 x 3 x 4 | 64 | 50 |
//! | [`forward_kinematics`]: The last DH frame in the world frame | 3 x 4 | 64 | 35 |
//! | [`tool_pose`]: The tool frame in the world frame | 3 x 4 | 64 | 35 |
//! | [`jacobian`]: Jacobian of the last DH frame's origin, in world axes | 6 x 6 | 65 | 40 |
//! | [`tool_jacobian`]: Jacobian of the tool frame's origin, in world axes | 6 x 6 | 65 | 40 |
//! | [`jacobian_dot_velocity`]: Acceleration of the last DH frame at zero `ddq`: `dJ/dt dq` | 6 | 140 | 79 |
//! | [`inverse_dynamics`]: Torques from the standard parameters | 6 | 309 | 289 |
//! | [`inverse_dynamics_base`]: Torques from the base parameters | 6 | 265 | 238 |
//! | [`mass_matrix`]: Mass matrix `M`, symmetric, kg m^2 | 6 x 6 | 163 | 147 |
//! | [`coriolis`]: Coriolis and centrifugal torques `C dq` | 6 | 218 | 180 |
//! | [`gravity`]: Gravity torques `g` | 6 | 48 | 26 |
//! | [`forward_dynamics`]: Accelerations under given torques | 6 | 514 | 420 |
//! | [`regressor`]: Regressor `W` of the standard parameters | 6 x 84 | 406 | 322 |
//! | [`base_regressor`]: Regressor `W_b` of the base parameters | 6 x 58 | 308 | 243 |
//! | [`gravity_regressor`]: Regressor at rest | 6 x 60 | 111 | 63 |
//! | [`kinetic_energy_regressor`]: Kinetic energy, one entry per standard parameter | 84 | 135 | 50 |
//! | [`potential_energy_regressor`]: Potential energy, one entry per standard parameter | 84 | 32 | 12 |
//! | [`payload_regressor`]: Regressor of a body fixed to the tool frame | 6 x 10 | 252 | 176 |

#![no_std]
#![deny(unsafe_code)]
#![warn(missing_docs)]
#![allow(clippy::all)]

#[cfg(any(test, feature = "dispatch"))]
extern crate std;

pub mod constants;
#[cfg(feature = "dispatch")]
pub mod dispatch;
pub mod ik;
mod implementations;
pub mod kernel;
mod parameters;
pub mod robot;
pub mod runtime;
#[cfg(test)]
mod tests;

pub use implementations::Robot;
pub use parameters::*;

use runtime::Scalar;

/// A configuration with the sines and cosines that all kernels share: make it once per state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trig<S> {
    /// Positions, rad or m.
    pub q: [S; DOF],
    /// Sines of the joint angles, constant offsets (quarter turns apart) included.
    pub sin: [S; DOF],
    /// Their cosines.
    pub cos: [S; DOF],
}

impl<S: Scalar> Trig<S> {
    /// Sines and cosines of all joint angles together.
    #[must_use]
    #[inline]
    pub fn new(q: &[S; DOF]) -> Self {
        let (sin, cos) = S::sin_cos_all(q);
        Self { q: *q, sin, cos }
    }
}

/// Base parameters from standard ones, `beta = K phi`.
#[must_use]
pub fn base_parameters<S: Scalar>(phi: &[S; STANDARD]) -> [S; BASE] {
    core::array::from_fn(|k| {
        BASE_COEFFICIENTS[k].iter().fold(S::default(), |sum, &(i, c)| sum + phi[i] * S::constant(c))
    })
}

/// DH frames of all rows in the world frame.
///
/// `out[i]` is the top three rows of the homogeneous matrix `T(0, i+1)`, m and one. Khalil and
/// Dombre, 3.2. Packed form: [`kernel::frames::packed`].
#[must_use]
#[inline]
pub fn frames<S: Scalar>(q: &[S; DOF]) -> [[[S; 4]; 3]; 6] {
    let mut out = [[[S::default(); 4]; 3]; 6];
    kernel::frames::nonzeros(&Trig::new(q), &mut out);
    out
}

/// The last DH frame in the world frame.
///
/// `out` is the top three rows of `T(0, n)`: axes of the frame as columns, then its origin, m.
/// Khalil and Dombre, 3.2.
#[must_use]
#[inline]
pub fn forward_kinematics<S: Scalar>(q: &[S; DOF]) -> [[S; 4]; 3] {
    let mut out = [[S::default(); 4]; 3];
    kernel::forward_kinematics::dense(&Trig::new(q), &mut out);
    out
}

/// The tool frame in the world frame.
///
/// Like `forward_kinematics`, followed by the tool's pose (the identity where the robot file has no
/// tool).
#[must_use]
#[inline]
pub fn tool_pose<S: Scalar>(q: &[S; DOF]) -> [[S; 4]; 3] {
    let mut out = [[S::default(); 4]; 3];
    kernel::tool_pose::dense(&Trig::new(q), &mut out);
    out
}

/// Jacobian of the last DH frame's origin, in world axes.
///
/// `(v, w) = J dq`: rows 0-2 linear, m/s, rows 3-5 angular, rad/s. Khalil and Dombre, 5.2. Packed
/// form: [`kernel::jacobian::packed`].
#[must_use]
#[inline]
pub fn jacobian<S: Scalar>(q: &[S; DOF]) -> [[S; 6]; 6] {
    let mut out = [[S::default(); 6]; 6];
    kernel::jacobian::nonzeros(&Trig::new(q), &mut out);
    out
}

/// Jacobian of the tool frame's origin, in world axes.
///
/// `(v, w) = J dq` as in `jacobian`; `tau = J' f` are the torques of a wrench on the tool. Khalil
/// and Dombre, 5.2. Packed form: [`kernel::tool_jacobian::packed`].
#[must_use]
#[inline]
pub fn tool_jacobian<S: Scalar>(q: &[S; DOF]) -> [[S; 6]; 6] {
    let mut out = [[S::default(); 6]; 6];
    kernel::tool_jacobian::nonzeros(&Trig::new(q), &mut out);
    out
}

/// Acceleration of the last DH frame at zero `ddq`: `dJ/dt dq`.
///
/// In world axes; entries 0-2 linear, m/s^2, 3-5 angular, rad/s^2. Khalil and Dombre, 5.10.
#[must_use]
#[inline]
pub fn jacobian_dot_velocity<S: Scalar>(q: &[S; DOF], dq: &[S; DOF]) -> [S; 6] {
    let mut out = [S::default(); 6];
    kernel::jacobian_dot_velocity::dense(&Trig::new(q), dq, &mut out);
    out
}

/// Torques from the standard parameters.
///
/// `tau = M ddq + C dq + g + friction`, N m, of the actuators on the links. Newton-Euler, Khalil
/// and Dombre, 9.5.2.
#[must_use]
#[inline]
pub fn inverse_dynamics<S: Scalar>(q: &[S; DOF], dq: &[S; DOF], ddq: &[S; DOF], phi: &[S; STANDARD]) -> [S; 6] {
    let mut out = [S::default(); 6];
    kernel::inverse_dynamics::dense(&Trig::new(q), dq, ddq, phi, &mut out);
    out
}

/// Torques from the base parameters.
///
/// `tau = W_b beta`, N m, without forming `W_b`. Newton-Euler with the regrouped parameters, Khalil
/// and Dombre, 9.6.
#[must_use]
#[inline]
pub fn inverse_dynamics_base<S: Scalar>(q: &[S; DOF], dq: &[S; DOF], ddq: &[S; DOF], beta: &[S; BASE]) -> [S; 6] {
    let mut out = [S::default(); 6];
    kernel::inverse_dynamics_base::dense(&Trig::new(q), dq, ddq, beta, &mut out);
    out
}

/// Mass matrix `M`, symmetric, kg m^2.
///
/// From the base parameters, rotors on the diagonal, by composite bodies. Featherstone, 6.2.
#[must_use]
#[inline]
pub fn mass_matrix<S: Scalar>(q: &[S; DOF], beta: &[S; BASE]) -> [[S; 6]; 6] {
    let mut out = [[S::default(); 6]; 6];
    kernel::mass_matrix::dense(&Trig::new(q), beta, &mut out);
    out
}

/// Coriolis and centrifugal torques `C dq`.
///
/// N m, from the base parameters; no gravity, no friction.
#[must_use]
#[inline]
pub fn coriolis<S: Scalar>(q: &[S; DOF], dq: &[S; DOF], beta: &[S; BASE]) -> [S; 6] {
    let mut out = [S::default(); 6];
    kernel::coriolis::dense(&Trig::new(q), dq, beta, &mut out);
    out
}

/// Gravity torques `g`.
///
/// N m, from the base parameters: the torques that hold the arm at rest.
#[must_use]
#[inline]
pub fn gravity<S: Scalar>(q: &[S; DOF], beta: &[S; BASE]) -> [S; 6] {
    let mut out = [S::default(); 6];
    kernel::gravity::dense(&Trig::new(q), beta, &mut out);
    out
}

/// Accelerations under given torques.
///
/// `ddq = M^-1 (tau - C dq - g - friction)`, rad/s^2, from the base parameters; `M = L D L'` in
/// closed form.
#[must_use]
#[inline]
pub fn forward_dynamics<S: Scalar>(q: &[S; DOF], dq: &[S; DOF], tau: &[S; DOF], beta: &[S; BASE]) -> [S; 6] {
    let mut out = [S::default(); 6];
    kernel::forward_dynamics::dense(&Trig::new(q), dq, tau, beta, &mut out);
    out
}

/// Regressor `W` of the standard parameters.
///
/// `tau = W phi`, row j in N m per unit of each parameter; columns as in `STANDARD_NAMES`. Khalil
/// and Dombre, 12.4. Packed form: [`kernel::regressor::packed`].
#[must_use]
#[inline]
pub fn regressor<S: Scalar>(q: &[S; DOF], dq: &[S; DOF], ddq: &[S; DOF]) -> [[S; 84]; 6] {
    let mut out = [[S::default(); 84]; 6];
    kernel::regressor::nonzeros(&Trig::new(q), dq, ddq, &mut out);
    out
}

/// Regressor `W_b` of the base parameters.
///
/// `tau = W_b beta`, row j in N m per unit of each parameter; columns as in `BASE_NAMES`. Khalil
/// and Dombre, 12.4. Packed form: [`kernel::base_regressor::packed`].
#[must_use]
#[inline]
pub fn base_regressor<S: Scalar>(q: &[S; DOF], dq: &[S; DOF], ddq: &[S; DOF]) -> [[S; 58]; 6] {
    let mut out = [[S::default(); 58]; 6];
    kernel::base_regressor::nonzeros(&Trig::new(q), dq, ddq, &mut out);
    out
}

/// Regressor at rest.
///
/// `g = W_g phi` of the links' parameters; columns as the first of `STANDARD_NAMES`, without the
/// drives'. Packed form: [`kernel::gravity_regressor::packed`].
#[must_use]
#[inline]
pub fn gravity_regressor<S: Scalar>(q: &[S; DOF]) -> [[S; 60]; 6] {
    let mut out = [[S::default(); 60]; 6];
    kernel::gravity_regressor::nonzeros(&Trig::new(q), &mut out);
    out
}

/// Kinetic energy, one entry per standard parameter.
///
/// `T = h phi`, J per unit. Khalil and Dombre, 9.4. Packed form:
/// [`kernel::kinetic_energy_regressor::packed`].
#[must_use]
#[inline]
pub fn kinetic_energy_regressor<S: Scalar>(q: &[S; DOF], dq: &[S; DOF]) -> [S; 84] {
    let mut out = [S::default(); 84];
    kernel::kinetic_energy_regressor::nonzeros(&Trig::new(q), dq, &mut out);
    out
}

/// Potential energy, one entry per standard parameter.
///
/// `U = h phi`, J per unit, zero at the world frame's origin; an offset torque counts as `FO q`.
/// Packed form: [`kernel::potential_energy_regressor::packed`].
#[must_use]
#[inline]
pub fn potential_energy_regressor<S: Scalar>(q: &[S; DOF]) -> [S; 84] {
    let mut out = [S::default(); 84];
    kernel::potential_energy_regressor::nonzeros(&Trig::new(q), &mut out);
    out
}

/// Regressor of a body fixed to the tool frame.
///
/// `tau = W_L phi_L`, columns `M MSX MSY MSZ XX YY ZZ XY XZ YZ` in the tool frame, about its
/// origin. Katsumata et al. 2019, (7). Packed form: [`kernel::payload_regressor::packed`].
#[must_use]
#[inline]
pub fn payload_regressor<S: Scalar>(q: &[S; DOF], dq: &[S; DOF], ddq: &[S; DOF]) -> [[S; 10]; 6] {
    let mut out = [[S::default(); 10]; 6];
    kernel::payload_regressor::nonzeros(&Trig::new(q), dq, ddq, &mut out);
    out
}

/// All postures that bring the last DH frame to a pose: the top three rows of `T(0, n)`, m.
///
/// Axes 2-4 are parallel, and the two at their end meet.
///
/// # Errors
/// If an entry is not finite, or the first three columns are no rotation.
pub fn inverse_kinematics(pose: &[[f64; 4]; 3], query: &ik::Query<'_, DOF>) -> Result<ik::Solutions<DOF>, ik::PoseError> {
    IK.solve_inlined(pose, query)
}

/// The same for a pose of the tool frame, as [`tool_pose`] gives it; errors are the tool's.
///
/// # Errors
/// Like [`inverse_kinematics`].
pub fn tool_inverse_kinematics(pose: &[[f64; 4]; 3], query: &ik::Query<'_, DOF>) -> Result<ik::Solutions<DOF>, ik::PoseError> {
    IK.with_tool(&TOOL).solve(pose, query)
}
