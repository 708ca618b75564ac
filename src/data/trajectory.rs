//! Joint motions as functions of time: clamped B-splines and Fourier series, stored as coefficients
//! and evaluated at any time.
//!
//! ```
//! use denavit::data::trajectory::{Spline, Trajectory};
//!
//! // Half a turn in two seconds, at rest at both ends.
//! let points = vec![0.0, 0.0, 0.0, 1.57, 3.14, 3.14, 3.14];
//! let spline = Spline::clamped(5, 2.0, 2, vec![points]).unwrap();
//! let motion = Trajectory::Spline(spline);
//! let (start, end) = (motion.at(0.0), motion.at(2.0));
//! assert_eq!((start.q[0], start.dq[0], start.ddq[0]), (0.0, 0.0, 0.0));
//! assert!((end.q[0] - 3.14).abs() < 1e-12 && end.dq[0].abs() < 1e-12);
//! ```

mod error;
mod fourier;
mod spline;

pub use error::CoefficientError;
pub use fourier::{Fourier, harmonic};
pub use spline::{Spline, basis, clamped_knots};

use crate::model::States;

/// Motion of all joints.
#[derive(Debug, Clone, PartialEq)]
pub enum Trajectory {
    /// A clamped B-spline.
    Spline(Spline),
    /// A periodic Fourier series.
    Fourier(Fourier),
}

/// All joints at one instant: rad, rad/s, rad/s^2, rad/s^3 (m for a prismatic joint).
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Instant {
    /// Positions.
    pub q: Vec<f64>,
    /// Velocities.
    pub dq: Vec<f64>,
    /// Accelerations.
    pub ddq: Vec<f64>,
    /// Jerks.
    pub dddq: Vec<f64>,
}

impl Trajectory {
    /// Number of joints.
    pub fn dof(&self) -> usize {
        match self {
            Self::Spline(s) => s.coefficients.len(),
            Self::Fourier(f) => f.center.len(),
        }
    }

    /// Duration, s.
    pub fn duration(&self) -> f64 {
        match self {
            Self::Spline(s) => s.duration(),
            Self::Fourier(f) => f.period * f.periods as f64,
        }
    }

    /// State at time `t`, s; times outside `[0, duration]` are clamped to the nearer end.
    pub fn at(&self, t: f64) -> Instant {
        let clamped = t.clamp(0.0, self.duration());
        let derivative = |r: usize| match self {
            Self::Spline(s) => s.derivative(clamped, r),
            Self::Fourier(f) => f.derivative(clamped, r),
        };
        let q = derivative(0);
        if clamped != t {
            let rest = vec![0.0; q.len()];
            return Instant { q, dq: rest.clone(), ddq: rest.clone(), dddq: rest };
        }
        Instant { q, dq: derivative(1), ddq: derivative(2), dddq: derivative(3) }
    }

    /// Samples at `rate`, Hz, from 0 to the end: times, s, and states. The end is always included,
    /// even where it falls between two sample times.
    pub fn sampled(&self, rate: f64) -> (Vec<f64>, States) {
        let times = times(self.duration(), rate);
        let (n, len) = (self.dof(), times.len());
        let mut states = States::zeros(n, len);
        for (s, &t) in times.iter().enumerate() {
            let at = self.at(t);
            for j in 0..n {
                states.q[j * len + s] = at.q[j];
                states.dq[j * len + s] = at.dq[j];
                states.ddq[j * len + s] = at.ddq[j];
            }
        }
        (times, states)
    }
}

/// Sample times `0, 1/rate, 2/rate, ..`, s, up to and including `duration`.
pub fn times(duration: f64, rate: f64) -> Vec<f64> {
    let whole = (duration * rate + 1e-9).floor() as usize;
    let mut times: Vec<f64> = (0..=whole).map(|k| (k as f64 / rate).min(duration)).collect();
    if duration - times[whole] > 1e-9 {
        times.push(duration);
    }
    times
}
