//! A fleet of simulated robots over a month, ten of which drift by a known amount and cause.
//!
//! A robot-day is a factor whose regressors are those of real recordings of an iiwa, any two to four
//! of the repository's four. Its torques are those of the robot's parameters on that day: its own,
//! with a day-to-day scatter of friction, offsets, gains and loads, and noise on top.

#[cfg(feature = "cluster")]
mod listening;

use std::fs::File;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use denavit::identify::recording::plain_preparation;
use denavit::identify::{KeyedFactors, RecordingFactor, RecordingReader};
use denavit::model::{Arm, StandardParameter};
use denavit::numerics::prng::Random;
use denavit::report::{FactorRow, FactorTable};
use denavit_fleet::calendar::day;
use denavit_fleet::robots::KnownRobot;
#[cfg(feature = "cluster")]
use listening::Listening;

const DAYS: i32 = 30;
const FIRST: i32 = 20_750;
/// Day of the step, or on which a slow drift begins.
const STEP: i32 = FIRST + 16;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn robot_file() -> PathBuf {
    root().join("robots/kuka-iiwa14.yaml")
}

fn gauss(draws: &mut Random) -> f64 {
    let (u, v) = (draws.uniform(1e-300, 1.0), draws.uniform(0.0, std::f64::consts::TAU));
    (-2.0 * u.ln()).sqrt() * v.cos()
}

/// What can happen to a robot.
#[derive(Clone, Copy, Debug)]
enum Cause {
    Parameter { name: &'static str, by: f64 },
    Gain { joint: usize, by: f64 },
}

/// Cause, whether it comes slowly, and what the watch has to say: kind, joint or link.
const DRIFTS: [(Cause, bool, &str, u64); 10] = [
    (Cause::Parameter { name: "FC2", by: 2.0 }, false, "friction", 2),
    (Cause::Parameter { name: "FV4", by: 3.0 }, false, "friction", 4),
    (Cause::Parameter { name: "FC6", by: 0.6 }, true, "friction", 6),
    (Cause::Parameter { name: "FC1", by: -1.5 }, false, "friction", 1),
    (Cause::Parameter { name: "M7", by: 0.5 }, false, "payload", 7),
    (Cause::Parameter { name: "M7", by: -0.4 }, true, "payload", 7),
    (Cause::Gain { joint: 4, by: 0.04 }, false, "gain", 4),
    (Cause::Gain { joint: 2, by: -0.03 }, false, "gain", 2),
    (Cause::Parameter { name: "FO3", by: 1.0 }, false, "offset", 3),
    (Cause::Parameter { name: "FO5", by: -0.6 }, false, "offset", 5),
];

/// The model that the robots have in common, and regressors.
struct Model {
    known: KnownRobot,
    templates: Vec<RecordingFactor>,
    beta: Vec<f64>,
    noise: Vec<f64>,
}

impl Model {
    fn new() -> Self {
        let known = KnownRobot::open(&robot_file()).unwrap();
        let files = ["chirp_j2", "chirp_j6", "motion_j2toj7", "motion_j3j4"];
        let factors: Vec<RecordingFactor> = files
            .iter()
            .map(|name| {
                let path = root().join(format!("data/kuka-iiwa14/{name}.csv.gz"));
                let prepare = plain_preparation(&known.robot);
                RecordingReader::with(&known.robot, known.digest, prepare, |reader| {
                    let reading = &reader.preparation().reading;
                    let mut rows = denavit::data::log::open_with(name, File::open(&path).unwrap(), reading).unwrap();
                    reader.factor(name, &mut *rows).unwrap().factor
                })
            })
            .collect();
        let merge = |mask: usize| {
            let mut keyed = KeyedFactors::default();
            for (k, factor) in factors.iter().enumerate().filter(|(k, _)| mask >> k & 1 == 1) {
                keyed.insert(k.to_string(), factor.clone()).unwrap();
            }
            keyed.fold("template").unwrap().unwrap()
        };
        let all = merge(15);
        let found = known.solve("iiwa", std::slice::from_ref(&all.factors)).unwrap();
        let beta = found.values();
        let noise = all.factors.joints.iter().map(|j| j.residual_norm(&beta) / (j.samples as f64).sqrt()).collect();
        let templates = (1..16_usize).filter(|mask| mask.count_ones() >= 2).map(merge).collect();
        Self { known, templates, beta, noise }
    }

    /// Adds a change of a standard parameter to base parameters.
    fn add(&self, beta: &mut [f64], name: &str, by: f64) {
        let arm: &dyn Arm = self.known.arm;
        let at = arm.standard_parameters().iter().position(|p: &StandardParameter| p.to_string() == name).unwrap();
        for (value, base) in beta.iter_mut().zip(arm.base_parameters()) {
            *value += base.coefficients.iter().filter(|(k, _)| *k == at).map(|(_, f)| f * by).sum::<f64>();
        }
    }

    /// Whether the arm's model has this parameter.
    fn has(&self, name: &str) -> bool {
        self.known.arm.standard_names().iter().any(|other| other == name)
    }

    /// The factor of a day: `gains` per joint.
    fn factor(&self, beta: &[f64], gains: &[f64], draws: &mut Random) -> Vec<u8> {
        let template = &self.templates[draws.below(self.templates.len())];
        let mut bytes = template.to_bytes();
        let mut at = 8 + 2 + 2 + 4 + 32 + 8;
        for (j, joint) in template.factors.joints.iter().enumerate() {
            let n = joint.columns.len();
            let slow = joint.samples as f64 / joint.independent.max(1.0);
            at += 4 + 4 * n + 16 + 32 + 8 * (n * (n + 1) / 2);
            let x: Vec<f64> = joint.columns.iter().map(|&c| beta[c]).chain([0.0]).collect();
            let clean = joint.triangle.apply(&x);
            for (i, clean) in clean.iter().enumerate() {
                let value = match i == n {
                    true => self.noise[j] * (joint.samples as f64).sqrt(),
                    false => gains[j] * clean + self.noise[j] * slow.sqrt() * gauss(draws),
                };
                bytes[at + 8 * i..at + 8 * i + 8].copy_from_slice(&value.to_le_bytes());
            }
            at += 8 * (n + 1);
        }
        assert_eq!(at, bytes.len());
        bytes
    }

    /// A robot on a day. `drift`: the cause and how much of it there is.
    fn day(&self, own: &[f64], drift: Option<(Cause, f64)>, draws: &mut Random) -> Vec<u8> {
        let mut beta = own.to_vec();
        let dof = self.noise.len();
        let warmth = 0.03 * gauss(draws);
        for joint in 1..=dof {
            for (name, own, relative) in [("FC", 0.02, true), ("FV", 0.02, true), ("FO", 0.03, false)] {
                let name = format!("{name}{joint}");
                if !self.has(&name) {
                    continue;
                }
                let index = self.known.arm.base_parameters().iter().position(|b| b.name == name);
                let size = index.filter(|_| relative).map_or(1.0, |k| self.beta[k].abs());
                let shared = if relative { warmth } else { 0.0 };
                self.add(&mut beta, &name, size * (shared + own * gauss(draws)));
            }
        }
        self.add(&mut beta, "M7", 0.01 * gauss(draws));
        let mut gains: Vec<f64> = (0..dof).map(|_| 1.0 + 0.001 * gauss(draws)).collect();
        match drift {
            Some((Cause::Parameter { name, by }, part)) => self.add(&mut beta, name, by * part),
            Some((Cause::Gain { joint, by }, part)) => gains[joint - 1] += by * part,
            None => {}
        }
        self.factor(&beta, &gains, draws)
    }
}

/// The causes that this arm's model has columns for.
fn drifts(model: &Model) -> Vec<(Cause, bool, &'static str, u64)> {
    let known = |cause: &Cause| !matches!(cause, Cause::Parameter { name, .. } if !model.has(name));
    DRIFTS.into_iter().filter(|(cause, ..)| known(cause)).collect()
}

/// One table per day.
fn write(model: &Model, folder: &Path, seed: u64, robots: usize, days: i32) {
    let drifts = drifts(model);
    let own = |k: usize| {
        let mut draws = Random::stream(seed, k as u64);
        let mut beta = model.beta.clone();
        for (value, base) in beta.iter_mut().zip(model.known.arm.base_parameters()) {
            let friction = base.name.starts_with("FC") || base.name.starts_with("FV");
            *value *= 1.0 + if friction { 0.15 } else { 0.01 } * gauss(&mut draws);
        }
        (beta, draws)
    };
    let mut all: Vec<(Vec<f64>, Random)> = (0..robots).map(own).collect();
    for day in FIRST..FIRST + days {
        let file = File::create(folder.join(format!("{day}.parquet"))).unwrap();
        let mut table = FactorTable::new(file, &Vec::new()).unwrap();
        for (k, (beta, draws)) in all.iter_mut().enumerate() {
            let drift = drifts.get(k).filter(|_| day >= STEP).map(|(cause, slow, ..)| {
                let part = if *slow { (f64::from(day - STEP + 1) / 8.0).min(1.0) } else { 1.0 };
                (*cause, part)
            });
            let row = FactorRow {
                robot: format!("arm-{k:04}"),
                day: Some(day),
                file: format!("{day}/arm-{k:04}.parquet"),
                sha256: Some(format!("{day}-{k}")),
                verdict: "clean",
                factor: Some(model.day(beta, drift, draws)),
                ..FactorRow::default()
            };
            table.row(row).unwrap();
        }
        table.finish().unwrap();
    }
}

/// Runs the watch: its JSON, seconds and most memory, MB.
fn watched(folder: &Path, rate: f64, words: &[&str]) -> (serde_json::Value, f64, f64) {
    let json = folder.join("watch.json");
    let start = Instant::now();
    let mut process = Command::new(env!("CARGO_BIN_EXE_denavit-fleet"))
        .arg("watch")
        .arg(folder)
        .arg("--robot")
        .arg(robot_file())
        .args(["--threads", "2", "--false-alarms", &rate.to_string(), "--json"])
        .arg(&json)
        .args(words)
        .stdout(Stdio::inherit())
        .spawn()
        .unwrap();
    let mut most = 0.0_f64;
    while process.try_wait().unwrap().is_none() {
        let status = std::fs::read_to_string(format!("/proc/{}/status", process.id())).unwrap_or_default();
        let peak = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
        let kilobytes = peak.and_then(|text| text.trim().trim_end_matches(" kB").parse::<f64>().ok());
        most = most.max(kilobytes.unwrap_or(0.0) / 1e3);
        std::thread::sleep(Duration::from_millis(20));
    }
    assert!(process.wait().unwrap().success());
    let text = std::fs::read_to_string(&json).unwrap();
    std::fs::remove_file(&json).unwrap();
    (serde_json::from_str(&text).unwrap(), start.elapsed().as_secs_f64(), most)
}

/// What a watch made of a fleet.
#[derive(Debug, Default)]
struct Judged {
    /// Causes that there were.
    all: usize,
    /// Of them those whose most probable cause is the right one.
    right: usize,
    /// Those for which the only cause that is named is a wrong one.
    misled: usize,
    /// Alarms of robots without a change, and of the others where all change was over.
    falsely: usize,
    seconds: f64,
    megabytes: f64,
}

/// Compares what was found with what was done.
fn judge(found: &serde_json::Value, drifts: &[(Cause, bool, &str, u64)]) -> Judged {
    let changes = found["changes"].as_array().unwrap();
    let mut judged = Judged { all: drifts.len(), ..Judged::default() };
    for (k, (cause, _, kind, joint)) in drifts.iter().enumerate() {
        let own: Vec<_> = changes.iter().filter(|c| c["robot"] == format!("arm-{k:04}")).collect();
        let Some(first) = own.first() else {
            println!("{cause:?}: NOT FOUND");
            continue;
        };
        let named = first["causes"].as_array().unwrap();
        let is_right = named[0]["kind"] == *kind && named[0]["joint"] == *joint;
        let certain = first["certain"].as_bool().unwrap();
        let said: Vec<String> = named[..2]
            .iter()
            .map(|c| format!("{} {}: {:.3}, explains {:.2}", c["kind"], c["joint"], c["probability"], c["share"]))
            .collect();
        let verdict = if is_right { "right" } else { "WRONG" };
        println!(
            "{cause:?}: {verdict}{}, after {}, found {}: {}",
            if certain { "" } else { " and uncertain" },
            first["before"],
            first["found"],
            said.join("; ")
        );
        judged.right += usize::from(is_right);
        judged.misled += usize::from(certain && !is_right);
    }
    let number = |change: &serde_json::Value| change["robot"].as_str().unwrap()[4..].parse::<usize>().unwrap();
    // The slow ones take eight days.
    let over = |change: &serde_json::Value| day(change["before"].as_str().unwrap()).unwrap() >= STEP + 8;
    judged.falsely = changes.iter().filter(|change| number(change) >= drifts.len() || over(change)).count();
    judged
}

fn measure(seed: u64, robots: usize, days: i32, rate: f64) -> Judged {
    let model = Model::new();
    let folder = tempfile::tempdir().unwrap();
    write(&model, folder.path(), seed, robots, days);
    let (found, seconds, megabytes) = watched(folder.path(), rate, &[]);
    let judged = Judged { seconds, megabytes, ..judge(&found, &drifts(&model)) };
    println!(
        "seed {seed}, {robots} robots x {days} days: {} of {} right, {} misled, {} false alarms, {seconds:.1} s, \
         {megabytes:.0} MB",
        judged.right, judged.all, judged.misled, judged.falsely
    );
    judged
}

#[test]
fn every_drift_of_a_small_fleet_is_found_with_its_cause() {
    let judged = measure(11, 24, DAYS, 0.05);
    assert_eq!((judged.right, judged.falsely), (judged.all, 0));
}

#[cfg(feature = "cluster")]
#[test]
fn workers_find_the_same() {
    let folder = tempfile::tempdir().unwrap();
    write(&Model::new(), folder.path(), 11, 24, DAYS);
    let mut workers = [(); 2].map(|()| Listening::start("127.0.0.1:0"));
    let addresses = workers.each_ref().map(|worker| worker.address.clone()).join(",");
    let (alone, ..) = watched(folder.path(), 0.05, &[]);
    let by = || watched(folder.path(), 0.05, &["--workers", &addresses]).0;
    assert_eq!(by(), alone);
    assert_eq!(alone["changes"].as_array().unwrap().len(), drifts(&Model::new()).len());
    assert_eq!(workers.each_ref().map(Listening::done), [12, 12]);
    // Without the first.
    workers[0].kill();
    assert_eq!(by(), alone);
    assert_eq!(workers[1].done(), 12 + 24);
}

/// A minute: `cargo test --release --test thousand -- --ignored --nocapture a_thousand`.
#[test]
#[ignore = "a gigabyte of factors"]
fn a_thousand_robots_for_a_month() {
    let judged = measure(11, 1000, DAYS, 0.01);
    assert!(judged.right == judged.all && judged.falsely <= 1);
    assert!(judged.seconds < 120.0 && judged.megabytes < 500.0);
}

/// What one seed shows may be luck.
#[test]
#[ignore = "a minute"]
fn causes_of_other_fleets_are_right() {
    let all: Vec<Judged> = (20..32).map(|seed| measure(seed, 24, DAYS, 0.05)).collect();
    let sum = |of: fn(&Judged) -> usize| all.iter().map(of).sum::<usize>();
    let (right, of, misled) = (sum(|j| j.right), sum(|j| j.all), sum(|j| j.misled));
    println!("{right} of {of} right, {misled} misled, {} false alarms", sum(|j| j.falsely));
    assert!(right * 20 >= of * 19 && misled * 50 <= of);
}

/// The same of another large fleet.
#[test]
#[ignore = "a gigabyte of factors"]
fn another_thousand_robots() {
    let judged = measure(12, 1000, DAYS, 0.01);
    assert!(judged.right == judged.all && judged.falsely <= 1);
}

#[test]
#[ignore = "hundreds of megabytes of factors"]
fn memory_does_not_grow_with_days() {
    let month = measure(11, 100, 30, 0.01).megabytes;
    let quarter = measure(11, 100, 90, 0.01).megabytes;
    assert!(quarter < 1.15 * month + 10.0, "{month} MB, {quarter} MB");
}
