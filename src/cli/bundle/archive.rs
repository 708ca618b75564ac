//! A zip archive of files, in memory.

use std::collections::BTreeMap;
use std::io::{Cursor, Read, Write};
use std::path::Path;

use serde_json::{Value, json};
use zip::write::SimpleFileOptions;

use super::super::Failure;
use super::super::files;
use super::super::provenance::sha256;
use super::{MANIFEST, comparable};

/// Largest total size of all files, bytes.
const MOST: u64 = 128 << 20;

/// Files by name, such as `inputs/0/log.csv`.
#[derive(Default)]
pub(super) struct Archive(BTreeMap<String, Vec<u8>>);

fn too_large() -> Failure {
    Failure::input(format!(
        "the files have more than {} MiB together; choose a part of the logs with --window",
        MOST >> 20
    ))
}

impl Archive {
    pub(super) fn add(&mut self, name: &str, bytes: Vec<u8>) {
        self.0.insert(name.into(), bytes);
    }

    pub(super) fn get(&self, name: &str) -> Option<&[u8]> {
        self.0.get(name).map(Vec::as_slice)
    }

    /// Number of files whose name begins with `prefix`.
    pub(super) fn count(&self, prefix: &str) -> usize {
        self.0.keys().filter(|name| name.starts_with(prefix)).count()
    }

    /// Adds the files of a folder below `root`.
    pub(super) fn add_folder(&mut self, root: &Path, folder: &str) -> Result<(), Failure> {
        let place = root.join(folder);
        let unread = |e: std::io::Error| Failure::other(format!("{} can't be read: {e}", place.display()));
        let entries = match std::fs::read_dir(&place) {
            Err(e) if e.kind() == std::io::ErrorKind::NotFound => return Ok(()),
            entries => entries.map_err(unread)?,
        };
        for entry in entries {
            let entry = entry.map_err(unread)?;
            let name = format!("{folder}/{}", entry.file_name().to_string_lossy());
            if entry.file_type().map_err(unread)?.is_dir() {
                self.add_folder(root, &name)?;
            } else {
                let mut bytes = Vec::new();
                let held: u64 = self.0.values().map(|b| b.len() as u64).sum();
                let file = files::open(&entry.path())?;
                file.take(MOST - held.min(MOST) + 1).read_to_end(&mut bytes).map_err(unread)?;
                if held + bytes.len() as u64 > MOST {
                    return Err(too_large());
                }
                self.0.insert(name, bytes);
            }
        }
        Ok(())
    }

    /// Name and SHA-256 of each file, except the manifest.
    pub(super) fn digests(&self) -> Value {
        let each = self.0.iter().filter(|(name, _)| *name != MANIFEST);
        json!(each.map(|(name, bytes)| (name.clone(), sha256(bytes))).collect::<BTreeMap<_, _>>())
    }

    /// Bytes of the zip; the same files give the same bytes.
    pub(super) fn pack(&self) -> Result<Vec<u8>, Failure> {
        let failed = |e: &dyn std::fmt::Display| Failure::other(format!("the archive can't be made: {e}"));
        let mut zip = zip::ZipWriter::new(Cursor::new(Vec::new()));
        for (name, bytes) in &self.0 {
            let options = SimpleFileOptions::default().compression_method(zip::CompressionMethod::Deflated);
            zip.start_file(name.as_str(), options).map_err(|e| failed(&e))?;
            zip.write_all(bytes).map_err(|e| failed(&e))?;
        }
        Ok(zip.finish().map_err(|e| failed(&e))?.into_inner())
    }

    /// Reads a zip. Names that lead out of its folder are refused.
    pub(super) fn read(path: &Path) -> Result<Self, Failure> {
        let shown = path.display();
        let bad = |e: &dyn std::fmt::Display| {
            Failure::input(format!("{shown} can't be read: {e}; name a file that `denavit bundle` wrote"))
        };
        let mut bytes = Vec::new();
        files::open(path)?.take(MOST + 1).read_to_end(&mut bytes).map_err(|e| bad(&e))?;
        if bytes.len() as u64 > MOST {
            return Err(bad(&"it is longer than any bundle"));
        }
        let mut zip = zip::ZipArchive::new(Cursor::new(bytes)).map_err(|e| bad(&e))?;
        let (mut archive, mut left) = (Self::default(), MOST);
        for k in 0..zip.len() {
            let mut file = zip.by_index(k).map_err(|e| bad(&e))?;
            let name = file.name().map_err(|e| bad(&e))?.into_owned();
            let plain = |part: &str| !part.is_empty() && part != "." && part != "..";
            if !name.split('/').all(plain) || name.contains(['\\', ':', '\0']) {
                return Err(bad(&format!("`{}` is no name of a file in it", name.escape_debug())));
            }
            let mut content = Vec::new();
            file.by_ref().take(left + 1).read_to_end(&mut content).map_err(|e| bad(&e))?;
            left =
                left.checked_sub(content.len() as u64).ok_or_else(|| bad(&"its files are longer than any bundle's"))?;
            archive.0.insert(name, content);
        }
        Ok(archive)
    }

    /// Writes the files whose names begin with `prefix` below a folder.
    pub(super) fn unpack(&self, prefix: &str, folder: &Path) -> Result<(), Failure> {
        for (name, bytes) in self.0.iter().filter(|(name, _)| name.starts_with(prefix)) {
            files::create_folder(folder, Path::new(name))?;
            files::write(&folder.join(name), bytes)?;
        }
        Ok(())
    }

    /// Results that another run wrote differently.
    pub(super) fn differences(&self, again: &Self) -> Vec<String> {
        let result = |name: &&String| name.starts_with("outputs/") || name.starts_with("std");
        let names: std::collections::BTreeSet<&String> = self.0.keys().chain(again.0.keys()).filter(result).collect();
        let compare = |name: &String| match (self.get(name), again.get(name)) {
            (Some(then), Some(now)) if comparable(name, then) == comparable(name, now) => None,
            (Some(_), Some(_)) => Some(format!("{name} has other bits")),
            (Some(_), None) => Some(format!("{name} was not written again")),
            _ => Some(format!("{name} was not written before")),
        };
        names.into_iter().filter_map(compare).collect()
    }
}
