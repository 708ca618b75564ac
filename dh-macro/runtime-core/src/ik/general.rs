//! Any six joints, of which most turn: up to sixteen postures, from the roots of a polynomial of
//! degree sixteen in one angle, each refined. With two joints that slide it has degree eight, with
//! three there are two postures, in closed form. Ways count in parts of the arm's size.
//!
//! Which joint is hidden, and which side eliminated, does not matter in theory. In practice one
//! choice may be singular for an arm's geometry and another for a pose, so there is an order of
//! them. The next is tried where a root did not lead to a posture of its own.

use super::super::runtime::Scalar;
use super::arm::{Arm, Query};
use super::axis::{Axis, Value};
use super::candidates::Candidates;
use super::elimination::{Elimination, Loop, Posture, last};
use super::harmonics::{Complex, DEGREE, ROOTS, Roots, SAMPLES, angles, roots};
use super::list::List;
use super::newton::{linear, newton, twin};
use super::pose::Displacement;
use super::slides::{self, Slides};
use super::solution::{Branch, CAPACITY};
use super::vector::{Turn, add, norm, scale, sub, unit};

/// Choices that are kept.
pub const CHOICES: usize = 6;

/// Six joints in general position.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct General {
    /// Lines in order, all `q` zero; the points are near the middle of the arm.
    pub axes: [Axis; 6],
    /// Whose they are.
    pub joints: [u8; 6],
    /// Of an arm with seven joints: the one that is given.
    pub locked: Option<u8>,
    /// Length that counts as one, m.
    pub size: f64,
    /// Twice the hidden joint, one more where the side with the pose is eliminated; best first,
    /// [`NO_CHOICE`] after the last.
    pub order: [u8; CHOICES],
}

/// In place of a choice: there are no more.
pub const NO_CHOICE: u8 = 255;

/// A posture that misses its pose by less, rad and parts of the size, is one of it.
const NAMED: f64 = 1e-9;
/// Postures are the same if no turn differs by more.
const SAME: f64 = 1e-8;
/// A posture that is nearer to a singularity has its twin looked for.
const NARROW: f64 = 0.02;
/// Where joints are looked at that might be free.
const NEAR_SINGULAR: f64 = 1e-3;
/// Where a posture counts as singular: another may have merged with it.
const SINGULAR: f64 = 1e-5;
/// What is left of a pose when Newton's steps have ended, rad and parts of the size.
const DONE: f64 = 1e-12;
/// A root that is farther from the unit circle is not real, whatever the noise.
const BESIDE: f64 = 3e-2;
/// Samples with more noise, parts of the largest coefficient, say nothing.
const LOUD: f64 = 1e-6;
/// Nearer roots, rad, are taken together.
const CLOSE: f64 = 1e-7;
/// A root that is nearer to the unit circle may be real: half of a pair that has just merged.
const BARELY: f64 = 1e-5;
/// Roots that are not known better, rad, say nothing.
const WIDEST: f64 = 0.03;
/// How far a posture may be from its root, rad, beyond the root's own error.
const FAR_OFF: f64 = 1e-5;
/// How far a pose beside is turned and shifted, rad and parts of the size.
const AWAY: [f64; 4] = [1e-3, -1e-3, 1e-5, -1e-5];

/// What was found so far.
struct Found {
    /// Positions in the joints' own order, and how far from a singularity.
    list: List<(Posture, f64), CAPACITY>,
    /// Nearest miss, for a pose out of reach.
    best: Option<(f64, Posture)>,
}

impl Found {
    /// The posture's place, new or known.
    fn keep(&mut self, posture: &Posture, slack: f64) -> Option<usize> {
        let far = |other: &Posture| {
            let mut most = 0.0f64;
            for (a, b) in other.iter().zip(posture) {
                most = most.max((a.turn.c - b.turn.c).abs() + (a.turn.s - b.turn.s).abs() + (a.way - b.way).abs());
            }
            most
        };
        if let Some(at) = self.list.iter().position(|(other, _)| far(other) < SAME) {
            return Some(at);
        }
        let at = self.list.len();
        self.list.push((*posture, slack)).then_some(at)
    }
}

impl General {
    /// All postures of `g`, the product of the joints, into `all`.
    #[inline(never)]
    pub(super) fn solve<const N: usize>(
        &self,
        arm: &Arm<N>,
        g: &Displacement,
        query: &Query<'_, N>,
        all: &mut Candidates<N>,
    ) {
        let (axes, target, locked) = self.unlocked(arm, g, query);
        let mut found = Found { list: List::new(([Value::ZERO; 6], 0.0)), best: None };
        if let Some(near) = query.near {
            self.named(&axes, &target, near, &mut found);
        }
        all.unsure = !self.gather(&axes, &target, &mut found);
        let slides = |j: usize| arm.axes.get(j).is_some_and(|a| a.slides);
        let whole = |six: &Posture| {
            let mut values = [Value::ZERO; N];
            let long = |v: &Value| Value { way: v.way * self.size, ..*v };
            let own = self.joints.iter().zip(six).map(|(j, v)| (usize::from(*j), long(v)));
            for (joint, value) in own.chain(locked) {
                if let Some(place) = values.get_mut(joint) {
                    *place = value;
                }
            }
            values
        };
        for (k, (six, slack)) in found.list.iter().enumerate() {
            let values = whole(six);
            let mut free = 0;
            if *slack < NEAR_SINGULAR {
                free = arm.freedom(g, query, &values);
                all.unsure |= *slack < SINGULAR;
            }
            all.push_all(&values, slides, Branch { root: k as u8 + 1, ..Branch::NONE }, free);
        }
        if all.len == 0 {
            let six = found.best.map_or([Value::ZERO; 6], |(_, six)| six);
            all.push_all(&whole(&six), slides, Branch { root: 1, ..Branch::NONE }, 0);
        }
    }

    /// The posture that was named as near, if it reaches the pose: of a family of postures it is the
    /// one that is wanted, and there is room for it.
    #[inline(never)]
    fn named(&self, axes: &[Axis; 6], g: &Displacement, near: &[f64], found: &mut Found) {
        let mut q = [0.0; 6];
        for (q, joint) in q.iter_mut().zip(self.joints) {
            *q = near.get(usize::from(joint)).copied().unwrap_or(0.0);
        }
        let posture = self.posture(axes, &q);
        let round = Loop::new(axes, g, 0, self.size);
        let (_, left) = linear(&round, &posture);
        if left < NAMED {
            self.refine(&round, posture, 0, found);
        }
    }

    /// From positions, rad or m.
    fn posture(&self, axes: &[Axis; 6], q: &[f64; 6]) -> Posture {
        let (sin, cos) = f64::sin_cos_all(q);
        let mut posture = [Value::ZERO; 6];
        for (k, (v, axis)) in posture.iter_mut().zip(axes).enumerate() {
            *v = if axis.slides { Value::way(q[k] / self.size) } else { Value::turn(Turn { c: cos[k], s: sin[k] }) };
        }
        posture
    }

    /// Of an arm with seven joints: the other six behind the locked one, and its value.
    fn unlocked<const N: usize>(
        &self,
        arm: &Arm<N>,
        g: &Displacement,
        query: &Query<'_, N>,
    ) -> ([Axis; 6], Displacement, Option<(usize, Value)>) {
        let lock = self.locked.map_or(N, usize::from);
        let Some(axis) = arm.axes.get(lock) else { return (self.axes, *g, None) };
        let ([s], [c]) = f64::sin_cos_all(&[query.redundancy]);
        let value = if axis.slides { Value::way(query.redundancy) } else { Value::turn(Turn { c, s }) };
        let moved = axis.displacement(value);
        let mut axes = self.axes;
        for (axis, joint) in axes.iter_mut().zip(self.joints) {
            if usize::from(joint) > lock {
                *axis = axis.carried(&moved);
            }
        }
        (axes, g.after(&moved.inverse()), Some((lock, value)))
    }

    /// Choice by choice, until one has a posture of its own for each of its roots. True: that is
    /// all of them.
    fn gather(&self, axes: &[Axis; 6], g: &Displacement, found: &mut Found) -> bool {
        // The last axis is no farther from the first than all distances between them together.
        let ways = axes.iter().zip(axes.iter().skip(1)).map(|(a, b)| norm(sub(b.c, a.c)));
        let [first, .., last] = axes;
        let slides = axes.iter().any(|a| a.slides);
        if !slides && norm(sub(g.point(last.c), first.c)) > 1e-9 * self.size + ways.sum::<f64>() {
            return true;
        }
        for choice in self.order {
            if choice == NO_CHOICE {
                break;
            }
            if self.attempt(axes, g, choice, found) && found.list.len().is_multiple_of(2) {
                return true;
            }
        }
        self.beside(axes, g, found)
    }

    /// Where roots lie together, the matrix has more than one kernel, and none leads to a posture.
    /// At a pose beside they are apart, and its postures are near.
    #[cold]
    #[inline(never)]
    fn beside(&self, axes: &[Axis; 6], g: &Displacement, found: &mut Found) -> bool {
        let round = Loop::new(axes, g, 0, self.size);
        for (k, way) in AWAY.into_iter().enumerate() {
            let [x, y, z] = [[0.6, -0.5, 0.62], [-0.7, 0.66, 0.3], [0.2, 0.75, -0.63], [0.5, 0.1, 0.86]][k % 4];
            let turn = Axis { slides: false, h: unit([x, y, z]), c: g.shift };
            let mut other = turn.displacement(Value::turn(Turn::along(1.0, way).0)).after(g);
            other.shift = add(other.shift, scale(way * self.size, [y, -z, x]));
            let mut there = Found { list: List::new(([Value::ZERO; 6], 0.0)), best: None };
            for choice in self.order.into_iter().filter(|choice| *choice != NO_CHOICE) {
                if self.attempt(axes, &other, choice, &mut there) && there.list.len().is_multiple_of(2) {
                    break;
                }
            }
            for (posture, _) in there.list.iter() {
                self.refine(&round, *posture, 0, found);
            }
        }
        for choice in self.order.into_iter().filter(|choice| *choice != NO_CHOICE) {
            if found.list.len().is_multiple_of(2) && self.attempt(axes, g, choice, found) {
                return true;
            }
        }
        false
    }

    /// One choice: adds postures; true if each root has its own.
    fn attempt(&self, axes: &[Axis; 6], g: &Displacement, choice: u8, found: &mut Found) -> bool {
        let pose_side = choice % 2 == 1;
        let hidden = usize::from(choice / 2);
        let round = Loop::new(axes, g, hidden, self.size);
        if let Some(slides) = Slides::new(&round) {
            return self.turns_first(&slides, &round, hidden, found);
        }
        let system = Elimination::new(&round, pose_side);
        let mut known = polynomial(|q| system.determinant(q), DEGREE);
        known.refine(|z| system.derivative(z));
        if !(known.noise < LOUD && system.regular > 1e-9) {
            return false;
        }
        let hopeless = found.list.is_empty();
        for z in known.z.iter().take(known.len) {
            if let Some(q) = tried(*z, hopeless && found.list.is_empty()) {
                self.refine(&round, start(&system, &round, q, pose_side), hidden, found);
            }
        }
        matched(&known, hidden, found)
    }

    /// The same of two or three joints that slide.
    fn turns_first(&self, slides: &Slides<'_>, round: &Loop, hidden: usize, found: &mut Found) -> bool {
        if !slides.hides() {
            for sign in [1.0, -1.0] {
                self.refine(round, slides.posture(Turn::NONE, sign), hidden, found);
            }
            return true;
        }
        let known = polynomial(|q| slides.polynomial(q), slides::DEGREE);
        if !(known.noise < LOUD) {
            return false;
        }
        let hopeless = found.list.is_empty();
        for z in known.z.iter().take(known.len) {
            if let Some(q) = tried(*z, hopeless && found.list.is_empty()) {
                for sign in [1.0, -1.0] {
                    self.refine(round, slides.posture(q, sign), hidden, found);
                }
            }
        }
        matched(&known, hidden, found)
    }

    /// Newton's steps, there and across a singularity nearby.
    fn refine(&self, round: &Loop, mut posture: Posture, hidden: usize, found: &mut Found) {
        let (left, slack) = newton(round, &mut posture);
        let own = back_in_order(&posture, hidden);
        if !(left < DONE) {
            if found.best.is_none_or(|(least, _)| left < least) {
                found.best = Some((left, own));
            }
            return;
        }
        found.keep(&own, slack);
        if slack < NARROW
            && let Some(mut twin) = twin(round, &posture)
        {
            let (left, slack) = newton(round, &mut twin);
            if left < DONE {
                found.keep(&back_in_order(&twin, hidden), slack);
            }
        }
    }

    /// How far the polynomial's nearest root is from a posture's hidden angle, rad; `None` where
    /// this choice alone does not lead to the posture, or not surely to all others.
    pub fn trial(&self, q: &[f64; 6], choice: u8) -> Option<f64> {
        let hidden = usize::from(choice / 2) % 6;
        let slides = self.axes.iter().filter(|a| a.slides).count();
        let fits = match slides {
            0 | 1 => !self.axes[hidden].slides,
            2 => !self.axes[hidden].slides && choice.is_multiple_of(2),
            3 => choice == 0,
            _ => false,
        };
        if !fits {
            return None;
        }
        let posture = self.posture(&self.axes, q);
        let mut g = Displacement::NONE;
        for (axis, v) in self.axes.iter().zip(posture) {
            g = g.after(&axis.displacement(Value { way: v.way * self.size, ..v }));
        }
        let mut found = Found { list: List::new(([Value::ZERO; 6], 0.0)), best: None };
        let sure = self.attempt(&self.axes, &g, choice, &mut found);
        let count = found.list.len();
        found.keep(&posture, 0.0);
        if !sure || found.list.len() != count {
            return None;
        }
        let round = Loop::new(&self.axes, &g, hidden, self.size);
        let known = match Slides::new(&round) {
            Some(slides) if slides.hides() => polynomial(|q| slides.polynomial(q), slides::DEGREE),
            Some(_) => return Some(0.0),
            None => {
                let system = Elimination::new(&round, choice % 2 == 1);
                polynomial(|q| system.determinant(q), DEGREE)
            }
        };
        let turn = posture.get(hidden).map_or(Turn::NONE, |v| v.turn);
        let here = Complex { re: turn.c, im: turn.s };
        let far = known.z.iter().take(known.len).map(|z| z.minus(here).size());
        Some(far.fold(f64::INFINITY, f64::min))
    }
}

/// Has each complex root near the unit circle its partner there? What is not so has not been found
/// well.
fn mirrored(known: &Roots, len: usize) -> bool {
    let roots = || known.z.iter().zip(known.error).take(len);
    for (z, error) in roots() {
        let size = z.size();
        let off = (size - 1.0).abs();
        if off > 2.0 * BESIDE || off < BARELY.max(30.0 * error) {
            continue;
        }
        let partner = z.times(1.0 / (size * size));
        if !roots().any(|(o, e)| o.minus(partner).size() < FAR_OFF + 30.0 * (error + e)) {
            return false;
        }
    }
    true
}

/// Has each real root its own posture? Roots that lie together need as many postures there.
fn matched(known: &Roots, hidden: usize, found: &Found) -> bool {
    let len = known.len.min(ROOTS);
    if !mirrored(known, len) {
        return false;
    }
    let mut width = [0.0; ROOTS];
    let mut group = [0usize; ROOTS];
    // By group: roots less postures.
    let mut open = [0i32; ROOTS];
    for k in 0..len {
        width[k] = CLOSE + 30.0 * known.error[k];
        group[k] = k;
        for j in 0..k {
            if known.z[k].minus(known.z[j]).size() < width[k] + width[j] {
                let (from, to) = (group[j], group[k]);
                group.iter_mut().take(k).filter(|g| **g == from).for_each(|g| *g = to);
            }
        }
    }
    for k in 0..len {
        if (known.z[k].size() - 1.0).abs() < width[k].max(BARELY) {
            if width[k] > WIDEST {
                return false;
            }
            open[group[k] & 15] += 1;
        }
    }
    for (posture, _) in found.list.iter() {
        let v = posture.get(hidden).map_or(Turn::NONE, |v| v.turn);
        let here = Complex { re: v.c, im: v.s };
        let mut nearest = (f64::INFINITY, 0);
        for k in 0..len {
            let far = known.z[k].minus(here).size();
            if far < nearest.0 {
                nearest = (far, k);
            }
        }
        let k = nearest.1 & 15;
        // A posture without a root shows that the roots are not to be believed.
        if nearest.0 > 3.0 * width[k] + FAR_OFF {
            return false;
        }
        open[group[k] & 15] -= 1;
    }
    open.iter().all(|left| *left <= 0)
}

/// Roots of a choice as the samples give them.
fn polynomial(of: impl Fn(Turn) -> f64, degree: usize) -> Roots {
    let turns = angles();
    let mut samples = [0.0; SAMPLES];
    for (sample, q) in samples.iter_mut().zip(&turns) {
        *sample = of(*q);
    }
    roots(&samples, &turns, degree)
}

/// The angle of a root that may be real. Of a pose out of reach the nearest miss is wanted, so
/// others are tried, too.
fn tried(z: Complex, others: bool) -> Option<Turn> {
    let size = z.size();
    let off = (size - 1.0).abs();
    (off < BESIDE || off < 1.0 && others).then(|| Turn { c: z.re / size, s: z.im / size })
}

/// All joints of the loop at a root.
fn start(system: &Elimination, round: &Loop, hidden: Turn, pose_side: bool) -> Posture {
    let [a, b, c, d] = system.positions(hidden);
    // Near side: joints 1 and 2; far side: 5 and 4.
    let ([one, two], [five, four]) = if pose_side { ([a, b], [c, d]) } else { ([c, d], [a, b]) };
    let mut v = [Value::turn(hidden), one, two, Value::ZERO, four, five];
    v[3] = last(round, &v);
    v
}

/// From the loop's order to the joints' own.
fn back_in_order(v: &Posture, hidden: usize) -> Posture {
    let mut own = *v;
    for (k, v) in v.iter().enumerate() {
        if let Some(place) = own.get_mut((k + hidden) % 6) {
            *place = *v;
        }
    }
    own
}
