//! The command `denavit`: parse, dispatch, exit status.

use std::process::ExitCode;

use clap::Parser;
use denavit::cli::{Cli, Failure};

fn main() -> ExitCode {
    match Cli::parse().run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(Failure { status, message }) => {
            eprintln!("denavit: {message}");
            ExitCode::from(status)
        }
    }
}
