//! From a robot's DH table to closed-form Rust, and from a recorded motion to an identified model.
//!
//! `YAML -> robot -> tapes -> Arm`, and `log -> signal -> identify -> report`:
//!
//! ```
//! use denavit::model::{Arm, States};
//! use denavit::model::interpreted::Interpreted;
//! use denavit::robot::{Robot, no_files};
//!
//! let text = "
//! name: pendulum
//! convention: modified
//! gravity: [0, -9.81, 0]
//! joints: [ { type: revolute } ]
//! links: [ { M: 2, MS: [1, 0, 0], I: [0, 0.5, 0.5, 0, 0, 0] } ]
//! ";
//! let robot = Robot::from_yaml(text, &no_files)?.robot;
//! let arm = Interpreted::new(&robot, &[]);
//! let names: Vec<&str> = arm.base_parameters().iter().map(|b| b.name.as_str()).collect();
//! assert_eq!(names, ["MSX1", "MSY1", "ZZ1"]);
//!
//! // Held level, a kilogram metre weighs 9.81 N m.
//! let level = States { len: 1, q: vec![0.0], dq: vec![0.0], ddq: vec![0.0] };
//! let mut tau = [0.0];
//! arm.inverse_dynamics(&level, &[2.0, 1.0, 0.0, 0.0, 0.0, 0.5, 0.5, 0.0, 0.0, 0.0], &mut tau);
//! assert!((tau[0] - 9.81).abs() < 1e-12);
//! # Ok::<(), denavit::robot::Problems>(())
//! ```

pub mod apps;
#[cfg(feature = "cli")]
pub mod cli;
pub mod control;
pub mod data;
pub mod diagnose;
pub mod exchange;
pub mod excite;
pub mod identify;
pub mod model;
pub mod numerics;
pub mod report;
pub mod simulate;

/// Robot files and symbolic robots: [`Robot::open`](robot::Robot::open). Re-exported, so that a
/// user names one dependency.
pub use dh_codegen::robot;
