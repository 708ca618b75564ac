//! Tests of `denavit diagnose` on logs of the simulated robot.

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};
#[cfg(target_os = "linux")]
use std::process::Command;

use serde_json::Value;

use super::denavit;

fn folder(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("diagnose").join(name);
    fs::create_dir_all(&path).unwrap();
    path
}

/// Writes a motion: sums of sines on all joints, starting at rest.
fn motion(path: &Path, dof: usize, seconds: f64, seed: f64) {
    let mut text = String::from("t");
    (1..=dof).for_each(|j| write!(text, ",q{j}").unwrap());
    text.push('\n');
    let rate = 100.0;
    for k in 0..(seconds * rate) as usize {
        let t = k as f64 / rate;
        // Grows from zero, so that the controller does not have to jump.
        let s = (t / 1.5).min(1.0);
        let grow = s * s * s * (10.0 - 15.0 * s + 6.0 * s * s);
        write!(text, "{t}").unwrap();
        for j in 0..dof {
            let f = |n: f64| {
                (std::f64::consts::TAU * (0.11 * n + 0.013 * j as f64 + 0.003 * seed) * t + n + seed + j as f64).sin()
            };
            write!(text, ",{}", grow * (0.5 * f(1.0) + 0.25 * f(2.0) + 0.12 * f(4.0))).unwrap();
        }
        text.push('\n');
    }
    fs::write(path, text).unwrap();
}

fn simulate(place: &Path, name: &str, motion: &Path, effects: &str, seed: &str) -> String {
    let (file, log) = (place.join(format!("{name}.effects.yaml")), place.join(format!("{name}.csv")));
    fs::write(&file, effects).unwrap();
    let (file, motion, log) = (file.to_str().unwrap(), motion.to_str().unwrap(), log.to_str().unwrap());
    let run = denavit(&[
        "simulate",
        "robots/kuka-lwr4.yaml",
        "--trajectory",
        motion,
        "--out",
        log,
        "--effects",
        file,
        "--seed",
        seed,
    ]);
    assert_eq!(run.status, Some(0), "{}", run.err);
    log.to_string()
}

fn diagnosis(name: &str, effect: &str) -> (Value, String) {
    let place = folder(name);
    let effects = format!("{effect}\nsensors: {{ rate: 500, torque_noise: 0.05 }}\n");
    let (one, two) = (place.join("one.csv"), place.join("two.csv"));
    motion(&one, 7, 10.0, 1.0);
    motion(&two, 7, 6.0, 2.0);
    let fit = simulate(&place, "fit", &one, &effects, "1");
    let validate = simulate(&place, "validate", &two, &effects, "2");
    let out = place.join("extended.yaml");
    let out = out.to_str().unwrap();
    let run =
        denavit(&["diagnose", "robots/kuka-lwr4.yaml", &fit, "--validate", &validate, "--out", out, "--json", "-"]);
    assert_eq!(run.status, Some(0), "{}", run.err);
    let found = serde_json::from_str(&run.out).unwrap();
    rejected_are_not_named(&found);
    (found, out.to_string())
}

/// Each rejected cause has its reason, and is not among the named ones.
fn rejected_are_not_named(found: &Value) {
    let named: Vec<[&Value; 2]> =
        found["causes"].as_array().unwrap().iter().map(|c| [&c["cause"], &c["joints"]]).collect();
    for rejected in found["rejected"].as_array().unwrap() {
        assert!(rejected["why"].as_str().unwrap().starts_with("is not "), "{rejected:#}");
        assert!(rejected["probability"].as_f64().is_none_or(|p| (0.0..1.0).contains(&p)), "{rejected:#}");
        assert!(!named.contains(&[&rejected["cause"], &rejected["joints"]]), "{rejected:#}");
    }
}

#[test]
fn nothing_hidden_is_nothing_wrong() {
    let (found, _) = diagnosis("nothing", "joints: {}");
    assert_eq!(found["verdict"], "nothing_wrong", "{found:#}");
    assert_eq!(found["causes"].as_array().unwrap().len(), 0);
    for j in 0..7 {
        let (noise, error) =
            (found["noise_floor"][j].as_f64().unwrap(), found["extended"]["rms"]["validate"][j].as_f64().unwrap());
        // Every sample counts, also at reversals, where the file's law takes the sign of a velocity
        // within its noise.
        assert!((0.8..1.2).contains(&(noise / 0.05)) && error < 1.5 * noise, "joint {}: {noise} {error}", j + 1);
    }
}

/// Candidates, refinements and folds run on all cores; one core gives the same bytes.
#[cfg(target_os = "linux")]
#[test]
fn one_core_gives_the_bits_of_all() {
    let place = folder("cores");
    let effects = "joints: { 3: { joint_spring: { KS: 8, QS: 0.2 } } }\nsensors: { rate: 250, torque_noise: 0.05 }\n";
    let path = place.join("motion.csv");
    motion(&path, 7, 8.0, 4.0);
    let log = simulate(&place, "log", &path, effects, "6");
    let arguments = ["diagnose", "robots/kuka-lwr4.yaml", &log, "--json", "-"];
    let all = denavit(&arguments);
    let one = Command::new("taskset")
        .args(["-c", "0", env!("CARGO_BIN_EXE_denavit")])
        .args(arguments)
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output();
    // Not every machine has `taskset` or lets processes use it.
    let Some(one) = one.ok().filter(|run| run.status.success()) else { return };
    assert_eq!(all.status, Some(0), "{}", all.err);
    assert_eq!(String::from_utf8(one.stdout).unwrap(), all.out);
    assert!(all.out.contains("joint_spring"));
}

#[test]
fn a_hidden_ripple_comes_back_in_the_robot_file() {
    let (found, out) = diagnosis("ripple", "joints: { 4: { torque_ripple: { RN: 20, RC: 0.3, RS: 0.2 } } }");
    let first = &found["causes"][0];
    assert_eq!(
        (first["cause"].as_str(), &first["joints"]),
        (Some("torque_ripple"), &serde_json::json!([4])),
        "{found:#}"
    );
    assert!((first["parameters"]["RC4"].as_f64().unwrap() - 0.3).abs() < 0.02);
    let gain = &first["gain"];
    assert!(gain["rms_after"][3].as_f64().unwrap() < 0.3 * gain["rms_before"][3].as_f64().unwrap());
    assert!(fs::read_to_string(&out).unwrap().contains("torque_ripple"));
    // Read back, the file is the proposed model.
    let written = &found["written"];
    assert_eq!(written["is_the_offered_model"], true, "{written}");
    for j in 0..7 {
        let [is, offered] = ["rms", "offered_rms"].map(|key| written[key]["validate"][j].as_f64().unwrap());
        assert!((is - offered).abs() < 0.02 * offered, "joint {}: {is} {offered}", j + 1);
    }
    let check = denavit(&["check", &out]);
    assert_eq!(check.status, Some(0), "{}", check.err);
}

#[test]
fn a_hidden_payload_is_the_whole_robots() {
    let (found, out) = diagnosis(
        "payload",
        "joints: {}\neffects: { payload: { M: 0.8, MSX: 0.02, MSZ: 0.1, XX: 0.02, YY: 0.02, ZZ: 0.003, XZ: -0.0025 } }",
    );
    let first = &found["causes"][0];
    assert_eq!((first["cause"].as_str(), &first["joints"]), (Some("payload"), &serde_json::json!([])), "{found:#}");
    assert!(first["not_distinguished_from"].as_array().unwrap().contains(&"link_inertia_error".into()));
    // No motion separates these two, so none is written.
    assert!(found["next_experiment"]["file"].is_null() && !Path::new(&out).with_extension("next.csv").exists());
}

/// Diagnosis of gear torques from torques on both sides: wrong links have no influence,
/// load-dependent friction uses the measured load, and no error is found in the written file.
#[test]
fn gears_are_diagnosed_by_the_torques_on_both_sides() {
    let place = folder("gears");
    let effects = "joints: { 2: { load_dependent_friction: { FL: 0.08 } }, 3: { rotor_inertia: { IA: 0.9 } }, 6: { coulomb_friction: { FC: 0.6 } } }
effects: { payload: { M: 1.5, MSX: 0.02, MSZ: 0.1, XX: 0.02, YY: 0.02, ZZ: 0.003, XZ: -0.0025 } }
sensors: { rate: 250, torque_noise: 0.05, torque: link }\n";
    let (one, two) = (place.join("one.csv"), place.join("two.csv"));
    motion(&one, 7, 10.0, 1.0);
    motion(&two, 7, 6.0, 2.0);
    let fit = simulate(&place, "fit", &one, effects, "1");
    let validate = simulate(&place, "validate", &two, effects, "2");
    let out = place.join("extended.yaml");
    let out = out.to_str().unwrap();
    let diagnosis = |robot: &str, more: &[&str]| {
        let run = denavit(&[&["diagnose", robot, "--json", "-"], more].concat());
        assert_eq!(run.status, Some(0), "{}", run.err);
        serde_json::from_str::<Value>(&run.out).unwrap()
    };
    let both = [&fit, "--validate", &validate, "--transmission"];
    let found = diagnosis("robots/kuka-lwr4.yaml", &[&both[..], &["--out", out]].concat());
    let causes = found["causes"].as_array().unwrap();
    let mut named: Vec<(&str, u64)> =
        causes.iter().map(|c| (c["cause"].as_str().unwrap(), c["joints"][0].as_u64().unwrap())).collect();
    named.sort_unstable();
    assert_eq!(named, [("coulomb_friction", 6), ("load_dependent_friction", 2), ("rotor_inertia", 3)], "{found:#}");
    let value = |key: &str| causes.iter().find_map(|c| c["parameters"][key].as_f64()).unwrap();
    for (key, true_value, within) in [("FL2", 0.08, 0.002), ("IA3", 0.9, 0.02), ("FC6", 0.16 + 0.6, 0.02)] {
        assert!((value(key) - true_value).abs() < within, "{key}: {}", value(key));
    }
    assert_eq!((&found["transmission"], &found["links_refitted"]), (&Value::Bool(true), &Value::Bool(false)));
    assert_eq!(diagnosis(out, &both)["verdict"], "nothing_wrong");
    // Its links are those of the original file.
    let links = |path: &str| {
        let text = fs::read_to_string(path).unwrap();
        text.split("\nlinks:").nth(1).unwrap().split("\n#").next().unwrap().lines().nth(1).unwrap().to_string()
    };
    assert_eq!(links(out), links("robots/kuka-lwr4.yaml"));
    // A log with both torques gives a hint if only one of them is diagnosed.
    let warnings = diagnosis("robots/kuka-lwr4.yaml", &[&validate])["warnings"].to_string();
    assert!(warnings.contains("--transmission"), "{warnings}");
}

/// Torque columns in another order or unit are reported, and no other conclusion is drawn from
/// them.
#[test]
fn misread_torque_columns_are_named_before_any_cause() {
    let place = folder("misread");
    let log = super::identify::record(12, 41);
    let write = |name: &str, text: String| {
        let path = place.join(name);
        fs::write(&path, text).unwrap();
        path.display().to_string()
    };
    let header = log.lines().next().unwrap().replace("tau2", "TAU").replace("tau4", "tau2").replace("TAU", "tau4");
    let swapped = write("swapped.csv", log.replacen(log.lines().next().unwrap(), &header, 1));
    let scaled = |by: f64| {
        let rows = log.lines().skip(1).map(|line| {
            let cells = line.split(',').enumerate();
            let cells = cells.map(|(k, x)| if k > 7 { (by * x.parse::<f64>().unwrap()).to_string() } else { x.into() });
            cells.collect::<Vec<String>>().join(",")
        });
        std::iter::once(log.lines().next().unwrap().to_string()).chain(rows).collect::<Vec<_>>().join("\n") + "\n"
    };
    let (millis, degrees) = (write("millis.csv", scaled(1e3)), write("degrees.csv", scaled(57.29578)));
    for verb in ["diagnose", "force"] {
        for (log, words) in [(&swapped, "another order"), (&millis, "N mm"), (&degrees, "180/pi")] {
            let run = denavit(&[verb, "robots/kuka-lwr4.yaml", log]);
            assert_eq!(run.status, Some(2), "{verb} {log}: {}", run.out);
            assert!(run.err.contains(words) && !run.err.contains("negate"), "{verb} {log}: {}", run.err);
        }
    }
    let kept = denavit(&["force", "robots/kuka-lwr4.yaml", &swapped, "--keep", "misread"]);
    assert_eq!(kept.status, Some(0), "{}", kept.err);
    assert!(kept.out.contains("warning") && kept.out.contains("another order"), "{}", kept.out);
    let right = write("right.csv", log);
    let right = denavit(&["force", "robots/kuka-lwr4.yaml", &right]);
    assert!(right.status == Some(0) && !right.out.contains("another order"), "{}{}", right.out, right.err);
}

#[test]
fn bad_use_is_said_in_one_paragraph() {
    let run = denavit(&["diagnose", "robots/kuka-lwr4.yaml", "no-such.csv"]);
    assert_eq!(run.status, Some(2));
    assert!(run.err.contains("no-such.csv"), "{}", run.err);
    let run = denavit(&["diagnose", "robots/kuka-lwr4.yaml", "no-such.csv", "--rate", "1"]);
    assert!(run.status == Some(2) && run.err.contains("--rate"), "{}", run.err);
}
