//! Seeded cases with one hidden effect each.

use dh_codegen::robot::{Robot, no_files};

use super::world::{Hidden, World, record};
use crate::diagnose::fit::model::{Chosen, Mode, ModelUnderTest};
use crate::diagnose::hypotheses::causes;
use crate::diagnose::select::model_choice::LeftOut;
use crate::diagnose::{Diagnosis, Settings, diagnose};
use crate::model::perturbable_robot::PerturbableRobot;
use crate::model::{Arm, PerturbableArm};
use crate::numerics::prng::Random;

fn robot(name: &str) -> Robot {
    let path = format!("{}/robots/{name}.yaml", env!("CARGO_MANIFEST_DIR"));
    let mut robot = Robot::from_yaml(&std::fs::read_to_string(path).unwrap(), &no_files).unwrap().robot;
    for row in robot.moving() {
        let drive = &mut robot.joints[row].drive;
        drive.viscous_friction = Some(drive.viscous_friction.unwrap_or(0.5));
        drive.coulomb_friction = Some(drive.coulomb_friction.unwrap_or(0.3));
    }
    robot
}

const ROBOTS: [&str; 4] = ["kuka-lwr4", "franka-panda", "ur10e", "puma560"];

fn all(random: &mut Random) -> Vec<Hidden> {
    vec![
        Hidden::Nothing,
        Hidden::Stribeck { speed: random.uniform(0.05, 0.15) },
        Hidden::SquareViscous,
        Hidden::RootViscous,
        Hidden::Load,
        Hidden::Bristle { distance: random.uniform(0.01, 0.05) },
        Hidden::Warming { time: random.uniform(4.0, 10.0) },
        Hidden::Bump { at: random.uniform(-0.3, 0.3), width: random.uniform(0.3, 0.7) },
        Hidden::Ripple { order: random.uniform(12.0, 60.0) },
        Hidden::Spring { stiffness: random.uniform(0.1, 0.6) },
        Hidden::Elastic,
        Hidden::Gain,
        Hidden::Offset,
        Hidden::Viscous,
        Hidden::Coulomb,
        Hidden::Saturation,
        Hidden::Zero,
        Hidden::Payload,
        Hidden::Tilt,
        Hidden::Delay { all: true },
        Hidden::Delay { all: false },
        Hidden::Contact,
        Hidden::Rotor,
        Hidden::Asymmetric,
        Hidden::Beat,
        Hidden::Cross,
    ]
}

/// One case: the hidden effect, its joint, the diagnosis and the robot's name.
fn case(seed: u64, which: Option<usize>, size: f64) -> (Hidden, usize, Diagnosis, String) {
    let mut random = Random::new(seed);
    let name = ROBOTS[random.below(4)];
    let robot = robot(name);
    let dof = robot.dof();
    let list = all(&mut random);
    let hidden = list[which.unwrap_or_else(|| random.below(list.len()))].clone();
    let j = random.below(dof);
    let noise: Vec<f64> =
        robot.moving().iter().map(|&r| 0.001 * robot.joints[r].limits.torque.unwrap_or(50.0)).collect();
    let world = World {
        robot: &robot,
        hidden: vec![(hidden.clone(), j, size)],
        noise: &noise,
        rate: 500.0,
        sizes: Default::default(),
    };
    let (a, b) = (world.log(12.0, &mut random), world.log(8.0, &mut random));
    let (fit, validate) = (record("fit", &a, dof), record("validate", &b, dof));
    let plant = PerturbableRobot::new(&robot);
    let found = diagnose(&plant, &[fit], &[validate], &Settings::default(), &|_| {}).unwrap();
    (hidden, j, found, name.into())
}

/// A robot file has no key for a coefficient of a spring's oscillation. The evaluated and offered
/// law has its stiffness and damping alone, whatever factor a free fit would find.
#[test]
fn a_law_whose_size_is_in_its_shape_is_not_scaled() {
    let robot = robot("ur10e");
    let noise = vec![0.05; robot.dof()];
    let world = World {
        robot: &robot,
        hidden: vec![(Hidden::Elastic, 1, 20.0)],
        noise: &noise,
        rate: 500.0,
        sizes: Default::default(),
    };
    let log = [record("fit", &world.log(6.0, &mut Random::new(5)), robot.dof())];
    let plant = PerturbableRobot::new(&robot);
    let delays = plant.delays();
    let mut tested = ModelUnderTest::new(&plant, &log, 100.0, Mode::Refitted, &delays, false);
    // Twice as stiff as a spring of 3 Hz: the free fit scales its oscillation.
    let cause = causes().find(|c| c.unit()).unwrap();
    let mut chosen = vec![Chosen { cause, place: vec![1], shape: vec![8e3, 40.0], x: Vec::new() }];
    let free = tested.fit(&mut chosen);
    assert!((free.solution.x[free.first[0]] - 1.0).abs() > 0.05, "{}", free.solution.x[free.first[0]]);
    let fitted = tested.possible(&mut chosen, &free).unwrap();
    assert_eq!(fitted.solution.x[fitted.first[0]], 1.0);
    assert_eq!(chosen[0].x, [1.0]);
}

/// The model that comes of a fit may leave a law that rests on it nothing to act on: a link of no
/// inertia has no swing. Left-out stretches are those of the fit all the same.
#[test]
fn stretches_have_the_terms_that_were_fitted() {
    let robot = robot("ur10e");
    let noise = vec![0.05; robot.dof()];
    let world = World { robot: &robot, hidden: Vec::new(), noise: &noise, rate: 500.0, sizes: Default::default() };
    let log = [record("fit", &world.log(6.0, &mut Random::new(5)), robot.dof())];
    let plant = PerturbableRobot::new(&robot);
    let mut tested = ModelUnderTest::new(&plant, &log, 100.0, Mode::Refitted, &plant.delays(), false);
    let cause = causes().find(|c| c.unit()).unwrap();
    let mut chosen = vec![Chosen { cause, place: vec![1], shape: vec![8e3, 40.0], x: Vec::new() }];
    let fitted = tested.fit(&mut chosen);
    let [possible, free] =
        [&tested.possible_left_out(&chosen, &fitted).unwrap(), &tested.left_out(&chosen, &fitted)].map(LeftOut::rms);
    tested.scene.set_model(vec![0.0; plant.base_parameters().len()], None);
    assert!(fitted.terms[0].len() == 1 && tested.terms(&chosen[0]).is_empty());
    assert_eq!(tested.possible_left_out(&chosen, &fitted).unwrap().rms(), possible);
    assert_eq!(tested.left_out(&chosen, &fitted).rms(), free);
}

#[test]
#[ignore = "minutes; prints the table"]
fn battery() {
    let number = |name: &str, default: u64| std::env::var(name).ok().and_then(|v| v.parse().ok()).unwrap_or(default);
    let (from, count) = (number("FROM", 1), number("COUNT", 26));
    let size = number("SIZE", 4) as f64;
    let mut right = 0;
    for seed in from..from + count {
        let which = (seed as usize) % 26;
        let clock = std::time::Instant::now();
        let (hidden, j, found, name) = case(seed, Some(which), size);
        let first = found.causes.first();
        let word = first.map_or("nothing_wrong", |c| c.cause);
        let ok = word == hidden.name();
        right += usize::from(ok);
        let list: Vec<String> = found
            .causes
            .iter()
            .map(|c| {
                let p: Vec<String> =
                    c.parameters.iter().take(3).map(|p| format!("{}={:.3}", p.symbol, p.value)).collect();
                format!(
                    "{}@{:?}p{:.2}[{}]~{:?}",
                    c.cause,
                    c.joints,
                    c.probability,
                    p.join(" "),
                    c.not_distinguished_from
                )
            })
            .collect();
        println!(
            "{} seed {seed} {name} {} j{} ({:.1} of noise) -> {} | {} ({:.1} s) links_refitted {}",
            if ok { "  " } else { "XX" },
            hidden.name(),
            j + 1,
            found.baseline.validate[j] / found.noise_floor[j],
            found.verdict.word(),
            list.join("; "),
            clock.elapsed().as_secs_f64(),
            found.links_refitted
        );
    }
    println!("{right} of {count}");
}
