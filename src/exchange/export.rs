//! Export of a robot file to URDF or MJCF, as far as each format can express it.

use core::fmt::Write;

use dh_codegen::robot::{Convention, Effect, EffectKind, Inertia, Joint, JointKind, Robot};
use nalgebra::{Matrix3, Vector3};

use super::ModelFormat;
use super::delay;
use super::displacement::Displacement;
use super::exact::pose;

/// An exported model, with reports of what could not be expressed.
#[derive(Debug, Clone, PartialEq)]
pub struct Exported {
    /// Text of the model.
    pub text: String,
    /// A sentence for each part of the robot file that the format cannot express, or that is
    /// unknown.
    pub left_out: Vec<String>,
    /// A sentence for each part that the format expresses only approximately, or only in some of
    /// its versions.
    pub notes: Vec<String>,
}

/// Rounding of a pose, m: essentially none.
const SLACK: f64 = 1e-15;

/// Exports the robot to a format.
pub fn export(robot: &Robot, format: ModelFormat) -> Exported {
    let links = chain(robot);
    let mut left_out = Vec::new();
    let text = match format {
        ModelFormat::Urdf => urdf(robot, &links, &mut left_out),
        ModelFormat::Mjcf => mjcf(robot, &links, &mut left_out),
    };
    left_out.extend(effects(robot, format));
    Exported { text, left_out, notes: delay_note(robot, format) }
}

/// A link whose frame is on its joint's axis.
struct LinkOut<'a> {
    /// Joint that moves the link; `None`: the tool.
    joint: Option<&'a Joint>,
    name: String,
    /// Pose of its frame in the frame of the previous link, with the joint at 0.
    at: Displacement,
    inertia: Option<Inertia>,
}

/// Links from the base to the tool.
fn chain(robot: &Robot) -> Vec<LinkOut<'_>> {
    let turn = |axis: Vector3<f64>, (s, c): (f64, f64)| {
        let k = axis.cross_matrix();
        Displacement { rotation: Matrix3::identity() + k * s + k * k * (1.0 - c), origin: Vector3::zeros() }
    };
    let start = robot.base.as_ref().map_or_else(Displacement::identity, |b| Displacement::new(b.rotation(), b.xyz));
    let mut links = Vec::new();
    // Pose, in the frame of the previous link, where the next row starts.
    let mut before = start;
    for (row, joint) in robot.joints.iter().enumerate() {
        let across = turn(Vector3::x(), joint.alpha.sin_cos()).then(&Displacement::shift(Vector3::x() * joint.d.value));
        let along = turn(Vector3::z(), joint.theta.sin_cos()).then(&Displacement::shift(Vector3::z() * joint.r.value));
        let known = robot.links.get(row).copied().flatten();
        let (at, inertia) = match robot.convention {
            Convention::Modified => (before.then(&across).then(&along), known),
            Convention::Standard => {
                let moved = |i: Inertia| i.moved(&across.rows(), &across.origin.into());
                (before.then(&along), known.map(moved))
            }
        };
        before = if robot.convention == Convention::Modified { Displacement::identity() } else { across };
        links.push(LinkOut { joint: Some(joint), name: format!("{}_link", joint.name), at, inertia });
    }
    if let Some(tool) = &robot.tool {
        let at = before.then(&Displacement::new(tool.rotation(), tool.xyz));
        links.push(LinkOut { joint: None, name: tool.name.clone(), at, inertia: tool.inertia });
    }
    links
}

/// Shortest decimal that reads back to the same bits.
pub(super) fn number(value: f64) -> String {
    let text = format!("{:?}", value + 0.0);
    text.strip_suffix(".0").map_or(text.clone(), str::to_string)
}

pub(super) fn list(values: &[f64]) -> String {
    values.iter().map(|v| number(*v)).collect::<Vec<_>>().join(" ")
}

/// Text escaped for an attribute.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;")
}

/// Mass, kg, centre of mass, m, and tensor about it, `XX YY ZZ XY XZ YZ`, kg m^2; `None` for a
/// massless link.
pub(super) fn about_center(inertia: &Inertia) -> Option<(f64, [f64; 3], [f64; 6])> {
    if inertia.m == 0.0 {
        return None;
    }
    let identity = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let center = inertia.ms.map(|s| s / inertia.m);
    Some((inertia.m, center, inertia.moved(&identity, &center.map(|c| -c)).i))
}

/// Pose of the robot's world in URDF's, where gravity points along -z.
fn upright(robot: &Robot, left_out: &mut Vec<String>) -> Displacement {
    let gravity = Vector3::from(robot.gravity);
    let size = gravity.norm();
    if (size - 9.81).abs() > 1e-9 {
        left_out.push(format!("gravity of {size} m/s^2: URDF leaves it to the simulator"));
    }
    let up = -gravity / size.max(1e-300);
    let axis = up.cross(&Vector3::z());
    match (size == 0.0, axis.norm() < 1e-15, up.z > 0.0) {
        (true, ..) | (_, true, true) => Displacement::identity(),
        (_, true, false) => Displacement::turn(&Vector3::x(), core::f64::consts::PI),
        _ => Displacement::turn(&axis.normalize(), axis.norm().atan2(up.z)),
    }
}

fn urdf(robot: &Robot, links: &[LinkOut<'_>], left_out: &mut Vec<String>) -> String {
    let mut t =
        format!("<?xml version=\"1.0\"?>\n<robot name=\"{}\">\n  <link name=\"base\"/>\n", escaped(&robot.name));
    let mut parent = "base".to_string();
    let mut world = upright(robot, left_out);
    for link in links {
        let name = escaped(&link.name);
        let _ = match (link.inertia.as_ref().and_then(about_center), &link.inertia) {
            (Some((m, center, [xx, yy, zz, xy, xz, yz])), _) => writeln!(
                t,
                "  <link name=\"{name}\">\n    <inertial>\n      <origin xyz=\"{}\"/>\n      <mass value=\"{}\"/>\n      \
                 <inertia ixx=\"{}\" ixy=\"{}\" ixz=\"{}\" iyy=\"{}\" iyz=\"{}\" izz=\"{}\"/>\n    </inertial>\n  </link>",
                list(&center),
                number(m),
                number(xx),
                number(xy),
                number(xz),
                number(yy),
                number(yz),
                number(zz)
            ),
            _ => writeln!(t, "  <link name=\"{name}\"/>"),
        };
        if link.inertia.is_none() && link.joint.is_some() {
            left_out.push(format!("the inertia of `{}` is not known", link.name));
        }
        let at = pose(&world.then(&link.at), SLACK);
        world = Displacement::identity();
        let kind = match link.joint.map(|j| (j.kind, j.limits.position)) {
            Some((JointKind::Revolute, Some(_))) => "revolute",
            Some((JointKind::Revolute, None)) => "continuous",
            Some((JointKind::Prismatic, _)) => "prismatic",
            _ => "fixed",
        };
        let joint = link.joint.map_or_else(|| format!("{name}_mount"), |j| escaped(&j.name));
        let _ = writeln!(
            t,
            "  <joint name=\"{joint}\" type=\"{kind}\">\n    <parent link=\"{parent}\"/>\n    <child link=\"{name}\"/>\n    \
             <origin xyz=\"{}\" rpy=\"{}\"/>",
            list(&at.xyz),
            list(&at.rpy.map(|a| a.value))
        );
        if let Some(joint) = link.joint.filter(|j| j.kind != JointKind::Fixed) {
            urdf_motion(&mut t, joint, left_out);
        }
        t += "  </joint>\n";
        parent = name;
    }
    t + "</robot>\n"
}

/// Writes axis, limits and friction of a joint.
fn urdf_motion(t: &mut String, joint: &Joint, left_out: &mut Vec<String>) {
    let limits = &joint.limits;
    let position = match limits.position {
        Some([lower, upper]) => format!("lower=\"{}\" upper=\"{}\" ", number(lower), number(upper)),
        None if joint.kind == JointKind::Prismatic => {
            left_out.push(format!("no limits of position are known of `{}`; 0 stands there", joint.name));
            "lower=\"0\" upper=\"0\" ".to_string()
        }
        None => String::new(),
    };
    for (value, what) in [(limits.velocity, "speed"), (limits.torque, "torque")] {
        if value.is_none() {
            left_out.push(format!("the largest {what} of `{}` is not known; 0 stands there", joint.name));
        }
    }
    let _ = writeln!(
        t,
        "    <axis xyz=\"0 0 1\"/>\n    <limit {position}effort=\"{}\" velocity=\"{}\"/>",
        number(limits.torque.unwrap_or(0.0)),
        number(limits.velocity.unwrap_or(0.0))
    );
    let (damping, friction) = (joint.drive.viscous_friction, joint.drive.coulomb_friction);
    if damping.or(friction).is_some() {
        let [damping, friction] = [damping, friction].map(|v| number(v.unwrap_or(0.0)));
        let _ = writeln!(t, "    <dynamics damping=\"{damping}\" friction=\"{friction}\"/>");
    }
}

fn mjcf(robot: &Robot, links: &[LinkOut<'_>], left_out: &mut Vec<String>) -> String {
    let mut t = format!(
        "<mujoco model=\"{}\">\n  <compiler angle=\"radian\" autolimits=\"true\"/>\n  <option gravity=\"{}\"/>\n  <worldbody>\n",
        escaped(&robot.name),
        list(&robot.gravity)
    );
    for (depth, link) in links.iter().enumerate() {
        let indent = "  ".repeat(depth + 2);
        let r = &link.at.rotation;
        let axes = [r[(0, 0)], r[(1, 0)], r[(2, 0)], r[(0, 1)], r[(1, 1)], r[(2, 1)]];
        let origin: [f64; 3] = link.at.origin.into();
        let _ = writeln!(
            t,
            "{indent}<body name=\"{}\" pos=\"{}\" xyaxes=\"{}\">",
            escaped(&link.name),
            list(&origin),
            list(&axes)
        );
        match (link.inertia.as_ref().and_then(about_center), link.joint) {
            (Some((m, center, tensor)), _) => {
                let (m, center, tensor) = (number(m), list(&center), list(&tensor));
                let _ = writeln!(t, "{indent}  <inertial pos=\"{center}\" mass=\"{m}\" fullinertia=\"{tensor}\"/>");
            }
            (None, Some(joint)) if joint.kind != JointKind::Fixed => {
                left_out.push(format!("`{}` has no inertia, and MuJoCo moves no body without one", link.name));
            }
            _ => {}
        }
        if let Some((_, _, [xx, yy, zz, xy, xz, yz])) = link.inertia.as_ref().and_then(about_center) {
            let tensor = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
            let smallest = tensor.symmetric_eigenvalues().min();
            if smallest <= 1e-15 || link.inertia.is_some_and(|i| i.physical().is_err()) {
                left_out.push(format!(
                    "`{}` has a principal moment of {smallest:.1e} kg m^2; MuJoCo takes bodies that can be and have some extent",
                    link.name
                ));
            }
        }
        if let Some(joint) = link.joint.filter(|j| j.kind != JointKind::Fixed) {
            mjcf_joint(&mut t, joint, &indent, left_out);
        }
    }
    for depth in (0..links.len()).rev() {
        let _ = writeln!(t, "{}</body>", "  ".repeat(depth + 2));
    }
    if robot.joints.iter().any(|j| j.limits.velocity.is_some()) {
        left_out.push("the largest speeds of the joints".to_string());
    }
    t += "  </worldbody>\n  <actuator>\n";
    for joint in robot.joints.iter().filter(|j| j.kind != JointKind::Fixed && j.actuated) {
        let name = escaped(&joint.name);
        let range =
            joint.limits.torque.map_or(String::new(), |l| format!(" ctrlrange=\"{0} {1}\"", number(-l), number(l)));
        let early = delay::of_motor(robot, joint);
        let _ = writeln!(t, "    <motor name=\"{name}\" joint=\"{name}\"{range}{early}/>");
    }
    let late = delay::late(robot).into_iter().map(|(row, delay)| (escaped(&robot.joints[row].name), delay));
    t + "  </actuator>\n" + &delay::sensors(&late.collect::<Vec<_>>()) + "</mujoco>\n"
}

fn mjcf_joint(t: &mut String, joint: &Joint, indent: &str, left_out: &mut Vec<String>) {
    let kind = if joint.kind == JointKind::Prismatic { "slide" } else { "hinge" };
    let _ = write!(t, "{indent}  <joint name=\"{}\" type=\"{kind}\" axis=\"0 0 1\"", escaped(&joint.name));
    if let Some(range) = joint.limits.position {
        let _ = write!(t, " range=\"{}\"", list(&range));
    }
    let drive = &joint.drive;
    let known = [
        ("damping", drive.viscous_friction),
        ("frictionloss", drive.coulomb_friction),
        ("armature", drive.rotor_inertia),
    ];
    for (name, value) in known {
        match value {
            Some(v) if v < 0.0 => left_out.push(format!("{name} of `{}` is negative", joint.name)),
            Some(v) if v > 0.0 => drop(write!(t, " {name}=\"{}\"", number(v))),
            _ => {}
        }
    }
    if let Some([stiffness, rest]) = spring(joint) {
        let _ = write!(t, " stiffness=\"{}\" springref=\"{}\"", number(stiffness), number(rest));
    }
    *t += "/>\n";
}

/// Stiffness and rest position of a joint's spring, if it is linear on both sides: the format has
/// no other.
pub(super) fn spring(joint: &Joint) -> Option<[f64; 2]> {
    let spring = joint.drive.effects.iter().find_map(|effect| match effect {
        Effect::JointSpring(spring) if spring.is_linear() => Some(*spring),
        _ => None,
    })?;
    Some([spring.stiffness?, spring.rest()])
}

/// Entries that the format cannot express, a sentence each.
pub(super) fn effects(robot: &Robot, format: ModelFormat) -> Vec<String> {
    let written = |joint: &Joint, effect: &Effect| match effect.kind() {
        EffectKind::JointSpring => spring(joint).is_some(),
        EffectKind::TimeDelay => true,
        _ => false,
    };
    let mjcf = format == ModelFormat::Mjcf;
    let mut left_out = Vec::new();
    for joint in &robot.joints {
        let drive = &joint.drive;
        let nonzero = |value: Option<f64>| value.is_some_and(|v| v != 0.0);
        if !joint.actuated && joint.kind != JointKind::Fixed && !mjcf {
            left_out.push(format!("that `{}` has no motor", joint.name));
        }
        if nonzero(drive.rotor_inertia) && !mjcf {
            left_out.push(format!("the rotor inertia of `{}`", joint.name));
        }
        if nonzero(drive.offset) {
            left_out.push(format!("the constant torque of `{}`", joint.name));
        }
        let said = |effect: &&Effect| mjcf && written(joint, effect);
        let unsaid = drive.effects.iter().filter(|effect| !said(effect));
        left_out.extend(unsaid.map(|effect| format!("{} of `{}`", effect.name(), joint.name)));
        left_out.extend(drive.law.iter().map(|_| format!("the law of `{}`", joint.name)));
    }
    let whole = robot.effects.iter().filter(|effect| !(mjcf && effect.kind() == EffectKind::TimeDelay));
    left_out.extend(whole.map(|effect| format!("{} of the robot", effect.name())));
    if mjcf {
        left_out.extend(delay::without_motor(robot));
    }
    left_out
}

/// Requirements on a simulator if a joint has a delay.
pub(super) fn delay_note(robot: &Robot, format: ModelFormat) -> Vec<String> {
    if format == ModelFormat::Mjcf { delay::note(robot).into_iter().collect() } else { Vec::new() }
}
