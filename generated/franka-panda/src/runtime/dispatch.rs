//! One binary for every processor: work is compiled for several instruction sets, and the
//! processor's own picks one at run time. The bits are the same in all of them.
//!
//! Needs `std`, to ask the processor.

use core::sync::atomic::{AtomicU8, Ordering};

use super::Scalar;
use super::pack::Side;
use super::registers::Register;
#[cfg(target_arch = "x86_64")]
use super::registers::x86;

/// Numbers side by side, of a width that is known.
pub trait Numbers: Scalar {
    /// How many.
    const WIDTH: usize;
    /// The first numbers of a list; zeros where it ends.
    fn load(from: &[f64]) -> Self;
    /// To the first places of a list, as far as it goes.
    fn store(self, to: &mut [f64]);
}

impl<R: Register, const K: usize> Numbers for Side<R, K> {
    const WIDTH: usize = Self::WIDTH;
    #[inline(always)]
    fn load(from: &[f64]) -> Self {
        Self::load(from)
    }
    #[inline(always)]
    fn store(self, to: &mut [f64]) {
        Self::store(self, to);
    }
}

/// By itself.
impl Numbers for f64 {
    const WIDTH: usize = 1;
    #[inline(always)]
    fn load(from: &[f64]) -> Self {
        from.first().copied().unwrap_or(0.0)
    }
    #[inline(always)]
    fn store(self, to: &mut [f64]) {
        if let Some(to) = to.first_mut() {
            *to = self;
        }
    }
}

/// What an instruction set computes with.
pub trait Set {
    /// Numbers in one register.
    type One: Numbers;
    /// Eight numbers.
    type Eight: Numbers;
    /// Numbers of which an operation hides what it costs to choose the operation.
    type Many: Numbers;
}

/// Work that is compiled once for every instruction set. Its `run`, and all that it calls, has to
/// be `#[inline(always)]`: only what stands within it gets the instructions.
pub trait Work {
    /// What comes out.
    type Result;
    /// Does it.
    fn run<S: Set>(self) -> Self::Result;
}

/// An instruction set by its level, ascending.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Level {
    /// What the whole build may use: SSE2 of x86-64, NEON of aarch64, or what its flags say.
    Build,
    /// `x86-64-v3`: AVX2, registers of four.
    V3,
    /// `x86-64-v4`: AVX-512, registers of eight.
    V4,
}

/// What the build may use.
struct Build;

impl Set for Build {
    type One = Side<super::registers::Native, 1>;
    type Eight = super::Pack;
    type Many = Side<super::registers::Native, 4>;
}

#[cfg(target_arch = "x86_64")]
struct V3;

#[cfg(target_arch = "x86_64")]
impl Set for V3 {
    type One = Side<x86::Four, 1>;
    type Eight = Side<x86::Four, 2>;
    type Many = Side<x86::Four, 8>;
}

#[cfg(target_arch = "x86_64")]
struct V4;

#[cfg(target_arch = "x86_64")]
impl Set for V4 {
    type One = Side<x86::Eight, 1>;
    type Eight = Side<x86::Eight, 1>;
    type Many = Side<x86::Eight, 4>;
}

/// The highest level of this processor, once it has been asked: one more than its number.
static HIGHEST: AtomicU8 = AtomicU8::new(0);

impl Level {
    /// The highest one of this processor.
    #[must_use]
    #[inline]
    pub fn highest() -> Self {
        match HIGHEST.load(Ordering::Relaxed) {
            1 => Self::Build,
            2 => Self::V3,
            3 => Self::V4,
            _ => Self::asked(),
        }
    }

    /// Asks the processor.
    #[cold]
    fn asked() -> Self {
        let level = Self::of_processor();
        HIGHEST.store(level as u8 + 1, Ordering::Relaxed);
        level
    }

    #[cfg(target_arch = "x86_64")]
    fn of_processor() -> Self {
        use std::arch::is_x86_feature_detected as has;
        let four = has!("avx2") && has!("bmi1") && has!("bmi2") && has!("lzcnt");
        let eight = has!("avx512f") && has!("avx512bw") && has!("avx512dq") && has!("avx512vl");
        match (four, eight) {
            (true, true) => Self::V4,
            (true, false) => Self::V3,
            _ => Self::Build,
        }
    }

    #[cfg(not(target_arch = "x86_64"))]
    fn of_processor() -> Self {
        Self::Build
    }

    /// The highest one for scalar code: on processors of Intel a 512-bit operation in flight closes
    /// a port that scalar arithmetic needs, and with AVX-512 the compiler puts some in by itself.
    /// (On a Zen 4 this costs up to 8 %.)
    #[must_use]
    #[inline]
    pub fn of_scalars() -> Self {
        Self::highest().min(Self::V3)
    }

    /// Does the work with this level, or with the highest one of the processor, if that is lower.
    #[inline(always)]
    #[allow(unsafe_code)]
    pub fn run<W: Work>(self, work: W) -> W::Result {
        // SAFETY: the processor has said that it has these instructions.
        #[cfg(target_arch = "x86_64")]
        match self.min(Self::highest()) {
            Self::V4 => return unsafe { v4(work) },
            Self::V3 => return unsafe { v3(work) },
            Self::Build => {}
        }
        work.run::<Build>()
    }
}

/// Sines and cosines of scalars, in registers of a set.
#[inline(always)]
pub fn sines_and_cosines<S: Set, const N: usize>(angles: &[f64; N]) -> ([f64; N], [f64; N]) {
    let (mut sin, mut cos) = ([0.0; N], [0.0; N]);
    for start in (0..N).step_by(8) {
        let mut eight = [0.0; 8];
        for l in 0..8 {
            if start + l < N {
                eight[l] = angles[start + l];
            }
        }
        let ([s], [c]) = S::Eight::sin_cos_all(&[S::Eight::load(&eight)]);
        let mut both = [[0.0; 8]; 2];
        s.store(&mut both[0]);
        c.store(&mut both[1]);
        for l in 0..8 {
            if start + l < N {
                (sin[start + l], cos[start + l]) = (both[0][l], both[1][l]);
            }
        }
    }
    (sin, cos)
}

/// Eights of numbers.
#[inline(always)]
pub fn eights<S: Set, const N: usize>(from: &[[f64; 8]; N]) -> [S::Eight; N] {
    let mut all = [S::Eight::default(); N];
    for k in 0..N {
        all[k] = S::Eight::load(&from[k]);
    }
    all
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512bw,avx512dq,avx512vl,avx2,bmi1,bmi2,lzcnt")]
fn v4<W: Work>(work: W) -> W::Result {
    work.run::<V4>()
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,bmi1,bmi2,lzcnt")]
fn v3<W: Work>(work: W) -> W::Result {
    work.run::<V3>()
}
