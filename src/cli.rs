//! The command line: one verb, one file. Only this module touches disk and terminal.

#![deny(clippy::print_stdout, clippy::print_stderr)] // `terminal` writes, and shows control characters

/// The columns of a log, for the end of a help.
macro_rules! log_columns {
    () => {
        "\n\nColumns of a log, in SI units:
  t                    time, s
  q1..                 positions of the joints, rad or m
  tau1.. or i1..       torques, N m; or motor currents, A, with `torque_constant` in the robot file
Optional columns:
  dq1.. ddq1..         velocities and accelerations
  qm1.. qd1..          motor-side and desired positions
  taum1.. temp1..      motor-side torques, N m; temperatures, deg C
  fx fy fz mx my mz    wrench on the tool, N and N m
  seg                  number of the recording
Other names and units: `denavit log inspect LOG` proposes a mapping for --map or the robot file.
Formats (CSV, Parquet, MCAP, npz, mat) and mappings: docs/logs.md"
    };
}

mod bundle;
mod calibrate;
mod check;
mod column_check;
mod delivery;
mod diagnose;
mod eval;
mod excite;
mod export;
mod factor;
mod files;
mod force;
mod generate;
mod identify;
mod ik;
mod import;
mod interrupt;
mod known_effects;
mod log;
mod logbook;
mod mapping;
mod motion;
mod motors;
mod new;
mod output;
mod paint;
mod prepare;
mod provenance;
mod reading;
mod reproduce;
mod shell;
mod simulate;
mod table;
mod terminal;
mod tool;
mod torque_columns;

use clap::{CommandFactory, FromArgMatches, Parser, Subcommand};

pub use terminal::say;

/// From a robot's DH table to closed-form Rust, and from a recorded motion to an identified model.
#[derive(Parser)]
#[command(name = "denavit", version, arg_required_else_help = true)]
pub struct Cli {
    #[command(subcommand)]
    command: Command,
    #[arg(skip)]
    provenance: provenance::Provenance,
}

#[derive(Subcommand)]
enum Command {
    /// Write a commented robot file for an arm of n joints, to fill in.
    New(new::New),
    /// Run a command and write its inputs, options, version and results into one file.
    Bundle(bundle::Bundle),
    /// Identify the robot, diagnose what is left, and measure both on logs that nothing was fitted
    /// to.
    Calibrate(calibrate::Calibrate),
    /// Read a robot file, validate it, and say what it describes.
    Check(check::Check),
    /// Write the drop-in crate with the robot's closed-form functions.
    Generate(generate::Generate),
    /// Find what a simulation of the robot file gets wrong, name the causes, extend the model,
    /// measure the gain.
    Diagnose(diagnose::Diagnose),
    /// Evaluate a quantity of the robot at given states.
    Eval(eval::Eval),
    /// Design the most informative motion for the parameters, inside every limit.
    Excite(excite::Excite),
    /// Write a robot file as URDF or MJCF, for simulators that read those.
    Export(export::Export),
    /// Write the factors of recordings, one row each, from which a fleet's models are found without
    /// reading the recordings again.
    Factor(Box<factor::Factor>),
    /// Estimate the wrench on the tool from joint torques, with 95 % bands.
    Force(Box<force::Force>),
    /// Make a robot file of a URDF or MJCF model.
    Import(import::Import),
    /// Find every posture that brings the arm to given poses.
    Ik(ik::Ik),
    /// Look into recordings (CSV, Parquet, MCAP, npz, mat), and convert them.
    Log(log::LogVerb),
    /// Identify the base parameters from logs, and write the robot file with the values in place.
    Identify(Box<identify::Identify>),
    /// Plan a motion that paints a wall with a roller.
    Paint(paint::Paint),
    /// Run the command of a bundle again, and compare its results bit by bit.
    Replay(bundle::Replay),
    /// Run the paper's experiments and print each table and figure beside the paper's own values.
    Reproduce(reproduce::Reproduce),
    /// Play a motion on the simulated robot and record a log.
    Simulate(simulate::Simulate),
    /// Identify what the arm carries, and recognise the tool.
    Tool(tool::ToolVerb),
    /// Write the completions of a shell to standard output.
    Completions(shell::Completions),
    /// Write the manual pages.
    Man(shell::Man),
}

impl Cli {
    /// Parses the arguments of this process.
    ///
    /// # Errors
    /// Returns clap's error: wrong use, or help and version to print.
    pub fn of_process() -> Result<Self, clap::Error> {
        let mut command = with_negative_numbers(Self::command());
        let matches = command.try_get_matches_from_mut(std::env::args_os())?;
        let mut cli = Self::from_arg_matches(&matches).map_err(|e| e.format(&mut command))?;
        cli.provenance = provenance::Provenance::new(&command, &matches);
        Ok(cli)
    }

    /// Runs the command.
    ///
    /// # Errors
    /// Returns a paragraph for standard error and an exit status: 2 for wrong use or bad input, 1
    /// otherwise.
    pub fn run(self) -> Result<(), Failure> {
        let provenance = self.provenance;
        match self.command {
            Command::New(verb) => verb.run(provenance),
            Command::Bundle(verb) => verb.run(),
            Command::Calibrate(verb) => verb.run(provenance),
            Command::Check(verb) => verb.run(provenance),
            Command::Generate(verb) => verb.run(provenance),
            Command::Diagnose(verb) => verb.run(provenance),
            Command::Eval(verb) => verb.run(provenance),
            Command::Excite(verb) => verb.run(provenance),
            Command::Export(verb) => verb.run(provenance),
            Command::Factor(verb) => verb.run(provenance),
            Command::Force(verb) => verb.run(provenance),
            Command::Ik(verb) => verb.run(provenance),
            Command::Import(verb) => verb.run(provenance),
            Command::Identify(verb) => verb.run(provenance),
            Command::Log(verb) => verb.run(provenance),
            Command::Paint(verb) => verb.run(provenance),
            Command::Replay(verb) => verb.run(),
            Command::Reproduce(verb) => verb.run(provenance),
            Command::Simulate(verb) => verb.run(provenance),
            Command::Tool(verb) => verb.run(provenance),
            Command::Completions(verb) => verb.run(Self::command()),
            Command::Man(verb) => verb.run(Self::command()),
        }
    }
}

/// Permits a negative number as the value of every option. The option's own check then reports the
/// error, instead of the parser reporting an unknown option `-5`.
fn with_negative_numbers(command: clap::Command) -> clap::Command {
    command
        .mut_args(|arg| match arg.get_action().takes_values() && !arg.is_positional() {
            true => arg.allow_negative_numbers(true),
            false => arg,
        })
        .mut_subcommands(with_negative_numbers)
}

/// Reason why a command failed.
#[derive(Debug, Clone)]
pub struct Failure {
    /// Exit status. 2: wrong use or bad input. 1: anything else.
    pub status: u8,
    /// What went wrong, where, and how to correct it.
    pub message: String,
}

impl Failure {
    /// Failure by wrong use or bad input.
    pub fn input(message: impl ToString) -> Self {
        Self { status: 2, message: message.to_string() }
    }

    /// Failure that is not the input's fault.
    pub fn other(message: impl ToString) -> Self {
        Self { status: 1, message: message.to_string() }
    }
}
