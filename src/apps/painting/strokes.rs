//! The painting motion on the wall: lanes (the paper's Fig. 7) and the legs between its way points.

use super::surface::Surface;

/// Order in which the way points are visited.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Pattern {
    /// The paper's cycle: down and up again on each lane, then across to the next at the top.
    Cycle,
    /// Down one lane, across, up the next: half as long.
    Snake,
}

/// Action of the roller on a leg.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Phase {
    /// From the start before the wall to the wall.
    Approach,
    /// Along a lane, in contact.
    Stroke,
    /// Across to the next lane, in contact.
    Shift,
    /// Off the wall.
    Retreat,
}

impl Phase {
    /// Name in files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Approach => "approach",
            Self::Stroke => "stroke",
            Self::Shift => "shift",
            Self::Retreat => "retreat",
        }
    }

    /// The phase with this name.
    pub fn named(name: &str) -> Option<Self> {
        [Self::Approach, Self::Stroke, Self::Shift, Self::Retreat].into_iter().find(|p| p.name() == name)
    }

    /// Whether the roller touches the wall.
    pub fn contact(self) -> bool {
        matches!(self, Self::Stroke | Self::Shift)
    }
}

/// The lanes: four of the six variables of equation (12), in wall coordinates, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Strokes {
    /// `Z_u`: upper end of the strokes.
    pub upper: f64,
    /// `Z_l`: lower end of the strokes.
    pub lower: f64,
    /// `Y_0`: middle of the first lane.
    pub first: f64,
    /// `dY`: distance from one lane to the next, signed.
    pub step: f64,
    /// Number of lanes: `N_r + 1` with the paper's cycle, which returns to `Z_u` before each step.
    pub lanes: usize,
    /// Order in which the lanes are painted.
    pub pattern: Pattern,
}

/// A straight leg of the motion, from rest to rest: wall coordinates and distance from the wall, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Leg {
    /// Action of the roller.
    pub phase: Phase,
    /// Start: `[y, z, distance]`.
    pub from: [f64; 3],
    /// End: `[y, z, distance]`.
    pub to: [f64; 3],
}

impl Strokes {
    /// Smallest number of lanes that cover a wall with a roller of this width, m.
    pub fn fewest(surface: &Surface, width: f64) -> usize {
        (surface.width / width - 1e-9).ceil().max(1.0) as usize
    }

    /// Middle of a lane, m.
    pub fn lane(&self, k: usize) -> f64 {
        self.first + self.step * k as f64
    }

    /// Painted rectangle, `[least y, largest y, least z, largest z]`, m, for a roller of this
    /// width, m. It has no gaps if `|dY|` is at most the width.
    pub fn painted(&self, width: f64) -> [f64; 4] {
        let (a, b) = (self.lane(0), self.lane(self.lanes.saturating_sub(1)));
        [a.min(b) - 0.5 * width, a.max(b) + 0.5 * width, self.lower, self.upper]
    }

    /// All legs, starting and ending `standoff` m before the wall.
    pub fn legs(&self, standoff: f64) -> Vec<Leg> {
        let mut legs = Vec::new();
        let mut here = [self.first, self.upper, standoff];
        let mut go = |phase: Phase, to: [f64; 3]| {
            if here != to {
                legs.push(Leg { phase, from: here, to });
            }
            here = to;
        };
        go(Phase::Approach, [self.first, self.upper, 0.0]);
        let mut high = true;
        for k in 0..self.lanes {
            let y = self.lane(k);
            if k > 0 {
                go(Phase::Shift, [y, if high { self.upper } else { self.lower }, 0.0]);
            }
            high = !high;
            go(Phase::Stroke, [y, if high { self.upper } else { self.lower }, 0.0]);
            if self.pattern == Pattern::Cycle {
                high = true;
                go(Phase::Stroke, [y, self.upper, 0.0]);
            }
        }
        let last = self.lane(self.lanes.saturating_sub(1));
        go(Phase::Retreat, [last, if high { self.upper } else { self.lower }, standoff]);
        legs
    }
}

/// Position, speed, acceleration and jerk, as shares of a leg, at a share `u` of its time. This is
/// the quintic from rest to rest, which has the least jerk (Flash and Hogan, J. Neuroscience 5,
/// 1985). As a B-spline of fifth order it is one interval with control points `0 0 0 1 1 1`.
pub(super) fn rest_to_rest(u: f64) -> [f64; 4] {
    let (u2, v) = (u * u, 1.0 - u);
    [
        u2 * u * (10.0 - 15.0 * u + 6.0 * u2),
        30.0 * u2 * v * v,
        60.0 * u * v * (1.0 - 2.0 * u),
        60.0 * (1.0 - 6.0 * u * v),
    ]
}
