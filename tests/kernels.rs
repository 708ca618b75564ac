//! Generated and interpreted code agree bit for bit, for every function.

use dh_codegen::arm::{Function, Model};
use dh_codegen::interpret::{Interpreter, State};
use dh_codegen::robot::{Robot, no_files};

fn numbers(seed: u64, len: usize) -> Vec<f64> {
    let mut state = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1;
    (0..len)
        .map(|_| {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            (state >> 11) as f64 / (1u64 << 53) as f64 * 6.0 - 3.0
        })
        .collect()
}

fn interpreter(name: &str) -> (Model, Interpreter) {
    let path = format!("{}/robots/{name}.yaml", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).unwrap();
    let model = Model::new(&Robot::from_yaml(&text, &no_files).unwrap().robot);
    let interpreter = Interpreter::new(&model, &Function::ALL);
    (model, interpreter)
}

macro_rules! agrees {
    ($test:ident, $module:ident, $name:literal) => {
        #[test]
        fn $test() {
            use $module as arm;
            let (model, run) = interpreter($name);
            assert_eq!((model.dof(), model.base().len(), model.standard().len()), (arm::DOF, arm::BASE, arm::STANDARD));
            for seed in 0..40 {
                let array = |k: u64, n: usize| numbers(seed * 10 + k, n);
                let (q, dq, ddq, tau) =
                    (array(1, arm::DOF), array(2, arm::DOF), array(3, arm::DOF), array(4, arm::DOF));
                let phi = array(5, arm::STANDARD);
                let [aq, adq, addq, atau]: [[f64; arm::DOF]; 4] =
                    [&q, &dq, &ddq, &tau].map(|v| v.as_slice().try_into().unwrap());
                let aphi: [f64; arm::STANDARD] = phi.as_slice().try_into().unwrap();
                let abeta = arm::base_parameters(&aphi);
                assert_eq!(abeta.to_vec(), model.base().values(&phi));
                let check = |f: Function, parameters: &[f64], generated: &[f64]| {
                    let state = State { q: &q, dq: &dq, ddq: &ddq, tau: &tau, parameters };
                    let interpreted = run.one(f, &state);
                    assert_eq!(interpreted.len(), generated.len());
                    for (i, (a, b)) in interpreted.iter().zip(generated).enumerate() {
                        // A structural zero of the dense form is +0 whatever sign a product would
                        // give it.
                        assert!(
                            a.to_bits() == b.to_bits() || (*a == 0.0 && *b == 0.0),
                            "{} entry {i}: {a} {b}",
                            f.name()
                        );
                    }
                };
                check(Function::Frames, &[], arm::frames(&aq).as_flattened().as_flattened());
                check(Function::ForwardKinematics, &[], arm::forward_kinematics(&aq).as_flattened());
                check(Function::ToolPose, &[], arm::tool_pose(&aq).as_flattened());
                check(Function::Jacobian, &[], arm::jacobian(&aq).as_flattened());
                check(Function::ToolJacobian, &[], arm::tool_jacobian(&aq).as_flattened());
                check(Function::JacobianDotVelocity, &[], &arm::jacobian_dot_velocity(&aq, &adq));
                check(Function::InverseDynamics, &phi, &arm::inverse_dynamics(&aq, &adq, &addq, &aphi));
                check(Function::InverseDynamicsBase, &abeta, &arm::inverse_dynamics_base(&aq, &adq, &addq, &abeta));
                check(Function::MassMatrix, &abeta, arm::mass_matrix(&aq, &abeta).as_flattened());
                check(Function::Coriolis, &abeta, &arm::coriolis(&aq, &adq, &abeta));
                check(Function::Gravity, &abeta, &arm::gravity(&aq, &abeta));
                check(Function::ForwardDynamics, &abeta, &arm::forward_dynamics(&aq, &adq, &atau, &abeta));
                check(Function::Regressor, &[], arm::regressor(&aq, &adq, &addq).as_flattened());
                check(Function::BaseRegressor, &[], arm::base_regressor(&aq, &adq, &addq).as_flattened());
                check(Function::GravityRegressor, &[], arm::gravity_regressor(&aq).as_flattened());
                check(Function::KineticEnergyRegressor, &[], &arm::kinetic_energy_regressor(&aq, &adq));
                check(Function::PotentialEnergyRegressor, &[], &arm::potential_energy_regressor(&aq));
                check(Function::PayloadRegressor, &[], arm::payload_regressor(&aq, &adq, &addq).as_flattened());
            }
        }
    };
}

agrees!(planar2r_agrees, planar2r, "planar2r");
agrees!(kuka_lwr4_agrees, kuka_lwr4, "kuka-lwr4");
agrees!(franka_panda_agrees, franka_panda, "franka-panda");
agrees!(ur10e_agrees, ur10e, "ur10e");
agrees!(kinova_gen3_agrees, kinova_gen3, "kinova-gen3");
agrees!(stanford_agrees, stanford, "stanford");

/// Packs of eight states and packed outputs give the same numbers as one state at a time.
#[test]
fn packs_and_packed_outputs_are_the_same_numbers() {
    use kuka_lwr4 as arm;
    use kuka_lwr4::kernel::base_regressor::{NONZEROS, PATTERN};
    use kuka_lwr4::runtime::Pack;
    let state = |lane: usize, k: u64| -> [f64; arm::DOF] {
        numbers(lane as u64 * 7 + k, arm::DOF).as_slice().try_into().unwrap()
    };
    let pack = |k: u64| -> [Pack; arm::DOF] {
        core::array::from_fn(|j| Pack::new(core::array::from_fn(|lane| state(lane, k)[j])))
    };
    let mut packed = [Pack::default(); NONZEROS];
    arm::kernel::base_regressor::packed(&arm::Trig::new(&pack(1)), &pack(2), &pack(3), &mut packed);
    for lane in 0..8 {
        let w = arm::base_regressor(&state(lane, 1), &state(lane, 2), &state(lane, 3));
        for (entry, (row, column)) in packed.iter().zip(PATTERN) {
            assert_eq!(entry.to_array()[lane].to_bits(), w[row][column].to_bits());
        }
    }
}

/// Every instruction set of this processor gives the bits of the plain functions, for one state and
/// for eight. So do angles beyond the range of the short reduction.
#[test]
fn instruction_sets_agree() {
    macro_rules! agree {
        ($module:ident) => {{
            use arm::runtime::dispatch::Level;
            use $module as arm;
            let list = |lane: usize, k: u64, n: usize| numbers(lane as u64 * 10 + k, n);
            let state = |lane: usize, k: u64| -> [f64; arm::DOF] { list(lane, k, arm::DOF).try_into().unwrap() };
            let mut qs: [[f64; arm::DOF]; 8] = core::array::from_fn(|lane| state(lane, 1));
            (qs[3][1], qs[6][0]) = (7e5, -3e8);
            let eights = |k: u64| {
                core::array::from_fn::<[f64; 8], { arm::DOF }, _>(|j| {
                    core::array::from_fn(|lane| if k == 1 { qs[lane][j] } else { state(lane, k)[j] })
                })
            };
            let beta: [f64; arm::BASE] = list(0, 4, arm::BASE).try_into().unwrap();
            let betas = beta.map(|b| [b; 8]);
            for level in [Level::Build, Level::V3, Level::V4] {
                let mut regressors = [[[0.0; 8]; arm::BASE]; arm::DOF];
                arm::dispatch::eight::base_regressor(level, &eights(1), &eights(2), &eights(3), &mut regressors);
                let mut torques = [[0.0; 8]; arm::DOF];
                arm::dispatch::eight::inverse_dynamics_base(
                    level,
                    &eights(1),
                    &eights(2),
                    &eights(3),
                    &betas,
                    &mut torques,
                );
                for (lane, q) in qs.iter().enumerate() {
                    let (dq, ddq) = (state(lane, 2), state(lane, 3));
                    let bits = |x: &[f64]| x.iter().map(|x| x.to_bits()).collect::<Vec<u64>>();
                    let plain = arm::base_regressor(q, &dq, &ddq);
                    let one = arm::dispatch::base_regressor(level, q, &dq, &ddq);
                    assert_eq!(bits(one.as_flattened()), bits(plain.as_flattened()), "{level:?}");
                    let lane_of: Vec<f64> = regressors.as_flattened().iter().map(|x| x[lane]).collect();
                    assert_eq!(bits(&lane_of), bits(plain.as_flattened()), "{level:?}, state {lane} of eight");
                    let plain = arm::inverse_dynamics_base(q, &dq, &ddq, &beta);
                    assert_eq!(bits(&arm::dispatch::inverse_dynamics_base(level, q, &dq, &ddq, &beta)), bits(&plain));
                    assert_eq!(bits(&torques.map(|x| x[lane])), bits(&plain), "{level:?}, state {lane} of eight");
                    let plain = arm::forward_dynamics(q, &dq, &ddq, &beta);
                    assert_eq!(bits(&arm::dispatch::forward_dynamics(level, q, &dq, &ddq, &beta)), bits(&plain));
                }
            }
            Level::highest()
        }};
    }
    let shipped = agree!(kuka_lwr4);
    let other = agree!(planar2r);
    let on_runtime = agree!(scara);
    assert_eq!((shipped as u8, shipped as u8), (other as u8, on_runtime as u8));
}

/// f32 uses the same source text.
#[test]
fn single_precision_is_close() {
    use ur10e as arm;
    let q: [f32; arm::DOF] = [0.1, -0.4, 0.9, 0.3, -1.2, 0.7];
    let single = arm::jacobian(&q);
    let double = arm::jacobian(&q.map(f64::from));
    for (a, b) in single.as_flattened().iter().zip(double.as_flattened()) {
        assert!((f64::from(*a) - b).abs() < 1e-6);
    }
}
