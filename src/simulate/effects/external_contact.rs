//! `external_contact`: a wrench on the tool or a link during a time window, or a wall.

use dh_codegen::robot::effects;

use crate::simulate::Wall;

/// A push, a wall, or both.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ExternalContact {
    /// Start, s.
    pub start: f64,
    /// End, s.
    pub end: f64,
    /// Time in which the wrench rises after the start and falls before the end, s. At most half of the
    /// duration counts.
    pub rise: f64,
    /// Force (N) and moment (N m) about the origin of the tool's frame, or the far end of the link.
    pub wrench: [f64; 6],
    /// Whether the wrench is in the axes of the base, else in those of the tool or the touched link.
    pub in_base: bool,
    /// Row of the touched link, from 0; `None`: the tool is touched.
    pub link: Option<usize>,
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
            rise: stated.rise(),
            wrench: stated.wrench(),
            in_base: stated.base() > 0.5,
            link: stated.link.and_then(|link| link.checked_sub(1)),
            wall: (stated.stiffness() > 0.0).then(|| {
                let normal = stated.normal();
                let length = normal.iter().map(|n| n * n).sum::<f64>().sqrt();
                let point = normal.map(|n| n / length * stated.at());
                Wall { stiffness: stated.stiffness(), damping: 0.0, ..Wall::new(point, normal) }
            }),
        }
    }

    /// Share of the wrench at time `t`: rises and falls as raised cosines, since no real push is a step.
    pub fn share(&self, t: f64) -> f64 {
        let rise = self.rise.min(0.5 * (self.end - self.start));
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

#[cfg(test)]
mod tests {
    use super::*;

    /// A wrench that rises for half of its duration, or as steep as a push by default.
    #[test]
    fn a_wrench_rises_and_falls() {
        let stated = effects::ExternalContact { start: Some(1.0), end: Some(2.0), ..Default::default() };
        let contact = |stated: effects::ExternalContact| ExternalContact::new(&stated, &(0.0..3.0));
        let of = |rise: f64| contact(effects::ExternalContact { rise: Some(rise), ..stated });
        let shares = |contact: ExternalContact| [0.9, 1.0, 1.25, 1.5, 1.75, 2.1].map(|t| contact.share(t));
        for rise in [0.5, 9.0] {
            for (share, wanted) in shares(of(rise)).into_iter().zip([0.0, 0.0, 0.5, 1.0, 0.5, 0.0]) {
                assert!((share - wanted).abs() < 1e-12, "{share} {wanted}");
            }
        }
        assert_eq!(shares(of(0.0)), [0.0, 0.0, 1.0, 1.0, 1.0, 0.0]);
        let steep = contact(stated);
        assert!(steep.share(1.02) == 1.0 && (steep.share(1.99) - 0.5).abs() < 1e-9);
    }
}
