//! Every file of robots/broken has one mistake; each is named, with its place and how to mend it.

mod common;

use common::{files, read, robots};

/// Lines with this comment hold the mistake.
const MARK: &str = "# here";

#[test]
fn every_mistake_is_named() {
    let mut printed = String::new();
    for path in files("broken") {
        let name = path.strip_prefix(robots()).unwrap().display().to_string();
        let problems = match read(&path) {
            Ok(_) => panic!("{name} was read without a problem"),
            Err(problems) => problems.in_file(&format!("robots/{name}")),
        };
        let bytes = std::fs::read(&path).unwrap();
        let marked = String::from_utf8_lossy(&bytes).lines().position(|line| line.contains(MARK));
        if let Some(row) = marked {
            assert_eq!(problems.list().len(), 1, "{name} has one mistake:\n{problems}");
            assert_eq!(problems.list()[0].line, row + 1, "{name}:\n{problems}");
        }
        for problem in problems.list() {
            assert!(!problem.what.is_empty() && !problem.mend.is_empty(), "{name}: {problem}");
        }
        printed += &format!("{problems}\n");
    }
    insta::assert_snapshot!("messages", printed);
}

#[test]
fn all_mistakes_of_a_file_are_reported_together() {
    let problems = read(&robots().join("broken/several.yaml")).unwrap_err();
    let paths: Vec<&str> = problems.list().iter().map(|problem| problem.path.as_str()).collect();
    let top = ["name", "convention", "gravity", "links", "links[1]", "tool", "colour"];
    let first = ["joints[1].aplha", "joints[1].position", "joints[2].name", "joints[2].type", "joints[2].d"];
    let third = ["joints[3].drive", "joints[3].drive.rotor_inertia"];
    for path in top.iter().chain(&first).chain(&third) {
        assert!(paths.contains(path), "{path} is not in\n{problems}");
    }
    assert_eq!(paths.len(), 14, "{problems}");
}

/// Mass and tensor could each be a body's; with these first moments they can't. Published tables
/// have such links, so it is said, with figures, but the file is read.
#[test]
fn a_tensor_that_does_not_go_with_the_first_moments_is_noted() {
    let text = "name: noted\nconvention: modified\ngravity: [0, 0, -9.81]\njoints:\n  - { type: revolute }\n\
                links:\n  - { M: 2.7, MS: [0.0, -0.12, 0.3], I: [0.02, 0.02, 0.004, 0, 0, 0] }\n";
    let reading = dh_codegen::robot::Robot::from_yaml(text, &dh_codegen::robot::no_files).unwrap();
    let notes: Vec<String> = reading.notes.iter().map(ToString::to_string).collect();
    assert!(notes.iter().any(|n| n.contains("links[1]") && n.contains("no body is like this")), "{notes:?}");
}
