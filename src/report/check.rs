//! Reports of the `check` command.

pub mod json;
pub mod text;
