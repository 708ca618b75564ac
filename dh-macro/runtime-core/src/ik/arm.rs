//! An arm made ready for its inverse, and the one entrance to all solvers.

use super::super::runtime::Scalar;
use super::axis::{Axis, Value};
use super::candidates::Candidates;
// [general]
use super::general::General;
// [/general]
use super::lanes::measured;
use super::list::List;
// [numerical]
use super::numerical;
// [/numerical]
// [plane]
use super::plane::Plane;
// [/plane]
use super::polish::{self, polish, remainder, sizes};
use super::pose::Displacement;
use super::real::{root, whole, wrapped};
use super::reference::Reference;
// [six]
use super::regional::Regional;
use super::six::{Method, Six};
// [/six]
use super::solution::{Branch, CAPACITY, PoseError, Solution, Solutions, Status};
// [swivel]
use super::swivel::Swivel;
// [/swivel]
use super::vector::{IDENTITY, Matrix, dot, product, transposed};

/// How an arm is solved.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Family {
    // [six]
    /// Six joints or fewer.
    Six(Six),
    /// Seven, the first or the last of which is given.
    Locked {
        /// Index, from 0.
        joint: u8,
        /// The other six.
        six: Six,
    },
    // [/six]
    // [swivel]
    /// Seven, by the swivel angle.
    Swivel(Swivel),
    // [/swivel]
    // [plane]
    /// All turning axes parallel.
    Plane(Plane),
    // [/plane]
    // [general]
    /// Six joints in general position, of which three at most slide, or seven of which one is given.
    General(General),
    // [/general]
    /// Only joints that slide: linear.
    Slides,
    // [numerical]
    /// No other solver is known: damped least squares from many starts. There may be postures that
    /// no start leads to.
    Numerical,
    // [/numerical]
}

impl Family {
    /// Whether postures are searched for, if there is no closed form.
    pub(super) fn is_searched(&self) -> bool {
        // [numerical]
        if matches!(self, Self::Numerical) {
            return true;
        }
        // [/numerical]
        false
    }

    /// Of an arm with seven joints whose redundancy is a joint's position: that joint.
    pub fn locked(&self) -> Option<u8> {
        match self {
            // [six]
            Self::Locked { joint, .. } => Some(*joint),
            // [/six]
            // [general]
            Self::General(general) => general.locked,
            // [/general]
            _ => None,
        }
    }

    /// Whether the redundancy is a swivel angle.
    pub(super) fn is_swivel(&self) -> bool {
        // [swivel]
        if matches!(self, Self::Swivel(_)) {
            return true;
        }
        // [/swivel]
        false
    }
}

/// An arm with `N` joints.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Arm<const N: usize> {
    /// Lines of the joints at `q = 0`, in world axes.
    pub axes: [Axis; N],
    /// The last DH frame at `q = 0`.
    pub home: Displacement,
    /// Lower and upper positions, rad or m.
    pub limits: [Option<[f64; 2]>; N],
    /// Whether a closed form is the arm's own. Otherwise it is that of a nominal arm nearby, each
    /// branch refined, or there is none and postures are searched.
    pub exact: bool,
    /// How it is solved.
    pub family: Family,
}

/// Options of a query beside the pose.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Query<'a, const N: usize> {
    /// Of a redundant arm: swivel angle, rad, or position of the locked joint, rad or m.
    pub redundancy: f64,
    /// From where the swivel angle is counted.
    pub reference: Reference,
    /// A posture: free joints take their positions from it, whole turns are chosen near it (near
    /// zero where it is beyond 1000 rad), and nearest solutions stand first.
    pub near: Option<&'a [f64; N]>,
    /// Tolerated pose error, m and rad. The default is `1e-12`: rounding.
    pub tolerance: f64,
    /// Newton's steps at most on a branch whose closed form leaves more than rounding (singular, or
    /// out of reach, where they find how far off the pose is). The default is 40: at a double root
    /// each only halves what is left. Who must answer in time asks for none, with a tolerance that
    /// the closed form keeps by itself (1e-9).
    pub steps: usize,
}

impl<const N: usize> Default for Query<'_, N> {
    fn default() -> Self {
        Self { redundancy: 0.0, reference: Reference::UP, near: None, tolerance: 1e-12, steps: STEPS }
    }
}

/// State carried along while solutions are gathered.
pub(super) struct Work {
    /// Marks of the solutions, to detect equal ones.
    marks: [f64; CAPACITY],
    /// The nearest miss, m and rad.
    best: [f64; 2],
}

/// A pose that is missed by less, m and rad, may be one that the arm reaches at a singularity.
const LITTLE: f64 = 1e-6;

/// Newton's steps where nothing else is asked for.
const STEPS: usize = 40;

/// Branches whose marks differ by less may be equal.
const SAME: f64 = 1e-7;

/// Pose error below which only rounding is left, m and rad.
const EXACT: f64 = 1e-13;

impl<const N: usize> Arm<N> {
    /// The pose of the last DH frame, as rows.
    pub fn forward(&self, q: &[f64; N]) -> [[f64; 4]; 3] {
        let t = polish::forward(self, &polish::values(self, q)).after(&self.home);
        core::array::from_fn(|i| {
            let [x, y, z] = t.rotation[i];
            [x, y, z, t.shift[i]]
        })
    }

    /// All postures that bring the last DH frame to a pose: the top three rows of its homogeneous
    /// matrix, m.
    ///
    /// # Errors
    /// If an entry is not finite, or the rotation is none (beyond 1e-6; a smaller defect is taken
    /// away).
    pub fn solve(&self, pose: &[[f64; 4]; 3], query: &Query<'_, N>) -> Result<Solutions<N>, PoseError> {
        self.solve_inlined(pose, query)
    }

    /// The same inlined: of an arm that is a constant, as that of a generated crate, the compiler
    /// makes a solver for it alone.
    ///
    /// # Errors
    /// Like [`Arm::solve`].
    #[inline(always)]
    pub fn solve_inlined(&self, pose: &[[f64; 4]; 3], query: &Query<'_, N>) -> Result<Solutions<N>, PoseError> {
        let target = checked(pose)?;
        let near_finite = query.near.is_none_or(|q| q.iter().all(|x| x.is_finite()));
        if !query.redundancy.is_finite() || !near_finite {
            return Err(PoseError::NotFinite(3, 0));
        }
        let g = target.after(&self.home.inverse());
        let near = query.near.map_or([Value::ZERO; N], |q| polish::values(self, q));
        let slides = |j: usize| self.axes.get(j).is_some_and(|a| a.slides);
        let mut all: Candidates<N> = Candidates::new();
        let second_plane = self.candidates_inlined(&g, query, query.redundancy, &near, &mut all);
        if all.in_doubt() {
            self.settle(&g, query, &near, &mut all);
        }
        // Of a family of postures, the member nearest to the one named, which may be one itself.
        let mut member = None;
        if query.near.is_some() && all.len > 0 {
            let [p, r] = sizes(&remainder(self, &g, &near));
            if p.max(r) < 1e-9 || all.free.iter().take(all.len).any(|f| *f != 0) {
                let far = |place: usize| {
                    all.values(place, slides).iter().zip(&near).fold(0.0f64, |m, (a, b)| {
                        m.max((a.turn.c - b.turn.c).abs() + (a.turn.s - b.turn.s).abs() + (a.way - b.way).abs())
                    })
                };
                member = (0..all.len).reduce(|a, b| if far(b) < far(a) { b } else { a });
            }
        }
        let mut result = Ok(Solutions {
            list: List::new(Solution::NONE),
            status: Status::Ok,
            distance: [0.0; 2],
            lost: 0,
            uncertain: false,
            redundancy: query.redundancy,
            second_plane,
        });
        let Ok(solutions) = &mut result else { return result };
        let mut work = Work { marks: [f64::INFINITY; CAPACITY], best: [f64::INFINITY; 2] };
        self.finish(&g, query, &all, member.map(|place| (place, near)), solutions, &mut work);
        let searched = self.family.is_searched();
        if (self.exact || searched)
            && solutions.list.is_empty()
            && query.steps > 0
            && work.best[0] + work.best[1] < LITTLE
        {
            self.retry(&g, query, &near, solutions, &mut work);
        }
        self.doubts(all.unsure, solutions);
        // [nearby]
        if !searched && !self.exact {
            self.search_nearby(&g, query, &near, &all, solutions, &mut work);
        }
        // [/nearby]
        conclude(query, &work, solutions);
        result
    }

    /// What may be missing of a search, or of an elimination that did not prove itself.
    #[inline(always)]
    fn doubts(&self, unsure: bool, out: &mut Solutions<N>) {
        // Real postures of a general arm with six joints come in pairs.
        let odd = (out.as_slice().len() % 2) as u32;
        if self.family.is_searched() {
            (out.uncertain, out.lost) = (true, if N == 6 { odd } else { 0 });
        }
        // [general]
        if let Family::General(_) = &self.family {
            (out.uncertain, out.lost) = (unsure, odd);
        }
        // [/general]
    }

    /// Closed-form solutions at a redundancy; true: counted from the second plane.
    #[inline(never)]
    pub(super) fn candidates(
        &self,
        g: &Displacement,
        query: &Query<'_, N>,
        redundancy: f64,
        near: &[Value; N],
        all: &mut Candidates<N>,
    ) -> bool {
        self.candidates_inlined(g, query, redundancy, near, all)
    }

    #[inline(always)]
    fn candidates_inlined(
        &self,
        g: &Displacement,
        query: &Query<'_, N>,
        redundancy: f64,
        near: &[Value; N],
        all: &mut Candidates<N>,
    ) -> bool {
        let slides = |j: usize| self.axes.get(j).is_some_and(|a| a.slides);
        let mut second_plane = false;
        match &self.family {
            // [six]
            Family::Six(six) => six.solve(g, near, all),
            Family::Locked { joint, six } => {
                let lock = usize::from(*joint);
                let axis = self.axes.get(lock).copied().unwrap_or(self.axes_first());
                let ([s], [c]) = f64::sin_cos_all(&[redundancy]);
                let turn = super::vector::Turn { c, s };
                let value = if axis.slides { Value::way(redundancy) } else { Value::turn(turn) };
                all.value(lock, axis.slides, value);
                let locked = axis.displacement(value).inverse();
                let rest = if lock == 0 { locked.after(g) } else { g.after(&locked) };
                six.solve(&rest, near, all);
            }
            // [/six]
            // [swivel]
            Family::Swivel(swivel) => {
                let ([s], [c]) = f64::sin_cos_all(&[redundancy]);
                second_plane = swivel.solve(g, &query.reference, (c, s), near, all);
            }
            // [/swivel]
            // [plane]
            Family::Plane(plane) => {
                let three = plane.joints.map(|j| pick(near, j));
                for f in plane.solve(g, &three).iter() {
                    let mut values = [Value::ZERO; N];
                    for (j, v) in plane.joints.iter().zip(f.values) {
                        put(&mut values, *j, v);
                    }
                    put(&mut values, plane.lift.map(|(_, j, _)| j), f.lift);
                    let mut free = super::candidates::in_doubt(f.free);
                    for (k, j) in plane.joints.iter().enumerate() {
                        free |= j.map_or(0, |j| u32::from(f.free >> k & 1) << (j & 15));
                    }
                    all.push_all(&values, slides, f.branch, free);
                }
            }
            // [/plane]
            // [general]
            Family::General(general) => general.solve(self, g, query, all),
            // [/general]
            Family::Slides => {
                all.push_all(&[Value::ZERO; N], slides, Branch::NONE, 0);
            }
            // [numerical]
            Family::Numerical => numerical::search(self, g, query, near, all),
            // [/numerical]
        }
        second_plane
    }

    /// The next posture along a path: the solution nearest to the last one, through singularities
    /// too. `None` where the pose is out of reach, or where every posture is farther than
    /// `largest_step` (rad or m, any joint): a jump is never made.
    ///
    /// # Errors
    /// Like [`Arm::solve`].
    pub fn follow(
        &self,
        pose: &[[f64; 4]; 3],
        last: &[f64; N],
        query: &Query<'_, N>,
        largest_step: f64,
    ) -> Result<Option<Solution<N>>, PoseError> {
        let found = self.solve(pose, &Query { near: Some(last), ..*query })?;
        let near = |s: &&Solution<N>| (0..N).all(|i| (s.q[i] - last[i]).abs() <= largest_step);
        Ok(found.as_slice().first().filter(near).copied())
    }

    fn axes_first(&self) -> Axis {
        self.axes.first().copied().unwrap_or(Axis { slides: true, h: [0.0, 0.0, 1.0], c: [0.0; 3] })
    }

    /// The redundancy parameter of a posture: its swivel angle or the locked joint's position; zero
    /// for other arms.
    pub fn redundancy(&self, q: &[f64; N], reference: &Reference) -> f64 {
        let values = polish::values(self, q);
        match &self.family {
            // [swivel]
            Family::Swivel(swivel) => {
                let seven = core::array::from_fn(|i| values.get(i).copied().unwrap_or(Value::ZERO));
                swivel.angle(&seven, reference).0
            }
            // [/swivel]
            other => other.locked().and_then(|joint| q.get(usize::from(joint)).copied()).unwrap_or(0.0),
        }
    }

    /// Is a branch that is this far off (m or rad) one that the arm has, but for rounding?
    fn nearly(&self, tolerance: f64) -> f64 {
        if !self.exact || self.family.is_searched() || matches!(self.family, Family::Slides) {
            return f64::INFINITY;
        }
        let quartic = match &self.family {
            // [six]
            Family::Six(six) | Family::Locked { six, .. } => matches!(
                six.method,
                Method::Wrist { regional: Regional::General { .. } | Regional::TurnSlideTurn, .. }
                    | Method::ThreeParallel { meet: None }
            ),
            // [/six]
            // [general]
            Family::General(_) => true,
            // [/general]
            _ => false,
        };
        // A double root of a quartic is known to half the digits.
        (100.0 * tolerance).max(if quartic { 1e-3 } else { 1e-6 })
    }

    /// Measures, refines where rounding shows, and keeps what reaches the pose. `member`: one more
    /// posture, of the family of the branch in that place.
    #[inline(always)]
    fn finish(
        &self,
        g: &Displacement,
        query: &Query<'_, N>,
        all: &Candidates<N>,
        member: Option<(usize, [Value; N])>,
        out: &mut Solutions<N>,
        work: &mut Work,
    ) {
        let slides = |j: usize| self.axes.get(j).is_some_and(|a| a.slides);
        let nearly = self.nearly(query.tolerance);
        let mut far_off = 0u32;
        for first in [0, 8] {
            if first >= all.len {
                break;
            }
            let eight = measured(self, g, query.near, all, first);
            // Equal branches are rare: only where two marks are equal are they compared.
            let mut alike = !out.list.is_empty();
            for (lane, mark) in eight.marks.iter().enumerate() {
                for other in &eight.marks[..lane] {
                    alike |= (mark - other).abs() < SAME;
                }
            }
            for lane in 0..8 {
                let place = first + lane;
                if place >= all.len {
                    break;
                }
                let (p2, r2, mark) = (eight.ways[lane], eight.turns[lane], eight.marks[lane]);
                let (branch, free) = all.kind(place);
                if p2 <= EXACT * EXACT && r2 <= EXACT * EXACT {
                    let mut found = Solution { branch, free, ..Solution::NONE };
                    (found.position_error, found.rotation_error) = (root(p2), root(r2));
                    found.margin = eight.margins[lane];
                    for j in 0..N {
                        found.q[j] = eight.q[j][lane];
                    }
                    found.within_limits = found.margin >= -1e-9;
                    if alike {
                        self.keep(out, work, found, mark);
                    } else {
                        add(out, work, found, mark);
                    }
                    continue;
                }
                // Rounding errors grow with each singularity.
                let nearly = if free == 0 { nearly } else { nearly.max(1e-3) };
                if p2 <= nearly * nearly && r2 <= nearly * nearly {
                    alike = true;
                    self.refine(g, query, all.values(place, slides), (branch, free), out, work);
                } else {
                    // No posture, or one of an added joint: tried only if there are no others.
                    far_off |= 1 << place;
                }
            }
        }
        if let Some((place, values)) = member {
            let kind = all.kind(place);
            self.refine(g, query, values, kind, out, work);
        }
        out.lost += far_off.count_ones();
        if out.list.is_empty() {
            for place in 0..all.len {
                if far_off >> place & 1 == 1 {
                    out.lost -= 1;
                    let kind = all.kind(place);
                    self.refine(g, query, all.values(place, slides), kind, out, work);
                }
            }
        }
    }

    /// One candidate by Newton's steps.
    #[cold]
    #[inline(never)]
    pub(super) fn refine(
        &self,
        g: &Displacement,
        query: &Query<'_, N>,
        mut values: [Value; N],
        (branch, free): (Branch, u32),
        out: &mut Solutions<N>,
        work: &mut Work,
    ) {
        for v in &mut values {
            v.turn = super::vector::Turn::along(v.turn.c, v.turn.s).0;
        }
        let start = values;
        let mut e = remainder(self, g, &values);
        let [p, r] = sizes(&e);
        if query.steps > 0 && (p.max(r) > EXACT || !self.exact) {
            e = polish(self, g, query, &mut values, query.steps);
            if let Some(joint) = self.family.locked() {
                // Its own value to the last digit.
                let lock = usize::from(joint);
                if let (Some(place), Some(kept)) = (values.get_mut(lock), start.get(lock)) {
                    *place = *kept;
                }
                e = remainder(self, g, &values);
            }
        }
        let [p, r] = sizes(&e);
        if p + r < work.best[0] + work.best[1] {
            work.best = [p, r];
        }
        if !(p <= query.tolerance && r <= query.tolerance && self.keeps(query, &values)) {
            out.lost += 1;
            return;
        }
        let own = self.freedom(g, query, &values);
        let free = if self.exact { free | own } else { own };
        let mut found = Solution {
            q: polish::positions(self, &values),
            branch,
            free,
            position_error: p,
            rotation_error: r,
            ..Solution::NONE
        };
        found.margin = f64::INFINITY;
        let mut mark = 0.0;
        for i in 0..N {
            let near = query.near.and_then(|n| n.get(i)).copied();
            let (x, m) = fitted(found.q[i], self.axes[i].slides, self.limits[i], near);
            found.q[i] = x;
            found.margin = found.margin.min(m);
            let (c, s) = if self.axes[i].slides { (values[i].way, 0.0) } else { (values[i].turn.c, values[i].turn.s) };
            let [a, b] = super::lanes::weights(i);
            mark += c * a + s * b;
        }
        found.within_limits = found.margin >= -1e-9;
        self.keep(out, work, found, mark);
    }

    /// Adds a solution that is not there yet. Equal ones have equal marks.
    #[cold]
    #[inline(never)]
    fn keep(&self, out: &mut Solutions<N>, work: &mut Work, found: Solution<N>, mark: f64) {
        let same = |s: &Solution<N>| {
            (0..N).all(|i| (s.q[i] - found.q[i]).abs() < 1e-10 || self.full_turn(i, s.q[i] - found.q[i]))
        };
        // Marks first: only where one is equal are all joints compared.
        for (twin, m) in out.list.as_mut_slice().iter_mut().zip(work.marks.iter()) {
            if (m - mark).abs() < SAME && same(twin) {
                twin.free |= found.free;
                if found.free != 0 {
                    out.status = Status::Singular;
                }
                return;
            }
        }
        add(out, work, found, mark);
    }

    fn full_turn(&self, joint: usize, difference: f64) -> bool {
        self.axes.get(joint).is_some_and(|a| !a.slides) && wrapped(difference).abs() < 1e-10
    }

    /// Does the arm keep a redundancy while it is refined? An exact swivel arm is not led away from
    /// its angle.
    pub(super) fn holds(&self) -> bool {
        match &self.family {
            // [swivel]
            Family::Swivel(_) => !self.exact,
            // [/swivel]
            other => other.locked().is_some(),
        }
    }

    /// Error of the redundancy that is kept, and its derivatives by the joints; zeros where none is
    /// kept.
    pub(super) fn held(&self, query: &Query<'_, N>, v: &[Value; N]) -> (f64, [f64; N]) {
        if self.holds() { self.kept(query, v) } else { (0.0, [0.0; N]) }
    }

    /// The same of every redundant arm.
    pub(super) fn kept(&self, query: &Query<'_, N>, v: &[Value; N]) -> (f64, [f64; N]) {
        let mut row = [0.0; N];
        match &self.family {
            // [swivel]
            Family::Swivel(swivel) => {
                let seven = core::array::from_fn(|i| v.get(i).copied().unwrap_or(Value::ZERO));
                let (left, rates) = swivel.left(&seven, &query.reference, query.redundancy);
                for (place, rate) in row.iter_mut().zip(rates) {
                    *place = rate;
                }
                (left, row)
            }
            // [/swivel]
            other => {
                let Some(joint) = other.locked() else { return (0.0, row) };
                let lock = usize::from(joint);
                let here = v.get(lock).copied().unwrap_or(Value::ZERO);
                if let Some(place) = row.get_mut(lock) {
                    *place = 1.0;
                }
                let slides = self.axes.get(lock).is_some_and(|a| a.slides);
                let at = if slides { here.way } else { super::real::angle(here.turn.s, here.turn.c) };
                (if slides { query.redundancy - at } else { wrapped(query.redundancy - at) }, row)
            }
        }
    }

    /// Is the redundancy the one that was asked for? The equation does not determine half turns of
    /// a swivel angle.
    fn keeps(&self, query: &Query<'_, N>, v: &[Value; N]) -> bool {
        // [swivel]
        if let Family::Swivel(swivel) = &self.family {
            let seven = core::array::from_fn(|i| v.get(i).copied().unwrap_or(Value::ZERO));
            return self.exact
                || wrapped(swivel.angle(&seven, &query.reference).0 - query.redundancy).abs() < 1e-6
                || swivel.left(&seven, &query.reference, query.redundancy).0.abs() < 1e-6 && swivel.straight(&seven);
        }
        // [/swivel]
        true
    }
}

/// Adds a solution.
#[inline(always)]
fn add<const N: usize>(out: &mut Solutions<N>, work: &mut Work, found: Solution<N>, mark: f64) {
    if found.free != 0 {
        out.status = Status::Singular;
    }
    if let Some(place) = work.marks.get_mut(out.list.len()) {
        *place = mark;
    }
    out.list.push(found);
}

fn pick<const N: usize>(values: &[Value; N], joint: Option<u8>) -> Value {
    joint.and_then(|j| values.get(usize::from(j)).copied()).unwrap_or(Value::ZERO)
}

fn put<const N: usize>(values: &mut [Value; N], joint: Option<u8>, v: Value) {
    if let Some(place) = joint.and_then(|j| values.get_mut(usize::from(j))) {
        *place = v;
    }
}

/// Whole turns are chosen near a position up to here, rad: the digits of one that is farther away
/// would not hold a pose.
const FAR: f64 = 1e3;

/// The whole turns that respect the limits and lie nearest to `near` (or zero), with the distance
/// to the nearest limit.
pub(super) fn fitted(q: f64, slides: bool, limits: Option<[f64; 2]>, near: Option<f64>) -> (f64, f64) {
    use core::f64::consts::TAU;
    let mut x = q;
    if !slides {
        let near = near.filter(|near| near.abs() <= FAR).unwrap_or(0.0);
        // All turns in one product: a sum of sums would keep what a far one has rounded.
        let turns = whole((near - q) / TAU);
        x = q + TAU * turns;
        if let Some([low, high]) = limits {
            let outside = |x: f64| (low - x).max(x - high);
            if outside(x) > 0.0 {
                // The nearest turn inside, from either side.
                let up = q + TAU * (turns + ceiling((low - 1e-9 - x) / TAU).max(0.0));
                let down = q + TAU * (turns - ceiling((x - high - 1e-9) / TAU).max(0.0));
                for other in [up, down] {
                    if outside(other) < outside(x) && outside(other) <= 1e-9 {
                        x = other;
                    }
                }
            }
        }
    }
    let margin = limits.map_or(f64::INFINITY, |[low, high]| (x - low).min(high - x));
    (x, margin)
}

fn ceiling(x: f64) -> f64 {
    let near = whole(x);
    if near < x { near + 1.0 } else { near }
}

/// A pose with finite entries and a true rotation.
pub(super) fn checked(pose: &[[f64; 4]; 3]) -> Result<Displacement, PoseError> {
    // Beyond that squares overflow, and no arm is as long.
    let usual = |x: f64| x.abs() < 1e100;
    let mut all = true;
    for row in pose {
        all &= usual(row[0]) & usual(row[1]) & usual(row[2]) & usual(row[3]);
    }
    if !all {
        return Err(not_finite(pose));
    }
    let mut t = Displacement::from_rows(pose);
    let (rr, d) = squared(&t.rotation);
    let determinant = dot(t.rotation[0], super::vector::cross(t.rotation[1], t.rotation[2]));
    if !(d <= 1e-6) {
        return Err(PoseError::NotARotation(d));
    }
    if !(determinant > 0.0) {
        return Err(PoseError::Reflection);
    }
    if d > 4e-16 {
        // Nearest rotation: R (3 - R'R) / 2; the defect is squared each time.
        t.rotation = nearer(&t.rotation, &rr);
        if d > 1e-9 {
            let (rr, _) = squared(&t.rotation);
            t.rotation = nearer(&t.rotation, &rr);
        }
    }
    Ok(t)
}

/// `R'R`, its upper half twice, and how far it is from the identity.
#[inline(always)]
fn squared(r: &Matrix) -> (Matrix, f64) {
    let [x, y, z] = transposed(r);
    let [xx, yy, zz] = [dot(x, x), dot(y, y), dot(z, z)];
    let [xy, xz, yz] = [dot(x, y), dot(x, z), dot(y, z)];
    let mut d = 0.0f64;
    // NaN stays.
    for part in [xx - 1.0, yy - 1.0, zz - 1.0, xy, xz, yz] {
        d = if part.abs() <= d { d } else { part.abs() };
    }
    ([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]], d)
}

/// `R (3 - R'R) / 2`.
#[inline(always)]
fn nearer(r: &Matrix, rr: &Matrix) -> Matrix {
    let k = |i: usize| {
        let [x, y, z] = IDENTITY[i];
        [1.5 * x - 0.5 * rr[i][0], 1.5 * y - 0.5 * rr[i][1], 1.5 * z - 0.5 * rr[i][2]]
    };
    product(r, &[k(0), k(1), k(2)])
}

/// Index of the entry that is not finite.
#[cold]
#[inline(never)]
fn not_finite(pose: &[[f64; 4]; 3]) -> PoseError {
    for (i, row) in pose.iter().enumerate() {
        for (j, x) in row.iter().enumerate() {
            if !(x.abs() < 1e100) {
                return PoseError::NotFinite(i, j);
            }
        }
    }
    PoseError::NotFinite(0, 0)
}

/// Status and order.
fn conclude<const N: usize>(query: &Query<'_, N>, work: &Work, out: &mut Solutions<N>) {
    if out.list.is_empty() {
        out.status = Status::Unreachable;
        out.distance = work.best.map(|x| if x.is_finite() { x } else { 0.0 });
    }
    if let Some(near) = query.near {
        let far = |s: &Solution<N>| s.q.iter().zip(near).fold(0.0f64, |m, (a, b)| m.max((a - b).abs()));
        // By insertion: a library sort has a way into a panic.
        let list = out.list.as_mut_slice();
        for i in 1..list.len() {
            for j in (1..=i).rev() {
                let (Some(a), Some(b)) = (list.get(j - 1), list.get(j)) else { break };
                if far(a) <= far(b) {
                    break;
                }
                list.swap(j - 1, j);
            }
        }
    }
}
