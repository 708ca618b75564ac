//! Painting a wall with a roller (the paper, sections IV to VI): motion planning, and simulated
//! runs against a wall.
//!
//! `Task -> plan -> Plan`: equation (12) with the closed-form inverse kinematics, quintics between
//! way points, and all limits.
//!
//! - `surface`: the wall, its axes, and the roller's pose on it. `strokes`: the lanes (Fig. 7) and
//!   the legs between their way points.
//! - `track`: postures along a leg; derivatives are those of Chebyshev polynomials. `leg_timing`:
//!   shortest time, jerk cost and violated limits of a leg.
//! - `clearance`: distances. `cost`: cost of a candidate. `search`: search over candidates with
//!   `numerics::pattern_search`. `motion`: spline of the joint motion.
//! - `joint_torques`: joint torques due to motion and wall. `plan`: the result. `coverage`: the
//!   painted area.
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
