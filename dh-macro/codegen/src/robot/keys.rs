//! Tables of all keys of a robot file, used by the checker and by the editor's schema.

use super::effects::{CoulombFriction, RotorInertia, ViscousFriction};

/// Description of a mapping in the file.
#[derive(Debug)]
pub(super) struct Table {
    /// Name of the mapping, for messages.
    pub(super) what: &'static str,
    pub(super) keys: &'static [Key],
    /// Whether names of the effects vocabulary are allowed here, too.
    pub(super) effects: bool,
}

/// A key of a mapping.
#[derive(Debug, Clone, Copy)]
pub(super) struct Key {
    pub(super) name: &'static str,
    pub(super) shape: Shape,
    pub(super) unit: &'static str,
    pub(super) doc: &'static str,
    pub(super) required: bool,
}

/// Value of a key.
#[derive(Debug, Clone, Copy)]
pub(super) enum Shape {
    Text,
    /// A list of texts.
    Texts,
    Flag,
    Choice(&'static [&'static str]),
    /// An integer from 0.
    Count,
    Number,
    Positive,
    Angle,
    Length,
    /// A list of this many numbers.
    Vector(usize),
    /// A list of this many angles.
    Angles(usize),
    /// A mapping of names to numbers.
    Constants,
    Map(&'static Table),
    /// A mapping, or the name of a file that contains it.
    MapOrFile(&'static Table),
    Rows(&'static Table),
    RowsOrNull(&'static Table),
    /// A mapping of names of the effects vocabulary.
    Effects,
    /// A number, or a list of them.
    Numbers,
    /// Columns of a log, each mapped to the name of a channel or to a mapping.
    Columns(&'static Table),
}

impl Shape {
    /// Description of the expected value, for messages.
    pub(super) fn describe(&self) -> String {
        match self {
            Self::Text => "text".to_string(),
            Self::Texts => "a list of texts".to_string(),
            Self::Flag => "true or false".to_string(),
            Self::Choice(words) => words.join(" or "),
            Self::Count => "a whole number".to_string(),
            Self::Number | Self::Positive => "a number".to_string(),
            Self::Angle => "an angle".to_string(),
            Self::Length => "a length".to_string(),
            Self::Vector(n) => format!("a list of {n} numbers"),
            Self::Angles(n) => format!("a list of {n} angles"),
            Self::Constants => "a mapping of names to numbers".to_string(),
            Self::Map(table) => format!("a mapping with the keys {}", table.names().join(", ")),
            Self::MapOrFile(table) => {
                format!("the name of a file, or a mapping with the keys {}", table.names().join(", "))
            }
            Self::Rows(table) => format!("a list with one mapping per {}", table.what),
            Self::RowsOrNull(table) => format!("a list with one mapping (or null) per {}", table.what),
            Self::Effects => "a mapping of effects to numbers".to_string(),
            Self::Numbers => "a number, or a list with one for each joint".to_string(),
            Self::Columns(table) => {
                format!(
                    "a mapping of columns to channels: a name, or a mapping with the keys {}",
                    table.names().join(", ")
                )
            }
        }
    }
}

impl Table {
    pub(super) fn names(&self) -> Vec<&'static str> {
        self.keys.iter().map(|key| key.name).collect()
    }

    pub(super) fn key(&self, name: &str) -> Option<&'static Key> {
        self.keys.iter().find(|key| key.name == name)
    }
}

const fn key(name: &'static str, shape: Shape, unit: &'static str, doc: &'static str) -> Key {
    Key { name, shape, unit, doc, required: false }
}

const fn required(name: &'static str, shape: Shape, unit: &'static str, doc: &'static str) -> Key {
    Key { name, shape, unit, doc, required: true }
}

use Shape::{Angle, Angles, Choice, Columns, Constants, Count, Effects, Flag, Length, Map, MapOrFile};
use Shape::{Number, Numbers, Positive, Rows, RowsOrNull, Text, Texts, Vector};

/// Key of a torque in closed form, in a joint's row or `drive`, or under `effects`.
pub(super) const LAW: &str = "law";
/// Key of the law's unit.
pub(super) const UNIT: &str = "unit";

/// Both keys of a law.
pub(super) const LAW_KEYS: [Key; 2] = [
    key(LAW, Text, "", "A torque in closed form, in q1.. dq1.. ddq1.. t temp1..: 0.7*sin(3*q2)*sign(dq4)."),
    key(UNIT, Choice(&["N m", "N"]), "", "Unit of the law: N m, of a prismatic joint N."),
];

pub(super) static ROBOT: Table = Table {
    what: "robot",
    effects: false,
    keys: &[
        required("name", Text, "", "Name of the robot and of the crate written for it: lower case, digits, dashes."),
        key("source", Text, "", "Where the numbers come from; free text."),
        required("convention", Choice(&["modified", "standard"]), "", "Denavit-Hartenberg convention of the rows."),
        key("provenance", Rows(&RUN), "", "Commands that wrote this file, the last one last."),
        key("constants", Constants, "m, rad", "Named constants; may be used in every number below."),
        key("gravity", Vector(3), "m/s^2", "Gravity in the world frame; default [0, 0, -9.81]."),
        key("base", Map(&BASE), "", "Frame 0, from which row 1 starts, in the world; default: they coincide."),
        required("joints", Rows(&JOINT), "", "Rows of the DH table, base to tip."),
        key("links", RowsOrNull(&LINK), "", "Inertial parameters, one entry per joint; null where unknown."),
        key("tool", MapOrFile(&TOOL), "", "Body fixed to the last frame."),
        key("collision", Map(&COLLISION), "", "What must not be hit."),
        key("effects", Effects, "", "Effects beyond the rigid body that concern the whole robot."),
        key("log", Map(&LOG), "", "Which channel of this robot's logs is which column; `--map` goes before it."),
    ],
};

/// Section `log`, which is also the format of the file of `--map`.
pub(super) static LOG: Table = Table {
    what: "mapping of a log",
    effects: false,
    keys: &[
        key(
            "clock",
            Choice(&["header", "arrival"]),
            "",
            "Stamp of a message, or time of the recorder; default header.",
        ),
        required("columns", Columns(&CHANNEL), "", "Column (t, q1, or q* for all joints) and its channel."),
    ],
};

pub(super) static CHANNEL: Table = Table {
    what: "channel",
    effects: false,
    keys: &[
        required("channel", Text, "", "Its name in the log; {joint}, {number} from 1 and {index} from 0 are replaced."),
        key("unit", Text, "", "Its unit in the log; default SI."),
        key("gain", Numbers, "", "Factor after the unit; default 1."),
        key("offset", Numbers, "", "What is added then, in SI; default 0."),
    ],
};

pub(super) static RUN: Table = Table {
    what: "run",
    effects: false,
    keys: &[
        required("command", Text, "", "The command without its outputs; it can be repeated."),
        key("version", Text, "", "Version of the program."),
        key("options", Texts, "", "Every option and its value."),
        key("files", Rows(&RUN_FILE), "", "Files that were read."),
        key("found", Texts, "", "What was found, a sentence each."),
    ],
};

pub(super) static RUN_FILE: Table = Table {
    what: "file of a run",
    effects: false,
    keys: &[
        key("for", Text, "", "What it was read for."),
        required("path", Text, "", "Its path."),
        key("sha256", Text, "", "SHA-256 of its bytes, hexadecimal."),
    ],
};

/// Origin of an imported joint.
pub(super) static JOINT_SOURCE: Table = Table {
    what: "source of a joint",
    effects: false,
    keys: &[
        key("name", Text, "", "Name of the joint in the file that it was imported from."),
        key("sign", Number, "", "1 or -1: whether the joint turns the same way there."),
        key("offset", Number, "rad or m", "Position here where the position there is 0."),
    ],
};

pub(super) static JOINT: Table = Table {
    what: "joint",
    effects: false,
    keys: &[
        key("name", Text, "", "Name of the joint; default joint1, joint2, ..."),
        required("type", Choice(&["revolute", "prismatic", "fixed"]), "", "sigma = 0, 1, 2."),
        key("antecedent", Count, "", "a: number of the row before, from 1; 0 is the base. Default: the row before."),
        key("actuated", Flag, "", "mu: whether a motor drives the joint; default true, false for a fixed one."),
        key("alpha", Angle, "rad", "Twist about x; default 0."),
        key("d", Length, "m", "Length along x; default 0."),
        key("theta", Angle, "rad", "Turn about z: the offset of a revolute joint; default 0."),
        key("r", Length, "m", "Shift along z: the offset of a prismatic joint; default 0."),
        key("position", Vector(2), "rad or m", "Lower and upper limit of q."),
        key("velocity", Positive, "rad/s or m/s", "Largest speed, symmetric."),
        key("acceleration", Positive, "rad/s^2 or m/s^2", "Largest acceleration, symmetric."),
        key("jerk", Positive, "rad/s^3 or m/s^3", "Largest jerk, symmetric."),
        key("torque", Positive, "N m or N", "Largest torque or force, symmetric."),
        key("drive", Map(&DRIVE), "", "Rotor, gear, friction and other effects of the drive."),
        LAW_KEYS[0],
        LAW_KEYS[1],
        key("source", Map(&JOINT_SOURCE), "", "The joint in the file that it was imported from."),
    ],
};

pub(super) static DRIVE: Table = Table {
    what: "drive",
    effects: true,
    keys: &[
        key(RotorInertia::NAME, Number, "kg m^2 or kg", "IA: rotor inertia on the link side of the gear."),
        key("gear_ratio", Number, "", "Motor turns per joint turn; negative where the gear reverses."),
        key("torque_constant", Positive, "N m/A", "Joint-side torque per motor current."),
        key("friction", Map(&FRICTION), "", "Friction laws."),
        key("identified", Flag, "", "The values were identified: a badly excited one may be negative."),
        LAW_KEYS[0],
        LAW_KEYS[1],
    ],
};

pub(super) static FRICTION: Table = Table {
    what: "friction mapping",
    effects: true,
    keys: &[
        key(ViscousFriction::NAME, Number, "N m s/rad or N s/m", "FV: torque per speed."),
        key(CoulombFriction::NAME, Number, "N m or N", "FC: torque against the direction of motion."),
        key("offset", Number, "N m or N", "FO: constant torque."),
    ],
};

pub(super) static LINK: Table = Table {
    what: "link",
    effects: false,
    keys: &[
        required("M", Number, "kg", "Mass."),
        required("MS", Vector(3), "kg m", "First moments MSX MSY MSZ: mass times centre of mass."),
        required(
            "I",
            Vector(6),
            "kg m^2",
            "Tensor XX YY ZZ XY XZ YZ about the frame's origin; XY is the tensor's entry.",
        ),
        key("identified", Flag, "", "The values were identified: they need not be those of a possible body."),
    ],
};

pub(super) static TOOL: Table = Table {
    what: "tool",
    effects: false,
    keys: &[
        key("name", Text, "", "Name of the tool."),
        key("source", Text, "", "Where the numbers come from; free text."),
        key("pose", Map(&POSE), "", "The tool frame in the last DH frame."),
        key("M", Number, "kg", "Mass; M, MS and I stand together or not at all."),
        key("MS", Vector(3), "kg m", "First moments in the tool frame."),
        key("I", Vector(6), "kg m^2", "Tensor XX YY ZZ XY XZ YZ in the tool frame, about its origin."),
        key("identified", Flag, "", "The values were identified: they need not be those of a possible body."),
        key("geometry", Map(&GEOMETRY), "", "Size of the tool."),
    ],
};

pub(super) static POSE: Table = Table {
    what: "pose",
    effects: false,
    keys: &[
        key("xyz", Vector(3), "m", "Origin of the tool frame; default 0."),
        key("rpy", Angles(3), "rad", "Fixed-axis roll, pitch, yaw: RotZ(yaw) RotY(pitch) RotX(roll); default 0."),
    ],
};

pub(super) static BASE: Table = Table {
    what: "base",
    effects: false,
    keys: &[
        key("xyz", Vector(3), "m", "Origin of frame 0 in the world; default 0."),
        key("rpy", Angles(3), "rad", "Fixed-axis roll, pitch, yaw: RotZ(yaw) RotY(pitch) RotX(roll); default 0."),
    ],
};

pub(super) static GEOMETRY: Table = Table {
    what: "geometry",
    effects: false,
    keys: &[
        required("length", Positive, "m", "From the mount to the far end, along z of the tool frame."),
        required("width", Positive, "m", "Of what meets the work: a roller along its axis, a brush across its stroke."),
    ],
};

pub(super) static COLLISION: Table = Table {
    what: "collision",
    effects: false,
    keys: &[
        key("ground", Number, "m", "Lowest z that elbow, wrist and tool may reach, in the world frame."),
        key("spheres", Rows(&SPHERE), "", "Spheres that stand for links in distance checks."),
        key("boxes", Rows(&BOX), "", "Boxes of the surroundings, along the world axes."),
    ],
};

pub(super) static SPHERE: Table = Table {
    what: "sphere",
    effects: false,
    keys: &[
        required("link", Count, "", "Row of the DH table that carries it, from 1; 0 is the base."),
        required("center", Vector(3), "m", "Centre in that row's frame."),
        required("radius", Positive, "m", "Radius."),
    ],
};

pub(super) static BOX: Table = Table {
    what: "box",
    effects: false,
    keys: &[
        key("name", Text, "", "Name of the box; default box1, box2, ..."),
        required("min", Vector(3), "m", "Lowest corner in the world frame."),
        required("max", Vector(3), "m", "Highest corner in the world frame."),
    ],
};
