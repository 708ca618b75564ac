//! Parameters of `kinova-gen3`: sizes, names, limits, values of its file. SI units.

use super::ik;

/// Name of the robot.
pub const NAME: &str = "kinova-gen3";
/// Degrees of freedom.
pub const DOF: usize = 7;
/// Rows of the DH table, fixed ones too.
pub const ROWS: usize = 7;
/// Standard parameters: ten per row, then the drives'.
pub const STANDARD: usize = 91;
/// Base parameters.
pub const BASE: usize = 64;
/// Gravity in the world frame, m/s^2.
pub const GRAVITY: [f64; 3] = [0.0, 0.0, -9.81];

/// Joints, in the order of `q`.
pub const JOINT_NAMES: [&str; DOF] = [
    "J1", "J2", "J3", "J4", "J5", "J6", "J7",
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
    "M7", "MSX7", "MSY7", "MSZ7", "XX7", "YY7", "ZZ7", "XY7", "XZ7", "YZ7",
    "FV1", "FV2", "FV3", "FV4", "FV5", "FV6", "FV7", "FC1", "FC2", "FC3",
    "FC4", "FC5", "FC6", "FC7", "FO1", "FO2", "FO3", "FO4", "FO5", "FO6",
    "FO7",
];
/// Base parameters, in the order of the base regressor's columns.
pub const BASE_NAMES: [&str; BASE] = [
    "ZZ1R", "MSX2", "MSY2R", "XX2R", "ZZ2R", "XY2", "XZ2", "YZ2", "MSX3", "MSY3R",
    "XX3R", "ZZ3R", "XY3", "XZ3", "YZ3", "MSX4", "MSY4R", "XX4R", "ZZ4R", "XY4",
    "XZ4", "YZ4", "MSX5", "MSY5R", "XX5R", "ZZ5R", "XY5", "XZ5", "YZ5", "MSX6",
    "MSY6R", "XX6R", "ZZ6R", "XY6", "XZ6", "YZ6", "MSX7", "MSY7", "XX7R", "ZZ7",
    "XY7", "XZ7", "YZ7", "FV1", "FV2", "FV3", "FV4", "FV5", "FV6", "FV7",
    "FC1", "FC2", "FC3", "FC4", "FC5", "FC6", "FC7", "FO1", "FO2", "FO3",
    "FO4", "FO5", "FO6", "FO7",
];
/// Base parameters in closed form, in the constants of the robot file; a name alone groups nothing.
pub const BASE_GROUPINGS: [&str; BASE] = [
    "ZZ1R = ZZ1 + 0.0001380625*(M2 + M3 + M4 + M5 + M6 + M7) - 0.0235*MSZ2 + YY2",
    "MSX2",
    "MSY2R = MSY2 - 0.42076*(M3 + M4 + M5 + M6 + M7) + MSZ3",
    "XX2R = XX2 - YY2 + 0.1770389776*(M3 + M4 + M5 + M6 + M7) - 0.84152*MSZ3 + YY3",
    "ZZ2R = ZZ2 + 0.1770389776*(M3 + M4 + M5 + M6 + M7) - 0.84152*MSZ3 + YY3",
    "XY2",
    "XZ2",
    "YZ2",
    "MSX3",
    "MSY3R = MSY3 + 0.01275*(M4 + M5 + M6 + M7) - MSZ4",
    "XX3R = XX3 - YY3 + 0.0001625625*(M4 + M5 + M6 + M7) - 0.0255*MSZ4 + YY4",
    "ZZ3R = ZZ3 + 0.0001625625*(M4 + M5 + M6 + M7) - 0.0255*MSZ4 + YY4",
    "XY3",
    "XZ3",
    "YZ3",
    "MSX4",
    "MSY4R = MSY4 - 0.31436*(M5 + M6 + M7) + MSZ5",
    "XX4R = XX4 - YY4 + 0.0988222096*(M5 + M6 + M7) - 0.62872*MSZ5 + YY5",
    "ZZ4R = ZZ4 + 0.0988222096*(M5 + M6 + M7) - 0.62872*MSZ5 + YY5",
    "XY4",
    "XZ4",
    "YZ4",
    "MSX5",
    "MSY5R = MSY5 + 0.00035*(M6 + M7) - MSZ6",
    "XX5R = XX5 - YY5 + 0.0000001225*(M6 + M7) - 0.0007*MSZ6 + YY6",
    "ZZ5R = ZZ5 + 0.0000001225*(M6 + M7) - 0.0007*MSZ6 + YY6",
    "XY5",
    "XZ5",
    "YZ5",
    "MSX6",
    "MSY6R = MSY6 - 0.167455*M7 + MSZ7",
    "XX6R = XX6 - YY6 + 0.028041177025*M7 - 0.33491*MSZ7 + YY7",
    "ZZ6R = ZZ6 + 0.028041177025*M7 - 0.33491*MSZ7 + YY7",
    "XY6",
    "XZ6",
    "YZ6",
    "MSX7",
    "MSY7",
    "XX7R = XX7 - YY7",
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
/// The same as numbers: index into the standard parameters, and factor.
pub const BASE_COEFFICIENTS: [&[(usize, f64)]; BASE] = [
    &[(6, 1.0), (10, 0.0001380625), (13, -0.0235), (15, 1.0), (20, 0.0001380625), (30, 0.0001380625), (40, 0.0001380625), (50, 0.0001380625), (60, 0.0001380625)],
    &[(11, 1.0)],
    &[(12, 1.0), (20, -0.42076), (23, 1.0), (30, -0.42076), (40, -0.42076), (50, -0.42076), (60, -0.42076)],
    &[(14, 1.0), (15, -1.0), (20, 0.1770389776), (23, -0.84152), (25, 1.0), (30, 0.1770389776), (40, 0.1770389776), (50, 0.1770389776), (60, 0.1770389776)],
    &[(16, 1.0), (20, 0.1770389776), (23, -0.84152), (25, 1.0), (30, 0.1770389776), (40, 0.1770389776), (50, 0.1770389776), (60, 0.1770389776)],
    &[(17, 1.0)],
    &[(18, 1.0)],
    &[(19, 1.0)],
    &[(21, 1.0)],
    &[(22, 1.0), (30, 0.01275), (33, -1.0), (40, 0.01275), (50, 0.01275), (60, 0.01275)],
    &[(24, 1.0), (25, -1.0), (30, 0.01275 * 0.01275), (33, -0.0255), (35, 1.0), (40, 0.01275 * 0.01275), (50, 0.01275 * 0.01275), (60, 0.01275 * 0.01275)],
    &[(26, 1.0), (30, 0.01275 * 0.01275), (33, -0.0255), (35, 1.0), (40, 0.01275 * 0.01275), (50, 0.01275 * 0.01275), (60, 0.01275 * 0.01275)],
    &[(27, 1.0)],
    &[(28, 1.0)],
    &[(29, 1.0)],
    &[(31, 1.0)],
    &[(32, 1.0), (40, -0.31436), (43, 1.0), (50, -0.31436), (60, -0.31436)],
    &[(34, 1.0), (35, -1.0), (40, 0.31436 * 0.31436), (43, -0.62872), (45, 1.0), (50, 0.31436 * 0.31436), (60, 0.31436 * 0.31436)],
    &[(36, 1.0), (40, 0.31436 * 0.31436), (43, -0.62872), (45, 1.0), (50, 0.31436 * 0.31436), (60, 0.31436 * 0.31436)],
    &[(37, 1.0)],
    &[(38, 1.0)],
    &[(39, 1.0)],
    &[(41, 1.0)],
    &[(42, 1.0), (50, 0.00035), (53, -1.0), (60, 0.00035)],
    &[(44, 1.0), (45, -1.0), (50, 1.225e-7), (53, -0.0007), (55, 1.0), (60, 1.225e-7)],
    &[(46, 1.0), (50, 1.225e-7), (53, -0.0007), (55, 1.0), (60, 1.225e-7)],
    &[(47, 1.0)],
    &[(48, 1.0)],
    &[(49, 1.0)],
    &[(51, 1.0)],
    &[(52, 1.0), (60, -0.167455), (63, 1.0)],
    &[(54, 1.0), (55, -1.0), (60, 0.028041177025), (63, -0.33491), (65, 1.0)],
    &[(56, 1.0), (60, 0.028041177025), (63, -0.33491), (65, 1.0)],
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
    &[(84, 1.0)],
    &[(85, 1.0)],
    &[(86, 1.0)],
    &[(87, 1.0)],
    &[(88, 1.0)],
    &[(89, 1.0)],
    &[(90, 1.0)],
];

/// Lower and upper position of each joint, rad or m.
pub const POSITION_LIMITS: [Option<[f64; 2]>; DOF] = [
    None, Some([-2.41, 2.41]), None, Some([-2.66, 2.66]),
    None, Some([-2.23, 2.23]), None,
];
/// Largest speeds, rad/s or m/s.
pub const VELOCITY_LIMITS: [Option<f64>; DOF] = [
    Some(1.396), Some(1.396), Some(1.396), Some(1.396),
    Some(1.222), Some(1.222), Some(1.222),
];
/// Largest accelerations, rad/s^2 or m/s^2.
pub const ACCELERATION_LIMITS: [Option<f64>; DOF] = [
    None, None, None, None,
    None, None, None,
];
/// Largest torques or forces, N m or N.
pub const TORQUE_LIMITS: [Option<f64>; DOF] = [
    Some(39.0), Some(39.0), Some(39.0), Some(39.0),
    Some(9.0), Some(9.0), Some(9.0),
];
/// Standard parameters of the robot file, its tool in the last link.
pub const STANDARD_VALUES: Option<[f64; STANDARD]> = Some([
    1.3773, -3.1678e-5, -0.014274337, 0.075779046, 0.008887302, 0.009000364, 0.00155694, 6.72e-7, 3.743e-6, 0.001233374, // M1 to YZ1
    1.1636, -5.1198e-5, -0.115871288, -0.008032331, 0.02268191, 0.001127449, 0.022793465, -9.8e-8, -3.53e-7, -0.00149086, // M2 to YZ2
    1.1636, -5.1198e-5, -0.007727468, 0.107619037, 0.020936788, 0.021080472, 0.00109432, -3.4e-7, -2.265e-6, 0.001320698, // M3 to YZ3
    0.9302, -1.6744e-5, -0.070209636, -0.008028556, 0.013515577, 0.000700295, 0.013615283, -2.264e-6, -1.45e-7, -0.001105979, // M4 to YZ4
    0.6781, 6.78e-7, -0.006395839, 0.028512071, 0.002855173, 0.002805847, 0.000459326, 6e-9, -2.9e-8, 0.000524926, // M5 to YZ5
    0.6781, 6.78e-7, -0.030842022, -0.006424998, 0.003104665, 0.000470877, 0.003043788, 3.1e-8, 6e-9, -0.000570228, // M6 to YZ6
    0.5, 0.0001405, 0.005701, 0.0158635, 0.001155304, 0.000872341, 0.000674042, 1.398e-6, -1.458e-6, -0.000298876, // M7 to YZ7
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, // FV1 to FC3
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, // FC4 to FO6
    0.0, // FO7 to FO7
]);

/// Name, multiplications and additions of each function; sines and cosines apart (`DOF` pairs).
pub const OPERATIONS: [(&str, usize, usize); 18] = [
    ("frames", 79, 64),
    ("forward_kinematics", 79, 43),
    ("tool_pose", 79, 43),
    ("jacobian", 89, 65),
    ("tool_jacobian", 89, 65),
    ("jacobian_dot_velocity", 186, 112),
    ("inverse_dynamics", 381, 378),
    ("inverse_dynamics_base", 326, 312),
    ("mass_matrix", 242, 197),
    ("coriolis", 296, 270),
    ("gravity", 64, 38),
    ("forward_dynamics", 725, 596),
    ("regressor", 859, 669),
    ("base_regressor", 675, 492),
    ("gravity_regressor", 283, 166),
    ("kinetic_energy_regressor", 163, 68),
    ("potential_energy_regressor", 40, 19),
    ("payload_regressor", 419, 281),
];

/// Class of the inverse kinematics.
pub const IK_CLASS: &str = "srs";
/// The geometry that makes it so.
pub const IK_REASON: &str = "nearly: axes 1-3 meet in a shoulder, 5-7 in a wrist, and axis 4 meets both upper and lower arm: by swivel angle; closed form of that nominal arm, each branch refined by Newton's steps";
/// Lines of the joints at `q = 0` in world axes, m, and the method of the inverse.
pub const IK: ik::Arm<DOF> = ik::Arm {
    axes: [
        ik::Axis { slides: false, h: [0.0, 0.0, -1.0], c: [0.0, 0.0, 0.28481] },
        ik::Axis { slides: false, h: [0.0, 1.0, 0.0], c: [0.0, -0.01175, 0.28481] },
        ik::Axis { slides: false, h: [0.0, 0.0, -1.0], c: [0.0, -0.01175, 0.70557] },
        ik::Axis { slides: false, h: [0.0, 1.0, 0.0], c: [0.0, -0.0245, 0.70557] },
        ik::Axis { slides: false, h: [0.0, 0.0, -1.0], c: [0.0, -0.0245, 1.01993] },
        ik::Axis { slides: false, h: [0.0, 1.0, 0.0], c: [0.0, -0.02485, 1.01993] },
        ik::Axis { slides: false, h: [0.0, 0.0, -1.0], c: [0.0, -0.02485, 1.187385] },
    ],
    home: ik::Displacement { rotation: [[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, -1.0]], shift: [0.0, -0.02485, 1.187385] },
    limits: POSITION_LIMITS,
    exact: false,
    family: ik::Family::Swivel(ik::Swivel {
        axes: [
            ik::Axis { slides: false, h: [0.0, 0.0, -1.0], c: [0.0, -0.005875, 0.28481] },
            ik::Axis { slides: false, h: [0.0, 1.0, 0.0], c: [0.0, -0.005875, 0.28481] },
            ik::Axis { slides: false, h: [-0.0, 0.029101653200527617, -0.9995764571962448], c: [0.0, -0.005875, 0.28481] },
            ik::Axis { slides: false, h: [0.0, 0.9995764571962447, 0.029101653200527617], c: [0.0, -0.018125000000000002, 0.70557] },
            ik::Axis { slides: false, h: [-0.0, 0.020831462845291086, -0.9997830015336955], c: [0.0, -0.024675000000000002, 1.01993] },
            ik::Axis { slides: false, h: [0.0, 1.0, 0.0], c: [0.0, -0.024675000000000002, 1.01993] },
            ik::Axis { slides: false, h: [0.0, 0.0, -1.0], c: [0.0, -0.024675000000000002, 1.01993] },
        ],
        shoulder: [0.0, -0.005875, 0.28481],
        elbow: [0.0, -0.018125000000000002, 0.70557],
        wrist: [0.0, -0.024675000000000002, 1.01993],
    }),
};
/// The tool frame in the last DH frame, m; nothing where the robot file has no tool.
pub const TOOL: ik::Displacement = ik::Displacement { rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], shift: [0.0, 0.0, 0.0] };
