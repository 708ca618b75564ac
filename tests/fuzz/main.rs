//! Hostile inputs for every reader: no panic, at most 5 s and 200 MB for each.
//!
//! Mutations of good files, deterministic by seed. An input with a new kind of result is kept and
//! mutated further. By default each target takes some seconds; `DENAVIT_FUZZ_ROUNDS=100` multiplies
//! the inputs, `DENAVIT_FUZZ_SEED` changes them (`scripts/fuzz`). `corpus/` contains inputs that
//! were once a problem. The same targets run under libFuzzer in `fuzz/`.

#[cfg(unix)]
mod command;
mod differential;
mod memory;
mod mutate;
mod structure;
mod targets;

use std::collections::HashSet;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use std::{env, fs};

use mutate::{NUMBERS, Random, mutated};
use structure::Mutator;

#[global_allocator]
static ALLOCATOR: memory::Counting = memory::Counting;

/// Longest time for one input, without optimisation, on a busy machine.
const LONGEST: Duration = Duration::from_secs(5);
/// Largest memory for one input, bytes.
const MOST_MEMORY: i64 = 200 << 20;
/// Largest number of inputs that are mutated further.
const POOL: usize = 400;

type Run = fn(&[u8]) -> String;

fn root() -> PathBuf {
    env!("CARGO_MANIFEST_DIR").into()
}

fn variable(name: &str, default: u64) -> u64 {
    env::var(name).ok().map_or(default, |text| text.parse().unwrap_or_else(|_| panic!("{name}: {text}")))
}

/// Files of a folder with one of these endings, sorted.
fn seeds(folder: &str, endings: &[&str]) -> Vec<Vec<u8>> {
    let mut paths: Vec<PathBuf> = fs::read_dir(root().join(folder)).unwrap().map(|e| e.unwrap().path()).collect();
    paths.retain(|p| p.is_file() && p.extension().is_some_and(|e| endings.iter().any(|ending| e == *ending)));
    paths.sort();
    assert!(!paths.is_empty(), "{folder}");
    paths.iter().map(|p| fs::read(p).unwrap()).collect()
}

/// Words in the seeds: keys, names, types.
fn words(seeds: &[Vec<u8>]) -> Vec<String> {
    let text: Vec<&str> = seeds.iter().filter_map(|s| std::str::from_utf8(s).ok()).collect();
    let mut found: Vec<String> = text
        .iter()
        .flat_map(|t| t.split(|c: char| !c.is_ascii_alphanumeric() && c != '_'))
        .filter(|w| w.len() > 1 && w.starts_with(|c: char| c.is_ascii_alphabetic()))
        .map(String::from)
        .collect();
    found.sort();
    found.dedup();
    found
}

/// Longest time and largest memory of any input.
#[derive(Default)]
struct Worst {
    time: Duration,
    memory: i64,
}

/// Runs one input and measures it. The input is kept in a file meanwhile, in case the process ends.
fn feed(name: &str, run: Run, input: &[u8], current: &Path, worst: &mut Worst) -> String {
    fs::write(current, input).unwrap();
    let start = Instant::now();
    let (said, memory) = memory::peak(|| run(input));
    let time = start.elapsed();
    worst.time = worst.time.max(time);
    worst.memory = worst.memory.max(memory);
    assert!(time < LONGEST, "{name}: {time:?} for {} bytes in {}", input.len(), current.display());
    assert!(memory < MOST_MEMORY, "{name}: {memory} bytes for {} in {}", input.len(), current.display());
    said
}

/// Kind of a message: without its numbers and quotations.
fn kind(said: &str) -> String {
    let mut quoted = false;
    let keep = |c: &char| {
        quoted ^= *c == '`';
        !quoted && !c.is_ascii_digit()
    };
    said.chars().filter(keep).collect()
}

/// Runs a target on seeds, their mutations and the corpus.
fn fuzz(name: &str, run: Run, mutate: Mutator, seeds: Vec<Vec<u8>>, count: u64) {
    let current = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("fuzz-{name}.bin"));
    let words = words(&seeds);
    let words: Vec<&str> = words.iter().map(String::as_str).chain(NUMBERS).collect();
    let (mut worst, mut pool) = (Worst::default(), seeds);
    let mut seen: HashSet<String> =
        pool.iter().map(|seed| kind(&feed(name, run, seed, &current, &mut worst))).collect();
    let count = count * variable("DENAVIT_FUZZ_ROUNDS", 1);
    let mut random = Random::new(variable("DENAVIT_FUZZ_SEED", 1) << 8 ^ name.len() as u64);
    for _ in 0..count {
        let (a, b) = (random.below(pool.len()), random.below(pool.len()));
        let input = mutate(&pool[a], &pool[b], &words, &mut random);
        let said = feed(name, run, &input, &current, &mut worst);
        if pool.len() < POOL && seen.insert(kind(&said)) {
            pool.push(input);
        }
    }
    fs::remove_file(&current).unwrap();
    println!(
        "fuzz {name}: {count} inputs, {} kinds of answers, at most {:.2} s and {:.1} MB",
        seen.len(),
        worst.time.as_secs_f64(),
        worst.memory as f64 / 1e6
    );
}

/// Inputs that were once a problem: `corpus/TARGET/..`.
#[test]
fn what_was_once_a_problem() {
    let current = Path::new(env!("CARGO_TARGET_TMPDIR")).join("fuzz-corpus.bin");
    let mut count = 0;
    for (name, run) in TARGETS {
        let Ok(folder) = fs::read_dir(root().join("tests/fuzz/corpus").join(name)) else { continue };
        for entry in folder {
            feed(name, run, &fs::read(entry.unwrap().path()).unwrap(), &current, &mut Worst::default());
            count += 1;
        }
    }
    println!("fuzz corpus: {count} inputs");
}

const TARGETS: [(&str, Run); 12] = [
    ("robot", targets::robot),
    ("tool", targets::tool),
    ("simulation", targets::simulation),
    ("expression", targets::expression),
    ("mapping", targets::mapping),
    ("log", targets::log),
    ("table", targets::table),
    ("model", targets::model),
    ("trajectory", targets::trajectory),
    ("plan", targets::plan),
    ("factor", targets::factor),
    ("identified", targets::identified),
];

#[test]
fn robots() {
    let mut all = seeds("robots", &["yaml"]);
    all.extend(seeds("robots/broken", &["yaml"]));
    all.extend(seeds("tests/fuzz/seeds/robot", &["yaml"]));
    fuzz("robot", targets::robot, mutated, all, 4000);
}

#[test]
fn tools() {
    fuzz("tool", targets::tool, mutated, seeds("robots/tools", &["yaml"]), 10000);
}

#[test]
fn simulation_files() {
    fuzz("simulation", targets::simulation, mutated, seeds("tests/fuzz/seeds/simulation", &["yaml"]), 15000);
}

#[test]
fn expressions() {
    let all =
        ["2 * L + 0.1", "-90deg", "(pi/2 - 1e-3) * (L + -3)", "0.3 * sign(dq1) * (1 + 0.2 * cos(3 * q1)) + temp1"];
    let all = all.into_iter().chain(["exp(-abs(dq2)/0.1) + sqrt(abs(q2)) + tanh(t / 30) ^ 2"]);
    fuzz("expression", targets::expression, mutated, all.map(|e| e.as_bytes().to_vec()).collect(), 5000);
}

#[test]
fn mappings() {
    fuzz("mapping", targets::mapping, mutated, seeds("tests/fuzz/seeds/mapping", &["yaml"]), 15000);
}

/// First lines of a CSV in every dialect.
fn csv() -> Vec<Vec<u8>> {
    let rows = |separator: &str, comma: bool, header: &str| {
        let mut text = format!("{header}\n");
        for k in 0..40 {
            let t = f64::from(k) * 0.01;
            let cells = [t, t.sin(), t.cos(), 3.0 * t, 1.0 - t].map(|x| format!("{x:.6}"));
            let line = cells.join(separator);
            text += &(if comma { line.replace('.', ",") } else { line } + "\n");
        }
        text.into_bytes()
    };
    let mut all = vec![
        rows(",", false, "t,q1,q2,tau1,tau2"),
        rows(";", true, "\u{feff}t;q1;q2;tau1;tau2"),
        rows("\t", false, "t\tq1 [deg]\tq2 [rad]\ttau1\ttau2"),
        rows("  ", false, "# t q1 q2 i1 i2"),
        rows(" | ", false, "% somebody\nt [ms]|q1|q2|tau1|tau2"),
        rows(",", false, "\"t\",\"q_shoulder\",\"q_elbow\",\"effort_shoulder\",\"effort_elbow\""),
    ];
    let wide: Vec<u8> = String::from_utf8_lossy(&all[0]).encode_utf16().flat_map(u16::to_le_bytes).collect();
    all.push([&[0xff, 0xfe][..], &wide].concat());
    all
}

#[test]
fn csv_logs() {
    fuzz("log", targets::log, mutated, csv(), 3000);
}

#[test]
fn gzipped_logs() {
    use std::io::Write;
    let pack = |text: Vec<u8>| {
        let mut out = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::fast());
        out.write_all(&text).unwrap();
        out.finish().unwrap()
    };
    fuzz("log-gzip", targets::log, structure::gzip, csv().into_iter().map(pack).collect(), 2000);
}

#[test]
fn parquet_logs() {
    fuzz("log-parquet", targets::log, structure::parquet, seeds("tests/recordings", &["parquet"]), 2500);
    fuzz("table-parquet", targets::table, structure::parquet, seeds("tests/recordings", &["parquet"]), 2500);
}

#[test]
fn mcap_logs() {
    fuzz("log-mcap", targets::log, structure::mcap, seeds("tests/recordings", &["mcap"]), 400);
    fuzz("table-mcap", targets::table, structure::mcap, seeds("tests/recordings", &["mcap"]), 1000);
}

#[test]
fn arrays() {
    fuzz("log-npz", targets::log, structure::npz, seeds("tests/recordings", &["npz"]), 1500);
    fuzz("log-mat", targets::log, structure::mat, seeds("tests/recordings", &["mat"]), 1500);
}

#[test]
fn models() {
    fuzz("model", targets::model, mutated, seeds("tests/import", &["urdf", "xml"]), 5000);
}

#[test]
fn motions() {
    fuzz("trajectory", targets::trajectory, mutated, seeds("tests/fuzz/seeds/trajectory", &["json"]), 10000);
}

#[test]
fn plans() {
    fuzz("plan", targets::plan, mutated, seeds("tests/fuzz/seeds/plan", &["json"]), 3000);
}

#[test]
fn factors() {
    fuzz("factor", targets::factor, mutated, seeds("tests/fuzz/seeds/factor", &["bin"]), 20000);
}

#[test]
fn uncertainties() {
    fuzz("identified", targets::identified, mutated, seeds("tests/fuzz/seeds/identified", &["json"]), 5000);
}
