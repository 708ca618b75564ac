//! Closed-form kinematics and dynamics of `franka-panda`: 7 degrees of freedom, 64 base parameters.
//!
//! Written by denavit 0.1.0 from the robot file with digest 4fa64d9edb7faf5e; do not edit, run `denavit generate` again.
//!
//! SI units: m, rad, s, kg, N m. Torques are those of the actuators on the links. Nothing is allocated; nothing but `core` is used.
//! Kernels ([`kernel`]) take sines and cosines ([`Trig`]); the functions here take `q`.
//! All are generic over [`runtime::Scalar`]: `f64`, `f32` and packs of states run the same text.
//!
//! | function | result | multiplications | additions |
//! |---|---|---|---|
//! | [`frames`]: DH frames of all rows in the base frame | 7 x 3 x 4 | 77 | 56 |
//! | [`forward_kinematics`]: The last DH frame in the base frame | 3 x 4 | 77 | 41 |
//! | [`tool_pose`]: The tool frame in the base frame | 3 x 4 | 77 | 41 |
//! | [`jacobian`]: Jacobian of the last DH frame's origin, in base axes | 6 x 7 | 93 | 57 |
//! | [`jacobian_dot_velocity`]: Acceleration of the last DH frame that is left when `ddq` is zero: `dJ/dt dq` | 6 | 184 | 122 |
//! | [`inverse_dynamics`]: Torques from the standard parameters | 7 | 360 | 356 |
//! | [`inverse_dynamics_base`]: Torques from the base parameters | 7 | 314 | 299 |
//! | [`mass_matrix`]: Mass matrix `M`, symmetric, kg m^2 | 7 x 7 | 223 | 190 |
//! | [`coriolis`]: Coriolis and centrifugal torques `C dq` | 7 | 287 | 260 |
//! | [`gravity`]: Gravity torques `g` | 7 | 64 | 38 |
//! | [`forward_dynamics`]: Accelerations that torques cause | 7 | 697 | 580 |
//! | [`regressor`]: Regressor `W` of the standard parameters | 7 x 91 | 813 | 634 |
//! | [`base_regressor`]: Regressor `W_b` of the base parameters | 7 x 64 | 625 | 466 |
//! | [`gravity_regressor`]: Regressor at rest | 7 x 70 | 259 | 155 |
//! | [`kinetic_energy_regressor`]: Kinetic energy, one entry per standard parameter | 91 | 154 | 59 |
//! | [`potential_energy_regressor`]: Potential energy, one entry per standard parameter | 91 | 39 | 19 |
//! | [`payload_regressor`]: Regressor of a body fixed to the tool frame | 7 x 10 | 389 | 277 |

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
pub const NAME: &str = "franka-panda";
/// Degrees of freedom.
pub const DOF: usize = 7;
/// Rows of the DH table, fixed ones too.
pub const ROWS: usize = 7;
/// Standard parameters: ten per row, then the drives'.
pub const STANDARD: usize = 91;
/// Base parameters.
pub const BASE: usize = 64;

/// Joints, in the order of `q`.
pub const JOINT_NAMES: [&str; DOF] = [
    "J1",
    "J2",
    "J3",
    "J4",
    "J5",
    "J6",
    "J7",
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
    "FO1",
    "FO2",
    "FO3",
    "FO4",
    "FO5",
    "FO6",
    "FO7",
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
    "MSX3R",
    "MSY3R",
    "XX3R",
    "ZZ3R",
    "XY3R",
    "XZ3",
    "YZ3",
    "MSX4R",
    "MSY4R",
    "XX4R",
    "ZZ4R",
    "XY4R",
    "XZ4",
    "YZ4",
    "MSX5",
    "MSY5R",
    "XX5R",
    "ZZ5R",
    "XY5",
    "XZ5",
    "YZ5",
    "MSX6R",
    "MSY6R",
    "XX6R",
    "ZZ6R",
    "XY6R",
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
    "FO1",
    "FO2",
    "FO3",
    "FO4",
    "FO5",
    "FO6",
    "FO7",
];
/// What each base parameter groups, in the constants of the robot file.
pub const BASE_GROUPINGS: [&str; BASE] = [
    "ZZ1R = ZZ1 + YY2",
    "MSX2 = MSX2",
    "MSY2R = MSY2 - L2*(M3 + M4 + M5 + M6 + M7) - MSZ3",
    "XX2R = XX2 - YY2 + L2^2*M3 + 2*L2*MSZ3 + YY3 + (L2^2 + A^2)*(M4 + M5 + M6 + M7)",
    "ZZ2R = ZZ2 + L2^2*M3 + 2*L2*MSZ3 + YY3 + (L2^2 + A^2)*(M4 + M5 + M6 + M7)",
    "XY2 = XY2",
    "XZ2 = XZ2",
    "YZ2 = YZ2",
    "MSX3R = MSX3 + A*(M4 + M5 + M6 + M7)",
    "MSY3R = MSY3 - MSZ4",
    "XX3R = XX3 - YY3 - A^2*M4 + YY4",
    "ZZ3R = ZZ3 + A^2*M4 + YY4 + 2*A^2*(M5 + M6 + M7)",
    "XY3R = XY3 + A*MSZ4",
    "XZ3 = XZ3",
    "YZ3 = YZ3",
    "MSX4R = MSX4 - A*(M5 + M6 + M7)",
    "MSY4R = MSY4 + L3*(M5 + M6 + M7) + MSZ5",
    "XX4R = XX4 - YY4 + (L3^2 - A^2)*(M5 + M6 + M7) + 2*L3*MSZ5 + YY5",
    "ZZ4R = ZZ4 + (L3^2 + A^2)*(M5 + M6 + M7) + 2*L3*MSZ5 + YY5",
    "XY4R = XY4 + L3*A*(M5 + M6 + M7) + A*MSZ5",
    "XZ4 = XZ4",
    "YZ4 = YZ4",
    "MSX5 = MSX5",
    "MSY5R = MSY5 - MSZ6",
    "XX5R = XX5 - YY5 + YY6 + 0.007744*M7",
    "ZZ5R = ZZ5 + YY6 + 0.007744*M7",
    "XY5 = XY5",
    "XZ5 = XZ5",
    "YZ5 = YZ5",
    "MSX6R = MSX6 + 0.088*M7",
    "MSY6R = MSY6 - MSZ7",
    "XX6R = XX6 - YY6 - 0.007744*M7 + YY7",
    "ZZ6R = ZZ6 + 0.007744*M7 + YY7",
    "XY6R = XY6 + 0.088*MSZ7",
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
    "FO1 = FO1",
    "FO2 = FO2",
    "FO3 = FO3",
    "FO4 = FO4",
    "FO5 = FO5",
    "FO6 = FO6",
    "FO7 = FO7",
];
/// The same as numbers: index into the standard parameters, and factor.
pub const BASE_COEFFICIENTS: [&[(usize, f64)]; BASE] = [
    &[(6, 1.0), (15, 1.0)],
    &[(11, 1.0)],
    &[(12, 1.0), (20, -0.316), (23, -1.0), (30, -0.316), (40, -0.316), (50, -0.316), (60, -0.316)],
    &[(14, 1.0), (15, -1.0), (20, 0.099856), (23, 0.632), (25, 1.0), (30, 0.10666225), (40, 0.10666225), (50, 0.10666225), (60, 0.10666225)],
    &[(16, 1.0), (20, 0.099856), (23, 0.632), (25, 1.0), (30, 0.10666225), (40, 0.10666225), (50, 0.10666225), (60, 0.10666225)],
    &[(17, 1.0)],
    &[(18, 1.0)],
    &[(19, 1.0)],
    &[(21, 1.0), (30, 0.0825), (40, 0.0825), (50, 0.0825), (60, 0.0825)],
    &[(22, 1.0), (33, -1.0)],
    &[(24, 1.0), (25, -1.0), (30, -0.006806250000000001), (35, 1.0)],
    &[(26, 1.0), (30, 0.006806250000000001), (35, 1.0), (40, 0.013612500000000001), (50, 0.013612500000000001), (60, 0.013612500000000001)],
    &[(27, 1.0), (33, 0.0825)],
    &[(28, 1.0)],
    &[(29, 1.0)],
    &[(31, 1.0), (40, -0.0825), (50, -0.0825), (60, -0.0825)],
    &[(32, 1.0), (40, 0.384), (43, 1.0), (50, 0.384), (60, 0.384)],
    &[(34, 1.0), (35, -1.0), (40, 0.14064975), (43, 0.768), (45, 1.0), (50, 0.14064975), (60, 0.14064975)],
    &[(36, 1.0), (40, 0.15426225000000002), (43, 0.768), (45, 1.0), (50, 0.15426225000000002), (60, 0.15426225000000002)],
    &[(37, 1.0), (40, 0.03168), (43, 0.0825), (50, 0.03168), (60, 0.03168)],
    &[(38, 1.0)],
    &[(39, 1.0)],
    &[(41, 1.0)],
    &[(42, 1.0), (53, -1.0)],
    &[(44, 1.0), (45, -1.0), (55, 1.0), (60, 0.007743999999999999)],
    &[(46, 1.0), (55, 1.0), (60, 0.007743999999999999)],
    &[(47, 1.0)],
    &[(48, 1.0)],
    &[(49, 1.0)],
    &[(51, 1.0), (60, 0.088)],
    &[(52, 1.0), (63, -1.0)],
    &[(54, 1.0), (55, -1.0), (60, -0.007743999999999999), (65, 1.0)],
    &[(56, 1.0), (60, 0.007743999999999999), (65, 1.0)],
    &[(57, 1.0), (63, 0.088)],
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
    &[(84, 1.0)],
    &[(85, 1.0)],
    &[(86, 1.0)],
    &[(87, 1.0)],
    &[(88, 1.0)],
    &[(89, 1.0)],
    &[(90, 1.0)],
];

/// Lower and upper position of each joint, rad or m.
pub const POSITION_LIMITS: [Option<[f64; 2]>; DOF] = [Some([-2.8973, 2.8973]), Some([-1.7628, 1.7628]), Some([-2.8973, 2.8973]), Some([-3.0718, -0.0698]), Some([-2.8973, 2.8973]), Some([-0.0175, 3.7525]), Some([-2.8973, 2.8973])];
/// Largest speeds, rad/s or m/s.
pub const VELOCITY_LIMITS: [Option<f64>; DOF] = [Some(2.175), Some(2.175), Some(2.175), Some(2.175), Some(2.61), Some(2.61), Some(2.61)];
/// Largest accelerations, rad/s^2 or m/s^2.
pub const ACCELERATION_LIMITS: [Option<f64>; DOF] = [Some(15.0), Some(7.5), Some(10.0), Some(12.5), Some(15.0), Some(20.0), Some(20.0)];
/// Largest torques or forces, N m or N.
pub const TORQUE_LIMITS: [Option<f64>; DOF] = [Some(87.0), Some(87.0), Some(87.0), Some(87.0), Some(12.0), Some(12.0), Some(12.0)];
/// The robot file's standard parameters, its tool in the last link.
pub const STANDARD_VALUES: Option<[f64; STANDARD]> = Some([4.970684, 0.0192614005, 0.0103439934, 0.0, 0.7033915259, 0.7066846379, 0.009213163777, -0.0001790829744, 0.006772, 0.019169, 0.646926, -0.002031994566, -0.01857971472, 0.00226100637, 0.008503511624, 0.02812428471, 0.0265349919, -0.003983358884, 0.01026110182, 0.0007689361029, 3.228604, 0.08884472487, 0.1267291642, -0.2147086232, 0.05649492601, 0.052878382, 0.01824920229, -0.008248333141, -0.005487648107, -0.004377257122, 3.587895, -0.1907683772, 0.374644408, 0.09850206933, 0.06767727025, 0.03239943042, 0.07758614905, 0.02771584317, 0.003905355026, -0.001644487577, 1.225946, -0.01465373254, 0.05034347249, -0.0471216864, 0.03942757096, 0.03146037233, 0.01086951076, -0.001515244473, -0.004600245518, 0.002164052052, 1.666555, 0.1002416167, -0.02352675694, -0.01752715894, 0.002480460358, 0.01056776613, 0.01179456023, 0.001524110903, -0.0001037589172, 9.356909731e-5, 0.735522, 0.007735484874, -0.003127439544, 0.04530594863, 0.01532000839, 0.01289906461, 0.004909651967, -0.0003951087183, -0.001672482662, -0.0005483591064, 0.0628, 0.2088, 0.0361, 0.2174, 0.1021, 0.0001613, 0.0632, 0.2549, 0.1413, 0.1879, 0.3625, 0.2728, 0.1529, 0.2097, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
/// Name, multiplications and additions of each function, sines and cosines apart (`DOF` pairs).
pub const OPERATIONS: [(&str, usize, usize); 17] = [
    ("frames", 77, 56),
    ("forward_kinematics", 77, 41),
    ("tool_pose", 77, 41),
    ("jacobian", 93, 57),
    ("jacobian_dot_velocity", 184, 122),
    ("inverse_dynamics", 360, 356),
    ("inverse_dynamics_base", 314, 299),
    ("mass_matrix", 223, 190),
    ("coriolis", 287, 260),
    ("gravity", 64, 38),
    ("forward_dynamics", 697, 580),
    ("regressor", 813, 634),
    ("base_regressor", 625, 466),
    ("gravity_regressor", 259, 155),
    ("kinetic_energy_regressor", 154, 59),
    ("potential_energy_regressor", 39, 19),
    ("payload_regressor", 389, 277),
];

/// Which inverse the arm has.
pub const IK_CLASS: &str = "7r-offset";
/// What in its geometry makes it so.
pub const IK_REASON: &str = "axes 1-3 meet in one point, and so do the first two of the others; joint 7 is given";
/// Lines of the joints at `q = 0` in base axes, m, and how the arm is taken apart.
pub const IK: ik::Arm<DOF> = ik::Arm {
    axes: [
        ik::Axis { slides: false, h: [0.0, 0.0, 1.0], c: [0.0, 0.0, 0.333] },
        ik::Axis { slides: false, h: [0.0, 1.0, 0.0], c: [0.0, 0.0, 0.333] },
        ik::Axis { slides: false, h: [0.0, 0.0, 1.0], c: [0.0, 0.0, 0.649] },
        ik::Axis { slides: false, h: [0.0, -1.0, 0.0], c: [0.0825, 0.0, 0.649] },
        ik::Axis { slides: false, h: [0.0, 0.0, 1.0], c: [0.0, 0.0, 1.033] },
        ik::Axis { slides: false, h: [0.0, -1.0, 0.0], c: [0.0, 0.0, 1.033] },
        ik::Axis { slides: false, h: [0.0, 0.0, -1.0], c: [0.088, 0.0, 1.033] },
    ],
    home: ik::Displacement { rotation: [[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, -1.0]], shift: [0.088, 0.0, 1.033] },
    limits: POSITION_LIMITS,
    exact: true,
    family: ik::Family::Locked { joint: 6, six: ik::Six {
        axes: [
        ik::Axis { slides: false, h: [-0.0, 1.0, -0.0], c: [0.0, 0.0, 1.033] },
        ik::Axis { slides: false, h: [-0.0, -0.0, -1.0], c: [0.0, 0.0, 1.033] },
        ik::Axis { slides: false, h: [-0.0, 1.0, -0.0], c: [0.0825, 0.0, 0.649] },
        ik::Axis { slides: false, h: [-0.0, -0.0, -1.0], c: [0.0, 0.0, 0.649] },
        ik::Axis { slides: false, h: [-0.0, -1.0, -0.0], c: [0.0, 0.0, 0.333] },
        ik::Axis { slides: false, h: [-0.0, -0.0, -1.0], c: [0.0, 0.0, 0.333] },
        ],
        joints: [Some(5), Some(4), Some(3), Some(2), Some(1), Some(0)],
        reversed: true,
        method: ik::Method::Wrist { center: [0.0, 0.0, 0.333], regional: ik::Regional::Meet { mirrored: false, at: [0.0, 0.0, 1.033] } },
    } },
};

/// All postures that bring the last DH frame to a pose: the top three rows of `T(0, n)`, m.
///
/// Axes 1-3 meet in one point, and so do the first two of the others; joint 7 is given. `query.redundancy` is the position of joint 7.
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
pub fn regressor<S: Scalar>(q: &[S; DOF], dq: &[S; DOF], ddq: &[S; DOF]) -> [[S; 91]; 7] {
    let mut out = [[S::default(); 91]; 7];
    kernel::regressor::nonzeros(&Trig::new(q), dq, ddq, &mut out);
    out
}

/// Regressor `W_b` of the base parameters.
///
/// `tau = W_b beta`, row j in N m per unit of each parameter; columns as in `BASE_NAMES`. Khalil and Dombre, 12.4. Packed form: [`kernel::base_regressor::packed`].
#[must_use]
#[inline]
pub fn base_regressor<S: Scalar>(q: &[S; DOF], dq: &[S; DOF], ddq: &[S; DOF]) -> [[S; 64]; 7] {
    let mut out = [[S::default(); 64]; 7];
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
pub fn kinetic_energy_regressor<S: Scalar>(q: &[S; DOF], dq: &[S; DOF]) -> [S; 91] {
    let mut out = [S::default(); 91];
    kernel::kinetic_energy_regressor::nonzeros(&Trig::new(q), dq, &mut out);
    out
}

/// Potential energy, one entry per standard parameter.
///
/// `U = h phi`, J per unit, zero at the base frame's origin; an offset torque counts as `FO q`. Packed form: [`kernel::potential_energy_regressor::packed`].
#[must_use]
#[inline]
pub fn potential_energy_regressor<S: Scalar>(q: &[S; DOF]) -> [S; 91] {
    let mut out = [S::default(); 91];
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
