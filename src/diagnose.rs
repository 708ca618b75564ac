//! Diagnosis of a simulation of the robot file: its errors, their likely cause, and the gain of
//! mending them on held-out logs.
//!
//! The pipeline is [`Motion`](crate::data::signal::Motion)s -> [`Recording`] -> windows
//! (`windowed_data`) -> every cause of the vocabulary in every place (`hypotheses`) against every
//! other (`search`), everything else refitted (`fit`) -> what holds on other data (`select`) ->
//! remaining structure (`findings`) -> [`Diagnosis`]. It is measured on logs that were not fitted.
//!
//! Sees a robot only as a [`PerturbableArm`](crate::model::PerturbableArm); prints nothing.

mod excerpts;
mod findings;
mod fit;
mod hypotheses;
mod next_experiment;
mod robot_file;
mod run;
mod search;
mod select;
mod windows;
mod written;

#[cfg(test)]
mod tests;

pub use findings::result::{
    Cause, Curve, Diagnosis, ErrorMap, Errors, Evidence, NextExperiment, Offer, Offered, Rejected, Verdict, measured_on,
};
pub use hypotheses::{Named, Quantity, Symbol};
pub use next_experiment::{Separation, discriminating_motion};
pub use robot_file::extended;
pub use run::{DiagnoseError, Settings, diagnose, misses};
pub use search::SearchSettings;
pub use windows::holding::{Coming, Holding, Thinning, Use};
pub use windows::low_passed::PositionBand;
pub use windows::recording::{HIGHEST, Recording, Stretch, fixed_preparation, preparation};
pub use written::written_errors;
