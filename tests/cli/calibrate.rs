//! Tests of `denavit calibrate` on a real recording: the excerpt in `data/`, against published
//! values.

use std::sync::OnceLock;

use super::{Run, denavit, folder, numbers, read_robot};

const ROBOT: &str = "robots/staubli-tx40.yaml";
const FIRST: &str = "data/staubli-tx40/first.csv.gz";
const SECOND: &str = "data/staubli-tx40/second.csv.gz";
const LAST: &str = "data/staubli-tx40/last.csv.gz";

/// Result of the README's command, with outputs in a folder of the test.
struct Story {
    run: Run,
    said: serde_json::Value,
    out: String,
    page: String,
    /// Paragraphs before and after the command.
    text: [String; 2],
}

fn story() -> &'static Story {
    static ONCE: OnceLock<Story> = OnceLock::new();
    ONCE.get_or_init(|| {
        let readme = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/README.md")).unwrap();
        let (before, rest) = readme.split_once("cargo run --release -- ").unwrap();
        let (command, after) = rest.split_once("```").unwrap();
        let paragraph = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
        let text = [before.rsplit("\n\n").nth(1), after.trim_start().split("\n\n").next()];
        let place = folder("calibrate");
        let [out, page, json] = ["robot.yaml", "page.html", "said.json"].map(|name| place.join(name));
        let [out, page, json] = [out, page, json].map(|path| path.display().to_string());
        let command = command.replace('\\', " ").replace("calibrated.yaml", &out).replace("calibrated.html", &page);
        let run = denavit(&[&command.split_whitespace().collect::<Vec<_>>()[..], &["--json", &json]].concat());
        assert_eq!(run.status, Some(0), "{}", run.err);
        let said = serde_json::from_str(&std::fs::read_to_string(&json).unwrap()).unwrap();
        Story { run, said, out, page, text: text.map(|text| paragraph(text.unwrap())) }
    })
}

/// Numbers in a text, with the unit of the last digit of each.
fn figures(text: &str) -> Vec<(f64, f64)> {
    let words = text.split_whitespace().map(|word| word.trim_end_matches(['.', ',', ';', ':']));
    let digits = |word: &str| word.split_once('.').map_or(0, |(_, digits)| digits.len() as i32);
    words.filter_map(|word| Some((word.parse::<f64>().ok()?, 0.1_f64.powi(digits(word))))).collect()
}

/// Each figure is within one unit of its last digit: processors differ in the last bits, and a
/// larger change is significant.
#[test]
fn the_story_of_the_readme_has_the_figures_of_its_command() {
    let Story { said, text: [before, after], .. } = story();
    let error = |model: &serde_json::Value, joint: usize| {
        100.0 * numbers(&model["rms"]["validate"])[joint - 1] / numbers(&said["torque_rms"])[joint - 1]
    };
    let (baseline, extended) = (&said["baseline"], &said["extended"]);
    let cause = likeliest(said);
    // Coulomb friction of the shared motor may be in an entry of its own.
    let couplings = || said["causes"].as_array().unwrap().iter().filter(|c| c["cause"] == "gear_coupling");
    let value = |key: &str| {
        let of = |joint: u32| couplings().find_map(|c| c["parameters"][format!("{key}{joint}")].as_f64());
        of(6).or(of(5)).unwrap_or(f64::NAN)
    };
    let mut joints = numbers(&cause["joints"]);
    joints.sort_by(f64::total_cmp);
    // Published values, from data/README.md.
    let published = [0.0077, 0.616, 1.956];
    let wanted = [
        &[5.0, error(baseline, 5), 6.0, error(baseline, 6), error(extended, 5), error(extended, 6)][..],
        &[cause["probability"].as_f64().unwrap()],
        &joints,
        &[value("IAM"), value("FVM"), value("FCM")],
        &published,
    ]
    .concat();
    check(after, &wanted);
    let rust = env!("CARGO_PKG_RUST_VERSION").parse().unwrap();
    let [first, second, last] = [FIRST, SECOND, LAST].map(seconds);
    // The computing time is not checked.
    check(before.split(", then takes").next().unwrap(), &[first + second, last, rust]);
}

/// The most probable cause, which the text's first line names.
fn likeliest(said: &serde_json::Value) -> &serde_json::Value {
    let probability = |cause: &serde_json::Value| cause["probability"].as_f64().unwrap();
    let all = said["causes"].as_array().unwrap();
    all.iter().max_by(|a, b| probability(a).total_cmp(&probability(b))).unwrap()
}

/// Duration of a packed log, s.
fn seconds(path: &str) -> f64 {
    let file = std::fs::File::open(std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join(path)).unwrap();
    let text = std::io::read_to_string(flate2::read::GzDecoder::new(file)).unwrap();
    let times: Vec<f64> = text.lines().skip(1).map(|line| line.split(',').next().unwrap().parse().unwrap()).collect();
    times[times.len() - 1] - times[0]
}

fn check(text: &str, wanted: &[f64]) {
    let written = figures(text);
    assert_eq!(written.len(), wanted.len(), "{text}\n{wanted:?}");
    for ((written, unit), wanted) in written.into_iter().zip(wanted) {
        assert!((written - wanted).abs() <= unit, "README: {written}, the command: {wanted}\n{text}");
    }
}

#[test]
fn a_recording_becomes_a_model_with_the_coupling_of_the_wrist() {
    let Story { run, said, out, page, .. } = story();

    // The motor of joint 6 turns with joint 5, which is not in the robot file (data/README.md).
    let first = likeliest(said);
    assert_eq!(first["cause"], "gear_coupling");
    let mut joints = numbers(&first["joints"]);
    joints.sort_by(f64::total_cmp);
    assert_eq!(joints, [5.0, 6.0]);
    // The source publishes 0.616 N m s/rad and 1.956 N m.
    let viscous = first["parameters"]["FVM6"].as_f64().unwrap();
    // Coulomb friction of the shared motor may be in an entry of its own.
    let couplings = said["causes"].as_array().unwrap().iter().filter(|c| c["cause"] == "gear_coupling");
    let dry = couplings.flat_map(|c| ["FCM6", "FCM5"].map(|key| c["parameters"][key].as_f64()));
    let dry = dry.flatten().next().unwrap();
    assert!((viscous - 0.616).abs() < 0.1 && (dry - 1.956).abs() < 0.4, "{viscous} {dry}");

    // Errors on a part of the run to which nothing was fitted.
    let [before, after] = ["baseline", "extended"].map(|model| numbers(&said[model]["rms"]["validate"]));
    for joint in [4, 5] {
        assert!(after[joint] < 0.5 * before[joint], "joint {}: {before:?} {after:?}", joint + 1);
    }
    assert!(after.iter().zip(&before).all(|(after, before)| *after < 1.05 * before), "{before:?} {after:?}");
    let identified = numbers(&said["identified"]["rms"]["validate"]);
    assert!((identified[4] / before[4] - 1.0).abs() < 0.1, "{identified:?} {before:?}");

    // The text agrees, and the file is a robot with the cause in it.
    assert!(run.out.contains("gear_coupling on joints 6, 5") && run.out.contains("identified"), "{}", run.out);
    assert!(read_robot(out).has_effects());
    assert!(std::fs::read_to_string(out).unwrap().contains("gear_coupling"));
    let checked = denavit(&["check", out]);
    assert_eq!(checked.status, Some(0), "{}", checked.err);
    let page = std::fs::read_to_string(page).unwrap();
    assert!(page.contains("gear coupling") && page.contains("</html>"));
    // Each warning is at the top, before the causes.
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
    // An output with the path of an input.
    let run = denavit(&["calibrate", ROBOT, FIRST, "--validate", LAST, "--out", FIRST]);
    assert_eq!(run.status, Some(2));
}
