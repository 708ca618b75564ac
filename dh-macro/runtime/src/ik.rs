//! Inverse kinematics: every posture of a pose, without `std` and without allocation. Shipped along verbatim, and what the
//! interpreter runs.
//!
//! `pose -> closed form of the family -> candidates -> refined with the arm's own Jacobian -> Solutions`. A joint is a line in
//! space ([`Axis`]); which family an arm belongs to was found out when the [`Arm`] was made.

mod arm;
mod axis;
mod candidates;
mod doubt;
mod homotopy;
mod interval;
mod lanes;
mod list;
mod nearby;
mod numerical;
mod orient;
mod plane;
mod polish;
mod pose;
mod quartic;
mod real;
mod regional;
mod six;
mod solution;
mod subproblem;
mod swivel;
mod vector;

pub use arm::{Arm, Family, Query};
pub use axis::Axis;
pub use interval::{Interval, Intervals};
pub use list::List;
pub use plane::Plane;
pub use pose::Displacement;
pub use regional::Regional;
pub use six::{Method, Six};
pub use solution::{Branch, CAPACITY, PoseError, Solution, Solutions, Status};
pub use swivel::{Reference, Swivel};
