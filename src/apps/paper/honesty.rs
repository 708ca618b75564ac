//! Are the standard deviations honest? Many runs with other noise, and how far the estimates lie
//! from the truth in their own standard deviations.

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
    /// Runs.
    pub runs: usize,
    /// Estimates within three of their own standard deviations of the truth, over all runs and
    /// parameters: a share.
    pub within_three: f64,
    /// The same of 95 % bands, 1.96 standard deviations to either side.
    pub within_band: f64,
    /// Per base parameter: name, that share, and the root mean square of the distances (1 if all is
    /// well).
    pub parameters: Vec<(String, f64, f64)>,
    /// Root mean square of all distances.
    pub spread: f64,
    /// Mean over runs and joints of the held-out RMS, by the noise floor.
    pub held_out: f64,
}

/// Half of a 95 % band, in standard deviations of a normal error.
const BAND: f64 = 1.96;

/// At least this share is asked for; a normal error has 99.73 %.
pub const ASKED: f64 = 0.99;

/// Every tenth sample after the low-pass, as it leaves nothing between them.
pub const STRIDE: usize = 10;

/// Runs `runs` times over the same motions with noise of other seeds, in the log that is fitted and
/// in the one that validates. `floor`: what the low-pass leaves of the sensors' noise, N m per
/// joint.
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
