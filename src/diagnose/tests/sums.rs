//! Sums of the diagnosis against independent computations: dense matrices, finite differences, laws
//! written out here.

use nalgebra::{DMatrix, DVector};

use super::columns::{PERIOD, recording};
use super::mechanisms::{bare, planar};
use crate::diagnose::fit::model::{Chosen, Mode, ModelUnderTest};
use crate::diagnose::fit::moments::Moments;
use crate::diagnose::fit::regulariser::{Regulariser, prior};
use crate::diagnose::fit::uncertainty::derivative;
use crate::diagnose::hypotheses::{Term, hypothesis, laws};
use crate::diagnose::search::forward::Evidence;
use crate::diagnose::search::judge::{Accepted, chosen_of};
use crate::diagnose::search::merge_couplings::merge_couplings;
use crate::diagnose::search::merge_levels::merge_levels;
use crate::diagnose::select::measure::{matters, share};
use crate::diagnose::windows::motion_error::budget;
use crate::diagnose::windows::torque_noise::autocorrelation_time;
use crate::diagnose::windows::windowed_data::{Column, WindowedData};
use crate::model::perturbable_robot::PerturbableRobot;
use crate::model::{Arm, PerturbableArm};
use crate::numerics::prng::Random;
use dh_codegen::robot::EffectKind;

fn scene<'a>(plant: &'a PerturbableRobot, recordings: &'a [crate::diagnose::Recording]) -> WindowedData<'a> {
    let mut scene = WindowedData::new(plant, recordings, 1.0 / PERIOD, &[0.0; 2], false);
    let beta = vec![0.4; scene.beta.len()];
    scene.set_model(beta, None);
    scene
}

/// Two columns on joint 1, one on both, and a trial column beside them: coefficients and sums of
/// squares equal those of a dense solution with the same weights.
#[test]
fn a_trial_is_a_refit_of_all() {
    let robot = planar();
    let plant = PerturbableRobot::new(&robot);
    let recordings = [recording()];
    let scene = scene(&plant, &recordings);
    let mut random = Random::new(8);
    let n = scene.len;
    let mut series = |live: &[bool]| -> Vec<f64> {
        live.iter().map(|live| if *live { random.uniform(-1.0, 1.0) } else { 0.0 }).collect()
    };
    let [a, b, c0, c1, t0, t1] = [0, 0, 0, 1, 0, 1].map(|j| series(&scene.live[j]));
    let y = [0, 1].map(|j| series(&scene.live[j])).to_vec();
    let columns = [Column::on(0, a), Column::on(0, b), Column::new(vec![(0, c0), (1, c1)])];
    // Nearly equal to another column, so that the subtracted part matters.
    let near: Vec<f64> = t0.iter().zip(&*columns[0].rows[0].1).map(|(t, a)| 0.3 * t + a).collect();
    let more = Column::new(vec![(0, near), (1, t1)]);
    let moments = Moments::new(&scene, &scene.block, &y, &columns.iter().collect::<Vec<&Column>>());
    let found = moments.solve(None);
    let trial = moments.trial(&[&more]);
    let reduced = moments.reduced(&found, &trial).unwrap();
    let gain = moments.gain_at(&found, &trial, &reduced, reduced.solution());
    let all: Vec<&Column> = columns.iter().chain([&more]).collect();
    let of = |j: usize, column: &Column| column.rows.iter().find(|r| r.0 == j).map(|r| r.1.clone());
    let stacked = |root: &dyn Fn(usize) -> f64| {
        let design = DMatrix::from_fn(2 * n, all.len(), |row, k| {
            of(row / n, all[k]).map_or(0.0, |series| root(row / n) * series[row % n])
        });
        let right = DVector::from_fn(2 * n, |row, _| root(row / n) * y[row / n][row % n]);
        (design, right)
    };
    let (design, right) = stacked(&|j| found.weights[j].sqrt());
    let x = design.svd(true, true).solve(&right, 1e-12).unwrap();
    assert!((gain.x[0] - x[3]).abs() < 1e-9, "{} {}", gain.x[0], x[3]);
    let (design, right) = stacked(&|_| 1.0);
    let left = right - design * x;
    for j in 0..2 {
        let square = left.rows(j * n, n).norm_squared();
        assert!((gain.rss[j] / square - 1.0).abs() < 1e-9, "{j}: {} {square}", gain.rss[j]);
    }
    // A column that the others already contain gains nothing.
    assert!(moments.reduced(&found, &moments.trial(&[&columns[2]])).is_none());
}

#[test]
fn a_share_is_of_what_is_above_the_noise() {
    let noise = [0.6];
    assert!((share(&[1.0], &[0.8], &noise, &[0]) - 0.36 / 0.64).abs() < 1e-12);
    // An increase of the error is a negative share, down to -1.
    assert!((share(&[1.0], &[1.1], &noise, &[0]) + 0.21 / 0.64).abs() < 1e-12);
    assert_eq!(share(&[1.0], &[3.0], &noise, &[0]), -1.0);
    // Of several joints, the one with the largest gain relative to its noise.
    assert!((share(&[1.0, 5.0], &[0.9, 4.9], &[0.1, 3.0], &[]) - 0.19 / 0.99).abs() < 1e-12);
}

#[test]
fn half_of_the_noise_matters() {
    let after = |taken: f64| (1.0 - taken * taken).sqrt();
    for (taken, does) in [(0.21, true), (0.19, false)] {
        assert_eq!(matters(&[1.0], &[after(taken)], &[0.4], &[0.0]), does, "{taken}");
        // Errors of the motion count in full.
        assert_eq!(matters(&[1.0], &[after(taken)], &[0.1], &[0.2]), does, "{taken}");
    }
}

/// The autocorrelation time of a residual does not depend on the share of windows used.
#[test]
fn memory_of_a_residual_with_gaps() {
    let mut random = Random::new(5);
    let mut x = 0.0;
    let series: Vec<f64> = (0..40_000)
        .map(|_| {
            x = 0.8 * x + random.uniform(-1.0, 1.0);
            x
        })
        .collect();
    for used in [0.8, 0.4] {
        let live: Vec<bool> = series.iter().map(|_| random.uniform(0.0, 1.0) < used).collect();
        let seen: Vec<f64> = series.iter().zip(&live).map(|(x, live)| if *live { *x } else { 0.0 }).collect();
        let found = autocorrelation_time(&seen, &live);
        assert!((found / 9.0 - 1.0).abs() < 0.25, "{used}: {found}");
    }
}

/// A clock error causes a torque error of that error times the torque's rate. Tested without
/// friction, whose jumps depend on the order of the difference: at each, the rate of order six has
/// 1.6 times the sum of squares of the one here.
#[test]
fn errors_of_the_clock_go_with_the_rate() {
    let robot = bare(&planar());
    let plant = PerturbableRobot::new(&robot);
    let of = |error: f64| {
        let mut recordings = [recording()];
        recordings[0].stretches[0].clock_error = error;
        let scene = scene(&plant, &recordings);
        let rigid = scene.rigid.clone();
        let central = |x: &[f64]| {
            let squares: Vec<f64> = x.windows(3).map(|w| ((w[2] - w[0]) / (2.0 * PERIOD)).powi(2)).collect();
            (squares.iter().sum::<f64>() / squares.len() as f64).sqrt()
        };
        let rates: Vec<f64> = rigid.iter().map(|x| central(x)).collect();
        (budget(&scene, recordings[0].stretches.iter(), &[0.0; 2]).clock, rates)
    };
    let (none, _) = of(0.0);
    assert_eq!(none, [0.0; 2]);
    let (once, rates) = of(2e-3);
    let (twice, _) = of(4e-3);
    for j in 0..2 {
        // Ends of a run have one-sided differences, and are not in `rates`.
        assert!((once[j] / (2e-3 * rates[j]) - 1.0).abs() < 2e-3, "{once:?} {rates:?}");
        assert!((twice[j] / once[j] - 2.0).abs() < 1e-9, "{once:?} {twice:?}");
    }
}

#[test]
fn a_ramp_has_its_slope() {
    let robot = planar();
    let plant = PerturbableRobot::new(&robot);
    let recordings = [recording()];
    let scene = scene(&plant, &recordings);
    let ramp: Vec<f64> = scene.time.iter().map(|t| 5.0 - 3.0 * t).collect();
    for run in &scene.runs {
        for rate in &scene.rate_of(&ramp)[run.start + 1..run.end - 1] {
            assert!((rate + 3.0).abs() < 1e-9, "{rate}");
        }
    }
}

/// Derivative column of a law by a number of its shape, against the analytic derivative.
#[test]
fn a_column_of_a_number_is_the_derivative_by_it() {
    let robot = planar();
    let plant = PerturbableRobot::new(&robot);
    let recordings = [recording()];
    let mut tested = ModelUnderTest::new(&plant, &recordings, 1.0 / PERIOD, Mode::Trusted, &[0.0; 2], false);
    let speed = 0.6;
    let chosen = Chosen {
        cause: hypothesis(EffectKind::StribeckFriction),
        place: vec![0],
        shape: vec![speed, 2.0],
        x: vec![1.7],
    };
    let mut all = [chosen];
    let fitted = tested.fit(&mut all);
    let [mut chosen] = all;
    chosen.x = vec![1.7];
    let column = derivative(&tested, &fitted, 0, &chosen, 0, -1e-2).unwrap();
    let (_, series) = column.rows.iter().find(|(j, _)| *j == 0).unwrap();
    let mut checked = 0;
    for (w, v) in tested.scene.own[0][0].v.iter().enumerate().filter(|(w, _)| tested.scene.live[0][*w]) {
        // d/ds sign(v) exp(-(v/s)^2) = sign(v) exp(-(v/s)^2) 2 v^2 / s^3.
        let by = 1.7 * v.signum() * (-(v / speed).powi(2)).exp() * 2.0 * v * v / speed.powi(3);
        assert!((series[w] - by).abs() < 1e-5, "{w}: {} {by}", series[w]);
        checked += 1;
    }
    assert!(checked > 800, "{checked}");
}

/// Without data on friction it stays within the prior: half of the joint's torque, a fifth for an
/// offset.
#[test]
fn friction_is_as_uncertain_as_the_torque_is_large() {
    let robot = planar();
    let plant = PerturbableRobot::new(&robot);
    let torque = [8.0, 2.0];
    let prior = prior(&plant, &[], &torque).unwrap();
    let nothing = DMatrix::zeros(6, 6);
    let held = Regulariser::new(&prior, &nothing, &nothing, 10.0).unwrap();
    for (j, torque) in torque.iter().enumerate() {
        for (which, part) in [0.5, 0.5, 0.2].into_iter().enumerate() {
            let k = 3 * j + which;
            let wide = (held.precision[(0, 0)] / held.precision[(k, k)]).sqrt();
            assert!((wide / (part * torque / (0.5 * 8.0)) - 1.0).abs() < 1e-9, "{k}: {wide}");
        }
    }
}

/// Series of a joint in a term of a hypothesis.
fn rows(terms: &[Term], term: usize, joint: usize) -> &[f64] {
    let found = terms[term].column.rows.iter().find(|(j, _)| *j == joint);
    found.map_or(&[], |(_, series)| series)
}

/// A motor that turns with another joint, `w = dq_m + r dq_k`: its inertia and friction act on
/// joint m directly, and on joint k times `r`.
#[test]
fn a_coupled_motor_acts_on_two_joints() {
    let robot = planar();
    let plant = PerturbableRobot::new(&robot);
    let recordings = [recording()];
    let scene = scene(&plant, &recordings);
    let ratio = -0.6;
    let plain = crate::diagnose::hypotheses::hypothesis(EffectKind::GearCoupling);
    let terms = plain.terms(&scene, &[0, 1], &[ratio, 7.0]);
    assert_eq!(terms.len(), 3);
    let (m, k) = (&scene.own[0][0], &scene.own[1][0]);
    let mut checked = 0;
    for w in 0..scene.len {
        let speed = m.v[w] + ratio * k.v[w];
        // The motor's own inertia about its own joint is a parameter of the file.
        let on_m = [ratio * k.a[w], ratio * k.v[w], speed.signum()];
        let on_k = [ratio * m.a[w], ratio * m.v[w], ratio * speed.signum()];
        for (joint, wanted) in [(0, on_m), (1, on_k)] {
            if !scene.live[joint][w] || speed.abs() < 0.05 {
                continue;
            }
            for (term, wanted) in wanted.into_iter().enumerate() {
                let value = rows(&terms, term, joint)[w];
                assert!((value - wanted).abs() < 1e-9 * (1.0 + wanted.abs()), "{term} {joint} {w}: {value} {wanted}");
            }
            checked += 1;
        }
    }
    assert!(checked > 1000, "{checked}");
}

/// Inertia found from one joint and friction from the other belong to one motor; one that turns the
/// other way is another.
#[test]
fn couplings_of_both_joints_are_one_motor() {
    let robot = planar();
    let plant = PerturbableRobot::new(&robot);
    let recordings = [recording()];
    let cause = crate::diagnose::hypotheses::hypothesis(EffectKind::GearCoupling);
    let coupling = |place: [usize; 2], ratio: f64, parts: f64| {
        let chosen = Chosen { cause, place: place.to_vec(), shape: vec![ratio, parts], x: Vec::new() };
        Accepted::of(chosen)
    };
    for (ratio, shapes) in [(1.0, vec![vec![1.0, 5.0]]), (-1.0, vec![vec![1.0, 1.0], vec![-1.0, 4.0]])] {
        let mut tested = ModelUnderTest::new(&plant, &recordings, 100.0, Mode::Trusted, &[0.0; 2], false);
        let mut accepted = vec![coupling([1, 0], 1.0, 1.0), coupling([0, 1], ratio, 4.0)];
        let mut fitted = tested.fit(&mut chosen_of(&accepted));
        let before = fitted.residual.clone();
        merge_couplings(&mut tested, &mut accepted, &mut fitted);
        assert_eq!(accepted.iter().map(|a| a.chosen.shape.clone()).collect::<Vec<_>>(), shapes);
        assert_eq!(accepted[0].chosen.place, [1, 0]);
        let pairs = before.iter().flatten().zip(fitted.residual.iter().flatten());
        assert!(pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) < 1e-9);
    }
}

/// An offset found before a linear spring is the spring's rest position; one found beside a law with a
/// rest position of its own is not.
#[test]
fn an_offset_is_the_rest_position_of_a_spring() {
    let robot = planar();
    let plant = PerturbableRobot::new(&robot);
    let recordings = [recording()];
    let of = |effect, share| Evidence { effect, place: vec![0], shape: Vec::new(), local: false, share };
    for (shape, left) in [(Vec::new(), vec![(EffectKind::JointSpring, 0.9)]), (vec![0.2, 0.0], Vec::new())] {
        let mut tested = ModelUnderTest::new(&plant, &recordings, 100.0, Mode::Trusted, &[0.0; 2], false);
        tested.separate[2] = true;
        let cause = laws(EffectKind::JointSpring).find(|c| c.shape().len() == shape.len()).unwrap();
        let chosen = Chosen { cause, place: vec![0], shape, x: Vec::new() };
        let accepted = [Accepted::of(chosen)];
        let fitted = tested.fit(&mut chosen_of(&accepted));
        let found = || vec![of(EffectKind::TorqueOffset, 0.8), of(EffectKind::JointSpring, 0.5)];
        let mut evidence = found();
        merge_levels(&mut tested, &accepted, &fitted, &mut evidence);
        let same =
            |(e, known): (&Evidence, &(EffectKind, f64))| e.effect == known.0 && (e.share - known.1).abs() < 1e-12;
        match left.is_empty() {
            true => assert!(evidence == found() && tested.separate[2]),
            false => assert!(evidence.len() == 1 && evidence.iter().zip(&left).all(same) && !tested.separate[2]),
        }
    }
}

/// Two ripples of nearly one order, whose sizes cancel, are one to the data.
#[test]
fn two_orders_are_resolved_by_the_travel() {
    let robot = planar();
    let plant = PerturbableRobot::new(&robot);
    let recordings = [recording()];
    let tested = ModelUnderTest::new(&plant, &recordings, 100.0, Mode::Trusted, &[0.0; 2], false);
    // Joint 1 travels 1.6 rad.
    let ripple = |j: usize, order: f64| {
        let cause = hypothesis(EffectKind::TorqueRipple);
        Chosen { cause, place: vec![j], shape: vec![order], x: Vec::new() }
    };
    for (a, b, one) in [(7.0, 7.1, true), (7.0, 7.5, true), (7.0, 7.8, false), (7.0, 7.0, true)] {
        assert_eq!(tested.unresolved(&[ripple(0, a), ripple(0, b)]), one, "{a} {b}");
    }
    assert!(!tested.unresolved(&[ripple(0, 7.0), ripple(1, 7.0)]));
}

/// Steps of both signs, up to the largest plausible offset.
#[test]
fn a_zero_is_looked_for_to_both_sides() {
    let robot = planar();
    let plant = PerturbableRobot::new(&robot);
    let recordings = [recording()];
    let scene = scene(&plant, &recordings);
    let steps: Vec<f64> =
        hypothesis(EffectKind::EncoderOffset).grid(&scene, &[0], &[]).into_iter().map(|s| s[0]).collect();
    assert!(steps.iter().any(|s| *s <= -0.3) && steps.iter().any(|s| *s >= 0.3), "{steps:?}");
    assert!(steps.iter().any(|s| s.abs() < 0.01), "{steps:?}");
}

/// The link rests half of the gap to the side towards which its torque pushes it. Where that side
/// stays the same, the column is minus or plus half of that of a shifted link.
#[test]
fn a_gap_is_taken_by_half_to_either_side() {
    let robot = planar();
    let plant = PerturbableRobot::new(&robot);
    let recordings = [recording()];
    let mut scene = scene(&plant, &recordings);
    let standard = plant.given().map(<[f64]>::to_vec);
    if let Some(given) = &standard {
        let base: Vec<f64> =
            plant.base_parameters().iter().map(|b| b.coefficients.iter().map(|(i, k)| k * given[*i]).sum()).collect();
        scene.set_model(base, None);
    }
    let terms = hypothesis(EffectKind::Backlash).terms(&scene, &[0], &[1e-4, 0.02, 5.0]);
    let column = rows(&terms, 0, 0);
    let shifted = scene.shifted(0, &vec![1.0; scene.len], 1e-4);
    let load = &scene.rigid[0];
    let most = load.iter().fold(0.0_f64, |m, t| m.max(t.abs()));
    // On one side for so long that the low-pass has settled.
    const SETTLED: usize = 60;
    let mut checked = 0;
    for w in SETTLED..scene.len - SETTLED {
        let side = load[w].signum();
        let steady = (w - SETTLED..=w + SETTLED).all(|k| load[k] * side > 0.2 * most);
        let wanted = -0.5 * side * shifted[0][w];
        if steady && scene.live[0][w] && wanted.abs() > 0.1 {
            assert!((column[w] / wanted - 1.0).abs() < 0.1, "{w}: {} {wanted}", column[w]);
            checked += 1;
        }
    }
    assert!(checked > 20, "{checked}");
}
