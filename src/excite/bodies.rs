//! Collision bodies: spheres on the arm, the ground, and boxes around it.

use dh_codegen::robot::{Robot, Sphere};

/// A sphere fixed to a frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Ball {
    /// Frame (row of the table from 0); `None`: the base.
    pub frame: Option<usize>,
    /// Centre in that frame, m; in the world frame for a sphere on the base.
    pub center: [f64; 3],
    /// Radius, m.
    pub radius: f64,
}

impl Ball {
    /// Centre in the world frame, m, at sample `s` of `len`; `frames` is laid out as
    /// [`crate::model::FrameKinematics::frames`] writes it.
    pub fn placed(&self, frames: &[f64], len: usize, s: usize) -> [f64; 3] {
        let Some(f) = self.frame else { return self.center };
        std::array::from_fn(|i| {
            let at = |k: usize| frames[((f * 3 + i) * 4 + k) * len + s];
            at(0) * self.center[0] + at(1) * self.center[1] + at(2) * self.center[2] + at(3)
        })
    }
}

/// A box in the surroundings, aligned with the world axes.
#[derive(Debug, Clone, PartialEq)]
pub struct Block {
    /// Name for messages.
    pub name: String,
    /// Lowest corner, m.
    pub min: [f64; 3],
    /// Highest corner, m.
    pub max: [f64; 3],
}

/// Two spheres that must not collide, by index.
pub type Pair = (usize, usize);

/// All collision bodies with the pairs to check.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Bodies {
    /// Spheres.
    pub balls: Vec<Ball>,
    /// Pairs of spheres that are checked.
    pub pairs: Vec<Pair>,
    /// Pairs of a sphere and a box that are checked.
    pub blocked: Vec<(usize, usize)>,
    /// Boxes.
    pub blocks: Vec<Block>,
    /// Lowest permitted z, m, and the frames whose origins must stay above it.
    pub ground: Option<(f64, Vec<usize>)>,
}

impl Bodies {
    /// Takes the bodies of a robot. Pairs are all spheres whose links have at least one moving link
    /// between them (neighbours touch by construction), except those whose distance no posture
    /// changes. The ground is checked for the origins of frames that move away from the base axis,
    /// and for the tool.
    pub fn new(robot: &Robot) -> Self {
        let ball = |s: &Sphere| {
            let frame = s.link.checked_sub(1);
            let at_base = robot.base.as_ref().filter(|_| frame.is_none());
            Ball { frame, center: at_base.map_or(s.center, |base| base.point(s.center)), radius: s.radius }
        };
        let balls: Vec<Ball> = robot.collision.spheres.iter().map(ball).collect();
        let moving: Vec<bool> = robot.joints.iter().map(|j| j.kind != dh_codegen::robot::JointKind::Fixed).collect();
        let between = |a: Option<usize>, b: Option<usize>| {
            let (low, high) = (a.map_or(0, |a| a + 1), b.map_or(0, |b| b + 1));
            moving[low.min(high)..low.max(high)].iter().filter(|m| **m).count()
        };
        let mut pairs = Vec::new();
        for a in 0..balls.len() {
            for b in a + 1..balls.len() {
                if between(balls[a].frame, balls[b].frame) >= 2 {
                    pairs.push((a, b));
                }
            }
        }
        let frames = robot.joints.len() + usize::from(robot.tool.is_some());
        let blocks: Vec<Block> =
            robot.collision.boxes.iter().map(|b| Block { name: b.name.clone(), min: b.min, max: b.max }).collect();
        let blocked = (0..balls.len())
            .filter(|&k| balls[k].frame.is_some_and(|f| moving[..=f].iter().any(|m| *m)))
            .flat_map(|k| (0..blocks.len()).map(move |b| (k, b)))
            .collect();
        Self { balls, pairs, blocked, blocks, ground: robot.collision.ground.map(|z| (z, (0..frames).collect())) }
    }
}

/// Distance from a point to a box and its gradient; inside the box, minus the depth below the
/// nearest face.
pub(super) fn distance(point: [f64; 3], block: &Block) -> (f64, [f64; 3]) {
    let outside: [f64; 3] =
        std::array::from_fn(|i| (block.min[i] - point[i]).max(0.0) - (point[i] - block.max[i]).max(0.0));
    let d = outside.iter().map(|x| x * x).sum::<f64>().sqrt();
    if d > 0.0 {
        return (d, outside.map(|x| -x / d));
    }
    let mut best = (f64::NEG_INFINITY, [0.0; 3]);
    for i in 0..3 {
        for (depth, sign) in [(block.min[i] - point[i], -1.0), (point[i] - block.max[i], 1.0)] {
            if depth > best.0 {
                best = (depth, [0.0; 3]);
                best.1[i] = sign;
            }
        }
    }
    best
}
