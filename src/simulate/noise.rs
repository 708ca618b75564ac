//! Random numbers of the sensors: the same for the same seed on every machine.

use crate::numerics::prng::Random;

/// Stream of normal deviates.
#[derive(Debug, Clone)]
pub(super) struct Noise {
    random: Random,
    spare: Option<f64>,
}

impl Noise {
    /// Stream number `stream` of a seed; what is drawn from one stream does not shift another.
    pub fn new(seed: u64, stream: u64) -> Self {
        let mut random = Random::new(seed ^ stream.wrapping_mul(0xD1B5_4A32_D192_ED03));
        random.bits();
        Self { random, spare: None }
    }

    /// Standard normal: Marsaglia's polar method (SIAM Review 6, 1964).
    pub fn normal(&mut self) -> f64 {
        if let Some(spare) = self.spare.take() {
            return spare;
        }
        loop {
            let (u, v) = (self.random.even(1.0), self.random.even(1.0));
            let s = u * u + v * v;
            if s > 0.0 && s < 1.0 {
                let factor = (-2.0 * libm::log(s) / s).sqrt();
                self.spare = Some(v * factor);
                return u * factor;
            }
        }
    }
}

/// Coloured noise: white noise through a first-order low-pass (a Gauss-Markov process), of standard
/// deviation 1.
#[derive(Debug, Clone)]
pub(super) struct Coloured {
    keep: f64,
    value: f64,
    noise: Noise,
}

impl Coloured {
    /// Noise with this corner frequency, Hz, sampled every `period` s.
    pub fn new(mut noise: Noise, corner: f64, period: f64) -> Self {
        let keep = libm::exp(-std::f64::consts::TAU * corner * period);
        let value = noise.normal();
        Self { keep, value, noise }
    }

    pub fn next(&mut self) -> f64 {
        let now = self.value;
        self.value = self.keep * now + (1.0 - self.keep * self.keep).sqrt() * self.noise.normal();
        now
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn moments_and_correlation() {
        let mut noise = Noise::new(7, 1);
        let n = 200_000;
        let (mut mean, mut square, mut fourth) = (0.0, 0.0, 0.0);
        for _ in 0..n {
            let x = noise.normal();
            mean += x;
            square += x * x;
            fourth += x * x * x * x;
        }
        let n = f64::from(n);
        assert!((mean / n).abs() < 0.01 && (square / n - 1.0).abs() < 0.01 && (fourth / n - 3.0).abs() < 0.06);
        let mut coloured = Coloured::new(Noise::new(7, 2), 5.0, 1e-3);
        let values: Vec<f64> = (0..400_000).map(|_| coloured.next()).collect();
        let product =
            |lag: usize| values.windows(lag + 1).map(|w| w[0] * w[lag]).sum::<f64>() / (values.len() - lag) as f64;
        assert!((product(0) - 1.0).abs() < 0.05, "{}", product(0));
        let expected = (-std::f64::consts::TAU * 5.0 * 0.02f64).exp();
        assert!((product(20) - expected).abs() < 0.05, "{} {expected}", product(20));
    }
}
