//! Residual torques of a segment of motion at the samples used.

use super::torques::Torques;
use crate::data::signal::{DeadZone, Filter, Motion, MotionBlock, low_pass};
use crate::identify::regression::rows::Rows;
use crate::model::{Arm, States};

/// Residual torques and what the estimators need with them; joint-major over the used samples
/// unless noted.
#[derive(Debug, Default)]
pub(super) struct ResidualTorque {
    /// Indices of the motion's samples that are used.
    pub samples: Vec<usize>,
    /// Their times, s.
    pub time: Vec<f64>,
    /// Model minus measured torque, low-passed, N m.
    pub external: Vec<f64>,
    /// Smearing of `external` by the low-pass, N m: the part removed by a second pass approximates
    /// the part removed by the first.
    pub smear: Vec<f64>,
    /// Regressor entries, entry-major.
    pub entries: Vec<f64>,
    /// Whether a joint is at rest, so that its Coulomb friction may be anything between its levels.
    pub still: Vec<bool>,
    /// Whether the joint is at rest within the range that the low-pass smears.
    pub near_rest: Vec<bool>,
    /// Accelerations used in `model` at all samples of the motion, rad/s^2; zero where a joint
    /// stands.
    pub ddq: Vec<f64>,
    /// Model torque at *all* samples of the motion, joint-major, N m: unfiltered, with the sensor's
    /// gain divided out.
    pub model: Vec<f64>,
    /// Measured torque, laid out and scaled as `model`.
    pub tau: Vec<f64>,
    /// Measured wrench, low-passed, component-major; empty where the log has none.
    pub measured: Vec<f64>,
}

/// Evaluates the model along the whole motion and low-passes the residual, so that friction steps
/// that the model reproduces do not pass through the filter. The motion's torques are raw, with
/// margins.
pub(super) fn pick(
    arm: &dyn Arm,
    rows: &Rows,
    torques: &dyn Torques,
    motion: &Motion,
    filter: Option<Filter>,
) -> ResidualTorque {
    let (n, len) = (arm.dof(), motion.states.len);
    let time: Vec<f64> = (0..len).map(|s| motion.time(s)).collect();
    let mut picked =
        ResidualTorque { samples: motion.picks().collect(), model: vec![0.0; n * len], ..ResidualTorque::default() };
    picked.time = picked.samples.iter().map(|&s| time[s]).collect();
    let still = still(motion, n);
    let mut states = motion.states.clone();
    let mut sign = motion.sign.clone();
    at_rest(&still, motion.period, &mut states, &mut sign);
    torques.since(motion.segment_start, &time, &states, &sign, &motion.temperature, &mut picked.model);
    picked.ddq = states.ddq;
    picked.tau.clone_from(&motion.tau);
    for j in 0..n {
        let gain = torques.gain(j);
        for values in [&mut picked.model, &mut picked.tau] {
            values[j * len..(j + 1) * len].iter_mut().for_each(|t| *t /= gain);
        }
    }
    let rate = motion.period.recip();
    let sos = filter.and_then(|f| low_pass(f.order, f.cutoff, rate).ok().map(|sos| (sos, f.cutoff)));
    let smooth = |values: &mut [f64], out: &mut Vec<f64>| {
        if let Some((sos, cutoff)) = &sos {
            sos.forward_backward(values, sos.scipy_padding().max((rate / cutoff).ceil() as usize));
        }
        out.extend(picked.samples.iter().map(|&s| values[s]));
    };
    let (mut external, mut measured, mut smear) = (Vec::new(), Vec::new(), Vec::new());
    for j in 0..n {
        let range = j * len..(j + 1) * len;
        let mut left: Vec<f64> =
            picked.model[range.clone()].iter().zip(&picked.tau[range]).map(|(m, t)| m - t).collect();
        smooth(&mut left, &mut external);
        if sos.is_some() {
            smooth(&mut left, &mut smear);
        } else {
            smear.extend(picked.samples.iter().map(|&s| left[s]));
        }
    }
    smear.iter_mut().zip(&external).for_each(|(twice, once)| *twice -= once);
    // A sensor column with a gap counts as no measurement.
    if motion.wrench.len() == 6 * len && motion.wrench.iter().all(|f| f.is_finite()) {
        for column in motion.wrench.chunks_exact(len.max(1)) {
            smooth(&mut column.to_vec(), &mut measured);
        }
    }
    (picked.external, picked.measured, picked.smear) = (external, measured, smear);
    let count = picked.samples.len();
    let entries = arm.base_pattern().len();
    picked.entries = vec![0.0; entries * count];
    picked.still = still.chunks_exact(len.max(1)).flat_map(|row| picked.samples.iter().map(|&s| row[s])).collect();
    picked.near_rest =
        near(&still, len, filter.map_or(0, |f| (SMEAR / (f.cutoff * motion.period)).ceil() as usize), &picked.samples);
    let (mut block, mut regressor, mut from) = (MotionBlock::default(), Vec::new(), 0);
    loop {
        let got = motion.gather(from, 256, &mut block);
        if got == 0 {
            break;
        }
        let sign_of = |j: usize, s: usize| if sign.is_empty() { 0.0 } else { sign[j * len + picked.samples[from + s]] };
        block.sign = (0..if sign.is_empty() { 0 } else { n * got }).map(|k| sign_of(k / got, k % got)).collect();
        rows.evaluate(arm, &block.states, &block.sign, &mut regressor);
        for (k, entry) in regressor.chunks_exact(got).enumerate() {
            picked.entries[k * count + from..k * count + from + got].copy_from_slice(entry);
        }
        from += got;
    }
    picked
}

/// Smearing of the low-pass to each side, as a share of the period of its cutoff.
const SMEAR: f64 = 0.25;
/// Time within the dead zone, s, beyond which a joint stands and its acceleration is zero too.
const STANDS: f64 = 0.3;

/// Whether each joint's friction may be anything between its levels, joint-major. This holds at
/// rest, when sticking at a reversal, and below half a percent of the joint's largest speed in the
/// motion. Below it, the ringing of the low-pass after a stop changes the sign of the velocity. A
/// given dead zone is the only criterion if there is one.
fn still(motion: &Motion, n: usize) -> Vec<bool> {
    let len = motion.states.len;
    let mut still = motion.resting.get(..n * len).map_or_else(|| vec![false; n * len], <[bool]>::to_vec);
    if motion.dead_zone != DeadZone::FromNoise {
        return still;
    }
    if motion.stuck.len() == n * len {
        still.iter_mut().zip(&motion.stuck).for_each(|(s, stuck)| *s |= stuck);
    }
    for (still, speed) in still.chunks_exact_mut(len.max(1)).zip(motion.states.dq.chunks_exact(len.max(1))) {
        let slow = 0.005 * speed.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
        still.iter_mut().zip(speed).for_each(|(s, v)| *s |= v.abs() < slow);
    }
    still
}

/// Sets the velocity of joints at rest to zero in the model's friction, and the acceleration of
/// those that stand.
fn at_rest(still: &[bool], period: f64, states: &mut States, sign: &mut [f64]) {
    let len = states.len.max(1);
    states.dq.iter_mut().zip(still).filter(|(_, still)| **still).for_each(|(v, _)| *v = 0.0);
    sign.iter_mut().zip(still).filter(|(_, still)| **still).for_each(|(s, _)| *s = 0.0);
    for (row, ddq) in still.chunks_exact(len).zip(states.ddq.chunks_exact_mut(len)) {
        let mut from = 0;
        for run in row.chunk_by(|a, b| a == b) {
            if run[0] && run.len() as f64 * period > STANDS {
                ddq[from..from + run.len()].fill(0.0);
            }
            from += run.len();
        }
    }
}

/// Whether a joint is at rest within `within` samples of each used one, joint-major over `picks`.
fn near(still: &[bool], len: usize, within: usize, picks: &[usize]) -> Vec<bool> {
    let of = |row: &[bool]| -> Vec<bool> {
        let reach = |s: usize| s.saturating_sub(within)..(s + within + 1).min(row.len());
        picks.iter().map(|&s| row[reach(s)].contains(&true)).collect()
    };
    still.chunks_exact(len.max(1)).flat_map(of).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A given dead zone is the only definition of rest: the speed threshold does not apply.
    #[test]
    fn a_given_dead_zone_holds_alone() {
        let states = States { len: 4, dq: vec![0.001, 0.004, -0.5, 1.0], ..States::default() };
        let motion = Motion { states, resting: vec![true, false, false, false], ..Motion::default() };
        assert_eq!(still(&motion, 1), [true, true, false, false]);
        let given = |dead_zone, resting: [bool; 4]| Motion { dead_zone, resting: resting.to_vec(), ..motion.clone() };
        assert_eq!(still(&given(DeadZone::Fixed(0.002), [true, false, false, false]), 1), [true, false, false, false]);
        assert_eq!(still(&given(DeadZone::Off, [false; 4]), 1), [false; 4]);
    }
}
