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
mod lanes;
mod list;
mod orient;
mod polish;
mod pose;
mod quartic;
mod real;
mod redundancy;
mod reference;
mod regional;
mod six;
mod solution;
mod subproblem;
mod vector;

pub use arm::{Arm, Family, Query};
pub use axis::Axis;
pub use differential::{Differential, Velocities};
pub use list::List;
pub use pose::Displacement;
pub use redundancy::{Range, Ranges};
pub use reference::Reference;
pub use regional::Regional;
pub use six::{Method, Six};
pub use solution::{Branch, CAPACITY, PoseError, Solution, Solutions, Status};
