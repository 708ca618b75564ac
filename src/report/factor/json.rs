//! Rows of `denavit factor` as JSON, without their factors.

use serde_json::{Value, json};

use super::table::FactorRow;

/// One recording. `bytes` is the size of its factor.
pub fn factor_json(row: &FactorRow) -> Value {
    json!({
        "robot": row.robot,
        "day": row.day,
        "file": row.file,
        "sha256": row.sha256,
        "samples": row.samples,
        "seconds": row.seconds,
        "verdict": row.verdict,
        "temperature": row.temperature,
        "bytes": row.factor.as_ref().map(Vec::len),
        "why": row.why,
    })
}
