//! Reports of the `excite` command.

pub(crate) mod motion_check;
pub(crate) mod page;
pub(crate) mod saved;
pub(crate) mod text;
