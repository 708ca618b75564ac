//! Writes a robot as the text of its file.

use super::effects::{CoulombFriction, RotorInertia, ViscousFriction};
use super::expression::Scope;
use super::keys::{LAW, UNIT};
use super::torque_law::{Law, unit_of};
use super::yaml::{self, Kind};
use super::{
    Angle, Collision, Convention, Drive, Effect, Inertia, Joint, JointKind, Length, Limits, LogMapping, Robot, Tool,
};

/// Longest line before a row of the table is wrapped.
const WIDTH: usize = 110;

impl Robot {
    /// Text of a file that [`Robot::from_yaml`] reads back as the same robot: numbers bit by bit,
    /// angles and lengths with their original text. Comments, `source` and the text of constants
    /// are not part of a robot.
    pub fn to_yaml(&self) -> String {
        self.to_yaml_with_source(None)
    }

    /// Variant of [`Robot::to_yaml`] with the key `source`, the origin of the numbers, such as
    /// [`super::Reading::source`].
    pub fn to_yaml_with_source(&self, source: Option<&str>) -> String {
        let scope = self.scope();
        let constants: Vec<Field> =
            self.constants.iter().map(|(name, value)| (name.clone(), constant(*value))).collect();
        let mut out = String::from("# yaml-language-server: $schema=robot.schema.json\n");
        let convention = if self.convention == Convention::Modified { "modified" } else { "standard" };
        out += &format!("name: {}\n", word(&self.name));
        if let Some(source) = source {
            out += &format!("source: {}\n", word(source));
        }
        out += &format!("convention: {convention}\n");
        if !constants.is_empty() {
            out += &format!("constants: {}\n", flow(&constants, 0));
        }
        out += &format!("gravity: {}\n", list(&self.gravity));
        if let Some(base) = &self.base {
            out += &format!("base: {}\n", braces(&pose_fields(&base.xyz, &base.rpy, &scope)));
        }
        out += "\njoints:\n";
        let kinds = self.moving_kinds();
        let words = Law { joints: &kinds, scope: &scope };
        for joint in &self.joints {
            let [row, limits, drive] = [row_fields(joint, &scope), limit_fields(joint), drive_field(joint)];
            let groups = [row, limits, drive, law_fields(joint, &words), source_field(joint)];
            out += &format!("  - {}\n", flow_groups(&groups, 4));
        }
        if !self.links.is_empty() {
            out += "\nlinks:\n";
            for link in &self.links {
                let text = link.as_ref().map_or("null".to_string(), |inertia| flow(&inertia_fields(inertia), 4));
                out += &format!("  - {text}\n");
            }
        }
        if let Some(tool) = &self.tool {
            out += "\ntool:\n";
            for (key, value) in tool_fields(tool, &scope) {
                out += &format!("  {key}: {value}\n");
            }
        }
        out += &collision_lines(&self.collision);
        if !self.effects.is_empty() {
            out += "\neffects:\n";
            for effect in &self.effects {
                let (name, parameters) = effect_field(effect);
                out += &format!("  {name}: {parameters}\n");
            }
        }
        out += &self.log.as_ref().map_or(String::new(), log_lines);
        out
    }
}

/// Lines of the section `log`.
fn log_lines(log: &LogMapping) -> String {
    let mut out = String::from("\nlog:\n");
    if log.arrival {
        out += "  clock: arrival\n";
    }
    out += "  columns:\n";
    for (column, channel) in &log.columns {
        let mut fields = vec![field("channel", text(&channel.name))];
        fields.extend(channel.unit.iter().map(|unit| field("unit", text(unit))));
        for (key, values) in [("gain", &channel.gain), ("offset", &channel.offset)] {
            fields.extend((!values.is_empty()).then(|| field(key, list(values))));
        }
        out += &format!("    {}: {}\n", text(column), flow(&fields, 6));
    }
    out
}

/// Lines of the section `collision`; empty if it is the default.
fn collision_lines(collision: &Collision) -> String {
    if *collision == Collision::default() {
        return String::new();
    }
    let mut out = String::new();
    out += "\ncollision:\n";
    if let Some(ground) = collision.ground {
        out += &format!("  ground: {}\n", number(ground));
    }
    if !collision.spheres.is_empty() {
        out += "  spheres:\n";
    }
    for sphere in &collision.spheres {
        let fields = [
            ("link".to_string(), sphere.link.to_string()),
            ("center".to_string(), list(&sphere.center)),
            ("radius".to_string(), number(sphere.radius)),
        ];
        out += &format!("    - {}\n", flow(&fields, 6));
    }
    if !collision.boxes.is_empty() {
        out += "  boxes:\n";
    }
    for cuboid in &collision.boxes {
        let fields = [
            ("name".to_string(), word(&cuboid.name)),
            ("min".to_string(), list(&cuboid.min)),
            ("max".to_string(), list(&cuboid.max)),
        ];
        out += &format!("    - {}\n", flow(&fields, 6));
    }
    out
}

/// A key and the text of its value.
pub(super) type Field = (String, String);

impl Robot {
    /// The constants as a scope, for expressions that use them.
    pub(super) fn scope(&self) -> Scope {
        let mut scope = Scope::default();
        for (name, value) in &self.constants {
            if let Ok(value) = scope.evaluate(&constant(*value)) {
                scope.define(name, value);
            }
        }
        scope
    }
}

/// Top-level entries of one line each.
pub(super) fn head_fields(robot: &Robot) -> Vec<Field> {
    let convention = if robot.convention == Convention::Modified { "modified" } else { "standard" };
    vec![field("name", word(&robot.name)), field("convention", convention), field("gravity", list(&robot.gravity))]
}

fn field(key: &str, value: impl Into<String>) -> Field {
    (key.to_string(), value.into())
}

/// Type of the joint and its row of the table.
pub(super) fn row_fields(joint: &Joint, scope: &Scope) -> Vec<Field> {
    let kind = match joint.kind {
        JointKind::Revolute => "revolute",
        JointKind::Prismatic => "prismatic",
        JointKind::Fixed => "fixed",
    };
    let mut fields = vec![field("name", word(&joint.name)), field("type", kind)];
    if !joint.actuated && joint.kind != JointKind::Fixed {
        fields.push(field("actuated", "false"));
    }
    fields.push(field("alpha", angle(&joint.alpha, scope)));
    fields.push(field("d", length(&joint.d, scope)));
    fields.push(field("theta", angle(&joint.theta, scope)));
    fields.push(field("r", length(&joint.r, scope)));
    fields
}

pub(super) fn limit_fields(joint: &Joint) -> Vec<Field> {
    let mut fields = Vec::new();
    // In degrees if that is the same number: 170deg is easier to read than 2.9670597283903604.
    let turning = |value: f64| if joint.kind == JointKind::Revolute { degrees(value) } else { number(value) };
    let Limits { position, velocity, acceleration, jerk, torque } = &joint.limits;
    if let Some([lower, upper]) = *position {
        fields.push(field("position", format!("[{}, {}]", turning(lower), turning(upper))));
    }
    for (key, value) in [("velocity", velocity), ("acceleration", acceleration), ("jerk", jerk)] {
        fields.extend(value.map(|value| field(key, turning(value))));
    }
    fields.extend(torque.map(|value| field("torque", number(value))));
    fields
}

/// Field `source`: the joint in the file from which it was imported.
pub(super) fn source_field(joint: &Joint) -> Vec<Field> {
    let Some(source) = &joint.source else { return Vec::new() };
    let mut fields: Vec<Field> = source.name.iter().map(|name| field("name", word(name))).collect();
    fields.extend([field("sign", number(source.sign)), field("offset", number(source.offset))]);
    vec![field("source", braces(&fields))]
}

/// `xyz` and `rpy`.
pub(super) fn pose_fields(xyz: &[f64; 3], rpy: &[Angle; 3], scope: &Scope) -> Vec<Field> {
    let rpy: Vec<String> = rpy.iter().map(|a| angle(a, scope)).collect();
    vec![field("xyz", list(xyz)), field("rpy", format!("[{}]", rpy.join(", ")))]
}

pub(super) fn drive_field(joint: &Joint) -> Vec<Field> {
    let drive = drive_fields(&joint.drive);
    if drive.is_empty() { Vec::new() } else { vec![field("drive", flow(&drive, 13))] }
}

/// Fields of the torque in closed form.
pub(super) fn law_fields(joint: &Joint, words: &Law<'_>) -> Vec<Field> {
    let Some(law) = &joint.drive.law else { return Vec::new() };
    vec![field(LAW, text(&law.words(words))), field(UNIT, unit_of(joint.kind))]
}

pub(super) fn drive_fields(drive: &Drive) -> Vec<Field> {
    let some = |key: &str, value: Option<f64>| value.map(|value| field(key, number(value)));
    let mut fields: Vec<Field> = Vec::new();
    fields.extend(some(RotorInertia::NAME, drive.rotor_inertia));
    fields.extend(some("gear_ratio", drive.gear_ratio));
    fields.extend(some("torque_constant", drive.torque_constant));
    let friction = friction_fields(drive);
    if !friction.is_empty() {
        fields.push(field("friction", braces(&friction)));
    }
    let signed = [drive.rotor_inertia, drive.viscous_friction, drive.coulomb_friction];
    let beyond = drive.effects.iter().any(|effect| effect.out_of_range().is_some());
    if signed.into_iter().flatten().any(|value| value < 0.0) || beyond {
        fields.push(field("identified", "true")); // else the file could not be read again
    }
    fields.extend(drive.effects.iter().map(effect_field));
    fields
}

/// Fields of plain friction, for the entry `friction`.
pub(super) fn friction_fields(drive: &Drive) -> Vec<Field> {
    let laws = [
        (ViscousFriction::NAME, drive.viscous_friction),
        (CoulombFriction::NAME, drive.coulomb_friction),
        ("offset", drive.offset),
    ];
    laws.into_iter().filter_map(|(key, value)| Some(field(key, number(value?)))).collect()
}

pub(super) fn effect_field(effect: &Effect) -> Field {
    let keys: Vec<Field> = effect.stated().iter().map(|(key, value)| (word(key), number(*value))).collect();
    (effect.name().to_string(), braces(&keys))
}

pub(super) fn inertia_fields(inertia: &Inertia) -> Vec<Field> {
    let mut fields = vec![field("M", number(inertia.m)), field("MS", list(&inertia.ms)), field("I", list(&inertia.i))];
    if inertia.physical().is_err() {
        fields.push(field("identified", "true"));
    }
    fields
}

pub(super) fn tool_fields(tool: &Tool, scope: &Scope) -> Vec<Field> {
    let mut fields = vec![field("name", word(&tool.name))];
    fields.push(field("pose", braces(&pose_fields(&tool.xyz, &tool.rpy, scope))));
    if let Some(inertia) = &tool.inertia {
        fields.extend(inertia_fields(inertia));
    }
    if let Some(size) = tool.geometry {
        fields.push(field("geometry", format!("{{ length: {}, width: {} }}", number(size.length), number(size.width))));
    }
    fields
}

impl Tool {
    /// The tool as a separate file, which [`Tool::from_yaml`] reads back bit by bit; `source` is
    /// the origin of the numbers.
    pub fn to_yaml(&self, source: Option<&str>) -> String {
        let mut fields = tool_fields(self, &Scope::default());
        if let Some(source) = source {
            fields.insert(1, field("source", word(source)));
        }
        fields.iter().map(|(key, value)| format!("{key}: {value}\n")).collect()
    }
}

/// Mapping on one line: `{ a: 1, b: 2 }`.
pub(super) fn braces(fields: &[Field]) -> String {
    if fields.is_empty() {
        return "{}".to_string();
    }
    let inner: Vec<String> = fields.iter().map(|(key, value)| format!("{key}: {value}")).collect();
    format!("{{ {} }}", inner.join(", "))
}

/// Mapping `{ a: 1, b: 2 }`, wrapped if a line would be too long; `indent` is the column of the
/// brace.
pub(super) fn flow(fields: &[Field], indent: usize) -> String {
    flow_groups(&[fields.to_vec()], indent)
}

/// The same, with a new line for every group.
fn flow_groups(groups: &[Vec<Field>], indent: usize) -> String {
    let mut out = String::from("{ ");
    let mut column = indent + 2;
    let new_line = format!(",\n{:width$}", "", width = indent + 2);
    for fields in groups {
        for (k, (key, value)) in fields.iter().enumerate() {
            let item = format!("{key}: {value}");
            let first = out.len() == 2;
            if !first && (k == 0 || column + item.len() > WIDTH) {
                out += &new_line;
                column = indent + 2;
            } else if !first {
                out += ", ";
                column += 2;
            }
            column += item.len();
            out += &item;
        }
    }
    out + " }"
}

/// Shortest decimal that reads back to the same bits.
fn number(value: f64) -> String {
    let text = format!("{value:?}");
    text.strip_suffix(".0").map_or(text.clone(), str::to_string)
}

fn list(values: &[f64]) -> String {
    format!("[{}]", values.iter().map(|v| number(*v)).collect::<Vec<_>>().join(", "))
}

/// Angle in degrees, `170deg`, if that has the same bits, otherwise the plain number.
fn degrees(value: f64) -> String {
    let rounded: f64 = format!("{:.4}", value.to_degrees()).parse().unwrap_or(value);
    let text = format!("{}deg", number(rounded));
    let same = Scope::default().evaluate(&text).is_ok_and(|v| v.number.to_bits() == value.to_bits());
    if same && value != 0.0 { text } else { number(value) }
}

/// Fraction `pi/8` or `-5/3` if that has the same bits, to keep everything derived from the
/// constant exact; otherwise the plain number.
fn constant(value: f64) -> String {
    let fraction = |unit: f64, q: i64, most: f64| {
        let p = (value * q as f64 / unit).round();
        (p != 0.0 && p.abs() <= most).then_some(p as i64)
    };
    for q in 1..=3600i64 {
        let Some(p) = fraction(core::f64::consts::PI, q, 7200.0) else { continue };
        let angle = Angle::pi_fraction(p, q);
        if angle.value.to_bits() == value.to_bits() {
            return angle.text;
        }
    }
    let decimal = number(value);
    // Decimals with fewer digits were written by a person, and are exact.
    if decimal.chars().filter(char::is_ascii_digit).count() >= 16 {
        for q in 2..=1000i64 {
            let Some(p) = fraction(1.0, q, 1e6) else { continue };
            if (p as f64 / q as f64).to_bits() == value.to_bits() {
                return format!("{p}/{q}");
            }
        }
    }
    decimal
}

/// Original text of the angle if it still has the same meaning.
fn angle(angle: &Angle, scope: &Scope) -> String {
    let plain = number(angle.value);
    let exact = angle.pi_multiple.map(|(p, q)| Angle::pi_fraction(p, q).text);
    // With `+ 0` a decimal is an expression, which is never read as a rounded pi/2.
    let candidates = [Some(own(&angle.text)), exact, Some(plain.clone()), Some(format!("{plain} + 0"))];
    let means = |text: &String| {
        let read = is_expression(text).then(|| scope.evaluate(text).ok()).flatten().map(|value| value.angle(text).0);
        read.is_some_and(|read| read.value == angle.value && read.pi_multiple == angle.pi_multiple)
    };
    scalar(candidates.into_iter().flatten().find(means).unwrap_or(plain))
}

/// Original text of the length if it still has the same meaning.
fn length(length: &Length, scope: &Scope) -> String {
    let plain = number(length.value);
    let constants = scope.constants();
    let shown = products(&length.closed_form.text(&constants));
    let candidates = [own(&length.text), shown, products(&length.closed_form.exact_text(&constants)), plain.clone()];
    let means = |text: &String| {
        let read = is_expression(text).then(|| scope.evaluate(text).ok()).flatten().map(|value| value.length(text));
        read.is_some_and(|read| read.value == length.value && read.closed_form == length.closed_form)
    };
    scalar(candidates.into_iter().find(means).unwrap_or(plain))
}

fn own(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Writes powers as products: `L1^3` as `L1*L1*L1`.
fn products(text: &str) -> String {
    let power = |factor: &str| match factor.split_once('^') {
        Some((name, power)) => vec![name; power.parse().unwrap_or(1)].join("*"),
        None => factor.to_string(),
    };
    let term = |term: &str| term.split('*').map(power).collect::<Vec<_>>().join("*");
    text.split(' ').map(term).collect::<Vec<_>>().join(" ")
}

/// Whether the text has only characters of expressions, and no YAML syntax.
fn is_expression(text: &str) -> bool {
    text.chars().all(|c| c.is_ascii_alphanumeric() || "+-*/()._ ".contains(c))
}

/// Expression in a flow mapping: quoted if YAML would misread it.
fn scalar(text: String) -> String {
    // `- 5/3` would be an item of a list.
    if text.starts_with("- ") { format!("\"{text}\"") } else { text }
}

/// Text in quotes.
pub(super) fn text(text: &str) -> String {
    let escaped: String = text
        .chars()
        .map(|c| match c {
            '"' => "\\\"".to_string(),
            '\\' => "\\\\".to_string(),
            c if c.is_control() || c == '\u{feff}' => format!("\\U{:08x}", c as u32),
            c => c.to_string(),
        })
        .collect();
    format!("\"{escaped}\"")
}

/// Text, quoted only if YAML would misread it.
pub(super) fn word(text: &str) -> String {
    let plain = text.starts_with(|c: char| c.is_ascii_alphabetic())
        && text.chars().all(|c| c.is_ascii_alphanumeric() || "-_. ".contains(c))
        // A comma may follow in a flow mapping.
        && !text.ends_with([' ', '-']);
    let same = |node: yaml::Node| matches!(node.kind, Kind::Scalar { text: read, .. } if read == text);
    if plain && yaml::parse(text).is_ok_and(same) {
        return text.to_string();
    }
    self::text(text)
}
