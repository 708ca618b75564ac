//! The tapes against the numeric recursion, which shares no code with them, on hundreds of random
//! chains.

use denavit::model::rigid_body::Numeric;
use denavit::model::rigid_body::base::rank;
use denavit::model::rigid_body::random::{Family, State as RandomState};
use denavit::numerics::prng::Random;
use dh_codegen::arm::param::standard_values;
use dh_codegen::arm::{BaseParameters, Function, Model};
use dh_codegen::interpret::{Interpreter, State};
use nalgebra::{DMatrix, DVector, Matrix4};

fn close(what: &str, a: f64, b: f64, size: f64) {
    assert!((a - b).abs() <= 1e-11 * (1.0 + size), "{what}: {a} is not {b}");
}

fn rows_of(m: &Matrix4<f64>) -> Vec<f64> {
    (0..3).flat_map(|i| (0..4).map(move |j| m[(i, j)])).collect()
}

fn row_major<R: nalgebra::Dim, S: nalgebra::RawStorage<f64, R, nalgebra::Dyn>>(
    m: &nalgebra::Matrix<f64, R, nalgebra::Dyn, S>,
) -> Vec<f64> {
    (0..m.nrows()).flat_map(|i| (0..m.ncols()).map(move |j| m[(i, j)])).collect()
}

fn compare(what: &str, got: &[f64], expected: &[f64]) {
    assert_eq!(got.len(), expected.len(), "{what}");
    let size = expected.iter().fold(0.0f64, |s, x| s.max(x.abs()));
    for (i, (a, b)) in got.iter().zip(expected).enumerate() {
        close(&format!("{what} entry {i}"), *a, *b, size);
    }
}

#[test]
fn every_function_agrees_on_random_chains() {
    for seed in 0..240 {
        let mut random = Random::new(seed);
        let robot = random.robot(&Family { base: if seed % 3 == 0 { 1.0 } else { 0.0 }, ..Family::default() });
        let model = Model::new(&robot);
        let n = model.dof();
        if n == 0 {
            continue;
        }
        let run = Interpreter::new(&model, &Function::ALL);
        let oracle = Numeric::new(&robot);
        let phi = standard_values(&robot).unwrap_or_else(|| random.phi(&robot));
        let beta = model.base().values(&phi);
        for _ in 0..3 {
            let RandomState { q, dq, ddq } = random.state(&robot);
            let tau = oracle.inverse_dynamics(&q, &dq, &ddq, &phi);
            let at = |f: Function, parameters: &[f64]| {
                run.one(f, &State { q: &q, dq: &dq, ddq: &ddq, tau: tau.as_slice(), parameters })
            };
            let name = |f: Function| format!("{} of {seed}", f.name());
            let check =
                |f: Function, parameters: &[f64], expected: &[f64]| compare(&name(f), &at(f, parameters), expected);
            check(Function::Frames, &[], &oracle.frames(&q).iter().flat_map(rows_of).collect::<Vec<_>>());
            check(Function::ForwardKinematics, &[], &rows_of(&oracle.frames(&q)[robot.joints.len() - 1]));
            check(Function::ToolPose, &[], &rows_of(&oracle.tool(&q)));
            check(Function::Jacobian, &[], &row_major(&oracle.jacobian(&q)));
            check(Function::JacobianDotVelocity, &[], oracle.jacobian_dot_dq(&q, &dq).as_slice());
            check(Function::InverseDynamics, &phi, tau.as_slice());
            check(Function::InverseDynamicsBase, &beta, tau.as_slice());
            check(Function::MassMatrix, &beta, &row_major(&oracle.mass_matrix(&q, &phi)));
            check(Function::Coriolis, &beta, oracle.coriolis(&q, &dq, &phi).as_slice());
            // An offset that can't be told from a prismatic joint's weight is in the gravity torque
            // (see `BaseParameters`).
            let mut gravity = oracle.gravity(&q, &phi);
            for (k, offset) in model.offsets_in_gravity(&phi) {
                gravity[k] += offset;
            }
            check(Function::Gravity, &beta, gravity.as_slice());
            check(Function::Regressor, &[], &row_major(&oracle.regressor(&q, &dq, &ddq)));
            check(Function::PayloadRegressor, &[], &row_major(&oracle.payload_regressor(&q, &dq, &ddq)));
            let links = 10 * robot.joints.len();
            let still = oracle.regressor(&q, &vec![0.0; n], &vec![0.0; n]).columns(0, links).into_owned();
            check(Function::GravityRegressor, &[], &row_major(&still));
            let sum = |f: Function| at(f, &[]).iter().zip(&phi).map(|(h, p)| h * p).sum::<f64>();
            let kinetic = oracle.kinetic_energy(&q, &dq, &phi);
            close(&name(Function::KineticEnergyRegressor), sum(Function::KineticEnergyRegressor), kinetic, kinetic);
            // Offsets act as a potential of their own: take them out of the sum.
            let names: Vec<String> = model.standard().iter().map(|p| p.name()).collect();
            let of_links: f64 = at(Function::PotentialEnergyRegressor, &[])
                .iter()
                .zip(&phi)
                .zip(&names)
                .filter(|(_, n)| !n.starts_with("FO"))
                .map(|((h, p), _)| h * p)
                .sum();
            close("potential energy", of_links, oracle.potential_energy(&q, &phi), 10.0);
            let wb = DMatrix::from_row_slice(n, beta.len(), &at(Function::BaseRegressor, &[]));
            compare(
                "base regressor times base parameters",
                (wb * DVector::from_column_slice(&beta)).as_slice(),
                tau.as_slice(),
            );
            // Where a joint carries nothing there is no forward dynamics.
            if oracle.inverse_mass_matrix(&q, &phi).is_some() {
                let found = at(Function::ForwardDynamics, &beta);
                let condition = {
                    let s = oracle.mass_matrix(&q, &phi).singular_values();
                    s.max() / s.min()
                };
                for (a, b) in found.iter().zip(&ddq) {
                    assert!((a - b).abs() < 1e-12 * condition * 10.0 + 1e-9, "forward dynamics of {seed}: {a} {b}");
                }
            }
        }
    }
}

/// The closed-form grouping has as many columns as the regressor has rank, and spans the same.
#[test]
fn base_parameters_are_as_many_as_the_rank() {
    for seed in 0..400 {
        let robot = Random::new(seed).robot(&Family { base: 0.3, ..Family::default() });
        let base = BaseParameters::new(&robot);
        let found = rank(&robot, seed, 60);
        assert!(found.gap > 1e4, "seed {seed}: the rank itself is in doubt: {found:?}");
        assert_eq!(base.len(), found.rank, "seed {seed}: {robot:#?}");
    }
}
