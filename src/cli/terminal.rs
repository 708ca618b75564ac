//! Text output on a terminal. Names of columns, joints and files come from outside and may contain
//! escape sequences: control characters are escaped here, and nowhere else.

use std::io::{self, Write};

pub(super) use crate::report::{is_control, visible};

use super::Failure;
use super::output;
use crate::report::Warnings;

/// Prints to standard output.
pub(super) fn print(text: &str) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    let done = out.write_all(visible(text).as_bytes()).and_then(|()| out.flush());
    done.map_err(|e| output::unwritable("standard output", &e))
}

/// Issues a warning: on standard error at once, in JSON and page with the result. `of` is the file
/// concerned.
pub(super) fn warn(warnings: &mut Warnings, of: &str, warning: &str) {
    say(&format!("{of}: note: {warning}"));
    warnings.push_shown(format!("{of}: {warning}"));
}

/// Prints a line to standard error. Write errors are ignored.
pub fn say(line: &str) {
    let _ = writeln!(io::stderr().lock(), "{}", visible(line));
}
