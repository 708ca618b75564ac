//! Arms, poses and the clock shared by the benchmarks of inverse kinematics.

use std::hint::black_box;
use std::time::Instant;

use dh_codegen::arm::{Inverse, Model};
use dh_codegen::ik::{Arm, Branch, Query, Reference};
use dh_codegen::robot::{Robot, no_files};

/// Number of poses used in turn: more than a branch predictor can learn.
pub const POSES: usize = 2000;
const ROUNDS: usize = 31;

/// A pose: the top three rows of its homogeneous matrix.
pub type Pose = [[f64; 4]; 3];

/// The branch whose swivel intervals are computed.
const FIRST: Branch = Branch { shoulder: 1, elbow: 1, wrist: 1, root: 0, numerical: false };

/// Nanoseconds of a clock cycle, from a chain of dependent operations with two cycles each.
/// Measured beside the calls, it makes figures at different clock rates comparable.
pub fn cycle() -> f64 {
    const LINKS: u32 = 200_000;
    (0..ROUNDS)
        .map(|_| {
            let start = Instant::now();
            let mut x = black_box(1u64);
            for k in 0..LINKS {
                x = x.rotate_left(5) ^ u64::from(k);
            }
            black_box(x);
            start.elapsed().as_secs_f64() * 1e9 / f64::from(2 * LINKS)
        })
        .fold(f64::INFINITY, f64::min)
}

/// Clock cycles per call: the best of several rounds over all poses, so that other load on the
/// machine does not count.
pub fn cycles<T>(poses: &[T], mut call: impl FnMut(&T)) -> f64 {
    let mut best = f64::INFINITY;
    let mut clock = cycle();
    for _ in 0..4 * ROUNDS {
        let start = Instant::now();
        poses.iter().for_each(|p| call(black_box(p)));
        best = best.min(start.elapsed().as_secs_f64() * 1e9 / poses.len() as f64);
    }
    clock = clock.min(cycle());
    best / clock
}

/// Nanoseconds per call: the median of several rounds over all poses.
#[allow(dead_code, reason = "benches/peers compares times")]
pub fn median<T>(poses: &[T], mut call: impl FnMut(&T)) -> f64 {
    let mut times: Vec<f64> = (0..ROUNDS)
        .map(|_| {
            let start = Instant::now();
            poses.iter().for_each(|p| call(black_box(p)));
            start.elapsed().as_secs_f64() * 1e9 / poses.len() as f64
        })
        .collect();
    times.sort_by(f64::total_cmp);
    times[ROUNDS / 2]
}

/// A robot of the repository, solved with the arm description of its generated crate.
pub struct Bench<const N: usize> {
    pub arm: Arm<N>,
    pub class: &'static str,
    /// Poses of random postures within the limits, with their redundancy.
    pub poses: Vec<(Pose, f64)>,
}

impl<const N: usize> Bench<N> {
    pub fn new(name: &str) -> Self {
        let path = format!("{}/robots/{name}.yaml", env!("CARGO_MANIFEST_DIR").trim_end_matches("/benches/peers"));
        Self::of(&std::fs::read_to_string(path).expect("a robot file of the repository"))
    }

    /// Creates a benchmark from the text of a robot file.
    pub fn of(text: &str) -> Self {
        let robot = Robot::from_yaml(text, &no_files).expect("a robot file without problems").robot;
        let inverse = Inverse::new(Model::new(&robot).chain());
        let limits: Vec<_> = robot.moving().iter().map(|&i| robot.joints[i].limits.position).collect();
        let arm: Arm<N> = inverse.arm(&limits).expect("as many joints");
        let mut state = 1u64;
        let poses = (0..POSES)
            .map(|_| {
                let q = core::array::from_fn(|i| {
                    state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                    let unit = (state >> 11) as f64 / (1u64 << 53) as f64;
                    let [low, high] = limits[i].unwrap_or([-3.0, 3.0]);
                    low + (high - low) * unit
                });
                (arm.forward(&q), arm.redundancy(&q, &Reference::UP))
            })
            .collect();
        Self { arm, class: inverse.class, poses }
    }

    /// Clock cycles for all branches of a pose, and for the swivel intervals of one branch.
    #[allow(dead_code, reason = "benches/peers compares times")]
    pub fn cycles(&self) -> (f64, f64) {
        let query = |redundancy| Query { redundancy, ..Query::default() };
        let all = cycles(&self.poses, |(pose, redundancy)| {
            black_box(&self.arm.solve(pose, &query(*redundancy)));
        });
        let intervals = cycles(&self.poses, |(pose, _)| {
            black_box(&self.arm.swivel_intervals(pose, FIRST, &Reference::UP));
        });
        (all, intervals)
    }

    /// Nanoseconds for all branches of a pose, and their average number.
    pub fn solve(&self) -> (f64, f64) {
        let query = |redundancy| Query { redundancy, ..Query::default() };
        let ns = median(&self.poses, |(pose, redundancy)| {
            black_box(&self.arm.solve(pose, &query(*redundancy)));
        });
        let found: usize =
            self.poses.iter().map(|(p, r)| self.arm.solve(p, &query(*r)).map_or(0, |s| s.as_slice().len())).sum();
        (ns, found as f64 / POSES as f64)
    }

    /// Nanoseconds for the swivel intervals of one branch.
    pub fn intervals(&self) -> f64 {
        median(&self.poses, |(pose, _)| {
            black_box(&self.arm.swivel_intervals(pose, FIRST, &Reference::UP));
        })
    }
}
