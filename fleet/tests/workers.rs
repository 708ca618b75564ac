//! Runs that are killed and repeated: nothing is lost, nothing is there twice.

use std::io::{Read, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Duration;

use datafusion::arrow::array::AsArray;
use datafusion::arrow::datatypes::Int64Type;
use denavit_fleet::Fleet;
use denavit_fleet::watch::TABLE;

const RECORDINGS: usize = 10;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// Recordings that differ: one of an iiwa, shortened more and more; and a damaged one.
fn logs(folder: &Path) {
    let file = std::fs::File::open(root().join("data/kuka-iiwa14/chirp_j2.csv.gz")).unwrap();
    let mut text = String::new();
    flate2::read::GzDecoder::new(file).read_to_string(&mut text).unwrap();
    let lines: Vec<&str> = text.lines().collect();
    for k in 0..RECORDINGS {
        let mut out = std::fs::File::create(folder.join(format!("{k:02}.csv"))).unwrap();
        out.write_all(lines[..lines.len() - 10 * k].join("\n").as_bytes()).unwrap();
    }
    std::fs::write(folder.join("damaged.csv"), "t,q1\n0,a\n").unwrap();
}

fn factor(logs: &Path, out: &Path, workers: &str) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_denavit-fleet"));
    command.arg("factor").arg(logs).arg("--robot").arg(root().join("robots/kuka-iiwa14.yaml")).arg("--out").arg(out);
    command.args(["--workers", workers, "--threads", "1"]).stdout(Stdio::piped()).stderr(Stdio::piped());
    command
}

/// Rows, different recordings, and the factor of all.
fn contents(out: &Path) -> (i64, i64, Vec<u8>) {
    let runtime = tokio::runtime::Runtime::new().unwrap();
    runtime.block_on(async {
        let fleet = Fleet::new(2);
        fleet.factors(&out.display().to_string()).await.unwrap();
        let query = format!("SELECT count(*), count(DISTINCT sha256), merge_factor(sha256, factor) FROM {TABLE}");
        let rows = fleet.context.sql(&query).await.unwrap().collect().await.unwrap();
        let number = |k: usize| rows[0].column(k).as_primitive::<Int64Type>().value(0);
        (number(0), number(1), rows[0].column(2).as_binary::<i32>().value(0).to_vec())
    })
}

fn rows(out: &Path) -> usize {
    std::fs::read_dir(out.join("unfinished")).map_or(0, |folder| {
        folder.filter(|entry| entry.as_ref().is_ok_and(|e| e.path().extension().is_some_and(|e| e == "row"))).count()
    })
}

/// Ends one worker of a run as soon as a row is there.
fn kill_a_worker(parent: u32, out: &Path) {
    while rows(out) == 0 {
        std::thread::sleep(Duration::from_millis(5));
    }
    let children = std::fs::read_to_string(format!("/proc/{parent}/task/{parent}/children")).unwrap();
    let worker = children.split_whitespace().next().expect("a worker runs").to_string();
    assert!(Command::new("kill").args(["-9", &worker]).status().unwrap().success());
}

#[test]
fn a_killed_worker_loses_nothing_and_repeats_only_what_is_missing() {
    let (folder, undisturbed, killed) =
        (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
    logs(folder.path());
    let done = factor(folder.path(), undisturbed.path(), "1").output().unwrap();
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    let process = factor(folder.path(), killed.path(), "2").spawn().unwrap();
    kill_a_worker(process.id(), killed.path());
    let done = process.wait_with_output().unwrap();
    assert_eq!(done.status.code(), Some(1));
    println!("{}", String::from_utf8_lossy(&done.stderr));
    let before = rows(killed.path());
    assert!((1..=RECORDINGS).contains(&before), "{before} rows are there");
    let done = factor(folder.path(), killed.path(), "2").output().unwrap();
    let said = String::from_utf8_lossy(&done.stdout).into_owned();
    println!("{before} rows were there; {said}");
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    assert!(said.contains(&format!("{} of {} recordings were missing", RECORDINGS + 1 - before, RECORDINGS + 1)));
    assert_eq!(contents(killed.path()), contents(undisturbed.path()));
    assert_eq!(contents(killed.path()).0, RECORDINGS as i64 + 1);
    assert_eq!(rows(killed.path()), 0);
    // A third run has nothing to do.
    let done = factor(folder.path(), killed.path(), "1").output().unwrap();
    assert!(String::from_utf8_lossy(&done.stdout).starts_with("0 of 11 recordings"));
    assert_eq!(contents(killed.path()).0, RECORDINGS as i64 + 1);
}
