//! J. R. Dormand and P. J. Prince, *A family of embedded Runge-Kutta formulae*, J. Comp. Appl.
//! Math. 6 (1980): orders 5 and 4, seven stages, the last of which is the first of the next step.

use super::Breakdown;
use super::Pace;
use super::System;
use super::norm;

const C: [f64; 7] = [0.0, 0.2, 0.3, 0.8, 8.0 / 9.0, 1.0, 1.0];
const A: [[f64; 6]; 7] = [
    [0.0; 6],
    [0.2, 0.0, 0.0, 0.0, 0.0, 0.0],
    [3.0 / 40.0, 9.0 / 40.0, 0.0, 0.0, 0.0, 0.0],
    [44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0, 0.0, 0.0, 0.0],
    [19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0, 0.0, 0.0],
    [9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0, 0.0],
    [35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0],
];
/// Weights of order 5 minus those of order 4.
const ERROR: [f64; 7] =
    [71.0 / 57600.0, 0.0, -71.0 / 16695.0, 71.0 / 1920.0, -17253.0 / 339200.0, 22.0 / 525.0, -1.0 / 40.0];

/// Work arrays.
#[derive(Debug, Clone, Default)]
pub(crate) struct DormandPrince {
    k: [Vec<f64>; 7],
    stage: Vec<f64>,
}

impl DormandPrince {
    /// Integrates from `t` to `end`.
    pub fn advance(
        &mut self,
        system: &mut dyn System,
        pace: &mut Pace,
        mut t: f64,
        end: f64,
        y: &mut [f64],
    ) -> Result<(), Breakdown> {
        for buffer in self.k.iter_mut().chain([&mut self.stage]) {
            buffer.resize(y.len(), 0.0);
        }
        let mut first = false;
        while t < end {
            let (h, last) = pace.step(t, end);
            if !first {
                system.rate(t, y, &mut self.k[0])?;
                first = true;
            }
            for i in 1..7 {
                for (e, stage) in self.stage.iter_mut().enumerate() {
                    *stage = y[e] + h * (0..i).map(|j| A[i][j] * self.k[j][e]).sum::<f64>();
                }
                system.rate(t + C[i] * h, &self.stage, &mut self.k[i])?;
            }
            let k = &self.k;
            let error = norm(system, pace.solver.tolerance, y, &self.stage, |e| {
                h * (0..7).map(|i| ERROR[i] * k[i][e]).sum::<f64>()
            });
            if pace.judge(t, h, error, 4.0)? {
                y.copy_from_slice(&self.stage);
                t = if last { end } else { t + h };
                self.k.swap(0, 6);
            }
        }
        Ok(())
    }
}
