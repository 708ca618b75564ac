//! Tests of single estimators against the numeric recursion.

use std::f64::consts::TAU;

use dh_codegen::arm::param;
use dh_codegen::robot::{Robot, no_files};
use nalgebra::{DMatrix, DVector, Matrix3, Vector3};

use super::super::*;
use crate::model::rigid_body::Numeric;
use crate::numerics::prng::Random;

struct Oracle {
    numeric: Numeric,
    phi: Vec<f64>,
    random: Random,
}

fn array(v: &DVector<f64>) -> [f64; 7] {
    std::array::from_fn(|j| v[j])
}

impl Oracle {
    fn new(seed: u64) -> Self {
        let text = include_str!("../../../../robots/kuka-lwr4.yaml");
        let robot = Robot::from_yaml(text, &no_files).unwrap().robot;
        let phi = param::standard_values(&robot).unwrap();
        Self { numeric: Numeric::new(&robot), phi, random: Random::new(seed) }
    }

    /// Jacobian of the tool's origin in the tool's axes, `6 x 7`.
    fn jacobian(&self, q: &[f64]) -> [[f64; 7]; 6] {
        let (last, tool) = (self.numeric.frames(q).pop().unwrap(), self.numeric.tool(q));
        let jacobian = self.numeric.jacobian(q);
        let lever: Vector3<f64> = tool.fixed_view::<3, 1>(0, 3) - last.fixed_view::<3, 1>(0, 3);
        let turn: Matrix3<f64> = tool.fixed_view::<3, 3>(0, 0).transpose();
        let mut out = [[0.0; 7]; 6];
        for j in 0..7 {
            let angular: Vector3<f64> = jacobian.fixed_view::<3, 1>(3, j).into();
            let linear: Vector3<f64> = Vector3::from(jacobian.fixed_view::<3, 1>(0, j)) + angular.cross(&lever);
            let (linear, angular) = (turn * linear, turn * angular);
            (0..3).for_each(|i| (out[i][j], out[i + 3][j]) = (linear[i], angular[i]));
        }
        out
    }

    /// A noise-free sample with this wrench on the tool.
    fn sample(&self, dt: f64, [q, dq, ddq]: [&[f64]; 3], wrench: &[f64; 6]) -> EstimatorInput<7> {
        let model = array(&self.numeric.inverse_dynamics(q, dq, ddq, &self.phi));
        let bias = array(&self.numeric.inverse_dynamics(q, dq, &[0.0; 7], &self.phi));
        let mass = self.numeric.mass_matrix(q, &self.phi);
        let jacobian = self.jacobian(q);
        EstimatorInput {
            dt,
            tau: std::array::from_fn(|j| model[j] - (0..6).map(|i| jacobian[i][j] * wrench[i]).sum::<f64>()),
            dq: std::array::from_fn(|j| dq[j]),
            model,
            bias,
            mass: std::array::from_fn(|i| std::array::from_fn(|j| mass[(i, j)])),
            jacobian,
            ..EstimatorInput::default()
        }
    }

    fn normal(&mut self) -> f64 {
        (0..12).map(|_| self.random.uniform(-0.5, 0.5)).sum()
    }

    /// Positions, velocities and accelerations of a slow wave at time `t`, s, away from
    /// singularities.
    fn wave(t: f64) -> [[f64; 7]; 3] {
        let middle = [0.3, 0.6, -0.2, 1.3, 0.4, 0.9, 0.1];
        let mut all = [[0.0; 7]; 3];
        for j in 0..7 {
            let w = TAU * (0.1 + 0.02 * j as f64);
            let (s, c) = (w * t + j as f64).sin_cos();
            (all[0][j], all[1][j], all[2][j]) = (middle[j] + 0.3 * s, 0.3 * w * c, -0.3 * w * w * s);
        }
        all
    }
}

const NOISE: [f64; 7] = [0.12, 0.15, 0.08, 0.1, 0.04, 0.05, 0.02];
const WANDER: Scale = Scale { force: 1.0, moment: 0.1 };
const WRENCH: [f64; 6] = [12.0, -20.0, 7.0, 1.0, -0.5, 0.8];

fn close(a: &[f64; 6], b: &[f64; 6], tolerance: f64) {
    assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() < tolerance), "{a:?} {b:?}");
}

#[test]
fn equation_14_finds_a_wrench_of_all_six_components() {
    let mut oracle = Oracle::new(1);
    for _ in 0..200 {
        let mut draw = |size: f64| -> Vec<f64> { (0..7).map(|_| oracle.random.uniform(-size, size)).collect() };
        let (mut q, dq, ddq) = (draw(2.0), draw(1.5), draw(4.0));
        (q[3], q[5]) = (1.2 + 0.2 * q[3], 0.9 + 0.2 * q[5]);
        let f: [f64; 6] = std::array::from_fn(|i| oracle.random.uniform(-1.0, 1.0) * if i < 3 { 50.0 } else { 5.0 });
        let sample = oracle.sample(1e-3, [&q, &dq, &ddq], &f);
        let mut residual = Residual::new(NOISE, Scale::default());
        let found = residual.step(&sample);
        assert!(found.fresh && found.misfit < 0.2, "{found:?}");
        // The damping changes the wrench by at most its share of the prior variance.
        for i in 0..6 {
            let share = (found.std(i) / Scale::default().each()[i]).powi(2);
            assert!((found.wrench[i] - f[i]).abs() < 1e-9 + 20.0 * share.max(1e-5) * 60.0, "{found:?} {f:?}");
        }
        // Plain formula: nalgebra's pseudo-inverse from singular values.
        residual.weights = Weights::Equal { damping: 1e-7 };
        let transposed = DMatrix::from_fn(7, 6, |j, i| sample.jacobian[i][j]);
        let external = DVector::from_fn(7, |j, _| sample.model[j] - sample.tau[j]);
        let expected = transposed.pseudo_inverse(1e-9).unwrap() * external;
        let found = residual.step(&sample);
        assert!((0..6).all(|i| (found.wrench[i] - expected[i]).abs() < 1e-6), "{found:?} {expected}");
    }
}

#[test]
fn the_covariance_is_that_of_many_draws() {
    let mut oracle = Oracle::new(2);
    let [q, dq, ddq] = Oracle::wave(0.7);
    let clean = oracle.sample(1e-3, [&q, &dq, &ddq], &WRENCH);
    // A model with one common error in several joints.
    let mut covariance = [[0.0; 7]; 7];
    let direction = [0.0, 0.2, 0.1, -0.1, 0.0, 0.05, 0.0];
    (0..7).for_each(|i| (0..7).for_each(|j| covariance[i][j] = direction[i] * direction[j]));
    for weights in [Weights::Uncertainty, Weights::Equal { damping: 1e-4 }] {
        let mut residual = Residual::new(NOISE, Scale::default());
        residual.weights = weights;
        let (mut surprise, mut misfit, mut inside, mut squares) = (0.0, 0.0, [0.0; 6], [0.0; 6]);
        let draws = 4000;
        for _ in 0..draws {
            let model = oracle.normal();
            let mut sample = EstimatorInput { covariance, ..clean };
            for j in 0..7 {
                sample.tau[j] += NOISE[j] * oracle.normal() + direction[j] * model;
            }
            let found = residual.step(&sample);
            for i in 0..6 {
                let error = found.wrench[i] - WRENCH[i];
                inside[i] += f64::from(u8::from(error.abs() <= found.half_width(i))) / f64::from(draws);
                squares[i] += (error / found.std(i)).powi(2) / f64::from(draws);
            }
            misfit += found.misfit / f64::from(draws);
            // The same noise without contact.
            for j in 0..7 {
                sample.tau[j] += (0..6).map(|i| clean.jacobian[i][j] * WRENCH[i]).sum::<f64>();
            }
            surprise += residual.step(&sample).surprise / f64::from(draws);
        }
        assert!(inside.iter().all(|p| (0.935..0.965).contains(p)), "{inside:?}");
        assert!(squares.iter().all(|s| (s - 1.0).abs() < 0.12), "{squares:?}");
        assert!((surprise - 7.0).abs() < 0.3 && (misfit - 1.0).abs() < 0.1, "{surprise} {misfit}");
    }
}

/// Heavy damping without noise: the lost part of the wrench stays within the band.
#[test]
fn a_band_holds_what_damping_loses() {
    let oracle = Oracle::new(5);
    let [q, dq, ddq] = Oracle::wave(0.7);
    let mut residual = Residual::new([1e-4; 7], Scale::default());
    residual.weights = Weights::Equal { damping: 0.5 };
    let found = residual.step(&oracle.sample(1e-3, [&q, &dq, &ddq], &WRENCH));
    let lost: f64 = (0..6).map(|i| (found.wrench[i] - WRENCH[i]).abs()).sum();
    assert!(lost > 1.0, "{found:?}");
    assert!((0..6).all(|i| (found.wrench[i] - WRENCH[i]).abs() <= found.half_width(i)), "{found:?}");
}

/// White velocity noise keeps its standard deviation at any gain; noise spread evenly over two
/// samples has smaller differences.
#[test]
fn white_speed_of_white_noise_is_one() {
    for gain in [5.0, 40.0, 200.0] {
        let white = momentum::white_speed(gain, 1e-3, &[1.0]);
        assert!((white - 1.0).abs() < 1e-6, "{gain}: {white}");
        assert!(momentum::white_speed(gain, 1e-3, &[0.5, 0.5]) < 0.9);
    }
}

#[test]
fn static_friction_exceeds_coulombs() {
    use stiction::breakaway;
    assert_eq!(breakaway(2.0, Some(3.0), 100.0), 3.0);
    assert_eq!(breakaway(2.0, Some(1.0), 100.0), 2.0);
    assert!(breakaway(2.0, None, 100.0) > 2.0 && breakaway(2.0, None, f64::INFINITY) == 2.0);
    assert!(breakaway(0.0, None, 100.0) > 0.0 && breakaway(0.0, None, f64::INFINITY) == 0.0);
}

/// Errors as large as predicted, and half as large again: chi-square of 1,400 numbers, whose mean
/// is known to 4 %.
#[test]
fn errors_that_are_too_large_are_improbable() {
    let mut oracle = Oracle::new(6);
    for (size, consistent) in [(1.0, true), (1.5, false)] {
        let mut checker = consistency::Checker::new(0.1);
        for _ in 0..200 {
            let error: Vec<f64> = (0..7).map(|_| size * oracle.normal()).collect();
            checker.add(&error, &DMatrix::zeros(7, 1), &[1.0; 7], None);
        }
        let found = checker.finish().unwrap();
        assert!((found.probability > 1e-3) == consistent, "{size}: {found:?}");
        assert!((found.ratio - size * size).abs() < 0.2 * size * size, "{found:?}");
    }
}

#[test]
fn the_observer_is_a_low_pass_of_the_external_torque() {
    let oracle = Oracle::new(3);
    let (dt, gain) = (1e-3, 25.0);
    let mut observer = Momentum::<7>::new(gain, [1e-6; 7], [1e-6; 7], Scale::default());
    let mut low_passed = [0.0; 7];
    for k in 0..2000 {
        let t = f64::from(k) * dt;
        let [q, dq, ddq] = Oracle::wave(t);
        let f: [f64; 6] = std::array::from_fn(|i| WRENCH[i] * (TAU * 0.7 * t + i as f64).sin());
        let sample = oracle.sample(dt, [&q, &dq, &ddq], &f);
        let estimate = observer.step(&sample);
        // Independent reference: the exact external torque through a first-order low-pass by the
        // midpoint rule.
        let middle = t - 0.5 * dt;
        let jacobian = oracle.jacobian(&Oracle::wave(middle)[0]);
        for j in 0..7 {
            let external: f64 =
                (0..6).map(|i| jacobian[i][j] * WRENCH[i] * (TAU * 0.7 * middle + i as f64).sin()).sum();
            if k > 0 {
                low_passed[j] += (1.0 - (-gain * dt).exp()) * (external - low_passed[j]);
            }
        }
        assert!(k == 0 || estimate.fresh);
        assert!((0..7).all(|j| (observer.torques()[j] - low_passed[j]).abs() < 2e-3), "{k}");
    }
}

#[test]
fn the_observer_is_as_unsure_as_its_noise_makes_it() {
    // One joint without contact, white noise on torque and velocity: standard deviation of the
    // estimate against the reported one.
    let mut oracle = Oracle::new(14);
    for (dt, gain) in [(1e-3, 30.0), (1e-2, 62.8)] {
        for (torque, speed) in [(0.3, 0.0), (0.0, 1e-3), (0.2, 1e-3)] {
            let mut observer = Momentum::<1>::new(gain, [torque * torque * dt], [speed], Scale::default());
            let mut jacobian = [[0.0]; 6];
            jacobian[0] = [1.0];
            let (mut square, mut said, mut count) = (0.0, 0.0, 0.0);
            for k in 0..60_000 {
                let sample = EstimatorInput {
                    dt,
                    tau: [torque * oracle.normal()],
                    dq: [speed * oracle.normal()],
                    mass: [[2.0]],
                    jacobian,
                    ..EstimatorInput::default()
                };
                let found = observer.step(&sample);
                if k > 2000 {
                    square += found.wrench[0] * found.wrench[0];
                    said += found.covariance[0][0];
                    count += 1.0;
                }
            }
            let ratio = (square / said).sqrt();
            assert!((0.85..1.03).contains(&ratio), "{dt} {torque} {speed}: {ratio} of {count}");
        }
    }
}

#[test]
fn the_filter_is_as_sure_as_it_may_be() {
    let mut oracle = Oracle::new(4);
    let (dt, velocity) = (2e-3, 1e-4);
    let mut filter = Kalman::<7>::new(NOISE.map(|s| s * s * dt), [velocity; 7], Scale::default(), WANDER);
    let mut observer = Momentum::<7>::new(15.0, NOISE.map(|s| s * s * dt), [velocity; 7], Scale::default());
    let mut squares = [[0.0; 6]; 2];
    let (mut count, mut walk) = (0.0, WRENCH);
    for k in 0..6000 {
        let t = f64::from(k) * dt;
        let [q, dq, ddq] = Oracle::wave(t);
        // The wrench is constant for the observer, whose band does not cover changes, and a random
        // walk for the filter.
        let paces = WANDER.each();
        (0..6).for_each(|i| walk[i] += paces[i] * dt.sqrt() * oracle.normal());
        let mut sample = oracle.sample(dt, [&q, &dq, &ddq], &WRENCH);
        let mut other = oracle.sample(dt, [&q, &dq, &ddq], &walk);
        for j in 0..7 {
            let (torque, speed) = (NOISE[j] * oracle.normal(), velocity * oracle.normal());
            for sample in [&mut sample, &mut other] {
                sample.tau[j] += torque;
                sample.dq[j] += speed;
            }
        }
        let found = [(filter.step(&other), walk), (observer.step(&sample), WRENCH)];
        if k > 1500 && k % 10 == 0 {
            count += 1.0;
            for (squares, (found, truth)) in squares.iter_mut().zip(&found) {
                (0..6).for_each(|i| squares[i] += ((found.wrench[i] - truth[i]) / found.std(i)).powi(2));
            }
        }
    }
    for squares in squares {
        let normed = squares.map(|s| (s / count).sqrt());
        assert!(normed.iter().all(|s| (0.5..1.3).contains(s)), "{squares:?} {normed:?}");
    }
}

#[test]
fn at_a_singularity_a_direction_is_not_told() {
    let oracle = Oracle::new(5);
    // Stretched and upright: a force along the arm loads no joint.
    let q = [0.2, 0.0, 0.3, 0.0, 0.1, 0.0, 0.0];
    let sample = oracle.sample(1e-3, [&q, &[0.0; 7], &[0.0; 7]], &[10.0, 0.0, 40.0, 0.0, 0.0, 0.0]);
    let scale = Scale::default();
    let found = Residual::new(NOISE, scale).step(&sample);
    assert!(found.fresh && (found.std(2) / scale.force - 1.0).abs() < 1e-6, "{found:?}");
    assert!(found.wrench[2].abs() < 1e-6 && found.half_width(2) > 40.0);
    let mut filter = Kalman::<7>::new([1e-5; 7], [1e-4; 7], scale, WANDER);
    let mut found = filter.step(&sample);
    for _ in 0..500 {
        found = filter.step(&sample);
        assert!(found.wrench.iter().all(|f| f.is_finite()));
    }
    assert!((found.std(2) / scale.force - 1.0).abs() < 1e-3, "{found:?}");
}

#[test]
fn a_sample_that_is_none_changes_nothing() {
    let oracle = Oracle::new(6);
    let mut residual = Residual::new(NOISE, Scale::default());
    let mut momentum = Momentum::new(25.0, [1e-5; 7], [1e-4; 7], Scale::default());
    let mut kalman = Kalman::new([1e-5; 7], [1e-4; 7], Scale::default(), WANDER);
    let all: [&mut dyn ForceEstimator<7>; 3] = [&mut residual, &mut momentum, &mut kalman];
    for estimator in all {
        let mut before = Estimate::unknown(&Scale::default());
        for k in 0..900 {
            let [q, dq, ddq] = Oracle::wave(f64::from(k) * 1e-3);
            let mut sample = oracle.sample(1e-3, [&q, &dq, &ddq], &WRENCH);
            let broken = (500..510).contains(&k);
            match k {
                500..503 => sample.tau[2] = f64::NAN,
                503..506 => (sample.dq[1], sample.bias[1], sample.model[1]) = (f64::INFINITY, f64::NAN, f64::NAN),
                506..510 => (sample.mass, sample.jacobian) = ([[f64::NAN; 7]; 7], [[f64::NAN; 7]; 6]),
                _ => {}
            }
            let now = estimator.step(&sample);
            assert!(now.wrench.iter().all(|f| f.is_finite()));
            if broken {
                assert!(!now.fresh && now.wrench == before.wrench, "{k}");
            }
            before = now;
        }
        assert!(before.fresh);
        close(&before.wrench, &WRENCH, 0.3);
        estimator.reset();
    }
}

#[test]
fn causal_derivatives_follow_a_parabola() {
    let mut filter = StateVariableFilter::<1>::new(10.0, 1e-3);
    let lag = 2.0 / (TAU * 10.0);
    for k in 0..3000 {
        let t = f64::from(k) * 1e-3;
        filter.push(&[0.5 * t * t], &[3.0 * t]);
    }
    let t = 2.999;
    assert!((filter.ddq()[0] - 1.0).abs() < 1e-6, "{}", filter.ddq()[0]);
    assert!((filter.dq()[0] - (t - lag)).abs() < 1e-6, "{}", filter.dq()[0]);
    assert!((filter.tau()[0] - 3.0 * (t - lag)).abs() < 1e-6);
    let mut noise = Oracle::new(7);
    let (mut filter, mut squares) = (StateVariableFilter::<1>::new(20.0, 2e-3), [0.0; 3]);
    for k in 0..200_000 {
        filter.push(&[noise.normal()], &[0.0]);
        if k >= 1000 {
            let values = [filter.q()[0], filter.dq()[0], filter.ddq()[0]];
            (0..3).for_each(|i| squares[i] += values[i] * values[i] / 199_000.0);
        }
    }
    let gain = filter.noise_gain();
    assert!((0..3).all(|i| (squares[i].sqrt() / gain[i] - 1.0).abs() < 0.03), "{squares:?} {gain:?}");
}

#[test]
fn touch_is_felt_and_noise_is_not() {
    let mut oracle = Oracle::new(8);
    let mut residual = Residual::new(NOISE, Scale::default());
    let mut detector = ContactDetector::default();
    let [q, dq, ddq] = Oracle::wave(0.2);
    for k in 0..20_000 {
        let push = if (10_000..15_000).contains(&k) { 8.0 } else { 0.0 };
        let mut sample = oracle.sample(1e-3, [&q, &dq, &ddq], &[0.0, push, 0.0, 0.0, 0.0, 0.0]);
        (0..7).for_each(|j| sample.tau[j] += NOISE[j] * oracle.normal());
        let contact = detector.step(&residual.step(&sample), 1e-3);
        if k % 5000 > 5 {
            assert_eq!(contact.touching, push > 0.0, "{k}: {contact:?}");
        }
    }
    // Wilson-Hilferty approximation against tables: the 99 % quantile of chi-square.
    for (freedom, quantile) in [(1, 6.635), (6, 16.812), (7, 18.475)] {
        assert!((deviate(quantile, freedom) - 2.326).abs() < 0.06, "{}", deviate(quantile, freedom));
    }
}

#[test]
#[ignore = "a measure, in release"]
fn time_of_a_step() {
    let oracle = Oracle::new(9);
    let samples: Vec<EstimatorInput<7>> = (0..1000)
        .map(|k| {
            let [q, dq, ddq] = Oracle::wave(f64::from(k) * 1e-3);
            oracle.sample(1e-3, [&q, &dq, &ddq], &WRENCH)
        })
        .collect();
    let mut residual = Residual::new(NOISE, Scale::default());
    let mut momentum = Momentum::new(25.0, [1e-5; 7], [1e-4; 7], Scale::default());
    let mut kalman = Kalman::new([1e-5; 7], [1e-4; 7], Scale::default(), WANDER);
    let all: [(&str, &mut dyn ForceEstimator<7>); 3] =
        [("residual", &mut residual), ("momentum", &mut momentum), ("kalman", &mut kalman)];
    for (name, estimator) in all {
        let begin = std::time::Instant::now();
        let mut sum = 0.0;
        for _ in 0..20 {
            sum += samples.iter().map(|s| estimator.step(s).wrench[0]).sum::<f64>();
        }
        println!("{name}: {:.2} us a step ({sum:.1})", begin.elapsed().as_secs_f64() * 1e6 / 20_000.0);
    }
}
