//! What generated robot code runs on: scalars and register packs ([`runtime`]), drive laws ([`drive`]) and inverse kinematics ([`ik`]).
//!
//! No `std`, no allocation, no dependency. Generated crates carry a copy of these modules, so they need nothing; who works with many
//! robots depends on this crate and has one type of pose and of solution for all.

#![no_std]

pub mod drive;
pub mod elementary;
// A negated comparison is true of NaN too, and is meant to be; a reference to a closure is a type like any other.
#[allow(clippy::neg_cmp_op_on_partial_ord, clippy::type_complexity)]
pub mod ik;
pub mod runtime;
#[cfg(feature = "sources")]
pub mod sources;
