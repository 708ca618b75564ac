//! Sine and cosine of many angles together: one polynomial for all, no branch but for angles beyond
//! half a million.
//!
//! Reduction by quarter turns with pi/2 in three pieces and a carried tail (Cody and Waite). The
//! first two pieces have 33 bits, so their products with a quarter-turn count below 2^20 are exact.
//! Then the polynomials of fdlibm's `k_sin.c` and `k_cos.c`. Beyond that range: Payne and Hanek,
//! with integers. Only additions and multiplications, each rounded: the same bits on every machine,
//! for one angle or for eight. Within 1 ulp: 0.63 at most against 40-digit values
//! (`tests/sincos.rs` of dh-codegen).

use super::pack::{Few, Side};
use super::registers::Register;
use super::{Pack, Scalar};

/// Up to here the pieces of pi/2 are exact enough.
const LIMIT: f64 = 500_000.0;
/// Adding and subtracting it rounds to the nearest whole number, which stands in the last bits
/// meanwhile.
const ROUND: f64 = 6_755_399_441_055_744.0;
const PIO2_1: f64 = 1.570_796_326_734_125_6;
const PIO2_2: f64 = 6.077_100_506_303_966e-11;
const PIO2_3: f64 = 2.022_266_248_795_950_7e-21;
const S: [f64; 6] = [
    -1.666_666_666_666_663_2e-1,
    8.333_333_333_322_49e-3,
    -1.984_126_982_985_795e-4,
    2.755_731_370_707_006_8e-6,
    -2.505_076_025_340_686_3e-8,
    1.589_690_995_211_55e-10,
];
const C: [f64; 6] = [
    4.166_666_666_666_66e-2,
    -1.388_888_888_887_411e-3,
    2.480_158_728_947_673e-5,
    -2.755_731_435_139_066_3e-7,
    2.087_572_321_298_175e-9,
    -1.135_964_755_778_819_5e-11,
];

/// Sines and cosines of angles side by side, rad.
#[inline(always)]
pub(super) fn together<R: Register, const K: usize>(x: Side<R, K>) -> (Side<R, K>, Side<R, K>) {
    // The way out shares no memory with the usual way, whose results stay in registers.
    if x.within(LIMIT) {
        near(x)
    } else {
        let (mut s, mut c) = (x, x);
        for k in 0..K {
            let mut list = [0.0; 8];
            x.only(k).store(&mut list);
            let (sines, cosines) = corrected(list);
            s = s.with(k, &sines);
            c = c.with(k, &cosines);
        }
        (s, c)
    }
}

/// Sines and cosines of a list of at most eight angles, in registers that scalar code bears.
#[inline(always)]
pub(super) fn eight(x: &[f64; 8]) -> ([f64; 8], [f64; 8]) {
    let (s, c) = together(Few::load(x));
    let (mut sin, mut cos) = ([0.0; 8], [0.0; 8]);
    s.store(&mut sin);
    c.store(&mut cos);
    (sin, cos)
}

/// For angles up to [`LIMIT`].
#[inline(always)]
fn near<R: Register, const K: usize>(x: Side<R, K>) -> (Side<R, K>, Side<R, K>) {
    let n = Side::constant;
    let shifted = x * n(core::f64::consts::FRAC_2_PI) + n(ROUND);
    let k = shifted - n(ROUND);
    let a = x - k * n(PIO2_1); // exact
    let b = k * n(PIO2_2); // exact
    let (r, error) = two_sum(a, -b);
    // The head does not wait for the first error, which goes to the tail alone: that is read last.
    let (head, rest) = two_sum(r, -(k * n(PIO2_3)));
    let (s, c) = kernels(head, error + rest);
    let (s, c) = Side::quarter_turned(s, c, shifted);
    (s.unless_zero(x), c)
}

/// The same where some lanes are too far out.
#[cold]
#[inline(never)]
fn corrected(x: [f64; 8]) -> ([f64; 8], [f64; 8]) {
    let (s, c) = near(Pack::new(x));
    let (mut s, mut c) = (s.to_array(), c.to_array());
    for l in 0..8 {
        if x[l].is_nan() || x[l].abs() > LIMIT {
            (s[l], c[l]) = beyond(x[l]);
        }
    }
    (s, c)
}

/// `a + b` and what rounding left out (Knuth).
#[inline(always)]
fn two_sum<R: Register, const K: usize>(a: Side<R, K>, b: Side<R, K>) -> (Side<R, K>, Side<R, K>) {
    let sum = a + b;
    let bb = sum - a;
    (sum, (a - (sum - bb)) + (b - bb))
}

/// Sine and cosine of `x + y`, `|x| <= pi/4`, `y` its tail.
#[inline(always)]
fn kernels<R: Register, const K: usize>(x: Side<R, K>, y: Side<R, K>) -> (Side<R, K>, Side<R, K>) {
    let n = Side::constant;
    let (half, one) = (n(0.5), n(1.0));
    let z = x * x;
    let zz = z * z;
    let v = z * x;
    let r = (n(S[1]) + z * (n(S[2]) + z * n(S[3]))) + (z * zz) * (n(S[4]) + z * n(S[5]));
    let sin = x - ((z * (half * y - v * r) - y) - v * n(S[0]));
    let r = z * (n(C[0]) + z * (n(C[1]) + z * n(C[2]))) + (zz * zz) * (n(C[3]) + z * (n(C[4]) + z * n(C[5])));
    let h = half * z;
    let w = one - h;
    let cos = w + (((one - w) - h) + (z * r - x * y));
    (sin, cos)
}

/// 2/pi, 1344 bits after the point.
const TWO_OVER_PI: [u64; 21] = [
    0xa2f9836e4e441529,
    0xfc2757d1f534ddc0,
    0xdb6295993c439041,
    0xfe5163abdebbc561,
    0xb7246e3a424dd2e0,
    0x06492eea09d1921c,
    0xfe1deb1cb129a73e,
    0xe88235f52ebb4484,
    0xe99c7026b45f7e41,
    0x3991d639835339f4,
    0x9c845f8bbdf9283b,
    0x1ff897ffde05980f,
    0xef2f118b5a0a6d1f,
    0x6d367ecf27cb09b7,
    0x4f463f669e5fea2d,
    0x7527bac7ebe5f17b,
    0x3d0739f78a5292ea,
    0x6bfb5fb11f8d5d08,
    0x56033046fc7b6bab,
    0xf0cfbc209af4361d,
    0xa9e391615ee61b08,
];

/// Any angle: `x = m 2^e`, and only those bits of `m 2/pi` that do not make whole turns (Payne and
/// Hanek).
#[cold]
#[inline(never)]
fn beyond(x: f64) -> (f64, f64) {
    if !x.is_finite() {
        return (f64::NAN, f64::NAN);
    }
    let bits = x.to_bits();
    let exponent = ((bits >> 52) & 0x7ff) as i32 - 1075;
    let mantissa = (bits & ((1 << 52) - 1)) | (1 << 52);
    // Bit i of 2/pi has weight 2^-i; from `first` on it matters.
    let first = if exponent > 2 { exponent - 1 } else { 1 };
    let window: [u64; 4] = core::array::from_fn(|w| {
        let at = first as usize - 1 + 64 * w;
        let (word, shift) = (at / 64, at % 64);
        // `get` and not an index: no way into a panic, whatever the compiler can prove.
        let at = |word: usize| TWO_OVER_PI.get(word).copied().unwrap_or(0);
        let high = at(word) << shift;
        if shift == 0 { high } else { high | (at(word + 1) >> (64 - shift)) }
    });
    // mantissa * window, most significant word first.
    let mut product = [0u64; 5];
    let mut carry = 0u128;
    for w in (0..4).rev() {
        let p = u128::from(mantissa) * u128::from(window[w]) + carry;
        product[w + 1] = p as u64;
        carry = p >> 64;
    }
    product[0] = carry as u64;
    // The point stands `256 - exponent + first - 1` bits from the right: bring it to bit 256 or so,
    // then cut.
    let fraction_bits = (256 - exponent + first - 1) as u32; // 254 to 290
    // 128 bits from bit `i` up; bit 0 is the product's last.
    let from = |i: u32| {
        let word = |w: u32| u128::from(product.iter().rev().nth(w as usize).copied().unwrap_or(0));
        let (w, shift) = (i / 64, i % 64);
        let (two, next) = (word(w) | (word(w + 1) << 64), word(w + 2));
        if shift == 0 { two } else { (two >> shift) | (next << (128 - shift)) }
    };
    let mut turns = from(fraction_bits) as u64 & 3;
    let mut fraction = from(fraction_bits - 128);
    let negative = fraction >> 127 == 1;
    if negative {
        turns += 1;
        fraction = fraction.wrapping_neg();
    }
    // To a head and a tail, times pi/2.
    let zeros = fraction.leading_zeros().min(100);
    let normal = fraction << zeros;
    let scale = f64::from_bits(u64::from(1023 - 128 - zeros) << 52);
    let high = ((normal >> 75) as f64) * 37_778_931_862_957_161_709_568.0; // 2^75
    let low = (normal & ((1u128 << 75) - 1)) as f64;
    let (head, tail) = times_half_pi(high * scale, low * scale);
    let sign = if negative { -1.0 } else { 1.0 };
    let (s, c) = kernels(Pack::constant(sign * head), Pack::constant(sign * tail));
    let (s, c) = Pack::quarter_turned(s, c, Pack::constant(f64::from_bits(turns)));
    let (s, c) = (s.to_array()[0], c.to_array()[0]);
    if x < 0.0 { (-s, c) } else { (s, c) }
}

/// `(a + b) pi/2` as head and tail, with the product's rounding error by splitting (Dekker).
fn times_half_pi(a: f64, b: f64) -> (f64, f64) {
    const HIGH: f64 = core::f64::consts::FRAC_PI_2;
    const LOW: f64 = 6.123_233_995_736_766e-17;
    let split = |v: f64| {
        let c = 134_217_729.0 * v;
        let high = c - (c - v);
        (high, v - high)
    };
    let product = a * HIGH;
    let ((ah, al), (ph, pl)) = (split(a), split(HIGH));
    let error = ((ah * ph - product) + ah * pl + al * ph) + al * pl;
    let tail = error + (a * LOW + b * HIGH);
    let head = product + tail;
    (head, (product - head) + tail)
}
