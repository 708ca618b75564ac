//! Folder of the robot files.
#![allow(dead_code, unreachable_pub)] // each test file uses its part

use std::path::{Path, PathBuf};

use dh_codegen::robot::{Problems, Reading, Robot};

/// The folder `robots` of the repository.
pub fn robots() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../robots")
}

/// The YAML files of a folder below `robots`, in order.
pub fn files(folder: &str) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(robots().join(folder)).unwrap();
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "yaml"));
    paths.sort();
    assert!(!paths.is_empty());
    paths
}

/// Reads a robot file; tool files stand beside it.
pub fn read(path: &Path) -> Result<Reading, Problems> {
    let folder = path.parent().unwrap().to_path_buf();
    Robot::from_bytes(&std::fs::read(path).unwrap(), &|name| {
        std::fs::read_to_string(folder.join(name))
            .map_err(|e| std::io::Error::new(e.kind(), format!("{name} was not found")))
    })
}
