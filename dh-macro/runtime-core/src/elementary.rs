//! Operations that laws of drives need beyond [`Scalar`]: sizes, roots, exponentials, single sines.
//! Shipped verbatim into crates whose robot file has effects; the interpreter uses the same text.
//!
//! The exponential and the logarithm reduce their argument by powers of two and use the polynomials
//! of fdlibm's `e_exp.c` and `e_log.c`. They are within 1 ulp, use additions, multiplications and
//! divisions only, and give the same bits on every machine.

use super::runtime::{Pack, Scalar, square_root};

/// A number, or a pack of numbers, that laws of drives can be computed with.
pub trait Real: Scalar {
    /// Size.
    #[must_use]
    fn abs(self) -> Self;
    /// The smaller of two; `other` where one is NaN.
    #[must_use]
    fn min(self, other: Self) -> Self;
    /// The larger of two; `other` where one is NaN.
    #[must_use]
    fn max(self, other: Self) -> Self;
    /// Square root; NaN of a negative number.
    #[must_use]
    fn sqrt(self) -> Self;
    /// `e` to this power.
    #[must_use]
    fn exp(self) -> Self;
    /// Natural logarithm; minus infinity of 0, NaN of a negative number.
    #[must_use]
    fn ln(self) -> Self;
    /// Sine of an angle, rad.
    #[must_use]
    #[inline]
    fn sin(self) -> Self {
        Self::sin_cos_all(&[self]).0[0]
    }
    /// Cosine of an angle, rad.
    #[must_use]
    #[inline]
    fn cos(self) -> Self {
        Self::sin_cos_all(&[self]).1[0]
    }
}

impl Real for f64 {
    #[inline(always)]
    fn abs(self) -> Self {
        f64::from_bits(self.to_bits() & !(1 << 63))
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        if self < other { self } else { other }
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        if self > other { self } else { other }
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        square_root(self)
    }
    #[inline]
    fn exp(self) -> Self {
        exponential(self)
    }
    #[inline]
    fn ln(self) -> Self {
        logarithm(self)
    }
}

impl Real for f32 {
    #[inline(always)]
    fn abs(self) -> Self {
        Real::abs(f64::from(self)) as f32
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        if self < other { self } else { other }
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        if self > other { self } else { other }
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        square_root(f64::from(self)) as f32
    }
    #[inline]
    fn exp(self) -> Self {
        exponential(f64::from(self)) as f32
    }
    #[inline]
    fn ln(self) -> Self {
        logarithm(f64::from(self)) as f32
    }
}

/// Lane by lane: the same bits as one number at a time.
#[inline(always)]
fn each(x: Pack, f: impl Fn(f64) -> f64) -> Pack {
    Pack::new(x.to_array().map(f))
}

/// The same of two.
#[inline(always)]
fn both(x: Pack, y: Pack, f: impl Fn(f64, f64) -> f64) -> Pack {
    let [a, b, c, d, e, g, h, i] = x.to_array();
    let [j, k, l, m, n, o, p, q] = y.to_array();
    Pack::new([f(a, j), f(b, k), f(c, l), f(d, m), f(e, n), f(g, o), f(h, p), f(i, q)])
}

impl Real for Pack {
    #[inline(always)]
    fn abs(self) -> Self {
        each(self, Real::abs)
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        both(self, other, Real::min)
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        both(self, other, Real::max)
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        each(self, square_root)
    }
    #[inline]
    fn exp(self) -> Self {
        each(self, exponential)
    }
    #[inline]
    fn ln(self) -> Self {
        each(self, logarithm)
    }
}

/// Adding and subtracting it rounds to the nearest whole number.
const ROUND: f64 = 6_755_399_441_055_744.0;
/// ln 2 in two pieces; the first has 33 bits, so that its products with an exponent are exact.
const LN2: [f64; 2] = [6.931_471_803_691_238e-1, 1.908_214_929_270_587_7e-10];
const E: [f64; 5] = [
    1.666_666_666_666_660_2e-1,
    -2.777_777_777_701_559_3e-3,
    6.613_756_321_437_934e-5,
    -1.653_390_220_546_525_2e-6,
    4.138_136_797_057_238_5e-8,
];
const L: [f64; 7] = [
    6.666_666_666_666_735e-1,
    3.999_999_999_940_942e-1,
    2.857_142_874_366_239e-1,
    2.222_219_843_214_978_4e-1,
    1.818_357_216_161_805e-1,
    1.531_383_769_920_937_3e-1,
    1.479_819_860_511_658_6e-1,
];

/// `2^k`, `-1022 <= k <= 1023`.
fn power_of_two(k: i64) -> f64 {
    f64::from_bits(((k + 1023) as u64) << 52)
}

/// `exp(x) = 2^k exp(r)`, `|r| <= ln(2)/2`, with the even part of `r coth(r/2)` as a polynomial.
fn exponential(x: f64) -> f64 {
    if x.is_nan() {
        return x;
    }
    if x > 709.782_712_893_384 {
        return f64::INFINITY;
    }
    if x < -745.133_219_101_941_1 {
        return 0.0;
    }
    let k = (x * core::f64::consts::LOG2_E + ROUND) - ROUND;
    let (high, low) = (x - k * LN2[0], k * LN2[1]);
    let r = high - low;
    let z = r * r;
    let c = r - z * (E[0] + z * (E[1] + z * (E[2] + z * (E[3] + z * E[4]))));
    let y = 1.0 + ((r * c / (2.0 - c) - low) + high);
    // In two steps, since neither 2^1024 nor a small result's power is a normal number.
    let k = k as i64;
    let half = k >> 1;
    y * power_of_two(half) * power_of_two(k - half)
}

/// `ln(x) = k ln 2 + ln(1 + f)`, `1 + f` from `sqrt(1/2)` to `sqrt(2)`, with `ln(1 + f) = 2
/// artanh(f / (2 + f))`.
fn logarithm(x: f64) -> f64 {
    if x.is_nan() || x == f64::INFINITY {
        return x;
    }
    if x <= 0.0 {
        return if x == 0.0 { f64::NEG_INFINITY } else { f64::NAN };
    }
    let (x, up) = if x < f64::MIN_POSITIVE { (x * 18_014_398_509_481_984.0, 54) } else { (x, 0) }; // 2^54
    let bits = x.to_bits();
    // The exponent that leaves a mantissa from sqrt(1/2) to sqrt(2).
    let shifted = bits + (0x3ff0_0000_0000_0000 - 0x3fe6_a09e_0000_0000);
    let k = (shifted >> 52) as i64 - 1023;
    let m = f64::from_bits((shifted & 0x000f_ffff_ffff_ffff) + 0x3fe6_a09e_0000_0000);
    let f = m - 1.0;
    let s = f / (2.0 + f);
    let z = s * s;
    let w = z * z;
    let odd = z * (L[0] + w * (L[2] + w * (L[4] + w * L[6])));
    let even = w * (L[1] + w * (L[3] + w * L[5]));
    let (half, k) = (0.5 * f * f, (k - up) as f64);
    k * LN2[0] - ((half - (s * (half + (odd + even)) + k * LN2[1])) - f)
}
