//! Reports of the `force` command.

pub(crate) mod json;
pub(crate) mod page;
pub(crate) mod text;
