//! A whole crate as a sorted map from relative path to text. Pure: reading and writing happen in
//! the doors.

use core::fmt::Write;
use std::collections::BTreeMap;

use super::kernel_file::{self, Context};
use super::{shell, tests_file, words};
use crate::arm::{Function, Kernel, Model};
use crate::interpret::Interpreter;
use crate::robot::{Robot, crate_name};

/// First words of the `Cargo.toml` of every generated crate: by them a folder is known to be the
/// generator's own.
pub const MARK: &str = "# Written by `denavit generate`.";

/// The parts that crate and macro share: body of the root, and the files below it.
pub(super) struct Parts {
    pub header: String,
    pub root: String,
    pub files: BTreeMap<String, String>,
}

/// `further`: functions that are generated on demand.
pub(super) fn parts(robot: &Robot, source: &str, further: &[Function]) -> Parts {
    let model = Model::with_effects(robot);
    // What is generated is the arm as it is, where the file says that it is another than its table.
    let real = if robot.has_effects() { robot.as_it_is() } else { robot.clone() };
    let robot = &real;
    let mut functions: Vec<Function> = Function::ALL.to_vec();
    if robot.has_effects() {
        functions.extend(Function::WITH_EFFECTS);
    }
    functions.extend(further);
    let kernels: Vec<Kernel> = functions.iter().map(|&f| model.kernel(f)).collect();
    let standard: Vec<String> = model.standard().iter().map(|p| p.name()).collect();
    let base: Vec<String> = model.base().0.iter().map(|b| b.name.clone()).collect();
    let constants = words::constants(&robot.constants);
    let context = Context { robot, constants: &constants, standard: &standard, base: &base, kernels: &kernels };
    let mut files = BTreeMap::new();
    if !constants.is_empty() {
        files.insert("constants.rs".to_string(), words::module(&constants));
    }
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
    let laws: &[(&str, &str)] = if robot.has_effects() { denavit_runtime::sources::WITH_EFFECTS } else { &[] };
    for (path, text) in denavit_runtime::sources::FILES.iter().chain(laws) {
        files.insert((*path).to_string(), (*text).to_string());
    }
    files.insert("tests.rs".to_string(), tests_file::print(&model, &Interpreter::from_kernels(&model, &kernels)));
    Parts {
        header: header(&context, &model, &kernels, source),
        root: shell::print(robot, &model, &kernels, &context),
        files,
    }
}

/// The crate's front page.
fn header(context: &Context<'_>, model: &Model, kernels: &[Kernel], source: &str) -> String {
    let (mut t, robot) = (String::new(), context.robot);
    let _ = writeln!(
        t,
        "//! Closed-form kinematics and dynamics of {}: {} degrees of freedom, {} base parameters.",
        words::code(&robot.name),
        model.dof(),
        model.base().len()
    );
    let _ = writeln!(
        t,
        "//!\n//! Written by denavit {} from the robot file with digest {:016x}; do not edit, run `denavit generate` again.",
        env!("CARGO_PKG_VERSION"),
        shell::digest(source)
    );
    t += "//!\n//! SI units: m, rad, s, kg, N m. Torques are those of the actuators on the links. Nothing is allocated; nothing but `core` is used.\n//! Kernels ([`kernel`]) take sines and cosines ([`Trig`]); the functions here take `q`.\n//! All are generic over [`runtime::Scalar`]: `f64`, `f32` and packs of states run the same text.\n//!\n//! | function | result | multiplications | additions |\n//! |---|---|---|---|\n";
    for kernel in kernels {
        let c = kernel.tape.operations();
        let shape: Vec<String> = kernel.shape.iter().map(usize::to_string).collect();
        let _ = writeln!(
            t,
            "//! | [`{}`]: {} | {} | {} | {} |",
            kernel.function.name(),
            context.doc(kernel.function).0,
            shape.join(" x "),
            c.mul,
            c.add
        );
    }
    t
}

/// Every file of the drop-in crate.
pub fn krate(robot: &Robot, source: &str) -> BTreeMap<String, String> {
    krate_with(robot, source, &[])
}

/// The same with further functions, such as [`Function::ADJOINTS`].
pub fn krate_with(robot: &Robot, source: &str, further: &[Function]) -> BTreeMap<String, String> {
    let parts = parts(robot, source, further);
    let mut files: BTreeMap<String, String> =
        parts.files.into_iter().map(|(path, text)| (format!("src/{path}"), text)).collect();
    files.insert(
        "src/lib.rs".into(),
        format!("{}\n#![no_std]\n#![deny(unsafe_code)]\n#![warn(missing_docs)]\n#![allow(clippy::all)]\n\n#[cfg(test)]\nextern crate std;\n\n{}", parts.header, parts.root),
    );
    let name = crate_name(&robot.name);
    let description = words::toml(&format!("Closed-form kinematics and dynamics of {}", robot.name));
    files.insert(
        "Cargo.toml".into(),
        format!(
            "{MARK} A folder of its own: copy it anywhere.\n[package]\nname = \"{name}\"\nversion = \"0.1.0\"\nedition = \"2024\"\nlicense = \"MIT OR Apache-2.0\"\ndescription = {description}\npublish = false\n\n[dependencies]\n\n[workspace]\n"
        ),
    );
    files
}
