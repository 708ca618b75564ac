//! Proposes gains, since the paper tuned them by hand: bandwidth and margins from a linear model of
//! arm, wall, filter and sampling.
//!
//! [`joint`]: each joint's loop, rigid and as a rotor behind a spring, sampled exactly. [`arm`]:
//! all of them together. [`force`]: the loop around it in a posture, as a sampled system of all
//! joints against the wall's stiffness. Both give [`Margins`]; [`propose_joint`] and
//! [`propose_force`] search for the fastest gains that keep them.

pub mod arm;
pub mod force;
pub mod joint;
mod sampled;

pub use arm::{ArmPlant, lowered};
pub use force::{ForcePlant, ForceProposal, Step, propose_force};
pub use joint::{JointPlant, JointProposal, propose_joint, wanted_joint};
pub use sampled::{Margins, wanted};
