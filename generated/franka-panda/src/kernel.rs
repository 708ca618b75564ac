//! Kernels: additions and multiplications only, given the sines and cosines. One file per function.

pub mod base_regressor;
pub mod coriolis;
pub mod forward_dynamics;
pub mod forward_kinematics;
pub mod frames;
pub mod gravity;
pub mod gravity_regressor;
pub mod inverse_dynamics;
pub mod inverse_dynamics_base;
pub mod jacobian;
pub mod jacobian_dot_velocity;
pub mod kinetic_energy_regressor;
pub mod mass_matrix;
pub mod payload_regressor;
pub mod potential_energy_regressor;
pub mod regressor;
pub mod tool_jacobian;
pub mod tool_pose;
