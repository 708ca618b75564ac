//! The `simulate` verb's results.

pub(crate) mod json;
pub(crate) mod text;
