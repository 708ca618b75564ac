//! Reports of `log inspect` and `log convert`.

pub(crate) mod json;
pub(crate) mod text;
