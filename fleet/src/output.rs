//! The terminal, and files that are there whole or not at all.

use std::io::Write;
use std::path::Path;

use denavit::report::visible;
use tempfile::NamedTempFile;

use crate::error::FleetError;

/// A line on standard error. Nobody may read it.
pub fn say(text: &str) {
    let _ = writeln!(std::io::stderr(), "{}", visible(text));
}

/// Text on standard output, whose reader may have closed it.
pub(crate) fn print(text: &str) -> Result<(), FleetError> {
    let mut out = std::io::stdout().lock();
    let done = out.write_all(text.as_bytes()).and_then(|()| out.flush());
    done.map_err(|source| FleetError::File { path: "standard output".into(), verb: "written", source })
}

/// A file without a name yet, which others may read as they may any file of this user.
pub(crate) fn unnamed(folder: &Path) -> std::io::Result<NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(std::fs::Permissions::from_mode(0o666));
    }
    builder.tempfile_in(folder)
}

/// Whether a file can get this name, before hours of work for it.
pub(crate) fn check(path: &Path) -> Result<(), FleetError> {
    let made =
        if path.is_dir() { Err(std::io::ErrorKind::IsADirectory.into()) } else { unnamed(folder(path)).map(drop) };
    made.map_err(|source| FleetError::File { path: path.into(), verb: "written", source })
}

/// Writes a file.
pub(crate) fn write(path: &Path, text: &str) -> Result<(), FleetError> {
    let written = unnamed(folder(path)).and_then(|mut file| {
        file.write_all(text.as_bytes())?;
        file.persist(path).map(drop).map_err(|e| e.error)
    });
    written.map_err(|source| FleetError::File { path: path.into(), verb: "written", source })
}

fn folder(path: &Path) -> &Path {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}
