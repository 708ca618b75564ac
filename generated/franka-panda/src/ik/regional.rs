//! Three joints that bring a point to a place: `E1 E2 E3 w = p` (Pieper 1968).

use super::axis::{Axis, Value, turns};
use super::list::{List, each};
use super::quartic::{roots, two_turns, zeros};
use super::real::root;
use super::subproblem::{DOUBT, FREE, NARROW, circle, doubt, reach, tilt, towards};
use super::vector::{Turn, Vector, add, cross, dot, norm, scale, sub, transposed_times, unit};

/// How the three joints are taken apart. A mirrored one is taken from its far end: `E3' E2' E1' p =
/// w`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Regional {
    /// Two turns about axes that meet in `at`, then any joint.
    Meet {
        /// From the far end.
        mirrored: bool,
        /// Intersection, m.
        at: Vector,
    },
    /// Two turns about parallel axes, then any joint.
    Parallel {
        /// From the far end.
        mirrored: bool,
    },
    /// Two turns about any axes, then any joint: a quartic.
    General {
        /// From the far end.
        mirrored: bool,
    },
    /// Turn, slide, turn: a quartic, or less.
    TurnSlideTurn,
    /// Turn, slide, slide.
    TurnSlides {
        /// From the far end.
        mirrored: bool,
    },
    /// Slide, turn, slide.
    SlideTurnSlide,
    /// Three slides.
    Slides,
}

/// One answer: three joints, and which branch (bit 0: first choice, bit 1: second) or root it is.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place {
    pub values: [Value; 3],
    pub branch: u8,
    /// Bit `j`: joint `j` is free; bit 7: [`DOUBT`].
    pub free: u8,
}

pub(super) type Places = List<Place, 4>;

const NOWHERE: Place = Place { values: [Value::ZERO; 3], branch: 0, free: 0 };

/// All answers; where there is none, the nearest ones. `near`: values for joints that are free.
#[inline(always)]
pub(super) fn solve(kind: &Regional, axes: &[Axis; 3], w: Vector, p: Vector, near: &[Value; 3]) -> Places {
    let mirrored = match *kind {
        Regional::Meet { mirrored, .. }
        | Regional::Parallel { mirrored }
        | Regional::General { mirrored }
        | Regional::TurnSlides { mirrored } => mirrored,
        _ => false,
    };
    if !mirrored {
        return forward(kind, axes, w, p, near);
    }
    let back = [axes[2].reversed(), axes[1].reversed(), axes[0].reversed()];
    let mut places = forward(kind, &back, p, w, &[near[2], near[1], near[0]]);
    for place in places.as_mut_slice() {
        // A reversed axis undoes by the same value.
        place.values = [place.values[2], place.values[1], place.values[0]];
        place.free = (place.free >> 2) & 1 | place.free & 2 | (place.free & 1) << 2 | place.free & DOUBT;
    }
    places
}

#[inline(always)]
fn forward(kind: &Regional, axes: &[Axis; 3], w: Vector, p: Vector, near: &[Value; 3]) -> Places {
    match *kind {
        Regional::Meet { at, .. } => meet(axes, at, w, p, near),
        Regional::Parallel { .. } => parallel(axes, w, p, near),
        Regional::General { .. } => general(axes, w, p, near),
        Regional::TurnSlideTurn => turn_slide_turn(axes, w, p),
        Regional::TurnSlides { .. } => turn_slides(axes, w, p, near),
        Regional::SlideTurnSlide => slide_turn_slide(axes, w, p, near),
        Regional::Slides => slides(axes, w, p),
    }
}

/// The turn about the first axis, or what it is to be where it is free (bit 0; bit 7: nearly).
fn first_turn(axis: &Axis, from: Vector, to: Vector, near: Value) -> (Value, u8) {
    let (from, to) = (sub(from, axis.c), sub(to, axis.c));
    let (turn, known) = towards(axis.h, from, to);
    // Squares, which need no root.
    let (known, size) = (known * known, dot(from, from) * dot(to, to));
    let below = |sine: f64| known < sine * sine * (sine * sine) * size;
    if known > 1e-52 * size.max(1e-40) {
        (Value::turn(turn), u8::from(below(FREE)) | doubt(below(NARROW)))
    } else {
        (near, 1 | DOUBT)
    }
}

#[inline(always)]
fn meet([one, two, three]: &[Axis; 3], x: Vector, w: Vector, p: Vector, near: &[Value; 3]) -> Places {
    let mut places = List::new(NOWHERE);
    let to = sub(p, x);
    let length2 = dot(to, to);
    let mut free = 0;
    let thirds = if three.slides {
        let d = sub(w, x);
        let along = dot(three.h, d);
        let across = sub(d, scale(along, three.h));
        let half = root(length2 - dot(across, across));
        free |= doubt(half < NARROW * root(length2));
        [Value::way(half - along), Value::way(-half - along)]
    } else {
        let pair = reach(three, w, x, length2);
        free |= u8::from(pair.free) << 2 | doubt(pair.narrow);
        if pair.blind { [near[2]; 2] } else { turns(pair.both) }
    };
    for (i, &third) in thirds.iter().enumerate() {
        let arm = sub(three.point(third, w), x);
        let pair = tilt(one.h, two.h, arm, to);
        let seconds = if pair.blind { [near[1]; 2] } else { turns(pair.both) };
        for (j, &second) in seconds.iter().enumerate() {
            let from = add(x, second.turn.about(two.h, arm));
            let (first, loose) = first_turn(one, from, p, near[0]);
            let free = free | loose | u8::from(pair.free) << 1 | doubt(pair.narrow);
            places.push(Place { values: [first, second, third], branch: (i | j << 1) as u8, free });
        }
    }
    places
}

#[inline(always)]
fn parallel([one, two, three]: &[Axis; 3], w: Vector, p: Vector, near: &[Value; 3]) -> Places {
    let mut places = List::new(NOWHERE);
    let mut free = 0;
    let h = one.h;
    let thirds = if three.slides {
        [Value::way((dot(h, p) - dot(h, w)) / dot(h, three.h)); 2]
    } else {
        let rel = sub(w, three.c);
        let along = scale(dot(three.h, rel), three.h);
        let across = sub(rel, along);
        let d = dot(h, sub(p, add(three.c, along)));
        let pair = circle(dot(h, across), dot(h, cross(three.h, across)), d, norm(rel));
        free |= u8::from(pair.free) << 2 | doubt(pair.narrow);
        if pair.blind { [near[2]; 2] } else { turns(pair.both) }
    };
    let to = sub(p, one.c);
    let (to2, flat) = (dot(to, to), sub(to, scale(dot(h, to), h)));
    // Away from the first axis, both ends of the planar arm are as far from it: one division for
    // all answers.
    let flat2 = dot(flat, flat);
    let apart = flat2 > 1e-4 * to2.max(1e-16);
    let per = if apart { 1.0 / flat2 } else { 0.0 };
    for (i, &third) in thirds.iter().enumerate() {
        if three.slides && i == 1 {
            break;
        }
        let arm = three.point(third, w);
        let pair = reach(two, arm, one.c, to2);
        let seconds = if pair.blind { [near[1]; 2] } else { turns(pair.both) };
        for (j, &second) in seconds.iter().enumerate() {
            let end = two.point(second, arm);
            let (first, loose) = if apart {
                let from = sub(end, one.c);
                let (c, s) = (dot(from, flat), dot(h, cross(from, flat)));
                (Value::turn(Turn { c: c * per, s: s * per }), 0)
            } else {
                first_turn(one, end, p, near[0])
            };
            let free = free | loose | u8::from(pair.free) << 1 | doubt(pair.narrow);
            places.push(Place { values: [first, second, third], branch: (i | j << 1) as u8, free });
        }
    }
    places
}

/// Feet of the common normal on two lines, and its direction.
pub(super) fn normal(one: &Axis, two: &Axis) -> (Vector, Vector, Vector) {
    let n = cross(one.h, two.h);
    let n2 = dot(n, n);
    let d = sub(two.c, one.c);
    if !(n2 > 1e-24) {
        let across = sub(d, scale(dot(one.h, d), one.h));
        return (one.c, add(one.c, across), unit(across));
    }
    let s = dot(cross(d, two.h), n) / n2;
    let t = dot(cross(d, one.h), n) / n2;
    let (f1, f2) = (add(one.c, scale(s, one.h)), add(two.c, scale(t, two.h)));
    let gap = dot(d, n);
    (f1, f2, scale(if gap < 0.0 { -1.0 } else { 1.0 } / root(n2), n))
}

fn general([one, two, three]: &[Axis; 3], w: Vector, p: Vector, near: &[Value; 3]) -> Places {
    let mut places = List::new(NOWHERE);
    let (o1, o2, x) = normal(one, two);
    let a = dot(sub(o2, o1), x);
    let y = cross(two.h, x);
    let (cosine, sine) = (dot(one.h, two.h), dot(one.h, y));
    let to = sub(p, o1);
    let (to2, height) = (dot(to, to), dot(one.h, to));
    // r = E3 w - o2: constant, then parts of the third joint's cosine and sine, or of its way.
    let rel = sub(w, three.c);
    let along = scale(dot(three.h, rel), three.h);
    let (r0, r1, r2) = if three.slides {
        (sub(w, o2), three.h, [0.0; 3])
    } else {
        (sub(add(three.c, along), o2), sub(rel, along), cross(three.h, rel))
    };
    // X = x . R2 r and Y = y . R2 r, each linear in the unknowns; X X + Y Y = r r - (h2 r)^2.
    let m = [dot(two.h, r0), dot(two.h, r1), dot(two.h, r2)];
    let rr = if three.slides { dot(r0, r0) } else { dot(r0, r0) + dot(r1, r1) };
    let k = [rr, 2.0 * dot(r0, r1), 2.0 * dot(r0, r2)];
    let big_y = [(height - cosine * m[0]) / sine, -cosine * m[1] / sine, -cosine * m[2] / sine];
    let mut thirds: List<Value, 4> = List::new(Value::ZERO);
    if three.slides {
        // r r = k0 + k1 t + t t.
        let big_x = [(to2 - a * a - k[0]) / (2.0 * a), -k[1] / (2.0 * a), -1.0 / (2.0 * a)];
        let q = [
            big_x[0] * big_x[0] + big_y[0] * big_y[0] - k[0] + m[0] * m[0],
            2.0 * (big_x[0] * big_x[1] + big_y[0] * big_y[1]) - k[1] + 2.0 * m[0] * m[1],
            2.0 * big_x[0] * big_x[2] + big_x[1] * big_x[1] + big_y[1] * big_y[1] - 1.0 + m[1] * m[1],
            2.0 * big_x[1] * big_x[2],
            big_x[2] * big_x[2],
        ];
        for &t in roots(&q).iter() {
            thirds.push(Value::way(t));
        }
    } else {
        let big_x = [(to2 - a * a - k[0]) / (2.0 * a), -k[1] / (2.0 * a), -k[2] / (2.0 * a)];
        let square = |v: &[f64; 3]| {
            [v[0] * v[0], 2.0 * v[0] * v[1], 2.0 * v[0] * v[2], v[1] * v[1], 2.0 * v[1] * v[2], v[2] * v[2]]
        };
        let (sx, sy, sm) = (square(&big_x), square(&big_y), square(&m));
        let mut form: [f64; 6] = each(0.0, |i| sx[i] + sy[i] + sm[i]);
        (form[0], form[1], form[2]) = (form[0] - k[0], form[1] - k[1], form[2] - k[2]);
        for &t in zeros(&form).iter() {
            thirds.push(Value::turn(t));
        }
    }
    for (i, &third) in thirds.iter().enumerate() {
        let r = sub(three.point(third, w), o2);
        let big_x = (to2 - a * a - dot(r, r)) / (2.0 * a);
        let big_y = (height - cosine * dot(two.h, r)) / sine;
        let goal = add(scale(big_x, x), scale(big_y, y));
        let (turn, known) = towards(two.h, r, goal);
        let second = if known > 1e-26 { Value::turn(turn) } else { near[1] };
        let from = add(o2, second.turn.about(two.h, r));
        let (first, loose) = first_turn(one, from, p, near[0]);
        let free = loose | doubt(!(known > NARROW * NARROW * dot(r, r)));
        places.push(Place { values: [first, second, third], branch: i as u8, free });
    }
    double_roots(&mut places, 2);
    places
}

/// `R1' (p - c1) + c1 = E3 w + h2 t`: the slide has no part across itself.
fn turn_slide_turn([one, two, three]: &[Axis; 3], w: Vector, p: Vector) -> Places {
    let mut places = List::new(NOWHERE);
    let (rel1, rel3) = (sub(p, one.c), sub(w, three.c));
    let b0 = super::vector::beside(two.h);
    let across = [b0, cross(two.h, b0)];
    let part = |h: Vector, r: Vector, b: Vector| {
        let along = dot(h, r);
        [dot(b, r) - dot(b, h) * along, dot(b, cross(h, r)), dot(b, h) * along]
    };
    let (mut a, mut k, mut m) = ([[0.0; 2]; 2], [0.0; 2], [[0.0; 2]; 2]);
    for i in 0..2 {
        let [c1, s1, k1] = part(one.h, rel1, across[i]);
        let [c3, s3, k3] = part(three.h, rel3, across[i]);
        a[i] = [c1, -s1]; // the first turn is undone
        m[i] = [c3, s3];
        k[i] = k1 - k3 + dot(across[i], sub(one.c, three.c));
    }
    for (i, &(first, third)) in two_turns(&a, &k, &m).iter().enumerate() {
        let (first, third) = (Value::turn(first), Value::turn(third));
        let way = dot(two.h, sub(one.point(first.back(), p), three.point(third, w)));
        places.push(Place { values: [first, Value::way(way), third], branch: i as u8, free: 0 });
    }
    double_roots(&mut places, 0);
    places
}

/// Roots of a quartic that lie close together in joint `j` are known to fewer digits.
fn double_roots(places: &mut Places, j: usize) {
    let close = |a: &Place, b: &Place| {
        let ([a0, a1, a2], [b0, b1, b2]) = (a.values, b.values);
        let (a, b) = match j {
            0 => (a0, b0),
            1 => (a1, b1),
            _ => (a2, b2),
        };
        let d = (a.turn.c - b.turn.c).abs() + (a.turn.s - b.turn.s).abs() + (a.way - b.way).abs();
        d < 10.0 * NARROW
    };
    for i in 0..places.len() {
        let own = places.as_slice().get(i).copied();
        let twin = |k: usize| places.as_slice().get(k).zip(own).is_some_and(|(b, a)| k != i && close(&a, b));
        let narrow = (0..places.len()).any(twin);
        if let Some(place) = places.as_mut_slice().get_mut(i) {
            place.free |= doubt(narrow);
        }
    }
}

/// `y = a s + b t` in the sense of least squares.
fn two_ways(a: Vector, b: Vector, y: Vector) -> (f64, f64) {
    let (c, ya, yb) = (dot(a, b), dot(a, y), dot(b, y));
    let d = 1.0 - c * c;
    ((ya - c * yb) / d, (yb - c * ya) / d)
}

fn turn_slides([one, two, three]: &[Axis; 3], w: Vector, p: Vector, near: &[Value; 3]) -> Places {
    let mut places = List::new(NOWHERE);
    let m = unit(cross(two.h, three.h));
    let rel = sub(p, one.c);
    let along = dot(one.h, rel);
    let across = sub(rel, scale(along, one.h));
    let d = dot(m, sub(w, add(one.c, scale(along, one.h))));
    let pair = circle(dot(m, across), -dot(m, cross(one.h, across)), d, norm(rel));
    let both = if pair.blind { [near[0]; 2] } else { turns(pair.both) };
    for (i, &first) in both.iter().enumerate() {
        let (s, t) = two_ways(two.h, three.h, sub(one.point(first.back(), p), w));
        let values = [first, Value::way(s), Value::way(t)];
        places.push(Place { values, branch: i as u8, free: u8::from(pair.free) | doubt(pair.narrow) });
    }
    places
}

fn slide_turn_slide([one, two, three]: &[Axis; 3], w: Vector, p: Vector, near: &[Value; 3]) -> Places {
    let mut places = List::new(NOWHERE);
    // (p - c2) - R2 (w - c2) lies in the plane of h1 and R2 h3: R2 h3 . (r x h1) = h1 . R2 (h3 x
    // w).
    let (r, w2) = (sub(p, two.c), sub(w, two.c));
    let (m, n) = (cross(r, one.h), cross(three.h, w2));
    let part = |b: Vector, v: Vector| {
        let along = dot(two.h, v);
        [dot(b, v) - dot(b, two.h) * along, dot(b, cross(two.h, v)), dot(b, two.h) * along]
    };
    let (f, g) = (part(m, three.h), part(one.h, n));
    let pair = circle(f[0] - g[0], f[1] - g[1], g[2] - f[2], norm(m) + norm(n));
    let both = if pair.blind { [near[1]; 2] } else { turns(pair.both) };
    for (i, &second) in both.iter().enumerate() {
        let out = second.turn.about(two.h, three.h);
        let (s, t) = two_ways(one.h, out, sub(p, two.point(second, w)));
        let values = [Value::way(s), second, Value::way(t)];
        places.push(Place { values, branch: i as u8, free: u8::from(pair.free) << 1 | doubt(pair.narrow) });
    }
    places
}

fn slides([one, two, three]: &[Axis; 3], w: Vector, p: Vector) -> Places {
    let mut places = List::new(NOWHERE);
    let rows = [cross(two.h, three.h), cross(three.h, one.h), cross(one.h, two.h)];
    let volume = dot(one.h, rows[0]);
    let columns = super::vector::transposed(&rows);
    let ways = transposed_times(&columns, sub(p, w)).map(|x| Value::way(x / volume));
    places.push(Place { values: ways, branch: 0, free: 0 });
    places
}
