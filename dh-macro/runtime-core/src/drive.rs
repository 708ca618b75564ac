//! Drives with memory: friction that depends on the travel since the last reversal, on time and on
//! temperature; links that swing on the springs of their gears. Shipped verbatim into crates whose
//! robot file has effects; the interpreter uses the same text.

use super::elementary::Real;

/// Constants of the memory of one joint's drive; a travel of 0 is no bristle, a time of 0 no drift.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Memory {
    /// `HX`: the travel in which a bristle bends to 1 - 1/e of its level, rad or m.
    pub travel: f64,
    /// `DA`: what cold friction has more than warm friction, as a part of the latter.
    pub cold: f64,
    /// `DT`: time constant of the warming, s.
    pub time: f64,
    /// `DK`: change per kelvin.
    pub per_kelvin: f64,
    /// `T0`: temperature at which `per_kelvin` does nothing, degrees C.
    pub reference: f64,
}

impl Memory {
    /// Of a bristle that stood at `bristle`, after the joint went by `by`: Dahl's `dz/dt = (v /
    /// HX)(1 - z sign v)`, solved exactly.
    #[must_use]
    #[inline]
    pub fn bent<S: Real>(&self, bristle: S, by: S) -> S {
        let end = by.sign();
        if self.travel > 0.0 { end + (bristle - end) * (-(by.abs() / S::constant(self.travel))).exp() } else { end }
    }

    /// Factor of the friction `since` seconds after the start at `temperature`, degrees C; never
    /// less than 0.
    #[must_use]
    #[inline]
    pub fn warmth<S: Real>(&self, since: S, temperature: S) -> S {
        if self.time <= 0.0 {
            return S::constant(1.0);
        }
        let cold = (-(since / S::constant(self.time))).exp() * S::constant(self.cold);
        let heat = (temperature - S::constant(self.reference)) * S::constant(self.per_kelvin);
        (S::constant(1.0) + cold + heat).max(S::default())
    }
}

/// The spring between one joint's motor and link.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spring {
    /// `KE`, N m/rad; 0: none.
    pub stiffness: f64,
    /// `DE`, N m s/rad.
    pub damping: f64,
    /// `GT`: what the sensor shows of 1 N m.
    pub gain: f64,
}

/// Deflection of a link behind its motor: angle, rad, its rate and its acceleration.
pub type Deflection<S> = [S; 3];

/// Torques of the arm, N m, whose links stand so far behind their motors.
pub type Bodies<'a, S> = dyn FnMut(&[Deflection<S>], &mut [S]) + 'a;

/// Least damping ratio of a link on its spring: with less, what the motion was long ago would
/// count.
pub const LEAST_DAMPING: f64 = 0.01;

/// Quasi-static deflections: the springs carry their links, nothing swings. The deflected arm has
/// other torques, so the evaluation is repeated until the change is negligible. `bodies`: torques
/// of the arm with its links so far behind.
pub fn quasi_static<S: Real>(
    springs: &[Spring],
    deflection: &mut [Deflection<S>],
    torques: &mut [S],
    bodies: &mut Bodies<'_, S>,
) {
    deflection.fill([S::default(); 3]);
    for _ in 0..5 {
        deflect(springs, deflection, torques, bodies);
    }
}

/// Deflects the springs by the torques of the arm at the present deflections.
fn deflect<S: Real>(
    springs: &[Spring],
    deflection: &mut [Deflection<S>],
    torques: &mut [S],
    bodies: &mut Bodies<'_, S>,
) {
    bodies(deflection, torques);
    for ((deflection, spring), &torque) in deflection.iter_mut().zip(springs).zip(torques.iter()) {
        if spring.stiffness > 0.0 {
            deflection[0] = torque / S::constant(spring.stiffness);
        }
    }
}

/// The same one step later, `dt` s after [`quasi_static`], and with the rate of the deflections:
/// from here links [`swing`]. `scratch` is of `2 n` numbers.
pub fn start_swing<S: Real>(
    springs: &[Spring],
    dt: S,
    deflection: &mut [Deflection<S>],
    scratch: &mut [S],
    bodies: &mut Bodies<'_, S>,
) {
    let (torques, before) = scratch.split_at_mut(springs.len());
    before.iter_mut().zip(deflection.iter()).for_each(|(before, deflection)| *before = deflection[0]);
    quasi_static(springs, deflection, torques, bodies);
    for (deflection, &mut before) in deflection.iter_mut().zip(before) {
        deflection[1] = (deflection[0] - before) / dt;
    }
}

/// Integrates the links over `dt`, s, by the trapezoidal rule. For each soft joint `KE d + DE d'`
/// is the torque of the arm whose links stand `d` behind their motors, linear in the accelerations.
/// `bodies` gives that torque; `scratch` is of `n (n + 2)` numbers.
pub fn swing<S: Real>(
    springs: &[Spring],
    dt: S,
    deflection: &mut [Deflection<S>],
    scratch: &mut [S],
    bodies: &mut Bodies<'_, S>,
) {
    let n = springs.len();
    let (matrix, rest) = scratch.split_at_mut(n * n);
    let (load, column) = rest.split_at_mut(n);
    let (half, zero, one) = (dt * S::constant(0.5), S::default(), S::constant(1.0));
    let quarter = half * half;
    let soft = |k: usize| springs[k].stiffness > 0.0;
    for [x, v, a] in deflection.iter_mut() {
        // Contribution of the step's beginning to its end.
        (*x, *v, *a) = (*x + dt * *v + quarter * *a, *v + half * *a, zero);
    }
    bodies(deflection, load);
    for c in (0..n).filter(|&c| soft(c)) {
        deflection[c][2] = one;
        bodies(deflection, column);
        deflection[c][2] = zero;
        for r in 0..n {
            matrix[r * n + c] = load[r] - column[r];
        }
    }
    for k in (0..n).filter(|&k| soft(k)) {
        let (stiffness, inertia) = (S::constant(springs[k].stiffness), matrix[k * n + k]);
        let least = S::constant(2.0 * LEAST_DAMPING) * (stiffness * inertia.max(zero)).sqrt();
        let damping = S::constant(springs[k].damping).max(least);
        load[k] = load[k] - damping * deflection[k][1] - stiffness * deflection[k][0];
        matrix[k * n + k] = inertia + half * damping + quarter * stiffness;
    }
    // Gauss: the matrix is positive definite.
    for p in (0..n).filter(|&p| soft(p)) {
        for r in (p + 1..n).filter(|&r| soft(r)) {
            let share = matrix[r * n + p] / matrix[p * n + p];
            for c in (p..n).filter(|&c| soft(c)) {
                matrix[r * n + c] = matrix[r * n + c] - share * matrix[p * n + c];
            }
            load[r] = load[r] - share * load[p];
        }
    }
    for p in (0..n).rev().filter(|&p| soft(p)) {
        let mut sum = load[p];
        for c in (p + 1..n).filter(|&c| soft(c)) {
            sum = sum - matrix[p * n + c] * deflection[c][2];
        }
        deflection[p][2] = sum / matrix[p * n + p];
    }
    for [x, v, a] in deflection.iter_mut() {
        (*x, *v) = (*x + quarter * *a, *v + half * *a);
    }
}

/// Dynamic part of the torque at the sensors due to the swinging links, beside the quasi-static
/// deflection of the springs. `scratch` is of `2 n` numbers.
pub fn elastic_torque<S: Real>(
    springs: &[Spring],
    deflection: &[Deflection<S>],
    still: &mut [Deflection<S>],
    scratch: &mut [S],
    torques: &mut [S],
    bodies: &mut Bodies<'_, S>,
) {
    let (moving, resting) = scratch.split_at_mut(springs.len());
    // Once, as the static law has it.
    still.fill([S::default(); 3]);
    deflect(springs, still, resting, bodies);
    bodies(still, resting);
    bodies(deflection, moving);
    for ((torque, spring), (moving, resting)) in torques.iter_mut().zip(springs).zip(moving.iter().zip(resting.iter()))
    {
        *torque = *torque + S::constant(spring.gain) * (*moving - *resting);
    }
}
