//! Closed-form kinematics and dynamics of `kuka-lwr4`: 7 degrees of freedom, 57 base parameters.
//!
//! Written by denavit 0.1.0 from the robot file with digest f8d57707902fc852; do not edit, run `denavit generate` again.
//!
//! SI units: m, rad, s, kg, N m. Torques are those of the actuators on the links. Nothing is allocated; nothing but `core` is used.
//! Kernels ([`kernel`]) take sines and cosines ([`Trig`]); the functions here take `q`.
//! All are generic over [`runtime::Scalar`]: `f64`, `f32` and packs of states run the same text.
//!
//! | function | result | multiplications | additions |
//! |---|---|---|---|
//! | [`frames`]: DH frames of all rows in the base frame | 7 x 3 x 4 | 68 | 48 |
//! | [`forward_kinematics`]: The last DH frame in the base frame | 3 x 4 | 68 | 33 |
//! | [`tool_pose`]: The tool frame in the base frame | 3 x 4 | 68 | 33 |
//! | [`jacobian`]: Jacobian of the last DH frame's origin, in base axes | 6 x 7 | 66 | 38 |
//! | [`jacobian_dot_velocity`]: Acceleration of the last DH frame that is left when `ddq` is zero: `dJ/dt dq` | 6 | 169 | 99 |
//! | [`inverse_dynamics`]: Torques from the standard parameters | 7 | 343 | 333 |
//! | [`inverse_dynamics_base`]: Torques from the base parameters | 7 | 297 | 276 |
//! | [`mass_matrix`]: Mass matrix `M`, symmetric, kg m^2 | 7 x 7 | 197 | 154 |
//! | [`coriolis`]: Coriolis and centrifugal torques `C dq` | 7 | 270 | 244 |
//! | [`gravity`]: Gravity torques `g` | 7 | 64 | 38 |
//! | [`forward_dynamics`]: Accelerations that torques cause | 7 | 654 | 520 |
//! | [`regressor`]: Regressor `W` of the standard parameters | 7 x 84 | 757 | 578 |
//! | [`base_regressor`]: Regressor `W_b` of the base parameters | 7 x 57 | 597 | 426 |
//! | [`gravity_regressor`]: Regressor at rest | 7 x 70 | 237 | 135 |
//! | [`kinetic_energy_regressor`]: Kinetic energy, one entry per standard parameter | 84 | 143 | 53 |
//! | [`potential_energy_regressor`]: Potential energy, one entry per standard parameter | 84 | 34 | 14 |
//! | [`payload_regressor`]: Regressor of a body fixed to the tool frame | 7 x 10 | 350 | 225 |

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
pub const NAME: &str = "kuka-lwr4";
/// Degrees of freedom.
pub const DOF: usize = 7;
/// Rows of the DH table, fixed ones too.
pub const ROWS: usize = 7;
/// Standard parameters: ten per row, then the drives'.
pub const STANDARD: usize = 84;
/// Base parameters.
pub const BASE: usize = 57;

/// Joints, in the order of `q`.
pub const JOINT_NAMES: [&str; DOF] = [
    "A1",
    "A2",
    "A3",
    "A4",
    "A5",
    "A6",
    "A7",
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
    "M7",
    "MSX7",
    "MSY7",
    "MSZ7",
    "XX7",
    "YY7",
    "ZZ7",
    "XY7",
    "XZ7",
    "YZ7",
    "FV1",
    "FV2",
    "FV3",
    "FV4",
    "FV5",
    "FV6",
    "FV7",
    "FC1",
    "FC2",
    "FC3",
    "FC4",
    "FC5",
    "FC6",
    "FC7",
];
/// Base parameters, in the order of the base regressor's columns.
pub const BASE_NAMES: [&str; BASE] = [
    "ZZ1R",
    "MSX2",
    "MSY2R",
    "XX2R",
    "ZZ2R",
    "XY2",
    "XZ2",
    "YZ2",
    "MSX3",
    "MSY3R",
    "XX3R",
    "ZZ3R",
    "XY3",
    "XZ3",
    "YZ3",
    "MSX4",
    "MSY4R",
    "XX4R",
    "ZZ4R",
    "XY4",
    "XZ4",
    "YZ4",
    "MSX5",
    "MSY5R",
    "XX5R",
    "ZZ5R",
    "XY5",
    "XZ5",
    "YZ5",
    "MSX6",
    "MSY6R",
    "XX6R",
    "ZZ6R",
    "XY6",
    "XZ6",
    "YZ6",
    "MSX7",
    "MSY7",
    "XX7R",
    "ZZ7",
    "XY7",
    "XZ7",
    "YZ7",
    "FV1",
    "FV2",
    "FV3",
    "FV4",
    "FV5",
    "FV6",
    "FV7",
    "FC1",
    "FC2",
    "FC3",
    "FC4",
    "FC5",
    "FC6",
    "FC7",
];
/// What each base parameter groups, in the constants of the robot file.
pub const BASE_GROUPINGS: [&str; BASE] = [
    "ZZ1R = ZZ1 + YY2",
    "MSX2 = MSX2",
    "MSY2R = MSY2 + L2*(M3 + M4 + M5 + M6 + M7) + MSZ3",
    "XX2R = XX2 - YY2 + L2^2*(M3 + M4 + M5 + M6 + M7) + 2*L2*MSZ3 + YY3",
    "ZZ2R = ZZ2 + L2^2*(M3 + M4 + M5 + M6 + M7) + 2*L2*MSZ3 + YY3",
    "XY2 = XY2",
    "XZ2 = XZ2",
    "YZ2 = YZ2",
    "MSX3 = MSX3",
    "MSY3R = MSY3 + MSZ4",
    "XX3R = XX3 - YY3 + YY4",
    "ZZ3R = ZZ3 + YY4",
    "XY3 = XY3",
    "XZ3 = XZ3",
    "YZ3 = YZ3",
    "MSX4 = MSX4",
    "MSY4R = MSY4 - L3*(M5 + M6 + M7) - MSZ5",
    "XX4R = XX4 - YY4 + L3^2*(M5 + M6 + M7) + 2*L3*MSZ5 + YY5",
    "ZZ4R = ZZ4 + L3^2*(M5 + M6 + M7) + 2*L3*MSZ5 + YY5",
    "XY4 = XY4",
    "XZ4 = XZ4",
    "YZ4 = YZ4",
    "MSX5 = MSX5",
    "MSY5R = MSY5 - MSZ6",
    "XX5R = XX5 - YY5 + YY6",
    "ZZ5R = ZZ5 + YY6",
    "XY5 = XY5",
    "XZ5 = XZ5",
    "YZ5 = YZ5",
    "MSX6 = MSX6",
    "MSY6R = MSY6 + MSZ7",
    "XX6R = XX6 - YY6 + YY7",
    "ZZ6R = ZZ6 + YY7",
    "XY6 = XY6",
    "XZ6 = XZ6",
    "YZ6 = YZ6",
    "MSX7 = MSX7",
    "MSY7 = MSY7",
    "XX7R = XX7 - YY7",
    "ZZ7 = ZZ7",
    "XY7 = XY7",
    "XZ7 = XZ7",
    "YZ7 = YZ7",
    "FV1 = FV1",
    "FV2 = FV2",
    "FV3 = FV3",
    "FV4 = FV4",
    "FV5 = FV5",
    "FV6 = FV6",
    "FV7 = FV7",
    "FC1 = FC1",
    "FC2 = FC2",
    "FC3 = FC3",
    "FC4 = FC4",
    "FC5 = FC5",
    "FC6 = FC6",
    "FC7 = FC7",
];
/// The same as numbers: index into the standard parameters, and factor.
pub const BASE_COEFFICIENTS: [&[(usize, f64)]; BASE] = [
    &[(6, 1.0), (15, 1.0)],
    &[(11, 1.0)],
    &[(12, 1.0), (20, 0.4), (23, 1.0), (30, 0.4), (40, 0.4), (50, 0.4), (60, 0.4)],
    &[(14, 1.0), (15, -1.0), (20, 0.16000000000000003), (23, 0.8), (25, 1.0), (30, 0.16000000000000003), (40, 0.16000000000000003), (50, 0.16000000000000003), (60, 0.16000000000000003)],
    &[(16, 1.0), (20, 0.16000000000000003), (23, 0.8), (25, 1.0), (30, 0.16000000000000003), (40, 0.16000000000000003), (50, 0.16000000000000003), (60, 0.16000000000000003)],
    &[(17, 1.0)],
    &[(18, 1.0)],
    &[(19, 1.0)],
    &[(21, 1.0)],
    &[(22, 1.0), (33, 1.0)],
    &[(24, 1.0), (25, -1.0), (35, 1.0)],
    &[(26, 1.0), (35, 1.0)],
    &[(27, 1.0)],
    &[(28, 1.0)],
    &[(29, 1.0)],
    &[(31, 1.0)],
    &[(32, 1.0), (40, -0.39), (43, -1.0), (50, -0.39), (60, -0.39)],
    &[(34, 1.0), (35, -1.0), (40, 0.1521), (43, 0.78), (45, 1.0), (50, 0.1521), (60, 0.1521)],
    &[(36, 1.0), (40, 0.1521), (43, 0.78), (45, 1.0), (50, 0.1521), (60, 0.1521)],
    &[(37, 1.0)],
    &[(38, 1.0)],
    &[(39, 1.0)],
    &[(41, 1.0)],
    &[(42, 1.0), (53, -1.0)],
    &[(44, 1.0), (45, -1.0), (55, 1.0)],
    &[(46, 1.0), (55, 1.0)],
    &[(47, 1.0)],
    &[(48, 1.0)],
    &[(49, 1.0)],
    &[(51, 1.0)],
    &[(52, 1.0), (63, 1.0)],
    &[(54, 1.0), (55, -1.0), (65, 1.0)],
    &[(56, 1.0), (65, 1.0)],
    &[(57, 1.0)],
    &[(58, 1.0)],
    &[(59, 1.0)],
    &[(61, 1.0)],
    &[(62, 1.0)],
    &[(64, 1.0), (65, -1.0)],
    &[(66, 1.0)],
    &[(67, 1.0)],
    &[(68, 1.0)],
    &[(69, 1.0)],
    &[(70, 1.0)],
    &[(71, 1.0)],
    &[(72, 1.0)],
    &[(73, 1.0)],
    &[(74, 1.0)],
    &[(75, 1.0)],
    &[(76, 1.0)],
    &[(77, 1.0)],
    &[(78, 1.0)],
    &[(79, 1.0)],
    &[(80, 1.0)],
    &[(81, 1.0)],
    &[(82, 1.0)],
    &[(83, 1.0)],
];

/// Lower and upper position of each joint, rad or m.
pub const POSITION_LIMITS: [Option<[f64; 2]>; DOF] = [Some([-2.9670597283903604, 2.9670597283903604]), Some([-2.0943951023931953, 2.0943951023931953]), Some([-2.9670597283903604, 2.9670597283903604]), Some([-2.0943951023931953, 2.0943951023931953]), Some([-2.9670597283903604, 2.9670597283903604]), Some([-2.0943951023931953, 2.0943951023931953]), Some([-2.9670597283903604, 2.9670597283903604])];
/// Largest speeds, rad/s or m/s.
pub const VELOCITY_LIMITS: [Option<f64>; DOF] = [Some(1.9198621771937623), Some(1.9198621771937623), Some(2.234021442552742), Some(2.234021442552742), Some(3.5604716740684323), Some(3.211405823669566), Some(3.211405823669566)];
/// Largest accelerations, rad/s^2 or m/s^2.
pub const ACCELERATION_LIMITS: [Option<f64>; DOF] = [None, None, None, None, None, None, None];
/// Largest torques or forces, N m or N.
pub const TORQUE_LIMITS: [Option<f64>; DOF] = [Some(176.0), Some(176.0), Some(100.0), Some(100.0), Some(100.0), Some(38.0), Some(38.0)];
/// The robot file's standard parameters, its tool in the last link.
pub const STANDARD_VALUES: Option<[f64; STANDARD]> = Some([2.7036985567, 0.0, 0.0, 0.0, 0.033180373793, 0.033179255008, 0.0060823587057, 0.0, 0.0, 0.0, 2.7084989177, 0.0013547404, 0.21567267715, 0.0038560143326, 0.033427937896, 0.0054516899943, 0.032778197901, 8.27561529e-8, 1.27083764e-10, -0.000543114698, 2.6966283472, 0.00094560079, 0.00062828039907, -0.3184607794, 0.051493638498, 0.050586516719, 0.0053371064286, -1.2154487e-7, 0.00037830507133, 0.0005374131766, 2.689589786, -0.00349748412, -0.21409561484, -0.0011006549001, 0.031042592641, 0.0054480071714, 0.030011540469, 7.09280381e-8, 7.73235478e-8, 0.000532412294, 1.6745990952, -0.000656231999, 0.010857559621, -0.25003539582, 0.048795121225, 0.04835474869, 0.0028179871547, 4.10092494e-8, -4.87260508e-8, 0.000422490382, 1.5546669658, 0.000835227362, 0.023268381773, -0.029830414379, 0.0035980186126, 0.0035124306353, 0.0026802148973, -1.62122248e-7, 4.43055103e-8, 1.00573718e-5, 0.28345773633, -0.000298447259, 0.000954515526, 0.0053687966266, 0.0010889025488, 0.0010878054827, 0.000120294035, 2.50512714e-8, -4.20844121e-9, 2.6711949e-9, 1.07, 0.96, 0.22, 0.69, 0.07, 0.25, 0.08, 0.28, 0.43, 0.05, 0.16, 0.34, 0.16, 0.2]);
/// Name, multiplications and additions of each function, sines and cosines apart (`DOF` pairs).
pub const OPERATIONS: [(&str, usize, usize); 17] = [
    ("frames", 68, 48),
    ("forward_kinematics", 68, 33),
    ("tool_pose", 68, 33),
    ("jacobian", 66, 38),
    ("jacobian_dot_velocity", 169, 99),
    ("inverse_dynamics", 343, 333),
    ("inverse_dynamics_base", 297, 276),
    ("mass_matrix", 197, 154),
    ("coriolis", 270, 244),
    ("gravity", 64, 38),
    ("forward_dynamics", 654, 520),
    ("regressor", 757, 578),
    ("base_regressor", 597, 426),
    ("gravity_regressor", 237, 135),
    ("kinetic_energy_regressor", 143, 53),
    ("potential_energy_regressor", 34, 14),
    ("payload_regressor", 350, 225),
];

/// Which inverse the arm has.
pub const IK_CLASS: &str = "srs";
/// What in its geometry makes it so.
pub const IK_REASON: &str = "axes 1-3 meet in a shoulder, 5-7 in a wrist, and axis 4 meets both upper and lower arm: by swivel angle";
/// Lines of the joints at `q = 0` in base axes, m, and how the arm is taken apart.
pub const IK: ik::Arm<DOF> = ik::Arm {
    axes: [
        ik::Axis { slides: false, h: [0.0, 0.0, 1.0], c: [0.0, 0.0, 0.3105] },
        ik::Axis { slides: false, h: [0.0, -1.0, 0.0], c: [0.0, 0.0, 0.3105] },
        ik::Axis { slides: false, h: [0.0, 0.0, 1.0], c: [0.0, 0.0, 0.7105] },
        ik::Axis { slides: false, h: [0.0, 1.0, 0.0], c: [0.0, 0.0, 0.7105] },
        ik::Axis { slides: false, h: [0.0, 0.0, 1.0], c: [0.0, 0.0, 1.1005] },
        ik::Axis { slides: false, h: [0.0, -1.0, 0.0], c: [0.0, 0.0, 1.1005] },
        ik::Axis { slides: false, h: [0.0, 0.0, 1.0], c: [0.0, 0.0, 1.1005] },
    ],
    home: ik::Displacement { rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], shift: [0.0, 0.0, 1.1005] },
    limits: POSITION_LIMITS,
    exact: true,
    family: ik::Family::Swivel(ik::Swivel {
        axes: [
        ik::Axis { slides: false, h: [0.0, 0.0, 1.0], c: [0.0, 0.0, 0.3105] },
        ik::Axis { slides: false, h: [0.0, -1.0, 0.0], c: [0.0, 0.0, 0.3105] },
        ik::Axis { slides: false, h: [0.0, 0.0, 1.0], c: [0.0, 0.0, 0.7105] },
        ik::Axis { slides: false, h: [0.0, 1.0, 0.0], c: [0.0, 0.0, 0.7105] },
        ik::Axis { slides: false, h: [0.0, 0.0, 1.0], c: [0.0, 0.0, 1.1005] },
        ik::Axis { slides: false, h: [0.0, -1.0, 0.0], c: [0.0, 0.0, 1.1005] },
        ik::Axis { slides: false, h: [0.0, 0.0, 1.0], c: [0.0, 0.0, 1.1005] },
        ],
        shoulder: [0.0, 0.0, 0.3105],
        elbow: [0.0, 0.0, 0.7105],
        wrist: [0.0, 0.0, 1.1005],
    }),
};

/// All postures that bring the last DH frame to a pose: the top three rows of `T(0, n)`, m.
///
/// Axes 1-3 meet in a shoulder, 5-7 in a wrist, and axis 4 meets both upper and lower arm: by swivel angle. `query.redundancy` is the swivel angle, rad.
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
pub fn frames<S: Scalar>(q: &[S; DOF]) -> [[[S; 4]; 3]; 7] {
    let mut out = [[[S::default(); 4]; 3]; 7];
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
pub fn jacobian<S: Scalar>(q: &[S; DOF]) -> [[S; 7]; 6] {
    let mut out = [[S::default(); 7]; 6];
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
pub fn inverse_dynamics<S: Scalar>(q: &[S; DOF], dq: &[S; DOF], ddq: &[S; DOF], phi: &[S; STANDARD]) -> [S; 7] {
    let mut out = [S::default(); 7];
    kernel::inverse_dynamics::dense(&Trig::new(q), dq, ddq, phi, &mut out);
    out
}

/// Torques from the base parameters.
///
/// `tau = W_b beta`, N m, without forming `W_b`. Newton-Euler with the regrouped parameters, Khalil and Dombre, 9.6.
#[must_use]
#[inline]
pub fn inverse_dynamics_base<S: Scalar>(q: &[S; DOF], dq: &[S; DOF], ddq: &[S; DOF], beta: &[S; BASE]) -> [S; 7] {
    let mut out = [S::default(); 7];
    kernel::inverse_dynamics_base::dense(&Trig::new(q), dq, ddq, beta, &mut out);
    out
}

/// Mass matrix `M`, symmetric, kg m^2.
///
/// From the base parameters, rotors on the diagonal, by composite bodies. Featherstone, 6.2.
#[must_use]
#[inline]
pub fn mass_matrix<S: Scalar>(q: &[S; DOF], beta: &[S; BASE]) -> [[S; 7]; 7] {
    let mut out = [[S::default(); 7]; 7];
    kernel::mass_matrix::dense(&Trig::new(q), beta, &mut out);
    out
}

/// Coriolis and centrifugal torques `C dq`.
///
/// N m, from the base parameters; no gravity, no friction.
#[must_use]
#[inline]
pub fn coriolis<S: Scalar>(q: &[S; DOF], dq: &[S; DOF], beta: &[S; BASE]) -> [S; 7] {
    let mut out = [S::default(); 7];
    kernel::coriolis::dense(&Trig::new(q), dq, beta, &mut out);
    out
}

/// Gravity torques `g`.
///
/// N m, from the base parameters: what holds the arm up at rest.
#[must_use]
#[inline]
pub fn gravity<S: Scalar>(q: &[S; DOF], beta: &[S; BASE]) -> [S; 7] {
    let mut out = [S::default(); 7];
    kernel::gravity::dense(&Trig::new(q), beta, &mut out);
    out
}

/// Accelerations that torques cause.
///
/// `ddq = M^-1 (tau - C dq - g - friction)`, rad/s^2, from the base parameters; `M = L D L'` written out.
#[must_use]
#[inline]
pub fn forward_dynamics<S: Scalar>(q: &[S; DOF], dq: &[S; DOF], tau: &[S; DOF], beta: &[S; BASE]) -> [S; 7] {
    let mut out = [S::default(); 7];
    kernel::forward_dynamics::dense(&Trig::new(q), dq, tau, beta, &mut out);
    out
}

/// Regressor `W` of the standard parameters.
///
/// `tau = W phi`, row j in N m per unit of each parameter; columns as in `STANDARD_NAMES`. Khalil and Dombre, 12.4. Packed form: [`kernel::regressor::packed`].
#[must_use]
#[inline]
pub fn regressor<S: Scalar>(q: &[S; DOF], dq: &[S; DOF], ddq: &[S; DOF]) -> [[S; 84]; 7] {
    let mut out = [[S::default(); 84]; 7];
    kernel::regressor::nonzeros(&Trig::new(q), dq, ddq, &mut out);
    out
}

/// Regressor `W_b` of the base parameters.
///
/// `tau = W_b beta`, row j in N m per unit of each parameter; columns as in `BASE_NAMES`. Khalil and Dombre, 12.4. Packed form: [`kernel::base_regressor::packed`].
#[must_use]
#[inline]
pub fn base_regressor<S: Scalar>(q: &[S; DOF], dq: &[S; DOF], ddq: &[S; DOF]) -> [[S; 57]; 7] {
    let mut out = [[S::default(); 57]; 7];
    kernel::base_regressor::nonzeros(&Trig::new(q), dq, ddq, &mut out);
    out
}

/// Regressor at rest.
///
/// `g = W_g phi` for the links' parameters only; columns as the first of `STANDARD_NAMES`. Packed form: [`kernel::gravity_regressor::packed`].
#[must_use]
#[inline]
pub fn gravity_regressor<S: Scalar>(q: &[S; DOF]) -> [[S; 70]; 7] {
    let mut out = [[S::default(); 70]; 7];
    kernel::gravity_regressor::nonzeros(&Trig::new(q), &mut out);
    out
}

/// Kinetic energy, one entry per standard parameter.
///
/// `T = h phi`, J per unit. Khalil and Dombre, 9.4. Packed form: [`kernel::kinetic_energy_regressor::packed`].
#[must_use]
#[inline]
pub fn kinetic_energy_regressor<S: Scalar>(q: &[S; DOF], dq: &[S; DOF]) -> [S; 84] {
    let mut out = [S::default(); 84];
    kernel::kinetic_energy_regressor::nonzeros(&Trig::new(q), dq, &mut out);
    out
}

/// Potential energy, one entry per standard parameter.
///
/// `U = h phi`, J per unit, zero at the base frame's origin; an offset torque counts as `FO q`. Packed form: [`kernel::potential_energy_regressor::packed`].
#[must_use]
#[inline]
pub fn potential_energy_regressor<S: Scalar>(q: &[S; DOF]) -> [S; 84] {
    let mut out = [S::default(); 84];
    kernel::potential_energy_regressor::nonzeros(&Trig::new(q), &mut out);
    out
}

/// Regressor of a body fixed to the tool frame.
///
/// `tau = W_L phi_L`, columns `M MSX MSY MSZ XX YY ZZ XY XZ YZ` in the tool frame, about its origin (the paper's (7)). Packed form: [`kernel::payload_regressor::packed`].
#[must_use]
#[inline]
pub fn payload_regressor<S: Scalar>(q: &[S; DOF], dq: &[S; DOF], ddq: &[S; DOF]) -> [[S; 10]; 7] {
    let mut out = [[S::default(); 10]; 7];
    kernel::payload_regressor::nonzeros(&Trig::new(q), dq, ddq, &mut out);
    out
}
