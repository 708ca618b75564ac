//! Detects impacts in a gear's backlash: short errors that follow the changes of sign of one
//! joint's load.
//!
//! A link in a gap flies freely from where its load changes sign until it strikes the other side.
//! With the load `s t` and the inertia `m` that takes `(6 m BL / s)^(1/3)`, some hundredths of a
//! second. The impact lasts for milliseconds, above the band of the recorded motion, so no column
//! computed from that motion contains it. It appears as a spike of the torques, at an instant that
//! the load predicts.

use std::ops::Range;

use super::evidence::short;
use super::result::Cause;
use super::structure::Structure;
use crate::diagnose::hypotheses::Named;
use crate::diagnose::select::excess::EXCESS;
use crate::diagnose::select::measure::{Measured, share};
use crate::diagnose::select::refine_and_select::Selected;
use crate::diagnose::windows::windowed_data::WindowedData;
use crate::numerics::median::median;
use dh_codegen::robot::EffectKind;
use dh_codegen::robot::effects;

/// Ratio of an error to its usual size above which it belongs to a spike.
const SPIKE: f64 = 6.0;
/// Time between two spikes, s, below which they count as one.
const ONE: f64 = 0.04;
/// Longest flight through a gap, s.
const FLIGHT: f64 = 0.25;
/// Least number of impacts that is distinguished from chance. Least share of the load's changes of
/// sign, and of the spikes' energy, that match each other.
const FEWEST: usize = 4;
const SHARE: f64 = 0.6;
/// Largest spread of the logarithms of the gaps from single flights.
const SPREAD: f64 = 0.7;
/// Error of the law of the flight, as a share of the gap.
const LAW: f64 = 0.25;
/// Time between a spike and a joint's own reversal, s, below which friction causes it.
const REVERSAL: f64 = 0.04;

/// A spike of the error.
#[derive(Debug, Clone, PartialEq)]
struct Spike {
    run: usize,
    /// Time of its largest sample, s.
    time: f64,
    /// Range of samples.
    span: Range<usize>,
    /// Sum of squares relative to the usual size.
    energy: f64,
}

/// A change of sign of a load.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Crossing {
    run: usize,
    time: f64,
    /// Rate of the load divided by the inertia behind the gap, rad/s^3.
    jerk: f64,
}

/// Impacts of one joint.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::diagnose) struct Impacts {
    /// Joint, from 0.
    joint: usize,
    /// Gap, rad, and its standard deviation.
    gap: [f64; 2],
    /// Shortest and longest flight, s.
    flights: [f64; 2],
    /// Number of changes of sign of the load, and of those followed by an impact.
    crossings: usize,
    followed: usize,
    /// Share of the spikes' energy in these impacts.
    energy: f64,
    /// Samples with an impact.
    spans: Vec<Range<usize>>,
}

/// Sum over joints of squared errors relative to each joint's usual size, and the largest summand.
fn by_usual(error: &[Vec<f64>]) -> (Vec<f64>, Vec<f64>) {
    let len = error.first().map_or(0, Vec::len);
    let (mut sum, mut largest) = (vec![0.0; len], vec![0.0_f64; len]);
    for row in error {
        let mut sizes: Vec<f64> = row.iter().map(|e| e.abs()).collect();
        let usual = median(&mut sizes).unwrap_or(0.0) / 0.6745;
        if usual <= 0.0 {
            continue;
        }
        for (k, e) in row.iter().enumerate() {
            let part = (e / usual).powi(2);
            sum[k] += part;
            largest[k] = largest[k].max(part);
        }
    }
    (sum, largest)
}

/// Spikes of errors (per joint and sample) in contiguous runs.
fn spikes(error: &[Vec<f64>], time: &[f64], runs: &[Range<usize>]) -> Vec<Spike> {
    let (sum, largest) = by_usual(error);
    let mut found: Vec<Spike> = Vec::new();
    for (number, run) in runs.iter().enumerate() {
        let mut peak = 0.0;
        for k in run.clone().filter(|&k| largest[k] > SPIKE * SPIKE) {
            match found.last_mut().filter(|s| s.run == number && time[k] - time[s.span.end - 1] < ONE) {
                Some(last) => {
                    last.span.end = k + 1;
                    last.energy += sum[k];
                    if largest[k] > peak {
                        (peak, last.time) = (largest[k], time[k]);
                    }
                }
                None => {
                    peak = largest[k];
                    found.push(Spike { run: number, time: time[k], span: k..k + 1, energy: sum[k] });
                }
            }
        }
    }
    found
}

/// Changes of sign of a series: run, window before it, and time by linear interpolation, s.
fn zeros<'a>(series: &'a [f64], scene: &'a WindowedData<'_>) -> impl Iterator<Item = (usize, usize, f64)> + 'a {
    let runs = scene.runs.iter().enumerate();
    runs.flat_map(|(number, run)| run.clone().zip(run.clone().skip(1)).map(move |pair| (number, pair))).filter_map(
        move |(number, (w, next))| {
            let [a, b] = [series[w], series[next]];
            (a * b < 0.0).then(|| (number, w, scene.time[w] + scene.step * a / (a - b)))
        },
    )
}

/// Changes of sign of the load of joint `j`.
fn crossings(scene: &WindowedData<'_>, j: usize) -> Vec<Crossing> {
    let load = scene.transmitted(j);
    if load.iter().all(|t| *t == 0.0) {
        return Vec::new();
    }
    let slopes = scene.slopes(j);
    let at = |(run, w, time): (usize, usize, f64)| {
        let inertia = slopes.acceleration[j][w] - scene.rotors[j];
        let rate = (load[w + 1] - load[w]).abs() / scene.step;
        (inertia > 0.0).then(|| Crossing { run, time, jerk: rate / inertia })
    };
    zeros(&load, scene).filter_map(at).collect()
}

/// Whether a spike coincides with a reversal of joint `j`.
fn at_a_reversal(spike: &Spike, scene: &WindowedData<'_>, j: usize) -> bool {
    let [_, velocity, _] = scene.motion_of(j);
    zeros(velocity, scene).any(|(run, _, time)| run == spike.run && (time - spike.time).abs() < REVERSAL)
}

/// Impacts of the joint with these changes of sign, if the spikes match them.
fn of_joint(joint: usize, crossings: &[Crossing], spikes: &[Spike]) -> Option<Impacts> {
    let after = |c: &Crossing| {
        let next = spikes.iter().filter(|s| s.run == c.run && s.time > c.time);
        next.map(|s| (s, s.time - c.time)).find(|(_, flight)| *flight < FLIGHT)
    };
    let pairs: Vec<(&Spike, f64, f64)> =
        crossings.iter().filter_map(|c| after(c).map(|(s, t)| (s, t, c.jerk * t.powi(3) / 6.0))).collect();
    let all: f64 = spikes.iter().map(|s| s.energy).sum();
    // Two changes of sign during one flight share an impact.
    let mut spans: Vec<Range<usize>> = pairs.iter().map(|p| p.0.span.clone()).collect();
    spans.dedup();
    let energy =
        spikes.iter().filter(|s| spans.contains(&s.span)).map(|s| s.energy).sum::<f64>() / all.max(f64::MIN_POSITIVE);
    let mut gaps: Vec<f64> = pairs.iter().map(|p| p.2).collect();
    let gap = median(&mut gaps)?;
    let mut apart: Vec<f64> = gaps.iter().map(|g| (g / gap).ln().abs()).collect();
    let off = median(&mut apart)? / 0.6745;
    let (crossings, followed) = (crossings.len(), pairs.len());
    let together = followed as f64 >= SHARE * crossings as f64 && energy >= SHARE;
    (spans.len() >= FEWEST && together && off < SPREAD).then(|| Impacts {
        joint,
        gap: [gap, gap * LAW.hypot(off / (followed as f64).sqrt())],
        flights: [
            pairs.iter().map(|p| p.1).fold(f64::INFINITY, f64::min),
            pairs.iter().map(|p| p.1).fold(0.0, f64::max),
        ],
        crossings,
        followed,
        energy,
        spans,
    })
}

/// Impacts in the errors of a model on the fitted logs.
pub(in crate::diagnose) fn impacts(model: &Selected<'_>) -> Option<Impacts> {
    let (scene, left) = (&model.tested.scene, &model.after_fit);
    let spikes = spikes(&left.error, &left.time, &left.runs);
    if spikes.len() < FEWEST || left.runs.len() != scene.runs.len() {
        return None;
    }
    let of = |j: usize| {
        let found = of_joint(j, &crossings(scene, j), &spikes)?;
        // Wrong friction causes spikes at the reversals of its joint.
        let turning = spikes.iter().filter(|s| at_a_reversal(s, scene, j)).count();
        (2 * turning < spikes.len()).then_some(found)
    };
    let sure = |i: &Impacts| i.energy * i.followed as f64 / i.crossings as f64;
    (0..scene.dof()).filter_map(of).max_by(|a, b| sure(a).total_cmp(&sure(b)))
}

impl Impacts {
    /// Root mean square error of each joint without the samples of impacts, N m.
    fn elsewhere(&self, measured: &Measured) -> Vec<f64> {
        let hit = |k: usize| self.spans.iter().any(|s| s.contains(&k));
        let of = |error: &Vec<f64>| {
            let (sum, n) = error
                .iter()
                .enumerate()
                .filter(|(k, _)| !hit(*k))
                .fold((0.0, 0.0), |(sum, n), (_, e)| (sum + e * e, n + 1.0));
            (sum / f64::max(n, 1.0)).sqrt()
        };
        measured.error.iter().map(of).collect()
    }

    /// Drops structure that consists of impacts alone.
    pub(in crate::diagnose) fn explain(
        &self,
        left: Vec<Structure>,
        measured: &Measured,
        floor: &[f64],
    ) -> Vec<Structure> {
        let rest = self.elsewhere(measured);
        left.into_iter().filter(|s| rest[s.joint] > EXCESS * floor[s.joint]).collect()
    }

    /// The impacts as a cause. Its error is limited to single samples, which no law of the file
    /// predicts.
    pub(in crate::diagnose) fn cause(&self, measured: &Measured, noise: &[f64]) -> Cause {
        let (j, rest) = (self.joint, self.elsewhere(measured));
        let probability = self.energy.min(self.followed as f64 / self.crossings as f64).min(0.97);
        let [gap, std] = self.gap;
        Cause {
            joints: vec![j + 1],
            probability,
            parameters: vec![Named::new(effects::Backlash::BL, gap, Some(std)).of_joint(Some(j + 1))],
            share: share(&measured.rms, &rest, noise, &[j]),
            evidence: format!(
                "joint {}: {} of {} changes of sign of the load are followed by an impact, {} to {} s later, as in a gap of {} rad; these impacts carry {:.0} % of the energy of all spikes. The model does not play them: they lie above the band of the recorded motion",
                j + 1,
                self.followed,
                self.crossings,
                short(self.flights[0]),
                short(self.flights[1]),
                short(gap),
                100.0 * self.energy
            ),
            rms_before: measured.rms.clone(),
            rms_after: rest,
            ..Cause::of_effect(EffectKind::Backlash)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn spike(time: f64, number: usize) -> Spike {
        Spike { run: 0, time, span: 10 * number..10 * number + 3, energy: 100.0 }
    }

    /// Flights through a gap, under loads that change at different rates.
    fn flights(gap: f64) -> (Vec<Crossing>, Vec<Spike>) {
        let jerks = [20.0, 50.0, 8.0, 120.0, 30.0, 70.0];
        let at = |k: usize| 1.0 + 2.0 * k as f64;
        let crossings = jerks.iter().enumerate().map(|(k, &jerk)| Crossing { run: 0, time: at(k), jerk }).collect();
        let hits = jerks.iter().enumerate().map(|(k, jerk)| spike(at(k) + (6.0 * gap / jerk).cbrt(), k)).collect();
        (crossings, hits)
    }

    #[test]
    fn flights_give_the_gap() {
        let (crossings, spikes) = flights(2e-3);
        let found = of_joint(3, &crossings, &spikes).unwrap();
        assert!((found.gap[0] / 2e-3 - 1.0).abs() < 1e-9 && found.followed == 6 && found.energy == 1.0);
        // Spikes at other instants do not belong to this joint.
        let early: Vec<Spike> = spikes.iter().map(|s| Spike { time: s.time - 0.4, ..s.clone() }).collect();
        assert_eq!(of_joint(3, &crossings, &early), None);
        // Three impacts are not enough.
        assert_eq!(of_joint(3, &crossings[..3], &spikes[..3]), None);
    }

    #[test]
    fn a_spike_is_one() {
        let time: Vec<f64> = (0..1000).map(|k| 0.002 * f64::from(k)).collect();
        let mut error = vec![vec![0.0; 1000]; 2];
        for (k, e) in error[0].iter_mut().enumerate() {
            *e = if k % 2 == 0 { 0.1 } else { -0.1 };
        }
        error[0][400] = 2.0;
        error[0][405] = -3.0;
        error[0][700] = 2.0;
        let found = spikes(&error, &time, std::slice::from_ref(&(0..1000)));
        assert_eq!(found.iter().map(|s| s.span.clone()).collect::<Vec<_>>(), [400..406, 700..701]);
        assert_eq!(found[0].time, time[405]);
    }
}
