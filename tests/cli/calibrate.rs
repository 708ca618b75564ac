//! `denavit calibrate` on a real recording: the excerpt in `data/`, and what the source says of it.

use super::{denavit, folder, numbers, read_robot};

const ROBOT: &str = "robots/staubli-tx40.yaml";
const FIRST: &str = "data/staubli-tx40/first.csv.gz";
const LAST: &str = "data/staubli-tx40/last.csv.gz";

#[test]
fn a_recording_becomes_a_model_with_the_coupling_of_the_wrist() {
    let place = folder("calibrate");
    let [out, page, json] = ["robot.yaml", "page.html", "said.json"].map(|name| place.join(name).display().to_string());
    let files = ["--out", &out, "--report", &page, "--json", &json];
    let run = denavit(&[&["calibrate", ROBOT, FIRST, "--validate", LAST][..], &files].concat());
    assert_eq!(run.status, Some(0), "{}", run.err);
    let said: serde_json::Value = serde_json::from_str(&std::fs::read_to_string(&json).unwrap()).unwrap();

    // The motor of joint 6 turns with joint 5, and the robot file does not say so (data/README.md).
    let first = &said["causes"][0];
    assert_eq!(first["cause"], "gear_coupling");
    let mut joints = numbers(&first["joints"]);
    joints.sort_by(f64::total_cmp);
    assert_eq!(joints, [5.0, 6.0]);
    // The source publishes 0.616 N m s/rad and 1.956 N m.
    let viscous = first["parameters"]["FVM6"].as_f64().unwrap();
    // Coulomb friction of the shared motor may stand in an entry of its own.
    let couplings = said["causes"].as_array().unwrap().iter().filter(|c| c["cause"] == "gear_coupling");
    let dry = couplings.flat_map(|c| ["FCM6", "FCM5"].map(|key| c["parameters"][key].as_f64()));
    let dry = dry.flatten().next().unwrap();
    assert!((viscous - 0.616).abs() < 0.1 && (dry - 1.956).abs() < 0.4, "{viscous} {dry}");

    // Measured on a part of the run to which nothing was fitted.
    let [before, after] = ["baseline", "extended"].map(|model| numbers(&said[model]["rms"]["validate"]));
    for joint in [4, 5] {
        assert!(after[joint] < 0.5 * before[joint], "joint {}: {before:?} {after:?}", joint + 1);
    }
    assert!(after.iter().zip(&before).all(|(after, before)| *after < 1.05 * before), "{before:?} {after:?}");
    let identified = numbers(&said["identified"]["rms"]["validate"]);
    assert!((identified[4] / before[4] - 1.0).abs() < 0.1, "{identified:?} {before:?}");

    // The text says the same, and the file is a robot with the cause in it.
    assert!(run.out.contains("gear_coupling on joints 6, 5") && run.out.contains("identified"), "{}", run.out);
    assert!(read_robot(&out).has_effects());
    assert!(std::fs::read_to_string(&out).unwrap().contains("gear_coupling"));
    let checked = denavit(&["check", &out]);
    assert_eq!(checked.status, Some(0), "{}", checked.err);
    let page = std::fs::read_to_string(&page).unwrap();
    assert!(page.contains("gear coupling") && page.contains("</html>"));
    // Each warning stands at the top, before the causes.
    let (top, _) = page.split_once(">Causes</h2>").expect("a heading of the causes");
    for warning in run.out.lines().filter_map(|line| line.strip_prefix("warning of the identification: ")) {
        let shown = warning.replace('&', "&amp;").replace('<', "&lt;").replace('\'', "&#39;");
        assert!(top.contains(&shown), "{warning}");
    }
}

#[test]
fn what_was_fitted_is_not_measured_on() {
    let run = denavit(&["calibrate", ROBOT, FIRST, "--validate", FIRST]);
    assert_eq!(run.status, Some(2));
    assert!(run.err.contains("the same samples"), "{}", run.err);
    let run = denavit(&["calibrate", ROBOT, FIRST]);
    assert_eq!(run.status, Some(2));
    assert!(run.err.contains("--validate"), "{}", run.err);
    // An output in the place of an input.
    let run = denavit(&["calibrate", ROBOT, FIRST, "--validate", LAST, "--out", FIRST]);
    assert_eq!(run.status, Some(2));
}
