//! Tests of possible bodies: two solution methods, feasibility, and contradictory data.

mod measured;

use dh_codegen::arm::param;
use dh_codegen::robot::{Robot, no_files};
use nalgebra::{DMatrix, DVector};

use super::newton::Weights;
use super::setup::{Data, Setup, grouping};
use super::*;
use crate::data::signal::Motion;
use crate::identify::{
    AccumulatorSettings, IdentifySettings, QrAccumulator, implausible_links, recover_standard, solve,
};
use crate::model::interpreted::Interpreted;
use crate::model::rigid_body::random::Family;
use crate::model::{DriveTerm, Inertial, LinkExtents, StandardParameter, States};
use crate::numerics::prng::Random;

/// A random robot with possible bodies, and its standard parameters.
fn robot(seed: u64, rows: [usize; 2]) -> (Robot, Interpreted, Vec<f64>) {
    of(seed, &Family { rows, tool: 0.0, upright: 1.0, ..Family::default() })
}

fn of(seed: u64, family: &Family) -> (Robot, Interpreted, Vec<f64>) {
    let mut random = Random::new(seed);
    let mut robot = random.robot(family);
    for joint in &mut robot.joints {
        // Friction and rotor inertias are made non-negative, like those of possible bodies.
        for term in
            [&mut joint.drive.rotor_inertia, &mut joint.drive.viscous_friction, &mut joint.drive.coulomb_friction]
        {
            *term = term.map(f64::abs);
        }
    }
    let truth = random.phi(&robot);
    let arm = Interpreted::new(&robot, &[]);
    (robot, arm, truth)
}

fn bodies(truth: &[f64], links: usize) -> Vec<Option<[f64; 10]>> {
    (0..links).map(|l| truth[10 * l..10 * l + 10].try_into().ok()).collect()
}

/// Equations of the whole arm at random states, with noise.
fn equations(arm: &Interpreted, truth: &[f64], states: usize, noise: f64, seed: u64) -> Data {
    let (n, b) = (arm.dof(), arm.base_parameters().len());
    let mut random = Random::new(seed);
    let mut draw = |size: f64| random.vector(n * states, size);
    let s = States { len: states, q: draw(3.0), dq: draw(1.5), ddq: draw(4.0) };
    let mut entries = vec![0.0; arm.base_pattern().len() * states];
    arm.base_regressor(&s, &mut entries);
    let mut w = DMatrix::zeros(n * states, b);
    for (k, &(row, column)) in arm.base_pattern().iter().enumerate() {
        for s in 0..states {
            w[(row * states + s, column)] += entries[k * states + s];
        }
    }
    let beta = grouping(arm.base_parameters(), truth.len()) * DVector::from_column_slice(truth);
    let tau = &w * beta
        + DVector::from_fn(n * states, |_, _| noise * (random.even(1.0) + random.even(1.0) + random.even(1.0)));
    // Triangular factor of the equations, with one row for the part that no parameters remove.
    let mut all = w.insert_column(b, 0.0);
    all.set_column(b, &tau);
    let r = (all / noise).qr().unpack_r();
    Data { r: r.columns(0, b).into_owned(), z: r.column(b).into_owned() }
}

/// Half the squared residual that no base parameters remove.
fn floor(data: &Data) -> f64 {
    let svd = data.r.clone().svd(true, true);
    let beta = svd.solve(&data.z, 1e-10 * svd.singular_values.max()).unwrap();
    0.5 * (&data.r * beta - &data.z).norm_squared()
}

#[test]
fn two_routes_agree() {
    let mut tight = 0;
    for seed in 0..12 {
        let (robot, arm, truth) = robot(40 + seed, [2, 4]);
        // Noise so large that the plain solution is no possible body.
        let data = equations(&arm, &truth, 60, 30.0, seed);
        let prior = prior_bodies(&bodies(&truth, robot.joints.len()), &geometric_bodies(&arm.ends()));
        // Without bounds, undetermined directions could grow without end, and the sum of squares
        // would have no minimum.
        let bounds = Bounds {
            mass: (0..prior.len()).map(|l| (l, [0.3 * prior[l].body[0], 3.0 * prior[l].body[0]])).collect(),
            ..Bounds::default()
        };
        let settings = ConsistentSettings { bounds, ..ConsistentSettings::default() };
        let mut setup = Setup::of(arm.description(), &data, &prior, &truth, &settings).unwrap();
        for link in &setup.problem.links {
            let trace = (0..4).map(|k| (link.start + k, -1.0)).collect();
            setup.problem.walls.push(super::newton::Wall { a: trace, b: -50.0 });
        }
        let weights = Weights { w: 1e-9, mu: 1e-9 };
        let (v, steps) = setup.problem.follow(&setup.start, weights).unwrap();
        let (cut, rounds) = cuts::by_cuts(&setup.problem, 1e-9, 60).unwrap();
        let (upper, lower) = (setup.problem.misfit(&v), setup.problem.misfit(&cut));
        println!(
            "{seed}: {upper} {lower} {:.2e} in {rounds} rounds, {steps} steps, plain {}",
            upper / lower - 1.0,
            floor(&data)
        );
        assert!((upper - lower).abs() < 1e-9 * upper, "seed {seed}: {upper} {lower}");
        tight += usize::from(upper > floor(&data) + 0.1);
    }
    assert!(tight >= 6, "the cones matter in {tight} cases only");
}

/// A motion of some sines with the robot's torque and white noise.
fn motion(arm: &Interpreted, truth: &[f64], seconds: f64, noise: f64, seed: u64) -> Motion {
    let (rate, n) = (200.0, arm.dof());
    let len = (seconds * rate) as usize;
    let mut random = Random::new(seed);
    let mut states = States { len, ..States::default() };
    let terms: Vec<Vec<[f64; 3]>> =
        (0..n).map(|_| (1..=4).map(|k| [random.even(0.5), 1.3 * f64::from(k), random.even(3.0)]).collect()).collect();
    let sum = |j: usize, s: usize, g: &dyn Fn(f64, f64, f64) -> f64| -> f64 {
        terms[j].iter().map(|&[a, w, p]| g(a, w, w * s as f64 / rate + p)).sum()
    };
    for j in 0..n {
        states.q.extend((0..len).map(|s| sum(j, s, &|a, _, x| a * x.sin())));
        states.dq.extend((0..len).map(|s| sum(j, s, &|a, w, x| a * w * x.cos())));
        states.ddq.extend((0..len).map(|s| sum(j, s, &|a, w, x| -a * w * w * x.sin())));
    }
    let mut tau = vec![0.0; n * len];
    arm.inverse_dynamics(&states, truth, &mut tau);
    tau.iter_mut().for_each(|t| *t += noise * (random.even(1.0) + random.even(1.0) + random.even(1.0)));
    Motion {
        period: rate.recip(),
        states,
        tau,
        core: 0..len,
        stride: 1,
        velocity_noise: vec![0.0; n],
        position_noise: Vec::new(),
        ..Motion::default()
    }
}

fn factors(arm: &Interpreted, motion: &Motion) -> Factors {
    let mut stack = QrAccumulator::new("test", arm, AccumulatorSettings::default());
    stack.absorb(motion);
    stack.finish()
}

#[test]
fn random_arms_get_possible_bodies_and_the_plain_ones_where_these_are_possible() {
    let (mut inside, mut outside) = (0, 0);
    for seed in 0..12 {
        let (robot, arm, truth) = robot(300 + seed, [1, 6]);
        let (noise, seconds) = if seed % 2 == 0 { (5e-3, 10.0) } else { (5.0, 2.0) };
        let logs = [factors(&arm, &motion(&arm, &truth, seconds, noise, seed))];
        let found = solve(&arm, &logs, &[], &IdentifySettings::default()).unwrap();
        let guesses = geometric_bodies(&arm.ends());
        let drives = vec![0.0; truth.len()];
        for prior in [prior_bodies(&bodies(&truth, robot.joints.len()), &guesses), prior_bodies(&[], &guesses)] {
            let result = consistent(&arm, &logs, &[], &found, &prior, &drives, &ConsistentSettings::default()).unwrap();
            for link in 0..robot.joints.len() {
                let body: [f64; 10] = result.standard[10 * link..10 * link + 10].try_into().unwrap();
                assert!(crate::model::pseudo_inertia::is_body(&body), "seed {seed}: {body:?}");
                assert!(result.margins[link] > result.margin);
            }
            for (parameter, value) in arm.standard_parameters().iter().zip(&result.standard) {
                assert!(!parameter.is_level() || *value > 0.0, "{parameter} {value}");
            }
            // If possibility costs nothing, the parameters are the plain ones, up to the
            // contributions of noise and prior.
            if result.possible.growth_percent < 1e-3 {
                inside += 1;
                for (p, q) in found.parameters.iter().zip(&result.base) {
                    assert!(
                        (p.value - q).abs() < 2.0 * p.std + 1e-9,
                        "seed {seed} {}: {} {q} ± {}",
                        p.name,
                        p.value,
                        p.std
                    );
                }
            } else {
                outside += 1;
            }
        }
    }
    assert!(inside >= 8 && outside >= 4, "{inside} inside, {outside} outside");
}

/// Whether possibility costs more than noise is an F test. Its degrees of freedom are the
/// independent samples minus the parameters, which matters for short logs.
#[test]
fn the_cost_of_possibility_is_judged_by_what_is_left() {
    use statrs::distribution::{ContinuousCDF, FisherSnedecor};
    let settings = ConsistentSettings { most_cost_percent: 1e9, ..ConsistentSettings::default() };
    let (mut judged, mut matters) = (0, 0);
    for seed in 0..16 {
        let (robot, arm, truth) = robot(305, [3, 3]);
        let b = arm.base_parameters().len() as f64;
        // Torques that no bodies explain, with noise that grows with `seed`.
        let mut motion = motion(&arm, &truth, 0.15, 0.0, seed);
        let scale = motion.tau.iter().fold(0.0_f64, |m, t| m.max(t.abs()));
        let mut random = Random::new(50 + seed);
        motion.tau.iter_mut().for_each(|t| *t = -*t + 0.02 * scale * f64::from(seed as u32 + 1) * random.even(1.0));
        let logs = [factors(&arm, &motion)];
        let Ok(found) = solve(&arm, &logs, &[], &IdentifySettings::default()) else { continue };
        let freedom = found.independent - b;
        if freedom < 2.0 {
            continue;
        }
        let prior = prior_bodies(&bodies(&truth, robot.joints.len()), &geometric_bodies(&arm.ends()));
        let Ok(result) = consistent(&arm, &logs, &[], &found, &prior, &vec![0.0; truth.len()], &settings) else {
            continue;
        };
        let grown = (1.0 + 0.01 * result.possible.growth_percent).powi(2) - 1.0;
        let limit = |freedom: f64| FisherSnedecor::new(b, freedom).unwrap().inverse_cdf(0.999);
        let f = grown * freedom / b;
        assert_eq!(result.significant, f > limit(freedom), "seed {seed}: {f} {}", limit(freedom));
        judged += 1;
        // With the parameters counted on the other side, the verdict would differ.
        let other = freedom + 2.0 * b;
        matters += usize::from((f > limit(freedom)) != (grown * other / b > limit(other)));
    }
    assert!(judged >= 8 && matters >= 2, "{judged} {matters}");
}

#[test]
fn torques_of_no_body_are_refused() {
    let (robot, arm, truth) = robot(305, [3, 3]);
    let mut motion = motion(&arm, &truth, 10.0, 0.01, 1);
    motion.tau.iter_mut().for_each(|t| *t = -*t);
    let logs = [factors(&arm, &motion)];
    let found = solve(&arm, &logs, &[], &IdentifySettings::default()).unwrap();
    let prior = prior_bodies(&bodies(&truth, robot.joints.len()), &geometric_bodies(&arm.ends()));
    let drives = vec![0.0; truth.len()];
    let error = consistent(&arm, &logs, &[], &found, &prior, &drives, &ConsistentSettings::default()).unwrap_err();
    assert!(
        matches!(error, ConsistentError::Contradiction { growth_percent, .. } if growth_percent > 100.0),
        "{error}"
    );
    assert!(error.to_string().contains("wrong sign"));
}

#[test]
fn the_prior_pulls_as_it_weighs_and_bounds_hold() {
    // Revolute joints only: prismatic ones would determine the links' masses.
    let turning = Family { rows: [4, 4], prismatic: 0.0, fixed: 0.0, tool: 0.0, upright: 1.0, ..Family::default() };
    let (robot, arm, truth) = of(41, &turning);
    let logs = [factors(&arm, &motion(&arm, &truth, 2.0, 1.0, 3))];
    let found = solve(&arm, &logs, &[], &IdentifySettings::default()).unwrap();
    let links = robot.joints.len();
    let prior = prior_bodies(&bodies(&truth, links), &geometric_bodies(&arm.ends()));
    let drives = vec![0.0; truth.len()];
    let fit = |settings: &ConsistentSettings| consistent(&arm, &logs, &[], &found, &prior, &drives, settings).unwrap();
    let (mut distance, mut growth) = (f64::INFINITY, -1.0);
    for weight in [1e-2, 1.0, 1e2, 1e4, 1e8] {
        let result = fit(&ConsistentSettings { prior_weight: weight, ..ConsistentSettings::default() });
        let now: f64 = result.distances.iter().sum();
        assert!(now <= distance && result.cost.growth_percent >= growth, "{weight}: {now} {distance}");
        // Cost from the errors of all joints, in standard deviations of their noise.
        let weighted = |rms: &[f64]| rms.iter().zip(&found.noise.sigma).map(|(r, s)| (r / s).powi(2)).sum::<f64>();
        let grown = 100.0 * ((weighted(&result.cost.fit.rms) / weighted(&found.fit.rms)).sqrt() - 1.0);
        let stated = result.cost.growth_percent;
        assert!((grown - stated).abs() < 0.02 * stated + 0.01, "{weight}: {grown} {stated}");
        (distance, growth) = (now, result.cost.growth_percent);
    }
    assert!(distance < 1e-6, "{distance}");

    let total: f64 = 1.2 * (0..links).map(|l| truth[10 * l]).sum::<f64>();
    let bounds = Bounds { mass: vec![(0, [0.1, 40.0])], center: vec![(0, 0, [0.01, 0.02])], total_mass: Some(total) };
    let settings = ConsistentSettings { bounds, ..ConsistentSettings::default() };
    let result = fit(&settings);
    assert!((result.total_mass / total - 1.0).abs() < 1e-9);
    let center = result.standard[1] / result.standard[0];
    assert!((0.01..0.02).contains(&center), "{center}");
    assert_eq!(result, fit(&settings), "the same every time");
}

#[test]
fn base_parameters_of_possible_bodies_are_reproduced() {
    for seed in 0..6 {
        let (robot, arm, truth) = robot(500 + seed, [2, 7]);
        let base = base_of(&arm, &truth);
        let prior = prior_bodies(&[], &geometric_bodies(&arm.ends()));
        let result = possible_bodies(&arm, &base, &prior, &truth, &ConsistentSettings::default()).unwrap();
        assert!(result.worst < 1e-5, "seed {seed}: {}", result.worst);
        assert!(result.margins.iter().all(|m| *m > 1e-3) && result.margins.len() == robot.joints.len());
        let mut none = base.clone();
        let heaviest = arm
            .base_parameters()
            .iter()
            .position(|b| matches!(b.leader, StandardParameter::Link(_, Inertial::ZZ)))
            .unwrap();
        none[heaviest] = -1.0;
        // Impossible parameters: the nearest ones or a stall, but never reported as met.
        match possible_bodies(&arm, &none, &prior, &truth, &ConsistentSettings::default()) {
            Ok(result) => assert!(!result.exact && result.residual[heaviest] > 0.5, "{:?}", result.residual),
            Err(error) => assert!(matches!(error, ConsistentError::Stalled(_)), "{error}"),
        }
    }
}

/// Base parameters leave the links undetermined: the least change may be impossible although other
/// links with the same torques are possible, with a friction level at its bound.
#[test]
fn links_that_could_be_built_have_the_same_base_parameters() {
    let settings = ConsistentSettings::default();
    for seed in 0..2 {
        let (_, arm, mut truth) = robot(700 + seed, [2, 7]);
        let parameters = arm.standard_parameters();
        let friction = parameters.iter().position(|p| p.is_level() && !p.is_rotor());
        friction.iter().for_each(|&i| truth[i] = 0.0);
        let base = base_of(&arm, &truth);
        let mut plain = recover_standard(&arm, &base, None).unwrap();
        assert!(!implausible_links(parameters, &plain).is_empty(), "seed {seed}");
        let prior = prior_bodies(&[], &geometric_bodies(&arm.ends()));
        let built = buildable_links(&arm, &plain, &prior, &settings).unwrap();
        assert!(implausible_links(parameters, &built).is_empty(), "seed {seed}");
        friction.iter().for_each(|&i| assert_eq!(built[i], 0.0));
        for (a, b) in base_of(&arm, &built).iter().zip(&base) {
            assert!((a - b).abs() < 1e-5, "seed {seed}: {a} {b}");
        }
        assert_eq!(buildable_links(&arm, &built, &prior, &settings).as_ref(), Ok(&built));
        // A negative moment of inertia is impossible.
        let heaviest = arm
            .base_parameters()
            .iter()
            .position(|b| matches!(b.leader, StandardParameter::Link(_, Inertial::ZZ)))
            .unwrap();
        let mut none = base.clone();
        none[heaviest] = -1.0;
        plain = recover_standard(&arm, &none, None).unwrap();
        assert_eq!(buildable_links(&arm, &plain, &prior, &settings), Err(implausible_links(parameters, &plain)));
    }
}

fn file(name: &str) -> (Robot, Interpreted) {
    let text = std::fs::read_to_string(format!("robots/{name}.yaml")).unwrap();
    let robot = Robot::from_yaml(&text, &no_files).unwrap().robot;
    let arm = Interpreted::new(&robot, &[]);
    (robot, arm)
}

/// The LWR's links are possible bodies, and so are the published base parameters: other bodies
/// reproduce them from a rough guess.
#[test]
fn the_published_lwr_is_possible() {
    let (robot, arm) = file("kuka-lwr4");
    let standard = param::standard_values(&robot).unwrap();
    let known = bodies(&standard, 7);
    for body in known.iter().flatten() {
        assert!(crate::model::pseudo_inertia::is_body(body), "{body:?}");
    }
    let base = base_of(&arm, &standard);
    for prior in
        [prior_bodies(&known, &geometric_bodies(&arm.ends())), prior_bodies(&[], &geometric_bodies(&arm.ends()))]
    {
        let result = possible_bodies(&arm, &base, &prior, &standard, &ConsistentSettings::default()).unwrap();
        println!("worst {:.2e} exact {} margins {:?}", result.worst, result.exact, result.margins);
        assert!(result.worst < 1e-4, "{}", result.worst);
    }
}

/// The stated uncertainty of extrapolation is correct: over runs with different noise, the torque
/// errors over states in the whole range are as large as the stated standard deviation.
#[test]
fn the_announced_uncertainty_elsewhere_is_honest() {
    let (robot, arm) = file("kuka-lwr4");
    let truth = param::standard_values(&robot).unwrap();
    let n = arm.dof();
    let (mut squares, mut announced) = (vec![0.0; n], vec![0.0; n]);
    let elsewhere = {
        let mut random = Random::new(77);
        let mut states = States { len: 400, ..States::default() };
        let ranges: Vec<[f64; 3]> = arm.ranges();
        for [low, high, _] in &ranges {
            states.q.extend((0..400).map(|_| 0.5 * (low + high) + 0.5 * random.even(high - low)));
        }
        for [_, _, speed] in &ranges {
            states.dq.extend((0..400).map(|_| random.even(0.5 * speed)));
        }
        for [_, _, speed] in &ranges {
            states.ddq.extend((0..400).map(|_| random.even(2.0 * speed)));
        }
        states
    };
    let rows = arm.base_pattern().len();
    let mut entries = vec![0.0; rows * elsewhere.len];
    arm.base_regressor(&elsewhere, &mut entries);
    let base = base_of(&arm, &truth);
    let runs = 12;
    for seed in 0..runs {
        let logs = [factors(&arm, &motion(&arm, &truth, 6.0, 0.3, 900 + seed))];
        let found = solve(&arm, &logs, &[], &IdentifySettings::default()).unwrap();
        let carry = crate::identify::extrapolation(&arm, &arm, &found);
        let error: Vec<f64> = found.parameters.iter().zip(&base).map(|(p, t)| p.value - t).collect();
        let mut torque = vec![0.0; n * elsewhere.len];
        for (k, &(row, column)) in arm.base_pattern().iter().enumerate() {
            for s in 0..elsewhere.len {
                torque[row * elsewhere.len + s] += entries[k * elsewhere.len + s] * error[column];
            }
        }
        for j in 0..n {
            let mean = torque[j * elsewhere.len..(j + 1) * elsewhere.len].iter().map(|t| t * t).sum::<f64>();
            squares[j] += mean / elsewhere.len as f64;
            announced[j] += carry.torque_std[j].powi(2);
        }
    }
    for j in 0..n {
        let ratio = (squares[j] / announced[j]).sqrt();
        println!("joint {}: {ratio:.2}", j + 1);
        assert!((0.6..1.5).contains(&ratio), "joint {}: {ratio}", j + 1);
    }
}

/// Fully correlated errors: for a covariance `s s'` the stated uncertainty is the torque of `s`
/// itself, root mean square over the range. Tested for errors of all parameters, and for viscous
/// and dry friction alone, whose columns have the same sign.
#[test]
fn the_uncertainty_of_errors_that_go_together() {
    let (robot, arm) = file("planar2r");
    let truth = param::standard_values(&robot).unwrap();
    let n = arm.dof();
    let logs = [factors(&arm, &motion(&arm, &truth, 6.0, 0.3, 911))];
    let mut found = solve(&arm, &logs, &[], &IdentifySettings::default()).unwrap();
    let b = found.parameters.len();
    let mut random = Random::new(12);
    let every: Vec<f64> = random.vector(b, 0.1);
    let friction = |p: &crate::model::BaseParameter| {
        matches!(p.leader, StandardParameter::Drive(_, DriveTerm::FV | DriveTerm::FC))
    };
    let dry: Vec<f64> = arm.base_parameters().iter().map(|p| if friction(p) { 0.1 } else { 0.0 }).collect();
    assert_eq!(dry.iter().filter(|e| **e > 0.0).count(), 2 * n);
    const LEN: usize = 40_000;
    let mut states = States { len: LEN, ..States::default() };
    let ranges: Vec<[f64; 3]> = arm.ranges();
    for [low, high, _] in &ranges {
        states.q.extend((0..LEN).map(|_| 0.5 * (low + high) + 0.5 * random.even(high - low)));
    }
    for [_, _, speed] in &ranges {
        states.dq.extend((0..LEN).map(|_| random.even(0.5 * speed)));
    }
    for [_, _, speed] in &ranges {
        states.ddq.extend((0..LEN).map(|_| random.even(2.0 * speed)));
    }
    let mut entries = vec![0.0; arm.base_pattern().len() * LEN];
    arm.base_regressor(&states, &mut entries);
    for error in [every, dry] {
        for (parameter, error) in found.parameters.iter_mut().zip(&error) {
            parameter.std = error.abs();
        }
        found.correlation = (0..b * b).map(|e| (error[e / b] * error[e % b]).signum()).collect();
        let announced = crate::identify::extrapolation(&arm, &arm, &found).torque_std;
        let mut torque = vec![0.0; n * LEN];
        for (k, &(row, column)) in arm.base_pattern().iter().enumerate() {
            for s in 0..LEN {
                torque[row * LEN + s] += entries[k * LEN + s] * error[column];
            }
        }
        for j in 0..n {
            let rms = (torque[j * LEN..(j + 1) * LEN].iter().map(|t| t * t).sum::<f64>() / LEN as f64).sqrt();
            assert!((announced[j] / rms - 1.0).abs() < 0.05, "joint {}: {} {rms}", j + 1, announced[j]);
        }
    }
}

/// For a correct model, the plain fit can be better on left-out data only by chance; a true and a
/// wrong model are distinguished.
#[test]
fn left_out_parts_tell_which_predicts_better() {
    let (robot, arm) = file("kuka-lwr4");
    let truth = param::standard_values(&robot).unwrap();
    let logs = [factors(&arm, &motion(&arm, &truth, 8.0, 1.0, 31))];
    let found = solve(&arm, &logs, &[], &IdentifySettings::default()).unwrap();
    let links = robot.joints.len();
    let drives: Vec<f64> = truth.iter().enumerate().map(|(k, v)| if k < 10 * links { 0.0 } else { *v }).collect();
    let of = |prior: &[PriorBody], weight: f64| {
        let settings = ConsistentSettings { prior_weight: weight, ..ConsistentSettings::default() };
        crate::identify::left_out(&arm, &logs, &found, prior, &drives, &settings, Some(&truth)).unwrap()
    };
    // Little data and known bodies: significantly better than the plain fit.
    let good = of(&prior_bodies(&bodies(&truth, links), &geometric_bodies(&arm.ends())), 1e3);
    assert!(good.better() == crate::identify::Better::Second && good.stretches >= 8, "{good:?}");
    // Bodies of the wrong size with a prior of 3 %.
    let twice: Vec<Option<[f64; 10]>> =
        bodies(&truth, links).into_iter().map(|b| b.map(|b| b.map(|v| 2.0 * v))).collect();
    let bad = of(&prior_bodies(&twice, &geometric_bodies(&arm.ends())), 1e6);
    assert_eq!(bad.better(), crate::identify::Better::First, "{bad:?}");
}
