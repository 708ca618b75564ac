//! Drives with memory against their differential equations.

use denavit_runtime_core::drive::{Memory, Spring, swing};

const MEMORY: Memory = Memory { travel: 2e-3, cold: 0.4, time: 50.0, per_kelvin: -0.01, reference: 20.0 };

/// `dz/dx = (1 - z sign) sign / travel`, in steps so small that Euler's rule will do.
#[test]
fn a_bristle_bends_as_dahls_equation_says() {
    let (mut exact, mut small) = (-1.0_f64, -1.0_f64);
    for by in [1e-3, 3e-3, -5e-4, -2e-3, 7e-4] {
        exact = MEMORY.bent(exact, by);
        let steps = 200_000;
        for _ in 0..steps {
            let step: f64 = by / f64::from(steps);
            small += step.abs() / MEMORY.travel * (step.signum() - small);
        }
        assert!((exact - small).abs() < 1e-5, "{by}: {exact} {small}");
    }
    // Without a travel it turns at once.
    assert_eq!(Memory { travel: 0.0, ..MEMORY }.bent(0.3, -1e-9), -1.0);
}

#[test]
fn friction_falls_as_the_drive_warms() {
    assert!((MEMORY.warmth(0.0, 20.0) - 1.4_f64).abs() < 1e-12);
    assert!((MEMORY.warmth(50.0, 20.0) - (1.0 + 0.4 / std::f64::consts::E)).abs() < 1e-12);
    assert!((MEMORY.warmth(1e9, 30.0) - 0.9_f64).abs() < 1e-9);
    assert_eq!(MEMORY.warmth(1e9, 1e4), 0.0_f64);
}

/// One link on its spring while its motor accelerates evenly: `J d'' + D d' + K d = J a`, of which
/// the answer is known.
#[test]
fn a_link_swings_as_a_damped_oscillator() {
    let (inertia, stiffness, damping, acceleration) = (2.0, 800.0, 8.0, 3.0);
    let springs = [Spring { stiffness, damping, gain: 1.0 }];
    let mut deflection = [[0.0, 0.0, acceleration]];
    let mut scratch = [0.0; 3];
    let dt = 1e-4;
    let rate = f64::sqrt(stiffness / inertia);
    let ratio = damping / (2.0 * inertia * rate);
    let damped = rate * f64::sqrt(1.0 - ratio * ratio);
    for step in 1..=10_000 {
        swing(&springs, dt, &mut deflection, &mut scratch, &mut |d, torques| {
            torques[0] = inertia * (acceleration - d[0][2]);
        });
        let t = dt * f64::from(step);
        let wave = f64::cos(damped * t) + ratio * rate / damped * f64::sin(damped * t);
        let wanted = inertia * acceleration / stiffness * (1.0 - f64::exp(-ratio * rate * t) * wave);
        assert!((deflection[0][0] - wanted).abs() < 1e-6, "{t}: {deflection:?} {wanted}");
    }
}
