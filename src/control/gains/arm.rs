//! All joints' loops at once, away from the wall: what one joint's loop does to another's.

use nalgebra::DMatrix;

use super::sampled::{held, radius};

/// An arm in one posture under proportional-derivative control of its motors.
#[derive(Debug, Clone, PartialEq)]
pub struct ArmPlant {
    /// Time between samples, s.
    pub period: f64,
    /// Mass matrix of the links, `n x n`, kg m^2, with the rotors of rigid joints.
    pub mass: DMatrix<f64>,
    /// Rotors of soft joints, kg m^2, their springs, N m/rad (infinite: rigid, the rotor counts as
    /// a part of the link), and their damping, N m s/rad.
    pub drives: Vec<[f64; 3]>,
    /// Viscous friction, N m s/rad.
    pub viscous: Vec<f64>,
}

impl ArmPlant {
    /// Largest eigenvalue of the closed loop with these gains (`kp`, `kd` of each joint), `delay`
    /// periods until a torque acts.
    pub fn radius(&self, gains: &[[f64; 2]], delay: usize) -> f64 {
        let n = self.mass.nrows();
        let soft: Vec<usize> = (0..n).filter(|&j| self.drives[j][1].is_finite()).collect();
        let total = n + soft.len();
        let mut motor: Vec<usize> = (0..n).collect();
        soft.iter().enumerate().for_each(|(k, &j)| motor[j] = n + k);
        let mut mass = DMatrix::zeros(total, total);
        mass.view_mut((0, 0), (n, n)).copy_from(&self.mass);
        let (mut stiffness, mut damping) = (DMatrix::zeros(total, total), DMatrix::zeros(total, total));
        for j in 0..n {
            let ([rotor, spring, loss], m) = (self.drives[j], motor[j]);
            mass[(m, m)] += rotor;
            damping[(m, m)] += self.viscous[j];
            if m != j {
                for (r, c, sign) in [(j, j, 1.0), (m, m, 1.0), (j, m, -1.0), (m, j, -1.0)] {
                    stiffness[(r, c)] += sign * spring;
                    damping[(r, c)] += sign * loss;
                }
            }
        }
        let Some(inverse) = mass.cholesky().map(|c| c.inverse()) else { return f64::INFINITY };
        let states = 2 * total;
        let mut a = DMatrix::zeros(states, states);
        a.view_mut((0, total), (total, total)).fill_with_identity();
        a.view_mut((total, 0), (total, total)).copy_from(&(-&inverse * stiffness));
        a.view_mut((total, total), (total, total)).copy_from(&(-&inverse * damping));
        let mut b = DMatrix::zeros(states, n);
        (0..n).for_each(|j| b.view_mut((total, j), (total, 1)).copy_from(&inverse.column(motor[j])));
        let (ad, bd) = held(&a, &b, self.period);
        // States, motor positions before, torques on their way.
        let size = states + n + delay * n;
        let mut command = DMatrix::zeros(n, size);
        for (j, [kp, kd]) in gains.iter().enumerate() {
            command[(j, motor[j])] = -(kp + kd / self.period);
            command[(j, states + j)] = kd / self.period;
        }
        let mut whole = DMatrix::zeros(size, size);
        whole.view_mut((0, 0), (states, states)).copy_from(&ad);
        (0..n).for_each(|j| whole[(states + j, motor[j])] = 1.0);
        if delay == 0 {
            let mut top = whole.rows_mut(0, states);
            top += &bd * &command;
        } else {
            let first = states + n;
            whole.view_mut((0, first), (states, n)).copy_from(&bd);
            for step in 1..delay {
                whole.view_mut((first + (step - 1) * n, first + step * n), (n, n)).fill_with_identity();
            }
            whole.view_mut((first + (delay - 1) * n, 0), (n, size)).copy_from(&command);
        }
        radius(&whole)
    }

    /// How far it is from keeping its margins: below 1, it is stable with all gains doubled, and
    /// with a period more of delay.
    pub fn strain(&self, gains: &[[f64; 2]]) -> f64 {
        let doubled: Vec<[f64; 2]> = gains.iter().map(|g| g.map(|g| 2.0 * g)).collect();
        self.radius(&doubled, 0).max(self.radius(gains, 1))
    }
}

/// Lowers gains until all joints together keep their margins in these postures, each time those of
/// the joint whose lowering helps most.
pub fn lowered(plants: &[ArmPlant], mut gains: Vec<[f64; 2]>) -> Option<Vec<[f64; 2]>> {
    /// Of a step: damping; stiffness goes with its square, so that the damping ratio stays.
    const STEP: f64 = 0.8;
    let worst = |gains: &[[f64; 2]]| -> f64 { plants.iter().map(|p| p.strain(gains)).fold(0.0, f64::max) };
    let mut strain = worst(&gains);
    for _ in 0..60 {
        if strain < 1.0 - 1e-9 {
            return Some(gains);
        }
        let tries = (0..gains.len()).map(|j| {
            let mut tried = gains.clone();
            tried[j] = [tried[j][0] * STEP * STEP, tried[j][1] * STEP];
            (worst(&tried), tried)
        });
        (strain, gains) = tries.min_by(|a, b| a.0.total_cmp(&b.0))?;
    }
    None
}
