//! Tests with real recordings, if present (`shared/data`, not part of the project): each is read by
//! default, or rejected for a real defect.

use std::{fs::File, path::PathBuf};

use super::*;

fn findings(path: &str) -> Option<Result<Log, LogError>> {
    let root = ["../shared/data", "shared/data"].iter().map(PathBuf::from).find(|p| p.is_dir())?;
    let file = File::open(root.join(path)).ok()?;
    Some(open(path, file).and_then(|mut source| Log::read(source.as_mut(), Quantity::Tau, Acceptance::default())))
}

#[test]
fn what_is_in_order_is_read() {
    for path in [
        "kuka-lwr4plus/traj1.csv",
        "staubli-tx40/exciting_train.csv",
        "kinova-gen3/optitraj1.csv",
        "kuka-iiwa14/chirp_j2.csv",
        "kuka-iiwa14/chirp_j6.csv",
        "kuka-iiwa14/chirp_j5j6j7.csv",
        "kuka-iiwa14/motion_j2toj7.csv",
        "kuka-iiwa14/motion_j3j4.csv",
        "kuka-iiwa14/static_j2toj4_896poses.csv",
        "kuka-iiwa14/static_j5toj7_50poses.csv",
        "kuka-iiwa14/friction_j1_v0.15.csv",
        "kuka-iiwa14/friction_j4_v1.10.csv",
        "kuka-iiwa14/friction_j5_loaded_v0.40.csv",
        "kuka-iiwa14/friction_j7_v0.90.csv",
    ] {
        if let Some(log) = findings(path) {
            let log = log.unwrap_or_else(|e| panic!("{e}"));
            assert!(
                log.findings.iter().all(|f| matches!(f.kind, Kind::Jitter { .. } | Kind::TooFew { .. })),
                "{path}: {:?}",
                log.findings
            );
        }
    }
}

#[test]
fn sensors_that_were_off() {
    for (path, dead) in [("kinova-gen3/sync7_run.csv", 1), ("kinova-gen3/trapez_j1_currentonly.csv", 7)] {
        if let Some(log) = findings(path) {
            let Err(LogError::Rejected { findings, .. }) = log else { panic!("{path}: not rejected") };
            assert_eq!(findings.iter().filter(|f| f.kind == Kind::DeadTorque).count(), dead);
            assert_eq!(findings.iter().filter(|f| f.is_fatal()).count(), dead, "{path}: {findings:?}");
        }
    }
}
