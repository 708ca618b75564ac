//! Two routes, possible bodies, contradictions.

use dh_codegen::arm::param;
use dh_codegen::robot::Robot;
use nalgebra::{DMatrix, DVector};

use super::newton::Weights;
use super::setup::{Data, Setup, grouping};
use super::*;
use crate::arm::{Reach, States};
use crate::identify::{IdentifySettings, Stack, StackSettings, solve};
use crate::interpreted::Interpreted;
use crate::numeric::random::{Family, Random};
use crate::signal::Motion;

/// A random robot with possible bodies, and its standard parameters.
fn robot(seed: u64, rows: [usize; 2]) -> (Robot, Interpreted, Vec<f64>) {
    let mut random = Random::new(seed);
    let family = Family { rows, tool: 0.0, upright: 1.0, ..Family::default() };
    let mut robot = random.robot(&family);
    for joint in &mut robot.joints {
        // Friction and rotors as bodies: not negative.
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

/// Equations of random states, with noise, over the whole arm.
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
    let beta = grouping(arm) * DVector::from_column_slice(truth);
    let tau = &w * beta
        + DVector::from_fn(n * states, |_, _| noise * (random.even(1.0) + random.even(1.0) + random.even(1.0)));
    // Of the equations their triangular factor, and one row for what no parameters remove.
    let mut all = w.insert_column(b, 0.0);
    all.set_column(b, &tau);
    let r = (all / noise).qr().unpack_r();
    Data { r: r.columns(0, b).into_owned(), z: r.column(b).into_owned() }
}

/// What no base parameters remove.
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
        // So much noise that the plain solution is no body.
        let data = equations(&arm, &truth, 60, 30.0, seed);
        let prior = prior_bodies(&bodies(&truth, robot.joints.len()), &geometric_bodies(&arm.ends()));
        // Without bounds, what no torque shows could grow without end, and the sum of squares have no least value.
        let bounds = Bounds {
            mass: (0..prior.len()).map(|l| (l, [0.3 * prior[l].body[0], 3.0 * prior[l].body[0]])).collect(),
            ..Bounds::default()
        };
        let settings = ConsistentSettings { bounds, ..ConsistentSettings::default() };
        let mut setup = Setup::new(&arm, &data, &prior, &truth, &settings).unwrap();
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
