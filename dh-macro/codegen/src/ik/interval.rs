//! Where the swivel angle may lie under the joint limits (Shimizu, Kakuya, Yoon, Kitagaki and Kosuge 2008).
//!
//! The upper arm's rotation is `Rot(n, phi) R0`, so that every condition "joint j stands at its limit" reads
//! `a cos phi + b sin phi = d`: two roots in closed form. Between neighbouring roots nothing changes; one look at the middle of
//! each gap tells whether it is allowed.

use super::super::runtime::Scalar;
use super::arm::{Arm, Family, Query, checked, fitted};
use super::axis::Value;
use super::list::List;
use super::orient::Three;
use super::polish;
use super::real::{angle, root};
use super::solution::{Branch, PoseError};
use super::subproblem::circle;
use super::swivel::{Reference, Swivel};
use super::vector::{Matrix, Turn, Vector, cross, dot, norm, product, scale, sub, times, transposed};

/// Allowed swivel angles from `from` to `to`, rad, within `[-pi, pi]`. One that goes on beyond pi is given in two parts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interval {
    /// rad.
    pub from: f64,
    /// rad.
    pub to: f64,
}

/// Allowed intervals of one branch, ascending. Two limits of six joints with two roots each, and eight singular angles, cut the
/// circle at 32 places at most.
pub type Intervals = List<Interval, 34>;

/// What does not change with the swivel angle.
struct Pencil<'a> {
    swivel: &'a Swivel,
    /// From shoulder to wrist.
    n: Vector,
    /// The upper arm's rotation at swivel angle zero.
    upper: Matrix,
    /// `R0 R4`: where the forearm's axes are at zero.
    fore: Matrix,
    hand: Matrix,
    v4: Value,
    shoulder: usize,
    wrist: usize,
}

impl Pencil<'_> {
    /// Joints 1 to 7 at a swivel angle.
    fn at(&self, phi: Turn) -> [Value; 7] {
        let a = &self.swivel.axes;
        let upper = |x: Vector| phi.about(self.n, times(&self.upper, x));
        let (shoulder, wrist) = (Three::new([a[0].h, a[1].h, a[2].h]), Three::new([a[4].h, a[5].h, a[6].h]));
        let [_, y, z] = shoulder.last.map(upper);
        let first = shoulder.turns(&shoulder.first, &[cross(y, z), y, z], Turn::NONE);
        let fore = wrist.carried(|x| upper(a[3].direction(self.v4, x)));
        let last = wrist.turns(&fore, &wrist.goal(&self.hand), Turn::NONE);
        let (first, last) = (first[self.shoulder & 1].0, last[self.wrist & 1].0);
        [
            Value::turn(first[0]),
            Value::turn(first[1]),
            Value::turn(first[2]),
            self.v4,
            Value::turn(last[0]),
            Value::turn(last[1]),
            Value::turn(last[2]),
        ]
    }

    /// Adds the roots of `a . Rot(n, phi) b = d`.
    fn roots(&self, a: Vector, b: Vector, d: f64, cuts: &mut List<f64, 34>) {
        let along = dot(self.n, b);
        let across = sub(b, scale(along, self.n));
        let (ca, sa) = (dot(a, across), dot(a, cross(self.n, b)));
        let d = d - along * dot(a, self.n);
        let r = root(ca * ca + sa * sa);
        // A limit that is never reached cuts nothing; one that is touched cuts where it is touched.
        if !(r > 1e-12) || d.abs() > r * (1.0 + 1e-12) {
            return;
        }
        for t in circle(ca, sa, d, 1.0).both {
            cuts.push(angle(t.s, t.c));
        }
    }
}

impl<const N: usize> Arm<N> {
    /// All swivel angles at which a branch reaches the pose within the limits; `None` for an arm without a swivel angle. Of an arm
    /// that is only nearly of the family: those of the nominal arm.
    ///
    /// # Errors
    /// Like [`Arm::solve`].
    pub fn swivel_intervals(
        &self,
        pose: &[[f64; 4]; 3],
        branch: Branch,
        reference: &Reference,
    ) -> Result<Option<Intervals>, PoseError> {
        let g = checked(pose)?.after(&self.home.inverse());
        let Family::Swivel(swivel) = &self.family else { return Ok(None) };
        let mut found: Intervals = List::new(Interval { from: 0.0, to: 0.0 });
        let limit = |j: usize| self.limits.get(j).copied().flatten();
        let elbows = swivel.elbows(&g);
        let index = |sign: i8| usize::from(sign < 0);
        let [plus, minus] = elbows.both;
        let (v4, frame) = if branch.elbow < 0 { minus } else { plus };
        let wrist_at = swivel.axes[3].point(v4, swivel.wrist);
        let to = norm(sub(g.point(swivel.wrist), swivel.shoulder));
        let off = norm(sub(wrist_at, swivel.shoulder)) - to;
        let q4 = angle(v4.turn.s, v4.turn.c);
        // Out of reach, or the elbow beyond its limit whatever the swivel angle.
        if !(off.abs() < 1e-9) || fitted(q4, false, limit(3), None).1 < -1e-9 {
            return Ok(Some(found));
        }
        let (u, v, _) = reference.plane(elbows.n);
        let zero = [elbows.n, u, v];
        let upper = product(&transposed(&zero), &frame);
        let a = &swivel.axes;
        let columns = super::vector::IDENTITY.map(|e| times(&upper, v4.turn.about(a[3].h, e)));
        let pencil = Pencil {
            swivel,
            n: elbows.n,
            upper,
            fore: transposed(&columns),
            hand: g.rotation,
            v4,
            shoulder: index(branch.shoulder),
            wrist: index(branch.wrist),
        };
        let mut cuts: List<f64, 34> = List::new(0.0);
        cuts.push(-core::f64::consts::PI);
        cuts.push(core::f64::consts::PI);
        for (three, base) in [([a[0].h, a[1].h, a[2].h], 0usize), ([a[4].h, a[5].h, a[6].h], 4)] {
            // x . R(three) y = d, where R is the upper arm's rotation, or the hand's against the forearm.
            let mut cut = |x: Vector, y: Vector, d: f64| {
                if base == 0 {
                    pencil.roots(x, times(&pencil.upper, y), d, &mut cuts);
                } else {
                    pencil.roots(times(&pencil.hand, y), times(&pencil.fore, x), d, &mut cuts);
                }
            };
            let [h1, h2, h3] = three;
            for k in 0..3 {
                let Some(both) = limit(base + k) else { continue };
                let ([s0, s1], [c0, c1]) = f64::sin_cos_all(&both);
                for t in [Turn { c: c0, s: s0 }, Turn { c: c1, s: s1 }] {
                    match k {
                        0 => cut(t.about(h1, h2), h3, dot(h2, h3)),
                        1 => cut(h1, h3, dot(h1, t.about(h2, h3))),
                        _ => cut(h1, t.back().about(h3, h2), dot(h1, h2)),
                    }
                }
            }
            // Where the middle joint is singular its neighbours jump.
            let (c, s) = (dot(h1, h2) * dot(h2, h3), norm(cross(h1, h2)) * norm(cross(h2, h3)));
            cut(h1, h3, c - s);
            cut(h1, h3, c + s);
        }
        let cuts = cuts.as_mut_slice();
        for i in 1..cuts.len() {
            for j in (1..=i).rev() {
                let (Some(x), Some(y)) = (cuts.get(j - 1), cuts.get(j)) else { break };
                if x <= y {
                    break;
                }
                cuts.swap(j - 1, j);
            }
        }
        for pair in cuts.windows(2) {
            let &[from, to] = pair else { continue };
            if to - from < 1e-12 {
                continue;
            }
            let ([s], [c]) = f64::sin_cos_all(&[0.5 * (from + to)]);
            let values = pencil.at(Turn { c, s });
            let allowed = values
                .iter()
                .enumerate()
                .all(|(j, v)| fitted(angle(v.turn.s, v.turn.c), false, limit(j), None).1 >= 0.0);
            if !allowed {
                continue;
            }
            match found.as_mut_slice().last_mut() {
                Some(last) if from - last.to < 1e-12 => last.to = to,
                _ => {
                    found.push(Interval { from, to });
                }
            }
        }
        Ok(Some(found))
    }

    /// The swivel angle at which a branch stays farthest from its limits, and that distance, rad; `None` where no angle is allowed
    /// or the arm has none. Sixteen looks at each interval, then golden sections.
    ///
    /// # Errors
    /// Like [`Arm::solve`].
    pub fn best_swivel(
        &self,
        pose: &[[f64; 4]; 3],
        branch: Branch,
        reference: &Reference,
    ) -> Result<Option<(f64, f64)>, PoseError> {
        const GOLDEN: f64 = 0.618_033_988_749_894_9;
        let Some(intervals) = self.swivel_intervals(pose, branch, reference)? else { return Ok(None) };
        let mut best: Option<(f64, f64)> = None;
        let margin = |phi: f64| {
            let query = Query { redundancy: phi, reference: *reference, ..Query::default() };
            let found = self.solve(pose, &query);
            found
                .ok()
                .and_then(|s| s.as_slice().iter().find(|s| s.branch == branch).map(|s| s.margin))
                .unwrap_or(f64::NEG_INFINITY)
        };
        for interval in intervals.iter() {
            let width = (interval.to - interval.from) / 16.0;
            let (mut at, mut most) = (interval.from, f64::NEG_INFINITY);
            for k in 0..16 {
                let phi = interval.from + width * (f64::from(k) + 0.5);
                let m = margin(phi);
                if m > most {
                    (at, most) = (phi, m);
                }
            }
            let (mut low, mut high) = ((at - width).max(interval.from), (at + width).min(interval.to));
            for _ in 0..40 {
                let (x, y) = (high - GOLDEN * (high - low), low + GOLDEN * (high - low));
                if margin(x) > margin(y) { high = y } else { low = x }
            }
            let middle = 0.5 * (low + high);
            let m = margin(middle);
            if m > most {
                (at, most) = (middle, m);
            }
            if best.is_none_or(|(_, b)| most > b) && most > f64::NEG_INFINITY {
                best = Some((at, most));
            }
        }
        Ok(best)
    }

    /// How fast the swivel angle turns when the joints do, rad/s; zero for an arm without one. Central differences along `dq`.
    pub fn swivel_velocity(&self, q: &[f64; N], dq: &[f64; N], reference: &Reference) -> f64 {
        let Family::Swivel(swivel) = &self.family else { return 0.0 };
        let size = dq.iter().fold(0.0f64, |m, x| m.max(x.abs()));
        if !(size > 0.0) {
            return 0.0;
        }
        let step = 1e-5 / size;
        let at = |k: f64| {
            let q: [f64; N] = core::array::from_fn(|i| q[i] + k * dq[i]);
            let values = polish::values(self, &q);
            let seven = core::array::from_fn(|i| values.get(i).copied().unwrap_or(Value::ZERO));
            swivel.angle(&seven, reference).0
        };
        let difference = |k: f64| super::real::wrapped(at(k) - at(-k)) / (2.0 * k);
        // Richardson: the error is of the fourth order.
        (4.0 * difference(step) - difference(2.0 * step)) / 3.0
    }
}
