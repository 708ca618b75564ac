//! Parameters of `ur10e`: sizes, names, limits, values of its file. SI units.

use super::ik;

/// Name of the robot.
pub const NAME: &str = "ur10e";
/// Degrees of freedom.
pub const DOF: usize = 6;
/// Rows of the DH table, fixed ones too.
pub const ROWS: usize = 6;
/// Standard parameters: ten per row, then the drives'.
pub const STANDARD: usize = 84;
/// Base parameters.
pub const BASE: usize = 58;
/// Gravity in the world frame, m/s^2.
pub const GRAVITY: [f64; 3] = [0.0, 0.0, -9.81];

/// Joints, in the order of `q`.
pub const JOINT_NAMES: [&str; DOF] = [
    "base", "shoulder", "elbow", "wrist1", "wrist2", "wrist3",
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
    "IA1", "IA2", "IA3", "IA4", "IA5", "IA6", "FV1", "FV2", "FV3", "FV4",
    "FV5", "FV6", "FC1", "FC2", "FC3", "FC4", "FC5", "FC6", "FO1", "FO2",
    "FO3", "FO4", "FO5", "FO6",
];
/// Base parameters, in the order of the base regressor's columns.
pub const BASE_NAMES: [&str; BASE] = [
    "ZZ1R", "MSX2R", "MSY2", "XX2R", "ZZ2R", "XY2", "XZ2R", "YZ2", "MSX3R", "MSY3",
    "XX3R", "ZZ3R", "XY3", "XZ3R", "YZ3", "MSX4", "MSY4R", "XX4R", "ZZ4R", "XY4",
    "XZ4", "YZ4", "MSX5", "MSY5R", "XX5R", "ZZ5R", "XY5", "XZ5", "YZ5", "MSX6",
    "MSY6", "XX6R", "ZZ6", "XY6", "XZ6", "YZ6", "IA3", "IA4", "IA5", "IA6",
    "FV1", "FV2", "FV3", "FV4", "FV5", "FV6", "FC1", "FC2", "FC3", "FC4",
    "FC5", "FC6", "FO1", "FO2", "FO3", "FO4", "FO5", "FO6",
];
/// Base parameters in closed form, in the constants of the robot file; a name alone groups nothing.
pub const BASE_GROUPINGS: [&str; BASE] = [
    "ZZ1R = ZZ1 + YY2 + YY3 + YY4 + IA1 + A2^2*M3 + (A2^2 + A3^2 + D4^2)*(M4 + M5 + M6) + 2*D4*MSZ4",
    "MSX2R = MSX2 + A2*(M3 + M4 + M5 + M6)",
    "MSY2",
    "XX2R = XX2 - YY2 - A2^2*(M3 + M4 + M5 + M6)",
    "ZZ2R = ZZ2 + A2^2*(M3 + M4 + M5 + M6) + IA2",
    "XY2",
    "XZ2R = XZ2 - A2*(MSZ3 + MSZ4) - A2*D4*(M4 + M5 + M6)",
    "YZ2",
    "MSX3R = MSX3 + A3*(M4 + M5 + M6)",
    "MSY3",
    "XX3R = XX3 - YY3 - A3^2*(M4 + M5 + M6)",
    "ZZ3R = ZZ3 + A3^2*(M4 + M5 + M6)",
    "XY3",
    "XZ3R = XZ3 - A3*D4*(M4 + M5 + M6) - A3*MSZ4",
    "YZ3",
    "MSX4",
    "MSY4R = MSY4 - D5*(M5 + M6) - MSZ5",
    "XX4R = XX4 - YY4 + D5^2*(M5 + M6) + 2*D5*MSZ5 + YY5",
    "ZZ4R = ZZ4 + D5^2*(M5 + M6) + 2*D5*MSZ5 + YY5",
    "XY4",
    "XZ4",
    "YZ4",
    "MSX5",
    "MSY5R = MSY5 + D6*M6 + MSZ6",
    "XX5R = XX5 - YY5 + D6^2*M6 + 2*D6*MSZ6 + YY6",
    "ZZ5R = ZZ5 + D6^2*M6 + 2*D6*MSZ6 + YY6",
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
    "FV1",
    "FV2",
    "FV3",
    "FV4",
    "FV5",
    "FV6",
    "FC1",
    "FC2",
    "FC3",
    "FC4",
    "FC5",
    "FC6",
    "FO1",
    "FO2",
    "FO3",
    "FO4",
    "FO5",
    "FO6",
];
/// The same as numbers: index into the standard parameters, and factor.
pub const BASE_COEFFICIENTS: [&[(usize, f64)]; BASE] = {
    use super::constants::*;
    [
        &[(6, 1.0), (15, 1.0), (20, A2 * A2), (25, 1.0), (30, A2 * A2 + A3 * A3 + D4 * D4), (33, 2.0 * D4), (35, 1.0), (40, A2 * A2 + A3 * A3 + D4 * D4), (50, A2 * A2 + A3 * A3 + D4 * D4), (60, 1.0)],
        &[(11, 1.0), (20, A2), (30, A2), (40, A2), (50, A2)],
        &[(12, 1.0)],
        &[(14, 1.0), (15, -1.0), (20, -A2 * A2), (30, -A2 * A2), (40, -A2 * A2), (50, -A2 * A2)],
        &[(16, 1.0), (20, A2 * A2), (30, A2 * A2), (40, A2 * A2), (50, A2 * A2), (61, 1.0)],
        &[(17, 1.0)],
        &[(18, 1.0), (23, -A2), (30, -A2 * D4), (33, -A2), (40, -A2 * D4), (50, -A2 * D4)],
        &[(19, 1.0)],
        &[(21, 1.0), (30, A3), (40, A3), (50, A3)],
        &[(22, 1.0)],
        &[(24, 1.0), (25, -1.0), (30, -A3 * A3), (40, -A3 * A3), (50, -A3 * A3)],
        &[(26, 1.0), (30, A3 * A3), (40, A3 * A3), (50, A3 * A3)],
        &[(27, 1.0)],
        &[(28, 1.0), (30, -A3 * D4), (33, -A3), (40, -A3 * D4), (50, -A3 * D4)],
        &[(29, 1.0)],
        &[(31, 1.0)],
        &[(32, 1.0), (40, -D5), (43, -1.0), (50, -D5)],
        &[(34, 1.0), (35, -1.0), (40, D5 * D5), (43, 2.0 * D5), (45, 1.0), (50, D5 * D5)],
        &[(36, 1.0), (40, D5 * D5), (43, 2.0 * D5), (45, 1.0), (50, D5 * D5)],
        &[(37, 1.0)],
        &[(38, 1.0)],
        &[(39, 1.0)],
        &[(41, 1.0)],
        &[(42, 1.0), (50, D6), (53, 1.0)],
        &[(44, 1.0), (45, -1.0), (50, D6 * D6), (53, 2.0 * D6), (55, 1.0)],
        &[(46, 1.0), (50, D6 * D6), (53, 2.0 * D6), (55, 1.0)],
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
    ]
};

/// Lower and upper position of each joint, rad or m.
pub const POSITION_LIMITS: [Option<[f64; 2]>; DOF] = [
    Some([-6.283185307179586, 6.283185307179586]), Some([-6.283185307179586, 6.283185307179586]), Some([-6.283185307179586, 6.283185307179586]), Some([-6.283185307179586, 6.283185307179586]),
    Some([-6.283185307179586, 6.283185307179586]), Some([-6.283185307179586, 6.283185307179586]),
];
/// Largest speeds, rad/s or m/s.
pub const VELOCITY_LIMITS: [Option<f64>; DOF] = [
    Some(2.0943951023931953), Some(2.0943951023931953), Some(3.141592653589793), Some(3.141592653589793),
    Some(3.141592653589793), Some(3.141592653589793),
];
/// Largest accelerations, rad/s^2 or m/s^2.
pub const ACCELERATION_LIMITS: [Option<f64>; DOF] = [
    None, None, None, None,
    None, None,
];
/// Largest torques or forces, N m or N.
pub const TORQUE_LIMITS: [Option<f64>; DOF] = [
    Some(330.0), Some(330.0), Some(150.0), Some(56.0),
    Some(56.0), Some(56.0),
];
/// Standard parameters of the robot file, its tool in the last link.
pub const STANDARD_VALUES: Option<[f64; STANDARD]> = Some([
    7.369, 0.154749, -0.198963, 0.0, 0.03519126166, 0.03306898966, 0.0293470425, 0.004178223, 0.0, 0.0, // M1 to YZ1
    13.051, -3.0369677, 0.0, 2.062058, 0.3625111015, 1.458208158, 1.132402994, 0.0, 0.4798408966, 0.0, // M2 to YZ2
    3.989, -1.32255295, 0.0, 0.271252, 0.0296641985, 0.571137406, 0.55269227, 0.0, 0.0899336006, 0.0, // M3 to YZ3
    2.1, 0.0, -0.0378, 0.0147, 0.006256422811, 0.005576022811, 0.00658665, 0.0, 0.0, 0.0002646, // M4 to YZ4
    1.98, 0.0, 0.03564, -0.01386, 0.005898912936, 0.005257392936, 0.00621027, 0.0, 0.0, 0.00024948, // M5 to YZ5
    0.615, 0.0, 0.0, -0.01599, 0.0008552085742, 0.0008552085742, 0.0006226875, 0.0, 0.0, 0.0, // M6 to YZ6
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, // IA1 to FV4
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, // FV5 to FO2
    0.0, 0.0, 0.0, 0.0, // FO3 to FO6
]);

/// Name, multiplications and additions of each function; sines and cosines apart (`DOF` pairs).
pub const OPERATIONS: [(&str, usize, usize); 18] = [
    ("frames", 64, 50),
    ("forward_kinematics", 64, 35),
    ("tool_pose", 64, 35),
    ("jacobian", 65, 40),
    ("tool_jacobian", 65, 40),
    ("jacobian_dot_velocity", 140, 79),
    ("inverse_dynamics", 309, 289),
    ("inverse_dynamics_base", 265, 238),
    ("mass_matrix", 163, 147),
    ("coriolis", 218, 180),
    ("gravity", 48, 26),
    ("forward_dynamics", 514, 420),
    ("regressor", 406, 322),
    ("base_regressor", 308, 243),
    ("gravity_regressor", 111, 63),
    ("kinetic_energy_regressor", 135, 50),
    ("potential_energy_regressor", 32, 12),
    ("payload_regressor", 252, 176),
];

/// Class of the inverse kinematics.
pub const IK_CLASS: &str = "6r-three-parallel";
/// The geometry that makes it so.
pub const IK_REASON: &str = "axes 2-4 are parallel, and the two at their end meet";
/// Lines of the joints at `q = 0` in world axes, m, and the method of the inverse.
pub const IK: ik::Arm<DOF> = ik::Arm {
    axes: [
        ik::Axis { slides: false, h: [0.0, 0.0, 1.0], c: [0.0, 0.0, 0.1807] },
        ik::Axis { slides: false, h: [0.0, -1.0, 0.0], c: [0.0, 0.0, 0.1807] },
        ik::Axis { slides: false, h: [0.0, -1.0, 0.0], c: [-0.6127, 0.0, 0.1807] },
        ik::Axis { slides: false, h: [0.0, -1.0, 0.0], c: [-1.18425, -0.17415, 0.1807] },
        ik::Axis { slides: false, h: [0.0, 0.0, -1.0], c: [-1.18425, -0.17415, 0.06085] },
        ik::Axis { slides: false, h: [0.0, -1.0, 0.0], c: [-1.18425, -0.2907, 0.06085] },
    ],
    home: ik::Displacement { rotation: [[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]], shift: [-1.18425, -0.2907, 0.06085] },
    limits: POSITION_LIMITS,
    exact: true,
    family: ik::Family::Six(ik::Six {
        axes: [
            ik::Axis { slides: false, h: [0.0, 0.0, 1.0], c: [0.0, 0.0, 0.1807] },
            ik::Axis { slides: false, h: [0.0, -1.0, 0.0], c: [0.0, 0.0, 0.1807] },
            ik::Axis { slides: false, h: [0.0, -1.0, 0.0], c: [-0.6127, 0.0, 0.1807] },
            ik::Axis { slides: false, h: [0.0, -1.0, 0.0], c: [-1.18425, -0.17415, 0.1807] },
            ik::Axis { slides: false, h: [0.0, 0.0, -1.0], c: [-1.18425, -0.17415, 0.06085] },
            ik::Axis { slides: false, h: [0.0, -1.0, 0.0], c: [-1.18425, -0.2907, 0.06085] },
        ],
        joints: [Some(0), Some(1), Some(2), Some(3), Some(4), Some(5)],
        reversed: false,
        method: ik::Method::ThreeParallel { meet: Some([-1.18425, -0.17415, 0.06085]) },
    }),
};
/// The tool frame in the last DH frame, m; nothing where the robot file has no tool.
pub const TOOL: ik::Displacement = ik::Displacement { rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], shift: [0.0, 0.0, 0.0] };
