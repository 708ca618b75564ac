//! Number of successes out of a total, and a confidence interval for the true share.

/// A count out of a total.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Tally {
    /// Number of successes.
    pub good: usize,
    /// Total number.
    pub all: usize,
}

impl Tally {
    /// Counts the successes.
    pub(super) fn of(each: impl IntoIterator<Item = bool>) -> Self {
        let mut tally = Self::default();
        each.into_iter().for_each(|good| tally.count(good));
        tally
    }

    pub(super) fn count(&mut self, good: bool) {
        self.good += usize::from(good);
        self.all += 1;
    }

    /// Share of successes, 0 to 1; `None` if the total is zero.
    pub fn value(&self) -> Option<f64> {
        (self.all > 0).then(|| self.good as f64 / self.all as f64)
    }

    /// 95 % interval of the true share (Wilson, J. Am. Stat. Assoc. 22, 1927), also valid at 0 and
    /// 1.
    pub fn interval(&self) -> [f64; 2] {
        const Z: f64 = 1.959_964;
        let (n, p) = (self.all.max(1) as f64, self.value().unwrap_or(0.0));
        let z2 = Z * Z / n;
        let (middle, half) = ((p + 0.5 * z2) / (1.0 + z2), Z * (p * (1.0 - p) / n + 0.25 * z2 / n).sqrt() / (1.0 + z2));
        [(middle - half).max(0.0), (middle + half).min(1.0)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Newcombe, Statistics in Medicine 17 (1998), table I, method 3: 81 of 263, 15 of 148, 0 of
    /// 20, 1 of 29.
    #[test]
    fn intervals_are_the_published_ones() {
        for (good, all, low, high) in
            [(81, 263, 0.2553, 0.3662), (15, 148, 0.0624, 0.1605), (0, 20, 0.0, 0.1611), (1, 29, 0.0061, 0.1718)]
        {
            let [a, b] = Tally { good, all }.interval();
            assert!((a - low).abs() < 6e-5 && (b - high).abs() < 6e-5, "{good} of {all}: {a} {b}");
        }
    }
}
