//! Tests with a valid log, and with one defect per test.

mod fingerprint;
mod formats;
mod measured;
mod quality_check;

use super::*;

/// Rows of two joints, 400 at 100 Hz, with a little noise.
fn good() -> Vec<Vec<String>> {
    let mut rows = vec![["t", "q1", "q2", "tau1", "tau2"].map(String::from).to_vec()];
    let mut state = 7_u64;
    let mut noise = || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 40) as f64 / (1u64 << 24) as f64 - 0.5
    };
    for k in 0..400 {
        let t = 0.01 * k as f64;
        let q = [(2.0 * t).sin(), 0.5 * (3.0 * t).cos()];
        let tau = q.map(|q| 10.0 * q + 0.1 * noise());
        rows.push(vec![
            format!("{t:.4}"),
            format!("{:.6}", q[0]),
            format!("{:.6}", q[1]),
            tau[0].to_string(),
            tau[1].to_string(),
        ]);
    }
    rows
}

fn text(rows: &[Vec<String>]) -> String {
    rows.iter().map(|row| row.join(",") + "\n").collect()
}

fn read(rows: &[Vec<String>], keep: Acceptance) -> Result<Log, LogError> {
    let text = text(rows);
    Log::read(open("log.csv", text.as_bytes())?.as_mut(), Quantity::Tau, keep)
}

/// Findings that stop the reading.
fn fatal(rows: &[Vec<String>]) -> Vec<Finding> {
    match read(rows, Acceptance::default()) {
        Err(LogError::Rejected { findings, .. }) => findings.into_iter().filter(Finding::is_fatal).collect(),
        other => panic!("not rejected: {other:?}"),
    }
}

/// The only finding that stops the reading, and the log read with that finding accepted.
fn only(rows: &[Vec<String>]) -> (Finding, Log) {
    let mut found = fatal(rows);
    assert_eq!(found.len(), 1, "{found:?}");
    let mut keep = Acceptance::default();
    assert!(keep.set(found[0].allowed_by().unwrap()));
    (found.remove(0), read(rows, keep).unwrap())
}
