//! The tapes against the numeric recursion, which shares no code with them, on hundreds of random
//! chains.

use denavit::model::rigid_body::Numeric;
use denavit::model::rigid_body::base::rank;
use denavit::model::rigid_body::random::{Family, State as RandomState};
use denavit::numerics::prng::Random;
use dh_codegen::arm::param::{DriveTerm, Parameter, standard_values};
use dh_codegen::arm::{BaseParameters, Function, Model};
use dh_codegen::interpret::{Interpreter, State};
use nalgebra::{DMatrix, DVector, Matrix4, Vector3};

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

/// Jacobian of the tool frame's origin: that of the last frame, plus the effect of its rotation on
/// the offset.
fn tool_jacobian(oracle: &Numeric, q: &[f64]) -> DMatrix<f64> {
    let mut jacobian = oracle.jacobian(q);
    let origin = |m: &Matrix4<f64>| m.fixed_view::<3, 1>(0, 3).into_owned();
    let arm = oracle.frames(q).last().map_or_else(Vector3::zeros, |last| origin(&oracle.tool(q)) - origin(last));
    for mut column in jacobian.column_iter_mut() {
        let moved = column.fixed_rows::<3>(0) + column.fixed_rows::<3>(3).cross(&arm);
        column.fixed_rows_mut::<3>(0).copy_from(&moved);
    }
    DMatrix::from_fn(6, jacobian.ncols(), |i, j| jacobian[(i, j)])
}

/// Number of random chains: fewer without optimisation.
const CHAINS: u64 = if cfg!(debug_assertions) { 80 } else { 240 };

#[test]
fn every_function_agrees_on_random_chains() {
    for seed in 0..CHAINS {
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
            check(Function::ToolJacobian, &[], &row_major(&tool_jacobian(&oracle, &q)));
            check(Function::JacobianDotVelocity, &[], oracle.jacobian_dot_dq(&q, &dq).as_slice());
            check(Function::InverseDynamics, &phi, tau.as_slice());
            check(Function::InverseDynamicsBase, &beta, tau.as_slice());
            check(Function::MassMatrix, &beta, &row_major(&oracle.mass_matrix(&q, &phi)));
            check(Function::Coriolis, &beta, oracle.coriolis(&q, &dq, &phi).as_slice());
            // An offset that can't be separated from a prismatic joint's weight is part of the
            // gravity torque (see `BaseParameters`).
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
            // Offsets act as a potential of their own: removed from the sum.
            let of_links: f64 = at(Function::PotentialEnergyRegressor, &[])
                .iter()
                .zip(&phi)
                .zip(model.standard())
                .filter(|(_, p)| !matches!(p, Parameter::Drive(_, DriveTerm::FO)))
                .map(|((h, p), _)| h * p)
                .sum();
            close("potential energy", of_links, oracle.potential_energy(&q, &phi), 10.0);
            let wb = DMatrix::from_row_slice(n, beta.len(), &at(Function::BaseRegressor, &[]));
            compare(
                "base regressor times base parameters",
                (wb * DVector::from_column_slice(&beta)).as_slice(),
                tau.as_slice(),
            );
            // A joint that carries nothing has no forward dynamics.
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

/// Velocity of a frame by differences of its pose: of its origin, and its angular velocity, both in
/// the axes in which the pose is given.
fn difference(pose: impl Fn(f64) -> Vec<f64>) -> Vec<f64> {
    let step = 1e-5;
    let (here, before, after) = (pose(0.0), pose(-step), pose(step));
    let rate = |i: usize, j: usize| (after[4 * i + j] - before[4 * i + j]) / (2.0 * step);
    let skew = |i: usize, j: usize| (0..3).map(|k| rate(i, k) * here[4 * j + k]).sum::<f64>();
    vec![rate(0, 3), rate(1, 3), rate(2, 3), skew(2, 1), skew(0, 2), skew(1, 0)]
}

/// Poses and Jacobians are in the same axes, those of the world, even if the base is tilted.
#[test]
fn jacobians_are_the_differences_of_poses_over_a_tilted_base() {
    for seed in 0..60 {
        let mut random = Random::new(seed);
        let robot = random.robot(&Family { base: 1.0, ..Family::default() });
        let model = Model::new(&robot);
        let n = model.dof();
        if n == 0 {
            continue;
        }
        let functions = [Function::ForwardKinematics, Function::ToolPose, Function::Jacobian, Function::ToolJacobian];
        let run = Interpreter::new(&model, &functions);
        let RandomState { q, dq, .. } = random.state(&robot);
        let at = |f: Function, t: f64| {
            let q: Vec<f64> = q.iter().zip(&dq).map(|(q, dq)| q + t * dq).collect();
            run.one(f, &State { q: &q, dq: &dq, ddq: &[], tau: &[], parameters: &[] })
        };
        for (pose, jacobian) in
            [(Function::ForwardKinematics, Function::Jacobian), (Function::ToolPose, Function::ToolJacobian)]
        {
            let twist = DMatrix::from_row_slice(6, n, &at(jacobian, 0.0)) * DVector::from_column_slice(&dq);
            let expected = difference(|t| at(pose, t));
            let size = twist.amax().max(dq.iter().fold(0.0, |s, x| s.max(x.abs())));
            for (a, b) in twist.iter().zip(&expected) {
                assert!((a - b).abs() < 1e-7 * (1.0 + size.powi(3)), "{} of {seed}: {a} is not {b}", jacobian.name());
            }
        }
    }
}

/// The closed-form grouping has as many columns as the regressor has rank, and spans the same
/// space.
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
