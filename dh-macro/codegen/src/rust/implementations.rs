//! Prints the traits that every robot implements, in terms of the functions of its module.

use super::kernel_file::bound;
use crate::arm::{Function, Kernel};

/// Constants of the description: name, type, and whether the trait takes a slice of it.
const CONSTANTS: [(&str, &str, bool); 13] = [
    ("NAME", "&'static str", false),
    ("DOF", "usize", false),
    ("ROWS", "usize", false),
    ("STANDARD", "usize", false),
    ("BASE", "usize", false),
    ("JOINT_NAMES", "&'static [&'static str]", true),
    ("STANDARD_NAMES", "&'static [&'static str]", true),
    ("BASE_NAMES", "&'static [&'static str]", true),
    ("GRAVITY", "[f64; 3]", false),
    ("POSITION_LIMITS", "&'static [Option<[f64; 2]>]", true),
    ("VELOCITY_LIMITS", "&'static [Option<f64>]", true),
    ("ACCELERATION_LIMITS", "&'static [Option<f64>]", true),
    ("TORQUE_LIMITS", "&'static [Option<f64>]", true),
];

/// Functions of a trait: name, arguments and type, with `@` for the path of the module.
type Methods = [(&'static str, &'static [(&'static str, &'static str)], &'static str)];

const JOINTS: &str = "&[S; @DOF]";
const Q: (&str, &str) = ("q", JOINTS);
const DQ: (&str, &str) = ("dq", JOINTS);
const DDQ: (&str, &str) = ("ddq", JOINTS);
const TAU: (&str, &str) = ("tau", JOINTS);
const PHI: (&str, &str) = ("phi", "&[S; @STANDARD]");
const BETA: (&str, &str) = ("beta", "&[S; @BASE]");

const KINEMATICS: &Methods = &[
    ("forward_kinematics", &[Q], "[[S; 4]; 3]"),
    ("tool_pose", &[Q], "[[S; 4]; 3]"),
    ("jacobian", &[Q], "[[S; @DOF]; 6]"),
    ("tool_jacobian", &[Q], "[[S; @DOF]; 6]"),
    ("jacobian_dot_velocity", &[Q, DQ], "[S; 6]"),
];

const DYNAMICS: &Methods = &[
    ("base_parameters", &[PHI], "[S; @BASE]"),
    ("inverse_dynamics", &[Q, DQ, DDQ, PHI], "[S; @DOF]"),
    ("inverse_dynamics_base", &[Q, DQ, DDQ, BETA], "[S; @DOF]"),
    ("mass_matrix", &[Q, BETA], "[[S; @DOF]; @DOF]"),
    ("coriolis", &[Q, DQ, BETA], "[S; @DOF]"),
    ("gravity", &[Q, BETA], "[S; @DOF]"),
    ("forward_dynamics", &[Q, DQ, TAU, BETA], "[S; @DOF]"),
    ("regressor", &[Q, DQ, DDQ], "[[S; @STANDARD]; @DOF]"),
    ("base_regressor", &[Q, DQ, DDQ], "[[S; @BASE]; @DOF]"),
    ("payload_regressor", &[Q, DQ, DDQ], "[[S; 10]; @DOF]"),
    ("kinetic_energy_regressor", &[Q, DQ], "[S; @STANDARD]"),
    ("potential_energy_regressor", &[Q], "[S; @STANDARD]"),
];

fn methods(list: &Methods) -> String {
    let one = |(name, arguments, result): &(&str, &[(&str, &str)], &str)| {
        let typed: String = arguments.iter().map(|(a, of)| format!(", {a}: {of}")).collect();
        let names: Vec<&str> = arguments.iter().map(|(a, _)| *a).collect();
        format!("    fn {name}(&self{typed}) -> {result} {{\n        @{name}({})\n    }}\n", names.join(", "))
    };
    list.iter().map(one).collect()
}

/// Text of the implementations for a type. `scalar`: trait bound on the numbers of its dynamics;
/// `module`: path of the functions, with `::`.
pub(super) fn print(scalar: &str, of: &str, module: &str) -> String {
    let constants: String = CONSTANTS
        .iter()
        .map(|(name, kind, slice)| format!("    const {name}: {kind} = {}@{name};\n", if *slice { "&" } else { "" }))
        .collect();
    let text = format!(
        "impl @robot::Description for {of} {{\n{constants}}}\n
impl<S: @runtime::Scalar> @robot::Kinematics<{{ @DOF }}, S> for {of} {{\n{}}}\n
impl<S: {scalar}> @robot::Dynamics<{{ @DOF }}, S> for {of} {{
    type Standard = [S; @STANDARD];
    type Base = [S; @BASE];
    fn standard_values(&self) -> Option<[S; @STANDARD]> {{
        @STANDARD_VALUES.map(|values| values.map(<S as @runtime::Scalar>::constant))
    }}
{}}}\n
impl @robot::InverseKinematics<{{ @DOF }}> for {of} {{
    fn inverse_kinematics(
        &self,
        pose: &[[f64; 4]; 3],
        query: &@ik::Query<'_, {{ @DOF }}>,
    ) -> Result<@ik::Solutions<{{ @DOF }}>, @ik::PoseError> {{
        @inverse_kinematics(pose, query)
    }}
    fn tool_inverse_kinematics(
        &self,
        pose: &[[f64; 4]; 3],
        query: &@ik::Query<'_, {{ @DOF }}>,
    ) -> Result<@ik::Solutions<{{ @DOF }}>, @ik::PoseError> {{
        @tool_inverse_kinematics(pose, query)
    }}
    fn arm(&self) -> @ik::Arm<{{ @DOF }}> {{
        @IK
    }}
    fn redundancy(&self, q: &[f64; @DOF], reference: &@ik::Reference) -> f64 {{
        @IK.redundancy(q, reference)
    }}
}}
",
        methods(KINEMATICS),
        methods(DYNAMICS)
    );
    text.replace('@', module)
}

/// Trait bound on the numbers of the dynamics.
pub(super) fn scalar(kernels: &[Kernel]) -> &'static str {
    let torques = kernels.iter().find(|k| k.function == Function::InverseDynamics);
    if torques.is_some_and(|k| bound(k) == "Real") { "@elementary::Real" } else { "@runtime::Scalar" }
}

/// Text of `src/implementations.rs`.
pub(super) fn file(kernels: &[Kernel]) -> String {
    format!(
        "//! The traits of every robot, for code that is generic over robots.\n\n/// This robot as a type.\n#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]\npub struct Robot;\n\n{}",
        print(scalar(kernels), "Robot", "super::")
    )
}
