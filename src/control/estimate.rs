//! Estimation of the external wrench on the tool without a force sensor, from joint torques, the
//! identified model and its uncertainty.
//!
//! A [`ForceEstimator`] takes an [`EstimatorInput`]: measured torques and the identified model's
//! torque, mass matrix, Jacobian and covariance. It returns an [`Estimate`]: the wrench that the
//! surroundings exert on the tool, in the tool's axes about its origin, with its covariance. There
//! are three estimators: [`Residual`] (the paper's equation 14), [`Momentum`] (De Luca's observer,
//! no acceleration) and [`Kalman`]. [`ContactDetector`] detects contact; [`StateVariableFilter`]
//! computes velocities and accelerations online. All of these are plain arrays with the number of
//! joints as a constant; they use `core` and `libm` alone.
//!
//! On logs: [`Motion`](crate::data::signal::Motion)s -> [`Run`] -> [`Series`], with an
//! [`Uncertainty`] from an identification, and a [`Consistency`] that checks the band.
//! docs/force.md defines the band and gives its measured coverage.
//!
//! Accesses a robot only through traits; prints nothing.

mod bias;
mod consistency;
mod contact;
mod kalman;
mod method;
mod momentum;
mod noise;
mod random_walk_rate;
mod residual;
mod residual_torque;
mod run;
mod sample;
mod series;
mod small_matrix;
mod state_variable_filter;
pub(crate) mod stiction;
mod torques;
mod uncertainty;
mod verdict;
mod wrench;

#[cfg(test)]
mod tests;

pub use bias::{Bias, BiasPass};
pub use consistency::Consistency;
pub use contact::{Contact, ContactDetector, deviate};
pub use kalman::Kalman;
pub use method::{MOST_JOINTS, Method};
pub use momentum::Momentum;
pub use noise::NoisePass;
pub use residual::Residual;
pub use run::{EstimationSettings, Known, Run, TooManyJoints};
pub use sample::{Estimate, EstimatorInput, ForceEstimator, NINETY_FIVE, Scale};
pub use series::{COMPONENTS, Comparison, Series};
pub use state_variable_filter::StateVariableFilter;
pub use torques::{Effected, Linear, Torques};
pub use uncertainty::{NoiseSource, Uncertainty, covariance};
pub use verdict::Verdict;
pub use wrench::Weights;
