//! Loop of one joint: proportional-derivative control with a backward difference, torques held over
//! a period.

use nalgebra::{Complex, DMatrix, DVector};

use super::sampled::{Margins, held, radius, response};

/// Plant of a joint's loop.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JointPlant {
    /// Time between samples, s.
    pub period: f64,
    /// Number of periods until a torque acts.
    pub delay: u32,
    /// Smallest and largest inertia at the joint, rotor included, kg m^2.
    pub inertia: [f64; 2],
    /// Inertia of the rotor alone, kg m^2: what a soft joint's loop moves at high frequencies.
    /// Infinite for a rigid joint.
    pub rotor: f64,
    /// Stiffness of the spring between rotor and link, N m/rad.
    pub stiffness: f64,
    /// Damping of the spring, N m s/rad.
    pub damping: f64,
    /// Viscous friction, N m s/rad.
    pub viscous: f64,
}

/// Gains of a joint with the resulting bandwidth and margins.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JointProposal {
    /// Proportional gain, N m/rad.
    pub kp: f64,
    /// Derivative gain, N m s/rad.
    pub kd: f64,
    /// `sqrt(kp / inertia)` with the largest inertia, rad/s.
    pub bandwidth: f64,
    /// Worst margins over rigid and soft joint, smallest and largest inertia.
    pub margins: Margins,
}

impl JointPlant {
    /// Margins with these gains, the worst over all cases.
    pub fn margins(&self, kp: f64, kd: f64) -> Margins {
        let mut worst: Option<Margins> = None;
        for inertia in self.inertia {
            for soft in [false, true] {
                // A light link on a spring is faster than any sampling; `arm` checks all joints
                // together.
                if soft && !(inertia == self.inertia[1] && self.rotor < inertia && self.stiffness.is_finite()) {
                    continue;
                }
                let found = self.case(inertia, soft, kp, kd);
                worst = Some(worst.map_or(found, |w| w.worse(found)));
            }
        }
        worst.unwrap_or(Margins { crossover: 0.0, phase: 0.0, gain: 0.0, modulus: 0.0, radius: f64::INFINITY })
    }

    fn case(&self, inertia: f64, soft: bool, kp: f64, kd: f64) -> Margins {
        let Self { period, rotor, stiffness, damping, viscous, .. } = *self;
        // States, motor first: [x, x', (link, link')].
        let (a, b) = if soft {
            let link = inertia - rotor;
            let (k, d) = (stiffness, damping);
            let a = DMatrix::from_row_slice(
                4,
                4,
                &[
                    0.0,
                    1.0,
                    0.0,
                    0.0, //
                    -k / rotor,
                    -(viscous + d) / rotor,
                    k / rotor,
                    d / rotor, //
                    0.0,
                    0.0,
                    0.0,
                    1.0, //
                    k / link,
                    d / link,
                    -k / link,
                    -d / link,
                ],
            );
            (a, DMatrix::from_column_slice(4, 1, &[0.0, 1.0 / rotor, 0.0, 0.0]))
        } else {
            let a = DMatrix::from_row_slice(2, 2, &[0.0, 1.0, 0.0, -viscous / inertia]);
            (a, DMatrix::from_column_slice(2, 1, &[0.0, 1.0 / inertia]))
        };
        let (ad, bd) = held(&a, &b, period);
        let n = ad.nrows();
        let late = self.delay as usize;
        // [x.., previous position, torques in transit]
        let size = n + 1 + late;
        let mut closed = DMatrix::zeros(size, size);
        closed.view_mut((0, 0), (n, n)).copy_from(&ad);
        closed[(n, 0)] = 1.0;
        let mut command = DVector::zeros(size);
        command[0] = -(kp + kd / period);
        command[n] = kd / period;
        for k in 0..size {
            if late == 0 {
                (0..n).for_each(|i| closed[(i, k)] += bd[(i, 0)] * command[k]);
            } else {
                closed[(n + late, k)] += command[k];
            }
        }
        for step in 0..late {
            if step == 0 {
                (0..n).for_each(|i| closed[(i, n + 1)] += bd[(i, 0)]);
            } else {
                closed[(n + step, n + 1 + step)] += 1.0;
            }
        }
        let input = bd.column(0).into_owned();
        let mut output = DVector::zeros(n);
        output[0] = 1.0;
        Margins::of(period, radius(&closed), |z| {
            let back = z.inv();
            let control: Complex<f64> = (Complex::new(1.0, 0.0) - back) * (kd / period) + kp;
            control * response(&ad, &input, &output, z) * back.powu(self.delay)
        })
    }
}

/// Margins of a joint's loop: 30 degrees, a factor of two (6 dB), and a sensitivity of at most 2.2.
/// They are lower than [`wanted`](super::wanted), as the joint loops are there to provide
/// stiffness.
pub fn wanted_joint(m: &Margins) -> bool {
    m.radius < 1.0 && m.phase >= 30.0 && m.gain >= 6.0 && m.modulus >= 0.45
}

/// Damping ratios for the largest inertia, well damped ones first. Where a light rotor limits the
/// derivative gain, a lower ratio allows more stiffness (with its inverse square). A ratio of 0.35
/// is a phase margin of 38 degrees for a rigid joint.
const DAMPING: [f64; 3] = [0.7, 0.5, 0.35];

/// Proposes the stiffest gains that keep the margins, over several damping ratios. A lower ratio is
/// accepted only if it gives half as much stiffness again.
pub fn propose_joint(plant: &JointPlant) -> Option<JointProposal> {
    let heavy = plant.inertia[1];
    let mut best: Option<JointProposal> = None;
    for damping in DAMPING {
        let of = |bandwidth: f64| (heavy * bandwidth * bandwidth, 2.0 * damping * heavy * bandwidth);
        let good = |bandwidth: f64| {
            let (kp, kd) = of(bandwidth);
            wanted_joint(&plant.margins(kp, kd))
        };
        let Some(bandwidth) = largest(0.1, 1e3, good) else { continue };
        let (kp, kd) = of(bandwidth);
        if best.is_none_or(|b| kp > 1.5 * b.kp) {
            best = Some(JointProposal { kp, kd, bandwidth, margins: plant.margins(kp, kd) });
        }
    }
    best
}

/// Largest value up to which `good` holds, to 5 %; `None` if not even `low` is good.
pub(super) fn largest(low: f64, high: f64, good: impl Fn(f64) -> bool) -> Option<f64> {
    if !good(low) {
        return None;
    }
    let (mut low, mut high) = (low, high);
    while high > 1.05 * low {
        let middle = (low * high).sqrt();
        if good(middle) { low = middle } else { high = middle }
    }
    Some(low)
}
