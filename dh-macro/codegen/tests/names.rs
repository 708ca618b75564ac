//! No word of a robot file can change what is printed: robots with hostile names, compiled and run.
//!
//! The words are those of the printed code itself, found by reading it, beside keywords and words
//! that are no identifiers. Each is the name of a constant that the kernels use. Crate, macro and
//! interpreter must agree bit for bit.

mod common;

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::path::Path;
use std::process::Command;

use dh_codegen::Runtime;
use dh_codegen::arm::{Argument, Function, Model};
use dh_codegen::interpret::{Interpreter, State};
use dh_codegen::robot::{Angle, Length, Polynomial, Robot, no_files};
use proc_macro2::TokenStream;

/// Of so many robots one is compiled as the macro expands it, too: the same text, through tokens.
const MACROS: usize = 8;

/// Words that every crate has in common; they stand once beside the robots.
const SHARED: [&str; 5] = ["ik", "robot", "runtime", "drive", "elementary"];

const KEYWORDS: &str = "as async await break const continue crate dyn else enum extern false fn for gen if impl in let loop match mod \
    move mut pub ref return self Self static struct super trait true type unsafe use where while abstract become box do final \
    macro override priv try typeof unsized virtual yield union auto raw safe macro_rules";

const NO_IDENTIFIERS: [&str; 14] = [
    "_",
    "__",
    "größe",
    "gr_f6_u00df",
    "o\u{308}",
    "\u{f6}",
    "_uf6",
    "a b",
    "a\"b",
    "a\n}\nfn x() {",
    "*/",
    "`]",
    "\u{202e}abc",
    "2x",
];

/// Identifiers of a text, comments and strings left out.
fn words_of(text: &str, words: &mut BTreeSet<String>) {
    for line in text.lines().map(|line| line.split("//").next().unwrap_or_default()) {
        let code = line.split('"').step_by(2);
        let found = code.flat_map(|part| part.split(|c: char| !(c.is_ascii_alphanumeric() || c == '_')));
        words.extend(found.filter(|w| w.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_')).map(String::from));
    }
}

/// Two joints; `values` stand in the table, the tool, gravity and, where the robot has effects, in
/// its drives.
const PLACES: usize = 10;

fn robot(which: usize, constants: Vec<(String, f64)>) -> Robot {
    let kinds = [["revolute", "revolute"], ["revolute", "prismatic"], ["prismatic", "revolute"]][which % 3];
    let convention = ["modified", "standard"][which / 3 % 2];
    let text = format!(
        "name: hostile-{which}\nconvention: {convention}\njoints:\n  - {{ type: {}, alpha: 0.3, theta: 0.2{} }}\n  - {{ type: {}, alpha: -0.7, theta: 0.4 }}\n",
        kinds[0],
        if which % 5 == 4 {
            ", drive: { stribeck_friction: { FS: 0.62, VS: 0.05 }, rotor_inertia: 0.1, viscous_friction: 1 }"
        } else {
            ""
        },
        kinds[1],
    );
    let mut robot = Robot::from_yaml(&text, &no_files).unwrap_or_else(|e| panic!("{e}\n{text}")).robot;
    let value = |k: usize| constants[k % constants.len()].1;
    let length =
        |k: usize| Length { value: value(k), closed_form: Polynomial::constant(k), text: constants[k].0.clone() };
    for (row, joint) in robot.joints.iter_mut().enumerate() {
        (joint.d, joint.r) = (length(2 * row), length(2 * row + 1));
        joint.name = format!("{} \"\n*/ `]", constants[row].0);
    }
    robot.gravity = [value(4), value(5), value(6)];
    robot.tool = Some(dh_codegen::robot::Tool {
        name: constants[1].0.clone(),
        xyz: [value(7), value(8), value(9)],
        rpy: [Angle::zero(), Angle::zero(), Angle::zero()],
        inertia: None,
        geometry: None,
    });
    robot.constants = constants;
    robot
}

/// Ten words to a robot, every word once; values that no other number of the robot has.
fn robots(words: &[String]) -> Vec<Robot> {
    let rounds = words.len().div_ceil(PLACES);
    (0..rounds)
        .map(|which| {
            let of = |k: usize| words[(which + k * rounds) % words.len()].clone();
            robot(which, (0..PLACES).map(|k| (of(k), 0.1017 + 0.0713 * k as f64 + 0.00031 * which as f64)).collect())
        })
        .collect()
}

fn functions(robot: &Robot) -> Vec<Function> {
    let with = if robot.has_effects() { &Function::WITH_EFFECTS[..] } else { &[] };
    Function::ALL.iter().chain(with).copied().collect()
}

/// Numbers between -1 and 1.
fn numbers(seed: u64, len: usize) -> Vec<f64> {
    let mut state = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1;
    let mut next = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    };
    (0..len).map(|_| next()).collect()
}

/// Arguments of a function: the numbers, and the text of the call.
struct Inputs {
    arrays: BTreeMap<&'static str, Vec<f64>>,
}

impl Inputs {
    fn new(model: &Model) -> Self {
        let (n, p, b) = (model.dof(), model.standard().len(), model.base().len());
        let sizes =
            [("q", n), ("dq", n), ("ddq", n), ("tau", n), ("phi", p), ("beta", b), ("bristle", n), ("warmth", n)];
        Self { arrays: sizes.into_iter().zip(1..).map(|((name, len), seed)| (name, numbers(seed, len))).collect() }
    }

    fn names(function: Function) -> Vec<&'static str> {
        let name = |a: &Argument| match a {
            Argument::Configuration => "q",
            Argument::Velocities => "dq",
            Argument::Accelerations => "ddq",
            Argument::Torques => "tau",
            Argument::StandardParameters => "phi",
            Argument::BaseParameters => "beta",
            Argument::Bristles => "bristle",
            Argument::Warmth => "warmth",
            Argument::Clock => "clock",
            Argument::Seeds => "seed",
        };
        function.arguments().iter().map(name).collect()
    }

    fn call(&self, function: Function) -> String {
        let list = |name: &str| self.arrays[name].iter().map(|v| format!("{v:?}f64")).collect::<Vec<_>>().join(", ");
        let arguments: Vec<String> = Self::names(function).into_iter().map(|n| format!("&[{}]", list(n))).collect();
        format!("{}({})", function.name(), arguments.join(", "))
    }

    fn interpreted(&self, function: Function, interpreter: &Interpreter) -> Vec<f64> {
        let names = Self::names(function);
        let parameters: Vec<f64> = names
            .iter()
            .skip_while(|n| ["q", "dq", "ddq", "tau"].contains(n))
            .flat_map(|n| self.arrays[n].clone())
            .collect();
        let [q, dq, ddq, tau] = ["q", "dq", "ddq", "tau"].map(|name| self.arrays[name].as_slice());
        interpreter.one(function, &State { q, dq, ddq, tau, parameters: &parameters })
    }
}

/// The crate below `src/<name>`, on a runtime that stands once beside the robots.
fn write_crate(folder: &Path, name: &str, files: &BTreeMap<String, String>) {
    for (path, text) in files.iter().filter(|(path, _)| path.starts_with("src/") && !path.ends_with("tests.rs")) {
        let (target, text) = match path.trim_start_matches("src/") {
            "lib.rs" => (format!("{name}.rs"), as_module(text)),
            path => (format!("{name}/{path}"), text.clone()),
        };
        let target = folder.join(target);
        std::fs::create_dir_all(target.parent().unwrap()).unwrap();
        std::fs::write(target, text).unwrap();
    }
}

/// The runtime that all of them share.
fn write_runtime(folder: &Path) {
    use denavit_runtime_core::sources::{FILES, WITH_EFFECTS};
    for (path, text, _) in FILES.iter().chain(WITH_EFFECTS) {
        let target = folder.join("shared").join(path);
        std::fs::create_dir_all(target.parent().unwrap()).unwrap();
        std::fs::write(target, text).unwrap();
    }
    let modules: String = SHARED.iter().map(|s| format!("pub mod {s};\n")).collect();
    std::fs::write(folder.join("shared.rs"), format!("#![allow(clippy::all)]\n{modules}")).unwrap();
}

/// The root of a crate as a module of the scratch crate.
fn as_module(root: &str) -> String {
    let text = root.replace("#![no_std]\n", "").replace("#[cfg(test)]\nmod tests;\n", "");
    text.replace("::denavit_runtime::", "crate::shared::")
}

/// Expansion of the macro, through tokens as the compiler gets it.
fn expanded(name: &str, robot: &Robot) -> String {
    let module = dh_codegen::module_on(robot, "", &runtime());
    let body = module.body.replace("::denavit_runtime::", "crate::shared::");
    let tokens: TokenStream = body.parse().expect("tokens");
    let traits: TokenStream = module.implementations("Own", "__robot").parse().expect("tokens");
    format!(
        "pub mod {name} {{ {tokens} }}\nconst _: () = {{ #[allow(dead_code)] struct Own; use {name} as __robot; {traits} }};\n"
    )
}

fn runtime() -> Runtime {
    Runtime::Crate(String::new())
}

const MAIN: &str = r#"
trait Flat { fn flat(&self, out: &mut Vec<f64>); }
impl Flat for f64 { fn flat(&self, out: &mut Vec<f64>) { out.push(*self); } }
impl<T: Flat, const N: usize> Flat for [T; N] { fn flat(&self, out: &mut Vec<f64>) { self.iter().for_each(|x| x.flat(out)); } }
#[inline(never)]
fn show(robot: &str, function: &str, value: &dyn Flat) {
    let mut out = Vec::new();
    value.flat(&mut out);
    let words: Vec<String> = out.iter().map(|v| format!("{:016x}", v.to_bits())).collect();
    println!("{robot} {function} {}", words.join(" "));
}
"#;

fn compile(folder: &Path, file: &str, more: &[&str]) {
    let rustc = std::env::var("RUSTC").unwrap_or_else(|_| "rustc".to_string());
    let run = Command::new(rustc)
        .args(["--edition", "2024", "-Dwarnings", "-Copt-level=0", "-Cdebuginfo=0", "--out-dir"])
        .arg(folder)
        .args(more)
        .arg(folder.join(file))
        .output()
        .unwrap();
    let said = String::from_utf8_lossy(&run.stderr);
    assert!(run.status.success(), "{}", said.chars().take(6000).collect::<String>());
}

/// Compiles crates and expansions of all robots, runs them and compares.
fn agree(folder: &Path, robots: &[Robot]) {
    let _ = std::fs::remove_dir_all(folder);
    std::fs::create_dir_all(folder).unwrap();
    let mut main = String::from("#![allow(missing_docs)]\npub mod shared;\n");
    let (mut calls, mut expected) = (String::new(), BTreeMap::new());
    for (which, robot) in robots.iter().enumerate() {
        let model = Model::with_effects(robot);
        let inputs = Inputs::new(&model);
        let interpreter = Interpreter::new(&model, &functions(robot));
        write_crate(folder, &format!("r{which}"), &dh_codegen::krate_on(robot, "", &[], &runtime()));
        let _ = writeln!(main, "pub mod r{which};");
        let expands = which % MACROS == 0;
        if expands {
            main += &expanded(&format!("m{which}"), robot);
        }
        let _ = writeln!(calls, "fn run{which}() {{");
        for function in functions(robot) {
            let (name, call) = (function.name(), inputs.call(function));
            for form in if expands { &["r", "m"][..] } else { &["r"] } {
                let _ = writeln!(calls, "show(\"{which}\", \"{name}\", &{form}{which}::{call});");
            }
            expected.insert((which.to_string(), name.to_string()), inputs.interpreted(function, &interpreter));
        }
        calls += "}\n";
    }
    let runs: String = (0..robots.len()).map(|k| format!("run{k}();\n")).collect();
    std::fs::write(folder.join("main.rs"), format!("{main}{MAIN}{calls}fn main() {{\n{runs}}}\n")).unwrap();
    write_runtime(folder);
    compile(folder, "main.rs", &[]);
    let run = Command::new(folder.join("main")).output().unwrap();
    assert!(run.status.success());
    let mut lines = 0;
    for line in String::from_utf8(run.stdout).unwrap().lines() {
        let mut words = line.split(' ');
        let key = (words.next().unwrap().to_string(), words.next().unwrap().to_string());
        let values: Vec<f64> = words.map(|w| f64::from_bits(u64::from_str_radix(w, 16).unwrap())).collect();
        let wanted = &expected[&key];
        assert_eq!(values.len(), wanted.len());
        // A structural zero of the dense form is +0 whatever the sign a product would give it.
        let same = |(a, b): (&f64, &f64)| a.to_bits() == b.to_bits() || (*a == 0.0 && *b == 0.0);
        let constants = &robots[key.0.parse::<usize>().unwrap()].constants;
        assert!(
            values.iter().zip(wanted).all(same),
            "{} of a robot with {constants:?}:\n{values:?}\n{wanted:?}",
            key.1
        );
        lines += 1;
    }
    assert!(lines > expected.len());
}

#[test]
fn no_name_of_a_file_changes_the_code() {
    let neutral =
        |which: usize| robot(which, (0..PLACES).map(|k| (format!("neutral{k}"), 0.1 + 0.07 * k as f64)).collect());
    let mut words = BTreeSet::new();
    for which in 0..5 {
        let files = dh_codegen::krate(&neutral(which), "");
        let own = |path: &str| !SHARED.iter().any(|s| path.starts_with(&format!("src/{s}")));
        files
            .iter()
            .filter(|(path, _)| own(path) && path.ends_with(".rs"))
            .for_each(|(_, text)| words_of(text, &mut words));
    }
    assert!(words.len() > 200, "{words:?}");
    for word in ["s1", "c2", "dq2", "ddq1", "M2", "put", "trig", "phi", "NAME", "DOF", "S", "t0", "k0"] {
        assert!(words.contains(word), "{word} is not found by reading the printed code");
    }
    words.extend(KEYWORDS.split_whitespace().map(String::from));
    // Words that look like the printer's own for constants.
    let guarded: Vec<String> = ["k_s1", "k_", "constants", "r#type", "neutral0"].map(String::from).to_vec();
    words.extend(guarded.into_iter().chain(NO_IDENTIFIERS.map(String::from)));
    let words: Vec<String> = words.into_iter().collect();
    println!("{} words", words.len());
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("hostile_names");
    agree(&folder, &robots(&words));
}
