//! Tests of gradients against differences, of motions against the checker, and of criteria against
//! each other.

use std::sync::atomic::AtomicBool;

use dh_codegen::robot::{Robot, no_files};
use nalgebra::DMatrix;

use super::check::{Written, check};
use super::program::Program;
use super::*;
use crate::model::differentiated::Differentiated;
use crate::model::{Arm, States};
use crate::numerics::prng::Random;

fn robot(name: &str) -> Robot {
    let path = format!("{}/robots/{name}.yaml", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).unwrap();
    Robot::from_yaml(&text, &no_files).unwrap().robot
}

/// Robots whose files have speed limits.
const ROBOTS: [&str; 5] = ["kuka-lwr4", "franka-panda", "ur10e", "kinova-gen3", "staubli-tx40"];

const CRITERIA: [Criterion; 5] =
    [Criterion::Condition, Criterion::LogDet, Criterion::Hadamard, Criterion::Trace, Criterion::Smallest];

fn quiet() -> (AtomicBool, fn(&Progress)) {
    (AtomicBool::new(false), |_| {})
}

fn motion(task: &Task<'_>, seed: u64) -> Vec<f64> {
    let mut random = Random::stream(seed, 3);
    let home: Vec<f64> = task.limits.iter().map(|l| 0.5 * (l.position[0] + l.position[1])).collect();
    home.iter().flat_map(|&q| task.curve.rest(q)).map(|x| x + random.uniform(-0.5, 0.5)).collect()
}

/// Five-point difference of `f` along `d`.
fn difference(f: &dyn Fn(&[f64]) -> f64, x: &[f64], d: &[f64], h: f64) -> f64 {
    let at = |s: f64| f(&x.iter().zip(d).map(|(x, d)| x + s * h * d).collect::<Vec<_>>());
    (8.0 * (at(1.0) - at(-1.0)) - (at(2.0) - at(-2.0))) / (12.0 * h)
}

#[test]
fn gradients_of_criteria_meet_differences() {
    for name in ROBOTS {
        let robot = robot(name);
        let arm = Differentiated::new(&robot);
        for (k, criterion) in CRITERIA.into_iter().enumerate() {
            let mut task = Task::new(&arm, &robot, 4.0, 0.5).unwrap();
            let power = criterion.powers()[0];
            task.criterion = criterion;
            let program = Program::new(&task, 25.0, 10.0, 4);
            let x = motion(&task, k as u64);
            let (_, gradient) = program.objective(&x, power).unwrap();
            let mut random = Random::stream(9, k as u64);
            for _ in 0..2 {
                let d: Vec<f64> = x.iter().map(|_| random.uniform(-1.0, 1.0)).collect();
                let slope: f64 = d.iter().zip(&gradient).map(|(d, g)| d * g).sum();
                let numeric = difference(&|x| program.objective(x, power).unwrap().0, &x, &d, 2e-5);
                let scale = 1.0 + slope.abs();
                assert!((slope - numeric).abs() < 1e-7 * scale, "{name} {:?}: {slope} {numeric}", task.criterion);
            }
        }
    }
}

#[test]
fn gradients_of_constraints_meet_differences() {
    for name in ROBOTS {
        let mut robot = robot(name);
        robot.collision.boxes.push(dh_codegen::robot::Cuboid {
            name: "wall".into(),
            min: [0.3, -2.0, 0.0],
            max: [0.5, 2.0, 2.0],
        });
        let arm = Differentiated::new(&robot);
        let task = Task::new(&arm, &robot, 3.0, 0.5).unwrap();
        let program = Program::new(&task, 10.0, 7.0, 4);
        assert!(task.bodies.pairs.len() >= 12, "{name} has {} pairs", task.bodies.pairs.len());
        let x = motion(&task, 4);
        let mut random = Random::stream(2, 2);
        let len = program.guard.times.len();
        let watched: Vec<(usize, usize)> = (0..program.list.len()).map(|c| (c, (3 * c + 1) % len)).collect();
        let slopes = program.gradients(&x, &watched);
        let weights: Vec<f64> = watched.iter().map(|_| random.uniform(0.0, 1.0)).collect();
        let sum = program.weighted(&x, &watched, &weights);
        let d: Vec<f64> = x.iter().map(|_| random.uniform(-1.0, 1.0)).collect();
        let mut total = 0.0;
        for (k, &(c, s)) in watched.iter().enumerate() {
            let slope: f64 = d.iter().zip(&slopes[k]).map(|(d, g)| d * g).sum();
            let numeric = difference(&|x| program.guarded(x)[c * len + s], &x, &d, 1e-5);
            assert!(
                (slope - numeric).abs() < 1e-7 * (1.0 + slope.abs()),
                "{name} {:?}: {slope} {numeric}",
                program.list[c]
            );
            total += weights[k] * slope;
        }
        let together: f64 = d.iter().zip(&sum).map(|(d, g)| d * g).sum();
        assert!((total - together).abs() < 1e-9 * (1.0 + total.abs()));
    }
}

fn written(design: &Design, rate: f64) -> Written {
    let (t, states) = design.trajectory.sampled(rate);
    let n = design.trajectory.dof();
    let rows = |part: &[f64]| (0..t.len()).map(|s| (0..n).map(|j| part[j * t.len() + s]).collect()).collect();
    Written { q: rows(&states.q), dq: rows(&states.dq), ddq: rows(&states.ddq), t }
}

fn effort(starts: usize, iterations: usize, threads: usize) -> Effort {
    Effort { starts, seed: 3, iterations, finalists: 1, threads }
}

#[test]
fn motions_pass_the_checker_improve_on_their_start_and_do_not_depend_on_threads() {
    let (stop, progress) = quiet();
    let watch = Watch { stop: &stop, progress: &progress };
    for (name, curve) in [
        ("kuka-lwr4", Curve::Spline { duration: 4.0, intervals: 4 }),
        ("ur10e", Curve::Fourier { period: 4.0, harmonics: 3, periods: 2 }),
    ] {
        let robot = robot(name);
        let arm = Differentiated::new(&robot);
        let mut task = Task::new(&arm, &robot, 4.0, 0.5).unwrap();
        task.curve = curve;
        let one = design(&task, &effort(2, 12, 1), &watch).unwrap();
        let two = design(&task, &effort(2, 12, 2), &watch).unwrap();
        assert_eq!(one.trajectory, two.trajectory, "{name}");
        assert!(one.feasible, "{name}: {:?}", one.closest);
        let verdict = check(&robot, &written(&one, 100.0), Some(0.5)).unwrap();
        let broken: Vec<_> = verdict.findings.iter().filter(|f| f.broken).collect();
        assert!(broken.is_empty(), "{name}: {broken:?}");
        let first = one.history.first().unwrap().value * task.columns().count() as f64;
        assert!(one.value < first - 5.0, "{name}: {} from {first}", one.value);
    }
}

#[test]
fn the_checker_sees_what_is_broken() {
    let robot = robot("franka-panda");
    let (stop, progress) = quiet();
    let arm = Differentiated::new(&robot);
    let task = Task::new(&arm, &robot, 3.0, 0.5).unwrap();
    let good = design(&task, &effort(1, 4, 1), &Watch { stop: &stop, progress: &progress }).unwrap();
    let good = written(&good, 100.0);
    let broken = |change: &dyn Fn(&mut Robot, &mut Written)| -> Vec<&'static str> {
        let (mut robot, mut motion) = (robot.clone(), good.clone());
        change(&mut robot, &mut motion);
        let verdict = check(&robot, &motion, Some(0.5)).unwrap();
        let mut kinds: Vec<&str> = verdict.findings.iter().filter(|f| f.broken).map(|f| f.kind).collect();
        kinds.dedup();
        kinds
    };
    assert!(broken(&|_, _| {}).is_empty());
    let has = |kinds: Vec<&'static str>, kind: &str| assert!(kinds.contains(&kind), "{kind} in {kinds:?}");
    has(broken(&|r, _| r.joints[1].limits.position = Some([-1e-3, 1e-3])), "position");
    has(broken(&|r, _| r.joints[2].limits.velocity = Some(1e-3)), "velocity");
    has(broken(&|r, _| r.joints[2].limits.acceleration = Some(1e-3)), "acceleration");
    has(broken(&|r, _| r.joints[0].limits.jerk = Some(1e-2)), "jerk");
    has(broken(&|r, _| r.joints[1].limits.torque = Some(1.0)), "torque");
    has(broken(&|r, _| r.collision.ground = Some(0.9)), "ground");
    has(broken(&|r, _| r.collision.spheres.iter_mut().for_each(|s| s.radius = 0.3)), "self_collision");
    let everywhere = dh_codegen::robot::Cuboid { name: "room".into(), min: [-2.0; 3], max: [2.0; 3] };
    has(broken(&|r, _| r.collision.boxes.push(everywhere.clone())), "box");
    has(broken(&|_, m| m.dq.iter_mut().for_each(|row| row[3] += 0.2)), "consistency");
    has(
        broken(&|_, m| {
            let half = m.t.len() / 2;
            for rows in [&mut m.q, &mut m.dq, &mut m.ddq] {
                rows.truncate(half);
            }
            m.t.truncate(half);
        }),
        "rest",
    );
    assert!(check(&robot, &Written::default(), None).is_err());
}

/// Nearly identical columns: `log det` from products is meaningless, from the factor it is not.
#[test]
fn log_det_is_meaningful_at_condition_numbers_of_1e8() {
    /// Adds a column that differs from `sin q1` by `1e-8 x`, next to nothing.
    struct Nearly {
        share: f64,
        pattern: [(usize, usize); 2],
    }
    impl Extra for Nearly {
        fn columns(&self) -> usize {
            2
        }
        fn pattern(&self) -> &[(usize, usize)] {
            &self.pattern
        }
        fn evaluate(&self, states: &States, out: &mut [f64]) {
            for s in 0..states.len {
                out[s] = states.q[s].sin() + states.q[s].powi(3);
                out[states.len + s] = out[s] + self.share * (1.7 * states.dq[s]).sin();
            }
        }
    }
    let robot = robot("kuka-lwr4");
    let arm = Differentiated::new(&robot);
    let mut values = Vec::new();
    for share in [1e-2, 1e-8] {
        let nearly = Nearly { share, pattern: [(0, 0), (0, 1)] };
        let mut task = Task::new(&arm, &robot, 4.0, 0.5).unwrap();
        let x = motion(&task, 5);
        task.base.clear();
        task.extra = Some(&nearly);
        let program = Program::new(&task, 50.0, 5.0, 4);
        let (value, gradient) = program.objective(&x, 1.0).unwrap();
        values.push(2.0 * value + 2.0 * share.ln()); // the unit is the number of columns
        let d: Vec<f64> = x.iter().enumerate().map(|(k, _)| (k as f64).cos()).collect();
        let slope: f64 = d.iter().zip(&gradient).map(|(d, g)| d * g).sum();
        let numeric = difference(&|x| program.objective(x, 1.0).unwrap().0, &x, &d, 1e-3);
        assert!((slope - numeric).abs() < 1e-4 * (1.0 + slope.abs()), "{share}: {slope} {numeric}");
    }
    // det = share^2 * (something that does not depend on it).
    assert!((values[0] - values[1]).abs() < 1e-4, "{values:?}");
}

#[test]
fn a_second_motion_complements_the_first_and_knowledge_counts() {
    let robot = robot("kuka-lwr4");
    let arm = Differentiated::new(&robot);
    let mut task = Task::new(&arm, &robot, 2.0, 0.5).unwrap();
    task.noise = vec![0.3; 7];
    let (stop, progress) = quiet();
    let first = design(&task, &effort(1, 6, 1), &Watch { stop: &stop, progress: &progress }).unwrap();
    let states = first.trajectory.sampled(100.0).1;
    let alone = expected(&task, &states);
    task.prior = Some(known_from(&task, std::slice::from_ref(&states)));
    let twice = expected(&task, &states);
    for (a, b) in alone.iter().zip(&twice) {
        assert!((a.std / b.std - 2.0_f64.sqrt()).abs() < 1e-6, "{}: {} {}", a.name, a.std, b.std);
    }
    task.prior = known_values(&task, 0.01);
    let known = expected(&task, &states);
    for (e, a) in known.iter().zip(&alone) {
        let bound = e.value.filter(|v| *v != 0.0).map_or(f64::INFINITY, |v| 0.01 * v.abs());
        assert!(e.std <= bound * (1.0 + 1e-6) && e.std <= a.std * (1.0 + 1e-6), "{}: {} {}", e.name, e.std, bound);
    }
}

/// Comparison with the textbook: the covariance of least squares on the stacked regressor.
#[test]
fn expected_precision_is_that_of_least_squares() {
    let robot = robot("planar2r");
    let arm = Differentiated::new(&robot);
    let len = 50;
    let mut random = Random::stream(5, 5);
    let mut draw = || (0..2 * len).map(|_| random.uniform(-1.0, 1.0)).collect::<Vec<f64>>();
    let states = States { len, q: draw(), dq: draw(), ddq: draw() };
    let mut limited = robot.clone();
    limited.joints.iter_mut().for_each(|j| j.limits.velocity = Some(1.0));
    let mut task = Task::new(&arm, &limited, 2.0, 0.5).unwrap();
    task.noise = vec![0.2, 0.7];
    let b = arm.base_parameters().len();
    let mut values = vec![0.0; arm.base_pattern().len() * len];
    arm.base_regressor(&states, &mut values);
    let mut w = DMatrix::zeros(2 * len, b);
    for (k, &(row, column)) in arm.base_pattern().iter().enumerate() {
        for s in 0..len {
            w[(2 * s + row, column)] = values[k * len + s] / task.noise[row];
        }
    }
    let covariance = (w.transpose() * &w).try_inverse().unwrap();
    for (k, e) in expected(&task, &states).iter().enumerate() {
        assert!((e.std / covariance[(k, k)].sqrt() - 1.0).abs() < 1e-8, "{}", e.name);
    }
    // The plain numbers of equation (9) as well, by another method.
    task.noise = vec![1.0, 1.0];
    for (i, row) in [(0, 0.2), (1, 0.7)] {
        (0..len).for_each(|s| (0..b).for_each(|k| w[(2 * s + i, k)] *= row));
    }
    let information = super::information::Information::new(&task.columns(), &states, &task.scaling(1.0));
    let conditions = information.conditions();
    let sigma = w.singular_values();
    assert!((conditions.condition / (sigma.max() / sigma.min()) - 1.0).abs() < 1e-9);
    assert!((conditions.log_det - 2.0 * sigma.map(|s| s.ln()).sum()).abs() < 1e-9);
    let hadamard: f64 = w.column_iter().map(|c| c.norm_squared().ln()).sum();
    assert!((conditions.hadamard - hadamard).abs() < 1e-9);
}

/// A spring in q1 and a cubic friction in dq1 are separated better by the motion designed for it.
#[test]
fn a_discriminating_motion_separates_hypotheses() {
    struct Own(fn(f64, f64) -> f64);
    impl Extra for Own {
        fn columns(&self) -> usize {
            1
        }
        fn pattern(&self) -> &[(usize, usize)] {
            &[(0, 0)]
        }
        fn evaluate(&self, states: &States, out: &mut [f64]) {
            (0..states.len).for_each(|s| out[s] = (self.0)(states.q[s], states.dq[s]));
        }
    }
    let (spring, cubic) = (Own(|q, _| q), Own(|_, v| v * v * v));
    let robot = robot("kuka-lwr4");
    let arm = Differentiated::new(&robot);
    let task = Task::new(&arm, &robot, 3.0, 0.5).unwrap();
    let (stop, progress) = quiet();
    let watch = Watch { stop: &stop, progress: &progress };
    let made = discriminate(&task, &spring, &cubic, &effort(1, 25, 1), &watch).unwrap();
    let start = made.history.first().unwrap().value;
    assert!(made.feasible);
    assert!(made.value < start - 1.0, "{} from {start}", made.value);
}

#[test]
fn what_cannot_be_is_said() {
    let mut robot = robot("kuka-lwr4");
    let arm = Differentiated::new(&robot);
    robot.collision.ground = Some(3.0);
    let task = Task::new(&arm, &robot, 3.0, 0.5).unwrap();
    let (stop, progress) = quiet();
    let error = design(&task, &effort(1, 4, 1), &Watch { stop: &stop, progress: &progress }).unwrap_err();
    assert!(matches!(&error, DesignError::Blocked(what) if what.contains("ground at 3 m")), "{error}");
    robot.joints[2].limits.velocity = None;
    let error = Task::new(&arm, &robot, 3.0, 0.5).err().unwrap();
    assert_eq!(error, LimitsError::Velocity("A3".into()));
    assert!(error.to_string().contains("`velocity`"), "{error}");
}

/// The problem of `benches/excite_slsqp.py`. Of five starts each, SLSQP with finite differences
/// reaches a median of 11.25 (condition number, 41 s of processor time) and -499.6 (log det, 26 s),
/// and violates limits between its times.
#[test]
fn a_few_steps_reach_what_a_general_solver_does() {
    let mut robot = robot("kuka-lwr4");
    robot.links.clear();
    robot.collision = Default::default();
    let arm = Differentiated::new(&robot);
    let mut task = Task::new(&arm, &robot, 10.0, 0.5).unwrap();
    task.links_only();
    let (stop, progress) = quiet();
    for (criterion, starts, iterations, reached) in
        [(Criterion::Condition, 3, 30, 11.25), (Criterion::LogDet, 4, 20, -499.6)]
    {
        task.criterion = criterion;
        let effort = Effort { starts, seed: 2, iterations, finalists: 1, threads: 2 };
        let found = design(&task, &effort, &Watch { stop: &stop, progress: &progress }).unwrap();
        assert!(found.feasible && found.value < reached, "{} {}", found.criterion, found.value);
    }
}

/// The torque that holds a posture against limits just above and just below it, in the constraint
/// and in the checker.
#[test]
fn a_torque_is_within_its_limit_or_not() {
    use crate::model::rigid_body::Numeric;
    use dh_codegen::arm::param;
    let mut robot = robot("kuka-lwr4");
    let standard = param::standard_values(&robot).unwrap();
    let q = [0.3, 0.9, -0.2, 1.1, 0.1, -0.6, 0.2];
    let still = [0.0; 7];
    let torque = Numeric::new(&robot).inverse_dynamics(&q, &still, &still, &standard)[1];
    for (share, within) in [(1.02, true), (0.98, false), (0.9, false)] {
        robot.joints[1].limits.torque = Some(share * torque.abs());
        let arm = Differentiated::new(&robot);
        let task = Task::new(&arm, &robot, 3.0, 0.5).unwrap();
        let bodies = super::bodies::Bodies::new(&robot);
        let constraints = super::constraints::Constraints {
            arm: &arm,
            limits: &task.limits,
            standard: Some(&standard),
            bodies: &bodies,
            torque_margin: 0.0,
            distance_margin: 0.0,
        };
        let states = States { len: 1, q: q.to_vec(), dq: still.to_vec(), ddq: still.to_vec() };
        let value = constraints.values(&[super::constraints::Constraint::Torque(1)], &states)[0];
        assert!((value - (1.0 / share - 1.0)).abs() < 1e-9, "{share}: {value}");
        let rows = |x: &[f64]| vec![x.to_vec(); 3];
        let motion = Written { t: vec![0.0, 0.1, 0.2], q: rows(&q), dq: rows(&still), ddq: rows(&still) };
        let verdict = check(&robot, &motion, Some(0.5)).unwrap();
        let broken = verdict.findings.iter().any(|f| f.kind == "torque" && f.limit == share * torque.abs() && f.broken);
        assert_eq!(broken, !within, "{share}");
    }
}

/// Violations on either side, with the violated limit.
#[test]
fn a_position_is_within_its_range_or_not() {
    let mut robot = robot("kuka-lwr4");
    let q = [0.3, 0.9, -0.2, 1.1, 0.1, -0.6, 0.2];
    let rows = |x: &[f64]| vec![x.to_vec(); 3];
    for (range, broken) in [([0.31, 1.0], Some(0.31)), ([-1.0, 0.29], Some(0.29)), ([0.29, 0.31], None)] {
        robot.joints[0].limits.position = Some(range);
        let motion = Written { t: vec![0.0, 0.1, 0.2], q: rows(&q), dq: rows(&[0.0; 7]), ddq: rows(&[0.0; 7]) };
        let findings = check(&robot, &motion, Some(0.5)).unwrap().findings;
        let found = findings.iter().find(|f| f.kind == "position" && f.broken).map(|f| f.limit);
        assert_eq!(found, broken, "{range:?}");
    }
}

/// The distance of a pair decreases by the increase of either radius.
#[test]
fn both_balls_of_a_pair_take_room() {
    let robot = robot("kuka-lwr4");
    let arm = Differentiated::new(&robot);
    let task = Task::new(&arm, &robot, 3.0, 0.5).unwrap();
    let mut bodies = super::bodies::Bodies::new(&robot);
    let q = vec![0.3, 0.9, -0.2, 1.1, 0.1, -0.6, 0.2];
    let states = States { len: 1, q, dq: vec![0.0; 7], ddq: vec![0.0; 7] };
    let value = |bodies: &super::bodies::Bodies| {
        let constraints = super::constraints::Constraints {
            arm: &arm,
            limits: &task.limits,
            standard: None,
            bodies,
            torque_margin: 0.0,
            distance_margin: 0.0,
        };
        constraints.values(&[super::constraints::Constraint::Pair(0)], &states)[0]
    };
    let (a, b) = bodies.pairs[0];
    let before = value(&bodies);
    for ball in [a, b] {
        let radius = bodies.balls[ball].radius;
        bodies.balls[ball].radius += 0.02;
        // In units of 0.1 m.
        assert!((value(&bodies) - before - 0.2).abs() < 1e-9, "{ball}");
        bodies.balls[ball].radius = radius;
    }
}

/// Positions, speeds and accelerations of a sine that is sampled eight times per period are
/// consistent: the trapezoidal rule alone would miss the positions by a twentieth.
#[test]
fn coarse_rows_of_a_sine_are_consistent() {
    let robot = robot("kuka-lwr4");
    let (w, h) = (7.0, 0.11);
    let rows = |of: &dyn Fn(f64) -> f64| (0..60).map(|k| vec![of(h * f64::from(k)); 7]).collect::<Vec<_>>();
    let sine = |lead: f64, size: f64| move |t: f64| size * (w * t + lead * std::f64::consts::FRAC_PI_2).sin();
    let motion = Written {
        t: (0..60).map(|k| h * f64::from(k)).collect(),
        q: rows(&sine(0.0, 0.1)),
        dq: rows(&sine(1.0, 0.1 * w)),
        ddq: rows(&sine(2.0, 0.1 * w * w)),
    };
    let inconsistent = |motion: &Written| {
        let verdict = check(&robot, motion, Some(0.5)).unwrap();
        verdict.findings.iter().filter(|f| f.kind == "consistency" && f.broken).count()
    };
    assert_eq!(inconsistent(&motion), 0);
    let mut wrong = motion.clone();
    wrong.q.iter_mut().for_each(|row| row[2] *= 1.1);
    assert_eq!(inconsistent(&wrong), 1);
}
