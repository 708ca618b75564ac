//! Mechanics of serial arms, written over expressions.
//!
//! `Robot -> Chain (one form for both DH conventions) -> sweeps -> Kernel (a tape with a
//! signature)`.

pub(crate) mod adjoint;
pub mod base;
pub mod chain;
mod drive;
mod dynamics;
mod energy;
mod formula;
mod inverse;
pub mod kernel;
mod kinematics;
mod motion;
pub mod param;
mod plan;
mod regressor;
mod screw;
mod subspace;
mod turning;
mod wrench;

pub use base::{BaseParameter, BaseParameters};
pub use inverse::Inverse;
pub use kernel::{Argument, Function, Kernel};
pub use kinematics::Pose;
pub use model::Model;

mod model;
