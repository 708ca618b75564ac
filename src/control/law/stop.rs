//! Stop along the planned path, and detection of an arm at rest.

use super::settings::Target;

/// Follows the plan's path from a point on, to second order, at a decreasing pace.
///
/// The ratio of path time to clock time decreases from 1 to 0 by a cubic in `within` seconds;
/// velocity and acceleration stay continuous. The plan beyond the point is not needed: the path
/// advances by half of `within` in all.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct PathStop<const N: usize> {
    from: Target<N>,
    within: f64,
    /// Time since the stop began, s; `along` is the path time since then.
    clock: f64,
    along: f64,
}

impl<const N: usize> PathStop<N> {
    pub(super) fn new(from: Target<N>, within: f64) -> Self {
        Self { from, within, clock: 0.0, along: 0.0 }
    }

    pub(super) fn is_over(&self) -> bool {
        self.clock >= self.within
    }

    /// Target after `dt`, s.
    pub(super) fn step(&mut self, dt: f64) -> Target<N> {
        let [before, _] = self.pace();
        self.clock = (self.clock + dt).min(self.within);
        let [pace, change] = self.pace();
        self.along += 0.5 * (before + pace) * dt;
        let Target { q, dq, ddq, .. } = self.from;
        let s = self.along;
        Target {
            q: core::array::from_fn(|j| q[j] + s * dq[j] + 0.5 * s * s * ddq[j]),
            dq: core::array::from_fn(|j| pace * (dq[j] + s * ddq[j])),
            ddq: core::array::from_fn(|j| change * (dq[j] + s * ddq[j]) + pace * pace * ddq[j]),
            ..self.from
        }
    }

    /// Path time per clock time, and its derivative, 1/s.
    fn pace(&self) -> [f64; 2] {
        let s = (self.clock / self.within).min(1.0);
        [1.0 - s * s * (3.0 - 2.0 * s), -6.0 * s * (1.0 - s) / self.within]
    }
}

/// Number of steps within the travel after which the arm is at rest.
const RESTS: u32 = 32;

/// Detects that all joints are at rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Still<const N: usize> {
    about: [f64; N],
    within: u32,
}

impl<const N: usize> Still<N> {
    pub(super) const NONE: Self = Self { about: [f64::NAN; N], within: 0 };

    /// Whether no joint has left the travel of two periods at its speed limit for some time: a mean
    /// speed below 1/16 of the limit.
    pub(super) fn step(&mut self, q: &[f64; N], velocity: &[f64; N], period: f64) -> bool {
        let stays = (0..N).all(|j| (q[j] - self.about[j]).abs() <= 2.0 * velocity[j] * period);
        (self.about, self.within) = if stays { (self.about, self.within.saturating_add(1)) } else { (*q, 0) };
        self.within >= RESTS
    }
}
