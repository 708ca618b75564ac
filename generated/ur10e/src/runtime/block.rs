//! As many numbers side by side as one register of the target holds. A long chain of vectors stays
//! in registers in blocks, where a [`super::Pack`] of eight would go through memory.

use core::ops::{Add, Div, Mul, Sub};

/// One register full of numbers.
#[derive(Clone, Copy, Debug)]
pub struct Block(lanes::Lanes);

impl Block {
    /// How many.
    pub const WIDTH: usize = lanes::WIDTH;

    /// Eight numbers, block by block.
    pub const COUNT: usize = 8 / Self::WIDTH;

    /// The same number everywhere.
    #[inline(always)]
    #[must_use]
    pub fn constant(value: f64) -> Self {
        Self(lanes::splat(value))
    }

    /// Number by number.
    #[inline(always)]
    #[must_use]
    pub fn from_fn(lane: impl Fn(usize) -> f64) -> Self {
        Self(lanes::from_fn(lane))
    }

    /// Numbers of a list by their places (of which the last four bits count), those from `first`
    /// on.
    #[inline(always)]
    #[must_use]
    pub fn pick(numbers: &[f64; 16], places: &[u8; 16], first: usize) -> Self {
        Self(lanes::pick(numbers, places, first))
    }

    /// The smaller of each two numbers; not for NaN.
    #[inline(always)]
    #[must_use]
    pub fn min(self, other: Self) -> Self {
        Self(lanes::min(self.0, other.0))
    }

    /// The larger one.
    #[inline(always)]
    #[must_use]
    pub fn max(self, other: Self) -> Self {
        Self(lanes::max(self.0, other.0))
    }

    /// Sizes.
    #[inline(always)]
    #[must_use]
    pub fn abs(self) -> Self {
        Self(lanes::abs(self.0))
    }

    /// `self` where `a < b`, else zero.
    #[inline(always)]
    #[must_use]
    pub fn only_where_less(self, a: Self, b: Self) -> Self {
        Self(lanes::only_where_less(self.0, a.0, b.0))
    }

    /// `-self` where `a < b`, else `self`.
    #[inline(always)]
    #[must_use]
    pub fn negative_where_less(self, a: Self, b: Self) -> Self {
        Self(lanes::negative_where_less(self.0, a.0, b.0))
    }

    /// The first ones of a list.
    #[inline(always)]
    pub fn put(self, to: &mut [f64]) {
        for (to, x) in to.iter_mut().zip(lanes::to_array(self.0)) {
            *to = x;
        }
    }

    /// Puts them down as the block in place `k` of eight numbers.
    #[inline(always)]
    pub fn store(self, k: usize, to: &mut [f64; 8]) {
        for (l, x) in lanes::to_array(self.0).iter().enumerate() {
            to[(k * Self::WIDTH + l) & 7] = *x;
        }
    }
}

macro_rules! operator {
    ($trait:ident, $method:ident) => {
        impl $trait for Block {
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

#[cfg(all(target_arch = "x86_64", target_feature = "avx512f"))]
#[allow(unsafe_code)]
mod lanes {
    use core::arch::x86_64::*;

    pub(super) type Lanes = __m512d;
    pub(super) const WIDTH: usize = 8;

    // SAFETY, for all of this module: it is compiled only where AVX-512F is enabled for the whole
    // build. It touches no memory but a whole array of eight or both halves of one of sixteen.
    macro_rules! two {
        ($($name:ident = $intrinsic:ident;)*) => {
            $(#[inline(always)] pub(super) fn $name(a: Lanes, b: Lanes) -> Lanes { unsafe { $intrinsic(a, b) } })*
        };
    }
    two! {
        add = _mm512_add_pd; sub = _mm512_sub_pd; mul = _mm512_mul_pd; div = _mm512_div_pd;
        min = _mm512_min_pd; max = _mm512_max_pd;
    }

    #[inline(always)]
    pub(super) fn abs(v: Lanes) -> Lanes {
        unsafe { _mm512_abs_pd(v) }
    }
    #[inline(always)]
    pub(super) fn only_where_less(v: Lanes, a: Lanes, b: Lanes) -> Lanes {
        unsafe { _mm512_maskz_mov_pd(_mm512_cmp_pd_mask::<_CMP_LT_OQ>(a, b), v) }
    }
    #[inline(always)]
    pub(super) fn negative_where_less(v: Lanes, a: Lanes, b: Lanes) -> Lanes {
        unsafe {
            let (less, bits) = (_mm512_cmp_pd_mask::<_CMP_LT_OQ>(a, b), _mm512_castpd_si512(v));
            _mm512_castsi512_pd(_mm512_mask_xor_epi64(bits, less, bits, _mm512_set1_epi64(i64::MIN)))
        }
    }

    #[inline(always)]
    pub(super) fn splat(x: f64) -> Lanes {
        unsafe { _mm512_set1_pd(x) }
    }
    #[inline(always)]
    pub(super) fn from_fn(f: impl Fn(usize) -> f64) -> Lanes {
        unsafe { _mm512_setr_pd(f(0), f(1), f(2), f(3), f(4), f(5), f(6), f(7)) }
    }
    #[inline(always)]
    pub(super) fn pick(numbers: &[f64; 16], places: &[u8; 16], first: usize) -> Lanes {
        let eight = (u128::from_le_bytes(*places) >> (8 * (first & 8))) as i64;
        unsafe {
            let (low, high) = (_mm512_loadu_pd(numbers.as_ptr()), _mm512_loadu_pd(numbers.as_ptr().add(8)));
            _mm512_permutex2var_pd(low, _mm512_cvtepu8_epi64(_mm_cvtsi64_si128(eight)), high)
        }
    }
    #[inline(always)]
    pub(super) fn to_array(v: Lanes) -> [f64; WIDTH] {
        let mut out = [0.0; WIDTH];
        unsafe { _mm512_storeu_pd(out.as_mut_ptr(), v) }
        out
    }
}

#[cfg(all(target_arch = "x86_64", target_feature = "avx2", not(target_feature = "avx512f")))]
#[allow(unsafe_code)]
mod lanes {
    use core::arch::x86_64::*;

    pub(super) type Lanes = __m256d;
    pub(super) const WIDTH: usize = 4;

    // SAFETY, for all of this module: it is compiled only where AVX2 is enabled for the whole
    // build, and touches no memory but a whole array of four.
    macro_rules! two {
        ($($name:ident = $intrinsic:ident;)*) => {
            $(#[inline(always)] pub(super) fn $name(a: Lanes, b: Lanes) -> Lanes { unsafe { $intrinsic(a, b) } })*
        };
    }
    two! {
        add = _mm256_add_pd; sub = _mm256_sub_pd; mul = _mm256_mul_pd; div = _mm256_div_pd;
        min = _mm256_min_pd; max = _mm256_max_pd;
    }

    #[inline(always)]
    pub(super) fn abs(v: Lanes) -> Lanes {
        unsafe { _mm256_andnot_pd(_mm256_set1_pd(-0.0), v) }
    }
    #[inline(always)]
    pub(super) fn only_where_less(v: Lanes, a: Lanes, b: Lanes) -> Lanes {
        unsafe { _mm256_and_pd(_mm256_cmp_pd::<_CMP_LT_OQ>(a, b), v) }
    }
    #[inline(always)]
    pub(super) fn negative_where_less(v: Lanes, a: Lanes, b: Lanes) -> Lanes {
        unsafe { _mm256_xor_pd(v, _mm256_and_pd(_mm256_cmp_pd::<_CMP_LT_OQ>(a, b), _mm256_set1_pd(-0.0))) }
    }

    #[inline(always)]
    pub(super) fn splat(x: f64) -> Lanes {
        unsafe { _mm256_set1_pd(x) }
    }
    #[inline(always)]
    pub(super) fn from_fn(f: impl Fn(usize) -> f64) -> Lanes {
        unsafe { _mm256_setr_pd(f(0), f(1), f(2), f(3)) }
    }
    #[inline(always)]
    pub(super) fn pick(numbers: &[f64; 16], places: &[u8; 16], first: usize) -> Lanes {
        from_fn(|l| numbers[usize::from(places[(first + l) & 15] & 15)])
    }
    #[inline(always)]
    pub(super) fn to_array(v: Lanes) -> [f64; WIDTH] {
        let mut out = [0.0; WIDTH];
        unsafe { _mm256_storeu_pd(out.as_mut_ptr(), v) }
        out
    }
}

#[cfg(all(target_arch = "x86_64", not(target_feature = "avx2"), not(target_feature = "avx512f")))]
#[allow(unsafe_code)]
mod lanes {
    use core::arch::x86_64::*;

    pub(super) type Lanes = __m128d;
    pub(super) const WIDTH: usize = 2;

    // SAFETY, for all of this module: SSE2 belongs to every x86-64, and no memory is touched but a
    // whole array of two.
    macro_rules! two {
        ($($name:ident = $intrinsic:ident;)*) => {
            $(#[inline(always)] pub(super) fn $name(a: Lanes, b: Lanes) -> Lanes { unsafe { $intrinsic(a, b) } })*
        };
    }
    two! { add = _mm_add_pd; sub = _mm_sub_pd; mul = _mm_mul_pd; div = _mm_div_pd; min = _mm_min_pd; max = _mm_max_pd; }

    #[inline(always)]
    pub(super) fn abs(v: Lanes) -> Lanes {
        unsafe { _mm_andnot_pd(_mm_set1_pd(-0.0), v) }
    }
    #[inline(always)]
    pub(super) fn only_where_less(v: Lanes, a: Lanes, b: Lanes) -> Lanes {
        unsafe { _mm_and_pd(_mm_cmplt_pd(a, b), v) }
    }
    #[inline(always)]
    pub(super) fn negative_where_less(v: Lanes, a: Lanes, b: Lanes) -> Lanes {
        unsafe { _mm_xor_pd(v, _mm_and_pd(_mm_cmplt_pd(a, b), _mm_set1_pd(-0.0))) }
    }

    #[inline(always)]
    pub(super) fn splat(x: f64) -> Lanes {
        unsafe { _mm_set1_pd(x) }
    }
    #[inline(always)]
    pub(super) fn from_fn(f: impl Fn(usize) -> f64) -> Lanes {
        unsafe { _mm_setr_pd(f(0), f(1)) }
    }
    #[inline(always)]
    pub(super) fn pick(numbers: &[f64; 16], places: &[u8; 16], first: usize) -> Lanes {
        from_fn(|l| numbers[usize::from(places[(first + l) & 15] & 15)])
    }
    #[inline(always)]
    pub(super) fn to_array(v: Lanes) -> [f64; WIDTH] {
        let mut out = [0.0; WIDTH];
        unsafe { _mm_storeu_pd(out.as_mut_ptr(), v) }
        out
    }
}

/// Any other target: pairs.
#[cfg(not(target_arch = "x86_64"))]
mod lanes {
    pub(super) type Lanes = [f64; 2];
    pub(super) const WIDTH: usize = 2;

    macro_rules! two {
        ($($name:ident = $op:tt;)*) => {
            $(#[inline(always)] pub(super) fn $name(a: Lanes, b: Lanes) -> Lanes { [a[0] $op b[0], a[1] $op b[1]] })*
        };
    }
    two! { add = +; sub = -; mul = *; div = /; }

    #[inline(always)]
    fn each(f: impl Fn(usize) -> f64) -> Lanes {
        [f(0), f(1)]
    }
    #[inline(always)]
    pub(super) fn min(a: Lanes, b: Lanes) -> Lanes {
        each(|l| if a[l] < b[l] { a[l] } else { b[l] })
    }
    #[inline(always)]
    pub(super) fn max(a: Lanes, b: Lanes) -> Lanes {
        each(|l| if a[l] > b[l] { a[l] } else { b[l] })
    }
    #[inline(always)]
    pub(super) fn abs(v: Lanes) -> Lanes {
        each(|l| v[l].abs())
    }
    #[inline(always)]
    pub(super) fn only_where_less(v: Lanes, a: Lanes, b: Lanes) -> Lanes {
        each(|l| if a[l] < b[l] { v[l] } else { 0.0 })
    }
    #[inline(always)]
    pub(super) fn negative_where_less(v: Lanes, a: Lanes, b: Lanes) -> Lanes {
        each(|l| if a[l] < b[l] { -v[l] } else { v[l] })
    }

    #[inline(always)]
    pub(super) fn splat(x: f64) -> Lanes {
        [x; 2]
    }
    #[inline(always)]
    pub(super) fn from_fn(f: impl Fn(usize) -> f64) -> Lanes {
        [f(0), f(1)]
    }
    #[inline(always)]
    pub(super) fn pick(numbers: &[f64; 16], places: &[u8; 16], first: usize) -> Lanes {
        from_fn(|l| numbers[usize::from(places[(first + l) & 15] & 15)])
    }
    #[inline(always)]
    pub(super) fn to_array(v: Lanes) -> [f64; WIDTH] {
        v
    }
}
