//! Reports of the `simulate` command.

pub(crate) mod json;
pub(crate) mod text;
