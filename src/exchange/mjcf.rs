//! Reader of MJCF, MuJoCo's format (<https://mujoco.readthedocs.io/en/stable/XMLreference.html>).
//!
//! Reads bodies with their joints, inertias (also those that the format defines by simple shapes),
//! default classes, actuators and equality constraints. Uses `roxmltree` like the URDF reader, as
//! `mjcf-rs` does not report the line of a mistake.

use dh_codegen::robot::Inertia;
use nalgebra::{Matrix3, Vector3};

use super::ImportError;
use super::exact::Snap;
use super::tree::{Displacement, Mimic, Tie, Tree, TreeBody, TreeJoint, TreeJointKind};
use super::xml::{self, Element, Mistakes, child, children};
use settings::{Settings, Value};

mod orientation;
mod settings;
mod shape;

/// Reads the tree of an MJCF file. Angles and rotations within the tolerance of `snap` become
/// exact.
///
/// # Errors
/// Returns every mistake of the file with its line and column, or elements that have to be expanded
/// first.
pub fn tree(text: &str, snap: &mut Snap) -> Result<Tree, ImportError> {
    let document = xml::parse(text)?;
    let root = document.root_element();
    let mut found = Mistakes::default();
    refuse_macros(root, &mut found);
    if !found.0.is_empty() {
        return Err(found.0.into());
    }
    let settings = Settings::new(root, &mut found);
    let world = TreeBody { name: "world".into(), inertia: None, shaped: false, site: false };
    let tree = Tree {
        name: root.attribute("model").unwrap_or("robot").to_string(),
        format: "MJCF",
        gravity: settings.gravity,
        bodies: vec![world],
        joints: Vec::new(),
        ties: Vec::new(),
        notes: settings.notes.clone(),
    };
    let mut reader = Reader { settings, snap, found, tree };
    for worldbody in children(root, "worldbody") {
        reader.contents(worldbody, 0, &Displacement::identity(), None);
    }
    if reader.tree.bodies.len() == 1 && reader.found.0.is_empty() {
        reader.found.element(root, "there is no `body` in `worldbody`", "check that this is the right file");
    }
    reader.actuators(root);
    reader.sensors(root);
    reader.equalities(root);
    reader.tendons(root);
    if !reader.found.0.is_empty() {
        reader.found.0.sort_by_key(|problem| (problem.line, problem.column));
        return Err(reader.found.0.into());
    }
    Ok(reader.tree)
}

/// Rejects elements that MuJoCo's compiler expands.
fn refuse_macros(root: Element<'_>, found: &mut Mistakes) {
    const MACROS: [&str; 7] = ["include", "attach", "replicate", "composite", "flexcomp", "mujocoinclude", "model"];
    let tag = root.descendants().find(|n| n.is_element() && MACROS.contains(&n.tag_name().name()));
    if let Some(tag) = tag {
        let mend = "let MuJoCo write the whole model: `python3 -c \"import mujoco as m; \
                    m.mj_saveLastXML('whole.xml', m.MjModel.from_xml_path('FILE'))\"`, then import whole.xml";
        found.element(tag, format!("`{}` is not expanded here", tag.tag_name().name()), mend);
    }
}

struct Reader<'a, 's> {
    settings: Settings<'a>,
    snap: &'s mut Snap,
    found: Mistakes,
    tree: Tree,
}

impl<'a> Reader<'a, '_> {
    /// Reads bodies, sites and frames in a body; `at` is their frame's pose in the body.
    fn contents(&mut self, element: Element<'a>, body: usize, at: &Displacement, class: Option<&'a str>) {
        for part in element.children().filter(|n| n.is_element()) {
            match part.tag_name().name() {
                "body" => self.body(part, body, at, class),
                "site" => self.site(part, body, at, class),
                "frame" => {
                    let Some(pose) = self.pose(part, "frame", class) else { continue };
                    self.contents(part, body, &at.then(&pose), part.attribute("childclass").or(class));
                }
                _ => {}
            }
        }
    }

    fn new_body(&mut self, element: Element<'a>, name: Option<&str>, site: bool) -> Option<usize> {
        let name = name.map_or_else(|| format!("body{}", self.tree.bodies.len()), str::to_string);
        if self.tree.body(&name).is_some() {
            // A site may have the name of a body; only bodies are needed.
            if !site {
                self.found.element(element, format!("there are two bodies `{name}`"), "give each body its own name");
            }
            return None;
        }
        self.tree.bodies.push(TreeBody { name, inertia: None, shaped: false, site });
        Some(self.tree.bodies.len() - 1)
    }

    fn site(&mut self, site: Element<'a>, body: usize, at: &Displacement, class: Option<&'a str>) {
        let Some(name) = site.attribute("name") else { return };
        let Some(pose) = self.pose(site, "site", class) else { return };
        let Some(index) = self.new_body(site, Some(name), true) else { return };
        self.tree.joints.push(TreeJoint::fixed(format!("site {name}"), body, index, at.then(&pose)));
    }

    fn body(&mut self, body: Element<'a>, parent: usize, at: &Displacement, class: Option<&'a str>) {
        let class = body.attribute("childclass").or(class);
        let Some(pose) = self.pose(body, "body", None) else { return };
        let joints: Vec<(Element<'a>, Option<&'a str>)> = gathered(body, "joint", class);
        if let Some(joint) = children(body, "frame")
            .flat_map(|f| f.descendants())
            .find(|n| n.tag_name().name() == "joint" && n.parent().is_some_and(|p| p.tag_name().name() == "frame"))
        {
            self.found.element(joint, "a joint in a `frame` is not read", "move it out of the frame, into the body");
        }
        let free = child(body, "freejoint");
        let Some(index) = self.new_body(body, body.attribute("name"), false) else { return };
        let name = self.tree.bodies[index].name.clone();
        let mut origin = at.then(&pose);
        let mut carrier = parent;
        if free.is_some() {
            let mut joint = TreeJoint::fixed(format!("freejoint of {name}"), carrier, index, origin);
            joint.kind = TreeJointKind::Other("free");
            self.tree.joints.push(joint);
        } else if joints.is_empty() {
            self.tree.joints.push(TreeJoint::fixed(format!("fixed {name}"), carrier, index, origin));
        }
        for (k, (joint, class)) in joints.iter().enumerate() {
            let last = k + 1 == joints.len();
            let moved = match last {
                true => Some(index),
                false => self.new_body(*joint, Some(&format!("{name}/{}", k + 1)), false),
            };
            let Some(moved) = moved else { return };
            if !last {
                // An intermediate body between two joints of one body.
                self.tree.bodies[moved].inertia = Some(Inertia::default());
            }
            self.joint(*joint, *class, &name, (carrier, moved), origin);
            (carrier, origin) = (moved, Displacement::identity());
        }
        if body.attribute("gravcomp").is_some_and(|g| g.trim() != "0") {
            self.tree.notes.push(format!("gravcomp of `{name}` does not come along"));
        }
        self.inertia(body, index, class);
        self.contents(body, index, &Displacement::identity(), class);
    }

    fn joint(
        &mut self,
        joint: Element<'a>,
        class: Option<&'a str>,
        body: &str,
        (parent, moved): (usize, usize),
        at: Displacement,
    ) {
        let value = |name: &str| self.settings.value(joint, "joint", class, name);
        let kind = match value("type").map_or("hinge", |v| v.text) {
            "hinge" => TreeJointKind::Revolute,
            "slide" => TreeJointKind::Prismatic,
            "ball" => TreeJointKind::Other("ball"),
            "free" => TreeJointKind::Other("free"),
            other => {
                let mend = "write hinge, slide, ball or free";
                return self.found.element(joint, format!("`{other}` is no type of joint"), mend);
            }
        };
        let name = joint.attribute("name").map_or_else(|| format!("{body}_joint"), str::to_string);
        if self.tree.joints.iter().any(|j| j.name == name) {
            return self.found.element(joint, format!("there are two joints `{name}`"), "give each joint its own name");
        }
        let [pos, axis] = ["pos", "axis"].map(value);
        let pos: Vector3<f64> = self.vector(pos).unwrap_or_default().into();
        let axis = self.vector(axis).unwrap_or([0.0, 0.0, 1.0]);
        if axis.iter().all(|x| *x == 0.0) {
            return self.found.element(joint, "the axis has no length", "write a direction, as in axis=\"0 0 1\"");
        }
        let mut read = TreeJoint { kind, ..TreeJoint::fixed(name, parent, moved, at.then(&Displacement::shift(pos))) };
        read.behind = Displacement::shift(-pos);
        read.axis = self.snap.direction(axis).into();
        self.motion(joint, class, &mut read);
        self.tree.joints.push(read);
    }

    /// Reads limits, friction, rotor and spring.
    fn motion(&mut self, joint: Element<'a>, class: Option<&'a str>, read: &mut TreeJoint) {
        let value = |name: &str| self.settings.value(joint, "joint", class, name);
        let unit = if read.kind == TreeJointKind::Revolute { self.settings.angle } else { 1.0 };
        let [range, force] = ["range", "actuatorfrcrange"].map(value);
        let limited = |name: &str| value(name).map_or("auto", |v| v.text);
        let [is_limited, is_force_limited] = ["limited", "actuatorfrclimited"].map(|n| limited(n) != "false");
        let [reference, damping, friction, armature, stiffness, spring, damper] =
            ["ref", "damping", "frictionloss", "armature", "stiffness", "springref", "springdamper"].map(value);
        let position = self.pair(range).filter(|_| is_limited);
        read.position = position.map(|range| range.map(|x| x * unit));
        read.endless = read.position.is_none();
        read.effort = self.pair(force).filter(|_| is_force_limited).and_then(symmetric);
        read.reference = self.number(reference).map_or(0.0, |x| x * unit);
        read.damping = self.number(damping);
        read.friction = self.number(friction);
        read.armature = self.number(armature);
        if damper.is_some() {
            self.tree.notes.push(format!("springdamper of `{}` is not applied", read.name));
        }
        let stiffness = self.number(stiffness);
        let rest = self.number(spring).map_or(0.0, |x| x * unit);
        read.spring = stiffness.map(|k| [k, rest]);
    }

    /// Inertia from `inertial`, or from the body's shapes by the rules of the format.
    fn inertia(&mut self, body: Element<'a>, index: usize, class: Option<&'a str>) {
        let geoms: Vec<(Element<'a>, Option<&'a str>)> = gathered(body, "geom", class);
        self.tree.bodies[index].shaped = !geoms.is_empty();
        let given = child(body, "inertial").filter(|_| !self.settings.inertia_from_geoms);
        if let Some(inertial) = given {
            self.tree.bodies[index].inertia = self.inertial(inertial);
            return;
        }
        let mut sum: Option<Inertia> = None;
        for (geom, class) in geoms {
            match self.geom(geom, class) {
                Some(inertia) => sum = Some(sum.map_or(inertia, |sum| sum.plus(&inertia))),
                None => {
                    self.tree.bodies[index].inertia = None;
                    return;
                }
            }
        }
        self.tree.bodies[index].inertia = sum;
    }

    fn inertial(&mut self, inertial: Element<'a>) -> Option<Inertia> {
        let at = self.pose(inertial, "inertial", None)?;
        self.found.required(inertial, "mass")?;
        let m = self.found.number(inertial, "mass")?;
        let i = if inertial.attribute("fullinertia").is_some() {
            self.found.numbers::<6>(inertial, "fullinertia")?
        } else {
            self.found.required(inertial, "diaginertia")?;
            let [x, y, z] = self.found.numbers::<3>(inertial, "diaginertia")?;
            [x, y, z, 0.0, 0.0, 0.0]
        };
        Some(Inertia { m, ms: [0.0; 3], i }.moved(&at.rows(), &at.origin.into()))
    }

    /// Reads torque limits and gears.
    fn actuators(&mut self, root: Element<'a>) {
        for actuator in children(root, "actuator").flat_map(|list| list.children()).filter(|n| n.is_element()) {
            let Some(name) = actuator.attribute("joint") else { continue };
            let tag = actuator.tag_name().name();
            let value = |name: &str| {
                let own = self.settings.value(actuator, tag, None, name);
                own.or_else(|| self.settings.value(actuator, "general", None, name))
            };
            let [gear, force, control, delay] = ["gear", "forcerange", "ctrlrange", "delay"].map(value);
            let gear = gear.and_then(|v| self.found.list(v.at, v.name)).and_then(|list| list.first().copied());
            let gear = gear.unwrap_or(1.0);
            // The control of a motor is its force before the gear.
            let range = self.pair(force).or_else(|| self.pair(control.filter(|_| tag == "motor")));
            let effort = range.and_then(symmetric).map(|force| force * gear.abs());
            let delay = delay.and_then(|v| self.delay(v.at));
            if delay.is_some() && tag != "motor" {
                self.tree.notes.push(format!("the delay of the {tag} of `{name}` does not come along"));
            }
            let Some(joint) = self.tree.joints.iter_mut().find(|j| j.name == name) else {
                self.found.element(actuator, format!("there is no joint `{name}`"), "correct the name");
                continue;
            };
            if ![0.0, 1.0].contains(&gear) {
                joint.gear = Some(gear);
            }
            joint.effort = joint.effort.or(effort);
            joint.delay = delay.filter(|_| tag == "motor").map(|late| -late);
        }
    }

    /// Reads the delays of torque sensors.
    fn sensors(&mut self, root: Element<'a>) {
        for sensor in children(root, "sensor").flat_map(|list| list.children()).filter(|n| n.is_element()) {
            let Some(delay) = self.delay(sensor) else { continue };
            let tag = sensor.tag_name().name();
            let name = sensor.attribute("joint").filter(|_| tag == "jointactuatorfrc");
            let joint = self.tree.joints.iter_mut().find(|j| Some(j.name.as_str()) == name);
            match joint {
                Some(joint) if joint.delay.is_none() => joint.delay = Some(delay),
                Some(joint) => self.tree.notes.push(format!(
                    "`{}` has a motor that acts late and a torque that is read late; only the first comes along",
                    joint.name
                )),
                None => self.tree.notes.push(format!("the delay of a {tag} does not come along")),
            }
        }
    }

    /// A valid, non-zero delay, s.
    fn delay(&mut self, element: Element<'a>) -> Option<f64> {
        let seconds = self.found.number(element, "delay").filter(|d| *d != 0.0)?;
        if !(0.0..10.0).contains(&seconds) {
            self.found.element(element, format!("no delay is of {seconds} s"), "write 0 or more, below 10 s");
            return None;
        }
        Some(seconds)
    }

    /// Notes tendons: they load joints, and a robot file has none.
    fn tendons(&mut self, root: Element<'a>) {
        for tendon in children(root, "tendon").flat_map(|list| list.children()).filter(|n| n.is_element()) {
            let name = tendon.attribute("name").map_or(String::new(), |name| format!(" `{name}`"));
            self.tree.notes.push(format!("the {} tendon{name} does not come along", tendon.tag_name().name()));
        }
    }

    /// Reads joints that follow others, and loops.
    fn equalities(&mut self, root: Element<'a>) {
        for tie in children(root, "equality").flat_map(|list| list.children()).filter(|n| n.is_element()) {
            if tie.attribute("active") == Some("false") {
                continue;
            }
            let named = |names: [&str; 2]| -> Vec<String> {
                names.iter().filter_map(|n| tie.attribute(*n)).map(str::to_string).collect()
            };
            let kind = tie.tag_name().name();
            let (joints, bodies) =
                (named(["joint1", "joint2"]), [named(["body1", "body2"]), named(["site1", "site2"])].concat());
            match (kind, &joints[..]) {
                ("joint", [first, second]) => self.follow(tie, first, second),
                ("connect" | "weld" | "joint", _) => {
                    let name = tie.attribute("name").map_or(String::new(), |name| format!(" `{name}`"));
                    let between = [joints.clone(), bodies.clone()].concat().join("` and `");
                    let what = format!("the equality {kind}{name} ties `{between}`: a closed loop");
                    self.tree.ties.push(Tie { what, joints, bodies });
                }
                _ => self.tree.notes.push(format!("the equality `{kind}` does not come along")),
            }
        }
    }

    fn follow(&mut self, tie: Element<'a>, first: &str, second: &str) {
        let list = self.found.list(tie, "polycoef").unwrap_or_default();
        let coefficient = |k: usize, default: f64| list.get(k).copied().unwrap_or(default);
        let find = |name: &str| self.tree.joints.iter().position(|j| j.name == name);
        let (Some(own), Some(joint)) = (find(first), find(second)) else {
            return self.found.element(
                tie,
                format!("there is no joint `{first}` or no `{second}`"),
                "correct the name",
            );
        };
        let (multiplier, own_zero, zero) =
            (coefficient(1, 1.0), self.tree.joints[own].reference, self.tree.joints[joint].reference);
        let offset = own_zero + coefficient(0, 0.0) - multiplier * zero;
        if (2..5).any(|k| coefficient(k, 0.0) != 0.0) {
            let what = format!("the joint `{first}` follows `{second}` by a polynomial");
            self.tree.ties.push(Tie { what, joints: vec![first.into(), second.into()], bodies: Vec::new() });
        } else {
            self.tree.joints[own].mimic = Some(Mimic { joint, multiplier, offset });
        }
    }

    fn vector(&mut self, value: Option<Value<'a>>) -> Option<[f64; 3]> {
        value.and_then(|v| self.found.numbers::<3>(v.at, v.name))
    }

    fn pair(&mut self, value: Option<Value<'a>>) -> Option<[f64; 2]> {
        value.and_then(|v| self.found.numbers::<2>(v.at, v.name))
    }

    /// First number: the linear part of a possible polynomial.
    fn number(&mut self, value: Option<Value<'a>>) -> Option<f64> {
        let value = value?;
        let list = self.found.list(value.at, value.name)?;
        if list.len() > 1 {
            self.tree.notes.push(format!(
                "{}.{} is a polynomial; only its first number comes along",
                xml::path(value.at),
                value.name
            ));
        }
        list.first().copied()
    }
}

/// Elements of one kind in a body, also in its frames, with their childclass. (The reader of poses
/// applies a frame's pose to a geom.)
fn gathered<'a>(body: Element<'a>, name: &'static str, class: Option<&'a str>) -> Vec<(Element<'a>, Option<&'a str>)> {
    let mut all: Vec<_> = children(body, name).map(|n| (n, class)).collect();
    for frame in children(body, "frame") {
        all.extend(gathered(frame, name, frame.attribute("childclass").or(class)));
    }
    all
}

/// Magnitude of a range that is symmetric about zero.
fn symmetric([lower, upper]: [f64; 2]) -> Option<f64> {
    (lower == -upper && upper > 0.0).then_some(upper)
}

/// Rotation with these columns.
fn from_columns(x: Vector3<f64>, y: Vector3<f64>, z: Vector3<f64>) -> Displacement {
    Displacement { rotation: Matrix3::from_columns(&[x, y, z]), origin: Vector3::zeros() }
}
