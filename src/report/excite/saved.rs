//! Motions as coefficients in a JSON file, written and read back.

use serde_json::{Value, json};

use crate::data::trajectory::{Fourier, Spline, Trajectory};
use crate::report::parts::fields::{FieldError, count, numbers, rows, rule};

/// The coefficients of a motion; [`trajectory_of_json`] gives the same motion.
///
/// ```
/// use denavit::data::trajectory::{Spline, Trajectory};
/// use denavit::report::{trajectory_json, trajectory_of_json};
///
/// let points = vec![0.0, 0.0, 0.0, 1.57, 3.14, 3.14, 3.14];
/// let motion = Trajectory::Spline(Spline::clamped(5, 2.0, 2, vec![points]).unwrap());
/// assert_eq!(trajectory_of_json(&trajectory_json(&motion)).unwrap(), motion);
/// ```
pub fn trajectory_json(motion: &Trajectory) -> Value {
    match motion {
        Trajectory::Spline(s) => json!({
            "kind": "spline", "degree": s.degree, "knots": s.knots, "coefficients": s.coefficients,
        }),
        Trajectory::Fourier(f) => json!({
            "kind": "fourier", "period": f.period, "periods": f.periods, "center": f.center, "sine": f.sine, "cosine": f.cosine,
        }),
    }
}

/// Reads the output of [`trajectory_json`], also under the key `trajectory`.
///
/// # Errors
/// The key that is missing or has the wrong shape.
pub fn trajectory_of_json(value: &Value) -> Result<Trajectory, FieldError> {
    let value = value.get("trajectory").unwrap_or(value);
    let of_joints =
        |key: &str| rows(value, key).ok_or_else(|| rule(key, "must be a list with one list of numbers per joint"));
    match value.get("kind").and_then(Value::as_str) {
        Some("spline") => {
            let spline = Spline::new(count(value, "degree")?, numbers(value, "knots")?, of_joints("coefficients")?)?;
            Ok(Trajectory::Spline(spline))
        }
        Some("fourier") => {
            let period = value.get("period").and_then(Value::as_f64).filter(|p| p.is_finite() && *p > 0.0);
            let period = period.ok_or_else(|| rule("period", "must be a positive number of seconds"))?;
            let (center, sine, cosine) = (numbers(value, "center")?, of_joints("sine")?, of_joints("cosine")?);
            Ok(Trajectory::Fourier(Fourier::new(period, count(value, "periods")?, center, sine, cosine)?))
        }
        Some(other) => Err(rule("kind", format!("is `{other}`; it must be spline or fourier"))),
        None => Err(rule("kind", "is missing; it must be spline or fourier")),
    }
}
