//! Singular more than once: each sine is small but counts, and together they leave nothing of a
//! joint's digits. The pose is solved again with its last digits changed; what moves is not
//! determined by the pose.

use super::arm::{Arm, Query, Work};
use super::axis::{Axis, Value};
use super::candidates::{Candidates, IN_DOUBT};
use super::list::each;
use super::polish::{Rows, jacobian, moved, polish, remainder, sizes, slack, step};
use super::pose::Displacement;
use super::real::root;
use super::solution::{CAPACITY, Solutions};
use super::subproblem::FREE;
use super::vector::{Turn, add, norm, scale, unit};

/// How far the pose is moved, rad and parts of the arm's size: some roundings.
const SHIFT: f64 = 1e-15;
/// A joint that moves by more is free, rad or m.
const MOVES: f64 = 1e-6;
/// Ways it is moved.
const TRIES: usize = 6;
/// How far a posture must be able to move, rad or m.
const WAY: f64 = 1e-2;

impl<const N: usize> Arm<N> {
    /// Adds to each doubtful branch the joints that the pose does not determine, and clears the
    /// doubt.
    #[cold]
    #[inline(never)]
    pub(super) fn settle(&self, g: &Displacement, query: &Query<'_, N>, near: &[Value; N], all: &mut Candidates<N>) {
        let slides = |j: usize| self.axes.get(j).is_some_and(|a| a.slides);
        let list = |of: &Candidates<N>| {
            each([Value::ZERO; N], |place| if place < of.len { of.values(place, slides) } else { [Value::ZERO; N] })
        };
        let own: [[Value; N]; CAPACITY] = list(all);
        for k in 0..TRIES {
            let other = self.shaken(g, k);
            let mut moved: Candidates<N> = Candidates::new();
            self.candidates(&other, query, query.redundancy, near, &mut moved);
            let theirs: [[Value; N]; CAPACITY] = list(&moved);
            for (place, own) in own.iter().enumerate().take(all.len) {
                if all.kind(place).1 & IN_DOUBT == 0 {
                    continue;
                }
                let mut nearest: Option<(f64, u32)> = None;
                for there in theirs.iter().take(moved.len) {
                    let (mut far, mut bits) = (0.0f64, 0u32);
                    for (j, (a, b)) in own.iter().zip(there).enumerate() {
                        let d = (a.turn.c - b.turn.c).abs() + (a.turn.s - b.turn.s).abs() + (a.way - b.way).abs();
                        far = far.max(d);
                        bits |= u32::from(d > MOVES) << (j & 15);
                    }
                    if nearest.is_none_or(|(least, _)| far < least) {
                        nearest = Some((far, bits));
                    }
                }
                all.loosen(place, nearest.map_or(0, |(_, bits)| bits));
            }
        }
        all.be_sure();
    }

    /// A pose with its last digits changed.
    fn shaken(&self, g: &Displacement, k: usize) -> Displacement {
        let size = self.axes.iter().fold(norm(g.shift).max(norm(self.home.shift)), |m, a| m.max(norm(a.c)));
        // Axes of an icosahedron: no direction is far from one of them.
        let (s, l) = (if k < 3 { 1.0 } else { -1.0 }, 1.618_033_988_749_895);
        let [x, y, z] = [[0.0, s, l], [l, 0.0, s], [s, l, 0.0]][k % 3];
        let turn = Axis { slides: false, h: unit([x, y, z]), c: g.shift };
        let mut other = turn.displacement(Value::turn(Turn { c: 1.0, s: SHIFT })).after(g);
        other.shift = add(other.shift, scale(SHIFT * size, unit([y, z, -x])));
        other
    }

    /// If two double roots follow each other, rounding of the first may take the second out of
    /// reach, by its square root. Newton's steps hardly come back from there. A pose beside has the
    /// first root exactly. Called where nothing was found and little is missing.
    #[cold]
    #[inline(never)]
    pub(super) fn retry(
        &self,
        g: &Displacement,
        query: &Query<'_, N>,
        near: &[Value; N],
        out: &mut Solutions<N>,
        work: &mut Work,
    ) {
        let slides = |j: usize| self.axes.get(j).is_some_and(|a| a.slides);
        let lost = out.lost;
        for k in 0..TRIES {
            let mut beside: Candidates<N> = Candidates::new();
            self.candidates(&self.shaken(g, k), query, query.redundancy, near, &mut beside);
            for place in 0..beside.len {
                let (branch, free) = beside.kind(place);
                self.refine(g, query, beside.values(place, slides), (branch, free & !IN_DOUBT), out, work);
            }
        }
        out.lost = lost.saturating_sub(out.as_slice().len() as u32);
    }

    /// The joints of a posture that can move together without changing the pose: not at a turning
    /// point, where they can't go on.
    pub(super) fn freedom(&self, g: &Displacement, query: &Query<'_, N>, v: &[Value; N]) -> u32 {
        if self.family.is_searched() {
            return 0;
        }
        let size = self.axes.iter().fold(norm(self.home.shift), |m, a| m.max(norm(a.c)));
        let (_, row) = self.kept(query, v);
        let parts = jacobian(self, v);
        let columns: [Rows; N] = each([0.0; 7], |i| {
            let [a, b, c, d, e, f] = parts[i];
            [a, b, c, d, e, f, row[i]]
        });
        if !(slack(&columns, size, N) < FREE) {
            return 0;
        }
        // A motion of all joints, minus the least motion with the same effect: the difference has
        // no effect on the pose.
        let any: [f64; N] = each(0.0, |i| [1.0, -0.7, 0.9, 0.6, -0.8, 1.1, -0.5, 0.75][i & 7]);
        let done: Rows = each(0.0, |k| columns.iter().zip(&any).fold(0.0, |s, (c, x)| s + c[k] * x));
        let undone = step(&columns, &done, 1e-13);
        let idle: [f64; N] = each(0.0, |i| any[i] - undone[i]);
        let n = root(idle.iter().fold(0.0, |s, x| s + x * x));
        if !(n > 0.05) {
            return 0;
        }
        let mut on = moved(v, &idle.map(|x| x * WAY / n));
        // Only as many steps as it needs: more would lead it back to where it is a little better.
        let [mut p, mut r] = sizes(&remainder(self, g, &on));
        for _ in 0..query.steps.min(8) {
            if p.max(r) < FREE * WAY {
                break;
            }
            [p, r] = sizes(&polish(self, g, query, &mut on, 1));
        }
        let far = on.iter().zip(v).fold(0.0f64, |m, (a, b)| {
            m.max((a.turn.c - b.turn.c).abs() + (a.turn.s - b.turn.s).abs() + (a.way - b.way).abs())
        });
        if !(p.max(r) < FREE * WAY && far > 0.2 * WAY) {
            return 0;
        }
        (0..N).fold(0, |bits, j| bits | u32::from(idle[j].abs() > 1e-3 * n) << (j & 15))
    }
}
