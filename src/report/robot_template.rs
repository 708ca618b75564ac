//! A robot file template with an explanation of each key.

use std::fmt::Write;

use dh_codegen::robot::effects;

/// Known data of an arm before any measurement.
pub struct RobotTemplate<'a> {
    /// Name of the robot.
    pub name: &'a str,
    /// Whether each joint is revolute (otherwise prismatic), base to tip.
    pub turns: &'a [bool],
    /// Whether the DH table is in the standard convention (otherwise in the modified one).
    pub standard: bool,
}

/// A complete, commented robot file. Lengths and limits are examples; optional keys are commented
/// out.
pub fn robot_template(template: &RobotTemplate<'_>) -> String {
    let RobotTemplate { name, turns, standard } = template;
    let name = serde_json::Value::from(*name);
    let convention = if *standard { "standard" } else { "modified" };
    let row = if *standard {
        "RotZ(theta) TransZ(r) TransX(d) RotX(alpha)"
    } else {
        "RotX(alpha) TransX(d) RotZ(theta) TransZ(r)"
    };
    let mut text = format!(
        "# Robot file of denavit; units are m, rad, s, kg, N, N m. Numbers may be expressions: pi/2, 22.5deg, 2*L1 - 0.1.
# Every number below is an example: write those of your arm, then run `denavit check` on this file.
name: {name}
# source: data sheet           # where the numbers come from
convention: {convention:<18} # each row is {row}
constants:                    # lengths of the data sheet, by name
"
    );
    for j in 1..=turns.len() {
        let _ = writeln!(text, "  L{j}: 0.3");
    }
    text.push_str(
        "gravity: [0, 0, -9.81]        # m/s^2 in the world frame; z is up where the base stands on the floor
# base: { xyz: [0, 0, 0.8], rpy: [0, 0, 0] }   # where frame 0 stands in the world, if not at its origin

joints:                       # one row of the DH table each, base to tip; what is left out is 0
",
    );
    for (j, turns) in turns.iter().enumerate() {
        text.push_str(&joint(j + 1, *turns, j == 0));
    }
    text.push_str(
        "
# Bodies, one entry per joint, null where nothing is known: mass (kg), first moment mass * centre (kg m), inertia tensor about the
# origin of the joint's frame, not about the centre of mass: XX YY ZZ XY XZ YZ (kg m^2). `denavit identify` fills them in from a log.
# links:
#   - { M: 4, MS: [0, 0, 0.6], I: [0.12, 0.12, 0.01, 0, 0, 0] }
#   - null

# tool:
#   name: gripper
#   pose: { xyz: [0, 0, 0.1], rpy: [0, 0, 0] }   # tool frame in the frame of the last joint
#   M: 0.5                    # with MS and I, as for a link
#   MS: [0, 0, 0.02]
#   I: [0.002, 0.002, 0.001, 0, 0, 0]

# collision:                  # what `denavit excite` keeps clear of
#   ground: 0.05
#   spheres: [ { link: 2, center: [0, 0, 0], radius: 0.09 } ]
",
    );
    text
}

/// A row of the DH table; the first one explains its keys.
fn joint(number: usize, turns: bool, explained: bool) -> String {
    let say = |key: &str, words: &str| {
        if explained { format!("{key:<32}# {words}\n") } else { format!("{key}\n") }
    };
    let (kind, offset, position, velocity, acceleration, torque) = if turns {
        ("revolute", "theta: 0", "[-170deg, 170deg]", "120deg", "400deg", "100")
    } else {
        ("prismatic", "r: 0", "[0, 0.5]", "0.5", "2", "500")
    };
    let (length, twist) =
        if turns { ("r", if number.is_multiple_of(2) { "-pi/2" } else { "pi/2" }) } else { ("d", "0") };
    let twist = if number == 1 { "0" } else { twist };
    let units = if turns { ["rad", "rad/s", "rad/s^2", "N m"] } else { ["m", "m/s", "m/s^2", "N"] };
    let mut text = say(&format!("  - name: joint{number}"), "as the log or the URDF calls it");
    text += &say(&format!("    type: {kind}"), "revolute, prismatic or fixed");
    text += &say(&format!("    alpha: {twist}"), "angle between the axes, rad");
    text += &say(&format!("    {length}: L{number}"), "offset along this axis is r, distance between the axes d; m");
    text += &say(&format!("    {offset}"), "value of the row where the controller shows 0");
    text += &say(&format!("    position: {position}"), &format!("limits, {}", units[0]));
    text += &say(&format!("    velocity: {velocity}"), &format!("limit, {}", units[1]));
    text += &say(&format!("    acceleration: {acceleration}"), &format!("limit, {}", units[2]));
    text += &say(&format!("    torque: {torque}"), &format!("limit, {}", units[3]));
    if explained {
        text += "    # drive:                    # all to be identified; 0 where it is to be found\n";
        text += "    #   gear_ratio: 100\n";
        let _ = writeln!(text, "    #   {}: 0        # behind the gear, kg m^2", effects::RotorInertia::NAME);
        let (viscous, coulomb) = (effects::ViscousFriction::NAME, effects::CoulombFriction::NAME);
        let _ = writeln!(text, "    #   friction: {{ {viscous}: 0, {coulomb}: 0, offset: 0 }}");
    }
    text
}
