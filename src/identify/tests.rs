//! Tests of the whole identification on the planar arm: exact without noise, correct standard
//! deviations with noise, and reports of undetermined parameters.

mod fit;
mod honesty;
mod logs;
mod portable;
mod speed;
mod unexcited;
mod wrong;

use super::AccumulatorSettings;
use super::Factors;
use super::Identification;
use super::IdentifySettings;
use super::QrAccumulator;
use super::planar::{Normal, Planar};
use super::solve;
use crate::data::signal::{Motion, low_pass};

fn factors(arm: &Planar, motions: &[Motion]) -> Factors {
    let mut stack = QrAccumulator::new("test", arm, AccumulatorSettings::default());
    motions.iter().for_each(|m| stack.absorb(m));
    stack.finish()
}

fn identify(arm: &Planar, motions: &[Motion]) -> Identification {
    solve(arm, &[factors(arm, motions)], &[], &IdentifySettings::default()).unwrap()
}

/// Adds noise to the torques, N m per joint: white, or white noise filtered by the zero-phase
/// default low-pass.
fn add_noise(motion: &mut Motion, sigma: [f64; 2], filtered: bool, seed: u64) {
    let len = motion.states.len;
    let mut normal = Normal::new(seed);
    for (joint, sigma) in sigma.into_iter().enumerate() {
        let mut noise: Vec<f64> = (0..len).map(|_| sigma * normal.next()).collect();
        if filtered {
            low_pass(5, 10.0, motion.period.recip()).unwrap().forward_backward(&mut noise, 200);
        }
        motion.tau[joint * len..(joint + 1) * len].iter_mut().zip(noise).for_each(|(t, n)| *t += n);
    }
}
