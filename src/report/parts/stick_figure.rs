//! An arm as a stick figure, for animated pages: origins of its frames and centres of its spheres.

use crate::excite::Ball;

use crate::report::parts::number::short;

/// Figures at some instants.
pub(in crate::report) struct StickFigures<'a> {
    /// Top three rows of each frame's matrix at each instant: `((frame * 3 + row) * 4 + column) *
    /// len + s`, m.
    pub(in crate::report) frames: &'a [f64],
    /// Number of instants.
    pub(in crate::report) len: usize,
    /// Spheres on the arm.
    pub(in crate::report) balls: &'a [Ball],
}

impl StickFigures<'_> {
    fn at(&self, frame: usize, row: usize, column: usize, s: usize) -> f64 {
        self.frames[((frame * 3 + row) * 4 + column) * self.len + s]
    }

    /// Origins of the frames in the world frame, x y z each, m.
    pub(in crate::report) fn joints(&self, s: usize) -> Vec<f64> {
        let count = self.frames.len() / (12 * self.len.max(1));
        (0..count).flat_map(|f| [0, 1, 2].map(|i| short(self.at(f, i, 3, s), 3))).collect()
    }

    /// Centres of the spheres in the world frame, x y z each, m.
    pub(in crate::report) fn balls(&self, s: usize) -> Vec<f64> {
        self.balls.iter().flat_map(|ball| ball.placed(self.frames, self.len, s)).map(|x| short(x, 3)).collect()
    }
}
