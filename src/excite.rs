//! Exciting motions: as much information about the parameters as possible in a short time, within
//! all limits (the paper, section III).
//!
//! `robot -> Task -> Program (criterion, constraints, their gradients) -> sqp -> Design`, many
//! starts in parallel; `check` checks a written motion and shares no code with any of that.
//!
//! - `curve`: splines and Fourier series as linear functions of the search variables; bounds that
//!   hold between samples.
//! - `columns`, `extra`: selection of regressor columns. `information`, `criterion`: their
//!   evaluation.
//! - `bodies`, `constraints`: torque, ground, spheres, boxes. `program`: all of it as one nonlinear
//!   program.
//! - `sqp`, `subproblem`: the solver. `start`: its starting points. `design`: several starts, grids
//!   from coarse to fine.
//! - `precision`: expected standard deviations of the parameters. `shortest`: the shortest motion
//!   that reaches a target. `durations`: gain of longer motions.

mod bodies;
pub mod check;
mod columns;
mod constraints;
mod criterion;
mod curve;
mod design;
mod durations;
mod error;
mod extra;
mod information;
mod limits;
mod precision;
mod program;
mod shortest;
mod sqp;
mod start;
mod subproblem;
mod task;

pub use bodies::{Ball, Block, Bodies, Pair};
pub use columns::Columns;
pub use constraints::{Constraint, Worst};
pub use criterion::Criterion;
pub use curve::Curve;
pub use design::{Design, Effort, Progress, Record, Watch, design, discriminate};
pub use durations::{AtDuration, by_duration};
pub use error::{DesignError, LimitsError, MotionError, ShortestError};
pub use extra::{Extra, FrictionCoverage};
pub use information::{Conditions, Information};
pub use limits::{JointLimits, Missing};
pub use precision::{Expected, expected, known_from, known_values, nominal};
pub use shortest::{Shortest, shortest};
pub use task::Task;

#[cfg(test)]
mod tests;
