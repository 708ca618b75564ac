//! From a robot's DH table to closed-form, straight-line Rust.
//!
//! `YAML -> robot (validated, exact angles) -> sym (hash-consed graph) -> arm (sweeps, regressor,
//! base) -> tape -> rust (text) | sym::eval (runs it)`
//!
//! ```
//! use dh_codegen::robot::{Robot, no_files};
//!
//! let text = "
//! name: pendulum
//! convention: modified
//! gravity: [0, -9.81, 0]
//! joints: [ { type: revolute } ]
//! ";
//! let robot = Robot::from_yaml(text, &no_files)?.robot;
//! let files = dh_codegen::krate(&robot, text);
//! assert!(files["src/parameters.rs"].contains("pub const DOF: usize = 1;"));
//! # Ok::<(), dh_codegen::robot::Problems>(())
//! ```

pub mod arm;
pub mod interpret;
pub mod pullback;
pub mod robot;
pub mod rust;
pub mod sym;

pub use denavit_runtime_core::{drive, elementary, ik, runtime};
pub use rust::krate::{Runtime, krate, krate_on, krate_with};
pub use rust::manifest::{MARK, listed};
pub use rust::module::{Module, module, module_on};
