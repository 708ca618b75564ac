//! Quadratic forms in the sine and cosine of one angle, and quartics: Ferrari's solution, then
//! Newton on the form itself.

use super::list::List;
use super::real::root;
use super::vector::Turn;

/// `k[0] + k[1] c + k[2] s + k[3] c c + k[4] c s + k[5] s s`.
pub(super) type Form = [f64; 6];

fn value(k: &Form, t: Turn) -> f64 {
    k[0] + k[1] * t.c + k[2] * t.s + k[3] * t.c * t.c + k[4] * t.c * t.s + k[5] * t.s * t.s
}

fn slope(k: &Form, t: Turn) -> f64 {
    k[2] * t.c - k[1] * t.s + 2.0 * (k[5] - k[3]) * t.c * t.s + k[4] * (t.c * t.c - t.s * t.s)
}

/// The zeros of a form: up to four angles. A pair that lies just beside the real ones counts as
/// double.
pub(super) fn zeros(k: &Form) -> List<Turn, 4> {
    let mut found = List::new(Turn::NONE);
    let size = k.iter().fold(0.0f64, |s, x| s.max(x.abs()));
    if !(size > 0.0) {
        return found;
    }
    let k = k.map(|x| x / size);
    // The angle where the form is largest goes to infinity, so that the leading coefficient is not
    // small.
    const START: [Turn; 6] = [
        Turn { c: 1.0, s: 0.0 },
        Turn { c: 0.5, s: 0.866_025_403_784_438_6 },
        Turn { c: -0.5, s: 0.866_025_403_784_438_6 },
        Turn { c: -1.0, s: 0.0 },
        Turn { c: -0.5, s: -0.866_025_403_784_438_6 },
        Turn { c: 0.5, s: -0.866_025_403_784_438_6 },
    ];
    let far = START.into_iter().fold(START[0], |b, t| if value(&k, t).abs() > value(&k, b).abs() { t } else { b });
    let start = Turn { c: -far.c, s: -far.s };
    // In x = angle - start: cos = c0 c - s0 s, sin = s0 c + c0 s.
    let (c0, s0) = (start.c, start.s);
    let a = [
        k[0],
        k[1] * c0 + k[2] * s0,
        k[2] * c0 - k[1] * s0,
        k[3] * c0 * c0 + k[4] * c0 * s0 + k[5] * s0 * s0,
        2.0 * (k[5] - k[3]) * c0 * s0 + k[4] * (c0 * c0 - s0 * s0),
        k[3] * s0 * s0 - k[4] * c0 * s0 + k[5] * c0 * c0,
    ];
    // c = (1 - t t)/(1 + t t), s = 2 t/(1 + t t).
    let quartic = [
        a[0] + a[1] + a[3],
        2.0 * (a[2] + a[4]),
        2.0 * a[0] - 2.0 * a[3] + 4.0 * a[5],
        2.0 * (a[2] - a[4]),
        a[0] - a[1] + a[3],
    ];
    for &t in roots(&quartic).iter() {
        let d = 1.0 / (1.0 + t * t);
        let mut turn = Turn { c: (1.0 - t * t) * d, s: 2.0 * t * d }.then(start);
        for _ in 0..4 {
            let (f, g) = (value(&k, turn), slope(&k, turn));
            let step = -f / g;
            if !(step.abs() < 0.1) {
                break;
            }
            let next = Turn::along(turn.c - turn.s * step, turn.s + turn.c * step).0;
            if !(value(&k, next).abs() < f.abs()) {
                break;
            }
            turn = next;
        }
        found.push(turn);
    }
    found
}

/// Real roots of `a[0] + a[1] t + .. + a[4] t^4`, those of a pair just beside the real axis too.
pub(super) fn roots(a: &[f64; 5]) -> List<f64, 4> {
    let mut found = List::new(0.0);
    let size = a.iter().fold(0.0f64, |s, x| s.max(x.abs()));
    if !(size > 0.0) {
        return found;
    }
    if !(a[4].abs() > 1e-13 * size) {
        cubic(&[a[0], a[1], a[2], a[3]], size, &mut found);
        return found;
    }
    let [e, d, c, b] = [a[0] / a[4], a[1] / a[4], a[2] / a[4], a[3] / a[4]];
    // t = y - b/4.
    let (h, hh) = (b / 4.0, b * b / 16.0);
    let p = c - 6.0 * hh;
    let q = d - 2.0 * h * c + 8.0 * h * hh;
    let r = e - h * d + hh * c - 3.0 * hh * hh;
    // m^3 + p m^2 + (p p/4 - r) m - q q/8 = 0 has a root that is not negative.
    let m = zero(&[-q * q / 8.0, p * p / 4.0 - r, p], 1.0);
    let s = root(2.0 * m);
    let scale = 1.0 + p.abs() + root(r.abs());
    if s * s <= 1e-13 * scale {
        // q = 0: a quadratic in y y.
        for sign in [1.0, -1.0] {
            let z = -p / 2.0 + sign * root((p * p / 4.0 - r).max(0.0));
            if z > -1e-5 * scale {
                found.push(root(z) - h);
                found.push(-root(z) - h);
            }
        }
    } else {
        // y y - sign s y + (p/2 + m + sign half) = 0: half the difference of the constants is q/(2
        // s). The constants' product is r, which determines it where s is small.
        let half = if m > 1e-4 * scale {
            q / (2.0 * s)
        } else {
            let middle = p / 2.0 + m;
            let sign = if q < 0.0 { -1.0 } else { 1.0 };
            sign * root(middle * middle - r)
        };
        for sign in [1.0, -1.0] {
            let constant = p / 2.0 + m + sign * half;
            let disc = s * s / 4.0 - constant;
            if disc > -1e-5 * scale {
                let w = root(disc);
                found.push(sign * s / 2.0 + w - h);
                found.push(sign * s / 2.0 - w - h);
            }
        }
    }
    for t in found.as_mut_slice() {
        *t = polished(a, *t);
    }
    found
}

fn polished(a: &[f64; 5], mut t: f64) -> f64 {
    let value = |t: f64| (((a[4] * t + a[3]) * t + a[2]) * t + a[1]) * t + a[0];
    for _ in 0..4 {
        let g = ((4.0 * a[4] * t + 3.0 * a[3]) * t + 2.0 * a[2]) * t + a[1];
        let (f, next) = (value(t), t - value(t) / g);
        if !((next - t).abs() < 0.1 * (1.0 + t.abs())) || !(value(next).abs() < f.abs()) {
            break;
        }
        t = next;
    }
    t
}

/// The outermost root that Newton's steps find of `k[0] + k[1] t + k[2] t t + t t t` on one side of
/// zero, where there is one. Steps stay between bounds, because beside a complex pair they jump far
/// off.
fn zero(k: &[f64; 3], side: f64) -> f64 {
    let bound = side * (1.0 + k[0].abs().max(k[1].abs()).max(k[2].abs()));
    // The sign at `outer` is that of `side`, at `inner` the other.
    let (mut inner, mut outer) = (0.0, bound);
    let mut t = bound;
    for _ in 0..120 {
        let f = ((t + k[2]) * t + k[1]) * t + k[0];
        if f * side > 0.0 {
            outer = t;
        } else {
            inner = t;
        }
        let next = t - f / ((3.0 * t + 2.0 * k[2]) * t + k[1]);
        if (next - t).abs() <= 2e-16 * t.abs() {
            break;
        }
        let between = (inner < next && next < outer) || (outer < next && next < inner);
        t = if between { next } else { 0.5 * (inner + outer) };
    }
    t
}

/// Degree three and less.
fn cubic(a: &[f64; 4], size: f64, found: &mut List<f64, 4>) {
    if a[3].abs() > 1e-13 * size {
        let [c, b, d] = [a[0] / a[3], a[1] / a[3], a[2] / a[3]];
        // f(0) = c: there is a root on the other side.
        let t = zero(&[c, b, d], if c > 0.0 { -1.0 } else { 1.0 });
        found.push(t);
        quadratic(&[b + t * (d + t), d + t, 1.0], 1.0, found);
    } else {
        quadratic(&[a[0], a[1], a[2]], size, found);
    }
}

fn quadratic(a: &[f64; 3], size: f64, found: &mut List<f64, 4>) {
    if a[2].abs() > 1e-13 * size {
        let half = -a[1] / (2.0 * a[2]);
        let disc = half * half - a[0] / a[2];
        if disc > -1e-6 * (1.0 + half * half) {
            let w = root(disc);
            found.push(half + w);
            found.push(half - w);
        }
    } else if a[1].abs() > 1e-13 * size {
        found.push(-a[0] / a[1]);
    }
}

/// Angles of two turns with `a[i] . (c1, s1) + k[i] = b[i] . (c2, s2)`, `i = 0, 1` (subproblem 6 of
/// Elias and Wen, 2022).
pub(super) fn two_turns(a: &[[f64; 2]; 2], k: &[f64; 2], b: &[[f64; 2]; 2]) -> List<(Turn, Turn), 4> {
    let mut found = List::new((Turn::NONE, Turn::NONE));
    let det = |m: &[[f64; 2]; 2]| m[0][0] * m[1][1] - m[0][1] * m[1][0];
    let size = |m: &[[f64; 2]; 2]| m.as_flattened().iter().fold(0.0f64, |s, x| s + x * x);
    let (da, db) = (det(a), det(b));
    let (wa, wb) = (da.abs() / size(a).max(1e-300), db.abs() / size(b).max(1e-300));
    if wa.max(wb) > 1e-9 {
        let swap = wa > wb;
        // Solve for `y` in terms of `x`: y = inverse (m x + n).
        let (m, n, inv, d) = if swap { (b, [-k[0], -k[1]], a, da) } else { (a, *k, b, db) };
        let solve =
            |r: [f64; 2]| [(inv[1][1] * r[0] - inv[0][1] * r[1]) / d, (inv[0][0] * r[1] - inv[1][0] * r[0]) / d];
        let (u, v, w) = (solve([m[0][0], m[1][0]]), solve([m[0][1], m[1][1]]), solve(n));
        let dot = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] + a[1] * b[1];
        let form = [dot(w, w) - 1.0, 2.0 * dot(w, u), 2.0 * dot(w, v), dot(u, u), 2.0 * dot(u, v), dot(v, v)];
        for &x in zeros(&form).iter() {
            let y = Turn::along(u[0] * x.c + v[0] * x.s + w[0], u[1] * x.c + v[1] * x.s + w[1]).0;
            found.push(if swap { (y, x) } else { (x, y) });
        }
        return found;
    }
    // Both of rank one: a combination without the second turn, and one for it.
    let longest = |m: &[[f64; 2]; 2]| if dot2(m[0]) >= dot2(m[1]) { m[0] } else { m[1] };
    let direction = longest(b);
    let n2 = dot2(direction).max(1e-300);
    let along = |r: [f64; 2]| (r[0] * direction[0] + r[1] * direction[1]) / n2;
    let (f0, f1) = (along(b[0]), along(b[1]));
    let row = |i: usize| [f1 * a[0][i] - f0 * a[1][i], f0 * a[0][i] + f1 * a[1][i]];
    let ((a0, b0), (a1, b1)) = ((row(0)[0], row(1)[0]), (row(0)[1], row(1)[1]));
    let (k0, k1) = (f1 * k[0] - f0 * k[1], f0 * k[0] + f1 * k[1]);
    let weight = f0 * f0 + f1 * f1;
    for x in super::subproblem::circle(a0, b0, -k0, 1.0).both {
        let d = a1 * x.c + b1 * x.s + k1;
        for y in super::subproblem::circle(weight * direction[0], weight * direction[1], d, 1.0).both {
            found.push((x, y));
        }
    }
    found
}

fn dot2(v: [f64; 2]) -> f64 {
    v[0] * v[0] + v[1] * v[1]
}
