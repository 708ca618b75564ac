//! Finds the joints that stand, so that their friction is an interval and not a function of the
//! motion.

/// Time within the travel after which a joint stands, s: longer than friction takes to turn round
/// in a motion (0.1 s).
const STANDS: f64 = 0.3;

/// Watches the travel of each joint. Positions alone: at rest the sign and the size of a speed are
/// the encoder's noise.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Rest<const N: usize> {
    travel: [f64; N],
    about: [f64; N],
    /// Time since each joint left the travel about a position, s.
    within: [f64; N],
}

impl<const N: usize> Rest<N> {
    /// Joints stand that move no more than this for some time, rad or m; 0: they never stand.
    pub(super) fn new(travel: [f64; N]) -> Self {
        Self { travel, about: [f64::NAN; N], within: [0.0; N] }
    }

    /// Takes in positions, `dt` s after those before; whether each joint stands.
    pub(super) fn step(&mut self, q: &[f64; N], dt: f64) -> [bool; N] {
        for j in 0..N {
            let stays = (q[j] - self.about[j]).abs() <= self.travel[j];
            (self.about[j], self.within[j]) = if stays { (self.about[j], self.within[j] + dt) } else { (q[j], 0.0) };
        }
        core::array::from_fn(|j| self.travel[j] > 0.0 && self.within[j] >= STANDS)
    }
}
