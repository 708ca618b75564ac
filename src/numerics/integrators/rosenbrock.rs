//! ROS34PW2: J. Rang and L. Angermann, *New Rosenbrock W-methods of order 3 for partial
//! differential algebraic equations of index 1*, BIT 45 (2005). Four stages, order 3 with an
//! embedded order 2, stiffly accurate and L-stable. As a W-method it keeps its order with any
//! Jacobian. The Jacobian used here therefore contains only stiff terms (springs, contacts,
//! bristles, gains), and the linear systems have the size of the mass matrix.

use super::Breakdown;
use super::Linear;
use super::LinearBristle;
use super::Pace;
use super::System;
use super::norm;
use crate::numerics::cholesky;

const GAMMA: f64 = 4.358_665_215_084_59e-1;
const ALPHA: [[f64; 3]; 4] = [
    [0.0, 0.0, 0.0],
    [8.717_330_430_169_18e-1, 0.0, 0.0],
    [8.445_706_001_536_942e-1, -1.129_906_423_648_418_5e-1, 0.0],
    [0.0, 0.0, 1.0],
];
const GAMMAS: [[f64; 3]; 4] = [
    [0.0, 0.0, 0.0],
    [-8.717_330_430_169_18e-1, 0.0, 0.0],
    [-9.033_805_701_304_408e-1, 5.418_067_238_809_533e-2, 0.0],
    [2.421_238_070_609_535e-1, -1.223_250_583_904_514_7, 5.452_602_553_351_021e-1],
];
const B: [f64; 4] =
    [2.421_238_070_609_535e-1, -1.223_250_583_904_514_7, 1.545_260_255_335_102, 4.358_665_215_084_59e-1];
const B_LOW: [f64; 4] = [3.781_090_314_581_937e-1, -9.604_229_221_242_318e-2, 0.5, 2.179_332_607_542_295e-1];

/// Work arrays.
#[derive(Debug, Clone, Default)]
pub(crate) struct Rosenbrock {
    k: [Vec<f64>; 4],
    stage: Vec<f64>,
    rate: Vec<f64>,
    /// Rate at the beginning of the step.
    first: Vec<f64>,
    sum: Vec<f64>,
    new: Vec<f64>,
    linear: Linear,
    matrix: Vec<f64>,
    right: Vec<f64>,
}

impl Rosenbrock {
    /// Integrates from `t` to `end`.
    pub fn advance(
        &mut self,
        system: &mut dyn System,
        pace: &mut Pace,
        mut t: f64,
        end: f64,
        y: &mut [f64],
    ) -> Result<(), Breakdown> {
        let len = y.len();
        for buffer in
            self.k.iter_mut().chain([&mut self.stage, &mut self.rate, &mut self.first, &mut self.sum, &mut self.new])
        {
            buffer.resize(len, 0.0);
        }
        let mut fresh = true;
        while t < end {
            let (h, last) = pace.step(t, end);
            if fresh {
                system.linearise(t, y, &mut self.linear, &mut self.first)?;
            }
            let error = self.step(system, t, h, y, pace.solver.tolerance)?;
            fresh = pace.judge(t, h, error, 2.0)?;
            if fresh {
                y.copy_from_slice(&self.new);
                t = if last { end } else { t + h };
            }
        }
        Ok(())
    }

    /// One step of length `h`, result in `self.new`; returns its error relative to the tolerance.
    fn step(&mut self, system: &mut dyn System, t: f64, h: f64, y: &[f64], tolerance: f64) -> Result<f64, Breakdown> {
        let n = system.coordinates();
        let hg = h * GAMMA;
        // M + h g D + (h g)^2 (K + sum along c a / (1 - h g b) along')
        self.matrix.clear();
        self.matrix.extend(
            (0..n * n).map(|i| self.linear.mass[i] + hg * self.linear.damping[i] + hg * hg * self.linear.stiffness[i]),
        );
        for &LinearBristle { along, c, a, b } in &self.linear.bristles {
            let weight = hg * hg * c * a / (1.0 - hg * b);
            for (i, fi) in along {
                for (k, fk) in along {
                    self.matrix[i * n + k] += weight * fi * fk;
                }
            }
        }
        // The mass matrix is positive definite: the stiff terms added to it are too large.
        cholesky::factor(n, &mut self.matrix).map_err(|_| Breakdown::Step { time: t, step: h })?;
        for i in 0..4 {
            self.stage.copy_from_slice(y);
            self.sum.fill(0.0);
            let mut at = t;
            for j in 0..i {
                at += h * ALPHA[i][j];
                for e in 0..y.len() {
                    self.stage[e] += ALPHA[i][j] * self.k[j][e];
                    self.sum[e] += GAMMAS[i][j] * self.k[j][e];
                }
            }
            if i == 0 {
                self.rate.copy_from_slice(&self.first);
            } else {
                system.rate(at, &self.stage, &mut self.rate)?;
            }
            self.solve(n, h, i);
        }
        for e in 0..y.len() {
            self.new[e] = y[e] + (0..4).map(|i| B[i] * self.k[i][e]).sum::<f64>();
        }
        let k = &self.k;
        Ok(norm(system, tolerance, y, &self.new, |e| (0..4).map(|i| (B[i] - B_LOW[i]) * k[i][e]).sum()))
    }

    /// Solves `(I - h g J) k_i = h f + h J s` for `k_i`, eliminating positions and bristles.
    fn solve(&mut self, n: usize, h: f64, i: usize) {
        let hg = h * GAMMA;
        let (f, s) = (&self.rate, &self.sum);
        let Linear { mass, stiffness, damping, bristles } = &self.linear;
        self.right.clear();
        for r in 0..n {
            let mut value = 0.0;
            for c in 0..n {
                let e = r * n + c;
                // Positions: k_q = h (f_q + s_v) + h g k_v.
                value += h * mass[e] * f[n + c]
                    - h * (stiffness[e] * (s[c] + hg * (f[c] + s[n + c])) + damping[e] * s[n + c]);
            }
            self.right.push(value);
        }
        for (b, &LinearBristle { along, c, a: rate_v, b: rate_z }) in bristles.iter().enumerate() {
            let z = 2 * n + b;
            let s_v: f64 = along.iter().map(|&(k, factor)| factor * s[n + k]).sum();
            let known = h * (f[z] + rate_v * s_v + rate_z * s[z]) / (1.0 - hg * rate_z);
            for (k, factor) in along {
                self.right[k] -= factor * c * (h * s[z] + hg * known);
            }
        }
        cholesky::solve(n, &self.matrix, &mut self.right);
        let k = &mut self.k[i];
        for c in 0..n {
            k[n + c] = self.right[c];
            k[c] = h * (f[c] + s[n + c]) + hg * self.right[c];
        }
        for (b, &LinearBristle { along, a: rate_v, b: rate_z, .. }) in bristles.iter().enumerate() {
            let z = 2 * n + b;
            let s_v: f64 = along.iter().map(|&(k, factor)| factor * s[n + k]).sum();
            let k_v: f64 = along.iter().map(|&(c, factor)| factor * self.right[c]).sum();
            k[z] = (h * (f[z] + rate_v * s_v + rate_z * s[z]) + hg * rate_v * k_v) / (1.0 - hg * rate_z);
        }
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{Matrix3, Vector3};

    use super::*;
    use crate::numerics::integrators::Solver;

    /// A mass on a spring, a damper and a bristle: `m x'' = -k x - d x' - c z`, `z' = a x' + b z`.
    struct Bristled;

    const MASS: f64 = 2.0;
    const SPRING: f64 = 300.0;
    const DAMPER: f64 = 5.0;
    const BRISTLE: LinearBristle = LinearBristle { along: [(0, 1.0), (0, 0.0)], c: 40.0, a: 500.0, b: -700.0 };

    fn jacobian() -> Matrix3<f64> {
        let LinearBristle { c, a, b, .. } = BRISTLE;
        Matrix3::new(0.0, 1.0, 0.0, -SPRING / MASS, -DAMPER / MASS, -c / MASS, 0.0, a, b)
    }

    impl System for Bristled {
        fn coordinates(&self) -> usize {
            1
        }

        fn rate(&mut self, _: f64, y: &[f64], dy: &mut [f64]) -> Result<(), Breakdown> {
            dy.copy_from_slice((jacobian() * Vector3::from_column_slice(y)).as_slice());
            Ok(())
        }

        fn linearise(&mut self, t: f64, y: &[f64], linear: &mut Linear, dy: &mut [f64]) -> Result<(), Breakdown> {
            *linear =
                Linear { mass: vec![MASS], stiffness: vec![SPRING], damping: vec![DAMPER], bristles: vec![BRISTLE] };
            self.rate(t, y, dy)
        }
    }

    /// Eliminating positions and bristles gives the same step as the whole matrix, `(I - h g J) k_i
    /// = h f + h J s`.
    #[test]
    fn elimination_is_the_whole_system() {
        for h in [1e-4, 3e-3, 0.1] {
            let mut method = Rosenbrock::default();
            let y = [0.3, -0.7, 0.2];
            for buffer in method.k.iter_mut().chain([
                &mut method.stage,
                &mut method.rate,
                &mut method.first,
                &mut method.sum,
                &mut method.new,
            ]) {
                buffer.resize(3, 0.0);
            }
            let tolerance = Solver::default().tolerance;
            Bristled.linearise(0.0, &y, &mut method.linear, &mut method.first).unwrap();
            method.step(&mut Bristled, 0.0, h, &y, tolerance).unwrap();
            let (j, start) = (jacobian(), Vector3::from(y));
            let matrix = (Matrix3::identity() - h * GAMMA * j).lu();
            let mut k: Vec<Vector3<f64>> = Vec::new();
            for i in 0..4 {
                let sum = |of: &[f64; 3]| k.iter().zip(of).map(|(k, by)| k * *by).sum::<Vector3<f64>>();
                let right = h * j * (start + sum(&ALPHA[i])) + h * j * sum(&GAMMAS[i]);
                let next = matrix.solve(&right).unwrap();
                k.push(next);
            }
            let end = start + k.iter().zip(B).map(|(k, b)| k * b).sum::<Vector3<f64>>();
            for e in 0..3 {
                assert!((method.new[e] - end[e]).abs() < 1e-12 * (1.0 + end.amax()), "{h} {e}: {:?} {end}", method.new);
            }
        }
    }
}
