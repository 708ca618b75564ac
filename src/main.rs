//! The command `denavit`: parse, dispatch, exit status.

use std::process::ExitCode;

use clap::error::ErrorKind;
use denavit::cli::{Cli, Failure, say};

fn main() -> ExitCode {
    let done = match Cli::of_process() {
        Ok(cli) => cli.run(),
        // A wrong use is one paragraph like any other error; help and version are clap's to print.
        Err(e) if e.use_stderr() && e.kind() != ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand => {
            Err(Failure::input(one_paragraph(&e.render().to_string())))
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

/// The blocks of clap's message, one after the other.
fn one_paragraph(message: &str) -> String {
    let blocks = message.trim_start_matches("error: ").split("\n\n");
    let lines = |block: &str| block.split_whitespace().collect::<Vec<_>>().join(" ");
    blocks.map(lines).filter(|b| !b.is_empty()).collect::<Vec<_>>().join("; ")
}
