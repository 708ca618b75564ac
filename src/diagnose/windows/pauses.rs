//! Parts of logs in which the whole arm stands.

use super::recording::Recording;
use crate::model::States;

/// Length of a block of samples, s.
const BLOCK: f64 = 0.03;

/// Largest distance from where a pause began, rad (m): a slow motion is none.
const STILL: f64 = 2e-3;

/// Part of a pause at either end that is left out, s: joints settle, and brakes and controllers switch.
const SETTLING: f64 = 0.2;

/// Largest relative difference of the blocks of two logs. Pauses of logs at quite another rate than the
/// first are left out.
const ALIKE: f64 = 0.2;

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
            let (speed, place) = (blocks(&stretch.states.dq), blocks(&stretch.states.q));
            let torque = blocks(&stretch.tau);
            let count = torque.first().map_or(0, Vec::len);
            let rests = |b: usize| speed.iter().zip(zones).all(|(v, zone)| v[b].abs() <= *zone);
            let stays = |from: usize, b: usize| place.iter().all(|q| (q[b] - q[from]).abs() <= STILL);
            let settling = (SETTLING / (per as f64 * stretch.period)).ceil() as usize;
            let mut begun = 0;
            for b in 0..=count {
                if b < count && rests(b) && stays(begun, b) {
                    continue;
                }
                let [from, b, next] = [begun + settling, b.saturating_sub(settling), b + 1];
                begun = next;
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
            }
        }
    }
    let first = found.first().map_or(BLOCK, |pause: &Pause| pause.block);
    found.retain(|pause| (pause.block / first - 1.0).abs() <= ALIKE);
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
        for joint in [0, len] {
            stretch.states.q[joint + 200..joint + 520].fill(0.3);
            stretch.states.dq[joint + 200..joint + 520].fill(0.004);
        }
        stretch.states.q[700..1000].fill(0.3);
        stretch.states.dq[700..1000].fill(0.0);
        let found = pauses(&[recording], &[0.005, 0.005]);
        let long: Vec<&Pause> = found.iter().filter(|p| p.len() > 2).collect();
        assert_eq!(long.len(), 1);
        let [start, end] = [long[0].start, long[0].start + long[0].len() as f64 * long[0].block];
        // From 1 s to 2.6 s of a log that begins at -2 s, less what settles.
        assert!((start - 3.2).abs() < 0.061 && (end - 4.4).abs() < 0.061, "{start} {end}");
        assert!(long[0].torque.iter().flatten().all(|tau| *tau == 1.0) && long[0].per == 6);
    }
}
