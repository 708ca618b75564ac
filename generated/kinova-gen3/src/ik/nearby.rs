//! Arms that are only nearly of their family. Each posture of the nominal arm is refined to one of
//! the real arm. Away from singularities that is all. Near a singularity two postures may merge or
//! vanish, and the real arm may have other postures than the nominal one. There every nominal
//! posture is also followed to the real arm's along a curve that passes turning points, and around
//! the curve that remains of the singular arm's family of postures. The same is done for every
//! branch found there, for postures at other swivel angles and at poses beside.

use super::arm::{Arm, Family, Query, Work};
use super::axis::{Axis, Value};
use super::candidates::Candidates;
use super::homotopy::{around, walk};
use super::polish::{equations, polish, remainder, sizes, slack, values};
use super::pose::Displacement;
use super::solution::Solutions;
use super::vector::{Turn, add, norm, unit};

/// How far a curve is followed beyond what the nominal arm misses by.
const FAR: f64 = 3.0;
/// Other swivel angles, or poses beside, that are tried.
const ELSEWHERE: usize = 15;
/// Of these, beside a singularity where nothing is missing.
const EVERY: usize = 5;
/// Below this a Jacobian (of the arm's own size) is near a singularity.
const REGULAR: f64 = 0.04;
/// Pose error beyond which the nominal arm has no posture, parts of its size and rad; beyond it,
/// the real one has none either.
const OUT_OF_REACH: f64 = 0.15;

/// How many postures fewer there are than the nominal arm has, and at least one where their number
/// is odd: they come and go in pairs.
fn missing<const N: usize>(wanted: usize, out: &Solutions<N>) -> u32 {
    let found = out.list.len();
    let odd = N >= 6 && found % 2 == 1;
    (wanted as u32).saturating_sub(found as u32).max(u32::from(odd))
}

impl<const N: usize> Arm<N> {
    /// Postures reached from the nominal ones, beside those already found. `lost`: how many are
    /// [`missing`].
    #[cold]
    #[inline(never)]
    pub(super) fn search_nearby(
        &self,
        g: &Displacement,
        query: &Query<'_, N>,
        near: &[Value; N],
        nominal: &Candidates<N>,
        out: &mut Solutions<N>,
        work: &mut Work,
    ) {
        let slides = |j: usize| self.axes.get(j).is_some_and(|a| a.slides);
        let size = self.axes.iter().fold(norm(self.home.shift), |m, a| m.max(norm(a.c)));
        let mut opposite: Candidates<N> = Candidates::new();
        if self.family.is_swivel() {
            // As the elbow passes through the line from shoulder to wrist, its swivel angle jumps
            // by half a turn.
            let half = query.redundancy + core::f64::consts::PI;
            self.candidates(g, query, half, near, &mut opposite);
            for place in 0..opposite.len {
                self.refine(g, query, opposite.values(place, slides), opposite.kind(place), out, work);
            }
        }
        let ideal = self.nominal();
        let (mut wanted, mut narrow) = (0usize, false);
        for (k, all) in [nominal, &opposite].into_iter().enumerate() {
            for place in 0..all.len {
                let (start, kind) = (all.values(place, slides), all.kind(place));
                let [p, r] = sizes(&remainder(&ideal, g, &start));
                wanted += usize::from(k == 0 && p.max(r) < 1e-6);
                let reached = p < OUT_OF_REACH * size && r < OUT_OF_REACH;
                if reached && slack(&equations(self, g, query, &start).1, size, N) < REGULAR {
                    narrow = true;
                    walk(self, g, query, &start, &[-1.0, 1.0], FAR, |v| {
                        self.refine(g, query, v, kind, out, work);
                    });
                    around(self, g, query, &start, |v| self.refine(g, query, v, kind, out, work));
                }
            }
        }
        // A posture found beside a singularity is followed around it, too.
        let mut at = 0;
        while let Some(found) = out.list.as_slice().get(at).copied() {
            let start = values(self, &found.q);
            if slack(&equations(self, g, query, &start).1, size, N) < REGULAR {
                narrow = true;
                let kind = (found.branch, found.free);
                around(self, g, query, &start, |v| self.refine(g, query, v, kind, out, work));
            }
            at += 1;
        }
        for k in 1..=ELSEWHERE {
            if narrow && (k % EVERY == 0 || out.list.is_empty()) || missing(wanted, out) > 0 {
                self.search_elsewhere(k, (g, size), query, near, out, work);
            }
        }
        out.lost = missing(wanted, out);
        out.uncertain = narrow;
    }

    /// From postures at another swivel angle, and at a pose beside.
    fn search_elsewhere(
        &self,
        k: usize,
        (g, size): (&Displacement, f64),
        query: &Query<'_, N>,
        near: &[Value; N],
        out: &mut Solutions<N>,
        work: &mut Work,
    ) {
        let slides = |j: usize| self.axes.get(j).is_some_and(|a| a.slides);
        let mut all: Candidates<N> = Candidates::new();
        if self.family.is_swivel() {
            // The real arm's own postures at another angle: from there it turns about the line from
            // shoulder to wrist.
            let angle = query.redundancy + core::f64::consts::TAU * k as f64 / (ELSEWHERE + 1) as f64;
            let other = Query { redundancy: angle, ..*query };
            self.candidates(g, &other, angle, near, &mut all);
            for place in 0..all.len {
                let mut start = all.values(place, slides);
                let [p, r] = sizes(&polish(self, g, &other, &mut start, 20));
                if p.max(r) < 1e-9 {
                    walk(self, g, query, &start, &[-1.0], f64::INFINITY, |v| {
                        self.refine(g, query, v, all.kind(place), out, work);
                    });
                }
            }
        }
        // Towards the corners of a cube, nearest first.
        let sign = |bit: usize| if k >> bit & 1 == 0 { 1.0 } else { -1.0 };
        let reach = (k + 1) as f64 / ELSEWHERE as f64;
        let axis = Axis { slides: false, h: unit([sign(1), sign(2), sign(0)]), c: g.shift };
        let mut beside = axis.displacement(Value::turn(Turn::along(1.0, 0.15 * reach).0)).after(g);
        beside.shift = add(beside.shift, [0, 1, 2].map(|i| 0.02 * size * reach * sign(i)));
        let mut all: Candidates<N> = Candidates::new();
        self.candidates(&beside, query, query.redundancy, near, &mut all);
        for place in 0..all.len {
            let start = all.values(place, slides);
            let [p, r] = sizes(&remainder(self, g, &start));
            if p < 2.0 * OUT_OF_REACH * size && r < 2.0 * OUT_OF_REACH {
                walk(self, g, query, &start, &[-1.0], 1.5, |v| self.refine(g, query, v, all.kind(place), out, work));
                self.refine(g, query, start, all.kind(place), out, work);
            }
        }
    }

    /// The arm whose closed form is used.
    fn nominal(&self) -> Self {
        let mut ideal = *self;
        let mut put = |joint: Option<u8>, axis: Axis| {
            if let Some(place) = joint.and_then(|j| ideal.axes.get_mut(usize::from(j))) {
                *place = axis;
            }
        };
        match &self.family {
            Family::Swivel(swivel) => {
                for (axis, joint) in swivel.axes.iter().zip(0..) {
                    put(Some(joint), *axis);
                }
            }
            // No closed form of a nominal arm: slides alone, and search.
            _ => {}
        }
        ideal
    }
}
