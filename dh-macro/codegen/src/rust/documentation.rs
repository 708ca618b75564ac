//! Doc comments of the generated functions: a title, and shape, unit and source.

use crate::arm::Function;

/// Title and meaning of a function.
type Doc = (&'static str, &'static str);

const FRAMES: Doc = (
    "DH frames of all rows in the world frame",
    "`out[i]` is the top three rows of the homogeneous matrix `T(0, i+1)`, m and one. Khalil and Dombre, 3.2.",
);
const FORWARD_KINEMATICS: Doc = (
    "The last DH frame in the world frame",
    "`out` is the top three rows of `T(0, n)`: axes of the frame as columns, then its origin, m. Khalil and Dombre, 3.2.",
);
const TOOL_POSE: Doc = (
    "The tool frame in the world frame",
    "Like `forward_kinematics`, followed by the tool's pose (the identity where the robot file has no tool).",
);
const JACOBIAN: Doc = (
    "Jacobian of the last DH frame's origin, in world axes",
    "`(v, w) = J dq`: rows 0-2 linear, m/s, rows 3-5 angular, rad/s. Khalil and Dombre, 5.2.",
);
const TOOL_JACOBIAN: Doc = (
    "Jacobian of the tool frame's origin, in world axes",
    "`(v, w) = J dq` as in `jacobian`; `tau = J' f` are the torques of a wrench on the tool. Khalil and Dombre, 5.2.",
);
const JACOBIAN_DOT_VELOCITY: Doc = (
    "Acceleration of the last DH frame at zero `ddq`: `dJ/dt dq`",
    "In world axes; entries 0-2 linear, m/s^2, 3-5 angular, rad/s^2. Khalil and Dombre, 5.10.",
);
const INVERSE_DYNAMICS: Doc = (
    "Torques from the standard parameters",
    "`tau = M ddq + C dq + g + friction`, N m, of the actuators on the links. Newton-Euler, Khalil and Dombre, 9.5.2.",
);
const INVERSE_DYNAMICS_BASE: Doc = (
    "Torques from the base parameters",
    "`tau = W_b beta`, N m, without forming `W_b`. Newton-Euler with the regrouped parameters, Khalil and Dombre, 9.6.",
);
const MASS_MATRIX: Doc = (
    "Mass matrix `M`, symmetric, kg m^2",
    "From the base parameters, rotors on the diagonal, by composite bodies. Featherstone, 6.2.",
);
const CORIOLIS: Doc =
    ("Coriolis and centrifugal torques `C dq`", "N m, from the base parameters; no gravity, no friction.");
const GRAVITY: Doc = ("Gravity torques `g`", "N m, from the base parameters: the torques that hold the arm at rest.");
const FORWARD_DYNAMICS: Doc = (
    "Accelerations under given torques",
    "`ddq = M^-1 (tau - C dq - g - friction)`, rad/s^2, from the base parameters; `M = L D L'` in closed form.",
);
const REGRESSOR: Doc = (
    "Regressor `W` of the standard parameters",
    "`tau = W phi`, row j in N m per unit of each parameter; columns as in `STANDARD_NAMES`. Khalil and Dombre, 12.4.",
);
const BASE_REGRESSOR: Doc = (
    "Regressor `W_b` of the base parameters",
    "`tau = W_b beta`, row j in N m per unit of each parameter; columns as in `BASE_NAMES`. Khalil and Dombre, 12.4.",
);
const GRAVITY_REGRESSOR: Doc = (
    "Regressor at rest",
    "`g = W_g phi` of the links' parameters; columns as the first of `STANDARD_NAMES`, without the drives'.",
);
const KINETIC_ENERGY_REGRESSOR: Doc =
    ("Kinetic energy, one entry per standard parameter", "`T = h phi`, J per unit. Khalil and Dombre, 9.4.");
const POTENTIAL_ENERGY_REGRESSOR: Doc = (
    "Potential energy, one entry per standard parameter",
    "`U = h phi`, J per unit, zero at the world frame's origin; an offset torque counts as `FO q`.",
);
const PAYLOAD_REGRESSOR: Doc = (
    "Regressor of a body fixed to the tool frame",
    "`tau = W_L phi_L`, columns `M MSX MSY MSZ XX YY ZZ XY XZ YZ` in the tool frame, about its origin. Katsumata et al. 2019, (7).",
);
const RIGID_DYNAMICS: Doc = (
    "Torques of the bodies, rotors and plain friction, without the effects of the file",
    "`tau = M ddq + C dq + g + friction`, N m, from the standard parameters. Newton-Euler, Khalil and Dombre, 9.5.2.",
);
const DRIVE_TORQUES: Doc = (
    "Torques at the sensors for given states of the drives",
    "Like `inverse_dynamics`, N m. `bristle` replaces the sign of the velocity in friction with memory, in [-1, 1]. `warmth` is the factor of each joint's friction that drifts. `Drive` integrates both.",
);
const CLOCKED_DRIVE_TORQUES: Doc = (
    "Torques at the sensors for given states of the drives, at a time and at temperatures",
    "Like `drive_torques`, N m, in which the motion has just begun and joints have the temperature at which nothing changes. `clock` is the time since the start, s, then the temperature of each joint, degrees C: laws of the robot file ask for them.",
);
const WITH_EFFECTS: Doc = (
    "Torques at the sensors from the standard parameters, with the effects of the robot file",
    "`tau = GT clip(M ddq + C dq + g + drives) + TO`, N m. The drives' laws enter as steady curves: friction with memory has slipped, gears are warm. `Drive` has their memory; `TIME_DELAY` is the delay of the sensors.",
);
const BASE_REGRESSOR_ADJOINT: Doc = (
    "Derivative of a weighted sum of the base regressor's entries",
    "`out = sum of seed[k] d(entry k)/d(q, dq, ddq)`, one row each; `entry k` stands at `kernel::base_regressor::PATTERN[k]`. The sign of a velocity has derivative zero. Griewank and Walther, 3.2.",
);
const PAYLOAD_REGRESSOR_ADJOINT: Doc = (
    "Derivative of a weighted sum of the payload regressor's entries",
    "`out = sum of seed[k] d(entry k)/d(q, dq, ddq)`, one row each; `entry k` stands at `kernel::payload_regressor::PATTERN[k]`. Griewank and Walther, 3.2.",
);
const INVERSE_DYNAMICS_ADJOINT: Doc = (
    "Derivative of a weighted sum of the torques",
    "`out = sum of seed[j] d(tau_j)/d(q, dq, ddq)`, one row each. The sign of a velocity has derivative zero. Griewank and Walther, 3.2.",
);
const FRAMES_ADJOINT: Doc = (
    "Derivative of a weighted sum of the frames' entries",
    "`out = sum of seed[k] d(entry k)/d(q, dq, ddq)`, one row each (only the first is not zero); `entry k` stands at `kernel::frames::PATTERN[k]`. Heights and distances of points on the arm are such sums. Griewank and Walther, 3.2.",
);
const TOOL_POSE_ADJOINT: Doc = (
    "Derivative of a weighted sum of the tool frame's entries",
    "`out = sum of seed[k] d(entry k)/d(q, dq, ddq)`, one row each (only the first is not zero); entries row-major without the structural zeros. Griewank and Walther, 3.2.",
);

/// Title and meaning of a function; `effects`: whether the robot file has effects.
pub(super) fn doc(function: Function, effects: bool) -> Doc {
    match function {
        Function::Frames => FRAMES,
        Function::ForwardKinematics => FORWARD_KINEMATICS,
        Function::ToolPose => TOOL_POSE,
        Function::Jacobian => JACOBIAN,
        Function::ToolJacobian => TOOL_JACOBIAN,
        Function::JacobianDotVelocity => JACOBIAN_DOT_VELOCITY,
        Function::InverseDynamics if effects => WITH_EFFECTS,
        Function::InverseDynamics => INVERSE_DYNAMICS,
        Function::InverseDynamicsBase => INVERSE_DYNAMICS_BASE,
        Function::MassMatrix => MASS_MATRIX,
        Function::Coriolis => CORIOLIS,
        Function::Gravity => GRAVITY,
        Function::ForwardDynamics => FORWARD_DYNAMICS,
        Function::Regressor => REGRESSOR,
        Function::BaseRegressor => BASE_REGRESSOR,
        Function::GravityRegressor => GRAVITY_REGRESSOR,
        Function::KineticEnergyRegressor => KINETIC_ENERGY_REGRESSOR,
        Function::PotentialEnergyRegressor => POTENTIAL_ENERGY_REGRESSOR,
        Function::PayloadRegressor => PAYLOAD_REGRESSOR,
        Function::RigidDynamics => RIGID_DYNAMICS,
        Function::DriveTorques => DRIVE_TORQUES,
        Function::ClockedDriveTorques => CLOCKED_DRIVE_TORQUES,
        Function::BaseRegressorAdjoint => BASE_REGRESSOR_ADJOINT,
        Function::PayloadRegressorAdjoint => PAYLOAD_REGRESSOR_ADJOINT,
        Function::InverseDynamicsAdjoint => INVERSE_DYNAMICS_ADJOINT,
        Function::FramesAdjoint => FRAMES_ADJOINT,
        Function::ToolPoseAdjoint => TOOL_POSE_ADJOINT,
    }
}
