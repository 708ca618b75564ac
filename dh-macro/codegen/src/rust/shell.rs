//! Prints the root of a crate or module: its modules, sines and cosines, and the functions of `q`.

use super::kernel_file::{Context, array, bound, call, has_packed, signature};
use super::krate::Runtime;
use super::{inverse, parameters};
use crate::arm::{Kernel, Model};
use crate::robot::Robot;

/// FNV-1a hash of a text, which identifies the file from which a crate was made.
pub(super) fn digest(text: &str) -> u64 {
    text.bytes().fold(0xcbf2_9ce4_8422_2325, |h, b| (h ^ u64::from(b)).wrapping_mul(0x0100_0000_01b3))
}

/// Body of `src/lib.rs` (or of the macro's module), without the crate's attributes.
pub(super) fn print(robot: &Robot, model: &Model, context: &Context<'_>, runtime: &Runtime) -> String {
    let mut t = modules(context, runtime) + &trig(robot, model) + BASE_PARAMETERS;
    for kernel in context.kernels {
        t += &function(kernel, context);
    }
    t + "\n" + &inverse::function(model)
}

/// Text of the modules and re-exports of the root.
fn modules(context: &Context<'_>, runtime: &Runtime) -> String {
    let effects = context.robot.has_effects();
    let shipped = *runtime == Runtime::Shipped;
    let own = [
        ("pub mod constants", !context.constants.is_empty()),
        (super::dispatch::DECLARED.trim_end().trim_end_matches(';'), true),
        ("pub mod drive", effects && shipped),
        ("pub mod elementary", effects && shipped),
        ("pub mod ik", shipped),
        ("mod implementations", true),
        ("mod joint_drives", effects),
        ("pub mod kernel", true),
        ("mod parameters", true),
        ("pub mod robot", shipped),
        ("pub mod runtime", shipped),
        ("#[cfg(test)]\nmod tests", true),
    ];
    let laws = if effects { "drive, elementary, " } else { "" };
    let passed = [
        (format!("::denavit_runtime::{{{laws}ik, robot, runtime}}"), !shipped),
        ("implementations::Robot".to_string(), true),
        ("joint_drives::*".to_string(), effects),
        ("parameters::*".to_string(), true),
    ];
    let mut t: String = own.iter().filter(|(_, there)| *there).map(|(word, _)| format!("{word};\n")).collect();
    t.push('\n');
    t.extend(passed.iter().filter(|(_, there)| *there).map(|(path, _)| format!("pub use {path};\n")));
    t.push('\n');
    if context.kernels.iter().any(|k| bound(k) == "Real") {
        t += "use elementary::Real;\n";
    }
    t + "use runtime::Scalar;\n\n"
}

const BASE_PARAMETERS: &str = "/// Base parameters from standard ones, `beta = K phi`.
#[must_use]
pub fn base_parameters<S: Scalar>(phi: &[S; STANDARD]) -> [S; BASE] {
    core::array::from_fn(|k| {
        BASE_COEFFICIENTS[k].iter().fold(S::default(), |sum, &(i, c)| sum + phi[i] * S::constant(c))
    })
}
";

/// Text of the form of a function that takes `q`.
fn function(kernel: &Kernel, context: &Context<'_>) -> String {
    let function = kernel.function;
    let (title, meaning) = context.doc(function);
    let name = function.name();
    let zero = kernel.shape.iter().rev().fold("S::default()".to_string(), |inner, n| format!("[{inner}; {n}]"));
    let packed = if has_packed(kernel) { format!(" Packed form: [`kernel::{name}::packed`].") } else { String::new() };
    let write = if has_packed(kernel) { "nonzeros" } else { "dense" };
    format!(
        "\n/// {title}.\n///\n/// {meaning}{packed}\n#[must_use]\n#[inline]\npub fn {name}<S: {}>({}) -> {} {{\n    let mut out = {zero};\n    kernel::{name}::{write}({}, &mut out);\n    out\n}}\n",
        bound(kernel),
        signature(function, "q: &[S; DOF]").replace("SEEDS", &format!("kernel::{name}::SEEDS")),
        array(&kernel.shape),
        call(function, "&Trig::new(q)")
    )
}

/// Text of the sines and cosines of a configuration.
fn trig(robot: &Robot, model: &Model) -> String {
    let any = model.chain().angle_offsets().iter().any(|o| *o != 0.0);
    let angles = if any { "&core::array::from_fn(|i| q[i] + S::constant(ANGLE_OFFSETS[i]))" } else { "q" };
    let body = if parameters::turns(robot) {
        format!("let (sin, cos) = S::sin_cos_all({angles});\n        Self {{ q: *q, sin, cos }}")
    } else {
        "Self { q: *q, sin: [S::default(); DOF], cos: [S::constant(1.0); DOF] }".into()
    };
    format!(
        "/// A configuration with the sines and cosines that all kernels share: make it once per state.\n#[derive(Clone, Copy, Debug, PartialEq)]\npub struct Trig<S> {{\n    /// Positions, rad or m.\n    pub q: [S; DOF],\n    /// Sines of the joint angles, constant offsets (quarter turns apart) included.\n    pub sin: [S; DOF],\n    /// Their cosines.\n    pub cos: [S; DOF],\n}}\n\nimpl<S: Scalar> Trig<S> {{\n    /// Sines and cosines of all joint angles together.\n    #[must_use]\n    #[inline]\n    pub fn new(q: &[S; DOF]) -> Self {{\n        {body}\n    }}\n}}\n\n"
    )
}
