//! The command `denavit`: parse, dispatch, exit status.

use std::process::ExitCode;

use clap::error::{ContextKind, ContextValue, ErrorKind};
use denavit::cli::{Cli, Failure, say};

fn main() -> ExitCode {
    let done = match Cli::of_process() {
        Ok(cli) => cli.run(),
        // A wrong use is one paragraph like any other error; help and version are clap's to print.
        Err(e) if e.use_stderr() && e.kind() != ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand => {
            Err(Failure::input(one_paragraph(&e.render().to_string()) + &swallowed(&e)))
        }
        Err(e) => return shown_by_clap(&e),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(Failure { status, message }) => {
            say(&format!("denavit: {message}"));
            ExitCode::from(status)
        }
    }
}

/// Help and version.
fn shown_by_clap(message: &clap::Error) -> ExitCode {
    match message.print() {
        Ok(()) => ExitCode::from(u8::try_from(message.exit_code()).unwrap_or(2)),
        Err(e) => {
            say(&format!("denavit: standard output can't be written: {e}"));
            ExitCode::FAILURE
        }
    }
}

/// clap's lines without the empty ones between its blocks.
fn one_paragraph(message: &str) -> String {
    let lines = message.trim_start_matches("error: ").lines().map(str::trim_end).filter(|line| !line.is_empty());
    lines.collect::<Vec<_>>().join("\n")
}

/// Advice where an option that takes many values took the logs that were meant for the command.
fn swallowed(error: &clap::Error) -> String {
    let Some(ContextValue::Strings(missing)) = error.get(ContextKind::InvalidArg) else { return String::new() };
    let log = error.kind() == ErrorKind::MissingRequiredArgument && missing.iter().any(|m| m.starts_with("<LOG"));
    match std::env::args().find(|a| MANY.contains(&a.as_str())) {
        Some(option) if log => format!(
            "\nhint: {option} takes every file up to the next option; put the logs to be fitted before {option}, or write {option}=FILE"
        ),
        _ => String::new(),
    }
}

/// Options that take any number of files.
const MANY: [&str; 2] = ["--validate", "--complement"];
