//! Provenance of a result: program, command, every option with its value, and the files read. It
//! suffices to repeat the run.

use std::path::Path;

use clap::parser::ValueSource;
use clap::{Arg, ArgAction, ArgMatches, Command};
use dh_codegen::robot::Run;
use sha2::{Digest, Sha256};

use super::Failure;
use super::files::RobotFile;
use super::logbook::Logbook;
use crate::data::log::hexadecimal;

/// Options that name outputs. They determine where a result goes, but not the result.
pub(super) const OUTPUTS: [&str; 7] = ["out", "json", "report", "next", "coefficients", "ros", "path"];

/// Provenance of a result.
#[derive(Debug, Clone, Default)]
pub(super) struct Provenance {
    /// The command without its outputs, ready for a shell.
    command: String,
    /// Every option with its value, given or default.
    options: Vec<(String, String)>,
    /// Values that were read or chosen: name and value.
    further: Vec<(String, String)>,
    /// Files: purpose, path, SHA-256.
    files: Vec<(String, String, String)>,
    /// Notes on the files read.
    notes: Vec<String>,
    /// Options given on the command line.
    given: Vec<String>,
}

impl Provenance {
    /// Takes the provenance from the arguments of a command line.
    pub(super) fn new(command: &Command, matches: &ArgMatches) -> Self {
        let mut words = vec![command.get_name().to_string()];
        let (mut command, mut matches) = (command, matches);
        while let Some((name, inner)) = matches.subcommand()
            && let Some(verb) = command.find_subcommand(name)
        {
            words.push(name.to_string());
            (command, matches) = (verb, inner);
        }
        let arguments = command.get_arguments().filter(|a| !matches!(a.get_id().as_str(), "help" | "version"));
        let (places, named): (Vec<&Arg>, Vec<&Arg>) = arguments.partition(|a| a.is_positional());
        let (mut options, mut typed) = (Vec::new(), Vec::new());
        for argument in places.into_iter().chain(named) {
            let id = argument.get_id().as_str();
            let values: Vec<String> = matches
                .get_raw(id)
                .map(|raw| raw.map(|value| value.to_string_lossy().into_owned()).collect())
                .unwrap_or_default();
            let given = matches.value_source(id) == Some(ValueSource::CommandLine);
            // `paint plan` writes a plan, `paint run` reads it.
            if given {
                typed.push(format!("--{}", name(argument)));
            }
            let output = OUTPUTS.contains(&id) || (id == "plan" && command.get_name() == "plan");
            if given && !output {
                words.extend(as_typed(argument, &values));
            }
            if !argument.is_positional() && !output {
                options.push((format!("--{}", name(argument)), shown(argument, &values, given)));
            }
        }
        Self { command: words.join(" "), options, given: typed, ..Self::default() }
    }

    /// Refuses given options that have no effect in this run. Each rule has the option, whether it
    /// has an effect, and the reason if not.
    pub(super) fn refuse_idle(&self, rules: &[(&str, bool, &str)]) -> Result<(), Failure> {
        let idle = rules.iter().find(|(option, acts, _)| !acts && self.given.iter().any(|given| given == option));
        idle.map_or(Ok(()), |(option, _, why)| {
            Err(Failure::input(format!("{option} has no effect here: {why}; leave it out")))
        })
    }

    /// Record for a robot file that this run writes. It does not contain the file's own path: the
    /// same run gives the same bytes.
    pub(super) fn run(&self, found: Vec<String>) -> Run {
        let option = |(name, value): &(String, String)| format!("{name}: {value}");
        Run {
            command: self.command.clone(),
            version: env!("CARGO_PKG_VERSION").into(),
            options: self.further.iter().chain(&self.options).map(option).collect(),
            files: self.files.iter().map(|(what, path, sha256)| [what, path, sha256].map(String::clone)).collect(),
            found,
        }
    }

    /// Adds the robot file.
    pub(super) fn robot(mut self, path: &Path, file: &RobotFile) -> Self {
        self.files.push(("robot file".into(), path.display().to_string(), sha256(file.text.as_bytes())));
        self.notes.extend(file.notes.iter().map(|note| format!("{}: {note}", path.display())));
        self
    }

    /// Adds the imported model.
    pub(super) fn model(mut self, shown: &str, text: &str) -> Self {
        self.files.push(("model".into(), shown.into(), sha256(text.as_bytes())));
        self
    }

    /// Adds the logs that were read.
    pub(super) fn logs(mut self, logbook: &Logbook) -> Self {
        let entry =
            |(purpose, path, digest): (&str, String, &str)| (format!("{purpose} log"), path, digest.to_string());
        self.files.extend(logbook.digests().map(entry));
        self
    }

    /// Adds another value that was read or chosen.
    pub(super) fn with(mut self, what: &str, value: impl ToString) -> Self {
        self.further.push((what.into(), value.to_string()));
        self
    }

    /// Rows for the foot of a page and the `provenance` of the JSON: name and value.
    pub(super) fn rows(&self) -> Vec<(String, String)> {
        let row = |what: &str, value: &str| (what.to_string(), value.to_string());
        let mut rows = vec![row("denavit", env!("CARGO_PKG_VERSION")), row("command", &self.command)];
        let mut purposes: Vec<&str> = self.files.iter().map(|(purpose, ..)| purpose.as_str()).collect();
        purposes.dedup();
        for purpose in purposes {
            let of = self.files.iter().filter(|(p, ..)| p == purpose);
            let list: Vec<String> = of.map(|(_, path, digest)| format!("{path} (SHA-256 {digest})")).collect();
            let plural = if purpose.ends_with("log") { "s" } else { "" };
            rows.push((format!("{purpose}{plural}"), list.join(", ")));
        }
        if !self.notes.is_empty() {
            rows.push(row("notes", &self.notes.join("; ")));
        }
        rows.extend(self.further.iter().cloned());
        rows.extend(self.options.iter().cloned());
        rows
    }
}

/// Hexadecimal SHA-256.
pub(super) fn sha256(bytes: &[u8]) -> String {
    hexadecimal(&Sha256::digest(bytes))
}

fn name(argument: &Arg) -> &str {
    argument.get_long().unwrap_or(argument.get_id().as_str())
}

fn is_flag(argument: &Arg) -> bool {
    matches!(argument.get_action(), ArgAction::SetTrue)
}

/// Words of the command line that give an argument these values.
fn as_typed(argument: &Arg, values: &[String]) -> Vec<String> {
    if argument.is_positional() {
        return values.iter().map(|value| quoted(value)).collect();
    }
    let option = format!("--{}", name(argument));
    if is_flag(argument) {
        return vec![option];
    }
    let joined = argument.get_value_delimiter().map(|between| values.join(&between.to_string()));
    let values = joined.map_or(values.to_vec(), |joined| vec![joined]);
    let several = argument.get_num_args().is_some_and(|n| n.max_values() > 1);
    if several && !values.iter().any(|value| value.starts_with('-')) {
        return std::iter::once(option).chain(values.iter().map(|value| quoted(value))).collect();
    }
    let equals = |value: &str| argument.is_require_equals_set() || value.starts_with('-');
    let one = |value: &String| match equals(value) {
        true => vec![format!("{option}={}", quoted(value))],
        false => vec![option.clone(), quoted(value)],
    };
    values.iter().flat_map(one).collect()
}

/// Value of an option for display.
fn shown(argument: &Arg, values: &[String], given: bool) -> String {
    match (is_flag(argument), values) {
        (true, _) => if given { "yes" } else { "no" }.into(),
        (_, []) => "not given".into(),
        _ => {
            let between = argument.get_value_delimiter().map_or(" ".to_string(), |c| c.to_string());
            let value = values.join(&between);
            if given { value } else { format!("{value} (default)") }
        }
    }
}

/// A word quoted for a shell.
fn quoted(word: &str) -> String {
    let plain = |c: char| c.is_ascii_alphanumeric() || "-_./,:=@%+".contains(c);
    if !word.is_empty() && word.chars().all(plain) {
        return word.to_string();
    }
    format!("'{}'", word.replace('\'', "'\\''"))
}
