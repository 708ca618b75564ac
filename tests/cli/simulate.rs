//! Tests of `denavit simulate`: logs for `identify`, identical for the same seed, and messages for
//! mistakes.

use super::*;

const ROBOT: &str = "robots/planar2r.yaml";

/// A motion of two joints, at rest at both ends.
fn motion(folder: &std::path::Path, seconds: f64) -> String {
    let rows = (seconds / 0.02).round() as usize;
    let mut text = String::from("t,q1,q2\n");
    for k in 0..=rows {
        let t = k as f64 * 0.02;
        let window = (std::f64::consts::PI * t / seconds).sin().powi(2);
        let (a, b) = ((2.0 * t).sin() + 0.4 * (5.1 * t).sin(), (3.1 * t).cos());
        text += &format!("{t},{},{}\n", 1.2 * window * a, 0.9 * window * b);
    }
    file(folder, "motion.csv", text)
}

#[test]
fn a_simulated_log_identifies_without_a_warning() {
    let folder = folder("simulate-identify");
    let (motion, log) = (motion(&folder, 8.0), folder.join("log.csv.gz").display().to_string());
    let run = denavit(&["simulate", ROBOT, "--trajectory", &motion, "--out", &log, "--seed", "3"]);
    assert_eq!(run.status, Some(0), "{}", run.err);
    assert!(run.err.is_empty(), "{}", run.err);
    assert!(run.out.contains("real time") && run.out.contains("8001 samples"), "{}", run.out);
    let other = folder.join("other.csv").display().to_string();
    assert_eq!(denavit(&["simulate", ROBOT, "--trajectory", &motion, "--out", &other, "--seed", "4"]).status, Some(0));
    let found = json(&["identify", ROBOT, &log, "--validate", &other, "--json", "-"]);
    // The file's own friction is identified again.
    for (name, expected) in [("FV1", 0.1), ("FC1", 0.2), ("FV2", 0.05), ("FC2", 0.1)] {
        let list = found["parameters"].as_array().unwrap();
        let value = list.iter().find(|p| p["name"] == name).unwrap()["value"].as_f64().unwrap();
        assert!((value - expected).abs() < 0.02, "{name} {value}");
    }
    let rms = numbers(&found["rms"]["validate"]);
    assert!(rms.iter().all(|r| *r < 0.06), "{rms:?}");
    let check = denavit(&["identify", ROBOT, &log, "--validate", &other]);
    assert!(!check.out.contains("warning") && check.err.is_empty(), "{}{}", check.out, check.err);
}

#[test]
fn the_same_seed_gives_the_same_bytes() {
    let folder = folder("simulate-seed");
    let motion = motion(&folder, 2.0);
    let effects = file(
        &folder,
        "effects.yaml",
        "joints: { elbow: { backlash: {}, presliding_hysteresis: {} }, 1: { torque_ripple: { RN: 20, RC: 0.1 } } }\n\
         sensors: { rate: 500, dq: true, torque: link, temp: true }\n",
    );
    let log = |name: &str, seed: &str| {
        let out = folder.join(name).display().to_string();
        let arguments =
            ["simulate", ROBOT, "--trajectory", &motion, "--out", &out, "--effects", &effects, "--seed", seed];
        let report = json(&[&arguments[..], &["--json", "-"]].concat());
        assert_eq!(report["samples"], 1001);
        (std::fs::read(&out).unwrap(), report)
    };
    let (a, b, c) = (log("a.csv", "1"), log("b.csv", "1"), log("c.csv", "2"));
    assert!(a == b && a.0 != c.0);
    let header = String::from_utf8_lossy(&a.0).lines().next().unwrap().to_string();
    assert_eq!(header, "t,q1,q2,dq1,dq2,tau1,tau2,taum1,taum2,qd1,qd2,temp1,temp2");
}

#[test]
fn a_free_swing_needs_no_trajectory() {
    let folder = folder("simulate-free");
    let log = folder.join("swing.csv").display().to_string();
    let run = denavit(&["simulate", ROBOT, "--free", "1", "--start", "-0.3,0.4", "--out", &log]);
    assert_eq!(run.status, Some(0), "{}", run.err);
    assert_eq!(std::fs::read_to_string(&log).unwrap().lines().count(), 1002);
    let both = ["--free", "1", "--start", "-0.3,0.4", "--trajectory", "motion.csv", "--out", &log];
    let run = denavit(&[&["simulate", ROBOT], &both[..]].concat());
    assert_eq!(run.status, Some(2), "{}", run.err);
    assert!(run.err.contains("--trajectory has no effect here"), "{}", run.err);
}

/// Warnings about a motion are in the JSON too.
#[test]
fn doubts_are_in_the_json() {
    let folder = folder("simulate-doubts");
    let fast = "t,q1,q2\n0,0,0\n0.1,3,0\n0.2,0,0\n0.3,3,0\n";
    let (motion, log) = (file(&folder, "fast.csv", fast), folder.join("log.csv").display().to_string());
    let run = denavit(&["simulate", ROBOT, "--trajectory", &motion, "--control", "exact", "--out", &log]);
    assert_eq!(run.status, Some(0), "{}", run.err);
    let arguments = ["simulate", ROBOT, "--trajectory", &motion, "--control", "exact", "--out", &log, "--json", "-"];
    let found = json(&arguments);
    let warnings = strings(&found["warnings"]);
    assert!(!warnings.is_empty(), "{}", run.err);
    for warning in warnings {
        let said = warning.split_once(": ").unwrap().1;
        assert!(run.err.contains(said), "{warning}: {}", run.err);
    }
}

/// A prismatic joint: the SCARA arm's own links, from a file to a log and back.
#[test]
fn a_scara_arm_is_simulated_and_identified() {
    let folder = folder("simulate-scara");
    let mut text = String::from("t,q1,q2,q3,q4\n");
    for k in 0..=800 {
        let t = f64::from(k) * 0.01;
        let window = (std::f64::consts::PI * t / 8.0).sin().powi(2);
        let (a, b) = ((3.0 * t).sin() + 0.4 * (7.1 * t).sin(), (4.1 * t).cos());
        let (c, d) = ((5.3 * t).sin(), (6.7 * t).sin() - 0.3 * (2.0 * t).cos());
        text += &format!("{t},{},{},{},{}\n", 0.9 * window * a, window * b, 0.1 + 0.06 * window * c, 2.0 * window * d);
    }
    let motion = file(&folder, "motion.csv", text);
    let log = folder.join("log.csv").display().to_string();
    let run = denavit(&["simulate", "robots/scara.yaml", "--trajectory", &motion, "--out", &log, "--seed", "2"]);
    assert_eq!(run.status, Some(0), "{}", run.err);
    let found = json(&["identify", "robots/scara.yaml", &log, "--json", "-"]);
    for parameter in found["parameters"].as_array().unwrap() {
        let number = |key: &str| parameter[key].as_f64().unwrap();
        let (value, prior) = (number("value"), number("prior"));
        let std = 0.01 * number("relative_std_percent") * value.abs();
        assert!((value - prior).abs() < 5.0 * std + 0.01 * prior.abs(), "{parameter}");
    }
}

#[test]
fn mistakes_are_told_and_mended() {
    let folder = folder("simulate-mistakes");
    let (motion, log) = (motion(&folder, 2.0), folder.join("log.csv").display().to_string());
    let three = file(&folder, "three.csv", "t,q1,q2,q3\n0,0,0,0\n1,1,1,1\n");
    let back = file(&folder, "back.csv", "t,q1,q2\n0,0,0\n1,1,1\n0.5,1,1\n");
    let text = file(&folder, "text.csv", "t,q1,q2\n0,0,0\n1,one,1\n");
    let key = file(&folder, "key.yaml", "joints: { 1: { backlash: { width: 1 } } }\n");
    let law = file(&folder, "law.yaml", "joints: { 1: { stribeck_friction: { FS: 1, VS: 0 } } }\n");
    let coupled = file(&folder, "coupled.yaml", "joints: { 1: { gear_coupling: { joint: 1 } } }\n");
    let sensors = file(&folder, "sensors.yaml", "sensors: { torque_noise: [1, 2, 3] }\n");
    let torque = file(&folder, "torque.yaml", "control: { mode: torque }\n");
    for (robot, trajectory, effects, expected) in [
        ("robots/kuka-lbr-med7.yaml", &motion, None, "7 in the robot file"),
        ("robots/staubli-tx40.yaml", &motion, None, "6 in the robot file"),
        (ROBOT, &three, None, "is 3 in the trajectory"),
        (ROBOT, &back, None, "does not ascend at row 3: 1 s, then 0.5 s"),
        (ROBOT, &text, None, "line 3, column q1: `one` is not a finite number"),
        (ROBOT, &motion, Some(&key), "the keys of backlash are BL (rad)"),
        (ROBOT, &motion, Some(&law), "VS of stribeck_friction is 0; help: it must be greater than 0"),
        (
            ROBOT,
            &motion,
            Some(&coupled),
            "gear_coupling of joint 1: joint is 1; it must be the number of another joint",
        ),
        (
            ROBOT,
            &motion,
            Some(&sensors),
            "sensors.torque_noise has 3 values; write one, or one for each of the 2 joints",
        ),
        (ROBOT, &motion, Some(&torque), "plays the columns tau1..tau2 of the trajectory, and it has none"),
    ] {
        let mut arguments = vec!["simulate", robot, "--trajectory", trajectory, "--out", &log];
        if let Some(effects) = effects {
            arguments.extend(["--effects", effects]);
        }
        let run = denavit(&arguments);
        assert_eq!(run.status, Some(2), "{expected}: {}", run.err);
        assert!(run.err.contains(expected), "{expected}: {}", run.err);
    }
    let plain = |text: &str| file(&folder, "one.yaml", text);
    for (text, expected) in [
        ("sensors: { rate: -1000 }", "sensors.rate is -1000; it must be greater than 0, and at most 100000 Hz"),
        (
            "sensors: { rate: 500, jitter: 0.001 }",
            "sensors.jitter is 0.001; it must be from 0 s to 0.45 sampling periods",
        ),
        ("sensors: { rate: 0.1 }", "raise sensors.rate, or give a longer motion"),
        ("joints: { 1: { coulomb_friction: -5 } }", "coulomb_friction of joint 1: FC, the file's included, is -4.8"),
        ("joints: { 1: { viscous_friction: -5 } }", "viscous_friction of joint 1: FV, the file's included, is -4.9"),
        (
            "joints: { 1: { nonlinear_viscous_friction: { FN: -1 } } }",
            "FN of nonlinear_viscous_friction is -1; help: it must not be negative",
        ),
        (
            "joints: { 1: { presliding_hysteresis: { HC: -1 } } }",
            "HC of presliding_hysteresis is -1; help: it must not be negative",
        ),
        ("effects: { time_delay: { TD: 1e6 } }", "TD of time_delay is 1000000; help: it must be from -10 to 10 s"),
        ("effects: { base_tilt: { roll: 400 } }", "one.yaml:1:31: effects.base_tilt.roll: roll of base_tilt is 400"),
        ("joints: { 1: { encoder_offset: 400 } }", "QO of encoder_offset is 400; help: it must be from -6.28"),
        ("joints: { 1: { backlash: {} }, shoulder: {} }", "joint 1 stands at line 1, column 11 already (joints.1)"),
        (
            "joints: [ { joint: 1, backlash: {} }, { joint: 1 } ]",
            "joint 1 stands at line 1, column 20 already (joints[1])",
        ),
        (
            "effects: { external_contact: { start: 5, end: 1 } }",
            "external_contact.end is 1; it must be later than start",
        ),
        ("effects: { external_contact: { k: 1000 } }", "k makes a wall, but it has no normal; write nx, ny, nz"),
        ("effects: { external_contact: { nz: 1 } }", "but it has no stiffness; write k in N/m"),
        ("effects: { link_inertia_error: { link: 9 } }", "there is no link 9; write the number of a link, 1 to 2"),
        ("effects: { payload: { M: -50 } }", "planar2r.yaml with"),
    ] {
        let run = denavit(&["simulate", ROBOT, "--trajectory", &motion, "--out", &log, "--effects", &plain(text)]);
        assert_eq!(run.status, Some(2), "{text}: {}", run.err);
        assert!(run.err.contains(expected) && run.err.contains("one.yaml"), "{text}: {}", run.err);
    }
    let unnamed = file(&folder, "unnamed.csv", "t,a,b\n0,0,0\n1,0,0\n");
    let run = denavit(&["simulate", ROBOT, "--trajectory", &unnamed, "--out", &log]);
    assert!(run.err.contains("unnamed.csv, line 1: there is no column q1; there are t, a, b"), "{}", run.err);
    for (arguments, expected) in
        [(["-1", "0,0"], "--free -1: seconds, more than 0"), (["1", "nan,0"], "--start has a value NaN")]
    {
        let [free, start] = arguments;
        let run = denavit(&["simulate", ROBOT, "--free", free, "--start", start, "--out", &log]);
        assert_eq!(run.status, Some(2), "{expected}: {}", run.err);
        assert!(run.err.contains(expected), "{expected}: {}", run.err);
    }
    let nowhere =
        denavit(&["simulate", "robots/kuka-lbr-med7.yaml", "--free", "1", "--start", "0,0,0,0,0,0,0", "--out", &log]);
    assert_eq!(nowhere.status, Some(2));
    assert!(nowhere.err.contains("has no `links`; add a `links:` list"), "{}", nowhere.err);
}

#[test]
fn coefficients_are_the_motion() {
    let folder = folder("simulate-coefficients");
    let path = |name: &str| folder.join(name).display().to_string();
    let exact =
        file(&folder, "exact.yaml", "control: { mode: exact }\nsensors: { rate: 100, encoder: 0, torque_noise: 0 }\n");
    for kind in [&["--spacing", "1"][..], &["--fourier", "3", "--periods", "2"]] {
        let (csv, coefficients) = (path("motion.csv"), path("motion.json"));
        let design = ["excite", ROBOT, "--duration", "3", "--starts", "2", "--iterations", "4", "--rate", "1000"];
        let run = denavit(&[&design[..], kind, &["--out", &csv, "--coefficients", &coefficients]].concat());
        assert_eq!(run.status, Some(0), "{}", run.err);
        let logs = [&csv, &coefficients].map(|motion| {
            let log = path("log.csv");
            let run = denavit(&["simulate", ROBOT, "--trajectory", motion, "--effects", &exact, "--out", &log]);
            assert!(run.status == Some(0) && !run.err.contains("slope"), "{}", run.err);
            let text = std::fs::read_to_string(&log).unwrap();
            let rows =
                text.lines().skip(1).map(|l| l.split(',').map(|x| x.parse::<f64>().unwrap()).collect::<Vec<_>>());
            rows.collect::<Vec<_>>()
        });
        assert!(logs[0].len() >= 300 && logs[0].len() == logs[1].len(), "{} {}", logs[0].len(), logs[1].len());
        let largest = |k: usize| logs[0].iter().zip(&logs[1]).map(|(a, b)| (a[k] - b[k]).abs()).fold(0.0, f64::max);
        assert!((0..3).all(|k| largest(k) < 1e-8), "{:?}", [1, 2].map(largest));
        // t q1 q2 tau1 tau2; at rest friction may be anything between its levels.
        let apart = (0..logs[0].len()).filter(|&s| (3..5).any(|k| (logs[0][s][k] - logs[1][s][k]).abs() > 1e-5));
        assert!(apart.count() < 8);
    }
    let other = file(&folder, "other.json", "{\"kind\": \"circle\"}");
    let run = denavit(&["simulate", ROBOT, "--trajectory", &other, "--out", &path("log.csv")]);
    assert_eq!(run.status, Some(2));
    assert!(run.err.contains("other.json") && run.err.contains("excite --coefficients"), "{}", run.err);
    // A period in ms, and one too long for any number of rows.
    for period in ["10000", "1e300"] {
        let zeros = "[[0],[0],[0],[0],[0],[0],[0]]";
        let text = format!(
            r#"{{"kind":"fourier","period":{period},"periods":10,"center":[0,0,0,0,0,0,0],"sine":{zeros},"cosine":{zeros}}}"#
        );
        let long = file(&folder, "long.json", text);
        let run = denavit(&["simulate", "robots/kuka-lwr4.yaml", "--trajectory", &long, "--out", &path("long.csv")]);
        assert_eq!(run.status, Some(2), "{}", run.err);
        assert!(run.err.contains("long.json") && run.err.contains("10000 s at most"), "{}", run.err);
    }
}
