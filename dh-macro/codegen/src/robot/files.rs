//! Access to files referenced by a robot file.

use std::io::{Error, ErrorKind, Result};

/// Returns the text of a file referenced by a robot file: `&|name|
/// fs::read_to_string(folder.join(name))`, or [`no_files`].
pub type Files<'a> = dyn Fn(&str) -> Result<String> + 'a;

/// File access for a robot file that references no other.
///
/// # Errors
/// Always: no file is available.
pub fn no_files(name: &str) -> Result<String> {
    Err(Error::new(ErrorKind::NotFound, format!("no file {name}")))
}
