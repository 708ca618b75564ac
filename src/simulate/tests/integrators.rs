//! Both methods have the order of their papers, the Rosenbrock method with any Jacobian.

use crate::numerics::integrators::dormand_prince::DormandPrince;
use crate::numerics::integrators::rosenbrock::Rosenbrock;
use crate::numerics::integrators::{Breakdown, Linear, LinearBristle, Method, Pace, Solver, System};

/// A forced and damped pendulum with a bristle; `share` is the share of the Jacobian that it
/// returns.
struct Pendulum {
    share: f64,
}

impl System for Pendulum {
    fn coordinates(&self) -> usize {
        1
    }

    fn rate(&mut self, t: f64, y: &[f64], dy: &mut [f64]) -> Result<(), Breakdown> {
        dy[0] = y[1];
        dy[1] = (-4.0 * y[0].sin() - 0.3 * y[1] - 0.7 * y[2] + (1.3 * t).cos()) / 2.0;
        dy[2] = (y[1] - (0.1 + y[1] * y[1]).sqrt() * y[2]) / 0.5;
        Ok(())
    }

    fn linearise(&mut self, t: f64, y: &[f64], linear: &mut Linear, dy: &mut [f64]) -> Result<(), Breakdown> {
        self.rate(t, y, dy)?;
        linear.mass = vec![2.0];
        linear.stiffness = vec![self.share * 4.0 * y[0].cos()];
        linear.damping = vec![self.share * 0.3];
        let (a, b) = (self.share * 2.0, -self.share * 2.0 * (0.1 + y[1] * y[1]).sqrt());
        linear.bristles = vec![LinearBristle { along: [(0, 1.0), (0, 0.0)], c: self.share * 0.7, a, b }];
        Ok(())
    }
}

fn end(method: Method, share: f64, step: f64) -> [f64; 3] {
    let mut y = [0.4, 1.0, 0.1];
    let mut pace = Pace::new(Solver { method, tolerance: 1e12, longest: step });
    pace.next = step;
    let mut system = Pendulum { share };
    match method {
        Method::DormandPrince => DormandPrince::default().advance(&mut system, &mut pace, 0.0, 4.0, &mut y).unwrap(),
        _ => Rosenbrock::default().advance(&mut system, &mut pace, 0.0, 4.0, &mut y).unwrap(),
    }
    y
}

#[test]
fn orders_are_as_published() {
    let exact = end(Method::DormandPrince, 0.0, 1e-3);
    let error = |method, share, step| {
        let y = end(method, share, step);
        (0..3).map(|i| (y[i] - exact[i]).abs()).fold(0.0, f64::max)
    };
    for (method, share, order) in [
        (Method::DormandPrince, 0.0, 5.0),
        (Method::Rosenbrock, 1.0, 3.0),
        (Method::Rosenbrock, 0.6, 3.0),
        (Method::Rosenbrock, 0.0, 3.0),
    ] {
        let (coarse, fine) = (error(method, share, 0.05), error(method, share, 0.025));
        let found = (coarse / fine).log2();
        assert!(
            found > order - 0.35,
            "{method:?}, {share} of the Jacobian: order {found:.2}, errors {coarse:.1e} {fine:.1e}"
        );
    }
}
