//! One file per function: the kernel over sines and cosines, dense and packed.

use core::fmt::Write;

use super::names::Names;
use super::print::{statements, wrapped};
use super::words::Constant;
use crate::arm::chain::Group;
use crate::arm::{Argument, Function, Kernel};
use crate::robot::Robot;
use crate::sym::Operand;

/// What a function means, for people.
pub(super) fn doc(function: Function) -> (&'static str, &'static str) {
    match function {
        Function::Frames => (
            "DH frames of all rows in the base frame",
            "`out[i]` is the top three rows of the homogeneous matrix `T(0, i+1)`, m and one. Khalil and Dombre, 3.2.",
        ),
        Function::ForwardKinematics => (
            "The last DH frame in the base frame",
            "`out` is the top three rows of `T(0, n)`: axes of the frame as columns, then its origin, m. Khalil and Dombre, 3.2.",
        ),
        Function::ToolPose => (
            "The tool frame in the base frame",
            "Like `forward_kinematics`, followed by the tool's pose (the identity where the robot file has no tool).",
        ),
        Function::Jacobian => (
            "Jacobian of the last DH frame's origin, in base axes",
            "`(v, w) = J dq`: rows 0-2 linear, m/s, rows 3-5 angular, rad/s. Khalil and Dombre, 5.2.",
        ),
        Function::JacobianDotVelocity => (
            "Acceleration of the last DH frame that is left when `ddq` is zero: `dJ/dt dq`",
            "In base axes; entries 0-2 linear, m/s^2, 3-5 angular, rad/s^2. Khalil and Dombre, 5.10.",
        ),
        Function::InverseDynamics => (
            "Torques from the standard parameters",
            "`tau = M ddq + C dq + g + friction`, N m, of the actuators on the links. Newton-Euler, Khalil and Dombre, 9.5.2.",
        ),
        Function::InverseDynamicsBase => (
            "Torques from the base parameters",
            "`tau = W_b beta`, N m, without forming `W_b`. Newton-Euler with the regrouped parameters, Khalil and Dombre, 9.6.",
        ),
        Function::MassMatrix => (
            "Mass matrix `M`, symmetric, kg m^2",
            "From the base parameters, rotors on the diagonal, by composite bodies. Featherstone, 6.2.",
        ),
        Function::Coriolis => {
            ("Coriolis and centrifugal torques `C dq`", "N m, from the base parameters; no gravity, no friction.")
        }
        Function::Gravity => ("Gravity torques `g`", "N m, from the base parameters: what holds the arm up at rest."),
        Function::ForwardDynamics => (
            "Accelerations that torques cause",
            "`ddq = M^-1 (tau - C dq - g - friction)`, rad/s^2, from the base parameters; `M = L D L'` written out.",
        ),
        Function::Regressor => (
            "Regressor `W` of the standard parameters",
            "`tau = W phi`, row j in N m per unit of each parameter; columns as in `STANDARD_NAMES`. Khalil and Dombre, 12.4.",
        ),
        Function::BaseRegressor => (
            "Regressor `W_b` of the base parameters",
            "`tau = W_b beta`, row j in N m per unit of each parameter; columns as in `BASE_NAMES`. Khalil and Dombre, 12.4.",
        ),
        Function::GravityRegressor => (
            "Regressor at rest",
            "`g = W_g phi` for the links' parameters only; columns as the first of `STANDARD_NAMES`.",
        ),
        Function::KineticEnergyRegressor => {
            ("Kinetic energy, one entry per standard parameter", "`T = h phi`, J per unit. Khalil and Dombre, 9.4.")
        }
        Function::PotentialEnergyRegressor => (
            "Potential energy, one entry per standard parameter",
            "`U = h phi`, J per unit, zero at the base frame's origin; an offset torque counts as `FO q`.",
        ),
        Function::RigidDynamics => (
            "Torques of the bodies, rotors and plain friction, without the effects of the file",
            "`tau = M ddq + C dq + g + friction`, N m, from the standard parameters. Newton-Euler, Khalil and Dombre, 9.5.2.",
        ),
        Function::DriveTorques => (
            "Torques at the sensors for given states of the drives",
            "Like `inverse_dynamics`, N m; `bristle`: what stands for the sign of the velocity in friction with memory, in [-1, 1]; `warmth`: factor of each joint's friction that drifts. `Drive` keeps both.",
        ),
        Function::BaseRegressorAdjoint => (
            "Derivative of a weighted sum of the base regressor's entries",
            "`out = sum of seed[k] d(entry k)/d(q, dq, ddq)`, one row each; `entry k` stands at `kernel::base_regressor::PATTERN[k]`. The sign of a velocity has derivative zero. Griewank and Walther, 3.2.",
        ),
        Function::PayloadRegressorAdjoint => (
            "Derivative of a weighted sum of the payload regressor's entries",
            "`out = sum of seed[k] d(entry k)/d(q, dq, ddq)`, one row each; `entry k` stands at `kernel::payload_regressor::PATTERN[k]`. Griewank and Walther, 3.2.",
        ),
        Function::InverseDynamicsAdjoint => (
            "Derivative of a weighted sum of the torques",
            "`out = sum of seed[j] d(tau_j)/d(q, dq, ddq)`, one row each. The sign of a velocity has derivative zero. Griewank and Walther, 3.2.",
        ),
        Function::FramesAdjoint => (
            "Derivative of a weighted sum of the frames' entries",
            "`out = sum of seed[k] d(entry k)/d(q, dq, ddq)`, one row each (only the first is not zero); `entry k` stands at `kernel::frames::PATTERN[k]`. Heights and distances of points on the arm are such sums. Griewank and Walther, 3.2.",
        ),
        Function::ToolPoseAdjoint => (
            "Derivative of a weighted sum of the tool frame's entries",
            "`out = sum of seed[k] d(entry k)/d(q, dq, ddq)`, one row each (only the first is not zero); entries row-major, those only that are not structurally zero. Griewank and Walther, 3.2.",
        ),
        Function::PayloadRegressor => (
            "Regressor of a body fixed to the tool frame",
            "`tau = W_L phi_L`, columns `M MSX MSY MSZ XX YY ZZ XY XZ YZ` in the tool frame, about its origin (the paper's (7)).",
        ),
    }
}

/// What the printer has to know of the robot.
pub(super) struct Context<'a> {
    pub robot: &'a Robot,
    pub constants: &'a [Constant],
    pub standard: &'a [String],
    pub base: &'a [String],
    pub kernels: &'a [Kernel],
}

impl Context<'_> {
    /// What a function means for this robot.
    pub(super) fn doc(&self, function: Function) -> (&'static str, &'static str) {
        match function {
            Function::InverseDynamics if self.robot.has_effects() => (
                "Torques at the sensors from the standard parameters, with the effects of the robot file",
                "`tau = GT clip(M ddq + C dq + g + drives) + TO`, N m. The laws of the drives are in it as steady curves: friction with memory has slipped, gears are warm; `Drive` has their memory, `TIME_DELAY` says how late the sensors are.",
            ),
            _ => doc(function),
        }
    }

    /// Of an adjoint: how many weights it takes.
    fn seeds(&self, function: Function) -> Option<usize> {
        let primal = function.primal()?;
        self.kernels.iter().find(|k| k.function == primal).map(|k| k.nonzeros().len())
    }

    fn parameters(&self, function: Function) -> &[String] {
        match function.arguments() {
            a if a.contains(&Argument::StandardParameters) => self.standard,
            a if a.contains(&Argument::Seeds) => &[],
            _ => self.base,
        }
    }
}

/// Rust type of a result.
pub(super) fn array(shape: &[usize]) -> String {
    shape.iter().rev().fold("S".to_string(), |inner, n| format!("[{inner}; {n}]"))
}

/// `name: type` of each argument.
pub(super) fn signature(function: Function, configuration: &str) -> String {
    let one = |a: &Argument| match a {
        Argument::Configuration => configuration.to_string(),
        Argument::Velocities => "dq: &[S; DOF]".to_string(),
        Argument::Accelerations => "ddq: &[S; DOF]".to_string(),
        Argument::Torques => "tau: &[S; DOF]".to_string(),
        Argument::StandardParameters => "phi: &[S; STANDARD]".to_string(),
        Argument::BaseParameters => "beta: &[S; BASE]".to_string(),
        Argument::Bristles => "bristle: &[S; DOF]".to_string(),
        Argument::Warmth => "warmth: &[S; DOF]".to_string(),
        Argument::Seeds => "seed: &[S; SEEDS]".to_string(),
    };
    function.arguments().iter().map(one).collect::<Vec<_>>().join(", ")
}

/// The arguments as they are handed on.
pub(super) fn call(function: Function, configuration: &str) -> String {
    let one = |a: &Argument| match a {
        Argument::Configuration => configuration,
        Argument::Velocities => "dq",
        Argument::Accelerations => "ddq",
        Argument::Torques => "tau",
        Argument::StandardParameters => "phi",
        Argument::BaseParameters => "beta",
        Argument::Bristles => "bristle",
        Argument::Warmth => "warmth",
        Argument::Seeds => "seed",
    };
    function.arguments().iter().map(one).collect::<Vec<_>>().join(", ")
}

/// What the numbers of a kernel must be able to do.
pub(super) fn bound(kernel: &Kernel) -> &'static str {
    if kernel.tape.code.iter().any(|step| step.kind.is_elementary()) { "Real" } else { "Scalar" }
}

/// Is there a packed form beside the dense one? Only where it has fewer entries.
pub(super) fn has_packed(kernel: &Kernel) -> bool {
    kernel.nonzeros().len() < kernel.tape.outputs.len()
}

/// Stretches of `0..size` between these ascending places.
fn gaps(places: &[usize], size: usize) -> Vec<core::ops::Range<usize>> {
    let starts = core::iter::once(0).chain(places.iter().map(|p| p + 1));
    let ends = places.iter().copied().chain([size]);
    starts.zip(ends).map(|(start, end)| start..end).filter(|gap| !gap.is_empty()).collect()
}

/// `[1][2]` for a place in the row-major result.
fn place(shape: &[usize], mut at: usize) -> String {
    let mut text = String::new();
    let mut rest: usize = shape.iter().product();
    for n in shape {
        rest /= n;
        let _ = write!(text, "[{}]", at / rest);
        at %= rest;
    }
    text
}

/// The text of `src/kernel/<function>.rs`.
pub(super) fn print(kernel: &Kernel, context: &Context<'_>) -> String {
    let packed = has_packed(kernel);
    // A matrix with zeros is written as it comes about, column by column.
    let tape = if packed { kernel.tape.with_few_waiting() } else { kernel.tape.clone() };
    let kernel = &Kernel { tape, ..kernel.clone() };
    let function = kernel.function;
    let (title, meaning) = context.doc(function);
    let bound = bound(kernel);
    let names = Names::new(&kernel.tape, kernel.inputs, context.parameters(function), context.constants);
    let names = if function.primal().is_some() { names.with_seeds() } else { names };
    let count = kernel.tape.operations();
    let nonzeros = kernel.nonzeros();
    let size: usize = kernel.shape.iter().product();
    let shape = kernel.shape.iter().map(usize::to_string).collect::<Vec<_>>().join(" x ");

    let mut text = String::new();
    let _ = writeln!(text, "//! {title}.\n//!\n//! {meaning}\n//!");
    let _ = writeln!(
        text,
        "//! {} multiplications, {} additions; {shape}, {} of {size} structurally nonzero.\n",
        count.mul,
        count.add,
        nonzeros.len()
    );
    let uses = ["DOF", "STANDARD", "BASE"].into_iter().filter(|c| signature(function, "").contains(c));
    let of_file = names.constants().any(|(_, value)| value.starts_with("constants::")).then_some("constants");
    let uses: Vec<&str> = uses.chain(["Trig"]).chain(of_file).collect();
    let clears = packed && gaps(&nonzeros, size).iter().any(|run| run.len() > 1);
    let numbers = match (bound, packed) {
        ("Real", true) if clears => "{elementary::Real, runtime::{apart, clear}}",
        ("Real", true) => "{elementary::Real, runtime::apart}",
        ("Real", false) => "elementary::Real",
        (_, true) if clears => "runtime::{Scalar, apart, clear}",
        (_, true) => "runtime::{Scalar, apart}",
        (_, false) => "runtime::Scalar",
    };
    let _ = writeln!(text, "use super::super::{numbers};\nuse super::super::{{{}}};\n", uses.join(", "));

    if let Some(seeds) = context.seeds(function) {
        let _ = writeln!(
            text,
            "/// Entries of the function that is differentiated, structural zeros left out.\npub const SEEDS: usize = {seeds};\n"
        );
    }
    if packed {
        let _ = writeln!(
            text,
            "/// Entries that are not structurally zero.\npub const NONZEROS: usize = {};\n",
            nonzeros.len()
        );
        let rows: Vec<String> = nonzeros
            .iter()
            .map(|&o| format!("({}, {})", o / (size / kernel.shape[0]), o % (size / kernel.shape[0])))
            .collect();
        let of = if kernel.shape.len() == 2 { "Row and column" } else { "First index, and the rest row-major," };
        let list: Vec<String> = rows.chunks(10).map(|c| format!("    {},", c.join(", "))).collect();
        let _ = writeln!(
            text,
            "/// {of} of each of them, in the order of [`packed`].\npub const PATTERN: [(usize, usize); NONZEROS] = [\n{}\n];\n",
            list.join("\n")
        );
    }
    if packed {
        let row = size / kernel.shape[0];
        let _ = writeln!(
            text,
            "/// Where entry `k` stands in the row-major result.\nconst fn place(k: usize) -> usize {{\n    PATTERN[k].0 * {row} + PATTERN[k].1\n}}\n"
        );
    }
    let arguments = signature(function, "trig: &Trig<S>");
    let call = call(function, "trig");
    let target = match (packed, kernel.shape.len()) {
        (true, 1) => "out[PATTERN[k].0] = x;".to_string(),
        (true, 2) => "out[PATTERN[k].0][PATTERN[k].1] = x;".to_string(),
        (true, _) => format!("out[PATTERN[k].0][PATTERN[k].1 / {0}][PATTERN[k].1 % {0}] = x;", kernel.shape[2]),
        (false, 1) => "out[k] = x;".to_string(),
        (false, 2) => format!("out[k / {0}][k % {0}] = x;", kernel.shape[1]),
        (false, _) => {
            format!("out[k / {1}][k % {1} / {0}][k % {0}] = x;", kernel.shape[2], kernel.shape[1] * kernel.shape[2])
        }
    };
    let out = array(&kernel.shape);
    let entries = format!("    entries({call}, |k, x| {{\n        {target}\n    }});\n");
    let _ = writeln!(
        text,
        "/// {title}: every entry of `out` is written.\n#[inline]\npub fn dense<S: {bound}>({arguments}, out: &mut {out}) {{"
    );
    if packed {
        // Each entry is written once: clearing the whole array first would take a call of `memset`,
        // and every store twice. The stretches of zeros go among the other stores: all of them at
        // once would have the rest wait.
        let flat = ".as_flattened_mut()".repeat(kernel.shape.len() - 1);
        let _ = writeln!(text, "    let flat = &mut out{flat}[..];");
        let clear = |run: &core::ops::Range<usize>| match run.len() {
            1 => format!("flat[{}] = S::default()", run.start),
            _ => format!("clear(&mut flat[{}..{}])", run.start, run.end),
        };
        let runs = gaps(&nonzeros, size);
        if let Some(first) = runs.first().filter(|run| run.start == 0) {
            let _ = writeln!(text, "    {};", clear(first));
        }
        let _ = writeln!(text, "    entries({call}, |k, x| {{\n        flat[place(k)] = x;\n        match k {{");
        for (k, &entry) in nonzeros.iter().enumerate() {
            if let Some(run) = runs.iter().find(|run| run.start == entry + 1) {
                let _ = writeln!(text, "            {k} => {},", clear(run));
            }
        }
        text += "            _ => {}\n        }\n        apart();\n    });\n}\n\n";
        let _ = writeln!(
            text,
            "/// The same, where all other entries of `out` are zero already: they are left alone.\n#[inline]\npub fn nonzeros<S: {bound}>({arguments}, out: &mut {out}) {{\n{entries}}}\n"
        );
    } else {
        let _ = writeln!(text, "{entries}}}\n");
    }
    if packed {
        let _ = writeln!(
            text,
            "/// The same, only the entries of [`PATTERN`].\n#[inline]\npub fn packed<S: {bound}>({arguments}, out: &mut [S; NONZEROS]) {{\n    entries({}, |k, x| out[k] = x);\n}}\n",
            call
        );
    }
    let put = if nonzeros.is_empty() { "_" } else { "mut put" };
    let _ = writeln!(
        text,
        "#[allow(non_snake_case, clippy::all)]\n#[inline(always)]\nfn entries<S: {bound}>({arguments}, {put}: impl FnMut(usize, S)) {{"
    );
    text += &inputs(kernel, &names);
    for (name, value) in names.constants() {
        let _ = writeln!(text, "    let {name} = S::constant({value});");
    }
    let columns = column_names(function, context);
    text += &statements(&kernel.tape, &names, &nonzeros, |o, value| {
        let k = nonzeros.iter().position(|&n| n == o).unwrap_or(0);
        let note = match (&columns, kernel.shape.as_slice()) {
            (Some(columns), [_, width]) => format!(" // row {}, {}", o / width + 1, columns[o % width]),
            _ if kernel.shape.len() > 1 => format!(" // {}", place(&kernel.shape, o)),
            _ => String::new(),
        };
        format!("put({k}, {value});{note}")
    });
    text += "}\n";
    text
}

fn column_names(function: Function, context: &Context<'_>) -> Option<Vec<String>> {
    match function {
        Function::Regressor | Function::GravityRegressor => Some(context.standard.to_vec()),
        Function::BaseRegressor => Some(context.base.to_vec()),
        Function::PayloadRegressor => {
            Some(["M", "MSX", "MSY", "MSZ", "XX", "YY", "ZZ", "XY", "XZ", "YZ"].map(String::from).to_vec())
        }
        _ => None,
    }
}

/// Takes the arguments apart: only what is read gets a name.
fn inputs(kernel: &Kernel, names: &Names) -> String {
    let mut used = vec![];
    let mut note = |operand: &Operand| {
        if let Operand::Input(i) = operand {
            used.push(*i as usize);
        }
    };
    kernel.tape.code.iter().flat_map(|s| [&s.a, &s.b]).for_each(&mut note);
    kernel.tape.outputs.iter().for_each(&mut note);
    used.sort_unstable();
    used.dedup();
    let mut text = String::new();
    for argument in kernel.function.arguments() {
        for &group in argument.groups() {
            let (source, len) = match group {
                Group::Position => ("trig.q", kernel.inputs.dof),
                Group::Sine => ("trig.sin", kernel.inputs.dof),
                Group::Cosine => ("trig.cos", kernel.inputs.dof),
                Group::Velocity => ("*dq", kernel.inputs.dof),
                Group::Acceleration => ("*ddq", kernel.inputs.dof),
                Group::Torque => ("*tau", kernel.inputs.dof),
                Group::Parameter => match argument {
                    Argument::StandardParameters => ("*phi", usize::MAX),
                    Argument::Bristles => ("*bristle", kernel.inputs.dof),
                    Argument::Warmth => ("*warmth", kernel.inputs.dof),
                    Argument::Seeds => ("*seed", usize::MAX),
                    _ => ("*beta", usize::MAX),
                },
            };
            let first = match argument {
                Argument::Bristles | Argument::Seeds => names.parameters(),
                Argument::Warmth => names.parameters() + kernel.inputs.dof,
                _ => 0,
            };
            // Which argument a parameter's input belongs to, by that argument's first input.
            let behind = |at: usize| {
                let second = if kernel.function.primal().is_some() { 0 } else { kernel.inputs.dof };
                let starts = [0, names.parameters(), names.parameters() + second];
                starts.into_iter().filter(|start| *start <= at).max()
            };
            let here: Vec<usize> = used
                .iter()
                .map(|&i| kernel.inputs.locate(i))
                .filter(|(g, at)| *g == group && (group != Group::Parameter || behind(*at) == Some(first)))
                .map(|(_, at)| at - first)
                .collect();
            let Some(&last) = here.last() else {
                if group != Group::Position && group != Group::Sine && group != Group::Cosine {
                    let _ = writeln!(text, "    let _ = {};", source.trim_start_matches('*'));
                }
                continue;
            };
            let list: Vec<String> = (0..=last)
                .map(|at| if here.binary_search(&at).is_ok() { names.input(group, first + at) } else { "_".into() })
                .collect();
            let rest = if last + 1 < len { ", .." } else { "" };
            let list = wrapped(&list, 12);
            let rest = if list.starts_with('\n') { rest.trim_start_matches(", ") } else { rest };
            let _ = writeln!(
                text,
                "    let [{}{rest}] = {source};",
                if rest.is_empty() {
                    list.clone()
                } else if list.starts_with('\n') {
                    format!("{}    ", list)
                } else {
                    list.clone()
                }
            );
        }
    }
    if !used.iter().any(|&i| matches!(kernel.inputs.locate(i).0, Group::Position | Group::Sine | Group::Cosine)) {
        text += "    let _ = trig;\n";
    }
    text
}
