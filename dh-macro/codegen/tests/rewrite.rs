//! A changed robot goes back into the text of its file: unchanged parts keep their text.

use dh_codegen::robot::effects::{TimeDelay, TorqueOffset};
use dh_codegen::robot::{Effect, Inertia, Robot, Run, no_files};

fn files() -> Vec<(String, String)> {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../robots");
    let mut paths: Vec<_> = std::fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()).collect();
    paths.retain(|p| p.extension().is_some_and(|e| e == "yaml"));
    paths.sort();
    paths.iter().map(|p| (p.display().to_string(), std::fs::read_to_string(p).unwrap())).collect()
}

/// Files that a robot file names.
fn load(name: &str) -> std::io::Result<String> {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../robots");
    std::fs::read_to_string(folder.join(name))
}

fn read(text: &str) -> Robot {
    Robot::from_yaml(text, &load).unwrap_or_else(|e| panic!("{}\n{text}", e.in_file("robot"))).robot
}

fn run(command: &str) -> Run {
    Run {
        command: command.into(),
        version: "0.1.0".into(),
        options: vec!["--delay: 0.04".into(), "--cutoff: 10 (default)".into()],
        files: vec![["fitted log".into(), "it's \"one\".csv".into(), "00ff".into()]],
        found: vec!["stribeck_friction: 4.1 N m # of joint 3".into()],
    }
}

/// Other bodies, friction and effects everywhere.
fn changed(mut robot: Robot) -> Robot {
    let count = robot.joints.len();
    robot.links = (0..count)
        .map(|k| Some(Inertia { m: 1.5 + k as f64 / 7.0, ms: [0.01, 0.02, 0.03], i: [0.5, 0.6, 0.7, 0.0, 0.01, 0.0] }))
        .collect();
    for (k, joint) in robot.joints.iter_mut().enumerate() {
        joint.drive.viscous_friction = Some(0.25 + k as f64 / 3.0);
        joint.drive.rotor_inertia = Some(0.125 + k as f64 / 3.0);
        joint.drive.effects.push(TorqueOffset { offset: Some(0.1) }.into());
    }
    robot.effects.push(TimeDelay { delay: Some(0.004) }.into());
    robot
}

fn comments(text: &str) -> Vec<&str> {
    text.lines().filter_map(|line| line.split_once('#')).map(|(_, comment)| comment).collect()
}

#[test]
fn nothing_changes_nothing() {
    for (path, text) in files() {
        assert_eq!(read(&text).rewritten(&text, &load, &load, &Run::default()), text, "{path}");
    }
}

#[test]
fn changes_stand_where_the_values_stood() {
    for (path, text) in files() {
        let robot = read(&text);
        if robot.joints.iter().any(|j| j.drive.effects.iter().any(|e| matches!(e, Effect::TorqueOffset(_)))) {
            continue;
        }
        let robot = changed(robot);
        let written = robot.rewritten(&text, &load, &load, &run("denavit identify x"));
        assert_eq!(read(&written).to_yaml(), robot.to_yaml(), "{path}");
        for comment in comments(&text) {
            assert!(written.contains(comment), "{path}: lost `{comment}`");
        }
        // Each line that is gone held a value that changed.
        let kept = text.lines().filter(|line| written.lines().any(|l| l == *line)).count();
        let rows = text.lines().filter(|l| l.contains("drive:") || l.contains("friction") || l.contains("M:")).count();
        assert!(kept + rows + 2 * robot.joints.len() >= text.lines().count(), "{path}: {kept} lines kept\n{written}");
        let source = |text: &str| Robot::from_yaml(text, &load).unwrap().source;
        assert_eq!(source(&written), source(&text), "{path}");
    }
}

#[test]
fn one_value_changes_one_place() {
    let text = "# head\nname: one   # its name\nsource: a book\nconvention: standard\nconstants: { L: 0.5 }\njoints:\n  # the only one\n  - name: a\n    type: revolute\n    d: L*2 # long\n    drive:\n      friction: { coulomb_friction: 1 }   # measured\n      gear_ratio: 100\nlinks:\n  - M: 2   # kg\n    MS: [0, 0, L/2]\n    I: [0.1, 0.1, 0.01, 0, 0, 0]\n# tail\n";
    for text in [text.to_string(), text.replace('\n', "\r\n"), format!("\u{feff}{text}").replace("head", "Höhe ü")] {
        let mut robot = read(&text);
        robot.joints[0].drive.coulomb_friction = Some(1.25);
        robot.links[0].as_mut().unwrap().m = 3.0;
        let written = robot.rewritten(&text, &load, &load, &Run::default());
        let expected = text.replace("coulomb_friction: 1 ", "coulomb_friction: 1.25 ").replace("M: 2 ", "M: 3 ");
        assert_eq!(written, expected.trim_start_matches('\u{feff}'));
    }
}

/// A tool in a file of its own comes along where the name leads nowhere.
#[test]
fn a_named_tool_is_found_from_the_new_place() {
    let text = "name: one\nconvention: standard\njoints:\n  - { type: revolute }\ntool: hand.yaml # in the lab\n";
    let here = |_: &str| Ok("name: hand\nM: 1\nMS: [0, 0, 0.1]\nI: [0.1, 0.1, 0.1, 0, 0, 0]\n".to_string());
    let robot = Robot::from_yaml(text, &here).unwrap().robot;
    assert_eq!(robot.rewritten(text, &here, &here, &Run::default()), text);
    let moved = robot.rewritten(text, &here, &no_files, &Run::default());
    assert_eq!(Robot::from_yaml(&moved, &no_files).unwrap().robot.tool, robot.tool);
    assert!(moved.contains("# in the lab"), "{moved}");
}

#[test]
fn runs_follow_each_other() {
    for (path, text) in files() {
        let robot = read(&text);
        let once = robot.rewritten(&text, &load, &load, &run("denavit identify x"));
        let twice = robot.rewritten(&once, &load, &load, &run("denavit diagnose y"));
        assert!(once.starts_with(&text) && twice.starts_with(&once), "{path}\n{once}\n---\n{twice}");
        assert_eq!(read(&twice).to_yaml(), robot.to_yaml(), "{path}");
        assert!(twice.find("denavit identify x").unwrap() < twice.find("denavit diagnose y").unwrap());
    }
}

/// A file that can't be edited in place still keeps its source and says what made it.
#[test]
fn one_line_is_written_out() {
    let text = "# from a book\n{ name: one, source: a book, convention: standard, joints: [ { type: revolute } ] }\n";
    let robot = changed(read(text));
    let written = robot.rewritten(text, &load, &load, &run("denavit identify x"));
    let reading = Robot::from_yaml(&written, &load).unwrap();
    assert_eq!((reading.robot.to_yaml(), reading.source.as_deref()), (robot.to_yaml(), Some("a book")));
    assert!(written.contains("denavit identify x") && written.contains("# from a book"), "{written}");
}

#[test]
fn a_joint_says_where_it_comes_from() {
    let text = |source: &str| {
        format!("name: one\nconvention: standard\njoints:\n  - {{ type: revolute, source: {source} }}\n")
    };
    let good = text("{ name: shoulder_pan, sign: -1, offset: 90deg }");
    let robot = changed(read(&good));
    assert!(
        robot
            .rewritten(&good, &load, &load, &Run::default())
            .contains("{ name: shoulder_pan, sign: -1, offset: 90deg }")
    );
    let problems = Robot::from_yaml(&text("{ sign: 2 }"), &load).unwrap_err().to_string();
    assert!(problems.contains("write 1 or -1"), "{problems}");
}
