//! Parses ROS 2 message definitions (`.msg`, as stored in a recording) and the types in them.

use std::collections::HashMap;

/// Reason why the type of a message can't be resolved.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub(super) enum DefinitionError {
    /// The message contains itself.
    #[error("the type {0} contains itself")]
    Endless(String),
    /// The type has no definition.
    #[error("the type {0} is not defined")]
    Undefined(String),
    /// The type expression can't be parsed, such as brackets without a number.
    #[error("the type `{0}` can't be read")]
    Unreadable(String),
}

/// Primitive type of a field.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Primitive {
    Bool,
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    I64,
    U64,
    F32,
    F64,
}

impl Primitive {
    fn of(name: &str) -> Option<Self> {
        Some(match name {
            "bool" => Self::Bool,
            "int8" => Self::I8,
            "uint8" | "byte" | "char" => Self::U8,
            "int16" => Self::I16,
            "uint16" => Self::U16,
            "int32" => Self::I32,
            "uint32" => Self::U32,
            "int64" => Self::I64,
            "uint64" => Self::U64,
            "float32" => Self::F32,
            "float64" => Self::F64,
            _ => return None,
        })
    }

    /// Size, bytes.
    pub(super) fn size(self) -> usize {
        match self {
            Self::Bool | Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::I64 | Self::U64 | Self::F64 => 8,
        }
    }
}

/// Type of a field.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Type {
    Primitive(Primitive),
    Text,
    /// Structure: index into [`Definition::structs`].
    Struct(usize),
    /// Array: element type, and length if fixed.
    Array(Box<Type>, Option<usize>),
}

/// Definition of a message: its own structure first, then those that it uses.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Definition {
    /// Names and types of the fields of each structure.
    pub(super) structs: Vec<Vec<(String, Type)>>,
}

/// Messages that can be decoded if a recording carries no definition.
const KNOWN: &[(&str, &str)] = &[
    ("builtin_interfaces/Time", "int32 sec\nuint32 nanosec"),
    ("builtin_interfaces/Duration", "int32 sec\nuint32 nanosec"),
    ("std_msgs/Header", "builtin_interfaces/Time stamp\nstring frame_id"),
    ("std_msgs/MultiArrayDimension", "string label\nuint32 size\nuint32 stride"),
    ("std_msgs/MultiArrayLayout", "MultiArrayDimension[] dim\nuint32 data_offset"),
    ("std_msgs/Float64MultiArray", "MultiArrayLayout layout\nfloat64[] data"),
    ("std_msgs/Float32MultiArray", "MultiArrayLayout layout\nfloat32[] data"),
    (
        "sensor_msgs/JointState",
        "std_msgs/Header header\nstring[] name\nfloat64[] position\nfloat64[] velocity\nfloat64[] effort",
    ),
    ("geometry_msgs/Vector3", "float64 x\nfloat64 y\nfloat64 z"),
    ("geometry_msgs/Wrench", "Vector3 force\nVector3 torque"),
    ("geometry_msgs/WrenchStamped", "std_msgs/Header header\nWrench wrench"),
    ("control_msgs/InterfaceValue", "string[] interface_names\nfloat64[] values"),
    (
        "control_msgs/DynamicJointState",
        "std_msgs/Header header\nstring[] joint_names\nInterfaceValue[] interface_values",
    ),
    (
        "trajectory_msgs/JointTrajectoryPoint",
        "float64[] positions\nfloat64[] velocities\nfloat64[] accelerations\nfloat64[] effort\nbuiltin_interfaces/Duration time_from_start",
    ),
];

/// Short form of a type name: `sensor_msgs/JointState` for `sensor_msgs/msg/JointState`.
fn short(name: &str) -> String {
    name.replace("/msg/", "/")
}

impl Definition {
    /// Parses the text that a recording carries (empty if it has none) for the named type.
    ///
    /// # Errors
    /// If a type can't be parsed, is undefined or contains itself.
    pub(super) fn new(type_name: &str, text: &str) -> Result<Self, DefinitionError> {
        let mut texts: HashMap<String, &str> = KNOWN.iter().map(|(name, text)| ((*name).into(), *text)).collect();
        for (i, part) in sections(text).into_iter().enumerate() {
            match (i, part.0) {
                (0, _) if !part.1.trim().is_empty() => drop(texts.insert(short(type_name), part.1)),
                (_, Some(name)) => drop(texts.insert(short(name), part.1)),
                _ => {}
            }
        }
        let mut reader = Reader { texts, done: HashMap::new(), structs: Vec::new() };
        reader.read(&short(type_name), 0)?;
        Ok(Self { structs: reader.structs })
    }
}

/// Sections of a definition: the message itself, then each type that it uses with its name.
fn sections(text: &str) -> Vec<(Option<&str>, &str)> {
    let mut parts = Vec::new();
    let (mut start, mut name, mut at) = (0, None, 0);
    for line in text.split_inclusive('\n') {
        let bare = line.trim();
        if bare.len() >= 20 && bare.chars().all(|c| c == '=') {
            parts.push((name.take(), &text[start..at]));
            start = at + line.len();
        } else if let Some(found) = bare.strip_prefix("MSG:") {
            name = Some(found.trim());
            start = at + line.len();
        }
        at += line.len();
    }
    parts.push((name, &text[start.min(text.len())..]));
    parts
}

struct Reader<'a> {
    texts: HashMap<String, &'a str>,
    done: HashMap<String, usize>,
    structs: Vec<Vec<(String, Type)>>,
}

impl Reader<'_> {
    /// Index of the named structure, which is parsed if it is new.
    fn read(&mut self, name: &str, depth: usize) -> Result<usize, DefinitionError> {
        if let Some(&index) = self.done.get(name) {
            return Ok(index);
        }
        if depth > 16 {
            return Err(DefinitionError::Endless(name.into()));
        }
        let text = *self.texts.get(name).ok_or_else(|| DefinitionError::Undefined(name.into()))?;
        let package = name.split('/').next().unwrap_or("").to_string();
        let index = self.structs.len();
        self.structs.push(Vec::new());
        let mut fields = Vec::new();
        for line in text.lines() {
            let line = line.split('#').next().unwrap_or("").trim();
            let mut words = line.split_whitespace();
            let (Some(kind), Some(field)) = (words.next(), words.next()) else { continue };
            // Skips a constant: `uint8 OK=1`, `uint8 OK = 1`.
            if field.contains('=') || words.next().is_some_and(|w| w.starts_with('=')) {
                continue;
            }
            fields.push((field.to_string(), self.kind(kind, &package, depth)?));
        }
        self.structs[index] = fields;
        self.done.insert(name.into(), index);
        Ok(index)
    }

    fn kind(&mut self, text: &str, package: &str, depth: usize) -> Result<Type, DefinitionError> {
        if let Some(inner) = text.strip_suffix(']') {
            let unreadable = || DefinitionError::Unreadable(text.into());
            let (element, size) = inner.rsplit_once('[').ok_or_else(unreadable)?;
            let size = match size {
                "" => None,
                bound if bound.starts_with("<=") => None,
                number => Some(number.parse().map_err(|_| unreadable())?),
            };
            return Ok(Type::Array(Box::new(self.kind(element, package, depth)?), size));
        }
        if text == "string" || text.starts_with("string<=") {
            return Ok(Type::Text);
        }
        if let Some(primitive) = Primitive::of(text) {
            return Ok(Type::Primitive(primitive));
        }
        let full = match text {
            "Header" => "std_msgs/Header".into(),
            "time" => "builtin_interfaces/Time".into(),
            "duration" => "builtin_interfaces/Duration".into(),
            _ if text.contains('/') => short(text),
            _ => format!("{package}/{text}"),
        };
        Ok(Type::Struct(self.read(&full, depth + 1)?))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_definition_with_its_parts() {
        let text = "# A comment\nuint8 OK=1\nuint8 BAD = 2\nHeader header\nPart[] parts # more\nfloat64[3] xyz\nstring<=8[] name\n\
            ================================================================================\nMSG: my_msgs/Part\nfloat32 a 1.5\n";
        let found = Definition::new("my_msgs/msg/Whole", text).unwrap();
        let fields: Vec<&str> = found.structs[0].iter().map(|(name, _)| name.as_str()).collect();
        assert_eq!(fields, ["header", "parts", "xyz", "name"]);
        assert_eq!(found.structs[0][2].1, Type::Array(Box::new(Type::Primitive(Primitive::F64)), Some(3)));
        assert_eq!(found.structs[0][3].1, Type::Array(Box::new(Type::Text), None));
    }

    #[test]
    fn what_is_not_defined_or_endless_is_an_error() {
        let refused = |text: &str| Definition::new("a/B", text).unwrap_err();
        assert_eq!(refused("C c"), DefinitionError::Undefined("a/C".into()));
        assert_eq!(refused(""), DefinitionError::Undefined("a/B".into()));
        assert_eq!(refused("B b"), DefinitionError::Endless("a/B".into()));
        assert_eq!(refused("float64[x] b"), DefinitionError::Unreadable("float64[x]".into()));
        assert!(Definition::new("sensor_msgs/msg/JointState", "").is_ok());
    }
}
