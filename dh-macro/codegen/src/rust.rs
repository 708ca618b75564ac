//! Tapes as Rust text, with comments: kernels, the shell around them, whole crates. Independent of
//! mechanics.

mod comment;
mod dispatch;
mod documentation;
mod drive;
mod front;
mod implementations;
mod inverse;
pub mod kernel_file;
pub mod krate;
pub mod manifest;
pub mod module;
mod names;
mod numbers;
mod parameters;
mod print;
mod shell;
mod shipped;
mod tests_file;
mod words;
