//! From motion and torque to base parameters, with standard deviations that can be believed.
//!
//! [`Motion`](crate::signal::Motion)s -> [`Stack`]: one triangular factor per joint -> [`solve`]: weighted least squares on the small
//! stacked factors -> [`Identification`]. The log passes once; weights, essential parameters, validation and standard deviations
//! all come from the factors.
//!
//! ```
//! use denavit::{arm::Arm, identify::*, log, report, signal::{Prepare, each_motion}};
//!
//! fn run(arm: &dyn Arm, fit: &[u8], validate: &[u8], prior: Vec<f64>) -> Result<String, Box<dyn std::error::Error>> {
//!     let prepare = Prepare::default(); // the paper's filter; `keep`, `trim`, `torque` as the user says
//!     let stack = |name: &str, bytes: &[u8]| -> Result<_, Box<dyn std::error::Error>> {
//!         let mut stack = Stack::new(name, arm, StackSettings::default());
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
//! Sees a robot only as an [`Arm`](crate::arm::Arm); prints nothing.

mod accuracy;
mod batches;
mod carry;
mod consistent;
mod disagree;
mod essential;
mod known;
mod left_out;
mod nonnegative;
mod preference;
mod recover;
mod result;
pub(crate) mod rows;
mod sign;
mod solve;
mod spectrum;
mod stack;
mod statistics;
mod trace;
mod triangle;
mod unexplained;
mod wls;

#[cfg(test)]
pub(crate) mod planar;
#[cfg(test)]
mod tests;

pub use accuracy::{Accuracy, accuracy};
pub use carry::{CarryOver, carry_over};
pub use consistent::{
    BoundedLeastSquares, Bounds, Consistent, ConsistentError, ConsistentSettings, Cost, Feasible, PriorBody,
    Reproduced, Source, Stalled, body_of, consistent, geometric_bodies, possible_bodies, prior_bodies, pseudo_inertia,
};
pub use essential::{Dropped, Essential};
pub use known::Known;
pub use left_out::{LeftOutError, left_out};
pub use nonnegative::{Nonnegative, nonnegative_drives};
pub use preference::{Better, Preference, preference};
pub use recover::{RecoverError, implausible_links, recover_standard};
pub use result::{Condition, Confused, Estimate, Identification, LogSummary, Standing, Underdetermined};
pub use solve::{IdentifyError, IdentifySettings, solve};
pub use stack::{Factors, JointFactor, Stack, StackSettings};
pub use statistics::Noise;
pub use trace::{Trace, TraceJoint, Tracer};
pub use triangle::Triangle;
pub(crate) use triangle::dot;
