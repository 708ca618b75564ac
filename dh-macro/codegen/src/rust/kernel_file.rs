//! Prints one file per function: the kernel over sines and cosines, dense and packed.

use core::fmt::Write;

use super::documentation::doc;
use super::names::Names;
use super::numbers::Numbers;
use super::print::{statements, wrapped};
use super::words::Constant;
use crate::arm::chain::Group;
use crate::arm::param::Inertial;
use crate::arm::{Argument, Function, Kernel};
use crate::robot::Robot;
use crate::sym::Operand;

/// Data of the robot for the printer.
pub(super) struct Context<'a> {
    pub robot: &'a Robot,
    pub constants: &'a [Constant],
    pub numbers: &'a Numbers,
    /// Numbers for kernels with gravity in the world frame.
    pub world_numbers: &'a Numbers,
    pub standard: &'a [String],
    pub base: &'a [String],
    pub kernels: &'a [Kernel],
}

impl Context<'_> {
    /// Title and meaning of a function for this robot.
    pub(super) fn doc(&self, function: Function) -> (&'static str, &'static str) {
        doc(function, self.robot.has_effects())
    }

    /// Numbers for a function: the recursions have gravity in frame 0, the potential energy in the
    /// world frame.
    fn numbers(&self, function: Function) -> &Numbers {
        match function {
            Function::PotentialEnergyRegressor => self.world_numbers,
            _ => self.numbers,
        }
    }

    /// For an adjoint: number of weights.
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

/// Rust type of a result with this shape.
pub(super) fn array(shape: &[usize]) -> String {
    shape.iter().rev().fold("S".to_string(), |inner, n| format!("[{inner}; {n}]"))
}

/// Arguments with types: `name: type`, separated by commas.
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
        Argument::Clock => "clock: &[S; DOF + 1]".to_string(),
        Argument::Seeds => "seed: &[S; SEEDS]".to_string(),
    };
    function.arguments().iter().map(one).collect::<Vec<_>>().join(", ")
}

/// Arguments passed on to a function.
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
        Argument::Clock => "clock",
        Argument::Seeds => "seed",
    };
    function.arguments().iter().map(one).collect::<Vec<_>>().join(", ")
}

/// Trait bound on the numbers of a kernel.
pub(super) fn bound(kernel: &Kernel) -> &'static str {
    if kernel.tape.code.iter().any(|step| step.kind.is_elementary()) { "Real" } else { "Scalar" }
}

/// Whether there is a packed form besides the dense one: only if it has fewer entries.
pub(super) fn has_packed(kernel: &Kernel) -> bool {
    kernel.nonzeros().len() < kernel.tape.outputs.len()
}

/// Ranges of `0..size` between these ascending positions.
fn gaps(places: &[usize], size: usize) -> Vec<core::ops::Range<usize>> {
    let starts = core::iter::once(0).chain(places.iter().map(|p| p + 1));
    let ends = places.iter().copied().chain([size]);
    starts.zip(ends).map(|(start, end)| start..end).filter(|gap| !gap.is_empty()).collect()
}

/// Index text `[1][2]` of a position in the row-major result.
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

/// Text of `src/kernel/<function>.rs`.
pub(super) fn print(kernel: &Kernel, context: &Context<'_>) -> String {
    let packed = has_packed(kernel);
    // A matrix with zeros is written column by column, the order of its computation.
    let tape = if packed { kernel.tape.with_few_waiting() } else { kernel.tape.clone() };
    let kernel = &Kernel { tape, ..kernel.clone() };
    let function = kernel.function;
    let names = Names::new(&kernel.tape, kernel.inputs, context.parameters(function), context.numbers(function));
    let names = if function.primal().is_some() { names.with_seeds() } else { names };
    let file = File { kernel, names, nonzeros: kernel.nonzeros(), packed, title: context.doc(function).0 };
    let mut text = file.heading(context.doc(function).1);
    if let Some(seeds) = context.seeds(function) {
        let _ = writeln!(
            text,
            "/// Entries of the function that is differentiated, structural zeros left out.\npub const SEEDS: usize = {seeds};\n"
        );
    }
    if packed {
        text += &file.pattern();
    }
    text += &file.dense();
    if packed {
        text += &file.sparse();
    }
    text + &file.entries(context)
}

/// Data for printing the file of one function.
struct File<'a> {
    kernel: &'a Kernel,
    names: Names,
    /// Indices of the outputs that are not structurally zero.
    nonzeros: Vec<usize>,
    /// Whether there are forms that omit the zeros.
    packed: bool,
    title: &'static str,
}

impl File<'_> {
    /// Number of entries of the result.
    fn size(&self) -> usize {
        self.kernel.shape.iter().product()
    }

    /// Number of entries per value of the first index.
    fn row(&self) -> usize {
        self.kernel.shape.iter().skip(1).product()
    }

    fn signature(&self) -> String {
        signature(self.kernel.function, "trig: &Trig<S>")
    }

    fn call(&self) -> String {
        call(self.kernel.function, "trig")
    }

    /// Comment of the file, and its imports.
    fn heading(&self, meaning: &str) -> String {
        let count = self.kernel.tape.operations();
        let shape = self.kernel.shape.iter().map(usize::to_string).collect::<Vec<_>>().join(" x ");
        let mut text = format!("//! {}.\n//!\n//! {meaning}\n//!\n", self.title);
        let _ = writeln!(
            text,
            "//! {} multiplications, {} additions; {shape}, {} of {} structurally nonzero.\n",
            count.mul,
            count.add,
            self.nonzeros.len(),
            self.size()
        );
        let signature = signature(self.kernel.function, "");
        let uses = ["DOF", "STANDARD", "BASE"].into_iter().filter(|c| signature.contains(c));
        let names = |word: &str| self.names.constants().any(|(_, value)| value.contains(word));
        let of_file = names("constants::").then_some("constants");
        let gravity = ["GRAVITY", "GRAVITY_IN_BASE"].into_iter().find(|word| names(&format!("{word}[")));
        let uses: Vec<&str> = uses.chain(gravity).chain(["Trig"]).chain(of_file).collect();
        let clears = self.packed && gaps(&self.nonzeros, self.size()).iter().any(|run| run.len() > 1);
        let numbers = match (bound(self.kernel), self.packed) {
            ("Real", true) if clears => "{elementary::Real, runtime::{apart, clear}}",
            ("Real", true) => "{elementary::Real, runtime::apart}",
            ("Real", false) => "elementary::Real",
            (_, true) if clears => "runtime::{Scalar, apart, clear}",
            (_, true) => "runtime::{Scalar, apart}",
            (_, false) => "runtime::Scalar",
        };
        let _ = writeln!(text, "use super::super::{numbers};\nuse super::super::{{{}}};\n", uses.join(", "));
        text
    }

    /// Text of the positions of the entries that are not structurally zero.
    fn pattern(&self) -> String {
        let row = self.row();
        let places: Vec<String> = self.nonzeros.iter().map(|&o| format!("({}, {})", o / row, o % row)).collect();
        let of = if self.kernel.shape.len() == 2 { "Row and column" } else { "First index, and the rest row-major," };
        let list: Vec<String> = places.chunks(10).map(|c| format!("    {},", c.join(", "))).collect();
        format!(
            "/// Entries that are not structurally zero.\npub const NONZEROS: usize = {};\n\n/// {of} of each of them, in the order of [`packed`].\npub const PATTERN: [(usize, usize); NONZEROS] = [\n{}\n];\n\n/// Place of entry `k` in the row-major result.\npub(crate) const fn place(k: usize) -> usize {{\n    PATTERN[k].0 * {row} + PATTERN[k].1\n}}\n\n",
            self.nonzeros.len(),
            list.join("\n")
        )
    }

    /// Statement that stores entry `k`.
    fn target(&self) -> String {
        let shape = &self.kernel.shape;
        match (self.packed, shape.len()) {
            (true, 1) => "out[PATTERN[k].0] = x;".to_string(),
            (true, 2) => "out[PATTERN[k].0][PATTERN[k].1] = x;".to_string(),
            (true, _) => format!("out[PATTERN[k].0][PATTERN[k].1 / {0}][PATTERN[k].1 % {0}] = x;", shape[2]),
            (false, 1) => "out[k] = x;".to_string(),
            (false, 2) => format!("out[k / {0}][k % {0}] = x;", shape[1]),
            (false, _) => {
                format!("out[k / {1}][k % {1} / {0}][k % {0}] = x;", shape[2], shape[1] * shape[2])
            }
        }
    }

    /// Text of the form that writes every entry.
    fn dense(&self) -> String {
        let (title, bound, call) = (self.title, bound(self.kernel), self.call());
        let mut text = format!(
            "/// {title}: every entry of `out` is written.\n#[inline]\npub fn dense<S: {bound}>({}, out: &mut {}) {{\n",
            self.signature(),
            array(&self.kernel.shape)
        );
        if !self.packed {
            let _ = writeln!(text, "    entries({call}, |k, x| {{\n        {}\n    }});\n}}\n", self.target());
            return text;
        }
        // Writes each entry once: clearing the whole array first would need a call of `memset`, and
        // every store twice. The ranges of zeros are spread among the other stores: cleared all at
        // once, they would delay the rest.
        let flat = ".as_flattened_mut()".repeat(self.kernel.shape.len() - 1);
        let _ = writeln!(text, "    let flat = &mut out{flat}[..];");
        let clear = |run: &core::ops::Range<usize>| match run.len() {
            1 => format!("flat[{}] = S::default()", run.start),
            _ => format!("clear(&mut flat[{}..{}])", run.start, run.end),
        };
        let runs = gaps(&self.nonzeros, self.size());
        if let Some(first) = runs.first().filter(|run| run.start == 0) {
            let _ = writeln!(text, "    {};", clear(first));
        }
        let _ = writeln!(text, "    entries({call}, |k, x| {{\n        flat[place(k)] = x;\n        match k {{");
        for (k, &entry) in self.nonzeros.iter().enumerate() {
            if let Some(run) = runs.iter().find(|run| run.start == entry + 1) {
                let _ = writeln!(text, "            {k} => {},", clear(run));
            }
        }
        text + "            _ => {}\n        }\n        apart();\n    });\n}\n\n"
    }

    /// Text of the forms that omit structural zeros.
    fn sparse(&self) -> String {
        let (bound, arguments, call) = (bound(self.kernel), self.signature(), self.call());
        format!(
            "/// The same for an `out` that is zero elsewhere already: other entries are not touched.\n#[inline]\npub fn nonzeros<S: {bound}>({arguments}, out: &mut {}) {{\n    entries({call}, |k, x| {{\n        {}\n    }});\n}}\n\n/// The same, only the entries of [`PATTERN`].\n#[inline]\npub fn packed<S: {bound}>({arguments}, out: &mut [S; NONZEROS]) {{\n    entries({call}, |k, x| out[k] = x);\n}}\n\n",
            array(&self.kernel.shape),
            self.target()
        )
    }

    /// Text of the straight-line program.
    fn entries(&self, context: &Context<'_>) -> String {
        let put = if self.nonzeros.is_empty() { "_" } else { "mut put" };
        let mut text = format!(
            "#[allow(non_snake_case, clippy::all)]\n#[inline(always)]\npub(crate) fn entries<S: {}>({}, {put}: impl FnMut(usize, S)) {{\n",
            bound(self.kernel),
            self.signature()
        );
        text += &inputs(self.kernel, &self.names);
        for (name, value) in self.names.constants() {
            let _ = writeln!(text, "    let {name} = S::constant({value});");
        }
        let shape = &self.kernel.shape;
        let columns = column_names(self.kernel.function, context);
        text += &statements(&self.kernel.tape, &self.names, &self.nonzeros, |o, value| {
            let k = self.nonzeros.iter().position(|&n| n == o).unwrap_or(0);
            let note = match (&columns, shape.as_slice()) {
                (Some(columns), [_, width]) => format!(" // row {}, {}", o / width + 1, columns[o % width]),
                _ if shape.len() > 1 => format!(" // {}", place(shape, o)),
                _ => String::new(),
            };
            format!("put({k}, {value});{note}")
        });
        text + "}\n"
    }
}

fn column_names(function: Function, context: &Context<'_>) -> Option<Vec<String>> {
    match function {
        Function::Regressor | Function::GravityRegressor => Some(context.standard.to_vec()),
        Function::BaseRegressor => Some(context.base.to_vec()),
        Function::PayloadRegressor => Some(Inertial::ALL.map(|which| which.name().to_string()).to_vec()),
        _ => None,
    }
}

/// Name of the variable that holds an argument among the parameters, and the number of values in
/// it.
fn parameter_source(argument: Argument, dof: usize) -> (&'static str, usize) {
    match argument {
        Argument::StandardParameters => ("*phi", usize::MAX),
        Argument::Bristles => ("*bristle", dof),
        Argument::Warmth => ("*warmth", dof),
        Argument::Clock => ("*clock", dof + 1),
        Argument::Seeds => ("*seed", usize::MAX),
        _ => ("*beta", usize::MAX),
    }
}

/// Destructures the arguments: only values that are read get a name.
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
                Group::Parameter => parameter_source(*argument, kernel.inputs.dof),
            };
            let first = match argument {
                Argument::Bristles | Argument::Seeds => names.parameters(),
                Argument::Warmth => names.parameters() + kernel.inputs.dof,
                Argument::Clock => names.parameters() + 2 * kernel.inputs.dof,
                _ => 0,
            };
            // Finds the argument that contains a parameter's input, by that argument's first input.
            let behind = |at: usize| {
                let second = if kernel.function.primal().is_some() { 0 } else { kernel.inputs.dof };
                let starts = [0, 1, 2].map(|k| names.parameters() + k * second);
                let starts = [0].into_iter().chain(starts);
                starts.filter(|start| *start <= at).max()
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
