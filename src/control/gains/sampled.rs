//! Sampled linear systems: zero-order hold, frequency response, margins.

use std::f64::consts::PI;

use nalgebra::{Complex, DMatrix, DVector};

/// Stability margins of a loop.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Margins {
    /// Highest frequency at which the loop gain crosses 1, rad/s.
    pub crossover: f64,
    /// Smallest phase margin at any crossover, degrees.
    pub phase: f64,
    /// Smallest factor on the gain that makes the loop unstable, dB; infinite if there is none.
    pub gain: f64,
    /// Smallest distance of the loop from -1: the reciprocal of the largest sensitivity.
    pub modulus: f64,
    /// Spectral radius of the closed loop, per period: below 1 it is stable.
    pub radius: f64,
}

/// Margins of a proposal: 45 degrees, a factor of two (6 dB), and a sensitivity of at most 1.8.
pub fn wanted(m: &Margins) -> bool {
    m.radius < 1.0 && m.phase >= 45.0 && m.gain >= 6.0 && m.modulus >= 0.55
}

impl Margins {
    /// The worse of two, figure by figure; the lower crossover.
    pub fn worse(self, other: Self) -> Self {
        Self {
            crossover: self.crossover.min(other.crossover),
            phase: self.phase.min(other.phase),
            gain: self.gain.min(other.gain),
            modulus: self.modulus.min(other.modulus),
            radius: self.radius.max(other.radius),
        }
    }

    /// Margins of a loop `L` at `z`, closed by negative feedback and sampled every `period` s;
    /// `radius` is that of the closed loop.
    pub fn of(period: f64, radius: f64, transfer: impl Fn(Complex<f64>) -> Complex<f64>) -> Self {
        const POINTS: usize = 400;
        let (low, high) = (0.2_f64, PI / period);
        let mut found = Self { crossover: 0.0, phase: 180.0, gain: f64::INFINITY, modulus: f64::INFINITY, radius };
        let mut before: Option<Complex<f64>> = None;
        for k in 0..POINTS {
            let w = low * (high / low).powf((k as f64 + 0.5) / POINTS as f64);
            let value = transfer(Complex::from_polar(1.0, w * period));
            found.modulus = found.modulus.min((value + 1.0).norm());
            if let Some(last) = before {
                if (last.norm() >= 1.0) != (value.norm() >= 1.0) {
                    // The angle to -1 from either side.
                    found.phase = found.phase.min((-value).arg().abs().to_degrees());
                    found.crossover = w;
                }
                if last.im * value.im < 0.0 && value.re < 0.0 {
                    found.gain = found.gain.min(-20.0 * value.norm().log10()).max(-120.0);
                }
            }
            before = Some(value);
        }
        found
    }
}

/// Discretises `x' = A x + B u` with `u` held over a period: `(A_d, B_d)` from the exponential of
/// `[A B; 0 0] T` (squaring a Taylor series).
pub fn held(a: &DMatrix<f64>, b: &DMatrix<f64>, period: f64) -> (DMatrix<f64>, DMatrix<f64>) {
    let (n, m) = (a.nrows(), b.ncols());
    let mut block = DMatrix::zeros(n + m, n + m);
    block.view_mut((0, 0), (n, n)).copy_from(&(a * period));
    block.view_mut((0, n), (n, m)).copy_from(&(b * period));
    let size = block.iter().fold(0.0_f64, |m, x| m.max(x.abs())) * (n + m) as f64;
    let halvings = size.max(1.0).log2().ceil() as i32 + 3;
    block *= 0.5_f64.powi(halvings);
    let mut term = DMatrix::identity(n + m, n + m);
    let mut sum = term.clone();
    for k in 1..14 {
        term = &term * &block / f64::from(k);
        sum += &term;
    }
    for _ in 0..halvings {
        sum = &sum * &sum;
    }
    (sum.view((0, 0), (n, n)).into_owned(), sum.view((0, n), (n, m)).into_owned())
}

/// Frequency response `C (z - A)^-1 B` of a sampled system with one input and one output.
pub fn response(a: &DMatrix<f64>, b: &DVector<f64>, c: &DVector<f64>, z: Complex<f64>) -> Complex<f64> {
    match states(a, b, z) {
        Some(x) => c.iter().zip(x.iter()).map(|(c, x)| x * *c).sum(),
        None => Complex::new(f64::MAX, 0.0),
    }
}

/// State response `(z - A)^-1 B`; `None` at a pole.
pub fn states(a: &DMatrix<f64>, b: &DVector<f64>, z: Complex<f64>) -> Option<DVector<Complex<f64>>> {
    let n = a.nrows();
    let matrix = DMatrix::from_fn(n, n, |i, k| Complex::from(-a[(i, k)]) + if i == k { z } else { Complex::ZERO });
    matrix.lu().solve(&b.map(Complex::from))
}

/// Spectral radius: largest absolute value of the eigenvalues.
pub fn radius(a: &DMatrix<f64>) -> f64 {
    a.complex_eigenvalues().iter().fold(0.0, |most: f64, v| most.max(v.norm()))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `10 / jw (1 + jw / 10)` falls to one at 7.86 rad/s, 51.8 degrees from -1.
    #[test]
    fn a_phase_margin_is_the_angle_to_minus_one() {
        let period = 1e-3;
        let margins = Margins::of(period, 0.5, |z| {
            let s = Complex::new(0.0, z.arg() / period);
            Complex::new(10.0, 0.0) / (s * (Complex::new(1.0, 0.0) + s / 10.0))
        });
        assert!((margins.crossover - 7.86).abs() < 0.3 && (margins.phase - 51.8).abs() < 1.5, "{margins:?}");
    }
}
