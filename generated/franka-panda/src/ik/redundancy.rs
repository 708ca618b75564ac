//! Where the locked joint of a redundant arm may be: positions at which some posture respects the
//! limits. There is no closed form, as for a swivel angle: the distance to the limits is looked at,
//! and its zeros are bracketed.

use super::arm::{Arm, Query, checked};
use super::list::List;
use super::solution::PoseError;

/// Positions at which a pose is looked at.
const LOOKS: usize = 64;
/// Halvings of a bracket, and golden sections of a peak between looks.
const HALVINGS: usize = 40;
const SECTIONS: usize = 24;

/// From and to, rad or m.
pub type Range = [f64; 2];

/// Positions of a locked joint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ranges {
    /// At which some posture respects the limits, ascending.
    pub list: List<Range, { LOOKS + 1 }>,
    /// At which one stays farthest from them, and that distance, rad or m; `None` where the pose is
    /// out of reach or no position respects them.
    pub best: Option<(f64, f64)>,
}

impl<const N: usize> Arm<N> {
    /// Positions of the locked joint at which some posture of the pose respects the limits; `None`
    /// for an arm without such a joint. What is narrower than a 64th of the joint's range (its
    /// limits, else a turn, or a metre to either side) is found only where the distance to the
    /// limits has its peak or its dip there.
    ///
    /// # Errors
    /// Like [`Arm::solve`].
    pub fn locked_ranges(&self, pose: &[[f64; 4]; 3]) -> Result<Option<Ranges>, PoseError> {
        use core::f64::consts::PI;
        checked(pose)?;
        let Some(joint) = self.family.locked().map(usize::from) else { return Ok(None) };
        let slides = self.axes.get(joint).is_some_and(|a| a.slides);
        let own = self.limits.get(joint).copied().flatten();
        let [low, high] = own.unwrap_or(if slides { [-1.0, 1.0] } else { [-PI, PI] });
        // Far below zero where there is no posture: brackets need finite numbers.
        let margin = |at: f64| {
            let found = self.solve(pose, &Query { redundancy: at, ..Query::default() });
            let safest = found.as_ref().ok().and_then(|s| s.safest());
            safest.map_or(-1e3, |s| if s.within_limits { s.margin.max(0.0) } else { s.margin })
        };
        let mut at = [low; LOOKS + 1];
        let mut looks = [0.0; LOOKS + 1];
        for (k, (at, look)) in at.iter_mut().zip(&mut looks).enumerate() {
            *at = low + (high - low) * k as f64 / LOOKS as f64;
            *look = margin(*at);
        }
        let mut out = Ranges { list: List::new([0.0; 2]), best: None };
        // Between an allowed position and one that is not: the last allowed one.
        let end = |mut inside: f64, mut outside: f64| {
            for _ in 0..HALVINGS {
                let middle = 0.5 * (inside + outside);
                if margin(middle) >= 0.0 { inside = middle } else { outside = middle }
            }
            inside
        };
        // The highest (or lowest) place between two.
        let peak = |mut a: f64, mut b: f64, sign: f64| {
            const GOLDEN: f64 = 0.618_033_988_749_894_9;
            for _ in 0..SECTIONS {
                let (x, y) = (b - GOLDEN * (b - a), a + GOLDEN * (b - a));
                if sign * margin(x) > sign * margin(y) { b = y } else { a = x }
            }
            0.5 * (a + b)
        };
        let mut open = (looks[0] >= 0.0).then_some(low);
        let mut best = (0, f64::NEG_INFINITY);
        for k in 0..=LOOKS {
            let here = looks[k];
            if here >= 0.0 && out.best.is_none_or(|(_, most)| here > most) {
                out.best = Some((at[k], here));
            }
            if here > best.1 {
                best = (k, here);
            }
            if k == LOOKS {
                break;
            }
            let next = looks[k + 1];
            match (here >= 0.0, next >= 0.0) {
                (true, false) => {
                    let from = open.take().unwrap_or(at[k]);
                    out.list.push([from, end(at[k], at[k + 1])]);
                }
                (false, true) => open = Some(end(at[k + 1], at[k])),
                (inside, _) => {
                    // A peak or a dip between neighbours.
                    let sign = if inside { -1.0 } else { 1.0 };
                    let before = if k > 0 { looks[k - 1] } else { here };
                    let after = if k + 2 <= LOOKS { looks[k + 2] } else { next };
                    if !(sign * (here - before) >= 0.0 && sign * (next - after) >= 0.0) || here == -1e3 && next == -1e3
                    {
                        continue;
                    }
                    let top = peak(at[k], at[k + 1], sign);
                    let m = margin(top);
                    if inside && m < 0.0 {
                        let from = open.take().unwrap_or(at[k]);
                        out.list.push([from, end(at[k], top)]);
                        open = Some(end(at[k + 1], top));
                    } else if !inside && m >= 0.0 {
                        out.list.push([end(top, at[k]), end(top, at[k + 1])]);
                        if out.best.is_none_or(|(_, most)| m > most) {
                            out.best = Some((top, m));
                        }
                    }
                }
            }
        }
        if let Some(from) = open {
            out.list.push([from, high]);
        }
        if let Some((_, most)) = out.best {
            let k = best.0;
            let (a, b) = (at[k.saturating_sub(1).min(LOOKS)], at[(k + 1).min(LOOKS)]);
            let top = peak(a, b, 1.0);
            let m = margin(top);
            if m > most {
                out.best = Some((top, m));
            }
        }
        Ok(Some(out))
    }
}
