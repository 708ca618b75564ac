//! Interval bounds on the value of an expression for any motion, since a law must be defined
//! everywhere.

use crate::elementary::Real;
use crate::runtime::Scalar;

/// Interval from the smallest to the largest value, either of which may be infinite.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Bounds {
    pub least: f64,
    pub most: f64,
}

impl Bounds {
    pub const ANY: Self = Self { least: f64::NEG_INFINITY, most: f64::INFINITY };

    /// Interval from two bounds; NaN means unbounded.
    pub fn new(least: f64, most: f64) -> Self {
        let or = |bound: f64, none: f64| if bound.is_nan() { none } else { bound };
        Self { least: or(least, f64::NEG_INFINITY), most: or(most, f64::INFINITY) }
    }

    pub fn of(value: f64) -> Self {
        Self::new(value, value)
    }

    /// Whether the interval contains 0.
    pub fn holds_zero(self) -> bool {
        self.least <= 0.0 && self.most >= 0.0
    }

    pub fn plus(self, other: Self) -> Self {
        Self::new(self.least + other.least, self.most + other.most)
    }

    pub fn negated(self) -> Self {
        Self::new(-self.most, -self.least)
    }

    pub fn times(self, other: Self) -> Self {
        let (a, b) = (self, other);
        hull([a.least * b.least, a.least * b.most, a.most * b.least, a.most * b.most])
    }

    /// Bounds of the inverse; the interval must not contain 0.
    pub fn inverse(self) -> Self {
        Self::new(1.0 / self.most, 1.0 / self.least)
    }

    pub fn abs(self) -> Self {
        let most = self.most.max(-self.least);
        let least = if self.holds_zero() { 0.0 } else { self.least.abs().min(self.most.abs()) };
        Self::new(least, most)
    }

    /// Bounds of an integer power, from 0.
    pub fn raised(self, n: u32) -> Self {
        let power = |x: f64| (0..n).fold(1.0, |y, _| y * x);
        let of = if n.is_multiple_of(2) { self.abs() } else { self };
        Self::new(power(of.least), power(of.most))
    }

    /// Bounds of a function that increases with its argument.
    pub fn by(self, f: impl Fn(f64) -> f64) -> Self {
        Self::new(f(self.least), f(self.most))
    }

    pub fn exp(self) -> Self {
        // An exponential underflows to 0.
        self.by(|x| if x == f64::NEG_INFINITY { 0.0 } else { Real::exp(x) })
    }

    pub fn sign(self) -> Self {
        self.by(|x| x.sign())
    }

    pub fn least_of(self, other: Self) -> Self {
        Self::new(self.least.min(other.least), self.most.min(other.most))
    }

    pub fn most_of(self, other: Self) -> Self {
        Self::new(self.least.max(other.least), self.most.max(other.most))
    }
}

/// Smallest interval that contains these products; 0 times infinity is 0, since the infinite value
/// is not attained.
fn hull(values: [f64; 4]) -> Bounds {
    let values = values.map(|x| if x.is_nan() { 0.0 } else { x });
    let least = values.iter().copied().fold(f64::INFINITY, f64::min);
    Bounds::new(least, values.iter().copied().fold(f64::NEG_INFINITY, f64::max))
}
