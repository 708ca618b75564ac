//! From a robot's DH table to closed-form, straight-line Rust.
//!
//! `YAML -> robot (validated, exact angles) -> sym (hash-consed graph) -> arm (sweeps, regressor, base)
//! -> tape -> rust (text) | sym::eval (runs it)`

pub mod arm;
pub mod drive;
pub mod elementary;
// A negated comparison is true of NaN too, and is meant to be; a reference to a closure is a type like any other.
#[allow(clippy::neg_cmp_op_on_partial_ord, clippy::type_complexity)]
pub mod ik;
pub mod interpret;
pub mod pullback;
pub mod robot;
pub mod runtime;
pub mod rust;
pub mod sym;

pub use rust::krate::{MARK, krate, krate_with};
pub use rust::module::module;
