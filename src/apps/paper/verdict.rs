//! Comparison of our figures with the paper's.

use std::fmt;

/// Comparison of a figure, of which less is better, with the paper's.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Verdict {
    /// Smaller by more than the tolerance.
    Better,
    /// Within the tolerance.
    Within,
    /// Larger, by this percentage of the paper's.
    Short(f64),
    /// No reference to compare with.
    Open,
}

/// Relative difference within which two figures count as equal: the resolution of the paper's
/// printed digits.
const ALIKE: f64 = 0.05;

impl Verdict {
    /// Compares two figures of which less is better.
    pub fn less(ours: f64, paper: f64) -> Self {
        match ours / paper {
            ratio if !ratio.is_finite() => Self::Open,
            ratio if ratio < 1.0 - ALIKE => Self::Better,
            ratio if ratio <= 1.0 + ALIKE => Self::Within,
            ratio => Self::Short(100.0 * (ratio - 1.0)),
        }
    }

    /// Checks a claim of an upper limit; a violation is given in percent.
    pub fn at_most(ours: f64, limit: f64) -> Self {
        match ours / limit {
            ratio if !ratio.is_finite() => Self::Open,
            ratio if ratio <= 1.0 => Self::Within,
            ratio => Self::Short(100.0 * (ratio - 1.0)),
        }
    }

    /// Whether the figure is better than or within the tolerance of the reference.
    pub fn holds(&self) -> bool {
        matches!(self, Self::Better | Self::Within)
    }
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Better => f.write_str("better"),
            Self::Within => f.write_str("within"),
            Self::Short(percent) => write!(f, "short by {percent:.0} %"),
            Self::Open => f.write_str("open"),
        }
    }
}
