//! Each function of two arms: generated for one state, generated for packs of eight, interpreted in
//! batches, numeric in nalgebra. Sines and cosines are included everywhere. `cargo bench` prints
//! medians per call; a call of `pack` is eight states and one of `batch` is 1000. The regressors
//! are written completely into an array of the caller. A sample contains many calls: reading the
//! clock takes 20 ns, and a first call after it another 100.
//!
//! For the figures of the README: `RUSTFLAGS="-C target-cpu=native" cargo bench --bench kernels`.

use denavit::model::States;
use denavit::model::interpreted::Interpreted;
use denavit::model::rigid_body::Numeric;
use dh_codegen::arm::{Function, param};
use dh_codegen::robot::{Robot, no_files};
use divan::{Bencher, black_box};

fn main() {
    divan::main();
}

/// Number of states in a batch.
const BATCH: usize = 1000;

fn robot(name: &str) -> Robot {
    let path = format!("{}/robots/{name}.yaml", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).expect("a robot file of the repository");
    Robot::from_yaml(&text, &no_files).expect("a robot file without problems").robot
}

fn angles<const N: usize>(seed: f64) -> [f64; N] {
    core::array::from_fn(|i| ((i as f64 + 1.0) * seed * 1.37).sin() * 2.0)
}

fn batch(function: Function, name: &str, bencher: Bencher<'_, '_>) {
    let robot = robot(name);
    let arm = Interpreted::new(&robot, &[function]);
    let column = |seed: f64| -> Vec<f64> { (0..robot.dof() * BATCH).map(|k| (k as f64 * seed).sin() * 2.0).collect() };
    let states = States { len: BATCH, q: column(0.7), dq: column(0.3), ddq: column(0.9) };
    let tau = column(0.2);
    let standard = vec![0.5; param::standard(&robot).len()];
    let mut out = vec![0.0; arm.shape(function).iter().product::<usize>() * BATCH];
    bencher.bench_local(|| arm.run(function, black_box(&states), &tau, &standard, black_box(&mut out)));
}

macro_rules! arm {
    ($module:ident, $name:literal) => {
        mod $module {
            use super::*;
            use ::$module as arm;
            use ::$module::runtime::Pack;

            const N: usize = arm::DOF;

            fn state() -> [[f64; N]; 3] {
                [1.0, 2.0, 3.0].map(angles::<N>)
            }
            fn packs() -> [[Pack; N]; 3] {
                [1.0, 2.0, 3.0].map(|seed| angles::<N>(seed).map(|x| Pack::new(core::array::from_fn(|l| x + 0.01 * l as f64))))
            }

            macro_rules! function {
                ($f:ident, $which:ident, @full, $out:expr, $generated:expr, $packed:expr, $numeric:expr) => {
                    mod $f {
                        use super::*;
                        #[divan::bench(sample_size = 500, sample_count = 200)]
                        fn generated(bencher: Bencher<'_, '_>) {
                            let [q, dq, ddq] = state();
                            let (phi, beta) = ([0.5; arm::STANDARD], [0.5; arm::BASE]);
                            let run: fn(&[f64; N], &[f64; N], &[f64; N], &[f64; arm::STANDARD], &[f64; arm::BASE], &mut _) -> _ = $generated;
                            let mut out = $out;
                            bencher.bench_local(|| run(black_box(&q), black_box(&dq), black_box(&ddq), black_box(&phi), black_box(&beta), black_box(&mut out)));
                        }
                        #[divan::bench(sample_size = 200, sample_count = 200)]
                        fn pack(bencher: Bencher<'_, '_>) {
                            let [q, dq, ddq] = packs();
                            let half = Pack::new([0.5; 8]);
                            let (phi, beta) = ([half; arm::STANDARD], [half; arm::BASE]);
                            let run: fn(&[Pack; N], &[Pack; N], &[Pack; N], &[Pack; arm::STANDARD], &[Pack; arm::BASE], &mut _) -> _ = $packed;
                            let mut out = $out;
                            bencher.bench_local(|| run(black_box(&q), black_box(&dq), black_box(&ddq), black_box(&phi), black_box(&beta), black_box(&mut out)));
                        }
                        #[divan::bench]
                        fn batch(bencher: Bencher<'_, '_>) {
                            super::super::batch(Function::$which, $name, bencher);
                        }
                        #[divan::bench(sample_size = 50, sample_count = 100)]
                        fn numeric(bencher: Bencher<'_, '_>) {
                            let arm = Numeric::new(&robot($name));
                            let [q, dq, ddq] = state();
                            let phi = [0.5; arm::STANDARD];
                            let run: fn(&Numeric, &[f64], &[f64], &[f64], &[f64]) -> _ = $numeric;
                            bencher.bench_local(|| run(&arm, black_box(&q), black_box(&dq), black_box(&ddq), black_box(&phi)));
                        }
                    }
                };
                ($f:ident, $which:ident, |$q:pat_param, $v:pat_param, $a:pat_param, $p:pat_param, $b:pat_param| $body:expr, |$m:pat_param, $nq:pat_param, $nv:pat_param, $na:pat_param, $np:pat_param| $numeric:expr) => {
                    function!($f, $which, @full, (), |$q, $v, $a, $p, $b, ()| $body, |$q, $v, $a, $p, $b, ()| $body, |$m, $nq, $nv, $na, $np| $numeric);
                };
            }
            function!(forward_kinematics, ForwardKinematics, |q, _, _, _, _| arm::forward_kinematics(q), |m, q, _, _, _| m.frames(q));
            function!(jacobian, Jacobian, |q, _, _, _, _| arm::jacobian(q), |m, q, _, _, _| m.jacobian(q));
            function!(inverse_dynamics, InverseDynamics, |q, v, a, p, _| arm::inverse_dynamics(q, v, a, p), |m, q, v, a, p| m.inverse_dynamics(q, v, a, p));
            function!(inverse_dynamics_base, InverseDynamicsBase, |q, v, a, _, b| arm::inverse_dynamics_base(q, v, a, b), |m, q, v, a, p| m.inverse_dynamics(q, v, a, p));
            function!(mass_matrix, MassMatrix, |q, _, _, _, b| arm::mass_matrix(q, b), |m, q, _, _, p| m.mass_matrix(q, p));
            function!(gravity, Gravity, |q, _, _, _, b| arm::gravity(q, b), |m, q, _, _, p| m.gravity(q, p));
            function!(forward_dynamics, ForwardDynamics, |q, v, a, _, b| arm::forward_dynamics(q, v, a, b), |m, q, v, a, p| m.forward_dynamics(q, v, a, p));
            function!(
                regressor,
                Regressor,
                @full,
                [[Default::default(); arm::STANDARD]; N],
                |q, v, a, _, _, out| arm::kernel::regressor::dense(&arm::Trig::new(q), v, a, out),
                |q, v, a, _, _, out| arm::kernel::regressor::dense(&arm::Trig::new(q), v, a, out),
                |m, q, v, a, _| m.regressor(q, v, a)
            );
            function!(
                base_regressor,
                BaseRegressor,
                @full,
                [[Default::default(); arm::BASE]; N],
                |q, v, a, _, _, out| arm::kernel::base_regressor::dense(&arm::Trig::new(q), v, a, out),
                |q, v, a, _, _, out| arm::kernel::base_regressor::dense(&arm::Trig::new(q), v, a, out),
                |m, q, v, a, _| m.regressor(q, v, a)
            );
        }
    };
}

arm!(kuka_lwr4, "kuka-lwr4");
arm!(ur10e, "ur10e");
