//! Parameters of `planar2r`: sizes, names, limits, values of its file. SI units.

use super::ik;

/// Name of the robot.
pub const NAME: &str = "planar2r";
/// Degrees of freedom.
pub const DOF: usize = 2;
/// Rows of the DH table, fixed ones too.
pub const ROWS: usize = 2;
/// Standard parameters: ten per row, then the drives'.
pub const STANDARD: usize = 24;
/// Base parameters.
pub const BASE: usize = 10;
/// Gravity in the world frame, m/s^2.
pub const GRAVITY: [f64; 3] = [0.0, -9.81, 0.0];

/// Joints, in the order of `q`.
pub const JOINT_NAMES: [&str; DOF] = [
    "shoulder", "elbow",
];
/// Standard parameters, in the order of the regressor's columns (SI; tensors about the frame's
/// origin).
pub const STANDARD_NAMES: [&str; STANDARD] = [
    "M1", "MSX1", "MSY1", "MSZ1", "XX1", "YY1", "ZZ1", "XY1", "XZ1", "YZ1",
    "M2", "MSX2", "MSY2", "MSZ2", "XX2", "YY2", "ZZ2", "XY2", "XZ2", "YZ2",
    "FV1", "FV2", "FC1", "FC2",
];
/// Base parameters, in the order of the base regressor's columns.
pub const BASE_NAMES: [&str; BASE] = [
    "MSX1R", "MSY1", "ZZ1R", "MSX2", "MSY2", "ZZ2", "FV1", "FV2", "FC1", "FC2",
];
/// Base parameters in closed form, in the constants of the robot file; a name alone groups nothing.
pub const BASE_GROUPINGS: [&str; BASE] = [
    "MSX1R = MSX1 + L1*M2",
    "MSY1",
    "ZZ1R = ZZ1 + L1^2*M2",
    "MSX2",
    "MSY2",
    "ZZ2",
    "FV1",
    "FV2",
    "FC1",
    "FC2",
];
/// The same as numbers: index into the standard parameters, and factor.
pub const BASE_COEFFICIENTS: [&[(usize, f64)]; BASE] = {
    use super::constants::*;
    [
        &[(1, 1.0), (10, L1)],
        &[(2, 1.0)],
        &[(6, 1.0), (10, L1 * L1)],
        &[(11, 1.0)],
        &[(12, 1.0)],
        &[(16, 1.0)],
        &[(20, 1.0)],
        &[(21, 1.0)],
        &[(22, 1.0)],
        &[(23, 1.0)],
    ]
};

/// Lower and upper position of each joint, rad or m.
pub const POSITION_LIMITS: [Option<[f64; 2]>; DOF] = [
    Some([-2.9670597283903604, 2.9670597283903604]), Some([-2.6179938779914944, 2.6179938779914944]),
];
/// Largest speeds, rad/s or m/s.
pub const VELOCITY_LIMITS: [Option<f64>; DOF] = [
    Some(3.141592653589793), Some(3.141592653589793),
];
/// Largest accelerations, rad/s^2 or m/s^2.
pub const ACCELERATION_LIMITS: [Option<f64>; DOF] = [
    Some(10.471975511965978), Some(10.471975511965978),
];
/// Largest torques or forces, N m or N.
pub const TORQUE_LIMITS: [Option<f64>; DOF] = [
    Some(20.0), Some(8.0),
];
/// Standard parameters of the robot file, its tool in the last link.
pub const STANDARD_VALUES: Option<[f64; STANDARD]> = Some([
    0.5, 0.125, 0.0, 0.0, 0.0, 0.041666666666666664, 0.041666666666666664, 0.0, 0.0, 0.0, // M1 to YZ1
    0.4, 0.08000000000000002, 0.0, 0.0, 0.0, 0.02133333333333334, 0.02133333333333334, 0.0, 0.0, 0.0, // M2 to YZ2
    0.1, 0.05, 0.2, 0.1, // FV1 to FC2
]);

/// Name, multiplications and additions of each function; sines and cosines apart (`DOF` pairs).
pub const OPERATIONS: [(&str, usize, usize); 18] = [
    ("frames", 6, 4),
    ("forward_kinematics", 6, 3),
    ("tool_pose", 8, 5),
    ("jacobian", 2, 1),
    ("tool_jacobian", 8, 6),
    ("jacobian_dot_velocity", 12, 5),
    ("inverse_dynamics", 29, 21),
    ("inverse_dynamics_base", 27, 19),
    ("mass_matrix", 4, 5),
    ("coriolis", 12, 4),
    ("gravity", 10, 5),
    ("forward_dynamics", 35, 23),
    ("regressor", 18, 12),
    ("base_regressor", 16, 11),
    ("gravity_regressor", 10, 5),
    ("kinetic_energy_regressor", 12, 3),
    ("potential_energy_regressor", 9, 2),
    ("payload_regressor", 21, 15),
];

/// Class of the inverse kinematics.
pub const IK_CLASS: &str = "planar";
/// The geometry that makes it so.
pub const IK_REASON: &str = "all turning axes are parallel, everything moves in one plane";
/// Lines of the joints at `q = 0` in world axes, m, and the method of the inverse.
pub const IK: ik::Arm<DOF> = ik::Arm {
    axes: [
        ik::Axis { slides: false, h: [0.0, 0.0, 1.0], c: [0.0, 0.0, 0.0] },
        ik::Axis { slides: false, h: [0.0, 0.0, 1.0], c: [0.5, 0.0, 0.0] },
    ],
    home: ik::Displacement { rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], shift: [0.5, 0.0, 0.0] },
    limits: POSITION_LIMITS,
    exact: true,
    family: ik::Family::Plane(ik::Plane {
        h: [0.0, 0.0, 1.0],
        axes: [
            ik::Axis { slides: false, h: [0.0, 0.0, 1.0], c: [0.0, 0.0, 0.0] },
            ik::Axis { slides: false, h: [0.0, 0.0, 1.0], c: [0.5, 0.0, 0.0] },
            ik::Axis { slides: false, h: [0.0, 0.0, 1.0], c: [1.0, 0.5, 0.0] },
        ],
        joints: [Some(0), Some(1), None],
        lift: None,
    }),
};
/// The tool frame in the last DH frame, m; nothing where the robot file has no tool.
pub const TOOL: ik::Displacement = ik::Displacement { rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-0.0, 0.0, 1.0]], shift: [0.4, 0.0, 0.0] };
