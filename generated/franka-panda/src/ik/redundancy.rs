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

/// Positions that were looked at, and the distance to the limits there.
struct Looks {
    at: [f64; LOOKS + 1],
    margin: [f64; LOOKS + 1],
}

/// The distance where there is no posture: brackets need finite numbers.
const NOWHERE: f64 = -1e3;

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
        let margin = |at: f64| {
            let found = self.solve(pose, &Query { redundancy: at, ..Query::default() });
            let safest = found.as_ref().ok().and_then(|s| s.safest());
            safest.map_or(NOWHERE, |s| if s.within_limits { s.margin.max(0.0) } else { s.margin })
        };
        let mut looks = Looks { at: [low; LOOKS + 1], margin: [0.0; LOOKS + 1] };
        for (k, (at, here)) in looks.at.iter_mut().zip(&mut looks.margin).enumerate() {
            *at = low + (high - low) * k as f64 / LOOKS as f64;
            *here = margin(*at);
        }
        Ok(Some(looks.ranges(margin)))
    }
}

impl Looks {
    fn ranges(&self, margin: impl Fn(f64) -> f64) -> Ranges {
        let mut out = Ranges { list: List::new([0.0; 2]), best: None };
        let mut open = (self.margin[0] >= 0.0).then_some(self.at[0]);
        for k in 0..LOOKS {
            let (from, to) = (self.at[k], self.at[k + 1]);
            match (self.margin[k] >= 0.0, self.margin[k + 1] >= 0.0) {
                (true, false) => {
                    out.list.push([open.take().unwrap_or(from), end(&margin, from, to)]);
                }
                (false, true) => open = Some(end(&margin, to, from)),
                (inside, _) => {
                    // A dip or a peak between neighbours.
                    let sign = if inside { -1.0 } else { 1.0 };
                    let Some(top) = self.turns(k, sign).then(|| peak(&margin, from, to, sign)) else { continue };
                    let m = margin(top);
                    if inside && m < 0.0 {
                        out.list.push([open.take().unwrap_or(from), end(&margin, from, top)]);
                        open = Some(end(&margin, to, top));
                    } else if !inside && m >= 0.0 {
                        out.list.push([end(&margin, top, from), end(&margin, top, to)]);
                        out.offer(top, m);
                    }
                }
            }
        }
        if let Some(from) = open {
            out.list.push([from, self.at[LOOKS]]);
        }
        let mut most = (0, f64::NEG_INFINITY);
        for (k, (at, m)) in self.at.iter().zip(&self.margin).enumerate() {
            out.offer(*at, *m);
            most = if *m > most.1 { (k, *m) } else { most };
        }
        let beside = |k: usize| self.at.get(k).copied();
        if let (Some(from), Some(to)) = (beside(most.0.saturating_sub(1)), beside((most.0 + 1).min(LOOKS))) {
            let top = peak(&margin, from, to, 1.0);
            out.offer(top, margin(top));
        }
        out
    }

    /// May the distance have a peak (or a dip) behind this look?
    fn turns(&self, k: usize, sign: f64) -> bool {
        let look = |k: usize| self.margin.get(k).copied();
        let (Some(here), Some(next)) = (look(k), look(k + 1)) else { return false };
        let (before, after) = (look(k.wrapping_sub(1)).unwrap_or(here), look(k + 2).unwrap_or(next));
        let nowhere = here == NOWHERE && next == NOWHERE;
        sign * (here - before) >= 0.0 && sign * (next - after) >= 0.0 && !nowhere
    }
}

impl Ranges {
    /// A position that may be better than the best so far.
    fn offer(&mut self, at: f64, margin: f64) {
        if margin >= 0.0 && self.best.is_none_or(|(_, most)| margin > most) {
            self.best = Some((at, margin));
        }
    }
}

/// Between an allowed position and one that is not: the last allowed one.
fn end(margin: impl Fn(f64) -> f64, mut inside: f64, mut outside: f64) -> f64 {
    for _ in 0..HALVINGS {
        let middle = 0.5 * (inside + outside);
        if margin(middle) >= 0.0 { inside = middle } else { outside = middle }
    }
    inside
}

/// The highest place between two; with the other sign the lowest.
fn peak(margin: impl Fn(f64) -> f64, mut a: f64, mut b: f64, sign: f64) -> f64 {
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    for _ in 0..SECTIONS {
        let (x, y) = (b - GOLDEN * (b - a), a + GOLDEN * (b - a));
        if sign * margin(x) > sign * margin(y) { b = y } else { a = x }
    }
    0.5 * (a + b)
}
