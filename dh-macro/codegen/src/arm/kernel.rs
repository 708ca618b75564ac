//! Functions that are generated for each robot, with signatures and tapes.

use super::chain::{Group, Inputs};
use crate::sym::{Ex, Operand, Tape};

/// A quantity that can be generated or evaluated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Function {
    /// Top three rows of every DH frame's homogeneous matrix, `rows x 3 x 4`.
    Frames,
    /// Last DH frame, `3 x 4`.
    ForwardKinematics,
    /// Tool frame, `3 x 4`.
    ToolPose,
    /// Jacobian of the last DH frame's origin, `6 x n`, linear part first, world axes.
    Jacobian,
    /// Jacobian of the tool frame's origin, `6 x n`.
    ToolJacobian,
    /// Velocity-dependent acceleration `dJ/dt dq`, `6`.
    JacobianDotVelocity,
    /// Torques `tau` from standard parameters.
    InverseDynamics,
    /// Torques `tau` from base parameters.
    InverseDynamicsBase,
    /// Mass matrix `M`, `n x n`, from base parameters.
    MassMatrix,
    /// Coriolis and centrifugal torques `C dq` from base parameters.
    Coriolis,
    /// Gravity torques `g` from base parameters.
    Gravity,
    /// Accelerations `ddq` from base parameters.
    ForwardDynamics,
    /// Regressor `W`, `n x P`.
    Regressor,
    /// Base regressor `W_b`, `n x B`.
    BaseRegressor,
    /// Regressor `W` at rest, `n x P`.
    GravityRegressor,
    /// Kinetic energy regressor `h` with `T = h phi`, `P`.
    KineticEnergyRegressor,
    /// Potential energy regressor `h` with `U = h phi`, `P`.
    PotentialEnergyRegressor,
    /// Ten columns of a body in the tool frame, `n x 10`.
    PayloadRegressor,
    /// Torques `tau` of the bodies, rotors and plain friction, without the effects of the file.
    RigidDynamics,
    /// [`Function::InverseDynamics`] for given states of the drives: bristles and warmth.
    DriveTorques,
    /// [`Function::DriveTorques`] at given time and temperatures, for laws that depend on them.
    ClockedDriveTorques,
    /// Product with the transposed derivative of [`Function::BaseRegressor`] by `q`, `dq` and
    /// `ddq`, `3 x n`.
    BaseRegressorAdjoint,
    /// The same for [`Function::PayloadRegressor`].
    PayloadRegressorAdjoint,
    /// The same for [`Function::InverseDynamics`].
    InverseDynamicsAdjoint,
    /// The same for [`Function::Frames`].
    FramesAdjoint,
    /// The same for [`Function::ToolPose`].
    ToolPoseAdjoint,
}

impl Function {
    /// Functions of every robot, in the order of the generated crate. For those of a file with
    /// effects, see [`Function::WITH_EFFECTS`].
    pub const ALL: [Self; 18] = [
        Self::Frames,
        Self::ForwardKinematics,
        Self::ToolPose,
        Self::Jacobian,
        Self::ToolJacobian,
        Self::JacobianDotVelocity,
        Self::InverseDynamics,
        Self::InverseDynamicsBase,
        Self::MassMatrix,
        Self::Coriolis,
        Self::Gravity,
        Self::ForwardDynamics,
        Self::Regressor,
        Self::BaseRegressor,
        Self::GravityRegressor,
        Self::KineticEnergyRegressor,
        Self::PotentialEnergyRegressor,
        Self::PayloadRegressor,
    ];

    /// Additional functions if the file has effects (and [`Function::ClockedDriveTorques`] if a law
    /// depends on time or temperature).
    pub const WITH_EFFECTS: [Self; 2] = [Self::RigidDynamics, Self::DriveTorques];

    /// Functions generated on demand: derivatives for gradient-based planning or calibration.
    pub const ADJOINTS: [Self; 5] = [
        Self::BaseRegressorAdjoint,
        Self::PayloadRegressorAdjoint,
        Self::InverseDynamicsAdjoint,
        Self::FramesAdjoint,
        Self::ToolPoseAdjoint,
    ];

    /// For an adjoint: the function that it differentiates.
    pub fn primal(self) -> Option<Self> {
        match self {
            Self::BaseRegressorAdjoint => Some(Self::BaseRegressor),
            Self::PayloadRegressorAdjoint => Some(Self::PayloadRegressor),
            Self::InverseDynamicsAdjoint => Some(Self::InverseDynamics),
            Self::FramesAdjoint => Some(Self::Frames),
            Self::ToolPoseAdjoint => Some(Self::ToolPose),
            _ => None,
        }
    }

    /// Name in code and commands.
    pub fn name(self) -> &'static str {
        match self {
            Self::Frames => "frames",
            Self::ForwardKinematics => "forward_kinematics",
            Self::ToolPose => "tool_pose",
            Self::Jacobian => "jacobian",
            Self::ToolJacobian => "tool_jacobian",
            Self::JacobianDotVelocity => "jacobian_dot_velocity",
            Self::InverseDynamics => "inverse_dynamics",
            Self::InverseDynamicsBase => "inverse_dynamics_base",
            Self::MassMatrix => "mass_matrix",
            Self::Coriolis => "coriolis",
            Self::Gravity => "gravity",
            Self::ForwardDynamics => "forward_dynamics",
            Self::Regressor => "regressor",
            Self::BaseRegressor => "base_regressor",
            Self::GravityRegressor => "gravity_regressor",
            Self::KineticEnergyRegressor => "kinetic_energy_regressor",
            Self::PotentialEnergyRegressor => "potential_energy_regressor",
            Self::PayloadRegressor => "payload_regressor",
            Self::RigidDynamics => "rigid_dynamics",
            Self::DriveTorques => "drive_torques",
            Self::ClockedDriveTorques => "clocked_drive_torques",
            Self::BaseRegressorAdjoint => "base_regressor_adjoint",
            Self::PayloadRegressorAdjoint => "payload_regressor_adjoint",
            Self::InverseDynamicsAdjoint => "inverse_dynamics_adjoint",
            Self::FramesAdjoint => "frames_adjoint",
            Self::ToolPoseAdjoint => "tool_pose_adjoint",
        }
    }

    /// Arguments in the order of the signature.
    pub fn arguments(self) -> &'static [Argument] {
        use Argument::{
            Accelerations, BaseParameters, Bristles, Clock, Configuration, Seeds, StandardParameters, Torques,
            Velocities, Warmth,
        };
        match self {
            Self::Frames
            | Self::ForwardKinematics
            | Self::ToolPose
            | Self::Jacobian
            | Self::ToolJacobian
            | Self::GravityRegressor
            | Self::PotentialEnergyRegressor => &[Configuration],
            Self::JacobianDotVelocity | Self::KineticEnergyRegressor => &[Configuration, Velocities],
            Self::DriveTorques => &[Configuration, Velocities, Accelerations, StandardParameters, Bristles, Warmth],
            Self::ClockedDriveTorques => {
                &[Configuration, Velocities, Accelerations, StandardParameters, Bristles, Warmth, Clock]
            }
            Self::InverseDynamics | Self::RigidDynamics => {
                &[Configuration, Velocities, Accelerations, StandardParameters]
            }
            Self::InverseDynamicsBase => &[Configuration, Velocities, Accelerations, BaseParameters],
            Self::MassMatrix | Self::Gravity => &[Configuration, BaseParameters],
            Self::Coriolis => &[Configuration, Velocities, BaseParameters],
            Self::ForwardDynamics => &[Configuration, Velocities, Torques, BaseParameters],
            Self::Regressor | Self::BaseRegressor | Self::PayloadRegressor => {
                &[Configuration, Velocities, Accelerations]
            }
            Self::BaseRegressorAdjoint | Self::PayloadRegressorAdjoint => {
                &[Configuration, Velocities, Accelerations, Seeds]
            }
            Self::InverseDynamicsAdjoint => &[Configuration, Velocities, Accelerations, StandardParameters, Seeds],
            Self::FramesAdjoint | Self::ToolPoseAdjoint => &[Configuration, Seeds],
        }
    }
}

/// An argument of a generated function.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Argument {
    /// Sines, cosines and positions.
    Configuration,
    /// Velocities `dq`.
    Velocities,
    /// Accelerations `ddq`.
    Accelerations,
    /// Torques `tau`.
    Torques,
    /// Standard parameters `phi`.
    StandardParameters,
    /// Base parameters `beta`.
    BaseParameters,
    /// `bristle`: state of each joint, in [-1, 1]. They follow the standard parameters among the
    /// inputs.
    Bristles,
    /// `warmth`: factor of each joint's friction. They follow the bristles.
    Warmth,
    /// `clock`: time since the start, s, then the temperature of each joint, degrees C. They follow
    /// the warmth.
    Clock,
    /// `seed`: a weight for each entry of the differentiated function that is not structurally
    /// zero. They follow the standard parameters among the inputs.
    Seeds,
}

impl Argument {
    /// Groups of inputs in the argument.
    pub fn groups(self) -> &'static [Group] {
        match self {
            Self::Configuration => &[Group::Position, Group::Sine, Group::Cosine],
            Self::Velocities => &[Group::Velocity],
            Self::Accelerations => &[Group::Acceleration],
            Self::Torques => &[Group::Torque],
            Self::StandardParameters
            | Self::BaseParameters
            | Self::Bristles
            | Self::Warmth
            | Self::Clock
            | Self::Seeds => &[Group::Parameter],
        }
    }
}

/// A function with its tape.
#[derive(Debug, Clone, PartialEq)]
pub struct Kernel {
    /// Quantity that it computes.
    pub function: Function,
    /// Extents of the result, outermost first; the tape's outputs are row-major.
    pub shape: Vec<usize>,
    /// Indices of the inputs.
    pub inputs: Inputs,
    /// Program that computes the outputs.
    pub tape: Tape,
}

impl Kernel {
    pub(super) fn new(function: Function, inputs: Inputs, shape: Vec<usize>, roots: &[Ex<'_>]) -> Self {
        let tape = match roots.first() {
            Some(first) => Tape::new(first.graph(), roots),
            None => Tape::default(),
        };
        Self { function, shape, inputs, tape }
    }

    /// Number of joints whose sine or cosine is read.
    pub fn sines(&self) -> usize {
        let read = self.tape.code.iter().flat_map(|s| [s.a, s.b]).chain(self.tape.outputs.iter().copied());
        let joints: std::collections::BTreeSet<usize> = read
            .filter_map(|operand| match operand {
                Operand::Input(i) => Some(self.inputs.locate(i as usize)),
                _ => None,
            })
            .filter(|(group, _)| matches!(group, Group::Sine | Group::Cosine))
            .map(|(_, joint)| joint)
            .collect();
        joints.len()
    }

    /// Indices, in the row-major result, of outputs that are not structurally zero.
    pub fn nonzeros(&self) -> Vec<usize> {
        (0..self.tape.outputs.len()).filter(|&i| !self.tape.is_zero(i)).collect()
    }
}
