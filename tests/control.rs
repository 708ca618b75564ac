//! Tests of the control law: its response to any input, and that it needs nothing but `core`.

mod gantry;

use denavit::control::law::{
    Body, Command, Controller, ControllerError, Estimator, EstimatorSettings, Fault, ForceSettings, Sample, Settings,
    Status, Target, Tool, damped, moved,
};
use gantry::{Gantry, T, World, pressing, settings, target};
use proptest::prelude::*;

#[test]
fn it_presses_with_the_force_that_is_wanted() {
    let (mut controller, world) = pressing();
    assert!((world.force() - 30.0).abs() < 0.05, "{}", world.force());
    let command = controller.step(&target(), &Sample { t: world.t, ..world.sample() });
    assert_eq!(command.status, Status::Pressing);
    // The spring of the joint loop (400 N/m) carries the force.
    assert!((command.displacement - world.q[0] - 30.0 / 400.0).abs() < 1e-3);
}

#[test]
fn what_is_fed_forward_need_not_be_displaced() {
    let mut controller = Controller::new(Gantry::default(), Settings { carry: 1.0, ..settings() }).unwrap();
    let mut world = World::new();
    let mut command = None;
    for _ in 0..8000 {
        let next = controller.step(&target(), &world.sample());
        world.run(&next);
        command = Some(next);
    }
    assert!((world.force() - 30.0).abs() < 0.05, "{}", world.force());
    assert!((command.unwrap().displacement - world.q[0]).abs() < 1e-3);
}

/// The feed-forward force ends within 20 ms of the end of contact, and starts within half a second.
#[test]
fn what_is_fed_forward_ends_with_the_contact() {
    let mut controller = Controller::new(Gantry::default(), Settings { carry: 1.0, ..settings() }).unwrap();
    let mut world = World::new();
    for _ in 0..8000 {
        let command = controller.step(&target(), &world.sample());
        world.run(&command);
    }
    let mut steps = |force: f64, count: u32| {
        let (mut last, mut speed) = (controller.step(&target(), &Sample { force, ..world.sample() }), 0.0);
        world.t += T;
        for _ in 1..count {
            let next = controller.step(&target(), &Sample { force, ..world.sample() });
            (last, speed) = (next, (next.displacement - last.displacement) / T);
            world.t += T;
        }
        (last.torque[0], last.displacement, speed)
    };
    let (before, start, _) = steps(30.0, 1);
    // Meanwhile the tool is moved deeper; this gives torques of the joint loop's spring and
    // damping.
    let (after, deeper, speed) = steps(0.0, 21);
    let loops = 400.0 * (deeper - start) + 40.0 * speed;
    assert!((before - after - 30.0 + loops).abs() < 0.1 && loops > 4.0, "{before} {after} {loops}");
    let (again, still, _) = steps(30.0, 250);
    assert!((again - 15.0 - 400.0 * (still - start)).abs() < 0.5, "{again} {after}");
}

#[test]
fn a_drag_aside_is_carried_by_its_estimate() {
    let moved = |aside: f64| {
        let mut controller = Controller::new(Gantry::default(), Settings { carry: 1.0, aside, ..settings() }).unwrap();
        let mut world = World::new();
        for k in 0..8000 {
            world.drag = if k > 4000 { 8.0 } else { 0.0 };
            let command = controller.step(&target(), &world.sample());
            world.run(&command);
        }
        assert!((world.force() - 30.0).abs() < 0.05, "{}", world.force());
        world.q[1]
    };
    // The spring of the joint loop (400 N/m) carries all of the force, or the remainder.
    assert!((moved(0.0) + 8.0 / 400.0).abs() < 1e-4);
    assert!((moved(0.9) + 0.8 / 400.0).abs() < 1e-4);
}

#[test]
fn drag_is_learned_and_then_known_before_the_estimate_shows_it() {
    const FRICTION: f64 = 0.4;
    // Moves back and forth along y with the tangential push measured through a low-pass of 10 Hz.
    // Returns the tool's deviation in the last of seven turns.
    let run = |drag: f64| {
        let settings = Settings { carry: 1.0, feed: 1.0, aside: 0.5, aside_pole: 4.0, drag, ..settings() };
        let mut controller = Controller::new(Gantry::default(), settings).unwrap();
        let mut world = World::new();
        let turn = std::f64::consts::TAU * 10.0 * T;
        let (mut low, mut worst) = ([0.0; 3], 0.0_f64);
        for k in 0..26_000 {
            let t = T * f64::from(k);
            let moves = if t > 4.0 { 1.0 } else { 0.0 };
            let wave = |d: i32| {
                moves * 0.05 * 2f64.powi(d) * (2.0 * (t - 4.0) + f64::from(d) * std::f64::consts::FRAC_PI_2).cos()
            };
            let mut target = target();
            (target.q[1], target.dq[1], target.ddq[1]) = (wave(0) - 0.05 * moves, wave(1), wave(2));
            let mut from = world.drag;
            for stage in &mut low {
                *stage += turn / (1.0 + turn) * (from - *stage);
                from = *stage;
            }
            let sample = Sample { push: [world.force(), low[2], 0.0], ..world.sample() };
            let command = controller.step(&target, &sample);
            world.run(&command);
            world.drag = FRICTION * world.force() * world.v[1] / world.v[1].hypot(1e-2);
            if k > 23_000 {
                worst = worst.max((world.q[1] - target.q[1]).abs());
            }
        }
        (worst, controller.drag().coefficients()[1])
    };
    let ((late, nothing), (known, learned)) = (run(0.0), run(1.0));
    assert!(nothing == 0.0 && (learned - FRICTION).abs() < 0.05, "{learned}");
    // With the prediction instead of the estimate's value, or the reverse, it is a tenth.
    assert!(known < 0.05 * late, "{known} {late}");
}

/// A push along the motion is not friction, and none is learned from it.
#[test]
fn drag_is_never_negative() {
    let settings = Settings { carry: 1.0, drag: 1.0, ..settings() };
    let mut controller = Controller::new(Gantry::default(), settings).unwrap();
    let mut world = World::new();
    for k in 0..9000 {
        let mut target = target();
        if k > 6000 {
            let t = T * f64::from(k - 6000);
            target.q[1] = 0.05 * (1.0 - (2.0 * t).cos());
            (target.dq[1], target.ddq[1]) = (0.1 * (2.0 * t).sin(), 0.2 * (2.0 * t).cos());
        }
        let push = [world.force(), -8.0 * target.dq[1].signum(), 0.0];
        let command = controller.step(&target, &Sample { push, ..world.sample() });
        world.run(&command);
        assert!(controller.drag().coefficients().iter().all(|c| *c >= 0.0), "{:?}", controller.drag());
    }
}

/// Newton steps with the Jacobian move the point and keep the tool's direction, on an arm where the
/// two are coupled.
#[test]
fn a_posture_is_moved_without_turning_the_tool() {
    let tool = |q: &[f64; 7]| {
        let frame = kuka_lwr4::forward_kinematics(q);
        Tool {
            origin: [frame[0][3], frame[1][3], frame[2][3]],
            rotation: [0, 1, 2].map(|i| [frame[i][0], frame[i][1], frame[i][2]]),
            jacobian: kuka_lwr4::jacobian(q),
        }
    };
    let (q, by) = ([0.3, -0.6, 0.2, 1.2, -0.4, 0.8, 0.1], [0.02, -0.03, 0.025]);
    let (start, end) = (tool(&q), tool(&moved(&q, &by, tool).unwrap()));
    for i in 0..3 {
        assert!((end.origin[i] - start.origin[i] - by[i]).abs() < 1e-5);
        for k in 0..3 {
            assert!((end.rotation[i][k] - start.rotation[i][k]).abs() < 1e-4, "{end:?} {start:?}");
        }
    }
}

#[test]
fn the_planned_motion_is_fed_forward() {
    // A frictionless unit mass follows a planned wave as if there were no loop, except for the half
    // period for which torques are held.
    let worst = |feed: f64| {
        let mut controller = Controller::new(Gantry::default(), Settings { feed, ..settings() }).unwrap();
        let mut world = World { wall: false, ..World::new() };
        world.q[0] = 0.0;
        let mut worst: f64 = 0.0;
        for k in 0..5000 {
            let t = T * f64::from(k);
            let wave = |d: i32| 0.1 * 3f64.powi(d) * (3.0 * t + f64::from(d) * std::f64::consts::FRAC_PI_2).cos();
            let mut target = Target::at([0.0; 6], [1.0, 0.0, 0.0], None);
            (target.q[1], target.dq[1], target.ddq[1]) = (wave(0) - 0.1, wave(1), wave(2));
            let command = controller.step(&target, &world.sample());
            if k > 2500 {
                worst = worst.max((world.q[1] - target.q[1]).abs());
            }
            world.run(&command);
        }
        worst
    };
    assert!(worst(0.0) > 1.5e-3, "{}", worst(0.0));
    assert!(worst(1.0) < 0.1 * worst(0.0), "{} {}", worst(1.0), worst(0.0));
}

#[test]
fn anti_windup() {
    // After long with an unreachable force, the loop responds at once when it is reachable.
    let mut force =
        denavit::control::law::ForceLoop::new(ForceSettings { kp: 1e-3, ki: 0.1, range: [0.0, 0.05], rate: 1.0 });
    for _ in 0..10_000 {
        assert!(force.press(30.0, T, f64::MAX, 0.0) <= 0.05);
    }
    for _ in 0..20 {
        force.press(-30.0, T, f64::MAX, 0.0);
    }
    assert!(force.displacement() < 0.03, "{}", force.displacement());
}

/// A feed-forward displacement is added to the loop's own, within the limits of the sum.
#[test]
fn what_is_known_is_added() {
    for (ahead, sum) in [(5e-3, 0.025), (-5e-3, 0.015), (0.1, 0.05)] {
        let limits = ForceSettings { kp: 1e-3, ki: 0.0, range: [0.0, 0.05], rate: 1.0 };
        let mut force = denavit::control::law::ForceLoop::new(limits);
        for _ in 0..200 {
            force.press(20.0, T, f64::MAX, ahead);
        }
        assert!((force.displacement() - sum).abs() < 1e-6, "{ahead}: {}", force.displacement());
    }
}

/// With a ceiling below the end of the range the integral is held too.
#[test]
fn anti_windup_behind_a_ceiling() {
    let settings = ForceSettings { kp: 0.0, ki: 0.1, range: [0.0, 0.05], rate: 1.0 };
    let mut force = denavit::control::law::ForceLoop::new(settings);
    for _ in 0..10_000 {
        force.press(30.0, T, 0.02, 0.0);
    }
    assert_eq!(force.displacement(), 0.02);
    force.press(-30.0, T, 0.02, 0.0);
    assert!(force.displacement() < 0.02, "{}", force.displacement());
}

#[test]
fn missing_samples_are_waited_for_and_then_stopped() {
    let (mut controller, mut world) = pressing();
    let last = controller.step(&target(), &world.sample());
    let dead = Sample { q: [f64::NAN; 6], ..world.sample() };
    for _ in 0..5 {
        let held = controller.step(&target(), &dead);
        assert_eq!((held.status, held.torque), (Status::Holding, last.torque));
        world.run(&held);
    }
    let stopped = controller.step(&target(), &dead);
    assert_eq!(stopped.status, Status::Stopped(Fault::Position));
    assert_eq!(stopped.torque, [0.0, 0.0, 9.81, 0.0, 0.0, 0.0]);
    // When samples return, it stays stopped and comes to rest.
    world.v[1] = 0.5;
    for _ in 0..2000 {
        let command = controller.step(&target(), &world.sample());
        assert_eq!(command.status, Status::Stopped(Fault::Position));
        world.run(&command);
    }
    assert!(world.v.iter().all(|v| v.abs() < 0.01), "{:?}", world.v);
    controller.reset();
    for _ in 0..6000 {
        let command = controller.step(&target(), &world.sample());
        world.run(&command);
    }
    assert!((world.force() - 30.0).abs() < 0.05);
}

#[test]
fn a_few_missing_samples_do_no_harm() {
    let (mut controller, mut world) = pressing();
    let mut most: f64 = 0.0;
    for k in 0..3000 {
        let mut sample = world.sample();
        match k % 17 {
            3 | 4 => sample.q[1] = f64::NAN,
            9 => sample.t -= 5.0 * T, // stale
            12 => sample.q[0] += 1.0, // a leap
            14 => sample.force = f64::INFINITY,
            _ => {}
        }
        let command = controller.step(&target(), &sample);
        world.run(&command);
        assert!(!matches!(command.status, Status::Stopped(_) | Status::Leaving(_)), "{:?}", command.status);
        most = most.max((world.force() - 30.0).abs());
    }
    assert!(most < 3.0, "{most}");
}

#[test]
fn a_late_sample_stops_it() {
    let (mut controller, mut world) = pressing();
    world.t += 0.05;
    assert_eq!(controller.step(&target(), &world.sample()).status, Status::Stopping(Fault::Clock));
    for _ in 0..=controller.bounds().stop {
        let command = controller.step(&target(), &world.sample());
        world.run(&command);
    }
    assert_eq!(controller.step(&target(), &world.sample()).status, Status::Stopped(Fault::Clock));
}

/// Limit of the delay: a period and a half more than the patience of five.
#[test]
fn a_sample_may_be_late_by_the_patience() {
    for (late, expected) in [(5.4, None), (5.6, Some(Fault::Clock))] {
        let (mut controller, mut world) = pressing();
        world.t += late * T;
        assert_eq!(controller.step(&target(), &world.sample()).status.fault(), expected, "{late}");
    }
}

#[test]
fn without_a_force_it_leaves_the_wall() {
    let (mut controller, mut world) = pressing();
    let mut status = Status::Free;
    for _ in 0..3000 {
        let command = controller.step(&target(), &Sample { force: f64::NAN, ..world.sample() });
        status = command.status;
        world.run(&command);
    }
    assert_eq!(status, Status::Stopped(Fault::Force));
    assert!(world.q[0] < -0.015, "{}", world.q[0]);
}

#[test]
fn lost_contact_is_looked_for_and_given_up() {
    let (mut controller, mut world) = pressing();
    let placed = controller.step(&target(), &world.sample()).displacement;
    world.run(&Command { torque: [0.0; 6], desired: [0.0; 6], displacement: 0.0, status: Status::Free });
    world.wall = false;
    let (mut most, mut seen): (f64, Vec<Status>) = (0.0, Vec::new());
    for _ in 0..3000 {
        let command = controller.step(&target(), &world.sample());
        most = most.max(command.displacement);
        if seen.last() != Some(&command.status) {
            seen.push(command.status);
        }
        world.run(&command);
    }
    assert!(most <= placed + 0.0101, "{most} {placed}");
    let after = [Status::Leaving, Status::Stopping, Status::Stopped].map(|state| state(Fault::Contact));
    assert_eq!((&seen[..2], &seen[2..]), (&[Status::Pressing, Status::Lost][..], &after[..]));
    assert!((world.q[0] + 0.02).abs() < 2e-3, "{}", world.q[0]);
}

#[test]
fn too_much_force_makes_it_leave() {
    let (mut controller, world) = pressing();
    let command = controller.step(&target(), &Sample { force: 90.0, ..world.sample() });
    assert_eq!(command.status, Status::Leaving(Fault::Excess));
}

#[test]
fn no_wall_at_all_is_given_up() {
    let mut controller = Controller::new(Gantry::default(), settings()).unwrap();
    let mut world = World { wall: false, ..World::new() };
    let mut status = Status::Free;
    for _ in 0..6000 {
        let command = controller.step(&target(), &world.sample());
        status = command.status;
        world.run(&command);
    }
    assert_eq!(status, Status::Stopped(Fault::Contact));
    assert!((world.q[0] + 0.02).abs() < 2e-3, "{}", world.q[0]);
}

#[test]
fn settings_that_make_no_sense_are_refused() {
    let refused = |s: Settings<6>| Controller::new(Gantry::default(), s).err();
    assert_eq!(refused(settings()), None);
    let (force, period) = (settings().force, f64::NAN);
    for (wrong, error) in [
        (Settings { period: 0.0, ..settings() }, ControllerError::Period),
        (Settings { period, ..settings() }, ControllerError::Period),
        (Settings { aside: 1.1, ..settings() }, ControllerError::Share),
        (Settings { drag: -0.1, ..settings() }, ControllerError::Share),
        (Settings { feed: f64::NAN, ..settings() }, ControllerError::Share),
        (Settings { corner: 0.0, ..settings() }, ControllerError::Corner),
        (Settings { torque: [f64::NAN; 6], ..settings() }, ControllerError::Limits),
        (Settings { force: ForceSettings { ki: -1.0, ..force }, ..settings() }, ControllerError::ForceGains),
        (Settings { force: ForceSettings { range: [0.1, 0.2], ..force }, ..settings() }, ControllerError::Range),
        (Settings { force: ForceSettings { rate: 0.0, ..force }, ..settings() }, ControllerError::Rate),
    ] {
        assert_eq!(refused(wrong), Some(error));
    }
}

#[test]
fn the_estimate_is_the_wrench() {
    let jacobian: [[f64; 7]; 6] =
        std::array::from_fn(|i| std::array::from_fn(|j| ((1.7 * i as f64 + 0.3) * (j as f64 + 1.0)).sin()));
    let wrench = [-30.0, 2.0, 1.0, 0.3, -0.2, 0.1];
    let weights = [1.0, 2.0, 3.0, 1.0, 2.0, 3.0, 1.0];
    let tau: [f64; 7] = std::array::from_fn(|j| (0..6).map(|i| jacobian[i][j] * wrench[i]).sum());
    let right: [f64; 6] = std::array::from_fn(|i| (0..7).map(|j| jacobian[i][j] * weights[j] * tau[j]).sum());
    let found = damped(&jacobian, &weights, &right, 0.0).unwrap();
    assert!(found.iter().zip(wrench).all(|(a, b)| (a - b).abs() < 1e-9), "{found:?}");

    for moment in [f64::INFINITY, 10.0, 0.0] {
        let settings = EstimatorSettings {
            period: T,
            corner: 20.0,
            weights: [1.0; 6],
            damping: 1e-9,
            moment,
            turning: [1.0; 6],
            rest: [1e-4; 6],
        };
        let mut estimator = Estimator::new(Gantry::default(), settings);
        let mut last = None;
        for k in 0..2000 {
            // x'' = 1 while a force of 5 N pulls along y.
            let t = T * f64::from(k);
            let noise = 1e-9 * f64::from(k % 2);
            last = estimator.step(&[0.5 * t * t, 0.0, 0.0, 0.0, 0.0, 0.0], &[1.0, 5.0 + noise, 9.81, 0.0, 0.0, 0.0]);
        }
        let found = last.unwrap();
        assert!(found.iter().zip([0.0, 5.0, 0.0, 0.0, 0.0, 0.0]).all(|(a, b)| (a - b).abs() < 1e-3), "{found:?}");
        assert_eq!(estimator.step(&[f64::NAN; 6], &[0.0; 6]), None);
        // Torques that stay bit-identical on 5 cm of motion are rejected until they change.
        let tau = [1.0, 5.0, 9.81, 0.0, 0.0, 0.0];
        for k in 0..110 {
            let found = estimator.step(&[2.0 + T * f64::from(k), 0.0, 0.0, 0.0, 0.0, 0.0], &tau);
            assert_eq!(found.is_none(), k > 50, "{k}");
        }
        assert!(estimator.step(&[2.11, 0.0, 0.0, 0.0, 0.0, 0.0], &[1.0; 6]).is_some());
    }
}

/// A single wrong position costs two samples, an implausible one costs one, and an encoder that
/// wraps around one. The next estimate is nearly as good as before.
#[test]
fn positions_that_jump_are_no_speeds() {
    let settings = EstimatorSettings {
        period: T,
        corner: 20.0,
        weights: [1.0; 6],
        damping: 1e-9,
        moment: f64::INFINITY,
        turning: [0.0; 6],
        rest: [1e-4; 6],
    };
    let mut estimator = Estimator::new(Gantry::default(), settings);
    let wrong = |k: u32| match k {
        1000 => 5.0,
        1200 => 1e300,
        1500.. => std::f64::consts::TAU,
        _ => 0.0,
    };
    for k in 0..2000 {
        let t = T * f64::from(k);
        let noise = 1e-9 * f64::from(k % 2);
        let q = [0.5 * t * t + wrong(k), 0.0, 0.0, 0.0, 0.0, 0.0];
        let found = estimator.step(&q, &[1.0, 5.0 + noise, 9.81, 0.0, 0.0, 0.0]);
        let lost = matches!(k, 0..3 | 1000 | 1001 | 1200 | 1500);
        assert_eq!(found.is_none(), lost, "{k}");
        let of = [0.0, 5.0, 0.0, 0.0, 0.0, 0.0];
        // Two replaced samples of an accelerating motion leave 0.13 N, two missing ones 2.8 N.
        let near = |found: [f64; 6]| found.iter().zip(of).all(|(a, b)| (a - b).abs() < 0.2);
        assert!(k < 500 || found.is_none_or(near), "{k}: {found:?}");
    }
}

/// The arm stops while samples are lost: the motion before the loss does not predict it.
#[test]
fn a_long_loss_is_not_bridged() {
    let settings = EstimatorSettings {
        period: T,
        corner: 20.0,
        weights: [1.0; 6],
        damping: 1e-9,
        moment: f64::INFINITY,
        turning: [0.0; 6],
        rest: [0.0; 6],
    };
    let mut estimator = Estimator::new(Gantry::default(), settings);
    for k in 0..800 {
        let x = if k < 500 { T * f64::from(k) } else { 0.6 };
        let tau = [0.0, 5.0, 9.81, 0.0, 0.0, 0.0];
        let found = if (500..700).contains(&k) {
            estimator.step(&[f64::NAN; 6], &tau)
        } else {
            estimator.step(&[x, 0.0, 0.0, 0.0, 0.0, 0.0], &tau.map(|tau| tau + 1e-9 * f64::from(k % 2)))
        };
        assert!(k < 703 || found.unwrap()[0].abs() < 1e-3, "{k}: {found:?}");
    }
}

/// A gantry whose second joint may have 0.4 N less friction than the model.
struct Doubtful(f64);

impl Body<6> for Doubtful {
    fn torques(&mut self, _: &[f64; 6], _: &[f64; 6], _: &[f64; 6], _: f64) -> [f64; 6] {
        [0.0; 6]
    }

    fn turning(&self) -> [f64; 6] {
        [0.0, self.0, 0.0, 0.0, 0.0, 0.0]
    }

    fn tool(&mut self, q: &[f64; 6]) -> Tool<6> {
        Gantry::tool(q)
    }
}

#[test]
fn what_may_be_friction_is_no_force() {
    let after = |steps: usize, doubt: f64, most: f64, to: f64| {
        let settings = EstimatorSettings {
            period: T,
            corner: 20.0,
            weights: [1.0; 6],
            damping: 1e-9,
            moment: 10.0,
            turning: [most; 6],
            rest: [0.0; 6],
        };
        let mut estimator = Estimator::new(Doubtful(0.0), settings);
        let mut last = None;
        for k in 0..500 + steps {
            if k == 500 {
                estimator.body().0 = doubt;
            }
            last = estimator.step(&[0.0; 6], &[1.0, if k < 500 { 5.0 } else { to }, 0.0, 0.0, 0.0, 0.0]);
        }
        last.map(|w| w[1])
    };
    // As long as a friction reversal takes; the low-pass takes half of it.
    let told = |doubt: f64, most: f64, to: f64| after(100, doubt, most, to);
    let near = |found: Option<f64>, wanted: f64, to: f64| {
        let off = (found.unwrap() - wanted) / (to - wanted);
        assert!((0.0..0.25).contains(&off), "{found:?} {wanted} {to}");
    };
    let is = |found: Option<f64>, wanted: f64| assert!((found.unwrap() - wanted).abs() < 1e-3, "{found:?} {wanted}");
    // Friction that is 0.4 N below the model's is a force up to 0.4 N above the reported one, and
    // not below it.
    near(told(-0.4, 1.0, 4.7), 5.0, 4.7);
    near(told(-0.4, 1.0, 4.0), 4.4, 4.0);
    is(told(-0.4, 1.0, 5.3), 5.3);
    near(told(0.4, 1.0, 5.3), 5.0, 5.3);
    is(told(0.4, 1.0, 4.7), 4.7);
    // Limited by the setting, and zero without uncertainty.
    near(told(-0.4, 0.1, 4.7), 4.8, 4.7);
    is(told(-0.4, 0.0, 4.7), 4.7);
    is(told(0.0, f64::INFINITY, 4.7), 4.7);
    assert_eq!(told(f64::NAN, 1.0, 4.7), None);
    // A contact is lost while a joint's friction is uncertain and could explain all of the force.
    let lost = after(3000, -8.0, f64::INFINITY, 0.0).unwrap();
    assert!(lost.abs() < 0.05, "{lost}");
}

/// Seven prismatic joints, two of them along x.
struct Twice;

impl Body<7> for Twice {
    fn torques(&mut self, _: &[f64; 7], _: &[f64; 7], _: &[f64; 7], _: f64) -> [f64; 7] {
        [0.0; 7]
    }

    fn tool(&mut self, _: &[f64; 7]) -> Tool<7> {
        let mut jacobian = [[0.0; 7]; 6];
        (0..6).for_each(|k| jacobian[k][k] = 1.0);
        jacobian[0][6] = 1.0;
        Tool { origin: [0.0; 3], rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], jacobian }
    }
}

/// Directions that no joint moves depend on the damping alone, a share of the mean of the diagonal.
#[test]
fn what_no_joint_moves_is_damped() {
    let mut jacobian = [[0.0; 6]; 6];
    (jacobian[0][0], jacobian[2][1]) = (1.0, 2.0);
    let weights = [2.0, 1.0, 1.0, 1.0, 1.0, 1.0];
    let right = [1.0, -2.0, 3.0, 0.5, 0.0, 4.0];
    // J W J' has 2 and 4 on its diagonal.
    let added = 1e-3 * 6.0 / 6.0;
    let own = [2.0, 0.0, 4.0, 0.0, 0.0, 0.0];
    let found = damped(&jacobian, &weights, &right, 1e-3).unwrap();
    for i in 0..6 {
        assert!((found[i] * (own[i] + added) - right[i]).abs() < 1e-9, "{found:?}");
    }
    assert!(damped(&jacobian, &weights, &right, 0.0).is_none());
}

/// If joints disagree, the estimate is their weighted mean.
#[test]
fn joints_count_by_their_weights() {
    let mut weights = [1.0; 7];
    weights[6] = 3.0;
    let settings = EstimatorSettings {
        period: T,
        corner: 20.0,
        weights,
        damping: 1e-9,
        moment: 10.0,
        turning: [0.0; 7],
        rest: [0.0; 7],
    };
    let mut estimator = Estimator::new(Twice, settings);
    let mut last = None;
    for _ in 0..4000 {
        last = estimator.step(&[0.0; 7], &[5.0, 0.0, 0.0, 0.0, 0.0, 0.0, 9.0]);
    }
    assert!((last.unwrap()[0] - 8.0).abs() < 1e-3, "{last:?}");
}

/// A moment is limited by its prior: half of it where both have equal weight.
#[test]
fn a_moment_is_weighed_against_its_prior() {
    let told = |moment: f64| {
        let settings = EstimatorSettings {
            period: T,
            corner: 20.0,
            weights: [1.0; 6],
            damping: 1e-9,
            moment,
            turning: [0.0; 6],
            rest: [0.0; 6],
        };
        let mut estimator = Estimator::new(Doubtful(0.0), settings);
        let last = (0..4000).filter_map(|_| estimator.step(&[0.0; 6], &[0.0, 0.0, 0.0, 0.8, 0.0, 0.0])).last();
        last.unwrap()[3]
    };
    for (moment, share) in [(1.0, 0.5), (f64::INFINITY, 1.0), (0.0, 0.0), (0.5, 0.2)] {
        assert!((told(moment) - 0.8 * share).abs() < 1e-3, "{moment} {}", told(moment));
    }
}

/// A gantry whose first joint holds up to 1 N by static friction.
struct Sticky;

impl Body<6> for Sticky {
    fn torques(&mut self, _: &[f64; 6], _: &[f64; 6], _: &[f64; 6], _: f64) -> [f64; 6] {
        [0.0; 6]
    }

    fn static_friction(&self) -> [[f64; 2]; 6] {
        let mut all = [[0.0; 2]; 6];
        all[0] = [-1.0, 1.0];
        all
    }

    fn tool(&mut self, q: &[f64; 6]) -> Tool<6> {
        Gantry::tool(q)
    }
}

#[test]
fn at_rest_friction_is_no_force() {
    let settings = |rest: f64| EstimatorSettings {
        period: T,
        corner: 20.0,
        weights: [1e4; 6],
        damping: 1e-9,
        moment: 10.0,
        turning: [0.0; 6],
        rest: [rest; 6],
    };
    // Wrench at the end of each period of 2 s: static friction, a push of 5 N, the part that
    // friction retains, and a push in a direction without stiction.
    let told = |rest: f64| {
        let mut estimator = Estimator::new(Sticky, settings(rest));
        let mut noise = 1.0;
        [[0.8, 0.0], [5.0, 0.0], [-0.6, 0.0], [0.3, 2.0]].map(|[x, y]| {
            let mut last = [0.0; 6];
            for _ in 0..2000 {
                noise = -noise;
                let q = [1e-5 * noise, 0.0, 1e-5 * noise, 0.0, 0.0, 0.0];
                last = estimator.step(&q, &[x + 0.01 * noise, y + 0.01 * noise, 0.0, 0.0, 0.0, 0.0]).unwrap_or(last);
            }
            ([last[0], last[1]], estimator.friction_alone())
        })
    };
    let near = |([x, y], friction): ([f64; 2], bool), wanted: [f64; 2], alone: bool| {
        assert!((x - wanted[0]).abs() < 0.05 && (y - wanted[1]).abs() < 0.05, "{x} {y} {wanted:?}");
        assert_eq!(friction, alone, "{wanted:?}");
    };
    let [friction, push, kept, aside] = told(1e-4);
    near(friction, [0.0, 0.0], true);
    near(push, [5.0, 0.0], false);
    near(kept, [0.0, 0.0], true);
    near(aside, [0.3, 2.0], false);
    // Joints that never stand: every torque is a force.
    near(told(0.0)[2], [-0.6, 0.0], false);
}

/// Output of the law's estimator along a log: times (s), wrenches (N, N m), and whether friction
/// alone explains the torques. `held`: each row is a pose that is held for a second.
type Along<const N: usize> = Vec<(f64, [f64; 6], bool)>;

/// Runs the estimator with a robot file of the repository on a recording, if it is available
/// (`shared/data`); `scale` converts the columns `torque` to N m.
fn along<const N: usize>(robot: &str, log: &str, torque: &str, scale: [f64; N], held: usize) -> Option<Along<N>> {
    use denavit::control::robot::{RobotModel, STANDING};
    use denavit::model::interpreted::Interpreted;
    use dh_codegen::robot::{Effects, Robot, no_files};
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/");
    let csv = std::fs::read_to_string(format!("{root}../shared/data/{log}")).ok()?;
    let text = std::fs::read_to_string(format!("{root}robots/{robot}.yaml")).unwrap();
    let robot = Robot::from_yaml(&text, &no_files).unwrap().robot;
    let arm = Interpreted::new(&robot, &Interpreted::BODIES);
    let standard = dh_codegen::arm::param::standard_values(&robot).unwrap();
    let drives = denavit::simulate::Simulator::new(&robot, &Effects::default()).unwrap().drives().to_vec();
    let body = RobotModel::new(&robot, Box::new(arm.bodies(&standard)), None, drives);
    let mut rows = csv.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let head = rows.next().unwrap();
    let column = |name: String| head.iter().position(|h| *h == name).unwrap();
    let places: [[usize; 2]; N] =
        std::array::from_fn(|j| [column(format!("q{}", j + 1)), column(format!("{torque}{}", j + 1))]);
    let samples: Vec<(f64, [f64; N], [f64; N])> = rows
        .map(|row| {
            let number = |at: usize| row[at].parse::<f64>().unwrap();
            let of = |k: usize| std::array::from_fn::<f64, N, _>(|j| number(places[j][k]));
            (number(0), of(0), std::array::from_fn(|j| scale[j] * of(1)[j]))
        })
        .collect();
    let period = if held > 1 { 1.0 / held as f64 } else { samples[samples.len() - 1].0 / (samples.len() - 1) as f64 };
    let settings = EstimatorSettings {
        period,
        corner: 5.0_f64.min(0.2 / period),
        weights: robot
            .moving()
            .iter()
            .map(|&r| (0.005 * robot.joints[r].limits.torque.unwrap()).powi(-2))
            .collect::<Vec<f64>>()
            .try_into()
            .unwrap(),
        damping: 1e-4,
        moment: 10.0,
        turning: [f64::INFINITY; N],
        rest: [STANDING; N],
    };
    let mut estimator = Estimator::new(body, settings);
    let mut found = Vec::new();
    for (t, q, tau) in &samples {
        for k in 0..held {
            if let Some(wrench) = estimator.step(q, tau) {
                found.push((*t + k as f64 * period, wrench, estimator.friction_alone()));
            }
        }
    }
    Some(found)
}

/// A UR10e at rest is pushed by hand four times. No force is reported before the first push, each
/// push is reported, and half a minute after it there is none, though friction retains a part of
/// the currents.
#[test]
fn pushes_on_a_standing_arm() {
    let gains = [10.0, 10.6956, 8.4566, 9.0029, 9.48, 10.1232];
    let Some(found) = along::<6>("ur10e", "ur10e-pushed/static_hand_push.csv", "i", gains, 1) else { return };
    let size = |w: &[f64; 6]| w[..3].iter().map(|x| x * x).sum::<f64>().sqrt();
    let between = |from: f64, to: f64| found.iter().filter(move |(t, ..)| (from..to).contains(t));
    for (from, to) in [(1.5, 2.6), (8.0, 11.0), (18.0, 25.0), (33.0, 37.9), (44.5, 45.2)] {
        let most = between(from, to).map(|(_, w, _)| size(w)).fold(0.0, f64::max);
        assert!(most < 3.0 && between(from, to).all(|(.., friction)| *friction), "{from} {to}: {most} N");
    }
    for (from, to) in [(3.7, 5.3), (12.0, 15.5), (25.8, 30.8), (39.0, 42.5)] {
        let least = between(from, to).map(|(_, w, _)| size(w)).fold(f64::INFINITY, f64::min);
        assert!(least > 15.0, "{from} {to}: {least} N");
    }
}

#[test]
#[ignore = "prints what the estimator says along recordings in which nothing touches"]
fn recordings_without_contact() {
    let print = |name: &str, found: &[(f64, [f64; 6], bool)]| {
        let quiet = found.iter().filter(|f| f.2).count() as f64 / found.len() as f64;
        let rms: [f64; 6] =
            std::array::from_fn(|i| (found.iter().map(|f| f.1[i] * f.1[i]).sum::<f64>() / found.len() as f64).sqrt());
        eprintln!("{name}: {} samples, friction alone in {:.1} %, rms {rms:.2?}", found.len(), 100.0 * quiet);
    };
    for (log, held) in
        [("static_j5toj7_50poses", 100), ("static_j2toj4_896poses", 100), ("friction_j2_v0.30", 1), ("motion_j3j4", 1)]
    {
        if let Some(found) = along::<7>("kuka-iiwa14", &format!("kuka-iiwa14/{log}.csv"), "tau", [1.0; 7], held) {
            print(log, &found);
        }
    }
    if let Some(found) = along::<7>("franka-panda", "franka-panda/exciting.csv", "tau", [1.0; 7], 1) {
        print("panda", &found);
    }
    let gains = [10.0, 10.6956, 8.4566, 9.0029, 9.48, 10.1232];
    if let Some(found) = along::<6>("ur10e", "ur10e-pushed/static_hand_push.csv", "i", gains, 1) {
        for f in found.iter().step_by(50) {
            eprintln!("{:.2} {:.1?} {}", f.0, f.1, f.2);
        }
    }
}

/// Arbitrary values, often plausible ones.
fn number(size: f64) -> impl Strategy<Value = f64> {
    prop_oneof![
        6 => -size..size,
        1 => prop::num::f64::ANY,
        1 => prop_oneof![Just(f64::NAN), Just(f64::INFINITY), Just(f64::MAX), Just(f64::MIN_POSITIVE), Just(-0.0)],
    ]
}

proptest! {
    #[test]
    fn torques_are_finite_and_inside_their_limits(
        steps in prop::collection::vec((number(0.01), prop::array::uniform6(number(0.5)), number(60.0),
            prop::array::uniform6(number(0.5)), prop::option::of(number(40.0)), any::<[bool; 3]>()), 1..80),
        kd in 0.0..1e6_f64,
        carry in 0.0..1.0_f64,
        ki in 0.0..1e3_f64,
    ) {
        let mut settings = settings();
        settings.joints.kd = [kd; 6];
        (settings.carry, settings.feed, settings.aside, settings.drag) = (carry, carry, carry, carry);
        (settings.force.ki, settings.force.kp) = (ki, ki);
        let mut controller = Controller::new(Gantry::default(), settings).unwrap();
        let mut estimator = Estimator::new(
            Gantry::default(),
            EstimatorSettings { period: T, corner: 20.0, weights: [1.0; 6], damping: 1e-6, moment: 1.0, turning: [1.0; 6], rest: [1e-4; 6] },
        );
        let mut t = 0.0;
        for (dt, q, force, wanted, press, [dumb, lost, reset]) in steps {
            t += if dt.abs() < 0.01 { T } else { dt };
            *controller.model() = Gantry { dumb, lost, ..Gantry::default() };
            let target = Target { dq: wanted, ddq: q, ..Target::at(wanted, [1.0, 0.0, 0.0], press) };
            let command = controller.step(&target, &Sample { t, q, force, push: [force, q[0], wanted[1]] });
            prop_assert!(command.torque.iter().all(|x| x.is_finite() && x.abs() <= 100.0), "{command:?}");
            prop_assert!((-0.02..=0.2).contains(&command.displacement), "{command:?}");
            if let Some(wrench) = estimator.step(&q, &wanted) {
                prop_assert!(wrench.iter().all(|x| x.is_finite()));
            }
            if reset && lost && dumb {
                controller.reset();
            }
        }
    }
}

/// The files of the law, compiled as a separate crate.
#[test]
fn it_needs_nothing_but_core() {
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/src/control");
    let out = std::env::temp_dir().join(format!("denavit-law-{}", std::process::id()));
    std::fs::create_dir_all(&out).unwrap();
    let crate_root = out.join("lib.rs");
    let text =
        format!("#![no_std]\n#![deny(unsafe_code)]\n#[path = \"{root}\"]\npub mod control {{\n    pub mod law;\n}}\n");
    std::fs::write(&crate_root, text).unwrap();
    let rustc = std::env::var("RUSTC").unwrap_or_else(|_| "rustc".into());
    let result = std::process::Command::new(rustc)
        .args(["--edition", "2024", "--crate-type", "rlib", "--emit", "metadata", "--crate-name", "bare", "--out-dir"])
        .arg(&out)
        .arg(&crate_root)
        .output()
        .unwrap();
    std::fs::remove_dir_all(&out).unwrap();
    assert!(result.status.success(), "{}", String::from_utf8_lossy(&result.stderr));
}
