//! Share of runs with a property, and a confidence interval for the true share.

/// A count out of a number of runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Share {
    /// Number of runs with the property.
    pub count: usize,
    /// Number of runs.
    pub of: usize,
}

impl Share {
    /// Counts the runs with the property.
    pub fn of(each: impl IntoIterator<Item = bool>) -> Self {
        each.into_iter()
            .fold(Self { count: 0, of: 0 }, |s, yes| Self { count: s.count + usize::from(yes), of: s.of + 1 })
    }

    /// The share, 0 to 1.
    pub fn value(&self) -> f64 {
        self.count as f64 / self.of.max(1) as f64
    }

    /// 95 % interval of the true share (Wilson, J. Am. Stat. Assoc. 22, 1927), also valid at 0 and
    /// 1.
    pub fn interval(&self) -> [f64; 2] {
        const Z: f64 = 1.959_964;
        let (n, p) = (self.of.max(1) as f64, self.value());
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
        for (count, of, low, high) in
            [(81, 263, 0.2553, 0.3662), (15, 148, 0.0624, 0.1605), (0, 20, 0.0, 0.1611), (1, 29, 0.0061, 0.1718)]
        {
            let [a, b] = Share { count, of }.interval();
            assert!((a - low).abs() < 6e-5 && (b - high).abs() < 6e-5, "{count} of {of}: {a} {b}");
        }
    }
}
