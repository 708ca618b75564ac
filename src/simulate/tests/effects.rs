//! Signature of each effect, as it would appear in a log of a real robot.

use super::*;

/// Velocity above which the bristles of a plain sign are saturated, rad/s.
const FAST: f64 = 0.15;

/// Column of a joint in the truth.
fn joint(values: &[f64], recording: &Recording, j: usize) -> Vec<f64> {
    let len = recording.truth.t.len();
    values[j * len..(j + 1) * len].to_vec()
}

/// Torque that an effect adds at one joint under exact motion, N m, with that motion.
struct Added {
    t: Vec<f64>,
    q: Vec<f64>,
    v: Vec<f64>,
    torque: Vec<f64>,
    load: Vec<f64>,
}

fn added(robot: &Robot, effects: &Effects, trajectory: &Trajectory, j: usize, rate: f64) -> Added {
    let with = run(robot, effects, trajectory, &exact(rate));
    let without = run(robot, &Effects::default(), trajectory, &exact(rate));
    let torque = joint(&with.truth.motor_torque, &with, j);
    let plain = joint(&without.truth.motor_torque, &without, j);
    Added {
        t: with.truth.t.clone(),
        q: joint(&with.truth.motor_q, &with, j),
        v: joint(&with.truth.motor_dq, &with, j),
        load: joint(&with.truth.link_torque, &with, j),
        torque: torque.iter().zip(&plain).map(|(a, b)| a - b).collect(),
    }
}

/// Compares the added torque with a law of `(t, q, v, load)` away from reversals.
fn follows(name: &str, parameters: &[(&str, f64)], law: impl Fn(f64, f64, f64, f64) -> f64, bound: f64) {
    let robot = robot("planar2r");
    for j in 0..2 {
        let seen = added(&robot, &at_joint(j, name, parameters), &motion(2, 1.2, 8.0), j, 500.0);
        let mut checked = 0;
        for k in 0..seen.t.len() {
            if seen.v[k].abs() > FAST {
                let expected = law(seen.t[k], seen.q[k], seen.v[k], seen.load[k]);
                let off = (seen.torque[k] - expected).abs();
                assert!(off < bound, "{name} of joint {} at {} s: {} {expected}", j + 1, seen.t[k], seen.torque[k]);
                checked += 1;
            }
        }
        assert!(checked > 500);
    }
}

#[test]
fn friction_velocity_curves() {
    let s = f64::signum;
    follows("viscous_friction", &[("FV", 0.7)], |_, _, v, _| 0.7 * v, 1e-9);
    follows("coulomb_friction", &[("FC", 0.7)], |_, _, v, _| 0.7 * s(v), 1e-6);
    follows("asymmetric_friction", &[("FCA", 0.3), ("FVA", 0.2)], |_, _, v, _| 0.3 + 0.2 * v.abs(), 1e-6);
    follows(
        "nonlinear_viscous_friction",
        &[("FN", 0.5), ("EN", 0.6)],
        |_, _, v, _| 0.5 * v.abs().powf(0.6) * s(v),
        1e-3,
    );
    follows("load_dependent_friction", &[("FL", 0.1)], |_, _, v, load| 0.1 * load.abs() * s(v), 1e-5);
    follows(
        "position_dependent_friction",
        &[("PC", 0.3), ("PS", 0.1), ("PN", 2.0)],
        |_, q, v, _| s(v) * (0.3 * (2.0 * q).cos() + 0.1 * (2.0 * q).sin()),
        1e-6,
    );
    follows("joint_spring", &[("KS", 3.0), ("QS", 0.2)], |_, q, _, _| 3.0 * (q - 0.2), 1e-9);
    follows(
        "torque_ripple",
        &[("RN", 20.0), ("RC", 0.2), ("RS2", 0.1)],
        |_, q, _, _| 0.2 * (20.0 * q).cos() + 0.1 * (40.0 * q).sin(),
        1e-9,
    );
}

#[test]
fn stribeck_falls_from_breakaway_to_coulomb() {
    let level = [0.2, 0.1]; // the file's FC
    for j in 0..2 {
        let effects = at_joint(j, "stribeck_friction", &[("FS", 0.9), ("VS", 0.15)]);
        let seen = added(&robot("planar2r"), &effects, &motion(2, 1.2, 8.0), j, 500.0);
        for k in (0..seen.t.len()).filter(|&k| seen.v[k].abs() > FAST) {
            let expected = (0.9 - level[j]) * (-(seen.v[k] / 0.15).powi(2)).exp() * seen.v[k].signum();
            assert!((seen.torque[k] - expected).abs() < 1e-5, "{} {expected}", seen.torque[k]);
        }
    }
}

#[test]
fn friction_fades_as_the_gear_warms() {
    let robot = robot("planar2r");
    let seen =
        added(&robot, &at_joint(0, "friction_drift", &[("DA", 0.5), ("DT", 3.0)]), &motion(2, 1.2, 8.0), 0, 500.0);
    for k in (0..seen.t.len()).filter(|&k| seen.v[k].abs() > FAST) {
        let friction = 0.1 * seen.v[k] + 0.2 * seen.v[k].signum();
        let expected = friction * 0.5 * (-seen.t[k] / 3.0).exp();
        assert!((seen.torque[k] - expected).abs() < 1e-5, "{} {expected}", seen.torque[k]);
    }
    let warm =
        run(&robot, &at_joint(0, "friction_drift", &[("DK", -0.01), ("DT", 3.0)]), &motion(2, 1.2, 8.0), &exact(100.0));
    let temperature = warm.log.joint(crate::data::log::Quantity::Temperature, 0).unwrap();
    assert!(temperature[0] == 25.0 && (38.0..40.0).contains(&temperature[temperature.len() - 1]));
}

#[test]
fn presliding_is_a_loop_whose_area_is_the_energy_lost() {
    // Cycles within and beyond the presliding travel, slow enough for the damping of the bristle to
    // be about a percent.
    let robot = frictionless("planar2r");
    let loop_area = |size: f64| {
        let t: Vec<f64> = (0..=4000).map(|k| f64::from(k) * 0.1).collect();
        let q: Vec<f64> =
            t.iter().map(|t| size * (0.01 * std::f64::consts::TAU * t).sin()).chain(t.iter().map(|_| 0.0)).collect();
        let motion = Trajectory::new(2, t, q, None, None).unwrap();
        let seen = added(&robot, &at_joint(0, "presliding_hysteresis", &[("HC", 2.0), ("HX", 2e-3)]), &motion, 0, 50.0);
        // Mean of the last two of four periods.
        let from = seen.t.len() / 2;
        (from + 1..seen.t.len())
            .map(|k| 0.5 * (seen.torque[k] + seen.torque[k - 1]) * (seen.q[k] - seen.q[k - 1]))
            .sum::<f64>()
            / 2.0
    };
    // Dahl's loop between -a and a: half its height is tanh(a / X), so its area is 4 HC (a - X
    // tanh(a / X)).
    for size in [1e-3, 4e-3, 2e-2] {
        let expected = 4.0 * 2.0 * (size - 2e-3 * (size / 2e-3f64).tanh());
        let found = loop_area(size);
        assert!((found / expected - 1.0).abs() < 0.02, "{size}: {found} {expected}");
    }
}

#[test]
fn an_elastic_joint_rings_at_its_resonance() {
    // The elbow's link rings at sqrt(K / J) against a locked motor, and at sqrt(K (1 / J + 1 / I))
    // with a free rotor.
    let mut robot = frictionless("planar2r");
    robot.gravity = [0.0; 3];
    let (stiffness, rotor) = (80.0, 0.02);
    let effects = Effects {
        joints: vec![
            (1, effect("joint_elasticity", &[("KE", stiffness)])),
            (1, effect("rotor_inertia", &[("IA", rotor)])),
        ],
        robot: Vec::new(),
        ..Effects::default()
    };
    // The shoulder is held and the elbow's motor receives a torque pulse.
    let t: Vec<f64> = (0..=400).map(|k| f64::from(k) * 0.005).collect();
    let len = t.len();
    let torques: Vec<f64> = (0..len).map(|_| 0.0).chain((0..len).map(|k| if k < 4 { 1.0 } else { 0.0 })).collect();
    let motion = Trajectory::new(2, t, vec![0.0; 2 * len], None, None).unwrap().with_torques(torques).unwrap();
    let held = Effects {
        joints: [effects.joints, vec![(0, effect("joint_spring", &[("KS", 1e7)]))]].concat(),
        robot: Vec::new(),
        ..Effects::default()
    };
    let request = Request { control: Control { mode: Mode::Torque, ..Control::default() }, ..loop_at(2000.0) };
    let seen = run(&robot, &held, &motion, &request);
    let spring = joint(&seen.truth.link_torque, &seen, 1);
    let mean = spring[400..].iter().sum::<f64>() / (spring.len() - 400) as f64;
    let crossings: Vec<f64> = (400..spring.len() - 1)
        .filter(|&k| spring[k] < mean && spring[k + 1] >= mean)
        .map(|k| seen.truth.t[k] + 5e-4 * (mean - spring[k]) / (spring[k + 1] - spring[k]))
        .collect();
    let period = (crossings[crossings.len() - 1] - crossings[0]) / (crossings.len() - 1) as f64;
    let link = 0.4f64.powi(3) / 3.0;
    let expected = (stiffness * (1.0 / link + 1.0 / rotor)).sqrt() / std::f64::consts::TAU;
    assert!((1.0 / period / expected - 1.0).abs() < 2e-3, "{} Hz {expected} Hz", 1.0 / period);
}

#[test]
fn an_elastic_joint_sags_by_its_load() {
    let robot = frictionless("planar2r");
    let effects = at_joint(1, "joint_elasticity", &[("KE", 200.0)]);
    for request in [exact(200.0), loop_at(200.0)] {
        let seen = run(&robot, &effects, &motion(2, 0.8, 4.0), &request);
        let (motor, link) = (joint(&seen.truth.motor_q, &seen, 1), joint(&seen.truth.link_q, &seen, 1));
        let load = joint(&seen.truth.link_torque, &seen, 1);
        for k in 0..motor.len() {
            assert!((motor[k] - link[k] - load[k] / 200.0).abs() < 1e-9);
        }
        assert!(load.iter().fold(0.0, |a: f64, b| a.max(b.abs())) > 0.5);
    }
}

#[test]
fn backlash_opens_where_the_load_changes_sides() {
    let mut robot = robot("planar2r");
    robot.gravity = [0.0; 3];
    for request in [exact(500.0), loop_at(500.0)] {
        let seen = run(&robot, &at_joint(1, "backlash", &[("BL", 2e-3)]), &motion(2, 1.0, 4.0), &request);
        let (motor, link) = (joint(&seen.truth.motor_q, &seen, 1), joint(&seen.truth.link_q, &seen, 1));
        let load = joint(&seen.truth.link_torque, &seen, 1);
        let (mut sides, mut pressed) = ([0, 0], 0);
        for k in 0..motor.len() {
            let gap = motor[k] - link[k];
            assert!(gap.abs() < 1e-3 + load[k].abs() / 400.0 + 1e-6);
            if load[k].abs() > 0.1 {
                pressed += 1;
                let pressed = gap - 1e-3_f64.copysign(load[k]) - load[k] / 4800.0;
                sides[usize::from(gap > 0.0)] += usize::from(pressed.abs() < 1e-4);
            }
        }
        assert!(pressed > 500 && sides[0] > 100 && sides[1] > 100, "{pressed} {sides:?}");
        assert!(sides[0] + sides[1] > pressed * 9 / 10);
    }
}

#[test]
fn a_coupled_motor_turns_with_another_joint() {
    let robot = robot("planar2r");
    let keys = [("joint", 1.0), ("KC", 0.8), ("IAM", 0.02), ("FVM", 0.1), ("FCM", 0.3)];
    let effects = at_joint(1, "gear_coupling", &keys);
    let trajectory = motion(2, 1.2, 8.0);
    let with = run(&robot, &effects, &trajectory, &exact(500.0));
    let without = run(&robot, &Effects::default(), &trajectory, &exact(500.0));
    let (v_k, v_m) = (joint(&with.truth.motor_dq, &with, 0), joint(&with.truth.motor_dq, &with, 1));
    let points = &with.truth.desired;
    let len = v_k.len();
    for k in 0..len {
        let w = v_m[k] + 0.8 * v_k[k];
        if w.abs() > 0.05 {
            let (a_k, a_m) = (points[k][2], points[len + k][2]);
            let on_k = 0.8 * (0.02 * a_m + 0.1 * v_m[k] + 0.3 * w.signum());
            let on_m = 0.8 * (0.02 * a_k + 0.1 * v_k[k]) + 0.3 * w.signum();
            for (j, expected) in [(0, on_k), (1, on_m)] {
                let seen = with.truth.motor_torque[j * len + k] - without.truth.motor_torque[j * len + k];
                assert!((seen - expected).abs() < 1e-5, "{seen} {expected}");
            }
        }
    }
}

#[test]
fn sensors_that_lie() {
    let robot = frictionless("planar2r");
    let trajectory = motion(2, 1.0, 4.0);
    let plain = run(&robot, &Effects::default(), &trajectory, &exact(1000.0)).log;
    let with = |name: &str, parameters: &[(&str, f64)]| {
        run(&robot, &at_joint(0, name, parameters), &trajectory, &exact(1000.0)).log
    };
    let tau = |log: &Log| log.joint(crate::data::log::Quantity::Tau, 0).unwrap().to_vec();
    let (true_torque, gained) = (tau(&plain), tau(&with("torque_gain_error", &[("GT", 1.1)])));
    let (offset, late) = (tau(&with("torque_offset", &[("TO", 0.4)])), tau(&with("time_delay", &[("TD", 0.0105)])));
    let clipped = tau(&with("torque_saturation", &[("TM", 3.0)]));
    for k in 0..true_torque.len() {
        assert!((gained[k] - 1.1 * true_torque[k]).abs() < 1e-12);
        assert!((offset[k] - 0.4 - true_torque[k]).abs() < 1e-12);
        assert!((clipped[k] - true_torque[k].clamp(-3.0, 3.0)).abs() < 1e-12);
        if k > 11 {
            assert!((late[k] - 0.5 * (true_torque[k - 10] + true_torque[k - 11])).abs() < 2e-3);
        }
    }
    assert!(true_torque.iter().any(|t| t.abs() > 3.0));
    // Encoder offset: the log shows the desired motion while the arm is elsewhere.
    let shifted = run(&robot, &at_joint(0, "encoder_offset", &[("QO", 0.05)]), &trajectory, &exact(100.0));
    let followed = run(&robot, &at_joint(0, "encoder_offset", &[("QO", 0.05)]), &trajectory, &loop_at(100.0));
    for (seen, bound) in [(&shifted, 1e-12), (&followed, 2e-2)] {
        let q = seen.log.joint(crate::data::log::Quantity::Q, 0).unwrap();
        for k in 0..q.len() {
            assert!((q[k] - seen.truth.desired[k][0]).abs() < bound);
            assert!((seen.truth.link_q[k] - q[k] - 0.05).abs() < 1e-12);
        }
    }
}

/// Torques of the oracle along the same motion, for a robot with other bodies.
fn by_oracle(robot: &Robot, recording: &Recording, k: usize) -> Vec<f64> {
    let numeric = crate::model::rigid_body::Numeric::new(robot);
    let phi = dh_codegen::arm::param::standard_values(robot).unwrap();
    let (n, len) = (robot.dof(), recording.truth.t.len());
    let of = |i: usize| (0..n).map(|j| recording.truth.desired[j * len + k][i]).collect::<Vec<f64>>();
    numeric.inverse_dynamics(&of(0), &of(1), &of(2), &phi).as_slice().to_vec()
}

#[test]
fn the_bodies_are_not_what_the_file_says() {
    let given = frictionless("kuka-lwr4");
    let trajectory = motion(7, 0.8, 3.0);
    let whole = |name: &str, parameters: &[(&str, f64)]| Effects {
        joints: Vec::new(),
        robot: vec![effect(name, parameters)],
        ..Effects::default()
    };
    let mut heavy = given.clone();
    let last = heavy.links[6].unwrap();
    heavy.links[6] = Some(last.plus(&dh_codegen::robot::Inertia {
        m: 2.0,
        ms: [0.1, 0.0, 0.2],
        i: [0.03, 0.03, 0.01, 0.0, -0.01, 0.0],
    }));
    let mut lighter = given.clone();
    lighter.links[2] =
        Some(dh_codegen::robot::Inertia::from_array(given.links[2].unwrap().to_array().map(|p| 1.2 * p)));
    let mut bent = given.clone();
    bent.joints[3].alpha = dh_codegen::robot::Angle::radians(given.joints[3].alpha.value + 0.03);
    bent.joints[3].d = dh_codegen::robot::Length::meters(0.02);
    let mut tilted = given.clone();
    // RotX(0.1)' (0, 0, -g)
    tilted.gravity = [0.0, -9.81 * 0.1f64.sin(), -9.81 * 0.1f64.cos()];
    let payload = [("M", 2.0), ("MSX", 0.1), ("MSZ", 0.2), ("XX", 0.03), ("YY", 0.03), ("ZZ", 0.01), ("XZ", -0.01)];
    for (effects, truly) in [
        (whole("payload", &payload), heavy),
        (at_joint(2, "link_inertia_error", &[]), lighter.clone()),
        (whole("link_inertia_error", &[("link", 3.0)]), lighter),
        (at_joint(3, "geometric_error", &[("DALPHA", 0.03), ("DD", 0.02)]), bent),
        (whole("base_tilt", &[("roll", 0.1)]), tilted),
    ] {
        let seen = run(&given, &effects, &trajectory, &exact(50.0));
        let len = seen.truth.t.len();
        let mut different = false;
        for k in (0..len).step_by(7) {
            let (expected, plain) = (by_oracle(&truly, &seen, k), by_oracle(&given, &seen, k));
            for j in 0..7 {
                let tau = seen.truth.motor_torque[j * len + k];
                assert!((tau - expected[j]).abs() < 1e-8, "{effects:?}: {tau} {}", expected[j]);
                different |= (tau - plain[j]).abs() > 0.1;
            }
        }
        assert!(different, "{effects:?}");
    }
}

#[test]
fn a_push_on_the_tool_is_felt_through_the_jacobian() {
    let robot = frictionless("planar2r");
    let push = effect("external_contact", &[("start", 1.0), ("end", 2.0), ("fx", 6.0), ("fy", -4.0), ("mz", 0.5)]);
    let effects = Effects { joints: Vec::new(), robot: vec![push], ..Effects::default() };
    let trajectory = motion(2, 0.8, 3.0);
    let request = Request { sensors: Sensors { wrench: true, ..Sensors::perfect(100.0) }, ..exact(100.0) };
    let with = run(&robot, &effects, &trajectory, &request);
    let without = run(&robot, &Effects::default(), &trajectory, &request);
    let len = with.truth.t.len();
    let (l1, l2) = (0.5, 0.4);
    for k in 0..len {
        let t = with.truth.t[k];
        let inside = if (1.03..1.97).contains(&t) {
            1.0
        } else if (1.0..=2.0).contains(&t) {
            continue;
        } else {
            0.0
        };
        let (q1, q2) = (with.truth.link_q[k], with.truth.link_q[len + k]);
        let a = q1 + q2;
        // Force in world axes.
        let (fx, fy) = (6.0 * a.cos() + 4.0 * a.sin(), 6.0 * a.sin() - 4.0 * a.cos());
        let elbow = l2 * (a.cos() * fy - a.sin() * fx) + 0.5;
        let shoulder = elbow + l1 * (q1.cos() * fy - q1.sin() * fx);
        for (j, expected) in [(0, shoulder), (1, elbow)] {
            let seen = with.truth.motor_torque[j * len + k] - without.truth.motor_torque[j * len + k];
            assert!((seen + inside * expected).abs() < 1e-10, "{seen} {expected}");
        }
        let measured = with.log.column(crate::data::log::Role::Wrench(1)).unwrap()[k];
        assert!((measured + 4.0 * inside).abs() < 1e-12);
    }
}

/// A force on link 1 acts at the elbow, on the shoulder alone, and is no wrench on the tool. In the
/// axes of the link its lever is the link's length at any angle.
#[test]
fn a_push_on_a_link_acts_at_its_far_end() {
    let robot = frictionless("planar2r");
    let push = |base: f64| {
        effect(
            "external_contact",
            &[("start", -9.0), ("end", 99.0), ("link", 1.0), ("fx", 6.0), ("fy", -4.0), ("base", base)],
        )
    };
    let trajectory = motion(2, 0.8, 3.0);
    let request = Request { sensors: Sensors { wrench: true, ..Sensors::perfect(100.0) }, ..exact(100.0) };
    let without = run(&robot, &Effects::default(), &trajectory, &request);
    for base in [0.0, 1.0] {
        let effects = Effects { joints: Vec::new(), robot: vec![push(base)], ..Effects::default() };
        let with = run(&robot, &effects, &trajectory, &request);
        let len = with.truth.t.len();
        for k in 0..len {
            let q1 = if base == 1.0 { with.truth.link_q[k] } else { 0.0 };
            let shoulder = 0.5 * (-6.0 * q1.sin() - 4.0 * q1.cos());
            for (j, expected) in [(0, shoulder), (1, 0.0)] {
                let seen = with.truth.motor_torque[j * len + k] - without.truth.motor_torque[j * len + k];
                assert!((seen + expected).abs() < 1e-10, "{base} {j}: {seen} {expected}");
            }
            assert_eq!(with.log.column(crate::data::log::Role::Wrench(1)).unwrap()[k], 0.0);
        }
    }
    let lost = effect("external_contact", &[("link", 3.0)]);
    let effects = Effects { joints: Vec::new(), robot: vec![lost], ..Effects::default() };
    let error = Simulator::new(&robot, &effects).map(|_| ()).unwrap_err().to_string();
    assert_eq!(error, "external_contact: there is no link 3; write the number of a link, 1 to 2");
}

/// Torques of a wall in the file are the derivatives of its energy, at any time. A push in the axes
/// of the base does not turn with the tool.
#[test]
fn a_wall_and_a_push_in_the_axes_of_the_base() {
    let robot = frictionless("planar2r");
    let wall = effect("external_contact", &[("k", 300.0), ("nx", 0.3), ("ny", 0.4), ("at", 0.2)]);
    let push = effect("external_contact", &[("start", -9.0), ("end", 99.0), ("fx", 6.0), ("base", 1.0)]);
    let effects = Effects { joints: Vec::new(), robot: vec![wall, push], ..Effects::default() };
    let trajectory = motion(2, 0.8, 3.0);
    let with = run(&robot, &effects, &trajectory, &exact(100.0));
    let without = run(&robot, &Effects::default(), &trajectory, &exact(100.0));
    let len = with.truth.t.len();
    let energy = |q1: f64, q2: f64| {
        let [x, y] = [0.5 * q1.cos() + 0.4 * (q1 + q2).cos(), 0.5 * q1.sin() + 0.4 * (q1 + q2).sin()];
        let depth = (0.2 - 0.6 * x - 0.8 * y).max(0.0);
        150.0 * depth * depth - 6.0 * x
    };
    for k in 0..len {
        let (q1, q2) = (with.truth.link_q[k], with.truth.link_q[len + k]);
        let slopes = [energy(q1 + 1e-6, q2) - energy(q1 - 1e-6, q2), energy(q1, q2 + 1e-6) - energy(q1, q2 - 1e-6)];
        for (j, slope) in slopes.into_iter().enumerate() {
            let seen = with.truth.motor_torque[j * len + k] - without.truth.motor_torque[j * len + k];
            assert!((seen - slope / 2e-6).abs() < 1e-6, "{seen} {slope}");
        }
    }
}

#[test]
fn a_wall_stops_the_tool() {
    let robot = robot("planar2r");
    // The arm swings towards a wall at x = 0.72; the straight arm reaches 0.9 m.
    let q = [-0.9, 0.2];
    let simulator = Simulator::new(&robot, &Effects::default()).unwrap();
    let t: Vec<f64> = (0..=300).map(|k| f64::from(k) * 0.01).collect();
    let ramp = |t: f64| (t / 2.0).min(1.0);
    let path: Vec<f64> = t.iter().map(|&t| q[0] + 0.5 * ramp(t)).chain(t.iter().map(|_| q[1])).collect();
    let motion = Trajectory::new(2, t, path, None, None).unwrap();
    let wall = Wall { stiffness: 2e4, ..Wall::new([0.72, 0.0, 0.0], [-1.0, 0.0, 0.0]) };
    let request = Request { sensors: Sensors { wrench: true, ..Sensors::perfect(200.0) }, ..loop_at(200.0) };
    let seen = simulator.run_against(&motion, &request, &[&wall], &mut |_| {}).unwrap();
    let len = seen.truth.t.len();
    let tip = |k: usize| {
        let (a, b) = (seen.truth.link_q[k], seen.truth.link_q[len + k]);
        0.5 * a.cos() + 0.4 * (a + b).cos()
    };
    assert!(tip(0) < 0.7 && (0..len).all(|k| tip(k) < 0.8));
    let force = |k: usize| (0..2).map(|i| seen.truth.wrench[i * len + k].powi(2)).sum::<f64>().sqrt();
    let depth = tip(len - 1) - 0.72;
    assert!(depth > 1e-5 && (force(len - 1) / (2e4 * depth) - 1.0).abs() < 1e-3, "{depth} {}", force(len - 1));
    assert_eq!(force(0), 0.0);
}

#[test]
fn a_saturated_drive_falls_behind() {
    let robot = robot("planar2r");
    let trajectory = motion(2, 1.0, 4.0);
    let seen = run(&robot, &at_joint(0, "torque_saturation", &[]), &trajectory, &loop_at(200.0));
    let torque = joint(&seen.truth.motor_torque, &seen, 0);
    let limit = seen.drives[0].limit.unwrap();
    let at_limit = torque.iter().filter(|t| (t.abs() - limit).abs() < 1e-9).count();
    assert!(at_limit > 5 && torque.iter().all(|t| t.abs() <= limit), "{at_limit}");
    let free = run(&robot, &Effects::default(), &trajectory, &loop_at(200.0));
    let off = |r: &Recording| {
        (0..torque.len()).map(|k| (r.truth.link_q[k] - r.truth.desired[k][0]).abs()).fold(0.0, f64::max)
    };
    assert!(off(&seen) > 5.0 * off(&free), "{} {}", off(&seen), off(&free));
}

#[test]
fn stick_and_slip_needs_stribeck() {
    // Slow ramp with a soft loop: the joint jerks with a breakaway level above Coulomb's, and
    // creeps evenly without.
    let mut robot = frictionless("planar2r");
    robot.gravity = [0.0; 3];
    let t: Vec<f64> = (0..=200).map(|k| f64::from(k) * 0.02).collect();
    let q: Vec<f64> = t.iter().map(|t| 0.02 * t).chain(t.iter().map(|_| 0.0)).collect();
    let ramp = Trajectory::new(2, t, q, None, None).unwrap();
    let mut request = loop_at(500.0);
    request.control.kp = Some(vec![50.0]);
    request.control.kd = Some(vec![0.5]);
    let speeds = |more: &[(&str, f64)]| {
        let mut effects = at_joint(0, "coulomb_friction", &[("FC", 1.0)]);
        if !more.is_empty() {
            effects.joints.push((0, effect("stribeck_friction", more)));
        }
        let seen = run(&robot, &effects, &ramp, &request);
        let v = joint(&seen.truth.link_dq, &seen, 0);
        v[v.len() / 2..].iter().fold(0.0, |a: f64, b| a.max(b.abs()))
    };
    let (even, jerky) = (speeds(&[]), speeds(&[("FS", 2.0), ("VS", 0.05)]));
    assert!(even < 0.03, "{even}");
    assert!(jerky > 0.08, "{jerky}");
}

#[test]
fn every_effect_runs_at_its_default_in_both_ways() {
    let robot = robot("planar2r");
    let trajectory = motion(2, 0.8, 1.0);
    for law in EffectKind::ALL.iter().map(|kind| kind.description()) {
        let joint = if law.name == "gear_coupling" { vec![("joint", 1.0)] } else { Vec::new() };
        let effects = if !law.scope.at_joint() {
            Effects { joints: Vec::new(), robot: vec![effect(law.name, &joint)], ..Effects::default() }
        } else {
            at_joint(1, law.name, &joint)
        };
        let simulator = Simulator::new(&robot, &effects).unwrap();
        for request in [exact(200.0), loop_at(200.0)] {
            let seen =
                simulator.run(&trajectory, &request, &mut |_| {}).unwrap_or_else(|e| panic!("{}: {e}", law.name));
            assert!(seen.log.columns.iter().flatten().all(|v| v.is_finite()), "{}", law.name);
        }
    }
}

#[test]
fn every_effect_has_its_picture_and_its_row() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(root.join("docs/simulate.md")).unwrap();
    for law in EffectKind::ALL {
        let law = law.description();
        let picture = format!("effects/{}.svg", law.name);
        assert!(text.contains(&picture), "{picture}");
        assert!(root.join("docs").join(&picture).exists(), "{picture}");
    }
}

#[test]
fn what_adds_to_the_file_is_judged_by_the_sum() {
    let mut robot = robot("planar2r");
    let drive = &mut robot.joints[0].drive;
    (drive.rotor_inertia, drive.viscous_friction, drive.coulomb_friction) = (Some(0.02), Some(0.02), Some(0.02));
    for (name, key) in [("rotor_inertia", "IA"), ("viscous_friction", "FV"), ("coulomb_friction", "FC")] {
        let simulator = |by: f64| Simulator::new(&robot, &at_joint(0, name, &[(key, by)]));
        let drive = simulator(-0.005).unwrap_or_else(|error| panic!("{error}")).drives()[0].clone();
        let values = [drive.rotor, drive.plain.viscous, drive.plain.level];
        assert_eq!(values.iter().filter(|value| (*value - 0.015).abs() < 1e-15).count(), 1, "{name}: {values:?}");
        let error = simulator(-0.05).err().unwrap().to_string();
        assert!(error.starts_with(&format!("{name} of joint 1: {key}, the file's included, is -0.03")), "{error}");
    }
}
