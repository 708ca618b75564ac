//! A recording's file, from a folder or an object store, and its digest.

use std::collections::BTreeSet;
use std::fs::File;
use std::io::{BufReader, Read, Seek};
use std::path::{Path, PathBuf};

use denavit::data::log::{Digest, Format, LogError, Reading, Source, open_parquet, open_table, source};
use denavit::identify::RecordingReader;
use denavit::report::FactorRow;

/// Endings of files that are recordings.
const ENDINGS: [&str; 9] = [".csv", ".csv.gz", ".csv.zst", ".parquet", ".mcap", ".mcap.zst", ".npz", ".mat", ".tsv"];

/// Why a file is no source of rows. Becomes a row's reason.
#[derive(Debug, thiserror::Error)]
pub enum OpenError {
    /// No access.
    #[error("{name} can't be read: {source}")]
    File {
        /// File.
        name: String,
        /// What the system says.
        source: std::io::Error,
    },
    /// No log.
    #[error(transparent)]
    Log(#[from] LogError),
}

/// Whether a name is that of a recording.
pub fn is_recording(name: &str) -> bool {
    ENDINGS.iter().any(|ending| name.to_ascii_lowercase().ends_with(ending))
}

/// The recordings below a folder, sorted; a file is itself.
///
/// # Errors
/// What the system says.
pub fn recordings_below(path: &Path) -> std::io::Result<Vec<PathBuf>> {
    if std::fs::metadata(path)?.is_file() {
        return Ok(vec![path.into()]);
    }
    let (mut found, mut folders, mut met) = (Vec::new(), vec![path.to_path_buf()], BTreeSet::new());
    while let Some(folder) = folders.pop() {
        // Links may lead back to it.
        if !met.insert(std::fs::canonicalize(&folder)?) {
            continue;
        }
        for entry in std::fs::read_dir(&folder)? {
            let path = entry?.path();
            match std::fs::metadata(&path) {
                Ok(meta) if meta.is_dir() => folders.push(path),
                // No pipe or device, which may never end.
                Ok(meta) if meta.is_file() && is_recording(&path.to_string_lossy()) => found.push(path),
                // A link that leads nowhere is a recording that can't be read: a row says so.
                Err(_) if is_recording(&path.to_string_lossy()) => found.push(path),
                _ => {}
            }
        }
    }
    found.sort();
    Ok(found)
}

/// The row of a recording: its factor, or the reason why there is none. `name` is what the row
/// calls the file at `path`, `robot` the arm.
pub fn row(name: &str, path: &Path, robot: &str, reader: &RecordingReader<'_>) -> FactorRow {
    let read = |source: &mut dyn Source| reader.factor(name, source);
    match with_source(name, path, &reader.preparation().reading, read) {
        Ok((Ok(found), sha256)) => FactorRow::of(robot, name, sha256, found),
        Ok((Err(why), _)) => FactorRow::without(robot, name, digest(path), why.to_string()),
        Err(why) => FactorRow::without(robot, name, digest(path), why.to_string()),
    }
}

/// What `read` finds in a file, and the SHA-256 of the file.
///
/// # Errors
/// Where the file is no log.
pub fn with_source<T>(
    name: &str,
    path: &Path,
    reading: &Reading,
    read: impl FnOnce(&mut dyn Source) -> T,
) -> Result<(T, String), OpenError> {
    let failed = |source| OpenError::File { name: name.into(), source };
    let mut file = File::open(path).map_err(failed)?;
    let mut magic = Vec::new();
    file.by_ref().take(16).read_to_end(&mut magic).map_err(failed)?;
    file.rewind().map_err(failed)?;
    let digest = Digest::default();
    // Parquet is read from its end, all else as a stream.
    let table = if Format::of(&magic) == Format::Parquet {
        digest.take_in(&mut file).map_err(failed)?;
        file.rewind().map_err(failed)?;
        open_parquet(name, file)?
    } else {
        open_table(name, digest.reading(BufReader::new(file)), reading)?
    };
    let mut rows = source(name, table, reading)?;
    let found = read(&mut *rows);
    drop(rows);
    Ok((found, digest.hexadecimal()))
}

/// SHA-256 of a file that can be read.
pub fn digest(path: &Path) -> Option<String> {
    let digest = Digest::default();
    digest.take_in(File::open(path).ok()?).ok()?;
    Some(digest.hexadecimal())
}
