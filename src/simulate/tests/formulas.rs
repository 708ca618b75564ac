//! Formulas of single effects, checked by differences, limits and energies.

use crate::simulate::effects::{JointSpring, LoadDependentFriction, NonlinearViscousFriction};

/// Central difference quotient.
fn slope(of: impl Fn(f64) -> f64, x: f64) -> f64 {
    const STEP: f64 = 1e-5;
    (of(x + STEP) - of(x - STEP)) / (2.0 * STEP)
}

/// The work put into a spring equals its stored energy, in both directions.
#[test]
fn a_spring_has_an_energy() {
    let spring = JointSpring { stiffness: 30.0, rest: 0.2, hardening: 80.0, side: 0.0 };
    let energy = |q: f64| 15.0 * (q - 0.2).powi(2) + 20.0 * (q - 0.2).powi(4);
    for q in [-0.9, -0.3, 0.1, 0.25, 0.8] {
        let torque = spring.torque(q);
        assert!((torque - slope(energy, q)).abs() < 1e-6 * (1.0 + torque.abs()), "{q}: {torque}");
        assert!((spring.slope(q) - slope(|q| spring.torque(q), q)).abs() < 1e-6 * spring.slope(q), "{q}");
        assert!((torque + spring.torque(0.4 - q)).abs() < 1e-12 * (1.0 + torque.abs()), "{q}");
    }
}

#[test]
fn a_cable_hangs_on_one_side() {
    for side in [1.0, -1.0] {
        let cable = JointSpring { stiffness: 30.0, rest: 0.2, hardening: 0.0, side };
        assert!((cable.torque(0.2 + 0.1 * side) - 3.0 * side).abs() < 1e-12);
        assert_eq!((cable.torque(0.2 - 0.1 * side), cable.slope(0.2 - 0.1 * side)), (0.0, 0.0));
    }
}

/// The level depends on whether the motor lifts the load or is driven by it.
#[test]
fn a_gear_loses_otherwise_where_the_load_drives_it() {
    let gear = LoadDependentFriction { factor: 0.05, driven: 0.12 };
    for sign in [1.0, -1.0] {
        assert!((gear.level(10.0 * sign, 0.3 * sign) - 0.5).abs() < 1e-12);
        assert!((gear.level(10.0 * sign, -0.3 * sign) - 1.2).abs() < 1e-12);
    }
}

/// Linear near zero, half of the level at `VN`, and never more than the level.
#[test]
fn friction_that_saturates_has_its_level_and_half_of_it() {
    let law = NonlinearViscousFriction { level: 8.0, exponent: 1.0, half: 0.4 };
    let torque = |v: f64| law.slope(v) * v;
    assert!((torque(0.4) - 4.0).abs() < 1e-12 && (torque(-0.4) + 4.0).abs() < 1e-12);
    assert!((torque(1e4) - 8.0).abs() < 1e-3 && torque(1e4) < 8.0);
    for v in [-2.0, -0.1, 0.3, 1.5] {
        assert!((law.derivative(v) - slope(torque, v)).abs() < 1e-7, "{v}");
    }
}
