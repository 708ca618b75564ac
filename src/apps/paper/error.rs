//! Errors of the experiments.

use dh_codegen::robot::Problems;

use crate::apps::painting::run::RunError;
use crate::apps::painting::{Infeasible, SurfaceError};
use crate::control::estimate::TooManyJoints;
use crate::data::signal::PrepareError;
use crate::diagnose::DiagnoseError;
use crate::excite::{DesignError, LimitsError};
use crate::identify::tool::ToolError;
use crate::identify::{ConsistentError, IdentifyError, RecoverError};
use crate::simulate::SimulateError;

/// Reason why an experiment could not be run.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ReproduceError {
    /// A built-in file, or one written from it, is invalid.
    #[error("the built-in robot can't be used: {0}")]
    Robot(#[source] Problems),
    /// Link parameters of the built-in robot are missing, so there is no reference.
    #[error("the built-in robot can't be used: its links are not all known")]
    UnknownLinks,
    /// The catalogue has no tool of this name.
    #[error("the catalogue has no tool `{0}`")]
    NoTool(String),
    /// A result of the experiment that the next step needs is missing.
    #[error("the experiment has no {0}")]
    Missing(&'static str),
    /// A motion or plan could not be made.
    #[error("{what}: {obstacle}")]
    Design {
        /// Name of the motion or plan.
        what: String,
        /// The obstacle.
        #[source]
        obstacle: DesignObstacle,
    },
    /// None of the arms shows the hidden effect.
    #[error("no arm can show what seed {seed} hides")]
    NothingToShow {
        /// Seed of the case.
        seed: u64,
    },
    /// A thread of the battery ended early.
    #[error("a case could not be run to its end")]
    CaseLost,
    /// The simulation failed.
    #[error(transparent)]
    Simulate(#[from] SimulateError),
    /// A simulated log can't be written as CSV.
    #[error("a simulated log can't be written: {0}")]
    Write(#[source] std::io::Error),
    /// The log could not be prepared.
    #[error(transparent)]
    Prepare(#[from] PrepareError),
    /// The identification failed.
    #[error(transparent)]
    Identify(#[from] IdentifyError),
    /// Standard parameters could not be recovered from the fit.
    #[error(transparent)]
    Recover(#[from] RecoverError),
    /// No physically consistent bodies were found from the fit.
    #[error(transparent)]
    Consistent(#[from] ConsistentError),
    /// The contact force could not be estimated.
    #[error(transparent)]
    Estimate(#[from] TooManyJoints),
    /// The diagnosis failed.
    #[error(transparent)]
    Diagnose(#[from] DiagnoseError),
    /// The fit of the payload failed.
    #[error(transparent)]
    Tool(#[from] ToolError),
    /// The run against the wall failed.
    #[error(transparent)]
    Paint(#[from] RunError),
}

impl ReproduceError {
    /// Error for the problems of the file of this name.
    pub(super) fn in_file(name: &str) -> impl Fn(Problems) -> Self + '_ {
        move |problems| Self::Robot(problems.in_file(name))
    }

    /// Error for a motion or plan that could not be made.
    pub(super) fn design<E: Into<DesignObstacle>>(what: &str) -> impl Fn(E) -> Self + '_ {
        move |obstacle| Self::Design { what: what.into(), obstacle: obstacle.into() }
    }
}

/// Reason why a motion or a plan could not be made.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum DesignObstacle {
    /// The roller's length and width are not known.
    #[error("the tool has no size")]
    ToolSize,
    /// More joints than the inverse kinematics has room for.
    #[error("too many joints")]
    TooManyJoints,
    /// The search ended outside the limits.
    #[error("no motion inside all limits was found")]
    OutsideLimits,
    /// The arm cannot reach the start before the wall.
    #[error("a place before the wall is out of reach")]
    OutOfReach,
    /// Invalid wall.
    #[error(transparent)]
    Surface(#[from] SurfaceError),
    /// Invalid or missing limits of the robot.
    #[error(transparent)]
    Limits(#[from] LimitsError),
    /// The exciting motion could not be designed.
    #[error(transparent)]
    Excite(#[from] DesignError),
    /// The wall could not be planned.
    #[error(transparent)]
    Plan(#[from] Infeasible),
}
