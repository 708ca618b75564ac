//! The little that a kernel asks of a number.

use core::ops::{Add, Div, Mul, Neg, Sub};

use super::sincos;

/// A number, or a pack of numbers that are computed side by side.
pub trait Scalar:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// Zero.
    const ZERO: Self;
    /// One.
    const ONE: Self;
    /// The number `value`.
    fn constant(value: f64) -> Self;
    /// `-1`, `0` or `1`; NaN of NaN.
    fn sign(self) -> Self;
    /// Sines and cosines of all angles together, rad.
    fn sin_cos_all<const N: usize>(angles: &[Self; N]) -> ([Self; N], [Self; N]);
}

impl Scalar for f64 {
    const ZERO: Self = 0.0;
    const ONE: Self = 1.0;
    #[inline(always)]
    fn constant(value: f64) -> Self {
        value
    }
    #[inline(always)]
    fn sign(self) -> Self {
        if self > 0.0 {
            1.0
        } else if self < 0.0 {
            -1.0
        } else {
            self * 0.0
        }
    }
    #[inline]
    fn sin_cos_all<const N: usize>(angles: &[Self; N]) -> ([Self; N], [Self; N]) {
        sincos::all(angles)
    }
}
