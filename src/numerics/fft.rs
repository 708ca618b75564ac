//! Radix-2 fast Fourier transform of real series (J. W. Cooley and J. W. Tukey 1965).
//!
//! Written here because one small use does not justify a crate: the usual ones share numeric traits
//! with the solvers and would change how these are built.

use std::f64::consts::TAU;

/// Power `|X_k|^2` of a real series for `k = 0..=n / 2`, zero-padded to `n`, the next power of two;
/// and `n`.
pub fn power_spectrum(x: &[f64]) -> (Vec<f64>, usize) {
    let n = x.len().next_power_of_two();
    let bits = n.trailing_zeros();
    let (mut re, mut im) = (vec![0.0; n], vec![0.0; n]);
    for (k, x) in x.iter().enumerate() {
        let to = if bits == 0 { 0 } else { k.reverse_bits() >> (usize::BITS - bits) };
        re[to] = *x;
    }
    let mut half = 1;
    while half < n {
        let turns: Vec<(f64, f64)> = (0..half).map(|k| (-TAU * k as f64 / (2 * half) as f64).sin_cos()).collect();
        for first in (0..n).step_by(2 * half) {
            for (k, (sin, cos)) in turns.iter().enumerate() {
                let (a, b) = (first + k, first + k + half);
                let (r, i) = (cos * re[b] - sin * im[b], cos * im[b] + sin * re[b]);
                (re[b], im[b]) = (re[a] - r, im[a] - i);
                (re[a], im[a]) = (re[a] + r, im[a] + i);
            }
        }
        half *= 2;
    }
    (re.iter().zip(&im).take(n / 2 + 1).map(|(r, i)| r * r + i * i).collect(), n)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_a_short_series_by_the_definition() {
        let x = [0.3, -1.2, 2.0, 0.7, -0.1];
        let (power, n) = power_spectrum(&x);
        assert_eq!((power.len(), n), (5, 8));
        for (k, power) in power.iter().enumerate() {
            let sum = |f: fn(f64) -> f64| -> f64 {
                x.iter().enumerate().map(|(i, x)| x * f(TAU * (i * k) as f64 / 8.0)).sum()
            };
            assert!((power - sum(f64::cos).powi(2) - sum(f64::sin).powi(2)).abs() < 1e-12);
        }
        assert_eq!(power_spectrum(&[2.0]).0, [4.0]);
    }
}
