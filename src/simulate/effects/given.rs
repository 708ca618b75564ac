//! An effect as it was written: see [`dh_codegen::robot::Given`].

pub use dh_codegen::robot::Given;
pub(crate) use dh_codegen::robot::RATED;
