//! Tests of the diagnosis: a seed draws effects and hides them in the simulator, and the diagnosis
//! has to find them in the logs.
//!
//! `seed -> arm, task, motion -> simulator (bristles, encoder resolution, jitter) -> bytes of a log
//! -> diagnosis -> figures`. The input of the diagnosis is the robot file and the logs, nothing
//! else.

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
pub use score::{Claim, Scores};

/// Settings of the test cases.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DiagnosisSettings {
    /// Number of cases.
    pub cases: usize,
    /// Seed of the first case; each further case has the next.
    pub from: u64,
    /// Root mean square of an effect relative to the noise of the joint's torque.
    pub size: f64,
    /// Whether to hide nothing: every cause named is then a false alarm.
    pub clean: bool,
    /// Lengths of the fitted and the validating log, s.
    pub seconds: [f64; 2],
    /// Sampling rate, Hz.
    pub rate: f64,
    /// Number of arms, at most 6.
    pub arms: usize,
    /// Control mode of the arm.
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

/// Results of all cases, ordered by seed.
#[derive(Debug, Clone, PartialEq)]
pub struct Battery {
    /// Settings of the cases.
    pub settings: DiagnosisSettings,
    /// Outcome of each case.
    pub outcomes: Vec<Outcome>,
    /// Summary figures.
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
