//! Maps of an error against velocity, position, acceleration, load, time, temperature and travel
//! since a reversal. Also its spectra over frequency and over periods per turn, its dependence on
//! another joint's motion, and the residual of the model shifted in time.

use std::sync::Arc;

use nalgebra::{DMatrix, DVector};

use super::result::ErrorMap;
use crate::diagnose::fit::moments::pseudo_inverse;
use crate::diagnose::windows::windowed_data::WindowedData;
use crate::model::States;

/// Number of bins of a map.
const BINS: usize = 48;

/// Longest section of a spectrum, s: the resolution is its inverse.
const SECTION: f64 = 4.0;

/// Maximum number of averaged sections of a spectrum, spread over the data.
const SECTIONS: usize = 24;

/// Highest frequency of a spectrum, Hz.
const HIGHEST: f64 = 40.0;

/// Variables of the maps, at every sample of the log, per joint.
pub(in crate::diagnose) struct View {
    /// Time since the recording began, s.
    pub time: Vec<f64>,
    /// Measured torque, N m.
    pub torque: Vec<Arc<Vec<f64>>>,
    runs: Vec<std::ops::Range<usize>>,
    /// Motion of all joints, once for each delay.
    states: Vec<Arc<States>>,
    /// Index of the motion that belongs to a joint's torque.
    state_of_joint: Vec<usize>,
    /// Torque of the model, per joint, N m.
    model: Vec<Arc<Vec<f64>>>,
    /// Temperature, per joint, deg C; empty if not recorded.
    temperature: Vec<Vec<f64>>,
    /// Motor turns per joint turn, if the file has them.
    gears: Vec<Option<f64>>,
}

/// Maximum number of samples of the more expensive maps, spread over the data.
const SAMPLES: usize = 6000;

/// Largest shift of the model in time, s.
const SHIFT: f64 = 0.08;

impl View {
    /// The view of a scene whose windows are single samples, with a model's torques there, N m.
    pub fn of(scene: &WindowedData<'_>, model: &[Arc<Vec<f64>>]) -> Self {
        let temperature =
            scene.own.iter().map(|own| own.iter().flat_map(|o| o.temperature.iter().copied()).collect()).collect();
        let gears = scene.plant.gear_ratios().to_vec();
        Self {
            time: scene.time.clone(),
            torque: scene.y.clone(),
            runs: scene.runs.clone(),
            states: scene.states.clone(),
            state_of_joint: scene.state_of_joint.clone(),
            model: model.to_vec(),
            temperature,
            gears,
        }
    }

    /// Position, velocity and acceleration of each joint at the time of joint `j`'s torque.
    pub fn motion(&self, j: usize) -> Vec<[&[f64]; 3]> {
        self.states[self.state_of_joint[j]].by_joint()
    }

    /// Position, velocity, acceleration of a joint and the model's torque on it.
    fn over(&self, j: usize) -> [&[f64]; 4] {
        let [q, v, a] = self.motion(j)[j];
        [q, v, a, &self.model[j]]
    }

    /// Time with one log after the other, s.
    pub fn clock(&self) -> Vec<f64> {
        let (mut shift, mut last, mut before) = (0.0, 0.0, f64::NEG_INFINITY);
        let mut clock = Vec::with_capacity(self.time.len());
        for t in &self.time {
            // A decreasing time marks the next log.
            if *t < before {
                shift = last;
            }
            (before, last) = (*t, t + shift);
            clock.push(last);
        }
        clock
    }

    /// Maps of joint `j`'s error, N m, with two models.
    pub fn maps(&self, j: usize, before: &[f64], after: &[f64]) -> Vec<ErrorMap> {
        let [q, v, a, load] = self.over(j);
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
        let warm = &self.temperature[j];
        if warm.len() == before.len() {
            maps.extend(binned("temperature, °C", warm, before, after));
        }
        maps.extend(self.spectrum(before, after));
        maps.extend(self.orders(j, before, after));
        maps.extend(self.reversals(j, before, after));
        maps.extend(self.pairs(j, before, after));
        maps.extend(self.shifts(j, before, after));
        maps
    }

    /// Indices of the samples used by the more expensive maps.
    fn thinned(&self) -> impl Iterator<Item = usize> + Clone + use<> {
        let len = self.time.len();
        (0..len).step_by(len.div_ceil(SAMPLES).max(1))
    }

    /// Amplitude over periods per turn of the joint, up to twice the motor's turn where the gear
    /// ratio is known.
    fn orders(&self, j: usize, before: &[f64], after: &[f64]) -> Option<ErrorMap> {
        let q = self.over(j)[0];
        let (low, high) = (least(q), most(q));
        if !(high - low > 0.05 && (high - low).is_finite()) {
            return None;
        }
        let step = (std::f64::consts::TAU / (high - low)).max(0.5);
        let last = self.gears[j].map_or(120.0, |g| (2.2 * g.abs()).clamp(40.0, 400.0));
        let orders: Vec<f64> = (1..).map(|k| f64::from(k) * step).take_while(|n| *n <= last).take(300).collect();
        let picks = self.thinned();
        let count = picks.clone().count().max(1) as f64;
        let mut amplitudes = [Vec::with_capacity(orders.len()), Vec::with_capacity(orders.len())];
        for n in &orders {
            let mut sums = [0.0; 4];
            for k in picks.clone() {
                let (sin, cos) = (n * q[k]).sin_cos();
                let add = [before[k] * cos, before[k] * sin, after[k] * cos, after[k] * sin];
                sums.iter_mut().zip(add).for_each(|(s, a)| *s += a);
            }
            amplitudes[0].push(2.0 * sums[0].hypot(sums[1]) / count);
            amplitudes[1].push(2.0 * sums[2].hypot(sums[3]) / count);
        }
        let [before, after] = amplitudes;
        (!orders.is_empty()).then_some(ErrorMap { over: "periods per turn", x: orders, before, after })
    }

    /// Error in the direction of motion over the travel since the joint's last reversal.
    fn reversals(&self, j: usize, before: &[f64], after: &[f64]) -> Option<ErrorMap> {
        let [q, v, ..] = self.over(j);
        let range = most(q) - least(q);
        let (mut travel, mut along) = (Vec::new(), [Vec::new(), Vec::new()]);
        for run in &self.runs {
            // The distance from a reversal is known only after the first one.
            let (mut sign, mut since) = (0.0, None);
            for k in run.clone() {
                let now = if v[k] == 0.0 { sign } else { v[k].signum() };
                if now != sign {
                    since = if sign == 0.0 { None } else { Some(q[k]) };
                    sign = now;
                }
                let Some(turned) = since else { continue };
                let moved = (q[k] - turned).abs();
                if moved < 0.1 * range {
                    travel.push(moved);
                    along[0].push(sign * before[k]);
                    along[1].push(sign * after[k]);
                }
            }
        }
        binned("travel since a reversal, rad", &travel, &along[0], &along[1])
    }

    /// Root mean square of the part that correlates with another joint's position, velocity,
    /// acceleration and direction, joint by joint.
    fn pairs(&self, j: usize, before: &[f64], after: &[f64]) -> Option<ErrorMap> {
        const COLUMNS: usize = 6;
        let picks = self.thinned();
        let others: Vec<usize> = (0..self.model.len()).filter(|k| *k != j).collect();
        let explained = |k: usize| {
            let [q, v, a, _] = self.over(k);
            let (mut gram, mut with) =
                (DMatrix::<f64>::zeros(COLUMNS, COLUMNS), [DVector::<f64>::zeros(COLUMNS), DVector::zeros(COLUMNS)]);
            let mut count = 0.0;
            for s in picks.clone() {
                let row = DVector::from_vec(vec![1.0, q[s].sin(), q[s].cos(), v[s], a[s], v[s].signum()]);
                gram.ger(1.0, &row, &row, 1.0);
                with[0].axpy(before[s], &row, 1.0);
                with[1].axpy(after[s], &row, 1.0);
                count += 1.0;
            }
            let inverse = pseudo_inverse(&gram);
            with.map(|w| (w.dot(&(&inverse * &w)).max(0.0) / f64::max(count, 1.0)).sqrt())
        };
        let found: Vec<[f64; 2]> = others.iter().map(|&k| explained(k)).collect();
        (!others.is_empty()).then(|| ErrorMap {
            over: "with the motion of joint",
            x: others.iter().map(|k| (k + 1) as f64).collect(),
            before: found.iter().map(|f| f[0]).collect(),
            after: found.iter().map(|f| f[1]).collect(),
        })
    }

    /// Root mean square error with the model's torque shifted in time: minimal at zero without a
    /// delay.
    fn shifts(&self, j: usize, before: &[f64], after: &[f64]) -> Option<ErrorMap> {
        let longest = self.runs.iter().max_by_key(|r| r.len())?;
        let period = (self.time[longest.end - 1] - self.time[longest.start]) / (longest.len().max(2) - 1) as f64;
        let torque = &self.torque[j];
        let reach = (SHIFT / period).floor();
        if !(period > 0.0 && reach >= 2.0 && longest.len() as f64 > 8.0 * reach) {
            return None;
        }
        let reach = reach as usize;
        let stride = (reach / 16).max(1);
        let shifts: Vec<isize> = (-(reach as isize)..=reach as isize).step_by(stride).collect();
        let left = |error: &[f64], by: isize| {
            let (mut sum, mut count) = (0.0, 0.0);
            for run in &self.runs {
                for k in run.clone().step_by(self.time.len().div_ceil(SAMPLES).max(1)) {
                    let at = k as isize - by;
                    if at >= run.start as isize && at < run.end as isize {
                        let model = torque[at as usize] - error[at as usize];
                        sum += (torque[k] - model).powi(2);
                        count += 1.0;
                    }
                }
            }
            (sum / f64::max(count, 1.0)).sqrt()
        };
        Some(ErrorMap {
            over: "shift of the model, s",
            x: shifts.iter().map(|s| *s as f64 * period).collect(),
            before: shifts.iter().map(|s| left(before, *s)).collect(),
            after: shifts.iter().map(|s| left(after, *s)).collect(),
        })
    }

    /// Amplitude over frequency: mean power of overlapping Hann windows (Welch 1967), as the
    /// amplitude of a sine with that power.
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

fn least(x: &[f64]) -> f64 {
    x.iter().copied().fold(f64::INFINITY, f64::min)
}

fn most(x: &[f64]) -> f64 {
    x.iter().copied().fold(f64::NEG_INFINITY, f64::max)
}

/// Means over equal bins of `x`; `None` if `x` is constant. Bins with fewer samples than a tenth of
/// the mean number (at least 1, at most 10) are left out.
fn binned(over: &'static str, x: &[f64], before: &[f64], after: &[f64]) -> Option<ErrorMap> {
    let (low, high) = (least(x), most(x));
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
            torque: vec![Arc::new(vec![0.0; len])],
            runs: vec![0..len / 2, len / 2..len],
            states: vec![Arc::new(States { len, q: x.clone(), dq: x.clone(), ddq: x })],
            state_of_joint: vec![0],
            model: vec![Arc::new(vec![0.0; len])],
            temperature: vec![Vec::new()],
            gears: vec![None],
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
        // The load is constant: no map.
        let names: Vec<&str> = maps.iter().map(|m| m.over.split(',').next().unwrap()).collect();
        assert_eq!(
            names,
            [
                "velocity",
                "position",
                "acceleration",
                "time",
                "frequency",
                "periods per turn",
                "travel since a reversal",
                "shift of the model"
            ]
        );
        for (x, y) in maps[1].x.iter().zip(&maps[1].after) {
            assert!((y - 0.5 * x).abs() < 1e-9);
        }
        // The second log follows the first.
        assert!((maps[3].x.last().unwrap() - 15.9).abs() < 0.1);
        let spectrum = &maps[4];
        let peak = (0..spectrum.x.len()).max_by(|a, b| spectrum.before[*a].total_cmp(&spectrum.before[*b])).unwrap();
        assert!((spectrum.x[peak] - 5.0).abs() < 1e-9 && (spectrum.before[peak] - 3.0).abs() < 1e-6);
    }

    #[test]
    fn ripple_and_delay_stand_out() {
        let time: Vec<f64> = (0..6000).map(|k| k as f64 * 0.002).collect();
        let q: Vec<f64> = time.iter().map(|t| 1.5 * (0.9 * t).sin()).collect();
        let mut view = view(time.clone(), q.clone());
        let ripple: Vec<f64> = q.iter().map(|q| 0.4 * (30.0 * q).cos()).collect();
        let map = view.orders(0, &ripple, &vec![0.0; 6000]).unwrap();
        let peak = (0..map.x.len()).max_by(|a, b| map.before[*a].total_cmp(&map.before[*b])).unwrap();
        assert!((map.x[peak] - 30.0).abs() < 2.5 && map.after.iter().all(|a| *a == 0.0), "{}", map.x[peak]);
        // The torque equals the model's of 20 ms ago.
        let wave = |t: f64| (3.0 * t).sin() + 0.5 * (11.0 * t).cos();
        view.torque = vec![Arc::new(time.iter().map(|t| wave(t - 0.02)).collect())];
        let late: Vec<f64> = time.iter().map(|t| wave(t - 0.02) - wave(*t)).collect();
        let map = view.shifts(0, &late, &vec![0.0; 6000]).unwrap();
        let least = (0..map.x.len()).min_by(|a, b| map.before[*a].total_cmp(&map.before[*b])).unwrap();
        assert!((map.x[least] - 0.02).abs() < 0.003, "{}", map.x[least]);
    }
}
