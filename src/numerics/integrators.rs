//! Adaptive integrators: [`rosenbrock`] for stiff systems, [`dormand_prince`] for others.

pub(crate) mod dormand_prince;
pub(crate) mod rosenbrock;

/// Settings of the integrator.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Solver {
    /// Integration method.
    pub method: Method,
    /// Relative tolerance per step. Absolute tolerances are a hundredth of it in rad, and equal to
    /// it in rad/s.
    pub tolerance: f64,
    /// Longest step, s.
    pub longest: f64,
}

/// Integration method.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// Rosenbrock where there is a loop, friction, elasticity, backlash or contact, else
    /// Dormand-Prince.
    Auto,
    /// ROS34PW2, order 3 with an error estimate of order 2, L-stable.
    Rosenbrock,
    /// Dormand-Prince pair of orders 5 and 4.
    DormandPrince,
}

impl Default for Solver {
    fn default() -> Self {
        Self { method: Method::Auto, tolerance: 1e-7, longest: 0.01 }
    }
}

/// Reason why the integration stopped.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum Breakdown {
    /// The mass matrix is not positive definite, which no bodies have.
    #[error(
        "at {time:.4} s the mass matrix is not positive definite at joint {joint}: the inertial parameters are not those of possible bodies; give the robot file (and what is added to its links) bodies that can be, or the joint a rotor inertia"
    )]
    Mass {
        /// Index of the coordinate, from 1.
        joint: usize,
        /// Time, s.
        time: f64,
    },
    /// Steps became too short.
    #[error(
        "at {time:.4} s the integration gets stuck at steps of {step:.1e} s: the motion is unstable, or something in it far too stiff or too fast; look at the gains and the sizes of the effects"
    )]
    Step {
        /// Time, s.
        time: f64,
        /// Length of the step, s.
        step: f64,
    },
}

/// `x'' = a(t, x, x', z)`, `z' = r(t, x, x', z)`; `y = [x, x', z]`.
pub(crate) trait System {
    /// Number of coordinates `x`.
    fn coordinates(&self) -> usize;
    /// Evaluates `dy = [x', a, r]`.
    fn rate(&mut self, t: f64, y: &[f64], dy: &mut [f64]) -> Result<(), Breakdown>;
    /// Evaluates mass matrix and stiff terms at a state, and its rate.
    fn linearise(&mut self, t: f64, y: &[f64], linear: &mut Linear, dy: &mut [f64]) -> Result<(), Breakdown>;
}

/// Stiff part of a system: `M a = -K x - D x' - sum_b along_b c_b z_b + (other terms)`, `z_b' = a_b
/// v_b + b_b z_b + ..`, `v_b = along_b . x'`.
#[derive(Debug, Clone, Default)]
pub(crate) struct Linear {
    /// `N x N`, row-major.
    pub mass: Vec<f64>,
    pub stiffness: Vec<f64>,
    pub damping: Vec<f64>,
    pub bristles: Vec<LinearBristle>,
}

/// A bristle among the stiff terms.
#[derive(Debug, Clone, Copy)]
pub(crate) struct LinearBristle {
    /// Coordinates and factors of its direction.
    pub along: [(usize, f64); 2],
    pub c: f64,
    pub a: f64,
    pub b: f64,
}

/// Step-size controller.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Pace {
    pub next: f64,
    pub solver: Solver,
    pub steps: usize,
    pub rejected: usize,
    /// Time of the first step, s.
    begun: Option<f64>,
}

/// Number of steps allowed in total, beyond one per microsecond: an integration with shorter steps
/// would practically never end. Shortest step, s.
const MOST: usize = 200_000;
const SHORTEST: f64 = 1e-12;

impl Pace {
    pub fn new(solver: Solver) -> Self {
        Self { next: 1e-4_f64.min(solver.longest), solver, steps: 0, rejected: 0, begun: None }
    }

    /// Length of the step from `t` that reaches or approaches `end`, and whether it reaches it.
    pub fn step(&self, t: f64, end: f64) -> (f64, bool) {
        let h = self.next.min(self.solver.longest);
        let left = end - t;
        if h >= left * (1.0 - 1e-9) {
            (left, true)
        } else if 2.0 * h > left {
            (0.5 * left, false)
        } else {
            (h, false)
        }
    }

    /// Accepts or rejects a step of length `h`, and sets the next length. `error` is relative to
    /// the tolerance; `order` is that of the method's error estimate.
    pub fn judge(&mut self, t: f64, h: f64, error: f64, order: f64) -> Result<bool, Breakdown> {
        let good = error <= 1.0;
        let begun = *self.begun.get_or_insert(t);
        if (self.steps + self.rejected) as f64 > MOST as f64 + 1e6 * (t - begun) {
            return Err(Breakdown::Step { time: t, step: h });
        }
        let factor =
            if error.is_nan() { 0.2 } else { (0.9 * libm::pow(error.max(1e-8), -1.0 / (order + 1.0))).clamp(0.2, 4.0) };
        if good {
            self.steps += 1;
            // A step that was shortened to meet a sample does not reduce the planned longer one.
            self.next = (h * factor).max(if h < self.next && factor >= 1.0 { self.next } else { 0.0 });
        } else {
            self.rejected += 1;
            self.next = h * factor.min(0.9);
            if self.next < SHORTEST {
                return Err(Breakdown::Step { time: t, step: self.next });
            }
        }
        self.next = self.next.min(self.solver.longest);
        Ok(good)
    }
}

/// Root mean square of the error, each entry relative to its tolerance.
pub(crate) fn norm(system: &dyn System, tolerance: f64, y: &[f64], new: &[f64], error: impl Fn(usize) -> f64) -> f64 {
    let n = system.coordinates();
    let sum: f64 = (0..y.len())
        .map(|i| {
            let absolute = match i / n.max(1) {
                0 => 1e-2 * tolerance,
                1 => tolerance,
                _ => 1e3 * tolerance, // a bristle: a thousandth of the friction
            };
            let allowed = absolute + tolerance * y[i].abs().max(new[i].abs());
            let ratio = error(i) / allowed;
            ratio * ratio
        })
        .sum();
    (sum / y.len().max(1) as f64).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An error above the tolerance rejects and shortens the step; one below it is accepted.
    #[test]
    fn a_step_is_kept_up_to_its_allowed_error() {
        for (error, kept) in [(0.99, true), (1.01, false), (30.0, false), (f64::NAN, false)] {
            let mut pace = Pace::new(Solver::default());
            assert_eq!(pace.judge(0.0, 1e-3, error, 2.0).unwrap(), kept, "{error}");
            assert_eq!([pace.steps, pace.rejected], [usize::from(kept), usize::from(!kept)]);
            assert!(pace.next < 1e-3, "{error}: {}", pace.next);
        }
        // An error of order 3 grows with the cube of the step; the target is 0.9 of the longest.
        let mut pace = Pace::new(Solver::default());
        pace.judge(0.0, 1e-3, 0.125, 2.0).unwrap();
        assert!((pace.next - 1.8e-3).abs() < 1e-12, "{}", pace.next);
    }
}
