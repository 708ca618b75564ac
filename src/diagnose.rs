//! What a simulation of the robot file gets wrong, why, and what it gains to put it right.
//!
//! [`Motion`](crate::signal::Motion)s -> [`Recording`] -> windows (`scene`) -> every cause of the vocabulary in every place (`causes`) against
//! every other (`search`), everything else refitted (`model`, `moments`) -> what is left (`structure`) -> [`Diagnosis`], measured on logs
//! that were used neither to fit nor to choose.
//!
//! Sees a robot only as a [`Plant`](crate::arm::Plant); prints nothing.

mod calibration;
mod causes;
mod evidence;
mod hold;
mod maps;
mod model;
mod moments;
mod next;
mod noise;
mod offer;
mod record;
mod result;
mod run;
mod scene;
mod search;
mod structure;

#[cfg(test)]
mod tests;

pub use causes::Named;
pub use next::{Separation, separate};
pub use record::{Recording, Stretch};
pub use result::{Cause, Curve, Diagnosis, ErrorMap, Errors, Evidence, NextExperiment, Offer, Offered, Verdict};
pub use run::{DiagnoseError, Settings, diagnose, misses};
pub use search::SearchSettings;
