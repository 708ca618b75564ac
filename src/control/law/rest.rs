//! Detection of joints at rest, whose friction is an interval and not a function of the motion.

/// Time within the travel after which a joint stands, s: longer than a friction reversal takes in a
/// motion (0.1 s).
const STANDS: f64 = 0.3;

/// Monitors the travel of each joint. Uses positions alone: at rest, sign and size of the velocity
/// are encoder noise.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Rest<const N: usize> {
    travel: [f64; N],
    about: [f64; N],
    /// Time since each joint left its travel about a position, s.
    within: [f64; N],
}

impl<const N: usize> Rest<N> {
    /// Creates a detector; a joint stands that moves no more than `travel` for some time, rad or m.
    /// 0: it never stands.
    pub(super) fn new(travel: [f64; N]) -> Self {
        Self { travel, about: [f64::NAN; N], within: [0.0; N] }
    }

    /// Processes positions, `dt` s after the previous ones; returns whether each joint stands.
    pub(super) fn step(&mut self, q: &[f64; N], dt: f64) -> [bool; N] {
        for j in 0..N {
            let stays = (q[j] - self.about[j]).abs() <= self.travel[j];
            (self.about[j], self.within[j]) = if stays { (self.about[j], self.within[j] + dt) } else { (q[j], 0.0) };
        }
        core::array::from_fn(|j| self.travel[j] > 0.0 && self.within[j] >= STANDS)
    }
}
