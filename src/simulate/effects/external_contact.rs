//! `external_contact`: a wrench on the tool during a time window, or a wall.

use dh_codegen::robot::effects;

use crate::simulate::Wall;

/// A push, a wall, or both.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ExternalContact {
    /// Start, s.
    pub start: f64,
    /// End, s.
    pub end: f64,
    /// Force (N) and moment (N m) about the origin of the tool's frame.
    pub wrench: [f64; 6],
    /// Whether the wrench is in the axes of the base, else in those of the tool.
    pub in_base: bool,
    /// Wall, which acts at any time.
    pub wall: Option<Wall>,
}

impl ExternalContact {
    /// `span`: start and end of the motion, s. The default window is its middle third.
    pub(crate) fn new(stated: &effects::ExternalContact, span: &std::ops::Range<f64>) -> Self {
        let third = (span.end - span.start) / 3.0;
        Self {
            start: stated.start.unwrap_or(span.start + third),
            end: stated.end.unwrap_or(span.end - third),
            wrench: stated.wrench(),
            in_base: stated.base() > 0.5,
            wall: (stated.stiffness() > 0.0).then(|| {
                let normal = stated.normal();
                let length = normal.iter().map(|n| n * n).sum::<f64>().sqrt();
                let point = normal.map(|n| n / length * stated.at());
                Wall { stiffness: stated.stiffness(), damping: 0.0, ..Wall::new(point, normal) }
            }),
        }
    }

    /// Share of the wrench at time `t`: rises and falls as raised cosines of 20 ms, since no real
    /// push is a step.
    pub fn share(&self, t: f64) -> f64 {
        const RISE: f64 = 0.02;
        let rise = RISE.min(0.5 * (self.end - self.start));
        let inside = (t - self.start).min(self.end - t);
        if inside <= 0.0 {
            return 0.0;
        }
        if inside >= rise {
            return 1.0;
        }
        0.5 - 0.5 * libm::cos(std::f64::consts::PI * inside / rise)
    }

    /// Whether the contact can act at this time.
    pub fn acts(&self, t: f64) -> bool {
        self.wall.is_some() || (self.start..self.end).contains(&t)
    }
}
