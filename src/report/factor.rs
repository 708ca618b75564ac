//! Report of `denavit factor`.

pub mod json;
pub mod table;
pub mod text;
