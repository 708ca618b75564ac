//! Interpolation and differentiation of smooth functions from their values at Chebyshev points
//! (Trefethen, *Spectral Methods in MATLAB*, chapters 5 and 6).

use std::f64::consts::PI;

use nalgebra::DMatrix;

/// Chebyshev points on `[0, 1]` in ascending order, with barycentric weights and the
/// differentiation matrix.
#[derive(Debug, Clone)]
pub(crate) struct Chebyshev {
    /// The points, ascending.
    pub points: Vec<f64>,
    weights: Vec<f64>,
    differentiate: DMatrix<f64>,
}

impl Chebyshev {
    /// Rule with `order + 1` points.
    pub(crate) fn new(order: usize) -> Self {
        let last = order as f64;
        let points: Vec<f64> = (0..=order).map(|k| 0.5 - 0.5 * (PI * k as f64 / last).cos()).collect();
        let weights: Vec<f64> = (0..=order)
            .map(|k| {
                let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
                if k == 0 || k == order { 0.5 * sign } else { sign }
            })
            .collect();
        // Differences of the points from their angles, which avoids cancellation.
        let apart = |i: usize, k: usize| {
            let (a, b) = (PI * i as f64 / last, PI * k as f64 / last);
            (0.5 * (a + b)).sin() * (0.5 * (a - b)).sin()
        };
        let mut differentiate = DMatrix::zeros(order + 1, order + 1);
        for i in 0..=order {
            for k in 0..=order {
                if i != k {
                    differentiate[(i, k)] = weights[k] / weights[i] / apart(i, k);
                }
            }
            differentiate[(i, i)] = -differentiate.row(i).sum();
        }
        Self { points, weights, differentiate }
    }

    /// Matrices from values at the points to the value and the first three derivatives at each `s`.
    pub(crate) fn rows(&self, s: &[f64]) -> [DMatrix<f64>; 4] {
        let count = self.points.len();
        let mut value = DMatrix::zeros(s.len(), count);
        for (r, &s) in s.iter().enumerate() {
            if let Some(k) = self.points.iter().position(|p| *p == s) {
                value[(r, k)] = 1.0;
                continue;
            }
            let terms: Vec<f64> = (0..count).map(|k| self.weights[k] / (s - self.points[k])).collect();
            let sum: f64 = terms.iter().sum();
            (0..count).for_each(|k| value[(r, k)] = terms[k] / sum);
        }
        let first = &value * &self.differentiate;
        let second = &first * &self.differentiate;
        let third = &second * &self.differentiate;
        [value, first, second, third]
    }

    /// Largest magnitude of the last three Chebyshev coefficients of values at the points: an
    /// estimate of the truncation error.
    pub(crate) fn tail(&self, values: impl Fn(usize) -> f64) -> f64 {
        let order = self.points.len() - 1;
        let coefficient = |m: usize| {
            let sum: f64 = (0..=order)
                .map(|k| {
                    let end = if k == 0 || k == order { 0.5 } else { 1.0 };
                    end * values(k) * (PI * (m * k) as f64 / order as f64).cos()
                })
                .sum();
            2.0 * sum / order as f64
        };
        (order.saturating_sub(2)..=order).map(|m| coefficient(m).abs()).fold(0.0, f64::max)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn derivatives_of_a_wave() {
        let c = Chebyshev::new(18);
        let values: Vec<f64> = c.points.iter().map(|s| (3.0 * s).sin()).collect();
        let at = [0.0, 0.123, 0.5, c.points[4], 0.97, 1.0];
        let rows = c.rows(&at);
        for (r, s) in at.iter().enumerate() {
            let exact = [(3.0 * s).sin(), 3.0 * (3.0 * s).cos(), -9.0 * (3.0 * s).sin(), -27.0 * (3.0 * s).cos()];
            for (d, exact) in exact.iter().enumerate() {
                let found: f64 = (0..values.len()).map(|k| rows[d][(r, k)] * values[k]).sum();
                let size = 1e-13 * [1.0, 1e2, 1e4, 1e6][d];
                assert!((found - exact).abs() < size, "{d} {s}: {found} {exact}");
            }
        }
        assert!(c.tail(|k| values[k]) < 1e-13);
        assert!(c.tail(|k| (c.points[k] - 0.4).abs()) > 1e-3);
    }
}
