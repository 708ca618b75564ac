//! Laws of mechanics: energy, free swings, friction, control loop, sensor noise.

use super::*;
use crate::model::rigid_body::Numeric;
use dh_codegen::arm::param;

fn energy(numeric: &Numeric, phi: &[f64], truth: &Truth, k: usize) -> f64 {
    let (n, len) = (numeric.dof(), truth.t.len());
    let of = |values: &[f64]| (0..n).map(|j| values[j * len + k]).collect::<Vec<f64>>();
    let (q, dq) = (of(&truth.link_q), of(&truth.link_dq));
    numeric.kinetic_energy(&q, &dq, phi) + numeric.potential_energy(&q, phi)
}

fn free(rate: f64, tolerance: f64) -> Request {
    Request {
        control: Control { mode: Mode::Free, ..Control::default() },
        sensors: Sensors::perfect(rate),
        solver: Solver { tolerance, ..Solver::default() },
        ..Request::default()
    }
}

/// Spring on joint 3: stiffness, N/m, and rest position, m. It keeps the Stanford arm's sliding
/// joint from leaving its bearing.
const SPRING: [f64; 2] = [200.0, 0.6];

fn spring(name: &str) -> Effects {
    match name {
        "stanford" => at_joint(2, "joint_spring", &[("KS", SPRING[0]), ("QS", SPRING[1])]),
        _ => Effects::default(),
    }
}

const LWR: [f64; 7] = [0.3, 0.5, -0.2, 0.8, 0.1, -0.5, 0.2];
const STANFORD: [f64; 6] = [0.2, 0.8, 0.7, -0.4, 0.6, 0.3];

#[test]
fn without_friction_energy_stays() {
    for (name, q) in [("planar2r", &[0.3, 0.4][..]), ("kuka-lwr4", &LWR), ("stanford", &STANFORD)] {
        let robot = frictionless(name);
        let phi = param::standard_values(&robot).unwrap();
        let numeric = Numeric::new(&robot);
        let swing = Trajectory::rest(q, 10.0).unwrap();
        let truth = run(&robot, &spring(name), &swing, &free(20.0, 1e-12)).truth;
        let len = truth.t.len();
        let stored = |k: usize| match name {
            "stanford" => 0.5 * SPRING[0] * (truth.link_q[2 * len + k] - SPRING[1]).powi(2),
            _ => 0.0,
        };
        let start = energy(&numeric, &phi, &truth, 0) + stored(0);
        let scale = (0..truth.t.len())
            .map(|k| {
                let dq: Vec<f64> = (0..q.len()).map(|j| truth.link_dq[j * truth.t.len() + k]).collect();
                let at: Vec<f64> = (0..q.len()).map(|j| truth.link_q[j * truth.t.len() + k]).collect();
                numeric.kinetic_energy(&at, &dq, &phi)
            })
            .fold(0.0, f64::max);
        for k in 0..truth.t.len() {
            let drift = (energy(&numeric, &phi, &truth, k) + stored(k) - start).abs() / scale;
            assert!(drift < 1e-8, "{name}: {drift:.1e} after {} s", truth.t[k]);
        }
    }
}

#[test]
fn a_free_swing_is_the_oracles() {
    for (name, q) in [("kuka-lwr4", &LWR[..]), ("stanford", &STANFORD)] {
        let mut robot = frictionless(name);
        robot.joints.iter_mut().for_each(|j| j.drive.viscous_friction = Some(0.5));
        let phi = param::standard_values(&robot).unwrap();
        let numeric = Numeric::new(&robot);
        let truth = run(&robot, &spring(name), &Trajectory::rest(q, 2.0).unwrap(), &free(10.0, 1e-10)).truth;
        // Reference: the classical Runge-Kutta method with the articulated-body algorithm.
        let (n, h) = (q.len(), 2e-4);
        let rate = |y: &[f64]| {
            let mut tau = vec![0.0; n];
            if name == "stanford" {
                tau[2] = -SPRING[0] * (y[2] - SPRING[1]);
            }
            let a = numeric.forward_dynamics(&y[..n], &y[n..], &tau, &phi);
            [&y[n..], a.as_slice()].concat()
        };
        let add = |y: &[f64], k: &[f64], h: f64| y.iter().zip(k).map(|(y, k)| y + h * k).collect::<Vec<f64>>();
        let mut y = [q.to_vec(), vec![0.0; n]].concat();
        for step in 0..10_000 {
            let k1 = rate(&y);
            let k2 = rate(&add(&y, &k1, 0.5 * h));
            let k3 = rate(&add(&y, &k2, 0.5 * h));
            let k4 = rate(&add(&y, &k3, h));
            for i in 0..2 * n {
                y[i] += h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);
            }
            if (step + 1) % 500 == 0 {
                let k = (step + 1) / 500;
                for j in 0..n {
                    let ours = truth.link_q[j * truth.t.len() + k];
                    let t = truth.t[k];
                    assert!((ours - y[j]).abs() < 1e-7, "{name}, joint {} at {t} s: {ours} {}", j + 1, y[j]);
                }
            }
        }
    }
}

#[test]
fn what_friction_takes_is_what_is_lost() {
    let mut robot = frictionless("planar2r");
    robot.joints.iter_mut().for_each(|j| {
        j.drive.viscous_friction = Some(0.05);
        j.drive.coulomb_friction = Some(0.1);
    });
    let phi = param::standard_values(&frictionless("planar2r")).unwrap();
    let numeric = Numeric::new(&frictionless("planar2r"));
    let swing = Trajectory::rest(&[0.3, 0.4], 4.0).unwrap();
    let truth = run(&robot, &Effects::default(), &swing, &free(4000.0, 1e-8)).truth;
    let len = truth.t.len();
    let power =
        |k: usize| (0..2).map(|j| truth.link_dq[j * len + k]).map(|v| 0.05 * v * v + 0.1 * v.abs()).sum::<f64>();
    let mut work = 0.0;
    for k in 1..len {
        work += 0.5 * (power(k) + power(k - 1)) * (truth.t[k] - truth.t[k - 1]);
    }
    let lost = energy(&numeric, &phi, &truth, 0) - energy(&numeric, &phi, &truth, len - 1);
    assert!(lost > 1.0 && (lost - work).abs() < 2e-4 * lost, "lost {lost}, work {work}");
}

#[test]
fn friction_holds_an_arm_that_is_not_heavy_enough() {
    let mut robot = frictionless("planar2r");
    robot.joints.iter_mut().for_each(|j| j.drive.coulomb_friction = Some(6.0));
    let truth =
        run(&robot, &Effects::default(), &Trajectory::rest(&[0.0, 0.1], 5.0).unwrap(), &free(100.0, 1e-6)).truth;
    let len = truth.t.len();
    for j in 0..2 {
        // The bristle yields a little at first. After that the only motion is the integration
        // tolerance, 1e-5 rad/s.
        let [start, soon, end] = [0, 100, len - 1].map(|k| truth.link_q[j * len + k]);
        assert!((soon - start).abs() < 1e-4, "joint {} gave way by {}", j + 1, soon - start);
        assert!((end - soon).abs() < 4e-5, "joint {} crept by {}", j + 1, end - soon);
    }
}

#[test]
fn the_loop_follows_and_its_torques_are_those_of_the_model() {
    let robot = robot("kuka-lwr4");
    let trajectory = motion(7, 0.8, 6.0);
    let followed = run(&robot, &Effects::default(), &trajectory, &loop_at(1000.0));
    let ideal = run(&robot, &Effects::default(), &trajectory, &exact(1000.0));
    let worst = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(worst(&followed.truth.link_q, &ideal.truth.link_q) < 3e-3);
    // Oracle's inverse dynamics at the states passed, with `ddq` from the loop's own motion.
    let phi = param::standard_values(&robot).unwrap();
    let numeric = Numeric::new(&robot);
    let (truth, len) = (&followed.truth, followed.truth.t.len());
    let mut squares = 0.0;
    let mut count = 0;
    for k in (300..len - 300).step_by(37) {
        let of = |values: &[f64], k: usize| (0..7).map(|j| values[j * len + k]).collect::<Vec<f64>>();
        let (before, after) = (of(&truth.link_dq, k - 1), of(&truth.link_dq, k + 1));
        let ddq: Vec<f64> = before.iter().zip(&after).map(|(a, b)| (b - a) / 2e-3).collect();
        let dq = of(&truth.link_dq, k);
        let tau = numeric.inverse_dynamics(&of(&truth.link_q, k), &dq, &ddq, &phi);
        for j in (0..7).filter(|&j| dq[j].abs() > 0.05) {
            squares += (tau[j] - truth.motor_torque[j * len + k]).powi(2);
            count += 1;
        }
    }
    let rms = (squares / f64::from(count)).sqrt();
    assert!(count > 300 && rms < 1e-2, "{rms} over {count}");
}

#[test]
fn the_same_seed_gives_the_same_log_and_another_seed_another() {
    let robot = robot("planar2r");
    let trajectory = motion(2, 0.6, 2.0);
    let with = |seed| {
        let request = Request { seed, ..Request::default() };
        let mut bytes = Vec::new();
        let log = run(&robot, &at_joint(0, "joint_elasticity", &[]), &trajectory, &request).log;
        crate::data::log::csv::write(&log, &mut bytes).unwrap();
        bytes
    };
    assert!(with(5) == with(5));
    assert!(with(5) != with(6));
}

#[test]
fn sensors_have_the_noise_that_is_asked_for() {
    let robot = robot("planar2r");
    let trajectory = motion(2, 0.6, 20.0);
    let mut request = exact(1000.0);
    let clean = run(&robot, &Effects::default(), &trajectory, &request).log;
    request.sensors.encoder = vec![1e-4];
    request.sensors.torque_noise = vec![0.05, 0.2];
    request.sensors.torque_colour = vec![0.0, 0.1];
    let noisy = run(&robot, &Effects::default(), &trajectory, &request).log;
    let rms = |column: usize| {
        let pairs = clean.columns[column].iter().zip(&noisy.columns[column]);
        (pairs.map(|(a, b)| (a - b) * (a - b)).sum::<f64>() / clean.len() as f64).sqrt()
    };
    // t, q1, q2, tau1, tau2
    assert!((rms(1) / (1e-4 / 12f64.sqrt()) - 1.0).abs() < 0.03, "{}", rms(1));
    assert!((rms(3) / 0.05 - 1.0).abs() < 0.03, "{}", rms(3));
    assert!((rms(4) / (0.2f64 * 0.2 + 0.1 * 0.1).sqrt() - 1.0).abs() < 0.05, "{}", rms(4));
    assert!(noisy.columns[1].iter().all(|q| ((q / 1e-4).round() * 1e-4 - q).abs() < 1e-15));
}

/// A motor torque that balances gravity and the friction offset keeps the joint at rest. With
/// gravity alone the offset accelerates it.
#[test]
fn an_offset_of_the_friction_holds_back() {
    let mut robot = frictionless("planar2r");
    robot.joints[1].drive.offset = Some(0.3);
    let (q, still) = ([0.3, 0.4], [0.0; 2]);
    let bodies = frictionless("planar2r");
    let free = Numeric::new(&bodies).inverse_dynamics(&q, &still, &still, &param::standard_values(&bodies).unwrap());
    let sampled =
        Sampled { start: q.to_vec(), seconds: 0.2, sensors: Sensors::perfect(1e3), solver: Solver::default(), seed: 1 };
    for with in [true, false] {
        let mut gravity: [f64; 2] = std::array::from_fn(|j| free[j]);
        if with {
            gravity[1] += 0.3;
        }
        let mut end = q.to_vec();
        Simulator::new(&robot, &Effects::default())
            .unwrap()
            .run_sampled(&sampled, &[], &mut |_, is, torque| {
                torque.copy_from_slice(&gravity);
                end.copy_from_slice(&is.q);
                true
            })
            .unwrap();
        let moved = end[1] - q[1];
        assert!(if with { moved.abs() < 1e-9 } else { moved < -1e-4 }, "{with}: {moved}");
    }
}
