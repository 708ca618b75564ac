//! Roots of a trigonometric polynomial of degree eight or less that is known at equal distances.
//!
//! With `z = e^(i q)` it is a polynomial of twice the degree whose real roots lie on the unit circle, where
//! its coefficients are as good as its samples. All roots are found together (Aberth and Ehrlich).

use super::super::runtime::Scalar;
use super::real::root;
use super::vector::Turn;

/// Samples: three more than a polynomial of degree eight has coefficients. The others tell the
/// noise.
pub(super) const SAMPLES: usize = 20;
/// Its degree at most.
pub(super) const DEGREE: usize = 8;
/// Its complex roots.
pub(super) const ROOTS: usize = 2 * DEGREE;
/// Iterations at most; eight are usual.
const ITERATIONS: usize = 40;

/// Roots that may be off by more, rad, are refined with the matrix.
const POOR: f64 = 1e-9;
/// Sweeps of that at most.
const SWEEPS: usize = 12;

#[derive(Debug, Clone, Copy)]
pub(super) struct Complex {
    pub re: f64,
    pub im: f64,
}

impl Complex {
    pub const ZERO: Self = Self { re: 0.0, im: 0.0 };
    pub const ONE: Self = Self { re: 1.0, im: 0.0 };

    #[inline(always)]
    pub fn plus(self, o: Self) -> Self {
        Self { re: self.re + o.re, im: self.im + o.im }
    }
    #[inline(always)]
    pub fn minus(self, o: Self) -> Self {
        Self { re: self.re - o.re, im: self.im - o.im }
    }
    #[inline(always)]
    pub fn by(self, o: Self) -> Self {
        Self { re: self.re * o.re - self.im * o.im, im: self.re * o.im + self.im * o.re }
    }
    #[inline(always)]
    pub fn times(self, k: f64) -> Self {
        Self { re: k * self.re, im: k * self.im }
    }
    #[inline(always)]
    pub fn square(self) -> f64 {
        self.re * self.re + self.im * self.im
    }
    /// `1 / self`; something large at zero.
    #[inline(always)]
    pub fn reciprocal(self) -> Self {
        let k = 1.0 / (self.square() + 1e-290);
        Self { re: k * self.re, im: -k * self.im }
    }
    /// Length.
    pub fn size(self) -> f64 {
        root(self.square())
    }
}

/// Angles of the samples.
#[inline]
pub(super) fn angles() -> [Turn; SAMPLES] {
    let mut q = [0.0; SAMPLES];
    for (k, q) in q.iter_mut().enumerate() {
        *q = core::f64::consts::TAU * k as f64 / SAMPLES as f64;
    }
    let (s, c) = f64::sin_cos_all(&q);
    let mut out = [Turn::NONE; SAMPLES];
    for k in 0..SAMPLES {
        out[k] = Turn { c: c[k], s: s[k] };
    }
    out
}

/// Roots, and what is known of their errors.
pub(super) struct Roots {
    /// All of them, `e^(i q)`; those that are real have length one.
    pub z: [Complex; ROOTS],
    /// By root: how far it may be off, rad.
    pub error: [f64; ROOTS],
    /// How many there are.
    pub len: usize,
    /// What the samples have beyond the degree, in parts of the largest coefficient.
    pub noise: f64,
}

/// Coefficients of `e^(i k q)`, `k` from zero.
#[inline]
fn coefficients(samples: &[f64; SAMPLES], turns: &[Turn; SAMPLES]) -> [Complex; SAMPLES / 2 + 1] {
    let mut out = [Complex::ZERO; SAMPLES / 2 + 1];
    for (k, place) in out.iter_mut().enumerate() {
        let mut sum = Complex::ZERO;
        let mut at = 0;
        for sample in samples {
            // `at` is k times the sample's number, modulo the number of samples.
            let Turn { c, s } = turns.get(at).copied().unwrap_or(Turn::NONE);
            sum = Complex { re: sum.re + sample * c, im: sum.im - sample * s };
            at += k;
            at = if at >= SAMPLES { at - SAMPLES } else { at };
        }
        *place = sum;
    }
    out
}

/// All roots of the polynomial of a degree up to [`DEGREE`] through the samples.
pub(super) fn roots(samples: &[f64; SAMPLES], turns: &[Turn; SAMPLES], degree: usize) -> Roots {
    let half = coefficients(samples, turns);
    let (mut most, mut beyond) = (1e-300f64, 0.0f64);
    for (k, c) in half.iter().enumerate() {
        most = most.max(c.size());
        beyond = if k > degree { beyond.max(c.size()) } else { beyond };
    }
    let noise = beyond / most;
    // Roots beyond all measure, and their counterparts at zero, are none.
    let mut degree = degree.min(DEGREE);
    while degree > 1 && !half.get(degree).is_some_and(|c| c.size() > 1e-13 * most) {
        degree -= 1;
    }
    let len = 2 * degree;
    let mut a = [Complex::ZERO; ROOTS + 1];
    for (m, place) in a.iter_mut().enumerate().take(len + 1) {
        let k = m.abs_diff(degree);
        let c = half.get(k).copied().unwrap_or(Complex::ZERO);
        *place = Complex { re: c.re / most, im: if m < degree { -c.im / most } else { c.im / most } };
    }
    let mut found = Roots { z: starts(len), error: [0.0; ROOTS], len, noise };
    iterate(&a, &mut found);
    found
}

/// On the circle of the unit circle's size, but not on it: roots come in pairs mirrored at it, and
/// starts that are so, too, would stay there.
fn starts(len: usize) -> [Complex; ROOTS] {
    let mut q = [0.0; ROOTS];
    for (k, q) in q.iter_mut().enumerate() {
        *q = core::f64::consts::TAU * (k as f64 + 0.3) / len as f64;
    }
    let (s, c) = f64::sin_cos_all(&q);
    let mut z = [Complex::ZERO; ROOTS];
    for k in 0..ROOTS {
        let r = if k % 2 == 0 { 0.93 } else { 1.04 };
        z[k] = Complex { re: r * c[k], im: r * s[k] };
    }
    z
}

/// Value, derivative, and the size of the value's rounding error in parts of a unit.
#[inline(always)]
fn evaluated(a: &[Complex; ROOTS + 1], len: usize, z: Complex) -> (Complex, Complex, f64) {
    let (mut p, mut d) = (Complex::ZERO, Complex::ZERO);
    let (r, mut sum) = (z.size(), 0.0);
    for c in a.iter().take(len + 1).rev() {
        d = d.by(z).plus(p);
        p = p.by(z).plus(*c);
        sum = sum * r + 1.0;
    }
    (p, d, sum)
}

/// The sum of `1 / (z - other)`.
#[inline(always)]
fn pull(z: &[Complex; ROOTS], len: usize, k: usize) -> Complex {
    let mut sum = Complex::ZERO;
    let here = z.get(k).copied().unwrap_or(Complex::ZERO);
    for (j, other) in z.iter().enumerate().take(len) {
        if j != k {
            sum = sum.plus(here.minus(*other).reciprocal());
        }
    }
    sum
}

impl Roots {
    /// Roots near the unit circle that the coefficients don't determine (a few that lie together
    /// spoil each other's digits): the same iteration with the matrix's own derivative, given
    /// together with its condition.
    #[cold]
    #[inline(never)]
    pub fn refine(&mut self, derivative: impl Fn(Complex) -> (Complex, f64)) {
        let len = self.len.min(ROOTS);
        let mut todo = 0u32;
        for k in 0..len {
            let poor = self.error[k] > POOR && (self.z[k].size() - 1.0).abs() < 0.1 + 10.0 * self.error[k];
            todo |= u32::from(poor) << k;
        }
        for _ in 0..SWEEPS {
            for k in 0..len {
                // A root that goes on moving is as far off as its last step was long.
                if todo >> k & 1 == 0 {
                    continue;
                }
                let z = self.z[k];
                let (own, condition) = derivative(z);
                let own = own.plus(z.reciprocal().times(0.5 * len as f64));
                let newton = own.reciprocal();
                let step = own.minus(pull(&self.z, len, k)).reciprocal();
                if !(step.square() < 0.04) {
                    self.error[k] = 1.0;
                    continue;
                }
                self.z[k] = z.minus(step);
                self.error[k] = (1e-15 * condition * newton.size()).max(step.size());
                if step.square() < 1e-24 {
                    todo &= !(1 << k);
                }
            }
            if todo == 0 {
                break;
            }
        }
    }
}

fn iterate(a: &[Complex; ROOTS + 1], found: &mut Roots) {
    let len = found.len.min(ROOTS);
    let mut done = 0u32;
    for _ in 0..ITERATIONS {
        for k in 0..len {
            if done >> k & 1 == 1 {
                continue;
            }
            let z = found.z[k];
            let (p, d, sum) = evaluated(a, len, z);
            let newton = p.by(d.reciprocal());
            let others = pull(&found.z, len, k);
            let step = newton.by(Complex::ONE.minus(newton.by(others)).reciprocal());
            found.z[k] = z.minus(step);
            if step.square() < 1e-26 * z.square() || p.square() < 1e-32 * sum * sum {
                done |= 1 << k;
            }
        }
        if done.count_ones() as usize == len {
            break;
        }
    }
    let noise = found.noise.max(1e-16);
    for k in 0..len {
        let (_, d, _) = evaluated(a, len, found.z[k]);
        // Where roots lie together, the derivative among what rounding leaves of them is small.
        found.error[k] = noise / d.size().max(1e-150);
    }
}
