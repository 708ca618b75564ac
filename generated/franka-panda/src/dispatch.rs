//! The functions of `q` once more, each compiled for several instruction sets, one of which is
//! taken at run time: one binary is fast on every processor. The bits are those of the other
//! functions.
//!
//! `level` is [`Level::of_scalars`] for one state and [`Level::highest`] for eight, or a lower one.

use super::runtime::Scalar;
use super::runtime::dispatch::{Level, Numbers, Set, Work, eights, sines_and_cosines};
use super::*;

macro_rules! one {
    ($(#[$doc:meta])* fn $name:ident($($argument:ident: $kind:ty),*) -> $result:ty = $zero:expr, |$out:ident| $flat:expr, |$k:ident| $place:expr) => {
        $(#[$doc])*
        #[must_use]
        pub fn $name(level: Level, q: &[f64; DOF], $($argument: &$kind),*) -> $result {
            struct Of<'a>(&'a [f64; DOF], $(&'a $kind,)* &'a mut $result);
            impl Work for Of<'_> {
                type Result = ();
                #[inline(always)]
                fn run<S: Set>(self) {
                    let Self(q, $($argument,)* $out) = self;
                    let flat = $flat;
                    kernel::$name::entries(&turned::<S>(q), $($argument,)* |$k, x| flat[$place] = x);
                }
            }
            let mut out = $zero;
            level.run(Of(q, $($argument,)* &mut out));
            out
        }
    };
}

macro_rules! eight {
    ($(#[$doc:meta])* fn $name:ident($($argument:ident: $kind:ty),*) -> $result:ty, |$out:ident| $flat:expr, |$k:ident| $place:expr) => {
        $(#[$doc])*
        pub fn $name(level: Level, q: &[[f64; 8]; DOF], $($argument: &$kind,)* out: &mut $result) {
            struct Of<'a>(&'a [[f64; 8]; DOF], $(&'a $kind,)* &'a mut $result);
            impl Work for Of<'_> {
                type Result = ();
                #[inline(always)]
                fn run<S: Set>(self) {
                    let Self(q, $($argument,)* $out) = self;
                    let flat = $flat;
                    let trig = super::turned_eight::<S>(&eights::<S, DOF>(q));
                    kernel::$name::entries(&trig, $(&eights::<S, _>($argument),)* |$k, x: S::Eight| x.store(&mut flat[$place]));
                }
            }
            level.run(Of(q, $($argument,)* out));
        }
    };
}

#[inline(always)]
fn turned<S: Set>(q: &[f64; DOF]) -> Trig<f64> {
    let angles = *q;
    let (sin, cos) = sines_and_cosines::<S, DOF>(&angles);
    Trig { q: *q, sin, cos }
}

#[inline(always)]
fn turned_eight<S: Set>(q: &[<S as Set>::Eight; DOF]) -> Trig<<S as Set>::Eight> {
    let angles = *q;
    let (sin, cos) = S::Eight::sin_cos_all(&angles);
    Trig { q: *q, sin, cos }
}

one! {
    /// DH frames of all rows in the world frame.
    fn frames() -> [[[f64; 4]; 3]; 7] = [[[0.0; 4]; 3]; 7], |out| out.as_flattened_mut().as_flattened_mut(), |k| kernel::frames::place(k)
}

one! {
    /// The last DH frame in the world frame.
    fn forward_kinematics() -> [[f64; 4]; 3] = [[0.0; 4]; 3], |out| out.as_flattened_mut(), |k| k
}

one! {
    /// The tool frame in the world frame.
    fn tool_pose() -> [[f64; 4]; 3] = [[0.0; 4]; 3], |out| out.as_flattened_mut(), |k| k
}

one! {
    /// Jacobian of the last DH frame's origin, in world axes.
    fn jacobian() -> [[f64; 7]; 6] = [[0.0; 7]; 6], |out| out.as_flattened_mut(), |k| kernel::jacobian::place(k)
}

one! {
    /// Jacobian of the tool frame's origin, in world axes.
    fn tool_jacobian() -> [[f64; 7]; 6] = [[0.0; 7]; 6], |out| out.as_flattened_mut(), |k| kernel::tool_jacobian::place(k)
}

one! {
    /// Acceleration of the last DH frame at zero `ddq`: `dJ/dt dq`.
    fn jacobian_dot_velocity(dq: [f64; DOF]) -> [f64; 6] = [0.0; 6], |out| out, |k| k
}

one! {
    /// Torques from the standard parameters.
    fn inverse_dynamics(dq: [f64; DOF], ddq: [f64; DOF], phi: [f64; STANDARD]) -> [f64; 7] = [0.0; 7], |out| out, |k| k
}

one! {
    /// Torques from the base parameters.
    fn inverse_dynamics_base(dq: [f64; DOF], ddq: [f64; DOF], beta: [f64; BASE]) -> [f64; 7] = [0.0; 7], |out| out, |k| k
}

one! {
    /// Mass matrix `M`, symmetric, kg m^2.
    fn mass_matrix(beta: [f64; BASE]) -> [[f64; 7]; 7] = [[0.0; 7]; 7], |out| out.as_flattened_mut(), |k| k
}

one! {
    /// Coriolis and centrifugal torques `C dq`.
    fn coriolis(dq: [f64; DOF], beta: [f64; BASE]) -> [f64; 7] = [0.0; 7], |out| out, |k| k
}

one! {
    /// Gravity torques `g`.
    fn gravity(beta: [f64; BASE]) -> [f64; 7] = [0.0; 7], |out| out, |k| k
}

one! {
    /// Accelerations under given torques.
    fn forward_dynamics(dq: [f64; DOF], tau: [f64; DOF], beta: [f64; BASE]) -> [f64; 7] = [0.0; 7], |out| out, |k| k
}

one! {
    /// Regressor `W` of the standard parameters.
    fn regressor(dq: [f64; DOF], ddq: [f64; DOF]) -> [[f64; 91]; 7] = [[0.0; 91]; 7], |out| out.as_flattened_mut(), |k| kernel::regressor::place(k)
}

one! {
    /// Regressor `W_b` of the base parameters.
    fn base_regressor(dq: [f64; DOF], ddq: [f64; DOF]) -> [[f64; 64]; 7] = [[0.0; 64]; 7], |out| out.as_flattened_mut(), |k| kernel::base_regressor::place(k)
}

one! {
    /// Regressor at rest.
    fn gravity_regressor() -> [[f64; 70]; 7] = [[0.0; 70]; 7], |out| out.as_flattened_mut(), |k| kernel::gravity_regressor::place(k)
}

one! {
    /// Kinetic energy, one entry per standard parameter.
    fn kinetic_energy_regressor(dq: [f64; DOF]) -> [f64; 91] = [0.0; 91], |out| out, |k| kernel::kinetic_energy_regressor::place(k)
}

one! {
    /// Potential energy, one entry per standard parameter.
    fn potential_energy_regressor() -> [f64; 91] = [0.0; 91], |out| out, |k| kernel::potential_energy_regressor::place(k)
}

one! {
    /// Regressor of a body fixed to the tool frame.
    fn payload_regressor(dq: [f64; DOF], ddq: [f64; DOF]) -> [[f64; 10]; 7] = [[0.0; 10]; 7], |out| out.as_flattened_mut(), |k| kernel::payload_regressor::place(k)
}

/// Eight states at once. Entries that are structurally zero are not touched.
pub mod eight {
    use super::super::*;
    use super::{Level, Numbers, Set, Work, eights};

    eight! {
        /// DH frames of all rows in the world frame.
        fn frames() -> [[[[f64; 8]; 4]; 3]; 7], |out| out.as_flattened_mut().as_flattened_mut(), |k| kernel::frames::place(k)
    }

    eight! {
        /// The last DH frame in the world frame.
        fn forward_kinematics() -> [[[f64; 8]; 4]; 3], |out| out.as_flattened_mut(), |k| k
    }

    eight! {
        /// The tool frame in the world frame.
        fn tool_pose() -> [[[f64; 8]; 4]; 3], |out| out.as_flattened_mut(), |k| k
    }

    eight! {
        /// Jacobian of the last DH frame's origin, in world axes.
        fn jacobian() -> [[[f64; 8]; 7]; 6], |out| out.as_flattened_mut(), |k| kernel::jacobian::place(k)
    }

    eight! {
        /// Jacobian of the tool frame's origin, in world axes.
        fn tool_jacobian() -> [[[f64; 8]; 7]; 6], |out| out.as_flattened_mut(), |k| kernel::tool_jacobian::place(k)
    }

    eight! {
        /// Acceleration of the last DH frame at zero `ddq`: `dJ/dt dq`.
        fn jacobian_dot_velocity(dq: [[f64; 8]; DOF]) -> [[f64; 8]; 6], |out| out, |k| k
    }

    eight! {
        /// Torques from the standard parameters.
        fn inverse_dynamics(dq: [[f64; 8]; DOF], ddq: [[f64; 8]; DOF], phi: [[f64; 8]; STANDARD]) -> [[f64; 8]; 7], |out| out, |k| k
    }

    eight! {
        /// Torques from the base parameters.
        fn inverse_dynamics_base(dq: [[f64; 8]; DOF], ddq: [[f64; 8]; DOF], beta: [[f64; 8]; BASE]) -> [[f64; 8]; 7], |out| out, |k| k
    }

    eight! {
        /// Mass matrix `M`, symmetric, kg m^2.
        fn mass_matrix(beta: [[f64; 8]; BASE]) -> [[[f64; 8]; 7]; 7], |out| out.as_flattened_mut(), |k| k
    }

    eight! {
        /// Coriolis and centrifugal torques `C dq`.
        fn coriolis(dq: [[f64; 8]; DOF], beta: [[f64; 8]; BASE]) -> [[f64; 8]; 7], |out| out, |k| k
    }

    eight! {
        /// Gravity torques `g`.
        fn gravity(beta: [[f64; 8]; BASE]) -> [[f64; 8]; 7], |out| out, |k| k
    }

    eight! {
        /// Accelerations under given torques.
        fn forward_dynamics(dq: [[f64; 8]; DOF], tau: [[f64; 8]; DOF], beta: [[f64; 8]; BASE]) -> [[f64; 8]; 7], |out| out, |k| k
    }

    eight! {
        /// Regressor `W` of the standard parameters.
        fn regressor(dq: [[f64; 8]; DOF], ddq: [[f64; 8]; DOF]) -> [[[f64; 8]; 91]; 7], |out| out.as_flattened_mut(), |k| kernel::regressor::place(k)
    }

    eight! {
        /// Regressor `W_b` of the base parameters.
        fn base_regressor(dq: [[f64; 8]; DOF], ddq: [[f64; 8]; DOF]) -> [[[f64; 8]; 64]; 7], |out| out.as_flattened_mut(), |k| kernel::base_regressor::place(k)
    }

    eight! {
        /// Regressor at rest.
        fn gravity_regressor() -> [[[f64; 8]; 70]; 7], |out| out.as_flattened_mut(), |k| kernel::gravity_regressor::place(k)
    }

    eight! {
        /// Kinetic energy, one entry per standard parameter.
        fn kinetic_energy_regressor(dq: [[f64; 8]; DOF]) -> [[f64; 8]; 91], |out| out, |k| kernel::kinetic_energy_regressor::place(k)
    }

    eight! {
        /// Potential energy, one entry per standard parameter.
        fn potential_energy_regressor() -> [[f64; 8]; 91], |out| out, |k| kernel::potential_energy_regressor::place(k)
    }

    eight! {
        /// Regressor of a body fixed to the tool frame.
        fn payload_regressor(dq: [[f64; 8]; DOF], ddq: [[f64; 8]; DOF]) -> [[[f64; 8]; 10]; 7], |out| out.as_flattened_mut(), |k| kernel::payload_regressor::place(k)
    }

}
