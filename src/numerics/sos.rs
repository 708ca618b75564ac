//! Filters in second-order sections, run forward or forward and backward.

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
    /// State (direct form II transposed) in which a constant input of 1 gives its constant output
    /// at once, and that output.
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
    /// Filters in place; the past before the first sample is taken as constant at `start`.
    pub fn forward(&self, x: &mut [f64], start: f64) {
        let mut level = start;
        for section in &self.sections {
            let ([z1, z2], gain) = section.rest();
            let (mut z1, mut z2) = (z1 * level, z2 * level);
            let ([b0, b1, b2], [a1, a2]) = (section.b, section.a);
            for value in x.iter_mut() {
                let y = b0 * *value + z1;
                z1 = b1 * *value - a1 * y + z2;
                z2 = b2 * *value - a2 * y;
                *value = y;
            }
            level *= gain;
        }
    }

    /// Padding that SciPy's `sosfiltfilt` uses.
    pub fn scipy_padding(&self) -> usize {
        3 * (self.order + 1)
    }

    /// Filters forward and backward, so without lag; the gain is that of one pass squared. `pad`
    /// samples are added at each end by turning the signal about its end point ("odd" extension).
    /// Each pass starts at rest at its first value, as SciPy's `sosfiltfilt` does (Gustafsson 1996
    /// compares the ways to start).
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

    /// Samples after which what came before has faded to 1e-12, from the pole of largest radius.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::data::signal::low_pass;

    /// The signal and SciPy's answers: `sos_reference.py` beside this file.
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
