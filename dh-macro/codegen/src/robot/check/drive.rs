//! Reads rotor, gear, friction, and the effects beyond the rigid body.

use super::super::Drive;
use super::super::effects::{
    CoulombFriction, Description, Effect, EffectKind, Magnitude, RotorInertia, ViscousFriction,
};
use super::super::keys::LAW;
use super::super::problem::closest;
use super::super::reader::{Fields, Findings, join};
use super::super::yaml::{Kind, Mark, Node, Word, shortened};
use super::law;

/// Kind of file in which an effect is stated.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::robot) enum Origin {
    /// A robot file.
    Robot,
    /// A robot file, in a drive whose values were identified.
    Identified,
    /// A file of effects for the simulator.
    Simulation,
}

/// Reads the drive of a joint.
pub(super) fn drive(fields: &Fields<'_>, to: &mut Findings) -> Drive {
    let mut drive = Drive {
        rotor_inertia: fields.number(RotorInertia::NAME, to),
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
    let origin = if identified { Origin::Identified } else { Origin::Robot };
    let mut seen = Vec::new();
    if let Some(friction) = fields.map("friction", to) {
        drive.viscous_friction = friction.number(ViscousFriction::NAME, to);
        drive.coulomb_friction = friction.number(CoulombFriction::NAME, to);
        drive.offset = friction.number("offset", to);
        laws(&friction, &mut drive, &mut seen, origin, to);
    }
    laws(fields, &mut drive, &mut seen, origin, to);
    drive
}

/// Checks that a dissipative or inertial parameter is not negative. A negative value is a problem,
/// or a note if it was identified from data that hardly determine it.
fn not_negative(kind: EffectKind, value: Option<f64>, mark: Mark, path: &str, origin: Origin, to: &mut Findings) {
    let Some(value) = value.filter(|value| kind.description().keys.iter().any(|key| !key.range.holds(*value))) else {
        return;
    };
    if origin == Origin::Identified {
        to.note(mark, path, format!("the identified {kind} is negative ({value}): the data hardly show it"));
    } else {
        let mend = "write its size; values from an identification may carry `identified: true` in `drive`";
        to.problem(mark, path, format!("{kind} must not be negative; it is {value}"), mend);
    }
}

/// Reads laws stated by their names, in `drive` or in `drive.friction`; `seen`: those of this
/// drive.
fn laws(fields: &Fields<'_>, drive: &mut Drive, seen: &mut Vec<EffectKind>, origin: Origin, to: &mut Findings) {
    let in_friction = fields.path.ends_with(".friction");
    for (word, node) in fields.fields {
        let Some(kind) = EffectKind::of(&word.text) else { continue };
        let path = join(&fields.path, kind.name());
        if !kind.description().scope.at_joint() {
            let mend = "write it under `effects` at the top of the file";
            to.problem(word.mark, &path, format!("{kind} concerns the whole robot, not a joint"), mend);
            continue;
        }
        if kind == EffectKind::RotorInertia && in_friction {
            let mend = "write it in `drive`, beside `friction`";
            to.problem(word.mark, &path, format!("{kind} is not a friction law"), mend);
            continue;
        }
        if seen.contains(&kind) {
            let what = format!("{kind} stands in `drive` and in `drive.friction`");
            to.problem(word.mark, &path, what, "keep one of the two");
            continue;
        }
        seen.push(kind);
        let slot = match kind {
            EffectKind::RotorInertia => &mut drive.rotor_inertia,
            EffectKind::ViscousFriction => &mut drive.viscous_friction,
            EffectKind::CoulombFriction => &mut drive.coulomb_friction,
            _ => {
                drive.effects.extend(effect(kind, node, &path, origin, to));
                continue;
            }
        };
        // Keys of the tables are read already; in `drive` itself there is none for friction.
        if kind != EffectKind::RotorInertia && !in_friction {
            *slot = to.number(node, &path, "a number");
        }
        not_negative(kind, *slot, node.mark, &path, origin, to);
    }
}

/// Reads `effects:` at the top of the file, except its law: see [`law`].
pub(in crate::robot) fn effects(node: &Node, path: &str, origin: Origin, to: &mut Findings) -> Vec<Effect> {
    let Kind::Map(fields) = &node.kind else {
        let mend = format!("write a mapping of effects to numbers: {}: {{ roll: 1deg }}", EffectKind::BaseTilt);
        to.problem(node.mark, path, format!("{} stands here", node.kind.describe()), mend);
        return Vec::new();
    };
    let mut effects = Vec::new();
    for (word, node) in fields {
        if law::is_key(word) {
            continue;
        }
        let path = join(path, &shortened(&word.text));
        let Some(kind) = EffectKind::of(&word.text) else {
            no_effect(word, &path, to);
            continue;
        };
        if kind.description().scope.at_top() {
            effects.extend(effect(kind, node, &path, origin, to));
        } else {
            let place = if kind.is_plain() { "`drive` of that joint" } else { "`drive` of the joint that has it" };
            to.problem(word.mark, &path, format!("{kind} belongs to one joint"), format!("write it in the {place}"));
        }
    }
    effects
}

/// Reads the effects of one joint in a file of effects, except its law.
pub(in crate::robot) fn effects_of_joint(fields: &[(Word, Node)], path: &str, to: &mut Findings) -> Vec<Effect> {
    let mut effects = Vec::new();
    for (word, node) in fields {
        if law::is_key(word) {
            continue;
        }
        let path = join(path, &shortened(&word.text));
        let Some(kind) = EffectKind::of(&word.text) else {
            no_effect(word, &path, to);
            continue;
        };
        if kind.description().scope.at_joint() {
            effects.extend(effect(kind, node, &path, Origin::Simulation, to));
        } else {
            let what = format!("{kind} concerns the whole robot, not a joint");
            to.problem(word.mark, &path, what, "write it under `effects`");
        }
    }
    effects
}

fn no_effect(word: &Word, path: &str, to: &mut Findings) {
    let names = EffectKind::ALL.iter().map(|kind| kind.name()).chain([LAW]);
    let mend = match closest(&word.text, names.clone()) {
        Some(close) => format!("did you mean `{close}`?"),
        None => format!("the effects are {}", names.collect::<Vec<_>>().join(", ")),
    };
    to.problem(word.mark, path, format!("`{}` is not an effect", shortened(&word.text)), mend);
}

/// Reads a bare number, or a mapping of the effect's keys. In a file of effects it may also be
/// empty. `None` after a problem that leaves no effect.
fn effect(kind: EffectKind, node: &Node, path: &str, origin: Origin, to: &mut Findings) -> Option<Effect> {
    let known = kind.description();
    let (first, keys) = (known.keys[0].name, known.keys_in_words());
    let expected = format!("a mapping with the keys {keys}, or a number: {first}");
    let mut values: Vec<(String, f64)> = Vec::new();
    match &node.kind {
        Kind::Map(fields) => values.extend(fields.iter().filter_map(|field| key_of(known, field, path, to))),
        Kind::Null if origin == Origin::Simulation => {}
        Kind::Null => {
            let mend = format!("write {expected}; {{}} where nothing is known");
            to.problem(node.mark, path, "nothing stands here", mend);
        }
        _ => values.extend(to.number(node, path, &expected).map(|value| (first.to_string(), value))),
    }
    ranges(kind, node, path, &values, origin, to);
    for key in known.keys.iter().filter(|key| key.omitted == Magnitude::Needed) {
        let there = match &node.kind {
            Kind::Map(fields) => fields.iter().any(|(word, _)| word.text == key.name),
            _ => !values.is_empty(),
        };
        if !there {
            to.problem(node.mark, path, format!("the key `{}` is missing", key.name), format!("add {}", key.doc));
        }
    }
    Effect::of_kind(kind, &values).ok()
}

/// Reads a key of an effect and its value.
fn key_of(known: &Description, field: &(Word, Node), path: &str, to: &mut Findings) -> Option<(String, f64)> {
    let (word, node) = field;
    let path = join(path, &shortened(&word.text));
    let Some(key) = known.key(&word.text) else {
        let (name, keys) = (known.name, known.keys_in_words());
        let what = format!("`{}` is not a key of {name}", shortened(&word.text));
        let mend = match closest(&word.text, known.keys.iter().map(|key| key.name)) {
            Some(close) => format!("did you mean `{close}`? The keys are {keys}"),
            None => format!("the keys of {name} are {keys}"),
        };
        to.problem(word.mark, &path, what, mend);
        return None;
    };
    to.number(node, &path, &format!("a number: {}", key.doc)).map(|value| (word.text.clone(), value))
}

/// Checks that values lie in the range of their key. An identified size may be negative. The values
/// that a file of effects adds to plain friction or a rotor may have any sign: the simulator checks
/// the sum.
fn ranges(kind: EffectKind, node: &Node, path: &str, values: &[(String, f64)], origin: Origin, to: &mut Findings) {
    let mark_of = |key: &str| match &node.kind {
        Kind::Map(fields) => fields.iter().find(|(word, _)| word.text == key).map_or(node.mark, |(_, n)| n.mark),
        _ => node.mark,
    };
    for (name, value) in values {
        let (mark, path) = (mark_of(name), join(path, name));
        let Some(key) = kind.description().key(name) else { continue };
        if key.count && !(value.fract() == 0.0 && (1.0..=1e6).contains(value)) {
            let mend = "joints and links are numbered from 1";
            to.problem(mark, &path, format!("{value} is not the number of a joint"), mend);
        }
        if key.range.holds(*value) || kind.is_plain() {
            continue;
        }
        if origin == Origin::Identified && key.range.may_be_identified(*value) {
            to.note(mark, &path, format!("the identified {name} is negative ({value}): the data hardly show it"));
        } else {
            let must = key.range.words(key.unit);
            to.problem(mark, &path, format!("{name} of {kind} is {value}"), format!("it must {must}"));
        }
    }
}
