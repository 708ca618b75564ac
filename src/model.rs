//! Traits of an arm, and their implementations: interpreted tapes, rigid-body recursions, edited
//! robot files.

pub mod arm;
pub mod coupled;
pub mod differentiable;
pub mod differentiated;
pub mod drives_alone;
pub mod dynamics;
pub(crate) mod far_end;
pub mod file_torque_model;
pub mod frame_kinematics;
pub mod interpreted;
pub mod inverse_kinematics;
pub(crate) mod likely_bodies;
pub mod link_extents;
pub mod parameter;
pub mod payload;
pub mod perturbable;
pub mod perturbable_robot;
pub(crate) mod pseudo_inertia;
pub mod rigid_body;
pub mod robot_edit;
pub mod torque_model;
pub(crate) mod walls;

pub use arm::{Arm, BaseParameter, Description, States, SummedSign, VelocitySum};
pub use dh_codegen::arm::param::{DriveTerm, Inertial};
pub use differentiable::{Differentiable, Gradient};
pub use dynamics::{Dynamics, ToolState};
pub use frame_kinematics::FrameKinematics;
pub use link_extents::LinkExtents;
pub use parameter::StandardParameter;
pub use payload::Payload;
pub use perturbable::{Change, Contact, LikelyBodies, PerturbableArm};
pub use torque_model::TorqueModel;
