//! The little that a kernel asks of a number.

use core::ops::{Add, Div, Mul, Neg, Sub};
use core::sync::atomic::{Ordering, compiler_fence};

use super::sincos;

/// Keeps the stores before it before those after it; no instruction. Otherwise LLVM gathers entries
/// of a row, which are computed far apart, into vectors, and twice as many values wait for their
/// neighbours in memory. (Measured on a regressor of seven joints: 3 % more time.)
#[inline(always)]
pub fn apart() {
    compiler_fence(Ordering::Release);
}

/// Sets all to zero. (`fill` of the library is a call where the compiler does not look across its
/// units.)
#[inline(always)]
pub fn clear<S: Scalar>(entries: &mut [S]) {
    for entry in entries {
        *entry = S::default();
    }
}

/// A number, or a pack of numbers that are computed side by side. `Default` is zero.
pub trait Scalar:
    Copy + Default + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// The number `value`.
    fn constant(value: f64) -> Self;
    /// `-1`, `0` or `1`; NaN of NaN.
    fn sign(self) -> Self;
    /// Sines and cosines of all angles together, rad.
    fn sin_cos_all<const N: usize>(angles: &[Self; N]) -> ([Self; N], [Self; N]);
}

impl Scalar for f64 {
    #[inline(always)]
    fn constant(value: f64) -> Self {
        value
    }
    #[inline(always)]
    fn sign(self) -> Self {
        let positive = if self > 0.0 { 1.0 } else { 0.0 };
        let negative = if self < 0.0 { 1.0 } else { 0.0 };
        if self.is_nan() { self } else { positive - negative }
    }
    #[inline]
    fn sin_cos_all<const N: usize>(angles: &[Self; N]) -> ([Self; N], [Self; N]) {
        let (mut sin, mut cos) = ([0.0; N], [0.0; N]);
        for start in (0..N).step_by(8) {
            let (s, c) = sincos::eight(&core::array::from_fn(|l| if start + l < N { angles[start + l] } else { 0.0 }));
            for l in 0..8 {
                if start + l < N {
                    (sin[start + l], cos[start + l]) = (s[l], c[l]);
                }
            }
        }
        (sin, cos)
    }
}

impl Scalar for f32 {
    #[inline(always)]
    fn constant(value: f64) -> Self {
        value as f32
    }
    #[inline(always)]
    fn sign(self) -> Self {
        f64::from(self).sign() as f32
    }
    #[inline]
    fn sin_cos_all<const N: usize>(angles: &[Self; N]) -> ([Self; N], [Self; N]) {
        let (sin, cos) = f64::sin_cos_all(&angles.map(f64::from));
        (sin.map(|x| x as f32), cos.map(|x| x as f32))
    }
}
