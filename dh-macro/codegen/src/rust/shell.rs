//! What stands around the kernels: sizes, names, values, sines and cosines, the forms that take
//! `q`.

use core::fmt::Write;

use super::kernel_file::{Context, array, bound, call, has_packed, signature};
use crate::arm::{Kernel, Model};
use crate::robot::{JointKind, Robot};

/// FNV-1a of a text: tells whether a crate was made from this file.
pub(super) fn digest(text: &str) -> u64 {
    text.bytes().fold(0xcbf2_9ce4_8422_2325, |h, b| (h ^ u64::from(b)).wrapping_mul(0x0100_0000_01b3))
}

fn strings(items: &[String]) -> String {
    items.iter().map(|s| format!("    {s:?},\n")).collect()
}

fn options(values: Vec<Option<f64>>) -> String {
    values.iter().map(|v| v.map_or("None".to_string(), |x| format!("Some({x:?})"))).collect::<Vec<_>>().join(", ")
}

/// The body of `src/lib.rs` (or of the macro's module), without the crate's attributes.
pub(super) fn print(robot: &Robot, model: &Model, kernels: &[Kernel], context: &Context<'_>) -> String {
    let mut t = String::new();
    let moving = robot.moving();
    let (n, p, b) = (model.dof(), model.standard().len(), model.base().len());
    let _ = writeln!(
        t,
        "{}pub mod ik;\npub mod kernel;\npub mod runtime;\n#[cfg(test)]\nmod tests;\n\nuse runtime::Scalar;\n",
        if context.constants.is_empty() { "" } else { "pub mod constants;\n" }
    );
    if context.robot.has_effects() {
        t = t.replace("pub mod ik;\n", "pub mod drive;\npub mod elementary;\npub mod ik;\n");
        t = t.replace("use runtime::Scalar;", "use elementary::Real;\nuse runtime::Scalar;");
    }
    let _ = writeln!(t, "/// Name of the robot.\npub const NAME: &str = {:?};", robot.name);
    let _ = writeln!(t, "/// Degrees of freedom.\npub const DOF: usize = {n};");
    let _ = writeln!(t, "/// Rows of the DH table, fixed ones too.\npub const ROWS: usize = {};", robot.joints.len());
    let _ = writeln!(t, "/// Standard parameters: ten per row, then the drives'.\npub const STANDARD: usize = {p};");
    let _ = writeln!(t, "/// Base parameters.\npub const BASE: usize = {b};\n");
    let joints: Vec<String> = moving.iter().map(|&i| robot.joints[i].name.clone()).collect();
    let _ =
        writeln!(t, "/// Joints, in the order of `q`.\npub const JOINT_NAMES: [&str; DOF] = [\n{}];", strings(&joints));
    let _ = writeln!(
        t,
        "/// Standard parameters, in the order of the regressor's columns (SI; tensors about the frame's origin).\npub const STANDARD_NAMES: [&str; STANDARD] = [\n{}];",
        strings(context.standard)
    );
    let _ = writeln!(
        t,
        "/// Base parameters, in the order of the base regressor's columns.\npub const BASE_NAMES: [&str; BASE] = [\n{}];",
        strings(context.base)
    );
    let groupings: Vec<String> = model.base().0.iter().map(|b| b.grouping.clone()).collect();
    let _ = writeln!(
        t,
        "/// What each base parameter groups, in the constants of the robot file.\npub const BASE_GROUPINGS: [&str; BASE] = [\n{}];",
        strings(&groupings)
    );
    let rows: String = model
        .base()
        .0
        .iter()
        .map(|b| {
            let entries: Vec<String> = b.coefficients.iter().map(|(i, c)| format!("({i}, {c:?})")).collect();
            format!("    &[{}],\n", entries.join(", "))
        })
        .collect();
    let _ = writeln!(
        t,
        "/// The same as numbers: index into the standard parameters, and factor.\npub const BASE_COEFFICIENTS: [&[(usize, f64)]; BASE] = [\n{rows}];\n"
    );
    let limits = |f: &dyn Fn(&crate::robot::Limits) -> Option<f64>| {
        options(moving.iter().map(|&i| f(&robot.joints[i].limits)).collect())
    };
    let _ = writeln!(
        t,
        "/// Lower and upper position of each joint, rad or m.\npub const POSITION_LIMITS: [Option<[f64; 2]>; DOF] = [{}];",
        moving.iter().map(|&i| format!("{:?}", robot.joints[i].limits.position)).collect::<Vec<_>>().join(", ")
    );
    let _ = writeln!(
        t,
        "/// Largest speeds, rad/s or m/s.\npub const VELOCITY_LIMITS: [Option<f64>; DOF] = [{}];",
        limits(&|l| l.velocity)
    );
    let _ = writeln!(
        t,
        "/// Largest accelerations, rad/s^2 or m/s^2.\npub const ACCELERATION_LIMITS: [Option<f64>; DOF] = [{}];",
        limits(&|l| l.acceleration)
    );
    let _ = writeln!(
        t,
        "/// Largest torques or forces, N m or N.\npub const TORQUE_LIMITS: [Option<f64>; DOF] = [{}];",
        limits(&|l| l.torque)
    );
    match crate::arm::param::standard_values(robot) {
        Some(values) => {
            let _ = writeln!(
                t,
                "/// The robot file's standard parameters, its tool in the last link.\npub const STANDARD_VALUES: Option<[f64; STANDARD]> = Some([{}]);",
                values.iter().map(|v| format!("{v:?}")).collect::<Vec<_>>().join(", ")
            );
        }
        None => {
            let _ = writeln!(
                t,
                "/// The robot file's standard parameters: it does not have them all.\npub const STANDARD_VALUES: Option<[f64; STANDARD]> = None;"
            );
        }
    }
    let _ = writeln!(
        t,
        "/// Name, multiplications and additions of each function, sines and cosines apart (`DOF` pairs).\npub const OPERATIONS: [(&str, usize, usize); {}] = [\n{}];\n",
        kernels.len(),
        kernels
            .iter()
            .map(|k| {
                let c = k.tape.operations();
                format!("    ({:?}, {}, {}),\n", k.function.name(), c.mul, c.add)
            })
            .collect::<String>()
    );
    if robot.has_effects() {
        t += &super::drive::print(model);
    }
    t += &super::inverse::print(model);
    t += &trig(robot, model);
    t += "/// Base parameters from standard ones, `beta = K phi`.\n#[must_use]\npub fn base_parameters<S: Scalar>(phi: &[S; STANDARD]) -> [S; BASE] {\n    core::array::from_fn(|k| {\n        BASE_COEFFICIENTS[k].iter().fold(S::default(), |sum, &(i, c)| sum + phi[i] * S::constant(c))\n    })\n}\n";
    for kernel in kernels {
        let function = kernel.function;
        let (title, meaning) = context.doc(function);
        let bound = bound(kernel);
        let name = function.name();
        let call = call(function, "&Trig::new(q)");
        let shape = array(&kernel.shape);
        let zero = kernel.shape.iter().rev().fold("S::default()".to_string(), |inner, n| format!("[{inner}; {n}]"));
        let packed =
            if has_packed(kernel) { format!(" Packed form: [`kernel::{name}::packed`].") } else { String::new() };
        let write = if has_packed(kernel) { "nonzeros" } else { "dense" };
        let _ = writeln!(
            t,
            "\n/// {title}.\n///\n/// {meaning}{packed}\n#[must_use]\n#[inline]\npub fn {name}<S: {bound}>({}) -> {shape} {{\n    let mut out = {zero};\n    kernel::{name}::{write}({}, &mut out);\n    out\n}}",
            signature(function, "q: &[S; DOF]").replace("SEEDS", &format!("kernel::{name}::SEEDS")),
            call
        );
    }
    t
}

/// Sines and cosines of one configuration.
fn trig(robot: &Robot, model: &Model) -> String {
    let offsets = model.chain().angle_offsets();
    let any = offsets.iter().any(|o| *o != 0.0);
    let revolute = robot.moving().iter().any(|&i| robot.joints[i].kind == JointKind::Revolute);
    let mut t = String::from(
        "/// A configuration with the sines and cosines that all kernels share: make it once per state.\n#[derive(Clone, Copy, Debug, PartialEq)]\npub struct Trig<S> {\n    /// Positions, rad or m.\n    pub q: [S; DOF],\n    /// Sines of the joint angles, constant offsets (quarter turns apart) included.\n    pub sin: [S; DOF],\n    /// Their cosines.\n    pub cos: [S; DOF],\n}\n\n",
    );
    if any {
        let list: Vec<String> = offsets.iter().map(|o| format!("{o:?}")).collect();
        let _ = writeln!(
            t,
            "/// Added to each joint's angle before its sine is taken, rad (quarter turns are in the kernels).\npub const ANGLE_OFFSETS: [f64; DOF] = [{}];\n",
            list.join(", ")
        );
    }
    let angles = if any { "&core::array::from_fn(|i| q[i] + S::constant(ANGLE_OFFSETS[i]))" } else { "q" };
    let body = if revolute {
        format!("let (sin, cos) = S::sin_cos_all({angles});\n        Self {{ q: *q, sin, cos }}")
    } else {
        "Self { q: *q, sin: [S::default(); DOF], cos: [S::constant(1.0); DOF] }".into()
    };
    let _ = writeln!(
        t,
        "impl<S: Scalar> Trig<S> {{\n    /// Sines and cosines of all joint angles together.\n    #[must_use]\n    #[inline]\n    pub fn new(q: &[S; DOF]) -> Self {{\n        {body}\n    }}\n}}\n"
    );
    t
}
