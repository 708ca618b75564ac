//! Noise of the torques, and autocorrelation time of their errors.

use super::recording::Recording;
use crate::data::signal::white_noise;

/// Standard deviation of each joint's torque noise, N m, without a model. It comes from fourth
/// differences of the raw samples, in which motion below a tenth of the sampling rate leaves
/// nothing. Noise that was low-passed before it was recorded is not seen. Where rows were put on
/// another clock, that of the rows.
pub fn torque_noise(recordings: &[Recording], dof: usize) -> Vec<f64> {
    let all = || recordings.iter().flat_map(|r| &r.stretches);
    let of = |j: usize| {
        let (mut squares, mut samples) = (0.0, 0);
        for stretch in all().filter(|s| s.torque_noise.len() == dof) {
            squares += stretch.torque_noise[j].powi(2) * stretch.states.len as f64;
            samples += stretch.states.len;
        }
        let plain = || all().filter(|s| s.torque_noise.len() != dof);
        let others: usize = plain().map(|s| s.states.len).sum();
        if others > 0 {
            squares += white_noise(plain().map(|s| s.of(&s.tau, j))).powi(2) * others as f64;
        }
        (squares / (samples + others).max(1) as f64).sqrt()
    };
    (0..dof).map(of).collect()
}

/// Autocorrelation time of a residual, windows: `1 + 2 sum rho_k` up to the first negative
/// pair (Geyer 1992), at least 1.
pub fn autocorrelation_time(residual: &[f64], live: &[bool]) -> f64 {
    let n = residual.len();
    let variance: f64 = residual.iter().map(|e| e * e).sum::<f64>();
    let count = live.iter().filter(|l| **l).count() as f64;
    if variance == 0.0 || count < 20.0 {
        return 1.0;
    }
    let correlation = |lag: usize| {
        let (mut sum, mut pairs) = (0.0, 0.0);
        for w in 0..n - lag {
            if live[w] && live[w + lag] {
                sum += residual[w] * residual[w + lag];
                pairs += 1.0;
            }
        }
        if pairs < 10.0 { 0.0 } else { sum / pairs / (variance / count) }
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
        // (1 + a) / (1 - a)
        let found = autocorrelation_time(&series, &vec![true; series.len()]);
        assert!((found / 9.0 - 1.0).abs() < 0.25, "{found}");
    }
}
