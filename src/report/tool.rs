//! Reports of the `tool` command.

pub(crate) mod json;
pub(crate) mod page;
pub(crate) mod text;
