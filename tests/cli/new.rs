//! Tests of `denavit new`: the robot file to fill in is valid.

use super::{denavit, folder, json};
use dh_codegen::robot::{JointKind, Robot, no_files};

#[test]
fn a_new_file_is_valid_and_has_the_joints_that_were_asked_for() {
    let folder = folder("new");
    for (joints, convention, wanted) in [
        ("1", "modified", "R"),
        ("7", "standard", "RRRRRRR"),
        ("PPR", "modified", "PPR"),
        ("RPRRR", "standard", "RPRRR"),
    ] {
        let out = folder.join(format!("{joints}-{convention}.yaml"));
        let path = out.to_str().unwrap();
        let run = denavit(&["new", "my-arm", "--joints", joints, "--convention", convention, "--out", path]);
        assert_eq!(run.status, Some(0), "{}", run.err);
        let text = std::fs::read_to_string(&out).unwrap();
        let robot = Robot::from_yaml(&text, &no_files).unwrap().robot;
        let kinds: String =
            robot.joints.iter().map(|j| if j.kind == JointKind::Prismatic { 'P' } else { 'R' }).collect();
        assert_eq!(kinds, wanted);
        let check = json(&["check", path, "--json", "-"]);
        assert_eq!(check["dof"], wanted.len());
        // Existing files are kept.
        let again = denavit(&["new", "my-arm", "--joints", joints, "--out", path]);
        assert_eq!(again.status, Some(2));
        assert!(again.err.contains("--force"), "{}", again.err);
        assert_eq!(std::fs::read_to_string(&out).unwrap(), text);
    }
}

/// The optional keys in comments are valid when uncommented.
#[test]
fn its_comments_are_true() {
    let run = denavit(&["new", "my-arm", "--joints", "2", "--out", "-"]);
    let uncommented = |line: &str| match line.strip_prefix("# ").or(line.strip_prefix("    # ")) {
        Some(rest) if line.starts_with("    # ") => format!("    {rest}"),
        Some(rest) if rest.split(':').next().is_some_and(|key| !key.contains(' ')) || rest.starts_with("  ") => {
            rest.into()
        }
        _ => line.to_string(),
    };
    let text: String = run.out.lines().map(|line| uncommented(line) + "\n").collect();
    let robot = Robot::from_yaml(&text, &no_files).map_err(|e| format!("{}\n{text}", e.in_file("new")));
    let robot = robot.unwrap().robot;
    assert!(
        robot.tool.is_some() && robot.collision.ground.is_some() && robot.joints[0].drive.gear_ratio == Some(100.0)
    );
}

#[test]
fn what_names_no_arm_is_refused() {
    for (name, joints) in [("my-arm", "0"), ("my-arm", "31"), ("my-arm", "RQ"), ("a: b", "2"), ("", "2")] {
        let run = denavit(&["new", name, "--joints", joints, "--out", "-"]);
        assert_eq!(run.status, Some(2), "{name} {joints}");
        assert!(run.out.is_empty() && run.err.starts_with("denavit: "), "{}", run.err);
    }
}
