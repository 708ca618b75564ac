//! Reading and writing for all verbs.

use std::fs;
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

use dh_codegen::robot::Robot;
use serde_json::Value;

use super::Failure;

/// A robot file with its text.
pub(super) struct RobotFile {
    pub robot: Robot,
    pub text: String,
}

/// Reads a robot file and says on standard error what was noted in it.
pub(super) fn robot(path: &Path) -> Result<RobotFile, Failure> {
    let shown = path.display().to_string();
    let text = text(path)?;
    let folder = path.parent().map(Path::to_path_buf).unwrap_or_default();
    let load =
        |name: &str| fs::read_to_string(folder.join(name)).map_err(|e| format!("{}: {e}", folder.join(name).display()));
    match Robot::from_yaml(&text, &load) {
        Ok(reading) => {
            for note in &reading.notes {
                eprintln!("{shown}: note: {note}");
            }
            Ok(RobotFile { robot: reading.robot, text })
        }
        Err(problems) => Err(Failure::input(format!("{shown} can't be used:\n{}", problems.in_file(&shown)))),
    }
}

/// Reads a text file.
pub(super) fn text(path: &Path) -> Result<String, Failure> {
    fs::read(path).map_err(|e| unreadable(path, &e)).and_then(|bytes| {
        String::from_utf8(bytes).map_err(|e| {
            Failure::input(format!(
                "{}: byte {} is not UTF-8 text; save the file as UTF-8",
                path.display(),
                e.utf8_error().valid_up_to()
            ))
        })
    })
}

/// Opens a file for reading.
pub(super) fn open(path: &Path) -> Result<fs::File, Failure> {
    let file = fs::File::open(path).map_err(|e| unreadable(path, &e))?;
    match file.metadata() {
        Ok(meta) if meta.is_dir() => Err(unreadable(path, &ErrorKind::IsADirectory.into())),
        _ => Ok(file),
    }
}

fn unreadable(path: &Path, error: &std::io::Error) -> Failure {
    let advice = match error.kind() {
        ErrorKind::NotFound => "; check the path",
        ErrorKind::IsADirectory => "; name a file in this folder",
        ErrorKind::PermissionDenied => "; check its permissions",
        _ => "",
    };
    Failure::input(format!("{} can't be read: {error}{advice}", path.display()))
}

/// Writes a whole file by way of a neighbour, so that what stood there is lost only when the new one is complete.
pub(super) fn write(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    let failed = |e: std::io::Error| Failure::other(format!("{} can't be written: {e}", path.display()));
    if let Some(folder) = path.parent().filter(|f| !f.as_os_str().is_empty()) {
        fs::create_dir_all(folder).map_err(failed)?;
    }
    let mut name = path.file_name().unwrap_or_default().to_os_string();
    name.push(".tmp");
    let beside = path.with_file_name(name);
    fs::write(&beside, bytes).and_then(|()| fs::rename(&beside, path)).map_err(|e| {
        let _ = fs::remove_file(&beside);
        failed(e)
    })
}

/// Where `--json` goes.
pub(super) fn json(target: &Path, value: &Value) -> Result<(), Failure> {
    let mut text = value.to_string();
    text.push('\n');
    if target == Path::new("-") { print(&text) } else { write(target, text.as_bytes()) }
}

/// To standard output; a reader that has gone away is no error.
pub(super) fn print(text: &str) -> Result<(), Failure> {
    match std::io::stdout().lock().write_all(text.as_bytes()) {
        Err(e) if e.kind() != ErrorKind::BrokenPipe => Err(Failure::other(format!("standard output: {e}"))),
        _ => Ok(()),
    }
}

/// Is `--json -` asked for? Then nothing else goes to standard output.
pub(super) fn is_stdout(json: &Option<PathBuf>) -> bool {
    json.as_deref() == Some(Path::new("-"))
}
