//! Inverse kinematics: every posture of a pose, without `std` and without allocation. Shipped along
//! verbatim, and what the interpreter runs.
//!
//! `pose -> closed form of the family -> candidates -> refined with the arm's own Jacobian ->
//! Solutions`. A joint is a line in space ([`Axis`]); which family an arm belongs to was found out
//! when the [`Arm`] was made.

// Without the other families some of it is unused.
#![allow(unused, irrefutable_let_patterns)]

mod arm;
mod axis;
mod candidates;
mod differential;
mod doubt;
mod homotopy;
mod interval;
mod lanes;
mod list;
mod nearby;
mod orient;
mod polish;
mod pose;
mod real;
mod reference;
mod solution;
mod subproblem;
mod swivel;
mod vector;

pub use arm::{Arm, Family, Query};
pub use axis::Axis;
pub use differential::{Differential, Velocities};
pub use interval::{Interval, Intervals};
pub use list::List;
pub use pose::Displacement;
pub use reference::Reference;
pub use solution::{Branch, CAPACITY, PoseError, Solution, Solutions, Status};
pub use swivel::Swivel;
