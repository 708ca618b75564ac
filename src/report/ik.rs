//! Reports of the `ik` command.

pub mod json;
pub mod text;
