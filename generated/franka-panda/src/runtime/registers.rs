//! Registers full of numbers, by the instructions that they need: what packs of states are made of.
//!
//! LLVM takes an array of eight apart and does not put it together again in a long straight line of
//! code, so the registers are requested by name. (Measured: 150 ns a state against 17.) No fused
//! multiply-add: lane and scalar agree bit for bit.

/// One register.
pub trait Register: Copy + core::fmt::Debug {
    /// Numbers in it.
    const WIDTH: usize;
    /// The first numbers of a list; zeros of a list that is too short.
    fn load(from: &[f64]) -> Self;
    /// To the first places of a list; nothing to a list that is too short.
    fn store(self, to: &mut [f64]);
    /// The same number everywhere.
    fn splat(x: f64) -> Self;
    /// Sums.
    fn add(a: Self, b: Self) -> Self;
    /// Differences.
    fn sub(a: Self, b: Self) -> Self;
    /// Products.
    fn mul(a: Self, b: Self) -> Self;
    /// Quotients.
    fn div(a: Self, b: Self) -> Self;
    /// Other signs.
    fn neg(v: Self) -> Self;
    /// Is the size of every number at most `limit`? (Not so for NaN.)
    fn within(v: Self, limit: f64) -> bool;
    /// `v` where `x` is not zero, else `x`.
    fn unless_zero(v: Self, x: Self) -> Self;
    /// Sine and cosine turned by as many quarters as the last two bits of `turns` say.
    fn quarter_turned(s: Self, c: Self, turns: Self) -> (Self, Self);
}

/// The widest register that the whole build may use.
#[cfg(all(target_arch = "x86_64", target_feature = "avx512f"))]
pub type Native = x86::Eight;
/// The widest register that the whole build may use.
#[cfg(all(target_arch = "x86_64", target_feature = "avx2", not(target_feature = "avx512f")))]
pub type Native = x86::Four;
/// The widest register that the whole build may use.
#[cfg(all(target_arch = "x86_64", not(target_feature = "avx2"), not(target_feature = "avx512f")))]
pub type Native = x86::Two;
/// The widest register that the whole build may use.
#[cfg(all(target_arch = "aarch64", target_feature = "neon"))]
pub type Native = aarch64::Two;
/// The widest register that the whole build may use.
#[cfg(not(any(target_arch = "x86_64", all(target_arch = "aarch64", target_feature = "neon"))))]
pub type Native = portable::Two;

/// Registers beside scalar code: of at most four. On processors of Intel a 512-bit operation in
/// flight closes a port that scalar arithmetic needs.
#[cfg(all(target_arch = "x86_64", target_feature = "avx2"))]
pub type Beside = x86::Four;
/// Registers beside scalar code.
#[cfg(not(all(target_arch = "x86_64", target_feature = "avx2")))]
pub type Beside = Native;

/// One intrinsic per operation on two registers.
macro_rules! two {
    ($($name:ident = $intrinsic:ident;)*) => {
        $(
            #[inline(always)]
            fn $name(a: Self, b: Self) -> Self {
                Self(unsafe { $intrinsic(a.0, b.0) })
            }
        )*
    };
}

/// Of x86-64.
///
/// SAFETY, for all of this module: a register is made only where its instructions are, as `Native`
/// and `Beside` of a build that has them, or by `dispatch` after it has asked the processor. No
/// memory is touched but arrays of the register's length, through unaligned loads and stores.
#[cfg(target_arch = "x86_64")]
#[allow(unsafe_code, dead_code)] // a build needs one of them, `dispatch` all
pub(super) mod x86 {
    use core::arch::x86_64::*;

    use super::Register;

    /// AVX-512F.
    #[derive(Clone, Copy, Debug)]
    pub struct Eight(__m512d);

    impl Register for Eight {
        const WIDTH: usize = 8;
        two! { add = _mm512_add_pd; sub = _mm512_sub_pd; mul = _mm512_mul_pd; div = _mm512_div_pd; }

        #[inline(always)]
        fn load(from: &[f64]) -> Self {
            let from = from.first_chunk::<8>().unwrap_or(&[0.0; 8]);
            Self(unsafe { _mm512_loadu_pd(from.as_ptr()) })
        }
        #[inline(always)]
        fn store(self, to: &mut [f64]) {
            if let Some(to) = to.first_chunk_mut::<8>() {
                unsafe { _mm512_storeu_pd(to.as_mut_ptr(), self.0) }
            }
        }
        #[inline(always)]
        fn splat(x: f64) -> Self {
            Self(unsafe { _mm512_set1_pd(x) })
        }
        #[inline(always)]
        fn neg(v: Self) -> Self {
            unsafe {
                let sign = _mm512_set1_epi64(i64::MIN);
                Self(_mm512_castsi512_pd(_mm512_xor_si512(_mm512_castpd_si512(v.0), sign)))
            }
        }
        #[inline(always)]
        fn within(v: Self, limit: f64) -> bool {
            unsafe { _mm512_cmp_pd_mask::<_CMP_LE_OQ>(_mm512_abs_pd(v.0), _mm512_set1_pd(limit)) == 0xff }
        }
        #[inline(always)]
        fn unless_zero(v: Self, x: Self) -> Self {
            unsafe {
                let zero = _mm512_cmp_pd_mask::<_CMP_EQ_OQ>(x.0, _mm512_setzero_pd());
                Self(_mm512_mask_blend_pd(zero, v.0, x.0))
            }
        }
        #[inline(always)]
        fn quarter_turned(s: Self, c: Self, turns: Self) -> (Self, Self) {
            unsafe {
                let (turns, one, two) = (_mm512_castpd_si512(turns.0), _mm512_set1_epi64(1), _mm512_set1_epi64(2));
                let odd = _mm512_test_epi64_mask(turns, one);
                let (sin, cos) = (_mm512_mask_blend_pd(odd, s.0, c.0), _mm512_mask_blend_pd(odd, c.0, s.0));
                let sign = |t| _mm512_slli_epi64::<62>(_mm512_and_si512(t, two));
                let turned = |v, sign| Self(_mm512_castsi512_pd(_mm512_xor_si512(_mm512_castpd_si512(v), sign)));
                (turned(sin, sign(turns)), turned(cos, sign(_mm512_add_epi64(turns, one))))
            }
        }
    }

    /// AVX2.
    #[derive(Clone, Copy, Debug)]
    pub struct Four(__m256d);

    impl Register for Four {
        const WIDTH: usize = 4;
        two! { add = _mm256_add_pd; sub = _mm256_sub_pd; mul = _mm256_mul_pd; div = _mm256_div_pd; }

        #[inline(always)]
        fn load(from: &[f64]) -> Self {
            let from = from.first_chunk::<4>().unwrap_or(&[0.0; 4]);
            Self(unsafe { _mm256_loadu_pd(from.as_ptr()) })
        }
        #[inline(always)]
        fn store(self, to: &mut [f64]) {
            if let Some(to) = to.first_chunk_mut::<4>() {
                unsafe { _mm256_storeu_pd(to.as_mut_ptr(), self.0) }
            }
        }
        #[inline(always)]
        fn splat(x: f64) -> Self {
            Self(unsafe { _mm256_set1_pd(x) })
        }
        #[inline(always)]
        fn neg(v: Self) -> Self {
            Self(unsafe { _mm256_xor_pd(v.0, _mm256_set1_pd(-0.0)) })
        }
        #[inline(always)]
        fn within(v: Self, limit: f64) -> bool {
            unsafe {
                let size = _mm256_andnot_pd(_mm256_set1_pd(-0.0), v.0);
                _mm256_movemask_pd(_mm256_cmp_pd::<_CMP_LE_OQ>(size, _mm256_set1_pd(limit))) == 0xf
            }
        }
        #[inline(always)]
        fn unless_zero(v: Self, x: Self) -> Self {
            unsafe {
                let zero = _mm256_cmp_pd::<_CMP_EQ_OQ>(x.0, _mm256_setzero_pd());
                Self(_mm256_blendv_pd(v.0, x.0, zero))
            }
        }
        #[inline(always)]
        fn quarter_turned(s: Self, c: Self, turns: Self) -> (Self, Self) {
            unsafe {
                let (turns, one, two) = (_mm256_castpd_si256(turns.0), _mm256_set1_epi64x(1), _mm256_set1_epi64x(2));
                let odd = _mm256_castsi256_pd(_mm256_slli_epi64::<63>(turns));
                let (sin, cos) = (_mm256_blendv_pd(s.0, c.0, odd), _mm256_blendv_pd(c.0, s.0, odd));
                let sign = |t| _mm256_castsi256_pd(_mm256_slli_epi64::<62>(_mm256_and_si256(t, two)));
                let turned = |v, sign| Self(_mm256_xor_pd(v, sign));
                (turned(sin, sign(turns)), turned(cos, sign(_mm256_add_epi64(turns, one))))
            }
        }
    }

    /// SSE2, which belongs to every x86-64.
    #[derive(Clone, Copy, Debug)]
    pub struct Two(__m128d);

    impl Two {
        /// `a` where the mask's bits are set, else `b`.
        #[inline(always)]
        fn pick(mask: __m128d, a: __m128d, b: __m128d) -> __m128d {
            unsafe { _mm_or_pd(_mm_and_pd(mask, a), _mm_andnot_pd(mask, b)) }
        }
    }

    impl Register for Two {
        const WIDTH: usize = 2;
        two! { add = _mm_add_pd; sub = _mm_sub_pd; mul = _mm_mul_pd; div = _mm_div_pd; }

        #[inline(always)]
        fn load(from: &[f64]) -> Self {
            let from = from.first_chunk::<2>().unwrap_or(&[0.0; 2]);
            Self(unsafe { _mm_loadu_pd(from.as_ptr()) })
        }
        #[inline(always)]
        fn store(self, to: &mut [f64]) {
            if let Some(to) = to.first_chunk_mut::<2>() {
                unsafe { _mm_storeu_pd(to.as_mut_ptr(), self.0) }
            }
        }
        #[inline(always)]
        fn splat(x: f64) -> Self {
            Self(unsafe { _mm_set1_pd(x) })
        }
        #[inline(always)]
        fn neg(v: Self) -> Self {
            Self(unsafe { _mm_xor_pd(v.0, _mm_set1_pd(-0.0)) })
        }
        #[inline(always)]
        fn within(v: Self, limit: f64) -> bool {
            unsafe {
                let size = _mm_andnot_pd(_mm_set1_pd(-0.0), v.0);
                _mm_movemask_pd(_mm_cmple_pd(size, _mm_set1_pd(limit))) == 0x3
            }
        }
        #[inline(always)]
        fn unless_zero(v: Self, x: Self) -> Self {
            Self(Self::pick(unsafe { _mm_cmpeq_pd(x.0, _mm_setzero_pd()) }, x.0, v.0))
        }
        #[inline(always)]
        fn quarter_turned(s: Self, c: Self, turns: Self) -> (Self, Self) {
            unsafe {
                let (turns, one, two) = (_mm_castpd_si128(turns.0), _mm_set1_epi64x(1), _mm_set1_epi64x(2));
                let odd = _mm_castsi128_pd(_mm_sub_epi64(_mm_setzero_si128(), _mm_and_si128(turns, one)));
                let (sin, cos) = (Self::pick(odd, c.0, s.0), Self::pick(odd, s.0, c.0));
                let sign = |t| _mm_castsi128_pd(_mm_slli_epi64::<62>(_mm_and_si128(t, two)));
                let turned = |v, sign| Self(_mm_xor_pd(v, sign));
                (turned(sin, sign(turns)), turned(cos, sign(_mm_add_epi64(turns, one))))
            }
        }
    }
}

/// Of aarch64.
///
/// SAFETY, for all of this module: it is compiled only where NEON is enabled for the whole build.
/// No memory is touched but arrays of two.
#[cfg(all(target_arch = "aarch64", target_feature = "neon"))]
#[allow(unsafe_code)]
pub(super) mod aarch64 {
    use core::arch::aarch64::*;

    use super::Register;

    /// NEON.
    #[derive(Clone, Copy, Debug)]
    pub struct Two(float64x2_t);

    impl Register for Two {
        const WIDTH: usize = 2;
        two! { add = vaddq_f64; sub = vsubq_f64; mul = vmulq_f64; div = vdivq_f64; }

        #[inline(always)]
        fn load(from: &[f64]) -> Self {
            let from = from.first_chunk::<2>().unwrap_or(&[0.0; 2]);
            Self(unsafe { vld1q_f64(from.as_ptr()) })
        }
        #[inline(always)]
        fn store(self, to: &mut [f64]) {
            if let Some(to) = to.first_chunk_mut::<2>() {
                unsafe { vst1q_f64(to.as_mut_ptr(), self.0) }
            }
        }
        #[inline(always)]
        fn splat(x: f64) -> Self {
            Self(unsafe { vdupq_n_f64(x) })
        }
        #[inline(always)]
        fn neg(v: Self) -> Self {
            Self(unsafe { vnegq_f64(v.0) })
        }
        #[inline(always)]
        fn within(v: Self, limit: f64) -> bool {
            unsafe {
                let inside = vcleq_f64(vabsq_f64(v.0), vdupq_n_f64(limit));
                vgetq_lane_u64::<0>(inside) & vgetq_lane_u64::<1>(inside) == u64::MAX
            }
        }
        #[inline(always)]
        fn unless_zero(v: Self, x: Self) -> Self {
            Self(unsafe { vbslq_f64(vceqzq_f64(x.0), x.0, v.0) })
        }
        #[inline(always)]
        fn quarter_turned(s: Self, c: Self, turns: Self) -> (Self, Self) {
            unsafe {
                let (turns, one, two) = (vreinterpretq_u64_f64(turns.0), vdupq_n_u64(1), vdupq_n_u64(2));
                let odd = vtstq_u64(turns, one);
                let (sin, cos) = (vbslq_f64(odd, c.0, s.0), vbslq_f64(odd, s.0, c.0));
                let sign = |t| vshlq_n_u64::<62>(vandq_u64(t, two));
                let turned = |v, sign| Self(vreinterpretq_f64_u64(veorq_u64(vreinterpretq_u64_f64(v), sign)));
                (turned(sin, sign(turns)), turned(cos, sign(vaddq_u64(turns, one))))
            }
        }
    }
}

/// Of any other target: pairs.
#[cfg(not(any(target_arch = "x86_64", all(target_arch = "aarch64", target_feature = "neon"))))]
pub(super) mod portable {
    use super::Register;

    /// Two numbers.
    #[derive(Clone, Copy, Debug)]
    pub struct Two([f64; 2]);

    macro_rules! each {
        ($($name:ident = $op:tt;)*) => {
            $(
                #[inline(always)]
                fn $name(a: Self, b: Self) -> Self {
                    Self([a.0[0] $op b.0[0], a.0[1] $op b.0[1]])
                }
            )*
        };
    }

    impl Register for Two {
        const WIDTH: usize = 2;
        each! { add = +; sub = -; mul = *; div = /; }

        #[inline(always)]
        fn load(from: &[f64]) -> Self {
            Self(*from.first_chunk::<2>().unwrap_or(&[0.0; 2]))
        }
        #[inline(always)]
        fn store(self, to: &mut [f64]) {
            if let Some(to) = to.first_chunk_mut::<2>() {
                *to = self.0;
            }
        }
        #[inline(always)]
        fn splat(x: f64) -> Self {
            Self([x; 2])
        }
        #[inline(always)]
        fn neg(v: Self) -> Self {
            Self(v.0.map(|x| -x))
        }
        #[inline(always)]
        fn within(v: Self, limit: f64) -> bool {
            v.0.iter().fold(true, |all, x| all & (x.abs() <= limit))
        }
        #[inline(always)]
        fn unless_zero(v: Self, x: Self) -> Self {
            Self(core::array::from_fn(|l| if x.0[l] == 0.0 { x.0[l] } else { v.0[l] }))
        }
        #[inline(always)]
        fn quarter_turned(s: Self, c: Self, turns: Self) -> (Self, Self) {
            let (mut sin, mut cos) = (s, c);
            for l in 0..2 {
                let turns = turns.0[l].to_bits();
                let odd = (turns & 1).wrapping_neg(); // by bits, not by branches
                let (sb, cb) = (s.0[l].to_bits(), c.0[l].to_bits());
                sin.0[l] = f64::from_bits(((sb & !odd) | (cb & odd)) ^ ((turns & 2) << 62));
                cos.0[l] = f64::from_bits(((cb & !odd) | (sb & odd)) ^ ((turns.wrapping_add(1) & 2) << 62));
            }
            (sin, cos)
        }
    }
}
