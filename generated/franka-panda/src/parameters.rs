//! Parameters of `franka-panda`: sizes, names, limits, values of its file. SI units.

use super::ik;

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
    "ZZ1R", "MSX2", "MSY2R", "XX2R", "ZZ2R", "XY2", "XZ2", "YZ2", "MSX3R", "MSY3R",
    "XX3R", "ZZ3R", "XY3R", "XZ3", "YZ3", "MSX4R", "MSY4R", "XX4R", "ZZ4R", "XY4R",
    "XZ4", "YZ4", "MSX5", "MSY5R", "XX5R", "ZZ5R", "XY5", "XZ5", "YZ5", "MSX6R",
    "MSY6R", "XX6R", "ZZ6R", "XY6R", "XZ6", "YZ6", "MSX7", "MSY7", "XX7R", "ZZ7",
    "XY7", "XZ7", "YZ7", "FV1", "FV2", "FV3", "FV4", "FV5", "FV6", "FV7",
    "FC1", "FC2", "FC3", "FC4", "FC5", "FC6", "FC7", "FO1", "FO2", "FO3",
    "FO4", "FO5", "FO6", "FO7",
];
/// Base parameters in closed form, in the constants of the robot file; a name alone groups nothing.
pub const BASE_GROUPINGS: [&str; BASE] = [
    "ZZ1R = ZZ1 + YY2",
    "MSX2",
    "MSY2R = MSY2 - L2*(M3 + M4 + M5 + M6 + M7) - MSZ3",
    "XX2R = XX2 - YY2 + L2^2*M3 + 2*L2*MSZ3 + YY3 + (L2^2 + A^2)*(M4 + M5 + M6 + M7)",
    "ZZ2R = ZZ2 + L2^2*M3 + 2*L2*MSZ3 + YY3 + (L2^2 + A^2)*(M4 + M5 + M6 + M7)",
    "XY2",
    "XZ2",
    "YZ2",
    "MSX3R = MSX3 + A*(M4 + M5 + M6 + M7)",
    "MSY3R = MSY3 - MSZ4",
    "XX3R = XX3 - YY3 - A^2*M4 + YY4",
    "ZZ3R = ZZ3 + A^2*M4 + YY4 + 2*A^2*(M5 + M6 + M7)",
    "XY3R = XY3 + A*MSZ4",
    "XZ3",
    "YZ3",
    "MSX4R = MSX4 - A*(M5 + M6 + M7)",
    "MSY4R = MSY4 + L3*(M5 + M6 + M7) + MSZ5",
    "XX4R = XX4 - YY4 + (L3^2 - A^2)*(M5 + M6 + M7) + 2*L3*MSZ5 + YY5",
    "ZZ4R = ZZ4 + (L3^2 + A^2)*(M5 + M6 + M7) + 2*L3*MSZ5 + YY5",
    "XY4R = XY4 + L3*A*(M5 + M6 + M7) + A*MSZ5",
    "XZ4",
    "YZ4",
    "MSX5",
    "MSY5R = MSY5 - MSZ6",
    "XX5R = XX5 - YY5 + YY6 + 0.007744*M7",
    "ZZ5R = ZZ5 + YY6 + 0.007744*M7",
    "XY5",
    "XZ5",
    "YZ5",
    "MSX6R = MSX6 + 0.088*M7",
    "MSY6R = MSY6 - MSZ7",
    "XX6R = XX6 - YY6 - 0.007744*M7 + YY7",
    "ZZ6R = ZZ6 + 0.007744*M7 + YY7",
    "XY6R = XY6 + 0.088*MSZ7",
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
pub const BASE_COEFFICIENTS: [&[(usize, f64)]; BASE] = {
    use super::constants::*;
    [
        &[(6, 1.0), (15, 1.0)],
        &[(11, 1.0)],
        &[(12, 1.0), (20, -L2), (23, -1.0), (30, -L2), (40, -L2), (50, -L2), (60, -L2)],
        &[(14, 1.0), (15, -1.0), (20, L2 * L2), (23, 2.0 * L2), (25, 1.0), (30, L2 * L2 + A * A), (40, L2 * L2 + A * A), (50, L2 * L2 + A * A), (60, L2 * L2 + A * A)],
        &[(16, 1.0), (20, L2 * L2), (23, 2.0 * L2), (25, 1.0), (30, L2 * L2 + A * A), (40, L2 * L2 + A * A), (50, L2 * L2 + A * A), (60, L2 * L2 + A * A)],
        &[(17, 1.0)],
        &[(18, 1.0)],
        &[(19, 1.0)],
        &[(21, 1.0), (30, A), (40, A), (50, A), (60, A)],
        &[(22, 1.0), (33, -1.0)],
        &[(24, 1.0), (25, -1.0), (30, -A * A), (35, 1.0)],
        &[(26, 1.0), (30, A * A), (35, 1.0), (40, 2.0 * (A * A)), (50, 2.0 * (A * A)), (60, 2.0 * (A * A))],
        &[(27, 1.0), (33, A)],
        &[(28, 1.0)],
        &[(29, 1.0)],
        &[(31, 1.0), (40, -A), (50, -A), (60, -A)],
        &[(32, 1.0), (40, L3), (43, 1.0), (50, L3), (60, L3)],
        &[(34, 1.0), (35, -1.0), (40, L3 * L3 - A * A), (43, 2.0 * L3), (45, 1.0), (50, L3 * L3 - A * A), (60, L3 * L3 - A * A)],
        &[(36, 1.0), (40, L3 * L3 + A * A), (43, 2.0 * L3), (45, 1.0), (50, L3 * L3 + A * A), (60, L3 * L3 + A * A)],
        &[(37, 1.0), (40, L3 * A), (43, A), (50, L3 * A), (60, L3 * A)],
        &[(38, 1.0)],
        &[(39, 1.0)],
        &[(41, 1.0)],
        &[(42, 1.0), (53, -1.0)],
        &[(44, 1.0), (45, -1.0), (55, 1.0), (60, 0.088 * 0.088)],
        &[(46, 1.0), (55, 1.0), (60, 0.088 * 0.088)],
        &[(47, 1.0)],
        &[(48, 1.0)],
        &[(49, 1.0)],
        &[(51, 1.0), (60, 0.088)],
        &[(52, 1.0), (63, -1.0)],
        &[(54, 1.0), (55, -1.0), (60, -0.088 * 0.088), (65, 1.0)],
        &[(56, 1.0), (60, 0.088 * 0.088), (65, 1.0)],
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
    ]
};

/// Lower and upper position of each joint, rad or m.
pub const POSITION_LIMITS: [Option<[f64; 2]>; DOF] = [
    Some([-2.8973, 2.8973]), Some([-1.7628, 1.7628]), Some([-2.8973, 2.8973]), Some([-3.0718, -0.0698]),
    Some([-2.8973, 2.8973]), Some([-0.0175, 3.7525]), Some([-2.8973, 2.8973]),
];
/// Largest speeds, rad/s or m/s.
pub const VELOCITY_LIMITS: [Option<f64>; DOF] = [
    Some(2.175), Some(2.175), Some(2.175), Some(2.175),
    Some(2.61), Some(2.61), Some(2.61),
];
/// Largest accelerations, rad/s^2 or m/s^2.
pub const ACCELERATION_LIMITS: [Option<f64>; DOF] = [
    Some(15.0), Some(7.5), Some(10.0), Some(12.5),
    Some(15.0), Some(20.0), Some(20.0),
];
/// Largest torques or forces, N m or N.
pub const TORQUE_LIMITS: [Option<f64>; DOF] = [
    Some(87.0), Some(87.0), Some(87.0), Some(87.0),
    Some(12.0), Some(12.0), Some(12.0),
];
/// Standard parameters of the robot file, its tool in the last link.
pub const STANDARD_VALUES: Option<[f64; STANDARD]> = Some([
    4.970684, 0.0192614005, 0.0103439934, 0.0, 0.7033915259, 0.7066846379, 0.009213163777, -0.0001790829744, 0.006772, 0.019169, // M1 to YZ1
    0.646926, -0.002031994566, -0.01857971472, 0.00226100637, 0.008503511624, 0.02812428471, 0.0265349919, -0.003983358884, 0.01026110182, 0.0007689361029, // M2 to YZ2
    3.228604, 0.08884472487, 0.1267291642, -0.2147086232, 0.05649492601, 0.052878382, 0.01824920229, -0.008248333141, -0.005487648107, -0.004377257122, // M3 to YZ3
    3.587895, -0.1907683772, 0.374644408, 0.09850206933, 0.06767727025, 0.03239943042, 0.07758614905, 0.02771584317, 0.003905355026, -0.001644487577, // M4 to YZ4
    1.225946, -0.01465373254, 0.05034347249, -0.0471216864, 0.03942757096, 0.03146037233, 0.01086951076, -0.001515244473, -0.004600245518, 0.002164052052, // M5 to YZ5
    1.666555, 0.1002416167, -0.02352675694, -0.01752715894, 0.002480460358, 0.01056776613, 0.01179456023, 0.001524110903, -0.0001037589172, 9.356909731e-5, // M6 to YZ6
    0.735522, 0.007735484874, -0.003127439544, 0.04530594863, 0.01532000839, 0.01289906461, 0.004909651967, -0.0003951087183, -0.001672482662, -0.0005483591064, // M7 to YZ7
    0.0628, 0.2088, 0.0361, 0.2174, 0.1021, 0.0001613, 0.0632, 0.2549, 0.1413, 0.1879, // FV1 to FC3
    0.3625, 0.2728, 0.1529, 0.2097, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, // FC4 to FO6
    0.0, // FO7 to FO7
]);

/// Name, multiplications and additions of each function; sines and cosines apart (`DOF` pairs).
pub const OPERATIONS: [(&str, usize, usize); 18] = [
    ("frames", 77, 56),
    ("forward_kinematics", 77, 41),
    ("tool_pose", 77, 41),
    ("jacobian", 93, 57),
    ("tool_jacobian", 93, 57),
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

/// Class of the inverse kinematics.
pub const IK_CLASS: &str = "7r-offset";
/// The geometry that makes it so.
pub const IK_REASON: &str = "axes 1-3 meet in one point, and so do the first two of the others; joint 7 is the redundancy";
/// Lines of the joints at `q = 0` in world axes, m, and the method of the inverse.
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
/// The tool frame in the last DH frame, m; nothing where the robot file has no tool.
pub const TOOL: ik::Displacement = ik::Displacement { rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], shift: [0.0, 0.0, 0.0] };
