//! The derive writes the same functions as `denavit generate`, bit for bit.

use dh_macro::DhRobot;

#[derive(DhRobot)]
#[dh(file = "../robots/kuka-lwr4.yaml")]
struct KukaLwr4;

/// Numbers between -3 and 3 that look random (Weyl's sequence).
fn numbers<const N: usize>(seed: usize) -> [f64; N] {
    core::array::from_fn(|i| ((seed * N + i + 1) as f64 * 0.618_033_988_749_894_9).fract() * 6.0 - 3.0)
}

#[test]
fn the_struct_knows_its_robot() {
    assert_eq!((KukaLwr4::NAME, KukaLwr4::DOF), ("kuka-lwr4", 7));
}

#[test]
fn the_struct_has_the_traits_of_every_robot() {
    use crate::kuka_lwr4::robot::{Dynamics, Kinematics};
    let q = numbers::<7>(3);
    assert_eq!(KukaLwr4.tool_jacobian(&q), crate::kuka_lwr4::tool_jacobian(&q));
    let beta = KukaLwr4.base_parameters(&KukaLwr4.standard_values().unwrap());
    assert_eq!(KukaLwr4.gravity(&q, &beta), crate::kuka_lwr4::gravity(&q, &beta));
}

#[test]
fn the_functions_are_those_of_the_generated_crate() {
    use crate::kuka_lwr4 as derived;
    use ::kuka_lwr4 as generated;
    assert_eq!(derived::BASE_GROUPINGS, generated::BASE_GROUPINGS);
    assert_eq!(derived::STANDARD_VALUES, generated::STANDARD_VALUES);
    for seed in 0..20 {
        let [q, dq, ddq, tau]: [[f64; 7]; 4] = core::array::from_fn(|k| numbers(4 * seed + k));
        let phi = numbers::<{ generated::STANDARD }>(seed);
        let beta = generated::base_parameters(&phi);
        // Equality of floats: neither side may be NaN, and zeros may differ in sign only.
        macro_rules! same {
            ($($function:ident($($argument:expr),*);)*) => {
                $(assert_eq!(derived::$function($($argument),*), generated::$function($($argument),*));)*
            };
        }
        same! {
            base_parameters(&phi);
            frames(&q);
            forward_kinematics(&q);
            tool_pose(&q);
            jacobian(&q);
            tool_jacobian(&q);
            jacobian_dot_velocity(&q, &dq);
            inverse_dynamics(&q, &dq, &ddq, &phi);
            inverse_dynamics_base(&q, &dq, &ddq, &beta);
            mass_matrix(&q, &beta);
            coriolis(&q, &dq, &beta);
            gravity(&q, &beta);
            forward_dynamics(&q, &dq, &tau, &beta);
            regressor(&q, &dq, &ddq);
            base_regressor(&q, &dq, &ddq);
            gravity_regressor(&q);
            kinetic_energy_regressor(&q, &dq);
            potential_energy_regressor(&q);
            payload_regressor(&q, &dq, &ddq);
        }
    }
}
