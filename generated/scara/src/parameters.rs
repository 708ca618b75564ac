//! Parameters of `scara`: sizes, names, limits, values of its file. SI units.

use super::ik;

/// Name of the robot.
pub const NAME: &str = "scara";
/// Degrees of freedom.
pub const DOF: usize = 4;
/// Rows of the DH table, fixed ones too.
pub const ROWS: usize = 4;
/// Standard parameters: ten per row, then the drives'.
pub const STANDARD: usize = 40;
/// Base parameters.
pub const BASE: usize = 8;
/// Gravity in the world frame, m/s^2.
pub const GRAVITY: [f64; 3] = [0.0, 0.0, -9.81];

/// Joints, in the order of `q`.
pub const JOINT_NAMES: [&str; DOF] = [
    "shoulder", "elbow", "stroke", "hand",
];
/// Standard parameters, in the order of the regressor's columns (SI; tensors about the frame's
/// origin).
pub const STANDARD_NAMES: [&str; STANDARD] = [
    "M1", "MSX1", "MSY1", "MSZ1", "XX1", "YY1", "ZZ1", "XY1", "XZ1", "YZ1",
    "M2", "MSX2", "MSY2", "MSZ2", "XX2", "YY2", "ZZ2", "XY2", "XZ2", "YZ2",
    "M3", "MSX3", "MSY3", "MSZ3", "XX3", "YY3", "ZZ3", "XY3", "XZ3", "YZ3",
    "M4", "MSX4", "MSY4", "MSZ4", "XX4", "YY4", "ZZ4", "XY4", "XZ4", "YZ4",
];
/// Base parameters, in the order of the base regressor's columns.
pub const BASE_NAMES: [&str; BASE] = [
    "ZZ1R", "MSX2R", "MSY2R", "ZZ2R", "M3R", "MSX4", "MSY4", "ZZ4",
];
/// Base parameters in closed form, in the constants of the robot file; a name alone groups nothing.
pub const BASE_GROUPINGS: [&str; BASE] = [
    "ZZ1R = ZZ1 + L1^2*M2",
    "MSX2R = MSX2 + MSX3",
    "MSY2R = MSY2 - MSY3",
    "ZZ2R = ZZ2 + 2*L2*MSX3 + ZZ3",
    "M3R = M3 + M4",
    "MSX4",
    "MSY4",
    "ZZ4",
];
/// The same as numbers: index into the standard parameters, and factor.
pub const BASE_COEFFICIENTS: [&[(usize, f64)]; BASE] = {
    use super::constants::*;
    [
        &[(6, 1.0), (10, L1 * L1)],
        &[(11, 1.0), (21, 1.0)],
        &[(12, 1.0), (22, -1.0)],
        &[(16, 1.0), (21, 2.0 * L2), (26, 1.0)],
        &[(20, 1.0), (30, 1.0)],
        &[(31, 1.0)],
        &[(32, 1.0)],
        &[(36, 1.0)],
    ]
};

/// Lower and upper position of each joint, rad or m.
pub const POSITION_LIMITS: [Option<[f64; 2]>; DOF] = [
    Some([-2.2689280275926285, 2.2689280275926285]), Some([-2.530727415391778, 2.530727415391778]), Some([0.0, 0.2]), Some([-6.283185307179586, 6.283185307179586]),
];
/// Largest speeds, rad/s or m/s.
pub const VELOCITY_LIMITS: [Option<f64>; DOF] = [
    Some(6.981317007977318), Some(10.471975511965978), Some(1.1), Some(26.179938779914945),
];
/// Largest accelerations, rad/s^2 or m/s^2.
pub const ACCELERATION_LIMITS: [Option<f64>; DOF] = [
    None, None, None, None,
];
/// Largest torques or forces, N m or N.
pub const TORQUE_LIMITS: [Option<f64>; DOF] = [
    None, None, None, None,
];
/// Standard parameters of the robot file, its tool in the last link.
pub const STANDARD_VALUES: Option<[f64; STANDARD]> = Some([
    9.0, 1.95, 0.0, 0.24, 0.036425, 0.6013375, 0.5817125, 0.0, -0.078, 0.0, // M1 to YZ1
    8.0, 0.9875, 0.0, 0.97, 0.156091666667, 0.342864583333, 0.202822916667, 0.0, -0.112, 0.0, // M2 to YZ2
    1.0, 0.0, 0.0, -0.35, 0.123008333333, 0.123241666667, 0.000833333333333, 0.0, 0.0, 0.0, // M3 to YZ3
    1.0, 0.0, 0.0, -0.2, 0.0533583333333, 0.0533583333333, 5e-5, 0.0, 0.0, 0.0, // M4 to YZ4
]);

/// Name, multiplications and additions of each function; sines and cosines apart (`DOF` pairs).
pub const OPERATIONS: [(&str, usize, usize); 18] = [
    ("frames", 12, 11),
    ("forward_kinematics", 12, 8),
    ("tool_pose", 12, 8),
    ("jacobian", 8, 6),
    ("tool_jacobian", 8, 6),
    ("jacobian_dot_velocity", 22, 10),
    ("inverse_dynamics", 52, 42),
    ("inverse_dynamics_base", 41, 30),
    ("mass_matrix", 17, 19),
    ("coriolis", 29, 17),
    ("gravity", 1, 1),
    ("forward_dynamics", 72, 50),
    ("regressor", 43, 35),
    ("base_regressor", 34, 26),
    ("gravity_regressor", 0, 0),
    ("kinetic_energy_regressor", 28, 11),
    ("potential_energy_regressor", 1, 1),
    ("payload_regressor", 34, 24),
];

/// Class of the inverse kinematics.
pub const IK_CLASS: &str = "scara";
/// The geometry that makes it so.
pub const IK_REASON: &str = "all turning axes are parallel, one joint slides along or across them";
/// Lines of the joints at `q = 0` in world axes, m, and the method of the inverse.
pub const IK: ik::Arm<DOF> = ik::Arm {
    axes: [
        ik::Axis { slides: false, h: [0.0, 0.0, 1.0], c: [0.0, 0.0, 0.4] },
        ik::Axis { slides: false, h: [0.0, 0.0, 1.0], c: [0.325, 0.0, 0.4] },
        ik::Axis { slides: true, h: [0.0, 0.0, -1.0], c: [0.6000000000000001, 0.0, 0.4] },
        ik::Axis { slides: false, h: [0.0, 0.0, -1.0], c: [0.6000000000000001, 0.0, 0.4] },
    ],
    home: ik::Displacement { rotation: [[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, -1.0]], shift: [0.6000000000000001, 0.0, 0.4] },
    limits: POSITION_LIMITS,
    exact: true,
    family: ik::Family::Plane(ik::Plane {
        h: [0.0, 0.0, 1.0],
        axes: [
            ik::Axis { slides: false, h: [0.0, 0.0, 1.0], c: [0.0, 0.0, 0.4] },
            ik::Axis { slides: false, h: [0.0, 0.0, 1.0], c: [0.325, 0.0, 0.4] },
            ik::Axis { slides: false, h: [0.0, 0.0, -1.0], c: [0.6000000000000001, 0.0, 0.4] },
        ],
        joints: [Some(0), Some(1), Some(3)],
        lift: Some((ik::Axis { slides: true, h: [0.0, 0.0, -1.0], c: [0.6000000000000001, 0.0, 0.4] }, 2, 2)),
    }),
};
/// The tool frame in the last DH frame, m; nothing where the robot file has no tool.
pub const TOOL: ik::Displacement = ik::Displacement { rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], shift: [0.0, 0.0, 0.0] };
