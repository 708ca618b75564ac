//! Gain proposals from a linear model of arm, wall, filter and sampling, since the paper tuned
//! gains by hand.
//!
//! [`joint`]: each joint's loop, rigid and as a rotor behind a spring, sampled exactly. [`arm`]:
//! all joint loops together. [`force`]: the force loop around them in one posture, as a sampled
//! system of all joints against the wall's stiffness. Joint and force loops give [`Margins`];
//! [`propose_joint`] and [`propose_force`] search for the fastest gains that keep them.

pub mod arm;
pub mod force;
pub mod joint;
mod sampled;

pub use arm::{ArmPlant, lowered};
pub use force::{ForcePlant, ForceProposal, Step, propose_force};
pub use joint::{JointPlant, JointProposal, propose_joint, wanted_joint};
pub use sampled::{Margins, wanted};
