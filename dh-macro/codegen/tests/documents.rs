//! Checks the examples of robots/README.md and reads the tool files.

mod common;

use common::robots;
use dh_codegen::robot::effects::{Description, EffectKey, Magnitude, Range, Scope};
use dh_codegen::robot::{EffectKind, Robot, no_files};

#[test]
fn the_example_of_the_readme_is_good() {
    let readme = std::fs::read_to_string(robots().join("README.md")).unwrap();
    let example = readme.split("```yaml\n").nth(1).unwrap().split("```").next().unwrap();
    let reading = Robot::from_yaml(example, &no_files).unwrap_or_else(|problems| panic!("{problems}"));
    assert!(reading.notes.is_empty(), "{:?}", reading.notes);
    let robot = reading.robot;
    assert_eq!(robot.tool.as_ref().map(|tool| tool.rpy[2].quarter_turns()), Some(Some(1)));
    assert_eq!(robot.joints[1].r.closed_form.text(&robot.constants), "-0.1 + 2*L2");
    assert_eq!(robot.joints[0].drive.effects[0].get("RC"), Some(0.3));
}

/// A bound of a range, as a reader writes it.
fn bound(value: f64) -> String {
    let turns = value / core::f64::consts::PI;
    match turns {
        -2.0 | -1.0 | 1.0 | 2.0 => format!("{turns} pi").replace("1 pi", "pi"),
        _ => value.to_string(),
    }
}

/// A key with its unit and its range.
fn key(key: &EffectKey) -> String {
    let Range { least, with_least, most, with_most, .. } = key.range;
    let range = match (least.is_finite(), most.is_finite()) {
        (false, _) => String::new(),
        (true, false) => format!(" ({} {})", if with_least { ">=" } else { ">" }, bound(least)),
        (true, true) if with_least && with_most => format!(" ({} to {})", bound(least), bound(most)),
        (true, true) => {
            let (above, below) = (if with_least { ">=" } else { ">" }, if with_most { "<=" } else { "<" });
            format!(" ({above} {}, {below} {})", bound(least), bound(most))
        }
    };
    let unit = if key.unit.is_empty() { String::new() } else { format!(" {}", key.unit) };
    format!("`{}`{unit}{range}", key.name)
}

/// The table of effects, from their types.
fn table_of_effects() -> String {
    let mut table = "| effect | what it is | stands | keys (a bare number is the first), range | adds to the torque, or means |\n|---|---|---|---|---|\n".to_string();
    for Description { name, sentence, scope, keys, law, .. } in EffectKind::ALL.iter().map(|kind| kind.description()) {
        let stands = match scope {
            Scope::Joint => "joint",
            Scope::EveryJoint => "joint; top: every joint",
            Scope::Link => "joint; top: with `link`",
            Scope::Robot => "top",
        };
        let keys = keys.iter().map(key).collect::<Vec<_>>().join(", ");
        let (sentence, law) = (sentence.trim().trim_end_matches('.'), law.replace('|', "&#124;"));
        table += &format!("| `{name}` | {sentence} | {stands} | {keys} | {law} |\n");
    }
    table
}

/// Default of a key, T being the torque limit.
fn default(key: &EffectKey) -> String {
    let unit = if key.unit.is_empty() { String::new() } else { format!(" {}", key.unit) };
    let per_torque = if key.unit == "N m" { String::new() } else { format!(" ({})", key.unit) };
    let text = match key.default {
        Magnitude::Is(value) => format!("{value:?}{unit}"),
        Magnitude::OfTorque(part) if part < 1.0 => format!("{} % of T{per_torque}", (1e4 * part).round() / 100.0),
        Magnitude::OfTorque(part) => format!("{part} T{per_torque}"),
        Magnitude::Derived => key.doc.split("default: ").nth(1).unwrap().to_string(),
        Magnitude::Needed => "must be written".to_string(),
    };
    format!("`{}` {text}", key.name)
}

/// The pictures of the effects with their defaults and where these come from.
fn table_of_defaults() -> String {
    let mut table = "| | |\n|---|---|\n".to_string();
    for Description { name, keys, law, source, .. } in EffectKind::ALL.iter().map(|kind| kind.description()) {
        let [law, source] = [law, source].map(|text| text.replace('|', "&#124;"));
        let keys = keys.iter().map(default).collect::<Vec<_>>().join(", ");
        table += &format!(
            "| <img src=\"effects/{name}.svg\" width=\"240\" alt=\"{name}\"> | **`{name}`**<br>{law}<br>default: {keys}<br><sub>{source}</sub> |\n"
        );
    }
    table
}

/// Compares the table that begins with `head` with the given one. `DENAVIT_REGENERATE=1` writes it
/// (and fails that once).
fn stands_in(document: &str, head: &str, table: &str) {
    let path = robots().join("..").join(document);
    let text = std::fs::read_to_string(&path).unwrap();
    let start = text.find(head).unwrap();
    let end = text[start..].find("\n\n").map_or(text.len(), |length| start + length + 1);
    if &text[start..end] != table {
        if std::env::var_os("DENAVIT_REGENERATE").is_some() {
            std::fs::write(&path, [&text[..start], table, &text[end..]].concat()).unwrap();
        }
        panic!("{document}: the table of effects is not that of their types; DENAVIT_REGENERATE=1 writes it");
    }
}

#[test]
fn the_table_of_effects_is_that_of_their_types() {
    stands_in("robots/README.md", "| effect |", &table_of_effects());
}

#[test]
fn the_table_of_defaults_is_that_of_the_types() {
    stands_in("docs/simulate.md", "| | |\n", &table_of_defaults());
}

const ROBOT: &str = "name: a\nconvention: modified\njoints: [ { type: revolute, alpha: 1.5708, theta: A } ]\n";

#[test]
fn a_tool_may_have_its_own_file() {
    let text = format!("{}tool: brush.yaml\n", ROBOT.replace("theta: A", "theta: 0"));
    let good = Robot::from_yaml(&text, &|name| Ok(format!("# {name}\npose: {{ rpy: [0, 3.1416, 0] }}\n"))).unwrap();
    assert_eq!(good.robot.tool.unwrap().name, "brush");
    let notes: Vec<String> = good.notes.iter().map(|note| note.to_string()).collect();
    assert_eq!(
        notes,
        ["3:36: joints[1].alpha: 1.5708 read as pi/2", "brush.yaml:2:18: pose.rpy[2]: 3.1416 read as pi"]
    );

    let broken = Robot::from_yaml(&text, &|_| Ok("pose: { xzy: [0, 0, 0] }\nM: -1\n".to_string())).unwrap_err();
    let printed = broken.in_file("robots/a.yaml").to_string();
    assert!(printed.starts_with("brush.yaml:1:1: M without MS, I;"), "{printed}");
    assert!(printed.contains("\nbrush.yaml:1:9: pose.xzy: `xzy` is not a key of a pose; help: did you mean `xyz`?"));
    let text = Robot::from_yaml(&text, &|_| Ok("[".to_string())).unwrap_err().to_string();
    assert!(text.starts_with("brush.yaml:"), "{text}");
}

#[test]
fn a_rounded_angle_may_stand_in_a_constant() {
    let text = ROBOT.replace("joints", "constants: { A: -1.570796 }\njoints");
    let reading = Robot::from_yaml(&text, &no_files).unwrap();
    assert_eq!(reading.robot.joints[0].theta.quarter_turns(), Some(-1));
    assert_eq!(reading.notes[1].what, "A = 1.570796 read as -pi/2");
}

#[test]
fn identified_links_need_not_be_bodies() {
    let link = "links: [ { M: -1, MS: [0, 0, 0], I: [1, 1, 1, 0, 0, 0], identified: true } ]\n";
    let text = ROBOT.replace("theta: A", "theta: 0") + link;
    let reading = Robot::from_yaml(&text, &no_files).unwrap();
    assert_eq!(reading.notes[1].what, "no body is like this identified link: the mass is -1 kg");
    assert!(reading.robot.to_yaml().contains("identified: true"));
    assert!(Robot::from_yaml(&text.replace(", identified: true", ""), &no_files).is_err());
}

#[test]
fn an_identified_size_may_be_negative_wherever_it_stands() {
    let with = |drive: &str| {
        let joint = format!("{{ type: revolute, drive: {{ {drive} }} }}");
        Robot::from_yaml(&format!("name: a\nconvention: modified\njoints: [ {joint} ]\n"), &no_files)
    };
    for size in [
        "rotor_inertia: -0.1",
        "viscous_friction: -0.1",
        "friction: { viscous_friction: -0.1 }",
        "stribeck_friction: { FS: -0.1 }",
        "load_dependent_friction: -0.1",
    ] {
        let notes = with(&format!("identified: true, {size}")).unwrap_or_else(|e| panic!("{size}: {e}")).notes;
        assert!(notes[0].what.ends_with("is negative (-0.1): the data hardly show it"), "{}", notes[0]);
        assert!(with(size).is_err(), "{size}");
    }
    // A shape without which the law has no value, and a gear that gives energy without end.
    for impossible in ["stribeck_friction: { VS: 0 }", "stribeck_friction: { DS: 0 }", "load_dependent_friction: -1"] {
        assert!(with(&format!("identified: true, {impossible}")).is_err(), "{impossible}");
    }
}

#[test]
fn values_in_another_unit_are_noticed() {
    let joint = "{ type: revolute, alpha: 90, d: 310, position: [-170, 170], velocity: 110 }";
    let text = format!("name: a\nconvention: modified\ngravity: [0, 0, -981]\njoints: [ {joint} ]\n");
    let notes = Robot::from_yaml(&text, &no_files).unwrap().notes;
    let paths: Vec<&str> = notes.iter().map(|note| note.path.as_str()).collect();
    assert_eq!(paths, ["gravity", "joints[1].alpha", "joints[1].d", "joints[1].position", "joints[1].velocity"]);
}
