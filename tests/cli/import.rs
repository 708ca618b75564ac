use super::*;

const ARM: &str = "tests/import/arm.urdf";

#[test]
fn an_imported_robot_is_a_robot_file() {
    let folder = folder("import");
    let out = folder.join("arm.yaml").display().to_string();
    let said = json(&["import", ARM, "--tip", "flange", "--at", "grip=0.03", "--out", &out, "--json", "-"]);
    assert_eq!(said["dof"], 7);
    assert!(said["forward_kinematics_error"]["position"].as_f64().unwrap() < 1e-12);
    let text = std::fs::read_to_string(&out).unwrap();
    assert!(text.contains("source: ") && text.contains("provenance:") && text.contains("sha256"), "{text}");
    assert_eq!(read_robot(&out).dof(), 7);
    assert_eq!(json(&["check", &out, "--json", "-"])["dof"], 7);
    let run = denavit(&["import", ARM, "--tip", "flange", "--at", "zero"]);
    assert_eq!(run.status, Some(0), "{}", run.err);
    for words in ["forward kinematics against the source", "held beside the arm: grip = 0.01", "1 anti-parallel"] {
        assert!(run.out.contains(words), "no `{words}` in\n{}", run.out);
    }
}

#[test]
fn wrong_use_says_how_to_go_on() {
    for (arguments, words) in [
        (&["import", ARM, "--tip", "flange"][..], "--at grip=0.01"),
        (&["import", ARM, "--tip", "flange", "--at", "grip"], "finger_joint=0.02"),
        (&["import", ARM, "--tip", "nowhere"], "no link `nowhere`"),
        (&["import", ARM, "--snap", "1"], "--snap"),
        (&["import", "robots/scara.yaml"], "no well-formed XML"),
        (&["check", ARM], "denavit import tests/import/arm.urdf --out tests/import/arm.yaml"),
    ] {
        let run = denavit(arguments);
        assert_eq!(run.status, Some(2), "{arguments:?}: {}", run.err);
        assert!(run.err.contains(words), "{arguments:?}: {}", run.err);
    }
}

/// A held position must be within the range of its joint.
#[test]
fn a_position_beside_the_arm_is_one_that_it_has() {
    let beyond = denavit(&["import", ARM, "--tip", "flange", "--at", "grip=5"]);
    assert!(beyond.status == Some(2) && beyond.err.contains("`grip` can't be at 5"), "{}", beyond.err);
}

#[test]
fn a_robot_is_exported_and_read_again() {
    let folder = folder("export");
    for format in ["urdf", "mjcf"] {
        let model = folder.join(format).display().to_string();
        let run = denavit(&["export", "robots/kuka-lwr4.yaml", "--format", format, "--out", &model]);
        assert_eq!(run.status, Some(0), "{}", run.err);
        let said = json(&["import", &model, "--json", "-"]);
        assert_eq!(said["dof"], 7, "{format}");
    }
    let model = folder.join("urdf").display().to_string();
    let out = folder.join("onto").display().to_string();
    let run = denavit(&["export", "robots/kuka-lwr4.yaml", "--onto", &model, "--out", &out]);
    assert_eq!(run.status, Some(0), "{}", run.err);
    let wrong = ["export", "robots/kuka-lwr4.yaml", "--format", "mjcf", "--onto", &model, "--out", &out];
    assert_eq!(denavit(&wrong).status, Some(2));
}
