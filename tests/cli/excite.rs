//! Tests of `denavit excite`: file formats, comparison of results with the numeric oracle, and
//! wrong uses.

use denavit::model::rigid_body::Numeric;
use dh_codegen::arm::param;
use nalgebra::DMatrix;

use super::*;

const ROBOT: &str = "robots/kuka-lwr4.yaml";
const QUICK: [&str; 6] = ["--duration", "4", "--starts", "2", "--iterations", "15"];

fn rows(path: &str) -> (Vec<String>, Vec<Vec<f64>>) {
    let text = std::fs::read_to_string(path).unwrap();
    let mut lines = text.lines();
    let header = lines.next().unwrap().split(',').map(String::from).collect();
    (header, lines.map(|l| l.split(',').map(|c| c.parse().unwrap()).collect()).collect())
}

#[test]
fn the_written_motion_is_what_the_json_says() {
    let folder = folder("excite");
    let path = |name: &str| folder.join(name).display().to_string();
    let (csv, coefficients, ros, page) = (path("m.csv"), path("m.json"), path("m.yaml"), path("m.html"));
    let files = ["--out", &csv, "--coefficients", &coefficients, "--ros", &ros, "--report", &page, "--json", "-"];
    let found = json(&[&["excite", ROBOT, "--criterion", "cond"], &QUICK[..], &files[..]].concat());
    assert_eq!(found["criterion"], "cond");
    assert_eq!(found["feasible"], true);
    assert!(found["seconds"].as_f64().unwrap() > 0.0);

    let (header, rows) = rows(&csv);
    let names = |p: &str| (1..=7).map(|j| format!("{p}{j}")).collect::<Vec<_>>();
    assert_eq!(header, [vec!["t".into()], names("q"), names("dq"), names("ddq")].concat());
    assert_eq!(rows.len(), 401);

    // Condition number of equation (9) by the oracle: the leaders' own columns of the numeric
    // regressor.
    let robot = read_robot(ROBOT);
    let numeric = Numeric::new(&robot);
    let standard: Vec<String> = param::standard(&robot).iter().map(|p| p.name()).collect();
    let leaders: Vec<usize> = found["columns"]
        .as_array()
        .unwrap()
        .iter()
        .map(|c| {
            let name = c.as_str().unwrap();
            standard.iter().position(|s| s == name || format!("{s}R") == name).unwrap()
        })
        .collect();
    let mut w = DMatrix::zeros(7 * rows.len(), leaders.len());
    for (s, row) in rows.iter().enumerate() {
        let full = numeric.regressor(&row[1..8], &row[8..15], &row[15..22]);
        for (k, &column) in leaders.iter().enumerate() {
            w.view_mut((7 * s, k), (7, 1)).copy_from(&full.column(column));
        }
    }
    let sigma = w.singular_values();
    let condition = sigma.max() / sigma.min();
    assert!((found["condition_number"].as_f64().unwrap() / condition - 1.0).abs() < 1e-3, "{condition} {found}");
    assert!((found["value"].as_f64().unwrap() / condition - 1.0).abs() < 1e-3);

    // The same motion from its coefficients, in the checker, and in ROS's format.
    let value = serde_json::from_str(&std::fs::read_to_string(&coefficients).unwrap()).unwrap();
    let motion = denavit::report::trajectory_of_json(&value).unwrap();
    for row in rows.iter().step_by(37) {
        let at = motion.at(row[0]);
        let all = at.q.iter().chain(&at.dq).chain(&at.ddq);
        all.zip(&row[1..]).for_each(|(a, b)| assert!((a - b).abs() < 1e-9));
    }
    let verdict = json(&["excite", ROBOT, "--check", &csv, "--json", "-"]);
    assert_eq!(verdict["feasible"], true, "{verdict}");
    let ros = std::fs::read_to_string(&ros).unwrap();
    assert!(ros.contains("joint_names: [\"A1\", \"A2\"") && ros.matches("time_from_start").count() == 401);
    let page = std::fs::read_to_string(&page).unwrap();
    assert!(page.contains("<canvas") || page.contains("id=arm"));
    assert!(!page.contains("http://") || page.matches("http://").count() == page.matches("http://www.w3.org").count());
    assert!(!page.contains("NaN"));

    // The same seed gives the same bytes.
    let again = path("again.csv");
    let run = denavit(
        &[&["excite", ROBOT, "--criterion", "cond", "--threads", "1"], &QUICK[..], &["--out", &again]].concat(),
    );
    assert_eq!(run.status, Some(0), "{}", run.err);
    assert_eq!(std::fs::read(&csv).unwrap(), std::fs::read(&again).unwrap());
}

#[test]
fn a_motion_for_another_robot_is_refused_by_name() {
    let folder = folder("excite_refused");
    let path = folder.join("m.csv").display().to_string();
    let run = denavit(&[&["excite", ROBOT], &QUICK[..], &["--out", &path]].concat());
    assert_eq!(run.status, Some(0), "{}", run.err);
    let run = denavit(&["excite", "robots/franka-panda.yaml", "--check", &path]);
    assert_eq!(run.status, Some(1));
    assert!(run.err.contains("position of J4"), "{}", run.err);
}

#[test]
fn wrong_uses_end_with_2() {
    let folder = folder("excite_wrong");
    let bad = file(&folder, "bad.csv", "t,q1,q2,q3,q4,q5,q6,q7\n0,0,0,0,0,0,0,x\n");
    let short = file(&folder, "short.csv", "t,q1\n0,0\n");
    let back = file(&folder, "back.csv", "t,q1,q2,q3,q4,q5,q6,q7\n0,0,0,0,0,0,0,0\n1,0,0,0,0,0,0,0\n1,0,0,0,0,0,0,0\n");
    let slow = file(&folder, "slow.yaml", "name: bare\nconvention: modified\njoints: [ { type: revolute } ]\n");
    for (arguments, says) in [
        (vec!["excite", ROBOT, "--duration", "-1"], "--duration"),
        (vec!["excite", ROBOT, "--duration", "NaN"], "--duration"),
        (vec!["excite", ROBOT, "--noise", "1,2"], "--noise"),
        (vec!["excite", ROBOT, "--log-rate", "1000"], "--noise"),
        (vec!["excite", ROBOT, "--noise", "1", "--log-rate", "0"], "--log-rate"),
        (vec!["excite", ROBOT, "--fourier", "3", "--target-std", "5"], "--fourier"),
        (vec!["excite", ROBOT, "--criterion", "best"], "--criterion"),
        (vec!["excite", ROBOT, "--duration", "500", "--spacing", "0.1"], "--spacing"),
        (vec!["excite", ROBOT, "--check", &bad], "line 2, column `q7`"),
        (vec!["excite", ROBOT, "--check", &short], "`q2`"),
        (vec!["excite", ROBOT, "--check", &back], "time does not ascend"),
        (vec!["excite", ROBOT, "--check", "nowhere.csv"], "nowhere.csv"),
        (vec!["excite", &slow], "`velocity`"),
    ] {
        let run = denavit(&arguments);
        assert_eq!(run.status, Some(2), "{arguments:?}: {}", run.err);
        assert!(run.err.contains(says), "{arguments:?}: {}", run.err);
    }
}

#[test]
fn what_the_file_does_not_say_is_said_once() {
    let folder = folder("excite_said");
    let path = folder.join("m.csv").display().to_string();
    let quick = ["--duration", "2", "--starts", "1", "--iterations", "4"];
    let run = denavit(&[&["excite", ROBOT], &quick[..]].concat());
    let notes: Vec<&str> = run.err.lines().filter(|l| l.contains("acceleration")).collect();
    assert!(
        matches!(notes[..], [line] if line.contains("A1 3.840, A2 3.840") && line.contains("A7 6.423")),
        "{}",
        run.err
    );
    // The same warning in JSON and page.
    let page = folder.join("m.html").display().to_string();
    let found = json(&[&["excite", ROBOT, "--report", &page, "--json", "-"], &quick[..]].concat());
    let warnings = strings(&found["warnings"]);
    assert!(matches!(warnings[..], [one] if one.contains("A1 3.840, A2 3.840")), "{warnings:?}");
    assert!(std::fs::read_to_string(&page).unwrap().contains("A1 3.840, A2 3.840"));
    let run = denavit(&[&["excite", "robots/planar2r.yaml", "--out", &path], &quick[..]].concat());
    assert_eq!(run.status, Some(0), "{}", run.err);
    assert!(run.err.contains("self-collision are not checked"), "{}", run.err);
    let run = denavit(&["excite", "robots/planar2r.yaml", "--check", &path]);
    assert!(run.out.contains("not checked: self-collision"), "{}", run.out);
    let verdict = json(&["excite", "robots/planar2r.yaml", "--check", &path, "--json", "-"]);
    assert!(verdict["unchecked"].as_array().unwrap().len() >= 2, "{verdict}");
    assert!(strings(&verdict["warnings"]).iter().any(|w| w.contains("self-collision")), "{verdict}");
}

#[test]
fn options_without_effect_are_refused() {
    for (arguments, option) in [
        (&["--periods", "5"][..], "--periods"),
        (&["--fourier", "3", "--spacing", "0.5"], "--spacing"),
        (&["--noise", "1", "--log-rate", "500", "--cutoff", "5"], "--cutoff"),
        (&["--tool", "--links-only"], "--links-only"),
        (&["--rate", "50"], "--rate"),
        (&["--check", "m.csv", "--seed", "3"], "--seed"),
        (&["--check", "m.csv", "--out", "n.csv"], "--out"),
    ] {
        let run = denavit(&[&["excite", ROBOT], arguments].concat());
        assert_eq!(run.status, Some(2), "{arguments:?}: {}", run.err);
        assert!(run.err.contains(&format!("{option} has no effect here")), "{arguments:?}: {}", run.err);
    }
}

/// `--target-std` is met: errors of the parameters identified from the motion, played with that
/// noise, are as large as predicted.
#[test]
fn what_is_promised_is_found_again() {
    let folder = folder("excite_promise");
    let path = |name: &str| folder.join(name).display().to_string();
    let (motion, log) = (path("motion.csv"), path("log.csv"));
    let sensors = file(&folder, "sensors.yaml", "sensors: { rate: 1000, torque_noise: [0.3, 0.1] }\n");
    let robot = "robots/planar2r.yaml";
    let asked = ["--target-std", "5", "--duration", "8", "--noise", "0.3,0.1", "--log-rate", "1000"];
    let quick = ["--starts", "2", "--iterations", "12", "--out", &motion, "--json", "-"];
    let found = json(&[&["excite", robot], &asked[..], &quick[..]].concat());
    let tried = found["tried"].as_array().unwrap();
    assert!(tried.len() > 1 && found["duration"].as_f64().unwrap() < 8.0, "{tried:?}");
    let essential: Vec<_> = found["expected"].as_array().unwrap().iter().filter(|e| e["essential"] == true).collect();
    assert!(essential.len() >= 4, "{essential:?}");
    assert!(essential.iter().all(|e| e["relative_std_percent"].as_f64().unwrap() <= 5.0), "{essential:?}");

    let runs = 8;
    let mut sum = 0.0;
    for seed in 1..=runs {
        let seed = seed.to_string();
        let play =
            ["--trajectory", &motion, "--effects", &sensors, "--control", "exact", "--seed", &seed, "--out", &log];
        let run = denavit(&[&["simulate", robot], &play[..]].concat());
        assert_eq!(run.status, Some(0), "{}", run.err);
        let identified = json(&["identify", robot, &log, "--consistent=never", "--json", "-"]);
        let value = |name: &str| {
            let all = identified["parameters"].as_array().unwrap();
            all.iter().find(|p| p["name"] == name).unwrap()["value"].as_f64().unwrap()
        };
        for e in &essential {
            let number = |key: &str| e[key].as_f64().unwrap();
            sum += ((value(e["name"].as_str().unwrap()) - number("value")) / number("std")).powi(2);
        }
    }
    let spread = (sum / f64::from(runs) / essential.len() as f64).sqrt();
    assert!((0.6..1.6).contains(&spread), "errors are {spread} times what was promised");
}

#[test]
fn a_tool_needs_nominal_values_for_a_target_and_an_arm_that_can_tell_it() {
    let folder = folder("excite_tool");
    let lwr = std::fs::read_to_string(PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(ROBOT)).unwrap();
    let tool = "\ntool: { name: box, M: 2, MS: [0.05, 0.04, 0.2], I: [0.05, 0.05, 0.02, -0.003, -0.004, -0.003] }\n";
    let loaded = file(&folder, "loaded.yaml", lwr + tool);
    let asked = ["--tool", "--target-std", "10", "--duration", "4", "--starts", "2", "--iterations", "8"];
    let found = json(&[&["excite", &loaded], &asked[..], &["--json", "-"]].concat());
    let expected = found["expected"].as_array().unwrap();
    assert!(expected.len() == 10 && expected[0]["value"] == 2.0, "{expected:?}");
    assert!(expected.iter().filter(|e| e["essential"] == true).count() >= 4, "{expected:?}");
    let run = denavit(&[&["excite", ROBOT], &asked[..]].concat());
    assert_eq!(run.status, Some(2), "{}", run.err);
    assert!(run.err.contains("under `tool`"), "{}", run.err);
    let run = denavit(&["excite", "robots/planar2r.yaml", "--tool", "--starts", "1", "--iterations", "2"]);
    assert_eq!(run.status, Some(1), "{}", run.err);
    assert!(run.err.contains("no motion of this arm separates MSZ of the tool"), "{}", run.err);
}
