//! A periodic exciting motion: sums of sines within the robot's limits, the best of several for
//! identifying the load.

use std::f64::consts::{FRAC_PI_2, TAU};

use dh_codegen::robot::Robot;

use crate::identify::RFactor;
use crate::identify::tool::Carrying;
use crate::model::{Arm, Payload, States};
use crate::numerics::prng::Random;

/// A sum of sines per joint.
#[derive(Debug, Clone, PartialEq)]
pub struct Waves {
    /// Period, s.
    pub period: f64,
    /// Middle of each joint's motion, rad.
    rest: Vec<f64>,
    /// Amplitude and phase of each harmonic of each joint.
    terms: Vec<Vec<[f64; 2]>>,
}

/// Number of harmonics of a motion: up to 1 Hz in 10 s, as for splines with a knot per second (the
/// paper, section III.A); far below the low-pass.
const HARMONICS: usize = 10;
/// Share of the limits that is used.
const SHARE: f64 = 0.8;
/// Defaults where the robot file has no limit, rad and rad/s.
const POSITION: [f64; 2] = [-2.5, 2.5];
const SPEED: f64 = 1.5;

impl Waves {
    /// A random motion within the limits.
    pub fn random(robot: &Robot, period: f64, random: &mut Random) -> Self {
        let mut waves = Self { period, rest: Vec::new(), terms: Vec::new() };
        for row in robot.moving() {
            let limits = &robot.joints[row].limits;
            let ([low, high], speed) = (limits.position.unwrap_or(POSITION), limits.velocity.unwrap_or(SPEED));
            let terms: Vec<[f64; 2]> =
                (1..=HARMONICS).map(|_| [random.uniform(0.1, 1.0), random.uniform(0.0, TAU)]).collect();
            let one = Self { period, rest: vec![0.0], terms: vec![terms] };
            let largest = |derivative| {
                (0..200).map(|k| one.joint(0, period * f64::from(k) / 200.0, derivative).abs()).fold(1e-9, f64::max)
            };
            let half = 0.5 * SHARE * (high - low);
            let scale = (half / largest(0)).min(SHARE * speed / largest(1));
            // The middle may be anywhere in the rest of the range.
            let free = (half - scale * largest(0)).max(0.0);
            waves.rest.push(0.5 * (low + high) + random.even(1.0) * free);
            waves.terms.push(one.terms[0].iter().map(|[a, phase]| [scale * a, *phase]).collect());
        }
        waves
    }

    /// The best of `tries` motions for mass and first moments of the load, with this noise of each
    /// joint's torque. It has the largest `log det` of their inverse covariance, with all other
    /// unknowns of equation (7) estimated too (D_s-optimal: Atkinson and Donev, *Optimum
    /// Experimental Designs*, 1992).
    pub fn exciting(robot: &Robot, arm: &dyn Payload, noise: &[f64], period: f64, tries: usize, seed: u64) -> Self {
        let mut random = Random::new(seed);
        let both = [Carrying::new(arm, false), Carrying::new(arm, true)];
        let mut best = Self::random(robot, period, &mut random);
        let mut most = best.criterion(&both, noise);
        for _ in 1..tries {
            let other = Self::random(robot, period, &mut random);
            let value = other.criterion(&both, noise);
            if value > most {
                (best, most) = (other, value);
            }
        }
        best
    }

    fn criterion(&self, arms: &[Carrying<'_>; 2], noise: &[f64]) -> f64 {
        let states = self.states(100);
        let (len, columns) = (states.len, arms[0].base_parameters().len());
        // Mass and first moments last: the last four rows of the factor then hold their remaining
        // information.
        let place = |c: usize| match c.checked_sub(columns - 10) {
            None => c,
            Some(k) if k < 4 => columns - 4 + k,
            Some(_) => c - 4,
        };
        let mut triangle = RFactor::new(columns);
        for arm in arms {
            let mut entries = vec![0.0; arm.base_pattern().len() * len];
            arm.base_regressor(&states, &mut entries);
            for (joint, noise) in noise.iter().enumerate() {
                let mut block = vec![0.0; columns * len];
                for (entry, &(_, column)) in
                    entries.chunks_exact(len).zip(arm.base_pattern()).filter(|(_, (row, _))| *row == joint)
                {
                    let to = &mut block[place(column) * len..(place(column) + 1) * len];
                    to.iter_mut().zip(entry).for_each(|(t, w)| *t = w / noise);
                }
                triangle.absorb(&mut block, len);
            }
        }
        (columns - 4..columns).map(|k| triangle.get(k, k).abs().max(1e-300).ln()).sum()
    }

    /// States at `len` instants, evenly spaced over the period.
    fn states(&self, len: usize) -> States {
        let all = |derivative| -> Vec<f64> {
            let dof = self.terms.len();
            (0..dof * len)
                .map(|k| self.joint(k / len, self.period * (k % len) as f64 / len as f64, derivative))
                .collect()
        };
        States { len, q: all(0), dq: all(1), ddq: all(2) }
    }

    /// A joint's position or a derivative of it; the k-th derivative of a sine leads by k quarter
    /// turns.
    fn joint(&self, joint: usize, t: f64, derivative: i32) -> f64 {
        let rest = if derivative == 0 { self.rest[joint] } else { 0.0 };
        let lead = FRAC_PI_2 * f64::from(derivative);
        let wave = |(k, [a, phase]): (usize, &[f64; 2])| {
            let w = TAU * (k + 1) as f64 / self.period;
            a * w.powi(derivative) * (w * t + phase + lead).sin()
        };
        rest + self.terms[joint].iter().enumerate().map(wave).sum::<f64>()
    }

    /// Positions, velocities and accelerations of all joints at time `t`, s.
    pub fn at(&self, t: f64) -> [Vec<f64>; 3] {
        [0, 1, 2].map(|derivative| (0..self.terms.len()).map(|joint| self.joint(joint, t, derivative)).collect())
    }
}
