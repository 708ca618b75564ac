//! Checks the form of provenance entries, and reads the source of joints.

use super::super::JointSource;
use super::super::reader::{Fields, Findings};

/// Checks `provenance:` at the top.
pub(super) fn check(top: &Fields<'_>, to: &mut Findings) {
    for (node, path) in top.rows("provenance", to).unwrap_or_default() {
        let Some(run) = top.row("provenance", node, &path, to) else { continue };
        ["command", "version"].iter().for_each(|key| drop(run.text(key, to)));
        ["options", "found"].iter().for_each(|key| run.texts(key, to));
        for (node, path) in run.rows("files", to).unwrap_or_default() {
            let Some(file) = run.row("files", node, &path, to) else { continue };
            ["for", "path", "sha256"].iter().for_each(|key| drop(file.text(key, to)));
        }
    }
}

/// Reads `source:` of a joint.
pub(super) fn of_joint(joint: &Fields<'_>, to: &mut Findings) -> Option<JointSource> {
    let source = joint.map("source", to)?;
    let sign = source.number("sign", to);
    if let (Some(sign), Some((node, path))) = (sign, source.node("sign"))
        && sign.abs() != 1.0
    {
        to.problem(node.mark, &path, format!("the sign is {sign}"), "write 1 or -1");
    }
    let offset = source.number("offset", to).unwrap_or(0.0);
    Some(JointSource { name: source.text("name", to), sign: sign.unwrap_or(1.0), offset })
}
