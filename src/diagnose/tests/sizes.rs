//! Fitted sizes, on torques of the textbook arm with a known addition.

use std::sync::Arc;

use super::columns::{PERIOD, recording};
use super::mechanisms::planar;
use crate::data::signal::Filter;
use crate::diagnose::Recording;
use crate::diagnose::fit::model::{Chosen, Mode, ModelUnderTest, given_friction};
use crate::diagnose::fit::regulariser::STRENGTHS;
use crate::diagnose::hypotheses::hypothesis;
use crate::diagnose::search::candidate::evaluate;
use crate::diagnose::select::excess::excess;
use crate::diagnose::select::measure::Meter;
use crate::diagnose::select::reduction::fix_friction;
use crate::diagnose::windows::windowed_data::WindowedData;
use crate::model::perturbable_robot::PerturbableRobot;
use crate::numerics::prng::Random;
use dh_codegen::robot::EffectKind;
use nalgebra::{DMatrix, DVector};
use std::f64::consts::TAU;

fn tested<'a>(plant: &'a PerturbableRobot, recordings: &'a [Recording], all: bool) -> ModelUnderTest<'a> {
    ModelUnderTest::new(plant, recordings, 1.0 / PERIOD, Mode::Trusted, &[0.0; 2], all)
}

/// The log of an arm as in its file, plus further torques, N m, per joint and used sample, and
/// uniform noise up to `noise`.
fn played(
    plant: &PerturbableRobot,
    mut log: Recording,
    noise: f64,
    adds: &dyn Fn(&WindowedData<'_>) -> Vec<Vec<f64>>,
) -> Recording {
    let mut random = Random::new(17);
    let copy = [log.clone()];
    let scene = tested(plant, &copy, true).scene;
    let (more, given) = (adds(&scene), given_friction(plant));
    let stretch = &mut log.stretches[0];
    let len = stretch.states.len;
    let edge = (len - scene.len) / 2;
    for j in 0..2 {
        let own = &scene.own[j][0];
        for w in 0..scene.len {
            let [fv, fc, _] = given[j].map(|x| x.unwrap_or(0.0));
            let friction = fv * own.v[w] + fc * own.v[w].signum();
            stretch.tau[j * len + edge + w] = scene.rigid[j][w] + friction + more[j][w] + random.uniform(-noise, noise);
        }
    }
    log
}

/// Torques of a spring of joint 1 on both joints, from quasi-static equilibrium.
fn swing(scene: &WindowedData<'_>, shape: &[f64]) -> [Vec<f64>; 2] {
    let terms = hypothesis(EffectKind::JointElasticity).terms(scene, &[0], shape);
    let row = |j: usize| terms[0].column.rows.iter().find(|row| row.0 == j).map(|row| row.1.to_vec());
    [0, 1].map(|j| row(j).unwrap())
}

/// Stiffness, N m/rad, and damping, N m s/rad, of the spring on which the first link oscillates at
/// this frequency, Hz. Outstretched, its inertia is `(L1 + L2)^3 / 3` kg m^2, rods of 1 kg/m.
fn at_frequency(frequency: f64) -> [f64; 2] {
    let (inertia, w) = (0.9_f64.powi(3) / 3.0, TAU * frequency);
    [w * w * inertia, 0.2 * w * inertia]
}

/// The motion of [`recording`] with a ripple of 4 Hz on joint 1, which excites a soft spring.
fn rippled() -> Recording {
    let mut log = recording();
    let w = TAU * 4.0;
    let states = &mut log.stretches[0].states;
    for k in 0..states.len {
        let (s, c) = (w * PERIOD * k as f64).sin_cos();
        states.q[k] += 0.01 * s;
        states.dq[k] += 0.01 * w * c;
        states.ddq[k] -= 0.01 * w * w * s;
    }
    log
}

/// A link that oscillates at 6 Hz is found there.
#[test]
fn a_spring_is_looked_for_at_its_stiffness() {
    let plant = PerturbableRobot::new(&planar());
    let recordings = [rippled()];
    let shape = at_frequency(6.0);
    let residual = swing(&tested(&plant, &recordings, true).scene, &shape).to_vec();
    let scene = tested(&plant, &recordings, false).scene;
    let grid = hypothesis(EffectKind::JointElasticity).grid(&scene, &[0], &residual);
    assert!((grid[0][0] / shape[0] - 1.0).abs() < 0.05, "{grid:?} {shape:?}");
}

/// Above the motion's band a spring is found by its deflection under load, and an oscillating one
/// is not searched.
#[test]
fn a_stiff_spring_is_looked_for_by_its_winding() {
    let plant = PerturbableRobot::new(&planar());
    let mut log = recording();
    log.stretches[0].band.narrow = vec![Filter { cutoff: 4.0, ..Filter::default() }; 2];
    let recordings = [log];
    let [stiffness, damping] = at_frequency(9.0);
    let residual = swing(&tested(&plant, &recordings, true).scene, &[stiffness, 7.0 * damping]).to_vec();
    let scene = tested(&plant, &recordings, false).scene;
    let cause = hypothesis(EffectKind::JointElasticity);
    let grid = cause.grid(&scene, &[0], &residual);
    assert!((grid[0][0] / stiffness - 1.0).abs() < 0.1, "{grid:?} {stiffness}");
    assert!(cause.shows(&scene, &[0], &grid[0]) && !cause.shows(&scene, &[0], &[stiffness, damping]));
}

/// A soft spring that deflects by a tenth of a radian, where the arm is nonlinear. If a log begins
/// in quasi-static equilibrium, the column is the same whether the initial state is estimated or
/// not.
#[test]
fn a_start_at_rest_is_found_at_rest() {
    let plant = PerturbableRobot::new(&planar());
    let recordings = [recording()];
    let shape = at_frequency(2.5);
    let [wanted, _] = swing(&tested(&plant, &recordings, true).scene, &shape);
    let mut scene = tested(&plant, &recordings, false).scene;
    scene.whole.clone_from(&scene.rigid);
    scene.y[0] = Arc::new(scene.rigid[0].iter().zip(&wanted).map(|(r, s)| r + s).collect());
    let [found, _] = swing(&scene, &shape);
    let (mut off, mut all) = (0.0, 0.0);
    for w in (0..scene.len).filter(|w| scene.live[0][*w]) {
        off += (found[w] - wanted[w]).powi(2);
        all += wanted[w].powi(2);
    }
    assert!(off < 4e-8 * all, "{}", (off / all).sqrt());
}

/// The coefficient of a spring is 1 within a twentieth. One of 1.1 is two standard deviations off,
/// at a cost of 4, and one of 1 costs next to nothing.
#[test]
fn a_swing_of_another_size_costs() {
    let plant = PerturbableRobot::new(&planar());
    let shape = at_frequency(15.0);
    for size in [1.0, 1.1] {
        let adds =
            |scene: &WindowedData<'_>| swing(scene, &shape).map(|row| row.iter().map(|x| size * x).collect()).to_vec();
        let recordings = [played(&plant, recording(), 1e-3, &adds)];
        let mut tested = tested(&plant, &recordings, false);
        tested.frozen.fill(true);
        let fitted = tested.fit(&mut []);
        let found = evaluate(&tested, &fitted, hypothesis(EffectKind::JointElasticity), &[0], &shape).unwrap();
        let x = found.gain.x[0];
        assert!((x - size).abs() < 0.05, "{size}: {x}");
        let counts = &fitted.solution.counts;
        let logs = (0..2).map(|j| counts[j] * (fitted.solution.rss[j] / found.gain.rss[j]).ln()).sum::<f64>();
        // Unknowns: size, stiffness, damping and initial state.
        let unknowns = 4.0 * counts.iter().sum::<f64>().ln();
        let cost = logs - unknowns - found.score;
        assert!((cost - (20.0 * (x - 1.0)).powi(2)).abs() < 1e-6, "{size}: {x} {cost}");
    }
}

/// A stiff spring deflects as `1 / K`: its stiffness and the size of its column are one number,
/// which the prior of 1 for the size decides. The noise is half of the spring's torque, so that the
/// initial state is poorly determined.
#[test]
fn a_stiffness_is_that_at_which_the_size_is_one() {
    let plant = PerturbableRobot::new(&planar());
    let shape = at_frequency(15.0);
    let recordings = [played(&plant, recording(), 5e-3, &|scene| swing(scene, &shape).to_vec())];
    for wrong in [0.75, 1.3] {
        let mut tested = tested(&plant, &recordings, false);
        tested.frozen.fill(true);
        let cause = hypothesis(EffectKind::JointElasticity);
        let start = vec![wrong * shape[0], shape[1]];
        let mut chosen = [Chosen { cause, place: vec![0], shape: start, x: vec![1.0] }];
        tested.polish(&mut chosen);
        let [Chosen { shape: found, x, .. }] = chosen;
        assert!((found[0] / shape[0] - 1.0).abs() < 0.08, "{wrong}: {found:?} {shape:?}");
        assert!((x[0] - 1.0).abs() < 0.08, "{wrong}: {x:?}");
    }
}

/// An error of 0.5 with noise of 0.3 leaves 0.4.
#[test]
fn an_excess_is_what_noise_leaves_of_the_square() {
    let plant = PerturbableRobot::new(&planar());
    let recordings = [recording()];
    let model = tested(&plant, &recordings, false);
    let meter = Meter::new(&plant, &recordings, &model);
    let predicted: Vec<Vec<f64>> = meter
        .fine
        .target()
        .iter()
        .map(|y| y.iter().enumerate().map(|(w, y)| if w % 2 == 0 { y - 0.5 } else { y + 0.5 }).collect())
        .collect();
    let measured = meter.errors(predicted, vec![0.0; 2]);
    let found = excess([&measured, &measured], &[0.3, 0.4]);
    // The second joint's error is less than one and a half times its noise.
    assert_eq!(found.iter().map(|s| s.joint).collect::<Vec<_>>(), [0]);
    assert!((found[0].rms - 0.4).abs() < 1e-9, "{}", found[0].rms);
}

/// Viscous friction that is 0.06 N m s/rad more than the file's, 0.08 N m of torque. With noise of
/// 1 N m it stays at the file's value, however significant; with noise of 0.1 N m it does not.
#[test]
fn friction_that_is_small_beside_the_noise_stays_with_the_file() {
    let plant = PerturbableRobot::new(&planar());
    let adds =
        |scene: &WindowedData<'_>| vec![scene.own[0][0].v.iter().map(|v| 0.06 * v).collect(), vec![0.0; scene.len]];
    let recordings = [played(&plant, recording(), 1e-3, &adds)];
    for (noise, stays) in [(1.0, true), (0.1, false)] {
        let mut tested = tested(&plant, &recordings, false);
        let fitted = fix_friction(&mut tested, &mut [], &[noise; 2]);
        assert_eq!(tested.frozen[0], stays, "{noise}");
        let value = fitted.solution.x[fitted.friction];
        assert!((value - if stays { 0.0 } else { 0.06 }).abs() < 1e-3, "{noise}: {value}");
    }
}

/// With an error that lasts `m` windows the data have `1 / m` of the information of independent
/// windows. With `W` that information in the prior's axes, friction is regularised by `s^4 m (W /
/// m)^-3`, since the solver counts every window.
#[test]
fn what_an_error_that_lasts_leaves_open_is_held() {
    let plant = PerturbableRobot::new(&planar());
    let lasting = |scene: &WindowedData<'_>| {
        let (mut random, mut x) = (Random::new(6), 0.0);
        let next = |_| {
            x = 0.7 * x + random.uniform(-0.3, 0.3);
            x
        };
        vec![(0..scene.len).map(next).collect(), vec![0.0; scene.len]]
    };
    let recordings = [played(&plant, recording(), 1e-3, &lasting)];
    let mut tested = tested(&plant, &recordings, false);
    let fitted = tested.fit(&mut []);
    let memory = fitted.memory[0];
    assert!((3.0..9.0).contains(&memory), "{memory}");
    let y = &tested.scene.y[0];
    let torque = (y.iter().map(|y| y * y).sum::<f64>() / y.len() as f64).sqrt();
    let root = DMatrix::from_diagonal(&DVector::from_vec([0.5, 0.5, 0.2].map(|share| share * torque).to_vec()));
    let white = |matrix: &DMatrix<f64>| &root * matrix.view((0, 0), (3, 3)) * &root;
    let every = white(&fitted.moments.information(&fitted.solution.weights));
    let held = white(&tested.regulariser.as_ref().unwrap().precision);
    let strength = (held * every.pow(3) / memory.powi(4)).trace() / 3.0;
    assert!(STRENGTHS.iter().any(|s| (strength / s.powi(4) - 1.0).abs() < 0.3), "{strength} {memory}");
}
