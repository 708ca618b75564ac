//! Reports of the `paint` command.

pub(crate) mod page;
pub(crate) mod run;
pub(crate) mod run_page;
pub(crate) mod saved;
pub(crate) mod text;
pub(crate) mod trace;
