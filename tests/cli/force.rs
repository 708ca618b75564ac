//! A push on the hand of an arm that was just identified.

use std::sync::OnceLock;

use denavit::numeric::Numeric;
use denavit::numeric::random::Random;
use denavit::tool::rerun::Waves;
use dh_codegen::arm::param;
use nalgebra::{Matrix3, Vector3};

use super::*;

const ROBOT: &str = "robots/kuka-lwr4.yaml";
const NOISE: f64 = 0.2; // N m, half the width of an even distribution, white at 250 Hz

/// 12 s at 250 Hz; from the fourth to the ninth second this wrench is on the tool, rising and falling as a sine.
fn record(wrench: [f64; 6], seed: u64) -> String {
    let robot = read_robot(ROBOT);
    let (arm, phi, mut random) = (Numeric::new(&robot), param::standard_values(&robot).unwrap(), Random::new(seed));
    let waves = Waves::random(&robot, 12.0, &mut random);
    let rows: Vec<Vec<f64>> = (0..3000)
        .map(|k| {
            let t = f64::from(k) / 250.0;
            let [q, dq, ddq] = waves.at(t);
            let tau = arm.inverse_dynamics(&q, &dq, &ddq, &phi);
            let share = if (4.0..9.0).contains(&t) { (std::f64::consts::PI * (t - 4.0) / 5.0).sin() } else { 0.0 };
            let f = wrench.map(|f| f * share);
            // The power of the wrench, joint by joint: its force on the tool's origin and its moment, in the tool's axes.
            let (last, tool, jacobian) = (arm.frames(&q).pop().unwrap(), arm.tool(&q), arm.jacobian(&q));
            let turn: Matrix3<f64> = tool.fixed_view::<3, 3>(0, 0).into();
            let lever: Vector3<f64> = tool.fixed_view::<3, 1>(0, 3) - last.fixed_view::<3, 1>(0, 3);
            let (force, moment) = (turn * Vector3::new(f[0], f[1], f[2]), turn * Vector3::new(f[3], f[4], f[5]));
            let pushed = |j: usize| {
                let (v, w) = (jacobian.fixed_view::<3, 1>(0, j), Vector3::from(jacobian.fixed_view::<3, 1>(3, j)));
                (v + w.cross(&lever)).dot(&force) + w.dot(&moment)
            };
            let noisy: Vec<f64> = (0..7).map(|j| tau[j] - pushed(j) + random.even(NOISE)).collect();
            [vec![t], q.to_vec(), noisy, f.to_vec()].concat()
        })
        .collect();
    let wrench = ["fx", "fy", "fz", "mx", "my", "mz"].map(String::from).to_vec();
    csv(&[vec!["t".to_string()], columns(&["q", "tau"], 7), wrench].concat(), &rows)
}

struct Logs {
    folder: PathBuf,
    free: String,
    push: String,
    identified: String,
    json: String,
}

fn logs() -> &'static Logs {
    static ONCE: OnceLock<Logs> = OnceLock::new();
    ONCE.get_or_init(|| {
        let folder = folder("force");
        let fit = file(&folder, "fit.csv", record([0.0; 6], 1));
        let free = file(&folder, "free.csv", record([0.0; 6], 2));
        let push = file(&folder, "push.csv", record([25.0, -15.0, 30.0, 2.0, -1.5, 1.0], 3));
        let [identified, json] = ["identified.yaml", "identified.json"].map(|n| folder.join(n).display().to_string());
        let run = denavit(&["identify", ROBOT, &fit, "--out", &identified, "--json", &json]);
        assert_eq!(run.status, Some(0), "{}", run.err);
        Logs { folder, free, push, identified, json }
    })
}

#[test]
fn a_push_is_measured_without_a_sensor() {
    let logs = logs();
    for estimator in ["residual", "plain", "momentum", "kalman"] {
        let found = json(&[
            "force",
            &logs.identified,
            &logs.push,
            "--identified",
            &logs.json,
            "--estimator",
            estimator,
            "--stride",
            "5",
            "--free",
            "0:3.8",
            "--json",
            "-",
        ]);
        let log = &found["logs"][0];
        for name in log
            .as_object()
            .unwrap()
            .keys()
            .chain(["noise", "known_from", "not_in_band", "wrench"].map(String::from).iter())
        {
            assert!(found["meaning"][name].is_string(), "{name} is not explained");
        }
        for (i, name) in ["fx", "fy", "fz", "mx", "my", "mz"].iter().enumerate() {
            let c = &log["against_measured"][name];
            let [rms, half, inside] = ["rms", "half_width", "inside"].map(|k| c[k].as_f64().unwrap());
            // The motion passes singularities, where errors and bands are wide.
            assert!(rms < 3.0 * half && inside > 0.85, "{estimator} {name} {c}");
            assert!(half < if i < 3 { 30.0 } else { 3.0 }, "{estimator} {name} {c}");
        }
        assert_eq!(log["consistency"]["free"]["holds"], true, "{log}");
        assert_eq!(log["consistency"]["unexplained"]["holds"], true, "{log}");
        let (touching, samples) = (log["touching"].as_f64().unwrap(), log["samples"].as_f64().unwrap());
        assert!((0.3..0.5).contains(&(touching / samples)), "{estimator} {touching} {samples}");
        assert!(log["false_contact"].as_f64().unwrap() < 0.01, "{log}");
    }
}

#[test]
fn csv_page_and_bias() {
    let logs = logs();
    let [out, page] = ["wrench.csv", "wrench.html"].map(|n| logs.folder.join(n).display().to_string());
    let run = denavit(&[
        "force",
        &logs.identified,
        &logs.push,
        "--identified",
        &logs.json,
        "--free",
        "0:3.8",
        "--bias",
        "--out",
        &out,
        "--report",
        &page,
    ]);
    assert_eq!(run.status, Some(0), "{}", run.err);
    assert!(run.out.contains("estimated less measured") && run.out.contains("phantom force"), "{}", run.out);
    let text = std::fs::read_to_string(&out).unwrap();
    assert!(text.starts_with("t,fx,fy,fz,mx,my,mz,fx_half,"));
    assert!(text.lines().count() > 2500 && !text.contains("NaN") && !text.contains("inf"));
    let page = std::fs::read_to_string(&page).unwrap();
    assert_eq!(page.matches("<svg class=wrench").count(), 6);
    assert!(!page.contains("http://") || page.matches("http://").count() == page.matches("http://www.w3.org").count());
    assert!(!page.contains("NaN"));
}

#[test]
fn where_nothing_touches_the_force_is_a_phantom() {
    let logs = logs();
    let found = json(&[
        "force",
        &logs.identified,
        &logs.free,
        "--identified",
        &logs.json,
        "--against",
        "nothing",
        "--stride",
        "5",
        "--json",
        "-",
    ]);
    let log = &found["logs"][0];
    assert!(log["against_measured"].is_null() && log["consistency"]["free"]["holds"] == true, "{log}");
    for name in ["fx", "fy", "fz", "mx", "my", "mz"] {
        assert!(log["phantom"][name]["inside"].as_f64().unwrap() > 0.8, "{log}");
    }
    // A model that is wrong is found out: the same arm with other links.
    let other =
        std::fs::read_to_string(&logs.identified).unwrap().replace("gravity: [0, 0, -9.81]", "gravity: [0, 0, -9.3]");
    let other = file(&logs.folder, "other.yaml", other);
    let run = denavit(&["force", &other, &logs.free, "--identified", &logs.json, "--against", "nothing"]);
    assert!(run.out.contains("too wrong for the bands to hold"), "{}", run.out);
    // Noise from the log itself.
    let run = denavit(&["force", &logs.identified, &logs.free, "--against", "nothing"]);
    assert!(run.status == Some(0) && run.out.contains("give --identified"), "{} {}", run.out, run.err);
    let run = denavit(&["force", &logs.identified, &logs.push]);
    assert!(run.status == Some(0) && run.out.contains("in no band"), "{} {}", run.out, run.err);
}

/// A model that holds where nothing touches and is contradicted by the spare joint elsewhere: one verdict in text, JSON and page.
#[test]
fn one_verdict_wherever_it_is_printed() {
    let logs = logs();
    let text = std::fs::read_to_string(&logs.push).unwrap();
    let spoiled: Vec<String> = text
        .lines()
        .enumerate()
        .map(|(row, line)| {
            let mut cells: Vec<String> = line.split(',').map(String::from).collect();
            if row > 1250 {
                for (cell, by) in cells[8..15].iter_mut().zip([4.0, -6.0, 5.0, 3.0, -2.0, 2.0, 1.5]) {
                    *cell = (cell.parse::<f64>().unwrap() + by).to_string();
                }
            }
            cells.join(",")
        })
        .collect();
    let spoiled = file(&logs.folder, "spoiled.csv", spoiled.join("\n") + "\n");
    let page = logs.folder.join("spoiled.html").display().to_string();
    let arguments =
        ["force", &logs.identified, &spoiled, "--identified", &logs.json, "--free", "0:3.8", "--report", &page];
    let run = denavit(&arguments);
    assert_eq!(run.status, Some(0), "{}", run.err);
    let found = json(&[&arguments[..], &["--json", "-"]].concat());
    assert_eq!(found["logs"][0]["consistency"]["free"]["holds"], true, "{found}");
    assert_eq!(found["logs"][0]["consistency"]["unexplained"]["holds"], false, "{found}");
    for verdict in [&found["verdict"], &found["logs"][0]["verdict"]] {
        assert_eq!(verdict["bands"], "too_narrow", "{verdict}");
        let sentence = verdict["sentence"].as_str().unwrap();
        assert!(run.out.contains(sentence) && sentence.contains("too wrong"), "{sentence}\n{}", run.out);
        let page = std::fs::read_to_string(&page).unwrap();
        assert!(page.contains(&format!("<p class=verdict>{sentence}</p>")), "{sentence}");
        for said in [&page, &run.out] {
            assert!(!said.contains("can be relied upon") && !said.contains("can be believed"), "{said}");
        }
    }
}

#[test]
fn wrong_use_is_explained() {
    let logs = logs();
    let bad = file(&logs.folder, "bad.json", "{\"parameters\": []}");
    let cases: [(&[&str], &str); 6] = [
        (&[&logs.identified, &logs.push, "--identified", &bad], "correlation"),
        (&["robots/planar2r.yaml", &logs.push], "joints"),
        (&[&logs.identified, &logs.push, "--free", "3:1"], "0:2.5"),
        (&[&logs.identified, &logs.push, "--free", "50:60", "--bias"], "--free stretches"),
        (&[&logs.identified, &logs.push, &logs.free, "--out", "x.csv"], "one log"),
        (&[&logs.identified, "none.csv"], "can't be read"),
    ];
    for (arguments, words) in cases {
        let run = denavit(&[&["force"], arguments].concat());
        assert_eq!(run.status, Some(2), "{arguments:?} {}", run.err);
        assert!(run.err.contains(words), "{arguments:?}: {}", run.err);
    }
}
