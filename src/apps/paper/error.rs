//! Why an experiment could not be run.

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

/// Why an experiment could not be run.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ReproduceError {
    /// A built-in file, or one that was written from it.
    #[error("the built-in robot can't be used: {0}")]
    Robot(#[source] Problems),
    /// Bodies of the built-in robot are absent, so that there is nothing to compare with.
    #[error("the built-in robot can't be used: its links are not all known")]
    UnknownLinks,
    /// The catalogue has no tool of this name.
    #[error("the catalogue has no tool `{0}`")]
    NoTool(String),
    /// A part of the experiment that the next step needs was not made.
    #[error("the experiment has no {0}")]
    Missing(&'static str),
    /// The motion or the plan.
    #[error("{what}: {obstacle}")]
    Design {
        /// The motion.
        what: String,
        /// The obstacle.
        #[source]
        obstacle: DesignObstacle,
    },
    /// A hidden effect that none of the arms shows.
    #[error("no arm can show what seed {seed} hides")]
    NothingToShow {
        /// Seed of the case.
        seed: u64,
    },
    /// A thread of the battery ended early.
    #[error("a case could not be run to its end")]
    CaseLost,
    /// The simulation.
    #[error(transparent)]
    Simulate(#[from] SimulateError),
    /// A simulated log can't be written as CSV.
    #[error("a simulated log can't be written: {0}")]
    Write(#[source] std::io::Error),
    /// The log.
    #[error(transparent)]
    Prepare(#[from] PrepareError),
    /// The fit.
    #[error(transparent)]
    Identify(#[from] IdentifyError),
    /// Standard parameters from the fit.
    #[error(transparent)]
    Recover(#[from] RecoverError),
    /// Possible bodies from the fit.
    #[error(transparent)]
    Consistent(#[from] ConsistentError),
    /// The contact force.
    #[error(transparent)]
    Estimate(#[from] TooManyJoints),
    /// The diagnosis.
    #[error(transparent)]
    Diagnose(#[from] DiagnoseError),
    /// The fit of what is carried.
    #[error(transparent)]
    Tool(#[from] ToolError),
    /// The run against the wall.
    #[error(transparent)]
    Paint(#[from] RunError),
}

impl ReproduceError {
    /// The mistakes of the file of this name.
    pub(super) fn in_file(name: &str) -> impl Fn(Problems) -> Self + '_ {
        move |problems| Self::Robot(problems.in_file(name))
    }

    /// What keeps this motion or plan from being made.
    pub(super) fn design<E: Into<DesignObstacle>>(what: &str) -> impl Fn(E) -> Self + '_ {
        move |obstacle| Self::Design { what: what.into(), obstacle: obstacle.into() }
    }
}

/// What keeps a motion or a plan from being made.
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
    /// The arm does not reach the wall from before it.
    #[error("a place before the wall is out of reach")]
    OutOfReach,
    /// The wall.
    #[error(transparent)]
    Surface(#[from] SurfaceError),
    /// The robot's limits.
    #[error(transparent)]
    Limits(#[from] LimitsError),
    /// The exciting motion.
    #[error(transparent)]
    Excite(#[from] DesignError),
    /// The plan of the wall.
    #[error(transparent)]
    Plan(#[from] Infeasible),
}
