//! Columns of the hypotheses on a synthetic motion, against their laws written out here.

use std::sync::Arc;

use super::mechanisms::planar;
use crate::data::signal::Band;
use crate::diagnose::hypotheses::{Term, hypothesis};
use crate::diagnose::windows::recording::{Recording, Stretch};
use crate::diagnose::windows::windowed_data::WindowedData;
use crate::model::drives_alone::DrivesAlone;
use crate::model::perturbable_robot::PerturbableRobot;
use crate::model::{Arm, States};
use dh_codegen::robot::EffectKind;

pub(super) const PERIOD: f64 = 0.005;
const LEN: usize = 1200;

/// Position, velocity and acceleration of joint 1; joint 2 follows at half the size.
fn at(k: usize) -> [f64; 3] {
    let (w, t) = (2.3, PERIOD * k as f64);
    [0.8 * (w * t).sin(), 0.8 * w * (w * t).cos(), -0.8 * w * w * (w * t).sin()]
}

pub(in crate::diagnose) fn recording() -> Recording {
    let series = |which: usize| -> Vec<f64> {
        [1.0, 0.5].into_iter().flat_map(|size| (0..LEN).map(move |k| size * at(k)[which])).collect()
    };
    let stretch = Stretch {
        start: 0.0,
        period: PERIOD,
        states: States { len: LEN, q: series(0), dq: series(1), ddq: series(2) },
        tau: vec![1.0; 2 * LEN],
        temperature: Vec::new(),
        motor: Vec::new(),
        load: Vec::new(),
        velocity_noise: vec![1e-6; 2],
        error: Vec::new(),
        torque_noise: vec![0.01; 2],
        clock_error: 0.0,
        stuck: Vec::new(),
        band: Band::default(),
        beside: [const { Vec::new() }; 2],
    };
    Recording { name: "made up".into(), begin: 0.0, stretches: vec![stretch] }
}

/// Checks the columns of a hypothesis on joint 1, one window per sample, against `law(term,
/// sample)`, in the windows that are used.
fn follows(scene: &WindowedData<'_>, effect: EffectKind, shape: &[f64], law: &dyn Fn(usize, usize) -> f64) {
    let terms: Vec<Term> = hypothesis(effect).terms(scene, &[0], shape);
    assert!(!terms.is_empty(), "{effect} {shape:?}");
    let mut counted = 0;
    for (term, t) in terms.iter().enumerate() {
        let (_, series) = t.column.rows.iter().find(|(j, _)| *j == 0).unwrap();
        for (w, value) in series.iter().enumerate().filter(|(w, _)| scene.live[0][*w]) {
            let wanted = law(term, w);
            assert!((value - wanted).abs() < 1e-9 * wanted.abs().max(1.0), "{effect} {shape:?} {w}: {value} {wanted}");
            counted += 1;
        }
    }
    assert!(counted > 800, "{effect}: {counted}");
}

#[test]
fn columns_are_what_their_laws_say() {
    let robot = planar();
    let plant = PerturbableRobot::new(&robot);
    let recordings = [recording()];
    let mut scene = WindowedData::new(&plant, &recordings, 1.0 / PERIOD, &[0.0; 2], false);
    let beta = vec![0.4; scene.beta.len()];
    scene.set_model(beta, None);
    let own = scene.own[0][0].clone();
    let (q, v, load) = (|w: usize| own.q[w], |w: usize| own.v[w], |w: usize| own.load(w));
    let sign = |w: usize| v(w).signum();
    assert!((0..scene.len).any(|w| load(w) > 0.1) && (0..scene.len).any(|w| load(w) < -0.1));

    follows(&scene, EffectKind::AsymmetricFriction, &[], &|_, w| v(w).abs());
    follows(&scene, EffectKind::StribeckFriction, &[0.3, 2.0], &|_, w| sign(w) * (-(v(w) / 0.3) * (v(w) / 0.3)).exp());
    follows(&scene, EffectKind::StribeckFriction, &[0.3, 1.0], &|_, w| sign(w) * (-v(w).abs() / 0.3).exp());
    follows(&scene, EffectKind::NonlinearViscousFriction, &[3.0, 0.0], &|_, w| v(w) * v(w) * v(w));
    follows(&scene, EffectKind::NonlinearViscousFriction, &[1.0, 0.2], &|_, w| v(w) / (v(w).abs() + 0.2));
    follows(&scene, EffectKind::LoadDependentFriction, &[0.0], &|_, w| sign(w) * load(w).abs());
    // The motor drives the load where power is positive; the load drives the motor elsewhere.
    follows(&scene, EffectKind::LoadDependentFriction, &[1.0], &|term, w| {
        let driving = load(w) * v(w) >= 0.0;
        if driving == (term == 0) { sign(w) * load(w).abs() } else { 0.0 }
    });
    follows(&scene, EffectKind::TorqueRipple, &[7.0], &|term, w| {
        let angle = 7.0 * q(w);
        if term == 0 { angle.cos() } else { angle.sin() }
    });
    follows(&scene, EffectKind::FrictionDrift, &[2.5], &|term, w| {
        (if term == 0 { sign(w) } else { v(w) }) * (-own.t(w) / 2.5).exp()
    });
}

/// Gears that are diagnosed alone. Their friction depends on the measured load behind them, the
/// motion's part of the torque is the rotor's, and a delayed motion uses the load of its torque.
#[test]
fn a_measured_load_is_what_a_gear_transmits() {
    let plant = DrivesAlone::new(&planar());
    let mut recordings = [recording()];
    let measured: Vec<f64> = (0..2 * LEN).map(|k| 3.0 * (0.01 * k as f64).cos()).collect();
    recordings[0].stretches[0].load.clone_from(&measured);
    let mut scene = WindowedData::new(&plant, &recordings, 1.0 / PERIOD, &[0.0; 2], false);
    let rotor = plant.base_parameters().iter().position(|b| b.name == "IA1").unwrap();
    let mut beta = vec![0.0; scene.beta.len()];
    beta[rotor] = 0.7;
    scene.set_model(beta, None);
    scene.rotors[0] = 0.7;
    scene.delayed_by(&recordings, 1.0 / PERIOD, &[4.0 * PERIOD, 0.0]);
    let own = scene.own[0][0].clone();
    let first = (scene.time[0] / PERIOD).round() as usize;
    let load = |w: usize| measured[first + w];
    follows(&scene, EffectKind::LoadDependentFriction, &[0.0], &|_, w| own.v[w].signum() * load(w).abs());
    for (w, torque) in scene.by_motion(0).iter().enumerate() {
        assert!((torque - 0.7 * own.a[w]).abs() < 1e-9, "{w}: {torque}");
    }
    assert!(scene.slopes(0).position.iter().flatten().all(|x| x.abs() < 1e-9));
}

#[test]
fn a_late_torque_is_the_earlier_one() {
    let robot = planar();
    let plant = PerturbableRobot::new(&robot);
    let recordings = [recording()];
    let mut scene = WindowedData::new(&plant, &recordings, 1.0 / PERIOD, &[0.0; 2], false);
    // A torque that rises in time: delayed, it is smaller.
    scene.whole = [scene.time.clone(), vec![0.0; scene.len]].map(Arc::new).to_vec();
    let terms = hypothesis(EffectKind::TimeDelay).terms(&scene, &[0], &[0.02]);
    let (_, series) = &terms[0].column.rows[0];
    let inner = 10..scene.len - 10;
    let late = inner.filter(|w| scene.live[0][*w]).map(|w| series[w]);
    late.for_each(|x| assert!((x + 1.0).abs() < 1e-9, "{x}"));
}

#[test]
fn bristles_bend_over_their_length() {
    let robot = planar();
    let plant = PerturbableRobot::new(&robot);
    let recordings = [recording()];
    let scene = WindowedData::new(&plant, &recordings, 1.0 / PERIOD, &[0.0; 2], false);
    let length = 0.05;
    let terms = hypothesis(EffectKind::PreslidingHysteresis).terms(&scene, &[0], &[length]);
    let (_, series) = &terms[0].column.rows[0];
    // Reference: dz = (sign - z) |dq| / length, by small steps along the exact motion.
    let (first, mut z, steps) = ((scene.own[0][0].t(0) / PERIOD).round(), 0.0, 200);
    let mut checked = 0;
    for w in 1..scene.len {
        for s in 0..steps {
            let k = |s: usize| (first + (w - 1) as f64 + s as f64 / f64::from(steps as u32)) * PERIOD;
            let by = 0.8 * ((2.3 * k(s + 1)).sin() - (2.3 * k(s)).sin());
            z += (by.signum() - z) * by.abs() / length;
        }
        // The initial state decays within a few lengths.
        if w > 200 && scene.live[0][w] {
            assert!((series[w] - z).abs() < 0.02, "{w}: {} {z}", series[w]);
            checked += 1;
        }
    }
    assert!(checked > 600, "{checked}");
}

/// A link of more than half the arm's mass (and more than its own) is implausible, as ten
/// parameters and as a point mass. Link 1 of a planar arm has no mass to the data: its first
/// coefficient is a first moment.
#[test]
fn a_link_gets_no_more_mass_than_an_arm_carries() {
    let robot = planar();
    let plant = PerturbableRobot::new(&robot);
    let recordings = [recording()];
    let scene = WindowedData::new(&plant, &recordings, 1.0 / PERIOD, &[0.0; 2], false);
    let masses: Vec<f64> = scene.plant.rows().iter().map(|row| scene.plant.given().unwrap()[10 * row]).collect();
    let most = (0.5 * masses.iter().sum::<f64>()).max(masses[1]);
    let both = |effect, place: &[usize]| {
        let ten = hypothesis(effect);
        [ten, ten.simpler(&scene, place, &[])[0].0]
    };
    for cause in both(EffectKind::LinkInertiaError, &[1]) {
        for (mass, plausible) in [(0.99 * most, true), (1.01 * most, false), (-0.9 * masses[1], true)] {
            assert_eq!(cause.plausible(&scene, &[1], &[0.0; 3], &[mass, 0.0]), plausible, "{mass}");
        }
        assert!(cause.plausible(&scene, &[0], &[0.0; 3], &[10.0 * most, 0.0]));
    }
    assert!(both(EffectKind::Payload, &[]).iter().all(|c| c.plausible(&scene, &[], &[0.0; 3], &[1.01 * most, 0.0])));
}
