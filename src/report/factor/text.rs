//! Report of `denavit factor` as text.

use super::table::FactorRow;
use crate::report::parts::number::figure;

/// One line per recording.
pub fn factor_text(row: &FactorRow) -> String {
    match (&row.factor, &row.why) {
        (Some(factor), _) => format!(
            "{}: {}, {} samples, {} s, {:.0} kB\n",
            row.file,
            row.verdict,
            row.samples,
            figure(row.seconds),
            factor.len() as f64 / 1e3
        ),
        (None, why) => format!("{}: no factor: {}\n", row.file, why.as_deref().unwrap_or("unknown")),
    }
}

/// Summary line.
pub fn factor_verdict(recordings: usize, without: usize, seconds: f64) -> String {
    let plural = if recordings == 1 { "" } else { "s" };
    let motion = figure(seconds);
    match without {
        0 => format!("{recordings} recording{plural}, {motion} s of motion\n"),
        _ => format!("{recordings} recording{plural}, {without} without a factor, {motion} s of motion\n"),
    }
}
