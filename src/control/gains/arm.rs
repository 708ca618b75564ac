//! Stability of all joint loops together, away from the wall, including the coupling between
//! joints.

use nalgebra::DMatrix;

use super::sampled::{held, radius};

/// An arm in one posture under proportional-derivative control of its motors.
#[derive(Debug, Clone, PartialEq)]
pub struct ArmPlant {
    /// Time between samples, s.
    pub period: f64,
    /// Mass matrix of the links, `n x n`, kg m^2, with the rotors of rigid joints.
    pub mass: DMatrix<f64>,
    /// Per joint: inertia of a soft joint's rotor, kg m^2, stiffness of its spring, N m/rad, and
    /// its damping, N m s/rad. An infinite stiffness means a rigid joint, whose rotor counts as
    /// part of the link.
    pub drives: Vec<[f64; 3]>,
    /// Viscous friction of the joints, N m s/rad.
    pub viscous: Vec<f64>,
}

impl ArmPlant {
    /// Spectral radius of the closed loop with the gains `kp`, `kd` of each joint; a torque acts
    /// after `delay` periods.
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
        // States, previous motor positions, torques in transit.
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

    /// Spectral radius under perturbation: below 1, the loop is stable both with all gains doubled
    /// and with one more period of delay.
    pub fn strain(&self, gains: &[[f64; 2]]) -> f64 {
        let doubled: Vec<[f64; 2]> = gains.iter().map(|g| g.map(|g| 2.0 * g)).collect();
        self.radius(&doubled, 0).max(self.radius(gains, 1))
    }
}

/// Lowers gains until all joints together keep their margins in these postures. Each step lowers
/// the gains of the joint for which this helps most. `None` if no such gains are found.
pub fn lowered(plants: &[ArmPlant], mut gains: Vec<[f64; 2]>) -> Option<Vec<[f64; 2]>> {
    /// Factor of the derivative gain per step; the stiffness changes with its square, so that the
    /// damping ratio stays.
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
