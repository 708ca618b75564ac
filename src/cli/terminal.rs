//! Text on its way to a terminal. Names of columns, joints and files come from elsewhere and may
//! hold escape sequences: control characters are written out here, and nowhere else.

use std::io::{self, Write};

pub(super) use crate::report::{is_control, visible};

use super::Failure;
use super::output;
use crate::report::Warnings;

/// To standard output.
pub(super) fn print(text: &str) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    let done = out.write_all(visible(text).as_bytes()).and_then(|()| out.flush());
    done.map_err(|e| output::unwritable("standard output", &e))
}

/// A warning as it arises: to standard error now, to JSON and page with the result. `of`: the file
/// that it is about.
pub(super) fn warn(warnings: &mut Warnings, of: &str, warning: &str) {
    say(&format!("{of}: note: {warning}"));
    warnings.push_shown(format!("{of}: {warning}"));
}

/// A line to standard error. If nobody reads it, the work goes on.
pub fn say(line: &str) {
    let _ = writeln!(io::stderr().lock(), "{}", visible(line));
}
