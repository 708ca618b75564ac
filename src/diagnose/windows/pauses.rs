//! Parts of logs in which the whole arm stands.

use super::recording::Recording;
use crate::model::States;

/// Length of a block of samples, s.
const BLOCK: f64 = 0.03;

/// A part of a log in which no joint moves.
pub(in crate::diagnose) struct Pause {
    /// Time of its first block since the log began, s.
    pub(in crate::diagnose) start: f64,
    /// Length of a block, s.
    pub(in crate::diagnose) block: f64,
    /// Number of samples of a block.
    pub(in crate::diagnose) per: usize,
    /// Torque per joint and block, N m.
    pub(in crate::diagnose) torque: Vec<Vec<f64>>,
    /// Its posture: one state.
    pub(in crate::diagnose) posture: States,
}

impl Pause {
    /// Number of blocks.
    pub(in crate::diagnose) fn len(&self) -> usize {
        self.torque.first().map_or(0, Vec::len)
    }
}

/// Mean of each block of `per` samples.
fn means(x: &[f64], per: usize) -> Vec<f64> {
    x.chunks_exact(per).map(|block| block.iter().sum::<f64>() / per as f64).collect()
}

/// Pauses of these logs. `zones`: speed of each joint up to which it is at rest, rad/s.
pub(in crate::diagnose) fn pauses(recordings: &[Recording], zones: &[f64]) -> Vec<Pause> {
    let mut found = Vec::new();
    for recording in recordings {
        for stretch in &recording.stretches {
            let per = ((BLOCK / stretch.period).round() as usize).max(1);
            let blocks = |x: &[f64]| (0..zones.len()).map(|j| means(stretch.of(x, j), per)).collect::<Vec<_>>();
            let (speed, torque) = (blocks(&stretch.states.dq), blocks(&stretch.tau));
            let count = torque.first().map_or(0, Vec::len);
            let rests = |b: usize| speed.iter().zip(zones).all(|(v, zone)| v[b].abs() <= *zone);
            let mut from = 0;
            for b in 0..=count {
                if b < count && rests(b) {
                    continue;
                }
                let middle = ((from + b) / 2 * per).min(stretch.states.len.saturating_sub(1));
                if b > from {
                    found.push(Pause {
                        start: stretch.start - recording.begin + (from * per) as f64 * stretch.period,
                        block: per as f64 * stretch.period,
                        per,
                        torque: torque.iter().map(|row| row[from..b].to_vec()).collect(),
                        posture: stretch.states.part(middle, middle + 1),
                    });
                }
                from = b + 1;
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnose::tests::columns::recording;

    /// The arm moves but for two parts, in one of which only one joint stands.
    #[test]
    fn the_whole_arm_stands() {
        let mut recording = recording();
        recording.begin = -2.0;
        let stretch = &mut recording.stretches[0];
        let len = stretch.states.len;
        stretch.states.dq[200..320].fill(0.0);
        stretch.states.dq[len + 200..len + 320].fill(0.004);
        stretch.states.dq[600..800].fill(0.0);
        let found = pauses(&[recording], &[0.005, 0.005]);
        let long: Vec<&Pause> = found.iter().filter(|p| p.len() > 2).collect();
        assert_eq!(long.len(), 1);
        let [start, end] = [long[0].start, long[0].start + long[0].len() as f64 * long[0].block];
        assert!((start - 3.0).abs() < 0.031 && (end - 3.6).abs() < 0.031, "{start} {end}");
        assert!(long[0].torque.iter().flatten().all(|tau| *tau == 1.0) && long[0].per == 6);
    }
}
