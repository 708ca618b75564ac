//! Eight states side by side, in one or two registers where the target has them.
//!
//! LLVM takes an array of eight apart and does not put it together again in a long straight line of
//! code, so the registers are requested by name. (Measured: 150 ns a state against 17.) No fused
//! multiply-add: lane and scalar agree bit for bit.

use core::ops::{Add, Div, Mul, Neg, Sub};

use super::Scalar;
use super::sincos;

/// Eight numbers that are computed side by side.
#[derive(Clone, Copy, Debug)]
pub struct Pack(lanes::Lanes);

impl Pack {
    /// From an array, lane by lane.
    #[inline(always)]
    #[must_use]
    pub fn new(values: [f64; 8]) -> Self {
        Self(lanes::load(&values))
    }

    /// The lanes.
    #[inline(always)]
    #[must_use]
    pub fn to_array(self) -> [f64; 8] {
        lanes::store(self.0)
    }

    /// Is every lane's size at most `limit`? (Not so for NaN.)
    #[inline(always)]
    pub(super) fn within(self, limit: f64) -> bool {
        lanes::within(self.0, limit)
    }

    /// `self` where `x` is not zero, else `x`.
    #[inline(always)]
    pub(super) fn unless_zero(self, x: Self) -> Self {
        Self(lanes::unless_zero(self.0, x.0))
    }

    /// Sine and cosine turned by as many quarters as the last two bits of `turns` say.
    #[inline(always)]
    pub(super) fn quarter_turned(s: Self, c: Self, turns: Self) -> (Self, Self) {
        let (s, c) = lanes::quarter_turned(s.0, c.0, turns.0);
        (Self(s), Self(c))
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
        impl $trait for Pack {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(lanes::$method(self.0, other.0))
            }
        }
    };
}
operator!(Add, add);
operator!(Sub, sub);
operator!(Mul, mul);
operator!(Div, div);

impl Neg for Pack {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(lanes::neg(self.0))
    }
}

impl Default for Pack {
    #[inline(always)]
    fn default() -> Self {
        Self::constant(0.0)
    }
}

impl Scalar for Pack {
    #[inline(always)]
    fn constant(value: f64) -> Self {
        Self(lanes::splat(value))
    }
    #[inline(always)]
    fn sign(self) -> Self {
        Self::new(self.to_array().map(Scalar::sign))
    }
    #[inline]
    fn sin_cos_all<const N: usize>(angles: &[Self; N]) -> ([Self; N], [Self; N]) {
        let (mut sin, mut cos) = ([Self::default(); N], [Self::default(); N]);
        for i in 0..N {
            (sin[i], cos[i]) = sincos::eight(angles[i]);
        }
        (sin, cos)
    }
}

/// One register of eight.
#[cfg(all(target_arch = "x86_64", target_feature = "avx512f"))]
#[allow(unsafe_code)]
mod lanes {
    use core::arch::x86_64::*;

    pub(super) type Lanes = __m512d;

    // SAFETY, for all of this module: it is compiled only where AVX-512F is enabled for the whole
    // build. It touches no memory but whole arrays of eight through unaligned loads and stores.
    macro_rules! two {
        ($($name:ident = $intrinsic:ident;)*) => {
            $(#[inline(always)] pub(super) fn $name(a: Lanes, b: Lanes) -> Lanes { unsafe { $intrinsic(a, b) } })*
        };
    }
    two! { add = _mm512_add_pd; sub = _mm512_sub_pd; mul = _mm512_mul_pd; div = _mm512_div_pd; }

    #[inline(always)]
    pub(super) fn load(v: &[f64; 8]) -> Lanes {
        unsafe { _mm512_loadu_pd(v.as_ptr()) }
    }
    #[inline(always)]
    pub(super) fn store(v: Lanes) -> [f64; 8] {
        let mut out = [0.0; 8];
        unsafe { _mm512_storeu_pd(out.as_mut_ptr(), v) }
        out
    }
    #[inline(always)]
    pub(super) fn splat(x: f64) -> Lanes {
        unsafe { _mm512_set1_pd(x) }
    }
    #[inline(always)]
    pub(super) fn within(v: Lanes, limit: f64) -> bool {
        unsafe { _mm512_cmp_pd_mask::<_CMP_LE_OQ>(_mm512_abs_pd(v), _mm512_set1_pd(limit)) == 0xff }
    }
    #[inline(always)]
    pub(super) fn neg(v: Lanes) -> Lanes {
        unsafe {
            let sign = _mm512_set1_epi64(i64::MIN);
            _mm512_castsi512_pd(_mm512_xor_si512(_mm512_castpd_si512(v), sign))
        }
    }
    #[inline(always)]
    pub(super) fn unless_zero(v: Lanes, x: Lanes) -> Lanes {
        unsafe { _mm512_mask_blend_pd(_mm512_cmp_pd_mask::<_CMP_EQ_OQ>(x, _mm512_setzero_pd()), v, x) }
    }
    #[inline(always)]
    pub(super) fn quarter_turned(s: Lanes, c: Lanes, turns: Lanes) -> (Lanes, Lanes) {
        unsafe {
            let (turns, one, two) = (_mm512_castpd_si512(turns), _mm512_set1_epi64(1), _mm512_set1_epi64(2));
            let odd = _mm512_test_epi64_mask(turns, one);
            let (sin, cos) = (_mm512_mask_blend_pd(odd, s, c), _mm512_mask_blend_pd(odd, c, s));
            let sign = |t| _mm512_slli_epi64::<62>(_mm512_and_si512(t, two));
            let turned = |v, sign| _mm512_castsi512_pd(_mm512_xor_si512(_mm512_castpd_si512(v), sign));
            (turned(sin, sign(turns)), turned(cos, sign(_mm512_add_epi64(turns, one))))
        }
    }
}

/// Two registers of four.
#[cfg(all(target_arch = "x86_64", target_feature = "avx2", not(target_feature = "avx512f")))]
#[allow(unsafe_code)]
mod lanes {
    use core::arch::x86_64::*;

    #[derive(Clone, Copy, Debug)]
    pub(super) struct Lanes(__m256d, __m256d);

    // SAFETY, for all of this module: it is compiled only where AVX2 is enabled for the whole
    // build. It touches no memory but halves of arrays of eight through unaligned loads and stores.
    macro_rules! two {
        ($($name:ident = $intrinsic:ident;)*) => {
            $(#[inline(always)] pub(super) fn $name(a: Lanes, b: Lanes) -> Lanes {
                unsafe { Lanes($intrinsic(a.0, b.0), $intrinsic(a.1, b.1)) }
            })*
        };
    }
    two! { add = _mm256_add_pd; sub = _mm256_sub_pd; mul = _mm256_mul_pd; div = _mm256_div_pd; }

    #[inline(always)]
    pub(super) fn load(v: &[f64; 8]) -> Lanes {
        unsafe { Lanes(_mm256_loadu_pd(v.as_ptr()), _mm256_loadu_pd(v.as_ptr().add(4))) }
    }
    #[inline(always)]
    pub(super) fn store(v: Lanes) -> [f64; 8] {
        let mut out = [0.0; 8];
        unsafe {
            _mm256_storeu_pd(out.as_mut_ptr(), v.0);
            _mm256_storeu_pd(out.as_mut_ptr().add(4), v.1);
        }
        out
    }
    #[inline(always)]
    pub(super) fn splat(x: f64) -> Lanes {
        let v = unsafe { _mm256_set1_pd(x) };
        Lanes(v, v)
    }
    #[inline(always)]
    pub(super) fn within(v: Lanes, limit: f64) -> bool {
        let half = |v| unsafe {
            _mm256_cmp_pd::<_CMP_LE_OQ>(_mm256_andnot_pd(_mm256_set1_pd(-0.0), v), _mm256_set1_pd(limit))
        };
        unsafe { _mm256_movemask_pd(_mm256_and_pd(half(v.0), half(v.1))) == 0xf }
    }
    #[inline(always)]
    pub(super) fn neg(v: Lanes) -> Lanes {
        let flip = |v| unsafe { _mm256_xor_pd(v, _mm256_set1_pd(-0.0)) };
        Lanes(flip(v.0), flip(v.1))
    }
    #[inline(always)]
    pub(super) fn unless_zero(v: Lanes, x: Lanes) -> Lanes {
        let pick = |v, x| unsafe { _mm256_blendv_pd(v, x, _mm256_cmp_pd::<_CMP_EQ_OQ>(x, _mm256_setzero_pd())) };
        Lanes(pick(v.0, x.0), pick(v.1, x.1))
    }
    #[inline(always)]
    pub(super) fn quarter_turned(s: Lanes, c: Lanes, turns: Lanes) -> (Lanes, Lanes) {
        let half = |s: __m256d, c: __m256d, turns: __m256d| unsafe {
            let (turns, one, two) = (_mm256_castpd_si256(turns), _mm256_set1_epi64x(1), _mm256_set1_epi64x(2));
            let odd = _mm256_castsi256_pd(_mm256_slli_epi64::<63>(turns));
            let (sin, cos) = (_mm256_blendv_pd(s, c, odd), _mm256_blendv_pd(c, s, odd));
            let sign = |t| _mm256_castsi256_pd(_mm256_slli_epi64::<62>(_mm256_and_si256(t, two)));
            (_mm256_xor_pd(sin, sign(turns)), _mm256_xor_pd(cos, sign(_mm256_add_epi64(turns, one))))
        };
        let ((s0, c0), (s1, c1)) = (half(s.0, c.0, turns.0), half(s.1, c.1, turns.1));
        (Lanes(s0, s1), Lanes(c0, c1))
    }
}

/// Four registers of two: what every x86-64 has.
#[cfg(all(target_arch = "x86_64", not(target_feature = "avx2"), not(target_feature = "avx512f")))]
#[allow(unsafe_code)]
mod lanes {
    use core::arch::x86_64::*;

    #[derive(Clone, Copy, Debug)]
    pub(super) struct Lanes([__m128d; 4]);

    // SAFETY, for all of this module: SSE2 belongs to every x86-64, and no memory is touched but
    // pairs inside arrays of eight through unaligned loads and stores.
    macro_rules! two {
        ($($name:ident = $intrinsic:ident;)*) => {
            $(#[inline(always)] pub(super) fn $name(Lanes(a): Lanes, Lanes(b): Lanes) -> Lanes {
                unsafe {
                    Lanes([$intrinsic(a[0], b[0]), $intrinsic(a[1], b[1]), $intrinsic(a[2], b[2]), $intrinsic(a[3], b[3])])
                }
            })*
        };
    }
    two! { add = _mm_add_pd; sub = _mm_sub_pd; mul = _mm_mul_pd; div = _mm_div_pd; }

    #[inline(always)]
    pub(super) fn load(v: &[f64; 8]) -> Lanes {
        let at = |k: usize| unsafe { _mm_loadu_pd(v.as_ptr().add(k)) };
        Lanes([at(0), at(2), at(4), at(6)])
    }
    #[inline(always)]
    pub(super) fn store(v: Lanes) -> [f64; 8] {
        let mut out = [0.0; 8];
        for k in 0..4 {
            unsafe { _mm_storeu_pd(out.as_mut_ptr().add(2 * k), v.0[k]) }
        }
        out
    }
    #[inline(always)]
    pub(super) fn splat(x: f64) -> Lanes {
        Lanes([unsafe { _mm_set1_pd(x) }; 4])
    }
    #[inline(always)]
    pub(super) fn within(v: Lanes, limit: f64) -> bool {
        let pair = |v| unsafe { _mm_cmple_pd(_mm_andnot_pd(_mm_set1_pd(-0.0), v), _mm_set1_pd(limit)) };
        let [a, b, c, d] = v.0.map(pair);
        unsafe { _mm_movemask_pd(_mm_and_pd(_mm_and_pd(a, b), _mm_and_pd(c, d))) == 0x3 }
    }
    #[inline(always)]
    pub(super) fn neg(v: Lanes) -> Lanes {
        Lanes(v.0.map(|v| unsafe { _mm_xor_pd(v, _mm_set1_pd(-0.0)) }))
    }
    /// `a` where the mask's bits are set, else `b`.
    #[inline(always)]
    fn pick(mask: __m128d, a: __m128d, b: __m128d) -> __m128d {
        unsafe { _mm_or_pd(_mm_and_pd(mask, a), _mm_andnot_pd(mask, b)) }
    }
    #[inline(always)]
    pub(super) fn unless_zero(v: Lanes, x: Lanes) -> Lanes {
        let one = |k: usize| pick(unsafe { _mm_cmpeq_pd(x.0[k], _mm_setzero_pd()) }, x.0[k], v.0[k]);
        Lanes([one(0), one(1), one(2), one(3)])
    }
    #[inline(always)]
    pub(super) fn quarter_turned(s: Lanes, c: Lanes, turns: Lanes) -> (Lanes, Lanes) {
        let half = |k: usize| unsafe {
            let (turns, one, two) = (_mm_castpd_si128(turns.0[k]), _mm_set1_epi64x(1), _mm_set1_epi64x(2));
            let odd = _mm_castsi128_pd(_mm_sub_epi64(_mm_setzero_si128(), _mm_and_si128(turns, one)));
            let (sin, cos) = (pick(odd, c.0[k], s.0[k]), pick(odd, s.0[k], c.0[k]));
            let sign = |t| _mm_castsi128_pd(_mm_slli_epi64::<62>(_mm_and_si128(t, two)));
            (_mm_xor_pd(sin, sign(turns)), _mm_xor_pd(cos, sign(_mm_add_epi64(turns, one))))
        };
        let [a, b, c, d] = [half(0), half(1), half(2), half(3)];
        (Lanes([a.0, b.0, c.0, d.0]), Lanes([a.1, b.1, c.1, d.1]))
    }
}

/// Any other target: arrays.
#[cfg(not(target_arch = "x86_64"))]
mod lanes {
    pub(super) type Lanes = [f64; 8];

    macro_rules! two {
        ($($name:ident = $op:tt;)*) => {
            $(#[inline(always)] pub(super) fn $name(a: Lanes, b: Lanes) -> Lanes {
                core::array::from_fn(|l| a[l] $op b[l])
            })*
        };
    }
    two! { add = +; sub = -; mul = *; div = /; }

    #[inline(always)]
    pub(super) fn load(v: &[f64; 8]) -> Lanes {
        *v
    }
    #[inline(always)]
    pub(super) fn store(v: Lanes) -> [f64; 8] {
        v
    }
    #[inline(always)]
    pub(super) fn splat(x: f64) -> Lanes {
        [x; 8]
    }
    #[inline(always)]
    pub(super) fn within(v: Lanes, limit: f64) -> bool {
        v.iter().fold(true, |all, x| all & (x.abs() <= limit))
    }
    #[inline(always)]
    pub(super) fn neg(v: Lanes) -> Lanes {
        v.map(|x| -x)
    }
    #[inline(always)]
    pub(super) fn unless_zero(v: Lanes, x: Lanes) -> Lanes {
        core::array::from_fn(|l| if x[l] == 0.0 { x[l] } else { v[l] })
    }
    #[inline(always)]
    pub(super) fn quarter_turned(s: Lanes, c: Lanes, turns: Lanes) -> (Lanes, Lanes) {
        let (mut sin, mut cos) = (s, c);
        for l in 0..8 {
            let turns = turns[l].to_bits();
            let odd = (turns & 1).wrapping_neg(); // by bits, not by branches
            let (sb, cb) = (s[l].to_bits(), c[l].to_bits());
            sin[l] = f64::from_bits(((sb & !odd) | (cb & odd)) ^ ((turns & 2) << 62));
            cos[l] = f64::from_bits(((cb & !odd) | (sb & odd)) ^ (((turns + 1) & 2) << 62));
        }
        (sin, cos)
    }
}
