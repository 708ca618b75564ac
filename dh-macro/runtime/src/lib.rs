//! Runtime of generated robot code, and the traits that every robot implements: a controller, a
//! planner or a test is written once for all of them.
//!
//! No `std`, no allocation, no dependency without the feature `derive`. With it the crate of a user
//! needs one line in its `Cargo.toml`:
//!
//! ```toml
//! denavit-runtime = { version = "0.1", features = ["derive"] }
//! ```
//!
//! ```
//! use denavit_runtime::{Dynamics, Kinematics};
//!
//! /// Torques that hold an arm and push with `force`, N, at the tool.
//! fn push<R: Dynamics<N>, const N: usize>(
//!     robot: &R,
//!     q: &[f64; N],
//!     beta: &R::Base,
//!     force: [f64; 3],
//! ) -> [f64; N] {
//!     let (hold, jacobian) = (robot.gravity(q, beta), robot.tool_jacobian(q));
//!     core::array::from_fn(|k| hold[k] + (0..3).map(|i| jacobian[i][k] * force[i]).sum::<f64>())
//! }
//! ```
//!
//! `denavit generate --runtime crate` writes crates that depend on this one. All robots then share
//! one [`Pose`], one [`ik::Query`] and one [`ik::Solution`].

#![no_std]

pub use denavit_runtime_core::{drive, elementary, ik, robot, runtime};
pub use ik::{Query, Solution, Solutions};
pub use robot::{Description, Dynamics, InverseKinematics, Kinematics, Pose, Vector};

/// A robot from its DH table: `#[derive(DhRobot)] #[dh(file = "robots/my-arm.yaml")]`.
///
/// Beside the struct stands a module with its name in snake case, with the functions that
/// `denavit generate` writes. The struct implements the traits of [`robot`].
#[cfg(feature = "derive")]
pub use dh_macro::DhRobotOnRuntime as DhRobot;
