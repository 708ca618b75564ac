//! `denavit paint`: plans the painting motion, and runs the plan. One subcommand, one file.

mod plan;
mod run;

use clap::{Args, Subcommand};

use super::Failure;
use super::provenance::Provenance;

/// Plan a motion that paints a wall with a roller.
#[derive(Args)]
#[command(
    arg_required_else_help = true,
    after_help = "Example:\n  denavit paint plan robots/kuka-lwr4.yaml --tool robots/tools/large-roller.yaml --out motion.csv --report paint.html"
)]
pub(super) struct Paint {
    #[command(subcommand)]
    what: What,
}

#[derive(Subcommand)]
enum What {
    /// Plan the motion: lanes, postures, durations, inside every limit.
    Plan(Box<plan::Plan>),
    /// Run a plan against the simulated wall, under position and force control.
    Run(Box<run::Run>),
}

impl Paint {
    pub(super) fn run(self, provenance: Provenance) -> Result<(), Failure> {
        match self.what {
            What::Plan(verb) => verb.run(provenance),
            What::Run(verb) => verb.run(provenance),
        }
    }
}
