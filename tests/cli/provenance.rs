//! Tests of the provenance: it is part of a result, and its command repeats the result.

use std::fs;

use super::*;

/// A simulated log of the textbook arm.
fn log(folder: &std::path::Path, name: &str, seed: &str) -> String {
    let motion = folder.join(format!("{name}.motion.csv")).display().to_string();
    let arguments = ["--duration", "6", "--starts", "2", "--seed", seed, "--out", &motion];
    let run = denavit(&[&["excite", ROBOT], &arguments[..]].concat());
    assert_eq!(run.status, Some(0), "{}", run.err);
    let log = folder.join(name).display().to_string();
    let run = denavit(&["simulate", ROBOT, "--trajectory", &motion, "--out", &log, "--seed", seed]);
    assert_eq!(run.status, Some(0), "{}", run.err);
    log
}

const ROBOT: &str = "robots/planar2r.yaml";

/// Runs a command line in a shell.
fn shell(line: &str, further: &str) -> Run {
    let program = env!("CARGO_BIN_EXE_denavit");
    let line = format!("{} {further}", line.replacen("denavit", &format!("'{program}'"), 1));
    let run = Command::new("sh").args(["-c", &line]).current_dir(env!("CARGO_MANIFEST_DIR")).output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    Run { status: run.status.code(), out: text(run.stdout), err: text(run.stderr) }
}

#[test]
fn the_command_repeats_the_run() {
    let folder = folder("provenance");
    let (a, b) = (log(&folder, "it's a log.csv", "1"), log(&folder, "b.csv", "2"));
    let page = folder.join("page.html").display().to_string();
    let said = json(&[
        "identify",
        ROBOT,
        &a,
        "--validate",
        &b,
        "--delay=-0.001",
        "--cutoff",
        "12",
        "--keep",
        "gaps,stuck",
        "--essential",
        "--consistent=never",
        "--report",
        &page,
        "--json",
        "-",
    ]);
    let made = &said["provenance"];
    assert_eq!(made["--delay"], "-0.001");
    assert_eq!(made["--cutoff"], "12");
    assert_eq!(made["--order"], "5 (default)");
    assert_eq!(made["--essential"], "yes");
    assert_eq!(made["--keep"], "gaps,stuck");
    assert_eq!(made["--consistent"], "never");
    let digest = Command::new("sha256sum").arg(&a).output().unwrap();
    let digest = String::from_utf8(digest.stdout).unwrap();
    let digest = digest.trim_start_matches('\\').split_whitespace().next().unwrap();
    assert!(made["fitted logs"].as_str().unwrap().contains(digest), "{made}");
    let again = shell(made["command"].as_str().unwrap(), "--json -");
    assert_eq!(again.status, Some(0), "{}", again.err);
    let again: serde_json::Value = serde_json::from_str(&again.out).unwrap();
    let part = |value: &serde_json::Value, key: &str| value[key].clone();
    for key in ["parameters", "rms", "nrms", "condition_number", "samples"] {
        assert_eq!(part(&again, key), part(&said, key), "{key}");
    }
    assert_eq!(again["provenance"]["command"], made["command"]);
    let page = fs::read_to_string(page).unwrap();
    assert!(page.contains("--delay=-0.001") && page.contains(digest) && page.contains("--prior-weight"));
}

#[test]
fn every_result_says_its_options() {
    let folder = folder("provenance-verbs");
    let motion = folder.join("motion.csv").display().to_string();
    let made = json(&["excite", ROBOT, "--duration", "4", "--starts", "1", "--out", &motion, "--json", "-"]);
    assert_eq!(made["provenance"]["--starts"], "1");
    assert_eq!(made["provenance"]["--speed"], "100 (default)");
    let out = folder.join("log.csv").display().to_string();
    let made = json(&["simulate", ROBOT, "--trajectory", &motion, "--out", &out, "--seed", "3", "--json", "-"]);
    assert_eq!(made["provenance"]["--seed"], "3");
    let diagnosis = json(&["diagnose", ROBOT, &out, "--cutoff", "14", "--json", "-"]);
    assert_eq!(diagnosis["provenance"]["--cutoff"], "14");
    assert_eq!(diagnosis["provenance"]["--rate"], "not given");
}
