//! Reading and writing of files for all verbs.

use std::cell::RefCell;
use std::fs;
use std::io::{self, ErrorKind, Read, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

use dh_codegen::robot::{Robot, Run};
use serde::Serialize;
use serde_json::Value;

use super::Failure;
use super::output::{self, Output, unwritable};
use super::provenance::Provenance;
use super::terminal;
use super::terminal::is_control;

pub(super) use super::output::check_outputs;
pub(super) use super::terminal::print;

/// A robot file with its text.
pub(super) struct RobotFile {
    pub robot: Robot,
    pub text: String,
    /// Files read for it: the robot file itself and those that it refers to.
    pub read: Vec<PathBuf>,
    /// Notes on the file.
    pub notes: Vec<String>,
}

impl RobotFile {
    /// Text of this file for a robot made from it, to be written to `path`.
    pub(super) fn rewritten(&self, robot: &Robot, path: &Path, run: &Run) -> String {
        let load = |beside: &Path, name: &str| beside_text(&beside.parent().unwrap_or(Path::new("")).join(name));
        let own = self.read.first().map_or(path, PathBuf::as_path);
        robot.rewritten(&self.text, &|name| load(own, name), &|name| load(path, name), run)
    }
}

/// Text of a file that a robot file refers to; its error names the path.
fn beside_text(path: &Path) -> std::io::Result<String> {
    fs::read_to_string(path).map_err(|e| std::io::Error::new(e.kind(), format!("{}: {e}", path.display())))
}

/// Reads a robot file and prints its notes on standard error.
pub(super) fn robot(path: &Path) -> Result<RobotFile, Failure> {
    let shown = path.display().to_string();
    let text = text(path)?;
    refuse_xml(&shown, &text)?;
    let folder = path.parent().map(Path::to_path_buf).unwrap_or_default();
    let read = RefCell::new(vec![path.to_path_buf()]);
    let load = |name: &str| {
        let path = folder.join(name);
        read.borrow_mut().push(path.clone());
        beside_text(&path)
    };
    match Robot::from_yaml(&text, &load) {
        Ok(reading) => {
            let notes: Vec<String> = reading.notes.iter().map(ToString::to_string).collect();
            for note in &notes {
                terminal::say(&format!("{shown}: note: {note}"));
            }
            Ok(RobotFile { robot: reading.robot, text, read: read.into_inner(), notes })
        }
        Err(problems) => Err(Failure::input(format!("{shown} can't be used:\n{}", problems.in_file(&shown)))),
    }
}

/// Refuses a model in XML, which has to be imported first.
fn refuse_xml(shown: &str, text: &str) -> Result<(), Failure> {
    if !text.trim_start_matches('\u{feff}').trim_start().starts_with('<') {
        return Ok(());
    }
    let (named, made) = match is_stdin(Path::new(shown)) {
        true => ("standard input", Path::new("robot.yaml").into()),
        false => (shown, Path::new(shown).with_extension("yaml")),
    };
    Err(Failure::input(format!(
        "{named} is XML, no robot file; make one of a URDF or MJCF model with `denavit import {shown} --out {}`",
        made.display()
    )))
}

/// Largest text file, bytes: robot files, models, mappings and motions are held in memory.
const LONGEST_TEXT: u64 = 64 << 20;

/// Reads a text file.
pub(super) fn text(path: &Path) -> Result<String, Failure> {
    let mut bytes = Vec::new();
    let read = open(path)?.take(LONGEST_TEXT + 1).read_to_end(&mut bytes);
    if bytes.len() as u64 > LONGEST_TEXT {
        return Err(Failure::input(format!(
            "{} has more than {} MiB; robot files, models, mappings and motions are held in memory: name the right file, or \
             shorten it",
            path.display(),
            LONGEST_TEXT >> 20
        )));
    }
    read.map_err(|e| unreadable(path, &e)).and_then(|_| {
        String::from_utf8(bytes).map_err(|e| {
            Failure::input(format!(
                "{}: byte {} is not UTF-8 text; save the file as UTF-8",
                path.display(),
                e.utf8_error().valid_up_to()
            ))
        })
    })
}

/// Whether a path denotes standard input.
pub(super) fn is_stdin(path: &Path) -> bool {
    path == Path::new("-")
}

/// Standard input, which can be read only once.
fn stdin() -> Result<fs::File, Failure> {
    static TAKEN: AtomicBool = AtomicBool::new(false);
    if TAKEN.swap(true, Ordering::Relaxed) {
        return Err(Failure::input(
            "- (standard input) can be read once, and this command reads it again; write it to a file and name that",
        ));
    }
    #[cfg(unix)]
    let file = std::os::fd::AsFd::as_fd(&io::stdin()).try_clone_to_owned();
    #[cfg(windows)]
    let file = std::os::windows::io::AsHandle::as_handle(&io::stdin()).try_clone_to_owned();
    file.map(fs::File::from).map_err(|e| unreadable(Path::new("standard input"), &e))
}

/// Opens a file for reading; `-` is standard input.
pub(super) fn open(path: &Path) -> Result<fs::File, Failure> {
    if is_stdin(path) {
        return stdin();
    }
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

/// Writes a whole file; it appears complete or not at all.
pub(super) fn write(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    stream(path, |output| output.write_all(bytes))
}

/// Creates `root`, and the folders in it that the file `inside` needs; the parent of `root` must
/// exist.
pub(super) fn create_folder(root: &Path, inside: &Path) -> Result<(), Failure> {
    let folders = inside.parent().into_iter().flat_map(Path::ancestors).filter(|f| !f.as_os_str().is_empty());
    let mut all: Vec<PathBuf> = folders.map(|folder| root.join(folder)).collect();
    all.push(root.to_path_buf());
    for folder in all.iter().rev() {
        match fs::create_dir(folder) {
            Err(_) if folder.is_dir() => {}
            Err(e) if e.kind() == ErrorKind::NotFound => {
                let parent = folder.parent().unwrap_or(folder).display();
                return Err(Failure::other(format!(
                    "{} can't be made: there is no folder {parent}; create it, or correct the path",
                    folder.display()
                )));
            }
            done => done.map_err(|e| unwritable(&folder.display().to_string(), &e))?,
        }
    }
    Ok(())
}

/// Writes a file piece by piece; it appears complete or not at all.
pub(super) fn stream(path: &Path, fill: impl FnOnce(&mut Output) -> io::Result<()>) -> Result<(), Failure> {
    let mut output = Output::create(path)?;
    match fill(&mut output) {
        Ok(()) => output.finish(),
        Err(e) => Err(output.failed(&e)),
    }
}

/// Writes the output of `--json`, with the provenance.
pub(super) fn json(target: &Path, mut value: Value, provenance: &Provenance) -> Result<(), Failure> {
    let rows = provenance.rows().into_iter().map(|(what, value)| (what, Value::from(value)));
    value["provenance"] = Value::Object(rows.collect());
    let fill = |output: &mut dyn Write| {
        value.serialize(&mut serde_json::Serializer::with_formatter(&mut *output, Visible))?;
        output.write_all(b"\n")
    };
    if target != Path::new("-") {
        return stream(target, |output| fill(output));
    }
    let mut out = io::BufWriter::new(io::stdout().lock());
    fill(&mut out).and_then(|()| out.flush()).map_err(|e| unwritable("standard output", &e))
}

/// JSON without control characters, as it may be shown on a terminal: JSON itself permits those
/// above U+007E.
struct Visible;

impl serde_json::ser::Formatter for Visible {
    fn write_string_fragment<W: ?Sized + Write>(&mut self, writer: &mut W, fragment: &str) -> io::Result<()> {
        if !fragment.contains(is_control) {
            return writer.write_all(fragment.as_bytes());
        }
        for c in fragment.chars() {
            // All of them have 16 bits.
            if is_control(c) { write!(writer, "\\u{:04x}", u32::from(c))? } else { write!(writer, "{c}")? }
        }
        Ok(())
    }
}

/// Whether one of these outputs goes to standard output, so that nothing else may.
pub(super) fn is_stdout<'a>(outputs: impl IntoIterator<Item = &'a PathBuf>) -> bool {
    outputs.into_iter().any(|path| output::is_stdout(path))
}
