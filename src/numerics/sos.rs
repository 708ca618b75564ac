//! Filters in second-order sections, run forward, or forward and backward.

use std::f64::consts::PI;

/// `(b0 + b1 z^-1 + b2 z^-2) / (1 + a1 z^-1 + a2 z^-2)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Biquad {
    /// `b0 b1 b2`.
    pub b: [f64; 3],
    /// `a1 a2`.
    pub a: [f64; 2],
}

impl Biquad {
    /// Steady state (direct form II transposed) for a constant input of 1, and the constant output.
    fn rest(&self) -> ([f64; 2], f64) {
        let gain = self.b.iter().sum::<f64>() / (1.0 + self.a[0] + self.a[1]);
        let z2 = self.b[2] - self.a[1] * gain;
        ([self.b[1] - self.a[0] * gain + z2, z2], gain)
    }
}

/// A cascade of second-order sections.
#[derive(Debug, Clone, PartialEq)]
pub struct Sos {
    /// The sections, in the order in which they are applied.
    pub sections: Vec<Biquad>,
    /// Order of the filter.
    pub order: usize,
}

impl Sos {
    /// Filters in place; the input before the first sample is assumed constant at `start`.
    pub fn forward(&self, x: &mut [f64], start: f64) {
        let mut level = start;
        // Three sections at once, since each depends on its own last sample only.
        let (threes, rest) = self.sections.as_chunks();
        for three in threes {
            level = cascade::<3>(*three, x, level);
        }
        _ = match rest {
            [one, two] => cascade([*one, *two], x, level),
            [one] => cascade([*one], x, level),
            _ => level,
        };
    }

    /// Padding that SciPy's `sosfiltfilt` uses.
    pub fn scipy_padding(&self) -> usize {
        3 * (self.order + 1)
    }

    /// Filters forward and backward, without lag; the gain is the square of one pass. `pad` samples
    /// are added at each end by reflecting the signal about its end point ("odd" extension). Each
    /// pass starts in the steady state of its first value, as SciPy's `sosfiltfilt` does
    /// (Gustafsson 1996 compares initial conditions).
    pub fn forward_backward(&self, x: &mut [f64], pad: usize) {
        let Some((&first, &last)) = x.first().zip(x.last()) else { return };
        let pad = pad.min(x.len() - 1);
        let n = x.len();
        let mut y = Vec::with_capacity(n + 2 * pad);
        y.extend((1..=pad).rev().map(|i| 2.0 * first - x[i]));
        y.extend_from_slice(x);
        y.extend((1..=pad).map(|i| 2.0 * last - x[n - 1 - i]));
        for _ in 0..2 {
            let start = y[0];
            self.forward(&mut y, start);
            y.reverse();
        }
        x.copy_from_slice(&y[pad..pad + n]);
    }

    /// Number of samples after which an initial state has decayed to 1e-12, from the largest pole
    /// radius.
    pub fn settling(&self) -> usize {
        let radius = self
            .sections
            .iter()
            .map(|s| {
                let [a1, a2] = s.a;
                let d = a1 * a1 - 4.0 * a2;
                if d < 0.0 { a2.sqrt() } else { (a1.abs() + d.sqrt()) / 2.0 }
            })
            .fold(0.0, f64::max);
        if radius <= 0.0 { 1 } else { ((1e-12_f64.ln() / radius.min(1.0 - 1e-6).ln()).ceil() as usize).max(1) }
    }

    /// Gain of one pass at a frequency, Hz.
    pub fn gain(&self, frequency: f64, rate: f64) -> f64 {
        let w = 2.0 * PI * frequency / rate;
        let at = |c: [f64; 3]| {
            let re = c[0] + c[1] * w.cos() + c[2] * (2.0 * w).cos();
            let im = c[1] * w.sin() + c[2] * (2.0 * w).sin();
            re.hypot(im)
        };
        self.sections.iter().map(|s| at(s.b) / at([1.0, s.a[0], s.a[1]])).product()
    }
}

/// A series with its filter, for [`forward_backward_each`].
#[derive(Debug, Clone, Copy)]
pub struct Filtered<'a> {
    /// The series.
    pub x: &'a [f64],
    /// The filter.
    pub sos: &'a Sos,
    /// Samples added at each end, as in [`Sos::forward_backward`].
    pub pad: usize,
}

/// Number of series filtered side by side: a recurrence waits for its own result, and four of them
/// fill the pipeline.
const LANES: usize = 4;
/// Number of sections applied in one pass.
const SECTIONS: usize = 3;

/// [`Sos::forward_backward`] of each series, bitwise equal.
pub fn forward_backward_each(series: &[Filtered<'_>]) -> Vec<Vec<f64>> {
    let mut out = Vec::with_capacity(series.len());
    for lanes in series.chunks(LANES) {
        let alike = |lane: &Filtered<'_>| {
            lane.x.len() == lanes[0].x.len() && lane.sos.sections.len() == lanes[0].sos.sections.len()
        };
        if lanes.len() > 1 && lanes.iter().all(alike) && !lanes[0].x.is_empty() {
            side_by_side(lanes, &mut out);
            continue;
        }
        out.extend(lanes.iter().map(|lane| {
            let mut x = lane.x.to_vec();
            lane.sos.forward_backward(&mut x, lane.pad);
            x
        }));
    }
    out
}

/// Filters at most [`LANES`] series of one length, whose filters have equally many sections. They
/// end at the same index of a common buffer, so that all backward passes begin there.
fn side_by_side(lanes: &[Filtered<'_>], out: &mut Vec<Vec<f64>>) {
    let n = lanes[0].x.len();
    let pads: Vec<usize> = lanes.iter().map(|lane| lane.pad.min(n - 1)).collect();
    let total = n + 2 * pads.iter().fold(0, |most, pad| most.max(*pad));
    let begins: Vec<usize> = pads.iter().map(|pad| total - n - 2 * pad).collect();
    let mut y = vec![[0.0; LANES]; total];
    for (l, ((lane, &pad), &begin)) in lanes.iter().zip(&pads).zip(&begins).enumerate() {
        let (x, first, last) = (lane.x, lane.x[0], lane.x[n - 1]);
        let (before, inner) = y[begin..].split_at_mut(pad);
        let (inner, after) = inner.split_at_mut(n);
        before.iter_mut().zip(x[1..].iter().take(pad).rev()).for_each(|(y, x)| y[l] = 2.0 * first - x);
        inner.iter_mut().zip(x).for_each(|(y, x)| y[l] = *x);
        after.iter_mut().zip(x.iter().rev().skip(1)).for_each(|(y, x)| y[l] = 2.0 * last - x);
    }
    for backward in [false, true] {
        let mut levels: Vec<f64> = match backward {
            false => begins.iter().enumerate().map(|(l, &begin)| y[begin][l]).collect(),
            true => (0..lanes.len()).map(|l| y[total - 1][l]).collect(),
        };
        for from in (0..lanes[0].sos.sections.len()).step_by(SECTIONS) {
            let mut abreast = Abreast::of(lanes, from);
            // Where a lane begins, set its steady state.
            let start = |l: usize| if backward { 0 } else { begins[l] };
            let mut cuts: Vec<usize> = (0..lanes.len()).map(start).chain([total]).collect();
            cuts.sort_unstable();
            for span in cuts.windows(2).filter(|w| w[0] < w[1]) {
                for l in (0..lanes.len()).filter(|&l| start(l) == span[0]) {
                    levels[l] = abreast.rest(lanes[l].sos, from, l, levels[l]);
                }
                let part = if backward { &mut y[..] } else { &mut y[span[0]..span[1]] };
                run(&abreast.sections, &mut abreast.states, part, backward);
            }
        }
    }
    out.extend((0..lanes.len()).map(|l| y[begins[l] + pads[l]..][..n].iter().map(|y| y[l]).collect()));
}

/// Some sections of several filters, one filter per lane.
struct Abreast {
    /// `b0 b1 b2 a1 a2` of each section and lane.
    sections: [[[f64; LANES]; 5]; SECTIONS],
    states: [[[f64; LANES]; 2]; SECTIONS],
}

impl Abreast {
    /// Sections from index `from`; missing ones pass their input through.
    fn of(lanes: &[Filtered<'_>], from: usize) -> Self {
        let mut sections = [[[1.0; LANES], [0.0; LANES], [0.0; LANES], [0.0; LANES], [0.0; LANES]]; SECTIONS];
        for (l, lane) in lanes.iter().enumerate() {
            for (to, Biquad { b, a }) in sections.iter_mut().zip(&lane.sos.sections[from..]) {
                to.iter_mut().zip(b.iter().chain(a)).for_each(|(to, value)| to[l] = *value);
            }
        }
        Self { sections, states: [[[0.0; LANES]; 2]; SECTIONS] }
    }

    /// Sets the steady state of a lane for the input `level`; returns the output level.
    fn rest(&mut self, sos: &Sos, from: usize, lane: usize, mut level: f64) -> f64 {
        for (state, section) in self.states.iter_mut().zip(&sos.sections[from..]) {
            let (rest, gain) = section.rest();
            state.iter_mut().zip(rest).for_each(|(z, rest)| z[lane] = rest * level);
            level *= gain;
        }
        level
    }
}

/// Runs all lanes through the sections, from the front or from the back, in the widest registers of
/// this processor. The result is bitwise equal to any other width.
#[multiversion::multiversion(targets("x86_64+avx2"))]
fn run(
    sections: &[[[f64; LANES]; 5]; SECTIONS],
    states: &mut [[[f64; LANES]; 2]; SECTIONS],
    y: &mut [[f64; LANES]],
    backward: bool,
) {
    let mut now = *states;
    let n = y.len();
    for k in 0..n {
        let value = &mut y[if backward { n - 1 - k } else { k }];
        let mut passed = *value;
        for ([z1, z2], [b0, b1, b2, a1, a2]) in now.iter_mut().zip(sections) {
            for l in 0..LANES {
                let y = b0[l] * passed[l] + z1[l];
                z1[l] = b1[l] * passed[l] - a1[l] * y + z2[l];
                z2[l] = b2[l] * passed[l] - a2[l] * y;
                passed[l] = y;
            }
        }
        *value = passed;
    }
    *states = now;
}

/// Filters through `N` sections, sample by sample, from the steady state at `level`; returns the
/// steady output level.
fn cascade<const N: usize>(sections: [Biquad; N], x: &mut [f64], level: f64) -> f64 {
    let (mut states, mut level) = ([[0.0; 2]; N], level);
    for (state, section) in states.iter_mut().zip(&sections) {
        let (rest, gain) = section.rest();
        *state = rest.map(|z| z * level);
        level *= gain;
    }
    for value in x.iter_mut() {
        let mut passed = *value;
        for ([z1, z2], Biquad { b: [b0, b1, b2], a: [a1, a2] }) in states.iter_mut().zip(&sections) {
            let y = b0 * passed + *z1;
            *z1 = b1 * passed - a1 * y + *z2;
            *z2 = b2 * passed - a2 * y;
            passed = y;
        }
        *value = passed;
    }
    level
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::data::signal::low_pass;

    /// Test signal; `sos_reference.py` beside this file computes SciPy's results.
    fn signal() -> Vec<f64> {
        (0..60).map(|k| (0.3 * k as f64).sin() + 0.2 * (1.7 * k as f64).cos() + 0.01 * k as f64 + 0.5).collect()
    }

    #[test]
    fn agrees_with_scipy() {
        for (order, cutoff, expected) in include!("sos_reference.in") {
            let sos = low_pass(order, cutoff, 100.0).unwrap();
            let mut x = signal();
            sos.forward_backward(&mut x, sos.scipy_padding());
            for (i, value) in expected {
                assert!((x[i] - value).abs() < 1e-12, "order {order}: y[{i}] = {} against {value}", x[i]);
            }
        }
    }

    /// Filtering side by side and separately gives the same bits, for any number of series and
    /// filters.
    #[test]
    fn series_side_by_side_are_as_apart() {
        for order in [1, 4, 5, 9] {
            let filters: Vec<Sos> = (0..7).map(|k| low_pass(order, 4.0 + f64::from(k / 2), 100.0).unwrap()).collect();
            let series: Vec<Vec<f64>> =
                (0..7).map(|j| signal().iter().map(|x| (x * f64::from(j + 1)).sin() - 0.3).collect()).collect();
            for count in 1..=7 {
                let lane = |j: usize| Filtered { x: &series[j], sos: &filters[j], pad: [9, 30, 100][j % 3] };
                let all: Vec<Filtered<'_>> = (0..count).map(lane).collect();
                for (lane, y) in all.iter().zip(forward_backward_each(&all)) {
                    let mut x = lane.x.to_vec();
                    lane.sos.forward_backward(&mut x, lane.pad);
                    assert_eq!(x, y, "order {order}, {count} series");
                }
            }
        }
        let sos = low_pass(2, 5.0, 100.0).unwrap();
        let [long, short, none] = [vec![1.0; 9], vec![2.0], vec![]];
        let of = |x| Filtered { x, sos: &sos, pad: 4 };
        let found = forward_backward_each(&[of(&long), of(&short), of(&none)]);
        assert_eq!(found.iter().map(Vec::len).collect::<Vec<_>>(), [9, 1, 0]);
        assert_eq!(forward_backward_each(&[of(&none)]), [Vec::<f64>::new()]);
    }

    #[test]
    fn no_lag_and_squared_gain() {
        let sos = low_pass(5, 10.0, 1000.0).unwrap();
        let tone = |k: usize| (2.0 * PI * 8.0 * k as f64 / 1000.0).sin();
        let mut x: Vec<f64> = (0..4000).map(tone).collect();
        sos.forward_backward(&mut x, 1000);
        let gain = sos.gain(8.0, 1000.0).powi(2);
        for k in 1500..2500 {
            assert!((x[k] - gain * tone(k)).abs() < 1e-9);
        }
    }

    #[test]
    fn a_line_stays_a_line_at_both_ends() {
        let sos = low_pass(5, 10.0, 1000.0).unwrap();
        let mut x: Vec<f64> = (0..3000).map(|k| 3.0 - 0.002 * k as f64).collect();
        let before = x.clone();
        sos.forward_backward(&mut x, 1500);
        assert!(x.iter().zip(&before).all(|(a, b)| (a - b).abs() < 1e-9));
    }

    #[test]
    fn short_signals_do_not_panic() {
        let sos = low_pass(4, 10.0, 1000.0).unwrap();
        for n in 0..5 {
            let mut x = vec![1.0; n];
            sos.forward_backward(&mut x, 100);
            assert!(x.iter().all(|v| (v - 1.0).abs() < 1e-12));
        }
    }
}
