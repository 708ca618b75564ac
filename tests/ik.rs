//! Inverse kinematics against the numeric recursion: every solution reaches its pose, and the posture that made the pose is found.
//!
//! `DENAVIT_IK_POSTURES` sets how many random postures each arm gets (1,000 here, a million before a release).

use core::f64::consts::{PI, TAU};

use denavit::inverse::{Ask, Kinematics, Postures};
use denavit::numeric::Numeric;
use denavit::numeric::random::Random;
use dh_codegen::arm::Model;
use dh_codegen::ik::Reference;
use dh_codegen::robot::{JointKind, Robot};

fn postures() -> usize {
    std::env::var("DENAVIT_IK_POSTURES").ok().and_then(|n| n.parse().ok()).unwrap_or(1000)
}

fn robot(name: &str) -> Robot {
    let path = format!("{}/robots/{name}.yaml", env!("CARGO_MANIFEST_DIR"));
    Robot::from_yaml(&std::fs::read_to_string(path).unwrap(), &|f| Err(f.to_string())).unwrap().robot
}

/// An arm, its inverse, and the recursion that shares no code with it.
struct Bench {
    robot: Robot,
    oracle: Numeric,
    ik: Kinematics,
    slides: Vec<bool>,
}

impl Bench {
    fn new(robot: Robot) -> Self {
        let ik = Kinematics::new(&robot, &Model::new(&robot)).unwrap();
        let slides = robot.moving().iter().map(|&i| robot.joints[i].kind == JointKind::Prismatic).collect();
        Self { oracle: Numeric::new(&robot), ik, slides, robot }
    }

    fn pose(&self, q: &[f64]) -> [[f64; 4]; 3] {
        let m = *self.oracle.frames(q).last().unwrap();
        core::array::from_fn(|i| core::array::from_fn(|j| m[(i, j)]))
    }

    fn solve(&self, q: &[f64], near: bool) -> Postures {
        let redundancy = self.ik.redundancy(q, &Reference::UP);
        let near = near.then(|| q.to_vec());
        self.ik.solve(&self.pose(q), &Ask { redundancy, near, ..Ask::default() }).unwrap()
    }

    fn distance(&self, a: &[f64], b: &[f64]) -> f64 {
        (0..a.len()).fold(0.0, |m: f64, i| {
            let d = a[i] - b[i];
            m.max(if self.slides[i] { d } else { d - TAU * (d / TAU).round() }.abs())
        })
    }

    /// Largest error of the solutions' poses, and how far the nearest solution is from the posture.
    fn check(&self, q: &[f64], near: bool) -> (f64, f64, Postures) {
        let goal = self.pose(q);
        let found = self.solve(q, near);
        let mut error: f64 = 0.0;
        let mut nearest = f64::INFINITY;
        for s in &found.list {
            assert!(s.q.iter().all(|x| x.is_finite()));
            let pose = self.pose(&s.q);
            for (a, b) in pose.as_flattened().iter().zip(goal.as_flattened()) {
                error = error.max((a - b).abs());
            }
            nearest = nearest.min(self.distance(&s.q, q));
        }
        (error, nearest, found)
    }

    fn random(&self, random: &mut Random) -> Vec<f64> {
        self.robot
            .moving()
            .iter()
            .map(|&i| {
                let slides = self.robot.joints[i].kind == JointKind::Prismatic;
                let [low, high] =
                    self.robot.joints[i].limits.position.unwrap_or(if slides { [0.1, 0.9] } else { [-PI, PI] });
                random.uniform(low, high)
            })
            .collect()
    }
}

const ROBOTS: [(&str, &str); 11] = [
    ("kuka-lwr4", "srs"),
    ("kuka-iiwa14", "srs"),
    ("kuka-lbr-med7", "srs"),
    ("franka-panda", "7r-offset"),
    ("kinova-gen3", "srs"),
    ("puma560", "6r-spherical-wrist"),
    ("staubli-tx40", "6r-spherical-wrist"),
    ("ur10e", "6r-three-parallel"),
    ("scara", "scara"),
    ("stanford", "stanford"),
    ("planar2r", "planar"),
];

#[test]
fn classes() {
    for (name, class) in ROBOTS {
        let bench = Bench::new(robot(name));
        let inverse = bench.ik.inverse();
        assert_eq!(inverse.class, class, "{name}: {}", inverse.reason);
        assert_eq!(inverse.exact, name != "kinova-gen3", "{name}: {}", inverse.reason);
    }
}

#[test]
fn random_postures() {
    for (name, _) in ROBOTS {
        let bench = Bench::new(robot(name));
        let mut random = Random::new(1);
        let (mut missed, mut worst, mut far, mut outside) = (0, 0.0f64, 0.0f64, 0);
        for _ in 0..postures() {
            let q = bench.random(&mut random);
            let (error, nearest, found) = bench.check(&q, false);
            worst = worst.max(error);
            if nearest > 1e-6 {
                missed += 1;
                if missed < 4 {
                    eprintln!("{name}: {q:?}: {nearest} {:?} lost {}", found.status, found.lost);
                }
            } else {
                far = far.max(nearest);
                let own = found.list.iter().find(|s| bench.distance(&s.q, &q) <= nearest).unwrap();
                outside += usize::from(!own.within_limits);
            }
        }
        eprintln!("{name}: missed {missed}, worst pose {worst:.1e}, farthest {far:.1e}, outside {outside}");
        assert!(worst < 1e-12, "{name}: {worst}");
        assert_eq!(outside, 0, "{name}");
        if bench.ik.inverse().exact {
            assert_eq!(missed, 0, "{name}");
        }
    }
}
