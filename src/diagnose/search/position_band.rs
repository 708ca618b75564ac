//! Band of the positions, chosen by the torques.
//!
//! The low-pass of a log's positions fits the noise of its encoders. A torque may follow the motion
//! less far: a sensor may filter it, and a link does not follow the vibration of its motor. Motion
//! beyond that band then looks like inertia, springs and couplings. The measured torques stay
//! unfiltered, so that models behind several low-passes of the positions explain the same data, and
//! the one that explains most is the likeliest.

use super::candidate::evaluate;
use crate::diagnose::fit::model::{Mode, ModelUnderTest};
use crate::diagnose::hypotheses::hypothesis;
use crate::diagnose::windows::low_passed::PositionBand;
use crate::diagnose::windows::recording::{HIGHEST, Recording};
use crate::model::PerturbableArm;
use dh_codegen::robot::EffectKind;

/// Ratio of neighbouring cutoffs, and the lowest, Hz.
const STEP: f64 = 0.7;
const LOWEST: f64 = 2.5;

/// Mean over joints of the logarithm of the ratio of squared errors above which a narrower band is
/// better.
const BETTER: f64 = 0.1;

/// Difference of two of these means below which the wider band is taken.
const ALIKE: f64 = 0.02;

/// Loss beside the best cutoff so far below which no lower one is tried.
const PAST: f64 = 0.2;

/// The low-pass behind which all base parameters and friction, refitted, explain the torques surely
/// better; `None` if there is none.
pub(in crate::diagnose) fn position_band(
    plant: &dyn PerturbableArm,
    recordings: &[Recording],
    rate: f64,
) -> Option<PositionBand> {
    if !plant.has_bodies() {
        return None;
    }
    let wide = errors(plant, recordings, rate);
    let mut tried: Vec<(f64, f64)> = Vec::new();
    let mut most = 0.0_f64;
    let cutoffs = std::iter::successors(Some(STEP * HIGHEST), |cutoff| Some(STEP * cutoff));
    for cutoff in cutoffs.take_while(|cutoff| *cutoff >= LOWEST) {
        let narrow: Vec<Recording> = recordings.iter().map(|r| r.low_passed(cutoff)).collect();
        let gain = gain(&wide, &errors(plant, &narrow, rate));
        tried.push((cutoff, gain));
        most = most.max(gain);
        if gain.is_nan() || gain <= most - PAST {
            break;
        }
    }
    let near = tried.into_iter().find(|(_, gain)| most > BETTER && *gain > most - ALIKE);
    near.map(|(cutoff, gain)| PositionBand { cutoff, removes: 1.0 - (-gain).exp() })
}

/// Mean squared error of each joint, (N m)^2, with all base parameters, friction and a delay of the
/// torques fitted.
fn errors(plant: &dyn PerturbableArm, recordings: &[Recording], rate: f64) -> Vec<f64> {
    let mut refit = ModelUnderTest::new(plant, recordings, rate, Mode::Refitted, &plant.delays(), false);
    let plain = refit.fit(&mut []);
    let delay = hypothesis(EffectKind::TimeDelay);
    let shapes = delay.grid(&refit.scene, &[], &plain.residual);
    let delayed = shapes.iter().filter_map(|shape| evaluate(&refit, &plain, delay, &[], shape));
    let rss = delayed.max_by(|a, b| a.score.total_cmp(&b.score)).map_or(plain.solution.rss, |c| c.gain.rss);
    rss.iter().zip(&plain.solution.counts).map(|(rss, count)| rss / count.max(1.0)).collect()
}

/// Mean over joints of the logarithm of the ratio of two squared errors.
fn gain(before: &[f64], after: &[f64]) -> f64 {
    let known = before.iter().zip(after).filter(|(a, b)| **a > 0.0 && **b > 0.0);
    let (sum, count) = known.fold((0.0, 0.0), |(sum, count), (a, b)| (sum + (a / b).ln(), count + 1.0));
    if count > 0.0 { sum / count } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gains_count_alike_on_all_joints() {
        let half = gain(&[4.0, 1e-6], &[2.0, 5e-7]);
        assert!((half - 2.0_f64.ln()).abs() < 1e-12);
        assert!(gain(&[4.0, 1.0], &[2.0, 2.0]).abs() < 1e-12);
        // A joint without torque does not count.
        assert!((gain(&[4.0, 0.0], &[2.0, 0.0]) - half).abs() < 1e-12);
        assert_eq!(gain(&[0.0], &[0.0]), 0.0);
    }
}
