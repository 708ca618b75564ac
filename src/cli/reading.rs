//! Options for reading a log, for every verb that fits one.

use clap::{Args, ValueEnum};

use super::Failure;
use super::mapping::MapOption;
use crate::data::log::{Acceptance, Quantity};

/// Torque, acceptance, and names of the columns.
#[derive(Args, Clone)]
pub(super) struct ReadOptions {
    /// Source of the torque: `tau` (of a log that has currents alone: `current`), `taum` (motor
    /// side), or `current` (motor current times the robot file's `torque_constant`).
    #[arg(long, value_enum, default_value_t = Torque::Tau)]
    pub(super) torque: Torque,
    #[command(flatten)]
    pub(super) keep: Keep,
    #[command(flatten)]
    pub(super) map: MapOption,
}

/// Source of a log's torque.
#[derive(Clone, Copy, ValueEnum)]
pub(super) enum Torque {
    Tau,
    Taum,
    Current,
}

impl Torque {
    pub(super) fn quantity(self) -> Quantity {
        match self {
            Self::Tau => Quantity::Tau,
            Self::Taum => Quantity::Taum,
            Self::Current => Quantity::Current,
        }
    }
}

/// `--keep`.
#[derive(Args, Clone)]
pub(super) struct Keep {
    /// Accept what is normally refused: bad-rows, gaps, restarts, duplicates, irregular-clock,
    /// stuck, clipped, dead-torque, large-angles, torque-unit, misread, or all.
    #[arg(long, value_delimiter = ',', value_name = "WHAT")]
    keep: Vec<String>,
}

impl Keep {
    /// Checks the option and returns the accepted findings.
    pub(super) fn acceptance(&self) -> Result<Acceptance, Failure> {
        let mut accepted = Acceptance::default();
        for name in &self.keep {
            if name == "all" {
                accepted = Acceptance::all();
            } else if !accepted.set(name) {
                let known = Acceptance::NAMES.join(", ");
                return Err(Failure::input(format!("--keep {name}: choose among {known}, all")));
            }
        }
        Ok(accepted)
    }
}
