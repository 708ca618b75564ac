//! The command `denavit-fleet`: parse, dispatch, exit status.

use std::process::ExitCode;

use clap::Parser;
use denavit_fleet::cli::{Cli, say};

fn main() -> ExitCode {
    let cli = Cli::parse();
    let threads = cli.threads();
    let runtime = tokio::runtime::Builder::new_multi_thread().worker_threads(threads).enable_all().build();
    let runtime = match runtime {
        Ok(runtime) => runtime,
        Err(e) => {
            say(&format!("denavit-fleet: threads can't be started: {e}"));
            return ExitCode::FAILURE;
        }
    };
    match runtime.block_on(cli.run()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            say(&format!("denavit-fleet: {error}"));
            ExitCode::from(error.status())
        }
    }
}
