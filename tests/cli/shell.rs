//! Tests of completions, manual pages, standard input, and messages for wrong arguments.

use std::io::Write;
use std::process::{Command, Stdio};

use super::{denavit, folder};

#[test]
fn shells_get_their_completions() {
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let run = denavit(&["completions", shell]);
        assert_eq!(run.status, Some(0), "{}", run.err);
        assert!(run.out.contains("identify") && run.out.contains("denavit"), "{shell}");
    }
}

#[test]
fn every_verb_has_its_manual_page() {
    let folder = folder("man").join("man1");
    let run = denavit(&["man", "--out", folder.to_str().unwrap()]);
    assert_eq!(run.status, Some(0), "{}", run.err);
    for page in ["denavit", "denavit-factor", "denavit-identify", "denavit-paint-run", "denavit-log-inspect"] {
        let text = std::fs::read_to_string(folder.join(format!("{page}.1"))).unwrap();
        assert!(text.contains(".SH NAME") && text.contains(&format!(".TH {page}")), "{page}: {text}");
    }
}

#[test]
fn a_robot_comes_from_standard_input() {
    let feed = |arguments: &[&str], input: &[u8]| {
        let mut child = Command::new(env!("CARGO_BIN_EXE_denavit"))
            .args(arguments)
            .current_dir(env!("CARGO_MANIFEST_DIR"))
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        child.stdin.take().unwrap().write_all(input).unwrap();
        child.wait_with_output().unwrap()
    };
    let robot = std::fs::read(concat!(env!("CARGO_MANIFEST_DIR"), "/robots/planar2r.yaml")).unwrap();
    let run = feed(&["check", "-", "--json", "-"], &robot);
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
    let value: serde_json::Value = serde_json::from_slice(&run.stdout).unwrap();
    assert_eq!(value["dof"], 2);
    let run = feed(&["check", "-"], b"<robot name=\"a\"/>");
    let said = String::from_utf8_lossy(&run.stderr).into_owned();
    assert!(said.contains("standard input is XML") && said.contains("import - --out robot.yaml"), "{said}");
    // Read once: there is no second robot file in it.
    let run = feed(&["eval", "-", "--quantity", "gravity", "--states", "-"], &robot);
    assert_eq!(run.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&run.stderr).contains("read once"), "{}", String::from_utf8_lossy(&run.stderr));
}

/// One paragraph that contains clap's lines.
#[test]
fn wrong_arguments_are_answered_line_by_line() {
    let run = denavit(&["identify", "robots/planar2r.yaml", "a.csv", "--valdate", "b.csv"]);
    assert_eq!(run.status, Some(2));
    assert!(run.err.lines().count() >= 3 && !run.err.contains("\n\n"), "{}", run.err);
    assert!(run.err.contains("--validate"), "{}", run.err);
}

#[test]
fn an_option_that_took_the_logs_is_named() {
    let run = denavit(&["identify", "robots/planar2r.yaml", "--validate", "a.csv", "b.csv"]);
    assert_eq!(run.status, Some(2));
    assert!(run.err.contains("put the logs to be fitted before --validate"), "{}", run.err);
    let run = denavit(&["identify", "robots/planar2r.yaml"]);
    assert!(!run.err.contains("hint"), "{}", run.err);
}
