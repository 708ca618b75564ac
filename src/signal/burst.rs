//! Short, fast motion between two cutoffs, let through where it stands out of the noise.
//!
//! A joint that stops at a reversal and breaks away moves, for some hundredths of a second, far above the band of the motion that was asked for. A low-pass
//! takes that out of the acceleration while the torque keeps it, and the difference is nobody's error. All of the higher band all the time would be
//! mostly noise. So each sample takes of it the share `1 - k N / P`, `P` the power of the acceleration there, averaged over its neighbours, and `N` the
//! usual one (J. S. Lee, *Digital image enhancement and noise filtering by use of local statistics*, IEEE PAMI 2, 1980).

use super::{central, central_second};

/// Half the width of the average, s: as long as a burst lasts.
const NEAR: f64 = 0.03;
/// How many times the usual power is taken for noise: powers scatter.
const SCATTER: f64 = 2.0;
/// Share of the largest speed below which a joint stands, and its encoder's noise is not to be seen.
const STANDS: f64 = 0.01;

/// Positions with their derivatives, rad, rad/s, rad/s^2.
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

    /// Takes what `wide`, the same signal with a higher cutoff, has beyond the noise.
    pub fn let_through(&mut self, wide: &Self, period: f64) {
        let band: Vec<f64> = wide.ddq.iter().zip(&self.ddq).map(|(a, b)| (a - b) * (a - b)).collect();
        let power = averaged(&band, ((NEAR / period).round() as usize).max(1));
        let fastest = self.dq.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
        let moving = power.iter().zip(&self.dq).filter(|(_, v)| v.abs() > STANDS * fastest).map(|(p, _)| *p);
        let mut sorted: Vec<f64> = moving.collect();
        if sorted.is_empty() {
            return;
        }
        let middle = sorted.len() / 2;
        let noise = SCATTER * *sorted.select_nth_unstable_by(middle, f64::total_cmp).1;
        for (k, &power) in power.iter().enumerate() {
            if power > noise {
                let share = 1.0 - noise / power;
                self.q[k] += share * (wide.q[k] - self.q[k]);
                self.dq[k] += share * (wide.dq[k] - self.dq[k]);
                self.ddq[k] += share * (wide.ddq[k] - self.ddq[k]);
            }
        }
    }
}

/// Averages with weights that fall on a raised cosine to zero beyond `half` samples to each side; at the ends of those that there are.
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
    use super::super::low_pass;
    use super::*;
    use crate::numeric::random::Random;

    /// A joint that swings slowly, stands still for 40 ms and catches up: its acceleration comes back where it breaks away, and the noise elsewhere
    /// stays as low as the lower cutoff leaves it.
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
        both.let_through(&wide, 1.0 / rate);
        let error = |d: &Derived, near: bool| {
            let at = (200..n - 200).filter(|k| {
                let since = (*k as f64 / rate) % 2.0 - 1.0;
                // Not the jump itself.
                if near { (0.012..0.1).contains(&since) } else { !(-0.15..0.3).contains(&since) }
            });
            let squares: Vec<f64> = at.map(|k| (d.ddq[k] - exact[k]).powi(2)).collect();
            (squares.iter().sum::<f64>() / squares.len() as f64).sqrt()
        };
        assert!(error(&both, true) < 0.65 * error(&plain, true), "{} {}", error(&both, true), error(&plain, true));
        assert!(error(&both, false) < 1.6 * error(&plain, false), "{} {}", error(&both, false), error(&plain, false));
        assert!(error(&both, false) < 0.4 * error(&wide, false), "{} {}", error(&both, false), error(&wide, false));
    }
}
