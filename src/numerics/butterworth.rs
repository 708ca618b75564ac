//! Butterworth low-pass filters.

use std::f64::consts::PI;

use crate::numerics::sos::{Biquad, Sos};

/// A cutoff that is invalid for the sampling rate.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error("a low-pass of {cutoff} Hz and order {order} needs samples at more than {} Hz; these come at {rate:.4} Hz{}: lower the cutoff or leave the filter out", 2.0 * .cutoff, slow(*.rate))]
pub struct CutoffError {
    /// Cutoff, Hz.
    pub cutoff: f64,
    /// Order.
    pub order: usize,
    /// Sampling rate, Hz.
    pub rate: f64,
}

/// Hint for an implausible sampling rate: no robot is recorded at less than 2 Hz.
fn slow(rate: f64) -> &'static str {
    if rate < 2.0 { " (is `t` in milliseconds or ticks? It must be in s)" } else { "" }
}

/// The digital Butterworth low-pass of this order, -3 dB at `cutoff` Hz for samples at `rate` Hz,
/// as second-order sections of unit DC gain.
///
/// Each analog pair `1 / (s^2 + 2 zeta s + 1)`, `zeta` the cosine of the angle of the poles from
/// the negative real axis, is mapped by the bilinear transform. The cutoff is prewarped, `K =
/// tan(pi cutoff / rate)` (Oppenheim and Schafer, Discrete-Time Signal Processing, section 7.1.2).
pub fn low_pass(order: usize, cutoff: f64, rate: f64) -> Result<Sos, CutoffError> {
    if order == 0 || order > 20 || !cutoff.is_finite() || cutoff <= 0.0 || cutoff >= 0.499 * rate {
        return Err(CutoffError { cutoff, order, rate });
    }
    let k = (PI * cutoff / rate).tan();
    let mut sections = Vec::new();
    for pair in 0..order / 2 {
        // Angle of the pole from the negative real axis, largest (least damped) for the last pair.
        let zeta = ((order - 1 - 2 * pair) as f64 * PI / (2 * order) as f64).cos();
        let d = 1.0 + 2.0 * zeta * k + k * k;
        let b = k * k / d;
        let (a1, a2) = (2.0 * (k * k - 1.0) / d, (1.0 - 2.0 * zeta * k + k * k) / d);
        sections.push(Biquad { b: [b, 2.0 * b, b], a: [a1, a2] });
    }
    if order % 2 == 1 {
        let b = k / (1.0 + k);
        sections.push(Biquad { b: [b, b, 0.0], a: [(k - 1.0) / (k + 1.0), 0.0] });
    }
    sections.reverse();
    Ok(Sos { sections, order })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_power_at_the_cutoff_and_the_analytic_slope() {
        for order in 1..=9 {
            let (cutoff, rate) = (10.0, 200.0);
            let sos = low_pass(order, cutoff, rate).unwrap();
            assert!((sos.gain(0.0, rate) - 1.0).abs() < 1e-12);
            for f in [1.0, 5.0, 10.0, 20.0, 60.0] {
                // |H|^2 = 1 / (1 + (tan(pi f / fs) / K)^(2 n)), exact for the bilinear transform.
                let ratio = (PI * f / rate).tan() / (PI * cutoff / rate).tan();
                let expected = (1.0 + ratio.powi(2 * order as i32)).sqrt().recip();
                assert!((sos.gain(f, rate) - expected).abs() < 1e-12, "order {order}, {f} Hz");
            }
        }
    }

    #[test]
    fn cutoff_beyond_half_the_rate() {
        let error = low_pass(5, 10.0, 1.0).unwrap_err().to_string();
        assert!(error.contains("10 Hz") && error.contains("20 Hz"), "{error}");
        assert!(low_pass(0, 1.0, 10.0).is_err() && low_pass(5, f64::NAN, 10.0).is_err());
    }
}
