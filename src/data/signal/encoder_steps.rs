//! Simulates the quantisation error of an encoder along a recorded motion.
//!
//! An encoder that is read more often than it steps has no random error. Its error is a sawtooth of
//! `|dq| / step` teeth a second (W. R. Bennett, *Spectra of quantized signals*, Bell Syst. Tech. J.
//! 27, 1948): flat noise while the joint is fast. Near a reversal it has few, long teeth whose
//! harmonics lie within the band of the motion, many times above the flat noise. Neither the
//! spectrum of the positions nor its flat part shows which part is the encoder's. But the step size
//! is known: an encoder with these steps, simulated along a smooth motion like the recorded one,
//! has a similar error. It is another realisation of the same error.

use super::low_pass;

/// Order of the low-pass that smooths the motion.
const ORDER: usize = 4;
/// Least ratio of the step to the noise. Rounding alone has `step = sqrt(12) noise`; below this
/// ratio other noise hides the steps.
const HIDDEN: f64 = 2.0;

/// Simulated errors of an encoder with the step size found in the positions, along the same motion
/// below `smooth`, Hz. Positions are as recorded, at even times `period` apart, s, with white noise
/// of standard deviation `noise`, rad. `None` if no steps are visible.
pub(super) fn encoder_steps(q: &[f64], noise: f64, smooth: f64, period: f64) -> Option<Vec<f64>> {
    let step = step(q, noise)?;
    let sos = low_pass(ORDER, smooth, period.recip()).ok()?;
    let mut motion = q.to_vec();
    let pad = (1.0 / (period * smooth)).ceil() as usize;
    sos.forward_backward(&mut motion, pad.max(sos.scipy_padding()));
    let origin = q.first()?;
    Some(motion.iter().map(|x| ((x - origin) / step).round().mul_add(step, origin - x)).collect())
}

/// Step size of an encoder: the smallest change between neighbouring samples, rad.
fn step(q: &[f64], noise: f64) -> Option<f64> {
    let changes = q.windows(2).map(|w| (w[1] - w[0]).abs());
    // Differences in the last digits of equal positions are below any encoder's resolution.
    let digits = q.iter().fold(0.0_f64, |most, x| most.max(x.abs())) * 1e-12;
    let least = changes.filter(|d| *d > digits).fold(f64::INFINITY, f64::min);
    (least.is_finite() && least > HIDDEN * noise).then_some(least)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::prng::Random;

    /// Slow and fast motion at 1 kHz: behind a low-pass the simulated error has the power of the
    /// true one, unlike white noise of the same variance.
    #[test]
    fn errors_have_the_power_of_the_true_ones() {
        let (rate, step) = (1000.0, 4e-4);
        for speed in [0.005, 0.01, 0.3, 3.0] {
            let truth =
                |k: usize| 0.7 + speed * (1.3 * k as f64 / rate).sin() + 0.1 * speed * (5.0 * k as f64 / rate).cos();
            let q: Vec<f64> = (0..20_000).map(|k| (truth(k) / step).round() * step).collect();
            let behind = |errors: &[f64]| {
                let mut x = errors.to_vec();
                low_pass(4, 15.0, rate).unwrap().forward_backward(&mut x, 100);
                let a = crate::data::signal::central_second(&x, 1.0 / rate);
                (a[500..19_500].iter().map(|a| a * a).sum::<f64>() / 19_000.0).sqrt()
            };
            let own: Vec<f64> = q.iter().enumerate().map(|(k, q)| q - truth(k)).collect();
            let played = encoder_steps(&q, step / 12.0_f64.sqrt(), 4.0, 1.0 / rate).unwrap();
            let ratio = behind(&played) / behind(&own);
            assert!((0.7..1.4).contains(&ratio), "{speed}: {ratio}");
            let mut random = Random::new(4);
            let white: Vec<f64> = q.iter().map(|_| random.uniform(-0.5 * step, 0.5 * step)).collect();
            assert!(speed > 0.1 || behind(&white) < 0.5 * behind(&own), "{speed}");
        }
    }

    /// Noise hides the steps, and a joint at rest shows none.
    #[test]
    fn steps_are_seen_or_not() {
        let step = 1e-4;
        let q: Vec<f64> = (0..2000).map(|k| ((0.01 * k as f64).sin() / step).round() * step).collect();
        let noise = step / 12.0_f64.sqrt();
        assert!((super::step(&q, noise).unwrap() / step - 1.0).abs() < 1e-6);
        assert_eq!(super::step(&[0.3; 100], 0.0), None);
        let mut random = Random::new(1);
        let noisy: Vec<f64> = q.iter().map(|q| q + random.uniform(-step, step)).collect();
        assert_eq!(encoder_steps(&noisy, 0.6 * step, 4.0, 1e-3), None);
    }
}
