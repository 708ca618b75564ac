//! Tests of a closed-form torque law in the robot file, in every verb that uses the file's model.
//! Reference torques are computed here, by the numeric recursion and the formula in Rust.

use std::fmt::Write as _;
use std::path::Path;

use denavit::apps::paper::tool::Waves;
use denavit::model::rigid_body::Numeric;
use denavit::numerics::prng::Random;
use dh_codegen::arm::param;
use serde_json::Value;

use super::*;

const PLAIN: &str = "robots/planar2r.yaml";
const LAW: &str = "law: \"a*sin(3*q1) + 0.4*tanh(dq2/0.2)*cos(q2) + 0.5*exp(-t/5) + 0.02*(temp1 - 25)\", unit: N m";

fn law(q: &[f64], dq: &[f64], t: f64, temp: f64) -> f64 {
    0.8 * (3.0 * q[0]).sin() + 0.4 * (dq[1] / 0.2).tanh() * q[1].cos() + 0.5 * (-t / 5.0).exp() + 0.02 * (temp - 25.0)
}

/// The planar arm with the law at its elbow, as a file.
fn lawful(folder: &Path) -> String {
    let text = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(PLAIN)).unwrap();
    let text = text.replace("constants: { L1: 0.5,", "constants: { a: 0.8, L1: 0.5,");
    file(
        folder,
        "lawful.yaml",
        text.replace("name: elbow, type: revolute,", &format!("name: elbow, type: revolute, {LAW},")),
    )
}

/// Rigid torque and plain friction by the recursion.
struct Plain {
    arm: Numeric,
    phi: Vec<f64>,
}

impl Plain {
    fn new() -> Self {
        let robot = read_robot(PLAIN);
        Self { arm: Numeric::new(&robot), phi: param::standard_values(&robot).unwrap() }
    }

    fn torque(&self, q: &[f64], dq: &[f64], ddq: &[f64]) -> Vec<f64> {
        self.arm.inverse_dynamics(q, dq, ddq, &self.phi).iter().copied().collect()
    }
}

fn temperature(t: f64) -> f64 {
    25.0 + 0.5 * t
}

/// A log of 16 s at 200 Hz with the law; `push` is an additional torque of the elbow, N m.
fn record(seed: u64, push: impl Fn(f64) -> f64) -> String {
    let (plain, mut random) = (Plain::new(), Random::new(seed));
    let waves = Waves::random(&read_robot(PLAIN), 16.0, &mut random);
    let mut text = String::from("t,q1,q2,tau1,tau2,temp1,temp2\n");
    for k in 0..3200 {
        let t = f64::from(k) / 200.0;
        let [q, dq, ddq] = waves.at(t);
        let mut tau = plain.torque(&q, &dq, &ddq);
        tau[1] += law(&q, &dq, t, temperature(t)) + push(t);
        let tau: Vec<f64> = tau.iter().map(|tau| tau + random.even(0.02)).collect();
        let temp = temperature(t);
        writeln!(text, "{t},{},{},{},{},{temp},{temp}", q[0], q[1], tau[0], tau[1]).unwrap();
    }
    text
}

#[test]
fn eval_has_it_with_and_without_a_clock() {
    let folder = folder("law-eval");
    let (robot, plain, mut random) = (lawful(&folder), Plain::new(), Random::new(4));
    let rows: Vec<[f64; 8]> = (0..40)
        .map(|k| {
            let mut row = [0.0; 8].map(|_: f64| random.even(1.5));
            (row[0], row[7]) = (0.3 * f64::from(k), 30.0 + row[7]);
            row
        })
        .collect();
    for (clock, header) in [(true, "t,q1,q2,dq1,dq2,ddq1,ddq2,temp1,temp2"), (false, "q1,q2,dq1,dq2,ddq1,ddq2")] {
        let mut states = format!("{header}\n");
        for row in &rows {
            let row = if clock { [&row[..], &[25.0]].concat() } else { row[1..7].to_vec() };
            states += &(row.iter().map(f64::to_string).collect::<Vec<_>>().join(",") + "\n");
        }
        let states = file(&folder, "states.csv", states);
        let found = json(&["eval", &robot, "--quantity", "inverse_dynamics", "--states", &states, "--json", "-"]);
        for (row, values) in rows.iter().zip(found["values"].as_array().unwrap()) {
            let (q, dq, ddq) = (&row[1..3], &row[3..5], &row[5..7]);
            let mut expected = plain.torque(q, dq, ddq);
            expected[1] += if clock { law(q, dq, row[0], row[7]) } else { law(q, dq, 0.0, 25.0) };
            for (a, b) in numbers(values).iter().zip(&expected) {
                assert!((a - b).abs() < 1e-9, "{clock}: {a} {b}");
            }
        }
    }
}

/// Columns of a log by name.
fn columns(path: &str) -> impl Fn(&str) -> Vec<f64> {
    let text = std::fs::read_to_string(path).unwrap();
    move |name: &str| {
        let at = text.lines().next().unwrap().split(',').position(|column| column == name).unwrap();
        text.lines().skip(1).map(|line| line.split(',').nth(at).unwrap().parse().unwrap()).collect()
    }
}

/// The law is simulated from the robot file, from the file of effects, and from the latter instead
/// of the former.
#[test]
fn simulate_plays_it() {
    let folder = folder("law-simulate");
    let (lawful, plain) = (lawful(&folder), Plain::new());
    let mut motion = String::from("t,q1,q2,dq1,dq2,ddq1,ddq2\n");
    for k in 0..=1200 {
        let t = f64::from(k) / 200.0;
        let wave = |a: f64, w: f64| [a * (1.0 - (w * t).cos()), a * w * (w * t).sin(), a * w * w * (w * t).cos()];
        let (x, y) = (wave(0.5, 1.3), wave(-0.4, 2.1));
        writeln!(motion, "{t},{},{},{},{},{},{}", x[0], y[0], x[1], y[1], x[2], y[2]).unwrap();
    }
    let motion = file(&folder, "motion.csv", motion);
    let perfect = "sensors: { rate: 1000, encoder: 0, torque_noise: 0, dq: true, velocity_noise: 0, temp: true }\n";
    let other = "joints: { elbow: { law: \"0.3*sign(dq2)*cos(q1)\", unit: N m } }\n";
    let same = format!("joints: {{ 2: {{ {} }} }}\n", LAW.replace("a*", "0.8*"));
    let none = String::new();
    for (robot, effects, exact, smooth) in [
        (lawful.as_str(), &none, true, true),
        (lawful.as_str(), &none, false, true),
        (PLAIN, &same, false, true),
        (lawful.as_str(), &other.to_string(), true, false),
        (lawful.as_str(), &other.to_string(), false, false),
    ] {
        let control = if exact { "control: { mode: exact }\n" } else { "" };
        let effects = file(&folder, "effects.yaml", [effects.as_str(), perfect, control].concat());
        let log = folder.join("log.csv").display().to_string();
        let run = denavit(&["simulate", robot, "--trajectory", &motion, "--effects", &effects, "--out", &log]);
        assert_eq!(run.status, Some(0), "{}", run.err);
        let of = columns(&log);
        let [t, q1, q2, dq1, dq2, tau1, tau2, temp] = ["t", "q1", "q2", "dq1", "dq2", "tau1", "tau2", "temp1"].map(of);
        let mut errors: Vec<f64> = (2..t.len() - 2)
            .map(|k| {
                let slope = |v: &[f64]| (v[k - 2] - 8.0 * v[k - 1] + 8.0 * v[k + 1] - v[k + 2]) / 12e-3;
                let (q, dq) = ([q1[k], q2[k]], [dq1[k], dq2[k]]);
                let mut expected = plain.torque(&q, &dq, &[slope(&dq1), slope(&dq2)]);
                expected[1] += match smooth {
                    true => law(&q, &dq, t[k], temp[k]),
                    false => 0.3 * dq[1].signum() * q[0].cos(),
                };
                (expected[0] - tau1[k]).abs().max((expected[1] - tau2[k]).abs())
            })
            .collect();
        errors.sort_by(f64::total_cmp);
        // At reversals bristles reverse; friction not modelled in the loop makes the joint stick.
        let share = if smooth { 95 } else { 80 };
        let (most, rms) = (errors[errors.len() * share / 100], 0.3);
        println!("exact {exact}, smooth {smooth}: {share} % of errors below {most:.2e} N m");
        assert!(most < 0.02 * rms, "exact {exact}, smooth {smooth}: {most} N m of {rms}");
    }
    let accelerates = "joints: { 1: { law: 0.1*ddq2, unit: N m } }\n";
    let effects = file(&folder, "accelerates.yaml", accelerates);
    let log = folder.join("log.csv").display().to_string();
    let run = denavit(&["simulate", PLAIN, "--trajectory", &motion, "--effects", &effects, "--out", &log]);
    assert!(run.status == Some(2) && run.err.contains("only `--control exact` plays it"), "{}", run.err);
    let run = denavit(&[
        "simulate",
        PLAIN,
        "--trajectory",
        &motion,
        "--effects",
        &effects,
        "--out",
        &log,
        "--control",
        "exact",
    ]);
    assert_eq!(run.status, Some(0), "{}", run.err);
    let bad = file(&folder, "bad.yaml", "joints: { 1: { law: 0.1*ddq3, unit: N m } }\n");
    let run = denavit(&["simulate", PLAIN, "--trajectory", &motion, "--effects", &bad, "--out", &log]);
    assert!(
        run.status == Some(2) && run.err.contains("bad.yaml:1:25: joints.1.law: there is no joint of `ddq3`"),
        "{}",
        run.err
    );
}

/// `identify` subtracts the law: the parameters are those of the recursion.
#[test]
fn identify_takes_it_out() {
    let folder = folder("law-identify");
    let lawful = lawful(&folder);
    let log = file(&folder, "log.csv", record(1, |_| 0.0));
    let of = |robot: &str| {
        let out = folder.join("identified.yaml").display().to_string();
        let said = denavit(&["identify", robot, &log, "--out", &out]);
        assert_eq!(said.status, Some(0), "{}", said.err);
        (json(&["identify", robot, &log, "--json", "-"]), said.out + &said.err, std::fs::read_to_string(out).unwrap())
    };
    let (with, said, written) = of(&lawful);
    let (without, ..) = of(PLAIN);
    assert!(said.contains("taken as known: law a*sin(3*q1)"), "{said}");
    assert!(written.contains("law: \"a*sin(3*q1) + 0.4"), "{written}");
    let error = |found: &Value| numbers(&found["rms"]["fit"])[1];
    assert!(error(&with) < 0.02 && error(&without) > 5.0 * error(&with), "{} {}", error(&with), error(&without));
    // Mass moment of the elbow's rod, and its friction.
    let value = |found: &Value, name: &str| {
        let all = found["parameters"].as_array().unwrap();
        all.iter().find(|p| p["name"] == name).unwrap()["value"].as_f64().unwrap()
    };
    for (name, truth) in [("MSX2", 0.08), ("FV2", 0.05), ("FC2", 0.1), ("FC1", 0.2)] {
        assert!((value(&with, name) - truth).abs() < 5e-3, "{name}: {}", value(&with, name));
    }
}

/// A file with the law predicts the log; for one without it, an error at the elbow is found.
#[test]
fn diagnose_knows_it() {
    let folder = folder("law-diagnose");
    let lawful = lawful(&folder);
    let [log, validate] = [1, 2].map(|seed| file(&folder, &format!("log{seed}.csv"), record(seed, |_| 0.0)));
    let of = |robot: &str| json(&["diagnose", robot, &log, "--validate", &validate, "--json", "-"]);
    let (with, without) = (of(&lawful), of(PLAIN));
    assert_eq!(with["verdict"], "nothing_wrong", "{with}");
    assert_ne!(without["verdict"], "nothing_wrong", "{without}");
    let error = |found: &Value| numbers(&found["baseline"]["rms"]["validate"])[1];
    assert!(error(&with) < 0.05 * error(&without), "{} {}", error(&with), error(&without));
}

/// A torque that no cause of the vocabulary produces is written to the file as a formula. The file
/// predicts unused logs as accurately as the diagnosis reports.
#[test]
fn diagnose_writes_what_it_finds() {
    let folder = folder("law-found");
    let hidden = |seed: u64| {
        let (plain, mut random) = (Plain::new(), Random::new(seed));
        let waves = Waves::random(&read_robot(PLAIN), 16.0, &mut random);
        let mut text = String::from("t,q1,q2,tau1,tau2\n");
        for k in 0..3200 {
            let t = f64::from(k) / 200.0;
            let [q, dq, ddq] = waves.at(t);
            let mut tau = plain.torque(&q, &dq, &ddq);
            tau[0] += 0.8 * (3.0 * q[1]).cos() * dq[0].signum();
            let tau: Vec<f64> = tau.iter().map(|tau| tau + random.even(0.03)).collect();
            writeln!(text, "{t},{},{},{},{}", q[0], q[1], tau[0], tau[1]).unwrap();
        }
        text
    };
    let [log, validate, third] = [11, 12, 13].map(|seed| file(&folder, &format!("log{seed}.csv"), hidden(seed)));
    let out = folder.join("found.yaml").display().to_string();
    let found = json(&["diagnose", PLAIN, &log, "--validate", &validate, "--out", &out, "--json", "-"]);
    let cause = found["causes"].as_array().unwrap().iter().find(|c| c["law"].is_string()).expect("a law");
    let law = cause["law"].as_str().unwrap();
    assert!(law.contains("*cos(3*q2)*sign(dq1)"), "{law}");
    let size: f64 = law.split('*').next().unwrap().parse().unwrap();
    assert!((size - 0.8).abs() < 0.05, "{law}");
    assert_eq!(
        (&cause["cause"], &cause["in_extended"], &found["offer"]["model"]),
        (&"unknown".into(), &true.into(), &"extended".into())
    );
    assert_eq!(found["written"]["is_the_offered_model"], true, "{found}");
    assert!(std::fs::read_to_string(&out).unwrap().contains(&format!("law: \"{law}\"")));
    // On a log that neither used.
    let again = |robot: &str| {
        let found = json(&["diagnose", robot, &third, "--json", "-"]);
        (found["verdict"].clone(), numbers(&found["baseline"]["rms"]["validate"])[0])
    };
    let (before, after) = (again(PLAIN), again(&out));
    assert!(after.1 < 0.2 * before.1 && after.0 == "nothing_wrong", "{before:?} {after:?}");
}

/// A temporary push on the elbow: without the law in the file its torque is mistaken for a push.
#[test]
fn force_knows_it() {
    let folder = folder("law-force");
    let lawful = lawful(&folder);
    let log = file(&folder, "log.csv", record(3, |t| if (6.0..10.0).contains(&t) { -1.0 } else { 0.0 }));
    let of = |robot: &str| {
        let found = json(&["force", robot, &log, "--estimator", "plain", "--json", "-"]);
        let log = &found["logs"][0];
        println!("{robot}: {log}");
        log["touching"].as_f64().unwrap() / log["samples"].as_f64().unwrap()
    };
    let (with, without) = (of(&lawful), of(PLAIN));
    assert!((0.2..0.32).contains(&with) && without > 0.5, "{with} {without}");
}
