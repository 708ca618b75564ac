//! Where no closed form is known: damped least squares (Levenberg-Marquardt; Buss 2004) from many starts.

use super::arm::{Arm, Candidate, Query};
use super::axis::Value;
use super::list::List;
use super::polish::{polish, sizes, values};
use super::pose::Displacement;
use super::solution::{Branch, CAPACITY};

/// Starts; every one gets as many steps.
const STARTS: u64 = 48;
const STEPS: usize = 80;

/// What different starts come to. The first is the near posture, or the middle; the others are the same for every pose.
pub(super) fn search<const N: usize>(
    arm: &Arm<N>,
    g: &Displacement,
    query: &Query<'_, N>,
    near: &[Value; N],
    all: &mut List<Candidate<N>, 17>,
) {
    let mut state = 0x9E37_79B9_7F4A_7C15u64;
    let mut closest: Option<(f64, Candidate<N>)> = None;
    for start in 0..STARTS {
        let mut v = *near;
        if start > 0 || query.near.is_none() {
            let q = core::array::from_fn(|i| {
                state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                let unit = if start == 0 { 0.5 } else { (state >> 11) as f64 / (1u64 << 53) as f64 };
                let [low, high] = arm.limits[i].unwrap_or(if arm.axes[i].slides { [-1.0, 1.0] } else { [-3.1, 3.1] });
                low + (high - low) * unit
            });
            v = values(arm, &q);
        }
        let [p, r] = sizes(&polish(arm, g, &mut v, None, STEPS));
        let branch = Branch { numerical: true, root: all.len() as u8 + 1, ..Branch::NONE };
        let candidate = Candidate { values: v, branch, free: 0 };
        if p.max(r) <= 1e-12 {
            let same = |c: &Candidate<N>| {
                (0..N).all(|i| {
                    let (a, b) = (c.values[i], v[i]);
                    (a.turn.c - b.turn.c).abs() + (a.turn.s - b.turn.s).abs() < 1e-6
                        && (!arm.axes[i].slides || (a.way - b.way).abs() < 1e-6)
                })
            };
            if !all.iter().any(same) && (!all.push(candidate) || all.len() == CAPACITY) {
                return;
            }
        } else if closest.is_none_or(|(d, _)| p + r < d) {
            closest = Some((p + r, candidate));
        }
    }
    if let (true, Some((_, candidate))) = (all.is_empty(), closest) {
        all.push(candidate);
    }
}
