//! Are the standard deviations honest? Many runs with other noise, and how far the estimates lie from the truth in their own standard deviations.

use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

use super::chain::{factors, fit};
use super::fig6::mean;
use super::lwr::Lwr;
use super::{ReproduceError, Watch};
use crate::arm::Arm;
use crate::identify::Factors;
use crate::simulate::Recording;

/// What many runs show.
#[derive(Debug, Clone, PartialEq)]
pub struct Honesty {
    /// Runs.
    pub runs: usize,
    /// Estimates within three of their own standard deviations of the truth, over all runs and parameters: a share.
    pub within_three: f64,
    /// Per base parameter: name, that share, and the root mean square of the distances (1 if all is well).
    pub parameters: Vec<(String, f64, f64)>,
    /// Root mean square of all distances.
    pub spread: f64,
    /// Mean over runs and joints of the held-out RMS, by that of the noise in the same log.
    pub held_out: f64,
}

/// At least this share is asked for; a normal error has 99.73 %.
pub const ASKED: f64 = 0.99;

/// Every tenth sample after the low-pass, as it leaves nothing between them.
pub const STRIDE: usize = 10;

/// Runs `runs` times over the same motion with noise of other seeds. `floor`: noise of each joint in the log that validates, N m (RMS of the true
/// parameters there, so that one log's luck does not count).
pub fn honesty(
    lwr: &Lwr,
    recording: &Recording,
    validate: &Factors,
    floor: &[f64],
    runs: usize,
    seed: u64,
    watch: Watch<'_>,
) -> Result<Honesty, ReproduceError> {
    let p = lwr.truth.len();
    let threads = std::thread::available_parallelism().map_or(1, usize::from).min(runs.max(1));
    let (next, done) = (AtomicUsize::new(0), AtomicUsize::new(0));
    type One = Result<(Vec<f64>, f64), ReproduceError>;
    let all: Mutex<Vec<(usize, One)>> = Mutex::new(Vec::new());
    let one = |run: usize| -> One {
        let log = recording.seen_by(&Lwr::sensors(), seed.wrapping_add(1 + run as u64));
        let found = fit(lwr, &factors("run", &lwr.arm, &log, STRIDE)?, validate)?;
        let distance = |(e, truth): (&crate::identify::Estimate, &f64)| (e.value - truth) / e.std;
        let rms = found.validation.as_ref().map_or(f64::NAN, |v| mean(&v.rms));
        Ok((found.parameters.iter().zip(&lwr.truth).map(distance).collect(), rms / mean(floor)))
    };
    std::thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                loop {
                    let run = next.fetch_add(1, Ordering::Relaxed);
                    if run >= runs {
                        break;
                    }
                    let result = one(run);
                    let share = (done.fetch_add(1, Ordering::Relaxed) + 1) as f64 / runs as f64;
                    watch(&format!("run {} of {runs}", done.load(Ordering::Relaxed)), share);
                    if let Ok(mut all) = all.lock() {
                        all.push((run, result));
                    }
                }
            });
        }
    });
    let mut all = all.into_inner().unwrap_or_default();
    // Sums in the order of the runs: the same bits whoever was first.
    all.sort_by_key(|(run, _)| *run);
    let (mut within, mut squares, mut held_out) = (vec![0.0; p], vec![0.0; p], 0.0);
    for (_, result) in all {
        let (distances, ratio) = result?;
        held_out += ratio;
        for (k, z) in distances.iter().enumerate() {
            within[k] += f64::from(u8::from(z.abs() <= 3.0));
            squares[k] += z * z;
        }
    }
    let count = runs.max(1) as f64;
    let names = lwr.arm.base_parameters().iter().map(|b| b.name.clone());
    Ok(Honesty {
        runs,
        within_three: mean(&within) / count,
        spread: (mean(&squares) / count).sqrt(),
        held_out: held_out / count,
        parameters: names
            .zip(within.iter().zip(&squares))
            .map(|(name, (w, s))| (name, w / count, (s / count).sqrt()))
            .collect(),
    })
}
