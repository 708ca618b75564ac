//! What `denavit import` reports.

pub mod json;
pub mod text;
