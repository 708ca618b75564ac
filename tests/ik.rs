//! Inverse kinematics against the numeric recursion: every solution reaches its pose, and the
//! original posture is found.
//!
//! `DENAVIT_IK_POSTURES` sets the number of random postures for each arm (1,000 here, a million
//! before a release), `DENAVIT_IK_ROBOT` selects a single arm.

use core::f64::consts::{PI, TAU};

use denavit::model::inverse_kinematics::{Ask, Kinematics, Postures};
use denavit::model::rigid_body::Numeric;
use denavit::numerics::prng::Random;
use dh_codegen::arm::Model;
use dh_codegen::ik::{Arm, Branch, Query, Reference, Status};
use dh_codegen::robot::{JointKind, Robot, no_files};

fn postures() -> usize {
    std::env::var("DENAVIT_IK_POSTURES").ok().and_then(|n| n.parse().ok()).unwrap_or(1000)
}

fn asked_for(name: &str) -> bool {
    std::env::var("DENAVIT_IK_ROBOT").ok().is_none_or(|only| only == name)
}

fn robot(name: &str) -> Robot {
    let path = format!("{}/robots/{name}.yaml", env!("CARGO_MANIFEST_DIR"));
    Robot::from_yaml(&std::fs::read_to_string(path).unwrap(), &no_files).unwrap().robot
}

/// An arm, its inverse kinematics, and the recursion that shares no code with it.
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

    /// Largest pose error of the solutions, and distance of the nearest solution from the posture.
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

    /// Whether no direction is hard to reach, by differences of poses. For a swivel arm, whose
    /// swivel angle is kept: whether no sine is small.
    fn away_from_singularities(&self, q: &[f64]) -> bool {
        if self.ik.inverse().class == "srs" {
            return [1, 3, 5].into_iter().all(|j| q[j].sin().abs() > 0.1);
        }
        let columns: Vec<_> = (0..q.len())
            .map(|j| {
                let (mut up, mut down) = (q.to_vec(), q.to_vec());
                up[j] += 1e-6;
                down[j] -= 1e-6;
                let (up, down) = (self.pose(&up), self.pose(&down));
                let d = |i: usize| (up[i / 4][i % 4] - down[i / 4][i % 4]) / 2e-6;
                nalgebra::SVector::<f64, 12>::from_fn(|i, _| d(i))
            })
            .collect();
        nalgebra::DMatrix::from_fn(12, q.len(), |i, j| columns[j][i]).singular_values().min() > 0.05
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
    ("puma560", "6r-spherical-wrist"),
    ("staubli-tx40", "6r-spherical-wrist"),
    ("ur10e", "6r-three-parallel"),
    ("scara", "scara"),
    ("stanford", "stanford"),
    ("planar2r", "planar"),
    ("kinova-gen3", "srs"),
];

/// Whole turns are those of the near posture, not only the angles.
#[test]
fn turns_are_those_of_the_near_posture() {
    let bench = Bench::new(robot("ur10e"));
    for q in [[4.5, -1.2, 1.3, -4.0, 5.0, 3.6], [-5.5, -1.2, -1.3, 4.0, -5.0, -3.6]] {
        let found = bench.solve(&q, true);
        let off = found.list[0].q.iter().zip(&q).map(|(x, near)| (x - near).abs()).fold(0.0, f64::max);
        assert!(off < 1e-6, "{:?}", found.list[0].q);
    }
}

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
    for (name, _) in ROBOTS.into_iter().filter(|(name, _)| asked_for(name)) {
        let bench = Bench::new(robot(name));
        let mut random = Random::new(1);
        let (mut loose, mut missed, mut silent, mut worst, mut far, mut outside) = (0, 0, 0, 0.0f64, 0.0f64, 0);
        let (mut uncertain, mut unflagged) = (0, 0);
        // Refined branch by branch: a thousand times as slow.
        let count = if bench.ik.inverse().exact { postures() } else { postures().min(20_000) };
        for _ in 0..count {
            let q = bench.random(&mut random);
            let (error, nearest, found) = bench.check(&q, false);
            worst = worst.max(error);
            uncertain += usize::from(found.uncertain);
            unflagged += usize::from(nearest > 1e-6 && found.status == Status::Ok && !found.uncertain);
            if nearest > 1e-6 && found.status == Status::Singular {
                // So near a singularity that the pose's last digits do not determine it, and
                // reported as such.
                loose += 1;
            } else if nearest > 1e-6 {
                missed += 1;
                silent += usize::from(found.lost == 0);
                if missed < 4 {
                    eprintln!("{name}: {q:?}: {nearest} {:?} lost {}", found.status, found.lost);
                }
            } else {
                far = far.max(nearest);
                let own = found.list.iter().find(|s| bench.distance(&s.q, &q) <= nearest).unwrap();
                outside += usize::from(!own.within_limits);
            }
        }
        eprintln!(
            "{name}: {count} postures, missed {missed}, singular {loose}, uncertain {uncertain}, worst pose {worst:.1e}, farthest {far:.1e}, outside {outside}"
        );
        // Away from singularities, an arm that is nearly of its family has the branches of the
        // nominal one, and reports if it is near one.
        assert_eq!(unflagged, 0, "{name}");
        if bench.ik.inverse().exact {
            assert_eq!(uncertain, 0, "{name}");
        } else {
            assert!(0 < uncertain && uncertain < count / 2, "{name}: {uncertain} of {count}");
        }
        assert!(worst < 1e-12, "{name}: {worst}");
        assert_eq!(outside, 0, "{name}");
        // An arm that is only nearly of its family may lose a branch, but it must report this.
        assert_eq!(if bench.ik.inverse().exact { missed } else { silent }, 0, "{name}: missed {missed}");
    }
}

/// Results for special postures.
#[derive(Default)]
struct Special {
    count: usize,
    missed: usize,
    empty: usize,
    unmarked: usize,
    worst: f64,
}

impl Special {
    /// Checks a posture, once with itself as the near posture, where it must be found though its
    /// pose leaves joints free, and once without.
    fn look(&mut self, bench: &Bench, name: &str, q: &[f64]) {
        self.count += 1;
        let (error, nearest, _) = bench.check(q, true);
        self.worst = self.worst.max(error);
        if nearest > 1e-5 {
            self.missed += 1;
            if self.missed < 4 {
                eprintln!("{name}: near {q:?}: {nearest:e}");
            }
        }
        let (error, nearest, found) = bench.check(q, false);
        self.worst = self.worst.max(error);
        self.empty += usize::from(found.list.is_empty());
        if nearest > 1e-4 && found.status == Status::Ok {
            self.unmarked += 1;
            if self.unmarked < 4 {
                eprintln!("{name}: unmarked {q:?}: {nearest:e} of {}", found.list.len());
            }
        }
    }

    fn judge(&self, name: &str) {
        let Self { count, missed, empty, unmarked, worst } = *self;
        eprintln!(
            "{name}: {count} special: missed {missed}, empty {empty}, unmarked {unmarked}, worst pose {worst:.1e}"
        );
        assert!(worst < 1e-12, "{name}: {worst}");
        assert_eq!((missed, empty), (0, 0), "{name}");
        // Singular or not, undetermined joints are reported.
        assert_eq!(unmarked, 0, "{name}");
    }
}

/// Multiples of 15, 30, 45 and 90 degrees, joints at their limits, and postures at and beside right
/// angles.
#[test]
fn nice_angles_limits_and_singularities() {
    for (name, _) in ROBOTS.into_iter().filter(|(name, _)| *name != "kinova-gen3" && asked_for(name)) {
        let bench = Bench::new(robot(name));
        let mut random = Random::new(2);
        let mut special = Special::default();
        for k in 0..(postures() / 2).min(40_000) {
            let mut q = bench.random(&mut random);
            let step = [15.0, 30.0, 45.0, 90.0][random.below(4)] * PI / 180.0;
            let beside = BESIDE[random.below(6)];
            for j in 0..q.len() {
                let limits = bench.robot.joints[bench.robot.moving()[j]].limits.position;
                match (k % 4, limits) {
                    (0, _) if !bench.slides[j] => q[j] = (q[j] / step).round() * step,
                    (1, Some(l)) if random.chance(0.5) => q[j] = l[random.below(2)],
                    (2 | 3, _) if !bench.slides[j] && random.chance(0.4) => {
                        q[j] = (q[j] / (PI / 2.0)).round() * PI / 2.0 + beside * random.even(1.0);
                    }
                    _ => {}
                }
            }
            special.look(&bench, name, &q);
        }
        special.judge(name);
    }
}

/// Distances from a singularity, rad.
const BESIDE: [f64; 6] = [0.0, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12];

/// Postures with one, two or three singularities: zeros of the Jacobian's determinant along random
/// lines, by bisection. For half of them the wrist is straight, too.
#[test]
fn zeros_of_the_determinant() {
    for name in ["puma560", "staubli-tx40", "ur10e", "stanford"].into_iter().filter(|name| asked_for(name)) {
        let bench = Bench::new(robot(name));
        // Without the straight wrist, which would be a factor of every posture.
        let determinant = |q: &[f64]| bench.oracle.jacobian(q).fixed_columns::<6>(0).determinant() / q[4].sin();
        let mut random = Random::new(6);
        let mut special = Special::default();
        let mut k = 0;
        while special.count < (postures() / 4).min(10_000) {
            let (from, to) = (bench.random(&mut random), bench.random(&mut random));
            let at = |t: f64| -> Vec<f64> {
                // The wrist is fixed, away from its zero.
                (0..6).map(|j| if j == 4 { 1.0 } else { from[j] + t * (to[j] - from[j]) }).collect()
            };
            let (mut low, mut high) = (0.0, 1.0);
            let (first, last) = (determinant(&at(low)), determinant(&at(high)));
            if first * last > 0.0 {
                continue;
            }
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                if determinant(&at(middle)) * first > 0.0 { low = middle } else { high = middle }
            }
            let mut q = at(low);
            k += 1;
            q[4] = if k % 2 == 0 { [0.0, PI][random.below(2)] } else { bench.random(&mut random)[4] };
            let beside = BESIDE[random.below(6)];
            q.iter_mut().for_each(|x| *x += beside * random.even(1.0));
            special.look(&bench, name, &q);
        }
        special.judge(name);
    }
}

/// The interpreted arm with its limits as the runtime's own type.
fn seven(name: &str) -> (Arm<7>, Bench) {
    let bench = Bench::new(robot(name));
    let limits: Vec<_> = bench.robot.moving().iter().map(|&i| bench.robot.joints[i].limits.position).collect();
    (bench.ik.inverse().arm(&limits).unwrap(), bench)
}

/// The intervals of the swivel angle agree with a dense scan of the branch within its limits.
#[test]
fn swivel_intervals_agree_with_a_scan() {
    const SCAN: usize = 180;
    for name in ["kuka-lwr4", "kuka-iiwa14"] {
        let (arm, bench) = seven(name);
        let mut random = Random::new(3);
        let (mut inside, mut outside) = (0, 0);
        for _ in 0..(postures() / 50).clamp(1, 10_000) {
            let q: [f64; 7] = bench.random(&mut random).try_into().unwrap();
            let pose = arm.forward(&q);
            let sign = |random: &mut Random| if random.chance(0.5) { 1 } else { -1 };
            let (shoulder, elbow, wrist) = (sign(&mut random), sign(&mut random), sign(&mut random));
            let branch = Branch { shoulder, elbow, wrist, root: 0, numerical: false };
            let intervals = arm.swivel_intervals(&pose, branch, &Reference::UP).unwrap().unwrap();
            for k in 0..SCAN {
                let phi = -PI + TAU * (k as f64 + 0.37) / SCAN as f64;
                if intervals.iter().any(|i| (phi - i.from).abs().min((phi - i.to).abs()) < 1e-7) {
                    continue;
                }
                let found = arm.solve(&pose, &Query { redundancy: phi, ..Query::default() }).unwrap();
                let own = found.as_slice().iter().find(|s| s.branch == branch).expect("every branch is there");
                let allowed = intervals.iter().any(|i| i.from < phi && phi < i.to);
                assert_eq!(own.within_limits, allowed, "{name} {q:?} {branch} at {phi}: {intervals:?}");
                if allowed { inside += 1 } else { outside += 1 }
            }
            if let Some((phi, margin)) = arm.best_swivel(&pose, branch, &Reference::UP).unwrap() {
                assert!(margin >= 0.0 && intervals.iter().any(|i| i.from <= phi && phi <= i.to));
            }
        }
        assert!(inside > 100 && outside > 100, "{name}: the scan must see both: {inside} {outside}");
    }
}

/// The swivel's velocity agrees with the angle one step later.
#[test]
fn swivel_velocity_is_the_derivative() {
    let (arm, bench) = seven("kuka-iiwa14");
    let mut random = Random::new(4);
    for _ in 0..50 {
        let q: [f64; 7] = bench.random(&mut random).try_into().unwrap();
        let dq: [f64; 7] = random.vector(7, 1.0).try_into().unwrap();
        let h = 1e-7;
        let later = core::array::from_fn(|i| q[i] + h * dq[i]);
        let d = arm.redundancy(&later, &Reference::UP) - arm.redundancy(&q, &Reference::UP);
        let d = d - TAU * (d / TAU).round();
        let v = arm.swivel_velocity(&q, &dq, &Reference::UP);
        assert!((v - d / h).abs() < 1e-4 * (1.0 + v * v), "{v} {}", d / h);
    }
}

/// A path that crosses the wrist singularity is followed without a jump, and back to its original
/// posture.
#[test]
fn a_path_through_the_wrist_singularity_is_followed() {
    for name in ["puma560", "staubli-tx40"] {
        let bench = Bench::new(robot(name));
        let limits: Vec<_> = bench.robot.moving().iter().map(|&i| bench.robot.joints[i].limits.position).collect();
        let arm: Arm<6> = bench.ik.inverse().arm(&limits).unwrap();
        let at = |t: f64| [0.3 + 0.2 * t, -0.4 + 0.1 * t, 0.9 - 0.3 * t, 0.5 + 0.3 * t, 0.4 * t, -0.2 + 0.1 * t];
        let mut last = at(-1.0);
        for k in 0..=400 {
            let q = at(-1.0 + f64::from(k) / 200.0);
            let next = arm.follow(&arm.forward(&q), &last, &Query::default(), 0.05).unwrap();
            let next = next.unwrap_or_else(|| panic!("{name}: lost at step {k}"));
            assert!(bench.distance(&next.q, &last) < 0.02, "{name} step {k}: {:?} {last:?}", next.q);
            // In the singularity itself joints 4 and 6 share a rotation, and keep their positions.
            let singular = q[4].abs() < 1e-9;
            assert!(singular || bench.distance(&next.q, &q) < 1e-6, "{name} step {k}: {:?} {q:?}", next.q);
            last = next.q;
        }
    }
}

/// A calibrated UR10e, its axes parallel to 6e-3: the nominal branches are refined, each kept or
/// reported as lost.
#[test]
fn a_calibrated_arm_keeps_its_branches() {
    let mut random = Random::new(5);
    let (mut found, mut all, mut own, mut told, mut flagged, mut worst) = (0, 0, 0, 0, 0, 0.0f64);
    for _ in 0..5 {
        let mut robot = robot("ur10e");
        for joint in &mut robot.joints {
            joint.alpha = dh_codegen::robot::Angle::radians(joint.alpha.value + random.even(6e-3));
            joint.d = dh_codegen::robot::Length::meters(joint.d.value + random.even(1e-3));
            joint.r = dh_codegen::robot::Length::meters(joint.r.value + random.even(1e-3));
            joint.theta = dh_codegen::robot::Angle::radians(joint.theta.value + random.even(5e-3) + 1e-4);
        }
        let bench = Bench::new(robot);
        assert_eq!((bench.ik.inverse().class, bench.ik.inverse().exact), ("6r-three-parallel", false));
        for _ in 0..100 {
            let q: Vec<f64> = random.vector(6, PI);
            let (error, nearest, solutions) = bench.check(&q, false);
            worst = worst.max(error);
            own += usize::from(nearest < 1e-6);
            told += usize::from(nearest >= 1e-6 && solutions.lost > 0);
            flagged += usize::from(solutions.uncertain);
            found += solutions.list.len();
            all += solutions.list.len() + solutions.lost as usize;
        }
    }
    eprintln!(
        "calibrated ur10e: own posture {own} of 500, branches {found} of {all}, uncertain {flagged}, worst pose {worst:.1e}"
    );
    // Every branch is kept, or its loss is reported.
    assert!(worst < 1e-12 && own + told == 500, "{own} {told} {worst}");
}

/// A rotated and shifted base moves the poses with it.
#[test]
fn a_turned_and_shifted_base_moves_the_poses_with_it() {
    let text = "base: { xyz: [0.3, -0.2, 0.7], rpy: [pi, 0.4, -pi/3] }\n";
    for name in ["kuka-lwr4", "puma560", "ur10e", "scara"] {
        let path = format!("{}/robots/{name}.yaml", env!("CARGO_MANIFEST_DIR"));
        let yaml = std::fs::read_to_string(path).unwrap() + text;
        let moved = Robot::from_yaml(&yaml, &no_files).unwrap().robot;
        let (moved, plain) = (Bench::new(moved), Bench::new(robot(name)));
        let mut random = Random::new(3);
        for _ in 0..20 {
            let q = plain.random(&mut random);
            let [seen, own] = [moved.pose(&q), plain.pose(&q)];
            let base = moved.robot.base.as_ref().unwrap();
            let origin = base.point([own[0][3], own[1][3], own[2][3]]);
            assert!((0..3).all(|i| (origin[i] - seen[i][3]).abs() < 1e-14), "{name}: {origin:?} {seen:?}");
            let (error, nearest, _) = moved.check(&q, false);
            assert!(error < 1e-9, "{name}: {error}");
            assert!(nearest < 1e-6 || !plain.away_from_singularities(&q), "{name}: {nearest}");
        }
    }
}

/// Results for poses that no posture reaches, and for matrices that are not poses.
#[test]
fn poses_out_of_reach_and_poses_that_are_none() {
    // The Stanford arm's file does not limit its prismatic joint.
    for (name, _) in ROBOTS.into_iter().filter(|(name, _)| *name != "stanford") {
        let bench = Bench::new(robot(name));
        let mut pose = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]];
        for (row, x) in [3.0, 4.0, 0.0].into_iter().enumerate() {
            pose[row][3] = 10.0 * x;
        }
        let found = bench.ik.solve(&pose, &Ask::default()).unwrap();
        assert_eq!((found.status, found.list.len()), (Status::Unreachable, 0), "{name}");
        assert!(found.distance[0] > 47.0 && found.distance[0] < 52.0, "{name}: {:?}", found.distance);
        for bad in [f64::NAN, f64::INFINITY, -f64::INFINITY, 1e300] {
            for k in 0..12 {
                let mut pose = pose;
                pose[k / 4][k % 4] = bad;
                assert!(bench.ik.solve(&pose, &Ask::default()).is_err(), "{name} {bad}");
            }
        }
        pose[0][0] = -1.0;
        assert!(bench.ik.solve(&pose, &Ask::default()).is_err(), "{name}: a reflection");
        let ask = Ask { redundancy: f64::NAN, ..Ask::default() };
        assert!(bench.ik.solve(&bench.pose(&vec![0.1; bench.slides.len()]), &ask).is_err());
    }
}

/// Any finite input gives postures of the pose or none, without NaN; any other input gives an
/// error. A near posture so far away that its turns have no valid digit must not cause a posture
/// that does not reach the pose.
#[test]
fn absurd_input_gives_no_wrong_answer() {
    const ODD: [f64; 14] =
        [0.0, -0.0, 1.0, 1e300, -1.7e308, 1e-320, -5e-324, 1e160, 1e99, -1e50, 1e15, 1e10, -1e6, core::f64::consts::PI];
    for (name, _) in ROBOTS.into_iter().filter(|(name, _)| *name != "kinova-gen3") {
        let bench = Bench::new(robot(name));
        let mut random = Random::new(7);
        let (mut found, mut refused) = (0, 0);
        for k in 0..600 {
            let q = bench.random(&mut random);
            let mut pose = bench.pose(&q);
            for _ in 0..k % 3 {
                pose[random.below(3)][random.below(4)] = ODD[random.below(ODD.len())];
            }
            let mut near = q.clone();
            near[random.below(q.len())] = ODD[random.below(ODD.len())];
            let mut ask =
                Ask { redundancy: bench.ik.redundancy(&q, &Reference::UP), near: Some(near), ..Ask::default() };
            if random.chance(0.3) {
                ask.redundancy = ODD[random.below(ODD.len())];
            }
            let Ok(postures) = bench.ik.solve(&pose, &ask) else {
                refused += 1;
                assert!(k % 3 > 0, "{name}: refused {pose:?} {ask:?}");
                continue;
            };
            assert!(postures.distance.iter().all(|x| x.is_finite()), "{name}: {pose:?} {ask:?}");
            for s in &postures.list {
                found += 1;
                assert!(s.q.iter().all(|x| x.is_finite()) && !s.margin.is_nan(), "{name}: {s:?} {ask:?}");
                let again = bench.pose(&s.q);
                let size = pose.as_flattened().iter().fold(1.0f64, |m, x| m.max(x.abs()));
                for (a, b) in again.as_flattened().iter().zip(pose.as_flattened()) {
                    // A rotation with an error up to 1e-6 is corrected.
                    let allowed = if k % 3 == 0 { 1e-12 } else { 1e-6 };
                    assert!((a - b).abs() < allowed * size, "{name}: {s:?} of {pose:?} {ask:?}");
                }
            }
            for bad in [f64::NAN, f64::INFINITY] {
                let near = ask.near.clone().map(|mut near| {
                    near[k % q.len()] = bad;
                    near
                });
                assert!(bench.ik.solve(&bench.pose(&q), &Ask { near, ..Ask::default() }).is_err(), "{name}");
            }
        }
        assert!(found > 100 && refused > 20, "{name}: {found} {refused}");
    }
}

/// Along a path each posture keeps its label: of the next pose's postures, the one that clearly
/// continues it has the same.
#[test]
fn labels_stay_with_their_branch() {
    for name in ["kuka-lwr4", "puma560", "staubli-tx40", "ur10e", "stanford"] {
        let bench = Bench::new(robot(name));
        let mut random = Random::new(8);
        let mut followed = 0;
        for _ in 0..30 {
            let (start, rate) = (bench.random(&mut random), random.vector(bench.slides.len(), 0.003));
            let at = |k: usize| -> Vec<f64> { start.iter().zip(&rate).map(|(q, r)| q + r * k as f64).collect() };
            let mut last = bench.solve(&at(0), false);
            for k in 1..40 {
                let next = bench.solve(&at(k), false);
                for s in &last.list {
                    let mut far: Vec<_> = next.list.iter().map(|n| (bench.distance(&n.q, &s.q), n.branch)).collect();
                    far.sort_by(|a, b| a.0.total_cmp(&b.0));
                    let [first, second, ..] = far[..] else { continue };
                    if first.0 < 0.02 && second.0 > 0.2 && bench.away_from_singularities(&s.q) {
                        followed += 1;
                        assert_eq!(first.1, s.branch, "{name} step {k}: {:?}", s.q);
                    }
                }
                last = next;
            }
        }
        assert!(followed > 2000, "{name}: {followed}");
    }
}

/// The swivel angle is the paper's: the elbow is at `c + R (cos phi u + sin phi v)` (equation 1).
#[test]
fn the_swivel_angle_is_the_papers() {
    let bench = Bench::new(robot("kuka-lwr4"));
    let mut random = Random::new(6);
    for b in [[0.0, 0.0, 1.0], [1.0, 0.5, -0.2]] {
        for _ in 0..40 {
            let q = bench.random(&mut random);
            let phi = random.even(PI);
            let reference = Reference { b, second: [0.0, 1.0, 0.0] };
            let ask = Ask { redundancy: phi, reference, ..Ask::default() };
            let found = bench.ik.solve(&bench.pose(&q), &ask).unwrap();
            assert_eq!(found.list.len(), 8);
            for s in &found.list {
                let frames = bench.oracle.frames(&s.q);
                let origin = |k: usize| nalgebra::Vector3::new(frames[k][(0, 3)], frames[k][(1, 3)], frames[k][(2, 3)]);
                let (shoulder, elbow, wrist) = (origin(1), origin(3), origin(5));
                let to = wrist - shoulder;
                let (d, n) = (to.norm(), to.normalize());
                let b = nalgebra::Vector3::from(b);
                let u = (b - n * n.dot(&b)).normalize();
                let v = n.cross(&u);
                let (l2, l3) = (0.40, 0.39);
                let cosine = (l2 * l2 + d * d - l3 * l3) / (2.0 * l2 * d);
                let radius = (1.0 - cosine * cosine).sqrt() * l2;
                let expected = shoulder + n * (cosine * l2) + (u * phi.cos() + v * phi.sin()) * radius;
                assert!((expected - elbow).norm() < 1e-12, "{} {}", expected, elbow);
            }
        }
    }
}
