//! Simulates a spring and damper between a motor and its link, along a given motion of the motor.
//!
//! With `d` the angle of the motor minus that of the link, the link's equation of motion (M. W.
//! Spong, *Modeling and control of elastic joint robots*, J. Dyn. Sys. Meas. Control 109, 1987) to
//! first order in `d` is `m d'' + (D + c) d' + (K + g) d = f`. Here `f` is the torque of the arm at
//! zero deflection. `m`, `c`, `g` are its derivatives with respect to the link's acceleration,
//! velocity and position, `K` and `D` spring and damper. Motions of other joints act through `f`.
//! The equation is solved by the trapezoidal rule, which adds no numerical damping.

use super::hermite::cubic;

/// Link load at evenly spaced instants.
#[derive(Debug, Clone, Copy)]
pub struct LinkLoad<'a> {
    /// `f`, N m.
    pub load: &'a [f64],
    /// `m`, kg m^2.
    pub inertia: &'a [f64],
    /// `c`, N m s/rad.
    pub damping: &'a [f64],
    /// `g`, N m/rad.
    pub stiffness: &'a [f64],
    /// Sampling period, s.
    pub step: f64,
}

/// Spring and damper of a joint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spring {
    /// `K`, N m/rad.
    pub stiffness: f64,
    /// `D`, N m s/rad.
    pub damping: f64,
}

/// Angle of the motor minus that of the link, rad, with its first and second derivatives.
pub type Deflection = [Vec<f64>; 3];

/// Largest phase of the oscillation per integration step, rad.
const FINE: f64 = 0.1;
/// Maximum number of steps per sample: faster oscillations follow their load quasi-statically.
const MOST: f64 = 40.0;

impl Spring {
    /// Quasi-static deflection: initial angle and rate.
    pub fn quasi_static(self, asked: &LinkLoad<'_>) -> [f64; 2] {
        let stiffness = |k: usize| self.stiffness + asked.stiffness[k];
        match asked.load {
            [] => [0.0; 2],
            [only] => [only / stiffness(0), 0.0],
            [first, second, ..] => {
                let (here, next) = (first / stiffness(0), second / stiffness(1));
                [here, (next - here) / asked.step]
            }
        }
    }

    /// Integrates from the angle and rate `start` at the first instant.
    pub fn integrate(self, asked: &LinkLoad<'_>, start: [f64; 2]) -> Deflection {
        let [only] = Self::damped(self.stiffness, [self.damping], asked, [start]);
        only
    }

    /// Integrates springs that differ in their dampers or initial states. They share their steps,
    /// and a processor computes several in the time of one.
    pub fn damped<const N: usize>(
        stiffness: f64,
        dampings: [f64; N],
        asked: &LinkLoad<'_>,
        starts: [[f64; 2]; N],
    ) -> [Deflection; N] {
        let len = asked.load.len();
        let mut found: [Deflection; N] = std::array::from_fn(|_| std::array::from_fn(|_| Vec::with_capacity(len)));
        let mut states = starts;
        let last = len.saturating_sub(1);
        for k in 0..len {
            let (m, s) = (asked.inertia[k], stiffness + asked.stiffness[k]);
            for (([x, v], damping), [angle, rate, second]) in states.iter().zip(dampings).zip(&mut found) {
                angle.push(*x);
                rate.push(*v);
                second.push((asked.load[k] - (damping + asked.damping[k]) * v - s * x) / m);
            }
            if k == last {
                break;
            }
            let (m1, s1) = (asked.inertia[k + 1], stiffness + asked.stiffness[k + 1]);
            let rate = asked.step * (s.max(s1).max(0.0) / m.min(m1)).sqrt() / FINE;
            // Round up without a library call.
            let parts = rate.clamp(1.0, MOST) as usize;
            let parts = if (parts as f64) < rate { (parts + 1).min(MOST as usize) } else { parts };
            let h = asked.step / parts as f64;
            let near =
                [asked.load[k.saturating_sub(1)], asked.load[k], asked.load[k + 1], asked.load[(k + 2).min(last)]];
            for part in 0..parts {
                let f = (part as f64 + 0.5) / parts as f64;
                let between = |a: f64, b: f64| a + f * (b - a);
                let (load, own) = (catmull_rom(near, f), between(asked.damping[k], asked.damping[k + 1]));
                let (m, s) = (between(m, m1), between(s, s1));
                for ([x, v], damping) in states.iter_mut().zip(dampings) {
                    let d = damping + own;
                    // Midpoint values for the whole step. Little work depends on the state.
                    let inverse = (m + 0.5 * h * d + 0.25 * h * h * s).recip();
                    let a = inverse * load - inverse * (d + 0.5 * h * s) * *v - inverse * s * *x;
                    *x = *x + h * *v + 0.5 * h * h * a;
                    *v += h * a;
                }
            }
        }
        found
    }
}

/// Catmull-Rom cubic between the second and the third of four evenly spaced values.
fn catmull_rom([a, b, c, d]: [f64; 4], s: f64) -> f64 {
    cubic([b, c], [0.5 * (c - a), 0.5 * (d - b)], s)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Springs integrated together equal those integrated one by one, bit for bit.
    #[test]
    fn springs_with_other_dampers_are_springs() {
        let len = 60;
        let series = |by: f64| -> Vec<f64> { (0..len).map(|k| 2.0 + (by * k as f64).sin()).collect() };
        let (load, inertia, damping, stiffness) = (series(0.3), series(0.1), series(0.2), series(0.05));
        let (load, inertia, damping, stiffness) = (&load[..], &inertia[..], &damping[..], &stiffness[..]);
        let asked = LinkLoad { load, inertia, damping, stiffness, step: 0.01 };
        let (dampings, starts) = ([3.0, 40.0], [[0.01, -0.2], [0.03, 0.5]]);
        let together = Spring::damped(900.0, dampings, &asked, starts);
        for (k, found) in together.iter().enumerate() {
            let alone = Spring { stiffness: 900.0, damping: dampings[k] }.integrate(&asked, starts[k]);
            assert_eq!(*found, alone);
        }
    }

    /// A step load and a sinusoidal load, against the closed-form solutions of the damped
    /// oscillator.
    #[test]
    fn it_is_the_damped_oscillator() {
        let (m, c, k) = (2.0, 4.0, 1800.0);
        let spring = Spring { stiffness: k, damping: c };
        let len = 400;
        let (inertia, none) = (vec![m; len], vec![0.0; len]);
        let asked = |load, step| LinkLoad { load, inertia: &inertia, damping: &none, stiffness: &none, step };
        let w0 = f64::sqrt(k / m);
        let z = c / (2.0 * f64::sqrt(k * m));
        let wd = w0 * f64::sqrt(1.0 - z * z);
        let step = 0.01;
        let load = vec![9.0; len];
        let [x, v, a] = spring.integrate(&asked(&load, step), [0.0; 2]);
        for i in 0..len {
            let t = i as f64 * step;
            let ring = f64::exp(-z * w0 * t) * ((wd * t).cos() + z * w0 / wd * (wd * t).sin());
            assert!((x[i] - 9.0 / k * (1.0 - ring)).abs() < 0.02 * 9.0 / k, "{i}: {}", x[i]);
            assert!((m * a[i] + c * v[i] + k * x[i] - 9.0).abs() < 1e-9, "{i}");
        }
        let w = 9.0;
        let load: Vec<f64> = (0..len).map(|i| (w * i as f64 * step).sin()).collect();
        let [x, v, _] = spring.integrate(&asked(&load, step), [0.0; 2]);
        let (re, im) = (k - m * w * w, c * w);
        let size = 1.0 / f64::hypot(re, im);
        for i in 350..len {
            let p = w * i as f64 * step - f64::atan2(im, re);
            assert!((x[i] - size * p.sin()).abs() < 0.02 * size && (v[i] - w * size * p.cos()).abs() < 0.03 * w * size);
        }
        let [angle, _] = spring.quasi_static(&asked(&[9.0], step));
        assert!((angle - 9.0 / k).abs() < 1e-15);
    }
}
