//! Report of the `eval` command.

pub mod json;
