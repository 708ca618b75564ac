//! Prints the tests of a crate, which compare its functions with each other, with differences, and
//! with a stored check vector.

use core::fmt::Write;

use crate::arm::{Function, Inverse, Model};
use crate::interpret::{Interpreter, State};

/// Numbers between -1 and 1 from a fixed sequence.
fn sequence(seed: u64, len: usize) -> Vec<f64> {
    let mut state = seed;
    (0..len)
        .map(|_| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            ((state >> 40) as f64 / (1u64 << 23) as f64) - 1.0
        })
        .collect()
}

fn list(values: &[f64]) -> String {
    let values: Vec<String> = values.iter().map(|v| format!("{v:?}")).collect();
    match values.len() {
        0..=4 => format!("[{}]", values.join(", ")),
        _ => super::parameters::list(&values, 5),
    }
}

/// Text of `src/tests.rs`.
pub(super) fn print(model: &Model, interpreter: &Interpreter) -> String {
    let effects = !model.laws().is_empty();
    let mut t = vectors(model, interpreter, effects);
    t += TOOLS;
    t += KINEMATICS;
    t += INVERSE;
    let redundant = Inverse::new(model.chain()).is_redundant();
    let redundancy = if redundant { "redundancy: IK.redundancy(&Q, &ik::Reference::UP), " } else { "" };
    let dynamics = [DYNAMICS, ENERGIES].concat();
    let t = t.replace("@REDUNDANCY ", redundancy);
    if !effects {
        return t + &dynamics;
    }
    // Springs follow the static law.
    let stiff = if model.laws().iter().any(|l| l.elasticity.is_some()) { "    drive.deflection = None;\n" } else { "" };
    // Gears are warm long after the start; laws that depend on the time use that of the start.
    let steady = match model.reads_clock() {
        true => {
            "clocked_drive_torques(&Q, &DQ, &DDQ, &PHI, &drive.bristle, &drive.warmth(), &core::array::from_fn(|k| if k == 0 { 0.0 } else { drive.temperature[k - 1] }))"
        }
        false => "drive.torques(&DQ, &DDQ, &PHI)",
    };
    t + &dynamics.replace("inverse_dynamics(&", "rigid_dynamics(&")
        + &EFFECTS.replace("@STIFF", stiff).replace("@STEADY", steady)
}

/// Text of a state, parameters, and the torques for them.
fn vectors(model: &Model, interpreter: &Interpreter, effects: bool) -> String {
    let (n, p) = (model.dof(), model.standard().len());
    let (q, dq, ddq) = (sequence(1, n), sequence(2, n), sequence(3, n));
    let phi = sequence(4, p);
    let state = State { q: &q, dq: &dq, ddq: &ddq, tau: &[], parameters: &phi };
    let tau = interpreter.one(if effects { Function::RigidDynamics } else { Function::InverseDynamics }, &state);
    let mut t = String::from(
        "//! The functions against each other and against differences, and a stored check vector.\n\nuse std::vec::Vec;\n\nuse super::*;\n\n",
    );
    let _ = writeln!(t, "const Q: [f64; DOF] = {};", list(&q));
    let _ = writeln!(t, "const DQ: [f64; DOF] = {};", list(&dq));
    let _ = writeln!(t, "const DDQ: [f64; DOF] = {};", list(&ddq));
    let _ = writeln!(t, "const PHI: [f64; STANDARD] = {};", list(&phi));
    let _ = writeln!(
        t,
        "/// Torques by the interpreter of the same tape, bit for bit.\nconst TAU: [f64; DOF] = {};",
        list(&tau)
    );
    if effects {
        let measured = interpreter.one(Function::InverseDynamics, &state);
        let _ = writeln!(
            t,
            "/// The same with the effects of the file.\nconst MEASURED: [f64; DOF] = {};",
            list(&measured)
        );
    }
    t
}

const TOOLS: &str = r#"/// Half the step of central differences, rad or m and their rates.
const STEP: f64 = 1e-5;

fn close(a: f64, b: f64, size: f64) {
    assert!((a - b).abs() <= 1e-11 * (1.0 + size), "{a} is not {b}");
}

/// The same of a central difference.
fn near(a: f64, b: f64, size: f64) {
    assert!((a - b).abs() <= 1e-7 * (1.0 + size), "{a} is not {b}");
}

fn product<const M: usize>(w: &[[f64; M]; DOF], x: &[f64; M]) -> [f64; DOF] {
    core::array::from_fn(|i| dot(&w[i], x))
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// `x + t v`.
fn moved(x: &[f64; DOF], t: f64, v: &[f64; DOF]) -> [f64; DOF] {
    core::array::from_fn(|k| x[k] + t * v[k])
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |m, v| m.max(v.abs()))
}
"#;

const KINEMATICS: &str = r#"
/// Velocity of a frame from two poses of it: of its origin, and its angular velocity.
fn velocity(pose: &[[f64; 4]; 3], before: &[[f64; 4]; 3], after: &[[f64; 4]; 3]) -> [f64; 6] {
    let rate = |i: usize, j: usize| (after[i][j] - before[i][j]) / (2.0 * STEP);
    // The skew matrix of the angular velocity is the rate of R times R'.
    let skew = |i: usize, j: usize| (0..3).map(|k| rate(i, k) * pose[j][k]).sum::<f64>();
    [rate(0, 3), rate(1, 3), rate(2, 3), skew(2, 1), skew(0, 2), skew(1, 0)]
}

#[test]
fn frames_are_rotations_and_the_last_is_forward_kinematics() {
    let frames = frames(&Q);
    for frame in &frames {
        for i in 0..3 {
            for j in 0..3 {
                close(dot(&frame[i][..3], &frame[j][..3]), f64::from(u8::from(i == j)), 1.0);
            }
        }
        let [x, y, z] = frame;
        let cross = [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]];
        close(dot(&cross, &z[..3]), 1.0, 1.0);
    }
    let last = forward_kinematics(&Q);
    for i in 0..3 {
        for j in 0..4 {
            close(frames[ROWS - 1][i][j], last[i][j], last[i][j].abs());
        }
    }
}

#[test]
fn jacobians_are_the_differences_of_their_frames() {
    let check = |jacobian: [[f64; DOF]; 6], pose: fn(&[f64; DOF]) -> [[f64; 4]; 3]| {
        let found = velocity(&pose(&Q), &pose(&moved(&Q, -STEP, &DQ)), &pose(&moved(&Q, STEP, &DQ)));
        for i in 0..6 {
            near(dot(&jacobian[i], &DQ), found[i], largest(&found));
        }
    };
    check(jacobian(&Q), forward_kinematics);
    check(tool_jacobian(&Q), tool_pose);
    let rate = jacobian_dot_velocity(&Q, &DQ);
    let [before, after] = [-STEP, STEP].map(|t| jacobian(&moved(&Q, t, &DQ)));
    for i in 0..6 {
        near(rate[i], (dot(&after[i], &DQ) - dot(&before[i], &DQ)) / (2.0 * STEP), largest(&rate));
    }
}
"#;

const INVERSE: &str = r#"
#[test]
fn postures_reach_their_pose() {
    let pose = forward_kinematics(&Q);
    let query = ik::Query { @REDUNDANCY near: Some(&Q), ..Default::default() };
    let found = inverse_kinematics(&pose, &query).unwrap();
    assert!(!found.as_slice().is_empty());
    for posture in found.as_slice() {
        let reached = forward_kinematics(&posture.q);
        for i in 0..3 {
            for j in 0..4 {
                assert!((reached[i][j] - pose[i][j]).abs() < 1e-9, "{:?}", posture.branch);
            }
        }
    }
    let pose = tool_pose(&Q);
    let found = tool_inverse_kinematics(&pose, &query).unwrap();
    assert!(!found.as_slice().is_empty());
    for posture in found.as_slice() {
        let reached = tool_pose(&posture.q);
        for (a, b) in reached.as_flattened().iter().zip(pose.as_flattened()) {
            assert!((a - b).abs() < 1e-9, "{:?}", posture.branch);
        }
    }
}

#[test]
fn velocities_are_those_of_the_jacobian() {
    let (arm, jacobian) = (IK.with_tool(&TOOL), tool_jacobian(&Q));
    let twist: [f64; 6] = core::array::from_fn(|i| dot(&jacobian[i], &DQ));
    let found = arm.velocities(&Q, &twist, &ik::Differential { near: 0.0, ..Default::default() });
    assert!(found.left[0] + found.left[1] < 1e-5 * largest(&twist), "{:?}", found.left);
    for i in 0..6 {
        near(dot(&arm.jacobian(&Q)[i], &DQ), twist[i], largest(&twist));
    }
}
"#;

const DYNAMICS: &str = r#"
#[test]
fn the_check_vector_comes_out_bit_for_bit() {
    assert_eq!(inverse_dynamics(&Q, &DQ, &DDQ, &PHI), TAU);
}

#[test]
fn regressor_times_parameters_is_inverse_dynamics() {
    let tau = product(&regressor(&Q, &DQ, &DDQ), &PHI);
    let beta = base_parameters(&PHI);
    let from_base = product(&base_regressor(&Q, &DQ, &DDQ), &beta);
    let direct = inverse_dynamics_base(&Q, &DQ, &DDQ, &beta);
    let size = largest(&TAU);
    for i in 0..DOF {
        close(tau[i], TAU[i], size);
        close(from_base[i], TAU[i], size);
        close(direct[i], TAU[i], size);
    }
}

#[test]
fn the_mass_matrix_is_symmetric_and_fits_the_torques() {
    let beta = base_parameters(&PHI);
    let mass = mass_matrix(&Q, &beta);
    let still = inverse_dynamics_base(&Q, &DQ, &[0.0; DOF], &beta);
    let size = largest(&TAU);
    for i in 0..DOF {
        for j in 0..DOF {
            assert_eq!(mass[i][j], mass[j][i]);
        }
        close(dot(&mass[i], &DDQ) + still[i], TAU[i], size);
    }
}

#[test]
fn at_rest_there_is_only_gravity() {
    let beta = base_parameters(&PHI);
    let g = gravity(&Q, &beta);
    let w = gravity_regressor(&Q);
    for i in 0..DOF {
        close(dot(&w[i], &PHI[..10 * ROWS]), g[i], 10.0);
    }
}
"#;

const ENERGIES: &str = r#"
/// Parameters of which those whose names begin with one of `words` are replaced.
fn with(phi: [f64; STANDARD], words: &[&str], value: f64) -> [f64; STANDARD] {
    core::array::from_fn(|k| if words.iter().any(|w| STANDARD_NAMES[k].starts_with(w)) { value } else { phi[k] })
}

#[test]
fn powers_are_the_rates_of_the_energies() {
    let phi = with(PHI, &["FV", "FC"], 0.0);
    let energy = |q: &[f64; DOF], dq: &[f64; DOF]| {
        dot(&kinetic_energy_regressor(q, dq), &phi) + dot(&potential_energy_regressor(q), &phi)
    };
    let at = |t: f64| energy(&moved(&Q, t, &DQ), &moved(&DQ, t, &DDQ));
    let power = dot(&inverse_dynamics(&Q, &DQ, &DDQ, &phi), &DQ);
    near((at(STEP) - at(-STEP)) / (2.0 * STEP), power, at(0.0).abs() + power.abs());
}

#[test]
fn forward_dynamics_undoes_inverse_dynamics() {
    // Bodies that can exist, so that the mass matrix is positive definite.
    let phi = with(with([0.0; STANDARD], &["M", "IA"], 1.0), &["MS"], 0.1);
    let phi = with(with(phi, &["XX", "YY", "ZZ"], 0.3), &["FV", "FC", "FO"], 0.2);
    let beta = base_parameters(&phi);
    let tau = inverse_dynamics_base(&Q, &DQ, &DDQ, &beta);
    let found = forward_dynamics(&Q, &DQ, &tau, &beta);
    let size: Vec<f64> = mass_matrix(&Q, &beta).iter().map(|row| largest(row)).collect();
    for k in 0..DOF {
        assert!((found[k] - DDQ[k]).abs() < 1e-9 * (1.0 + largest(&size)), "{} is not {}", found[k], DDQ[k]);
    }
}
"#;

const EFFECTS: &str = r#"
#[test]
fn effects_come_out_bit_for_bit() {
    assert_eq!(inverse_dynamics(&Q, &DQ, &DDQ, &PHI), MEASURED);
}

#[test]
fn a_drive_that_has_gone_far_is_steady() {
    let mut drive = Drive::new(&Q, &DQ);
    drive.since = 1e9;
    let far: [f64; DOF] = core::array::from_fn(|i| Q[i] - DQ[i] * 1e3);
    drive.q = far;
    drive.bristle = DQ.map(|v| -v.sign());
    drive.step(0.001, &Q, &DQ, &DDQ, &PHI);
@STIFF    let tau = @STEADY;
    for i in 0..DOF {
        close(tau[i], MEASURED[i], MEASURED[i].abs());
    }
}
"#;
