//! Closed-form kinematics and dynamics of `stanford`: 6 degrees of freedom, 37 base parameters.
//!
//! Written by denavit 0.1.0 from the robot file with digest b0b4c404891fade7; do not edit, run `denavit generate` again.
//!
//! SI units: m, rad, s, kg, N m. Torques are those of the actuators on the links. Nothing is allocated; nothing but `core` is used.
//! Kernels ([`kernel`]) take sines and cosines ([`Trig`]); the functions here take `q`.
//! All are generic over [`runtime::Scalar`]: `f64`, `f32` and packs of states run the same text.
//!
//! | function | result | multiplications | additions |
//! |---|---|---|---|
//! | [`frames`]: DH frames of all rows in the base frame | 6 x 3 x 4 | 46 | 33 |
//! | [`forward_kinematics`]: The last DH frame in the base frame | 3 x 4 | 46 | 23 |
//! | [`tool_pose`]: The tool frame in the base frame | 3 x 4 | 46 | 23 |
//! | [`jacobian`]: Jacobian of the last DH frame's origin, in base axes | 6 x 6 | 44 | 27 |
//! | [`jacobian_dot_velocity`]: Acceleration of the last DH frame that is left when `ddq` is zero: `dJ/dt dq` | 6 | 120 | 68 |
//! | [`inverse_dynamics`]: Torques from the standard parameters | 6 | 280 | 278 |
//! | [`inverse_dynamics_base`]: Torques from the base parameters | 6 | 226 | 213 |
//! | [`mass_matrix`]: Mass matrix `M`, symmetric, kg m^2 | 6 x 6 | 120 | 99 |
//! | [`coriolis`]: Coriolis and centrifugal torques `C dq` | 6 | 206 | 189 |
//! | [`gravity`]: Gravity torques `g` | 6 | 50 | 29 |
//! | [`forward_dynamics`]: Accelerations that torques cause | 6 | 447 | 362 |
//! | [`regressor`]: Regressor `W` of the standard parameters | 6 x 66 | 420 | 330 |
//! | [`base_regressor`]: Regressor `W_b` of the base parameters | 6 x 37 | 337 | 252 |
//! | [`gravity_regressor`]: Regressor at rest | 6 x 60 | 113 | 68 |
//! | [`kinetic_energy_regressor`]: Kinetic energy, one entry per standard parameter | 66 | 123 | 45 |
//! | [`potential_energy_regressor`]: Potential energy, one entry per standard parameter | 66 | 22 | 12 |
//! | [`payload_regressor`]: Regressor of a body fixed to the tool frame | 6 x 10 | 242 | 163 |

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
pub const NAME: &str = "stanford";
/// Degrees of freedom.
pub const DOF: usize = 6;
/// Rows of the DH table, fixed ones too.
pub const ROWS: usize = 6;
/// Standard parameters: ten per row, then the drives'.
pub const STANDARD: usize = 66;
/// Base parameters.
pub const BASE: usize = 37;

/// Joints, in the order of `q`.
pub const JOINT_NAMES: [&str; DOF] = [
    "J1",
    "J2",
    "J3",
    "J4",
    "J5",
    "J6",
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
    "M3",
    "MSX3",
    "MSY3",
    "MSZ3",
    "XX3",
    "YY3",
    "ZZ3",
    "XY3",
    "XZ3",
    "YZ3",
    "M4",
    "MSX4",
    "MSY4",
    "MSZ4",
    "XX4",
    "YY4",
    "ZZ4",
    "XY4",
    "XZ4",
    "YZ4",
    "M5",
    "MSX5",
    "MSY5",
    "MSZ5",
    "XX5",
    "YY5",
    "ZZ5",
    "XY5",
    "XZ5",
    "YZ5",
    "M6",
    "MSX6",
    "MSY6",
    "MSZ6",
    "XX6",
    "YY6",
    "ZZ6",
    "XY6",
    "XZ6",
    "YZ6",
    "IA1",
    "IA2",
    "IA3",
    "IA4",
    "IA5",
    "IA6",
];
/// Base parameters, in the order of the base regressor's columns.
pub const BASE_NAMES: [&str; BASE] = [
    "YY1R",
    "MSX2",
    "MSZ2",
    "YY2R",
    "ZZ2R",
    "XY2R",
    "XZ2R",
    "YZ2R",
    "M3R",
    "MSX3",
    "MSY3",
    "MSZ3R",
    "MSX4",
    "MSZ4R",
    "YY4R",
    "ZZ4R",
    "XY4",
    "XZ4",
    "YZ4",
    "MSX5",
    "MSZ5R",
    "YY5R",
    "ZZ5R",
    "XY5",
    "XZ5",
    "YZ5",
    "MSX6",
    "MSY6",
    "XX6R",
    "ZZ6",
    "XY6",
    "XZ6",
    "YZ6",
    "IA3",
    "IA4",
    "IA5",
    "IA6",
];
/// What each base parameter groups, in the constants of the robot file.
pub const BASE_GROUPINGS: [&str; BASE] = [
    "YY1R = YY1 + D2^2*M2 + 2*D2*MSY2 + XX2 + YY3 + XX4 + XX5 + YY6 + IA1 + D6^2*M6 + 2*D6*MSZ6",
    "MSX2 = MSX2",
    "MSZ2 = MSZ2",
    "YY2R = YY2 + XX3 + XX4 + XX5 + YY6 + IA2 + D6^2*M6 + 2*D6*MSZ6",
    "ZZ2R = ZZ2 - XX2 - YY3 - XX4 - XX5 - YY6 + ZZ3 - D6^2*M6 - 2*D6*MSZ6",
    "XY2R = XY2 - XY3",
    "XZ2R = XZ2 + YZ3",
    "YZ2R = YZ2 - XZ3",
    "M3R = M3 + M4 + M5 + M6",
    "MSX3 = MSX3",
    "MSY3 = MSY3",
    "MSZ3R = MSZ3 - MSY4",
    "MSX4 = MSX4",
    "MSZ4R = MSZ4 + MSY5",
    "YY4R = YY4 + XX5 + YY6 + D6^2*M6 + 2*D6*MSZ6",
    "ZZ4R = ZZ4 - XX4 - XX5 - YY6 - D6^2*M6 - 2*D6*MSZ6",
    "XY4 = XY4",
    "XZ4 = XZ4",
    "YZ4 = YZ4",
    "MSX5 = MSX5",
    "MSZ5R = MSZ5 + D6*M6 + MSZ6",
    "YY5R = YY5 + D6^2*M6 + 2*D6*MSZ6 + YY6",
    "ZZ5R = ZZ5 - XX5 - YY6 - D6^2*M6 - 2*D6*MSZ6",
    "XY5 = XY5",
    "XZ5 = XZ5",
    "YZ5 = YZ5",
    "MSX6 = MSX6",
    "MSY6 = MSY6",
    "XX6R = XX6 - YY6",
    "ZZ6 = ZZ6",
    "XY6 = XY6",
    "XZ6 = XZ6",
    "YZ6 = YZ6",
    "IA3 = IA3",
    "IA4 = IA4",
    "IA5 = IA5",
    "IA6 = IA6",
];
/// The same as numbers: index into the standard parameters, and factor.
pub const BASE_COEFFICIENTS: [&[(usize, f64)]; BASE] = [
    &[(5, 1.0), (10, 0.023716), (12, 0.308), (14, 1.0), (25, 1.0), (34, 1.0), (44, 1.0), (50, 0.06916900000000001), (53, 0.526), (55, 1.0), (60, 1.0)],
    &[(11, 1.0)],
    &[(13, 1.0)],
    &[(15, 1.0), (24, 1.0), (34, 1.0), (44, 1.0), (50, 0.06916900000000001), (53, 0.526), (55, 1.0), (61, 1.0)],
    &[(14, -1.0), (16, 1.0), (25, -1.0), (26, 1.0), (34, -1.0), (44, -1.0), (50, -0.06916900000000001), (53, -0.526), (55, -1.0)],
    &[(17, 1.0), (27, -1.0)],
    &[(18, 1.0), (29, 1.0)],
    &[(19, 1.0), (28, -1.0)],
    &[(20, 1.0), (30, 1.0), (40, 1.0), (50, 1.0)],
    &[(21, 1.0)],
    &[(22, 1.0)],
    &[(23, 1.0), (32, -1.0)],
    &[(31, 1.0)],
    &[(33, 1.0), (42, 1.0)],
    &[(35, 1.0), (44, 1.0), (50, 0.06916900000000001), (53, 0.526), (55, 1.0)],
    &[(34, -1.0), (36, 1.0), (44, -1.0), (50, -0.06916900000000001), (53, -0.526), (55, -1.0)],
    &[(37, 1.0)],
    &[(38, 1.0)],
    &[(39, 1.0)],
    &[(41, 1.0)],
    &[(43, 1.0), (50, 0.263), (53, 1.0)],
    &[(45, 1.0), (50, 0.06916900000000001), (53, 0.526), (55, 1.0)],
    &[(44, -1.0), (46, 1.0), (50, -0.06916900000000001), (53, -0.526), (55, -1.0)],
    &[(47, 1.0)],
    &[(48, 1.0)],
    &[(49, 1.0)],
    &[(51, 1.0)],
    &[(52, 1.0)],
    &[(54, 1.0), (55, -1.0)],
    &[(56, 1.0)],
    &[(57, 1.0)],
    &[(58, 1.0)],
    &[(59, 1.0)],
    &[(62, 1.0)],
    &[(63, 1.0)],
    &[(64, 1.0)],
    &[(65, 1.0)],
];

/// Lower and upper position of each joint, rad or m.
pub const POSITION_LIMITS: [Option<[f64; 2]>; DOF] = [None, None, None, None, None, None];
/// Largest speeds, rad/s or m/s.
pub const VELOCITY_LIMITS: [Option<f64>; DOF] = [None, None, None, None, None, None];
/// Largest accelerations, rad/s^2 or m/s^2.
pub const ACCELERATION_LIMITS: [Option<f64>; DOF] = [None, None, None, None, None, None];
/// Largest torques or forces, N m or N.
pub const TORQUE_LIMITS: [Option<f64>; DOF] = [None, None, None, None, None, None];
/// The robot file's standard parameters, its tool in the last link.
pub const STANDARD_VALUES: Option<[f64; STANDARD]> = Some([9.29, 0.0, 0.162575, -1.026545, 0.276, 0.255, 0.071, 0.0, 0.0, 0.0, 5.01, 0.0, -0.528054, 0.0, 0.108, 0.018, 0.1, 0.0, 0.0, 0.0, 4.25, 0.0, 0.0, -2.739975, 2.51, 2.51, 0.006, 0.0, 0.0, 0.0, 1.08, 0.0, 0.009936, -0.005832, 0.002, 0.001, 0.001, 0.0, 0.0, 0.0, 0.63, 0.0, 0.0, 0.035658, 0.003, 0.003, 0.0004, 0.0, 0.0, 0.0, 0.51, 0.0, 0.0, 0.079254, 0.013, 0.013, 0.0003, 0.0, 0.0, 0.0, 0.953, 2.193, 0.782, 0.106, 0.097, 0.02]);
/// Name, multiplications and additions of each function, sines and cosines apart (`DOF` pairs).
pub const OPERATIONS: [(&str, usize, usize); 17] = [
    ("frames", 46, 33),
    ("forward_kinematics", 46, 23),
    ("tool_pose", 46, 23),
    ("jacobian", 44, 27),
    ("jacobian_dot_velocity", 120, 68),
    ("inverse_dynamics", 280, 278),
    ("inverse_dynamics_base", 226, 213),
    ("mass_matrix", 120, 99),
    ("coriolis", 206, 189),
    ("gravity", 50, 29),
    ("forward_dynamics", 447, 362),
    ("regressor", 420, 330),
    ("base_regressor", 337, 252),
    ("gravity_regressor", 113, 68),
    ("kinetic_energy_regressor", 123, 45),
    ("potential_energy_regressor", 22, 12),
    ("payload_regressor", 242, 163),
];

/// Which inverse the arm has.
pub const IK_CLASS: &str = "stanford";
/// What in its geometry makes it so.
pub const IK_REASON: &str = "axes 4-6 meet in one point, joint 3 of the others slides, the first two meet";
/// Lines of the joints at `q = 0` in base axes, m, and how the arm is taken apart.
pub const IK: ik::Arm<DOF> = ik::Arm {
    axes: [
        ik::Axis { slides: false, h: [0.0, 0.0, 1.0], c: [0.0, 0.0, 0.412] },
        ik::Axis { slides: false, h: [0.0, 1.0, 0.0], c: [0.0, 0.154, 0.412] },
        ik::Axis { slides: true, h: [0.0, 0.0, 1.0], c: [0.0, 0.154, 0.412] },
        ik::Axis { slides: false, h: [0.0, 0.0, 1.0], c: [0.0, 0.154, 0.412] },
        ik::Axis { slides: false, h: [1.0, 0.0, 0.0], c: [0.0, 0.154, 0.412] },
        ik::Axis { slides: false, h: [0.0, 0.0, 1.0], c: [0.0, 0.154, 0.675] },
    ],
    home: ik::Displacement { rotation: [[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]], shift: [0.0, 0.154, 0.675] },
    limits: POSITION_LIMITS,
    exact: true,
    family: ik::Family::Six(ik::Six {
        axes: [
        ik::Axis { slides: false, h: [0.0, 0.0, 1.0], c: [0.0, 0.0, 0.412] },
        ik::Axis { slides: false, h: [0.0, 1.0, 0.0], c: [0.0, 0.154, 0.412] },
        ik::Axis { slides: true, h: [0.0, 0.0, 1.0], c: [0.0, 0.154, 0.412] },
        ik::Axis { slides: false, h: [0.0, 0.0, 1.0], c: [0.0, 0.154, 0.412] },
        ik::Axis { slides: false, h: [1.0, 0.0, 0.0], c: [0.0, 0.154, 0.412] },
        ik::Axis { slides: false, h: [0.0, 0.0, 1.0], c: [0.0, 0.154, 0.675] },
        ],
        joints: [Some(0), Some(1), Some(2), Some(3), Some(4), Some(5)],
        reversed: false,
        method: ik::Method::Wrist { center: [0.0, 0.154, 0.412], regional: ik::Regional::Meet { mirrored: false, at: [0.0, 0.0, 0.412] } },
    }),
};

/// All postures that bring the last DH frame to a pose: the top three rows of `T(0, n)`, m.
///
/// Axes 4-6 meet in one point, joint 3 of the others slides, the first two meet.
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
pub fn frames<S: Scalar>(q: &[S; DOF]) -> [[[S; 4]; 3]; 6] {
    let mut out = [[[S::default(); 4]; 3]; 6];
    kernel::frames::nonzeros(&Trig::new(q), &mut out);
    out
}

/// The last DH frame in the base frame.
///
/// `out` is the top three rows of `T(0, n)`: axes of the frame as columns, then its origin, m. Khalil and Dombre, 3.2.
#[must_use]
#[inline]
pub fn forward_kinematics<S: Scalar>(q: &[S; DOF]) -> [[S; 4]; 3] {
    let mut out = [[S::default(); 4]; 3];
    kernel::forward_kinematics::dense(&Trig::new(q), &mut out);
    out
}

/// The tool frame in the base frame.
///
/// Like `forward_kinematics`, followed by the tool's pose (the identity where the robot file has no tool).
#[must_use]
#[inline]
pub fn tool_pose<S: Scalar>(q: &[S; DOF]) -> [[S; 4]; 3] {
    let mut out = [[S::default(); 4]; 3];
    kernel::tool_pose::dense(&Trig::new(q), &mut out);
    out
}

/// Jacobian of the last DH frame's origin, in base axes.
///
/// `(v, w) = J dq`: rows 0-2 linear, m/s, rows 3-5 angular, rad/s. Khalil and Dombre, 5.2. Packed form: [`kernel::jacobian::packed`].
#[must_use]
#[inline]
pub fn jacobian<S: Scalar>(q: &[S; DOF]) -> [[S; 6]; 6] {
    let mut out = [[S::default(); 6]; 6];
    kernel::jacobian::nonzeros(&Trig::new(q), &mut out);
    out
}

/// Acceleration of the last DH frame that is left when `ddq` is zero: `dJ/dt dq`.
///
/// In base axes; entries 0-2 linear, m/s^2, 3-5 angular, rad/s^2. Khalil and Dombre, 5.10.
#[must_use]
#[inline]
pub fn jacobian_dot_velocity<S: Scalar>(q: &[S; DOF], dq: &[S; DOF]) -> [S; 6] {
    let mut out = [S::default(); 6];
    kernel::jacobian_dot_velocity::dense(&Trig::new(q), dq, &mut out);
    out
}

/// Torques from the standard parameters.
///
/// `tau = M ddq + C dq + g + friction`, N m, of the actuators on the links. Newton-Euler, Khalil and Dombre, 9.5.2.
#[must_use]
#[inline]
pub fn inverse_dynamics<S: Scalar>(q: &[S; DOF], dq: &[S; DOF], ddq: &[S; DOF], phi: &[S; STANDARD]) -> [S; 6] {
    let mut out = [S::default(); 6];
    kernel::inverse_dynamics::dense(&Trig::new(q), dq, ddq, phi, &mut out);
    out
}

/// Torques from the base parameters.
///
/// `tau = W_b beta`, N m, without forming `W_b`. Newton-Euler with the regrouped parameters, Khalil and Dombre, 9.6.
#[must_use]
#[inline]
pub fn inverse_dynamics_base<S: Scalar>(q: &[S; DOF], dq: &[S; DOF], ddq: &[S; DOF], beta: &[S; BASE]) -> [S; 6] {
    let mut out = [S::default(); 6];
    kernel::inverse_dynamics_base::dense(&Trig::new(q), dq, ddq, beta, &mut out);
    out
}

/// Mass matrix `M`, symmetric, kg m^2.
///
/// From the base parameters, rotors on the diagonal, by composite bodies. Featherstone, 6.2. Packed form: [`kernel::mass_matrix::packed`].
#[must_use]
#[inline]
pub fn mass_matrix<S: Scalar>(q: &[S; DOF], beta: &[S; BASE]) -> [[S; 6]; 6] {
    let mut out = [[S::default(); 6]; 6];
    kernel::mass_matrix::nonzeros(&Trig::new(q), beta, &mut out);
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
/// N m, from the base parameters: what holds the arm up at rest.
#[must_use]
#[inline]
pub fn gravity<S: Scalar>(q: &[S; DOF], beta: &[S; BASE]) -> [S; 6] {
    let mut out = [S::default(); 6];
    kernel::gravity::dense(&Trig::new(q), beta, &mut out);
    out
}

/// Accelerations that torques cause.
///
/// `ddq = M^-1 (tau - C dq - g - friction)`, rad/s^2, from the base parameters; `M = L D L'` written out.
#[must_use]
#[inline]
pub fn forward_dynamics<S: Scalar>(q: &[S; DOF], dq: &[S; DOF], tau: &[S; DOF], beta: &[S; BASE]) -> [S; 6] {
    let mut out = [S::default(); 6];
    kernel::forward_dynamics::dense(&Trig::new(q), dq, tau, beta, &mut out);
    out
}

/// Regressor `W` of the standard parameters.
///
/// `tau = W phi`, row j in N m per unit of each parameter; columns as in `STANDARD_NAMES`. Khalil and Dombre, 12.4. Packed form: [`kernel::regressor::packed`].
#[must_use]
#[inline]
pub fn regressor<S: Scalar>(q: &[S; DOF], dq: &[S; DOF], ddq: &[S; DOF]) -> [[S; 66]; 6] {
    let mut out = [[S::default(); 66]; 6];
    kernel::regressor::nonzeros(&Trig::new(q), dq, ddq, &mut out);
    out
}

/// Regressor `W_b` of the base parameters.
///
/// `tau = W_b beta`, row j in N m per unit of each parameter; columns as in `BASE_NAMES`. Khalil and Dombre, 12.4. Packed form: [`kernel::base_regressor::packed`].
#[must_use]
#[inline]
pub fn base_regressor<S: Scalar>(q: &[S; DOF], dq: &[S; DOF], ddq: &[S; DOF]) -> [[S; 37]; 6] {
    let mut out = [[S::default(); 37]; 6];
    kernel::base_regressor::nonzeros(&Trig::new(q), dq, ddq, &mut out);
    out
}

/// Regressor at rest.
///
/// `g = W_g phi` for the links' parameters only; columns as the first of `STANDARD_NAMES`. Packed form: [`kernel::gravity_regressor::packed`].
#[must_use]
#[inline]
pub fn gravity_regressor<S: Scalar>(q: &[S; DOF]) -> [[S; 60]; 6] {
    let mut out = [[S::default(); 60]; 6];
    kernel::gravity_regressor::nonzeros(&Trig::new(q), &mut out);
    out
}

/// Kinetic energy, one entry per standard parameter.
///
/// `T = h phi`, J per unit. Khalil and Dombre, 9.4. Packed form: [`kernel::kinetic_energy_regressor::packed`].
#[must_use]
#[inline]
pub fn kinetic_energy_regressor<S: Scalar>(q: &[S; DOF], dq: &[S; DOF]) -> [S; 66] {
    let mut out = [S::default(); 66];
    kernel::kinetic_energy_regressor::nonzeros(&Trig::new(q), dq, &mut out);
    out
}

/// Potential energy, one entry per standard parameter.
///
/// `U = h phi`, J per unit, zero at the base frame's origin; an offset torque counts as `FO q`. Packed form: [`kernel::potential_energy_regressor::packed`].
#[must_use]
#[inline]
pub fn potential_energy_regressor<S: Scalar>(q: &[S; DOF]) -> [S; 66] {
    let mut out = [S::default(); 66];
    kernel::potential_energy_regressor::nonzeros(&Trig::new(q), &mut out);
    out
}

/// Regressor of a body fixed to the tool frame.
///
/// `tau = W_L phi_L`, columns `M MSX MSY MSZ XX YY ZZ XY XZ YZ` in the tool frame, about its origin (the paper's (7)). Packed form: [`kernel::payload_regressor::packed`].
#[must_use]
#[inline]
pub fn payload_regressor<S: Scalar>(q: &[S; DOF], dq: &[S; DOF], ddq: &[S; DOF]) -> [[S; 10]; 6] {
    let mut out = [[S::default(); 10]; 6];
    kernel::payload_regressor::nonzeros(&Trig::new(q), dq, ddq, &mut out);
    out
}
