//! What a simulation of the robot file gets wrong, why, and what it gains to put it right.
//!
//! [`Motion`](crate::signal::Motion)s -> [`Recording`] -> windows (`scene`) -> every cause of the vocabulary in every place (`causes`) against
//! every other (`search`), everything else refitted (`model`, `moments`) -> what is left (`structure`) -> [`Diagnosis`], measured on logs
//! that were used neither to fit nor to choose.
//!
//! Sees a robot only as a [`Plant`](crate::arm::Plant); prints nothing.

mod calibration;
mod candidate;
mod causes;
mod evidence;
mod hold;
mod item;
mod judge;
mod links;
mod maps;
mod measure;
mod model;
mod moments;
mod next;
mod noise;
mod offer;
mod plain;
mod possible;
mod record;
mod result;
mod run;
mod scene;
mod search;
mod settle;
mod stay;
mod structure;
mod swap;
mod uncertainty;
mod unite;
mod weigh;
mod written;

#[cfg(test)]
mod tests;

/// Where a recording's second cutoff is, by its first: see [`Prepare::bursts`](crate::signal::Prepare::bursts). A joint that breaks away catches up with the
/// bandwidth of its loop, some 10 Hz, in steps that are shorter.
pub const BURSTS: f64 = 8.0 / 3.0;

pub use causes::Named;
pub use next::{Separation, separate};
pub use record::{Recording, Stretch};
pub use result::{Cause, Curve, Diagnosis, ErrorMap, Errors, Evidence, NextExperiment, Offer, Offered, Verdict};
pub use run::{DiagnoseError, Settings, diagnose, misses};
pub use search::SearchSettings;
pub use written::written_errors;
