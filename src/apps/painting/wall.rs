//! The wall that a roller presses on, and the force sensor behind it.

use crate::numerics::prng::Random;
use crate::simulate::{External, Wrench};

/// A roller on a wall: both are compliant along the normal; the roller rolls across its axis and
/// slides along it.
///
/// The normal force is `k d (1 + c d')` (Hunt and Crossley, J. Applied Mechanics 42, 1975), with
/// `d` the penetration at the point of contact; it never pulls. Tangential forces oppose the
/// motion: rolling resistance across the roller's axis and sliding friction along it, both smoothed
/// below `creep`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RollerWall {
    /// A point of the plane, world axes, m.
    pub point: [f64; 3],
    /// Unit normal out of the wall, world axes.
    pub normal: [f64; 3],
    /// Point of contact of the tool, tool frame, m.
    pub contact: [f64; 3],
    /// Stiffness `k` of roller and wall in series, N/m.
    pub stiffness: f64,
    /// Damping `c`, s/m.
    pub damping: f64,
    /// Coefficient of rolling resistance: per normal force.
    pub rolling: f64,
    /// Coefficient of sliding friction along the roller's axis (x of the tool): per normal force.
    pub sliding: f64,
    /// Speed below which tangential forces are smoothed, m/s.
    pub creep: f64,
}

impl RollerWall {
    /// Creates a wall of 8 kN/m: 30 N press a nap of some centimetres' length 4 mm deep. Rolling
    /// resistance is 5 %, that of a soft tyre; sliding friction half the normal force.
    pub fn new(point: [f64; 3], normal: [f64; 3], contact: [f64; 3]) -> Self {
        let length = normal.iter().map(|n| n * n).sum::<f64>().sqrt();
        Self {
            point,
            normal: normal.map(|n| n / length),
            contact,
            stiffness: 8e3,
            damping: 2.0,
            rolling: 0.05,
            sliding: 0.5,
            creep: 5e-3,
        }
    }

    /// Effective viscous damping at this force, N s/m.
    pub fn damping_at(&self, force: f64) -> f64 {
        self.damping * force
    }
}

impl External for RollerWall {
    fn wrench(&self, _: f64, pose: &[f64; 12], twist: &[f64; 6]) -> Wrench {
        let n = self.normal;
        let turned =
            |v: [f64; 3]| -> [f64; 3] { std::array::from_fn(|i| (0..3).map(|k| pose[4 * i + k] * v[k]).sum()) };
        let arm = turned(self.contact);
        let w = [twist[3], twist[4], twist[5]];
        let velocity: [f64; 3] = std::array::from_fn(|i| twist[i] + cross(w, arm)[i]);
        let depth: f64 = (0..3).map(|k| n[k] * (self.point[k] - pose[4 * k + 3] - arm[k])).sum();
        let speed: f64 = (0..3).map(|k| n[k] * velocity[k]).sum();
        let factor = 1.0 - self.damping * speed;
        let mut result = Wrench::default();
        if depth <= 0.0 || factor <= 0.0 {
            return result;
        }
        let press = self.stiffness * depth * factor;
        // The roller's axis in the plane of the wall.
        let x = turned([1.0, 0.0, 0.0]);
        let out: f64 = (0..3).map(|k| x[k] * n[k]).sum();
        let axis: [f64; 3] = std::array::from_fn(|k| x[k] - out * n[k]);
        let size = axis.iter().map(|a| a * a).sum::<f64>().sqrt().max(1e-9);
        let axis = axis.map(|a| a / size);
        let across = cross(n, axis);
        let mut drag = [[0.0; 3]; 3];
        let mut force: [f64; 3] = n.map(|n| press * n);
        for (direction, coefficient) in [(across, self.rolling), (axis, self.sliding)] {
            let v: f64 = (0..3).map(|k| direction[k] * velocity[k]).sum();
            let slope = coefficient * press / (v * v + self.creep * self.creep).sqrt();
            for i in 0..3 {
                force[i] -= slope * v * direction[i];
                (0..3).for_each(|k| drag[i][k] += slope * direction[i] * direction[k]);
            }
        }
        let moment = cross(arm, force);
        for i in 0..3 {
            (result.wrench[i], result.wrench[3 + i]) = (force[i], moment[i]);
            for k in 0..3 {
                let along = n[i] * n[k];
                result.stiffness[i][k] = self.stiffness * factor * along;
                result.damping[i][k] = self.stiffness * depth * self.damping * along + drag[i][k];
            }
        }
        result
    }
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// A force sensor in the centre of the wall: the ATI Mini45 with its smallest calibration
/// (SI-145-5: 145 N across, 290 N along its axis, resolution 1/16 N; docs/control.md has the
/// source). The noise has a standard deviation of one resolution step.
#[derive(Debug, Clone)]
pub struct WallSensor {
    /// White noise, standard deviation, N.
    pub noise: f64,
    /// Resolution, N.
    pub step: f64,
    /// Largest force in the output, N.
    pub range: f64,
    random: Random,
}

impl WallSensor {
    /// Creates a sensor with this seed of its noise.
    pub fn new(seed: u64) -> Self {
        Self { noise: 1.0 / 16.0, step: 1.0 / 16.0, range: 290.0, random: Random::new(seed ^ 0xA71) }
    }

    /// Reading for a force along its axis, N.
    pub fn read(&mut self, force: f64) -> f64 {
        // Sum of twelve uniform numbers: near enough to normal, and a fixed number of draws.
        let normal: f64 = (0..12).map(|_| self.random.even(1.0)).sum::<f64>() * 0.5;
        let value = force + self.noise * normal;
        ((value / self.step).round() * self.step).clamp(-self.range, self.range)
    }
}
