//! The tests that go with a crate: its own consistency, and a stored check vector.

use core::fmt::Write;

use crate::arm::Model;
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
    values.iter().map(|v| format!("{v:?}")).collect::<Vec<_>>().join(", ")
}

/// The text of `src/tests.rs`.
pub(super) fn print(model: &Model, interpreter: &Interpreter) -> String {
    let (n, p) = (model.dof(), model.standard().len());
    let (q, dq, ddq) = (sequence(1, n), sequence(2, n), sequence(3, n));
    let phi = sequence(4, p);
    let state = State { q: &q, dq: &dq, ddq: &ddq, tau: &[], parameters: &phi };
    use crate::arm::Function;
    let effects = !model.laws().is_empty();
    let tau = interpreter.one(if effects { Function::RigidDynamics } else { Function::InverseDynamics }, &state);
    let mut t = String::from(
        "//! Consistency of the generated functions with each other, and a stored check vector.\n\nuse super::*;\n\n",
    );
    let _ = writeln!(t, "const Q: [f64; DOF] = [{}];", list(&q));
    let _ = writeln!(t, "const DQ: [f64; DOF] = [{}];", list(&dq));
    let _ = writeln!(t, "const DDQ: [f64; DOF] = [{}];", list(&ddq));
    let _ = writeln!(t, "const PHI: [f64; STANDARD] = [{}];", list(&phi));
    let _ = writeln!(
        t,
        "/// What the interpreter of the same tape answers, to the last bit.\nconst TAU: [f64; DOF] = [{}];",
        list(&tau)
    );
    if effects {
        let measured = interpreter.one(Function::InverseDynamics, &state);
        let _ = writeln!(
            t,
            "/// The same with the effects of the file.\nconst MEASURED: [f64; DOF] = [{}];",
            list(&measured)
        );
    }
    let body = r#"
fn close(a: f64, b: f64, size: f64) {
    assert!((a - b).abs() <= 1e-11 * (1.0 + size), "{a} is not {b}");
}

fn product<const M: usize>(w: &[[f64; M]; DOF], x: &[f64; M]) -> [f64; DOF] {
    core::array::from_fn(|i| (0..M).map(|k| w[i][k] * x[k]).sum())
}

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
    let size = TAU.iter().fold(0.0f64, |s, t| s.max(t.abs()));
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
    let size = TAU.iter().fold(0.0f64, |s, t| s.max(t.abs()));
    for i in 0..DOF {
        for j in 0..DOF {
            assert_eq!(mass[i][j], mass[j][i]);
        }
        let inertial: f64 = (0..DOF).map(|j| mass[i][j] * DDQ[j]).sum();
        close(inertial + still[i], TAU[i], size);
    }
}

#[test]
fn at_rest_there_is_only_gravity() {
    let beta = base_parameters(&PHI);
    let g = gravity(&Q, &beta);
    let w = gravity_regressor(&Q);
    for i in 0..DOF {
        let sum: f64 = w[i].iter().zip(&PHI).map(|(w, p)| w * p).sum();
        close(sum, g[i], 10.0);
    }
}
"#;
    if !effects {
        return t + body;
    }
    t += &body.replace("inverse_dynamics(&Q", "rigid_dynamics(&Q");
    // Springs as the static law has them.
    let stiff = if model.laws().iter().any(|l| l.elasticity.is_some()) { "    drive.behind = None;\n" } else { "" };
    let steady = r#"
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
@STIFF    let tau = drive.torques(&DQ, &DDQ, &PHI);
    for i in 0..DOF {
        close(tau[i], MEASURED[i], MEASURED[i].abs());
    }
}
"#;
    t + &steady.replace("@STIFF", stiff)
}
