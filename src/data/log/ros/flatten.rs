//! Decodes a message to a list of named numbers.

use std::hash::{DefaultHasher, Hash, Hasher};

use super::cdr::{Cdr, CdrError};
use super::definition::{Definition, Primitive, Type};

/// Longest array whose elements become channels; an image is longer.
const LONGEST_ARRAY: usize = 128;
/// Largest number of fields of a message.
const MOST_FIELDS: usize = 1 << 20;

/// A node of a decoded message.
enum Node {
    Number(f64),
    Text,
    /// Elements of a numeric array; empty if there are too many.
    Numbers(Vec<f64>),
    Texts(Vec<String>),
    List(Vec<Node>),
    Struct(usize, Vec<Node>),
}

/// A decoded message: its numbers, its stamp, and a signature of their names.
pub(super) struct Flat {
    pub(super) numbers: Vec<f64>,
    /// Stamp of the header, ns; `None` if there is none or it is zero.
    pub(super) stamp: Option<i64>,
    /// Hash that is equal for messages whose numbers have the same names.
    pub(super) signature: u64,
    root: Node,
}

/// Decodes a message.
///
/// # Errors
/// If the bytes do not fit the definition.
pub(super) fn decode(definition: &Definition, bytes: &[u8]) -> Result<Flat, CdrError> {
    // Alignment counts from behind the header; some writers count from the message's first byte.
    let mut failure = None;
    for origin in [4, 0] {
        let mut decoder = Decoder { definition, cdr: Cdr::new(bytes, origin)?, fields: 0 };
        match decoder.structure(0) {
            // A message may be padded to a multiple of its largest alignment.
            Ok(root) if decoder.cdr.left() < 8 => return Ok(flat(definition, root)),
            Ok(_) => {}
            Err(error) => failure = failure.or(Some(error)),
        }
    }
    Err(failure.unwrap_or(CdrError::Short))
}

struct Decoder<'a> {
    definition: &'a Definition,
    cdr: Cdr<'a>,
    fields: usize,
}

impl Decoder<'_> {
    fn structure(&mut self, index: usize) -> Result<Node, CdrError> {
        let definition = self.definition;
        let fields = definition.structs[index].iter().map(|(_, kind)| self.node(kind));
        Ok(Node::Struct(index, fields.collect::<Result<_, _>>()?))
    }

    fn node(&mut self, kind: &Type) -> Result<Node, CdrError> {
        self.fields += 1;
        if self.fields > MOST_FIELDS {
            return Err(CdrError::Short);
        }
        Ok(match kind {
            Type::Primitive(p) => Node::Number(self.number(*p)?),
            Type::Text => {
                self.cdr.text()?;
                Node::Text
            }
            Type::Struct(index) => self.structure(*index)?,
            Type::Array(element, size) => {
                let n = size.map_or_else(|| self.cdr.length(), Ok)?;
                self.array(element, n)?
            }
        })
    }

    fn array(&mut self, element: &Type, n: usize) -> Result<Node, CdrError> {
        if n > self.cdr.left() {
            return Err(CdrError::Short);
        }
        match element {
            Type::Primitive(p) if n > LONGEST_ARRAY => {
                self.cdr.skip(n, p.size())?;
                Ok(Node::Numbers(Vec::new()))
            }
            Type::Primitive(p) => Ok(Node::Numbers((0..n).map(|_| self.number(*p)).collect::<Result<_, _>>()?)),
            Type::Text => {
                let mut texts = Vec::new();
                for _ in 0..n {
                    texts.push(String::from_utf8_lossy(self.cdr.text()?).into_owned());
                }
                Ok(Node::Texts(texts))
            }
            other => {
                let mut list = Vec::new();
                for _ in 0..n {
                    list.push(self.node(other)?);
                }
                if n > LONGEST_ARRAY {
                    list.clear();
                }
                Ok(Node::List(list))
            }
        }
    }

    fn number(&mut self, primitive: Primitive) -> Result<f64, CdrError> {
        let cdr = &mut self.cdr;
        Ok(match primitive {
            Primitive::Bool | Primitive::U8 => f64::from(cdr.primitive::<1>()?[0]),
            Primitive::I8 => f64::from(i8::from_le_bytes(cdr.primitive()?)),
            Primitive::I16 => f64::from(i16::from_le_bytes(cdr.primitive()?)),
            Primitive::U16 => f64::from(u16::from_le_bytes(cdr.primitive()?)),
            Primitive::I32 => f64::from(i32::from_le_bytes(cdr.primitive()?)),
            Primitive::U32 => f64::from(u32::from_le_bytes(cdr.primitive()?)),
            Primitive::I64 => i64::from_le_bytes(cdr.primitive()?) as f64,
            Primitive::U64 => u64::from_le_bytes(cdr.primitive()?) as f64,
            Primitive::F32 => f64::from(f32::from_le_bytes(cdr.primitive()?)),
            Primitive::F64 => f64::from_le_bytes(cdr.primitive()?),
        })
    }
}

fn flat(definition: &Definition, root: Node) -> Flat {
    let (mut numbers, mut hash) = (Vec::new(), DefaultHasher::new());
    collect(&root, &mut numbers, &mut hash);
    let stamp = stamp(definition, &root);
    Flat { numbers, stamp, signature: hash.finish(), root }
}

/// Collects the numbers in message order, and hashes everything on which their names depend.
fn collect(node: &Node, numbers: &mut Vec<f64>, hash: &mut DefaultHasher) {
    match node {
        Node::Number(value) => numbers.push(*value),
        Node::Text => {}
        Node::Numbers(values) => {
            values.len().hash(hash);
            numbers.extend(values);
        }
        Node::Texts(texts) => texts.hash(hash),
        Node::List(list) => {
            list.len().hash(hash);
            list.iter().for_each(|n| collect(n, numbers, hash));
        }
        Node::Struct(_, fields) => fields.iter().for_each(|n| collect(n, numbers, hash)),
    }
}

/// Stamp `header.stamp`, ns.
fn stamp(definition: &Definition, root: &Node) -> Option<i64> {
    let header = field(definition, root, "header")?;
    let stamp = field(definition, header, "stamp")?;
    let (Node::Number(sec), Node::Number(nanosec)) =
        (field(definition, stamp, "sec")?, field(definition, stamp, "nanosec")?)
    else {
        return None;
    };
    // Seconds (i32) and nanoseconds (u32) are exact in an i64.
    Some(*sec as i64 * 1_000_000_000 + *nanosec as i64).filter(|ns| *ns != 0)
}

fn field<'a>(definition: &Definition, node: &'a Node, name: &str) -> Option<&'a Node> {
    let Node::Struct(index, fields) = node else { return None };
    let at = definition.structs[*index].iter().position(|(n, _)| n == name)?;
    fields.get(at)
}

impl Flat {
    /// Names of the numbers: the topic, then the path in the message. Elements of an array get the
    /// names of an adjacent text array of the same length, otherwise their index.
    pub(super) fn names(&self, definition: &Definition, topic: &str) -> Vec<String> {
        let mut names = Vec::new();
        name(definition, &self.root, topic, &[], &mut names);
        names
    }
}

fn name(definition: &Definition, node: &Node, path: &str, joints: &[String], out: &mut Vec<String>) {
    let element = |i: usize, n: usize| match joints.get(i).filter(|j| joints.len() == n && !j.is_empty()) {
        Some(joint) => format!("{path}/{joint}"),
        None => format!("{path}[{i}]"),
    };
    match node {
        Node::Number(_) => out.push(path.into()),
        Node::Text | Node::Texts(_) => {}
        Node::Numbers(values) => out.extend((0..values.len()).map(|i| element(i, values.len()))),
        Node::List(list) => {
            for (i, item) in list.iter().enumerate() {
                name(definition, item, &element(i, list.len()), &[], out);
            }
        }
        Node::Struct(index, fields) => {
            let mut own = fields.iter().filter_map(|f| if let Node::Texts(t) = f { Some(t) } else { None });
            // With two text arrays side by side, it is ambiguous which one holds the names.
            let joints: &[String] = match (own.next(), own.next()) {
                (Some(texts), None) => texts,
                (None, _) => joints,
                _ => &[],
            };
            // Values of a joint's interfaces get no extra path element: `elbow/position`.
            let fields = definition.structs[*index].iter().zip(fields);
            for ((field, _), inner) in fields {
                let bare = matches!(field.as_str(), "values" | "interface_values") && !joints.is_empty();
                let path = if bare { path.into() } else { format!("{path}/{field}") };
                name(definition, inner, &path, joints, out);
            }
        }
    }
}
