//! The file of a simulation: effects of joints and of the robot, sensors, control, solver.

use super::super::problem::{Problems, closest};
use super::super::reader::{Findings, join};
use super::super::yaml::{self, Kind, Mark, Node, Word, shortened};
use super::super::{Effect, EffectKind, Effects, JointKind, Note, Robot};
use super::drive;

/// Content of such a file. Every part may be left out.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct SimulationFile {
    /// Effects beyond those of the robot file.
    pub effects: Effects,
    /// Of `sensors`, `control`, `solver`: section, key (`torque_noise_color.std` of a mapping) and
    /// value.
    pub settings: Vec<(&'static str, &'static str, Setting)>,
    /// Action or observation of the reader.
    pub notes: Vec<Note>,
}

/// The value of a setting.
#[derive(Debug, Clone, PartialEq)]
pub enum Setting {
    /// One number, or one for each joint.
    Numbers(Vec<f64>),
    /// Yes or no.
    Flag(bool),
    /// One of the words that are known there.
    Word(&'static str),
}

/// Value of a key of a section.
enum Form {
    Number,
    /// A number, or a list with one for each joint.
    Each,
    Flag,
    Words(&'static [&'static str]),
}

struct Known {
    section: &'static str,
    key: &'static str,
    form: Form,
    doc: &'static str,
}

const fn known(section: &'static str, key: &'static str, form: Form, doc: &'static str) -> Known {
    Known { section, key, form, doc }
}

use Form::{Each, Flag, Number, Words};

const SECTIONS: [&str; 5] = ["joints", "effects", "sensors", "control", "solver"];

static KNOWN: [Known; 24] = [
    known("sensors", "rate", Number, "samples per second, Hz"),
    known("sensors", "encoder", Each, "step of the encoders, rad; 0 for none"),
    known("sensors", "position_noise", Each, "white noise of the positions, standard deviation, rad"),
    known("sensors", "torque_noise", Each, "white noise of the torques, standard deviation, N m"),
    known("sensors", "torque_noise_color.std", Each, "coloured noise of the torques, standard deviation, N m"),
    known("sensors", "torque_noise_color.corner", Number, "its corner frequency, Hz"),
    known("sensors", "torque_step", Each, "step of the torque sensors, N m; 0 for none"),
    known("sensors", "latency", Number, "age of all samples at their stamp, s"),
    known("sensors", "jitter", Number, "of the sampling instants, standard deviation, s"),
    known("sensors", "torque", Words(&["motor", "link"]), "the side of the gear that `tau` is of"),
    known("sensors", "position", Words(&["motor", "link"]), "the side of the gear that `q` is of"),
    known("sensors", "dq", Flag, "whether `dq` is recorded"),
    known("sensors", "velocity_noise", Each, "white noise of `dq`, standard deviation, rad/s"),
    known("sensors", "qd", Flag, "whether `qd` is recorded"),
    known("sensors", "temp", Flag, "whether `temp` is recorded"),
    known("sensors", "wrench", Flag, "whether the external wrench is recorded"),
    known("control", "mode", Words(&["position", "pd", "torque", "free", "exact"]), "what drives the arm"),
    known("control", "kp", Each, "position gain, N m/rad"),
    known("control", "kd", Each, "velocity gain, N m s/rad"),
    known("control", "bandwidth", Number, "what default gains are made for, rad/s"),
    known("control", "damping", Number, "damping ratio that default gains are made for"),
    known("solver", "method", Words(&["auto", "rosenbrock", "dormand-prince"]), "ROS34PW2 or Dormand and Prince 5(4)"),
    known("solver", "tolerance", Number, "relative error of a step"),
    known("solver", "step", Number, "longest step, s"),
];

impl SimulationFile {
    /// Reads the file for a robot; joints stand there by number or name. All mistakes are reported
    /// together.
    pub fn from_yaml(text: &str, robot: &Robot) -> Result<Self, Problems> {
        let says_something = |line: &str| !line.trim().is_empty() && !line.trim_start().starts_with('#');
        if !text.lines().any(says_something) {
            return Ok(Self::default());
        }
        let root = yaml::parse(text).map_err(Problems)?;
        let mut found = Findings::default();
        let mut file = Self::default();
        match &root.kind {
            Kind::Map(fields) => {
                for (word, node) in fields {
                    let path = shortened(&word.text);
                    match word.text.as_str() {
                        "joints" => joints(node, &path, robot, &mut file.effects.joints, &mut found),
                        "effects" => {
                            file.effects.robot = drive::effects(node, &path, drive::Origin::Simulation, &mut found)
                        }
                        "sensors" | "control" | "solver" => section(word, node, &mut file, &mut found),
                        other => {
                            let mend = match closest(other, SECTIONS) {
                                Some(close) => format!("did you mean `{close}`?"),
                                None => format!("the keys of a file of effects are {}", SECTIONS.join(", ")),
                            };
                            found.problem(
                                word.mark,
                                &path,
                                format!("`{path}` is not a key of a file of effects"),
                                mend,
                            );
                        }
                    }
                }
            }
            Kind::Null => {}
            other => {
                let mend = format!("a file of effects is a mapping with the keys {}", SECTIONS.join(", "));
                found.problem(root.mark, "", format!("{} stands here", other.describe()), mend);
            }
        }
        if found.problems.is_empty() {
            file.notes = found.notes;
            return Ok(file);
        }
        found.problems.sort_by_key(|p| (p.line, p.column));
        Err(Problems(found.problems))
    }
}

/// A mapping of joints to effects, or a list of mappings with `joint` in each.
fn joints(node: &Node, path: &str, robot: &Robot, out: &mut Vec<(usize, Effect)>, to: &mut Findings) {
    let mut seen = Vec::new();
    match &node.kind {
        Kind::Null => {}
        Kind::Map(fields) => {
            for (word, node) in fields {
                let path = format!("{path}.{}", shortened(&word.text));
                let row = once(row(&word.text, word.mark, &path, robot, to), word.mark, &path, &mut seen, to);
                match &node.kind {
                    Kind::Map(fields) => {
                        let effects = drive::effects_of_joint(fields, &path, to);
                        out.extend(row.iter().flat_map(|&row| effects.iter().map(move |e| (row, e.clone()))));
                    }
                    other => {
                        let [gap, offset] = [EffectKind::Backlash, EffectKind::TorqueOffset];
                        let mend = format!("write a mapping of effects: {{ {gap}: {{}}, {offset}: {{ TO: 0.5 }} }}");
                        to.problem(node.mark, &path, format!("{} stands here", other.describe()), mend);
                    }
                }
            }
        }
        Kind::List(items) => {
            for (k, item) in items.iter().enumerate() {
                let path = format!("{path}[{}]", k + 1);
                let Kind::Map(fields) = &item.kind else {
                    let mend = "write a mapping with the joint and its effects: { joint: 3, backlash: {} }";
                    to.problem(item.mark, &path, format!("{} stands here", item.kind.describe()), mend);
                    continue;
                };
                let (named, effects): (Vec<_>, Vec<_>) =
                    fields.iter().cloned().partition(|(word, _): &(Word, Node)| word.text == "joint");
                let row = match named.first() {
                    Some((_, Node { kind: Kind::Scalar { text, .. }, mark, .. })) => {
                        once(row(text, *mark, &path, robot, to), *mark, &path, &mut seen, to)
                    }
                    _ => {
                        to.problem(
                            item.mark,
                            &path,
                            "the key `joint` is missing",
                            "add `joint:` with its number or name",
                        );
                        None
                    }
                };
                let effects = drive::effects_of_joint(&effects, &path, to);
                out.extend(row.iter().flat_map(|&row| effects.iter().map(move |e| (row, e.clone()))));
            }
        }
        other => {
            let mend = "write a mapping of joints, by number or name, to effects: 3: { backlash: {} }";
            to.problem(node.mark, path, format!("{} stands here", other.describe()), mend);
        }
    }
}

/// A joint stands in one place of the file: by number or by name.
fn once(
    row: Option<usize>,
    mark: Mark,
    path: &str,
    seen: &mut Vec<(usize, Mark, String)>,
    to: &mut Findings,
) -> Option<usize> {
    let row = row?;
    if let Some((_, first, before)) = seen.iter().find(|(other, ..)| *other == row) {
        let what =
            format!("joint {} stands at line {}, column {} already ({before})", row + 1, first.line, first.column);
        to.problem(mark, path, what, "write all effects of a joint in one place");
        return None;
    }
    seen.push((row, mark, path.to_string()));
    Some(row)
}

/// The row of a joint that is named by number, from 1, or by name.
fn row(text: &str, mark: Mark, path: &str, robot: &Robot, to: &mut Findings) -> Option<usize> {
    let text = text.trim();
    let by_name = robot.joints.iter().position(|joint| joint.name == text);
    let by_number = text.parse::<usize>().ok().and_then(|number| number.checked_sub(1));
    let row = by_name.or(by_number.filter(|&row| row < robot.joints.len()));
    let moving = row.filter(|&row| robot.joints[row].kind != JointKind::Fixed);
    if moving.is_none() {
        let what = match row {
            Some(row) => format!("joint {} is fixed", row + 1),
            None => format!("{} has no joint `{}`", robot.name, shortened(text)),
        };
        let moving = || robot.joints.iter().enumerate().filter(|(_, joint)| joint.kind != JointKind::Fixed);
        let names = moving().map(|(_, joint)| joint.name.as_str()).collect::<Vec<_>>().join(", ");
        let mend = match moving().count() == robot.joints.len() {
            true => format!("write a number from 1 to {}, or one of {names}", robot.joints.len()),
            false => {
                let rows = moving().map(|(row, _)| (row + 1).to_string()).collect::<Vec<_>>().join(", ");
                format!("write the row of a joint that moves ({rows}), or one of {names}")
            }
        };
        to.problem(mark, path, what, mend);
    }
    moving
}

fn section(word: &Word, node: &Node, file: &mut SimulationFile, to: &mut Findings) {
    let path = word.text.clone();
    let Kind::Map(fields) = &node.kind else {
        if !matches!(node.kind, Kind::Null) {
            let mend = format!("write a mapping with the keys {}", keys(&path));
            to.problem(node.mark, &path, format!("{} stands here", node.kind.describe()), mend);
        }
        return;
    };
    for (key, node) in fields {
        match &node.kind {
            Kind::Map(inner) => {
                for (part, node) in inner {
                    setting(&path, &format!("{}.{}", key.text, part.text), part.mark, node, file, to);
                }
            }
            _ => setting(&path, &key.text, key.mark, node, file, to),
        }
    }
}

fn keys(section: &str) -> String {
    KNOWN.iter().filter(|k| k.section == section).map(|k| k.key).collect::<Vec<_>>().join(", ")
}

fn setting(section: &str, name: &str, mark: Mark, node: &Node, file: &mut SimulationFile, to: &mut Findings) {
    let path = join(section, &shortened(name));
    let Some(known) = KNOWN.iter().find(|k| k.section == section && k.key == name) else {
        let mend = match closest(name, KNOWN.iter().filter(|k| k.section == section).map(|k| k.key)) {
            Some(close) => format!("did you mean `{close}`?"),
            None => format!("the keys of {section} are {}", keys(section)),
        };
        to.problem(mark, &path, format!("`{}` is not a key of {section}", shortened(name)), mend);
        return;
    };
    let mut wrong = |expected: &str| {
        let mend = format!("write {expected}: {}", known.doc);
        to.problem(node.mark, &path, format!("{} stands here", node.kind.describe()), mend);
    };
    let value = match (&known.form, &node.kind) {
        (Form::Flag, Kind::Scalar { text, quoted: false }) if text == "true" || text == "false" => {
            Some(Setting::Flag(text == "true"))
        }
        (Form::Flag, _) => {
            wrong("true or false");
            None
        }
        (Form::Words(words), Kind::Scalar { text, .. }) => {
            let found = words.iter().find(|word| **word == text.trim());
            if found.is_none() {
                let what = format!("`{}` is not a {name}", shortened(text));
                to.problem(node.mark, &path, what, format!("write {}: {}", words.join(" or "), known.doc));
            }
            found.map(|word| Setting::Word(word))
        }
        (Form::Words(words), _) => {
            wrong(&words.join(" or "));
            None
        }
        (Form::Each, Kind::List(items)) if items.is_empty() => {
            wrong("a number, or one for each joint");
            None
        }
        (Form::Each, Kind::List(items)) => {
            let numbers: Vec<f64> = items.iter().filter_map(|item| to.number(item, &path, known.doc)).collect();
            (numbers.len() == items.len()).then_some(Setting::Numbers(numbers))
        }
        (Form::Number | Form::Each, _) => to.number(node, &path, known.doc).map(|value| Setting::Numbers(vec![value])),
    };
    if let Some(value) = value {
        file.settings.retain(|(s, k, _)| (*s, *k) != (known.section, known.key));
        file.settings.push((known.section, known.key, value));
    }
}
