//! Newton's steps of six joints, and what lies across a singularity.

use super::super::runtime::Scalar;
use super::dense::{Rows, back, eliminate, kernel};
use super::elimination::{Loop, Posture};
use super::pose::Displacement;
use super::real::root;
use super::vector::{Turn, cross, norm, product, scale, sub, times, transposed};

/// Six columns of the joints, what is left, and one to fill whole registers.
type System = Rows<8>;

/// Length that counts as one, in parts of the arm's size: that of the posture, where slides are far
/// out.
fn long(v: &Posture) -> f64 {
    v.iter().fold(1.0, |most, v| v.way.abs().max(most))
}

/// Equations of Newton's step: columns of the joints, then what is left; and its size.
pub(super) fn linear(round: &Loop, v: &Posture) -> (System, f64) {
    let parts = 1.0 / long(v);
    let mut before = Displacement::NONE;
    let mut h = [[0.0; 3]; 6];
    let mut c = [[0.0; 3]; 6];
    for k in 0..6 {
        let axis = &round.axes[k];
        h[k] = times(&before.rotation, axis.h);
        c[k] = before.point(axis.c);
        before = before.after(&axis.displacement(v[k]));
    }
    // The tip is in the middle of the loop's pose.
    let tip = before.shift;
    let left = sub(round.pose.shift, tip);
    let r = product(&round.pose.rotation, &transposed(&before.rotation));
    let w = [0.5 * (r[2][1] - r[1][2]), 0.5 * (r[0][2] - r[2][0]), 0.5 * (r[1][0] - r[0][1])];
    let mut rows = [[0.0; 8]; 16];
    for k in 0..6 {
        let turned = || (scale(parts, cross(h[k], sub(tip, c[k]))), h[k]);
        let (l, w) = if round.axes[k].slides { (h[k], [0.0; 3]) } else { turned() };
        for i in 0..3 {
            (rows[i][k], rows[3 + i][k]) = (l[i], w[i]);
        }
    }
    for i in 0..3 {
        (rows[i][6], rows[3 + i][6]) = (parts * left[i], w[i]);
    }
    // Beyond a quarter turn the sine falls again.
    let wide = r[0][0] + r[1][1] + r[2][2] < 1.0;
    (rows, norm(left) + norm(w) + if wide { 1.0 } else { 0.0 })
}

/// Joints moved on.
fn stepped(round: &Loop, v: &Posture, d: &[f64; 6]) -> Posture {
    let (sin, cos) = f64::sin_cos_all(d);
    let (mut out, long) = (*v, long(v));
    for (k, v) in out.iter_mut().enumerate() {
        if round.axes[k].slides {
            v.way += long * d[k];
            continue;
        }
        let turn = v.turn.then(Turn { c: cos[k], s: sin[k] });
        let n = 1.5 - 0.5 * (turn.c * turn.c + turn.s * turn.s);
        v.turn = Turn { c: turn.c * n, s: turn.s * n };
    }
    out
}

/// Below this pivot the least stretch is looked at, too.
const SMALL_PIVOT: f64 = 0.05;

/// How far from a singularity: smallest pivot, in parts of the largest, or what the matrix makes of
/// the direction that it nearly takes to zero. Both bound its least singular value from above, and a
/// small one may be the product of two pivots that are not small.
fn pivots(rows: &System) -> f64 {
    let (mut least, mut most) = (f64::INFINITY, 0.0f64);
    for k in 0..6 {
        let pivot = rows[k][k].abs();
        (least, most) = (least.min(pivot), most.max(pivot));
    }
    if least < SMALL_PIVOT * most {
        let inverse = back::<6, 8>(rows, &[1.0; 6], 1e-150);
        least = least.min(root(6.0 / inverse.iter().fold(0.0, |s, x| s + x * x)));
    }
    least / most.max(1e-150)
}

/// Newton's steps: what is left, and how far from a singularity.
pub(super) fn newton(round: &Loop, v: &mut Posture) -> (f64, f64) {
    let (mut rows, mut left) = linear(round, v);
    let mut slack = 0.0;
    let mut worse = 0;
    for _ in 0..12 {
        eliminate::<6, 8>(&mut rows);
        slack = pivots(&rows);
        if left < 2e-15 {
            break;
        }
        let mut b = [0.0; 6];
        for (b, row) in b.iter_mut().zip(&rows) {
            *b = row[6];
        }
        let mut d = back::<6, 8>(&rows, &b, 1e-150);
        let most = d.iter().fold(0.0f64, |m, x| m.max(x.abs()));
        if !(most < 1e100) {
            break;
        }
        if most > 0.3 {
            d = d.map(|x| x * 0.3 / most);
        }
        let next = stepped(round, v, &d);
        let (next_rows, next_left) = linear(round, &next);
        if next_left >= left {
            worse += 1;
            if left < 1e-13 || worse > 2 {
                break;
            }
        }
        (*v, rows, left) = (next, next_rows, next_left);
    }
    (left, slack)
}

/// Beside a singularity a second posture lies across it: where the pose error, which bends like a
/// parabola along the direction that hardly moves the pose, is zero again.
pub(super) fn twin(round: &Loop, v: &Posture) -> Option<Posture> {
    const STEP: f64 = 1e-4;
    let (rows, _) = linear(round, v);
    let mut factors = rows;
    eliminate::<6, 8>(&mut factors);
    let idle = kernel::<6, 8>(&factors);
    // The left one: of the transposed matrix.
    let mut across = rows;
    for i in 0..6 {
        for k in 0..6 {
            across[i][k] = rows[k][i];
        }
    }
    eliminate::<6, 8>(&mut across);
    let left = kernel::<6, 8>(&across);
    let image = |rows: &System| {
        let mut sum = 0.0;
        for i in 0..6 {
            for k in 0..6 {
                sum += left[i] * rows[i][k] * idle[k];
            }
        }
        sum
    };
    let here = image(&rows);
    let (on, _) = linear(round, &stepped(round, v, &idle.map(|x| x * STEP)));
    let (off, _) = linear(round, &stepped(round, v, &idle.map(|x| -x * STEP)));
    let bend = (image(&on) - image(&off)) / (2.0 * STEP);
    let way = -2.0 * here / bend;
    (way.abs() < 0.3).then(|| stepped(round, v, &idle.map(|x| x * way)))
}
