//! Reads the rows of the DH table.

use super::super::reader::{Fields, Findings};
use super::super::yaml::{Kind, Mark, Node};
use super::super::{Angle, Drive, Joint, JointKind, Length, Limits};
use super::{drive, place, provenance};

/// Speed above that of any joint, rad/s, which suggests degrees.
const FASTEST: f64 = 60.0;
/// Angle beyond the travel of any joint, rad, which suggests degrees.
const FURTHEST: f64 = 30.0;

/// Most rows of a table. The symbolic work grows with a power of their number: 50 rows take some
/// seconds, 100 would take a minute and 400 MB for no known robot.
const MOST_ROWS: usize = 50;

/// Reads all rows.
pub(super) fn joints(top: &Fields<'_>, to: &mut Findings) -> Vec<Joint> {
    let Some((node, path)) = top.node("joints") else { return Vec::new() };
    if matches!(&node.kind, Kind::List(items) if items.is_empty()) {
        to.problem(node.mark, &path, "the list is empty", "write one entry per row of the DH table, base to tip");
    }
    if let Kind::List(rows) = &node.kind
        && rows.len() > MOST_ROWS
    {
        let what = format!("{} rows, and the symbolic work is limited to {MOST_ROWS}", rows.len());
        to.problem(node.mark, &path, what, "take out rows that do not move, or describe a part of the chain");
        return (0..rows.len()).map(placeholder).collect();
    }
    let mut joints: Vec<Joint> = Vec::new();
    let mut names: Vec<(String, usize)> = Vec::new();
    for (row, (node, path)) in top.rows("joints", to).unwrap_or_default().into_iter().enumerate() {
        let Some(fields) = top.row("joints", node, &path, to) else {
            joints.push(placeholder(row)); // keeps the count of rows for `links` and spheres
            continue;
        };
        let joint = joint(row, &fields, to);
        if let Some((_, first)) = names.iter().find(|(name, _)| *name == joint.name) {
            let (mark, path) = fields.node("name").map_or_else(|| place(&fields), |(node, path)| (node.mark, path));
            let what = format!("joint {} has the name `{}` of joint {first}", row + 1, joint.name);
            to.problem(mark, &path, what, "give every joint its own name");
        }
        names.push((joint.name.clone(), row + 1));
        joints.push(joint);
    }
    if !joints.is_empty() && joints.iter().all(|joint| joint.kind == JointKind::Fixed) && to.problems.is_empty() {
        let mark = top.key("joints").map_or(node.mark, |(mark, _)| mark);
        to.problem(mark, &path, "every joint is fixed", "at least one must be revolute or prismatic");
    }
    joints
}

fn placeholder(row: usize) -> Joint {
    Joint {
        name: format!("joint{}", row + 1),
        kind: JointKind::Revolute,
        actuated: true,
        alpha: Angle::zero(),
        d: Length::zero(),
        theta: Angle::zero(),
        r: Length::zero(),
        source: None,
        limits: Limits::default(),
        drive: Drive::default(),
    }
}

fn joint(row: usize, fields: &Fields<'_>, to: &mut Findings) -> Joint {
    let kind = match fields.choice("type", to) {
        Some("prismatic") => JointKind::Prismatic,
        Some("fixed") => JointKind::Fixed,
        _ => JointKind::Revolute,
    };
    antecedent(row, fields, to);
    Joint {
        name: fields.text("name", to).unwrap_or_else(|| format!("joint{}", row + 1)),
        kind,
        actuated: actuated(kind, fields, to),
        alpha: fields.angle("alpha", to).unwrap_or_else(Angle::zero),
        d: fields.length("d", to).unwrap_or_else(Length::zero),
        theta: fields.angle("theta", to).unwrap_or_else(Angle::zero),
        r: fields.length("r", to).unwrap_or_else(Length::zero),
        source: provenance::of_joint(fields, to),
        limits: limits(kind, fields, to),
        drive: drive(kind, fields, to),
    }
}

fn antecedent(row: usize, fields: &Fields<'_>, to: &mut Findings) {
    let Some(antecedent) = fields.count("antecedent", to) else { return };
    let Some((node, path)) = fields.node("antecedent").filter(|_| antecedent != row) else { return };
    let what = if antecedent > row {
        format!("row {} follows row {antecedent}, which does not stand before it", row + 1)
    } else {
        format!("row {} follows row {antecedent}, not row {row}: a branched chain is not read yet", row + 1)
    };
    to.problem(
        node.mark,
        &path,
        what,
        format!("order the rows as a serial chain and write {row}, or leave the key out"),
    );
}

fn actuated(kind: JointKind, fields: &Fields<'_>, to: &mut Findings) -> bool {
    let actuated = fields.flag("actuated", to);
    if let (JointKind::Fixed, Some(true), Some((mark, path))) = (kind, actuated, fields.key("actuated")) {
        to.problem(
            mark,
            &path,
            "a fixed joint has no motor",
            "delete the key, or make the joint revolute or prismatic",
        );
    }
    actuated.unwrap_or(kind != JointKind::Fixed)
}

fn drive(kind: JointKind, fields: &Fields<'_>, to: &mut Findings) -> Drive {
    let Some((mark, path)) = fields.key("drive") else { return Drive::default() };
    let unactuated = fields.has("actuated") && fields.node("actuated").is_some_and(|(node, _)| is_false(node));
    if kind == JointKind::Fixed {
        to.problem(
            mark,
            &path,
            "a fixed joint has no drive",
            "delete the key, or make the joint revolute or prismatic",
        );
    } else if unactuated {
        let mend = "delete `drive`, or delete `actuated: false`";
        to.problem(mark, &path, "a joint without a motor has no drive", mend);
    }
    fields.map("drive", to).map(|fields| drive::drive(&fields, to)).unwrap_or_default()
}

fn is_false(node: &Node) -> bool {
    matches!(&node.kind, Kind::Scalar { text, quoted: false } if text == "false")
}

fn limits(kind: JointKind, fields: &Fields<'_>, to: &mut Findings) -> Limits {
    if kind == JointKind::Fixed {
        for name in ["position", "velocity", "acceleration", "jerk", "torque"] {
            if let Some((mark, path)) = fields.key(name) {
                let mend = "delete the key, or make the joint revolute or prismatic";
                to.problem(mark, &path, format!("a fixed joint has no {name} limit"), mend);
            }
        }
        return Limits::default();
    }
    let limits = Limits {
        position: fields.vector::<2>("position", to),
        velocity: fields.number("velocity", to),
        acceleration: fields.number("acceleration", to),
        jerk: fields.number("jerk", to),
        torque: fields.number("torque", to),
    };
    if let (Some([lower, upper]), Some((node, path))) = (limits.position, fields.node("position"))
        && lower >= upper
    {
        let written = match &node.kind {
            Kind::List(items) => items.iter().map(|item| item.kind.describe()).collect::<Vec<_>>().join(" to "),
            _ => format!("{lower} to {upper}"),
        };
        let what = format!("the interval from {written} is empty");
        let mend = if lower > upper { "write the lower limit first" } else { "write a lower and an upper limit" };
        to.problem(node.mark, &path, what, mend);
    }
    if kind == JointKind::Revolute {
        let furthest = limits.position.map(|[lower, upper]| lower.abs().max(upper.abs()));
        suspect_degrees(furthest, FURTHEST, "position", "rad", fields, to);
        suspect_degrees(limits.velocity, FASTEST, "velocity", "rad/s", fields, to);
    }
    limits
}

fn suspect_degrees(value: Option<f64>, most: f64, name: &str, unit: &str, fields: &Fields<'_>, to: &mut Findings) {
    let Some((value, (node, path))) = value.filter(|v| *v > most).zip(fields.node(name)) else { return };
    let mark: Mark = node.mark;
    to.note(mark, &path, format!("{value} {unit} is more than joints reach; if degrees are meant, write {value}deg"));
}
