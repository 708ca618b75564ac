//! Six joints: a spherical wrist behind three joints of any kind (Pieper 1968), or three parallel
//! axes in the middle.
//!
//! An arm with fewer joints is completed by joints that stay at zero; one with its sphere at the
//! shoulder is solved from its tip: `E1 .. E6 = G` is `E6' .. E1' = G'`.

use super::axis::{Axis, Value, turns};
use super::candidates::{Candidates, in_doubt};
use super::list::List;
use super::orient::Three;
use super::pose::Displacement;
use super::quartic::two_turns;
use super::regional::{self, Regional};
use super::solution::Branch;
use super::subproblem::{DOUBT, FREE, NARROW, Reach, across, circle, doubt, reach, tilt, towards};
use super::vector::{Turn, Vector, beside, cross, dot, norm, scale, sub, times};

/// How six joints are taken apart.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Method {
    /// Axes 4, 5 and 6 meet.
    Wrist {
        /// Position, m.
        center: Vector,
        /// The first three.
        regional: Regional,
    },
    /// Axes 2, 3 and 4 are parallel.
    ThreeParallel {
        /// Intersection of axes 5 and 6, if there is one, m.
        meet: Option<Vector>,
    },
}

/// Six joints with their lines.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Six {
    /// In the order in which they are solved, lines already reversed where the arm is.
    pub axes: [Axis; 6],
    /// Index of each joint in the arm, from 0; `None`: one that stays at zero.
    pub joints: [Option<u8>; 6],
    /// From the tip?
    pub reversed: bool,
    /// How.
    pub method: Method,
}

/// Of three parallel axes: what is known before them.
#[derive(Clone, Copy)]
struct Start {
    /// The name of joint 1 among its values.
    at: u8,
    fifth: Value,
    sixth: Value,
    /// The turn of the three axes together.
    sum: Turn,
    /// Required position of axis 4, seen from axis 2, m.
    to: Vector,
    /// Of the two roots; from 4: which zero of a quartic.
    signs: [u8; 2],
    free: u8,
}

impl Start {
    const NONE: Self =
        Self { at: 0, fifth: Value::ZERO, sixth: Value::ZERO, sum: Turn::NONE, to: [0.0; 3], signs: [0; 2], free: 0 };
}

/// Destination of the solutions of six joints: the columns of the arm's own joints.
struct Into<'a, const N: usize> {
    six: &'a Six,
    all: &'a mut Candidates<N>,
}

impl<const N: usize> Into<'_, N> {
    #[inline(always)]
    fn value(&mut self, k: usize, v: Value) -> u8 {
        match self.six.joints.get(k) {
            Some(&Some(j)) => self.all.value(usize::from(j), self.six.axes[k].slides, v),
            _ => 0,
        }
    }

    #[inline(always)]
    fn push(&mut self, at: [u8; 6], branch: Branch, free: u8) {
        let mut bits = in_doubt(free);
        if free & !DOUBT != 0 {
            for (k, j) in self.six.joints.iter().enumerate() {
                if let Some(j) = j {
                    bits |= u32::from(free >> k & 1) << (u32::from(*j) & 31);
                }
            }
        }
        let Some(place) = self.all.push(branch, bits) else { return };
        for (at, j) in at.iter().zip(&self.six.joints) {
            if let Some(j) = j {
                self.all.set(place, usize::from(*j), *at);
            }
        }
    }
}

impl Six {
    /// All answers of `E1 .. E6 = g` of the arm, the joints that are not among the six at the first
    /// values of their columns; where there is none, the nearest ones.
    #[inline(always)]
    pub(super) fn solve<const N: usize>(&self, g: &Displacement, near: &[Value; N], all: &mut Candidates<N>) {
        let near = self.near(near);
        let inverse;
        let g = if self.reversed {
            inverse = g.inverse();
            &inverse
        } else {
            g
        };
        let mut into = Into { six: self, all };
        match &self.method {
            Method::Wrist { center, regional } => self.wrist(g, *center, regional, &near, &mut into),
            Method::ThreeParallel { meet } => self.three_parallel(g, *meet, &near, &mut into),
        }
    }

    #[inline(always)]
    fn wrist<const N: usize>(
        &self,
        g: &Displacement,
        center: Vector,
        regional: &Regional,
        near: &[Value; 6],
        into: &mut Into<'_, N>,
    ) {
        let [one, two, three, four, five, six] = &self.axes;
        let places =
            regional::solve(regional, &[*one, *two, *three], center, g.point(center), &[near[0], near[1], near[2]]);
        let wrist = Three::new([four.h, five.h, six.h]);
        let goal = wrist.goal(&g.rotation);
        // Remainder of the goal after joint 1, and its value's name: often the same for two places.
        let (mut last, mut y1, mut z1, mut a) = (Value::way(f64::NAN), goal[1], goal[2], 0);
        for place in places.iter() {
            let [v1, v2, v3] = place.values;
            if v1 != last {
                (last, y1, z1) = (v1, one.direction(v1.back(), goal[1]), one.direction(v1.back(), goal[2]));
                a = into.value(0, v1);
            }
            let (y2, z2) = (two.direction(v2.back(), y1), two.direction(v2.back(), z1));
            let (y, z) = (three.direction(v3.back(), y2), three.direction(v3.back(), z2));
            let (b, c) = (into.value(1, v2), into.value(2, v3));
            let both = wrist.turns(&wrist.first, &[cross(y, z), y, z], near[3].turn);
            for (i, ([v4, v5, v6], free)) in both.iter().enumerate() {
                let [v4, v5, v6] = [Value::turn(*v4), Value::turn(*v5), Value::turn(*v6)];
                let at = [a, b, c, into.value(3, v4), into.value(4, v5), into.value(5, v6)];
                let branch = Branch::of_wrist(regional, place.branch, i as u8, self.reversed);
                into.push(at, branch, place.free | (free & 3) << 3 | free & DOUBT);
            }
        }
    }

    /// The part that the three parallel axes leave alone gives joints 1 and 5; then they are a
    /// planar arm.
    #[inline(always)]
    fn three_parallel<const N: usize>(
        &self,
        g: &Displacement,
        meet: Option<Vector>,
        near: &[Value; 6],
        into: &mut Into<'_, N>,
    ) {
        let [one, two, three, four, five, six] = &self.axes;
        let h = two.h;
        let mut starts: List<Start, 4> = List::new(Start::NONE);
        if let Some(x) = meet {
            let there = g.point(x);
            let rel = sub(there, one.c);
            let along = scale(dot(one.h, rel), one.h);
            let pair = circle(
                dot(h, sub(rel, along)),
                -dot(h, cross(one.h, rel)),
                dot(h, sub(sub(x, one.c), along)),
                norm(rel),
            );
            let free = u8::from(pair.free) | doubt(pair.narrow);
            let firsts = if pair.blind { [near[0]; 2] } else { turns(pair.both) };
            let wrist = Three::new([h, five.h, six.h]);
            let goal = wrist.goal(&g.rotation);
            for (i, &first) in firsts.iter().enumerate() {
                let at = into.value(0, first);
                if wrist.is_square() {
                    // Euler angles: the turn of the three, joints 5 and 6, which leave `x` alone.
                    let carried = |k: usize| one.direction(first.back(), goal[k]);
                    let image = [carried(0), carried(1), carried(2)];
                    let both = wrist.turns(&wrist.first, &image, Turn::NONE);
                    if both[0].1 == 0 {
                        let hand = sub(one.point(first.back(), there), two.c);
                        for (j, ([sum, fifth, sixth], _)) in both.iter().enumerate() {
                            starts.push(Start {
                                at,
                                fifth: Value::turn(*fifth),
                                sixth: Value::turn(*sixth),
                                sum: *sum,
                                to: sub(hand, two.spun(*sum, sub(x, four.c))),
                                signs: [i as u8, j as u8],
                                free,
                            });
                        }
                        continue;
                    }
                }
                let fifths = tilt(h, five.h, six.h, one.direction(first.back(), goal[2]));
                for (j, &fifth) in fifths.both.iter().enumerate() {
                    let free = free | doubt(fifths.narrow);
                    let known = [first, Value::turn(fifth)];
                    starts.push(self.start(g, known, at, [i as u8, j as u8], free, near));
                }
            }
        } else {
            let part = |b: Vector, a: Vector, r: Vector| {
                let along = dot(a, r);
                ([dot(b, r) - dot(b, a) * along, dot(b, cross(a, r))], dot(b, a) * along)
            };
            let goal6 = times(&g.rotation, six.h);
            let (p1, k1) = part(h, one.h, sub(g.point(six.c), one.c));
            let (d1, l1) = part(h, one.h, goal6);
            let (p5, k5) = part(h, five.h, sub(six.c, five.c));
            let (d5, l5) = part(h, five.h, six.h);
            let a = [[p1[0], -p1[1]], [d1[0], -d1[1]]];
            let k = [k1 + dot(h, one.c) - k5 - dot(h, five.c), l1 - l5];
            let roots = two_turns(&a, &k, &[p5, d5]);
            for (i, &(first, fifth)) in roots.iter().enumerate() {
                let own = Value::turn(first);
                let at = into.value(0, own);
                // Roots of a quartic that lie close together are known to fewer digits.
                let close = |t: Turn| (t.c - first.c).abs() + (t.s - first.s).abs() < 10.0 * NARROW;
                let narrow = roots.iter().enumerate().any(|(k, (t, _))| k != i && close(*t));
                starts.push(self.start(g, [own, Value::turn(fifth)], at, [i as u8 | 4, 0], doubt(narrow), near));
            }
        }
        let elbow = Reach::new(three, four.c, two.c);
        for start in starts.iter() {
            let &Start { to, sum, signs: [shoulder, wrist], .. } = start;
            let to2 = dot(to, to);
            let pair = elbow.at(to2);
            // Both ends of the planar arm are as far from axis 2: one division for both answers.
            let flat = sub(to, scale(dot(h, to), h));
            let flat2 = dot(flat, flat);
            let apart = flat2 > 1e-26;
            let per = if apart { 1.0 / flat2 } else { 0.0 };
            let size2 = to2.max(1e-6);
            let free = start.free
                | if flat2 > FREE * FREE * size2 { 0 } else { 2 }
                | if pair.free { 4 } else { 0 }
                | doubt(pair.narrow || flat2 < NARROW * NARROW * size2);
            let ends = [into.value(4, start.fifth), into.value(5, start.sixth)];
            for (j, &third) in pair.both.iter().enumerate() {
                let arm = sub(three.point(Value::turn(third), four.c), two.c);
                let second = if apart {
                    let (c, s) = (dot(arm, flat), dot(h, cross(arm, flat)));
                    Turn { c: c * per, s: s * per }
                } else {
                    near[1].turn
                };
                let same = |axis: &Axis, t: Turn| if dot(axis.h, h) < 0.0 { t.back() } else { t };
                let fourth = sum.then(second.back()).then(same(three, third).back());
                let at = [
                    start.at,
                    into.value(1, Value::turn(second)),
                    into.value(2, Value::turn(third)),
                    into.value(3, Value::turn(same(four, fourth))),
                    ends[0],
                    ends[1],
                ];
                into.push(at, Branch::of_three_parallel(shoulder, j as u8, wrist, self.reversed), free);
            }
        }
    }

    /// Joint 6 and the turn of the three parallel axes from joints 1 and 5, with any angle between
    /// the axes.
    #[inline(never)]
    fn start(
        &self,
        g: &Displacement,
        [v1, v5]: [Value; 2],
        at: u8,
        signs: [u8; 2],
        doubtful: u8,
        near: &[Value; 6],
    ) -> Start {
        let [one, two, _, four, five, six] = &self.axes;
        let h = two.h;
        let mut free = doubtful;
        let side = beside(six.h);
        let back = |x: Vector| one.direction(v1.back(), times(&g.rotation, x));
        let (goal, image) = (back(six.h), back(side));
        let (turn, known) = towards(h, five.direction(v5, six.h), goal);
        let seen = known > 1e-28;
        let (mut sum, mut v6) = if seen {
            let back = five.direction(v5.back(), turn.back().about(h, image));
            (turn, Value::turn(across(six.h, side, back)))
        } else {
            (Turn::NONE, near[5])
        };
        if known < FREE * FREE {
            free |= 32 | DOUBT;
            // Rounding turns it too, perhaps to where the planar arm does not reach.
            let within = self.last_within_reach(g, v1, v5, v6, seen);
            if !seen || within != v6 {
                v6 = within;
                let carried = |x: Vector| v5.turn.about(five.h, v6.turn.about(six.h, x));
                let other = cross(six.h, side);
                // The better seen of two directions across axis 6.
                let (a, na) = towards(h, carried(side), image);
                let (b, nb) = towards(h, carried(other), back(other));
                sum = if na >= nb { a } else { b };
            }
        }
        let four_at = six.point(v6.back(), five.point(v5.back(), four.c));
        let to = sub(one.point(v1.back(), g.point(four_at)), two.c);
        free |= doubt(known < NARROW * NARROW);
        Start { at, fifth: v5, sixth: v6, sum, to, signs, free }
    }

    /// Axis 6 is parallel to the three: its turn is free as far as the planar arm still reaches.
    /// The near one; else, where that one was `seen` in the pose, the nearest, or one in the middle
    /// of what it reaches.
    fn last_within_reach(&self, g: &Displacement, v1: Value, v5: Value, near: Value, seen: bool) -> Value {
        let [one, two, three, four, five, six] = &self.axes;
        let h = two.h;
        let across = |x: Vector| norm(sub(x, scale(dot(h, x), h)));
        let (upper, fore) = (across(sub(three.c, two.c)), across(sub(four.c, three.c)));
        let (least, most) = ((upper - fore).abs(), upper + fore);
        let hand = five.point(v5.back(), four.c);
        let there = |x: Vector| across(sub(one.point(v1.back(), g.point(x)), two.c));
        let now = there(six.point(near.back(), hand));
        if now > least && now < most {
            return near;
        }
        // Distances from the hand's side: it turns about axis 6 at `radius`, and the axis stands
        // `away` from axis 2.
        let rel = sub(hand, six.c);
        let radius = norm(sub(rel, scale(dot(six.h, rel), six.h)));
        let away = there(six.c);
        let (low, high) = (least.max((away - radius).abs()), most.min(away + radius));
        let goal = match (seen, now <= least) {
            (false, _) => 0.5 * (low + high),
            (true, true) => low,
            (true, false) => high,
        };
        let shoulder = g.back(one.point(v1, two.c));
        let lift = dot(six.h, sub(hand, shoulder));
        let [a, b] = reach(&six.reversed(), hand, shoulder, goal * goal + lift * lift).both;
        let like = |t: Turn| t.c * near.turn.c + t.s * near.turn.s;
        let mut turn = if seen && like(b) > like(a) { b } else { a };
        // That was about axis 6; decisive is the distance across the plane, and the two differ by
        // their angle.
        let distance = |t: Turn| there(six.point(Value::turn(t.back()), hand));
        let by = |t: Turn, angle: f64| t.then(Turn::along(1.0, angle).0);
        for _ in 0..3 {
            let slope = (distance(by(turn, 1e-4)) - distance(by(turn, -1e-4))) / 2e-4;
            let step = (goal - distance(turn)) / slope;
            if !(step.abs() < 1e-2) {
                break;
            }
            turn = by(turn, step);
        }
        Value::turn(turn)
    }

    /// Fills the joints of an arm; those of a reversed one have the same values.
    pub(super) fn near<const N: usize>(&self, near: &[Value; N]) -> [Value; 6] {
        let mut own = [Value::ZERO; 6];
        for (own, joint) in own.iter_mut().zip(&self.joints) {
            if let Some(v) = joint.and_then(|j| near.get(usize::from(j))) {
                *own = *v;
            }
        }
        own
    }
}
