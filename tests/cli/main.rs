//! Tests of the command as a process: printed output, written files, exit status.

mod bundle;
mod calibrate;
mod check;
mod diagnose;
mod errors;
mod eval;
mod excite;
mod factor;
mod force;
mod generate;
mod identify;
mod ik;
mod import;
mod law;
mod log;
#[cfg(target_os = "linux")]
mod memory;
mod new;
mod outputs;
mod paint;
mod provenance;
mod reproduce;
mod same_samples;
mod shell;
mod simulate;
mod tool;

use std::path::PathBuf;
use std::process::Command;

use dh_codegen::robot::{Robot, no_files};

/// Exit status and output of a run.
struct Run {
    status: Option<i32>,
    out: String,
    err: String,
}

/// Runs the command at the root of the repository, so that paths `robots/..` are valid.
fn denavit(arguments: &[&str]) -> Run {
    let run = Command::new(env!("CARGO_BIN_EXE_denavit"))
        .args(arguments)
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    Run { status: run.status.code(), out: text(run.stdout), err: text(run.stderr) }
}

/// Output of a successful run with `--json -`: one JSON value and nothing else.
fn json(arguments: &[&str]) -> serde_json::Value {
    let run = denavit(arguments);
    assert_eq!(run.status, Some(0), "{}", run.err);
    serde_json::from_str(&run.out).unwrap()
}

/// An empty folder for one test.
fn folder(name: &str) -> PathBuf {
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("cli").join(name);
    let _ = std::fs::remove_dir_all(&path);
    std::fs::create_dir_all(&path).unwrap();
    path
}

/// Writes a file and returns its path as an argument.
fn file(folder: &std::path::Path, name: &str, text: impl AsRef<[u8]>) -> String {
    let path = folder.join(name);
    std::fs::write(&path, text).unwrap();
    path.display().to_string()
}

fn read_robot(path: &str) -> Robot {
    let text = std::fs::read_to_string(PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(path)).unwrap();
    Robot::from_yaml(&text, &no_files).unwrap().robot
}

fn numbers(value: &serde_json::Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|v| v.as_f64().unwrap()).collect()
}

fn strings(value: &serde_json::Value) -> Vec<&str> {
    value.as_array().unwrap().iter().map(|v| v.as_str().unwrap()).collect()
}

/// CSV of columns with a header.
fn csv(header: &[String], rows: &[Vec<f64>]) -> String {
    let line = |row: &Vec<f64>| row.iter().map(f64::to_string).collect::<Vec<_>>().join(",");
    let lines: Vec<String> = std::iter::once(header.join(",")).chain(rows.iter().map(line)).collect();
    lines.join("\n") + "\n"
}

/// Names such as `q1..qn`.
fn columns(prefixes: &[&str], n: usize) -> Vec<String> {
    prefixes.iter().flat_map(|p| (1..=n).map(move |j| format!("{p}{j}"))).collect()
}
