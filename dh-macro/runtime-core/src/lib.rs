//! Modules that generated robot code runs on: scalars and register packs ([`runtime`]), drive laws
//! ([`drive`]), inverse kinematics ([`ik`]), and the traits that every robot implements
//! ([`robot`]).
//!
//! ```
//! use denavit_runtime_core::runtime::{Pack, Scalar};
//!
//! /// Height of a pendulum of 0.5 m, for one angle, rad, or for eight.
//! fn height<S: Scalar>(q: S) -> S {
//!     let (sin, _) = S::sin_cos_all(&[q]);
//!     sin[0] * S::constant(0.5)
//! }
//!
//! let angles: [f64; 8] = core::array::from_fn(|k| 0.1 * k as f64);
//! let eight = height(Pack::new(angles)).to_array();
//! assert!(angles.iter().zip(eight).all(|(&q, h)| height(q) == h));
//! ```
//!
//! No `std`, no allocation, no dependency. Use them through the crate `denavit-runtime`. They stand
//! apart because the generator ships their text and the macro, which `denavit-runtime` passes on,
//! is built with the generator.

#![no_std]

#[cfg(feature = "dispatch")]
extern crate std;

pub mod drive;
pub mod elementary;
// A negated comparison is true of NaN too, and is meant to be; a reference to a closure is a type
// like any other.
#[allow(clippy::neg_cmp_op_on_partial_ord, clippy::type_complexity)]
pub mod ik;
pub mod robot;
pub mod runtime;
#[cfg(feature = "sources")]
pub mod sources;
