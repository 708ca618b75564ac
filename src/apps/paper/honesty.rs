//! Validity of the stated standard deviations: many runs with other noise, and the estimates'
//! errors relative to their own standard deviations.

use super::ReproduceError;
use super::Watch;
use super::chain::{factors, fit};
use super::fig6::mean;
use super::lwr::Lwr;
use super::many::many;
use crate::model::Arm;
use crate::simulate::Recording;

/// Statistics over many runs.
#[derive(Debug, Clone, PartialEq)]
pub struct Honesty {
    /// Number of runs.
    pub runs: usize,
    /// Share of estimates, over all runs and parameters, within three of their own standard
    /// deviations of the truth.
    pub within_three: f64,
    /// Share of 95 % bands, 1.96 standard deviations to either side, that contain the truth.
    pub within_band: f64,
    /// Per base parameter: name, share of 95 % bands that contain the truth, and root mean square
    /// of the normalised errors (1 if the standard deviation is correct).
    pub parameters: Vec<(String, f64, f64)>,
    /// Root mean square of all normalised errors.
    pub spread: f64,
    /// Held-out RMS relative to the noise floor, mean over runs and joints.
    pub held_out: f64,
}

/// Half-width of a 95 % band, in standard deviations of a normal error.
const BAND: f64 = 1.96;

/// Required share within three standard deviations; a normal error has 99.73 %.
pub const ASKED: f64 = 0.99;

/// Stride after the low-pass: every tenth sample, as those between are nearly redundant.
pub const STRIDE: usize = 10;

/// Makes `runs` runs over the same motions with other noise in the fitted and in the validating
/// log. `floor` is the sensors' noise after the low-pass, N m per joint.
pub fn honesty(
    lwr: &Lwr,
    recording: &Recording,
    validating: &Recording,
    floor: &[f64],
    runs: usize,
    seed: u64,
    watch: Watch<'_>,
) -> Result<Honesty, ReproduceError> {
    let p = lwr.truth.len();
    let one = |run: usize| {
        let noisy = |what: &Recording, kind: u64| {
            let log = what.seen_by(&Lwr::sensors(), seed.wrapping_add(2 * run as u64 + kind));
            factors("run", &lwr.arm, &log, STRIDE)
        };
        let found = fit(lwr, &noisy(recording, 1)?, &noisy(validating, 2)?)?;
        let distance = |(e, truth): (&crate::identify::Estimate, &f64)| (e.value - truth) / e.std;
        let distances: Vec<f64> = found.parameters.iter().zip(&lwr.truth).map(distance).collect();
        let rms = found.validation.as_ref().map_or(f64::NAN, |v| mean(&v.rms));
        Ok((distances, rms / mean(floor)))
    };
    let (mut within, mut squares, mut held_out) = (vec![0.0; p], vec![0.0; p], 0.0);
    let mut banded = 0.0;
    for (distances, ratio) in many(runs, &one, watch)? {
        held_out += ratio;
        for (k, z) in distances.iter().enumerate() {
            within[k] += f64::from(u8::from(z.abs() <= 3.0));
            banded += f64::from(u8::from(z.abs() <= BAND));
            squares[k] += z * z;
        }
    }
    let count = runs.max(1) as f64;
    let names = lwr.arm.base_parameters().iter().map(|b| b.name.clone());
    Ok(Honesty {
        runs,
        within_three: mean(&within) / count,
        within_band: banded / (count * p.max(1) as f64),
        spread: (mean(&squares) / count).sqrt(),
        held_out: held_out / count,
        parameters: names
            .zip(within.iter().zip(&squares))
            .map(|(name, (w, s))| (name, w / count, (s / count).sqrt()))
            .collect(),
    })
}
