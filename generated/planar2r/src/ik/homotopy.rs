//! From a posture that misses the pose to those that meet it, past turning points: the curve on which what is left to the pose is a
//! multiple of what it is at the start (Newton homotopy by arc length; Branin 1972, Allgower and Georg, 2.1). Where Newton's steps
//! end at one posture of several, or between two, the curve goes on.

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
const SHORTEST: f64 = 1e-3;

type Row = [f64; ROWS];

/// Solves by elimination with the largest pivots; `None` where it is singular. Rows and columns from `n` on are not looked at.
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
    /// What is left, and the bordered matrix with a last row.
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

/// Walks from a posture, less left (-1), more left (1) or both ways, as far as `far` times what is left there, and hands over where
/// nothing is left, nearly.
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
    // As many equations as joints, and some way to go.
    if !(N == 6 || N == 7 && arm.holds()) || !(s0 > 1e-9) {
        return;
    }
    let walk = Walk { arm, g, query, u: left.map(|x| x / s0) };
    for &way in ways {
        let mut up = [0.0; ROWS];
        up[N.min(7)] = way;
        let (mut v, mut s) = (*start, s0);
        let Some(mut t) = walk.tangent(&v, s, &up) else { continue };
        let mut length: f64 = 0.05;
        for _ in 0..STEPS {
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
            if (s > 0.0) != (next_s > 0.0) {
                let part = length * s / (s - next_s);
                met(moved(&v, &core::array::from_fn(|i| part * t[i.min(ROWS - 1)])));
            }
            (v, s, t) = (next_v, next_s, next_t);
            if s.abs() > far * s0 {
                break;
            }
            length = (length * if turned > 0.97 { 1.7 } else { 0.8 }).min(LONGEST);
        }
    }
}
