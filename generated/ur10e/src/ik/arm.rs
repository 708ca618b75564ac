//! An arm made ready for its inverse, and the one entrance to all solvers.

use super::super::runtime::Scalar;
use super::axis::{Axis, Value};
use super::list::List;
use super::numerical;
use super::plane::Plane;
use super::polish::{self, polish, remainder, sizes};
use super::pose::Displacement;
use super::real::{whole, wrapped};
use super::six::Six;
use super::solution::{Branch, PoseError, Solution, Solutions, Status};
use super::swivel::{Reference, Swivel};
use super::vector::{IDENTITY, product, transposed};

/// How an arm is solved.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Family {
    /// Six joints or fewer.
    Six(Six),
    /// Seven, the first or the last of which is given.
    Locked {
        /// Which one, from 0.
        joint: u8,
        /// The other six.
        six: Six,
    },
    /// Seven, by the swivel angle.
    Swivel(Swivel),
    /// All turning axes parallel.
    Plane(Plane),
    /// Only joints that slide: linear.
    Slides,
    /// No closed form is known: damped least squares from many starts.
    Numerical,
}

/// An arm with `N` joints.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Arm<const N: usize> {
    /// Lines of the joints at `q = 0`, in base axes.
    pub axes: [Axis; N],
    /// The last DH frame at `q = 0`.
    pub home: Displacement,
    /// Lower and upper positions, rad or m.
    pub limits: [Option<[f64; 2]>; N],
    /// Is the family's closed form the arm's own? Otherwise it is that of a nominal arm nearby, and every branch is refined.
    pub exact: bool,
    /// How it is solved.
    pub family: Family,
}

/// What is asked beside the pose.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Query<'a, const N: usize> {
    /// Of a redundant arm: swivel angle, rad, or position of the locked joint, rad or m.
    pub redundancy: f64,
    /// From where the swivel angle is counted.
    pub reference: Reference,
    /// A posture: free joints take their positions from it, whole turns are chosen near it, and nearest solutions stand first.
    pub near: Option<&'a [f64; N]>,
    /// What may be left to the pose, m and rad. The default is `1e-12`: rounding.
    pub tolerance: f64,
}

impl<const N: usize> Default for Query<'_, N> {
    fn default() -> Self {
        Self { redundancy: 0.0, reference: Reference::UP, near: None, tolerance: 1e-12 }
    }
}

/// A candidate of any family.
#[derive(Clone, Copy)]
pub(super) struct Candidate<const N: usize> {
    pub values: [Value; N],
    pub branch: Branch,
    pub free: u32,
}

impl<const N: usize> Arm<N> {
    /// The pose of the last DH frame, as rows.
    pub fn forward(&self, q: &[f64; N]) -> [[f64; 4]; 3] {
        let t = polish::forward(self, &polish::values(self, q)).after(&self.home);
        core::array::from_fn(|i| {
            let [x, y, z] = t.rotation[i];
            [x, y, z, t.shift[i]]
        })
    }

    /// All postures that bring the last DH frame to a pose: the top three rows of its homogeneous matrix, m.
    ///
    /// # Errors
    /// If an entry is not finite, or the rotation is none (beyond 1e-6; a smaller defect is taken away).
    pub fn solve(&self, pose: &[[f64; 4]; 3], query: &Query<'_, N>) -> Result<Solutions<N>, PoseError> {
        let target = checked(pose)?;
        let near_finite = query.near.is_none_or(|q| q.iter().all(|x| x.is_finite()));
        if !query.redundancy.is_finite() || !near_finite {
            return Err(PoseError::NotFinite(3, 0));
        }
        let g = target.after(&self.home.inverse());
        let near = query.near.map_or([Value::ZERO; N], |q| polish::values(self, q));
        let mut all: List<Candidate<N>, 17> = List::new(Candidate { values: near, branch: Branch::NONE, free: 0 });
        let mut second_plane = false;
        match &self.family {
            Family::Six(six) => self.six(six, &g, &near, &mut all),
            Family::Locked { joint, six } => {
                let lock = usize::from(*joint);
                let mut fixed = near;
                let axis = self.axes.get(lock).copied().unwrap_or(self.axes_first());
                let ([s], [c]) = f64::sin_cos_all(&[query.redundancy]);
                let value = Value { turn: super::vector::Turn { c, s }, way: query.redundancy };
                let value = if axis.slides { Value::way(query.redundancy) } else { Value::turn(value.turn) };
                if let Some(place) = fixed.get_mut(lock) {
                    *place = value;
                }
                let locked = axis.displacement(value).inverse();
                let rest = if lock == 0 { locked.after(&g) } else { g.after(&locked) };
                self.six(six, &rest, &fixed, &mut all);
            }
            Family::Swivel(swivel) => {
                let seven: [Value; 7] = core::array::from_fn(|i| near.get(i).copied().unwrap_or(Value::ZERO));
                let ([s], [c]) = f64::sin_cos_all(&[query.redundancy]);
                let (finds, second) = swivel.solve(&g, &query.reference, (c, s), &seven);
                second_plane = second;
                for f in finds.iter() {
                    let values = core::array::from_fn(|i| f.values.get(i).copied().unwrap_or(Value::ZERO));
                    all.push(Candidate { values, branch: f.branch, free: u32::from(f.free) });
                }
            }
            Family::Plane(plane) => {
                let three = plane.joints.map(|j| pick(&near, j));
                for f in plane.solve(&g, &three).iter() {
                    let mut values = [Value::ZERO; N];
                    for (j, v) in plane.joints.iter().zip(f.values) {
                        put(&mut values, *j, v);
                    }
                    put(&mut values, plane.lift.map(|(_, j, _)| j), f.lift);
                    all.push(Candidate { values, branch: f.branch, free: 0 });
                }
            }
            Family::Slides => {
                all.push(Candidate { values: [Value::ZERO; N], branch: Branch::NONE, free: 0 });
            }
            Family::Numerical => numerical::search(self, &g, query, &near, &mut all),
        }
        // Of a family of postures, the member nearest to the one that was named; and that one itself where it is there already.
        if query.near.is_some() && !all.is_empty() {
            let [p, r] = sizes(&remainder(self, &g, &near));
            if p.max(r) < 1e-9 || all.iter().any(|c| c.free != 0) {
                let far = |c: &Candidate<N>| {
                    c.values.iter().zip(&near).fold(0.0f64, |m, (a, b)| {
                        m.max((a.turn.c - b.turn.c).abs() + (a.turn.s - b.turn.s).abs() + (a.way - b.way).abs())
                    })
                };
                let closest = all.iter().copied().reduce(|a, b| if far(&b) < far(&a) { b } else { a });
                if let Some(closest) = closest {
                    all.push(Candidate { values: near, ..closest });
                }
            }
        }
        let mut solutions = self.finish(&g, query, all.as_slice());
        solutions.second_plane = second_plane;
        Ok(solutions)
    }

    /// The next posture along a path: the solution nearest to the last one, through singularities too. `None` where the pose is
    /// out of reach, or where every posture is farther than `largest_step` (rad or m, any joint): a jump is never made.
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

    /// The redundancy parameter of a posture: its swivel angle or the locked joint's position; zero for other arms.
    pub fn redundancy(&self, q: &[f64; N], reference: &Reference) -> f64 {
        let values = polish::values(self, q);
        match &self.family {
            Family::Swivel(swivel) => {
                let seven = core::array::from_fn(|i| values.get(i).copied().unwrap_or(Value::ZERO));
                swivel.angle(&seven, reference).0
            }
            Family::Locked { joint, .. } => q.get(usize::from(*joint)).copied().unwrap_or(0.0),
            _ => 0.0,
        }
    }

    fn six(&self, six: &Six, g: &Displacement, near: &[Value; N], all: &mut List<Candidate<N>, 17>) {
        let finds = if six.reversed { six.solve(&g.inverse(), &six.near(near)) } else { six.solve(g, &six.near(near)) };
        for f in finds.iter() {
            let mut values = *near;
            let mut free = 0;
            for (k, j) in six.joints.iter().enumerate() {
                put(&mut values, *j, f.values[k]);
                if let Some(j) = j {
                    free |= u32::from(f.free >> k & 1) << (u32::from(*j) & 31);
                }
            }
            all.push(Candidate { values, branch: f.branch, free });
        }
    }

    /// Refines, measures, and keeps what reaches the pose.
    fn finish(&self, g: &Displacement, query: &Query<'_, N>, all: &[Candidate<N>]) -> Solutions<N> {
        let nothing = Solution {
            q: [0.0; N],
            branch: Branch::NONE,
            position_error: 0.0,
            rotation_error: 0.0,
            within_limits: false,
            margin: 0.0,
            free: 0,
        };
        let mut out = Solutions {
            list: List::new(nothing),
            status: Status::Ok,
            distance: [0.0; 2],
            lost: 0,
            redundancy: query.redundancy,
            second_plane: false,
        };
        let mut best = [f64::INFINITY; 2];
        let swivel = match (&self.family, self.exact) {
            (Family::Swivel(s), false) => Some(s),
            _ => None,
        };
        let hold = |v: &[Value; N]| {
            let seven = core::array::from_fn(|i| v.get(i).copied().unwrap_or(Value::ZERO));
            swivel.map_or(0.0, |s| wrapped(s.angle(&seven, &query.reference).0 - query.redundancy))
        };
        let hold: Option<&dyn Fn(&[Value; N]) -> f64> = if swivel.is_some() { Some(&hold) } else { None };
        let locked = match &self.family {
            Family::Locked { joint, .. } => Some(usize::from(*joint)),
            _ => None,
        };
        for candidate in all {
            let mut values = candidate.values;
            let mut e = remainder(self, g, &values);
            let [p, r] = sizes(&e);
            // What is this far off belongs to a joint that must stay at zero, or to no posture at all: a few steps tell.
            if p.max(r) > 1e-13 {
                let steps = if self.exact { 8 } else { 40 };
                e = match locked {
                    Some(joint) => self.held(joint).polished(g, &mut values, steps),
                    None => polish(self, g, &mut values, hold, steps),
                };
            }
            let [p, r] = sizes(&e);
            if p + r < best[0] + best[1] {
                best = [p, r];
            }
            if !(p <= query.tolerance && r <= query.tolerance) {
                out.lost += 1;
                continue;
            }
            let mut q = polish::positions(self, &values);
            let (mut within_limits, mut margin) = (true, f64::INFINITY);
            for i in 0..N {
                let near = query.near.and_then(|n| n.get(i)).copied();
                let (x, m) = fitted(q[i], self.axes[i].slides, self.limits[i], near);
                q[i] = x;
                margin = margin.min(m);
                within_limits &= m >= -1e-9;
            }
            let solution = Solution {
                q,
                branch: candidate.branch,
                position_error: p,
                rotation_error: r,
                within_limits,
                margin,
                free: candidate.free,
            };
            let same =
                |s: &Solution<N>| (0..N).all(|i| (s.q[i] - q[i]).abs() < 1e-10 || self.full_turn(i, s.q[i] - q[i]));
            if out.list.iter().any(same) {
                continue;
            }
            if candidate.free != 0 {
                out.status = Status::Singular;
            }
            out.list.push(solution);
        }
        if out.list.is_empty() {
            out.status = Status::Unreachable;
            out.distance = best.map(|x| if x.is_finite() { x } else { 0.0 });
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
        out
    }

    fn full_turn(&self, joint: usize, difference: f64) -> bool {
        !self.axes[joint].slides && wrapped(difference).abs() < 1e-10
    }

    /// The arm with one joint held: it turns about nothing.
    fn held(&self, joint: usize) -> Held<'_, N> {
        Held { arm: self, joint }
    }
}

/// Polishing with one joint left alone.
struct Held<'a, const N: usize> {
    arm: &'a Arm<N>,
    joint: usize,
}

impl<const N: usize> Held<'_, N> {
    fn polished(&self, g: &Displacement, v: &mut [Value; N], steps: usize) -> polish::Twist {
        // A stiff further equation: the joint stays where it is.
        let start = v.get(self.joint).copied().unwrap_or(Value::ZERO);
        let slides = self.arm.axes.get(self.joint).is_some_and(|a| a.slides);
        let hold = |v: &[Value; N]| {
            let here = v.get(self.joint).copied().unwrap_or(Value::ZERO);
            let back = here.turn.then(start.turn.back());
            if slides { here.way - start.way } else { super::real::angle(back.s, back.c) }
        };
        polish(self.arm, g, v, Some(&hold), steps);
        if let Some(place) = v.get_mut(self.joint) {
            *place = start;
        }
        remainder(self.arm, g, v)
    }
}

fn pick<const N: usize>(values: &[Value; N], joint: Option<u8>) -> Value {
    joint.and_then(|j| values.get(usize::from(j)).copied()).unwrap_or(Value::ZERO)
}

fn put<const N: usize>(values: &mut [Value; N], joint: Option<u8>, v: Value) {
    if let Some(place) = joint.and_then(|j| values.get_mut(usize::from(j))) {
        *place = v;
    }
}

/// The whole turns that respect the limits and lie nearest to `near` (or zero), with the distance to the nearest limit.
pub(super) fn fitted(q: f64, slides: bool, limits: Option<[f64; 2]>, near: Option<f64>) -> (f64, f64) {
    use core::f64::consts::TAU;
    let mut x = q;
    if !slides {
        let near = near.unwrap_or(0.0);
        x = q + TAU * whole((near - q) / TAU);
        if let Some([low, high]) = limits {
            let outside = |x: f64| (low - x).max(x - high);
            if outside(x) > 0.0 {
                // The nearest turn inside, from either side.
                let up = x + TAU * ceiling((low - 1e-9 - x) / TAU).max(0.0);
                let down = x - TAU * ceiling((x - high - 1e-9) / TAU).max(0.0);
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
    for (i, row) in pose.iter().enumerate() {
        for (j, x) in row.iter().enumerate() {
            // Beyond that squares overflow, and no arm is as long.
            if !(x.abs() < 1e100) {
                return Err(PoseError::NotFinite(i, j));
            }
        }
    }
    let mut t = Displacement::from_rows(pose);
    let defect = |r: &super::vector::Matrix| {
        let rr = product(&transposed(r), r);
        (0..9).fold(0.0f64, |m, k| m.max((rr[k / 3][k % 3] - IDENTITY[k / 3][k % 3]).abs()))
    };
    let d = defect(&t.rotation);
    let determinant = super::vector::dot(t.rotation[0], super::vector::cross(t.rotation[1], t.rotation[2]));
    if !(d <= 1e-6) || !(determinant > 0.0) {
        return Err(PoseError::NotARotation(if d <= 1e-6 { 2.0 } else { d }));
    }
    if d > 4e-16 {
        // Nearest rotation: R (3 - R'R) / 2, twice.
        for _ in 0..2 {
            let rr = product(&transposed(&t.rotation), &t.rotation);
            let k: super::vector::Matrix =
                core::array::from_fn(|i| core::array::from_fn(|j| 1.5 * IDENTITY[i][j] - 0.5 * rr[i][j]));
            t.rotation = product(&t.rotation, &k);
        }
    }
    Ok(t)
}
