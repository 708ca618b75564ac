//! Copies of a command line's inputs in a folder, and the command line adapted to it.

use std::cell::RefCell;
use std::path::{Component, Path, PathBuf};

use dh_codegen::robot::Robot;

use super::super::Failure;
use super::super::files;
use super::super::provenance::OUTPUTS;
use super::window::Window;

/// A run in its own folder.
pub(super) struct Inputs {
    /// Verb and arguments with the paths in the folder.
    pub(super) words: Vec<String>,
    /// Each input: its original path, and its name in the folder.
    pub(super) files: Vec<(PathBuf, String)>,
}

/// Whether these words only refer to paths inside their folder.
pub(super) fn harmless(words: &[String]) -> bool {
    let inside = |word: &str| {
        let value = word.split_once('=').map_or(word, |(_, value)| value);
        let path = Path::new(value);
        !path.is_absolute() && !path.components().any(|part| part == Component::ParentDir)
    };
    !words.is_empty() && !matches!(words[0].as_str(), "bundle" | "replay") && words.iter().all(|w| inside(w))
}

/// Whether an option names an output: `paint plan` writes a plan, `paint run` reads it.
fn is_output(option: &str, words: &[String]) -> bool {
    let planned = option == "plan" && words.get(1).is_some_and(|word| word == "plan");
    planned || OUTPUTS.contains(&option)
}

impl Inputs {
    /// Copies every file that the words name into `folder`; logs are cut to the window.
    pub(super) fn collect(words: &[String], folder: &Path, window: Option<&Window>) -> Result<Self, Failure> {
        let mut inputs = Self { words: Vec::new(), files: Vec::new() };
        files::create_folder(folder, Path::new("outputs/x"))?;
        let mut option = None;
        for word in words {
            let (name, value) = match word.strip_prefix("--").and_then(|rest| rest.split_once('=')) {
                Some((name, value)) => (Some(name), value),
                None => (option, word.as_str()),
            };
            let held = if value != "-" && name.is_some_and(|name| is_output(name, words)) {
                let last = Path::new(value).file_name().map_or("result".into(), |n| n.to_string_lossy());
                Some(format!("outputs/{last}"))
            } else if Path::new(value).exists() && !value.starts_with('-') {
                Some(inputs.copy(Path::new(value), folder, window)?)
            } else {
                None
            };
            let given = held.as_deref().unwrap_or(value);
            inputs.words.push(match word.split_once('=') {
                Some((before, _)) if name.is_some() && word.starts_with("--") => format!("{before}={given}"),
                _ => given.to_string(),
            });
            option = word.strip_prefix("--").filter(|rest| !rest.contains('='));
        }
        match harmless(&inputs.words) {
            true => Ok(inputs),
            false => {
                Err(Failure::input("an argument names a place outside that is no file; name files that are there"))
            }
        }
    }

    /// Copies a file, or the files of a folder; returns its name in the folder.
    fn copy(&mut self, from: &Path, folder: &Path, window: Option<&Window>) -> Result<String, Failure> {
        let last = from.file_name().map_or("input".into(), |n| n.to_string_lossy().into_owned());
        let held = format!("inputs/{}/{last}", self.files.len());
        let unread = |e: std::io::Error| Failure::input(format!("{} can't be read: {e}", from.display()));
        files::create_folder(folder, Path::new(&held))?;
        if from.is_dir() {
            files::create_folder(folder, &Path::new(&held).join("x"))?;
            for entry in std::fs::read_dir(from).map_err(unread)? {
                let path = entry.map_err(unread)?.path();
                if path.is_file() {
                    let name = path.file_name().unwrap_or_default().to_owned();
                    std::fs::copy(&path, folder.join(&held).join(name)).map_err(unread)?;
                }
            }
        } else {
            let cut = window.map(|window| window.cut(from)).transpose()?.flatten();
            match cut {
                Some(rows) => files::write(&folder.join(&held), &rows)?,
                None => drop(std::fs::copy(from, folder.join(&held)).map_err(unread)?),
            }
            beside(from, &folder.join(&held), folder)?;
        }
        self.files.push((from.to_path_buf(), held.clone()));
        Ok(held)
    }
}

/// Copies the files that a robot file refers to, relative to its own folder.
fn beside(from: &Path, to: &Path, folder: &Path) -> Result<(), Failure> {
    let Ok(text) = std::fs::read_to_string(from) else { return Ok(()) };
    let names = RefCell::new(Vec::new());
    let load = |name: &str| {
        names.borrow_mut().push(name.to_string());
        std::fs::read_to_string(from.parent().unwrap_or(Path::new("")).join(name))
    };
    let yaml = from.extension().is_some_and(|e| e == "yaml" || e == "yml");
    if !yaml || Robot::from_yaml(&text, &load).is_err() {
        return Ok(());
    }
    for name in names.into_inner() {
        let plain = Path::new(&name).components().all(|part| matches!(part, Component::Normal(_)));
        if !plain {
            return Err(Failure::input(format!(
                "{} names {name}, which is not beside it; put both into one folder",
                from.display()
            )));
        }
        let target = to.parent().unwrap_or(folder).join(&name);
        if let Some(place) = target.parent().and_then(|p| p.strip_prefix(folder).ok()) {
            files::create_folder(folder, &place.join("x"))?;
        }
        let source = from.parent().unwrap_or(Path::new("")).join(&name);
        std::fs::copy(&source, &target)
            .map_err(|e| Failure::input(format!("{} can't be read: {e}", source.display())))?;
    }
    Ok(())
}
