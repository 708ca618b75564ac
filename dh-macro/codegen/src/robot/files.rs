//! Files that a robot file names.

use std::io::{Error, ErrorKind, Result};

/// Gives the text of a file that a robot file names: `&|name| fs::read_to_string(folder.join(name))`,
/// or [`no_files`].
pub type Files<'a> = dyn Fn(&str) -> Result<String> + 'a;

/// For a robot file that names no other.
///
/// # Errors
/// Always: there is no file of this name.
pub fn no_files(name: &str) -> Result<String> {
    Err(Error::new(ErrorKind::NotFound, format!("no file {name}")))
}
