//! Diagnosis of a simulation of the robot file: its errors, their likely cause, and the gain of
//! mending them on held-out logs.
//!
//! The pipeline is [`Motion`](crate::data::signal::Motion)s -> [`Recording`] -> windows
//! (`windowed_data`) -> every cause of the vocabulary in every place (`hypotheses`) against every
//! other (`search`), everything else refitted (`model`, `moments`) -> remaining structure
//! (`structure`) -> [`Diagnosis`]. It is measured on logs that were used neither to fit nor to
//! choose.
//!
//! Sees a robot only as a [`PerturbableArm`](crate::model::PerturbableArm); prints nothing.

mod attribution;
mod baseline_friction;
mod beside;
mod calibration;
mod candidate;
mod contenders;
mod deflection;
mod evidence;
mod excess;
mod hypotheses;
mod impacts;
mod judge;
mod likelihood;
mod links;
mod maps;
mod measure;
mod merge_bodies;
mod merge_common_delay;
mod model;
mod model_choice;
mod moments;
mod motion_error;
mod next_experiment;
mod possible;
mod recording;
mod reduction;
mod refine_and_select;
mod regulariser;
mod reported_cause;
mod result;
mod robot_file;
mod run;
mod search;
mod simplest_laws;
mod stepwise_exchange;
mod structure;
mod torque_noise;
mod uncertainty;
mod windowed_data;
mod written;

#[cfg(test)]
mod tests;

pub use hypotheses::Named;
pub use next_experiment::{Separation, discriminating_motion};
pub use recording::{HIGHEST, Recording, Stretch, fixed_preparation, preparation};
pub use result::{
    Cause, Curve, Diagnosis, ErrorMap, Errors, Evidence, NextExperiment, Offer, Offered, Verdict, measured_on,
};
pub use robot_file::extended;
pub use run::{DiagnoseError, Settings, diagnose, misses};
pub use search::SearchSettings;
pub use written::written_errors;
