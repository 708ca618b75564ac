//! The force on the tool without a force sensor: from joint torques, the identified model and what is known of its errors.
//!
//! A [`ForceEstimator`] takes a [`Sample`] (measured torques; what the identified model says of them: torque, mass matrix, Jacobian,
//! covariance) and gives an [`Estimate`]: the wrench that the surroundings exert on the tool, in the tool's axes about its origin, with its
//! covariance. Three ways: [`Residual`] (the paper's equation 14), [`Momentum`] (De Luca's observer, no acceleration), [`Kalman`].
//! [`ContactDetector`] says whether something touches, [`Causal`] makes velocities and accelerations on line.
//! All of these are plain arrays with the number of joints as a constant; they use `core` and `libm` alone.

mod causal;
mod contact;
mod kalman;
mod momentum;
mod residual;
mod sample;
mod small;
mod wrench;

#[cfg(test)]
mod tests;

pub use causal::Causal;
pub use contact::{Contact, ContactDetector, deviate};
pub use kalman::Kalman;
pub use momentum::Momentum;
pub use residual::Residual;
pub use sample::{Estimate, ForceEstimator, NINETY_FIVE, Sample, Scale};
pub use wrench::Weights;
