//! Noise of the torques, and autocorrelation time of residuals.

use super::recording::Stretch;
use crate::data::signal::noise_between_reversals;
use crate::identify::dot;

/// Standard deviation of each joint's torque noise, N m, without a model: see
/// [`noise_between_reversals`]. If samples were resampled at estimated times, what remains of the
/// noise of the original samples.
pub fn torque_noise<'r>(stretches: impl Iterator<Item = &'r Stretch> + Clone, dof: usize) -> Vec<f64> {
    let all = || stretches.clone();
    let of = |j: usize| {
        let (mut squares, mut samples) = (0.0, 0);
        for stretch in all().filter(|s| s.torque_noise.len() == dof) {
            squares += stretch.torque_noise[j].powi(2) * stretch.states.len as f64;
            samples += stretch.states.len;
        }
        let plain = || all().filter(|s| s.torque_noise.len() != dof);
        let others: usize = plain().map(|s| s.states.len).sum();
        if others > 0 {
            let slowest = plain().map(|s| s.period).fold(0.0, f64::max);
            let series = plain().map(|s| (s.of(&s.tau, j), s.of(&s.states.dq, j)));
            let noise = noise_between_reversals(series, slowest.recip());
            squares += noise.powi(2) * others as f64;
        }
        (squares / (samples + others).max(1) as f64).sqrt()
    };
    (0..dof).map(of).collect()
}

/// Autocorrelation time of a residual, windows: `1 + 2 sum rho_k` up to the first negative pair
/// (Geyer 1992), at least 1.
pub fn autocorrelation_time(residual: &[f64], live: &[bool]) -> f64 {
    let n = residual.len();
    let masked: Vec<f64> = residual.iter().zip(live).map(|(e, live)| if *live { *e } else { 0.0 }).collect();
    let variance = dot(&masked, &masked);
    let count = live.iter().filter(|l| **l).count() as f64;
    if variance == 0.0 || count < 20.0 {
        return 1.0;
    }
    let used = Bits::of(live);
    let correlation = |lag: usize| {
        let pairs = f64::from(used.pairs(lag));
        if pairs < 10.0 { 0.0 } else { product(&masked[..n - lag], &masked[lag..]) / pairs / (variance / count) }
    };
    let mut total = 1.0;
    let mut lag = 1;
    while lag + 1 < n.min(400) {
        let pair = correlation(lag) + correlation(lag + 1);
        if pair <= 0.02 {
            break;
        }
        total += 2.0 * pair;
        lag += 2;
    }
    total.clamp(1.0, count / 5.0)
}

/// Inner product in the widest registers of this processor, bitwise equal to any other width.
#[multiversion::multiversion(targets("x86_64+avx2"))]
fn product(a: &[f64], b: &[f64]) -> f64 {
    dot(a, b)
}

/// Flags of the used windows, 64 to a word.
struct Bits(Vec<u64>);

impl Bits {
    fn of(live: &[bool]) -> Self {
        let word = |w: &[bool]| w.iter().enumerate().fold(0, |bits, (i, live)| bits | u64::from(*live) << i);
        Self(live.chunks(64).map(word).collect())
    }

    /// Number of used windows for which the window `lag` later is also used.
    fn pairs(&self, lag: usize) -> u32 {
        let (words, by) = (lag / 64, lag % 64);
        let later = |k: usize| self.0.get(k + words).copied().unwrap_or(0);
        let shifted = |k: usize| if by == 0 { later(k) } else { later(k) >> by | later(k + 1) << (64 - by) };
        self.0.iter().enumerate().map(|(k, word)| (word & shifted(k)).count_ones()).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::prng::Random;

    #[test]
    fn memory_of_an_autoregression() {
        let mut random = Random::new(5);
        let mut x = 0.0;
        let series: Vec<f64> = (0..20_000)
            .map(|_| {
                x = 0.8 * x + random.uniform(-1.0, 1.0);
                x
            })
            .collect();
        // Theory: (1 + a) / (1 - a).
        let found = autocorrelation_time(&series, &vec![true; series.len()]);
        assert!((found / 9.0 - 1.0).abs() < 0.25, "{found}");
    }

    #[test]
    fn pairs_of_used_windows_are_counted() {
        let mut random = Random::new(8);
        let live: Vec<bool> = (0..1000).map(|_| random.uniform(0.0, 1.0) < 0.7).collect();
        let used = Bits::of(&live);
        for lag in [0, 1, 2, 63, 64, 65, 399] {
            let counted = (0..live.len() - lag).filter(|&w| live[w] && live[w + lag]).count();
            assert_eq!(used.pairs(lag) as usize, counted, "{lag}");
        }
    }
}
