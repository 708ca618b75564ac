//! Closed-form kinematics and dynamics of `planar2r`: 2 degrees of freedom, 10 base parameters.
//!
//! Written by denavit 0.1.0 from the robot file with digest acb094e26243e6d8; do not edit, run `denavit generate` again.
//!
//! SI units: m, rad, s, kg, N m. Torques are those of the actuators on the links. Nothing is allocated; nothing but `core` is used.
//! Kernels ([`kernel`]) take sines and cosines ([`Trig`]); the functions here take `q`.
//! All are generic over [`runtime::Scalar`]: `f64`, `f32` and packs of states run the same text.
//!
//! | function | result | multiplications | additions |
//! |---|---|---|---|
//! | [`frames`]: DH frames of all rows in the base frame | 2 x 3 x 4 | 6 | 4 |
//! | [`forward_kinematics`]: The last DH frame in the base frame | 3 x 4 | 6 | 3 |
//! | [`tool_pose`]: The tool frame in the base frame | 3 x 4 | 8 | 5 |
//! | [`jacobian`]: Jacobian of the last DH frame's origin, in base axes | 6 x 2 | 2 | 1 |
//! | [`jacobian_dot_velocity`]: Acceleration of the last DH frame that is left when `ddq` is zero: `dJ/dt dq` | 6 | 12 | 5 |
//! | [`inverse_dynamics`]: Torques from the standard parameters | 2 | 29 | 21 |
//! | [`inverse_dynamics_base`]: Torques from the base parameters | 2 | 27 | 19 |
//! | [`mass_matrix`]: Mass matrix `M`, symmetric, kg m^2 | 2 x 2 | 4 | 5 |
//! | [`coriolis`]: Coriolis and centrifugal torques `C dq` | 2 | 12 | 4 |
//! | [`gravity`]: Gravity torques `g` | 2 | 10 | 5 |
//! | [`forward_dynamics`]: Accelerations that torques cause | 2 | 35 | 23 |
//! | [`regressor`]: Regressor `W` of the standard parameters | 2 x 24 | 18 | 12 |
//! | [`base_regressor`]: Regressor `W_b` of the base parameters | 2 x 10 | 16 | 11 |
//! | [`gravity_regressor`]: Regressor at rest | 2 x 20 | 10 | 5 |
//! | [`kinetic_energy_regressor`]: Kinetic energy, one entry per standard parameter | 24 | 12 | 3 |
//! | [`potential_energy_regressor`]: Potential energy, one entry per standard parameter | 24 | 9 | 2 |
//! | [`payload_regressor`]: Regressor of a body fixed to the tool frame | 2 x 10 | 21 | 15 |

#![no_std]
#![deny(unsafe_code)]
#![warn(missing_docs)]
#![allow(clippy::all)]

#[cfg(test)]
extern crate std;

pub mod constants;
pub mod ik;
pub mod kernel;
pub mod runtime;
#[cfg(test)]
mod tests;

use runtime::Scalar;

/// Name of the robot.
pub const NAME: &str = "planar2r";
/// Degrees of freedom.
pub const DOF: usize = 2;
/// Rows of the DH table, fixed ones too.
pub const ROWS: usize = 2;
/// Standard parameters: ten per row, then the drives'.
pub const STANDARD: usize = 24;
/// Base parameters.
pub const BASE: usize = 10;

/// Joints, in the order of `q`.
pub const JOINT_NAMES: [&str; DOF] = [
    "shoulder",
    "elbow",
];
/// Standard parameters, in the order of the regressor's columns (SI; tensors about the frame's origin).
pub const STANDARD_NAMES: [&str; STANDARD] = [
    "M1",
    "MSX1",
    "MSY1",
    "MSZ1",
    "XX1",
    "YY1",
    "ZZ1",
    "XY1",
    "XZ1",
    "YZ1",
    "M2",
    "MSX2",
    "MSY2",
    "MSZ2",
    "XX2",
    "YY2",
    "ZZ2",
    "XY2",
    "XZ2",
    "YZ2",
    "FV1",
    "FV2",
    "FC1",
    "FC2",
];
/// Base parameters, in the order of the base regressor's columns.
pub const BASE_NAMES: [&str; BASE] = [
    "MSX1R",
    "MSY1",
    "ZZ1R",
    "MSX2",
    "MSY2",
    "ZZ2",
    "FV1",
    "FV2",
    "FC1",
    "FC2",
];
/// What each base parameter groups, in the constants of the robot file.
pub const BASE_GROUPINGS: [&str; BASE] = [
    "MSX1R = MSX1 + L1*M2",
    "MSY1 = MSY1",
    "ZZ1R = ZZ1 + L1^2*M2",
    "MSX2 = MSX2",
    "MSY2 = MSY2",
    "ZZ2 = ZZ2",
    "FV1 = FV1",
    "FV2 = FV2",
    "FC1 = FC1",
    "FC2 = FC2",
];
/// The same as numbers: index into the standard parameters, and factor.
pub const BASE_COEFFICIENTS: [&[(usize, f64)]; BASE] = [
    &[(1, 1.0), (10, 0.5)],
    &[(2, 1.0)],
    &[(6, 1.0), (10, 0.25)],
    &[(11, 1.0)],
    &[(12, 1.0)],
    &[(16, 1.0)],
    &[(20, 1.0)],
    &[(21, 1.0)],
    &[(22, 1.0)],
    &[(23, 1.0)],
];

/// Lower and upper position of each joint, rad or m.
pub const POSITION_LIMITS: [Option<[f64; 2]>; DOF] = [Some([-2.9670597283903604, 2.9670597283903604]), Some([-2.6179938779914944, 2.6179938779914944])];
/// Largest speeds, rad/s or m/s.
pub const VELOCITY_LIMITS: [Option<f64>; DOF] = [Some(3.141592653589793), Some(3.141592653589793)];
/// Largest accelerations, rad/s^2 or m/s^2.
pub const ACCELERATION_LIMITS: [Option<f64>; DOF] = [Some(10.471975511965978), Some(10.471975511965978)];
/// Largest torques or forces, N m or N.
pub const TORQUE_LIMITS: [Option<f64>; DOF] = [Some(20.0), Some(8.0)];
/// The robot file's standard parameters, its tool in the last link.
pub const STANDARD_VALUES: Option<[f64; STANDARD]> = Some([0.5, 0.125, 0.0, 0.0, 0.0, 0.041666666666666664, 0.041666666666666664, 0.0, 0.0, 0.0, 0.4, 0.08000000000000002, 0.0, 0.0, 0.0, 0.02133333333333334, 0.02133333333333334, 0.0, 0.0, 0.0, 0.1, 0.05, 0.2, 0.1]);
/// Name, multiplications and additions of each function, sines and cosines apart (`DOF` pairs).
pub const OPERATIONS: [(&str, usize, usize); 17] = [
    ("frames", 6, 4),
    ("forward_kinematics", 6, 3),
    ("tool_pose", 8, 5),
    ("jacobian", 2, 1),
    ("jacobian_dot_velocity", 12, 5),
    ("inverse_dynamics", 29, 21),
    ("inverse_dynamics_base", 27, 19),
    ("mass_matrix", 4, 5),
    ("coriolis", 12, 4),
    ("gravity", 10, 5),
    ("forward_dynamics", 35, 23),
    ("regressor", 18, 12),
    ("base_regressor", 16, 11),
    ("gravity_regressor", 10, 5),
    ("kinetic_energy_regressor", 12, 3),
    ("potential_energy_regressor", 9, 2),
    ("payload_regressor", 21, 15),
];

/// Which inverse the arm has.
pub const IK_CLASS: &str = "planar";
/// What in its geometry makes it so.
pub const IK_REASON: &str = "all turning axes are parallel, everything moves in one plane";
/// Lines of the joints at `q = 0` in base axes, m, and how the arm is taken apart.
pub const IK: ik::Arm<DOF> = ik::Arm {
    axes: [
        ik::Axis { slides: false, h: [0.0, 0.0, 1.0], c: [0.0, 0.0, 0.0] },
        ik::Axis { slides: false, h: [0.0, 0.0, 1.0], c: [0.5, 0.0, 0.0] },
    ],
    home: ik::Displacement { rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], shift: [0.5, 0.0, 0.0] },
    limits: POSITION_LIMITS,
    exact: true,
    family: ik::Family::Plane(ik::Plane {
        h: [0.0, 0.0, 1.0],
        axes: [
        ik::Axis { slides: false, h: [0.0, 0.0, 1.0], c: [0.0, 0.0, 0.0] },
        ik::Axis { slides: false, h: [0.0, 0.0, 1.0], c: [0.5, 0.0, 0.0] },
        ik::Axis { slides: false, h: [0.0, 0.0, 1.0], c: [1.0, 0.5, 0.0] },
        ],
        joints: [Some(0), Some(1), None],
        lift: None,
    }),
};

/// All postures that bring the last DH frame to a pose: the top three rows of `T(0, n)`, m.
///
/// All turning axes are parallel, everything moves in one plane.
///
/// # Errors
/// If an entry is not finite, or the rotation is none.
pub fn inverse_kinematics(pose: &[[f64; 4]; 3], query: &ik::Query<'_, DOF>) -> Result<ik::Solutions<DOF>, ik::PoseError> {
    IK.solve_inlined(pose, query)
}

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

/// DH frames of all rows in the base frame.
///
/// `out[i]` is the top three rows of the homogeneous matrix `T(0, i+1)`, m and one. Khalil and Dombre, 3.2. Packed form: [`kernel::frames::packed`].
#[must_use]
#[inline]
pub fn frames<S: Scalar>(q: &[S; DOF]) -> [[[S; 4]; 3]; 2] {
    let mut out = [[[S::default(); 4]; 3]; 2];
    kernel::frames::nonzeros(&Trig::new(q), &mut out);
    out
}

/// The last DH frame in the base frame.
///
/// `out` is the top three rows of `T(0, n)`: axes of the frame as columns, then its origin, m. Khalil and Dombre, 3.2. Packed form: [`kernel::forward_kinematics::packed`].
#[must_use]
#[inline]
pub fn forward_kinematics<S: Scalar>(q: &[S; DOF]) -> [[S; 4]; 3] {
    let mut out = [[S::default(); 4]; 3];
    kernel::forward_kinematics::nonzeros(&Trig::new(q), &mut out);
    out
}

/// The tool frame in the base frame.
///
/// Like `forward_kinematics`, followed by the tool's pose (the identity where the robot file has no tool). Packed form: [`kernel::tool_pose::packed`].
#[must_use]
#[inline]
pub fn tool_pose<S: Scalar>(q: &[S; DOF]) -> [[S; 4]; 3] {
    let mut out = [[S::default(); 4]; 3];
    kernel::tool_pose::nonzeros(&Trig::new(q), &mut out);
    out
}

/// Jacobian of the last DH frame's origin, in base axes.
///
/// `(v, w) = J dq`: rows 0-2 linear, m/s, rows 3-5 angular, rad/s. Khalil and Dombre, 5.2. Packed form: [`kernel::jacobian::packed`].
#[must_use]
#[inline]
pub fn jacobian<S: Scalar>(q: &[S; DOF]) -> [[S; 2]; 6] {
    let mut out = [[S::default(); 2]; 6];
    kernel::jacobian::nonzeros(&Trig::new(q), &mut out);
    out
}

/// Acceleration of the last DH frame that is left when `ddq` is zero: `dJ/dt dq`.
///
/// In base axes; entries 0-2 linear, m/s^2, 3-5 angular, rad/s^2. Khalil and Dombre, 5.10. Packed form: [`kernel::jacobian_dot_velocity::packed`].
#[must_use]
#[inline]
pub fn jacobian_dot_velocity<S: Scalar>(q: &[S; DOF], dq: &[S; DOF]) -> [S; 6] {
    let mut out = [S::default(); 6];
    kernel::jacobian_dot_velocity::nonzeros(&Trig::new(q), dq, &mut out);
    out
}

/// Torques from the standard parameters.
///
/// `tau = M ddq + C dq + g + friction`, N m, of the actuators on the links. Newton-Euler, Khalil and Dombre, 9.5.2.
#[must_use]
#[inline]
pub fn inverse_dynamics<S: Scalar>(q: &[S; DOF], dq: &[S; DOF], ddq: &[S; DOF], phi: &[S; STANDARD]) -> [S; 2] {
    let mut out = [S::default(); 2];
    kernel::inverse_dynamics::dense(&Trig::new(q), dq, ddq, phi, &mut out);
    out
}

/// Torques from the base parameters.
///
/// `tau = W_b beta`, N m, without forming `W_b`. Newton-Euler with the regrouped parameters, Khalil and Dombre, 9.6.
#[must_use]
#[inline]
pub fn inverse_dynamics_base<S: Scalar>(q: &[S; DOF], dq: &[S; DOF], ddq: &[S; DOF], beta: &[S; BASE]) -> [S; 2] {
    let mut out = [S::default(); 2];
    kernel::inverse_dynamics_base::dense(&Trig::new(q), dq, ddq, beta, &mut out);
    out
}

/// Mass matrix `M`, symmetric, kg m^2.
///
/// From the base parameters, rotors on the diagonal, by composite bodies. Featherstone, 6.2.
#[must_use]
#[inline]
pub fn mass_matrix<S: Scalar>(q: &[S; DOF], beta: &[S; BASE]) -> [[S; 2]; 2] {
    let mut out = [[S::default(); 2]; 2];
    kernel::mass_matrix::dense(&Trig::new(q), beta, &mut out);
    out
}

/// Coriolis and centrifugal torques `C dq`.
///
/// N m, from the base parameters; no gravity, no friction.
#[must_use]
#[inline]
pub fn coriolis<S: Scalar>(q: &[S; DOF], dq: &[S; DOF], beta: &[S; BASE]) -> [S; 2] {
    let mut out = [S::default(); 2];
    kernel::coriolis::dense(&Trig::new(q), dq, beta, &mut out);
    out
}

/// Gravity torques `g`.
///
/// N m, from the base parameters: what holds the arm up at rest.
#[must_use]
#[inline]
pub fn gravity<S: Scalar>(q: &[S; DOF], beta: &[S; BASE]) -> [S; 2] {
    let mut out = [S::default(); 2];
    kernel::gravity::dense(&Trig::new(q), beta, &mut out);
    out
}

/// Accelerations that torques cause.
///
/// `ddq = M^-1 (tau - C dq - g - friction)`, rad/s^2, from the base parameters; `M = L D L'` written out.
#[must_use]
#[inline]
pub fn forward_dynamics<S: Scalar>(q: &[S; DOF], dq: &[S; DOF], tau: &[S; DOF], beta: &[S; BASE]) -> [S; 2] {
    let mut out = [S::default(); 2];
    kernel::forward_dynamics::dense(&Trig::new(q), dq, tau, beta, &mut out);
    out
}

/// Regressor `W` of the standard parameters.
///
/// `tau = W phi`, row j in N m per unit of each parameter; columns as in `STANDARD_NAMES`. Khalil and Dombre, 12.4. Packed form: [`kernel::regressor::packed`].
#[must_use]
#[inline]
pub fn regressor<S: Scalar>(q: &[S; DOF], dq: &[S; DOF], ddq: &[S; DOF]) -> [[S; 24]; 2] {
    let mut out = [[S::default(); 24]; 2];
    kernel::regressor::nonzeros(&Trig::new(q), dq, ddq, &mut out);
    out
}

/// Regressor `W_b` of the base parameters.
///
/// `tau = W_b beta`, row j in N m per unit of each parameter; columns as in `BASE_NAMES`. Khalil and Dombre, 12.4. Packed form: [`kernel::base_regressor::packed`].
#[must_use]
#[inline]
pub fn base_regressor<S: Scalar>(q: &[S; DOF], dq: &[S; DOF], ddq: &[S; DOF]) -> [[S; 10]; 2] {
    let mut out = [[S::default(); 10]; 2];
    kernel::base_regressor::nonzeros(&Trig::new(q), dq, ddq, &mut out);
    out
}

/// Regressor at rest.
///
/// `g = W_g phi` for the links' parameters only; columns as the first of `STANDARD_NAMES`. Packed form: [`kernel::gravity_regressor::packed`].
#[must_use]
#[inline]
pub fn gravity_regressor<S: Scalar>(q: &[S; DOF]) -> [[S; 20]; 2] {
    let mut out = [[S::default(); 20]; 2];
    kernel::gravity_regressor::nonzeros(&Trig::new(q), &mut out);
    out
}

/// Kinetic energy, one entry per standard parameter.
///
/// `T = h phi`, J per unit. Khalil and Dombre, 9.4. Packed form: [`kernel::kinetic_energy_regressor::packed`].
#[must_use]
#[inline]
pub fn kinetic_energy_regressor<S: Scalar>(q: &[S; DOF], dq: &[S; DOF]) -> [S; 24] {
    let mut out = [S::default(); 24];
    kernel::kinetic_energy_regressor::nonzeros(&Trig::new(q), dq, &mut out);
    out
}

/// Potential energy, one entry per standard parameter.
///
/// `U = h phi`, J per unit, zero at the base frame's origin; an offset torque counts as `FO q`. Packed form: [`kernel::potential_energy_regressor::packed`].
#[must_use]
#[inline]
pub fn potential_energy_regressor<S: Scalar>(q: &[S; DOF]) -> [S; 24] {
    let mut out = [S::default(); 24];
    kernel::potential_energy_regressor::nonzeros(&Trig::new(q), &mut out);
    out
}

/// Regressor of a body fixed to the tool frame.
///
/// `tau = W_L phi_L`, columns `M MSX MSY MSZ XX YY ZZ XY XZ YZ` in the tool frame, about its origin (the paper's (7)). Packed form: [`kernel::payload_regressor::packed`].
#[must_use]
#[inline]
pub fn payload_regressor<S: Scalar>(q: &[S; DOF], dq: &[S; DOF], ddq: &[S; DOF]) -> [[S; 10]; 2] {
    let mut out = [[S::default(); 10]; 2];
    kernel::payload_regressor::nonzeros(&Trig::new(q), dq, ddq, &mut out);
    out
}
