//! Effects beyond the rigid body, one file each: their laws in the simulated robot.
//!
//! Names, keys and defaults are in [`dh_codegen::robot::effects`]. Effects that change geometry or
//! bodies are in [`dh_codegen::robot::Robot::change`].

mod asymmetric_friction;
mod backlash;
mod closed_form;
mod coulomb_friction;
mod friction_drift;
mod gear_coupling;
mod joint_elasticity;
mod joint_spring;
mod load_dependent_friction;
mod nonlinear_viscous_friction;
mod position_dependent_friction;
mod presliding_hysteresis;
mod stribeck_friction;
mod torque_ripple;

pub(super) mod external_contact;

pub use asymmetric_friction::AsymmetricFriction;
pub use backlash::Backlash;
pub use closed_form::{ClosedForm, Moment};
pub use coulomb_friction::CoulombFriction;
pub use external_contact::ExternalContact;
pub use friction_drift::FrictionDrift;
pub use gear_coupling::GearCoupling;
pub use joint_elasticity::JointElasticity;
pub use joint_spring::JointSpring;
pub use load_dependent_friction::LoadDependentFriction;
pub use nonlinear_viscous_friction::NonlinearViscousFriction;
pub use position_dependent_friction::PositionDependentFriction;
pub use presliding_hysteresis::PreslidingHysteresis;
pub use stribeck_friction::StribeckFriction;
pub use torque_ripple::TorqueRipple;
