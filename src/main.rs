//! The command `denavit`.
fn main() {}
