//! Random numbers: splitmix64 (G. Steele, D. Lea and C. Flood, *Fast splittable pseudorandom number
//! generators*, OOPSLA 2014).
//!
//! Ten lines instead of a crate, so that a seed that once found a mistake finds it after every
//! update.

/// A stream of random numbers determined by its seed.
#[derive(Debug, Clone)]
pub struct Random {
    state: u64,
}

impl Random {
    /// The stream of this seed.
    pub fn new(seed: u64) -> Self {
        Self { state: seed }
    }

    /// Stream `stream` of a seed.
    pub fn stream(seed: u64, stream: u64) -> Self {
        let mut random = Self::new(seed ^ stream.wrapping_mul(0xD134_2543_DE82_EF95));
        random.bits();
        random
    }

    /// The next 64 bits.
    pub fn bits(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.state;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// Uniform in `[low, high)`.
    pub fn uniform(&mut self, low: f64, high: f64) -> f64 {
        let unit = (self.bits() >> 11) as f64 / (1u64 << 53) as f64;
        low + (high - low) * unit
    }

    /// Uniform in `[-size, size)`.
    pub fn even(&mut self, size: f64) -> f64 {
        self.uniform(-size, size)
    }

    /// Vector of `len` numbers, uniform in `[-size, size)`.
    pub fn vector(&mut self, len: usize, size: f64) -> Vec<f64> {
        (0..len).map(|_| self.even(size)).collect()
    }

    /// True with this probability.
    pub fn chance(&mut self, probability: f64) -> bool {
        self.uniform(0.0, 1.0) < probability
    }

    /// Uniform among `0..count`; zero when `count` is zero.
    pub fn below(&mut self, count: usize) -> usize {
        // The bias of the remainder is 2^-60 here.
        (self.bits() % count.max(1) as u64) as usize
    }
}
