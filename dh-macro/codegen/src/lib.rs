//! From a robot's DH table to closed-form, straight-line Rust.
//!
//! `YAML -> robot (validated, exact angles) -> sym (hash-consed graph) -> arm (sweeps, regressor, base)
//! -> tape -> rust (text) | sym::eval (runs it)`

pub mod arm;
pub mod ik;
pub mod interpret;
pub mod pullback;
pub mod robot;
pub mod runtime;
pub mod rust;
pub mod sym;

pub use rust::krate::krate;
pub use rust::module::module;
