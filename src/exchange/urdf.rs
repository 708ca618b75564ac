//! Reader of URDF (<http://wiki.ros.org/urdf/XML>): the elements `link`, `joint` and
//! `transmission`.

use std::collections::BTreeMap;

use dh_codegen::robot::{Inertia, Pose};
use nalgebra::Vector3;

use super::ImportError;
use super::exact::Snap;
use super::tree::{Displacement, Mimic, Tie, Tree, TreeBody, TreeJoint, TreeJointKind};
use super::xml::{self, Element, Mistakes, child, children};

/// Reads the tree of a URDF file. Angles within the tolerance of `snap` become exact.
///
/// # Errors
/// Returns every mistake of the file with its line and column; a file with xacro tags is rejected.
pub fn tree(text: &str, snap: &mut Snap) -> Result<Tree, ImportError> {
    let document = xml::parse(text)?;
    let root = document.root_element();
    let mut found = Mistakes::default();
    refuse_xacro(root, &mut found);
    if !found.0.is_empty() {
        return Err(found.0.into());
    }
    if root.tag_name().name() != "robot" {
        let what = format!("the first element is `{}`", root.tag_name().name());
        found.element(root, what, "a URDF begins with <robot>, MJCF with <mujoco>; other formats are not read");
        return Err(found.0.into());
    }
    let mut reader = Reader { snap, found, tree: empty(root), places: BTreeMap::new() };
    for link in children(root, "link") {
        reader.link(link);
    }
    let joints: Vec<Element<'_>> = children(root, "joint").collect();
    let kept: Vec<Element<'_>> = joints.into_iter().filter(|joint| reader.joint(*joint)).collect();
    reader.mimics(&kept);
    reader.transmissions(root);
    if reader.tree.bodies.is_empty() && reader.found.0.is_empty() {
        reader.found.element(root, "there is no `link`", "check that this is the right file");
    }
    if !reader.found.0.is_empty() {
        reader.found.0.sort_by_key(|problem| (problem.line, problem.column));
        return Err(reader.found.0.into());
    }
    Ok(reader.tree)
}

fn empty(root: Element<'_>) -> Tree {
    Tree {
        name: root.attribute("name").unwrap_or("robot").to_string(),
        format: "URDF",
        gravity: [0.0, 0.0, -9.81],
        bodies: Vec::new(),
        joints: Vec::new(),
        ties: Vec::new(),
        notes: Vec::new(),
    }
}

/// Rejects tags and expressions of xacro that were not expanded.
fn refuse_xacro(root: Element<'_>, found: &mut Mistakes) {
    let is_xacro = |n: &Element<'_>| n.is_element() && n.tag_name().namespace().is_some_and(|s| s.contains("xacro"));
    let expression = |n: &Element<'_>| n.attributes().any(|a| a.value().contains("${") || a.value().contains("$("));
    // A file of macros alone has no other tag, so the first one suffices.
    if let Some(tag) = root.descendants().find(|n| is_xacro(n) || (n.is_element() && expression(n))) {
        let what = match is_xacro(&tag) {
            true => format!("`{}` is a tag of xacro, which is not expanded here", tag.tag_name().name()),
            false => "an expression of xacro stands here, which is not evaluated here".to_string(),
        };
        // Without a definition here, or an included one, the file is a part of another.
        let word = |n: &Element<'_>| n.tag_name().name().to_string();
        let tags: Vec<String> = root.descendants().filter(is_xacro).map(|n| word(&n)).collect();
        let part = !tags.is_empty()
            && !tags.iter().any(|tag| ["macro", "include", "property", "arg", "if", "unless"].contains(&tag.as_str()));
        let mend = match part {
            true => {
                "the macro is not defined in this file: expand the file that includes it, \
                     `xacro THAT.xacro > robot.urdf`, or take the tag out"
            }
            false => {
                "expand the file first: `xacro FILE.xacro > robot.urdf` (ROS 2: `ros2 run xacro xacro`), \
                      or `xacro FILE.xacro | denavit import - --out ROBOT`"
            }
        };
        found.element(tag, what, mend);
    }
}

struct Reader<'a> {
    snap: &'a mut Snap,
    found: Mistakes,
    tree: Tree,
    /// Joint above each body found so far.
    places: BTreeMap<usize, String>,
}

impl Reader<'_> {
    fn link(&mut self, link: Element<'_>) {
        let Some(name) = self.found.required(link, "name") else { return };
        if self.tree.body(name).is_some() {
            self.found.element(link, format!("there are two links `{name}`"), "give each link its own name");
            return;
        }
        let inertia = child(link, "inertial").and_then(|inertial| self.inertial(inertial));
        let shaped = child(link, "visual").or(child(link, "collision")).is_some();
        self.tree.bodies.push(TreeBody { name: name.to_string(), inertia, shaped, site: false });
    }

    /// Mass and tensor about the centre of mass, transformed to the link's origin.
    fn inertial(&mut self, inertial: Element<'_>) -> Option<Inertia> {
        let at = child(inertial, "origin").map_or(Some(Displacement::identity()), |origin| self.origin(origin))?;
        let mass = child(inertial, "mass");
        let tensor = child(inertial, "inertia");
        for (element, name) in [(mass, "mass"), (tensor, "inertia")] {
            if element.is_none() {
                self.found.element(
                    inertial,
                    format!("`{name}` is missing"),
                    "write it, or delete the whole `inertial`",
                );
            }
        }
        let (mass, tensor) = (mass?, tensor?);
        self.found.required(mass, "value")?;
        let m = self.found.number(mass, "value")?;
        // Missing products are zero, but moments are required.
        let mut entry = |name: &str, needed: bool| {
            if needed {
                self.found.required(tensor, name)?;
            }
            if tensor.attribute(name).is_none() { Some(0.0) } else { self.found.number(tensor, name) }
        };
        let i = [
            entry("ixx", true)?,
            entry("iyy", true)?,
            entry("izz", true)?,
            entry("ixy", false)?,
            entry("ixz", false)?,
            entry("iyz", false)?,
        ];
        Some(Inertia { m, ms: [0.0; 3], i }.moved(&at.rows(), &at.origin.into()))
    }

    /// Pose from `xyz`, and `rpy` or (since version 1.2 of the format) `quat_xyzw`.
    fn origin(&mut self, origin: Element<'_>) -> Option<Displacement> {
        let has = |name: &str| origin.attribute(name).is_some();
        let xyz = if has("xyz") { self.found.place(origin, "xyz")? } else { [0.0; 3] };
        if has("quat_xyzw") {
            let [x, y, z, w] = self.found.numbers::<4>(origin, "quat_xyzw")?;
            let turned = self.snap.rotation(Displacement::quaternion([w, x, y, z]));
            if !turned.is_rotation() {
                self.found.element(origin, "the quaternion has no length", "write 0 0 0 1 for no turn");
                return None;
            }
            return Some(Displacement { origin: xyz.into(), ..turned });
        }
        let rpy = if has("rpy") { self.found.numbers::<3>(origin, "rpy")? } else { [0.0; 3] };
        let rpy = rpy.map(|angle| self.snap.angle(angle));
        Some(Displacement::new(Pose { xyz, rpy }.rotation(), xyz))
    }

    /// Reads a joint; false if it is invalid.
    fn joint(&mut self, joint: Element<'_>) -> bool {
        let Some(name) = self.found.required(joint, "name") else { return false };
        if self.tree.joints.iter().any(|j| j.name == name) {
            self.found.element(joint, format!("there are two joints `{name}`"), "give each joint its own name");
            return false;
        }
        let kind = self.kind(joint);
        let ends = [self.end(joint, "parent"), self.end(joint, "child")];
        let origin = child(joint, "origin").map_or(Some(Displacement::identity()), |origin| self.origin(origin));
        let (Some(kind), [Some(parent), Some(body)], Some(origin)) = (kind, ends, origin) else { return false };
        if let Some(other) = self.places.insert(body, name.to_string()) {
            let [body, parent] = [body, parent].map(|b| self.tree.bodies[b].name.clone());
            self.tree.ties.push(Tie {
                what: format!("the joints `{other}` and `{name}` both move the link `{body}`: a closed loop"),
                joints: vec![other, name.to_string()],
                bodies: vec![body, parent],
            });
            return false;
        }
        let mut read = TreeJoint { kind, ..TreeJoint::fixed(name, parent, body, origin) };
        read.endless = joint.attribute("type") == Some("continuous");
        if read.moves() {
            self.motion(joint, &mut read);
        }
        self.tree.joints.push(read);
        true
    }

    fn kind(&mut self, joint: Element<'_>) -> Option<TreeJointKind> {
        Some(match self.found.required(joint, "type")? {
            "revolute" | "continuous" => TreeJointKind::Revolute,
            "prismatic" => TreeJointKind::Prismatic,
            "fixed" => TreeJointKind::Fixed,
            "floating" => TreeJointKind::Other("floating"),
            "planar" => TreeJointKind::Other("planar"),
            other => {
                let what = format!("`{other}` is no type of joint");
                let known = "revolute, continuous, prismatic, fixed, floating or planar";
                self.found.element(joint, what, format!("write {known}"));
                return None;
            }
        })
    }

    /// Index of the link that `parent` or `child` names.
    fn end(&mut self, joint: Element<'_>, which: &'static str) -> Option<usize> {
        let Some(element) = child(joint, which) else {
            self.found.element(joint, format!("`{which}` is missing"), format!("write <{which} link=\"..\"/>"));
            return None;
        };
        let name = self.found.required(element, "link")?;
        let body = self.tree.body(name);
        if body.is_none() {
            self.found.element(element, format!("there is no link `{name}`"), "correct the name, or add the link");
        }
        body
    }

    /// Reads axis, limits and dynamics.
    fn motion(&mut self, joint: Element<'_>, read: &mut TreeJoint) {
        if let Some(axis) = child(joint, "axis")
            && let Some(xyz) = self.found.numbers::<3>(axis, "xyz")
        {
            match xyz.iter().any(|x| *x != 0.0) {
                true => read.axis = Vector3::from(self.snap.direction(xyz)),
                false => self.found.element(axis, "the axis has no length", "write a direction, as in xyz=\"0 0 1\""),
            }
        }
        if let Some(limit) = child(joint, "limit") {
            let mut number = |name: &str| self.found.number(limit, name);
            let (lower, upper) = (number("lower"), number("upper"));
            (read.effort, read.velocity) = (number("effort"), number("velocity"));
            // A missing limit is 0 by the format.
            if lower.is_some() || upper.is_some() {
                read.position = Some([lower.unwrap_or(0.0), upper.unwrap_or(0.0)]);
            }
        }
        if let Some(dynamics) = child(joint, "dynamics") {
            read.damping = self.found.number(dynamics, "damping");
            read.friction = self.found.number(dynamics, "friction");
        }
    }

    /// Reads joints that follow others, once all are known.
    fn mimics(&mut self, joints: &[Element<'_>]) {
        for (index, joint) in joints.iter().enumerate() {
            let Some(mimic) = child(*joint, "mimic") else { continue };
            let Some(name) = self.found.required(mimic, "joint") else { continue };
            let Some(other) = self.tree.joints.iter().position(|j| j.name == name) else {
                self.found.element(mimic, format!("there is no joint `{name}`"), "correct the name");
                continue;
            };
            let multiplier = self.found.number(mimic, "multiplier").unwrap_or(1.0);
            let offset = self.found.number(mimic, "offset").unwrap_or(0.0);
            self.tree.joints[index].mimic = Some(Mimic { joint: other, multiplier, offset });
        }
    }

    /// Reads `mechanicalReduction` of transmissions with one joint.
    fn transmissions(&mut self, root: Element<'_>) {
        for transmission in children(root, "transmission") {
            let joints: Vec<&str> = children(transmission, "joint").filter_map(|j| j.attribute("name")).collect();
            let [name] = joints[..] else { continue };
            let reduction = transmission.descendants().find(|n| n.tag_name().name() == "mechanicalReduction");
            let ratio = reduction.and_then(|r| r.text()).and_then(|text| text.trim().parse::<f64>().ok());
            let joint = self.tree.joints.iter_mut().find(|j| j.name == name);
            if let (Some(ratio), Some(joint)) = (ratio.filter(|r| r.is_finite() && ![0.0, 1.0].contains(r)), joint) {
                joint.gear = Some(ratio);
            }
        }
    }
}
