//! Parameters of `stanford`: sizes, names, limits, values of its file. SI units.

use super::ik;

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
/// Gravity in the world frame, m/s^2.
pub const GRAVITY: [f64; 3] = [0.0, 0.0, -9.81];

/// Joints, in the order of `q`.
pub const JOINT_NAMES: [&str; DOF] = [
    "J1", "J2", "J3", "J4", "J5", "J6",
];
/// Standard parameters, in the order of the regressor's columns (SI; tensors about the frame's
/// origin).
pub const STANDARD_NAMES: [&str; STANDARD] = [
    "M1", "MSX1", "MSY1", "MSZ1", "XX1", "YY1", "ZZ1", "XY1", "XZ1", "YZ1",
    "M2", "MSX2", "MSY2", "MSZ2", "XX2", "YY2", "ZZ2", "XY2", "XZ2", "YZ2",
    "M3", "MSX3", "MSY3", "MSZ3", "XX3", "YY3", "ZZ3", "XY3", "XZ3", "YZ3",
    "M4", "MSX4", "MSY4", "MSZ4", "XX4", "YY4", "ZZ4", "XY4", "XZ4", "YZ4",
    "M5", "MSX5", "MSY5", "MSZ5", "XX5", "YY5", "ZZ5", "XY5", "XZ5", "YZ5",
    "M6", "MSX6", "MSY6", "MSZ6", "XX6", "YY6", "ZZ6", "XY6", "XZ6", "YZ6",
    "IA1", "IA2", "IA3", "IA4", "IA5", "IA6",
];
/// Base parameters, in the order of the base regressor's columns.
pub const BASE_NAMES: [&str; BASE] = [
    "YY1R", "MSX2", "MSZ2", "YY2R", "ZZ2R", "XY2R", "XZ2R", "YZ2R", "M3R", "MSX3",
    "MSY3", "MSZ3R", "MSX4", "MSZ4R", "YY4R", "ZZ4R", "XY4", "XZ4", "YZ4", "MSX5",
    "MSZ5R", "YY5R", "ZZ5R", "XY5", "XZ5", "YZ5", "MSX6", "MSY6", "XX6R", "ZZ6",
    "XY6", "XZ6", "YZ6", "IA3", "IA4", "IA5", "IA6",
];
/// Base parameters in closed form, in the constants of the robot file; a name alone groups nothing.
pub const BASE_GROUPINGS: [&str; BASE] = [
    "YY1R = YY1 + D2^2*M2 + 2*D2*MSY2 + XX2 + YY3 + XX4 + XX5 + YY6 + IA1 + D6^2*M6 + 2*D6*MSZ6",
    "MSX2",
    "MSZ2",
    "YY2R = YY2 + XX3 + XX4 + XX5 + YY6 + IA2 + D6^2*M6 + 2*D6*MSZ6",
    "ZZ2R = ZZ2 - XX2 - YY3 - XX4 - XX5 - YY6 + ZZ3 - D6^2*M6 - 2*D6*MSZ6",
    "XY2R = XY2 - XY3",
    "XZ2R = XZ2 + YZ3",
    "YZ2R = YZ2 - XZ3",
    "M3R = M3 + M4 + M5 + M6",
    "MSX3",
    "MSY3",
    "MSZ3R = MSZ3 - MSY4",
    "MSX4",
    "MSZ4R = MSZ4 + MSY5",
    "YY4R = YY4 + XX5 + YY6 + D6^2*M6 + 2*D6*MSZ6",
    "ZZ4R = ZZ4 - XX4 - XX5 - YY6 - D6^2*M6 - 2*D6*MSZ6",
    "XY4",
    "XZ4",
    "YZ4",
    "MSX5",
    "MSZ5R = MSZ5 + D6*M6 + MSZ6",
    "YY5R = YY5 + D6^2*M6 + 2*D6*MSZ6 + YY6",
    "ZZ5R = ZZ5 - XX5 - YY6 - D6^2*M6 - 2*D6*MSZ6",
    "XY5",
    "XZ5",
    "YZ5",
    "MSX6",
    "MSY6",
    "XX6R = XX6 - YY6",
    "ZZ6",
    "XY6",
    "XZ6",
    "YZ6",
    "IA3",
    "IA4",
    "IA5",
    "IA6",
];
/// The same as numbers: index into the standard parameters, and factor.
pub const BASE_COEFFICIENTS: [&[(usize, f64)]; BASE] = {
    use super::constants::*;
    [
        &[(5, 1.0), (10, D2 * D2), (12, 2.0 * D2), (14, 1.0), (25, 1.0), (34, 1.0), (44, 1.0), (50, D6 * D6), (53, 2.0 * D6), (55, 1.0), (60, 1.0)],
        &[(11, 1.0)],
        &[(13, 1.0)],
        &[(15, 1.0), (24, 1.0), (34, 1.0), (44, 1.0), (50, D6 * D6), (53, 2.0 * D6), (55, 1.0), (61, 1.0)],
        &[(14, -1.0), (16, 1.0), (25, -1.0), (26, 1.0), (34, -1.0), (44, -1.0), (50, -D6 * D6), (53, -2.0 * D6), (55, -1.0)],
        &[(17, 1.0), (27, -1.0)],
        &[(18, 1.0), (29, 1.0)],
        &[(19, 1.0), (28, -1.0)],
        &[(20, 1.0), (30, 1.0), (40, 1.0), (50, 1.0)],
        &[(21, 1.0)],
        &[(22, 1.0)],
        &[(23, 1.0), (32, -1.0)],
        &[(31, 1.0)],
        &[(33, 1.0), (42, 1.0)],
        &[(35, 1.0), (44, 1.0), (50, D6 * D6), (53, 2.0 * D6), (55, 1.0)],
        &[(34, -1.0), (36, 1.0), (44, -1.0), (50, -D6 * D6), (53, -2.0 * D6), (55, -1.0)],
        &[(37, 1.0)],
        &[(38, 1.0)],
        &[(39, 1.0)],
        &[(41, 1.0)],
        &[(43, 1.0), (50, D6), (53, 1.0)],
        &[(45, 1.0), (50, D6 * D6), (53, 2.0 * D6), (55, 1.0)],
        &[(44, -1.0), (46, 1.0), (50, -D6 * D6), (53, -2.0 * D6), (55, -1.0)],
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
    ]
};

/// Lower and upper position of each joint, rad or m.
pub const POSITION_LIMITS: [Option<[f64; 2]>; DOF] = [
    None, None, None, None,
    None, None,
];
/// Largest speeds, rad/s or m/s.
pub const VELOCITY_LIMITS: [Option<f64>; DOF] = [
    None, None, None, None,
    None, None,
];
/// Largest accelerations, rad/s^2 or m/s^2.
pub const ACCELERATION_LIMITS: [Option<f64>; DOF] = [
    None, None, None, None,
    None, None,
];
/// Largest torques or forces, N m or N.
pub const TORQUE_LIMITS: [Option<f64>; DOF] = [
    None, None, None, None,
    None, None,
];
/// Standard parameters of the robot file, its tool in the last link.
pub const STANDARD_VALUES: Option<[f64; STANDARD]> = Some([
    9.29, 0.0, 0.162575, -1.026545, 0.276, 0.255, 0.071, 0.0, 0.0, 0.0, // M1 to YZ1
    5.01, 0.0, -0.528054, 0.0, 0.108, 0.018, 0.1, 0.0, 0.0, 0.0, // M2 to YZ2
    4.25, 0.0, 0.0, -2.739975, 2.51, 2.51, 0.006, 0.0, 0.0, 0.0, // M3 to YZ3
    1.08, 0.0, 0.009936, -0.005832, 0.002, 0.001, 0.001, 0.0, 0.0, 0.0, // M4 to YZ4
    0.63, 0.0, 0.0, 0.035658, 0.003, 0.003, 0.0004, 0.0, 0.0, 0.0, // M5 to YZ5
    0.51, 0.0, 0.0, 0.079254, 0.013, 0.013, 0.0003, 0.0, 0.0, 0.0, // M6 to YZ6
    0.953, 2.193, 0.782, 0.106, 0.097, 0.02, // IA1 to IA6
]);

/// Name, multiplications and additions of each function; sines and cosines apart (`DOF` pairs).
pub const OPERATIONS: [(&str, usize, usize); 18] = [
    ("frames", 46, 33),
    ("forward_kinematics", 46, 23),
    ("tool_pose", 46, 23),
    ("jacobian", 44, 27),
    ("tool_jacobian", 44, 27),
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

/// Class of the inverse kinematics.
pub const IK_CLASS: &str = "stanford";
/// The geometry that makes it so.
pub const IK_REASON: &str = "axes 4-6 meet in one point, joint 3 of the others slides, the first two meet";
/// Lines of the joints at `q = 0` in world axes, m, and the method of the inverse.
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
/// The tool frame in the last DH frame, m; nothing where the robot file has no tool.
pub const TOOL: ik::Displacement = ik::Displacement { rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], shift: [0.0, 0.0, 0.0] };
