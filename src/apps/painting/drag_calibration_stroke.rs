//! A short stroke along the roller's axis, from which the controller learns the roller's drag
//! before painting.

use crate::control::law::Model;
use crate::control::robot::RobotModel;
use crate::simulate::Trajectory;

/// Length of the stroke, m: joints of some hundred N m/rad yield by a centimetre before the roller
/// slides. `TIME` is the time there and back, and `REST` that of the rest before painting begins,
/// s.
const FAR: f64 = 0.04;
const TIME: f64 = 1.5;
const REST: f64 = 0.6;
/// Time at the beginning of settling in which the force rises, s.
const BEFORE: f64 = 0.9;
/// Number of knots per second.
const RATE: f64 = 100.0;

/// The stroke from a posture in contact and back to it, in the last seconds of the settling time
/// `settle`, s, first in the direction of the plan. `None` if there is not enough time or no
/// posture.
pub(super) fn calibration_stroke<const N: usize>(
    model: &mut RobotModel<'_>,
    first: &[f64; N],
    postures: &[[f64; N]],
    normal: &[f64; 3],
    settle: f64,
) -> Option<Trajectory> {
    if settle < BEFORE + TIME + REST {
        return None;
    }
    let start = model.contact(first);
    let axis: [f64; 3] = std::array::from_fn(|i| start.rotation[i][0]);
    let out: f64 = (0..3).map(|i| axis[i] * normal[i]).sum();
    let axis: [f64; 3] = std::array::from_fn(|i| axis[i] - out * normal[i]);
    let mut ahead = 0.0;
    for q in postures {
        let there = model.contact(q).origin;
        ahead += (0..3).map(|i| axis[i] * (there[i] - start.origin[i])).sum::<f64>();
    }
    let count = (TIME * RATE) as usize;
    let (mut t, mut rows, mut near) = (Vec::new(), Vec::new(), *first);
    for k in 0..=count {
        let s = k as f64 / count as f64;
        // There and back, with zero velocity and acceleration at both ends.
        let way = FAR.copysign(ahead) * 64.0 * (s * (1.0 - s)).powi(3);
        near = model.displaced(first, &axis.map(|a| a * way), &near)?;
        t.push(settle - REST - TIME + TIME * s);
        rows.push(near);
    }
    let q = (0..N).flat_map(|j| rows.iter().map(move |row| row[j])).collect();
    Trajectory::new(N, t, q, None, None).ok()
}
