//! Detects a joint that sticks at a reversal: it does not move beyond the noise of its encoder,
//! although the filtered position creeps.
//!
//! At a reversal dry friction holds a joint for some hundredths of a second. The low-pass spreads
//! the motion before and after over that time, so the filtered velocity has a sign while the joint
//! stands still. The friction torque balances the other torques and passes from one level to the
//! other. There it is not a function of the velocity.

use std::ops::Range;

use crate::numerics::median::median;

/// Half of the time over which a displacement is measured, s.
const NEAR: f64 = 0.01;
/// Least displacement that counts as motion, in standard deviations of the position's noise.
const NOTHING: f64 = 4.0;
/// Smearing by the low-pass to each side of a stick, as a share of the period of its cutoff.
const SMEAR: f64 = 0.25;
/// Longest stick, s. Beyond it a joint rests, or creeps more slowly than its encoder resolves
/// within [`NEAR`].
const LONGEST: f64 = 0.3;

/// A stretch in which dry friction holds a joint at a reversal.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Stiction {
    /// Samples at which the joint does not move.
    pub held: Range<usize>,
    /// The same samples, extended by the smearing of the low-pass.
    pub seen: Range<usize>,
    /// Sign of the velocity after the stick.
    pub to: f64,
}

impl Stiction {
    /// Sets the expected ratio of dry friction to its level while the joint is held. It passes
    /// linearly from one level to the other, since only the ends of its path are known.
    pub fn put_friction(&self, signs: &mut [f64]) {
        let (from, length) = (self.held.start, self.held.len() as f64);
        for k in self.held.clone() {
            signs[k] = self.to * (2.0 * ((k - from) as f64 + 0.5) / length - 1.0);
        }
    }
}

/// Whether each of `n` samples belongs to one of the sticks.
pub(super) fn stuck(held: &[Stiction], n: usize) -> Vec<bool> {
    let mut marks = vec![false; n];
    held.iter().for_each(|stick| marks[stick.seen.clone()].fill(true));
    marks
}

/// Sticks of a joint at reversals. `raw`, `smooth`: recorded position, unfiltered and behind a
/// low-pass of `cutoff` Hz; `period`: sampling period, s.
pub(super) fn sticks(raw: &[f64], smooth: &[f64], cutoff: f64, period: f64) -> Vec<Stiction> {
    let n = raw.len();
    let mut found = Vec::new();
    let near = ((NEAR / period).round() as usize).max(1);
    if n <= 2 * near {
        return found;
    }
    let least = NOTHING * noise(raw, smooth);
    let still = |k: usize| (raw[k + near] - raw[k - near]).abs() <= least;
    let wide = near + (SMEAR / (cutoff * period)).ceil() as usize;
    let mut k = near;
    while k < n - near {
        if !still(k) {
            k += 1;
            continue;
        }
        let end = (k..n - near).find(|&i| !still(i)).unwrap_or(n - near);
        // A parabola is still for an instant at its top.
        let long = near.div_ceil(2) + 1..=(LONGEST / period) as usize;
        let seen = k.saturating_sub(wide)..(end + wide).min(n);
        if let Some(to) = turns(&smooth[seen.clone()]).filter(|_| long.contains(&(end - k))) {
            found.push(Stiction { held: k - near..end + near, seen, to });
        }
        k = end;
    }
    found
}

/// Sign of the velocity at the end, if the motion returns to the side from which it came.
fn turns(smooth: &[f64]) -> Option<f64> {
    match smooth {
        [first, second, .., before, last] if (second - first) * (last - before) < 0.0 => Some((last - before).signum()),
        _ => None,
    }
}

/// Standard deviation of a position's noise from the median of what the low-pass removes; the
/// median is robust against sticks and reversals.
fn noise(raw: &[f64], smooth: &[f64]) -> f64 {
    let mut out: Vec<f64> = raw.iter().zip(smooth).map(|(a, b)| (a - b).abs()).collect();
    median(&mut out).unwrap_or(0.0) / 0.6745
}

#[cfg(test)]
mod tests {
    use super::super::low_pass;
    use super::*;

    const PERIOD: f64 = 2e-3;

    fn through(q: &[f64]) -> Vec<f64> {
        let mut y = q.to_vec();
        low_pass(4, 15.0, PERIOD.recip()).unwrap().forward_backward(&mut y, 100);
        y
    }

    /// A sine that is held for 50 ms at each of its peaks, read by an encoder.
    #[test]
    fn a_held_joint_sticks_and_a_turning_one_does_not() {
        let read = |q: f64| (q / 2e-5).round() * 2e-5;
        let (turn, hold) = (1.0, 0.05);
        let held: Vec<f64> = (0..4000)
            .map(|k| {
                let t = k as f64 * PERIOD;
                let (half, within) = ((t / turn).floor(), t % turn);
                let angle = std::f64::consts::PI * (half + (within / (turn - hold)).min(1.0));
                read(0.5 * angle.cos())
            })
            .collect();
        let found = sticks(&held, &through(&held), 15.0, PERIOD);
        let stuck = stuck(&found, held.len());
        for k in 200..3800 {
            let within = (k as f64 * PERIOD) % turn;
            if within > turn - hold {
                assert!(stuck[k], "sample {k}");
            } else if within > 0.08 && within < turn - hold - 0.08 {
                assert!(!stuck[k], "sample {k}");
            }
        }
        let free: Vec<f64> = (0..4000).map(|k| read(0.5 * (4.0 * k as f64 * PERIOD).cos())).collect();
        assert_eq!(within(&sticks(&free, &through(&free), 15.0, PERIOD)), 0);
        // The friction passes from one level to the other around the middle of the hold.
        for stick in found.iter().filter(|s| s.held.start > 200 && s.held.end < 3800) {
            let mut signs = vec![0.0; held.len()];
            stick.put_friction(&mut signs);
            let middle = (stick.held.start + stick.held.end) / 2;
            let turn_back = held[stick.held.end + 50] > held[middle];
            assert_eq!(stick.to > 0.0, turn_back);
            assert!(signs[middle].abs() < 0.1 && signs[stick.held.end - 1] * stick.to > 0.9, "{stick:?}");
            assert!(signs[stick.held.start] * stick.to < -0.9 && signs[stick.held.end] == 0.0);
        }
    }

    /// Number of sticks away from the ends.
    fn within(found: &[Stiction]) -> usize {
        found.iter().filter(|s| s.seen.end > 100 && s.seen.start < 3900).count()
    }

    /// A joint that creeps onwards, or rests, does not stick.
    #[test]
    fn creeping_and_resting_are_not_sticking() {
        let read = |q: f64| (q / 1e-4).round() * 1e-4;
        let creeping: Vec<f64> = (0..4000).map(|k| read(5e-3 * k as f64 * PERIOD)).collect();
        let resting: Vec<f64> = (0..4000)
            .map(|k| {
                let t = k as f64 * PERIOD;
                read(if t < 3.0 { (3.0 - t).powi(2) } else { (t - 5.0).max(0.0).powi(2) })
            })
            .collect();
        for q in [creeping, resting] {
            assert_eq!(within(&sticks(&q, &through(&q), 15.0, PERIOD)), 0);
        }
    }
}
