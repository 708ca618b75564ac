//! Text on its way to a terminal. Names of columns, joints and files come from elsewhere and may
//! hold escape sequences: control characters are written out here, and nowhere else.

use std::io::{self, Write};

pub(super) use crate::report::{is_control, visible};

use super::Failure;
use super::output;

/// To standard output.
pub(super) fn print(text: &str) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    let done = out.write_all(visible(text).as_bytes()).and_then(|()| out.flush());
    done.map_err(|e| output::unwritable("standard output", &e))
}

/// A line to standard error. Where nobody reads it, the work goes on.
pub fn say(line: &str) {
    let _ = writeln!(io::stderr().lock(), "{}", visible(line));
}
