//! Painting a wall with a roller (the paper, sections IV to VI): the motion is planned here, and
//! run.
//!
//! `Task -> plan -> Plan`: equation (12) with the closed-form inverse, quintics between way points,
//! and every limit.
//!
//! - `surface`: the wall, its axes, how a roller stands on it. `strokes`: the lanes (Fig. 7) and
//!   the legs they are made of.
//! - `track`: postures along a leg. `chebyshev`: their derivatives. `pace`: how fast a leg can be,
//!   what its jerk costs, what it breaks.
//! - `surroundings`: distances. `score`: a candidate's cost. `compass`, `search`: the search.
//!   `motion`: the joints' spline.
//! - `plan`: what comes out. `cover`: what it paints.
//! - [`run`]: a plan under control against the simulated wall ([`wall`]), with the gains of
//!   [`tune`].

mod clearance;
mod cost;
mod coverage;
mod drag_calibration_stroke;
mod leg_timing;
mod motion;
mod plan;
pub mod run;
mod search;
mod strokes;
mod surface;
mod task;
mod track;
pub mod tune;
mod vector;
pub mod wall;

pub use coverage::Coverage;
pub use motion::Motion;
pub use plan::{Infeasible, Moment, Plan, Side, Span, plan};
pub use search::Progress;
pub use strokes::{Leg, Pattern, Phase, Strokes};
pub use surface::{Roller, Surface};
pub use task::{Cover, Swivel, Task, Weights};

#[cfg(test)]
mod run_tests;
#[cfg(test)]
mod tests;
#[cfg(test)]
mod tune_tests;
