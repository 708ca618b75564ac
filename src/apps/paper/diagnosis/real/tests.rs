//! Tests of the test chain itself, on a small simulated recording.

use super::*;
use crate::data::log::csv;
use crate::simulate::{Control, Effects, Mode, Request, Sensors, Simulator, Trajectory};

/// The planar arm with friction, 24 s at 100 Hz.
fn small() -> Recorded {
    let text = include_str!("../../../../../robots/planar2r.yaml");
    let robot = dh_codegen::robot::Robot::from_yaml(text, &dh_codegen::robot::no_files).unwrap().robot;
    let t: Vec<f64> = (0..1250).map(|k| f64::from(k) / 50.0).collect();
    let q = |t: f64| [0.9 * (1.3 * t).sin() + 0.3 * (2.9 * t).sin(), 0.8 * (1.9 * t).cos() - 0.3 * (3.7 * t).sin()];
    let positions: Vec<f64> = (0..2).flat_map(|j| t.iter().map(move |&t| q(t)[j])).collect();
    let motion = Trajectory::new(2, t, positions, None, None).unwrap();
    let request = Request {
        control: Control { mode: Mode::Exact, ..Control::default() },
        sensors: Sensors {
            rate: 100.0,
            encoder: vec![1e-5],
            torque_noise: vec![0.1, 0.05],
            desired: false,
            ..Sensors::default()
        },
        ..Request::default()
    };
    let log = Simulator::new(&robot, &Effects::default()).unwrap().run(&motion, &request, &mut |_| {}).unwrap().log;
    let mut bytes = Vec::new();
    csv::write(&log, &mut bytes).unwrap();
    let arm = ArmData { folder: "planar", robot: text, fit: &["run.csv"], validate: &[], late: 0.0, gains: &[] };
    Recorded { arm, fit: vec![bytes], validate: Vec::new() }
}

#[test]
fn every_addition_has_its_size_and_an_informed_fit_finds_it() {
    let session = Session::new(&small(), [40.0, 15.0]).unwrap();
    // Friction of 0.2 and 0.1 N m, no payload: the residual is little more than the torque's noise.
    assert!(session.residual.iter().zip([0.1, 0.05]).all(|(r, noise)| *r < 1.5 * noise), "{:?}", session.residual);
    let mut drawn = 0;
    for form in Form::ALL {
        let mut random = Random::new(5);
        let Some(addition) = Addition::draw(form, &session, &mut random) else { continue };
        let Some(x) = addition.sized(&session, 20.0) else { continue };
        drawn += 1;
        let added = addition.added(&session, x);
        let by = |j: usize| added.rms[j] / session.residual[j];
        let most = by(0).max(by(1));
        let own = added.joints.first().map_or(most, |j| if form == Form::Link { most } else { by(j - 1) });
        assert!((own - 20.0).abs() < 0.05, "{form:?} {own}");
        let found = informed::recovered(&session, &addition, x);
        // Apart from reversals, a level that differs with the direction is an offset.
        if form == Form::Asymmetric {
            continue;
        }
        assert!((found - 1.0).abs() < 0.2, "{form:?} {found}");
    }
    assert!(drawn >= 10, "{drawn}");
}

#[test]
fn an_added_body_is_the_difference_of_two_arms() {
    let session = Session::new(&small(), [40.0, 15.0]).unwrap();
    let addition = Addition::draw(Form::Payload, &session, &mut Random::new(3)).unwrap();
    let e = &session.fit[0];
    let added = addition.signal(&session, e, 0.4, true);
    let (mut with, without) = (session::bodies(&session.robot), session::bodies(&session.robot));
    // The planar arm depends on the mass, its two first moments in the plane, and their squares.
    let once = addition.signal(&session, e, 0.1, true);
    assert!(added[1].iter().zip(&once[1]).all(|(a, b)| (a - 4.0 * b).abs() < 1e-9));
    with[10] += 0.4;
    let [heavy, light] = [&with, &without].map(|s| session::torques(&session.numeric, &e.states, s));
    // A mass at the frame's origin acts on the first joint only; the addition acts mainly there.
    assert!(heavy[1].iter().zip(&light[1]).all(|(a, b)| (a - b).abs() < 1e-9));
    assert!(added[0].iter().any(|a| a.abs() > 0.1));
}

#[test]
fn positions_differentiated_by_the_measure_are_right() {
    let t: Vec<f64> = (0..400).map(|k| f64::from(k) * 0.01 + 0.002 * f64::from(k % 3)).collect();
    let q = vec![t.iter().map(|t| (2.0 * t).sin()).collect::<Vec<f64>>()];
    let states = motion::states(&t, &q, &[200]);
    for k in 5..395 {
        assert!((states.dq[k] - 2.0 * (2.0 * t[k]).cos()).abs() < 5e-3, "{k}");
        assert!((states.ddq[k] + 4.0 * (2.0 * t[k]).sin()).abs() < 0.4, "{k}");
    }
}

#[test]
#[cfg_attr(debug_assertions, ignore = "slow without optimisation: cargo test --release --lib")]
fn a_battery_counts_what_it_says() {
    let settings = RealSettings { cases: 2, seed: 4, sizes: vec![3.0], ..RealSettings::default() };
    let found = on_real(&settings, &[small()], &|_, _| {}).unwrap();
    assert_eq!(found.cases.len() + found.skipped.len(), 2, "{:?}", found.skipped);
    assert_eq!(found.figures[0].recovered.all, found.cases.len());
    assert!(found.figures[0].claims.len() >= found.figures[0].named.good);
    let again = on_real(&settings, &[small()], &|_, _| {}).unwrap();
    assert_eq!(format!("{:?}", found.cases), format!("{:?}", again.cases));
}
