//! Reports of the `identify` command.

pub(crate) mod consistent;
pub(crate) mod json;
pub(crate) mod page;
pub(crate) mod text;
