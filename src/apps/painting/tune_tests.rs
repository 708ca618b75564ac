//! Checks the predictions of `tune` against the simulated arm on walls of several stiffnesses.

use dh_codegen::arm::param;
use dh_codegen::robot::{Effects, Robot, no_files};

use super::run_tests::FILE;
use super::tune::{Demands, Tuning, tune};
use super::wall::RollerWall;
use crate::control::law::{Controller, ForceSettings, JointLoop, Limits, Sample, Settings, Target};
use crate::control::robot::{RobotModel, contact_point};
use crate::model::interpreted::Interpreted;
use crate::simulate::{External, Sampled, Sensors, Simulator, Solver};

const PERIOD: f64 = 1e-3;
const CORNER: f64 = 10.0;
const FORCE: f64 = 20.0;
/// Elbow up, hand along x.
const POSTURE: [f64; 3] = [0.8, -1.3, 0.5];
/// Time at which the desired force rises by 1 N, s; `WATCHED` is the time recorded after it, s.
const SETTLED: f64 = 5.0;
const WATCHED: f64 = 3.0;

/// Force minus [`FORCE`] from the step on, N, one value per period, with the proposed gains of the
/// force loop times `factor`.
fn stepped(stiffness: f64, factor: impl Fn(&Tuning) -> f64) -> (Tuning, Vec<f64>) {
    let robot = Robot::from_yaml(FILE, &no_files).unwrap().robot;
    let real = Simulator::new(&robot, &Effects::default()).unwrap();
    let arm = Interpreted::new(&robot, &Interpreted::BODIES);
    let standard = param::standard_values(&robot).unwrap();
    let lend = || RobotModel::new(&robot, Box::new(arm.bodies(&standard)), None, real.drives().to_vec());
    let mut model = lend();
    let place = model.contact(&POSTURE).origin;
    // A wall with normal stiffness only, as in the linear model at any force.
    let wall = RollerWall {
        stiffness,
        damping: 0.0,
        rolling: 0.0,
        sliding: 0.0,
        ..RollerWall::new(place, [-1.0, 0.0, 0.0], contact_point(robot.tool.as_ref()))
    };
    let press = [1.0, 0.0, 0.0];
    let demands = Demands {
        period: PERIOD,
        corner: CORNER,
        stiffness,
        damping: wall.damping_at(FORCE),
        drives: vec![[0.0, f64::INFINITY, 0.0]; 3],
    };
    let viscous = std::array::from_fn(|j| real.drives()[j].plain.viscous);
    let tuning = tune(&mut model, &[POSTURE], &viscous, &press, &demands).unwrap();
    let factor = factor(&tuning);
    let settings = Settings {
        period: PERIOD,
        joints: JointLoop {
            kp: std::array::from_fn(|j| tuning.joints[j].kp),
            kd: std::array::from_fn(|j| tuning.joints[j].kd),
        },
        force: ForceSettings {
            kp: factor * tuning.force.kp,
            ki: factor * tuning.force.ki,
            range: [-0.1, 0.3],
            rate: 10.0,
        },
        torque: [1e3; 3],
        velocity: [20.0; 3],
        patience: 5,
        contact: 0.0,
        lost_after: 10.0,
        regain: 1.0,
        give_up: 1e3,
        most: 1e6,
        carry: 0.0,
        feed: 0.0,
        aside: 0.0,
        aside_pole: 0.0,
        drag: 0.0,
        corner: CORNER,
        limits: Limits::NONE,
        stop: 0.25,
    };
    let mut controller = Controller::new(lend(), settings).unwrap();
    let run = Sampled {
        start: POSTURE.to_vec(),
        seconds: SETTLED + WATCHED,
        sensors: Sensors::perfect(1.0 / PERIOD),
        solver: Solver::default(),
        seed: 1,
    };
    let turn = std::f64::consts::TAU * CORNER * PERIOD;
    let share = turn / (1.0 + turn);
    let (mut low, mut forces) = ([0.0; 3], Vec::new());
    let external: [&dyn External; 1] = [&wall];
    real.run_sampled(&run, &external, &mut |seen, is, torque| {
        let truth = -is.wrench[0];
        let mut from = truth;
        for stage in &mut low {
            *stage += share * (from - *stage);
            from = *stage;
        }
        let after = seen.t > SETTLED - 0.5 * PERIOD;
        if after {
            forces.push(truth - FORCE);
        }
        // A slow rise: a wall cannot pull, and a loop that bounces is a different loop.
        let wanted = FORCE * (seen.t / 2.0).min(1.0) + f64::from(u8::from(after));
        let target = Target::at(POSTURE, press, Some(wanted));
        let q = std::array::from_fn(|j| seen.q[j]);
        let command = controller.step(&target, &Sample { t: seen.t, q, force: low[2], push: [f64::NAN; 3] });
        torque.copy_from_slice(&command.torque);
        true
    })
    .unwrap();
    (tuning, forces)
}

/// Time at which the step response reaches a share of 1 N, s.
fn reaches(forces: &[f64], share: f64) -> f64 {
    forces.iter().position(|f| *f >= share).map_or(f64::INFINITY, |k| k as f64 * PERIOD)
}

#[test]
fn steps_of_the_force_are_as_predicted() {
    for stiffness in [1e3, 8e3, 3e4] {
        let (tuning, is) = stepped(stiffness, |_| 1.0);
        let predicted = &tuning.force.step;
        let worst = predicted.force.iter().zip(&is).map(|(p, f)| (p - f).abs()).fold(0.0, f64::max);
        assert!(worst < 0.05, "{stiffness} N/m: {worst} of 1 N");
        let rise = |forces: &[f64]| reaches(forces, 0.9) - reaches(forces, 0.1);
        let (said, found) = (rise(&predicted.force), rise(&is));
        // Plus three periods: on a soft wall the kick of the joints' derivative gains makes up the
        // whole rise.
        assert!((found - said).abs() < 0.1 * said + 0.003, "{stiffness} N/m: rise {found} s, predicted {said} s");
        let over = is.iter().fold(0.0_f64, |most, f| most.max(f - 1.0));
        assert!(
            (over - predicted.overshoot).abs() < 0.05,
            "{stiffness} N/m: {over}, predicted {}",
            predicted.overshoot
        );
        let margins = &tuning.force.margins;
        assert!(margins.phase >= 45.0 && margins.gain >= 6.0, "{stiffness} N/m: {margins:?}");
        let ripple = is[is.len() - 500..].iter().fold(0.0_f64, |most, f| most.max((f - 1.0).abs()));
        assert!(ripple < 0.02, "{stiffness} N/m: {ripple}");
    }
}

#[test]
fn the_gain_margin_is_where_the_loop_begins_to_swing() {
    for stiffness in [1e3, 8e3, 3e4] {
        let swing = |of_margin: f64| {
            let (_, is) = stepped(stiffness, |t| of_margin * 10f64.powf(t.force.margins.gain / 20.0));
            let end = &is[is.len() - 1000..];
            end.iter().fold(f64::MIN, |m, f| m.max(*f)) - end.iter().fold(f64::MAX, |m, f| m.min(*f))
        };
        // 2 dB to either side.
        let (below, above) = (swing(0.8), swing(1.25));
        assert!(below < 0.1, "{stiffness} N/m: {below} N at 0.8 of the margin");
        assert!(above > 2.0, "{stiffness} N/m: {above} N at 1.25 of the margin");
    }
}
