//! Runtime of generated code: a scalar, sines and cosines, packs of states. Shipped along verbatim.

// A robot whose postures need no blocks, and a derived one, leave some of it unused.
#[allow(dead_code)]
mod block;
#[cfg(feature = "dispatch")]
pub mod dispatch;
mod pack;
mod registers;
mod scalar;
mod sincos;

pub use block::Block;
pub use pack::{Pack, square_root};
pub use scalar::{Scalar, apart, clear};
