//! Checks the parsed tree of a robot file and builds the robot, or reports all problems at once.

mod body;
pub(super) mod drive;
mod joint;
pub(super) mod law;
mod log;
mod provenance;

use super::expression::{RESERVED, is_name};
use super::keys;
use super::name;
use super::problem::{Note, Problem, Problems};
use super::reader::{Fields, Findings, join};
use super::yaml::{self, Kind, Mark, shortened};
use super::{Collision, Convention, Cuboid, Effect, Files, Joint, JointKind, Pose, Robot, Sphere, Tool};

/// A robot as read from its file, with notes of the reader.
#[derive(Debug, Clone)]
pub struct Reading {
    /// The robot.
    pub robot: Robot,
    /// Source of the numbers, if stated in the file.
    pub source: Option<String>,
    /// Notes on decimals read as exact angles, values that look like another unit, ...
    pub notes: Vec<Note>,
}

/// Default gravity of a robot file, m/s^2.
const GRAVITY: [f64; 3] = [0.0, 0.0, -9.81];

impl Robot {
    /// Reads a robot file. `files` returns the text of a tool file by the name given for `tool:`
    /// ([`no_files`](super::no_files) if there is none).
    ///
    /// Reports all mistakes together, each with its line and column.
    pub fn from_yaml(text: &str, files: &Files<'_>) -> Result<Reading, Problems> {
        let root = yaml::parse(text).map_err(Problems)?;
        let mut found = Findings::default();
        let top = found.fields(&root, "", &keys::ROBOT);
        let source = top.as_ref().and_then(|top| top.text("source", &mut found));
        let robot = top.map(|top| robot(&top, files, &mut found));
        found.problems.sort_by(|a, b| (&a.file, a.line, a.column).cmp(&(&b.file, b.line, b.column)));
        found.notes.sort_by(|a, b| (&a.file, a.line, a.column).cmp(&(&b.file, b.line, b.column)));
        match robot {
            Some(robot) if found.problems.is_empty() => Ok(Reading { robot, source, notes: found.notes }),
            _ => Err(Problems(found.problems)),
        }
    }

    /// Variant of [`Robot::from_yaml`] for bytes that may not be UTF-8.
    pub fn from_bytes(bytes: &[u8], files: &Files<'_>) -> Result<Reading, Problems> {
        match core::str::from_utf8(bytes) {
            Ok(text) => Self::from_yaml(text, files),
            Err(error) => {
                let good = String::from_utf8_lossy(&bytes[..error.valid_up_to()]);
                let byte = bytes.get(error.valid_up_to()).copied().unwrap_or_default();
                Err(Problems(vec![Problem {
                    file: None,
                    path: String::new(),
                    line: good.matches('\n').count() + 1,
                    column: good.chars().rev().take_while(|&c| c != '\n').count() + 1,
                    what: format!("the byte 0x{byte:02x} is not UTF-8"),
                    mend: "save the file as UTF-8 text".to_string(),
                }]))
            }
        }
    }
}

impl Tool {
    /// Reads a tool file (the keys of a robot file's `tool`). `name` is used if the file states
    /// none.
    pub fn from_yaml(text: &str, name: &str) -> Result<(Self, Vec<Note>), Problems> {
        let mut found = Findings::default();
        let tool = body::tool_text(text, name, &mut found);
        found.problems.sort_by_key(|problem| (problem.line, problem.column));
        match tool {
            Some(tool) if found.problems.is_empty() => Ok((tool, found.notes)),
            _ => Err(Problems(found.problems)),
        }
    }
}

/// Builds the robot, with defaults in place of invalid entries.
fn robot(top: &Fields<'_>, files: &Files<'_>, to: &mut Findings) -> Robot {
    constants(top, to);
    let name = top.text("name", to).unwrap_or_default();
    check_name(&name, top, to);
    let convention = match top.choice("convention", to) {
        Some("standard") => Convention::Standard,
        _ => Convention::Modified,
    };
    let gravity = gravity(top, to);
    let base = top.map("base", to).map(|fields| pose(&fields, to));
    provenance::check(top, to);
    let mut joints = joint::joints(top, to);
    let links = body::links(top, joints.len(), to);
    let tool = body::tool(top, files, to);
    let collision = collision(top, joints.len(), to);
    let effects = top
        .node("effects")
        .map(|(node, path)| drive::effects(node, &path, drive::Origin::Robot, to))
        .unwrap_or_default();
    numbers_in_effects(top, &joints, &effects, to);
    law::laws(top, &mut joints, to);
    let log = top.map("log", to).map(|fields| log::mapping(&fields, to));
    let constants = to.scope.constants();
    Robot { name, convention, constants, gravity, base, joints, links, tool, collision, effects, log }
}

/// Checks that joints and links referenced by effects exist.
fn numbers_in_effects(top: &Fields<'_>, joints: &[Joint], whole: &[Effect], to: &mut Findings) {
    let of_joints = joints.iter().enumerate().flat_map(|(row, j)| j.drive.effects.iter().map(move |e| (Some(row), e)));
    for (row, effect) in of_joints.chain(whole.iter().map(|e| (None, e))) {
        let (key, number) = match (effect, row) {
            (Effect::GearCoupling(e), Some(_)) => ("joint", Some(e.joint)),
            (Effect::LinkInertiaError(e), _) => ("link", e.link),
            _ => continue,
        };
        let named = number.map(|n| n - 1);
        let what = match (key, named) {
            ("joint", Some(k)) if Some(k) == row => format!("joint {} is the motor's own", k + 1),
            (_, Some(k)) if k >= joints.len() => format!("there is no {key} {}", k + 1),
            ("joint", Some(k)) if joints[k].kind == JointKind::Fixed => format!("joint {} does not move", k + 1),
            ("joint", _) if row.is_some_and(|row| joints[row].kind == JointKind::Fixed) => {
                "this joint does not move, so no motor of it turns with another".to_string()
            }
            (_, None) if row.is_none() => "no link is named".to_string(),
            _ => continue,
        };
        let which = if key == "joint" { "another joint that moves" } else { "a link" };
        if let Some((mark, path)) = written(top, row, effect.name(), key) {
            to.problem(mark, &path, what, format!("write the number of {which}, 1 to {}", joints.len()));
        }
    }
}

/// Location of an effect's key: in the drive of a row (or in its friction), or among the effects at
/// the top. If the effect is a bare number or lacks the key, the location of the effect itself.
fn written(top: &Fields<'_>, row: Option<usize>, effect: &str, key: &str) -> Option<(Mark, String)> {
    fn child<'n>((node, path): (&'n yaml::Node, String), name: &str) -> Option<(&'n yaml::Node, String)> {
        let Kind::Map(fields) = &node.kind else { return None };
        let (_, found) = fields.iter().find(|(word, _)| word.text == name)?;
        Some((found, join(&path, name)))
    }
    let place = match row {
        None => child(top.node("effects")?, effect)?,
        Some(row) => {
            let (node, path) = top.node("joints")?;
            let Kind::List(rows) = &node.kind else { return None };
            let (drive, path) = child((rows.get(row)?, format!("{path}[{}]", row + 1)), "drive")?;
            child((drive, path.clone()), effect).or_else(|| {
                let (friction, path) = child((drive, path), "friction")?;
                child((friction, path), effect)
            })?
        }
    };
    let (node, path) = child(place.clone(), key).unwrap_or(place);
    Some((node.mark, path))
}

fn constants(top: &Fields<'_>, to: &mut Findings) {
    let Some((node, path)) = top.node("constants") else { return };
    let Kind::Map(fields) = &node.kind else {
        let mend = "write a mapping of names to numbers: { L1: 0.31, L2: 0.40 }";
        to.problem(node.mark, &path, format!("{} stands here", node.kind.describe()), mend);
        return;
    };
    for (word, node) in fields {
        let path = format!("{path}.{}", shortened(&word.text));
        if RESERVED.contains(&word.text.as_str()) {
            let what = format!("`{}` has a meaning of its own", word.text);
            to.problem(word.mark, &path, what, "give the constant another name");
            continue;
        }
        if !is_name(&word.text) {
            let what = format!("`{}` can't name a constant", shortened(&word.text));
            to.problem(word.mark, &path, what, "use letters, digits and _, a letter first");
            continue;
        }
        // A wrong constant is defined, too: one problem instead of one for every use.
        let value = to.value(node, &path, "a number").map(|(value, _)| value);
        if let Some(value) = value.or_else(|| to.scope.evaluate("1").ok()) {
            to.scope.define(&word.text, value);
        }
    }
}

/// Checks the robot's name, which is also that of the generated crate.
fn check_name(name: &str, top: &Fields<'_>, to: &mut Findings) {
    let Some((node, path)) = top.node("name").filter(|_| !name.is_empty()) else { return };
    if name::is_reserved(name) {
        let what = format!("`{name}` is a reserved word and can't name a crate");
        to.problem(node.mark, &path, what, format!("write {}", name::crate_name(name)));
    } else if name.len() > name::LONGEST {
        let what = format!("the name has {} characters; a crate's name has at most {}", name.len(), name::LONGEST);
        to.problem(node.mark, &path, what, "shorten it");
    } else if !name::is_well_formed(name) {
        let mend =
            format!("write {}: lower case, digits and dashes, a letter first", shortened(&name::crate_name(name)));
        to.problem(node.mark, &path, format!("`{}` can't name a crate", shortened(name)), mend);
    }
}

fn gravity(top: &Fields<'_>, to: &mut Findings) -> [f64; 3] {
    let Some((node, path)) = top.node("gravity") else { return GRAVITY };
    let Some(gravity) = top.vector::<3>("gravity", to) else { return GRAVITY };
    let length = gravity.iter().fold(0.0f64, |sum, g| sum.hypot(*g));
    if length == 0.0 {
        to.note(node.mark, &path, "gravity is 0: masses and first moments will be hard to see");
    } else if !(1.0..=30.0).contains(&length) {
        to.note(node.mark, &path, format!("gravity has the length {length} m/s^2; on Earth it is 9.81"));
    } else if gravity[2] > 0.9 * length {
        to.note(node.mark, &path, "gravity points along +z of the world frame: is the robot hung from the ceiling?");
    }
    gravity
}

/// Reads `xyz` and `rpy`, zero if omitted.
fn pose(fields: &Fields<'_>, to: &mut Findings) -> Pose {
    let unset = Pose::default();
    Pose { xyz: fields.vector("xyz", to).unwrap_or(unset.xyz), rpy: fields.angles("rpy", to).unwrap_or(unset.rpy) }
}

fn collision(top: &Fields<'_>, rows: usize, to: &mut Findings) -> Collision {
    let Some(fields) = top.map("collision", to) else { return Collision::default() };
    let ground = fields.number("ground", to);
    let mut spheres = Vec::new();
    for (node, path) in fields.rows("spheres", to).unwrap_or_default() {
        let Some(sphere) = fields.row("spheres", node, &path, to) else { continue };
        let (link, center) = (sphere.count("link", to), sphere.vector::<3>("center", to));
        let radius = sphere.number("radius", to);
        if let (Some(link), Some((node, path))) = (link, sphere.node("link"))
            && link > rows
        {
            let mend = format!("write the number of a row, 1 to {rows}, or 0 for the base");
            to.problem(node.mark, &path, format!("there is no row {link}"), mend);
        }
        if let (Some(link), Some(center), Some(radius)) = (link, center, radius) {
            spheres.push(Sphere { link, center, radius });
        }
    }
    let mut boxes = Vec::new();
    for (node, path) in fields.rows("boxes", to).unwrap_or_default() {
        let Some(cuboid) = fields.row("boxes", node, &path, to) else { continue };
        let name = cuboid.text("name", to).unwrap_or_else(|| format!("box{}", boxes.len() + 1));
        let (Some(min), Some(max)) = (cuboid.vector::<3>("min", to), cuboid.vector::<3>("max", to)) else { continue };
        if (0..3).any(|i| min[i] >= max[i]) {
            to.problem(
                node.mark,
                &path,
                "the corners of this box are the wrong way round",
                "each entry of min must be less than that of max",
            );
        }
        boxes.push(Cuboid { name, min, max });
    }
    Collision { ground, spheres, boxes }
}

/// Start of a mapping, for problems that concern the whole mapping.
fn place(fields: &Fields<'_>) -> (Mark, String) {
    (fields.mark, fields.path.clone())
}
