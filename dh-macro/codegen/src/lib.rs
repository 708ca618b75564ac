//! From a robot's DH table to closed-form, straight-line Rust.
//!
//! `YAML -> robot (validated, exact angles) -> sym (hash-consed graph) -> arm (sweeps, regressor,
//! base) -> tape -> rust (text) | sym::eval (runs it)`

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
