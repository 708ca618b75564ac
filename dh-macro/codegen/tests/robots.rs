//! The robot files of the repository read well, and survive being written.

mod common;

use common::{files, read, robots};
use dh_codegen::robot::{JointKind, Robot, no_files, schema};

#[test]
fn every_robot_reads_without_a_problem() {
    for path in files("") {
        let name = path.file_stem().unwrap().to_string_lossy().to_string();
        let reading =
            read(&path).unwrap_or_else(|problems| panic!("{}", problems.in_file(&path.display().to_string())));
        assert!(reading.notes.is_empty(), "{name}: {:?}", reading.notes);
        assert_eq!(reading.robot.name, name);
        let text = std::fs::read_to_string(&path).unwrap();
        assert!(text.starts_with("# yaml-language-server: $schema=robot.schema.json\n"), "{name}");
        for joint in &reading.robot.joints {
            assert!(joint.alpha.quarter_turns().is_some(), "{name} {}", joint.name);
        }
    }
}

#[test]
fn a_written_robot_reads_back_the_same() {
    for path in files("") {
        let reading = read(&path).unwrap();
        let robot = reading.robot;
        assert!(reading.source.is_some());
        let text = robot.to_yaml_with_source(reading.source.as_deref());
        let again = Robot::from_yaml(&text, &no_files).unwrap_or_else(|e| panic!("{e}\n{text}"));
        assert_eq!(again.robot, robot, "{text}");
        assert_eq!(again.source, reading.source);
        assert_eq!(again.robot.to_yaml_with_source(again.source.as_deref()), text);
    }
}

#[test]
fn the_lwr_is_table_one() {
    let robot = read(&robots().join("kuka-lwr4.yaml")).unwrap().robot;
    let turns: Vec<_> = robot.joints.iter().map(|joint| joint.alpha.quarter_turns().unwrap()).collect();
    assert_eq!(turns, [0, 1, -1, -1, 1, 1, -1]);
    let lengths: Vec<_> = robot.joints.iter().map(|joint| joint.r.closed_form.text(&robot.constants)).collect();
    assert_eq!(lengths, ["L1", "0", "L2", "0", "L3", "0", "0"]);
    assert!(robot.joints.iter().all(|joint| joint.kind == JointKind::Revolute && joint.d.value == 0.0));
    assert_eq!(robot.joints[5].limits.torque, Some(38.0));
}

/// The groupings that carry gravity, against the published values (Gaz et al. 2014, gravity model).
#[test]
fn the_lwr_has_the_published_base_parameters() {
    let robot = read(&robots().join("kuka-lwr4.yaml")).unwrap().robot;
    let links: Vec<_> = robot.links.iter().map(|link| link.unwrap()).collect();
    let mass = |from: usize| links[from..].iter().map(|link| link.m).sum::<f64>();
    let (l2, l3) = (0.40, 0.39);
    let close = |name: &str, value: f64, published: f64| assert!((value - published).abs() < 1e-9, "{name}: {value}");
    close("MSX2", links[1].ms[0], 1.35474040e-03);
    close("MSY2R", links[1].ms[1] + links[2].ms[2] + l2 * mass(2), 3.45678867);
    close("MSY3R", links[2].ms[1] + links[3].ms[2], -4.72374501e-04);
    close("MSY4R", links[3].ms[1] - links[4].ms[2] - l3 * mass(4), -1.33402250);
    close("MSY5R", links[4].ms[1] - links[5].ms[2], 4.06879740e-02);
    close("MSY6R", links[5].ms[1] + links[6].ms[2], 2.86371784e-02);
    let (xx, yy, zz) = (0, 1, 2);
    let carried = 2.0 * l2 * links[2].ms[2] + l2 * l2 * mass(2);
    close("XX2R", links[1].i[xx] - links[1].i[yy] + links[2].i[yy] + carried, 1.24762485);
    close("ZZ2R", links[1].i[zz] + links[2].i[yy] + carried, 1.25242680);
    close("ZZ6R", links[5].i[zz] + links[6].i[yy], 3.76802038e-03);
    close("ZZ7", links[6].i[zz], 1.20294035e-04);
}

/// Rewrites `robots/robot.schema.json` and fails when it does not say what the tables of keys say.
#[test]
fn the_schema_is_fresh() {
    let path = robots().join("robot.schema.json");
    let fresh = schema();
    if std::fs::read_to_string(&path).ok().as_deref() != Some(&fresh) {
        std::fs::write(&path, fresh).unwrap();
        panic!("{} was stale and has been rewritten; run the test again and commit the file", path.display());
    }
}

/// The layout of a written file, for a person to look at.
#[test]
fn a_written_file_can_be_read_by_a_person() {
    let reading = read(&robots().join("kuka-lwr4.yaml")).unwrap();
    insta::assert_snapshot!("written", reading.robot.to_yaml_with_source(reading.source.as_deref()));
}
