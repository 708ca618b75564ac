//! Parameters of `kuka-lwr4`: sizes, names, limits, values of its file. SI units.

use super::ik;

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
/// Gravity in the world frame, m/s^2.
pub const GRAVITY: [f64; 3] = [0.0, 0.0, -9.81];

/// Joints, in the order of `q`.
pub const JOINT_NAMES: [&str; DOF] = [
    "A1", "A2", "A3", "A4", "A5", "A6", "A7",
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
    "FC4", "FC5", "FC6", "FC7",
];
/// Base parameters, in the order of the base regressor's columns.
pub const BASE_NAMES: [&str; BASE] = [
    "ZZ1R", "MSX2", "MSY2R", "XX2R", "ZZ2R", "XY2", "XZ2", "YZ2", "MSX3", "MSY3R",
    "XX3R", "ZZ3R", "XY3", "XZ3", "YZ3", "MSX4", "MSY4R", "XX4R", "ZZ4R", "XY4",
    "XZ4", "YZ4", "MSX5", "MSY5R", "XX5R", "ZZ5R", "XY5", "XZ5", "YZ5", "MSX6",
    "MSY6R", "XX6R", "ZZ6R", "XY6", "XZ6", "YZ6", "MSX7", "MSY7", "XX7R", "ZZ7",
    "XY7", "XZ7", "YZ7", "FV1", "FV2", "FV3", "FV4", "FV5", "FV6", "FV7",
    "FC1", "FC2", "FC3", "FC4", "FC5", "FC6", "FC7",
];
/// Base parameters in closed form, in the constants of the robot file; a name alone groups nothing.
pub const BASE_GROUPINGS: [&str; BASE] = [
    "ZZ1R = ZZ1 + YY2",
    "MSX2",
    "MSY2R = MSY2 + L2*(M3 + M4 + M5 + M6 + M7) + MSZ3",
    "XX2R = XX2 - YY2 + L2^2*(M3 + M4 + M5 + M6 + M7) + 2*L2*MSZ3 + YY3",
    "ZZ2R = ZZ2 + L2^2*(M3 + M4 + M5 + M6 + M7) + 2*L2*MSZ3 + YY3",
    "XY2",
    "XZ2",
    "YZ2",
    "MSX3",
    "MSY3R = MSY3 + MSZ4",
    "XX3R = XX3 - YY3 + YY4",
    "ZZ3R = ZZ3 + YY4",
    "XY3",
    "XZ3",
    "YZ3",
    "MSX4",
    "MSY4R = MSY4 - L3*(M5 + M6 + M7) - MSZ5",
    "XX4R = XX4 - YY4 + L3^2*(M5 + M6 + M7) + 2*L3*MSZ5 + YY5",
    "ZZ4R = ZZ4 + L3^2*(M5 + M6 + M7) + 2*L3*MSZ5 + YY5",
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
    "MSY6R = MSY6 + MSZ7",
    "XX6R = XX6 - YY6 + YY7",
    "ZZ6R = ZZ6 + YY7",
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
];
/// The same as numbers: index into the standard parameters, and factor.
pub const BASE_COEFFICIENTS: [&[(usize, f64)]; BASE] = {
    use super::constants::*;
    [
        &[(6, 1.0), (15, 1.0)],
        &[(11, 1.0)],
        &[(12, 1.0), (20, L2), (23, 1.0), (30, L2), (40, L2), (50, L2), (60, L2)],
        &[(14, 1.0), (15, -1.0), (20, L2 * L2), (23, 2.0 * L2), (25, 1.0), (30, L2 * L2), (40, L2 * L2), (50, L2 * L2), (60, L2 * L2)],
        &[(16, 1.0), (20, L2 * L2), (23, 2.0 * L2), (25, 1.0), (30, L2 * L2), (40, L2 * L2), (50, L2 * L2), (60, L2 * L2)],
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
        &[(32, 1.0), (40, -L3), (43, -1.0), (50, -L3), (60, -L3)],
        &[(34, 1.0), (35, -1.0), (40, L3 * L3), (43, 2.0 * L3), (45, 1.0), (50, L3 * L3), (60, L3 * L3)],
        &[(36, 1.0), (40, L3 * L3), (43, 2.0 * L3), (45, 1.0), (50, L3 * L3), (60, L3 * L3)],
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
    ]
};

/// Lower and upper position of each joint, rad or m.
pub const POSITION_LIMITS: [Option<[f64; 2]>; DOF] = [
    Some([-2.9670597283903604, 2.9670597283903604]), Some([-2.0943951023931953, 2.0943951023931953]), Some([-2.9670597283903604, 2.9670597283903604]), Some([-2.0943951023931953, 2.0943951023931953]),
    Some([-2.9670597283903604, 2.9670597283903604]), Some([-2.0943951023931953, 2.0943951023931953]), Some([-2.9670597283903604, 2.9670597283903604]),
];
/// Largest speeds, rad/s or m/s.
pub const VELOCITY_LIMITS: [Option<f64>; DOF] = [
    Some(1.9198621771937623), Some(1.9198621771937623), Some(2.234021442552742), Some(2.234021442552742),
    Some(3.5604716740684323), Some(3.211405823669566), Some(3.211405823669566),
];
/// Largest accelerations, rad/s^2 or m/s^2.
pub const ACCELERATION_LIMITS: [Option<f64>; DOF] = [
    None, None, None, None,
    None, None, None,
];
/// Largest torques or forces, N m or N.
pub const TORQUE_LIMITS: [Option<f64>; DOF] = [
    Some(176.0), Some(176.0), Some(100.0), Some(100.0),
    Some(100.0), Some(38.0), Some(38.0),
];
/// Standard parameters of the robot file, its tool in the last link.
pub const STANDARD_VALUES: Option<[f64; STANDARD]> = Some([
    2.7036985567, 0.0, 0.0, 0.0, 0.033180373793, 0.033179255008, 0.0060823587057, 0.0, 0.0, 0.0, // M1 to YZ1
    2.7084989177, 0.0013547404, 0.21567267715, 0.0038560143326, 0.033427937896, 0.0054516899943, 0.032778197901, 8.27561529e-8, 1.27083764e-10, -0.000543114698, // M2 to YZ2
    2.6966283472, 0.00094560079, 0.00062828039907, -0.3184607794, 0.051493638498, 0.050586516719, 0.0053371064286, -1.2154487e-7, 0.00037830507133, 0.0005374131766, // M3 to YZ3
    2.689589786, -0.00349748412, -0.21409561484, -0.0011006549001, 0.031042592641, 0.0054480071714, 0.030011540469, 7.09280381e-8, 7.73235478e-8, 0.000532412294, // M4 to YZ4
    1.6745990952, -0.000656231999, 0.010857559621, -0.25003539582, 0.048795121225, 0.04835474869, 0.0028179871547, 4.10092494e-8, -4.87260508e-8, 0.000422490382, // M5 to YZ5
    1.5546669658, 0.000835227362, 0.023268381773, -0.029830414379, 0.0035980186126, 0.0035124306353, 0.0026802148973, -1.62122248e-7, 4.43055103e-8, 1.00573718e-5, // M6 to YZ6
    0.28345773633, -0.000298447259, 0.000954515526, 0.0053687966266, 0.0010889025488, 0.0010878054827, 0.000120294035, 2.50512714e-8, -4.20844121e-9, 2.6711949e-9, // M7 to YZ7
    1.07, 0.96, 0.22, 0.69, 0.07, 0.25, 0.08, 0.28, 0.43, 0.05, // FV1 to FC3
    0.16, 0.34, 0.16, 0.2, // FC4 to FC7
]);

/// Name, multiplications and additions of each function; sines and cosines apart (`DOF` pairs).
pub const OPERATIONS: [(&str, usize, usize); 18] = [
    ("frames", 68, 48),
    ("forward_kinematics", 68, 33),
    ("tool_pose", 68, 33),
    ("jacobian", 66, 38),
    ("tool_jacobian", 66, 38),
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

/// Class of the inverse kinematics.
pub const IK_CLASS: &str = "srs";
/// The geometry that makes it so.
pub const IK_REASON: &str = "axes 1-3 meet in a shoulder, 5-7 in a wrist, and axis 4 meets both upper and lower arm: by swivel angle";
/// Lines of the joints at `q = 0` in world axes, m, and the method of the inverse.
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
/// The tool frame in the last DH frame, m; nothing where the robot file has no tool.
pub const TOOL: ik::Displacement = ik::Displacement { rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], shift: [0.0, 0.0, 0.0] };
