//! Differential tests on random arms: inverse kinematics against the numeric recursion, printed
//! crates against the interpreter.

use std::path::Path;
use std::process::Command;
use std::{env, fs};

use denavit::model::inverse_kinematics::{Ask, Kinematics};
use denavit::model::rigid_body::{Numeric, random::Family};
use denavit::numerics::prng::Random;
use dh_codegen::arm::{Function, Model};
use dh_codegen::ik::{Reference, Status};
use dh_codegen::interpret::{Interpreter, State};

use crate::variable;

/// Tolerance between a posture's reported pose error and the recomputed one: rounding of two
/// computations over lengths of some metres.
const ROUNDING: f64 = 1e-11;

#[test]
fn postures_of_random_arms_reach_their_poses() {
    let arms = 60 * variable("DENAVIT_FUZZ_ROUNDS", 1);
    let mut random = Random::new(variable("DENAVIT_FUZZ_SEED", 1));
    let (mut asked, mut found) = (0, 0);
    for arm in 0..arms {
        let robot = random.robot(&Family { rows: [1, 7], ..Family::default() });
        let Some(ik) = Kinematics::new(&robot, &Model::new(&robot)) else { continue };
        let oracle = Numeric::new(&robot);
        for _ in 0..3 {
            let q = random.vector(robot.dof(), 2.5);
            let goal = *oracle.frames(&q).last().unwrap();
            let pose = core::array::from_fn(|i| core::array::from_fn(|j| goal[(i, j)]));
            let redundancy = ik.redundancy(&q, &Reference::UP);
            let Ok(postures) = ik.solve(&pose, &Ask { redundancy, near: Some(q.clone()), ..Ask::default() }) else {
                continue;
            };
            asked += 1;
            found += usize::from(postures.status == Status::Ok);
            for posture in &postures.list {
                let reached = *oracle.frames(&posture.q).last().unwrap();
                let error = |i: usize| (reached[(i, 3)] - goal[(i, 3)]).abs();
                let apart = error(0).max(error(1)).max(error(2));
                let size = 1.0 + (0..3).fold(0.0, |m: f64, i| m.max(goal[(i, 3)].abs()));
                assert!(
                    apart <= posture.position_error + ROUNDING * size,
                    "arm {arm}: {apart:e} m from its pose, where it says {:e}: {}",
                    posture.position_error,
                    robot.to_yaml()
                );
            }
        }
    }
    println!("fuzz postures: {asked} poses of {arms} arms, {found} solved");
    // Most arms have a closed form or are searched; each pose can be reached by its arm.
    assert!(2 * found > asked, "{found} of {asked}");
}

/// Functions with their parameters and their call in a generated crate.
const PRINTED: [(Function, &str, &str); 18] = [
    (Function::Frames, "", "frames(&q).as_flattened().as_flattened()"),
    (Function::ForwardKinematics, "", "forward_kinematics(&q).as_flattened()"),
    (Function::ToolPose, "", "tool_pose(&q).as_flattened()"),
    (Function::Jacobian, "", "jacobian(&q).as_flattened()"),
    (Function::ToolJacobian, "", "tool_jacobian(&q).as_flattened()"),
    (Function::JacobianDotVelocity, "", "jacobian_dot_velocity(&q, &dq)"),
    (Function::InverseDynamics, "phi", "inverse_dynamics(&q, &dq, &ddq, &phi)"),
    (Function::InverseDynamicsBase, "beta", "inverse_dynamics_base(&q, &dq, &ddq, &beta)"),
    (Function::MassMatrix, "beta", "mass_matrix(&q, &beta).as_flattened()"),
    (Function::Coriolis, "beta", "coriolis(&q, &dq, &beta)"),
    (Function::Gravity, "beta", "gravity(&q, &beta)"),
    (Function::ForwardDynamics, "beta", "forward_dynamics(&q, &dq, &tau, &beta)"),
    (Function::Regressor, "", "regressor(&q, &dq, &ddq).as_flattened()"),
    (Function::BaseRegressor, "", "base_regressor(&q, &dq, &ddq).as_flattened()"),
    (Function::GravityRegressor, "", "gravity_regressor(&q).as_flattened()"),
    (Function::KineticEnergyRegressor, "", "kinetic_energy_regressor(&q, &dq)"),
    (Function::PotentialEnergyRegressor, "", "potential_energy_regressor(&q)"),
    (Function::PayloadRegressor, "", "payload_regressor(&q, &dq, &ddq).as_flattened()"),
];
/// Number of states for each arm.
const STATES: usize = 10;

/// A program that calls each function of the crate `name` at each state, and prints the bits.
fn asking(name: &str, states: &[Vec<f64>]) -> String {
    let rows: Vec<String> = states
        .iter()
        .map(|state| format!("[{}]", state.iter().map(|x| format!("{:#x}", x.to_bits())).collect::<Vec<_>>().join(",")))
        .collect();
    let calls: String = PRINTED.iter().map(|(_, _, call)| format!("say(&arm::{call}[..]);\n")).collect();
    format!(
        "fn {name}() {{
use {name} as arm;
const STATES: [[u64; {}]; {}] = [{}];
for state in STATES {{
let mut next = state.iter().map(|bits| f64::from_bits(*bits));
let [q, dq, ddq, tau]: [[f64; arm::DOF]; 4] = core::array::from_fn(|_| core::array::from_fn(|_| next.next().unwrap()));
let phi: [f64; arm::STANDARD] = core::array::from_fn(|_| next.next().unwrap());
let beta = arm::base_parameters(&phi);
let say = |values: &[f64]| println!(\"{{}}\", values.iter().map(|x| format!(\"{{:x}}\", x.to_bits())).collect::<Vec<_>>().join(\" \"));
{calls}}}
}}
",
        states[0].len(),
        states.len(),
        rows.join(",\n")
    )
}

/// Compares every function to the bit.
#[test]
fn printed_crates_are_what_is_interpreted() {
    let arms = 3 * variable("DENAVIT_FUZZ_ROUNDS", 1).min(20);
    let mut random = Random::new(variable("DENAVIT_FUZZ_SEED", 1) ^ 77);
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("fuzz-printed");
    // Each of the crates is a workspace of its own: the program is beside them.
    let home = folder.join("program");
    let _ = fs::remove_dir_all(folder.join("arms"));
    let (mut asked, mut program, mut crates) = (Vec::new(), String::new(), String::new());
    for k in 0..arms {
        let name = format!("arm{k}");
        let mut robot = random.robot(&Family { rows: [1, 5], ..Family::default() });
        robot.name.clone_from(&name);
        for (path, text) in dh_codegen::krate(&robot, &robot.to_yaml()) {
            let file = folder.join("arms").join(&name).join(path);
            fs::create_dir_all(file.parent().unwrap()).unwrap();
            fs::write(file, text).unwrap();
        }
        let model = Model::new(&robot);
        let states: Vec<Vec<f64>> =
            (0..STATES).map(|_| random.vector(4 * model.dof() + model.standard().len(), 3.0)).collect();
        program += &asking(&name, &states);
        crates += &format!("{name} = {{ path = \"../arms/{name}\" }}\n");
        asked.push((robot, model, states));
    }
    program += &format!("fn main() {{ {} }}\n", (0..arms).map(|k| format!("arm{k}();")).collect::<String>());
    fs::create_dir_all(home.join("src")).unwrap();
    let manifest = format!(
        "[package]\nname = \"printed\"\nversion = \"0.1.0\"\nedition = \"2024\"\n[dependencies]\n{crates}[workspace]\n"
    );
    fs::write(home.join("Cargo.toml"), manifest).unwrap();
    fs::write(home.join("src/main.rs"), program).unwrap();
    let mut command = Command::new(env!("CARGO"));
    command.args(["run", "--quiet", "--offline", "--target-dir", "target"]).current_dir(&home);
    let run = command.env_remove("RUSTFLAGS").output().unwrap();
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
    let said = String::from_utf8(run.stdout).unwrap();
    let mut lines = said.lines();
    let mut compared = 0;
    for (robot, model, states) in &asked {
        let interpreter = Interpreter::new(model, &Function::ALL);
        let n = model.dof();
        for state in states {
            let (phi, none) = (&state[4 * n..], Vec::new());
            let beta = model.base().values(phi);
            let [q, dq, ddq, tau] = [0, 1, 2, 3].map(|k| &state[k * n..(k + 1) * n]);
            for (function, parameters, _) in PRINTED {
                let parameters = match parameters {
                    "phi" => phi,
                    "beta" => &beta,
                    _ => &none,
                };
                let interpreted = interpreter.one(function, &State { q, dq, ddq, tau, parameters });
                let bits = |word: &str| f64::from_bits(u64::from_str_radix(word, 16).unwrap());
                let printed: Vec<f64> = lines.next().unwrap().split_whitespace().map(bits).collect();
                // A structural zero of the dense form is +0 whatever sign a product would give it.
                let same = |(a, b): (&f64, &f64)| a.to_bits() == b.to_bits() || (*a == 0.0 && *b == 0.0);
                assert!(
                    printed.len() == interpreted.len() && printed.iter().zip(&interpreted).all(same),
                    "{}: {printed:?} {interpreted:?}\n{}",
                    function.name(),
                    robot.to_yaml()
                );
                compared += printed.len();
            }
        }
    }
    assert!(lines.next().is_none());
    println!("fuzz printed: {} inputs, {compared} numbers of {arms} arms", arms * STATES as u64);
}
