//! Prints the module `dispatch` of a crate: functions of `q` for one binary on every processor.

use core::fmt::Write;

use super::kernel_file::{Context, array, bound, has_packed, signature};
use super::parameters;
use crate::arm::{Kernel, Model};

/// Declaration of the module in the crate root.
pub(super) const DECLARED: &str = "#[cfg(feature = \"dispatch\")]\npub mod dispatch;\n";

const HEAD: &str = "//! The functions of `q` once more, each compiled for several instruction sets, one of which is
//! taken at run time: one binary is fast on every processor. The bits are those of the other functions.
//!
//! `level` is [`Level::of_scalars`] for one state and [`Level::highest`] for eight, or a lower one.

use super::runtime::Scalar;
use super::runtime::dispatch::{Level, Numbers, Set, Work, eights, sines_and_cosines};
use super::*;

macro_rules! one {
    ($(#[$doc:meta])* fn $name:ident($($argument:ident: $kind:ty),*) -> $result:ty = $zero:expr, |$out:ident| $flat:expr, |$k:ident| $place:expr) => {
        $(#[$doc])*
        #[must_use]
        pub fn $name(level: Level, q: &[f64; DOF], $($argument: &$kind),*) -> $result {
            struct Of<'a>(&'a [f64; DOF], $(&'a $kind,)* &'a mut $result);
            impl Work for Of<'_> {
                type Result = ();
                #[inline(always)]
                fn run<S: Set>(self) {
                    let Self(q, $($argument,)* $out) = self;
                    let flat = $flat;
                    kernel::$name::entries(&turned::<S>(q), $($argument,)* |$k, x| flat[$place] = x);
                }
            }
            let mut out = $zero;
            level.run(Of(q, $($argument,)* &mut out));
            out
        }
    };
}

macro_rules! eight {
    ($(#[$doc:meta])* fn $name:ident($($argument:ident: $kind:ty),*) -> $result:ty, |$out:ident| $flat:expr, |$k:ident| $place:expr) => {
        $(#[$doc])*
        pub fn $name(level: Level, q: &[[f64; 8]; DOF], $($argument: &$kind,)* out: &mut $result) {
            struct Of<'a>(&'a [[f64; 8]; DOF], $(&'a $kind,)* &'a mut $result);
            impl Work for Of<'_> {
                type Result = ();
                #[inline(always)]
                fn run<S: Set>(self) {
                    let Self(q, $($argument,)* $out) = self;
                    let flat = $flat;
                    let trig = super::turned_eight::<S>(&eights::<S, DOF>(q));
                    kernel::$name::entries(&trig, $(&eights::<S, _>($argument),)* |$k, x: S::Eight| x.store(&mut flat[$place]));
                }
            }
            level.run(Of(q, $($argument,)* out));
        }
    };
}

";

/// Text of `src/dispatch.rs`.
pub(super) fn print(model: &Model, context: &Context<'_>) -> String {
    let mut text = String::from(HEAD) + &turned(model, context);
    for kernel in context.kernels {
        text += &one(kernel, context);
    }
    text += "/// Eight states at once. Entries that are structurally zero are not touched.\npub mod eight {\n    use super::super::*;\n    use super::{Level, Numbers, Set, Work, eights};\n\n";
    for kernel in context.kernels.iter().filter(|kernel| bound(kernel) == "Scalar") {
        text += &eight(kernel, context);
    }
    text + "}\n"
}

/// Text that computes sines and cosines, like `Trig::new`.
fn turned(model: &Model, context: &Context<'_>) -> String {
    let any = model.chain().angle_offsets().iter().any(|o| *o != 0.0);
    let forms =
        [("f64", "", "sines_and_cosines::<S, DOF>(&angles)"), ("S::Eight", "_eight", "S::Eight::sin_cos_all(&angles)")];
    let mut text = String::new();
    for (number, name, call) in forms {
        let offsets = match any {
            true => format!(
                "    let mut angles = *q;\n    for i in 0..DOF {{\n        angles[i] = q[i] + {number}::constant(ANGLE_OFFSETS[i]);\n    }}\n"
            ),
            false => "    let angles = *q;\n".to_string(),
        };
        let number = if number == "f64" { number } else { "<S as Set>::Eight" };
        let offsets = offsets
            .replace("S::Eight::constant", "<S::Eight as Scalar>::constant")
            .replace("f64::constant", "f64::from");
        let body = match parameters::turns(context.robot) {
            true => format!("{offsets}    let (sin, cos) = {call};\n    Trig {{ q: *q, sin, cos }}"),
            false => format!(
                "    Trig {{ q: *q, sin: [<{number} as Scalar>::constant(0.0); DOF], cos: [<{number} as Scalar>::constant(1.0); DOF] }}"
            ),
        };
        let _ = writeln!(
            text,
            "#[inline(always)]\nfn turned{name}<S: Set>(q: &[{number}; DOF]) -> Trig<{number}> {{\n{body}\n}}\n"
        );
    }
    text
}

/// Arguments after `q`, with numbers of this type.
fn arguments(kernel: &Kernel, number: &str) -> String {
    let all = signature(kernel.function, "");
    let name = kernel.function.name();
    let behind = all.split(", ").filter(|argument| !argument.is_empty());
    let typed = behind.map(|argument| argument.replace(": &[S;", &format!(": [{number};")));
    typed.collect::<Vec<_>>().join(", ").replace("SEEDS", &format!("kernel::{name}::SEEDS"))
}

/// Result as a list, and the position of entry `k` in it.
fn place(kernel: &Kernel) -> String {
    let flat = ".as_flattened_mut()".repeat(kernel.shape.len() - 1);
    let flat = if flat.is_empty() { "out".to_string() } else { format!("out{flat}") };
    let at = if has_packed(kernel) { format!("kernel::{}::place(k)", kernel.function.name()) } else { "k".into() };
    format!("|out| {flat}, |k| {at}")
}

fn one(kernel: &Kernel, context: &Context<'_>) -> String {
    let zero = kernel.shape.iter().rev().fold("0.0".to_string(), |inner, n| format!("[{inner}; {n}]"));
    format!(
        "one! {{\n    /// {}.\n    fn {}({}) -> {} = {zero}, {}\n}}\n\n",
        context.doc(kernel.function).0,
        kernel.function.name(),
        arguments(kernel, "f64"),
        array(&kernel.shape).replace("[S;", "[f64;"),
        place(kernel)
    )
}

fn eight(kernel: &Kernel, context: &Context<'_>) -> String {
    format!(
        "    eight! {{\n        /// {}.\n        fn {}({}) -> {}, {}\n    }}\n\n",
        context.doc(kernel.function).0,
        kernel.function.name(),
        arguments(kernel, "[f64; 8]"),
        array(&kernel.shape).replace("[S;", "[[f64; 8];"),
        place(kernel)
    )
}
