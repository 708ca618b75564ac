//! Tests of `denavit force`: a push on the tool of an arm that was just identified.

use std::path::Path;
use std::sync::OnceLock;

use denavit::apps::paper::tool::Waves;
use denavit::model::rigid_body::Numeric;
use denavit::numerics::prng::Random;
use dh_codegen::arm::param;
use nalgebra::{Matrix3, Vector3};

use super::*;

const ROBOT: &str = "robots/kuka-lwr4.yaml";
const NOISE: f64 = 0.2; // N m, half the width of an even distribution, white at 250 Hz

/// A log of 12 s at 250 Hz; from the fourth to the ninth second this wrench acts on the tool, with
/// a sine-shaped course.
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
            // Power of the wrench, joint by joint: its force at the tool's origin and its moment,
            // in the tool's axes.
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
    // A wrong model is detected: the same arm with another gravity.
    let other =
        std::fs::read_to_string(&logs.identified).unwrap().replace("gravity: [0, 0, -9.81]", "gravity: [0, 0, -9.3]");
    let other = file(&logs.folder, "other.yaml", other);
    let run = denavit(&["force", &other, &logs.free, "--identified", &logs.json, "--against", "nothing"]);
    assert!(run.out.contains("too wrong for the bands to hold"), "{}", run.out);
    // Noise estimated from the log itself.
    let run = denavit(&["force", &logs.identified, &logs.free, "--against", "nothing"]);
    assert!(run.status == Some(0) && run.out.contains("give --identified"), "{} {}", run.out, run.err);
    let run = denavit(&["force", &logs.identified, &logs.push]);
    assert!(run.status == Some(0) && run.out.contains("in no band"), "{} {}", run.out, run.err);
}

/// A model that is consistent without contact but contradicted by the redundant joint elsewhere:
/// the same verdict in text, JSON and page.
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

/// A copy of a robot file with these Coulomb levels, N m.
fn with_friction(folder: &Path, robot: &str, levels: &[f64]) -> String {
    let mut text = std::fs::read_to_string(robot).unwrap();
    let mut from = 0;
    for level in levels {
        let at = from + text[from..].find("coulomb_friction: ").unwrap() + "coulomb_friction: ".len();
        let end = at + text[at..].find([',', ' ', '}']).unwrap();
        text.replace_range(at..end, &level.to_string());
        from = at;
    }
    file(folder, &format!("friction-{}", Path::new(robot).file_name().unwrap().to_str().unwrap()), text)
}

/// A log of 16 s at 100 Hz of an arm at rest, with encoder noise and static friction at a share of
/// its level. From 6 to 9 s there is a push on the tool, and after it static friction at another
/// share.
fn standing(robot: &str, q: &[f64], push: [f64; 6], encoder: f64, noise: f64, seed: u64) -> String {
    let read = read_robot(robot);
    let (arm, phi, mut random) = (Numeric::new(&read), param::standard_values(&read).unwrap(), Random::new(seed));
    let n = q.len();
    let level: Vec<f64> = read.moving().iter().map(|&r| read.joints[r].drive.coulomb_friction.unwrap_or(0.0)).collect();
    let zero = vec![0.0; n];
    let weight = arm.inverse_dynamics(q, &zero, &zero, &phi);
    let (last, tool, jacobian) = (arm.frames(q).pop().unwrap(), arm.tool(q), arm.jacobian(q));
    let turn: Matrix3<f64> = tool.fixed_view::<3, 3>(0, 0).into();
    let lever: Vector3<f64> = tool.fixed_view::<3, 1>(0, 3) - last.fixed_view::<3, 1>(0, 3);
    let (force, moment) =
        (turn * Vector3::new(push[0], push[1], push[2]), turn * Vector3::new(push[3], push[4], push[5]));
    let pushed = |j: usize| {
        let (v, w) = (jacobian.fixed_view::<3, 1>(0, j), Vector3::from(jacobian.fixed_view::<3, 1>(3, j)));
        (v + w.cross(&lever)).dot(&force) + w.dot(&moment)
    };
    let mut held =
        || -> Vec<f64> { (0..n).map(|_| random.uniform(-1.0, 1.0).signum() * random.uniform(0.4, 0.8)).collect() };
    let (before, after) = (held(), held());
    let rows: Vec<Vec<f64>> = (0..1600)
        .map(|k| {
            let t = f64::from(k) / 100.0;
            let on = f64::from(u8::from((6.0..9.0).contains(&t)));
            let hold = if t < 9.0 { &before } else { &after };
            let angles: Vec<f64> = q.iter().map(|q| q + random.even(encoder)).collect();
            let torques: Vec<f64> =
                (0..n).map(|j| weight[j] + hold[j] * level[j] - on * pushed(j) + random.even(noise)).collect();
            [vec![t], angles, torques].concat()
        })
        .collect();
    csv(&[vec!["t".to_string()], columns(&["q", "tau"], n)].concat(), &rows)
}

/// Shares of samples with contact and undecided ones, between two times, s, of a written wrench.
fn shares(path: &str, from: f64, to: f64) -> [f64; 2] {
    let text = std::fs::read_to_string(path).unwrap();
    let head: Vec<&str> = text.lines().next().unwrap().split(',').collect();
    let column = |name: &str| head.iter().position(|h| *h == name).unwrap();
    let rows: Vec<Vec<f64>> = text
        .lines()
        .skip(1)
        .map(|line| line.split(',').map(|cell| cell.parse().unwrap_or(f64::NAN)).collect())
        .collect();
    let within: Vec<&Vec<f64>> = rows.iter().filter(|r| (from..to).contains(&r[0])).collect();
    ["touching", "undecided"].map(|c| within.iter().map(|r| r[column(c)]).sum::<f64>() / within.len() as f64)
}

#[test]
fn at_rest_friction_is_an_interval() {
    let folder = folder("standing");
    let ur = with_friction(&folder, "robots/ur10e.yaml", &[9.0, 11.0, 7.0, 2.5, 2.0, 1.5]);
    let cases = [
        (ur.as_str(), vec![0.03, -1.1, 2.33, -1.25, -1.05, -0.5], [60.0, -70.0, 50.0, 4.0, 0.0, 3.0], 3e-5, 0.7),
        (ur.as_str(), vec![0.5, -1.4, 1.8, -0.9, 1.2, 0.4], [-70.0, 50.0, 60.0, 0.0, -5.0, 2.0], 4e-4, 0.2),
        (ROBOT, vec![0.3, 0.6, -0.2, 1.3, 0.4, 0.9, 0.1], [20.0, -15.0, 20.0, 1.0, -1.0, 1.0], 2e-5, 0.08),
    ];
    for (seed, (robot, q, push, encoder, noise)) in cases.into_iter().enumerate() {
        let log = file(&folder, "standing.csv", standing(robot, &q, push, encoder, noise, 40 + seed as u64));
        let out = folder.join("wrench.csv").display().to_string();
        for estimator in ["residual", "momentum", "kalman"] {
            let run = denavit(&["force", robot, &log, "--estimator", estimator, "--out", &out]);
            assert_eq!(run.status, Some(0), "{}", run.err);
            let [before, _] = shares(&out, 0.5, 5.5);
            let [during, _] = shares(&out, 6.5, 8.5);
            let [after, undecided] = shares(&out, 10.0, 15.5);
            assert_eq!([before, after], [0.0, 0.0], "{robot} {estimator}");
            assert!(during > 0.98, "{robot} {estimator} {during}");
            assert!(undecided > 0.8 && run.out.contains("can't be told apart"), "{estimator} {undecided} {}", run.out);
        }
        // The dead zone defines rest: without one the sign of the noise acts as friction.
        let run = denavit(&["force", robot, &log, "--dead-zone", "0", "--out", &out]);
        assert_eq!(run.status, Some(0), "{}", run.err);
        assert!(shares(&out, 0.5, 5.5)[0] > 0.5, "{robot}");
    }
    // A file without dry friction gives a warning.
    let log =
        file(&folder, "standing.csv", standing(&ur, &[0.03, -1.1, 2.33, -1.25, -1.05, -0.5], [0.0; 6], 3e-5, 0.5, 7));
    let found = json(&["force", "robots/ur10e.yaml", &log, "--json", "-"]);
    assert_eq!(found["logs"][0]["touching"], 0, "{found}");
    assert!(found["logs"][0]["undecided"].as_f64().unwrap() > 1000.0, "{found}");
    assert_eq!(found["logs"][0]["assumed_static_friction"][1]["at_most"], 16.5, "{found}");
    // The same warnings in text, JSON and page.
    let page = folder.join("standing.html").display().to_string();
    let run = denavit(&["force", "robots/ur10e.yaml", &log, "--report", &page]);
    let page = std::fs::read_to_string(page).unwrap();
    let warnings = strings(&found["warnings"]);
    assert!(warnings.iter().any(|w| w.contains("has no dry friction for joints 1 (16 N m)")), "{warnings:?}");
    for warning in warnings {
        assert!(run.out.contains(&format!("warning: {warning}")), "{warning}\n{}", run.out);
        assert!(page.contains(&warning.replace('\'', "&#39;")) || page.contains(warning), "{warning}");
    }
}

#[test]
fn wrong_use_is_explained() {
    let logs = logs();
    let bad = file(&logs.folder, "bad.json", "{\"parameters\": []}");
    let cases: [(&[&str], &str); 9] = [
        (&[&logs.identified, &logs.push, "--gain", "30"], "--estimator momentum"),
        (&[&logs.identified, &logs.push, "--wander", "5,1"], "--estimator kalman"),
        (&[&logs.identified, &logs.push, "--against", "nothing", "--free", "0:1"], "--free has no effect"),
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
