//! Prints the constants of an arm's inverse kinematics, and the function that uses them.

use core::fmt::{Debug, Write};

use crate::arm::{Inverse, Model};
use crate::ik::{Axis, Displacement, Family, Method, Six};

/// Axes, one per line.
fn axes(axes: &[Axis], indent: &str) -> String {
    axes.iter().map(|a| format!("{indent}ik::{a:?},\n")).collect()
}

/// Text of an option whose value has a printed form of its own.
fn some<T: Debug>(value: &Option<T>) -> String {
    value.as_ref().map_or("None".into(), |v| format!("Some({v:?})"))
}

fn six(six: &Six) -> String {
    let joints: Vec<String> = six.joints.iter().map(some).collect();
    let method = match &six.method {
        Method::Wrist { center, regional } => {
            format!("ik::Method::Wrist {{ center: {center:?}, regional: ik::Regional::{regional:?} }}")
        }
        Method::ThreeParallel { meet } => format!("ik::Method::ThreeParallel {{ meet: {} }}", some(meet)),
    };
    format!(
        "ik::Six {{\n        axes: [\n{}        ],\n        joints: [{}],\n        reversed: {},\n        method: {method},\n    }}",
        axes(&six.axes, "            "),
        joints.join(", "),
        six.reversed
    )
}

fn family(family: &Family) -> String {
    match family {
        Family::Six(s) => format!("ik::Family::Six({})", six(s)),
        Family::Locked { joint, six: s } => format!("ik::Family::Locked {{ joint: {joint}, six: {} }}", six(s)),
        Family::Swivel(s) => format!(
            "ik::Family::Swivel(ik::Swivel {{\n        axes: [\n{}        ],\n        shoulder: {:?},\n        elbow: {:?},\n        wrist: {:?},\n    }})",
            axes(&s.axes, "            "),
            s.shoulder,
            s.elbow,
            s.wrist
        ),
        Family::Plane(p) => {
            let joints: Vec<String> = p.joints.iter().map(some).collect();
            let lift =
                p.lift.as_ref().map_or("None".into(), |(a, j, before)| format!("Some((ik::{a:?}, {j}, {before}))"));
            format!(
                "ik::Family::Plane(ik::Plane {{\n        h: {:?},\n        axes: [\n{}        ],\n        joints: [{}],\n        lift: {lift},\n    }})",
                p.h,
                axes(&p.axes, "            "),
                joints.join(", ")
            )
        }
        Family::General(g) => format!(
            "ik::Family::General(ik::General {{\n        axes: [\n{}        ],\n        joints: {:?},\n        locked: {},\n        size: {:?},\n        order: {:?},\n    }})",
            axes(&g.axes, "            "),
            g.joints,
            some(&g.locked),
            g.size,
            g.order
        ),
        Family::Slides => "ik::Family::Slides".into(),
        Family::Numerical => "ik::Family::Numerical".into(),
    }
}

/// Text of class, reason, lines and family.
pub(super) fn constants(model: &Model) -> String {
    let inverse = Inverse::new(model.chain());
    let mut t = String::new();
    let _ = writeln!(t, "/// Class of the inverse kinematics.\npub const IK_CLASS: &str = {:?};", inverse.class);
    let _ = writeln!(t, "/// The geometry that makes it so.\npub const IK_REASON: &str = {:?};", inverse.reason);
    let _ = writeln!(
        t,
        "/// Lines of the joints at `q = 0` in world axes, m, and the method of the inverse.\npub const IK: ik::Arm<DOF> = ik::Arm {{\n    axes: [\n{}    ],\n    home: ik::{:?},\n    limits: POSITION_LIMITS,\n    exact: {},\n    family: {},\n}};",
        axes(&inverse.axes, "        "),
        inverse.home,
        inverse.exact,
        family(&inverse.family)
    );
    let tool = model.chain().tool.map_or(Displacement::NONE, |(rotation, shift)| Displacement { rotation, shift });
    let _ = writeln!(
        t,
        "/// The tool frame in the last DH frame, m; nothing where the robot file has no tool.\npub const TOOL: ik::Displacement = ik::{tool:?};"
    );
    t
}

/// Text of the function.
pub(super) fn function(model: &Model) -> String {
    let inverse = Inverse::new(model.chain());
    let redundancy = match &inverse.family {
        Family::Swivel(_) => " `query.redundancy` is the swivel angle, rad.".to_string(),
        Family::Numerical => " There may be postures that the search does not find.".to_string(),
        other => other
            .locked()
            .map_or(String::new(), |joint| format!(" `query.redundancy` is the position of joint {}.", joint + 1)),
    };
    let which = match (&inverse.family, inverse.exact) {
        (Family::Numerical, _) => "Postures, found by search,",
        (_, true) => "All postures",
        (_, false) => {
            "Postures ([`ik::Solutions::lost`] and [`ik::Solutions::uncertain`] say where one may be missing)"
        }
    };
    format!(
        "/// {which} that bring the last DH frame to a pose: the top three rows of `T(0, n)`, m.\n///\n/// {}.{redundancy}\n///\n/// # Errors\n/// If an entry is not finite, or the first three columns are no rotation.\npub fn inverse_kinematics(pose: &[[f64; 4]; 3], query: &ik::Query<'_, DOF>) -> Result<ik::Solutions<DOF>, ik::PoseError> {{\n    IK.solve_inlined(pose, query)\n}}\n\n/// The same for a pose of the tool frame, as [`tool_pose`] gives it; errors are the tool's.\n///\n/// # Errors\n/// Like [`inverse_kinematics`].\npub fn tool_inverse_kinematics(pose: &[[f64; 4]; 3], query: &ik::Query<'_, DOF>) -> Result<ik::Solutions<DOF>, ik::PoseError> {{\n    IK.with_tool(&TOOL).solve(pose, query)\n}}\n",
        capital(&inverse.reason)
    )
}

fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or(String::new(), |c| c.to_uppercase().collect::<String>() + letters.as_str())
}
