//! States side by side, in as many registers as they take.

use core::ops::{Add, Div, Mul, Neg, Sub};

use super::Scalar;
use super::registers::{Beside, Native, Register};
use super::sincos;

/// As many numbers as `K` registers hold, computed side by side.
#[derive(Clone, Copy, Debug)]
pub struct Side<R, const K: usize>([R; K]);

/// Eight numbers that are computed side by side.
pub type Pack = Side<Native, { 8 / Native::WIDTH }>;

/// Eight numbers beside scalar code.
pub(super) type Few = Side<Beside, { 8 / Beside::WIDTH }>;

impl<R: Register, const K: usize> Side<R, K> {
    /// How many numbers.
    pub const WIDTH: usize = K * R::WIDTH;

    /// The first numbers of a list; zeros where it ends.
    #[inline(always)]
    #[must_use]
    pub fn load(from: &[f64]) -> Self {
        let mut all = [R::splat(0.0); K];
        for k in 0..K {
            if let Some(from) = from.get(k * R::WIDTH..) {
                all[k] = R::load(from);
            }
        }
        Self(all)
    }

    /// To the first places of a list, as many registers as it has room for.
    #[inline(always)]
    pub fn store(self, to: &mut [f64]) {
        for k in 0..K {
            if let Some(to) = to.get_mut(k * R::WIDTH..) {
                self.0[k].store(to);
            }
        }
    }

    /// Register `k` alone.
    #[inline(always)]
    pub(super) fn only(self, k: usize) -> R {
        self.0[k]
    }

    /// The same with another register `k`.
    #[inline(always)]
    pub(super) fn with(mut self, k: usize, numbers: &[f64]) -> Self {
        self.0[k] = R::load(numbers);
        self
    }

    /// Is every lane's size at most `limit`? (Not so for NaN.)
    #[inline(always)]
    pub(super) fn within(self, limit: f64) -> bool {
        let mut all = true;
        for k in 0..K {
            all &= R::within(self.0[k], limit);
        }
        all
    }

    /// `self` where `x` is not zero, else `x`.
    #[inline(always)]
    pub(super) fn unless_zero(mut self, x: Self) -> Self {
        for k in 0..K {
            self.0[k] = R::unless_zero(self.0[k], x.0[k]);
        }
        self
    }

    /// Sine and cosine turned by as many quarters as the last two bits of `turns` say.
    #[inline(always)]
    pub(super) fn quarter_turned(mut s: Self, mut c: Self, turns: Self) -> (Self, Self) {
        for k in 0..K {
            (s.0[k], c.0[k]) = R::quarter_turned(s.0[k], c.0[k], turns.0[k]);
        }
        (s, c)
    }
}

impl Pack {
    /// From an array, lane by lane.
    #[inline(always)]
    #[must_use]
    pub fn new(values: [f64; 8]) -> Self {
        Self::load(&values)
    }

    /// The lanes.
    #[inline(always)]
    #[must_use]
    pub fn to_array(self) -> [f64; 8] {
        let mut out = [0.0; 8];
        self.store(&mut out);
        out
    }
}

/// Square root, correctly rounded; NaN of a negative number.
#[inline(always)]
#[must_use]
pub fn square_root(x: f64) -> f64 {
    root::square_root(x)
}

/// In one instruction.
#[cfg(target_arch = "x86_64")]
#[allow(unsafe_code)]
mod root {
    use core::arch::x86_64::{_mm_cvtsd_f64, _mm_set_sd, _mm_sqrt_sd};

    #[inline(always)]
    pub(super) fn square_root(x: f64) -> f64 {
        // SAFETY: SSE2 belongs to every x86-64.
        unsafe {
            let v = _mm_set_sd(x);
            _mm_cvtsd_f64(_mm_sqrt_sd(v, v))
        }
    }
}

/// With integers, the same bits.
#[cfg(not(target_arch = "x86_64"))]
mod root {
    pub(super) fn square_root(x: f64) -> f64 {
        if !(x > 0.0) || x == f64::INFINITY {
            return if x < 0.0 { f64::NAN } else { x };
        }
        let (x, up) = if x < f64::MIN_POSITIVE { (x * 18_014_398_509_481_984.0, 27) } else { (x, 0) }; // 2^54
        let exponent = ((x.to_bits() >> 52) & 0x7ff) as i64 - 1075; // x = mantissa 2^exponent
        let mantissa = u128::from((x.to_bits() & ((1 << 52) - 1)) | (1 << 52));
        let odd = exponent & 1;
        // 54 bits of the root: one to round by; the rest, if any, breaks the tie (a root is never
        // half way).
        let square = mantissa << (54 + odd);
        let root = square.isqrt();
        let sticky = u128::from(root * root != square);
        let twice = (root << 1 | sticky) as u64;
        // root = value 2^((exponent - odd - 54)/2)
        let rounded = ((twice + 1 + ((twice >> 2) & 1)) >> 2) as f64; // 53 bits: exact
        let power = (exponent - odd - 54) / 2 + 1 - up;
        rounded * f64::from_bits(((power + 1023) as u64) << 52)
    }
}

impl From<[f64; 8]> for Pack {
    #[inline(always)]
    fn from(values: [f64; 8]) -> Self {
        Self::new(values)
    }
}

impl PartialEq for Pack {
    fn eq(&self, other: &Self) -> bool {
        self.to_array() == other.to_array()
    }
}

macro_rules! operator {
    ($trait:ident, $method:ident) => {
        impl<R: Register, const K: usize> $trait for Side<R, K> {
            type Output = Self;
            #[inline(always)]
            fn $method(mut self, other: Self) -> Self {
                for k in 0..K {
                    self.0[k] = R::$method(self.0[k], other.0[k]);
                }
                self
            }
        }
    };
}
operator!(Add, add);
operator!(Sub, sub);
operator!(Mul, mul);
operator!(Div, div);

impl<R: Register, const K: usize> Neg for Side<R, K> {
    type Output = Self;
    #[inline(always)]
    fn neg(mut self) -> Self {
        for k in 0..K {
            self.0[k] = R::neg(self.0[k]);
        }
        self
    }
}

impl<R: Register, const K: usize> Default for Side<R, K> {
    #[inline(always)]
    fn default() -> Self {
        Self::constant(0.0)
    }
}

impl<R: Register, const K: usize> Scalar for Side<R, K> {
    #[inline(always)]
    fn constant(value: f64) -> Self {
        Self([R::splat(value); K])
    }
    #[inline(always)]
    fn sign(self) -> Self {
        let (mut list, mut signs) = ([0.0; 8], self);
        for k in 0..K {
            self.0[k].store(&mut list);
            signs.0[k] = R::load(&list.map(Scalar::sign));
        }
        signs
    }
    #[inline(always)]
    fn sin_cos_all<const N: usize>(angles: &[Self; N]) -> ([Self; N], [Self; N]) {
        let (mut sin, mut cos) = ([Self::default(); N], [Self::default(); N]);
        for i in 0..N {
            (sin[i], cos[i]) = sincos::together(angles[i]);
        }
        (sin, cos)
    }
}
