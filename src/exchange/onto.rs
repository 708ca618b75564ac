//! Writing a robot file's values into an existing model; meshes, names and comments are kept.

use core::ops::Range;
use std::collections::BTreeMap;

use dh_codegen::robot::effects::TimeDelay;
use dh_codegen::robot::{Inertia, Joint, JointKind, Robot};
use nalgebra::Vector3;
use roxmltree::Document;

use super::chain::nearest_to_zero;
use super::delay;
use super::displacement::Displacement;
use super::exact::Snap;
use super::export::{Exported, about_center, delay_note, effects, list, number, spring};
use super::tree::{Tree, TreeJoint};
use super::xml::{self, Element, child, children};
use super::{ImportError, ModelFormat};
use crate::model::rigid_body::Numeric;
use crate::numerics::prng::Random;

/// Largest difference between the model's link poses and the robot file's, m and entries of
/// rotations.
const SAME: f64 = 1e-6;

/// The model's text with the robot's inertias, friction and limits. `held` gives the positions of
/// joints beside the arm when the robot was identified, rad or m; others are at zero, or at the
/// limit nearest to it.
///
/// # Errors
/// Returns mistakes of the model, and joints of the robot that are missing in it or move
/// differently there.
pub fn onto(robot: &Robot, text: &str, held: &[(String, f64)]) -> Result<Exported, ImportError> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let format = ModelFormat::of(text);
    let tree = format.tree(text, &mut Snap::new(1e-9))?;
    let joints = matched(robot, &tree)?;
    let placed = Placed::new(robot, &tree, &joints, held)?;
    let document = xml::parse(text)?;
    let mut editor = Editor { text, document: &document, edits: Vec::new() };
    let mut left_out = Vec::new();
    for (k, &joint) in joints.iter().enumerate() {
        let row = robot.moving()[k];
        editor.joint(format, &tree.joints[joint].name, &robot.joints[row], &mut left_out);
        let body = tree.joints[joint].child;
        let Some(total) = placed.inertia(robot, k, body) else {
            left_out.push(format!("the inertia of `{}` is not known; the model's stays", tree.bodies[body].name));
            continue;
        };
        let others: Vec<usize> = placed.carried(&tree, k).filter(|&b| b != body).collect();
        let rest = others
            .iter()
            .filter_map(|&b| placed.in_body(&tree, b, body))
            .fold(total, |sum, other| sum.plus(&Inertia::from_array(other.to_array().map(|p| -p))));
        if rest.physical().is_ok() {
            editor.body(format, &tree.bodies[body].name, &rest);
        } else {
            editor.body(format, &tree.bodies[body].name, &total);
            for other in others.iter().filter(|&&b| tree.bodies[b].inertia.is_some_and(|i| i.m != 0.0)) {
                let name = &tree.bodies[*other].name;
                editor.without_inertia(format, name);
                left_out.push(format!(
                    "`{name}` has its inertia in `{}` now: less than nothing was left there",
                    tree.bodies[body].name
                ));
            }
        }
    }
    left_out.extend(effects(robot, format));
    if format == ModelFormat::Mjcf {
        let named = |rows: Vec<(usize, f64)>| -> Vec<(String, f64)> {
            let name = |row| robot.moving().iter().position(|&r| r == row).map(|k| tree.joints[joints[k]].name.clone());
            rows.into_iter().filter_map(|(row, delay)| Some((name(row)?, delay))).collect()
        };
        editor.delays(&named(delay::early(robot)), &named(delay::late(robot)), &mut left_out);
    }
    Ok(Exported { text: editor.applied(), left_out, notes: delay_note(robot, format) })
}

/// The model's joints that correspond to the robot's moving rows, by name.
fn matched(robot: &Robot, tree: &Tree) -> Result<Vec<usize>, ImportError> {
    let one = |&row: &usize| {
        let joint = &robot.joints[row];
        let name = joint.source.as_ref().and_then(|s| s.name.as_ref()).unwrap_or(&joint.name);
        tree.joints.iter().position(|j| j.name == *name && j.moves()).ok_or_else(|| {
            let names: Vec<&str> = tree.joints.iter().filter(|j| j.moves()).map(|j| j.name.as_str()).collect();
            ImportError::arm(
                format!("the model has no moving joint `{name}`"),
                format!(
                    "its joints: {}; a joint's `source: {{ name: .. }}` in the robot file names it",
                    names.join(", ")
                ),
            )
        })
    };
    robot.moving().iter().map(one).collect()
}

/// Poses of the model's bodies in the robot's world.
struct Placed {
    /// Frames of all rows at q = 0.
    all_frames: Vec<Displacement>,
    /// The model's bodies in the same world.
    bodies: Vec<Option<Displacement>>,
    /// The model's joint for each moving row.
    joints: Vec<usize>,
}

impl Placed {
    fn new(robot: &Robot, tree: &Tree, joints: &[usize], held: &[(String, f64)]) -> Result<Self, ImportError> {
        let numeric = Numeric::new(robot);
        let source = |row: usize| {
            let source = robot.joints[row].source.as_ref();
            source.map_or((1.0, 0.0), |s| (s.sign, s.offset))
        };
        let rows = robot.moving();
        let at = |base: usize, q: &[f64]| {
            let beside = |(j, joint): (usize, &TreeJoint)| {
                let given = held.iter().find(|(name, _)| *name == joint.name).map(|(_, q)| *q);
                let free = joint.moves() && joint.mimic.is_none();
                free.then(|| (j, given.unwrap_or(nearest_to_zero(joint.position))))
            };
            let mut positions: BTreeMap<usize, f64> = tree.joints.iter().enumerate().filter_map(beside).collect();
            for (k, &joint) in joints.iter().enumerate() {
                let (sign, offset) = source(rows[k]);
                positions.insert(joint, sign * (q[k] - offset));
            }
            tree.poses(base, &tree.positions(&positions))
        };
        let frames = |q: &[f64]| -> Vec<Displacement> { numeric.frames(q).iter().map(displacement).collect() };
        let still = vec![0.0; rows.len()];
        let offsets = |base: usize, q: &[f64]| -> Vec<Option<Displacement>> {
            let (frames, bodies) = (frames(q), at(base, q));
            let one =
                |(k, &joint): (usize, &usize)| Some(frames[rows[k]].inverse().then(&bodies[tree.joints[joint].child]?));
            joints.iter().enumerate().map(one).collect()
        };
        let moves_alike = |base: &usize| {
            let before = offsets(*base, &still);
            let mut random = Random::new(7);
            (0..5).all(|_| {
                let now = offsets(*base, &random.vector(rows.len(), 1.0));
                before.iter().zip(&now).all(|(a, b)| match (a, b) {
                    (Some(a), Some(b)) => {
                        (a.rotation - b.rotation).amax() < SAME && (a.origin - b.origin).amax() < SAME
                    }
                    _ => false,
                })
            })
        };
        // The world of the robot file is a body above the first joint.
        let mut above = vec![tree.joints[joints[0]].parent];
        while let Some(joint) = tree.joint_above(above[above.len() - 1]).filter(|_| above.len() <= tree.bodies.len()) {
            above.push(tree.joints[joint].parent);
        }
        let base = above.iter().rev().find(|base| moves_alike(base)).ok_or_else(|| {
            ImportError::arm(
                "the model's joints do not move as the robot file's do",
                "use the model that the robot file was imported from",
            )
        })?;
        let all_frames = frames(&still);
        Ok(Self { all_frames, bodies: at(*base, &still), joints: joints.to_vec() })
    }

    /// Bodies that moving row `k` carries.
    fn carried<'a>(&'a self, tree: &'a Tree, k: usize) -> impl Iterator<Item = usize> + 'a {
        let on_row = move |&body: &usize| {
            let mut at = body;
            for _ in 0..tree.bodies.len() {
                let Some(joint) = tree.joint_above(at) else { return false };
                if let Some(row) = self.joints.iter().position(|&j| j == joint) {
                    return row == k;
                }
                at = tree.joints[joint].parent;
            }
            false
        };
        (0..tree.bodies.len()).filter(on_row)
    }

    /// Inertia of another body in a body's frame.
    fn in_body(&self, tree: &Tree, other: usize, body: usize) -> Option<Inertia> {
        let at = self.bodies[body]?.inverse().then(&self.bodies[other]?);
        Some(tree.bodies[other].inertia?.moved(&at.rows(), &at.origin.into()))
    }

    /// Inertia of everything that moving row `k` carries by the robot file, in a body's frame: its
    /// link, the fixed rows behind it, and the tool behind the last.
    fn inertia(&self, robot: &Robot, k: usize, body: usize) -> Option<Inertia> {
        let rows = robot.moving();
        let end = rows.get(k + 1).copied().unwrap_or(robot.joints.len());
        let mut links: Vec<Option<Inertia>> = robot.links.clone();
        links.resize(robot.joints.len(), None);
        let tool = robot.tool.as_ref().and_then(|t| Some(t.inertia.as_ref()?.moved(&t.rotation(), &t.xyz)));
        let mut sum = Inertia::default();
        for row in rows[k]..end {
            let at = self.bodies[body]?.inverse().then(&self.all_frames[row]);
            let mut own = links[row]?;
            if row + 1 == robot.joints.len() {
                own = tool.map_or(own, |tool| own.plus(&tool));
            }
            sum = sum.plus(&own.moved(&at.rows(), &at.origin.into()));
        }
        Some(sum)
    }
}

fn displacement(t: &nalgebra::Matrix4<f64>) -> Displacement {
    let origin: Vector3<f64> = t.fixed_view::<3, 1>(0, 3).into();
    Displacement { rotation: t.fixed_view::<3, 3>(0, 0).into(), origin }
}

/// Replacements in the text.
struct Editor<'a> {
    text: &'a str,
    document: &'a Document<'a>,
    edits: Vec<(Range<usize>, String)>,
}

impl<'a> Editor<'a> {
    fn named(&self, tag: &str, name: &str) -> Option<Element<'a>> {
        let same = |n: &Element<'a>| n.is_element() && n.tag_name().name() == tag && n.attribute("name") == Some(name);
        self.document.descendants().find(same)
    }

    /// Sets an attribute of an element; one with the same numbers, up to rounding, is kept as
    /// written.
    fn set(&mut self, element: Element<'a>, name: &str, values: &[f64]) {
        match element.attribute_node(name) {
            Some(attribute) => {
                let read: Option<Vec<f64>> = attribute.value().split_whitespace().map(|w| w.parse().ok()).collect();
                let alike = |(a, b): (&f64, &f64)| (a - b).abs() <= 1e-13 * a.abs().max(1e-3);
                let same = |read: Vec<f64>| read.len() == values.len() && read.iter().zip(values).all(alike);
                if !read.is_some_and(same) {
                    self.edits.push((attribute.range_value(), list(values)));
                }
            }
            None => {
                let at = element.range().start + 1 + element.tag_name().name().len();
                self.edits.push((at..at, format!(" {name}=\"{}\"", list(values))));
            }
        }
    }

    /// Inserts a new element at the beginning of another one.
    fn insert(&mut self, parent: Element<'a>, new: &str) {
        let range = parent.range();
        match parent.first_child() {
            Some(first) => {
                let line = self.text[..first.range().start].rfind('\n').map_or(0, |k| k + 1);
                let indent: String = self.text[line..].chars().take_while(|c| *c == ' ' || *c == '\t').collect();
                let at = first.range().start;
                self.edits.push((at..at, format!("\n{indent}  {new}")));
            }
            None => {
                let tag = parent.tag_name().name();
                let end = range.start + self.text[range.clone()].rfind("/>").unwrap_or(range.len());
                self.edits.push((end..range.end, format!(">{new}</{tag}>")));
            }
        }
    }

    fn body(&mut self, format: ModelFormat, name: &str, inertia: &Inertia) {
        let Some((m, center, [xx, yy, zz, xy, xz, yz])) = about_center(inertia) else { return };
        let tag = if format == ModelFormat::Urdf { "link" } else { "body" };
        let Some(body) = self.named(tag, name) else { return };
        let inertial = child(body, "inertial");
        if format == ModelFormat::Mjcf {
            let tensor = [xx, yy, zz, xy, xz, yz];
            let new = format!(
                "<inertial pos=\"{}\" mass=\"{}\" fullinertia=\"{}\"/>",
                list(&center),
                number(m),
                list(&tensor)
            );
            return match inertial {
                Some(old) => self.edits.push((old.range(), new)),
                None => self.insert(body, &new),
            };
        }
        let new = format!(
            "<inertial><origin xyz=\"{}\"/><mass value=\"{}\"/><inertia ixx=\"{}\" ixy=\"{}\" ixz=\"{}\" iyy=\"{}\" iyz=\"{}\" izz=\"{}\"/></inertial>",
            list(&center),
            number(m),
            number(xx),
            number(xy),
            number(xz),
            number(yy),
            number(yz),
            number(zz)
        );
        let Some(old) = inertial else { return self.insert(body, &new) };
        let parts = [child(old, "origin"), child(old, "mass"), child(old, "inertia")];
        let [Some(origin), Some(mass), Some(tensor)] = parts else { return self.edits.push((old.range(), new)) };
        self.set(origin, "xyz", &center);
        self.set(origin, "rpy", &[0.0; 3]);
        self.set(mass, "value", &[m]);
        for (name, value) in [("ixx", xx), ("ixy", xy), ("ixz", xz), ("iyy", yy), ("iyz", yz), ("izz", zz)] {
            self.set(tensor, name, &[value]);
        }
    }

    /// Removes the inertia of a body.
    fn without_inertia(&mut self, format: ModelFormat, name: &str) {
        let tag = if format == ModelFormat::Urdf { "link" } else { "body" };
        if let Some(old) = self.named(tag, name).and_then(|body| child(body, "inertial")) {
            self.edits.push((old.range(), String::new()));
        }
    }

    fn joint(&mut self, format: ModelFormat, name: &str, joint: &Joint, left_out: &mut Vec<String>) {
        let Some(element) = self.joint_element(format, name) else {
            return left_out.push(format!("`{name}` has no name of its own in the model: its friction stays"));
        };
        let drive = &joint.drive;
        if format == ModelFormat::Mjcf {
            let known = [
                ("damping", drive.viscous_friction),
                ("frictionloss", drive.coulomb_friction),
                ("armature", drive.rotor_inertia),
                ("stiffness", spring(joint).map(|[k, _]| k)),
                ("springref", spring(joint).map(|[_, rest]| self.in_model(joint, rest))),
            ];
            for (attribute, value) in known {
                match value {
                    Some(v) if v < 0.0 && attribute != "springref" => {
                        left_out.push(format!("{attribute} of `{name}` is negative"));
                    }
                    Some(v) => self.set(element, attribute, &[v]),
                    None => {}
                }
            }
            return;
        }
        let friction = [("damping", drive.viscous_friction), ("friction", drive.coulomb_friction)];
        let known: Vec<(&str, f64)> = friction.into_iter().filter_map(|(n, v)| Some((n, v?))).collect();
        match child(element, "dynamics") {
            Some(dynamics) => known.iter().for_each(|(n, v)| self.set(dynamics, n, &[*v])),
            None if !known.is_empty() => {
                let attributes: Vec<String> = known.iter().map(|(n, v)| format!("{n}=\"{}\"", number(*v))).collect();
                self.insert(element, &format!("<dynamics {}/>", attributes.join(" ")));
            }
            None => {}
        }
        if let Some(limit) = child(element, "limit") {
            let own = [("velocity", joint.limits.velocity), ("effort", joint.limits.torque)];
            own.iter().filter_map(|(n, v)| Some((n, (*v)?))).for_each(|(n, v)| self.set(limit, n, &[v]));
        }
    }

    /// Converts a position of the robot file to the model's zero, sign and unit of angle.
    fn in_model(&self, joint: &Joint, q: f64) -> f64 {
        let source = joint.source.as_ref().map_or(q, |s| s.sign * (q - s.offset));
        let mut compilers = children(self.document.root_element(), "compiler");
        let radian = compilers.any(|c| c.attribute("angle") == Some("radian"));
        if radian || joint.kind == JointKind::Prismatic { source } else { source.to_degrees() }
    }

    /// Sets delays of motors and of torque sensors, given by names in the model. A joint has at
    /// most one of them.
    fn delays(&mut self, early: &[(String, f64)], late: &[(String, f64)], left_out: &mut Vec<String>) {
        let root = self.document.root_element();
        let of_joint = |section: &'static str, tag: &'static str, name: &str| {
            let mut all = children(root, section).flat_map(|list| children(list, tag));
            all.find(|n| n.attribute("joint") == Some(name))
        };
        let [motor, sensor] = [("actuator", "motor"), ("sensor", "jointactuatorfrc")]
            .map(|(section, tag)| move |name: &str| of_joint(section, tag, name));
        for (name, delay) in early {
            self.no_longer_late(sensor(name));
            match motor(name) {
                Some(motor) => self.late(motor, *delay),
                None => left_out.push(format!("{} of `{name}`, which no `motor` of the model moves", TimeDelay::NAME)),
            }
        }
        let mut missing = Vec::new();
        for (name, delay) in late {
            self.no_longer_late(motor(name));
            match sensor(name) {
                Some(sensor) => self.late(sensor, *delay),
                None => missing.push((name.clone(), *delay)),
            }
        }
        let end = self.text[..root.range().end].rfind("</");
        if let Some(end) = end.filter(|_| !missing.is_empty()) {
            self.edits.push((end..end, delay::sensors(&missing)));
        }
    }

    fn no_longer_late(&mut self, element: Option<Element<'a>>) {
        if let Some(old) = element.and_then(|e| e.attribute_node("delay")) {
            self.edits.push((old.range_value(), "0".into()));
        }
    }

    fn late(&mut self, element: Element<'a>, seconds: f64) {
        for (name, value) in delay::attributes(seconds) {
            match element.attribute_node(name) {
                Some(old) => self.edits.push((old.range_value(), value)),
                None => {
                    let at = element.range().start + 1 + element.tag_name().name().len();
                    self.edits.push((at..at, format!(" {name}=\"{value}\"")));
                }
            }
        }
    }

    /// Element of a joint; in URDF, where transmissions name joints too, only the robot's own
    /// children.
    fn joint_element(&self, format: ModelFormat, name: &str) -> Option<Element<'a>> {
        match format {
            ModelFormat::Urdf => {
                children(self.document.root_element(), "joint").find(|j| j.attribute("name") == Some(name))
            }
            ModelFormat::Mjcf => {
                let world = children(self.document.root_element(), "worldbody").flat_map(|w| w.descendants());
                let mut joints = world.filter(|n| n.tag_name().name() == "joint");
                joints.find(|j| j.attribute("name") == Some(name))
            }
        }
    }

    fn applied(mut self) -> String {
        self.edits.sort_by_key(|(range, _)| range.start);
        let (mut out, mut at) = (String::new(), 0);
        for (range, new) in &self.edits {
            out += &self.text[at..range.start.max(at)];
            out += new;
            at = range.end.max(at);
        }
        out + &self.text[at..]
    }
}
