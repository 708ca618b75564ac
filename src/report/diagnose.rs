//! Reports of the `diagnose` command.

pub(crate) mod calibrate;
mod doubts;
pub(crate) mod json;
pub(crate) mod next_experiment;
pub(crate) mod page;
pub(crate) mod text;
pub(crate) mod written;
