//! `external_contact`: a wrench on the tool, in its frame, during a window of time.

use dh_codegen::robot::effects;

/// A push.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ExternalContact {
    /// s
    pub start: f64,
    /// s
    pub end: f64,
    /// Force and moment, tool frame.
    pub wrench: [f64; 6],
}

impl ExternalContact {
    /// `span`: begin and end of the motion, s.
    pub(crate) fn new(stated: &effects::ExternalContact, span: &std::ops::Range<f64>) -> Self {
        let third = (span.end - span.start) / 3.0;
        Self {
            start: stated.start.unwrap_or(span.start + third),
            end: stated.end.unwrap_or(span.end - third),
            wrench: stated.wrench(),
        }
    }

    /// How much of it acts at this time: it rises and falls in raised cosines of 20 ms, as no push
    /// is a step.
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

    /// Whether it acts at this time.
    pub fn acts(&self, t: f64) -> bool {
        (self.start..self.end).contains(&t)
    }
}
