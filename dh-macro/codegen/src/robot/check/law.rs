//! Reads torques in closed form: `law` with its `unit`, in a joint's row or `drive`, or under
//! `effects`, where it applies to every joint with that unit.

use super::super::keys::{LAW, LAW_KEYS, Shape, UNIT};
use super::super::reader::{Fields, Findings, join};
use super::super::torque_law::{Law, unit_of};
use super::super::yaml::{Kind, Mark, Node, Word, shortened};
use super::super::{Joint, JointKind, TorqueLaw};

/// Whether this is a key of a law.
pub(super) fn is_key(word: &Word) -> bool {
    LAW_KEYS.iter().any(|key| key.name == word.text)
}

/// Reads the laws of all joints, after all rows, since they may refer to joints further out.
pub(super) fn laws(top: &Fields<'_>, joints: &mut [Joint], to: &mut Findings) {
    let moving: Vec<JointKind> = joints.iter().map(|j| j.kind).filter(|kind| *kind != JointKind::Fixed).collect();
    let scope = core::mem::take(&mut to.scope);
    let words = Law { joints: &moving, scope: &scope };
    if let Some((node, path)) = top.node("joints")
        && let Kind::List(rows) = &node.kind
    {
        for (k, (row, joint)) in rows.iter().zip(joints.iter_mut()).enumerate() {
            of_joint(row, &format!("{path}[{}]", k + 1), joint, &words, to);
        }
    }
    if let Some((node, path)) = top.node("effects")
        && let Kind::Map(fields) = &node.kind
    {
        of_every_joint(fields, &path, joints, &words, to);
    }
    to.scope = scope;
}

/// Reads a law in the joint's row or in its drive.
fn of_joint(row: &Node, path: &str, joint: &mut Joint, words: &Law<'_>, to: &mut Findings) {
    let Kind::Map(fields) = &row.kind else { return };
    let beside = at_joint(fields, path, joint.kind, words, to);
    let drive = fields.iter().find(|(word, _)| word.text == "drive").map(|(_, node)| &node.kind);
    let Some(Kind::Map(drive)) = drive else {
        joint.drive.law = beside;
        return;
    };
    let within = at_joint(drive, &join(path, "drive"), joint.kind, words, to);
    if let (Some(_), Some(_), Some((word, _))) = (&beside, &within, drive.iter().find(|(word, _)| word.text == LAW)) {
        twice(word.mark, &join(&join(path, "drive"), LAW), "this joint has a law beside its drive", to);
    }
    joint.drive.law = beside.or(within);
}

fn twice(mark: Mark, path: &str, what: &str, to: &mut Findings) {
    to.problem(mark, path, what, "write their sum in one of the two places");
}

/// Reads `law` and `unit` among the keys of a joint of this kind.
pub(in crate::robot) fn at_joint(
    fields: &[(Word, Node)],
    path: &str,
    kind: JointKind,
    words: &Law<'_>,
    to: &mut Findings,
) -> Option<TorqueLaw> {
    let (mark, law, unit) = stated(fields, path, Some(unit_of(kind)), words, to)?;
    if kind == JointKind::Fixed {
        let mend = "delete `law` and `unit`, or make the joint revolute or prismatic";
        to.problem(mark, &join(path, LAW), "a fixed joint has no torque", mend);
        return None;
    }
    (unit == unit_of(kind)).then_some(law)
}

/// Reads a law under `effects`, which applies to every joint with that unit.
fn of_every_joint(fields: &[(Word, Node)], path: &str, joints: &mut [Joint], words: &Law<'_>, to: &mut Findings) {
    let Some((mark, law, unit)) = stated(fields, path, None, words, to) else { return };
    let mut none = true;
    for (row, joint) in joints.iter_mut().enumerate() {
        if joint.kind == JointKind::Fixed || unit_of(joint.kind) != unit {
            continue;
        }
        none = false;
        if joint.drive.law.is_some() {
            twice(mark, &join(path, LAW), &format!("joint {} has a law of its own", row + 1), to);
        }
        joint.drive.law = Some(law.clone());
    }
    if none {
        to.problem(mark, &join(path, LAW), format!("no joint has a torque in {unit}"), "write the unit of a joint");
    }
}

/// Laws of all joints in the `effects` of a file of effects.
pub(in crate::robot) fn of_effects(
    node: &Node,
    path: &str,
    rows: &[JointKind],
    words: &Law<'_>,
    to: &mut Findings,
) -> Vec<(usize, TorqueLaw)> {
    let Kind::Map(fields) = &node.kind else { return Vec::new() };
    let Some((mark, law, unit)) = stated(fields, path, None, words, to) else { return Vec::new() };
    let of = |kind: &JointKind| *kind != JointKind::Fixed && unit_of(*kind) == unit;
    let laws: Vec<_> =
        rows.iter().enumerate().filter(|(_, kind)| of(kind)).map(|(row, _)| (row, law.clone())).collect();
    if laws.is_empty() {
        to.problem(mark, &join(path, LAW), format!("no joint has a torque in {unit}"), "write the unit of a joint");
    }
    laws
}

/// Location of the law's key, the law and its unit; `wanted`: required unit.
fn stated<'f>(
    fields: &'f [(Word, Node)],
    path: &str,
    wanted: Option<&str>,
    words: &Law<'_>,
    to: &mut Findings,
) -> Option<(Mark, TorqueLaw, &'f str)> {
    let of = |name: &str| fields.iter().find(|(word, _)| word.text == name);
    let units = match LAW_KEYS[1].shape {
        Shape::Choice(words) => words.join(" or "),
        _ => String::new(),
    };
    let write = wanted.map_or(units, str::to_string);
    match (of(LAW), of(UNIT)) {
        (None, None) => None,
        (None, Some((word, _))) => {
            let mend = format!("add `{LAW}: \"..\"`, or delete `{UNIT}`");
            to.problem(word.mark, &join(path, UNIT), format!("`{UNIT}` stands here without a `{LAW}`"), mend);
            None
        }
        (Some((word, node)), None) => {
            to.problem(
                word.mark,
                &join(path, LAW),
                format!("the key `{UNIT}` is missing"),
                format!("add `{UNIT}: {write}`"),
            );
            expression(node, path, words, to);
            None
        }
        (Some((word, node)), Some((_, unit))) => {
            let law = expression(node, path, words, to);
            let text = match &unit.kind {
                Kind::Scalar { text, .. } => text.trim(),
                other => {
                    to.problem(
                        unit.mark,
                        &join(path, UNIT),
                        format!("{} stands here", other.describe()),
                        format!("write {write}"),
                    );
                    return None;
                }
            };
            let known = matches!(LAW_KEYS[1].shape, Shape::Choice(words) if words.contains(&text));
            if !known || wanted.is_some_and(|wanted| wanted != text) {
                let what = format!("`{}` is not the unit of this torque", shortened(text));
                to.problem(unit.mark, &join(path, UNIT), what, format!("write {write}"));
                return None;
            }
            Some((word.mark, law?, text))
        }
    }
}

fn expression(node: &Node, path: &str, words: &Law<'_>, to: &mut Findings) -> Option<TorqueLaw> {
    let path = join(path, LAW);
    let Kind::Scalar { text, quoted } = &node.kind else {
        let mend = "write an expression in quotes: \"0.7*sin(3*q2)*sign(dq4)\"";
        to.problem(node.mark, &path, format!("{} stands here", node.kind.describe()), mend);
        return None;
    };
    match TorqueLaw::of_file(text, words) {
        Ok(law) => Some(law),
        Err(error) => {
            let column = node.mark.column + error.offset + usize::from(*quoted);
            to.problem(Mark { line: node.mark.line, column }, &path, error.what, error.mend);
            None
        }
    }
}
