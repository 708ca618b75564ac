//! Inverse kinematics: every posture of a pose, without `std` and without allocation. Shipped along
//! verbatim, and what the interpreter runs.
//!
//! `pose -> closed form of the family -> candidates -> refined with the arm's own Jacobian ->
//! Solutions`. A joint is a line in space ([`Axis`]); which family an arm belongs to was found out
//! when the [`Arm`] was made.

mod arm;
mod axis;
mod candidates;
// [general]
mod dense;
// [/general]
mod differential;
mod doubt;
// [general]
mod elimination;
mod general;
mod harmonics;
// [/general]
// [nearby]
mod homotopy;
// [/nearby]
// [swivel]
mod interval;
// [/swivel]
mod lanes;
mod list;
// [nearby]
mod nearby;
// [/nearby]
// [general]
mod newton;
// [/general]
// [numerical]
mod numerical;
// [/numerical]
// [six|swivel]
mod orient;
// [/six|swivel]
// [plane]
mod plane;
// [/plane]
mod polish;
mod pose;
// [six]
mod quartic;
// [/six]
mod real;
// [six|general]
mod redundancy;
// [/six|general]
mod reference;
// [six]
mod regional;
mod six;
// [/six]
// [general]
mod slides;
// [/general]
mod solution;
mod subproblem;
// [swivel]
mod swivel;
// [/swivel]
mod vector;

pub use arm::{Arm, Family, Query};
pub use axis::Axis;
pub use differential::{Differential, Velocities};
// [general]
pub use general::{CHOICES, General, NO_CHOICE};
// [/general]
// [swivel]
pub use interval::{Interval, Intervals};
// [/swivel]
pub use list::List;
// [plane]
pub use plane::Plane;
// [/plane]
pub use pose::Displacement;
// [six|general]
pub use redundancy::{Range, Ranges};
// [/six|general]
pub use reference::Reference;
// [six]
pub use regional::Regional;
pub use six::{Method, Six};
// [/six]
pub use solution::{Branch, CAPACITY, PoseError, Solution, Solutions, Status};
// [swivel]
pub use swivel::Swivel;
// [/swivel]
