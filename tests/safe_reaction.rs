//! Tests of the controller's safe reaction, including cases that once defeated it.

mod gantry;

use denavit::control::law::{Bounds, Command, Controller, Fault, Sample, Settings, Status, Target};
use gantry::{Gantry, T, World, pressing, settings, target};

/// Tangential speed at which an undamped arm coasts, m/s.
const COASTS: f64 = 0.49;

fn fastest(world: &World) -> f64 {
    world.v.iter().fold(0.0, |most, v| most.max(v.abs()))
}

fn is_fault(status: Status) -> bool {
    !matches!(status, Status::Free | Status::Approaching | Status::Pressing | Status::Lost | Status::Holding)
}

/// Continues with modified samples; returns the largest torque and the last status.
fn go_on(
    controller: &mut Controller<Gantry, 6>,
    world: &mut World,
    steps: u32,
    mut hurt: impl FnMut(u32, &mut Sample<6>),
) -> (f64, Status) {
    let (mut most, mut status) = (0.0_f64, Status::Free);
    for k in 0..steps {
        let mut sample = world.sample();
        hurt(k, &mut sample);
        let command = controller.step(&target(), &sample);
        most = command.torque.iter().enumerate().filter(|(j, _)| *j != 2).fold(most, |m, (_, t)| m.max(t.abs()));
        status = command.status;
        world.run(&command);
    }
    (most, status)
}

#[test]
fn a_sample_stamped_ahead_leaves_the_arm_damped() {
    let (mut controller, mut world) = pressing();
    world.v[1] = COASTS;
    let (_, status) = go_on(&mut controller, &mut world, 2000, |k, sample| sample.t += if k == 0 { 10.0 } else { 0.0 });
    assert!(is_fault(status), "{status:?}");
    assert!(fastest(&world) < 0.01, "{:?}", world.v);
}

/// The joint loop only provides damping: 40 N s/m.
#[test]
fn a_stop_damps_with_the_gain_of_the_joint_loop() {
    let (mut controller, mut world) = pressing();
    go_on(&mut controller, &mut world, 1, |_, sample| sample.t += 10.0);
    world.v[1] = COASTS;
    let still = Command { torque: [0.0, 0.0, 9.81, 0.0, 0.0, 0.0], ..controller.step(&target(), &world.sample()) };
    world.run(&still);
    let command = controller.step(&target(), &world.sample());
    assert!((command.torque[1] + 40.0 * COASTS).abs() < 0.1, "{command:?}");
}

#[test]
fn a_clock_set_back_leaves_the_arm_damped() {
    let (mut controller, mut world) = pressing();
    world.v[1] = COASTS;
    let (_, status) = go_on(&mut controller, &mut world, 2000, |_, sample| sample.t -= 6.0);
    assert!(is_fault(status), "{status:?}");
    assert!(fastest(&world) < 0.01, "{:?}", world.v);
}

#[test]
fn a_model_that_gives_no_numbers_for_good_stops_the_arm() {
    let (mut controller, mut world) = pressing();
    world.v[1] = COASTS;
    controller.model().dumb = true;
    let (_, status) = go_on(&mut controller, &mut world, 2000, |_, _| {});
    assert!(is_fault(status), "{status:?}");
    assert!(fastest(&world) < 0.01, "{:?}", world.v);
}

#[test]
fn frozen_positions_under_a_moving_plan_stop_the_arm() {
    let mut controller = Controller::new(Gantry::default(), settings()).unwrap();
    let mut world = World { wall: false, ..World::new() };
    let (mut most, mut status, mut frozen) = (0.0_f64, Status::Free, None);
    for k in 0..2000 {
        let t = T * f64::from(k);
        let mut target = target();
        (target.force, target.q[1], target.dq[1]) = (None, 0.2 * t, 0.2);
        let mut sample = world.sample();
        if k >= 500 {
            sample.q = *frozen.get_or_insert(sample.q);
        }
        let command = controller.step(&target, &sample);
        most = most.max(command.torque[1].abs());
        status = command.status;
        world.run(&command);
    }
    assert!(is_fault(status), "{status:?}");
    assert!(most < 25.0, "{most}");
}

#[test]
fn a_force_that_is_stuck_does_not_push_to_the_end_of_the_range() {
    let (mut controller, mut world) = pressing();
    let mut most = 0.0_f64;
    let mut status = Status::Free;
    for _ in 0..5000 {
        let command = controller.step(&target(), &Sample { force: 10.0, ..world.sample() });
        status = command.status;
        world.run(&command);
        most = most.max(world.force());
    }
    assert!(is_fault(status), "{status:?}");
    assert!(most < 35.0, "{most}");
}

#[test]
fn one_target_with_an_impossible_acceleration_is_not_followed() {
    let mut controller = Controller::new(Gantry::default(), Settings { feed: 1.0, ..settings() }).unwrap();
    let mut world = World::new();
    for _ in 0..6000 {
        let command = controller.step(&target(), &world.sample());
        world.run(&command);
    }
    let before = controller.step(&target(), &world.sample());
    world.run(&before);
    let mut wrong = target();
    wrong.ddq[1] = 1e9;
    let command = controller.step(&wrong, &world.sample());
    assert!((command.torque[1] - before.torque[1]).abs() < 1.0, "{:?}", command.torque);
}

/// Checks that a stopped arm comes to rest, requests the brakes, and does not press again.
fn assert_stopped(controller: &mut Controller<Gantry, 6>, world: &mut World, fault: Fault) {
    let Bounds { leave, stop, .. } = *controller.bounds();
    let (_, status) = go_on(controller, world, leave + stop + 2, |_, _| {});
    assert_eq!(status, Status::Stopped(fault));
    assert!(status.brakes() && fastest(world) < 0.02, "{fault:?} {:?}", world.v);
    controller.reset();
    let (_, status) = go_on(controller, world, 6000, |_, _| {});
    assert_eq!(status, Status::Pressing, "{fault:?}");
}

/// Runs until there is a fault; returns the number of steps and the status.
fn until_fault(
    controller: &mut Controller<Gantry, 6>,
    world: &mut World,
    steps: u32,
    mut hurt: impl FnMut(u32, &mut Target<6>, &mut Sample<6>),
) -> (u32, Status) {
    for k in 0..steps {
        let (mut target, mut sample) = (target(), world.sample());
        hurt(k, &mut target, &mut sample);
        let command = controller.step(&target, &sample);
        world.run(&command);
        if command.status.fault().is_some() {
            return (k + 1, command.status);
        }
    }
    (steps, Status::Free)
}

#[test]
fn clocks_that_run_apart_are_found() {
    for (rate, expected) in [(1.05, None), (0.95, None), (1.1, Some(Fault::Clock)), (0.9, Some(Fault::Clock))] {
        let (mut controller, mut world) = pressing();
        let start = world.t;
        let found = until_fault(&mut controller, &mut world, 2000, |_, _, sample| {
            sample.t = start + rate * (sample.t - start);
        });
        assert_eq!(found.1.fault(), expected, "{rate} {found:?}");
    }
}

#[test]
fn too_many_bad_samples_are_no_connection() {
    // A third of the samples may be bad permanently, but not half of them.
    for (each, expected) in [(4, None), (2, Some(Fault::Position))] {
        let (mut controller, mut world) = pressing();
        let found = until_fault(&mut controller, &mut world, 3000, |k, _, sample| {
            if k % each == 0 {
                sample.q[3] = f64::NAN;
            }
        });
        assert_eq!(found.1.fault(), expected, "{each} {found:?}");
    }
}

#[test]
fn a_source_that_repeats_its_last_sample_is_not_heard_in_a_stop() {
    let (mut controller, mut world) = pressing();
    let dead = world.sample();
    let found = until_fault(&mut controller, &mut world, 20, |_, _, sample| *sample = dead);
    assert_eq!(found, (7, Status::Stopped(Fault::Position)));
    let (torque, _) = go_on(&mut controller, &mut world, 10, |_, sample| *sample = dead);
    assert_eq!(torque, 0.0, "gravity alone");
}

/// A controller with changed limits.
fn limited(change: impl FnOnce(&mut Settings<6>)) -> (Controller<Gantry, 6>, World) {
    let mut settings = settings();
    change(&mut settings);
    let mut controller = Controller::new(Gantry::default(), settings).unwrap();
    let mut world = World::new();
    let (_, status) = go_on(&mut controller, &mut world, 6000, |_, _| {});
    assert_eq!(status, Status::Pressing);
    (controller, world)
}

#[test]
fn a_joint_beyond_its_range_is_stopped() {
    let (mut controller, mut world) = limited(|s| s.limits.position[1] = [-0.1, 0.1]);
    // It may be outside by a fiftieth of the range: 4 mm.
    let found = until_fault(&mut controller, &mut world, 400, |k, _, sample| {
        sample.q[1] = 1e-3 * f64::from(k.min(200));
    });
    assert_eq!(found, (106, Status::Stopping(Fault::Joint)));
    // The arm was driven away while its sensor read otherwise: faster than plausible, and damped.
    let (_, status) = go_on(&mut controller, &mut world, 2000, |_, _| {});
    assert!(status == Status::Stopped(Fault::Joint) && fastest(&world) < 0.01, "{status:?} {:?}", world.v);
    // Targets outside are not followed, to either side.
    for outside in [0.101_f64, -0.101] {
        let (mut controller, mut world) = limited(|s| s.limits.position[1] = [-0.1, 0.1]);
        // At half of the speed limit, to 1 mm beyond.
        let found = until_fault(&mut controller, &mut world, 300, |k, target, _| {
            target.q[1] = outside.signum() * (5e-4 * f64::from(k)).min(outside.abs());
        });
        assert_eq!(found, (207, Status::Leaving(Fault::Plan)), "{outside}");
    }
}

#[test]
fn postures_beyond_the_range_are_not_gone_to() {
    // 30 N deflect the joint loop's spring by 75 mm: the target is inside, displaced it is not.
    let mut settings = settings();
    settings.limits.position[0] = [-1.0, 0.05];
    let mut controller = Controller::new(Gantry::default(), settings).unwrap();
    let (mut world, mut most, mut seen) = (World::new(), 0.0_f64, Status::Waiting);
    for _ in 0..8000 {
        let command = controller.step(&target(), &world.sample());
        (most, seen) = (most.max(command.desired[0]), command.status);
        world.run(&command);
    }
    assert!(most <= 0.05 && most > 0.049, "{most}");
    assert_eq!(seen, Status::Stopped(Fault::Reach));
}

#[test]
fn a_joint_that_is_too_fast_is_stopped() {
    for (speed, expected) in [(1.4, None), (1.6, Some(Fault::Speed))] {
        let (mut controller, mut world) = pressing();
        let found = until_fault(&mut controller, &mut world, 40, |k, _, sample| sample.q[1] = speed * T * f64::from(k));
        assert_eq!(found.1.fault(), expected, "{speed} {found:?}");
    }
}

#[test]
fn torques_at_their_limits_for_long_are_a_fault() {
    // At 80 mm the spring requires 32 N.
    let (mut controller, mut world) = limited(|s| s.torque[1] = 20.0);
    let found = until_fault(&mut controller, &mut world, 400, |_, target, _| target.q[1] = 0.0);
    assert_eq!(found.1.fault(), None);
    let held = world.q;
    let found = until_fault(&mut controller, &mut world, 400, |k, target, sample| {
        target.q[1] = (1e-3 * f64::from(k + 1)).min(0.08);
        // Blocked, but not frozen.
        sample.q = held;
        sample.q[1] += if k % 2 == 0 { 1e-5 } else { -1e-5 };
    });
    assert_eq!(found.1, Status::Stopping(Fault::Torque));
    assert!((100..250).contains(&found.0), "{found:?}");
}

#[test]
fn torques_change_no_faster_than_their_limit() {
    let (mut controller, mut world) = limited(|s| s.limits.torque_rate = [1e3; 6]);
    let mut last = controller.step(&target(), &world.sample());
    world.run(&last);
    let mut most = 0.0_f64;
    for k in 0..300 {
        let mut sample = world.sample();
        if k > 5 {
            sample.q[4] = f64::NAN;
        }
        let command = controller.step(&target(), &sample);
        for j in 0..6 {
            most = most.max((command.torque[j] - last.torque[j]).abs());
        }
        last = command;
        world.run(&command);
    }
    assert_eq!(last.status, Status::Stopped(Fault::Position));
    assert!(most <= 1.0 + 1e-9 && most > 0.99, "{most}");
}

#[test]
fn a_plan_beyond_its_limits_is_not_followed() {
    type Change = fn(u32, &mut Target<6>);
    let wrong: [Change; 6] = [
        |_, target| target.dq[1] = 1.1,
        |_, target| target.ddq[1] = 11.0,
        // Within the limit of acceleration, beyond that of jerk.
        |k, target| target.ddq[1] = if k % 2 == 0 { 8.0 } else { -8.0 },
        |_, target| target.q[1] = f64::NAN,
        // The tool: 1 m/s along two axes each is within 2 m/s; a jump exceeds the acceleration.
        |_, target| (target.dq[0], target.dq[1]) = (1.0, 1.0),
        |k, target| target.ahead = 0.02 * f64::from(k + 1),
    ];
    for (which, change) in wrong.into_iter().enumerate() {
        let (mut controller, mut world) = pressing();
        // Each target is rejected once, without a fault.
        let found = until_fault(&mut controller, &mut world, 300, |k, target, _| {
            if k % 3 == 0 {
                change(0, target);
            }
        });
        assert_eq!(found.1.fault(), None, "{which}");
        assert!((world.force() - 30.0).abs() < 0.1 && world.q[1].abs() < 1e-6, "{which} {}", world.force());
        let found = until_fault(&mut controller, &mut world, 20, |k, target, _| change(k, target));
        assert_eq!(found, (6, Status::Leaving(Fault::Plan)), "{which}");
        assert_stopped(&mut controller, &mut world, Fault::Plan);
    }
}

/// Jerk is the change of the acceleration: a smoothly reached acceleration may persist.
#[test]
fn a_steady_acceleration_has_no_jerk() {
    let (mut controller, mut world) = pressing();
    let found = until_fault(&mut controller, &mut world, 300, |k, target, _| {
        // 900 m/s^3 for 10 ms, 9 m/s^2 for 50 ms, and back in the same way.
        let after = |begin: f64| (T * f64::from(k) - begin).max(0.0);
        let rises = [(0.0, 900.0), (0.01, -900.0), (0.06, -900.0), (0.07, 900.0)];
        let sum = |f: fn(f64) -> f64| rises.iter().map(|(begin, jerk)| jerk * f(after(*begin))).sum::<f64>();
        target.q[1] = sum(|t| t * t * t / 6.0);
        target.dq[1] = sum(|t| 0.5 * t * t);
        target.ddq[1] = sum(|t| t);
    });
    assert_eq!(found.1.fault(), None, "{found:?}");
    assert!(world.q[1] > 0.05, "{:?}", world.q);
}

#[test]
fn the_tool_has_limits_of_its_own() {
    let (mut controller, mut world) = limited(|s| s.limits.tool = [0.5, 20.0, 2e3]);
    // Each joint within 1 m/s, the tool within 0.5 m/s, reached smoothly.
    let mut reached = 0.0;
    let found = until_fault(&mut controller, &mut world, 2000, |k, target, _| {
        let speed = 0.5 * T * f64::from(k);
        (target.q[1], target.dq[1], target.ddq[1]) = (0.25 * (T * f64::from(k)).powi(2), speed, 0.5);
        reached = speed;
    });
    assert_eq!(found.1, Status::Leaving(Fault::Plan));
    assert!((reached - 0.5).abs() < 0.01, "{reached}");
    // A speed jump of 1 cm/s in a period is within the acceleration, but beyond the jerk.
    for (jerk, expected) in [(2e4, None), (2e2, Some(Fault::Plan))] {
        let (mut controller, mut world) = limited(|s| s.limits.tool = [0.5, 20.0, jerk]);
        let found = until_fault(&mut controller, &mut world, 40, |k, target, _| {
            target.dq[1] = if k > 20 { 0.01 } else { 0.0 };
        });
        assert_eq!(found.1.fault(), expected, "{found:?}");
    }
}

#[test]
fn without_a_posture_for_long_it_leaves() {
    let (mut controller, mut world) = pressing();
    controller.model().lost = true;
    let found = until_fault(&mut controller, &mut world, 2000, |_, _, _| {});
    assert_eq!(found.1, Status::Leaving(Fault::Reach));
    assert!((500..510).contains(&found.0), "{found:?}");
}

#[test]
fn a_push_aside_that_is_too_large_makes_it_leave() {
    let (mut controller, mut world) = pressing();
    let found = until_fault(&mut controller, &mut world, 20, |_, _, sample| sample.push = [0.0, 60.0, -60.0]);
    assert_eq!(found, (6, Status::Leaving(Fault::Excess)));
    // In free motion there is no wall to leave.
    let (mut controller, mut world) = pressing();
    let found = until_fault(&mut controller, &mut world, 20, |_, target, sample| {
        (target.force, sample.push) = (None, [0.0, 60.0, -60.0]);
    });
    assert_eq!(found.1, Status::Stopping(Fault::Excess));
}

#[test]
fn too_little_force_at_the_end_of_the_range_is_given_up() {
    // A contact force that changes with each sample but never rises.
    let (mut controller, mut world) = pressing();
    let found = until_fault(&mut controller, &mut world, 10_000, |k, _, sample| {
        sample.force = 10.0 + 1e-3 * f64::from(k % 2);
    });
    assert_eq!(found.1, Status::Leaving(Fault::Contact));
    assert_stopped(&mut controller, &mut world, Fault::Contact);
}

#[test]
fn a_stop_goes_along_the_path() {
    // A circle of 0.2 m in the y-z plane at 0.6 rad/s, on which the force sensor fails.
    let mut controller = Controller::new(Gantry::default(), Settings { feed: 1.0, ..settings() }).unwrap();
    let mut world = World { wall: false, ..World::new() };
    let circle = |t: f64| {
        // Accelerates within a second.
        let (angle, speed, change) = if t < 1.0 {
            (0.6 * (t * t * t - 0.5 * t * t * t * t), 0.6 * t * t * (3.0 - 2.0 * t), 3.6 * t * (1.0 - t))
        } else {
            (0.6 * (t - 0.5), 0.6, 0.0)
        };
        let (s, c) = angle.sin_cos();
        let mut target = Target::at([0.0, 0.2 * s, 0.2 * (1.0 - c), 0.0, 0.0, 0.0], [1.0, 0.0, 0.0], None);
        (target.dq[1], target.dq[2]) = (0.2 * c * speed, 0.2 * s * speed);
        (target.ddq[1], target.ddq[2]) =
            (0.2 * (c * change - s * speed * speed), 0.2 * (s * change + c * speed * speed));
        target
    };
    let (mut off, mut status, mut fastest_turn, mut last) = (0.0_f64, Status::Free, 0.0_f64, 0.0);
    for k in 0..3500 {
        let t = T * f64::from(k);
        let mut sample = world.sample();
        if k >= 2000 {
            sample.push = [0.0, 90.0, 0.0];
        }
        let command = controller.step(&circle(t), &sample);
        status = command.status;
        world.run(&command);
        let radius = world.q[1].hypot(0.2 - world.q[2]);
        off = off.max((radius - 0.2).abs());
        if k > 2050 {
            fastest_turn = fastest_turn.max((world.v[1] - last).abs() / T);
        }
        last = world.v[1];
    }
    assert_eq!(status, Status::Stopped(Fault::Excess));
    assert!(off < 1e-5, "{off}");
    assert!(fastest(&world) < 1e-3 && fastest_turn < 2.0, "{:?} {fastest_turn}", world.v);
}

/// Each failure is harmless once, and none occurs more often in a row than the patience.
#[test]
fn what_fails_most_of_the_time_is_a_fault() {
    type Fail = fn(&mut Controller<Gantry, 6>, &mut Target<6>, &mut Sample<6>, bool);
    let fails: [(Fault, Fail); 3] = [
        (Fault::Model, |controller, _, _, fails| controller.model().dumb = fails),
        (Fault::Plan, |_, target, _, fails| target.dq[1] = if fails { f64::NAN } else { 0.0 }),
        (Fault::Force, |_, _, sample, fails| {
            if fails {
                sample.force = f64::NAN;
            }
        }),
    ];
    for (fault, fail) in fails {
        // A quarter of the steps may fail permanently, but not five of six.
        for (good, expected) in [(3, None), (0, Some(fault))] {
            let (mut controller, mut world) = pressing();
            let mut found = None;
            for k in 0..2000_u32 {
                let (mut target, mut sample) = (target(), world.sample());
                let fails = if good == 3 { k % 4 == 0 } else { k % 6 != 0 };
                fail(&mut controller, &mut target, &mut sample, fails);
                let command = controller.step(&target, &sample);
                found = command.status.fault();
                world.run(&command);
            }
            assert_eq!(found, expected, "{fault:?}");
        }
    }
}

/// A broken track of an encoder: every other step is off by just a plausible distance.
#[test]
fn a_position_that_leaps_to_and_fro_is_a_fault() {
    let (mut controller, mut world) = pressing();
    let found = until_fault(&mut controller, &mut world, 2000, |k, _, sample| {
        sample.q[1] += if k % 4 < 2 { 2.5e-3 } else { 0.0 };
    });
    assert!(found.1.fault() == Some(Fault::Speed) && found.0 < 100, "{found:?}");
}

/// Largest step of the torques after a change to one target, and the final status.
fn after_one_target(settings: Settings<6>, change: fn(&mut Target<6>)) -> (f64, Status) {
    let mut controller = Controller::new(Gantry::default(), settings).unwrap();
    let mut world = World::new();
    let (mut last, mut most) = ([0.0; 6], 0.0_f64);
    let mut status = Status::Waiting;
    for k in 0..6100 {
        let mut target = target();
        if k == 6000 {
            change(&mut target);
        }
        let command = controller.step(&target, &world.sample());
        if k >= 6000 {
            most = (0..6).fold(most, |most, j| most.max((command.torque[j] - last[j]).abs()));
        }
        (last, status) = (command.torque, command.status);
        world.run(&command);
    }
    (most, status)
}

#[test]
fn one_target_that_leaps_is_not_followed() {
    let fed = Settings { carry: 1.0, feed: 1.0, ..settings() };
    let leaps: [fn(&mut Target<6>); 6] = [
        |target| target.q[1] = 1.0,
        |target| target.q[1] = -2e-3,
        |target| target.dq[1] = 0.5,
        |target| target.normal = [-1.0, 0.0, 0.0],
        |target| target.normal = [0.6, 0.8, 0.0],
        |target| target.force = Some(1e5),
    ];
    for (which, change) in leaps.into_iter().enumerate() {
        for settings in [settings(), fed] {
            let (most, status) = after_one_target(settings, change);
            assert!(most < 0.1 && status == Status::Pressing, "{which}: {most} {status:?}");
        }
    }
}

/// Largest speed, acceleration and jerk of a displacement, by differences over steps without
/// contact.
fn fastest_of(ways: &[(f64, Status)]) -> [f64; 3] {
    let mut most = [0.0_f64; 3];
    for of in ways.windows(4).filter(|of| of.iter().all(|(_, status)| *status != Status::Pressing)) {
        let [a, b, c, d] = [0, 1, 2, 3].map(|k| of[k].0);
        let now = [(d - c) / T, (d - 2.0 * c + b) / (T * T), (d - 3.0 * c + 3.0 * b - a) / (T * T * T)];
        (0..3).for_each(|k| most[k] = most[k].max(now[k].abs()));
    }
    most
}

/// Approach to the wall, a wall that recedes and returns, one that is gone, and the retreat: all
/// displacements that the force loop adds to the plan without contact.
#[test]
fn the_displacement_has_limits_of_acceleration_and_jerk() {
    for [acceleration, jerk] in [[20.0, 2e3], [20.0, f64::INFINITY], [f64::INFINITY, 2e2], [5.0, 3e3]] {
        let settings = {
            let mut settings = Settings { carry: 1.0, ..settings() };
            settings.limits.tool = [2.0, acceleration, jerk];
            (settings.force.kp, settings.limits.force_rate) = (1e-4, f64::INFINITY);
            // A wall that is met again is met at full speed.
            settings.most = 1e3;
            settings
        };
        let mut controller = Controller::new(Gantry::default(), settings).unwrap();
        let (mut world, mut ways) = (World::new(), vec![(0.0, Status::Waiting)]);
        for k in 0..10_000 {
            world.wall = k < 4000 || (4100..7000).contains(&k);
            let command = controller.step(&target(), &world.sample());
            world.run(&command);
            ways.push((command.displacement, command.status));
        }
        let [speed, most, turn] = fastest_of(&ways);
        assert!(speed > 0.099 && speed < 0.1 + 1e-9, "{speed}");
        assert!(most < acceleration + 1e-3 && turn < jerk + 2.0, "{acceleration} {jerk}: {most} {turn}");
        // The limits are used; half of the jerk is for the reversal.
        assert!(most > 0.9 * acceleration || turn > 0.45 * jerk, "{acceleration} {jerk}: {most} {turn}");
        assert_eq!(ways[10_000].1, Status::Stopped(Fault::Contact));
        for state in [Status::Approaching, Status::Pressing, Status::Lost, Status::Leaving(Fault::Contact)] {
            assert!(ways.iter().any(|(_, status)| *status == state), "{state:?}");
        }
    }
}

/// A tool that is to leave the wall goes no deeper, whatever time the acceleration takes, and has
/// the time for it.
#[test]
fn a_tool_that_leaves_goes_no_deeper() {
    let mut settings = settings();
    settings.limits.tool = [2.0, 1.0, f64::INFINITY];
    let mut controller = Controller::new(Gantry::default(), settings).unwrap();
    let mut world = World { wall: false, ..World::new() };
    let (mut deepest, mut last, mut end) = (0.0, 0.0, f64::NAN);
    for k in 0..3000 {
        let mut sample = world.sample();
        sample.force = if k < 500 { sample.force } else { 90.0 + 1e-3 * f64::from(k % 2) };
        let command = controller.step(&target(), &sample);
        world.run(&command);
        match command.status {
            Status::Leaving(_) => {
                assert!(command.displacement <= last + 1e-12, "{last} {command:?}");
                end = command.displacement;
            }
            _ if k < 500 => deepest = command.displacement,
            _ => {}
        }
        last = command.displacement;
    }
    assert!(deepest > 0.03 && end < -0.0199, "{deepest} {end}");
}

/// The limits do not apply in contact: the force reaches 30 N and stays there.
#[test]
fn limits_of_the_displacement_do_not_make_the_loop_swing() {
    for tool in [[2.0, 20.0, 2e3], [2.0, 1.0, 1e3], [f64::INFINITY; 3]] {
        let (mut controller, mut world) = limited(|s| (s.limits.tool, s.force.kp) = (tool, 1e-4));
        for k in 0..3000 {
            let mut sample = world.sample();
            // Some noise, of the size that an estimate has.
            sample.force += if k % 2 == 0 { 0.1 } else { -0.1 };
            let command = controller.step(&target(), &sample);
            assert_eq!(command.status, Status::Pressing);
            world.run(&command);
            assert!((world.force() - 30.0).abs() < 0.2, "{tool:?}: {} N at {k}", world.force());
        }
    }
}

/// An integral that has waited for the displacement does not push it on once the force is reached.
#[test]
fn what_the_displacement_lags_is_not_made_up_for() {
    let (mut controller, mut world) = pressing();
    let mut go_on = |force: f64, count: u32| {
        let mut at = 0.0;
        for k in 0..count {
            // Not frozen, and without a long loss of contact.
            let force = force + 1e-3 * f64::from(k % 2);
            at = controller.step(&target(), &Sample { force, ..world.sample() }).displacement;
            world.t += T;
        }
        at
    };
    let before = go_on(30.0, 1);
    let sent = go_on(3.0, 50);
    let after = go_on(30.0, 200);
    // Desired: 0.27 m/s, 13 mm in all; permitted: 0.1 m/s, 0.25 mm to brake from it, and the mean
    // of 20 steps.
    assert!(sent - before > 3e-3 && after - sent < 1.5e-3, "{before} {sent} {after}");
}

/// A step of 30 N at 100 N/s: a millimetre of the proportional part in 0.1 s.
#[test]
fn a_force_that_leaps_is_come_to_by_its_rate() {
    let mut settings = settings();
    (settings.limits.force_rate, settings.force.kp, settings.force.ki) = (100.0, 1e-4, 0.0);
    let mut controller = Controller::new(Gantry::default(), settings).unwrap();
    let world = World::new();
    let mut way = [0.0; 600];
    for k in 0..600_u32 {
        let target = Target { force: Some(if k < 400 { 30.0 } else { 60.0 }), ..target() };
        let sample = Sample { t: T * f64::from(k), force: 30.0 + 1e-6 * f64::from(k % 2), ..world.sample() };
        way[k as usize] = controller.step(&target, &sample).displacement;
    }
    assert!(way[399].abs() < 1e-6 && (way[499] - 1e-3).abs() < 1e-4, "{} {}", way[399], way[499]);
}

/// Speeds that jump without an acceleration, at a constant position.
#[test]
fn speeds_that_leap_are_not_followed() {
    // The tool has limits of its own, which would detect it as well.
    let (mut controller, mut world) = limited(|s| s.limits.tool = [f64::INFINITY; 3]);
    let found = until_fault(&mut controller, &mut world, 300, |k, target, _| {
        target.dq[1] = if k % 2 == 0 { 0.5 } else { 0.0 };
    });
    assert_eq!(found.1, Status::Leaving(Fault::Plan));
}

/// Three times the speed limit is implausible; less is accepted.
#[test]
fn a_leap_is_no_sample() {
    for (leap, status) in [(2.9e-3, Status::Pressing), (3.1e-3, Status::Holding)] {
        let (mut controller, mut world) = pressing();
        let before = controller.step(&target(), &world.sample());
        world.run(&before);
        let mut sample = world.sample();
        sample.q[1] += leap;
        let command = controller.step(&target(), &sample);
        assert_eq!(command.status, status, "{leap}");
        assert_eq!(command.torque == before.torque, status == Status::Holding);
    }
}

/// Another branch stays as far away as before, however long it is requested.
#[test]
fn another_branch_does_not_come_nearer_in_time() {
    let (mut controller, mut world) = limited(|s| s.give_up = 3.0);
    controller.model().flipped = true;
    for _ in 0..2900 {
        let command = controller.step(&target(), &world.sample());
        world.run(&command);
        assert!(command.desired[3].abs() < 1e-9 && command.status.fault().is_none(), "{command:?}");
    }
    let found = until_fault(&mut controller, &mut world, 200, |_, _, _| {});
    assert_eq!(found.1, Status::Leaving(Fault::Reach));
}

#[test]
fn another_branch_of_the_inverse_is_not_gone_to() {
    let (mut controller, mut world) = pressing();
    controller.model().flipped = true;
    let (torque, _) = go_on(&mut controller, &mut world, 5, |_, _| {});
    assert!(torque < 32.0, "{torque}");
    let found = until_fault(&mut controller, &mut world, 2000, |_, _, _| {});
    assert_eq!(found.1, Status::Leaving(Fault::Reach));
    assert!(world.q[3].abs() < 1e-9, "{:?}", world.q);
    // A single occurrence is harmless.
    let (mut controller, mut world) = pressing();
    controller.model().flipped = true;
    go_on(&mut controller, &mut world, 1, |_, _| {});
    controller.model().flipped = false;
    let (_, status) = go_on(&mut controller, &mut world, 1000, |_, _| {});
    assert_eq!(status, Status::Pressing);
}

/// Gravity that no drive could hold is rejected; the stop uses the last valid one.
#[test]
fn a_model_that_gives_wild_numbers_stops_the_arm() {
    let (mut controller, mut world) = pressing();
    world.v[1] = COASTS;
    controller.model().wild = true;
    let (mut status, mut most) = (Status::Free, 0.0_f64);
    for _ in 0..2000 {
        let command = controller.step(&target(), &world.sample());
        (status, most) = (command.status, most.max(command.torque[2].abs()));
        world.run(&command);
    }
    assert_eq!(status, Status::Stopped(Fault::Model));
    assert!(most < 10.0 && fastest(&world) < 0.01, "{most} {:?}", world.v);
}

/// A xorshift generator of random numbers.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    /// A random integer below `of`.
    fn one(&mut self, of: u64) -> u64 {
        (self.next() >> 11) % of
    }

    /// A random number from -1 to 1.
    fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / 2f64.powi(52) - 1.0
    }

    /// Any bits, often critical values.
    fn any(&mut self) -> f64 {
        match self.one(6) {
            0 => f64::NAN,
            1 => f64::INFINITY,
            2 => -f64::MAX,
            3 => f64::MIN_POSITIVE,
            _ => f64::from_bits(self.next()),
        }
    }
}

/// Applies one kind of temporary failure that the controller must survive.
fn hurt(random: &mut Random, kind: u64, target: &mut Target<6>, sample: &mut Sample<6>, frozen: &Sample<6>) {
    let j = random.one(6) as usize;
    match kind {
        0 => sample.q[j] = random.any(),
        1 => sample.t = random.any(),
        2 => sample.t += 20.0 * T * random.unit(),
        3 => sample.force = random.any(),
        4 => sample.push[j % 3] = random.any(),
        5 => target.q[j] = random.any(),
        6 => target.dq[j] = random.any(),
        7 => target.ddq[j] = random.any(),
        8 => target.normal[j % 3] = random.any(),
        9 => (target.force, target.ahead) = (Some(random.any()), random.any()),
        10 => sample.q = frozen.q,
        11 => sample.force = frozen.force,
        12 => *sample = *frozen,
        13 => sample.q[j] += 2.0 * random.unit(),
        14 => sample.q.iter_mut().for_each(|q| *q += 2e-3 * random.unit()),
        15 => sample.force += 60.0 * random.unit(),
        16 => target.force = None,
        17 => target.q.iter_mut().for_each(|q| *q += random.unit()),
        18 => sample.t -= 6.0,
        _ => sample.t += 10.0,
    }
}

/// A million steps with a failure half of the time, on the simulated gantry. Torques are finite and
/// within their limits of size and rate. A fault ends only with a reset, and the brakes are
/// requested in time. No torque is held for longer than the patience while samples arrive.
#[test]
fn a_million_hostile_steps() {
    const STEPS: u32 = 1_000_000;
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    let mut settings = settings();
    settings.limits.torque_rate = [2e4; 6];
    (settings.carry, settings.feed, settings.aside, settings.drag) = (1.0, 1.0, 0.5, 1.0);
    let mut controller = Controller::new(Gantry::default(), settings).unwrap();
    let Bounds { patience, leave, stop } = *controller.bounds();
    let mut world = World::new();
    let (mut frozen, mut kind, mut left, mut ill) = (world.sample(), 0, 0_u64, false);
    let (mut last, mut since, mut held): (Option<Command<6>>, u32, u32) = (None, 0, 0);
    let mut met = std::collections::HashSet::new();
    for _ in 0..STEPS {
        if left == 0 {
            (kind, ill) = (random.one(22), !ill);
            left = 1 + if random.one(3) == 0 { random.one(1000) } else { random.one(12) };
            frozen = world.sample();
        }
        left -= 1;
        let (mut target, mut sample) = (target(), world.sample());
        let t = world.t;
        (target.q[1], target.dq[1], target.ddq[1]) = (0.1 * t.sin(), 0.1 * t.cos(), -0.1 * t.sin());
        if ill {
            hurt(&mut random, kind, &mut target, &mut sample, &frozen);
        }
        *controller.model() = Gantry { dumb: ill && kind == 20, lost: ill && kind == 21, ..Gantry::default() };
        let command = controller.step(&target, &sample);
        assert!(command.torque.iter().all(|x| x.is_finite() && x.abs() <= 100.0), "{command:?}");
        assert!((-0.02..=0.2).contains(&command.displacement), "{command:?}");
        if let Some(last) = last {
            let step = (0..6).fold(0.0_f64, |most, j| most.max((command.torque[j] - last.torque[j]).abs()));
            assert!(step <= 20.0 + 1e-9, "{last:?} {command:?}");
            assert!(last.status.fault().is_none() || command.status.fault().is_some(), "{last:?} {command:?}");
            assert!(!last.status.brakes() || command.status.brakes(), "{last:?} {command:?}");
            held = if command.torque == last.torque && command.status == Status::Holding { held + 1 } else { 0 };
            assert!(held <= patience, "{command:?}");
        }
        met.insert(command.status);
        since = if command.status.fault().is_some() { since + 1 } else { 0 };
        assert!(since <= leave + stop || command.status.brakes(), "{command:?}");
        last = Some(command);
        world.run(&command);
        let far = world.q.iter().any(|q| q.abs() > 1.0);
        if far || (command.status.brakes() && random.one(300) == 0) {
            controller.reset();
            world = World { t: world.t, ..World::new() };
            (last, since, held) = (None, 0, 0);
        }
    }
    println!("{} of the states were met", met.len());
    assert!(met.len() >= 25, "{met:?}");
}
