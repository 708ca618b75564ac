//! Tests with one defect each.

use super::*;

#[test]
fn in_order() {
    let log = read(&good(), Acceptance::default()).unwrap();
    assert_eq!((log.len(), log.starts.as_slice()), (400, &[0][..]));
    assert!(log.findings.is_empty(), "{:?}", log.findings);
}

#[test]
fn empty_cell() {
    let mut rows = good();
    rows[100][2].clear();
    let (finding, log) = only(&rows);
    assert_eq!(
        finding.to_string(),
        "line 101: column `q2`: an empty cell, NaN or infinity (mend the cell or leave the row out, or allow it: --keep bad-rows)"
    );
    assert_eq!((log.len(), log.starts.as_slice()), (399, &[0, 99][..]));
}

#[test]
fn nan_cell() {
    let mut rows = good();
    rows[100][4] = "NaN".into();
    let (finding, _) = only(&rows);
    assert_eq!((finding.kind, finding.line, finding.column.as_deref()), (Kind::NotFinite, Some(101), Some("tau2")));
}

#[test]
fn text_in_a_number() {
    let mut rows = good();
    rows[7][1] = "0,5".replace(',', "_");
    let finding = &fatal(&rows)[0];
    assert_eq!((finding.line, finding.column.as_deref()), (Some(8), Some("q1")));
    assert_eq!(finding.kind, Kind::NotANumber { text: "0_5".into() });
}

#[test]
fn short_row() {
    let mut rows = good();
    rows[400].truncate(3);
    let found = fatal(&rows);
    assert_eq!(found[0].line, Some(401));
    assert!(
        matches!(&found[0].kind, Kind::RowLength { text } if text == "3 cells where the header has 5"),
        "{found:?}"
    );
}

#[test]
fn time_runs_back() {
    let mut rows = good();
    for row in &mut rows[201..] {
        row[0] = format!("{:.4}", row[0].parse::<f64>().unwrap() - 2.0);
    }
    let (finding, log) = only(&rows);
    assert_eq!((finding.kind, finding.line), (Kind::TimeRunsBack { from: 1.99, to: 0.0 }, Some(202)));
    assert_eq!(log.starts, [0, 200]);
}

#[test]
fn a_new_recording_may_restart_its_clock() {
    let mut rows = good();
    rows[0].push("seg".into());
    for (i, row) in rows.iter_mut().enumerate().skip(1) {
        row.push(if i <= 200 { "1" } else { "2" }.into());
        if i > 200 {
            row[0] = format!("{:.4}", row[0].parse::<f64>().unwrap() - 2.0);
        }
    }
    let log = read(&rows, Acceptance::default()).unwrap();
    assert_eq!(log.starts, [0, 200]);
    assert!(log.findings.is_empty(), "{:?}", log.findings);
}

#[test]
fn double_time() {
    let mut rows = good();
    rows[11][0] = rows[10][0].clone();
    let (finding, log) = only(&rows);
    assert_eq!((finding.kind, finding.line), (Kind::DuplicateTime { at: 0.09 }, Some(12)));
    assert_eq!(log.len(), 399);
}

#[test]
fn gap() {
    let mut rows = good();
    rows.drain(101..151);
    let (finding, log) = only(&rows);
    assert!(matches!(finding.kind, Kind::Gap { longest, .. } if (longest - 0.51).abs() < 1e-9), "{finding:?}");
    assert_eq!((finding.line, log.starts.as_slice()), (Some(102), &[0, 100][..]));
}

#[test]
fn one_missing_sample_is_no_gap() {
    let mut rows = good();
    rows.remove(100);
    let log = read(&rows, Acceptance::default()).unwrap();
    assert!(matches!(log.findings[..], [Finding { kind: Kind::Jitter { .. }, severity: Severity::Note, .. }]));
}

#[test]
fn jitter_is_noted() {
    let mut rows = good();
    for (k, row) in rows.iter_mut().enumerate().skip(1) {
        row[0] = format!("{:.6}", 0.01 * (k as f64 + 0.3 * (5.0 * k as f64).sin()));
    }
    let log = read(&rows, Acceptance::default()).unwrap();
    let Kind::Jitter { period, rms, shortest, longest } = log.findings[0].kind else { panic!("{:?}", log.findings) };
    assert!(rms < period && shortest < 0.008 && longest > 0.012);
}

#[test]
fn irregular_clock() {
    let mut rows = good();
    for (k, row) in rows.iter_mut().enumerate().skip(1) {
        let shift = if k % 3 == 0 { 0.7 } else { 0.0 };
        row[0] = format!("{:.4}", 0.01 * (k as f64 + shift));
    }
    let (finding, _) = only(&rows);
    assert!(matches!(finding.kind, Kind::IrregularClock { share, .. } if share > 0.3), "{finding:?}");
}

#[test]
fn stuck_position() {
    let mut rows = good();
    let frozen = rows[50][1].clone();
    rows[51..75].iter_mut().for_each(|row| row[1] = frozen.clone());
    let (finding, _) = only(&rows);
    assert_eq!((finding.column.as_deref(), finding.line), (Some("q1"), Some(51)));
    assert!(matches!(finding.kind, Kind::Stuck { seconds, .. } if (seconds - 0.24).abs() < 0.011), "{finding:?}");
}

#[test]
fn a_joint_at_rest_is_not_stuck() {
    let mut rows = good();
    let rest = rows[50][1].clone();
    rows[51..].iter_mut().for_each(|row| row[1] = rest.clone());
    assert!(read(&rows, Acceptance::default()).unwrap().findings.is_empty());
}

/// The torque of a joint at rest may be constant and step when the joint moves; a torque that is
/// constant while the joint moves is stuck.
#[test]
fn the_torque_of_a_joint_at_rest_is_not_stuck() {
    let mut rows = good();
    rows[51..90].iter_mut().for_each(|row| row[3] = "0".into());
    rows[90][3] = "1000".into();
    let (finding, _) = only(&rows);
    assert!(matches!(finding.kind, Kind::Stuck { .. }) && finding.column.as_deref() == Some("tau1"), "{finding:?}");
    let rest = rows[51][1].clone();
    rows[51..90].iter_mut().for_each(|row| row[1] = rest.clone());
    rows[90..].iter_mut().for_each(|row| row[1] = rest.clone());
    assert!(read(&rows, Acceptance::default()).unwrap().findings.is_empty());
}

#[test]
fn clipped_torque() {
    let mut rows = good();
    for row in &mut rows[1..] {
        row[3] = row[3].parse::<f64>().unwrap().clamp(-6.0, 6.0).to_string();
    }
    let (finding, _) = only(&rows);
    assert_eq!(finding.column.as_deref(), Some("tau1"));
    assert!(matches!(finding.kind, Kind::Clipped { level, samples } if level == 6.0 && samples > 100), "{finding:?}");
}

#[test]
fn dead_sensor() {
    let mut rows = good();
    rows[1..].iter_mut().for_each(|row| row[4] = "0.0".into());
    let (finding, _) = only(&rows);
    assert_eq!((finding.kind, finding.column.as_deref()), (Kind::DeadTorque, Some("tau2")));
}

#[test]
fn degrees() {
    let mut rows = good();
    for row in &mut rows[1..] {
        row[1] = row[1].parse::<f64>().unwrap().to_degrees().to_string();
    }
    let (finding, _) = only(&rows);
    assert!(matches!(finding.kind, Kind::Degrees { largest } if largest > 57.0));
    assert_eq!(finding.column.as_deref(), Some("q1"));
}

#[test]
fn too_few() {
    let rows = good();
    assert!(matches!(fatal(&rows[..10])[0].kind, Kind::TooFew { samples: 9 }));
    assert_eq!(read(&rows[..100], Acceptance::default()).unwrap().findings[0].severity, Severity::Warning);
}

#[test]
fn unknown_columns_are_one_note() {
    let mut rows = good();
    for (i, row) in rows.iter_mut().enumerate() {
        row.insert(1, if i == 0 { "mode" } else { "auto" }.into());
        row.push(if i == 0 { "note" } else { "" }.into());
    }
    let log = read(&rows, Acceptance::default()).unwrap();
    assert_eq!(log.len(), 400);
    assert_eq!(
        log.findings[0].to_string(),
        "line 1: columns that are not used: mode, note (rename them if they are meant)"
    );
    assert_eq!(log.findings.len(), 1);
}

#[test]
fn all_mistakes_at_once() {
    let mut rows = good();
    rows[100][2] = "x".into();
    rows[200][0] = rows[199][0].clone();
    rows[1..].iter_mut().for_each(|row| row[4] = "0".into());
    let message = read(&rows, Acceptance::default()).unwrap_err().to_string();
    for part in ["log.csv", "line 101", "line 201", "tau2", "--keep dead-torque", "--keep duplicates"] {
        assert!(message.contains(part), "{message}");
    }
    assert!(read(&rows, Acceptance::all()).is_ok());
}
