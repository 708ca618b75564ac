//! Arms without a closed form: damped least squares (Levenberg-Marquardt; Buss 2004) from many
//! starts.

use super::arm::{Arm, Query};
use super::axis::Value;
use super::candidates::Candidates;
use super::list::each;
use super::polish::{polish, sizes, values};
use super::pose::Displacement;
use super::solution::{Branch, CAPACITY};

/// Starts; every one gets as many steps.
const STARTS: u64 = 48;
const STEPS: usize = 80;

/// Results of different starts. The first is the near posture, or the middle; the others are the
/// same for every pose.
pub(super) fn search<const N: usize>(
    arm: &Arm<N>,
    g: &Displacement,
    query: &Query<'_, N>,
    near: &[Value; N],
    all: &mut Candidates<N>,
) {
    let mut state = 0x9E37_79B9_7F4A_7C15u64;
    let slides = |j: usize| arm.axes[j].slides;
    let mut closest: Option<(f64, [Value; N])> = None;
    for start in 0..STARTS {
        let mut v = *near;
        if start > 0 || query.near.is_none() {
            let q = each(0.0, |i| {
                state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                let unit = if start == 0 { 0.5 } else { (state >> 11) as f64 / (1u64 << 53) as f64 };
                let [low, high] = arm.limits[i].unwrap_or(if arm.axes[i].slides { [-1.0, 1.0] } else { [-3.1, 3.1] });
                low + (high - low) * unit
            });
            v = values(arm, &q);
        }
        let [p, r] = sizes(&polish(arm, g, query, &mut v, STEPS));
        let branch = |root: usize| Branch { numerical: true, root: root as u8 + 1, ..Branch::NONE };
        if p.max(r) <= 1e-12 {
            let same = |place: usize| {
                let other = all.values(place, slides);
                (0..N).all(|i| {
                    let (a, b) = (other[i], v[i]);
                    (a.turn.c - b.turn.c).abs() + (a.turn.s - b.turn.s).abs() < 1e-6
                        && (!arm.axes[i].slides || (a.way - b.way).abs() < 1e-6)
                })
            };
            if !(0..all.len).any(same) {
                all.push_all(&v, slides, branch(all.len), 0);
                if all.len == CAPACITY {
                    return;
                }
            }
        } else if closest.is_none_or(|(d, _)| p + r < d) {
            closest = Some((p + r, v));
        }
    }
    if let (true, Some((_, v))) = (all.len == 0, closest) {
        all.push_all(&v, slides, Branch { numerical: true, root: 1, ..Branch::NONE }, 0);
    }
}
