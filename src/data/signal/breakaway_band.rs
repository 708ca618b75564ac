//! Passes short bursts of fast motion between two cutoffs where they stand out of the noise.
//!
//! A joint that stops at a reversal and breaks away moves, for some hundredths of a second, far
//! above the band of the commanded motion. A low-pass removes this from the acceleration while the
//! torque keeps it, and the difference looks like a model error. Passing the whole higher band all
//! the time would add mostly noise. A burst must therefore exceed the level that noise reaches once
//! in twenty logs. Noise power of the acceleration between the cutoffs, averaged over its
//! neighbours, is distributed like chi-squared about a median that bursts do not move. Its degrees
//! of freedom are twice the product of bandwidth and averaging time (R. B. Blackman and J. W. Tukey
//! 1958). Around such a peak, as far as it rises out of the noise, each sample takes the share `1 -
//! N / P` of the band (J. S. Lee, *Digital image enhancement and noise filtering by use of local
//! statistics*, IEEE PAMI 2, 1980).
//!
//! The noise of a coarse encoder is not stationary ([`super::encoder_steps`]): power that its steps
//! alone have in the band is no burst.

use super::central;
use super::central_second;
use crate::numerics::median::median;

/// Half the width of the averaging window, s: as long as a burst lasts.
const NEAR: f64 = 0.05;
/// Expected number of false bursts from noise alone, per joint and chunk.
const MISTAKEN: f64 = 0.05;
/// Factor over its median that the power of noise is assumed to have around a burst.
const ABOVE: f64 = 3.0;
/// Share of the largest speed below which a joint counts as standing, where the noise of its
/// encoder is not visible.
const STANDS: f64 = 0.01;

/// Positions and their derivatives, rad, rad/s, rad/s^2.
pub(super) struct Derived {
    pub q: Vec<f64>,
    pub dq: Vec<f64>,
    pub ddq: Vec<f64>,
}

impl Derived {
    pub fn of(q: Vec<f64>, period: f64) -> Self {
        let (dq, ddq) = (central(&q, period), central_second(&q, period));
        Self { q, dq, ddq }
    }

    /// Blends in the part of `wide`, the same signal with a higher cutoff, that exceeds the noise.
    /// `cutoffs`: of both low-passes, Hz; `steps`: errors of the encoder's steps behind both
    /// filters, if known. Returns the weight of `wide` at each sample; empty if all are zero.
    pub fn let_through(&mut self, wide: &Self, cutoffs: [f64; 2], steps: Option<[Self; 2]>, period: f64) -> Vec<f64> {
        let half = ((NEAR / period).round() as usize).max(1);
        let power = between(self, wide, half);
        let fastest = self.dq.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
        let moving = power.iter().zip(&self.dq).filter(|(_, v)| v.abs() > STANDS * fastest).map(|(p, _)| *p);
        let mut sorted: Vec<f64> = moving.collect();
        let Some(median) = median(&mut sorted) else { return Vec::new() };
        let mut shares: Vec<f64> = Vec::new();
        // The effective averaging length of a raised cosine is 4/3 of its half width.
        let time = 4.0 / 3.0 * half as f64 * period;
        let freedom = 2.0 * bandwidth(cutoffs) * time;
        let looks = (power.len() as f64 * period / time).max(1.0);
        let peak = median * (chi_squared(freedom, MISTAKEN / looks) / chi_squared(freedom, 0.5)).max(ABOVE);
        let steps = steps.map_or_else(Vec::new, |[narrow, wide]| between(&narrow, &wide, half));
        let near = |k: usize| steps.get(k.saturating_sub(half)..(k + half + 1).min(steps.len())).unwrap_or(&[]);
        let noise = |k: usize| ABOVE * near(k).iter().fold(median, |most, power| most.max(*power));
        let mut k = 0;
        while k < power.len() {
            if power[k] <= noise(k) {
                k += 1;
                continue;
            }
            let end = (k..power.len()).find(|&i| power[i] <= noise(i)).unwrap_or(power.len());
            if (k..end).any(|i| power[i] > peak.max(noise(i))) {
                shares.resize(power.len(), 0.0);
                (k..end).for_each(|i| shares[i] = 1.0 - noise(i) / power[i]);
            }
            k = end;
        }
        self.share_of(wide, &shares);
        shares
    }

    /// Blends `wide` in with one weight per sample.
    pub fn share_of(&mut self, wide: &Self, shares: &[f64]) {
        for (own, other) in [(&mut self.q, &wide.q), (&mut self.dq, &wide.dq), (&mut self.ddq, &wide.ddq)] {
            for ((own, other), share) in own.iter_mut().zip(other).zip(shares) {
                *own += share * (other - *own);
            }
        }
    }
}

/// Power of the acceleration between two filters, averaged over `half` samples to each side.
fn between(narrow: &Derived, wide: &Derived, half: usize) -> Vec<f64> {
    let band: Vec<f64> = wide.ddq.iter().zip(&narrow.ddq).map(|(a, b)| (a - b) * (a - b)).collect();
    averaged(&band, half)
}

/// Noise bandwidth of the acceleration of white position noise between two cutoffs, Hz: `(int S)^2
/// / int S^2` with `S = f^4`.
fn bandwidth([low, high]: [f64; 2]) -> f64 {
    let whole = (high.powi(5) - low.powi(5)) / 5.0;
    whole * whole / ((high.powi(9) - low.powi(9)) / 9.0)
}

/// Quantile of chi-squared with `freedom` degrees that is exceeded with `probability` (at most a
/// half). Uses the normal approximation of E. B. Wilson and M. M. Hilferty (1931), with the normal
/// quantile of Abramowitz and Stegun, 26.2.23.
fn chi_squared(freedom: f64, probability: f64) -> f64 {
    let t = (-2.0 * probability.clamp(1e-300, 0.5).ln()).sqrt();
    let z =
        t - (2.515_517 + t * (0.802_853 + t * 0.010_328)) / (1.0 + t * (1.432_788 + t * (0.189_269 + t * 0.001_308)));
    let a = 2.0 / (9.0 * freedom.max(0.1));
    freedom * (1.0 - a + z * a.sqrt()).max(0.0).powi(3)
}

/// Moving average with raised cosine weights that fall to zero beyond `half` samples to each side;
/// at the ends over the available samples.
fn averaged(x: &[f64], half: usize) -> Vec<f64> {
    let weights: Vec<f64> =
        (0..=half).map(|i| 0.5 + 0.5 * (std::f64::consts::PI * i as f64 / (half + 1) as f64).cos()).collect();
    (0..x.len())
        .map(|k| {
            let span = k.saturating_sub(half)..(k + half + 1).min(x.len());
            let (mut sum, mut whole) = (0.0, 0.0);
            for i in span {
                let w = weights[i.abs_diff(k)];
                sum += w * x[i];
                whole += w;
            }
            sum / whole
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::encoder_steps::encoder_steps;
    use super::super::low_pass;
    use super::*;
    use crate::numerics::prng::Random;

    /// A joint swings slowly, stands still for 40 ms and catches up. The acceleration is recovered
    /// where it breaks away, and elsewhere the noise stays at the level of the lower cutoff.
    #[test]
    fn a_break_away_is_seen_and_noise_is_not() {
        let (rate, n) = (500.0, 6000);
        let truth = |t: f64| {
            // Catching up: a step of acceleration through a damped oscillator of 10 Hz.
            let since = (t % 2.0) - 1.0;
            let burst = if since > 0.0 { (-60.0 * since).exp() * (60.0 * since).sin() } else { 0.0 };
            (3.0 * t).sin() + 2e-3 * burst
        };
        let mut random = Random::new(3);
        let raw: Vec<f64> =
            (0..n).map(|k| ((truth(k as f64 / rate) + random.uniform(-1e-5, 1e-5)) / 2e-5).round() * 2e-5).collect();
        let exact: Vec<f64> = {
            let h = 1e-4;
            let at = |t: f64| (truth(t + h) - 2.0 * truth(t) + truth(t - h)) / (h * h);
            (0..n).map(|k| at(k as f64 / rate)).collect()
        };
        let filtered = |cutoff: f64| {
            let mut q = raw.clone();
            low_pass(4, cutoff, rate).unwrap().forward_backward(&mut q, 50);
            Derived::of(q, 1.0 / rate)
        };
        let (plain, wide) = (filtered(15.0), filtered(40.0));
        let mut both = filtered(15.0);
        both.let_through(&wide, [15.0, 40.0], None, 1.0 / rate);
        let error = |d: &Derived, near: bool| {
            let at = (200..n - 200).filter(|k| {
                let since = (*k as f64 / rate) % 2.0 - 1.0;
                // Excludes the jump itself.
                if near { (0.012..0.1).contains(&since) } else { !(-0.15..0.3).contains(&since) }
            });
            let squares: Vec<f64> = at.map(|k| (d.ddq[k] - exact[k]).powi(2)).collect();
            (squares.iter().sum::<f64>() / squares.len() as f64).sqrt()
        };
        assert!(error(&both, true) < 0.65 * error(&plain, true), "{} {}", error(&both, true), error(&plain, true));
        assert!(error(&both, false) < 1.2 * error(&plain, false), "{} {}", error(&both, false), error(&plain, false));
        assert!(error(&both, false) < 0.4 * error(&wide, false), "{} {}", error(&both, false), error(&wide, false));
    }

    /// Noise of a tenth of a milliradian, and of the clock, is no burst.
    #[test]
    fn noise_is_let_through_in_few_logs() {
        let (rate, n) = (500.0, 6000_usize);
        let mut touched = 0;
        for seed in 0..20 {
            let mut random = Random::new(seed);
            let gauss = |random: &mut Random| (0..12).map(|_| random.uniform(0.0, 1.0)).sum::<f64>() - 6.0;
            let raw: Vec<f64> = (0..n).map(|k| (0.006 * k as f64).sin() + 1e-4 * gauss(&mut random)).collect();
            let filtered = |cutoff: f64| {
                let mut q = raw.clone();
                low_pass(4, cutoff, rate).unwrap().forward_backward(&mut q, 50);
                Derived::of(q, 1.0 / rate)
            };
            let (plain, mut both) = (filtered(15.0), filtered(15.0));
            both.let_through(&filtered(40.0), [15.0, 40.0], None, 1.0 / rate);
            // The ends, where the filter is one-sided, are cut off later.
            touched += usize::from(plain.ddq[100..n - 100] != both.ddq[100..n - 100]);
        }
        assert!(touched <= 4, "{touched} of 20");
    }

    /// Steps of a coarse encoder at slow reversals are no bursts.
    #[test]
    fn steps_of_an_encoder_are_no_bursts() {
        for rate in [500.0, 1000.0] {
            let (step, n) = (4e-4, (10.0 * rate) as usize);
            let raw: Vec<f64> =
                (0..n).map(|k| ((0.04 * (2.0 * k as f64 / rate).sin()) / step).round() * step).collect();
            let filtered = |x: &[f64], cutoff: f64| {
                let mut q = x.to_vec();
                low_pass(4, cutoff, rate).unwrap().forward_backward(&mut q, 50);
                Derived::of(q, 1.0 / rate)
            };
            let steps = encoder_steps(&raw, step / 12.0_f64.sqrt(), 4.0, 1.0 / rate).unwrap();
            let share = |steps: Option<[Derived; 2]>| {
                filtered(&raw, 15.0).let_through(&filtered(&raw, 40.0), [15.0, 40.0], steps, 1.0 / rate)
            };
            assert!(share(None).iter().any(|s| *s > 0.5), "{rate} Hz");
            let own = share(Some([filtered(&steps, 15.0), filtered(&steps, 40.0)]));
            assert!(own.iter().skip(100).take(n - 200).all(|s| *s == 0.0), "{rate} Hz");
        }
    }

    /// Tabulated values: 5 % and 0.1 % for two and ten degrees of freedom.
    #[test]
    fn chi_squared_of_the_tables() {
        for (freedom, probability, value) in
            [(2.0, 0.05, 5.991), (2.0, 0.001, 13.816), (10.0, 0.05, 18.307), (10.0, 0.001, 29.588)]
        {
            let found = chi_squared(freedom, probability);
            assert!((found / value - 1.0).abs() < 0.03, "{found} {value}");
        }
    }
}
