//! Why a command of the fleet can't do its work.

use std::path::PathBuf;

use datafusion::error::DataFusionError;
use denavit::identify::{FactorError, IdentifyError};

/// Why there is no result. A recording that can't be used is none of these: it is a row.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum FleetError {
    /// No access.
    #[error("{path} can't be {verb}: {source}")]
    File {
        /// File or folder.
        path: PathBuf,
        /// What was tried: `read`, `written`.
        verb: &'static str,
        /// What the system says.
        source: std::io::Error,
    },
    /// All mistakes in a robot file, with their places.
    #[error("{0}")]
    Robot(String),
    /// A factor without its robot.
    #[error("a factor is of a robot file with SHA-256 {digest}, and no --robot has it; give that file")]
    UnknownRobot {
        /// Digest in the factor.
        digest: String,
    },
    /// Bytes that are no factor, or of another robot.
    #[error(transparent)]
    Factor(#[from] FactorError),
    /// No model of a robot.
    #[error("{what}: {source}")]
    Identify {
        /// Robot or recording.
        what: String,
        /// Reason.
        source: IdentifyError,
    },
    /// No reference.
    #[error("{what}: no joint of its reference has a torque; look into its recordings")]
    NoReference {
        /// Robot.
        what: String,
    },
    /// Nothing to do.
    #[error("{path} has no {what}; {advice}")]
    Empty {
        /// Folder or table.
        path: PathBuf,
        /// What is missing.
        what: &'static str,
        /// What to do.
        advice: &'static str,
    },
    /// A folder that another run writes.
    #[error("another run writes to {path}; wait for its end, or give another folder")]
    Busy {
        /// Folder.
        path: PathBuf,
    },
    /// An option out of range.
    #[error("{0}")]
    Option(String),
    /// A worker process that failed.
    #[error("worker {number} failed; run the same command again: only the missing files are read")]
    Worker {
        /// From 1.
        number: usize,
    },
    /// Workers on other machines.
    #[error("no worker answers ({why}); start some with `denavit-fleet worker --listen ADDRESS:PORT`")]
    NoWorker {
        /// Why not, for each.
        why: String,
    },
    /// The engine.
    #[error("{0}")]
    Engine(#[source] DataFusionError),
}

impl FleetError {
    /// Exit status: 2 for wrong use or bad input, 1 otherwise.
    pub fn status(&self) -> u8 {
        match self {
            Self::Busy { .. }
            | Self::Worker { .. }
            | Self::NoWorker { .. }
            | Self::File { verb: "written" | "started" | "listened on", .. } => 1,
            _ => 2,
        }
    }
}

impl From<DataFusionError> for FleetError {
    fn from(error: DataFusionError) -> Self {
        match error {
            // Our own, on its way through the engine.
            DataFusionError::External(inner) => match inner.downcast::<Self>() {
                Ok(own) => *own,
                Err(other) => Self::Engine(DataFusionError::External(other)),
            },
            error => Self::Engine(error),
        }
    }
}

impl From<FleetError> for DataFusionError {
    fn from(error: FleetError) -> Self {
        match error {
            FleetError::Engine(error) => error,
            error => Self::External(Box::new(error)),
        }
    }
}
