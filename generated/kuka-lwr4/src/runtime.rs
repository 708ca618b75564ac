//! What generated code needs beside itself: a scalar, sines and cosines, packs of states. Shipped along verbatim.

mod pack;
mod scalar;
mod sincos;

pub use pack::Pack;
pub use scalar::Scalar;
