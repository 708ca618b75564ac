//! Parameters of `puma560`: sizes, names, limits, values of its file. SI units.

use super::ik;

/// Name of the robot.
pub const NAME: &str = "puma560";
/// Degrees of freedom.
pub const DOF: usize = 6;
/// Rows of the DH table, fixed ones too.
pub const ROWS: usize = 6;
/// Standard parameters: ten per row, then the drives'.
pub const STANDARD: usize = 78;
/// Base parameters.
pub const BASE: usize = 52;
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
    "IA1", "IA2", "IA3", "IA4", "IA5", "IA6", "FV1", "FV2", "FV3", "FV4",
    "FV5", "FV6", "FC1", "FC2", "FC3", "FC4", "FC5", "FC6",
];
/// Base parameters, in the order of the base regressor's columns.
pub const BASE_NAMES: [&str; BASE] = [
    "ZZ1R", "MSX2R", "MSY2", "XX2R", "ZZ2R", "XY2", "XZ2R", "YZ2", "MSX3R", "MSY3R",
    "XX3R", "ZZ3R", "XY3R", "XZ3", "YZ3", "MSX4", "MSY4R", "XX4R", "ZZ4R", "XY4",
    "XZ4", "YZ4", "MSX5", "MSY5R", "XX5R", "ZZ5R", "XY5", "XZ5", "YZ5", "MSX6",
    "MSY6", "XX6R", "ZZ6", "XY6", "XZ6", "YZ6", "IA3", "IA4", "IA5", "IA6",
    "FV1", "FV2", "FV3", "FV4", "FV5", "FV6", "FC1", "FC2", "FC3", "FC4",
    "FC5", "FC6",
];
/// Base parameters in closed form, in the constants of the robot file; a name alone groups nothing.
pub const BASE_GROUPINGS: [&str; BASE] = [
    "ZZ1R = ZZ1 + D2^2*M2 + 2*D2*MSZ2 + YY2 + YY3 + IA1 + (A2^2 + 2*D2*D3 + D2^2 + D3^2)*M3 + (2*D2 + 2*D3)*MSZ3 + (A2^2 + A3^2 + 2*D2*D3 + D2^2 + D3^2)*(M4 + M5 + M6)",
    "MSX2R = MSX2 + A2*(M3 + M4 + M5 + M6)",
    "MSY2",
    "XX2R = XX2 - YY2 - A2^2*(M3 + M4 + M5 + M6)",
    "ZZ2R = ZZ2 + A2^2*(M3 + M4 + M5 + M6) + IA2",
    "XY2",
    "XZ2R = XZ2 - A2*D3*(M3 + M4 + M5 + M6) - A2*MSZ3",
    "YZ2",
    "MSX3R = MSX3 + A3*(M4 + M5 + M6)",
    "MSY3R = MSY3 - D4*(M4 + M5 + M6) - MSZ4",
    "XX3R = XX3 - YY3 + (-A3^2 + D4^2)*(M4 + M5 + M6) + 2*D4*MSZ4 + YY4",
    "ZZ3R = ZZ3 + (A3^2 + D4^2)*(M4 + M5 + M6) + 2*D4*MSZ4 + YY4",
    "XY3R = XY3 + A3*D4*(M4 + M5 + M6) + A3*MSZ4",
    "XZ3",
    "YZ3",
    "MSX4",
    "MSY4R = MSY4 + MSZ5",
    "XX4R = XX4 - YY4 + YY5",
    "ZZ4R = ZZ4 + YY5",
    "XY4",
    "XZ4",
    "YZ4",
    "MSX5",
    "MSY5R = MSY5 - MSZ6",
    "XX5R = XX5 - YY5 + YY6",
    "ZZ5R = ZZ5 + YY6",
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
];
/// The same as numbers: index into the standard parameters, and factor.
pub const BASE_COEFFICIENTS: [&[(usize, f64)]; BASE] = {
    use super::constants::*;
    [
        &[(6, 1.0), (10, D2 * D2), (13, 2.0 * D2), (15, 1.0), (20, A2 * A2 + 2.0 * D2 * D3 + D2 * D2 + D3 * D3), (23, 2.0 * D2 + 2.0 * D3), (25, 1.0), (30, A2 * A2 + A3 * A3 + 2.0 * D2 * D3 + D2 * D2 + D3 * D3), (40, A2 * A2 + A3 * A3 + 2.0 * D2 * D3 + D2 * D2 + D3 * D3), (50, A2 * A2 + A3 * A3 + 2.0 * D2 * D3 + D2 * D2 + D3 * D3), (60, 1.0)],
        &[(11, 1.0), (20, A2), (30, A2), (40, A2), (50, A2)],
        &[(12, 1.0)],
        &[(14, 1.0), (15, -1.0), (20, -A2 * A2), (30, -A2 * A2), (40, -A2 * A2), (50, -A2 * A2)],
        &[(16, 1.0), (20, A2 * A2), (30, A2 * A2), (40, A2 * A2), (50, A2 * A2), (61, 1.0)],
        &[(17, 1.0)],
        &[(18, 1.0), (20, -A2 * D3), (23, -A2), (30, -A2 * D3), (40, -A2 * D3), (50, -A2 * D3)],
        &[(19, 1.0)],
        &[(21, 1.0), (30, A3), (40, A3), (50, A3)],
        &[(22, 1.0), (30, -D4), (33, -1.0), (40, -D4), (50, -D4)],
        &[(24, 1.0), (25, -1.0), (30, -A3 * A3 + D4 * D4), (33, 2.0 * D4), (35, 1.0), (40, -A3 * A3 + D4 * D4), (50, -A3 * A3 + D4 * D4)],
        &[(26, 1.0), (30, A3 * A3 + D4 * D4), (33, 2.0 * D4), (35, 1.0), (40, A3 * A3 + D4 * D4), (50, A3 * A3 + D4 * D4)],
        &[(27, 1.0), (30, A3 * D4), (33, A3), (40, A3 * D4), (50, A3 * D4)],
        &[(28, 1.0)],
        &[(29, 1.0)],
        &[(31, 1.0)],
        &[(32, 1.0), (43, 1.0)],
        &[(34, 1.0), (35, -1.0), (45, 1.0)],
        &[(36, 1.0), (45, 1.0)],
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
    ]
};

/// Lower and upper position of each joint, rad or m.
pub const POSITION_LIMITS: [Option<[f64; 2]>; DOF] = [
    Some([-2.792526803190927, 2.792526803190927]), Some([-3.9269908169872414, 0.7853981633974483]), Some([-0.7853981633974483, 3.9269908169872414]), Some([-1.9198621771937623, 2.9670597283903604]),
    Some([-1.7453292519943295, 1.7453292519943295]), Some([-4.642575810304916, 4.642575810304916]),
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
    13.0, 0.0, 0.0, 0.0, 0.175, 0.175, 0.35, 0.0, 0.0, 0.0, // M1 to YZ1
    17.4, 1.1832, 0.1044, -0.2784, 0.1350808, 0.608912, 0.620084, -0.0070992, 0.0189312, 0.0016704, // M2 to YZ2
    4.8, 0.0, -0.336, 0.0672, 0.0904608, 0.0134408, 0.08952, 0.0, 0.0, 0.004704, // M3 to YZ3
    0.82, 0.0, 0.0, -0.01558, 0.00209602, 0.00209602, 0.0013, 0.0, 0.0, 0.0, // M4 to YZ4
    0.34, 0.0, 0.0, 0.0, 0.0003, 0.0003, 0.0004, 0.0, 0.0, 0.0, // M5 to YZ5
    0.09, 0.0, 0.0, 0.00288, 0.00024216, 0.00024216, 4e-5, 0.0, 0.0, 0.0, // M6 to YZ6
    1.14, 4.71, 0.83, 0.2, 0.179, 0.193, 5.802, 9.497, 3.98, 0.4116, // IA1 to FV4
    0.4273, 0.2158, 25.98, 10.62, 6.364, 1.068, 0.8544, 0.5544, // FV5 to FC6
]);

/// Name, multiplications and additions of each function; sines and cosines apart (`DOF` pairs).
pub const OPERATIONS: [(&str, usize, usize); 18] = [
    ("frames", 63, 49),
    ("forward_kinematics", 63, 32),
    ("tool_pose", 63, 32),
    ("jacobian", 53, 28),
    ("tool_jacobian", 53, 28),
    ("jacobian_dot_velocity", 141, 84),
    ("inverse_dynamics", 322, 303),
    ("inverse_dynamics_base", 277, 250),
    ("mass_matrix", 184, 163),
    ("coriolis", 235, 204),
    ("gravity", 50, 28),
    ("forward_dynamics", 552, 454),
    ("regressor", 473, 386),
    ("base_regressor", 379, 298),
    ("gravity_regressor", 141, 79),
    ("kinetic_energy_regressor", 145, 55),
    ("potential_energy_regressor", 29, 15),
    ("payload_regressor", 268, 192),
];

/// Class of the inverse kinematics.
pub const IK_CLASS: &str = "6r-spherical-wrist";
/// The geometry that makes it so.
pub const IK_REASON: &str = "axes 4-6 meet in one point, the second and third of the other three are parallel";
/// Lines of the joints at `q = 0` in world axes, m, and the method of the inverse.
pub const IK: ik::Arm<DOF> = ik::Arm {
    axes: [
        ik::Axis { slides: false, h: [0.0, 0.0, 1.0], c: [0.0, 0.0, 0.0] },
        ik::Axis { slides: false, h: [0.0, 1.0, 0.0], c: [0.0, 0.2435, 0.0] },
        ik::Axis { slides: false, h: [0.0, 1.0, 0.0], c: [0.4318, 0.1501, 0.0] },
        ik::Axis { slides: false, h: [0.0, 0.0, 1.0], c: [0.41150000000000003, 0.1501, 0.4331] },
        ik::Axis { slides: false, h: [0.0, 1.0, 0.0], c: [0.41150000000000003, 0.1501, 0.4331] },
        ik::Axis { slides: false, h: [0.0, 0.0, 1.0], c: [0.41150000000000003, 0.1501, 0.4331] },
    ],
    home: ik::Displacement { rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], shift: [0.41150000000000003, 0.1501, 0.4331] },
    limits: POSITION_LIMITS,
    exact: true,
    family: ik::Family::Six(ik::Six {
        axes: [
            ik::Axis { slides: false, h: [0.0, 0.0, 1.0], c: [0.0, 0.0, 0.0] },
            ik::Axis { slides: false, h: [0.0, 1.0, 0.0], c: [0.0, 0.2435, 0.0] },
            ik::Axis { slides: false, h: [0.0, 1.0, 0.0], c: [0.4318, 0.1501, 0.0] },
            ik::Axis { slides: false, h: [0.0, 0.0, 1.0], c: [0.41150000000000003, 0.1501, 0.4331] },
            ik::Axis { slides: false, h: [0.0, 1.0, 0.0], c: [0.41150000000000003, 0.1501, 0.4331] },
            ik::Axis { slides: false, h: [0.0, 0.0, 1.0], c: [0.41150000000000003, 0.1501, 0.4331] },
        ],
        joints: [Some(0), Some(1), Some(2), Some(3), Some(4), Some(5)],
        reversed: false,
        method: ik::Method::Wrist { center: [0.41150000000000003, 0.1501, 0.4331], regional: ik::Regional::Parallel { mirrored: true } },
    }),
};
/// The tool frame in the last DH frame, m; nothing where the robot file has no tool.
pub const TOOL: ik::Displacement = ik::Displacement { rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], shift: [0.0, 0.0, 0.0] };
