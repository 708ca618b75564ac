//! From motion and torque to base parameters, with honest standard deviations.
//!
//! [`Motion`](crate::data::signal::Motion)s -> [`QrAccumulator`]: one triangular factor per joint
//! -> [`solve`]: weighted least squares on the small stacked factors -> [`Identification`]. The log
//! passes once; weights, essential parameters, validation and standard deviations all come from the
//! factors.
//!
//! ```
//! use denavit::model::Arm;
//! use denavit::identify::*;
//! use denavit::data::log;
//! use denavit::report;
//! use denavit::data::signal::{Prepare, each_motion};
//!
//! fn run(arm: &dyn Arm, fit: &[u8], validate: &[u8], prior: Vec<f64>) -> Result<String, Box<dyn std::error::Error>> {
//!     let prepare = Prepare::default(); // the paper's filter; `keep`, `trim`, `torque` as the user says
//!     let stack = |name: &str, bytes: &[u8]| -> Result<_, Box<dyn std::error::Error>> {
//!         let mut stack = QrAccumulator::new(name, arm, AccumulatorSettings::default());
//!         let mut source = log::open(name, bytes)?; // any `Read`: CSV, CSV gzipped, Parquet
//!         let prepared = each_motion(source.as_mut(), arm.dof(), &prepare, |motion| stack.absorb(motion))?;
//!         Ok((stack.finish(), prepared))
//!     };
//!     let ((fit_factors, a), (validate_factors, b)) = (stack("fit.csv", fit)?, stack("validate.csv", validate)?);
//!     let settings = IdentifySettings { prior: Some(prior.clone()), essential: Some(Essential::default()), ..Default::default() };
//!     let found = solve(arm, &[fit_factors], &[validate_factors], &settings)?;
//!     let _for_the_robot_file = recover_standard(arm, &found.values(), Some(&prior))?;
//!     let logs = [a, b];
//!     let warnings = report::identify_warnings(&found, &logs, None, None);
//!     let _json = report::identify_json(&found, &logs, &warnings, &[]).to_string();
//!     // For the page's curves a log is read once more.
//!     let mut tracer = Tracer::new("validate.csv", true, arm, &found.values());
//!     each_motion(log::open("validate.csv", validate)?.as_mut(), arm.dof(), &prepare, |motion| tracer.absorb(motion))?;
//!     let _page = report::identify_html(&found, &logs, &warnings, &[tracer.finish()], None, &[]);
//!     Ok(report::identify_text(&found, &logs, &warnings))
//! }
//! ```
//!
//! Sees a robot only as an [`Arm`](crate::model::Arm), but for [`recording`], which makes one of a
//! robot file; prints nothing.

mod budget;
mod consistent;
mod known_effects;
mod portable;
pub mod recording;
pub(crate) mod regression;
mod result;
mod solve;
pub mod tool;
pub(crate) mod validation;

#[cfg(test)]
pub(crate) mod planar;
#[cfg(test)]
mod tests;

pub use budget::{BudgetCollector, ErrorBudget, thinned, torque_of_errors};
pub use consistent::{
    BoundedLeastSquares, Bounds, Consistent, ConsistentError, ConsistentSettings, Cost, Feasible, PriorBody,
    Reproduced, Source, Stalled, body_of, buildable_links, consistent, geometric_bodies, possible_bodies, prior_bodies,
    pseudo_inertia,
};
pub use known_effects::KnownEffects;
pub use portable::{FactorError, KeyedFactors, RecordingFactor};
pub use recording::{FactoredRecording, RecordingReader};
pub use regression::accumulator::{AccumulatorSettings, Factors, JointFactor, QrAccumulator};
pub use regression::essential::{Dropped, Essential};
pub use regression::known_parameters::Known;
pub use regression::nonnegative::{Nonnegative, nonnegative_drives};
pub use regression::r_factor::RFactor;
pub(crate) use regression::r_factor::{dot, dots_of};
pub use regression::recover::{RecoverError, implausible_links, recover_standard};
pub use regression::statistics::Noise;
pub use result::{Condition, Confused, Estimate, Identification, LogSummary, Standing, Underdetermined};
pub use solve::{IdentifyError, IdentifySettings, solve};
pub use validation::accuracy::{Accuracy, accuracy};
pub use validation::extrapolation::{Extrapolation, extrapolation};
pub use validation::left_out::{LeftOutError, left_out};
pub use validation::preference::{Better, Preference, preference};
pub use validation::torque_columns::{Reference, TorqueColumns};
pub use validation::trace::{Trace, TraceJoint, Tracer};
