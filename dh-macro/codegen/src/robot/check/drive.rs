//! Rotor, gear, friction, and the effects beyond the rigid body.

use super::super::effect::{EffectKey, Law, Magnitude, Place};
use super::super::problem::closest;
use super::super::reader::{Fields, Findings, join};
use super::super::yaml::{Kind, Node, Word, shortened};
use super::super::{Drive, EFFECT_NAMES, Effect};

/// Where an effect is written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Origin {
    /// A robot file.
    Robot,
    /// A robot file, in a drive whose values were identified.
    Identified,
    /// A file of effects for the simulator.
    Simulation,
}

/// Effects that are parameters of [`Drive`] themselves.
const OWN_PLACE: [&str; 3] = ["rotor_inertia", "viscous_friction", "coulomb_friction"];

/// The drive of a joint.
pub(super) fn drive(fields: &Fields<'_>, to: &mut Findings) -> Drive {
    let mut drive = Drive {
        rotor_inertia: fields.number("rotor_inertia", to),
        gear_ratio: fields.number("gear_ratio", to),
        torque_constant: fields.number("torque_constant", to),
        ..Drive::default()
    };
    let identified = fields.flag("identified", to).unwrap_or(false);
    if let (Some(0.0), Some((node, path))) = (drive.gear_ratio, fields.node("gear_ratio")) {
        to.problem(
            node.mark,
            &path,
            "gear_ratio must not be 0",
            "write motor turns per joint turn, 1 for a direct drive",
        );
    }
    if let Some(friction) = fields.map("friction", to) {
        drive.viscous_friction = friction.number("viscous_friction", to);
        drive.coulomb_friction = friction.number("coulomb_friction", to);
        drive.offset = friction.number("offset", to);
        not_negative(&friction, "viscous_friction", drive.viscous_friction, identified, to);
        not_negative(&friction, "coulomb_friction", drive.coulomb_friction, identified, to);
        laws(&friction, &mut drive, identified, to);
    }
    not_negative(fields, "rotor_inertia", drive.rotor_inertia, identified, to);
    laws(fields, &mut drive, identified, to);
    drive
}

/// A drive takes energy: less than none is a problem, and a note where the value was identified
/// from data that hardly show it.
fn not_negative(fields: &Fields<'_>, name: &str, value: Option<f64>, identified: bool, to: &mut Findings) {
    if let (Some(value), Some((node, path))) = (value.filter(|&v| v < 0.0), fields.node(name)) {
        if identified {
            to.note(node.mark, &path, format!("the identified {name} is negative ({value}): the data hardly show it"));
        } else {
            let mend = "write its size; values from an identification may carry `identified: true` in `drive`";
            to.problem(node.mark, &path, format!("{name} must not be negative; it is {value}"), mend);
        }
    }
}

/// Laws that stand under their own names, in `drive` or in `drive.friction`.
fn laws(fields: &Fields<'_>, drive: &mut Drive, identified: bool, to: &mut Findings) {
    let in_friction = fields.path.ends_with(".friction");
    for (word, node) in fields.fields {
        let name = word.text.as_str();
        if !EFFECT_NAMES.contains(&name) {
            continue;
        }
        let path = join(&fields.path, name);
        match name {
            "rotor_inertia" if in_friction => {
                to.problem(
                    word.mark,
                    &path,
                    "rotor_inertia is not a friction law",
                    "write it in `drive`, beside `friction`",
                );
            }
            "rotor_inertia" => {}
            "viscous_friction" | "coulomb_friction" if in_friction => {}
            "viscous_friction" => plain_law(&mut drive.viscous_friction, node, &path, name, to),
            "coulomb_friction" => plain_law(&mut drive.coulomb_friction, node, &path, name, to),
            _ if place(name) == Some(Place::Robot) => {
                let mend = "write it under `effects` at the top of the file";
                to.problem(word.mark, &path, format!("{name} concerns the whole robot, not a joint"), mend);
            }
            _ if drive.effects.iter().any(|effect| effect.name == name) => {
                to.problem(
                    word.mark,
                    &path,
                    format!("{name} stands in `drive` and in `drive.friction`"),
                    "keep one of the two",
                );
            }
            _ => {
                let origin = if identified { Origin::Identified } else { Origin::Robot };
                drive.effects.push(effect(word, node, &path, origin, to));
            }
        }
    }
}

/// `viscous_friction` or `coulomb_friction` beside `friction`.
fn plain_law(slot: &mut Option<f64>, node: &Node, path: &str, name: &str, to: &mut Findings) {
    if slot.is_some() {
        to.problem(node.mark, path, format!("{name} stands in `drive` and in `drive.friction`"), "keep one of the two");
        return;
    }
    let value = to.number(node, path, "a number");
    if let Some(value) = value.filter(|&v| v < 0.0) {
        to.problem(node.mark, path, format!("{name} must not be negative; it is {value}"), "write its size");
    }
    *slot = value;
}

/// `effects:` at the top of the file.
pub(super) fn effects(node: &Node, path: &str, origin: Origin, to: &mut Findings) -> Vec<Effect> {
    let Kind::Map(fields) = &node.kind else {
        let mend = "write a mapping of effects to numbers: base_tilt: { roll: 1deg }";
        to.problem(node.mark, path, format!("{} stands here", node.kind.describe()), mend);
        return Vec::new();
    };
    let mut effects = Vec::new();
    for (word, node) in fields {
        let name = word.text.as_str();
        let path = join(path, &shortened(name));
        match place(name) {
            Some(Place::Robot | Place::Either) => effects.push(effect(word, node, &path, origin, to)),
            Some(Place::Joint) => {
                let place = if OWN_PLACE.contains(&name) {
                    "`drive` of that joint"
                } else {
                    "`drive` of the joint that has it"
                };
                to.problem(
                    word.mark,
                    &path,
                    format!("{name} belongs to one joint"),
                    format!("write it in the {place}"),
                );
            }
            None => no_effect(word, &path, to),
        }
    }
    effects
}

/// The effects of one joint in a file of effects.
pub(super) fn effects_of_joint(fields: &[(Word, Node)], path: &str, to: &mut Findings) -> Vec<Effect> {
    let mut effects = Vec::new();
    for (word, node) in fields {
        let path = join(path, &shortened(&word.text));
        match place(&word.text) {
            Some(Place::Joint | Place::Either) => effects.push(effect(word, node, &path, Origin::Simulation, to)),
            Some(Place::Robot) => {
                let mend = "write it under `effects`";
                to.problem(word.mark, &path, format!("{} concerns the whole robot, not a joint", word.text), mend);
            }
            None => no_effect(word, &path, to),
        }
    }
    effects
}

fn no_effect(word: &Word, path: &str, to: &mut Findings) {
    let mend = match closest(&word.text, EFFECT_NAMES) {
        Some(close) => format!("did you mean `{close}`?"),
        None => format!("the effects are {}", EFFECT_NAMES.join(", ")),
    };
    to.problem(word.mark, path, format!("`{}` is not an effect", shortened(&word.text)), mend);
}

fn place(name: &str) -> Option<Place> {
    Law::of(name).map(|law| law.place)
}

/// A bare number, or a mapping of the keys of the effect's law. In a file of effects nothing at all
/// will do too.
fn effect(word: &Word, node: &Node, path: &str, origin: Origin, to: &mut Findings) -> Effect {
    let name = word.text.clone();
    let Some(law) = Law::of(&name) else { return Effect { name, parameters: Vec::new() } };
    let first = law.keys[0].name;
    let expected = format!("a mapping with the keys {}, or a number: {first}", keys_of(law));
    let mut parameters: Vec<(String, f64)> = Vec::new();
    match &node.kind {
        Kind::Map(fields) => {
            for (key, node) in fields {
                let path = join(path, &shortened(&key.text));
                let Some(known) = law.key(&key.text) else {
                    let what = format!("`{}` is not a key of {name}", shortened(&key.text));
                    let mend = match closest(&key.text, law.keys.iter().map(|key| key.name)) {
                        Some(close) => format!("did you mean `{close}`? The keys are {}", keys_of(law)),
                        None => format!("the keys of {name} are {}", keys_of(law)),
                    };
                    to.problem(key.mark, &path, what, mend);
                    continue;
                };
                if let Some(value) = to.number(node, &path, &format!("a number: {}", known.doc)) {
                    parameters.push((key.text.clone(), value));
                }
            }
        }
        Kind::Null if origin == Origin::Simulation => {}
        Kind::Null => {
            to.problem(
                node.mark,
                path,
                "nothing stands here",
                format!("write {expected}; {{}} where nothing is known"),
            );
        }
        _ => parameters.extend(to.number(node, path, &expected).map(|value| (first.to_string(), value))),
    }
    ranges(law, node, path, &parameters, origin, to);
    for key in law.keys.iter().filter(|key| key.omitted == Magnitude::Needed) {
        let there = match &node.kind {
            Kind::Map(fields) => fields.iter().any(|(word, _)| word.text == key.name),
            _ => !parameters.is_empty(),
        };
        if !there {
            to.problem(node.mark, path, format!("the key `{}` is missing", key.name), format!("add {}", key.doc));
        }
    }
    Effect { name, parameters }
}

/// Values must lie in the range of their key. An identified size may be negative, as those of plain
/// friction.
fn ranges(law: &Law, node: &Node, path: &str, values: &[(String, f64)], origin: Origin, to: &mut Findings) {
    let mark_of = |key: &str| match &node.kind {
        Kind::Map(fields) => fields.iter().find(|(word, _)| word.text == key).map_or(node.mark, |(_, n)| n.mark),
        _ => node.mark,
    };
    for (key, value) in values {
        let (mark, path) = (mark_of(key), join(path, key));
        let is_count = law.key(key).is_some_and(|key| key.count);
        if is_count && !(value.fract() == 0.0 && (1.0..=1e6).contains(value)) {
            let mend = "joints and links are numbered from 1";
            to.problem(mark, &path, format!("{value} is not the number of a joint"), mend);
        }
        let Some(must) = law.must(key, *value) else { continue };
        if origin == Origin::Identified && law.may_be_identified(key, *value) {
            to.note(mark, &path, format!("the identified {key} is negative ({value}): the data hardly show it"));
        } else {
            to.problem(mark, &path, format!("{key} of {} is {value}", law.name), format!("it must {must}"));
        }
    }
}

/// `FS (N m), VS (rad/s), DS`
fn keys_of(law: &Law) -> String {
    let with_unit = |key: &EffectKey| match key.unit {
        "" => key.name.to_string(),
        unit => format!("{} ({unit})", key.name),
    };
    law.keys.iter().map(with_unit).collect::<Vec<_>>().join(", ")
}
