//! Tests of `denavit log`, and of the mapping of a robot file.

use super::{denavit, folder};

const MAPPING: &str = "columns:\n  t: { channel: Time, unit: ms }\n  \"q*\": { channel: \"Axis {number}\", unit: deg }\n  \
                       \"tau*\": { channel: \"Moment {number}\", unit: N mm }\n";

#[test]
fn the_mapping_of_the_robot_file_is_used_unless_another_is_given() {
    let place = folder("log-mapping");
    let path = |name: &str| place.join(name).display().to_string();
    let plain = std::fs::read_to_string("robots/planar2r.yaml").unwrap();
    let indented: String = MAPPING.lines().map(|line| format!("  {line}\n")).collect();
    std::fs::write(path("robot.yaml"), format!("{plain}\nlog:\n{indented}")).unwrap();
    let row = |k: u32| format!("{};{};{k};{};-500\n", 10 * k, 90 + k, 1000 + k);
    let rows: String = (0..50).map(row).collect();
    std::fs::write(path("export.csv"), format!("Time;Axis 1;Axis 2;Moment 1;Moment 2\n{rows}")).unwrap();
    let convert = |more: &[&str]| {
        let (log, robot, out) = (path("export.csv"), path("robot.yaml"), path("out.csv"));
        let all = [&["log", "convert", &log, "--robot", &robot, "--out", &out, "--keep", "all"], more].concat();
        let run = denavit(&all);
        assert_eq!(run.status, Some(0), "{}", run.err);
        std::fs::read_to_string(path("out.csv")).unwrap()
    };
    let first = convert(&[]).lines().nth(1).unwrap().to_string();
    assert_eq!(first, format!("0,{},0,1,-0.5", std::f64::consts::FRAC_PI_2));
    std::fs::write(path("map.yaml"), MAPPING.replace("unit: N mm", "gain: 2")).unwrap();
    assert!(convert(&["--map", &path("map.yaml")]).lines().nth(1).unwrap().ends_with(",2000,-1000"));
    // Mistakes in a mapping file are reported by line and column, as in the robot file.
    std::fs::write(path("map.yaml"), MAPPING.replace("unit: ms", "unit: m")).unwrap();
    let run = denavit(&["log", "convert", &path("export.csv"), "--map", &path("map.yaml"), "--out", &path("no.csv")]);
    assert_eq!(run.status, Some(2));
    assert!(run.err.contains("map.yaml:2:") && run.err.contains("`m` is no unit of `t`"), "{}", run.err);
}

/// A file without numbers is no log.
#[test]
fn a_file_without_numbers_is_refused() {
    let path = folder("log-nothing").join("header.csv").display().to_string();
    std::fs::write(&path, "t,q1,q2,tau1,tau2\n").unwrap();
    let run = denavit(&["log", "inspect", &path]);
    assert_eq!(run.status, Some(2), "{}", run.out);
    assert!(run.err.contains("header.csv holds no numbers"), "{}", run.err);
}

#[test]
fn a_folder_of_rosbag2_stands_for_its_recording() {
    let run = denavit(&["log", "inspect", "tests/recordings/rosbag2"]);
    if cfg!(feature = "rosbag2") {
        assert!(run.out.contains("/joint_states/position/elbow"), "{}", run.out);
    } else {
        assert_eq!(run.status, Some(2));
        assert!(run.err.contains("--features rosbag2"), "{}", run.err);
    }
}

#[test]
fn help_of_every_verb_that_reads_logs_names_the_columns() {
    for verb in
        [&["identify"][..], &["factor"], &["diagnose"], &["calibrate"], &["tool"], &["force"], &["log", "convert"]]
    {
        let run = denavit(&[verb, &["--help"]].concat());
        assert!(run.out.contains("tau1.. or i1..") && run.out.contains("seg "), "{verb:?}:\n{}", run.out);
    }
}
