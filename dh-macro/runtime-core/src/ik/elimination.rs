//! Six turns whose product is a pose: five of them eliminated (Raghavan and Roth 1993).
//!
//! Written as a loop that begins with the hidden joint, `E0 (E1 E2 line3) = G E5' E4' line3`: joint 3
//! does not move its own line. Fourteen numbers of a line are bilinear in the cosines and sines of
//! either side. Eight of the fourteen equations eliminate one side. Six remain, bilinear in two
//! angles, linear in cosine and sine of the hidden one; multiplied with cosine and sine of half of
//! an angle they are twelve for twelve products. No tangent of a half angle, so half turns are like
//! others.

use super::axis::{Axis, Value};
use super::dense::{Rows, eliminate, eliminate_complex, kernel};
use super::harmonics::Complex;
use super::pose::Displacement;
use super::real::root;
use super::vector::{Turn, add, beside, cross, dot, scale, sub, times, transposed};

/// Numbers of a line.
const NUMBERS: usize = 14;
/// Products of `(c, s, 1)` of two angles; the last is one.
const PRODUCTS: usize = 9;
/// Those that vary.
const VARY: usize = 8;
/// Products of cosine and sine of half an angle and of one and a half, and `(c, s, 1)` of the other.
pub(super) const TERMS: usize = 12;

/// The matrix, its derivative, and one column more, rounded up to whole registers.
const WIDE: usize = 28;
/// `1 / i`
const BACK: Complex = Complex { re: 0.0, im: -1.0 };

type Side = [[f64; PRODUCTS]; NUMBERS];

/// Positions of the six joints.
pub(super) type Posture = [Value; 6];

/// Axes of a loop, the hidden joint first and along z through the origin, lengths in parts of the
/// arm's size; and the pose.
#[derive(Clone, Copy)]
pub(super) struct Loop {
    pub axes: [Axis; 6],
    pub pose: Displacement,
}

impl Loop {
    /// Of six joints `E0 .. E5 = g`, from the joint `first` on around.
    pub fn new(axes: &[Axis; 6], g: &Displacement, first: usize, size: f64) -> Self {
        let back = g.inverse();
        let mut turned = *axes;
        for (k, place) in turned.iter_mut().enumerate() {
            let at = k + first;
            *place = match axes.get(at) {
                Some(axis) => *axis,
                None => axes.get(at.wrapping_sub(6)).map_or(axes[0], |a| a.carried(&back)),
            };
        }
        let z = turned[0].h;
        let x = beside(z);
        let rotation = [x, cross(z, x), z];
        let [a, b, c] = times(&rotation, turned[0].c);
        let frame = Displacement { rotation, shift: [-a, -b, -c] };
        let mut pose = frame.after(g).after(&frame.inverse());
        let parts = 1.0 / size;
        for axis in &mut turned {
            *axis = axis.carried(&frame);
            axis.c = scale(parts, axis.c);
        }
        pose.shift = scale(parts, pose.shift);
        Self { axes: turned, pose }
    }
}

/// Six that do not change in a turn about z, then four x and four y that turn.
fn numbers(h: [f64; 3], p: [f64; 3]) -> [f64; NUMBERS] {
    let moment = cross(p, h);
    let (pp, ph) = (dot(p, p), dot(p, h));
    let r = sub(scale(pp, h), scale(2.0 * ph, p));
    let (q, l) = (moment, h);
    [l[2], p[2], q[2], r[2], pp, ph, l[0], p[0], q[0], r[0], l[1], p[1], q[1], r[1]]
}

/// A third of a turn.
const THIRDS: [Turn; 3] = [
    Turn { c: 1.0, s: 0.0 },
    Turn { c: -0.5, s: 0.866_025_403_784_438_6 },
    Turn { c: -0.5, s: -0.866_025_403_784_438_6 },
];

/// `[c, s, 1]` parts of what has these values at the three thirds.
#[inline(always)]
fn parts([a, b, c]: [f64; 3]) -> [f64; 3] {
    const K: f64 = 0.577_350_269_189_625_8;
    [(2.0 * a - b - c) / 3.0, (b - c) * K, (a + b + c) / 3.0]
}

/// Numbers of the line that two joints move, by the products of their turns.
fn side(first: &Axis, second: &Axis, line: &Axis, after: &Displacement) -> Side {
    let mut at = [[[0.0; NUMBERS]; 3]; 3];
    for (j, second_turn) in THIRDS.iter().enumerate() {
        let v = Value::turn(*second_turn);
        let (h, p) = (second.direction(v, line.h), second.point(v, line.c));
        for (i, first_turn) in THIRDS.iter().enumerate() {
            let v = Value::turn(*first_turn);
            let (h, p) = (first.direction(v, h), first.point(v, p));
            at[i][j] = numbers(times(&after.rotation, h), after.point(p));
        }
    }
    let mut out = [[0.0; PRODUCTS]; NUMBERS];
    for (n, row) in out.iter_mut().enumerate() {
        let mut half = [[0.0; 3]; 3];
        for i in 0..3 {
            half[i] = parts([at[i][0][n], at[i][1][n], at[i][2][n]]);
        }
        for j in 0..3 {
            let [c, s, one] = parts([half[0][j], half[1][j], half[2][j]]);
            (row[j], row[3 + j], row[6 + j]) = (c, s, one);
        }
    }
    out
}

/// What is left when one side is eliminated.
pub(super) struct Elimination {
    /// `12 x 12`: constant, times cosine, times sine of the hidden angle.
    matrix: [[[f64; TERMS]; TERMS]; 3],
    /// Of the eliminated side: reflections (their vectors), triangle, last column.
    vectors: [[f64; NUMBERS]; VARY],
    triangle: [[f64; VARY]; VARY],
    constant: [f64; NUMBERS],
    /// The other side.
    other: Side,
    /// Direction in which the other side turns.
    sense: f64,
    /// Smallest part of the triangle's diagonal in the largest.
    pub regular: f64,
}

/// `x - 2 v (v . x)`
#[inline(always)]
fn reflect(v: &[f64; NUMBERS], x: &mut [f64; NUMBERS]) {
    let mut sum = 0.0;
    for (v, x) in v.iter().zip(x.iter()) {
        sum += v * x;
    }
    for (v, x) in v.iter().zip(x) {
        *x -= 2.0 * sum * v;
    }
}

impl Elimination {
    /// Eliminates joints 5 and 4 if `pose_side`, else 1 and 2.
    pub fn new(l: &Loop, pose_side: bool) -> Self {
        let [_, a1, a2, a3, a4, a5] = &l.axes;
        let near = side(a1, a2, a3, &Displacement::NONE);
        let far = side(&a5.reversed(), &a4.reversed(), a3, &l.pose);
        let (gone, other, sense) = if pose_side { (far, near, 1.0) } else { (near, far, -1.0) };
        let mut out = Self {
            matrix: [[[0.0; TERMS]; TERMS]; 3],
            vectors: [[0.0; NUMBERS]; VARY],
            triangle: [[0.0; VARY]; VARY],
            constant: [0.0; NUMBERS],
            other,
            sense,
            regular: 0.0,
        };
        out.reduce(&gone);
        out.expand();
        out
    }

    /// Householder's reflections of the varying columns.
    fn reduce(&mut self, gone: &Side) {
        let mut columns = [[0.0; NUMBERS]; PRODUCTS];
        for (n, row) in gone.iter().enumerate() {
            for (column, x) in columns.iter_mut().zip(row) {
                column[n] = *x;
            }
        }
        self.constant = columns[VARY];
        let (mut least, mut most) = (f64::INFINITY, 0.0f64);
        for k in 0..VARY {
            let mut v = [0.0; NUMBERS];
            let mut n2 = 0.0;
            for n in k..NUMBERS {
                v[n] = columns[k][n];
                n2 += v[n] * v[n];
            }
            let n = root(n2);
            v[k] += if v[k] < 0.0 { -n } else { n };
            let long = root(v.iter().fold(0.0, |s, x| s + x * x)).max(1e-150);
            v = v.map(|x| x / long);
            for column in columns.iter_mut().take(VARY).skip(k) {
                reflect(&v, column);
            }
            self.vectors[k] = v;
            (least, most) = (least.min(n), most.max(n));
        }
        for k in 0..VARY {
            for j in k..VARY {
                self.triangle[k][j] = columns[j][k];
            }
        }
        self.regular = least / most.max(1e-150);
    }

    /// The six rows that the eliminated side does not reach.
    fn expand(&mut self) {
        for e in 0..NUMBERS - VARY {
            let mut normal = [0.0; NUMBERS];
            normal[VARY + e] = 1.0;
            for v in self.vectors.iter().rev() {
                reflect(v, &mut normal);
            }
            let mut three = [[0.0; PRODUCTS]; 3];
            for n in 0..6 {
                for k in 0..PRODUCTS {
                    three[0][k] += normal[n] * self.other[n][k];
                }
            }
            for n in 6..10 {
                // An x turns into (x c - y s), a y into (x s + y c).
                let (a, b) = (normal[n], normal[n + 4]);
                for k in 0..PRODUCTS {
                    let (x, y) = (self.other[n][k], self.other[n + 4][k]);
                    three[1][k] += a * x + b * y;
                    three[2][k] += self.sense * (b * x - a * y);
                }
            }
            let mut last = 0.0;
            for (a, b) in normal.iter().zip(&self.constant) {
                last += a * b;
            }
            three[0][VARY] -= last;
            for (matrix, part) in self.matrix.iter_mut().zip(&three) {
                for j in 0..3 {
                    let (c, s, one) = (0.5 * part[j], 0.5 * part[3 + j], part[6 + j]);
                    let by_cosine = &mut matrix[2 * e];
                    (by_cosine[j], by_cosine[3 + j], by_cosine[6 + j], by_cosine[9 + j]) = (one + c, s, c, s);
                    let by_sine = &mut matrix[2 * e + 1];
                    (by_sine[j], by_sine[3 + j], by_sine[6 + j], by_sine[9 + j]) = (s, one - c, -s, c);
                }
            }
        }
    }

    /// The matrix at a hidden angle.
    #[inline(always)]
    fn at(&self, q: Turn) -> Rows<TERMS> {
        let mut rows = [[0.0; TERMS]; 16];
        for r in 0..TERMS {
            for k in 0..TERMS {
                rows[r][k] = self.matrix[0][r][k] + q.c * self.matrix[1][r][k] + q.s * self.matrix[2][r][k];
            }
        }
        rows
    }

    /// Its determinant: a trigonometric polynomial of degree eight.
    #[inline]
    pub fn determinant(&self, q: Turn) -> f64 {
        eliminate::<TERMS, TERMS>(&mut self.at(q))
    }

    /// Logarithmic derivative of the determinant by `z = e^(i q)`, and the size of the inverse times
    /// that of the matrix: an error that the coefficients of a polynomial would magnify does not
    /// reach it.
    pub fn derivative(&self, z: Complex) -> (Complex, f64) {
        let w = z.reciprocal();
        // Cosine and sine of a complex angle, and their derivatives.
        let (c, s) = (z.plus(w).times(0.5), z.minus(w).times(0.5).by(BACK));
        let w2 = w.by(w);
        let (dc, ds) = (Complex::ONE.minus(w2).times(0.5), Complex::ONE.plus(w2).times(0.5).by(BACK));
        let (mut re, mut im) = ([[0.0; WIDE]; TERMS + 4], [[0.0; WIDE]; TERMS + 4]);
        let mut size = 0.0;
        for r in 0..TERMS {
            for k in 0..TERMS {
                let [one, by_c, by_s] = [self.matrix[0][r][k], self.matrix[1][r][k], self.matrix[2][r][k]];
                (re[r][k], im[r][k]) = (one + c.re * by_c + s.re * by_s, c.im * by_c + s.im * by_s);
                (re[r][TERMS + k], im[r][TERMS + k]) = (dc.re * by_c + ds.re * by_s, dc.im * by_c + ds.im * by_s);
                size += re[r][k] * re[r][k] + im[r][k] * im[r][k];
            }
            re[r][2 * TERMS] = 1.0;
        }
        eliminate_complex::<TERMS, WIDE>(&mut re, &mut im);
        let mut trace = Complex::ZERO;
        let mut inverse = 0.0;
        for k in 0..=TERMS {
            let mut x = [Complex::ZERO; TERMS];
            for i in (0..TERMS).rev() {
                let mut sum = Complex { re: re[i][TERMS + k], im: im[i][TERMS + k] };
                for j in i + 1..TERMS {
                    sum = sum.minus(Complex { re: re[i][j], im: im[i][j] }.by(x[j]));
                }
                x[i] = sum.by(Complex { re: re[i][i], im: im[i][i] }.reciprocal());
            }
            match x.get(k) {
                Some(x) => trace = trace.plus(*x),
                None => inverse = x.iter().fold(0.0, |s, x| s + x.square()),
            }
        }
        (trace, root(size) * root(inverse))
    }

    /// The other four angles at a root: those of the side that was not eliminated, then those of the
    /// other.
    pub fn angles(&self, q: Turn) -> [Turn; 4] {
        let mut rows = self.at(q);
        eliminate::<TERMS, TERMS>(&mut rows);
        let x = kernel::<TERMS, TERMS>(&rows);
        let block = |k: usize| [x[3 * k], x[3 * k + 1], x[3 * k + 2]];
        // (c, s, 1) of the second angle times cosine and sine of half the first, and of one and a
        // half of it, which stand for the first where these are small.
        let (a, b) = (block(0), block(1));
        let (first, _) = Turn::along(dot(a, a) - dot(b, b), 2.0 * dot(a, b));
        // The half angle, of either sign, from its larger part.
        let half =
            if first.c > 0.0 { Turn::along(1.0 + first.c, first.s).0 } else { Turn::along(first.s, 1.0 - first.c).0 };
        let w = add(scale(half.c, a), scale(half.s, b));
        let sign = if w[2] < 0.0 { -1.0 } else { 1.0 };
        let (second, _) = Turn::along(sign * w[0], sign * w[1]);
        let [third, fourth] = self.eliminated(q, first, second);
        [first, second, third, fourth]
    }

    /// The angles of the eliminated side, from the others.
    fn eliminated(&self, q: Turn, first: Turn, second: Turn) -> [Turn; 2] {
        let mut x = [0.0; NUMBERS];
        let (u, w) = ([first.c, first.s, 1.0], [second.c, second.s, 1.0]);
        for (x, row) in x.iter_mut().zip(&self.other) {
            *x = u[0] * dot([row[0], row[1], row[2]], w)
                + u[1] * dot([row[3], row[4], row[5]], w)
                + dot([row[6], row[7], row[8]], w);
        }
        let s = self.sense * q.s;
        for n in 6..10 {
            (x[n], x[n + 4]) = (q.c * x[n] - s * x[n + 4], s * x[n] + q.c * x[n + 4]);
        }
        for (x, c) in x.iter_mut().zip(&self.constant) {
            *x -= c;
        }
        for v in &self.vectors {
            reflect(v, &mut x);
        }
        let mut m = [0.0; VARY];
        for k in (0..VARY).rev() {
            let mut sum = x[k];
            for j in k + 1..VARY {
                sum -= self.triangle[k][j] * m[j];
            }
            let pivot = self.triangle[k][k];
            m[k] = sum / if pivot.abs() < 1e-150 { 1e-150 } else { pivot };
        }
        [Turn::along(m[2], m[5]).0, Turn::along(m[6], m[7]).0]
    }
}

/// The angle of joint 3, from all others.
pub(super) fn last(l: &Loop, v: &Posture) -> Turn {
    let turn = |k: usize| l.axes[k].displacement(v[k]).rotation;
    let product = super::vector::product;
    let left = product(&product(&turn(0), &turn(1)), &turn(2));
    let right = product(&turn(4), &turn(5));
    let rest = product(&product(&transposed(&left), &l.pose.rotation), &transposed(&right));
    let h = l.axes[3].h;
    let b = beside(h);
    let image = times(&rest, b);
    Turn::along(dot(b, image), dot(cross(h, b), image)).0
}
