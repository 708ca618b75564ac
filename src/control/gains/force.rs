//! Force loop: from force error to displacement to joints to force, in one posture, all joints at
//! once.

use nalgebra::{Complex, DMatrix, DVector};

use super::joint::largest;
use super::sampled::{Margins, held, radius, response, states, wanted};

/// Arm and wall in one posture.
#[derive(Debug, Clone, PartialEq)]
pub struct ForcePlant {
    /// Time between samples, s.
    pub period: f64,
    /// Mass matrix, `n x n`, kg m^2, with the rotors of rigid joints.
    pub mass: DMatrix<f64>,
    /// Per joint: inertia of a soft joint's rotor, kg m^2, stiffness of its spring, N m/rad, and
    /// its damping, N m s/rad. An infinite stiffness means a rigid joint, whose rotor counts as
    /// part of `mass`.
    pub drives: Vec<[f64; 3]>,
    /// Viscous friction of the joints, N m s/rad.
    pub viscous: DVector<f64>,
    /// Proportional gains of the joints, N m/rad.
    pub kp: DVector<f64>,
    /// Derivative gains of the joints, N m s/rad.
    pub kd: DVector<f64>,
    /// Velocity of the contact along the normal per joint velocity, `n . J`, m/rad.
    pub along: DVector<f64>,
    /// Joint motion per displacement, rad/m, as the inverse kinematics gives it.
    pub inverse: DVector<f64>,
    /// Contact stiffness of wall and roller, N/m.
    pub stiffness: f64,
    /// Contact damping of wall and roller, N s/m.
    pub damping: f64,
    /// Corner frequency of the three-pole filter on the force, Hz; infinite: no filter.
    pub corner: f64,
}

/// Response to a step of the desired force by 1 N.
#[derive(Debug, Clone, PartialEq)]
pub struct Step {
    /// Force at each period, N.
    pub force: Vec<f64>,
    /// Overshoot beyond 1 N, relative to 1 N.
    pub overshoot: f64,
    /// Time after which the force stays within 5 %, s.
    pub settled: f64,
}

/// Gains of the force loop with the resulting margins and step response.
#[derive(Debug, Clone, PartialEq)]
pub struct ForceProposal {
    /// Proportional gain, m/N.
    pub kp: f64,
    /// Integral gain, m/(N s).
    pub ki: f64,
    /// Worst margins over all postures.
    pub margins: Margins,
    /// Step response in the first posture.
    pub step: Step,
}

/// Sampled system from the displacement to the filtered force.
struct Inner {
    a: DMatrix<f64>,
    b: DVector<f64>,
    /// Output row of the filtered force.
    c: DVector<f64>,
    /// Output row of the unfiltered force.
    force: DVector<f64>,
    /// Index of each joint's motor among the states.
    motor: Vec<usize>,
}

impl ForcePlant {
    /// Builds the system with states `x, dx, previous motors, previous displacement, filter`; `x`
    /// are the links and then the motors of soft joints. Outputs are those of the same instant; the
    /// displacement acts until the next one.
    fn inner(&self) -> Option<Inner> {
        let n = self.mass.nrows();
        let mut motor: Vec<usize> = (0..n).collect();
        let mut total = n;
        for (m, [_, spring, _]) in motor.iter_mut().zip(&self.drives) {
            if spring.is_finite() {
                (*m, total) = (total, total + 1);
            }
        }
        let mut mass = DMatrix::zeros(total, total);
        mass.view_mut((0, 0), (n, n)).copy_from(&self.mass);
        let (mut stiffness, mut damping) = (DMatrix::zeros(total, total), DMatrix::zeros(total, total));
        let contact = &self.along * self.along.transpose();
        stiffness.view_mut((0, 0), (n, n)).copy_from(&(&contact * self.stiffness));
        damping.view_mut((0, 0), (n, n)).copy_from(&(&contact * self.damping));
        for (j, &m) in motor.iter().enumerate() {
            damping[(m, m)] += self.viscous[j];
            if m != j {
                let [rotor, spring, loss] = self.drives[j];
                mass[(m, m)] += rotor;
                for (r, c, sign) in [(j, j, 1.0), (m, m, 1.0), (j, m, -1.0), (m, j, -1.0)] {
                    stiffness[(r, c)] += sign * spring;
                    damping[(r, c)] += sign * loss;
                }
            }
        }
        let inverse_mass = mass.cholesky()?.inverse();
        let states = 2 * total;
        let mut a = DMatrix::zeros(states, states);
        a.view_mut((0, total), (total, total)).fill_with_identity();
        a.view_mut((total, 0), (total, total)).copy_from(&(-&inverse_mass * stiffness));
        a.view_mut((total, total), (total, total)).copy_from(&(-&inverse_mass * damping));
        let mut b = DMatrix::zeros(states, n);
        (0..n).for_each(|j| b.view_mut((total, j), (total, 1)).copy_from(&inverse_mass.column(motor[j])));
        let (ad, bd) = held(&a, &b, self.period);

        let filter = self.corner.is_finite();
        let poles = if filter { 3 } else { 0 };
        let (before, last, first) = (states, states + n, states + n + 1);
        let size = first + poles;
        let kd = &self.kd / self.period;
        // Torques: (Kp + Kd/T) (g s - q) - Kd/T (g s_before - q_before).
        let mut torque = DMatrix::zeros(n, size);
        for j in 0..n {
            torque[(j, motor[j])] = -(self.kp[j] + kd[j]);
            torque[(j, before + j)] = kd[j];
            torque[(j, last)] = -kd[j] * self.inverse[j];
        }
        let direct = DVector::from_fn(n, |j, _| (self.kp[j] + kd[j]) * self.inverse[j]);
        let mut whole = DMatrix::zeros(size, size);
        whole.view_mut((0, 0), (states, states)).copy_from(&ad);
        let driven = &bd * torque;
        (0..states).for_each(|i| (0..size).for_each(|k| whole[(i, k)] += driven[(i, k)]));
        (0..n).for_each(|j| whole[(before + j, motor[j])] = 1.0);
        let mut input = DVector::zeros(size);
        input.rows_mut(0, states).copy_from(&(&bd * direct));
        input[last] = 1.0;
        let mut force = DVector::zeros(size);
        for j in 0..n {
            force[j] = self.stiffness * self.along[j];
            force[total + j] = self.damping * self.along[j];
        }
        let mut c = force.clone();
        if filter {
            // x1 += s (f - x1), x2 += s (x1 - x2), x3 += s (x2 - x3), each with the updated value;
            // rows give the values after the sample.
            let turn = std::f64::consts::TAU * self.corner * self.period;
            let s = turn / (1.0 + turn);
            let mut from = force.clone();
            for k in 0..poles {
                let mut row = &from * s;
                row[first + k] += 1.0 - s;
                whole.row_mut(first + k).copy_from(&row.transpose());
                from = row;
            }
            c = from;
        }
        Some(Inner { a: whole, b: input, c, force, motor })
    }

    /// Closes the inner loop with proportional and integral gains: `s = kp e + i`, where `i` sums
    /// `ki T e`.
    fn closed(&self, inner: &Inner, kp: f64, ki: f64) -> (DMatrix<f64>, DVector<f64>) {
        let n = inner.a.nrows();
        let gain = kp + ki * self.period;
        let mut a = DMatrix::zeros(n + 1, n + 1);
        a.view_mut((0, 0), (n, n)).copy_from(&(&inner.a - &inner.b * inner.c.transpose() * gain));
        (0..n).for_each(|i| a[(i, n)] = inner.b[i]);
        (0..n).for_each(|k| a[(n, k)] = -ki * self.period * inner.c[k]);
        a[(n, n)] = 1.0;
        let mut b = DVector::zeros(n + 1);
        b.rows_mut(0, n).copy_from(&(&inner.b * gain));
        b[n] = ki * self.period;
        (a, b)
    }

    /// Margins with these gains; `None` if the mass matrix is singular.
    pub fn margins(&self, kp: f64, ki: f64) -> Option<Margins> {
        let inner = self.inner()?;
        let (closed, _) = self.closed(&inner, kp, ki);
        Some(Margins::of(self.period, radius(&closed), |z| {
            let sum = Complex::from(ki * self.period) * z / (z - 1.0);
            (sum + kp) * response(&inner.a, &inner.b, &inner.c, z)
        }))
    }

    /// Response of the filtered force, N/m, to a displacement added to the force loop's own, at
    /// these frequencies, rad/s. The loop is closed with these gains on the force estimated from
    /// the motors. Links oscillating behind the springs have inertial forces of their own, which
    /// the estimate attributes to the motors. `None` if the mass matrix is singular.
    pub fn response_to_displacement(&self, kp: f64, ki: f64, frequencies: &[f64]) -> Option<Vec<Complex<f64>>> {
        let inner = self.inner()?;
        // Torques to the force along the normal: `n J^+'` with equal joint weights, within that
        // direction.
        let per_torque = &self.along / self.along.norm_squared().max(1e-12);
        let lever = &self.mass * per_torque;
        let of = |w: &f64| {
            let z = Complex::from_polar(1.0, w * self.period);
            let states = states(&inner.a, &inner.b, z)?;
            let sum_of = |c: &DVector<f64>| c.iter().zip(states.iter()).map(|(c, x)| x * *c).sum::<Complex<f64>>();
            let (filtered, force) = (sum_of(&inner.c), sum_of(&inner.force));
            let behind: Complex<f64> =
                inner.motor.iter().enumerate().map(|(j, &m)| (states[j] - states[m]) * lever[j]).sum();
            let plant = filtered * (Complex::from(1.0) - behind * (w * w) / force);
            let sum = Complex::from(ki * self.period) * z / (z - 1.0);
            Some(plant / ((sum + kp) * plant + 1.0))
        };
        frequencies.iter().map(of).collect()
    }

    /// Response to a step of the desired force by 1 N, over `seconds`.
    pub fn step(&self, kp: f64, ki: f64, seconds: f64) -> Option<Step> {
        let inner = self.inner()?;
        let (a, b) = self.closed(&inner, kp, ki);
        let mut x = DVector::zeros(a.nrows());
        let mut force = Vec::new();
        for _ in 0..(seconds / self.period) as usize {
            force.push(inner.force.iter().zip(x.iter()).map(|(c, x)| c * x).sum());
            x = &a * &x + &b;
        }
        let overshoot = force.iter().fold(0.0_f64, |most: f64, f| most.max(f - 1.0));
        let outside = force.iter().rposition(|f: &f64| (f - 1.0).abs() > 0.05);
        let settled = outside.map_or(0.0, |k| (k + 1) as f64 * self.period);
        Some(Step { force, overshoot, settled })
    }
}

/// Proposes the fastest gains that keep the margins in all postures. For each of several ratios of
/// proportional to integral gain it takes the largest integral gain, and among these the one whose
/// step settles first.
pub fn propose_force(postures: &[ForcePlant]) -> Option<ForceProposal> {
    let worst = |kp: f64, ki: f64| {
        let mut all = postures.iter().map(|p| p.margins(kp, ki));
        let first = all.next()??;
        all.try_fold(first, |w, m| Some(w.worse(m?)))
    };
    let mut best: Option<ForceProposal> = None;
    for ratio in [0.0, 0.03, 0.1] {
        let ki = largest(1e-7, 1e3, |ki| worst(ratio * ki, ki).is_some_and(|m| wanted(&m)));
        let Some(ki) = ki else { continue };
        let (margins, step) = (worst(ratio * ki, ki)?, postures.first()?.step(ratio * ki, ki, 3.0)?);
        if best.as_ref().is_none_or(|b| step.settled < 0.9 * b.step.settled) {
            best = Some(ForceProposal { kp: ratio * ki, ki, margins, step });
        }
    }
    best
}
