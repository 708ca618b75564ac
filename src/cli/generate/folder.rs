//! The folder of a generated crate: its ownership and its update.

use std::collections::BTreeMap;
use std::path::{Component, Path};
use std::{fs, io};

use super::super::{Failure, files};

const MANIFEST: &str = "Cargo.toml";
const ROOT: &str = "src/lib.rs";
/// Root of a crate while it is being rewritten.
const UNFINISHED: &str = "compile_error!(\"`denavit generate` was interrupted here; run it again\");\n";

/// Content of the crate's destination.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Folder {
    Absent,
    Empty,
    /// A generated crate: its `Cargo.toml` carries the generator's mark.
    Generated,
    Foreign,
}

impl Folder {
    pub(super) fn at(out: &Path) -> Result<Self, Failure> {
        let failed = |e: io::Error| Failure::input(format!("{} can't be used: {e}; name a folder", out.display()));
        let mut entries = match fs::read_dir(out) {
            Ok(entries) => entries,
            Err(e) if e.kind() == io::ErrorKind::NotFound && fs::symlink_metadata(out).is_err() => {
                return Ok(Self::Absent);
            }
            Err(e) => return Err(failed(e)),
        };
        if entries.next().is_none() {
            return Ok(Self::Empty);
        }
        let manifest = fs::read(out.join(MANIFEST)).unwrap_or_default();
        Ok(if manifest.starts_with(dh_codegen::MARK.as_bytes()) { Self::Generated } else { Self::Foreign })
    }
}

/// Failure for a folder with other content.
pub(super) fn foreign(out: &Path) -> Failure {
    let manifest = match out.join(MANIFEST).exists() {
        true => "its Cargo.toml was not written by `denavit generate`",
        false => "it has no Cargo.toml",
    };
    Failure::input(format!(
        "{} is not empty, and {manifest}; nothing was written. Name a new folder, or add --force to replace files of the same names",
        out.display()
    ))
}

/// Differences between a folder and the crate to write.
#[derive(Debug, Default)]
pub(super) struct Stale {
    /// Files that are missing or differ.
    pub written: Vec<String>,
    /// Files of an earlier run that the crate no longer has.
    pub removed: Vec<String>,
}

impl Stale {
    pub(super) fn of(out: &Path, crate_files: &BTreeMap<String, String>) -> Self {
        let differs = |path: &str, text: &str| fs::read(out.join(path)).ok().as_deref() != Some(text.as_bytes());
        let written = crate_files.iter().filter(|(path, text)| differs(path, text));
        let manifest = fs::read_to_string(out.join(MANIFEST)).unwrap_or_default();
        let gone = dh_codegen::listed(&manifest).into_iter().filter(|path| !crate_files.contains_key(*path));
        Self {
            written: written.map(|(path, _)| path.clone()).collect(),
            removed: gone.filter(|path| is_file_inside(out, path)).map(str::to_string).collect(),
        }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.written.is_empty() && self.removed.is_empty()
    }
}

/// Whether a path names a file below a folder, without a link that leads out of it.
fn is_file_inside(out: &Path, path: &str) -> bool {
    let plain = Path::new(path).components().all(|part| matches!(part, Component::Normal(_)));
    let inside = || {
        let folder = out.join(path).parent()?.canonicalize().ok()?;
        Some(folder.starts_with(out.canonicalize().ok()?) && out.join(path).symlink_metadata().ok()?.is_file())
    };
    plain && inside() == Some(true)
}

/// Writes a new crate beside its destination and moves it there, so that it is complete or absent.
pub(super) fn create(out: &Path, crate_files: &BTreeMap<String, String>) -> Result<(), Failure> {
    let failed = |e: io::Error| Failure::other(format!("{} can't be written: {e}", out.display()));
    let mut name = out.file_name().unwrap_or_default().to_os_string();
    name.push(format!(".{}.partial", std::process::id()));
    let beside = out.with_file_name(name);
    let written = crate_files.iter().try_for_each(|(path, text)| write(&beside, path, text));
    written.and_then(|()| fs::rename(&beside, out).map_err(failed)).inspect_err(|_| {
        let _ = fs::remove_dir_all(&beside);
    })
}

/// Replaces and removes stale files. Until all is done the root of the crate is a compile error, so
/// that files of two robots are never compiled together. The previous manifest is kept until the
/// files that it lists are removed.
pub(super) fn update(
    out: &Path,
    folder: Folder,
    crate_files: &BTreeMap<String, String>,
    stale: &Stale,
) -> Result<(), Failure> {
    let whole = |path: &str| write(out, path, &crate_files[path]);
    let parts: Vec<&String> = stale.written.iter().filter(|path| ![MANIFEST, ROOT].contains(&path.as_str())).collect();
    if folder != Folder::Generated {
        whole(MANIFEST)?;
    }
    if !parts.is_empty() || !stale.removed.is_empty() {
        write(out, ROOT, UNFINISHED)?;
    }
    stale.removed.iter().try_for_each(|path| remove(out, path))?;
    whole(MANIFEST)?;
    parts.into_iter().try_for_each(|path| whole(path))?;
    whole(ROOT)
}

/// Removes a file, and folders that become empty.
fn remove(out: &Path, path: &str) -> Result<(), Failure> {
    let file = out.join(path);
    fs::remove_file(&file)
        .map_err(|e| Failure::other(format!("{} can't be removed: {e}; remove it yourself", file.display())))?;
    let above = Path::new(path).ancestors().skip(1).filter(|folder| *folder != Path::new(""));
    for folder in above {
        if fs::remove_dir(out.join(folder)).is_err() {
            break; // it holds something else
        }
    }
    Ok(())
}

fn write(folder: &Path, path: &str, text: &str) -> Result<(), Failure> {
    files::create_folder(folder, Path::new(path))?;
    files::write(&folder.join(path), text.as_bytes())
}
