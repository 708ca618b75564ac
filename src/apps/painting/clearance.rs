//! Clearance while painting: of the arm from itself, the ground and boxes, and of everything but
//! the roller from the wall.

use crate::excite::Bodies;
use crate::model::{FrameKinematics, States};

use super::surface::Surface;
use super::vector::dot;

/// A monitored distance.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Watch {
    Ground(usize),
    Pair(usize, usize),
    Block(usize, usize),
    Wall(usize),
}

/// All monitored distances.
#[derive(Debug, Clone)]
pub(super) struct Clearance {
    bodies: Bodies,
    surface: Surface,
    /// Required distance, m.
    margin: f64,
    list: Vec<Watch>,
}

impl Clearance {
    /// Collects the distances, without those that do not depend on the posture.
    pub(super) fn new(arm: &dyn FrameKinematics, bodies: Bodies, surface: Surface, margin: f64) -> Self {
        let mut list: Vec<Watch> = Vec::new();
        if let Some((_, frames)) = &bodies.ground {
            list.extend(frames.iter().map(|&f| Watch::Ground(f)));
        }
        list.extend(bodies.pairs.iter().map(|&(a, b)| Watch::Pair(a, b)));
        list.extend(bodies.blocked.iter().map(|&(a, b)| Watch::Block(a, b)));
        list.extend((0..bodies.balls.len()).filter(|&b| bodies.balls[b].frame.is_some()).map(Watch::Wall));
        let mut all = Self { bodies, surface, margin, list };
        let (n, len) = (arm.dof(), 16);
        let mut states = States::zeros(n, len);
        for (k, q) in states.q.iter_mut().enumerate() {
            *q = 1.5 * (1.7 * (k % len) as f64 + 2.3 * (k / len) as f64).sin();
        }
        let mut frames = vec![0.0; arm.frame_count() * 12 * len];
        arm.frames(&states, &mut frames);
        let varies = |w: &Watch| {
            let gaps: Vec<f64> = (0..len).map(|s| all.gap(*w, &frames, len, s)).collect();
            gaps.iter().any(|g| (g - gaps[0]).abs() > 1e-9)
        };
        let kept: Vec<Watch> = all.list.iter().filter(|w| varies(w)).copied().collect();
        all.list = kept;
        all
    }

    /// Smallest distance at sample `s` minus the margin, m, and its index in the list; `None` if no
    /// distance is monitored.
    pub(super) fn least(&self, frames: &[f64], len: usize, s: usize) -> Option<(f64, usize)> {
        let gaps = self.list.iter().enumerate().map(|(k, w)| (self.gap(*w, frames, len, s) - self.margin, k));
        gaps.min_by(|a, b| a.0.total_cmp(&b.0))
    }

    fn gap(&self, watch: Watch, frames: &[f64], len: usize, s: usize) -> f64 {
        let at = |b: usize| self.center(b, frames, len, s);
        let radius = |b: usize| self.bodies.balls[b].radius;
        match watch {
            Watch::Ground(f) => {
                frames[((f * 3 + 2) * 4 + 3) * len + s] - self.bodies.ground.as_ref().map_or(f64::NEG_INFINITY, |g| g.0)
            }
            Watch::Pair(a, b) => {
                let (x, y) = (at(a), at(b));
                (0..3).map(|i| (x[i] - y[i]).powi(2)).sum::<f64>().sqrt() - radius(a) - radius(b)
            }
            Watch::Block(b, block) => {
                let (x, block) = (at(b), &self.bodies.blocks[block]);
                let out: [f64; 3] = std::array::from_fn(|i| (block.min[i] - x[i]).max(x[i] - block.max[i]));
                let outside = out.iter().map(|d| d.max(0.0).powi(2)).sum::<f64>().sqrt();
                let deepest = out.iter().copied().fold(f64::NEG_INFINITY, f64::max);
                (if outside > 0.0 { outside } else { deepest }) - radius(b)
            }
            Watch::Wall(b) => {
                dot(self.surface.normal, at(b)) - dot(self.surface.normal, self.surface.center) - radius(b)
            }
        }
    }

    fn center(&self, ball: usize, frames: &[f64], len: usize, s: usize) -> [f64; 3] {
        self.bodies.balls[ball].placed(frames, len, s)
    }

    /// Describes a distance for a message.
    pub(super) fn describe(&self, which: usize) -> String {
        let ball = |k: usize| match self.bodies.balls[k].frame {
            Some(f) => format!("sphere {} (link {})", k + 1, f + 1),
            None => format!("sphere {} (base)", k + 1),
        };
        match self.list.get(which) {
            Some(Watch::Ground(f)) => {
                format!("frame {} above the ground ({} m)", f + 1, self.bodies.ground.as_ref().map_or(0.0, |g| g.0))
            }
            Some(&Watch::Pair(a, b)) => format!("{} and {}", ball(a), ball(b)),
            Some(&Watch::Block(b, block)) => format!("{} and box {}", ball(b), self.bodies.blocks[block].name),
            Some(&Watch::Wall(b)) => format!("{} and the wall", ball(b)),
            None => "nothing".into(),
        }
    }
}
