//! Any robot survives being written; any text is answered without a panic.

mod common;

use common::{files, robots};
use dh_codegen::robot::effects::Magnitude;
use dh_codegen::robot::{
    Angle, Collision, Convention, Cuboid, Drive, Effect, EffectKind, Inertia, Joint, JointKind, JointSource, Length,
    Limits, LogChannel, LogMapping, Polynomial, Pose, Robot, Sphere, Tool, ToolGeometry, no_files,
};
use proptest::collection::vec;
use proptest::option;
use proptest::prelude::*;

const CONSTANTS: [&str; 3] = ["L1", "L2", "offset_3"];

fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => -10.0..10.0f64,
        1 => (-1000i32..1000).prop_map(|n| f64::from(n) / 100.0),
        1 => prop::num::f64::NORMAL.prop_map(|v| v % 1e100),
        1 => Just(0.0),
    ]
}

fn positive() -> impl Strategy<Value = f64> {
    prop_oneof![1e-6..1e4f64, (1i32..720).prop_map(|n| f64::from(n).to_radians())]
}

fn angle() -> impl Strategy<Value = Angle> {
    prop_oneof![
        (-12i64..12, 1i64..13).prop_map(|(p, q)| Angle::pi_fraction(p, q)),
        (-4i64..5).prop_map(|p| Angle::pi_fraction(p, 2)),
        number().prop_map(Angle::radians),
        // Measured angles that look like rounded quarter turns.
        prop::sample::select(&["1.5708", "-3.14159", "1.5707963267948966"][..])
            .prop_map(|text| Angle::radians(text.parse().unwrap_or_default())),
        // A text that does not mean the value.
        number().prop_map(|v| Angle { text: "] nonsense: {".to_string(), ..Angle::radians(v) }),
    ]
}

fn length(constants: Vec<(String, f64)>) -> impl Strategy<Value = Length> {
    let named = (0..constants.len().max(1), -3i32..4).prop_map(move |(k, n)| match constants.get(k) {
        Some((name, value)) if n != 0 => Length {
            value: f64::from(n) * value,
            closed_form: Polynomial::constant(k).scale(f64::from(n)),
            text: format!("{n}*{name}"),
        },
        _ => Length::zero(),
    });
    prop_oneof![number().prop_map(Length::meters), named]
}

fn limits() -> impl Strategy<Value = Limits> {
    let position = option::of((number(), 0.001..5.0f64).prop_map(|(lower, width)| [lower, lower + width]))
        .prop_map(|position| position.filter(|[lower, upper]| lower < upper));
    (position, option::of(positive()), option::of(positive()), option::of(positive()), option::of(positive())).prop_map(
        |(position, velocity, acceleration, jerk, torque)| Limits { position, velocity, acceleration, jerk, torque },
    )
}

/// Any of these effects, with none, one or all of the keys of its law.
fn effect(names: &'static [&'static str]) -> impl Strategy<Value = Effect> {
    (prop::sample::select(names), 0..3usize, number()).prop_map(|(name, keys, value)| {
        let known = EffectKind::of(name).expect("a name of the vocabulary").description().keys;
        // The first key is the only one that may have to be there.
        let least = usize::from(known[0].omitted == Magnitude::Needed);
        let most = [least, 1, known.len()][keys];
        let value_of = |k: usize| match value + k as f64 {
            _ if known[k].count => 1.0,
            value if known[k].range.holds(value) => value,
            _ => 0.5,
        };
        let values: Vec<_> = (0..most).map(|k| (known[k].name, value_of(k))).collect();
        Effect::from_keys(name, &values).expect("keys of the effect")
    })
}

fn drive() -> impl Strategy<Value = Drive> {
    let own = (option::of(positive()), option::of(positive()), option::of(positive()));
    let friction = (option::of(positive()), option::of(positive()), option::of(number()));
    let effects = option::of(effect(&["stribeck_friction", "backlash", "torque_ripple", "time_delay"]));
    (own, friction, effects).prop_map(|((rotor_inertia, gear_ratio, torque_constant), friction, effect)| Drive {
        rotor_inertia,
        gear_ratio,
        torque_constant,
        viscous_friction: friction.0,
        coulomb_friction: friction.1,
        offset: friction.2,
        effects: effect.into_iter().collect(),
        law: None,
    })
}

fn joint(constants: Vec<(String, f64)>) -> impl Strategy<Value = Joint> {
    let kind = prop_oneof![Just(JointKind::Revolute), Just(JointKind::Prismatic), Just(JointKind::Fixed)];
    let table = (angle(), length(constants.clone()), angle(), length(constants));
    (kind, any::<bool>(), "[A-Za-z0-9 :#,é\"\\\\-]{0,6}", table, limits(), drive()).prop_map(
        |(kind, actuated, name, (alpha, d, theta, r), limits, drive)| {
            let (fixed, actuated) = (kind == JointKind::Fixed, actuated && kind != JointKind::Fixed);
            Joint {
                source: (!fixed).then(|| JointSource {
                    name: actuated.then(|| format!("j {name}").trim().to_string()),
                    sign: if actuated { -1.0 } else { 1.0 },
                    offset: theta.value,
                }),
                name: name.trim().to_string(),
                kind,
                actuated,
                alpha,
                d,
                theta,
                r,
                limits: if fixed { Limits::default() } else { limits },
                drive: if actuated { drive } else { Drive::default() },
            }
        },
    )
}

fn inertia() -> impl Strategy<Value = Inertia> {
    [number(), number(), number(), number(), number(), number(), number(), number(), number(), number()]
        .prop_map(Inertia::from_array)
}

fn tool() -> impl Strategy<Value = Tool> {
    let geometry = option::of((positive(), positive()).prop_map(|(length, width)| ToolGeometry { length, width }));
    ([number(), number(), number()], [angle(), angle(), angle()], option::of(inertia()), geometry)
        .prop_map(|(xyz, rpy, inertia, geometry)| Tool { name: "brush 2".to_string(), xyz, rpy, inertia, geometry })
}

fn robot() -> impl Strategy<Value = Robot> {
    let lengths = vec(number(), 0..3)
        .prop_map(|values| CONSTANTS.iter().map(|name| name.to_string()).zip(values).collect::<Vec<(String, f64)>>());
    let joints = lengths.prop_flat_map(|constants| (vec(joint(constants.clone()), 1..5), Just(constants), angle()));
    let joints = joints.prop_map(|(joints, mut constants, angle)| {
        constants.push(("an_angle".to_string(), angle.value));
        (joints, constants)
    });
    let rest = (option::of(tool()), [number(), number(), number()], any::<bool>(), any::<bool>());
    let effects = option::of(effect(&["base_tilt", "torque_gain_error", "payload"]));
    (joints, rest, vec(option::of(inertia()), 4), option::of(number()), effects).prop_map(
        |((mut joints, constants), (tool, gravity, standard, known), links, ground, effect)| {
            for (k, joint) in joints.iter_mut().enumerate() {
                joint.name += &format!("{k}");
            }
            joints[0].kind = JointKind::Revolute;
            let links = if known { links[..joints.len().min(4)].to_vec() } else { Vec::new() };
            let spheres = ground.map(|_| Sphere { link: 1, center: gravity, radius: 0.1 }).into_iter().collect();
            let wall = || Cuboid { name: "wall".to_string(), min: [-0.5, 0.25, -1.0], max: [0.5, 1.0, 2.0] };
            let boxes = ground.map(|_| wall()).into_iter().collect();
            Robot {
                name: "any-robot".to_string(),
                convention: if standard { Convention::Standard } else { Convention::Modified },
                constants,
                gravity,
                base: tool.as_ref().map(|tool| Pose { xyz: tool.xyz, rpy: tool.rpy.clone() }),
                joints,
                links,
                tool,
                collision: Collision { ground, spheres, boxes },
                effects: effect.into_iter().collect(),
                log: ground.map(|_| LogMapping {
                    columns: vec![
                        (
                            "q*".into(),
                            LogChannel {
                                name: "Axis {number}: Pos".into(),
                                unit: Some("deg".into()),
                                ..LogChannel::default()
                            },
                        ),
                        (
                            "i2".into(),
                            LogChannel { name: "#2".into(), unit: None, gain: vec![0.5, -1.5], offset: vec![0.1] },
                        ),
                    ],
                    arrival: standard,
                }),
            }
        },
    )
}

/// Texts are the file's own words; everything else must survive to the bit.
fn without_texts(mut robot: Robot) -> Robot {
    for joint in &mut robot.joints {
        for angle in [&mut joint.alpha, &mut joint.theta] {
            angle.text.clear();
        }
        for length in [&mut joint.d, &mut joint.r] {
            length.text.clear();
        }
    }
    let base = robot.base.iter_mut().flat_map(|base| &mut base.rpy);
    for angle in robot.tool.iter_mut().flat_map(|tool| &mut tool.rpy).chain(base) {
        angle.text.clear();
    }
    robot
}

proptest! {
    #![proptest_config(ProptestConfig { cases: ProptestConfig::default().cases.max(500), failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn a_written_robot_reads_back_the_same(robot in robot()) {
        let text = robot.to_yaml();
        let again = Robot::from_yaml(&text, &no_files)
            .map_err(|problems| TestCaseError::fail(format!("{problems}\n{text}")))?;
        prop_assert_eq!(without_texts(again.robot), without_texts(robot), "{}", text);
    }

    /// A good file with a few bytes deleted, replaced or inserted.
    #[test]
    fn a_damaged_file_is_answered(
        file in 0usize..100,
        damage in vec((0usize..100_000, 0u8..3, prop_oneof![
            prop::sample::select(&b"[]{}:,-#&*!|>'\"%@` \t\n\r?~<=.0e/()\\"[..]),
            any::<u8>(),
        ]), 1..8),
    ) {
        let paths = files("");
        let mut bytes = std::fs::read(&paths[file % paths.len()]).unwrap();
        for (place, how, byte) in damage {
            let place = place % bytes.len();
            match how {
                0 => { bytes.remove(place); }
                1 => bytes[place] = byte,
                _ => bytes.insert(place, byte),
            }
        }
        if let Err(problems) = Robot::from_bytes(&bytes, &no_files) {
            prop_assert!(!problems.list().is_empty());
            prop_assert!(problems.list().iter().all(|problem| problem.line > 0 && problem.column > 0), "{}", problems);
        }
    }

    /// Pieces of YAML in any order.
    #[test]
    fn any_text_is_answered(pieces in vec(prop::sample::select(&[
        "name: a\n", "joints:\n", "  - ", "{ ", " }", "[", "]", ", ", ": ", "\n", "  ", "type: revolute", "? ", "- ", "&a ", "*a",
        "!!str ", "'", "\"", "|\n", ">-\n", "# x\n", "---\n", "...\n", "%YAML 1.2\n", "\u{feff}", "é", "\\x", "<<", "1e999",
        "pi/", "((", "~", "alpha", "\t", "\r\n", "links: ", "tool: a.yaml\n", "constants: { L: 1 }\n", "effects: ",
    ][..]), 0..40)) {
        let text: String = pieces.concat();
        let _ = Robot::from_yaml(&text, &|_| Ok(text.clone()));
    }
}

/// An expression in any form that the reader accepts: literals, constants, units, signs with
/// blanks, brackets.
fn expression() -> impl Strategy<Value = String> {
    let literals =
        ["0", "1", "5", "0.3", ".5", "5.", "1e-3", "2.5E+1", "1.5708", "3.14159", "90deg", "22.5 deg", "0.1rad"];
    let words = ["pi", "L1", "L2", "A", "B", "1/3", "- 5/3", "-5/3", "pi/7", "-  2*pi/3", "L1*L1", "1.5708 + 0"];
    let leaf = prop::sample::select([&literals[..], &words[..]].concat()).prop_map(String::from);
    leaf.prop_recursive(3, 12, 2, |inner| {
        prop_oneof![
            (inner.clone(), prop::sample::select(&[" + ", "-", "*", " / ", "/"][..]), inner.clone())
                .prop_map(|(a, operator, b)| format!("{a}{operator}{b}")),
            (prop::sample::select(&["-", "- ", "+", "--", " "][..]), inner.clone())
                .prop_map(|(sign, a)| format!("{sign}{a}")),
            inner.clone().prop_map(|a| format!("({a})")),
            inner.prop_map(|a| format!("({a})deg")),
        ]
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: ProptestConfig::default().cases.max(2000), failure_persistence: None, ..ProptestConfig::default() })]

    /// Read, written and read again, every number is the same: fractions of pi, polynomials in the
    /// constants, bits.
    #[test]
    fn numbers_of_every_form_survive(
        b in prop::sample::select(&["- 5/3", "pi/7", "22.5deg", "0.1deg", "1.5708", "-1.5708", "1.5708 + 0", "2/7", "1e-3", "0.3"][..]),
        texts in vec(expression(), 7),
    ) {
        let [alpha, d, theta, r, x, y, roll] = &texts[..] else { unreachable!() };
        let text = format!(
            "name: a\nconvention: modified\nconstants: {{ L1: 0.31, L2: 2/3, A: 1/3, B: \"{b}\" }}\ngravity: [0, 0, \"{y}\"]\n\
             joints: [ {{ type: revolute, alpha: \"{alpha}\", d: \"{d}\", theta: \"{theta}\", r: \"{r}\", position: [-300, \"{x}\"] }} ]\n\
             tool: {{ pose: {{ xyz: [\"{x}\", 0, 0], rpy: [\"{roll}\", 0, 0] }} }}\n"
        );
        // A division by zero, or a constant that refers to itself.
        let Ok(first) = Robot::from_yaml(&text, &no_files) else { return Ok(()) };
        let written = first.robot.to_yaml();
        let again = Robot::from_yaml(&written, &no_files)
            .map_err(|problems| TestCaseError::fail(format!("{problems}\n{text}\n{written}")))?;
        prop_assert_eq!(without_texts(again.robot), without_texts(first.robot), "{}\n{}", text, written);
    }
}

#[test]
fn the_robots_have_windows_line_ends_too() {
    let text = std::fs::read_to_string(robots().join("kuka-lwr4.yaml")).unwrap().replace('\n', "\r\n");
    assert!(Robot::from_yaml(&text, &no_files).is_ok());
}
