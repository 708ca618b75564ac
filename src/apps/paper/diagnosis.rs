//! The diagnosis put to the test: effects that a seed draws and hides in the simulator, and what
//! the diagnosis makes of the logs.
//!
//! `seed -> arm, task, motion -> simulator (bristles, encoders that step, jitter) -> bytes of a log
//! -> diagnosis -> figures`. The diagnosis gets the robot file and the logs, nothing else.

mod case;
mod draft;
mod hidden;
pub mod real;
mod score;

use std::sync::atomic::{AtomicUsize, Ordering};

use super::ReproduceError;
use super::Watch;
use crate::simulate::Mode;
use case::{Plants, case};

pub use case::{CaseKind, Outcome};
pub use hidden::{Hidden, Wanted};
pub use score::{Claim, Scores, Tally};

/// The cases.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DiagnosisSettings {
    /// How many.
    pub cases: usize,
    /// The first seed; each case has the next.
    pub from: u64,
    /// Root mean square of an effect by the noise of the joint's torque.
    pub size: f64,
    /// Hide nothing: every cause that is named is a false alarm.
    pub clean: bool,
    /// Length of the log to look in, and of the log to measure on, s.
    pub seconds: [f64; 2],
    /// Samples per second.
    pub rate: f64,
    /// How many of the arms, at most 6.
    pub arms: usize,
    /// Control of the arm.
    pub control: Mode,
}

impl Default for DiagnosisSettings {
    fn default() -> Self {
        Self {
            cases: 40,
            from: 1,
            size: 10.0,
            clean: false,
            seconds: [12.0, 8.0],
            rate: 500.0,
            arms: 6,
            control: Mode::Position,
        }
    }
}

/// All cases, by seed.
#[derive(Debug, Clone, PartialEq)]
pub struct Battery {
    /// The kind.
    pub settings: DiagnosisSettings,
    /// One per case.
    pub outcomes: Vec<Outcome>,
    /// The figures.
    pub scores: Scores,
}

/// Runs the cases, two at a time.
pub fn battery(settings: &DiagnosisSettings, watch: Watch<'_>) -> Result<Battery, ReproduceError> {
    let plants = Plants::default();
    let (next, done) = (AtomicUsize::new(0), AtomicUsize::new(0));
    let work = || -> Result<Vec<Outcome>, ReproduceError> {
        let mut found = Vec::new();
        loop {
            let number = next.fetch_add(1, Ordering::Relaxed);
            if number >= settings.cases {
                return Ok(found);
            }
            found.push(case(settings, settings.from + number as u64, &plants)?);
            let done = done.fetch_add(1, Ordering::Relaxed) + 1;
            watch(&format!("{done} of {} cases", settings.cases), done as f64 / settings.cases as f64);
        }
    };
    let threads: Vec<Result<Vec<Outcome>, ReproduceError>> = std::thread::scope(|scope| {
        let handles: Vec<_> = (0..2).map(|_| scope.spawn(work)).collect();
        let lost = || Err(ReproduceError::CaseLost);
        handles.into_iter().map(|h| h.join().unwrap_or_else(|_| lost())).collect()
    });
    let mut outcomes = Vec::with_capacity(settings.cases);
    for part in threads {
        outcomes.extend(part?);
    }
    outcomes.sort_by_key(|o| o.seed);
    let scores = Scores::of(&outcomes);
    Ok(Battery { settings: *settings, outcomes, scores })
}
