//! The `check` verb's results.

pub mod json;
pub mod text;
