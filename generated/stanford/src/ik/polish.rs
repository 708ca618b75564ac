//! Newton's steps with the arm's own Jacobian (Lynch and Park, 6.2), and how far a posture is from
//! the pose.

use super::super::runtime::Scalar;
use super::arm::{Arm, Query};
use super::axis::Value;
use super::list::each;
use super::pose::Displacement;
use super::real::{angle, root};
use super::vector::{IDENTITY, Turn, Vector, cross, norm, product, scale, sub, times, transposed};

/// `[v; w]`: the step in m and the turn in rad, world axes, that are left to the pose.
pub(super) type Twist = [f64; 6];

/// Lengths of the two halves.
pub(super) fn sizes(e: &Twist) -> [f64; 2] {
    [norm([e[0], e[1], e[2]]), norm([e[3], e[4], e[5]])]
}

/// Turns of all joints.
pub(super) fn values<const N: usize>(arm: &Arm<N>, q: &[f64; N]) -> [Value; N] {
    let (sin, cos) = f64::sin_cos_all(q);
    each(
        Value::ZERO,
        |i| {
            if arm.axes[i].slides { Value::way(q[i]) } else { Value::turn(Turn { c: cos[i], s: sin[i] }) }
        },
    )
}

/// Positions from turns, each within half a turn of zero.
pub(super) fn positions<const N: usize>(arm: &Arm<N>, v: &[Value; N]) -> [f64; N] {
    each(0.0, |i| if arm.axes[i].slides { v[i].way } else { angle(v[i].turn.s, v[i].turn.c) })
}

/// `E1 .. En`.
pub(super) fn forward<const N: usize>(arm: &Arm<N>, v: &[Value; N]) -> Displacement {
    let mut x = [[0.0; 3], IDENTITY[0], IDENTITY[1]];
    for i in (0..N).rev() {
        let axis = &arm.axes[i];
        x = [axis.point(v[i], x[0]), axis.direction(v[i], x[1]), axis.direction(v[i], x[2])];
    }
    let columns = [x[1], x[2], cross(x[1], x[2])];
    Displacement { rotation: transposed(&columns), shift: x[0] }
}

/// What is left from `E1 .. En` to `g`, at the last frame's origin.
pub(super) fn remainder<const N: usize>(arm: &Arm<N>, g: &Displacement, v: &[Value; N]) -> Twist {
    remainder_of(arm, g, &forward(arm, v))
}

fn remainder_of<const N: usize>(arm: &Arm<N>, g: &Displacement, here: &Displacement) -> Twist {
    let [x, y, z] = sub(g.point(arm.home.shift), here.point(arm.home.shift));
    let r = product(&g.rotation, &transposed(&here.rotation));
    let w = [r[2][1] - r[1][2], r[0][2] - r[2][0], r[1][0] - r[0][1]];
    let s = norm(w) / 2.0;
    if s < 1e-6 && r[0][0] + r[1][1] + r[2][2] > 2.0 {
        // The sine is the angle.
        return [x, y, z, 0.5 * w[0], 0.5 * w[1], 0.5 * w[2]];
    }
    let c = (r[0][0] + r[1][1] + r[2][2] - 1.0) / 2.0;
    // Turn by `a` about w: the skew part is sin a. Near pi it loses the axis; any will do there.
    let a = angle(s, c);
    let k = if s > 1e-9 { a / (2.0 * s) } else { 0.5 };
    let w = if s <= 1e-9 && c < 0.0 { [core::f64::consts::PI, 0.0, 0.0] } else { scale(k, w) };
    [x, y, z, w[0], w[1], w[2]]
}

/// Columns `[v; w]` of the last frame's origin, one per joint.
pub(super) fn jacobian<const N: usize>(arm: &Arm<N>, v: &[Value; N]) -> [Twist; N] {
    jacobian_about(arm, v, forward(arm, v).point(arm.home.shift))
}

/// The same where the tip is known already.
fn jacobian_about<const N: usize>(arm: &Arm<N>, v: &[Value; N], tip: Vector) -> [Twist; N] {
    let mut before = Displacement::NONE;
    each([0.0; 6], |i| {
        let axis = &arm.axes[i];
        let h = times(&before.rotation, axis.h);
        let c = before.point(axis.c);
        before = before.after(&axis.displacement(v[i]));
        let (l, w): (Vector, Vector) = if axis.slides { (h, [0.0; 3]) } else { (cross(h, sub(tip, c)), h) };
        [l[0], l[1], l[2], w[0], w[1], w[2]]
    })
}

/// Pose error, and its derivatives by the joints: six rows of the pose, a seventh for what a
/// redundant arm keeps (zero for others).
pub(super) type Rows = [f64; 7];

/// Columns `[v; w; redundancy]`, one per joint.
pub(super) fn equations<const N: usize>(
    arm: &Arm<N>,
    g: &Displacement,
    query: &Query<'_, N>,
    v: &[Value; N],
) -> (Rows, [Rows; N]) {
    let here = forward(arm, v);
    let [a, b, c, d, e, f] = remainder_of(arm, g, &here);
    let (left, row) = arm.held(query, v);
    let columns = jacobian_about(arm, v, here.point(arm.home.shift));
    let all = each([0.0; 7], |i| {
        let [a, b, c, d, e, f] = columns[i];
        [a, b, c, d, e, f, row[i]]
    });
    ([a, b, c, d, e, f, left], all)
}

/// Distance of a Jacobian from a singularity: the rest of the last column after it is made square
/// to the others, the longest first (Gram and Schmidt with pivots). Lengths count in parts of
/// `size`. Of an arm with joints to spare only the first `rank` columns count.
pub(super) fn slack<const N: usize>(columns: &[Rows; N], size: f64, rank: usize) -> f64 {
    let mut rest = columns.map(|[x, y, z, a, b, c, d]| [x / size, y / size, z / size, a, b, c, d]);
    let dot = |a: &Rows, b: &Rows| a.iter().zip(b).fold(0.0, |s, (x, y)| s + x * y);
    let mut least = f64::INFINITY;
    for k in 0..rank.min(N) {
        let longer = |best: (usize, f64), (i, c): (usize, &Rows)| {
            let n2 = dot(c, c);
            if n2 > best.1 { (i, n2) } else { best }
        };
        let (at, n2) = rest.iter().enumerate().skip(k).fold((k, 0.0), longer);
        // Without indices that could be out of bounds: no way into a panic.
        let (Some(&pivot), Some(&first)) = (rest.get(at), rest.get(k)) else { break };
        if let Some(place) = rest.get_mut(at) {
            *place = first;
        }
        least = least.min(root(n2));
        for other in rest.iter_mut().skip(k + 1) {
            let f = dot(other, &pivot) / n2.max(1e-300);
            for (x, p) in other.iter_mut().zip(&pivot) {
                *x -= f * p;
            }
        }
    }
    least
}

/// `(J' J + damping) d = J' e` by Cholesky.
pub(super) fn step<const N: usize>(columns: &[Rows; N], e: &Rows, damping: f64) -> [f64; N] {
    let mut a = [[0.0; N]; N];
    let mut b = [0.0; N];
    let dot = |a: &Rows, b: &Rows| a.iter().zip(b).fold(0.0, |s, (x, y)| s + x * y);
    let mut trace = 0.0;
    for i in 0..N {
        for j in 0..=i {
            a[i][j] = dot(&columns[i], &columns[j]);
        }
        b[i] = dot(&columns[i], e);
        trace += a[i][i];
    }
    for i in 0..N {
        a[i][i] += damping * trace + 1e-300;
        for j in 0..=i {
            let mut sum = a[i][j];
            for k in 0..j {
                sum -= a[i][k] * a[j][k];
            }
            if i == j {
                a[i][i] = root(sum).max(1e-150);
            } else {
                a[i][j] = sum / a[j][j];
            }
        }
        for k in 0..i {
            b[i] -= a[i][k] * b[k];
        }
        b[i] /= a[i][i];
    }
    for i in (0..N).rev() {
        for k in i + 1..N {
            b[i] -= a[k][i] * b[k];
        }
        b[i] /= a[i][i];
    }
    b
}

/// `v` moved on by `d`.
pub(super) fn moved<const N: usize>(v: &[Value; N], d: &[f64; N]) -> [Value; N] {
    let (sin, cos) = f64::sin_cos_all(d);
    each(Value::ZERO, |i| {
        let turn = v[i].turn.then(Turn { c: cos[i], s: sin[i] });
        // Keep the length one.
        let k = 1.5 - 0.5 * (turn.c * turn.c + turn.s * turn.s);
        Value { turn: Turn { c: turn.c * k, s: turn.s * k }, way: v[i].way + d[i] }
    })
}

/// Steps until what is left is rounding, or no step helps; a redundant arm keeps its redundancy.
pub(super) fn polish<const N: usize>(
    arm: &Arm<N>,
    g: &Displacement,
    query: &Query<'_, N>,
    v: &mut [Value; N],
    steps: usize,
) -> Twist {
    let size = |e: &Rows| root(e.iter().fold(0.0, |s, x| s + x * x));
    let fine = 2e-15 * (1.0 + norm(g.point(arm.home.shift)));
    let (mut e, mut columns) = equations(arm, g, query, v);
    let mut left = size(&e);
    let mut damping = 1e-15;
    for _ in 0..steps {
        if !(left > fine) {
            break;
        }
        let next = moved(v, &step(&columns, &e, damping));
        let (next_e, next_columns) = equations(arm, g, query, &next);
        let next_left = size(&next_e);
        if next_left < left {
            (*v, e, columns, left) = (next, next_e, next_columns, next_left);
            damping = (damping * 0.01).max(1e-15);
        } else if left < 1e-13 || damping > 1e3 {
            break;
        } else {
            damping = (damping * 100.0).max(1e-10);
        }
    }
    let [x, y, z, a, b, c, _] = e;
    [x, y, z, a, b, c]
}
