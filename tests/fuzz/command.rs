//! Hostile files for the command, as a process with at most 2 GB: states, poses, motions, bundles.
//! It must end with 0, 1 or 2 and in time, with a message if it fails.

use std::path::Path;
use std::process::Command;
use std::time::{Duration, Instant};
use std::{env, fs};

use crate::mutate::{NUMBERS, Random, mutated};
use crate::variable;

/// Longest run, without optimisation, on a busy machine.
const LONGEST: Duration = Duration::from_secs(20);

fn table(header: &str, rows: u32) -> Vec<u8> {
    let cells = header.split(',').count();
    let row = |k: u32| (0..cells).map(|c| format!("{:.4}", f64::from(k) * 0.01 + c as f64 * 0.1)).collect::<Vec<_>>();
    let rows: Vec<String> = (0..rows).map(|k| row(k).join(",")).collect();
    format!("{header}\n{}\n", rows.join("\n")).into_bytes()
}

/// Runs a verb on mutations of a table, whose path replaces `TABLE`.
fn feed(name: &str, arguments: &str, seed: &[u8], count: u64) {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("fuzz-{name}"));
    fs::create_dir_all(&folder).unwrap();
    let (input, output) = (folder.join("in.csv"), folder.join("out.csv"));
    let words: Vec<&str> =
        ["q1", "q2", "q3", "dq1", "t", "px", "r11", "swivel", "tau1"].into_iter().chain(NUMBERS).collect();
    let mut random = Random::new(variable("DENAVIT_FUZZ_SEED", 1) ^ name.len() as u64);
    let count = count * variable("DENAVIT_FUZZ_ROUNDS", 1);
    let (mut good, mut worst) = (0, Duration::ZERO);
    for k in 0..=count {
        let bytes = if k == 0 { seed.to_vec() } else { mutated(seed, seed, &words, &mut random) };
        fs::write(&input, bytes).unwrap();
        let line = format!("ulimit -v 2000000; exec \"$0\" {arguments}");
        let line = line.replace("TABLE", "\"$1\"").replace("OUT", "\"$2\"");
        let mut command = Command::new("sh");
        command.args(["-c", &line, env!("CARGO_BIN_EXE_denavit")]).args([&input, &output]);
        let start = Instant::now();
        let run = command.current_dir(env!("CARGO_MANIFEST_DIR")).output().unwrap();
        worst = worst.max(start.elapsed());
        let said = String::from_utf8_lossy(&run.stderr);
        let status = run.status.code();
        assert!(matches!(status, Some(0..=2)), "{name}: {:?}: {said}\n{}", run.status, input.display());
        // Notes may precede the error.
        let told = said.lines().any(|line| line.starts_with("denavit: "));
        assert!(status == Some(0) || told, "{name}: {said}\n{}", input.display());
        assert!(!said.contains("panicked"), "{name}: {said}\n{}", input.display());
        assert!(start.elapsed() < LONGEST, "{name}: {:?}: {}", start.elapsed(), input.display());
        assert!(k > 0 || status != Some(2), "{name}: the table itself: {said}");
        good += u64::from(status == Some(0));
    }
    println!("fuzz {name}: {count} inputs, {good} accepted, at most {:.2} s", worst.as_secs_f64());
}

#[test]
fn states() {
    let verb = "eval robots/planar2r.yaml --quantity inverse_dynamics --states TABLE --json OUT";
    feed("states", verb, &table("t,q1,q2,dq1,dq2,ddq1,ddq2", 5), 120);
}

#[test]
fn poses() {
    let pose =
        b"r11,r12,r13,px,r21,r22,r23,py,r31,r32,r33,pz\n1,0,0,0.5,0,1,0,0.2,0,0,1,0\n0,-1,0,0.1,1,0,0,0.4,0,0,1,0\n";
    feed("poses", "ik robots/scara.yaml --poses TABLE --json OUT", pose, 120);
}

#[test]
fn played_motions() {
    let verb = "simulate robots/planar2r.yaml --trajectory TABLE --out OUT";
    feed("motions", verb, &table("t,q1,q2", 12), 60);
}

#[test]
fn checked_motions() {
    let verb = "excite robots/planar2r.yaml --check TABLE --json OUT";
    feed("checked", verb, &table("t,q1,q2,dq1,dq2,ddq1,ddq2", 12), 60);
}

/// Mutations of an archive packed by the command itself.
#[test]
fn bundles() {
    let archive = Path::new(env!("CARGO_TARGET_TMPDIR")).join("fuzz-bundle-seed.zip");
    let verb = ["check", "robots/planar2r.yaml"];
    let mut command = Command::new(env!("CARGO_BIN_EXE_denavit"));
    command.arg("bundle").arg(&archive).arg("--").args(verb).current_dir(env!("CARGO_MANIFEST_DIR"));
    assert!(command.output().unwrap().status.success());
    feed("bundle", "replay TABLE", &fs::read(&archive).unwrap(), 60);
}
