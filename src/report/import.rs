//! Report of `denavit import`.

pub mod json;
pub mod text;
