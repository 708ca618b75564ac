//! Intervals of the swivel angle under the joint limits (Shimizu, Kakuya, Yoon, Kitagaki and Kosuge
//! 2008).
//!
//! The upper arm's rotation is `Rot(n, phi) R0`, so every condition "joint j stands at its limit"
//! reads `a cos phi + b sin phi = d`. It has two roots in closed form. Between neighbouring roots
//! nothing changes, so one test at the middle of each gap decides whether it is allowed.

use super::super::runtime::Scalar;
use super::arm::{Arm, Family, checked, fitted};
use super::axis::Value;
use super::list::List;
use super::orient::Three;
use super::polish;
use super::pose::Displacement;
use super::real::{angle, angles};
use super::reference::Reference;
use super::solution::{Branch, PoseError};
use super::subproblem::circle;
use super::swivel::Swivel;
use super::vector::{Matrix, Turn, Vector, cross, dot, norm, product, scale, sub, times, transposed};

/// Allowed swivel angles from `from` to `to`, rad, within `[-pi, pi]`. One that goes on beyond pi
/// is given in two parts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interval {
    /// rad.
    pub from: f64,
    /// rad.
    pub to: f64,
}

/// Allowed intervals of one branch, ascending. Two limits of six joints with two roots each, and
/// eight singular angles, cut the circle at 32 places at most.
pub type Intervals = List<Interval, 33>;

/// `P + Q cos phi + W sin phi`: what a turn by `phi` makes of products of vectors.
struct Turning([Matrix; 3]);

impl Turning {
    /// Of `x_i . Rot(n, phi) y_j`.
    fn new(n: Vector, x: &[Vector; 3], y: &[Vector; 3]) -> Self {
        let along = y.map(|y| scale(dot(n, y), n));
        let part = |y: [Vector; 3]| x.map(|x| y.map(|y| dot(x, y)));
        let across = [0, 1, 2].map(|k: usize| sub(y[k], along[k]));
        Self([part(along), part(across), part(y.map(|y| cross(n, y)))])
    }

    #[inline(always)]
    fn at(&self, phi: Turn) -> Matrix {
        let [p, q, w] = &self.0;
        core::array::from_fn(|i| core::array::from_fn(|j| p[i][j] + phi.c * q[i][j] + phi.s * w[i][j]))
    }
}

/// One branch of a pose, its swivel angle left open.
struct Pencil {
    shoulder: Three,
    wrist: Three,
    /// Interval of the swivel angle that results from the two.
    first: Turning,
    last: Turning,
    /// From shoulder to wrist.
    n: Vector,
    /// The upper arm's rotation at swivel angle zero.
    upper: Matrix,
    /// The same times joint 4's: where the forearm's axes are at zero.
    fore: Matrix,
    hand: Matrix,
    v4: Value,
    /// Signs of the branch.
    signs: [bool; 2],
}

impl Pencil {
    /// Of a pose and a branch; `None` where the pose is out of reach.
    fn new(swivel: &Swivel, g: &Displacement, branch: Branch, reference: &Reference) -> Option<Self> {
        let elbows = swivel.elbows(g);
        let [plus, minus] = elbows.both;
        let (v4, frame) = if branch.elbow < 0 { minus } else { plus };
        let wrist_at = swivel.axes[3].point(v4, swivel.wrist);
        let to = norm(sub(g.point(swivel.wrist), swivel.shoulder));
        if !((norm(sub(wrist_at, swivel.shoulder)) - to).abs() < 1e-9) {
            return None;
        }
        let n = elbows.n;
        let (u, v, _) = reference.plane(n);
        let upper = product(&transposed(&[n, u, v]), &frame);
        let a = &swivel.axes;
        let columns = super::vector::IDENTITY.map(|e| times(&upper, a[3].direction(v4, e)));
        let (shoulder, wrist) = (Three::new([a[0].h, a[1].h, a[2].h]), Three::new([a[4].h, a[5].h, a[6].h]));
        let first = Turning::new(n, &shoulder.first, &shoulder.goal(&upper));
        // x . y' with x turned: y' . x the other way round.
        let Turning(last) =
            Turning::new(n, &wrist.goal(&g.rotation), &wrist.carried(|x| times(&upper, a[3].direction(v4, x))));
        let last = Turning(last.map(|m| transposed(&m)));
        let signs = [branch.shoulder < 0, branch.wrist < 0];
        Some(Self { shoulder, wrist, first, last, n, upper, fore: transposed(&columns), hand: g.rotation, v4, signs })
    }

    /// Joints 1 to 3 and 5 to 7 at a swivel angle.
    #[inline(always)]
    fn at(&self, phi: Turn) -> [Turn; 6] {
        let [a, b] = self.signs;
        let first = self.shoulder.between(&self.first.at(phi), Turn::NONE);
        let last = self.wrist.between(&self.last.at(phi), Turn::NONE);
        let ([f0, f1], [l0, l1]) = (first, last);
        let ([x, y, z], [u, v, w]) = (if a { f1.0 } else { f0.0 }, if b { l1.0 } else { l0.0 });
        [x, y, z, u, v, w]
    }

    /// Adds the roots of `a . Rot(n, phi) b = d`.
    fn roots(&self, a: Vector, b: Vector, d: f64, cuts: &mut Cuts) {
        let along = dot(self.n, b);
        let across = sub(b, scale(along, self.n));
        let (ca, sa) = (dot(a, across), dot(a, cross(self.n, b)));
        let d = d - along * dot(a, self.n);
        let r2 = ca * ca + sa * sa;
        // A limit that is never reached cuts nothing; one that is touched cuts where it is touched.
        if !(r2 > 1e-24) || d * d > r2 * (1.0 + 2e-12) {
            return;
        }
        for t in circle(ca, sa, d, 1.0).both {
            cuts.push(t);
        }
    }
}

/// Directions at which the circle is cut.
struct Cuts {
    c: [f64; MOST],
    s: [f64; MOST],
    len: usize,
}

/// Two limits of six joints and four singular angles, two roots each; a multiple of four.
const MOST: usize = 32;

impl Cuts {
    #[inline(always)]
    fn push(&mut self, t: Turn) {
        let at = self.len & (MOST - 1);
        (self.c[at], self.s[at]) = (t.c, t.s);
        self.len = at + 1;
    }
}

/// A joint's limits as an arc: the direction of its middle, and the cosine of half its width;
/// allowed are directions that are not farther from the middle.
#[derive(Clone, Copy)]
struct Arc {
    middle: Turn,
    cosine: f64,
    /// The two ends; none where every direction is allowed.
    ends: Option<[Turn; 2]>,
}

impl Arc {
    fn all(limits: [Option<[f64; 2]>; 6]) -> [Self; 6] {
        let both = limits.map(|l| l.unwrap_or([-4.0, 4.0]));
        let middles = both.map(|[low, high]| 0.5 * (low + high));
        let halves = both.map(|[low, high]| 0.5 * (high - low));
        let ((ms, mc), (hs, hc)) = (f64::sin_cos_all(&middles), f64::sin_cos_all(&halves));
        core::array::from_fn(|k| {
            let (middle, half) = (Turn { c: mc[k], s: ms[k] }, Turn { c: hc[k], s: hs[k] });
            if halves[k] >= core::f64::consts::PI {
                return Self { middle, cosine: -2.0, ends: None };
            }
            // No direction at all where the limits are the wrong way round.
            let cosine = if halves[k] < 0.0 { 2.0 } else { half.c };
            Self { middle, cosine, ends: Some([middle.then(half.back()), middle.then(half)]) }
        })
    }

    #[inline(always)]
    fn allows(&self, t: Turn) -> bool {
        t.c * self.middle.c + t.s * self.middle.s >= self.cosine
    }
}

impl<const N: usize> Arm<N> {
    /// All swivel angles at which a branch reaches the pose within the limits; `None` for an arm
    /// without a swivel angle. Of an arm that is only nearly of the family: those of the nominal
    /// arm.
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
        Ok(Some(match Pencil::new(swivel, &g, branch, reference) {
            Some(pencil) => self.intervals(&pencil),
            None => List::new(Interval { from: 0.0, to: 0.0 }),
        }))
    }

    fn intervals(&self, pencil: &Pencil) -> Intervals {
        let mut found: Intervals = List::new(Interval { from: 0.0, to: 0.0 });
        let limit = |j: usize| self.limits.get(j).copied().flatten();
        // The elbow beyond its limit, whatever the swivel angle.
        if fitted(angle(pencil.v4.turn.s, pencil.v4.turn.c), false, limit(3), None).1 < -1e-9 {
            return found;
        }
        let arcs = Arc::all([0, 1, 2, 4, 5, 6].map(limit));
        let mut cuts = Cuts { c: [0.0; MOST], s: [0.0; MOST], len: 0 };
        for (three, base) in [(&pencil.shoulder, 0usize), (&pencil.wrist, 3)] {
            // x . R(three) y = d; R rotates the upper arm, or the hand against the forearm.
            let mut cut = |x: Vector, y: Vector, d: f64| {
                if base == 0 {
                    pencil.roots(x, times(&pencil.upper, y), d, &mut cuts);
                } else {
                    pencil.roots(times(&pencil.hand, y), times(&pencil.fore, x), d, &mut cuts);
                }
            };
            let [h1, h2, h3] = three.h;
            for k in 0..3 {
                let Some(ends) = arcs.get(base + k).and_then(|a| a.ends) else { continue };
                for t in ends {
                    match k {
                        0 => cut(t.about(h1, h2), h3, dot(h2, h3)),
                        1 => cut(h1, h3, dot(h1, t.about(h2, h3))),
                        _ => cut(h1, t.back().about(h3, h2), dot(h1, h2)),
                    }
                }
            }
            // At a singularity of the middle joint its neighbours jump.
            let (c, s) = (dot(h1, h2) * dot(h2, h3), norm(cross(h1, h2)) * norm(cross(h2, h3)));
            cut(h1, h3, c - s);
            cut(h1, h3, c + s);
        }
        // -pi, the cuts, pi.
        const BOUNDS: usize = MOST + 2;
        let mut bounds = [core::f64::consts::PI; BOUNDS];
        let phi = angles(&cuts.s, &cuts.c, cuts.len);
        bounds[0] = -core::f64::consts::PI;
        for (k, x) in phi.into_iter().take(cuts.len).enumerate() {
            // By insertion: a library sort has a way into a panic.
            let mut at = k + 1;
            while let (Some(&before), true) = (bounds.get(at.wrapping_sub(1)), at > 1) {
                if before <= x {
                    break;
                }
                if let Some(place) = bounds.get_mut(at) {
                    *place = before;
                }
                at -= 1;
            }
            if let Some(place) = bounds.get_mut(at) {
                *place = x;
            }
        }
        let middles: [f64; MOST + 1] = core::array::from_fn(|k| 0.5 * (bounds[k] + bounds[k + 1]));
        let (sin, cos) = f64::sin_cos_all(&middles);
        for k in 0..=cuts.len.min(MOST) {
            let (from, to) = (bounds[k], bounds[k + 1]);
            if to - from < 1e-12 {
                continue;
            }
            let turns = pencil.at(Turn { c: cos[k], s: sin[k] });
            if !turns.iter().zip(&arcs).fold(true, |all, (t, arc)| all & arc.allows(*t)) {
                continue;
            }
            match found.as_mut_slice().last_mut() {
                Some(last) if from - last.to < 1e-12 => last.to = to,
                _ => {
                    found.push(Interval { from, to });
                }
            }
        }
        found
    }

    /// The swivel angle at which a branch stays farthest from its limits, and that distance, rad;
    /// `None` where no angle is allowed or the arm has none. Sixteen looks at each interval, then
    /// golden sections.
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
        let g = checked(pose)?.after(&self.home.inverse());
        let Family::Swivel(swivel) = &self.family else { return Ok(None) };
        let Some(pencil) = Pencil::new(swivel, &g, branch, reference) else { return Ok(None) };
        let intervals = self.intervals(&pencil);
        let mut best: Option<(f64, f64)> = None;
        let limit = |j: usize| self.limits.get(j).copied().flatten();
        let elbow = fitted(angle(pencil.v4.turn.s, pencil.v4.turn.c), false, limit(3), None).1;
        let margin = |phi: f64| {
            let ([s], [c]) = f64::sin_cos_all(&[phi]);
            let turns = pencil.at(Turn { c, s });
            let q = angles(&pad(turns.map(|t| t.s)), &pad(turns.map(|t| t.c)), 6);
            [0, 1, 2, 4, 5, 6].iter().zip(q).fold(elbow, |m, (j, q)| m.min(fitted(q, false, limit(*j), None).1))
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

    /// How fast the swivel angle turns when the joints do, rad/s; zero for an arm without one.
    /// Central differences along `dq`.
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

fn pad(six: [f64; 6]) -> [f64; 8] {
    let [a, b, c, d, e, f] = six;
    [a, b, c, d, e, f, 1.0, 1.0]
}
