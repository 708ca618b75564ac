//! Singular more than once: each sine is small but counts, and together they leave nothing of a joint's digits. The pose is solved
//! again with its last digits changed, and what moves is not told by the pose.

use super::arm::{Arm, Query};
use super::axis::{Axis, Value};
use super::candidates::{Candidates, IN_DOUBT};
use super::pose::Displacement;
use super::vector::{Turn, add, norm, scale, unit};

/// How far the pose is moved, rad and parts of the arm's size: some roundings.
const SHIFT: f64 = 1e-15;
/// A joint that moves by more is free, rad or m.
const MOVES: f64 = 1e-6;
/// Ways it is moved.
const TRIES: usize = 6;

impl<const N: usize> Arm<N> {
    /// Adds to each branch in doubt the joints that the pose does not tell, and takes the doubt away.
    #[cold]
    #[inline(never)]
    pub(super) fn settle(&self, g: &Displacement, query: &Query<'_, N>, near: &[Value; N], all: &mut Candidates<N>) {
        let slides = |j: usize| self.axes.get(j).is_some_and(|a| a.slides);
        let size = self.axes.iter().fold(norm(g.shift).max(norm(self.home.shift)), |m, a| m.max(norm(a.c)));
        for k in 0..TRIES {
            // Axes of an icosahedron: no direction is far from one of them.
            let (s, l) = (if k < 3 { 1.0 } else { -1.0 }, 1.618_033_988_749_895);
            let [x, y, z] = [[0.0, s, l], [l, 0.0, s], [s, l, 0.0]][k % 3];
            let turn = Axis { slides: false, h: unit([x, y, z]), c: g.shift };
            let mut other = turn.displacement(Value::turn(Turn { c: 1.0, s: SHIFT })).after(g);
            other.shift = add(other.shift, scale(SHIFT * size, unit([y, z, -x])));
            let mut moved: Candidates<N> = Candidates::new();
            self.candidates(&other, query, query.redundancy, near, &mut moved);
            for place in 0..all.len {
                if all.kind(place).1 & IN_DOUBT == 0 {
                    continue;
                }
                let own = all.values(place, slides);
                let mut nearest: Option<(f64, u32)> = None;
                for there in 0..moved.len {
                    let (mut far, mut bits) = (0.0f64, 0u32);
                    for (j, (a, b)) in own.iter().zip(&moved.values(there, slides)).enumerate() {
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
}
