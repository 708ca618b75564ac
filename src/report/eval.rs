//! The `eval` verb's results.

pub mod json;
