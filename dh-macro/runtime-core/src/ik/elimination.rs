//! Six joints whose product is a pose: five of them eliminated (Raghavan and Roth 1993). The hidden
//! one turns; the others turn or slide.
//!
//! Written as a loop that begins with the hidden joint, `E0 (E1 E2 line3) = G E5' E4' line3`: joint 3
//! does not move its own line. Fourteen numbers of a line are bilinear in the cosines and sines of
//! either side. Eight of the fourteen equations eliminate one side. Six remain, bilinear in two
//! angles, linear in cosine and sine of the hidden one; multiplied with cosine and sine of half of
//! an angle they are twelve for twelve products. No tangent of a half angle, so half turns are like
//! others.
//!
//! A joint that slides by `d` has `d^2` and `d` where one that turns has cosine and sine, and `1` and
//! `d` where that has cosine and sine of half the angle. If joint 3 slides, a whole frame keeps its
//! directions: fourteen numbers again, its axes, the moment of the line, and where the origin is
//! across the slide as the frame sees it.

use super::axis::{Axis, Value};
use super::dense::{Rows, eliminate, eliminate_complex, kernel};
use super::harmonics::Complex;
use super::pose::Displacement;
use super::real::root;
use super::vector::{Turn, add, beside, cross, dot, scale, sub, times};

/// Numbers of a line.
const NUMBERS: usize = 14;
/// Products of `(c, s, 1)` or `(d^2, d, 1)` of two joints; the last is one.
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

/// Of a line, six that do not change in a turn about z, then four x and four y that turn.
fn numbers(h: [f64; 3], p: [f64; 3]) -> [f64; NUMBERS] {
    let moment = cross(p, h);
    let (pp, ph) = (dot(p, p), dot(p, h));
    let r = sub(scale(pp, h), scale(2.0 * ph, p));
    let (q, l) = (moment, h);
    [l[2], p[2], q[2], r[2], pp, ph, l[0], p[0], q[0], r[0], l[1], p[1], q[1], r[1]]
}

/// The same of a frame that is known but for a slide along its axis `h`.
fn numbers_of_frame([h, x, y]: [[f64; 3]; 3], p: [f64; 3]) -> [f64; NUMBERS] {
    let m = cross(p, h);
    [h[2], x[2], y[2], m[2], dot(p, x), dot(p, y), h[0], x[0], y[0], m[0], h[1], x[1], y[1], m[1]]
}

/// A third of a turn.
const THIRDS: [Turn; 3] = [
    Turn { c: 1.0, s: 0.0 },
    Turn { c: -0.5, s: 0.866_025_403_784_438_6 },
    Turn { c: -0.5, s: -0.866_025_403_784_438_6 },
];

/// `[c, s, 1]` parts of what has these values at the three thirds of a turn, `[d^2, d, 1]` parts of
/// what has them at the ways 0, 1 and -1.
#[inline(always)]
fn parts(slides: bool, [a, b, c]: [f64; 3]) -> [f64; 3] {
    const K: f64 = 0.577_350_269_189_625_8;
    if slides {
        [0.5 * (b + c) - a, 0.5 * (b - c), a]
    } else {
        [(2.0 * a - b - c) / 3.0, (b - c) * K, (a + b + c) / 3.0]
    }
}

/// Where a joint is looked at.
#[inline(always)]
fn sampled(axis: &Axis) -> [Value; 3] {
    if axis.slides { [0.0, 1.0, -1.0].map(Value::way) } else { THIRDS.map(Value::turn) }
}

/// Numbers of the line (or frame) that two joints move, by the products of their positions.
fn side(first: &Axis, second: &Axis, line: &Axis, after: &Displacement) -> Side {
    let mut at = [[[0.0; NUMBERS]; 3]; 3];
    for (j, w) in sampled(second).into_iter().enumerate() {
        for (i, v) in sampled(first).into_iter().enumerate() {
            let direction = |x| times(&after.rotation, first.direction(v, second.direction(w, x)));
            let p = after.point(first.point(v, second.point(w, line.c)));
            at[i][j] = if line.slides {
                let x = beside(line.h);
                numbers_of_frame([line.h, x, cross(line.h, x)].map(direction), p)
            } else {
                numbers(direction(line.h), p)
            };
        }
    }
    let mut out = [[0.0; PRODUCTS]; NUMBERS];
    for (n, row) in out.iter_mut().enumerate() {
        let mut half = [[0.0; 3]; 3];
        for i in 0..3 {
            half[i] = parts(second.slides, [at[i][0][n], at[i][1][n], at[i][2][n]]);
        }
        for j in 0..3 {
            let [c, s, one] = parts(first.slides, [half[0][j], half[1][j], half[2][j]]);
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
    /// Do the joints slide: those of the other side, then those of the eliminated one?
    slides: [bool; 4],
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
        let [one, two, four, five] = [a1, a2, a4, a5].map(|a| a.slides);
        let slides = if pose_side { [one, two, five, four] } else { [five, four, one, two] };
        let mut out = Self {
            matrix: [[[0.0; TERMS]; TERMS]; 3],
            vectors: [[0.0; NUMBERS]; VARY],
            triangle: [[0.0; VARY]; VARY],
            constant: [0.0; NUMBERS],
            other,
            sense,
            slides,
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
                    if self.slides[0] {
                        // d^3, d^2, d, 1.
                        let (square, plain, one) = (part[j], part[3 + j], part[6 + j]);
                        let by_one = &mut matrix[2 * e];
                        (by_one[3 + j], by_one[6 + j], by_one[9 + j]) = (square, plain, one);
                        let by_way = &mut matrix[2 * e + 1];
                        (by_way[j], by_way[3 + j], by_way[6 + j]) = (square, plain, one);
                        continue;
                    }
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

    /// The other four positions at a root: those of the side that was not eliminated, then those of
    /// the other.
    pub fn positions(&self, q: Turn) -> [Value; 4] {
        let mut rows = self.at(q);
        eliminate::<TERMS, TERMS>(&mut rows);
        let x = kernel::<TERMS, TERMS>(&rows);
        let block = |k: usize| [x[3 * k], x[3 * k + 1], x[3 * k + 2]];
        // `(c, s, 1)` of the second joint, times what the first one makes of it.
        let (first, w) = if self.slides[0] { slide(block) } else { turn(block) };
        let second = single(self.slides[1], w);
        let [third, fourth] = self.eliminated(q, factors(self.slides[0], first), factors(self.slides[1], second));
        [first, second, third, fourth]
    }

    /// Positions of the eliminated side, from the factors of the others.
    fn eliminated(&self, q: Turn, u: [f64; 3], w: [f64; 3]) -> [Value; 2] {
        let mut x = [0.0; NUMBERS];
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
        [single(self.slides[2], [m[2], m[5], 1.0]), single(self.slides[3], [m[6], m[7], 1.0])]
    }
}

/// The angle whose half's cosine and sine, and those of one and a half of it, multiply the blocks:
/// and what they multiply. The latter two stand for the first where these are small.
fn turn(block: impl Fn(usize) -> [f64; 3]) -> (Value, [f64; 3]) {
    let (a, b) = (block(0), block(1));
    let (first, _) = Turn::along(dot(a, a) - dot(b, b), 2.0 * dot(a, b));
    // The half angle, of either sign, from its larger part.
    let half =
        if first.c > 0.0 { Turn::along(1.0 + first.c, first.s).0 } else { Turn::along(first.s, 1.0 - first.c).0 };
    (Value::turn(first), add(scale(half.c, a), scale(half.s, b)))
}

/// The way whose powers, the third first, multiply the blocks: and what they multiply.
fn slide(block: impl Fn(usize) -> [f64; 3]) -> (Value, [f64; 3]) {
    let [cube, square, plain, one] = [block(0), block(1), block(2), block(3)];
    // By least squares over neighbours.
    let above = dot(cube, square) + dot(square, plain) + dot(plain, one);
    let below = dot(square, square) + dot(plain, plain) + dot(one, one);
    let way = above / below.max(1e-150);
    let w = if way.abs() < 1.0 { add(one, scale(way, plain)) } else { add(plain, scale(1.0 / way, one)) };
    (Value::way(way), w)
}

/// Of `(c, s, 1)` or `(d^2, d, 1)`, times anything.
fn single(slides: bool, [a, b, c]: [f64; 3]) -> Value {
    if slides {
        let way = if a.abs() > c.abs() { a / b } else { b / c };
        // Beyond all measure where both vanish.
        Value::way(if way.abs() < 1e100 { way } else { 0.0 })
    } else {
        let sign = if c < 0.0 { -1.0 } else { 1.0 };
        Value::turn(Turn::along(sign * a, sign * b).0)
    }
}

/// `(c, s, 1)` or `(d^2, d, 1)`.
fn factors(slides: bool, v: Value) -> [f64; 3] {
    if slides { [v.way * v.way, v.way, 1.0] } else { [v.turn.c, v.turn.s, 1.0] }
}

/// The position of joint 3, from all others.
pub(super) fn last(l: &Loop, v: &Posture) -> Value {
    let axis = &l.axes[3];
    let moved = |k: usize| l.axes[k].displacement(v[k]);
    let left = moved(0).after(&moved(1)).after(&moved(2));
    let rest = left.inverse().after(&l.pose).after(&moved(4).after(&moved(5)).inverse());
    let h = axis.h;
    if axis.slides {
        return Value::way(dot(h, rest.shift));
    }
    let b = beside(h);
    let image = times(&rest.rotation, b);
    Value::turn(Turn::along(dot(b, image), dot(cross(h, b), image)).0)
}
