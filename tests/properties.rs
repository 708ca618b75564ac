//! Laws of mechanics that hold for every arm, tested on random chains without an oracle.
//!
//! There are few cases each: a chain of eight rows takes a good part of a second to prepare at this
//! profile's optimisation, and `tests/oracle.rs` runs over hundreds of chains anyway.

use denavit::model::rigid_body::random::Family;
use denavit::numerics::prng::Random;
use dh_codegen::arm::param::{DriveTerm, Parameter, standard_values};
use dh_codegen::arm::{Function, Model};
use dh_codegen::interpret::{Interpreter, State};
use dh_codegen::robot::{Angle, Convention, Inertia, JointKind, Length, Robot};
use nalgebra::{DMatrix, DVector, Matrix3, Rotation3, Vector3};
use proptest::prelude::*;

/// An interpreted arm with its own parameters.
struct Arm {
    model: Model,
    run: Interpreter,
    phi: Vec<f64>,
    beta: Vec<f64>,
    n: usize,
}

impl Arm {
    fn new(robot: &Robot, functions: &[Function]) -> Self {
        let model = Model::new(robot);
        let phi = standard_values(robot).unwrap();
        Self { run: Interpreter::new(&model, functions), beta: model.base().values(&phi), n: model.dof(), phi, model }
    }

    fn at(&self, f: Function, [q, dq, ddq]: [&[f64]; 3], parameters: &[f64]) -> Vec<f64> {
        self.run.one(f, &State { q, dq, ddq, tau: &[], parameters })
    }

    /// A function of the configuration alone.
    fn still(&self, f: Function, q: &[f64]) -> Vec<f64> {
        self.at(f, [q, &[], &[]], &self.beta)
    }

    fn mass(&self, q: &[f64]) -> DMatrix<f64> {
        DMatrix::from_row_slice(self.n, self.n, &self.still(Function::MassMatrix, q))
    }

    fn torque(&self, state: [&[f64]; 3], phi: &[f64]) -> DVector<f64> {
        DVector::from_vec(self.at(Function::InverseDynamics, state, phi))
    }
}

/// Positions `q + h dq`.
fn moved(q: &[f64], h: f64, dq: &[f64]) -> Vec<f64> {
    q.iter().zip(dq).map(|(q, dq)| q + h * dq).collect()
}

/// Derivative at zero by central differences of fourth order: for arms that turn at tens of rad/s
/// the error is near 1e-8.
fn slope(f: impl Fn(f64) -> Vec<f64>) -> DVector<f64> {
    let h = 3e-4;
    let difference = |h: f64| DVector::from_vec(f(h)) - DVector::from_vec(f(-h));
    (difference(h) * 8.0 - difference(2.0 * h)) / (12.0 * h)
}

/// Difference of two vectors, relative to their size if that is above one.
fn apart(a: &DVector<f64>, b: &DVector<f64>) -> f64 {
    (a - b).amax() / (1.0 + b.amax())
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// A random chain with at least one moving joint, and random numbers for its states.
fn chain() -> impl Strategy<Value = (Robot, Random)> {
    (any::<u64>(), 1usize..=8)
        .prop_map(|(seed, rows)| {
            let family = Family { rows: [rows, rows], ..Family::default() };
            (Random::new(seed).robot(&family), Random::new(!seed))
        })
        .prop_filter("nothing moves", |(robot, _)| robot.dof() > 0)
}

/// Seeds do not shrink to anything simpler, and a failing chain is identified by its message.
fn few(cases: u32) -> ProptestConfig {
    ProptestConfig { cases, max_shrink_iters: 0, failure_persistence: None, ..ProptestConfig::default() }
}

proptest! {
    #![proptest_config(few(24))]

    #[test]
    fn torque_is_linear_in_the_parameters((robot, mut random) in chain()) {
        let arm = Arm::new(&robot, &[Function::InverseDynamics]);
        let [q, dq, ddq] = [3.0, 2.0, 5.0].map(|size| random.vector(arm.n, size));
        let [one, two] = [1.0, 1.0].map(|size| random.vector(arm.phi.len(), size));
        let (a, b) = (random.even(2.0), random.even(2.0));
        let mixed: Vec<f64> = one.iter().zip(&two).map(|(one, two)| a * one + b * two).collect();
        let torque = |phi: &[f64]| arm.torque([&q, &dq, &ddq], phi);
        prop_assert!(apart(&torque(&mixed), &(torque(&one) * a + torque(&two) * b)) < 1e-11);
    }

    /// Energy balance: `d(T + U)/dt = tau' dq - friction power`. An offset acts as a potential of
    /// its own, so it is in `U`.
    #[test]
    fn power_in_is_energy_gained_and_friction((robot, mut random) in chain()) {
        use Function::{InverseDynamics, KineticEnergyRegressor, PotentialEnergyRegressor};
        let arm = Arm::new(&robot, &[InverseDynamics, KineticEnergyRegressor, PotentialEnergyRegressor]);
        let [q, dq, ddq] = [3.0, 2.0, 5.0].map(|size| random.vector(arm.n, size));
        let energy = |t: f64| {
            let (q, dq) = (moved(&moved(&q, t, &dq), 0.5 * t * t, &ddq), moved(&dq, t, &ddq));
            let of = |f| dot(&arm.at(f, [&q, &dq, &[]], &[]), &arm.phi);
            vec![of(KineticEnergyRegressor) + of(PotentialEnergyRegressor)]
        };
        let friction: f64 = arm.model.standard().iter().zip(&arm.phi).map(|(parameter, value)| match *parameter {
            Parameter::Drive(row, term) => {
                let v = dq[arm.model.chain().rows[row].dof.unwrap()];
                match term {
                    DriveTerm::FV => value * v * v,
                    DriveTerm::FC => value * v.abs(),
                    _ => 0.0,
                }
            }
            Parameter::Link(..) => 0.0,
        }).sum();
        let power = arm.torque([&q, &dq, &ddq], &arm.phi).dot(&DVector::from_vec(dq.clone()));
        let (gained, given) = (slope(energy)[0], power - friction);
        prop_assert!((gained - given).abs() < 1e-6 * (1.0 + given.abs() + power.abs()), "{gained} {given}");
    }

    /// Every link of these chains is a real body, so no motion is free of inertia; and
    /// `T = dq' M dq / 2`.
    #[test]
    fn mass_matrix_is_symmetric_positive_definite((robot, mut random) in chain()) {
        let arm = Arm::new(&robot, &[Function::MassMatrix, Function::KineticEnergyRegressor]);
        let [q, dq] = [3.0, 2.0].map(|size| random.vector(arm.n, size));
        let mass = arm.mass(&q);
        prop_assert_eq!(&mass, &mass.transpose());
        let values = mass.symmetric_eigenvalues();
        prop_assert!(values.min() > 1e-9 * values.max(), "{}", values);
        let kinetic = dot(&arm.at(Function::KineticEnergyRegressor, [&q, &dq, &[]], &[]), &arm.phi);
        let v = DVector::from_vec(dq);
        prop_assert!((0.5 * v.dot(&(&mass * &v)) - kinetic).abs() < 1e-11 * (1.0 + kinetic));
    }

    /// `C dq` follows from the mass matrix by Christoffel's symbols, so `dM/dt - 2 C` is skew.
    #[test]
    fn coriolis_torques_come_from_the_mass_matrix((robot, mut random) in chain()) {
        let arm = Arm::new(&robot, &[Function::MassMatrix, Function::Coriolis]);
        let [q, dq] = [3.0, 2.0].map(|size| random.vector(arm.n, size));
        let along = |direction: &[f64]| {
            let slope = slope(|h| arm.still(Function::MassMatrix, &moved(&q, h, direction)));
            DMatrix::from_column_slice(arm.n, arm.n, slope.as_slice()) // symmetric, so either order will do
        };
        let v = DVector::from_vec(dq.clone());
        let coriolis = DVector::from_vec(arm.at(Function::Coriolis, [&q, &dq, &[]], &arm.beta));
        // c = (dM/dt) dq - grad(dq' M dq) / 2
        let gradient = DVector::from_fn(arm.n, |k, _| {
            let axis: Vec<f64> = (0..arm.n).map(|j| f64::from(u8::from(j == k))).collect();
            v.dot(&(along(&axis) * &v))
        });
        let rate = along(&dq) * &v;
        prop_assert!(apart(&coriolis, &(&rate - gradient * 0.5)) < 1e-6);
        prop_assert!((v.dot(&rate) - 2.0 * v.dot(&coriolis)).abs() < 1e-6 * (1.0 + v.dot(&rate).abs()));
    }

    /// The Jacobian gives the velocity of the last frame, and its rate the acceleration at constant
    /// `dq`.
    #[test]
    fn jacobian_is_the_derivative_of_the_frame((robot, mut random) in chain()) {
        use Function::{ForwardKinematics, Jacobian, JacobianDotVelocity};
        let arm = Arm::new(&robot, &[ForwardKinematics, Jacobian, JacobianDotVelocity]);
        let [q, dq] = [3.0, 2.0].map(|size| random.vector(arm.n, size));
        let twist = |h: f64| {
            let jacobian = DMatrix::from_row_slice(6, arm.n, &arm.still(Jacobian, &moved(&q, h, &dq)));
            (jacobian * DVector::from_column_slice(&dq)).as_slice().to_vec()
        };
        let pose = arm.still(ForwardKinematics, &q);
        let rate = slope(|h| arm.still(ForwardKinematics, &moved(&q, h, &dq)));
        let rotation = |pose: &[f64]| Matrix3::from_fn(|i, j| pose[4 * i + j]);
        let spin = rotation(rate.as_slice()) * rotation(&pose).transpose();
        let expected = [rate[3], rate[7], rate[11], spin[(2, 1)], spin[(0, 2)], spin[(1, 0)]];
        prop_assert!(apart(&DVector::from_vec(twist(0.0)), &DVector::from_row_slice(&expected)) < 1e-7);
        let found = DVector::from_vec(arm.at(JacobianDotVelocity, [&q, &dq, &[]], &[]));
        prop_assert!(apart(&found, &slope(twist)) < 1e-7);
    }
}

proptest! {
    #![proptest_config(few(12))] // two arms of up to eight joints in each

    /// The same arm in both conventions has the same motion, the same torques, and as many base
    /// parameters.
    #[test]
    fn both_conventions_describe_one_arm((mut robot, mut random) in chain()) {
        use Function::{ForwardKinematics, InverseDynamics, Jacobian};
        robot.convention = Convention::Standard;
        robot.joints.iter_mut().for_each(|joint| joint.kind = JointKind::Revolute);
        let [one, two] = [&robot, &to_modified(&robot)].map(|r| Arm::new(r, &[ForwardKinematics, Jacobian, InverseDynamics]));
        let [q, dq, ddq] = [3.0, 2.0, 5.0].map(|size| random.vector(one.n, size));
        for function in [ForwardKinematics, Jacobian] {
            let [a, b] = [&one, &two].map(|arm| DVector::from_vec(arm.still(function, &q)));
            prop_assert!(apart(&a, &b) < 1e-12, "{}", function.name());
        }
        let [a, b] = [&one, &two].map(|arm| arm.torque([&q, &dq, &ddq], &arm.phi));
        prop_assert!(apart(&a, &b) < 1e-11, "{a} {b}");
        prop_assert_eq!(one.beta.len(), two.beta.len());
    }
}

/// A standard row is `RotZ TransZ` and then `TransX RotX`; in the modified convention the second
/// half starts the next row. The remainder of the last row is a fixed row without a body.
fn to_modified(robot: &Robot) -> Robot {
    let mut modified = Robot { convention: Convention::Modified, ..robot.clone() };
    let mut last = robot.joints[0].clone();
    (last.kind, last.drive, last.theta, last.r) = (JointKind::Fixed, Default::default(), Angle::zero(), Length::zero());
    modified.joints.push(last);
    let (mut alpha, mut d) = (Angle::zero(), Length::zero());
    for row in 0..modified.joints.len() {
        let joint = &mut modified.joints[row];
        (joint.alpha, joint.d) = (alpha, d);
        if let Some(own) = robot.joints.get(row) {
            (alpha, d) = (own.alpha.clone(), own.d.clone());
            // The body is attached to the frame before the second half.
            let (sin, cos) = alpha.sin_cos();
            let turn = [[1.0, 0.0, 0.0], [0.0, cos, -sin], [0.0, sin, cos]];
            modified.links[row] = robot.links[row].map(|body| body.moved(&turn, &[d.value, 0.0, 0.0]));
        } else {
            (alpha, d) = (Angle::zero(), Length::zero());
        }
    }
    modified.links.push(Some(Inertia::default()));
    modified
}

proptest! {
    #![proptest_config(few(200))] // no arm to build

    #[test]
    fn a_body_moved_there_and_back_is_the_same(seed in any::<u64>()) {
        let mut random = Random::new(seed);
        let body = random.inertia();
        let turn = Rotation3::from_euler_angles(random.even(3.0), random.even(1.5), random.even(3.0));
        let origin = Vector3::from_fn(|_, _| random.even(2.0));
        let rows = |r: &Rotation3<f64>| core::array::from_fn(|i| core::array::from_fn(|j| r[(i, j)]));
        let there = body.moved(&rows(&turn), &origin.into());
        let back = there.moved(&rows(&turn.inverse()), &(turn.inverse() * -origin).into());
        let [body, back] = [body, back].map(|b| DVector::from_column_slice(&b.to_array()));
        prop_assert!((body - back).amax() < 1e-13 * (1.0 + DVector::from_column_slice(&there.to_array()).amax()));
    }
}
