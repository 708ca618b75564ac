//! Tapes as Rust text, with comments: kernels, the shell around them, whole crates. Knows no
//! mechanics.

mod drive;
mod inverse;
pub mod kernel_file;
pub mod krate;
pub mod module;
mod names;
mod print;
mod shell;
mod tests_file;
mod words;
