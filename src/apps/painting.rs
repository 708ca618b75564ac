//! Painting a wall with a roller (the paper, sections IV to VI): planning of the motion, and
//! its run against a simulated wall.
//!
//! `Task -> plan -> Plan`: equation (12) with the closed-form inverse, quintics between way points,
//! and every limit.
//!
//! - `surface`: the wall, its axes, how a roller stands on it. `strokes`: the lanes (Fig. 7) and
//!   the legs they are made of.
//! - `track`: postures along a leg; their derivatives are those of Chebyshev polynomials.
//!   `leg_timing`: shortest time, cost of the jerk and broken limits of a leg.
//! - `clearance`: distances. `cost`: a candidate's cost. `search`: the search over candidates, by
//!   `numerics::pattern_search`. `motion`: the joints' spline.
//! - `joint_torques`: what the motion and the wall ask of the joints. `plan`: the result.
//!   `coverage`: the painted area.
//! - [`run`]: a plan under control against the simulated wall ([`wall`]), with the gains of
//!   [`tune`].

mod clearance;
mod cost;
mod coverage;
mod drag_calibration_stroke;
mod joint_torques;
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
pub use joint_torques::joint_torques;
pub use motion::PaintingMotion;
pub use plan::{Infeasible, Moment, Plan, Side, Span, plan};
pub use search::Progress;
pub use strokes::{Leg, Pattern, Phase, Strokes};
pub use surface::{Roller, Surface, SurfaceError};
pub use task::{Cover, Swivel, Task, Weights};

#[cfg(test)]
mod run_tests;
#[cfg(test)]
mod tests;
#[cfg(test)]
mod tune_tests;
