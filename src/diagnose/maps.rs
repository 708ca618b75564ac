//! Maps of an error: against velocity, position, acceleration, load and time, and its spectrum.

use super::result::ErrorMap;
use super::scene::Scene;

/// Bins of a map.
const BINS: usize = 48;

/// Longest section of a spectrum, s: the resolution is its inverse.
const SECTION: f64 = 4.0;

/// Sections that a spectrum averages at most, spread over the data.
const SECTIONS: usize = 24;

/// Highest frequency of a spectrum, Hz.
const HIGHEST: f64 = 40.0;

/// What the errors are drawn over, every sample of the log, per joint.
pub(super) struct View {
    /// Time since the recording began, s.
    pub time: Vec<f64>,
    /// Measured torque, N m.
    pub torque: Vec<Vec<f64>>,
    runs: Vec<std::ops::Range<usize>>,
    /// Position, velocity, acceleration and torque of the model, per joint.
    over: Vec<[Vec<f64>; 4]>,
}

impl View {
    /// Of a scene whose windows are single samples.
    pub fn of(scene: &Scene<'_>) -> Self {
        let over = (0..scene.dof())
            .map(|j| {
                let states = &scene.states[scene.seen[j]];
                let row = |x: &[f64]| x[j * states.len..(j + 1) * states.len].to_vec();
                [row(&states.q), row(&states.dq), row(&states.ddq), scene.whole[j].clone()]
            })
            .collect();
        Self { time: scene.time.clone(), torque: scene.y.clone(), runs: scene.runs.clone(), over }
    }

    /// Time with one log after the other, s.
    pub fn clock(&self) -> Vec<f64> {
        let (mut shift, mut last, mut before) = (0.0, 0.0, f64::NEG_INFINITY);
        let mut clock = Vec::with_capacity(self.time.len());
        for t in &self.time {
            // Time that falls: the next log begins.
            if *t < before {
                shift = last;
            }
            (before, last) = (*t, t + shift);
            clock.push(last);
        }
        clock
    }

    /// Maps of joint `j`'s error, N m, of two models.
    pub fn maps(&self, j: usize, before: &[f64], after: &[f64]) -> Vec<ErrorMap> {
        let [q, v, a, load] = &self.over[j];
        let clock = self.clock();
        let mut maps: Vec<ErrorMap> = [
            ("velocity, rad/s", v),
            ("position, rad", q),
            ("acceleration, rad/s²", a),
            ("torque of the model, N m", load),
            ("time, s", &clock),
        ]
        .into_iter()
        .filter_map(|(over, x)| binned(over, x, before, after))
        .collect();
        maps.extend(self.spectrum(before, after));
        maps
    }

    /// Amplitude over frequency: mean power of overlapping Hann windows (Welch 1967), as the amplitude of a sine with that power.
    fn spectrum(&self, before: &[f64], after: &[f64]) -> Option<ErrorMap> {
        let longest = self.runs.iter().max_by_key(|r| r.len())?;
        let period = (self.time[longest.end - 1] - self.time[longest.start]) / (longest.len().max(2) - 1) as f64;
        if !(period > 0.0 && longest.len() >= 32) {
            return None;
        }
        let len = ((SECTION / period).round() as usize).min(longest.len());
        let starts: Vec<usize> = self
            .runs
            .iter()
            .filter(|r| r.len() >= len)
            .flat_map(|r| (r.start..=r.end - len).step_by((len / 2).max(1)))
            .collect();
        let starts: Vec<usize> = starts.iter().step_by(starts.len().div_ceil(SECTIONS).max(1)).copied().collect();
        let window: Vec<f64> =
            (0..len).map(|k| 0.5 - 0.5 * (std::f64::consts::TAU * k as f64 / len as f64).cos()).collect();
        let weight: f64 = window.iter().sum();
        let resolution = 1.0 / (len as f64 * period);
        let lines = (((HIGHEST / resolution) as usize).min(len / 2)).max(1);
        let amplitude = |error: &[f64], line: usize| {
            let turn = 2.0 * (std::f64::consts::TAU * line as f64 / len as f64).cos();
            let power: f64 = starts
                .iter()
                .map(|&start| {
                    // Goertzel: one line of the transform by a recursion of second order.
                    let (mut one, mut two) = (0.0, 0.0);
                    for (e, w) in error[start..start + len].iter().zip(&window) {
                        (one, two) = (e * w + turn * one - two, one);
                    }
                    (one * one + two * two - turn * one * two).max(0.0)
                })
                .sum();
            2.0 * (power / starts.len() as f64).sqrt() / weight
        };
        Some(ErrorMap {
            over: "frequency, Hz",
            x: (1..=lines).map(|line| line as f64 * resolution).collect(),
            before: (1..=lines).map(|line| amplitude(before, line)).collect(),
            after: (1..=lines).map(|line| amplitude(after, line)).collect(),
        })
    }
}

/// Means over equal bins of `x`; `None` where it does not vary. Bins with fewer samples than a tenth of their share are left out.
fn binned(over: &'static str, x: &[f64], before: &[f64], after: &[f64]) -> Option<ErrorMap> {
    let low = x.iter().copied().fold(f64::INFINITY, f64::min);
    let high = x.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    if !(high - low > 1e-9 && (high - low).is_finite()) {
        return None;
    }
    let mut sums = vec![[0.0; 4]; BINS];
    for ((x, b), a) in x.iter().zip(before).zip(after) {
        let bin = (((x - low) / (high - low) * BINS as f64) as usize).min(BINS - 1);
        sums[bin].iter_mut().zip([1.0, *x, *b, *a]).for_each(|(s, v)| *s += v);
    }
    let least = (x.len() as f64 / (10 * BINS) as f64).clamp(1.0, 10.0);
    let used: Vec<[f64; 4]> = sums.into_iter().filter(|s| s[0] >= least).collect();
    let mean = |k: usize| used.iter().map(|s| s[k] / s[0]).collect();
    Some(ErrorMap { over, x: mean(1), before: mean(2), after: mean(3) })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn view(time: Vec<f64>, x: Vec<f64>) -> View {
        let len = time.len();
        View {
            torque: vec![vec![0.0; len]],
            runs: vec![0..len / 2, len / 2..len],
            over: vec![[x.clone(), x.clone(), x, vec![0.0; len]]],
            time,
        }
    }

    #[test]
    fn a_line_and_a_sine_are_seen_as_such() {
        let half: Vec<f64> = (0..4000).map(|k| k as f64 * 0.002).collect();
        let time = [half.clone(), half].concat();
        let x: Vec<f64> = time.iter().map(|t| (0.7 * t).sin()).collect();
        let before: Vec<f64> = time.iter().map(|t| 3.0 * (std::f64::consts::TAU * 5.0 * t).sin()).collect();
        let after: Vec<f64> = x.iter().map(|x| 0.5 * x).collect();
        let maps = view(time, x).maps(0, &before, &after);
        // The load is the same throughout: no map.
        let names: Vec<&str> = maps.iter().map(|m| m.over.split(',').next().unwrap()).collect();
        assert_eq!(names, ["velocity", "position", "acceleration", "time", "frequency"]);
        for (x, y) in maps[1].x.iter().zip(&maps[1].after) {
            assert!((y - 0.5 * x).abs() < 1e-9);
        }
        // The second log follows the first.
        assert!((maps[3].x.last().unwrap() - 15.9).abs() < 0.1);
        let spectrum = &maps[4];
        let peak = (0..spectrum.x.len()).max_by(|a, b| spectrum.before[*a].total_cmp(&spectrum.before[*b])).unwrap();
        assert!((spectrum.x[peak] - 5.0).abs() < 1e-9 && (spectrum.before[peak] - 3.0).abs() < 1e-6);
    }
}
