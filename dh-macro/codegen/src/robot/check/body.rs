//! Reads links and tool: inertial parameters, and whether they are physically possible.

use super::super::keys;
use super::super::problem::Problem;
use super::super::reader::{Fields, Findings};
use super::super::yaml::{self, Kind, Mark, shortened};
use super::super::{Files, Inertia, Pose, Tool, ToolGeometry};
use super::place;

/// Reads the inertial parameters per row of the DH table.
pub(super) fn links(top: &Fields<'_>, rows: usize, to: &mut Findings) -> Vec<Option<Inertia>> {
    let Some((node, path)) = top.node("links").filter(|(node, _)| !matches!(node.kind, Kind::Null)) else {
        return Vec::new();
    };
    let items = top.rows("links", to).unwrap_or_default();
    if items.len() != rows && matches!(node.kind, Kind::List(_)) {
        let what = format!("the number of links is {}, that of joints {rows}", items.len());
        let mark = top.key("links").map_or(node.mark, |(mark, _)| mark);
        to.problem(mark, &path, what, "write one entry per joint, null where nothing is known");
    }
    items
        .into_iter()
        .map(|(node, path)| {
            if matches!(node.kind, Kind::Null) {
                return None;
            }
            let fields = top.row("links", node, &path, to)?;
            inertia(&fields, "link", to)
        })
        .collect()
}

/// Reads `M`, `MS`, `I`. An impossible body is a problem, unless its values were identified. It is
/// only a note if mass and tensor are each possible and only contradict the first moments: data
/// sheets round, and their tensors are often about another point.
fn inertia(fields: &Fields<'_>, what: &str, to: &mut Findings) -> Option<Inertia> {
    let (m, ms, i) = (fields.number("M", to), fields.vector("MS", to), fields.vector("I", to));
    let identified = fields.flag("identified", to).unwrap_or(false);
    let inertia = Inertia { m: m?, ms: ms?, i: i? };
    if let Err(defect) = inertia.physical() {
        let (mark, path) = place(fields);
        let apart = Inertia { ms: [0.0; 3], ..inertia }.physical().is_ok() && inertia.m > 0.0;
        if identified {
            to.note(mark, &path, format!("no body is like this identified {what}: {defect}"));
        } else if apart {
            let advice =
                "look whether I is about the frame's origin (not the centre of mass), and MS is mass times centre";
            to.note(mark, &path, format!("no body is like this {what}: {defect}; {advice}"));
        } else {
            let mend = "MS is mass times centre of mass, I is about the frame's origin (not the centre of mass); \
                        values from an identification may carry `identified: true`";
            to.problem(mark, &path, format!("no body is like this {what}: {defect}"), mend);
        }
    }
    Some(inertia)
}

/// Reads the tool, from here or from a separate file.
pub(super) fn tool(top: &Fields<'_>, files: &Files<'_>, to: &mut Findings) -> Option<Tool> {
    let (node, path) = top.node("tool")?;
    match &node.kind {
        Kind::Null => None,
        Kind::Scalar { text, .. } => tool_file(text.trim(), node.mark, &path, files, to),
        _ => top.map("tool", to).and_then(|fields| tool_fields(&fields, "tool", to)),
    }
}

fn tool_file(name: &str, mark: Mark, path: &str, files: &Files<'_>, to: &mut Findings) -> Option<Tool> {
    if !(name.ends_with(".yaml") || name.ends_with(".yml")) {
        let mend = "write the name of a .yaml file, relative to this one, as in tools/roller.yaml, or the tool itself";
        to.problem(mark, path, format!("`{}` is not the name of a tool file", shortened(name)), mend);
        return None;
    }
    let text = match files(name) {
        Ok(text) => text,
        Err(error) => {
            to.problem(
                mark,
                path,
                format!("the tool file can't be read: {error}"),
                "its name is relative to this file",
            );
            return None;
        }
    };
    let mut found = Findings { file: Some(name.to_string()), ..Findings::default() };
    let stem = name.rsplit('/').next().and_then(|file| file.rsplit_once('.')).map_or(name, |(stem, _)| stem);
    let tool = tool_text(&text, stem, &mut found);
    to.problems.append(&mut found.problems);
    to.notes.append(&mut found.notes);
    tool
}

/// Reads a tool from the text of its file; `name` is used if the file states none.
pub(super) fn tool_text(text: &str, name: &str, found: &mut Findings) -> Option<Tool> {
    match yaml::parse(text) {
        Ok(root) => {
            let fields = found.fields(&root, "", &keys::TOOL);
            fields.and_then(|fields| tool_fields(&fields, name, found))
        }
        Err(problems) => {
            let file = found.file.clone();
            found.problems.extend(problems.into_iter().map(|problem| Problem { file: file.clone(), ..problem }));
            None
        }
    }
}

fn tool_fields(fields: &Fields<'_>, name: &str, to: &mut Findings) -> Option<Tool> {
    let name = fields.text("name", to).unwrap_or_else(|| name.to_string());
    fields.text("source", to);
    let pose = fields.map("pose", to);
    let pose = pose.map(|fields| super::pose(&fields, to));
    let inertial = ["M", "MS", "I"];
    let (here, absent): (Vec<&str>, Vec<&str>) = inertial.iter().partition(|name| fields.has(name));
    if !here.is_empty() && !absent.is_empty() {
        let (mark, path) = place(fields);
        let what = format!("{} without {}", here.join(", "), absent.join(", "));
        to.problem(mark, &path, what, "write M, MS and I together, or none of them");
    }
    let inertia = inertia(fields, "tool", to);
    let geometry = fields.map("geometry", to);
    let geometry = geometry.and_then(|geometry| {
        let (length, width) = (geometry.number("length", to), geometry.number("width", to));
        Some(ToolGeometry { length: length?, width: width? })
    });
    let Pose { xyz, rpy } = pose.unwrap_or_default();
    Some(Tool { name, xyz, rpy, inertia, geometry })
}
