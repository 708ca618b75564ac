//! Decisions of the search and the selection on synthetic torques with known causes: noise, an
//! effect in some stretches, one that holds throughout.

use nalgebra::DMatrix;

use super::columns::{PERIOD, recording};
use super::mechanisms::{Bodies, bare, planar};
use crate::diagnose::Recording;
use crate::diagnose::findings::reported_cause::{Item, items};
use crate::diagnose::fit::model::{Chosen, Mode, ModelUnderTest};
use crate::diagnose::fit::moments::Gain;
use crate::diagnose::fit::regulariser::Regulariser;
use crate::diagnose::fit::uncertainty::Uncertainty;
use crate::diagnose::hypotheses::{Estimate, Hypothesis, causes, hypothesis};
use crate::diagnose::search::SearchSettings;
use crate::diagnose::search::alone::{is_alone, is_an_error_of_a_push};
use crate::diagnose::search::baseline_friction::is_better;
use crate::diagnose::search::candidate::{Candidate, evaluate};
use crate::diagnose::search::driving_friction::friction_drives;
use crate::diagnose::search::forward::Evidence;
use crate::diagnose::search::judge::{Accepted, Judge, bearable, confirmation};
use crate::diagnose::search::levels_instead::levels_instead;
use crate::diagnose::search::shorter_push::shorter_push;
use crate::diagnose::search::support::{gained, shows_on_other_joints, support_beside_all};
use crate::diagnose::select::beside::share_within;
use crate::diagnose::select::beside_other_links::worth;
use crate::diagnose::select::measure::{Meter, leave_out, share};
use crate::diagnose::windows::recording::Stretch;
use crate::diagnose::windows::windowed_data::WindowedData;
use crate::model::perturbable_robot::PerturbableRobot;
use crate::numerics::prng::Random;
use dh_codegen::robot::EffectKind;

/// The planar arm's torques on the synthetic motion, with noise and an addition per joint and
/// sample.
pub(super) fn made(noise: [f64; 2], seed: u64, more: &dyn Fn(usize, usize) -> f64) -> [Recording; 1] {
    let robot = planar();
    let bodies = Bodies::of(&bare(&robot));
    let mut random = Random::new(seed);
    let mut recordings = [recording()];
    let stretch = &mut recordings[0].stretches[0];
    let len = stretch.states.len;
    for k in 0..len {
        let of = |x: &[f64]| [x[k], x[len + k]];
        let state = [of(&stretch.states.q), of(&stretch.states.dq), of(&stretch.states.ddq)];
        let rigid = bodies.torques(&state);
        for j in 0..2 {
            let drive = &robot.joints[j].drive;
            let (viscous, dry) = (drive.viscous_friction.unwrap(), drive.coulomb_friction.unwrap());
            let v = state[1][j];
            let gauss = (0..12).map(|_| random.uniform(0.0, 1.0)).sum::<f64>() - 6.0;
            stretch.tau[j * len + k] = rigid[j] + viscous * v + dry * v.signum() + noise[j] * gauss + more(j, k);
        }
    }
    stretch.torque_noise = noise.to_vec();
    recordings
}

fn tested<'a>(plant: &'a PerturbableRobot, recordings: &'a [Recording]) -> ModelUnderTest<'a> {
    ModelUnderTest::new(plant, recordings, 1.0 / PERIOD, Mode::Trusted, &[0.0; 2], false)
}

fn chosen(effect: EffectKind, place: &[usize], shape: &[f64]) -> Chosen {
    Chosen { cause: hypothesis(effect), place: place.to_vec(), shape: shape.to_vec(), x: Vec::new() }
}

/// Index of the sample of each window.
fn samples(scene: &WindowedData<'_>) -> Vec<usize> {
    scene.time.iter().map(|t| (t / PERIOD).round() as usize).collect()
}

/// Order of a ripple that is nearly white from sample to sample.
const ORDER: f64 = 200.0;

fn ripple(k: usize) -> f64 {
    let stretch = &recording().stretches[0];
    0.3 * (ORDER * stretch.states.q[k]).cos()
}

/// An effect that holds in each stretch is a cause. One that changes its sign in one of the parts
/// is rejected, though it takes nearly half of the error.
#[test]
fn a_cause_holds_in_most_stretches() {
    let robot = planar();
    let plant = PerturbableRobot::new(&robot);
    let noise = [0.05; 2];
    let quiet = made(noise, 1, &|_, _| 0.0);
    let scene = WindowedData::new(&plant, &quiet, 1.0 / PERIOD, &[0.0; 2], false);
    let mut block = vec![0; quiet[0].stretches[0].states.len];
    samples(&scene).into_iter().zip(&scene.block).for_each(|(k, b)| block[k] = *b);
    for (sign, holds) in [(1.0, true), (-1.0, false)] {
        let at = |j: usize, k: usize| if j == 0 { ripple(k) * if block[k] == 2 { sign } else { 1.0 } } else { 0.0 };
        let recordings = made(noise, 1, &at);
        let mut tested = tested(&plant, &recordings);
        let before = tested.fit(&mut []);
        let mut trial = [chosen(EffectKind::TorqueRipple, &[0], &[ORDER])];
        let after = tested.fit(&mut trial);
        let settings = SearchSettings::default();
        let judge = Judge { tested: &tested, noise: &noise, settings: &settings, accepted: &[], tried: 1 };
        assert!(judge.matters(trial[0].cause, &before, &after));
        assert_eq!(judge.judge(&before, &after, &trial).is_some(), holds, "{sign}");
    }
}

/// A force of 0.6 s is supported in its part alone beside noise and beside another push, but not
/// beside an error that recurs throughout.
#[test]
fn a_push_stands_out_from_the_rest_of_the_log() {
    let robot = planar();
    let plant = PerturbableRobot::new(&robot);
    let push = |k: usize, from: usize| if (from..from + 120).contains(&k) { 0.5 } else { 0.0 };
    let slow = |k: usize| 0.5 * (k as f64 / 40.0).sin();
    type Error<'a> = &'a dyn Fn(usize) -> f64;
    let errors: [(Error<'_>, bool); 3] =
        [(&|k| push(k, 500), true), (&|k| push(k, 500) + push(k, 900), true), (&|k| push(k, 500) + slow(k), false)];
    for (case, (error, alone)) in errors.into_iter().enumerate() {
        let recordings = made([0.05; 2], 5, &|j, k| if j == 0 { error(k) } else { 0.0 });
        let mut tested = tested(&plant, &recordings);
        let before = tested.fit(&mut []);
        let samples = samples(&tested.scene);
        let step = tested.scene.step;
        let at = |k: usize| samples.iter().position(|s| *s >= k).unwrap() as f64 * step;
        let mut trial = [chosen(EffectKind::ExternalContact, &[], &[at(500), at(620), 1.0, 1.0, 0.0])];
        tested.fit(&mut trial);
        assert_eq!(is_alone(&tested, &before, &trial[0]), alone, "{case}");
        let most = chosen(EffectKind::ExternalContact, &[], &[at(60), at(1100), 1.0, 1.0, 0.0]);
        assert!(!is_alone(&tested, &before, &most));
    }
}

/// A moment on the tool shows on both joints. An error of one joint, which the push absorbs as well,
/// does not.
#[test]
fn a_push_shows_on_more_than_one_joint() {
    let robot = planar();
    let plant = PerturbableRobot::new(&robot);
    let shown = |other: f64| {
        let error = |j: usize, k: usize| if (500..620).contains(&k) { [0.5, other][j] } else { 0.0 };
        let recordings = made([0.05; 2], 5, &error);
        let mut tested = tested(&plant, &recordings);
        let before = tested.fit(&mut []);
        let samples = samples(&tested.scene);
        let step = tested.scene.step;
        let at = |k: usize| samples.iter().position(|s| *s >= k).unwrap() as f64 * step;
        let mut trial = [chosen(EffectKind::ExternalContact, &[], &[at(500), at(620), 1.0, 1.0, 0.0])];
        let after = tested.fit(&mut trial);
        assert!(gained(&tested, &trial[0], 1, [&before, &after]) > 50.0);
        shows_on_other_joints(&tested, &trial[0], [&before, &after])
    };
    assert!(shown(0.5) && !shown(0.0));
}

/// A second push during the first is an error of its course, unless the first is far longer.
#[test]
fn a_push_during_another_is_none() {
    let robot = planar();
    let plant = PerturbableRobot::new(&robot);
    let recordings = made([0.05; 2], 5, &|_, _| 0.0);
    let tested = tested(&plant, &recordings);
    let push = |start: f64, end: f64| chosen(EffectKind::ExternalContact, &[], &[start, end, 1.0, 0.0, 0.0]);
    let error = |one: [f64; 2], other: [f64; 2]| {
        is_an_error_of_a_push(&tested.scene, &push(one[0], one[1]), [&push(other[0], other[1])])
    };
    assert!(error([1.2, 1.6], [1.0, 2.0]) && error([1.7, 2.1], [1.0, 2.0]));
    assert!(!error([1.9, 2.4], [1.0, 2.0]) && !error([2.5, 3.0], [1.0, 2.0]));
    assert!(!error([1.2, 1.6], [1.0, 3.0]));
}

/// A push that was accepted with little support, beside a cause that has left the model, has the
/// support that it has beside the others; one of a log without it has none.
#[test]
fn the_support_of_a_push_is_that_beside_all_others() {
    let robot = planar();
    let plant = PerturbableRobot::new(&robot);
    let of = |force: f64| {
        let push = |j: usize, k: usize| if j == 0 && (500..620).contains(&k) { force } else { 0.0 };
        let recordings = made([0.05; 2], 5, &push);
        let mut tested = tested(&plant, &recordings);
        let samples = samples(&tested.scene);
        let step = tested.scene.step;
        let at = |k: usize| samples.iter().position(|s| *s >= k).unwrap() as f64 * step;
        let push = chosen(EffectKind::ExternalContact, &[], &[at(500), at(620), 1.0, 1.0, 0.0]);
        let mut accepted = [Accepted::of(chosen(EffectKind::TorqueOffset, &[1], &[])), Accepted::of(push)];
        assert!(support_beside_all(&mut tested, &mut accepted).is_some());
        // What acts throughout keeps the support with which it was found.
        assert_eq!(accepted[0].support, 1.0);
        assert!(support_beside_all(&mut tested, &mut accepted[..1]).is_none());
        accepted[1].support
    };
    assert!(of(0.5) > 50.0 && of(0.0) < 0.0, "{} {}", of(0.5), of(0.0));
}

/// Noise gives each unknown some gain, and a cause of ten unknowns ten times as much: it must pay
/// for them.
#[test]
fn noise_is_no_cause_whatever_the_number_of_unknowns() {
    let robot = planar();
    let plant = PerturbableRobot::new(&robot);
    let noise = [0.05, 0.03];
    let settings = SearchSettings::default();
    for seed in 1..=8 {
        let recordings = made(noise, seed, &|_, _| 0.0);
        let mut tested = tested(&plant, &recordings);
        let before = tested.fit(&mut []);
        let found = evaluate(&tested, &before, hypothesis(EffectKind::TorqueRipple), &[0], &[ORDER]).unwrap();
        assert!(found.score < 0.0, "{seed}: {}", found.score);
        let mut trial = [chosen(EffectKind::Payload, &[], &[])];
        let after = tested.fit(&mut trial);
        let judge = Judge { tested: &tested, noise: &noise, settings: &settings, accepted: &[], tried: 1 };
        let unknowns = trial[0].x.len() as f64;
        assert!(unknowns >= 4.0, "{unknowns}");
        assert_eq!(judge.support(&before, &after, &trial, unknowns), None, "{seed}");
    }
    let recordings = made(noise, 1, &|j, k| if j == 0 { ripple(k) } else { 0.0 });
    let mut tested = tested(&plant, &recordings);
    let before = tested.fit(&mut []);
    let found = evaluate(&tested, &before, hypothesis(EffectKind::TorqueRipple), &[0], &[ORDER]).unwrap();
    assert!(found.score > 1000.0 && (found.gain.x[0] - 0.3).abs() < 0.01, "{} {:?}", found.score, found.gain.x);
}

/// A body that is visible on the quiet joint in each stretch; the other joint's noise is a thousand
/// times as large and carries no information.
#[test]
fn stretches_count_by_the_noise_of_their_joints() {
    let robot = planar();
    let plant = PerturbableRobot::new(&robot);
    let noise = [10.0, 0.01];
    let quiet = made([0.0; 2], 1, &|_, _| 0.0);
    let scene = tested(&plant, &quiet);
    let terms = scene.family(hypothesis(EffectKind::Payload), &[], &[]);
    let both = terms.iter().find(|t| t.column.rows.len() == 2).unwrap();
    let mut body = vec![[0.0; 2]; quiet[0].stretches[0].states.len];
    for (j, series) in &both.column.rows {
        samples(&scene.scene).into_iter().zip(&**series).for_each(|(k, torque)| body[k][*j] = 0.01 * torque);
    }
    for seed in 1..=4 {
        let recordings = made(noise, seed, &|j, k| body[k][j]);
        let mut tested = tested(&plant, &recordings);
        let before = tested.fit(&mut []);
        let after = tested.fit(&mut [chosen(EffectKind::Payload, &[], &[])]);
        let found = confirmation(&before, &after, &[false; 2]).confirmed;
        assert!(found > 0.95, "{seed}: {found}");
    }
}

/// The more a cause explains of one joint, the more it may make another worse; a body by half of
/// that.
#[test]
fn what_is_borne_on_other_joints() {
    let ripple = hypothesis(EffectKind::TorqueRipple);
    for (predicted, most) in [(0.2, 0.1), (0.6, 0.1), (0.75, 0.3), (0.9, 0.5), (1.0, 0.5)] {
        assert!((bearable(ripple, predicted) - most).abs() < 1e-9, "{predicted}");
    }
    let body = hypothesis(EffectKind::Payload);
    for (predicted, most) in [(0.5, 0.25), (0.75, 0.375), (0.9, 0.5)] {
        assert!((bearable(body, predicted) - most).abs() < 1e-9, "{predicted}");
    }
}

/// Scores count windows; as many as the residual's autocorrelation time count as one.
#[test]
fn a_score_within_the_memory_is_no_better() {
    let of = |x: usize, score: f64| {
        let Chosen { cause, place, shape, .. } = chosen(EffectKind::TorqueRipple, &[0], &[ORDER]);
        Candidate { cause, place, shape, gain: Gain { x: vec![0.1; x], rss: vec![1.0; 2] }, score }
    };
    for memory in [1.0, 20.0] {
        // It replaces nothing.
        assert!(!is_better(&of(2, 100.0 + memory), 100.0, 0, memory));
        assert!(is_better(&of(2, 100.0 + 10.0 * memory), 100.0, 0, memory));
        // As many unknowns as in what it replaces: a larger margin is needed.
        assert!(!is_better(&of(2, 100.0 + 8.0 * memory), 100.0, 2, memory));
        assert!(is_better(&of(2, 100.0 + 20.0 * memory), 100.0, 2, memory));
    }
}

#[test]
fn a_share_within_a_span_is_of_that_span() {
    let robot = planar();
    let plant = PerturbableRobot::new(&robot);
    let recordings = made([0.05; 2], 1, &|_, _| 0.0);
    let tested = tested(&plant, &recordings);
    let meter = Meter::new(&plant, &recordings, &tested);
    let span = 100..200;
    let of = |inside: f64| {
        let target = meter.fine.target();
        let missed = target.iter().enumerate().map(|(j, y)| {
            let wrong = |(k, y): (usize, &f64)| y - if j == 0 && span.contains(&k) { inside } else { 0.2 };
            y.iter().enumerate().map(wrong).collect()
        });
        meter.errors(missed.collect(), vec![0.0; 2])
    };
    let noise = [0.2; 2];
    for (without, with, share) in [(2.0, 1.0, 0.75), (0.2, 0.1, 0.75), (0.2, 0.19, 0.0), (1.0, 2.0, 0.0)] {
        let found = share_within(span.clone(), [&of(without), &of(with)], &noise);
        assert!((found - share).abs() < 1e-9, "{without} {with}: {found}");
    }
}

/// Dry friction found beyond the file's holds a joint at rest: on a log at rest the torque may be
/// any up to that level.
#[test]
fn friction_that_was_found_holds_a_joint_at_rest() {
    let plant = PerturbableRobot::new(&planar());
    let recordings = made([0.05; 2], 4, &|j, k| {
        let v = recording().stretches[0].states.dq[k];
        if j == 0 { 0.6 * v.signum() } else { 0.0 }
    });
    let mut tested = tested(&plant, &recordings);
    let fitted = tested.fit(&mut []);
    let level = planar().joints[0].drive.coulomb_friction.unwrap();
    let mut still = recordings.clone();
    let Stretch { states, tau, .. } = &mut still[0].stretches[0];
    let (dq, ddq) = (vec![0.0; states.dq.len()], vec![0.0; states.ddq.len()]);
    (states.q, states.dq, states.ddq) = ([vec![0.3; dq.len() / 2], vec![-0.2; dq.len() / 2]].concat(), dq, ddq);
    let held = Bodies::of(&bare(&planar())).torques(&[[0.3, -0.2], [0.0; 2], [0.0; 2]]);
    let len = states.len;
    tau[..len].fill(held[0] + level + 0.4);
    tau[len..].fill(held[1]);
    let mut meter = Meter::new(&plant, &still, &tested);
    let file = meter.of_the_file().steady[0];
    let model = meter.of(&tested, &fitted, &[], true).steady[0];
    assert!((file - 0.4).abs() < 1e-6 && model < 1e-3, "{file} {model}");
}

/// A size within two and a half standard deviations is insignificant, whatever the search found. So
/// is an equally uncertain stiffness.
#[test]
fn what_does_not_exceed_its_uncertainty_is_nothing() {
    let robot = planar();
    let plant = PerturbableRobot::new(&robot);
    let recordings = made([0.05; 2], 3, &|_, _| 0.0);
    let mut tested = tested(&plant, &recordings);
    let mut all = [chosen(EffectKind::StribeckFriction, &[0], &[3.0, 2.0])];
    let fitted = tested.fit(&mut all);
    let at = fitted.first[0];
    let known = fitted.covariance()[(at, at)].sqrt();
    let mut of = |size: f64| {
        all[0].x = vec![size * known];
        Uncertainty::of(&tested, &fitted, &all).exceeds_zero(&tested, &fitted, 0, &all[0])
    };
    assert!(of(2.0) < 0.0 && of(-2.0) < 0.0 && of(3.0) > 0.0);
    all[0].x.clear();
    let gone = Uncertainty::of(&tested, &fitted, &all).exceeds_zero(&tested, &fitted, 0, &all[0]);
    assert_eq!(gone, f64::NEG_INFINITY);
    let mut spring = [chosen(EffectKind::JointElasticity, &[0], &[300.0, 2.0])];
    let fitted = tested.fit(&mut spring);
    let uncertainty = Uncertainty::of(&tested, &fitted, &spring);
    assert!(uncertainty.exceeds_zero(&tested, &fitted, 0, &spring[0]) < 0.0, "a rigid arm has no spring");
}

/// Friction that would drive the joint ends at zero; an offset may have either sign.
#[test]
fn friction_does_not_drive() {
    let robot = planar();
    let plant = PerturbableRobot::new(&robot);
    let velocity = |k: usize| recording().stretches[0].states.dq[k];
    let recordings = made([0.01; 2], 2, &|j, k| if j == 0 { -0.4 * velocity(k) - 0.5 } else { -0.5 });
    let mut tested = tested(&plant, &recordings);
    let fitted = tested.fit(&mut []);
    let of = |x: &nalgebra::DVector<f64>| [0, 2, 5].map(|k| x[fitted.friction + k]);
    let free = of(&fitted.solution.x);
    assert!((free[0] + 0.4).abs() < 0.01, "{free:?}");
    let moved = tested.possible(&mut [], &fitted).unwrap();
    let [viscous, offset, other] = of(&moved.solution.x);
    // The file's level is 0.1.
    assert!((viscous + 0.1).abs() < 1e-4, "{viscous}");
    assert!((offset + 0.5).abs() < 0.1 && (other + 0.5).abs() < 0.01, "{offset} {other}");
}

/// The size of a spring is in its shape: a stiffness whose column must be scaled to fit is wrong.
#[test]
fn a_spring_is_as_stiff_as_its_column_is_large() {
    let robot = planar();
    let plant = PerturbableRobot::new(&robot);
    let truth = [300.0, 2.0];
    let quiet = made([0.0; 2], 1, &|_, _| 0.0);
    let mut body = vec![[0.0; 2]; quiet[0].stretches[0].states.len];
    {
        let scene = tested(&plant, &quiet);
        let terms = scene.family(hypothesis(EffectKind::JointElasticity), &[0], &truth);
        for (j, series) in &terms[0].column.rows {
            samples(&scene.scene).into_iter().zip(&**series).for_each(|(k, torque)| body[k][*j] = *torque);
        }
    }
    let recordings = made([2e-3; 2], 1, &|j, k| body[k][j]);
    let mut tested = tested(&plant, &recordings);
    let before = tested.fit(&mut []);
    let score = |by: f64| {
        let shape = [by * truth[0], truth[1]];
        evaluate(&tested, &before, hypothesis(EffectKind::JointElasticity), &[0], &shape).unwrap().score
    };
    let right = score(1.0);
    assert!([0.5, 0.7, 1.4, 2.0].into_iter().all(|by| score(by) < right), "{right}");
    let mut all = [chosen(EffectKind::JointElasticity, &[0], &[1.3 * truth[0], truth[1]])];
    tested.polish(&mut all);
    assert!((all[0].shape[0] / truth[0] - 1.0).abs() < 0.03, "{:?}", all[0].shape);
}

/// Two orders of ripple are strongly correlated where a joint makes little of a turn: refined
/// alone, each stops where the other is wrong.
#[test]
fn numbers_of_two_laws_are_refined_together() {
    let robot = planar();
    let plant = PerturbableRobot::new(&robot);
    let q = recording().stretches[0].states.q.clone();
    let recordings =
        made([0.02; 2], 3, &|j, k| if j == 0 { 0.5 * (6.0 * q[k]).cos() + 0.4 * (12.0 * q[k]).sin() } else { 0.0 });
    let mut tested = tested(&plant, &recordings);
    let mut all = [6.25, 12.4].map(|order| chosen(EffectKind::TorqueRipple, &[0], &[order]));
    tested.polish(&mut all);
    let found = all.map(|c| c.shape[0]);
    assert!((found[0] - 6.0).abs() < 0.05 && (found[1] - 12.0).abs() < 0.05, "{found:?}");
}

/// A power of the speed approximates both levels; more friction in one direction consists of the
/// levels.
#[test]
fn levels_are_the_friction_beside_a_difference_by_direction() {
    let robot = planar();
    let plant = PerturbableRobot::new(&robot);
    let v = recording().stretches[0].states.dq.clone();
    let of = |power: bool| {
        let more = |j: usize, k: usize| match (j, power) {
            (0, false) if v[k] > 0.0 => 1.0 + 0.8 * v[k],
            (0, true) => 0.9 * v[k].signum() * v[k].abs().sqrt() + 0.5 * v[k].abs() + 0.5,
            _ => 0.0,
        };
        let recordings = made([0.02; 2], 5, &more);
        let mut tested = tested(&plant, &recordings);
        tested.frozen.fill(true);
        tested.regulariser = Some(Regulariser::none());
        let difference = chosen(EffectKind::AsymmetricFriction, &[0], &[]);
        let mut all = [difference, chosen(EffectKind::NonlinearViscousFriction, &[0], &[0.5, 0.0])];
        let fitted = tested.fit(&mut all);
        let mut accepted: Vec<Accepted> = all.into_iter().map(Accepted::of).collect();
        let evidence = |effect| Evidence { effect, place: vec![0], shape: Vec::new(), local: false, share: 0.5 };
        let mut known = [EffectKind::AsymmetricFriction, EffectKind::NonlinearViscousFriction].map(evidence).to_vec();
        levels_instead(&mut tested, &mut accepted, fitted, &mut known);
        (accepted.len(), tested.frozen[..2].to_vec(), known.iter().map(|e| e.share).collect::<Vec<f64>>())
    };
    assert_eq!(of(false), (1, vec![false; 2], vec![0.75]));
    assert_eq!(of(true), (2, vec![true; 2], vec![0.5; 2]));
}

/// A law of friction by position has no part in what the plain levels explain that changed with it.
#[test]
fn a_law_is_measured_beside_its_levels() {
    let robot = planar();
    let plant = PerturbableRobot::new(&robot);
    let Stretch { states, .. } = recording().stretches.remove(0);
    let (q, v) = (&states.q, &states.dq);
    let of = |law: f64| {
        let more = |j: usize, k: usize| match j {
            0 => (1.0 + law * (2.0 * q[k]).cos()) * v[k].signum() + 0.5 * v[k],
            _ => 0.0,
        };
        let recordings = made([0.05; 2], 6, &more);
        let mut tested = tested(&plant, &recordings);
        let all = [chosen(EffectKind::PositionDependentFriction, &[0], &[2.0])];
        let mut trial = all.clone();
        let fitted = tested.fit(&mut trial);
        let mut meter = Meter::new(&plant, &recordings, &tested);
        let with = meter.of(&tested, &fitted, &trial, false).steady;
        let item = Item { hypothesis: all[0].cause, place: vec![0], accepted: Some(0), friction: vec![0, 1] };
        [Some(&item), item.law_alone().as_ref()].map(|item| {
            let without = leave_out(&plant, &recordings, &mut meter, &mut tested, &trial, item.unwrap(), false);
            share(&without.steady, &with, &[0.05; 2], &[0])
        })
    };
    let [whole, alone] = of(0.02);
    assert!(whole > 0.9 && alone < 0.2, "{whole} {alone}");
    let [whole, alone] = of(0.6);
    assert!(whole > 0.9 && alone > 0.8, "{whole} {alone}");
}

/// A level and an offset are levels that differ by direction, unless they differ by too much to be
/// friction of one gear.
#[test]
fn friction_of_one_direction_is_at_most_five_times_the_other() {
    let robot = planar();
    let plant = PerturbableRobot::new(&robot);
    let dry = robot.joints[0].drive.coulomb_friction.unwrap();
    let of = |ratio: f64| {
        let more = |j: usize, k: usize| match j {
            0 => (1.0 - dry) * recording().stretches[0].states.dq[k].signum() + ratio,
            _ => 0.0,
        };
        let recordings = made([0.02; 2], 7, &more);
        let mut tested = tested(&plant, &recordings);
        let fitted = tested.fit(&mut []);
        let here = items(&tested, &[], &fitted).into_iter().filter(|i| i.place == [0] && i.friction != [0]);
        here.map(|i| i.hypothesis.name()).collect::<Vec<_>>()
    };
    assert_eq!(of(0.6), ["asymmetric_friction"]);
    assert_eq!(of(0.75), ["coulomb_friction", "torque_offset"]);
}

/// Changes beyond the file's values are reported as totals, under the names of the file.
#[test]
fn names_of_the_file_are_of_the_whole() {
    let robot = planar();
    let plant = PerturbableRobot::new(&robot);
    let recordings = made([0.05; 2], 1, &|_, _| 0.0);
    let scene = WindowedData::new(&plant, &recordings, 1.0 / PERIOD, &[0.004, 0.0], false);
    let named = |effect: EffectKind, shape: &[f64], x: f64| {
        let cause: &dyn Hypothesis = hypothesis(effect);
        let shape_std = shape.iter().map(|_| None).collect();
        let covariance = DMatrix::identity(4, 4) * 1e-4;
        let found = Estimate {
            scene: &scene,
            place: &[0],
            shape,
            shape_std,
            terms: &[],
            x: &[x],
            levels: [0.2, 0.5, 0.1],
            covariance,
        };
        let all = cause.named(&found);
        (all[0].symbol.name(), all[0].value)
    };
    // A sensor with 5 % more gain, a delay of 3 ms more than known, a friction of 0.8 at rest.
    for (found, name, value) in [
        (named(EffectKind::TorqueGainError, &[], 0.05), "GT", 1.05),
        (named(EffectKind::TimeDelay, &[1e-3], 0.003), "TD", 0.007),
        (named(EffectKind::StribeckFriction, &[0.3, 2.0], 0.3), "FS", 0.8),
    ] {
        assert!(found.0 == name && (found.1 - value).abs() < 1e-12, "{found:?}");
    }
}

/// A cable pulls where it is taut and is slack on the other side.
#[test]
fn a_cable_pulls_on_its_side() {
    let robot = planar();
    let plant = PerturbableRobot::new(&robot);
    let recordings = [recording()];
    let scene = WindowedData::new(&plant, &recordings, 1.0 / PERIOD, &[0.0; 2], false);
    let cable = causes().find(|c| c.effect() == EffectKind::JointSpring && c.shape().len() == 2).unwrap();
    let rest = 0.1;
    for (form, (low, high, powers)) in
        [(0.0, 1.0, 1), (-1.0, 0.0, 1), (0.0, 1.0, 2), (-1.0, 0.0, 2), (-1.0, 1.0, 2)].into_iter().enumerate()
    {
        let terms = cable.terms(&scene, &[0], &[rest, form as f64]);
        assert_eq!(terms.len(), powers);
        for (term, power) in terms.iter().zip([1, 3]) {
            let (_, series) = &term.column.rows[0];
            for w in (0..scene.len).filter(|w| scene.live[0][*w]) {
                let x = scene.own[0][0].q[w] - rest;
                let wanted = x.clamp(low, high).powi(power);
                assert!((series[w] - wanted).abs() < 1e-9, "{form} {w}: {} {wanted}", series[w]);
            }
        }
    }
}

/// Friction may fall with speed or vary along the travel as long as it dissipates. A law that
/// returns energy over a part of the motion is another error.
#[test]
fn friction_that_drives_the_joint_is_none() {
    let robot = planar();
    let plant = PerturbableRobot::new(&robot);
    let noise = [0.05; 2];
    let stretch = &recording().stretches[0];
    let dry = robot.joints[1].drive.coulomb_friction.unwrap();
    let len = stretch.states.len;
    let wavy = |size: f64| {
        let along = |j: usize, k: usize| match j {
            1 => size * (3.0 * stretch.states.q[len + k]).cos() * stretch.states.dq[len + k].signum(),
            _ => 0.0,
        };
        made(noise, 3, &along)
    };
    for (size, drives) in [(0.5 * dry, false), (-4.0 * dry, true)] {
        let recordings = wavy(size);
        let mut tested = tested(&plant, &recordings);
        let mut trial = [chosen(EffectKind::PositionDependentFriction, &[1], &[3.0])];
        let fitted = tested.fit(&mut trial);
        assert!(trial[0].x[0] / size > 0.5, "{:?} for {size}", trial[0].x);
        assert_eq!(friction_drives(&tested, 1, &trial, &fitted, noise[1]), drives, "{size} N m beside {dry}");
    }
}

/// A friction law that drives the joint is accepted if it takes most of the joint's error, which
/// then has this form.
#[test]
fn friction_that_drives_the_joint_must_take_most_of_its_error() {
    let robot = planar();
    let plant = PerturbableRobot::new(&robot);
    let states = &recording().stretches[0].states;
    let dry = robot.joints[1].drive.coulomb_friction.unwrap();
    let noise = [0.05, 0.05 * dry];
    for (slow, drives) in [(0.0, false), (5.0 * dry, true)] {
        let along = |j: usize, k: usize| {
            let (q, v) = (states.q[states.len + k], states.dq[states.len + k]);
            if j == 1 { -4.0 * dry * (3.0 * q).cos() * v.signum() + slow * (2.0 * states.q[k]).sin() } else { 0.0 }
        };
        let recordings = made(noise, 3, &along);
        let mut tested = tested(&plant, &recordings);
        let before = tested.fit(&mut []);
        let mut trial = [chosen(EffectKind::PositionDependentFriction, &[1], &[3.0])];
        let after = tested.fit(&mut trial);
        let settings = SearchSettings::default();
        let judge = Judge { tested: &tested, noise: &noise, settings: &settings, accepted: &[], tried: 1 };
        assert_eq!(judge.drives(&trial, [&before, &after]), drives, "beside {slow} N m of another error");
    }
}

/// A push of 0.6 s that seems to last a second, and an opposite one over its end, are one push.
/// Two pushes with forces of their own are not.
#[test]
fn an_opposite_push_over_the_end_of_another_makes_it_shorter() {
    let robot = planar();
    let plant = PerturbableRobot::new(&robot);
    let states = recording().stretches[0].states.len;
    let at = |share: f64| (share * states as f64).round();
    let time = |share: f64| at(share) * PERIOD;
    for (later, one) in [(0.0, true), (-1.5, false)] {
        let force = |k: usize| match k as f64 {
            k if (at(0.4)..at(0.5)).contains(&k) => 1.0,
            k if (at(0.5)..at(0.57)).contains(&k) => later,
            _ => 0.0,
        };
        let recordings = made([0.02; 2], 4, &|j, k| force(k) * [0.6, 0.4][j]);
        let mut tested = tested(&plant, &recordings);
        let push = |from: f64| chosen(EffectKind::ExternalContact, &[], &[time(from), time(0.57), 0.0, 1.0, 0.0]);
        let mut two = [push(0.4), push(0.5)];
        let fitted = tested.fit(&mut two);
        let found = shorter_push(&mut tested, &two, &fitted);
        assert_eq!(found.is_some(), one, "{later}");
        if let Some(found) = found {
            assert_eq!((found.needless, found.chosen.len()), (1, 1));
            assert_eq!(found.chosen[0].shape[..2], [time(0.4), time(0.5)]);
        }
    }
}

/// Links that are wrong altogether resemble a shared motor, wrong gains or rotors. Beside refitted
/// links none of these is likely, and a real spring remains.
#[test]
fn what_other_links_explain_is_unlikely_beside_them() {
    let robot = planar();
    let plant = PerturbableRobot::new(&robot);
    let quiet = made([0.0; 2], 1, &|_, _| 0.0);
    let file = tested(&plant, &quiet);
    let states = &quiet[0].stretches[0].states;
    let mut heavier = vec![[0.0; 2]; states.len];
    for (w, k) in samples(&file.scene).into_iter().enumerate() {
        heavier[k] = [0.4 * file.scene.rigid[0][w], 0.3 * file.scene.rigid[1][w]];
    }
    let noise = [0.05; 2];
    let spring = |j: usize, k: usize| if j == 1 { 2.0 * states.q[states.len + k] } else { 0.0 };
    let recordings = [made(noise, 3, &|j, k| heavier[k][j]), made(noise, 3, &|j, k| heavier[k][j] + spring(j, k))];
    let likely = |which: usize, mode: Mode, name: &str, place: &[usize]| {
        let mut tested = ModelUnderTest::new(&plant, &recordings[which], 1.0 / PERIOD, mode, &[0.0; 2], false);
        worth(&mut tested, &mut Vec::new(), (name, place), &noise).map_or(0.0, |worth| worth.probability())
    };
    let seeming: [(&str, &[usize]); 4] =
        [("gear_coupling", &[0, 1]), ("torque_gain_error", &[1]), ("base_tilt", &[]), ("rotor_inertia", &[0])];
    for (name, place) in seeming {
        assert!(likely(0, Mode::Trusted, name, place) > 0.6, "{name}");
        assert!(likely(0, Mode::Refitted, name, place) < 0.2, "{name}");
    }
    for (which, there) in [(0, false), (1, true)] {
        let p = likely(which, Mode::Refitted, "joint_spring", &[1]);
        assert_eq!(p > 0.8, there, "{p}");
        assert!(likely(which, Mode::Refitted, "viscous_friction", &[1]) < 0.2);
    }
}
