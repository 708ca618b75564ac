//! Generates a whole crate as a sorted map from relative path to text, without side effects: the
//! callers read and write files.

use core::fmt::Write;
use std::collections::BTreeMap;

use super::comment::wrapped;
use super::front::Front;
use super::kernel_file::{self, Context};
use super::numbers::{Gravity, Numbers};
use super::{dispatch, drive, implementations, manifest, parameters, shell, shipped, tests_file, words};
use crate::arm::{Function, Inverse, Kernel, Model};
use crate::interpret::Interpreter;
use crate::robot::Robot;

/// Licences under which generated code may be used.
const LICENCES: [(&str, &str); 2] =
    [("LICENSE-MIT", include_str!("../../LICENSE-MIT")), ("LICENSE-APACHE", include_str!("../../LICENSE-APACHE"))];

/// Parts shared by crate and macro: body of the root, and the files below it.
pub(super) struct Parts {
    /// Comment at the top of a module.
    pub module: String,
    /// Comment at the top of a crate.
    pub crate_root: String,
    pub readme: String,
    pub root: String,
    /// Trait bound on the numbers of the dynamics.
    pub scalar: &'static str,
    pub files: BTreeMap<String, String>,
}

/// Source of the runtime of the generated code.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub enum Runtime {
    /// A copy of the runtime's modules inside the crate, as far as the robot needs them.
    #[default]
    Shipped,
    /// The crate `denavit-runtime`: the right-hand side of its line in `Cargo.toml`, such as
    /// `"0.1"` or `{ path = "../runtime" }`. All robots then share one type of pose, query and
    /// solution.
    Crate(String),
}

/// Generates the parts of a robot; `further`: functions that are generated on demand.
pub(super) fn parts(robot: &Robot, source: &str, further: &[Function], runtime: &Runtime) -> Parts {
    let model = Model::with_effects(robot);
    // If the file states errors of its own table, code is generated for the effective arm.
    let real = if robot.has_effects() { robot.effective() } else { robot.clone() };
    let robot = &real;
    let mut functions: Vec<Function> = Function::ALL.to_vec();
    if robot.has_effects() {
        functions.extend(Function::WITH_EFFECTS);
    }
    functions.extend(further.iter().copied().chain(model.reads_clock().then_some(Function::ClockedDriveTorques)));
    let kernels: Vec<Kernel> = functions.iter().map(|&f| model.kernel(f)).collect();
    let standard: Vec<String> = model.standard().iter().map(|p| p.name()).collect();
    let base: Vec<String> = model.base().0.iter().map(|b| b.name.clone()).collect();
    let constants = words::constants(&robot.constants);
    let [numbers, world_numbers] =
        [Gravity::base, Gravity::world].map(|gravity| Numbers::new(robot, &gravity(model.chain()), &constants));
    let context = Context {
        robot,
        constants: &constants,
        numbers: &numbers,
        world_numbers: &world_numbers,
        standard: &standard,
        base: &base,
        kernels: &kernels,
    };
    let mut files = BTreeMap::from([("dispatch.rs".to_string(), dispatch::print(&model, &context))]);
    if !constants.is_empty() {
        files.insert("constants.rs".to_string(), words::module(&constants));
    }
    files.insert("implementations.rs".to_string(), implementations::file(&kernels));
    if robot.has_effects() {
        files.insert("joint_drives.rs".to_string(), drive::file(&model));
    }
    files.insert("parameters.rs".to_string(), parameters::print(robot, &model, &kernels, &context));
    let mut index = String::from(
        "//! Kernels: additions and multiplications only, given the sines and cosines. One file per function.\n\n",
    );
    functions.sort_by_key(|f| f.name());
    for f in &functions {
        let _ = writeln!(index, "pub mod {};", f.name());
    }
    files.insert("kernel.rs".to_string(), index);
    for kernel in &kernels {
        files.insert(format!("kernel/{}.rs", kernel.function.name()), kernel_file::print(kernel, &context));
    }
    files.insert("tests.rs".to_string(), tests_file::print(&model, &Interpreter::from_kernels(&model, &kernels)));
    files.values_mut().for_each(|text| *text = wrapped(text));
    if *runtime == Runtime::Shipped {
        files.extend(shipped::files(&Inverse::new(model.chain()), robot.has_effects()));
    }
    let front = Front { context: &context, model: &model, kernels: &kernels, source, runtime };
    Parts {
        module: wrapped(&front.module()),
        crate_root: wrapped(&front.root()),
        readme: front.readme(),
        scalar: implementations::scalar(&kernels),
        root: wrapped(&shell::print(robot, &model, &context, runtime)),
        files,
    }
}

/// All files of the drop-in crate.
pub fn krate(robot: &Robot, source: &str) -> BTreeMap<String, String> {
    krate_with(robot, source, &[])
}

/// Variant with further functions, such as [`Function::ADJOINTS`].
pub fn krate_with(robot: &Robot, source: &str, further: &[Function]) -> BTreeMap<String, String> {
    krate_on(robot, source, further, &Runtime::Shipped)
}

/// Variant with further functions and a choice of the runtime.
pub fn krate_on(robot: &Robot, source: &str, further: &[Function], runtime: &Runtime) -> BTreeMap<String, String> {
    let parts = parts(robot, source, further, runtime);
    let mut files: BTreeMap<String, String> =
        parts.files.into_iter().map(|(path, text)| (format!("src/{path}"), text)).collect();
    files.insert(
        "src/lib.rs".into(),
        format!("{}\n#![no_std]\n#![deny(unsafe_code)]\n#![warn(missing_docs)]\n#![allow(clippy::all)]\n\n#[cfg(any(test, feature = \"dispatch\"))]\nextern crate std;\n\n{}", parts.crate_root, parts.root),
    );
    files.insert("README.md".into(), parts.readme);
    files.extend(LICENCES.map(|(path, text)| (path.to_string(), text.to_string())));
    files.insert("Cargo.toml".into(), manifest::print(&robot.name, runtime, &files));
    files
}
