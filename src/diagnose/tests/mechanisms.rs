//! One mechanism per test: a planar arm whose torques are computed here, by virtual work, tables
//! and laws other than those that the diagnosis uses.

use dh_codegen::arm::param;
use dh_codegen::robot::{Robot, no_files};

use super::world::{motion, record};
use crate::diagnose::{Diagnosis, Settings, diagnose, extended, written_errors};
use crate::model::file_torque_model::FileTorqueModel;
use crate::model::perturbable_robot::PerturbableRobot;
use crate::model::rigid_body::Numeric;
use crate::numerics::prng::Random;

pub(super) const RATE: f64 = 200.0;
const NOISE: [f64; 2] = [0.02, 0.01];

pub(super) fn planar() -> Robot {
    let text = include_str!("../../../robots/planar2r.yaml");
    Robot::from_yaml(text, &no_files).unwrap().robot
}

/// Torques of an arm at one state.
pub(super) struct Bodies {
    numeric: Numeric,
    phi: Vec<f64>,
}

impl Bodies {
    pub(super) fn of(robot: &Robot) -> Self {
        Self { numeric: Numeric::new(robot), phi: param::standard_values(robot).unwrap() }
    }

    pub(super) fn torques(&self, [q, v, a]: &[[f64; 2]; 3]) -> [f64; 2] {
        let (mut work, mut tau) = (self.numeric.workspace(), [0.0; 2]);
        self.numeric.inverse_dynamics_into(&mut work, q, v, a, &self.phi, &mut tau);
        tau
    }
}

/// The arm's links without its drive parameters.
pub(super) fn bare(robot: &Robot) -> Robot {
    let mut robot = robot.clone();
    for joint in &mut robot.joints {
        let drive = &mut joint.drive;
        (drive.viscous_friction, drive.coulomb_friction, drive.rotor_inertia) = (None, None, None);
    }
    robot
}

/// A log of an arm with these torques at `[q, v, a]`.
pub(super) fn log(
    robot: &Robot,
    seconds: f64,
    random: &mut Random,
    tau: &dyn Fn(&[[f64; 2]; 3]) -> [f64; 2],
) -> Vec<u8> {
    let q = motion(robot, seconds, RATE, random);
    let gauss = |random: &mut Random| (0..12).map(|_| random.uniform(0.0, 1.0)).sum::<f64>() - 6.0;
    let mut text = String::from("t,q1,q2,tau1,tau2\n");
    for k in 0..q[0].len() {
        let state: [[f64; 2]; 3] = std::array::from_fn(|i| [q[0][k][i], q[1][k][i]]);
        let clean = tau(&state);
        let noisy = [0, 1].map(|j| clean[j] + NOISE[j] * gauss(random));
        let at = k as f64 / RATE;
        text.push_str(&format!("{at:.4},{:.6},{:.6},{:.6},{:.6}\n", state[0][0], state[0][1], noisy[0], noisy[1]));
    }
    text.into_bytes()
}

/// Diagnosis of the arm's file for these torques, and the error of the written file on a third log,
/// in units of the noise.
fn found(robot: &Robot, seed: u64, tau: &dyn Fn(&[[f64; 2]; 3]) -> [f64; 2]) -> (Diagnosis, Vec<f64>) {
    let mut random = Random::new(seed);
    let [a, b, c] = [12.0, 8.0, 8.0].map(|seconds| record("log", &log(robot, seconds, &mut random, tau), 2));
    let plant = PerturbableRobot::new(robot);
    let found = diagnose(&plant, &[a], &[b], &Settings::default(), &|_| {}).unwrap();
    let extended = extended(robot.clone(), &found);
    let written = FileTorqueModel::new(&extended).unwrap().among_walls(&extended);
    let missed = written_errors(&written, &[c], &found).iter().zip(NOISE).map(|(e, s)| e / s).collect();
    (found, missed)
}

fn sign(v: f64) -> f64 {
    (v / 1e-3).tanh()
}

/// Torques of the file's drives.
pub(super) fn plain(robot: &Robot, v: &[f64; 2]) -> [f64; 2] {
    [0, 1].map(|j| {
        let drive = &robot.joints[j].drive;
        drive.viscous_friction.unwrap_or(0.0) * v[j] + drive.coulomb_friction.unwrap_or(0.0) * sign(v[j])
    })
}

/// Torques about shoulder and elbow of a force at the tip, axes of the base.
fn at_tip([q1, q2]: &[f64; 2], [fx, fy]: [f64; 2]) -> [f64; 2] {
    let q12 = q1 + q2;
    let elbow = 0.4 * (fy * q12.cos() - fx * q12.sin());
    [elbow + 0.5 * (fy * q1.cos() - fx * q1.sin()), elbow]
}

fn names(found: &Diagnosis) -> Vec<(&'static str, Vec<usize>)> {
    found.causes.iter().map(|c| (c.cause, c.joints.clone())).collect()
}

fn value(found: &Diagnosis, symbol: &str) -> f64 {
    let all = found.causes.iter().flat_map(|c| &c.parameters);
    all.into_iter().find(|p| p.symbol == symbol).unwrap_or_else(|| panic!("{symbol}: {:?}", names(found))).value
}

/// A compliant wall that the tip of the arm reaches repeatedly is one contact of all logs, with its
/// place and stiffness.
#[test]
#[cfg_attr(debug_assertions, ignore = "slow without optimisation: cargo test --release --lib")]
fn a_wall_is_a_contact_that_depends_on_the_position() {
    let robot = planar();
    let bodies = Bodies::of(&bare(&robot));
    let (stiffness, normal, at) = (20.0, [-0.6, 0.8], -0.2);
    let (found, missed) = found(&robot, 16, &|s| {
        let (rigid, friction) = (bodies.torques(s), plain(&robot, &s[1]));
        let [q1, q12] = [s[0][0], s[0][0] + s[0][1]];
        let tip = [0.5 * q1.cos() + 0.4 * q12.cos(), 0.5 * q1.sin() + 0.4 * q12.sin()];
        let depth = (at - normal[0] * tip[0] - normal[1] * tip[1]).max(0.0);
        let [shoulder, elbow] = at_tip(&s[0], normal.map(|n| stiffness * depth * n));
        [rigid[0] + friction[0] - shoulder, rigid[1] + friction[1] - elbow]
    });
    assert_eq!(names(&found), [("external_contact", vec![])]);
    let named: Vec<_> = found.causes[0].parameters.iter().map(|p| (p.symbol.as_str(), p.value, p.std)).collect();
    for (symbol, wanted) in [("k", stiffness), ("nx", normal[0]), ("ny", normal[1]), ("at", at)] {
        let (_, value, std) = named.iter().find(|p| p.0 == symbol).unwrap();
        // Within its stated deviation.
        assert!((value - wanted).abs() < (4.0 * std.unwrap()).min(0.01 * wanted.abs()), "{named:?}");
    }
    assert!(missed.iter().all(|m| *m < 1.1), "{missed:?}");
}

#[test]
#[cfg_attr(debug_assertions, ignore = "slow without optimisation: cargo test --release --lib")]
fn a_cable_that_is_taut_on_one_side_is_a_spring() {
    let robot = planar();
    let bodies = Bodies::of(&bare(&robot));
    let (found, missed) = found(&robot, 11, &|s| {
        let (rigid, friction) = (bodies.torques(s), plain(&robot, &s[1]));
        let cable = if s[0][1] > 0.4 { 0.6 * (s[0][1] - 0.4) } else { 0.0 };
        [rigid[0] + friction[0], rigid[1] + friction[1] + cable]
    });
    assert_eq!(names(&found), [("joint_spring", vec![2])]);
    assert!((value(&found, "KS2") - 0.6).abs() < 0.05 && (value(&found, "QS2") - 0.4).abs() < 0.1);
    assert_eq!(value(&found, "SIDE2"), 1.0);
    assert!(missed[1] < 1.5, "{missed:?}");
}

#[test]
#[cfg_attr(debug_assertions, ignore = "slow without optimisation: cargo test --release --lib")]
fn a_cable_that_stiffens_is_a_spring() {
    let robot = planar();
    let bodies = Bodies::of(&bare(&robot));
    let (found, missed) = found(&robot, 12, &|s| {
        let (rigid, friction) = (bodies.torques(s), plain(&robot, &s[1]));
        [rigid[0] + friction[0], rigid[1] + friction[1] + 0.08 * (1.6 * (s[0][1] + 0.2)).sinh()]
    });
    assert_eq!(names(&found), [("joint_spring", vec![2])]);
    assert!(value(&found, "KQ2") > 0.0 && (value(&found, "QS2") + 0.2).abs() < 0.2);
    assert!(missed[1] < 2.0, "{missed:?}");
}

/// More friction in one direction is a higher level and an asymmetry: one cause.
#[test]
#[cfg_attr(debug_assertions, ignore = "slow without optimisation: cargo test --release --lib")]
fn more_friction_in_one_direction_is_one_cause() {
    let robot = planar();
    let bodies = Bodies::of(&bare(&robot));
    let (found, missed) = found(&robot, 17, &|s| {
        let (rigid, friction) = (bodies.torques(s), plain(&robot, &s[1]));
        [rigid[0] + friction[0], rigid[1] + friction[1] + 0.06 * s[1][1].max(0.0)]
    });
    assert_eq!(names(&found), [("asymmetric_friction", vec![2])]);
    assert!((value(&found, "FV2") - 0.08).abs() < 0.01 && (value(&found, "FVA2") - 0.03).abs() < 0.01);
    assert!(missed[1] < 1.5, "{missed:?}");
}

/// `q_2 = theta_2 + c theta_1`: the motors' power equals the links' power.
#[test]
#[cfg_attr(debug_assertions, ignore = "slow without optimisation: cargo test --release --lib")]
fn an_axis_that_another_motor_carries_is_a_gear_coupling() {
    for (seed, c) in [(13, 0.3), (14, -0.04)] {
        let robot = planar();
        let bodies = Bodies::of(&bare(&robot));
        let (found, missed) = found(&robot, seed, &|s| {
            let friction = plain(&robot, &s[1]);
            let links = s.map(|x| [x[0], x[1] + c * x[0]]);
            let on_links = bodies.torques(&links);
            [on_links[0] + c * on_links[1] + friction[0], on_links[1] + friction[1]]
        });
        assert_eq!(names(&found), [("gear_coupling", vec![2, 1])]);
        assert!((value(&found, "CQ2") - c).abs() < 0.01, "{}", value(&found, "CQ2"));
        assert!(missed.iter().all(|m| *m < 1.5), "{missed:?}");
    }
}

#[test]
#[cfg_attr(debug_assertions, ignore = "slow without optimisation: cargo test --release --lib")]
fn load_friction_that_differs_by_quadrant_is_no_gain_error() {
    let robot = planar();
    let bodies = Bodies::of(&bare(&robot));
    let (found, missed) = found(&robot, 15, &|s| {
        let (rigid, friction) = (bodies.torques(s), plain(&robot, &s[1]));
        let share = if rigid[0] * s[1][0] > 0.0 { 0.08 } else { 0.03 };
        [rigid[0] + friction[0] + share * rigid[0].abs() * sign(s[1][0]), rigid[1] + friction[1]]
    });
    assert_eq!(names(&found), [("load_dependent_friction", vec![1])]);
    assert!((value(&found, "FL1") - 0.08).abs() < 0.01 && (value(&found, "FLB1") - 0.03).abs() < 0.01);
    assert!(missed[0] < 1.5, "{missed:?}");
}

#[test]
#[cfg_attr(debug_assertions, ignore = "slow without optimisation: cargo test --release --lib")]
fn friction_that_saturates_is_nonlinear_viscous() {
    let robot = planar();
    let bodies = Bodies::of(&bare(&robot));
    let (found, missed) = found(&robot, 16, &|s| {
        let (rigid, friction) = (bodies.torques(s), plain(&robot, &s[1]));
        [rigid[0] + friction[0] + 0.4 * (s[1][0] / 0.3).tanh(), rigid[1] + friction[1]]
    });
    assert_eq!(names(&found)[0], ("nonlinear_viscous_friction", vec![1]));
    let sizes: Vec<_> = found.causes.iter().flat_map(|c| &c.parameters).map(|p| (&p.symbol, p.value)).collect();
    assert!(missed[0] < 2.0, "{missed:?}, {sizes:?}");
}

/// A slip element of 0.3 N m beside a spring that carries twenty times as much on the same joint.
#[test]
#[cfg_attr(debug_assertions, ignore = "slow without optimisation: cargo test --release --lib")]
fn a_strong_spring_does_not_hide_friction_of_its_joint() {
    let robot = planar();
    let bodies = Bodies::of(&bare(&robot));
    let slip = std::cell::RefCell::new((f64::NAN, 0.0_f64));
    let (found, missed) = found(&robot, 20, &|s| {
        let (rigid, friction) = (bodies.torques(s), plain(&robot, &s[1]));
        let (last, z) = &mut *slip.borrow_mut();
        let moved = if last.is_nan() { 0.0 } else { s[0][1] - *last };
        *last = s[0][1];
        *z = (*z + moved).clamp(-0.06, 0.06);
        [rigid[0] + friction[0], rigid[1] + friction[1] + 8.0 * (s[0][1] - 0.2) + 5.0 * *z]
    });
    let mut all = names(&found);
    all.retain(|(name, _)| *name != "unknown");
    all.sort_unstable();
    assert_eq!(all, [("joint_spring", vec![2]), ("presliding_hysteresis", vec![2])]);
    assert!(missed[1] < 6.0, "{missed:?}");
}

/// Parallel axes, unknown links, and a rotor that the file lacks. In a refit without rotors it
/// resembles a motor shared by two joints, with negative inertia.
#[test]
#[cfg_attr(debug_assertions, ignore = "slow without optimisation: cargo test --release --lib")]
fn a_refit_has_rotors() {
    let known = planar();
    let bodies = Bodies::of(&bare(&known));
    let file = Robot { links: Vec::new(), ..known.clone() };
    let (found, missed) = found(&file, 17, &|s| {
        let (rigid, friction) = (bodies.torques(s), plain(&known, &s[1]));
        [rigid[0] + friction[0], rigid[1] + friction[1] + 0.09 * s[2][1]]
    });
    assert!(names(&found).iter().all(|(name, _)| *name != "gear_coupling"), "{:?}", names(&found));
    assert!(missed.iter().all(|m| *m < 2.0), "{missed:?}");
    let written = extended(file, &found);
    let rotor = written.joints[1].drive.rotor_inertia.unwrap();
    assert!((rotor - 0.09).abs() < 0.02, "{rotor}");
}

/// A motor whose dry friction also drives the next joint. Beside that slow error a short log seems
/// to determine little of the joint's own friction and offset; beside its cause it determines all
/// of it.
#[test]
fn what_a_log_shows_is_judged_beside_the_causes_found() {
    use crate::diagnose::fit::model::{Chosen, Mode, ModelUnderTest};
    use crate::diagnose::hypotheses::by_name;
    let robot = planar();
    let bodies = Bodies::of(&bare(&robot));
    let mut random = Random::new(31);
    let bytes = log(&robot, 5.0, &mut random, &|s| {
        let (rigid, friction) = (bodies.torques(s), plain(&robot, &s[1]));
        let shared = 1.5 * sign(s[1][0] + s[1][1]);
        [rigid[0] + friction[0] + shared, rigid[1] + friction[1] + shared + 0.4]
    });
    let recordings = [record("log", &bytes, 2)];
    let plant = PerturbableRobot::new(&robot);
    let mut tested = ModelUnderTest::new(&plant, &recordings, 100.0, Mode::Trusted, &[0.0; 2], false);
    let offset = |tested: &ModelUnderTest<'_>| tested.regulariser.as_ref().unwrap().precision[(5, 5)];
    tested.fit(&mut []);
    let before = offset(&tested);
    // One motor, its dry friction alone (the third bit).
    let cause = by_name("gear_coupling").unwrap();
    let mut coupling = [Chosen { cause, place: vec![1, 0], shape: vec![1.0, 4.0], x: vec![1.5] }];
    let fitted = tested.fit_regularised_beside(&mut coupling);
    assert!(offset(&tested) < 0.01 * before, "{} {before}", offset(&tested));
    assert!((coupling[0].x[0] - 1.5).abs() < 0.1 && (fitted.solution.x[fitted.friction + 5] - 0.4).abs() < 0.05);
}

/// A push of 0.9 s at the tip in a log of 20 s with an error throughout. It is a small share of the
/// log's error, but most of it while the push lasts.
#[test]
#[cfg_attr(debug_assertions, ignore = "slow without optimisation: cargo test --release --lib")]
fn a_push_counts_by_the_error_while_it_lasts() {
    let robot = planar();
    let bodies = Bodies::of(&bare(&robot));
    let mut random = Random::new(32);
    let play = |push: f64, seconds: f64, random: &mut Random| {
        let samples = std::cell::Cell::new(0.0);
        let bytes = log(&robot, seconds, random, &|s| {
            let t = samples.replace(samples.get() + 1.0) / RATE;
            let (rigid, friction) = (bodies.torques(s), plain(&robot, &s[1]));
            // A cogging that no law of the vocabulary describes.
            let rough = 0.12 * (7.0 * s[0][0] + 5.0 * s[0][1]).sin();
            let on = if (8.0..8.9).contains(&t) { push } else { 0.0 };
            let [shoulder, elbow] = at_tip(&s[0], [-0.6 * on, -0.8 * on]);
            [rigid[0] + friction[0] - shoulder + rough, rigid[1] + friction[1] - elbow + rough]
        });
        record("log", &bytes, 2)
    };
    let (fit, validate) = (play(2.0, 20.0, &mut random), play(0.0, 8.0, &mut random));
    let found = diagnose(&PerturbableRobot::new(&robot), &[fit], &[validate], &Settings::default(), &|_| {}).unwrap();
    let push = found.causes.iter().find(|c| c.cause == "external_contact");
    assert!(push.is_some_and(|c| c.share > 0.5), "{:?}", names(&found));
    let span = ["start", "end"].map(|symbol| value(&found, symbol));
    assert!((span[0] - 8.0).abs() < 0.3 && (span[1] - 8.9).abs() < 0.3, "{span:?}");
}

#[test]
fn what_runs_to_the_end_of_what_is_looked_for_is_no_estimate() {
    use crate::diagnose::hypotheses::{at_edge, by_name};
    let power = by_name("nonlinear_viscous_friction").unwrap();
    assert!(at_edge(power, &[0.201, 0.0]) && at_edge(power, &[4.99, 0.0]));
    assert!(!at_edge(power, &[0.4, 0.0]) && !at_edge(power, &[1.0, 0.3]));
    // An exponent that is an integer by preference only is weak evidence for a law.
    assert!(!at_edge(by_name("stribeck_friction").unwrap(), &[0.1, 0.5]));
}

/// A body in the hand during the fitted log alone. The file is right for the empty hand, so it is
/// offered, and the deviation of the fitted log is named.
#[test]
fn a_payload_of_the_fitted_log_alone() {
    let robot = planar();
    let (empty, mut loaded) = (Bodies::of(&robot), robot.clone());
    let link = loaded.links[1].as_mut().unwrap();
    link.m += 0.8;
    link.ms[0] += 0.8 * 0.35;
    link.i[2] += 0.8 * 0.35 * 0.35;
    let loaded = Bodies::of(&loaded);
    let mut random = Random::new(41);
    let fit = record("loaded", &log(&robot, 12.0, &mut random, &|s| loaded.torques(s)), 2);
    let validate = record("empty", &log(&robot, 8.0, &mut random, &|s| empty.torques(s)), 2);
    let found = diagnose(&PerturbableRobot::new(&robot), &[fit], &[validate], &Settings::default(), &|_| {}).unwrap();
    assert!(found.file_holds && !found.changed.is_empty());
    for (after, file) in found.extended.validate.iter().zip(&found.baseline.validate) {
        assert!(after <= &(1.01 * file), "{after} {file}");
    }
    let named: Vec<&str> = found.changes.iter().map(|c| c.cause).collect();
    assert!(named.iter().any(|c| ["payload", "link_inertia_error"].contains(c)), "{named:?}");
}

/// A changed friction term stands out of a periodic error of its size on the same joint, which no
/// law of the vocabulary has. It comes before laws that could follow both.
#[test]
#[cfg_attr(debug_assertions, ignore = "slow without optimisation: cargo test --release --lib")]
fn changed_friction_is_found_beside_an_error_of_its_size() {
    let robot = planar();
    let bodies = Bodies::of(&bare(&robot));
    for (seed, viscous, level) in [(31, 0.12, 0.0), (32, 0.0, 0.1)] {
        let (found, _) = found(&robot, seed, &|s| {
            let (rigid, friction) = (bodies.torques(s), plain(&robot, &s[1]));
            let foreign = 0.1 * (2.0 * s[0][0]).sin() * (3.0 * s[0][1]).cos();
            let change = viscous * s[1][1] + level * sign(s[1][1]);
            [rigid[0] + friction[0], rigid[1] + friction[1] + foreign + change]
        });
        let (name, symbol, truth) = match viscous > 0.0 {
            true => ("viscous_friction", "FV2", 0.05 + viscous),
            false => ("coulomb_friction", "FC2", 0.1 + level),
        };
        let first = found.causes.iter().find(|c| c.cause != "unknown").unwrap();
        assert_eq!((first.cause, &first.joints[..]), (name, &[2][..]), "{:?}", names(&found));
        assert!(first.probability > 0.5 && (value(&found, symbol) / truth - 1.0).abs() < 0.2, "{first:?}");
    }
}

/// Friction of the elbow that depends on the position or speed of the shoulder, which no law of the
/// vocabulary describes. The result is that law, and none that approximates it. (For the second,
/// the search alone finds friction by load, or one that fades.)
#[test]
fn a_law_of_another_joint_stands_alone() {
    let robot = planar();
    let bodies = Bodies::of(&bare(&robot));
    type Law = fn(&[[f64; 2]; 3]) -> f64;
    let of_place: (Law, &str) = (|s| 0.25 * (2.0 * s[0][0]).sin() * s[1][1], "*sin(2*q1)*dq2");
    let of_speed: (Law, &str) = (|s| 0.25 * s[1][0].abs() * sign(s[1][1]), "*sign(dq2)*abs(dq1)");
    for ((law, text), seed) in [(of_place, 51), (of_place, 52), (of_speed, 51), (of_speed, 52)] {
        let (found, _) = found(&robot, seed, &|s| {
            let (rigid, friction) = (bodies.torques(s), plain(&robot, &s[1]));
            [rigid[0] + friction[0], rigid[1] + friction[1] + law(s)]
        });
        let named: Vec<&str> = found.causes.iter().filter(|c| c.law.is_none()).map(|c| c.cause).collect();
        let laws: Vec<&str> = found.causes.iter().filter_map(|c| c.law.as_deref()).collect();
        assert!(named.is_empty() && laws.len() == 1 && laws[0].ends_with(text), "{named:?} {laws:?}");
    }
}

/// Friction that varies along the travel by more than the file's level would drive the joint. It
/// has its name, and the evidence says so.
#[test]
#[cfg_attr(debug_assertions, ignore = "slow without optimisation: cargo test --release --lib")]
fn friction_beyond_the_level_has_its_name() {
    let robot = planar();
    let bodies = Bodies::of(&bare(&robot));
    let size = 8.0 * robot.joints[1].drive.coulomb_friction.unwrap();
    let (found, missed) = found(&robot, 21, &|s| {
        let (rigid, friction) = (bodies.torques(s), plain(&robot, &s[1]));
        let wave = size * (5.3 * s[0][1] + 0.4).cos() * sign(s[1][1]);
        [rigid[0] + friction[0], rigid[1] + friction[1] + wave]
    });
    assert_eq!(names(&found), [("position_dependent_friction", vec![2])]);
    assert!((value(&found, "PN2") - 5.3).abs() < 0.1, "{}", value(&found, "PN2"));
    assert!(found.causes[0].evidence.contains("drive it in a part"), "{}", found.causes[0].evidence);
    assert!(missed.iter().all(|m| *m < 2.5), "{missed:?}");
}

/// An error of the last part of a log, which is not fitted, has no cause on the fitted part. The
/// joint is named, and the part.
#[test]
#[cfg_attr(debug_assertions, ignore = "slow without optimisation: cargo test --release --lib")]
fn an_error_of_the_last_part_alone_is_unknown_there() {
    let robot = planar();
    let bodies = Bodies::of(&bare(&robot));
    let bytes = log(&robot, 20.0, &mut Random::new(5), &|s| {
        let (rigid, friction) = (bodies.torques(s), plain(&robot, &s[1]));
        [rigid[0] + friction[0], rigid[1] + friction[1]]
    });
    let text = String::from_utf8(bytes).unwrap();
    let rows = text.lines().count();
    let later = |(row, line): (usize, &str)| match line.rsplit_once(',') {
        Some((others, tau)) if 10 * row > 8 * rows => format!("{others},{}\n", tau.parse::<f64>().unwrap() + 0.2),
        _ => format!("{line}\n"),
    };
    let text: String = text.lines().enumerate().map(later).collect();
    let plant = PerturbableRobot::new(&robot);
    let found = diagnose(&plant, &[record("log", text.as_bytes(), 2)], &[], &Settings::default(), &|_| {}).unwrap();
    assert_eq!(names(&found), [("unknown", vec![2])]);
    assert!(found.causes[0].evidence.contains("on the last part of the logs"), "{}", found.causes[0].evidence);
}
