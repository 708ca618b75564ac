//! Seven joints with a spherical shoulder, an elbow and a spherical wrist. The swivel angle of the
//! elbow about the line from shoulder to wrist is given (the paper's equation 1; Tolani, Goswami
//! and Badler 2000).

use super::super::runtime::Scalar;
use super::axis::{Axis, Value};
use super::candidates::{Candidates, in_doubt};
use super::orient::Three;
use super::pose::Displacement;
use super::real::{angle, root};
use super::reference::Reference;
use super::solution::Branch;
use super::subproblem::{doubt, reach};
use super::vector::{Matrix, Turn, Vector, add, cross, dot, nearly_unit, norm, scale, sub, times, transposed, unit};

/// Lines and points of the arm at `q = 0`, in world axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Swivel {
    /// Base to tip.
    pub axes: [Axis; 7],
    /// Intersection of axes 1 to 3, m.
    pub shoulder: Vector,
    /// Intersection of axes 3, 4 and 5, m.
    pub elbow: Vector,
    /// Intersection of axes 5 to 7, m.
    pub wrist: Vector,
}

/// The columns of a frame.
type Frame = [Vector; 3];

fn from_to(from: &Frame, to: &Frame) -> Matrix {
    // sum of to_k from_k'
    super::vector::product(&transposed(to), from)
}

/// Quantities of the pose alone: the direction from shoulder to wrist, and for each elbow its angle
/// and the upper arm's frame.
pub(super) struct Elbows {
    pub n: Vector,
    pub both: [(Value, Frame); 2],
    pub stretched: bool,
    pub narrow: bool,
}

impl Swivel {
    /// In the upper arm's frame at `q = 0`: direction to the wrist, and beside it direction to the
    /// elbow, for an angle of joint 4. `per`: the reciprocal of the distance to the wrist, as
    /// computed so far.
    fn upper(&self, v4: Value, per: f64, side: f64) -> (Frame, f64) {
        let to = sub(self.axes[3].point(v4, self.wrist), self.shoulder);
        let w = nearly_unit(scale(per, to));
        let across = cross(self.axes[3].h, w);
        let out = dot(sub(self.elbow, self.shoulder), across);
        let sign = if out.abs() > 1e-15 { out } else { side };
        let e = nearly_unit(scale(if sign < 0.0 { -1.0 } else { 1.0 }, across));
        ([w, e, cross(w, e)], out.abs())
    }

    pub(super) fn elbows(&self, g: &Displacement) -> Elbows {
        let to = sub(g.point(self.wrist), self.shoulder);
        let length2 = dot(to, to);
        let length = root(length2);
        let per = if length > 1e-12 { 1.0 / length } else { 1.0 };
        let n = if length > 1e-12 { scale(per, to) } else { self.axes[0].h };
        let pair = reach(&self.axes[3], self.wrist, self.shoulder, length2);
        let mut stretched = false;
        let mut side = -1.0;
        let least = 1e-8 * norm(sub(self.elbow, self.shoulder));
        let mut one = |t: Turn| {
            side = -side;
            let (frame, out) = self.upper(Value::turn(t), per, side);
            stretched |= out < least;
            (Value::turn(t), frame)
        };
        let both = [one(pair.both[0]), one(pair.both[1])];
        Elbows { n, both, stretched, narrow: pair.narrow }
    }

    /// All answers at a swivel angle (its cosine and sine); true: counted from the second plane.
    #[inline(always)]
    pub(super) fn solve<const N: usize>(
        &self,
        g: &Displacement,
        reference: &Reference,
        (c, s): (f64, f64),
        near: &[Value; N],
        all: &mut Candidates<N>,
    ) -> bool {
        let Elbows { n, both, stretched, narrow } = self.elbows(g);
        let narrow = doubt(narrow);
        let (u, v, second) = reference.plane(n);
        let e = add(scale(c, u), scale(s, v));
        let goal: Frame = [n, e, cross(n, e)];
        let [a1, a2, a3, a4, a5, a6, a7] = &self.axes;
        let near = |j: usize| near.get(j).map_or(Turn::NONE, |v| v.turn);
        let (shoulder, wrist) = (Three::new([a1.h, a2.h, a3.h]), Three::new([a5.h, a6.h, a7.h]));
        let hand = wrist.goal(&g.rotation);
        let sign = |bit: usize| if bit == 0 { 1 } else { -1 };
        for (i, (v4, frame)) in both.iter().enumerate() {
            let upper = from_to(frame, &goal);
            // R(123) = R(G) R(567)' R(4)', from either end.
            let firsts = shoulder.turns(&shoulder.first, &shoulder.goal(&upper), near(0));
            let fore = wrist.carried(|x| times(&upper, a4.direction(*v4, x)));
            let lasts = wrist.turns(&fore, &hand, near(4));
            let at4 = all.value(3, false, *v4);
            let mut name = |first: usize, [a, b, c]: [Turn; 3]| {
                [
                    all.value(first, false, Value::turn(a)),
                    all.value(first + 1, false, Value::turn(b)),
                    all.value(first + 2, false, Value::turn(c)),
                ]
            };
            let at1 = [name(0, firsts[0].0), name(0, firsts[1].0)];
            let at5 = [name(4, lasts[0].0), name(4, lasts[1].0)];
            for (j, (a, (_, f1))) in at1.iter().zip(&firsts).enumerate() {
                for (k, (b, (_, f2))) in at5.iter().zip(&lasts).enumerate() {
                    let branch = Branch { shoulder: sign(j), elbow: sign(i), wrist: sign(k), ..Branch::NONE };
                    let bits = |f: u8| u32::from(f & 3);
                    let free = bits(*f1) | bits(*f2) << 4 | if stretched { 4 } else { 0 };
                    let free = free | in_doubt(f1 | f2 | narrow);
                    let Some(place) = all.push(branch, free) else { continue };
                    for (joint, at) in [a[0], a[1], a[2], at4, b[0], b[1], b[2]].iter().enumerate() {
                        all.set(place, joint, *at);
                    }
                }
            }
        }
        second
    }

    /// Difference of a posture's swivel angle to another one, and its derivatives by the joints. It
    /// is measured by its sine, for which half turns do not count, because the angle jumps by one
    /// where the arm is stretched.
    pub(super) fn left(&self, values: &[Value; 7], reference: &Reference, goal: f64) -> (f64, [f64; 7]) {
        let [a1, a2, a3, a4, ..] = &self.axes;
        let [v1, v2, v3, v4, ..] = *values;
        let to = sub(a4.point(v4, self.wrist), self.shoulder);
        let w = unit(to);
        let carried = |x: Vector| a1.direction(v1, a2.direction(v2, a3.direction(v3, x)));
        let (n, e) = (carried(w), carried(unit(cross(a4.h, w))));
        let (u, v, _) = reference.plane(n);
        let phi = angle(dot(e, v), dot(e, u));
        let ([s], [c]) = f64::sin_cos_all(&[goal - phi]);
        // The plane turns with the line from shoulder to wrist: u stays on the side of b, whichever
        // b that was.
        let b = [reference.b, reference.second].map(|b| (dot(n, b), dot(u, b)));
        let (along, beside) = if dot(reference.b, v).abs() <= 1e-9 * norm(reference.b) { b[0] } else { b[1] };
        let lean = if beside.abs() > 1e-9 { along / beside } else { 0.0 };
        let rate = |h: Vector| c * (dot(h, n) - lean * dot(h, u));
        let way = cross(a4.h, sub(add(to, self.shoulder), a4.c));
        let four = dot(a4.h, cross(to, way)) / dot(to, to).max(1e-30);
        let (h2, h3) = (a1.direction(v1, a2.h), a1.direction(v1, a2.direction(v2, a3.h)));
        (s, [rate(a1.h), rate(h2), rate(h3), four * rate(carried(a4.h)), 0.0, 0.0, 0.0])
    }

    /// Is the arm stretched, so that its elbow is on neither side?
    pub(super) fn straight(&self, values: &[Value; 7]) -> bool {
        self.upper(values[3], 1.0, 1.0).1 < 1e-9 * norm(sub(self.elbow, self.shoulder))
    }

    /// The swivel angle of a posture, rad, and whether it is counted from the second plane.
    pub(super) fn angle(&self, values: &[Value; 7], reference: &Reference) -> (f64, bool) {
        let (frame, _) = self.upper(values[3], 1.0, 1.0);
        let ([a1, a2, a3, ..], [v1, v2, v3, ..]) = (&self.axes, *values);
        let upper = |x: Vector| a1.direction(v1, a2.direction(v2, a3.direction(v3, x)));
        let (n, e) = (upper(frame[0]), upper(frame[1]));
        let (u, v, second) = reference.plane(n);
        (angle(dot(e, v), dot(e, u)), second)
    }
}
