//! From a posture that misses the pose to those that meet it, past turning points. The curve is the
//! one on which the pose error is a multiple of its initial value (Newton homotopy by arc length;
//! Branin 1972, Allgower and Georg, 2.1). Where Newton's steps end at one posture of several, or
//! between two, the curve goes on.

use super::arm::{Arm, Query};
use super::axis::Value;
use super::polish::{equations, moved};
use super::pose::Displacement;
use super::real::root;

/// Pose, redundancy, and the multiple.
const ROWS: usize = 8;
const MASK: usize = ROWS - 1;
/// Steps each way, and their lengths: rad, m and multiples together.
const STEPS: usize = 40;
const LONGEST: f64 = 0.3;
/// How far from the pose a walk around a singularity goes, rad and m.
const AWAY: f64 = 0.3;
const SHORTEST: f64 = 1e-3;

type Row = [f64; ROWS];

/// Solves by elimination with the largest pivots; `None` where it is singular. Rows and columns
/// from `n` on are not looked at.
fn solve(a: &mut [Row; ROWS], b: &mut Row, n: usize) -> Option<()> {
    let n = n.min(ROWS);
    for k in 0..n {
        let mut best = k;
        for i in k + 1..n {
            // The mask spares a bound check, which would be a way into a panic.
            if a[i][k].abs() > a[best & MASK][k].abs() {
                best = i;
            }
        }
        let (best, pivot) = (best & MASK, a[best & MASK]);
        if !(pivot[k].abs() > 1e-13) {
            return None;
        }
        (a[best], a[k]) = (a[k], pivot);
        (b[best], b[k]) = (b[k], b[best]);
        for i in k + 1..n {
            let f = a[i][k] / pivot[k];
            for j in k..n {
                a[i][j] -= f * pivot[j];
            }
            b[i] -= f * b[k];
        }
    }
    for i in (0..n).rev() {
        for j in i + 1..n {
            b[i] -= a[i][j] * b[j];
        }
        b[i] /= a[i][i];
    }
    Some(())
}

fn size(v: &[f64]) -> f64 {
    root(v.iter().fold(0.0, |s, x| s + x * x))
}

/// A point of the curve and the way on from it: joints first, the multiple last.
struct Walk<'a, const N: usize> {
    arm: &'a Arm<N>,
    g: &'a Displacement,
    query: &'a Query<'a, N>,
    /// Direction of what is left at the start.
    u: [f64; 7],
}

impl<const N: usize> Walk<'_, N> {
    /// Pose error, and the bordered matrix with a last row.
    fn system(&self, v: &[Value; N], s: f64, last: &Row) -> (Row, [Row; ROWS]) {
        let (left, columns) = equations(self.arm, self.g, self.query, v);
        let mut a = [[0.0; ROWS]; ROWS];
        let mut b = [0.0; ROWS];
        for i in 0..N.min(7) {
            for j in 0..N.min(7) {
                a[i][j] = columns[j][i];
            }
            a[i][N.min(7)] = self.u[i];
            b[i] = left[i] - s * self.u[i];
        }
        a[N.min(7)] = *last;
        (b, a)
    }

    /// The unit tangent that goes on in the direction of `last`.
    fn tangent(&self, v: &[Value; N], s: f64, last: &Row) -> Option<Row> {
        let (_, mut a) = self.system(v, s, last);
        let mut t = [0.0; ROWS];
        t[N.min(7)] = 1.0;
        solve(&mut a, &mut t, N + 1)?;
        let n = size(&t);
        Some(t.map(|x| x / n))
    }

    /// On to the curve again, across the tangent.
    fn corrected(&self, mut v: [Value; N], mut s: f64, last: &Row) -> Option<([Value; N], f64)> {
        for _ in 0..5 {
            let (mut b, mut a) = self.system(&v, s, last);
            let left = size(&b);
            if left < 1e-7 {
                return Some((v, s));
            }
            solve(&mut a, &mut b, N + 1)?;
            if !(size(&b) < 0.5) {
                return None;
            }
            v = moved(&v, &core::array::from_fn(|i| b[i.min(ROWS - 1)]));
            s += b[N.min(7)];
        }
        None
    }
}

/// Zero of the multiple between two points of the curve that are one step apart, as parts of the
/// step. It is that of the cubic through both values with both slopes. Also where it only comes
/// near zero, since a pair of postures may lie between.
fn crossings(length: f64, (s0, d0): (f64, f64), (s1, d1): (f64, f64)) -> [Option<f64>; 2] {
    let (d0, d1) = (d0 * length, d1 * length);
    let at = |x: f64| {
        let y = 1.0 - x;
        y * y * ((1.0 + 2.0 * x) * s0 + x * d0) + x * x * ((1.0 + 2.0 * y) * s1 - y * d1)
    };
    let zero = |mut from: f64, mut to: f64| {
        let sign = at(from) > 0.0;
        for _ in 0..20 {
            let middle = 0.5 * (from + to);
            if (at(middle) > 0.0) == sign {
                from = middle;
            } else {
                to = middle;
            }
        }
        Some(from)
    };
    if (s0 > 0.0) != (s1 > 0.0) {
        return [zero(0.0, 1.0), None];
    }
    // Towards zero at first, away from it at last.
    if !(d0 * s0 < 0.0 && d1 * s1 > 0.0) {
        return [None; 2];
    }
    let mut lowest = 0.5;
    for k in 1..16 {
        let x = f64::from(k) / 16.0;
        if at(x) * s0 < at(lowest) * s0 {
            lowest = x;
        }
    }
    if (at(lowest) > 0.0) != (s0 > 0.0) {
        [zero(0.0, lowest), zero(lowest, 1.0)]
    } else if at(lowest).abs() < 0.1 * s0.abs().max(s1.abs()) {
        [Some(lowest), None]
    } else {
        [None; 2]
    }
}

/// How long a walk may be.
struct Bounds {
    /// Steps.
    steps: usize,
    /// The largest multiple.
    far: f64,
    /// Ends where it comes by its start again.
    closed: bool,
}

/// Goes on from a point of the curve, and hands over where nothing is left, nearly. True: it came
/// back to its start.
fn go<const N: usize>(
    walk: &Walk<'_, N>,
    (mut v, mut s): ([Value; N], f64),
    up: &Row,
    bounds: &Bounds,
    met: &mut impl FnMut([Value; N]),
) -> bool {
    let Some(mut t) = walk.tangent(&v, s, up) else { return false };
    let (start, first) = (v, t);
    let mut length: f64 = 0.05;
    let mut way = 0.0;
    for _ in 0..bounds.steps {
        let ahead = moved(&v, &core::array::from_fn(|i| length * t[i.min(ROWS - 1)]));
        let next = walk.corrected(ahead, s + length * t[N.min(7)], &t);
        let next = next.and_then(|(v, s)| Some((v, s, walk.tangent(&v, s, &t)?)));
        let turned = next.map_or(0.0, |(_, _, n)| n.iter().zip(&t).fold(0.0, |s, (a, b)| s + a * b));
        let Some((next_v, next_s, next_t)) = next.filter(|_| turned > 0.7) else {
            length *= 0.4;
            if length < SHORTEST {
                break;
            }
            continue;
        };
        for part in crossings(length, (s, t[N.min(7)]), (next_s, next_t[N.min(7)])).into_iter().flatten() {
            met(moved(&v, &core::array::from_fn(|i| part * length * t[i.min(ROWS - 1)])));
        }
        way += length;
        let apart = start.iter().zip(&next_v).fold(0.0f64, |m, (a, b)| {
            m.max((a.turn.c - b.turn.c).abs() + (a.turn.s - b.turn.s).abs() + (a.way - b.way).abs())
        });
        let along = first.iter().zip(&next_t).fold(0.0, |s, (a, b)| s + a * b);
        if bounds.closed && way > 3.0 * LONGEST && apart < length && along > 0.5 {
            return true;
        }
        (v, s, t) = (next_v, next_s, next_t);
        if s.abs() > bounds.far {
            break;
        }
        length = (length * if turned > 0.97 { 1.7 } else { 0.8 }).min(LONGEST);
    }
    false
}

/// Are there as many equations as joints?
fn square<const N: usize>(arm: &Arm<N>) -> bool {
    N == 6 || N == 7 && arm.holds()
}

/// Walks from a posture, less left (-1), more left (1) or both ways, as far as `far` times what is
/// left there, and hands over where nothing is left, nearly.
pub(super) fn walk<const N: usize>(
    arm: &Arm<N>,
    g: &Displacement,
    query: &Query<'_, N>,
    start: &[Value; N],
    ways: &[f64],
    far: f64,
    mut met: impl FnMut([Value; N]),
) {
    let (left, _) = equations(arm, g, query, start);
    let s0 = size(&left);
    // Some way to go.
    if !square(arm) || !(s0 > 1e-9) {
        return;
    }
    let walk = Walk { arm, g, query, u: left.map(|x| x / s0) };
    for &way in ways {
        let mut up = [0.0; ROWS];
        up[N.min(7)] = way;
        let bounds = Bounds { steps: STEPS, far: far * s0, closed: false };
        go(&walk, (*start, s0), &up, &bounds, &mut met);
    }
}

/// Beside a singularity: walks around the curve on which the pose is met but for a multiple of what
/// the joints can hardly do there. It is what becomes of the family of postures that a singular arm
/// has, and all that the real arm has of it lie on the curve.
pub(super) fn around<const N: usize>(
    arm: &Arm<N>,
    g: &Displacement,
    query: &Query<'_, N>,
    start: &[Value; N],
    mut met: impl FnMut([Value; N]),
) {
    if !square(arm) {
        return;
    }
    let (_, columns) = equations(arm, g, query, start);
    let Some(u) = hardest(&columns) else { return };
    let walk = Walk { arm, g, query, u };
    for sign in [1.0, -1.0] {
        // Any row across which the curve goes.
        let up = [1.0, -0.7, 0.9, 0.6, -0.8, 1.1, -0.5, 0.3].map(|x| sign * x);
        let Some(t) = walk.tangent(start, 0.0, &up) else { continue };
        let Some(on) = walk.corrected(*start, 0.0, &t) else { continue };
        let bounds = Bounds { steps: 4 * STEPS, far: AWAY, closed: true };
        if go(&walk, on, &t, &bounds, &mut met) {
            break;
        }
    }
}

/// The direction in which a Jacobian does least (unit vector): its last left singular vector, by
/// inverse iteration.
fn hardest<const N: usize>(columns: &[[f64; 7]; N]) -> Option<[f64; 7]> {
    let n = N.min(7);
    let mut gram = [[0.0; ROWS]; ROWS];
    let mut trace = 0.0;
    for i in 0..n {
        for j in 0..n {
            gram[i][j] = columns.iter().fold(0.0, |s, c| s + c[i] * c[j]);
        }
        trace += gram[i][i];
    }
    for (i, row) in gram.iter_mut().enumerate() {
        row[i] += 1e-11 * trace;
    }
    let mut u = [0.5, 0.6, -0.4, 0.7, 0.3, -0.8, 0.9, 0.0];
    for _ in 0..6 {
        let mut a = gram;
        solve(&mut a, &mut u, n)?;
        for x in u.iter_mut().skip(n) {
            *x = 0.0;
        }
        let length = size(&u);
        u = u.map(|x| x / length);
    }
    let [a, b, c, d, e, f, h, _] = u;
    Some([a, b, c, d, e, f, h])
}
