//! Drives that remember: friction that depends on the travel since the last reversal, and on time
//! and temperature; links that swing on the springs of their gears. Shipped verbatim into crates
//! whose robot file has effects; the interpreter uses the same text.

use super::elementary::Real;

/// What one joint's drive remembers by; a travel of 0 is no bristle, a time of 0 no drift.
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

/// Where a link stands behind its motor: angle, rad, its rate and its acceleration.
pub type Behind<S> = [S; 3];

/// Torques of the arm, N m, whose links stand so far behind their motors.
pub type Bodies<'a, S> = dyn FnMut(&[Behind<S>], &mut [S]) + 'a;

/// Least damping ratio of a link on its spring: with less, what the motion was long ago would
/// count.
pub const LEAST_DAMPING: f64 = 0.01;

/// Where the springs carry their links if nothing swings: the arm behind them hangs otherwise than
/// it was, so it is asked again until that is next to nothing. `bodies`: torques of the arm with
/// its links so far behind.
pub fn at_ease<S: Real>(springs: &[Spring], behind: &mut [Behind<S>], torques: &mut [S], bodies: &mut Bodies<'_, S>) {
    behind.fill([S::default(); 3]);
    for _ in 0..5 {
        wind(springs, behind, torques, bodies);
    }
}

/// Winds the springs by the torques of the arm as it is behind them.
fn wind<S: Real>(springs: &[Spring], behind: &mut [Behind<S>], torques: &mut [S], bodies: &mut Bodies<'_, S>) {
    bodies(behind, torques);
    for ((behind, spring), &torque) in behind.iter_mut().zip(springs).zip(torques.iter()) {
        if spring.stiffness > 0.0 {
            behind[0] = torque / S::constant(spring.stiffness);
        }
    }
}

/// The same one step later, `dt` s after [`at_ease`], and at the rate at which the springs are
/// wound meanwhile: from here links [`swing`]. `room` is of `2 n` numbers.
pub fn let_go<S: Real>(
    springs: &[Spring],
    dt: S,
    behind: &mut [Behind<S>],
    room: &mut [S],
    bodies: &mut Bodies<'_, S>,
) {
    let (torques, before) = room.split_at_mut(springs.len());
    before.iter_mut().zip(behind.iter()).for_each(|(before, behind)| *before = behind[0]);
    at_ease(springs, behind, torques, bodies);
    for (behind, &mut before) in behind.iter_mut().zip(before) {
        behind[1] = (behind[0] - before) / dt;
    }
}

/// The links go on by `dt`, s, by the trapezoidal rule: of each soft joint `KE d + DE d'` is the
/// torque of the arm whose links stand `d` behind their motors, linear in the accelerations.
/// `bodies` gives that torque; `room` is of `n (n + 2)` numbers.
pub fn swing<S: Real>(springs: &[Spring], dt: S, behind: &mut [Behind<S>], room: &mut [S], bodies: &mut Bodies<'_, S>) {
    let n = springs.len();
    let (matrix, rest) = room.split_at_mut(n * n);
    let (load, column) = rest.split_at_mut(n);
    let (half, zero, one) = (dt * S::constant(0.5), S::default(), S::constant(1.0));
    let quarter = half * half;
    let soft = |k: usize| springs[k].stiffness > 0.0;
    for [x, v, a] in behind.iter_mut() {
        // What the step's end has of its beginning.
        (*x, *v, *a) = (*x + dt * *v + quarter * *a, *v + half * *a, zero);
    }
    bodies(behind, load);
    for c in (0..n).filter(|&c| soft(c)) {
        behind[c][2] = one;
        bodies(behind, column);
        behind[c][2] = zero;
        for r in 0..n {
            matrix[r * n + c] = load[r] - column[r];
        }
    }
    for k in (0..n).filter(|&k| soft(k)) {
        let (stiffness, inertia) = (S::constant(springs[k].stiffness), matrix[k * n + k]);
        let least = S::constant(2.0 * LEAST_DAMPING) * (stiffness * inertia.max(zero)).sqrt();
        let damping = S::constant(springs[k].damping).max(least);
        load[k] = load[k] - damping * behind[k][1] - stiffness * behind[k][0];
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
            sum = sum - matrix[p * n + c] * behind[c][2];
        }
        behind[p][2] = sum / matrix[p * n + p];
    }
    for [x, v, a] in behind.iter_mut() {
        (*x, *v) = (*x + quarter * *a, *v + half * *a);
    }
}

/// What the links' swing adds to the torques at the sensors, beside the static winding of the
/// springs. `room` is of `2 n` numbers.
pub fn swung<S: Real>(
    springs: &[Spring],
    behind: &[Behind<S>],
    still: &mut [Behind<S>],
    room: &mut [S],
    torques: &mut [S],
    bodies: &mut Bodies<'_, S>,
) {
    let (moving, resting) = room.split_at_mut(springs.len());
    // Once, as the static law has it.
    still.fill([S::default(); 3]);
    wind(springs, still, resting, bodies);
    bodies(still, resting);
    bodies(behind, moving);
    for ((torque, spring), (moving, resting)) in torques.iter_mut().zip(springs).zip(moving.iter().zip(resting.iter()))
    {
        *torque = *torque + S::constant(spring.gain) * (*moving - *resting);
    }
}
