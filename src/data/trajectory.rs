//! Joint motions as functions of time: clamped B-splines and Fourier series, evaluated anywhere,
//! kept as coefficients.
//!
//! ```
//! use denavit::data::trajectory::{Spline, Trajectory};
//!
//! // Half a turn in two seconds, at rest at both ends.
//! let spline = Spline::clamped(5, 2.0, 2, vec![vec![0.0, 0.0, 0.0, 1.57, 3.14, 3.14, 3.14]]).unwrap();
//! let motion = Trajectory::Spline(spline);
//! let (start, end) = (motion.at(0.0), motion.at(2.0));
//! assert_eq!((start.q[0], start.dq[0], start.ddq[0]), (0.0, 0.0, 0.0));
//! assert!((end.q[0] - 3.14).abs() < 1e-12 && end.dq[0].abs() < 1e-12);
//! let same = Trajectory::from_json(&motion.to_json()).unwrap();
//! assert_eq!(motion, same);
//! ```

mod fourier;
mod spline;

pub use fourier::{Fourier, harmonic};
pub use spline::{Spline, basis, clamped_knots};

use serde_json::{Value, json};

use crate::model::States;

/// A motion of all joints.
#[derive(Debug, Clone, PartialEq)]
pub enum Trajectory {
    /// A clamped B-spline.
    Spline(Spline),
    /// Periods of a Fourier series.
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

    /// Length, s.
    pub fn duration(&self) -> f64 {
        match self {
            Self::Spline(s) => s.duration(),
            Self::Fourier(f) => f.period * f.periods as f64,
        }
    }

    /// The motion at `t` seconds; before the start and after the end it rests there.
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

    /// Times from 0 to the end, `rate` per second (the end included, also where it falls between),
    /// and the states there.
    pub fn sampled(&self, rate: f64) -> (Vec<f64>, States) {
        let times = times(self.duration(), rate);
        let (n, len) = (self.dof(), times.len());
        let mut states = States { len, q: vec![0.0; n * len], dq: vec![0.0; n * len], ddq: vec![0.0; n * len] };
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

    /// Everything that it takes to have the same motion again.
    pub fn to_json(&self) -> Value {
        match self {
            Self::Spline(s) => json!({
                "kind": "spline", "degree": s.degree, "knots": s.knots, "coefficients": s.coefficients,
            }),
            Self::Fourier(f) => json!({
                "kind": "fourier", "period": f.period, "periods": f.periods, "center": f.center, "sine": f.sine, "cosine": f.cosine,
            }),
        }
    }

    /// Reads what [`Trajectory::to_json`] wrote, also where it stands under the key `trajectory`.
    ///
    /// # Errors
    /// Says which key is missing or has the wrong shape.
    pub fn from_json(value: &Value) -> Result<Self, String> {
        let value = value.get("trajectory").unwrap_or(value);
        match value.get("kind").and_then(Value::as_str) {
            Some("spline") => {
                let degree = count(value, "degree")?;
                Spline::new(degree, numbers(value, "knots")?, rows(value, "coefficients")?).map(Self::Spline)
            }
            Some("fourier") => {
                let period = value.get("period").and_then(Value::as_f64).filter(|p| p.is_finite() && *p > 0.0);
                let period = period.ok_or("`period` must be a positive number of seconds")?;
                let (sine, cosine) = (rows(value, "sine")?, rows(value, "cosine")?);
                Fourier::new(period, count(value, "periods")?, numbers(value, "center")?, sine, cosine)
                    .map(Self::Fourier)
            }
            Some(other) => Err(format!("`kind` is `{other}`; it must be spline or fourier")),
            None => Err("`kind` is missing; it must be spline or fourier".into()),
        }
    }
}

/// `0, 1/rate, 2/rate, ..` up to and with `duration`.
pub fn times(duration: f64, rate: f64) -> Vec<f64> {
    let whole = (duration * rate + 1e-9).floor() as usize;
    let mut times: Vec<f64> = (0..=whole).map(|k| (k as f64 / rate).min(duration)).collect();
    if duration - times[whole] > 1e-9 {
        times.push(duration);
    }
    times
}

fn count(value: &Value, key: &str) -> Result<usize, String> {
    let found = value.get(key).and_then(Value::as_u64).filter(|&n| n > 0 && n < 100_000);
    found.map(|n| n as usize).ok_or_else(|| format!("`{key}` must be a positive whole number"))
}

fn list(value: &Value) -> Option<Vec<f64>> {
    value.as_array()?.iter().map(|x| x.as_f64().filter(|x| x.is_finite())).collect()
}

fn numbers(value: &Value, key: &str) -> Result<Vec<f64>, String> {
    value.get(key).and_then(list).ok_or_else(|| format!("`{key}` must be a list of numbers"))
}

fn rows(value: &Value, key: &str) -> Result<Vec<Vec<f64>>, String> {
    let rows = value.get(key).and_then(Value::as_array).and_then(|rows| rows.iter().map(list).collect());
    rows.ok_or_else(|| format!("`{key}` must be a list with one list of numbers per joint"))
}
