//! Memory of a diagnosis: less than 200 MB, whatever the number and length of the logs.

use std::f64::consts::TAU;
use std::fs::File;
use std::io::{BufWriter, Write};
use std::path::Path;
use std::process::Command;

use denavit::model::perturbable_robot::PerturbableRobot;
use denavit::model::{Arm, PerturbableArm, States};

use super::{columns, folder, read_robot};

const ROBOT: &str = "robots/kuka-lwr4.yaml";

/// Writes a log of the LWR with `rows` rows at `rate`: sums of sines and the file's torques, with
/// noise of a twentieth N m and more load-dependent friction on joint 2 than in the file.
fn log(path: &Path, rate: f64, rows: usize, seed: usize) {
    let plant = PerturbableRobot::new(&read_robot(ROBOT));
    let wave = |k: usize, j: usize, order: i32| -> f64 {
        let part = |n: f64| {
            let w = TAU * (0.11 * n + 0.013 * j as f64 + 0.003 * seed as f64);
            let phase = w * k as f64 / rate + n + (seed + j) as f64 + f64::from(order) * TAU / 4.0;
            0.5 / n * w.powi(order) * phase.sin()
        };
        part(1.0) + part(2.0) + part(4.0)
    };
    let series =
        |order: i32| (0..7).flat_map(|j| (0..rows).map(move |k| (k, j))).map(|(k, j)| wave(k, j, order)).collect();
    let states = States { len: rows, q: series(0), dq: series(1), ddq: series(2) };
    let mut tau = vec![0.0; 7 * rows];
    plant.inverse_dynamics(&states, plant.given().unwrap(), &mut tau);
    let mut out = BufWriter::new(File::create(path).unwrap());
    writeln!(out, "t,{}", columns(&["q", "tau"], 7).join(",")).unwrap();
    let mut state = 1 + seed as u64;
    for k in 0..rows {
        write!(out, "{:.4}", k as f64 / rate).unwrap();
        (0..7).for_each(|j| write!(out, ",{:.7}", states.q[j * rows + k]).unwrap());
        for j in 0..7 {
            // Knuth's linear congruential generator; its high bits are random enough.
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let scatter = 0.17 * ((state >> 33) as f64 / f64::from(1_u32 << 31) - 0.5);
            let at = j * rows + k;
            let more = if j == 1 { 0.08 * tau[at].abs() * states.dq[at].signum() } else { 0.0 };
            write!(out, ",{:.6}", tau[at] + more + scatter).unwrap();
        }
        writeln!(out).unwrap();
    }
}

/// Peak memory of a run as counted by the kernel, MB.
fn run(arguments: &[String]) -> f64 {
    let mut child = Command::new(env!("CARGO_BIN_EXE_denavit"))
        .args(arguments)
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .stdout(std::process::Stdio::null())
        .stderr(std::process::Stdio::piped())
        .spawn()
        .unwrap();
    let status = format!("/proc/{}/status", child.id());
    let mut most = 0.0_f64;
    while child.try_wait().unwrap().is_none() {
        let text = std::fs::read_to_string(&status).unwrap_or_default();
        let peak = text.lines().find_map(|line| line.strip_prefix("VmHWM:")?.trim().strip_suffix(" kB")?.parse().ok());
        most = peak.map_or(most, |kb: f64| most.max(kb / 1e3));
        std::thread::sleep(std::time::Duration::from_millis(2));
    }
    let run = child.wait_with_output().unwrap();
    let said = String::from_utf8(run.stderr).unwrap();
    assert_eq!(run.status.code(), Some(0), "{said}");
    most
}

fn diagnosed(name: &str, logs: usize, rate: f64, rows: usize) {
    let place = folder(name);
    let names: Vec<String> = (0..logs)
        .map(|seed| {
            let path = place.join(format!("{seed}.csv"));
            log(&path, rate, rows, seed);
            path.display().to_string()
        })
        .collect();
    let json = place.join("found.json").display().to_string();
    let most = run(&[vec!["diagnose".into(), ROBOT.into()], names, vec!["--json".into(), json.clone()]].concat());
    println!("{name}: {most:.0} MB");
    assert!(most < 200.0, "{most} MB");
    let sentence = "more than a diagnosis holds in memory";
    let found = std::fs::read_to_string(json).unwrap();
    assert!(found.contains(sentence), "{found}");
    assert!(found.contains("load_dependent_friction"), "{found}");
    std::fs::remove_dir_all(place).unwrap();
}

#[test]
#[cfg_attr(debug_assertions, ignore = "slow without optimisation: cargo test --release --test cli memory")]
fn a_hundred_logs_take_no_more_than_one() {
    // 430 kB each: each sample is a window.
    diagnosed("memory-logs", 100, 100.0, 3_400);
}

#[test]
#[cfg_attr(debug_assertions, ignore = "slow without optimisation: cargo test --release --test cli memory")]
fn ten_minutes_at_a_kilohertz_take_no_more_than_one() {
    diagnosed("memory-long", 1, 1_000.0, 600_000);
}
