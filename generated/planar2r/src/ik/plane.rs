//! All turning axes parallel: planar arms and SCARAs. At most one joint slides out of the plane.

use super::axis::{Axis, Value};
use super::list::List;
use super::pose::Displacement;
use super::real::root;
use super::solution::Branch;
use super::subproblem::{FREE, NARROW, doubt, reach, towards};
use super::vector::{Turn, Vector, add, beside, dot, norm, scale, sub, times};

/// Three joints in the plane across `h`, and perhaps one that slides out of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plane {
    /// Across the plane.
    pub h: Vector,
    /// The three in the plane, base to tip; one that stays at zero completes an arm with fewer.
    pub axes: [Axis; 3],
    /// Index of each joint in the arm, from 0.
    pub joints: [Option<u8>; 3],
    /// The one out of the plane: its line, which joint it is, and how many of the three stand
    /// before it.
    pub lift: Option<(Axis, u8, u8)>,
}

#[derive(Debug, Clone, Copy)]
pub(super) struct FoundPlane {
    pub values: [Value; 3],
    pub lift: Value,
    pub branch: Branch,
    /// Like that of a place: which of the three are free, and the doubt.
    pub free: u8,
}

type Finds = List<FoundPlane, 2>;

impl Plane {
    /// All answers; where there is none, the nearest ones.
    pub(super) fn solve(&self, g: &Displacement, near: &[Value; 3]) -> Finds {
        let mut finds =
            List::new(FoundPlane { values: [Value::ZERO; 3], lift: Value::ZERO, branch: Branch::NONE, free: 0 });
        let (mut axes, mut goal, mut lift) = (self.axes, *g, Value::ZERO);
        if let Some((axis, _, before)) = self.lift {
            let x = axes[0].c;
            lift = Value::way(dot(self.h, sub(g.point(x), x)) / dot(self.h, axis.h));
            // E1 .. S .. E3 = E1 .. (S E3 S') S.
            let slide = axis.displacement(lift);
            for (k, a) in axes.iter_mut().enumerate() {
                if k >= usize::from(before) {
                    *a = a.carried(&slide);
                }
            }
            goal = g.after(&slide.inverse());
        }
        let side = beside(self.h);
        let (sum, _) = towards(self.h, side, times(&g.rotation, side));
        for (i, (values, free)) in self.turns(&axes, &goal, sum, near).iter().enumerate() {
            let elbow = if i == 0 { 1 } else { -1 };
            finds.push(FoundPlane { values: *values, lift, branch: Branch { elbow, ..Branch::NONE }, free: *free });
        }
        finds
    }

    fn turns(&self, axes: &[Axis; 3], g: &Displacement, sum: Turn, near: &[Value; 3]) -> List<([Value; 3], u8), 2> {
        let mut found = List::new(([Value::ZERO; 3], 0));
        // Information in a direction of length `sqrt(known / size)`, and whether there is any.
        let loose = |joint: u8, known: f64, size: f64| {
            u8::from(!(known > FREE * FREE * size)) << joint | doubt(!(known > NARROW * NARROW * size))
        };
        let [one, two, three] = axes;
        // Angles are counted about each joint's own axis.
        let own = |axis: &Axis, t: Turn| Value::turn(if dot(axis.h, self.h) < 0.0 { t.back() } else { t });
        let common = |axis: &Axis, v: Value| own(axis, v.turn).turn;
        match axes.map(|a| a.slides) {
            [false, false, false] => {
                let goal = g.point(three.c);
                let to = sub(goal, one.c);
                let (upper, fore) = (sub(two.c, one.c), sub(three.c, two.c));
                let size2 = dot(upper, upper) + dot(fore, fore);
                let pair = reach(two, three.c, one.c, dot(to, to));
                for second in pair.both {
                    let second = if pair.blind { near[1] } else { Value::turn(second) };
                    let arm = sub(two.point(second, three.c), one.c);
                    let (first, known) = towards(one.h, arm, to);
                    let first = if known > 1e-26 { Value::turn(first) } else { near[0] };
                    let third = sum.then(common(one, first).back()).then(common(two, second).back());
                    let free = loose(0, known, size2) | u8::from(pair.free) << 1 | doubt(pair.narrow);
                    found.push(([first, second, own(three, third)], free));
                }
            }
            [false, true, false] => {
                // |c3 + h2 t - c1| = |G c3 - c1|
                let to = sub(g.point(three.c), one.c);
                for way in ways(sub(three.c, one.c), two.h, norm(to)) {
                    let arm = sub(two.point(Value::way(way), three.c), one.c);
                    let (first, known) = towards(one.h, arm, to);
                    let first = if known > 1e-26 { Value::turn(first) } else { near[0] };
                    let third = sum.then(common(one, first).back());
                    let free = loose(0, known, dot(three.c, three.c) + dot(one.c, one.c));
                    found.push(([first, Value::way(way), own(three, third)], free));
                }
            }
            [true, false, false] => {
                // E2 c3 = G c3 - h1 t
                let goal = g.point(three.c);
                let length2 = dot(sub(three.c, two.c), sub(three.c, two.c));
                for way in ways(sub(goal, two.c), scale(-1.0, one.h), root(length2)) {
                    let to = sub(one.point(Value::way(-way), goal), two.c);
                    let (second, known) = towards(two.h, sub(three.c, two.c), to);
                    let second = if known > 1e-26 { Value::turn(second) } else { near[1] };
                    let third = sum.then(common(two, second).back());
                    found.push(([Value::way(way), second, own(three, third)], loose(1, known, length2)));
                }
            }
            [false, false, true] => {
                // E2' E1' c1 = E3 G' c1: c1 - h1.. taken from the far end.
                let goal = g.back(one.c);
                let length2 = dot(sub(one.c, two.c), sub(one.c, two.c));
                for way in ways(sub(goal, two.c), three.h, root(length2)) {
                    let to = sub(three.point(Value::way(way), goal), two.c);
                    let (back, known) = towards(two.h, sub(one.c, two.c), to);
                    let second = if known > 1e-26 { Value::turn(back.back()) } else { near[1] };
                    let first = sum.then(common(two, second).back());
                    found.push(([own(one, first), second, Value::way(way)], loose(1, known, length2)));
                }
            }
            slides => {
                // One turn at most, known from the rotation; the slides are linear.
                let mut values = [Value::ZERO; 3];
                for (k, axis) in axes.iter().enumerate() {
                    if !slides[k] {
                        values[k] = own(axis, sum);
                    }
                }
                let start = one.point(values[0], two.point(values[1], three.point(values[2], [0.0; 3])));
                let out = [
                    one.h,
                    one.direction(values[0], two.h),
                    one.direction(values[0], two.direction(values[1], three.h)),
                ];
                let y = sub(g.point([0.0; 3]), start);
                let (i, j) = if !slides[0] {
                    (1, 2)
                } else if !slides[1] {
                    (0, 2)
                } else {
                    (0, 1)
                };
                let c = dot(out[i], out[j]);
                let (yi, yj) = (dot(out[i], y), dot(out[j], y));
                let d = 1.0 - c * c;
                values[i] = Value::way((yi - c * yj) / d);
                values[j] = Value::way((yj - c * yi) / d);
                found.push((values, 0));
            }
        }
        found
    }
}

/// `|x + h t| = length`: the two `t`, or the nearest one twice.
fn ways(x: Vector, h: Vector, length: f64) -> [f64; 2] {
    let along = dot(h, x);
    let across = add(x, scale(-along, h));
    let half = root(length * length - dot(across, across));
    [half - along, -half - along]
}
