//! The command line: one verb, one file. Only this room touches disk and terminal.

mod check;
mod eval;
mod files;
mod generate;
mod identify;
mod ik;
mod table;

use clap::{Parser, Subcommand};

/// From a robot's DH table to closed-form Rust, and from a recorded motion to an identified model.
#[derive(Parser)]
#[command(name = "denavit", version, arg_required_else_help = true)]
pub struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Read a robot file, validate it, and say what it describes.
    Check(check::Check),
    /// Write the drop-in crate with the robot's closed-form functions.
    Generate(generate::Generate),
    /// Evaluate a quantity of the robot at given states.
    Eval(eval::Eval),
    /// Find every posture that brings the arm to given poses.
    Ik(ik::Ik),
    /// Identify the base parameters from logs, and write the robot file with the values in place.
    Identify(identify::Identify),
}

impl Cli {
    /// Does what was asked.
    ///
    /// # Errors
    /// A paragraph for standard error and an exit status: 2 for wrong use or bad input, 1 otherwise.
    pub fn run(self) -> Result<(), Failure> {
        match self.command {
            Command::Check(verb) => verb.run(),
            Command::Generate(verb) => verb.run(),
            Command::Eval(verb) => verb.run(),
            Command::Ik(verb) => verb.run(),
            Command::Identify(verb) => verb.run(),
        }
    }
}

/// Why a command stopped.
#[derive(Debug)]
pub struct Failure {
    /// 2: wrong use or bad input. 1: anything else.
    pub status: u8,
    /// What, where, how to mend it.
    pub message: String,
}

impl Failure {
    /// Wrong use or bad input.
    pub fn input(message: impl ToString) -> Self {
        Self { status: 2, message: message.to_string() }
    }

    /// Not the input's fault.
    pub fn other(message: impl ToString) -> Self {
        Self { status: 1, message: message.to_string() }
    }
}
