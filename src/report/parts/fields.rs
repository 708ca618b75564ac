//! Reads fields of JSON files that `denavit` has written.

use serde_json::Value;

use crate::apps::painting::SurfaceError;
use crate::data::trajectory::CoefficientError;

/// Reason why a JSON file is not one that `denavit` writes.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FieldError {
    /// A key is missing.
    #[error("`{0}` is missing")]
    Missing(String),
    /// A value violates a rule.
    #[error("`{key}` {rule}")]
    Rule {
        /// Key of the value.
        key: String,
        /// The violated rule: `must be a number`.
        rule: String,
    },
    /// The output of another command is needed, which has this key.
    #[error("no `{0}` as `denavit identify --json` writes it")]
    Absent(&'static str),
    /// The file belongs to another robot: a parameter that this robot lacks.
    #[error("the parameter {0} is not of this robot; take the JSON that was written with this robot file")]
    Parameter(String),
    /// Invalid coefficients of a motion.
    #[error(transparent)]
    Coefficients(#[from] CoefficientError),
    /// Invalid wall.
    #[error(transparent)]
    Surface(#[from] SurfaceError),
}

/// The error of a value that violates a rule.
pub(in crate::report) fn rule(key: &str, rule: impl Into<String>) -> FieldError {
    FieldError::Rule { key: key.into(), rule: rule.into() }
}

pub(in crate::report) fn field<'v>(value: &'v Value, key: &str) -> Result<&'v Value, FieldError> {
    value.get(key).ok_or_else(|| FieldError::Missing(key.into()))
}

/// A finite number.
pub(in crate::report) fn number(value: &Value, key: &str) -> Result<f64, FieldError> {
    let found = value.get(key).and_then(Value::as_f64).filter(|x| x.is_finite());
    found.ok_or_else(|| rule(key, "must be a number"))
}

/// A positive whole number.
pub(in crate::report) fn count(value: &Value, key: &str) -> Result<usize, FieldError> {
    let found = value.get(key).and_then(Value::as_u64).filter(|&n| n > 0 && n < 100_000);
    found.map(|n| n as usize).ok_or_else(|| rule(key, "must be a positive whole number"))
}

pub(in crate::report) fn text(value: &Value, key: &str) -> Result<String, FieldError> {
    value.get(key).and_then(Value::as_str).map(String::from).ok_or_else(|| rule(key, "must be a word"))
}

/// A list of finite numbers.
pub(in crate::report) fn list(value: &Value) -> Option<Vec<f64>> {
    value.as_array()?.iter().map(|x| x.as_f64().filter(|x| x.is_finite())).collect()
}

pub(in crate::report) fn numbers(value: &Value, key: &str) -> Result<Vec<f64>, FieldError> {
    value.get(key).and_then(list).ok_or_else(|| rule(key, "must be a list of numbers"))
}

pub(in crate::report) fn array<const N: usize>(value: &Value, key: &str) -> Result<[f64; N], FieldError> {
    let found = value.get(key).and_then(list).and_then(|v| v.try_into().ok());
    found.ok_or_else(|| rule(key, format!("must be {N} numbers")))
}

/// A list of lists of finite numbers.
pub(in crate::report) fn rows(value: &Value, key: &str) -> Option<Vec<Vec<f64>>> {
    value.get(key).and_then(Value::as_array)?.iter().map(list).collect()
}
