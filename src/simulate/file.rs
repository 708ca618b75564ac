//! File of a simulation: reads effects of joints and robot, and settings of sensors, controller and
//! solver.

use dh_codegen::robot::document::{
    self, Findings, Kind, Mark, Node, Word, closest, effects_of_joint, effects_of_robot, join, law_of_joint,
    law_of_robot, shortened,
};
use dh_codegen::robot::{EffectKind, Effects, JointKind, Note, Problems, Robot};

use super::{Method, Mode, Request, Side};

/// Content of the file. Every part is optional.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct SimulationFile {
    /// Effects beyond those of the robot file.
    pub effects: Effects,
    /// Notes of the reader for the author of the file.
    pub notes: Vec<Note>,
    /// Settings of `sensors`, `control`, `solver`: index in [`KNOWN`], and value.
    settings: Vec<(usize, Setting)>,
}

/// Value of a setting.
#[derive(Debug, Clone, PartialEq)]
enum Setting {
    /// One number, or one per joint.
    Numbers(Vec<f64>),
    Flag(bool),
    /// Index of the word in the words of its key.
    Word(usize),
}

/// Form of the value of a key, and the function that sets it.
enum Form {
    Number(fn(&mut Request, f64)),
    /// A number, or a list with one per joint.
    Each(fn(&mut Request, Vec<f64>)),
    Flag(fn(&mut Request, bool)),
    /// One of these words, passed on by its index.
    Words(&'static [&'static str], fn(&mut Request, usize)),
}

struct Known {
    section: &'static str,
    /// Key; of a mapping with its name: `torque_noise_color.std`.
    key: &'static str,
    form: Form,
    doc: &'static str,
}

const fn known(section: &'static str, key: &'static str, form: Form, doc: &'static str) -> Known {
    Known { section, key, form, doc }
}

use Form::{Each, Flag, Number, Words};

const SECTIONS: [&str; 5] = ["joints", "effects", "sensors", "control", "solver"];

const SIDES: [Side; 2] = [Side::Motor, Side::Link];
const MODES: [&str; 5] = [Mode::ALL[0].0, Mode::ALL[1].0, Mode::ALL[2].0, Mode::ALL[3].0, Mode::ALL[4].0];
const METHODS: [Method; 3] = [Method::Auto, Method::Rosenbrock, Method::DormandPrince];

#[rustfmt::skip]
static KNOWN: [Known; 24] = [
    known("sensors", "rate", Number(|r, x| r.sensors.rate = x), "samples per second, Hz"),
    known("sensors", "encoder", Each(|r, x| r.sensors.encoder = x), "step of the encoders, rad; 0 for none"),
    known("sensors", "position_noise", Each(|r, x| r.sensors.position_noise = x), "white noise of the positions, standard deviation, rad"),
    known("sensors", "torque_noise", Each(|r, x| r.sensors.torque_noise = x), "white noise of the torques, standard deviation, N m"),
    known("sensors", "torque_noise_color.std", Each(|r, x| r.sensors.torque_colour = x), "coloured noise of the torques, standard deviation, N m"),
    known("sensors", "torque_noise_color.corner", Number(|r, x| r.sensors.colour_corner = x), "its corner frequency, Hz"),
    known("sensors", "torque_step", Each(|r, x| r.sensors.torque_step = x), "step of the torque sensors, N m; 0 for none"),
    known("sensors", "latency", Number(|r, x| r.sensors.latency = x), "age of all samples at their stamp, s"),
    known("sensors", "jitter", Number(|r, x| r.sensors.jitter = x), "of the sampling instants, standard deviation, s"),
    known("sensors", "torque", Words(&["motor", "link"], |r, k| r.sensors.torque = SIDES[k]), "the side of the gear that `tau` is of"),
    known("sensors", "position", Words(&["motor", "link"], |r, k| r.sensors.position = SIDES[k]), "the side of the gear that `q` is of"),
    known("sensors", "dq", Flag(|r, x| r.sensors.velocity = x), "whether `dq` is recorded"),
    known("sensors", "velocity_noise", Each(|r, x| r.sensors.velocity_noise = x), "white noise of `dq`, standard deviation, rad/s"),
    known("sensors", "qd", Flag(|r, x| r.sensors.desired = x), "whether `qd` is recorded"),
    known("sensors", "temp", Flag(|r, x| r.sensors.temperature = x), "whether `temp` is recorded"),
    known("sensors", "wrench", Flag(|r, x| r.sensors.wrench = x), "whether the external wrench is recorded"),
    known("control", "mode", Words(&MODES, |r, k| r.control.mode = Mode::ALL[k].1), "what drives the arm"),
    known("control", "kp", Each(|r, x| r.control.kp = Some(x)), "position gain, N m/rad"),
    known("control", "kd", Each(|r, x| r.control.kd = Some(x)), "velocity gain, N m s/rad"),
    known("control", "bandwidth", Number(|r, x| r.control.bandwidth = x), "what default gains are made for, rad/s"),
    known("control", "damping", Number(|r, x| r.control.damping = x), "damping ratio that default gains are made for"),
    known("solver", "method", Words(&["auto", "rosenbrock", "dormand-prince"], |r, k| r.solver.method = METHODS[k]), "ROS34PW2 or Dormand and Prince 5(4)"),
    known("solver", "tolerance", Number(|r, x| r.solver.tolerance = x), "relative error of a step"),
    known("solver", "step", Number(|r, x| r.solver.longest = x), "longest step, s"),
];

impl SimulationFile {
    /// Reads the file for a robot; joints are given by number or name. All mistakes are reported
    /// together.
    pub fn from_yaml(text: &str, robot: &Robot) -> Result<Self, Problems> {
        let says_something = |line: &str| !line.trim().is_empty() && !line.trim_start().starts_with('#');
        if !text.lines().any(says_something) {
            return Ok(Self::default());
        }
        let root = document::tree(text)?;
        let mut found = Findings::default();
        let mut file = Self::default();
        match &root.kind {
            Kind::Map(fields) => {
                for (word, node) in fields {
                    let path = shortened(&word.text);
                    match word.text.as_str() {
                        "joints" => joints(node, &path, robot, &mut file.effects, &mut found),
                        "effects" => {
                            file.effects.robot = effects_of_robot(node, &path, &mut found);
                            // A joint's own law replaces one for all joints.
                            file.effects.laws.splice(0..0, law_of_robot(node, &path, robot, &mut found));
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
        file.notes = found.finish()?;
        Ok(file)
    }

    /// Sections and keys of the settings, in the order of the file.
    pub fn settings(&self) -> impl Iterator<Item = (&'static str, &'static str)> {
        self.settings.iter().map(|(place, _)| (KNOWN[*place].section, KNOWN[*place].key))
    }

    /// Applies the settings of sensors, control and solver; effects are applied by the simulator.
    pub fn apply(&self, request: &mut Request) {
        for (place, value) in &self.settings {
            match (&KNOWN[*place].form, value) {
                (Number(set), Setting::Numbers(numbers)) => set(request, numbers[0]),
                (Each(set), Setting::Numbers(numbers)) => set(request, numbers.clone()),
                (Flag(set), Setting::Flag(flag)) => set(request, *flag),
                (Words(_, set), Setting::Word(word)) => set(request, *word),
                _ => unreachable!("a value is read by the form of its key"),
            }
        }
    }
}

/// Reads a mapping of joints to effects, or a list of mappings with `joint` in each.
fn joints(node: &Node, path: &str, robot: &Robot, out: &mut Effects, to: &mut Findings) {
    let mut seen = Vec::new();
    match &node.kind {
        Kind::Null => {}
        Kind::Map(fields) => {
            for (word, node) in fields {
                let path = format!("{path}.{}", shortened(&word.text));
                let row = once(row(&word.text, word.mark, &path, robot, to), word.mark, &path, &mut seen, to);
                match &node.kind {
                    Kind::Map(fields) => {
                        joint(fields, &path, robot, row, out, to);
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
                joint(&effects, &path, robot, row, out, to);
            }
        }
        other => {
            let mend = "write a mapping of joints, by number or name, to effects: 3: { backlash: {} }";
            to.problem(node.mark, path, format!("{} stands here", other.describe()), mend);
        }
    }
}

/// Reads the effects and the law of one joint.
fn joint(fields: &[(Word, Node)], path: &str, robot: &Robot, row: Option<usize>, out: &mut Effects, to: &mut Findings) {
    let effects = effects_of_joint(fields, path, to);
    let Some(row) = row else { return };
    out.joints.extend(effects.into_iter().map(|effect| (row, effect)));
    out.laws.extend(law_of_joint(fields, path, robot, row, to).map(|law| (row, law)));
}

/// Checks that a joint occurs only once in the file, whether by number or by name.
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

/// Row of a joint given by number, from 1, or by name.
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
    let Some(place) = KNOWN.iter().position(|k| k.section == section && k.key == name) else {
        let mend = match closest(name, KNOWN.iter().filter(|k| k.section == section).map(|k| k.key)) {
            Some(close) => format!("did you mean `{close}`?"),
            None => format!("the keys of {section} are {}", keys(section)),
        };
        to.problem(mark, &path, format!("`{}` is not a key of {section}", shortened(name)), mend);
        return;
    };
    let known = &KNOWN[place];
    let mut wrong = |expected: &str| {
        let mend = format!("write {expected}: {}", known.doc);
        to.problem(node.mark, &path, format!("{} stands here", node.kind.describe()), mend);
    };
    let value = match (&known.form, &node.kind) {
        (Flag(_), Kind::Scalar { text, quoted: false }) if text == "true" || text == "false" => {
            Some(Setting::Flag(text == "true"))
        }
        (Flag(_), _) => {
            wrong("true or false");
            None
        }
        (Words(words, _), Kind::Scalar { text, .. }) => {
            let found = words.iter().position(|word| *word == text.trim());
            if found.is_none() {
                let what = format!("`{}` is not a {name}", shortened(text));
                to.problem(node.mark, &path, what, format!("write {}: {}", words.join(" or "), known.doc));
            }
            found.map(Setting::Word)
        }
        (Words(words, _), _) => {
            wrong(&words.join(" or "));
            None
        }
        (Each(_), Kind::List(items)) if items.is_empty() => {
            wrong("a number, or one for each joint");
            None
        }
        (Each(_), Kind::List(items)) => {
            let numbers: Vec<f64> = items.iter().filter_map(|item| to.number(item, &path, known.doc)).collect();
            (numbers.len() == items.len()).then_some(Setting::Numbers(numbers))
        }
        (Number(_) | Each(_), _) => to.number(node, &path, known.doc).map(|value| Setting::Numbers(vec![value])),
    };
    if let Some(value) = value {
        file.settings.retain(|(other, _)| *other != place);
        file.settings.push((place, value));
    }
}

#[cfg(test)]
mod tests {
    use dh_codegen::robot::no_files;

    use super::*;
    use crate::simulate::Sensors;

    const EFFECTS: &str = "
joints:
  2: { stribeck_friction: { FS: 4.1, VS: 0.08 }, backlash: }
  shoulder: { joint_elasticity: 3000 }
effects: { base_tilt: { roll: 90deg } }
sensors: { encoder: [1e-5, 2e-5], torque_noise_color: { std: 0.02, corner: 5 }, torque: link, dq: true }
control: { mode: exact }
";

    fn two_joints() -> Robot {
        let text =
            "name: a\nconvention: modified\njoints: [ { type: revolute, name: shoulder }, { type: revolute } ]\n";
        Robot::from_yaml(text, &no_files).unwrap().robot
    }

    #[test]
    fn a_file_of_effects_is_read() {
        let file = SimulationFile::from_yaml(EFFECTS, &two_joints()).unwrap_or_else(|problems| panic!("{problems}"));
        let named: Vec<(usize, &str)> = file.effects.joints.iter().map(|(row, e)| (*row, e.name())).collect();
        assert_eq!(named, [(1, "stribeck_friction"), (1, "backlash"), (0, "joint_elasticity")]);
        assert_eq!(file.effects.joints[2].1.stated(), [("KE".to_string(), 3000.0)]);
        assert!((file.effects.robot[0].get("roll").unwrap() - core::f64::consts::FRAC_PI_2).abs() < 1e-15);
        let mut request = Request::default();
        file.apply(&mut request);
        let Sensors { encoder, torque_colour, colour_corner, torque, velocity, .. } = request.sensors;
        assert_eq!((encoder, torque_colour, colour_corner), (vec![1e-5, 2e-5], vec![0.02], 5.0));
        assert_eq!((torque, velocity, request.control.mode), (Side::Link, true, Mode::Exact));
        let list = "joints: [ { joint: 2, backlash: {} }, { joint: shoulder, torque_offset: 1 } ]";
        let file = SimulationFile::from_yaml(list, &two_joints()).unwrap();
        assert_eq!(file.effects.joints.iter().map(|(row, _)| *row).collect::<Vec<_>>(), [1, 0]);
        assert_eq!(SimulationFile::from_yaml("# nothing\n", &two_joints()).unwrap(), SimulationFile::default());
    }

    #[test]
    fn mistakes_in_a_file_of_effects_are_told_with_their_places() {
        for (text, expected) in [
            ("joints: { 3: { backlash: {} } }", "1:11: joints.3: a has no joint `3`; help: write a number from 1 to 2"),
            ("joints: { 1: { baklash: {} } }", "`baklash` is not an effect; help: did you mean `backlash`?"),
            ("joints: { 1: { backlash: { BW: 1 } } }", "`BW` is not a key of backlash; help: "),
            ("joints: { 1: { payload: {} } }", "payload concerns the whole robot"),
            ("effects: { backlash: {} }", "backlash belongs to one joint"),
            ("joints: { 1: { gear_coupling: {} } }", "the key `joint` is missing"),
            ("joints: [ { backlash: {} } ]", "joints[1]: the key `joint` is missing"),
            ("joint: { 1: {} }", "`joint` is not a key of a file of effects; help: did you mean `joints`?"),
            ("sensors: { ratte: 1 }", "`ratte` is not a key of sensors; help: did you mean `rate`?"),
            ("sensors: { torque: both }", "`both` is not a torque; help: write motor or link"),
            ("sensors: { dq: 1 }", "write true or false"),
            ("control: exact", "`exact` stands here"),
            ("[1]", "a file of effects is a mapping"),
        ] {
            let problems = SimulationFile::from_yaml(text, &two_joints()).unwrap_err().to_string();
            assert!(problems.contains(expected), "{text}: {problems}");
        }
    }
}
