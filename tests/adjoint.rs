//! Adjoints: compared with differences, with the designer's own adjoint, and printed against
//! interpreted.

use std::path::Path;
use std::process::Command;

use dh_codegen::arm::{Argument, Function, Model};
use dh_codegen::interpret::{Batch, Interpreter, State};
use dh_codegen::pullback::{Gradient, Pullback};
use dh_codegen::robot::{Robot, no_files};

fn robot(name: &str) -> (Robot, String) {
    let path = format!("{}/robots/{name}.yaml", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).unwrap();
    (Robot::from_yaml(&text, &no_files).unwrap().robot, text)
}

/// Random numbers between -1 and 1.
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

/// Non-zero entries of a function at a state.
fn entries(run: &Interpreter, function: Function, x: &[Vec<f64>; 3], parameters: &[f64]) -> Vec<f64> {
    let state = State { q: &x[0], dq: &x[1], ddq: &x[2], tau: &[], parameters };
    let all = run.one(function, &state);
    run.nonzeros(function).unwrap().iter().map(|&o| all[o]).collect()
}

#[test]
fn adjoints_meet_differences_and_are_those_that_the_designer_runs() {
    // Both conventions, prismatic joints, angles that are no quarter turns (the tool), with and
    // without a tool.
    for name in ["planar2r", "kuka-lwr4", "franka-panda", "ur10e", "stanford", "scara"] {
        let model = Model::new(&robot(name).0);
        let functions: Vec<Function> =
            Function::ADJOINTS.into_iter().flat_map(|f| [Some(f), f.primal()]).flatten().collect();
        let run = Interpreter::new(&model, &functions);
        let n = model.dof();
        for function in Function::ADJOINTS {
            let primal = function.primal().unwrap();
            let x: [Vec<f64>; 3] = [1, 2, 3].map(|k| numbers(k, n));
            let takes = primal.arguments().contains(&Argument::StandardParameters);
            let phi = if takes { numbers(4, model.standard().len()) } else { Vec::new() };
            let seeds = numbers(5, run.nonzeros(primal).unwrap().len());
            let both: Vec<f64> = phi.iter().chain(&seeds).copied().collect();
            let state = State { q: &x[0], dq: &x[1], ddq: &x[2], tau: &[], parameters: &both };
            let slopes = run.one(function, &state);
            let sum = |x: &[Vec<f64>; 3]| -> f64 {
                entries(&run, primal, x, &phi).iter().zip(&seeds).map(|(e, w)| e * w).sum()
            };
            for (k, slope) in slopes.iter().enumerate() {
                let at = |h: f64| {
                    let mut x = x.clone();
                    x[k / n][k % n] += h;
                    sum(&x)
                };
                let h = 2e-3;
                // Seven points: the error is of the sixth order.
                let numeric = (45.0 * (at(h) - at(-h)) - 9.0 * (at(2.0 * h) - at(-2.0 * h)) + at(3.0 * h)
                    - at(-3.0 * h))
                    / (60.0 * h);
                assert!(
                    (slope - numeric).abs() < 1e-7 * (1.0 + slope.abs()),
                    "{name} {} by {}{}: {slope} {numeric}",
                    function.name(),
                    ["q", "dq", "ddq"][k / n],
                    k % n + 1
                );
            }
            // The designer's batches have the same bits.
            let kernel = model.kernel(primal);
            let pullback = Pullback::new(&kernel, &kernel.nonzeros(), &model.chain().angle_offsets());
            let batch = Batch { len: 1, q: &x[0], dq: &x[1], ddq: &x[2], tau: &[], parameters: &phi };
            let mut to = Gradient { q: vec![0.0; n], dq: vec![0.0; n], ddq: vec![0.0; n] };
            pullback.run(&batch, &seeds, &mut to);
            let run: Vec<f64> = to.q.into_iter().chain(to.dq).chain(to.ddq).collect();
            for (a, b) in slopes.iter().zip(&run) {
                assert!(a.to_bits() == b.to_bits() || (*a == 0.0 && *b == 0.0), "{name} {}: {a} {b}", function.name());
            }
        }
    }
}

/// The crate with its adjoints, compiled by itself: passes its own tests, and has the interpreter's
/// results to the last bit.
#[test]
fn printed_adjoints_say_the_same_bits() {
    let (robot, text) = robot("stanford");
    let model = Model::new(&robot);
    let functions: Vec<Function> =
        Function::ADJOINTS.into_iter().flat_map(|f| [Some(f), f.primal()]).flatten().collect();
    let run = Interpreter::new(&model, &functions);
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("adjoint_crate");
    for (path, text) in dh_codegen::krate_with(&robot, &text, &Function::ADJOINTS) {
        let path = folder.join(path);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, text).unwrap();
    }
    let [q, dq, ddq] = [1, 2, 3].map(|k| numbers(k, model.dof()));
    let mut body = format!("    let (q, dq, ddq) = (&{q:?}, &{dq:?}, &{ddq:?});\n");
    for function in Function::ADJOINTS {
        let primal = function.primal().unwrap();
        let takes = |a| primal.arguments().contains(&a);
        let phi = if takes(Argument::StandardParameters) { numbers(4, model.standard().len()) } else { Vec::new() };
        let seeds = numbers(5, run.nonzeros(primal).unwrap().len());
        let both: Vec<f64> = phi.iter().chain(&seeds).copied().collect();
        let state = State { q: &q, dq: &dq, ddq: &ddq, tau: &[], parameters: &both };
        let expected: Vec<u64> = run.one(function, &state).iter().map(|v| (v + 0.0).to_bits()).collect();
        let mut call = String::from("q");
        call += if takes(Argument::Velocities) { ", dq, ddq" } else { "" };
        call += &if phi.is_empty() { String::new() } else { format!(", &{phi:?}") };
        body += &format!(
            "    let out: [[f64; DOF]; 3] = {}({call}, &{seeds:?});\n    assert_eq!(out.as_flattened().iter().map(|v| (v + 0.0).to_bits()).collect::<Vec<_>>(), {expected:?});\n",
            function.name()
        );
    }
    std::fs::create_dir_all(folder.join("tests")).unwrap();
    let test = format!("use stanford::*;\n\n#[test]\nfn bits() {{\n{body}}}\n");
    std::fs::write(folder.join("tests/bits.rs"), test).unwrap();
    let run = Command::new(env!("CARGO"))
        .args(["test", "--quiet", "--test", "bits", "--manifest-path"])
        .arg(folder.join("Cargo.toml"))
        .arg("--target-dir")
        .arg(folder.join("target"))
        .output()
        .unwrap();
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
}
