//! The `force` verb's results.

pub(crate) mod json;
pub(crate) mod page;
pub(crate) mod text;
