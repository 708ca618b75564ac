//! Effects of a robot file in its inverse dynamics: compared with formulas written out by hand,
//! with the simulator's physics, and with the generated code.

use std::path::Path;
use std::process::Command;

use denavit::model::file_torque_model::FileTorqueModel;
use denavit::model::interpreted::Interpreted;
use denavit::model::{Arm, States, TorqueModel};
use denavit::simulate::{Control, Effects, Mode, Request, Sensors, Simulator, Trajectory};
use dh_codegen::arm::{Function, param};
use dh_codegen::interpret::{Interpreter, State};
use dh_codegen::robot::{Robot, no_files};

/// The planar arm of `robots/` with these effects: of the shoulder's drive, of the elbow's, and of
/// the whole robot.
fn planar(shoulder: &str, elbow: &str, whole: &str) -> Robot {
    read(&planar_text(shoulder, elbow, whole))
}

fn planar_text(shoulder: &str, elbow: &str, whole: &str) -> String {
    format!(
        "name: planar2r-effects
convention: modified
gravity: [0, -9.81, 0]
joints:
  - {{ type: revolute, torque: 20, drive: {{ rotor_inertia: 0.05, friction: {{ viscous_friction: 0.1, coulomb_friction: 0.2, offset: 0.03 }}{shoulder} }} }}
  - {{ type: revolute, d: 0.5, torque: 8, drive: {{ friction: {{ viscous_friction: 0.05, coulomb_friction: 0.1 }}{elbow} }} }}
links:
  - {{ M: 0.5, MS: [0.125, 0, 0], I: [0, 0.0416667, 0.0416667, 0, 0, 0] }}
  - {{ M: 0.4, MS: [0.08, 0, 0], I: [0, 0.0213333, 0.0213333, 0, 0, 0] }}
{whole}"
    )
}

fn read(text: &str) -> Robot {
    Robot::from_yaml(text, &no_files).unwrap_or_else(|e| panic!("{e}\n{text}")).robot
}

/// Torques of two rods in a vertical plane by the textbook's formulas, N m.
fn rods(q: [f64; 2], v: [f64; 2], a: [f64; 2]) -> [f64; 2] {
    let (l, m2, s1, s2, z1, z2, g) = (0.5, 0.4, 0.125, 0.08, 0.0416667, 0.0213333, 9.81);
    let (c, s) = (q[1].cos(), q[1].sin());
    let m12 = z2 + l * s2 * c;
    let first = (z1 + z2 + m2 * l * l + 2.0 * l * s2 * c) * a[0] + m12 * a[1] - l * s2 * s * (2.0 * v[0] + v[1]) * v[1]
        + g * ((s1 + m2 * l) * q[0].cos() + s2 * (q[0] + q[1]).cos());
    let second = m12 * a[0] + z2 * a[1] + l * s2 * s * v[0] * v[0] + g * s2 * (q[0] + q[1]).cos();
    [first, second]
}

const STATES: [[[f64; 2]; 3]; 5] = [
    [[0.3, -0.7], [0.4, -0.9], [1.5, -2.0]],
    [[-1.1, 0.4], [-0.02, 0.03], [0.5, 0.2]],
    [[2.0, 1.3], [-1.7, 1.1], [-3.0, 4.0]],
    [[0.1, -2.2], [0.0, 0.0], [0.0, 0.0]],
    [[-0.4, 0.9], [0.01, -2.0], [-1.0, 0.3]],
];

/// Rigid torque `load` plus rotor and plain friction, N m.
fn plain(load: [f64; 2], v: [f64; 2], a: [f64; 2]) -> [f64; 2] {
    [load[0] + 0.05 * a[0] + 0.1 * v[0] + 0.2 * sign(v[0]) + 0.03, load[1] + 0.05 * v[1] + 0.1 * sign(v[1])]
}

fn sign(x: f64) -> f64 {
    if x == 0.0 { 0.0 } else { x.signum() }
}

/// Torques of the interpreted file, N m.
fn predicted(robot: &Robot, state: &[[f64; 2]; 3]) -> [f64; 2] {
    let states = States { len: 1, q: state[0].to_vec(), dq: state[1].to_vec(), ddq: state[2].to_vec() };
    let mut out = [0.0; 2];
    FileTorqueModel::new(robot).unwrap().torques(&states, &mut out);
    out
}

fn check(robot: &Robot, what: &str, law: impl Fn([f64; 2], [f64; 2], [f64; 2]) -> [f64; 2]) {
    for state in &STATES {
        let (found, expected) = (predicted(robot, state), law(state[0], state[1], state[2]));
        for j in 0..2 {
            assert!(
                (found[j] - expected[j]).abs() < 1e-9,
                "{what}, joint {}: {} is not {} at {state:?}",
                j + 1,
                found[j],
                expected[j]
            );
        }
    }
}

/// Checks one law of the elbow by its formula in the table of effects: `extra(q, v, load)` is
/// added.
fn one(elbow: &str, extra: impl Fn(f64, f64, f64) -> f64) {
    check(&planar("", &format!(", {elbow}"), ""), elbow, |q, v, a| {
        let load = rods(q, v, a);
        let mut tau = plain(load, v, a);
        tau[1] += extra(q[1], v[1], load[1]);
        tau
    });
}

#[test]
fn laws_of_friction() {
    one("asymmetric_friction: { FCA: 0.07, FVA: 0.02 }", |_, v, _| 0.07 * sign(v).abs() + 0.02 * v.abs());
    one("stribeck_friction: { FS: 0.5, VS: 0.3 }", |_, v, _| 0.4 * (-(v / 0.3_f64).powi(2)).exp() * sign(v));
    one("stribeck_friction: { FS: 0.5, VS: 0.3, DS: 1.3 }", |_, v, _| {
        0.4 * (-(v / 0.3_f64).abs().powf(1.3)).exp() * sign(v)
    });
    one("stribeck_friction: {}", |_, v, _| 0.08 * (-(v / 0.05_f64).powi(2)).exp() * sign(v));
    one("nonlinear_viscous_friction: { FN: 0.3, EN: 0.7 }", |_, v, _| 0.3 * v.abs().powf(0.7) * sign(v));
    one("load_dependent_friction: 0.12", |_, v, load| 0.12 * load.abs() * sign(v));
    one("position_dependent_friction: { PC: 0.1, PS: -0.05, PN: 3 }", |q, v, _| {
        sign(v) * (0.1 * (3.0 * q).cos() - 0.05 * (3.0 * q).sin())
    });
    one("presliding_hysteresis: { HC: 0.2, HX: 0.01 }", |_, v, _| 0.2 * sign(v));
    one("friction_drift: { DA: 0.5, DT: 3 }", |_, _, _| 0.0);
}

#[test]
fn laws_of_transmission_and_sensor() {
    one("torque_ripple: { RN: 12, RC: 0.1, RS: 0.2, RN2: 30, RC2: 0.05 }", |q, _, _| {
        0.1 * (12.0 * q).cos() + 0.2 * (12.0 * q).sin() + 0.05 * (30.0 * q).cos()
    });
    one("joint_spring: { KS: 2, QS: 0.3 }", |q, _, _| 2.0 * (q - 0.3));
    one("torque_offset: -0.4", |_, _, _| -0.4);
    let gain = planar("", ", torque_gain_error: 1.1, torque_saturation: 0.5, torque_offset: 0.2", "");
    check(&gain, "clip, gain, offset", |q, v, a| {
        let mut tau = plain(rods(q, v, a), v, a);
        tau[1] = 1.1 * tau[1].clamp(-0.5, 0.5) + 0.2;
        tau
    });
    let coupled = planar("", ", gear_coupling: { joint: 1, KC: -0.5, IAM: 0.02, FVM: 0.3, FCM: 0.15 }", "");
    check(&coupled, "gear_coupling", |q, v, a| {
        let (mut tau, k) = (plain(rods(q, v, a), v, a), -0.5);
        let s = 0.15 * sign(v[1] + k * v[0]);
        tau[0] += k * (0.02 * a[1] + 0.3 * v[1] + s);
        tau[1] += 0.02 * k * a[0] + 0.3 * k * v[0] + s;
        tau
    });
    let carried = planar("", ", gear_coupling: { joint: 1, CQ: 0.3 }", "");
    check(&carried, "gear_coupling that carries the link", |q, v, a| {
        let link = |x: [f64; 2]| [x[0], x[1] + 0.3 * x[0]];
        let load = rods(link(q), link(v), link(a));
        plain([load[0] + 0.3 * load[1], load[1]], v, a)
    });
    let soft = planar(", joint_elasticity: 300", ", joint_elasticity: 200, load_dependent_friction: 0.1", "");
    check(&soft, "joint_elasticity", |q, v, a| {
        let load = rods(q, v, a);
        let load = rods([q[0] - load[0] / 300.0, q[1] - load[1] / 200.0], v, a);
        let mut tau = plain(load, v, a);
        tau[1] += 0.1 * load[1].abs() * sign(v[1]);
        tau
    });
    check(&planar("", ", backlash: 0.02", ""), "backlash", |q, v, a| {
        let load = rods(q, v, a)[1];
        let side = load / (load * load + 0.016 * 0.016_f64).sqrt();
        plain(rods([q[0], q[1] - 0.01 * side], v, a), v, a)
    });
}

/// A point of 2 kg that slides on a link of 0.3 kg m^2 in a vertical plane, by Lagrange's
/// equations.
fn polar(q: [f64; 2], v: [f64; 2], a: [f64; 2]) -> [f64; 2] {
    let (m, g) = (2.0, 9.81);
    let turning = (0.3 + m * q[1] * q[1]) * a[0] + 2.0 * m * q[1] * v[1] * v[0] + m * g * q[1] * q[0].sin();
    [turning, m * a[1] - m * q[1] * v[0] * v[0] - m * g * q[0].cos()]
}

#[test]
fn laws_of_a_sliding_joint() {
    let arm = |slide: &str| {
        read(&format!(
            "name: polar
convention: modified
gravity: [0, -9.81, 0]
joints:
  - {{ type: revolute, torque: 20 }}
  - {{ type: prismatic, alpha: pi/2, torque: 50{slide} }}
links:
  - {{ M: 1, MS: [0, 0, 0], I: [0.3, 0.3, 0.3, 0, 0, 0] }}
  - {{ M: 2, MS: [0, 0, 0], I: [0, 0, 0, 0, 0, 0] }}
"
        ))
    };
    check(&arm(""), "polar arm", polar);
    check(&arm(", drive: { joint_elasticity: 4000 }"), "joint_elasticity", |q, v, a| {
        polar([q[0], q[1] - polar(q, v, a)[1] / 4000.0], v, a)
    });
    check(&arm(", drive: { gear_coupling: { joint: 1, CQ: 0.1 } }"), "gear_coupling", |q, v, a| {
        let link = |x: [f64; 2]| [x[0], x[1] + 0.1 * x[0]];
        let load = polar(link(q), link(v), link(a));
        [load[0] + 0.1 * load[1], load[1]]
    });
}

#[test]
fn geometry_and_bodies() {
    let zero = planar("", ", encoder_offset: 0.1, torque_ripple: { RN: 5, RS: 0.2 }", "");
    check(&zero, "encoder_offset", |q, v, a| {
        let mut tau = plain(rods([q[0], q[1] + 0.1], v, a), v, a);
        tau[1] += 0.2 * (5.0 * (q[1] + 0.1)).sin();
        tau
    });
    // About z of a base whose plane contains gravity, pitch and roll shorten gravity's component in
    // the plane.
    check(&planar("", "", "effects: { base_tilt: { roll: 0.2 } }"), "base_tilt", |q, v, a| {
        let (upright, weight) = (rods(q, v, a), rods(q, [0.0; 2], [0.0; 2]));
        plain([0, 1].map(|j| upright[j] + (0.2_f64.cos() - 1.0) * weight[j]), v, a)
    });
    check(&planar("", "", "effects: { link_inertia_error: { link: 2, M: 0.1 } }"), "link_inertia_error", |q, v, a| {
        // A mass in the elbow: at 0.5 m from the shoulder.
        let mut load = rods(q, v, a);
        load[0] += 0.1 * 0.5 * (0.5 * a[0] + 9.81 * q[0].cos());
        plain(load, v, a)
    });
    check(
        &planar("", ", geometric_error: { DD: 0.1, DR: 0 }", "effects: { payload: { M: 0 } }"),
        "lengths",
        |q, v, a| {
            let longer = planar_text("", "", "").replace("d: 0.5", "d: 0.6");
            predicted(&read(&longer), &[q, v, a])
        },
    );
}

#[test]
fn a_payload_of_mass_alone_is_a_point() {
    let robot = planar("", "", "effects: { payload: { M: 0.3, MSX: 0.12 } }");
    check(&robot, "payload", |q, v, a| {
        // 0.3 kg at 0.4 m along the second link.
        let (x, g) = (0.4, 9.81);
        let (c, s) = (q[1].cos(), q[1].sin());
        let w = a[0] + a[1];
        let mut load = rods(q, v, a);
        let reach = x * x * w + x * 0.5 * (a[0] * c + v[0] * v[0] * s) + g * x * (q[0] + q[1]).cos();
        load[1] += 0.3 * reach;
        let speed = v[0] + v[1];
        load[0] += 0.3 * (reach + 0.5 * (0.5 * a[0] + x * (w * c - speed * speed * s)) + g * 0.5 * q[0].cos());
        plain(load, v, a)
    });
}

const MANY: [&str; 3] = [
    ", stribeck_friction: { FS: 0.5, VS: 0.1, DS: 1.5 }, torque_ripple: { RN: 7, RC: 0.2, RS: -0.1 }, joint_elasticity: 800, torque_gain_error: 1.05, presliding_hysteresis: { HC: 0.3, HX: 0.02 }, encoder_offset: 0.02",
    ", nonlinear_viscous_friction: { FN: 0.2, EN: 0.6 }, load_dependent_friction: 0.1, friction_drift: { DA: 0.6, DT: 2 }, gear_coupling: { joint: 1, KC: 1, IAM: 0.01, FVM: 0.05, FCM: 0.1 }, joint_spring: { KS: 1, QS: 0.2 }, position_dependent_friction: { PC: 0.05, PS: 0.02, PN: 2 }, asymmetric_friction: { FCA: 0.02, FVA: 0.01 }, backlash: 0.002, torque_saturation: 6, torque_offset: 0.1, time_delay: 0.004",
    "effects: { base_tilt: { roll: 0.05, pitch: 0.02 }, payload: { M: 0.2, MSX: 0.05 } }",
];

/// The crate of a robot with many effects, compiled by itself: passes its own tests, and has the
/// interpreter's results to the last bit.
#[test]
fn the_generated_crate_says_the_same_bits() {
    let text = planar_text(MANY[0], MANY[1], MANY[2]);
    let robot = read(&text);
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("effects_crate");
    for (path, text) in dh_codegen::krate(&robot, &text) {
        let path = folder.join(path);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, text).unwrap();
    }
    let predictor = FileTorqueModel::new(&robot).unwrap();
    let phi = param::standard_values(&robot.effective()).unwrap();
    let arm = Interpreted::with_effects(&robot, &[Function::DriveTorques]);
    let mut rows = String::new();
    for state in &STATES {
        let tau = predicted(&robot, state).map(f64::to_bits);
        let parameters: Vec<f64> = phi.iter().copied().chain([0.3, -0.6, 1.2, 1.7]).collect();
        let states = States { len: 1, q: state[0].to_vec(), dq: state[1].to_vec(), ddq: state[2].to_vec() };
        let mut drives = [0.0; 2];
        arm.run(Function::DriveTorques, &states, &[], &parameters, &mut drives);
        rows += &format!("    ({state:?}, {tau:?}, {:?}),\n", drives.map(f64::to_bits));
    }
    // The motion of a log, with the memory of the drives.
    let time: Vec<f64> = (0..50).map(|k| 0.01 * f64::from(k)).collect();
    let swing = |k: usize, j: usize| {
        let (t, w) = (time[k], 9.0 + 4.0 * j as f64);
        [0.3 * (w * t).sin(), 0.3 * w * (w * t).cos(), -0.3 * w * w * (w * t).sin()]
    };
    let of =
        |which: usize| (0..2).flat_map(|j| (0..50).map(move |k| (k, j))).map(|(k, j)| swing(k, j)[which]).collect();
    let states = States { len: 50, q: of(0), dq: of(1), ddq: of(2) };
    let mut undelayed = robot.clone();
    undelayed.joints[1].drive.effects.retain(|e| e.name() != "time_delay");
    let mut along = vec![0.0; 100];
    FileTorqueModel::new(&undelayed).unwrap().torques_along(&time, &states, &[], &mut along);
    let steps: String = (0..50)
        .map(|k| {
            let s: [[f64; 2]; 3] = [0, 1, 2].map(|which| [swing(k, 0)[which], swing(k, 1)[which]]);
            format!("    ({s:?}, {:?}),\n", [along[k], along[50 + k]])
        })
        .collect();
    assert_eq!(predictor.delays(), [0.0, 0.004]);
    let test = format!(
        "use planar2r_effects::runtime::Pack;
use planar2r_effects::*;

type Row = ([[f64; 2]; 3], [u64; 2], [u64; 2]);
const ROWS: [Row; {}] = [
{rows}];
const STEPS: [([[f64; 2]; 3], [f64; 2]); 50] = [
{steps}];

#[test]
fn bits() {{
    let phi = STANDARD_VALUES.unwrap();
    for ([q, dq, ddq], tau, drives) in &ROWS {{
        assert_eq!(inverse_dynamics(q, dq, ddq, &phi).map(f64::to_bits), *tau);
        assert_eq!(drive_torques(q, dq, ddq, &phi, &[0.3, -0.6], &[1.2, 1.7]).map(f64::to_bits), *drives);
        let pack = |x: &[f64; 2]| x.map(|x| Pack::new([x; 8]));
        let packed = inverse_dynamics(&pack(q), &pack(dq), &pack(ddq), &phi.map(|p| Pack::new([p; 8])));
        assert_eq!(packed.map(|p| p.to_array()[5].to_bits()), *tau);
        let single = |x: &[f64; 2]| x.map(|x| x as f32);
        let near = inverse_dynamics(&single(q), &single(dq), &single(ddq), &phi.map(|p| p as f32));
        for (a, b) in near.iter().zip(tau) {{
            assert!((f64::from(*a) - f64::from_bits(*b)).abs() < 1e-4);
        }}
    }}
}}

#[test]
fn a_drive_steps_like_the_evaluator() {{
    let phi = STANDARD_VALUES.unwrap();
    let mut drive = Drive::new(&STEPS[0].0[0], &STEPS[0].0[1]);
    for (k, ([q, dq, ddq], tau)) in STEPS.iter().enumerate() {{
        let dt = if k == 0 {{ 0.0 }} else {{ 0.01 }};
        let found = if k == 0 {{ drive.torques(dq, ddq, &phi) }} else {{ drive.step(dt, q, dq, ddq, &phi) }};
        assert!(found.iter().zip(tau).all(|(a, b)| (a - b).abs() < 1e-9), \"{{k}}: {{found:?}} {{tau:?}}\");
    }}
    assert_eq!(TIME_DELAY, [0.0, 0.004]);
}}
",
        STATES.len()
    );
    std::fs::create_dir_all(folder.join("tests")).unwrap();
    std::fs::write(folder.join("tests/bits.rs"), test).unwrap();
    let run = Command::new(env!("CARGO"))
        .args(["test", "--quiet", "--target-dir"])
        .arg(folder.join("target"))
        .current_dir(&folder)
        .env_remove("RUSTFLAGS")
        .output()
        .unwrap();
    let said = [run.stdout, run.stderr].map(|o| String::from_utf8_lossy(&o).into_owned()).concat();
    assert!(run.status.success(), "{said}");
    assert!(!said.contains("warning"), "{said}");
}

/// The simulator computes torques by its own physics: without a loop, on smooth motion, they agree
/// with the predicted ones.
#[test]
fn a_simulated_log_is_what_was_predicted() {
    let without = |text: &str, law: &str| text.replace(law, "");
    let stiff = without(MANY[0], "joint_elasticity: 800, ");
    let cases = [
        // Its bristles also have damping (LuGre, not Dahl), so hysteresis is another case.
        (
            without(&stiff, ", presliding_hysteresis: { HC: 0.3, HX: 0.02 }"),
            without(MANY[1], "backlash: 0.002, "),
            MANY[2],
            5e-4, // it shifts late torques on cubics of 5 ms, steps of friction too
        ),
        (stiff, without(MANY[1], "backlash: 0.002, "), MANY[2], 0.01),
        (", joint_elasticity: 800".into(), String::new(), "", 0.02),
    ];
    for (shoulder, elbow, whole, tolerance) in cases {
        let robot = planar(&shoulder, &elbow, whole);
        let rest = |t: f64| 1.0 - (-t * t).exp();
        let len = 801;
        let columns: Vec<Vec<f64>> = (0..2)
            .map(|j| {
                let w = 2.0 + j as f64;
                (0..len).map(|k| 0.005 * k as f64).map(|t| rest(t) * (w * t).sin() - 0.5 * rest(t)).collect()
            })
            .collect();
        let t: Vec<f64> = (0..len).map(|k| 0.005 * k as f64).collect();
        let trajectory = Trajectory::new(2, t, columns.concat(), None, None).unwrap();
        let simulator = Simulator::new(&robot, &Effects::default()).unwrap();
        let request = Request {
            control: Control { mode: Mode::Exact, ..Control::default() },
            sensors: Sensors::perfect(200.0),
            ..Request::default()
        };
        let run = simulator.run(&trajectory, &request, &mut |_| {}).unwrap();
        let n = run.truth.t.len();
        // The measured motion.
        let offsets: Vec<f64> = robot.laws().iter().map(|l| l.encoder_offset).collect();
        let q: Vec<f64> = run.truth.motor_q.iter().enumerate().map(|(at, q)| q - offsets[at / n]).collect();
        let ddq: Vec<f64> = (0..2)
            .flat_map(|j| {
                let trajectory = &trajectory;
                run.truth.t.iter().map(move |&t| {
                    let mut points = [[0.0; 3]; 2];
                    trajectory.at(t, &mut 0, &mut points);
                    points[j][2]
                })
            })
            .collect();
        let states = States { len: n, q, dq: run.truth.motor_dq.clone(), ddq };
        let mut predicted = vec![0.0; 2 * n];
        FileTorqueModel::new(&robot).unwrap().torques_along(&run.truth.t, &states, &[], &mut predicted);
        let tau: Vec<&Vec<f64>> = (0..2).map(|j| &run.log.columns[run.log.layout.roles.len() - 4 + j]).collect();
        for j in 0..2 {
            let scale = tau[j].iter().fold(0.0_f64, |m, t| m.max(t.abs()));
            let mut errors: Vec<f64> = (0..n).map(|k| (predicted[j * n + k] - tau[j][k]).abs() / scale).collect();
            errors.sort_by(f64::total_cmp);
            // At a reversal the simulator's bristles need some microradians to reverse.
            assert!(errors[n * 95 / 100] < tolerance, "joint {}: {}", j + 1, errors[n * 95 / 100]);
        }
    }
}

/// Links oscillate on the springs of both joints: the simulator integrates two inertias per joint,
/// and the file's law follows the motors' recorded motion.
#[test]
fn links_swing_on_their_springs() {
    let text = planar_text(", joint_elasticity: { KE: 40, DE: 0.5 }", ", joint_elasticity: { KE: 12, DE: 0.06 }", "")
        .replace("torque: 8, drive: {", "torque: 8, drive: { rotor_inertia: 0.02,")
        .replace(", coulomb_friction: 0.2", "")
        .replace(", coulomb_friction: 0.1", "");
    let robot = read(&text);
    let len = 601;
    let t: Vec<f64> = (0..len).map(|k| 0.02 * f64::from(k)).collect();
    let wave = |w: f64, t: f64| 0.3 * (0.2 * w * t).sin() + 0.05 * (w * t).sin();
    let q = [9.0, 14.0].iter().flat_map(|w| t.iter().map(|t| wave(*w, *t)).collect::<Vec<f64>>()).collect();
    let trajectory = Trajectory::new(2, t, q, None, None).unwrap();
    let request = Request { sensors: Sensors::perfect(1000.0), ..Request::default() };
    let truth =
        Simulator::new(&robot, &Effects::default()).unwrap().run(&trajectory, &request, &mut |_| {}).unwrap().truth;
    let n = truth.t.len();
    let ddq: Vec<f64> =
        (0..2).flat_map(|j| denavit::data::signal::central(&truth.motor_dq[j * n..(j + 1) * n], 1e-3)).collect();
    let states = States { len: n, q: truth.motor_q.clone(), dq: truth.motor_dq.clone(), ddq };
    let predictor = FileTorqueModel::new(&robot).unwrap();
    let (mut still, mut swings) = (vec![0.0; 2 * n], vec![0.0; 2 * n]);
    predictor.torques(&states, &mut still);
    predictor.torques_along(&truth.t, &states, &[], &mut swings);
    for j in 0..2 {
        // Its initial oscillation has decayed after half of the motion.
        let rms = |x: &[f64]| {
            let span = j * n + n / 2..(j + 1) * n - 5;
            (span.clone().map(|k| (x[k] - truth.motor_torque[k]).powi(2)).sum::<f64>() / span.len() as f64).sqrt()
        };
        let (a, b) = (rms(&still), rms(&swings));
        assert!(a > 0.02 && b < 0.05 * a, "joint {}: {a} standing, {b} swinging", j + 1);
    }
}

/// A file without effects is the rigid arm.
#[test]
fn a_file_without_effects_is_the_rigid_arm() {
    let robot = planar("", "", "");
    let arm = Interpreted::new(&robot, &[]);
    let phi = param::standard_values(&robot).unwrap();
    for state in &STATES {
        let states = States { len: 1, q: state[0].to_vec(), dq: state[1].to_vec(), ddq: state[2].to_vec() };
        let mut rigid = [0.0; 2];
        arm.inverse_dynamics(&states, &phi, &mut rigid);
        assert_eq!(rigid, predicted(&robot, state));
    }
    let run = Interpreter::new(arm.model(), &[Function::InverseDynamics]);
    let state = State { q: &STATES[0][0], dq: &STATES[0][1], ddq: &STATES[0][2], tau: &[], parameters: &phi };
    assert_eq!(run.one(Function::InverseDynamics, &state), predicted(&robot, &STATES[0]));
}
