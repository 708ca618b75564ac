//! Compares the written robot file with the offered model: both errors, in words and as JSON.

use serde_json::{Value, json};

use crate::diagnose::measured_on;
use crate::numerics::sums::root_mean_square;
use crate::report::parts::number::digits;

/// Largest relative difference of the errors: the file's laws are evaluated sample by sample, those
/// of the diagnosis interpolated linearly.
const ALIKE: f64 = 0.01;

/// Errors on the validating logs, per joint, N m.
#[derive(Debug, Clone, PartialEq)]
pub struct WrittenCheck {
    /// Errors of the written file, by its inverse dynamics; `None` if it has no links, or the
    /// torques are those of its gears alone.
    pub rms: Option<Vec<f64>>,
    /// Whether the torques are those of its gears alone.
    pub transmission: bool,
    /// Errors of the offered model.
    pub offered: Vec<f64>,
    /// Whether the validating data are separate logs.
    pub own_validation: bool,
}

impl WrittenCheck {
    /// Root mean square over joints, N m: of the file, of the offered model.
    fn figures(&self) -> Option<[f64; 2]> {
        self.rms.as_ref().map(|rms| [rms, &self.offered].map(|x| root_mean_square(x)))
    }

    /// Difference of the two relative to the larger; 0 where the file cannot be evaluated.
    fn difference(&self) -> f64 {
        self.figures().map_or(0.0, |[is, offered]| {
            let larger = if is.is_nan() { is } else { is.max(offered) };
            if larger == 0.0 { 0.0 } else { (is - offered) / larger }
        })
    }

    /// Error message if the file is not the offered model.
    pub fn refusal(&self, file: &str) -> Option<String> {
        let [is, offered] = self.figures()?;
        // NaN differs from any error.
        if self.difference().abs() <= ALIKE {
            return None;
        }
        let rms = self.rms.as_deref().unwrap_or_default();
        let joints: Vec<String> = (1..)
            .zip(rms.iter().zip(&self.offered))
            .filter(|(_, (a, b))| (*a - *b).abs() > ALIKE * a.max(**b))
            .map(|(j, (a, b))| format!("joint {j}: {} and {}", digits(*a, 3), digits(*b, 3)))
            .collect();
        Some(format!(
            "{file} is NOT the model that the diagnosis offers: its inverse dynamics misses {} by {} N m (RMS over joints), the offered model by {} N m; {}. A law that was found acts otherwise along the log's samples than in the diagnosis; trust the file's own figure, or diagnose with a higher --rate.",
            measured_on("validate", self.own_validation),
            digits(is, 3),
            digits(offered, 3),
            joints.join("; ")
        ))
    }
}

/// `"written"` of `diagnose --json`.
pub fn written_json(check: &WrittenCheck) -> Value {
    json!({
        "rms": { "validate": check.rms },
        "offered_rms": { "validate": check.offered },
        "difference_percent": check.rms.as_ref().map(|_| 100.0 * check.difference()),
        "is_the_offered_model": check.rms.as_ref().map(|_| check.difference().abs() <= ALIKE),
    })
}

/// A line for the terminal.
pub fn written_text(check: &WrittenCheck, file: &str) -> String {
    match check.figures() {
        Some([is, offered]) => format!(
            "wrote {file}; read back, its inverse dynamics misses {} by {} N m (RMS over joints), the offered model by {} N m\n",
            measured_on("validate", check.own_validation),
            digits(is, 3),
            digits(offered, 3)
        ),
        None if check.transmission => format!("wrote {file}, with what was found of its gears\n"),
        None => format!("wrote {file}; it has no links, so its inverse dynamics can't be evaluated\n"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_that_is_another_model_is_refused() {
        let check = |rms: [f64; 2]| WrittenCheck {
            rms: Some(rms.to_vec()),
            transmission: false,
            offered: vec![0.5, 0.2],
            own_validation: true,
        };
        assert_eq!(check([0.501, 0.2]).refusal("x.yaml"), None);
        let words = check([0.5, 0.4]).refusal("x.yaml").unwrap();
        assert!(words.contains("x.yaml is NOT the model") && words.contains("joint 2: 0.400 and 0.200"), "{words}");
        assert!(!words.contains("joint 1:"), "{words}");
        assert!(check([f64::NAN, 0.2]).refusal("x.yaml").is_some());
        let unknown = WrittenCheck { rms: None, transmission: true, offered: vec![0.5], own_validation: true };
        assert_eq!(unknown.refusal("x.yaml"), None);
        assert!(written_text(&unknown, "x.yaml").contains("of its gears"));
    }
}
