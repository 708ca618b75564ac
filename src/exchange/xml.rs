//! XML with positions: elements, attributes, numbers, and every mistake with line and column.
//!
//! Uses `roxmltree`, because it gives the position of each attribute. A deserialiser (`urdf-rs`)
//! stops at the first mistake, reports no position, and fills in missing values.

use dh_codegen::robot::Problem;
use roxmltree::{Attribute, Document, Node, ParsingOptions, TextPos};

/// An element of the document.
pub(super) type Element<'a> = Node<'a, 'a>;

/// Largest coordinate of a position, m. Beyond it, rounding alone moves a tip by more than 1e-9 m.
const FARTHEST: f64 = 1e5;

/// Largest file, bytes. The document takes some ten times as much memory.
const LONGEST: usize = 8 << 20;

/// Largest number of quotation marks in one tag: the time to compare attributes grows with their
/// number squared.
const MOST_QUOTES: usize = 2000;

/// Parses a text.
pub(super) fn parse(text: &str) -> Result<Document<'_>, Vec<Problem>> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    if let Some(what) = too_large(text) {
        let mend = "take out what is no link, joint or body";
        return Err(vec![problem(TextPos::new(1, 1), "", what, mend)]);
    }
    if text.trim_start().is_empty() {
        return Err(vec![problem(TextPos::new(1, 1), "", "the file is empty", "write a URDF or an MJCF model")]);
    }
    let options = ParsingOptions { allow_dtd: true, ..ParsingOptions::default() };
    Document::parse_with_options(text, options).map_err(|error| {
        let mut what = error.to_string();
        // The position is already at the front of the message.
        if let Some(at) = what.rfind(" at ") {
            what.truncate(at);
        }
        vec![problem(error.pos(), "", format!("this is no well-formed XML: {what}"), "mend the XML at this place")]
    })
}

/// Describes what would take too much memory or time to parse.
fn too_large(text: &str) -> Option<String> {
    if text.len() > LONGEST {
        return Some(format!("the file has {} bytes, more than the {LONGEST} that are read", text.len()));
    }
    let quotes = |tag: &str| tag.bytes().filter(|b| matches!(b, b'"' | b'\'')).count();
    let crowded = |tag: &&str| quotes(tag) > MOST_QUOTES && tag.contains('=') && !tag.starts_with(['!', '?']);
    let tag = text.split('<').map(|piece| piece.split('>').next().unwrap_or("")).find(crowded)?;
    let name: String = tag.chars().take_while(|c| !c.is_whitespace()).take(40).collect();
    Some(format!("an element `{name}` has more than {} attributes", MOST_QUOTES / 2))
}

pub(super) fn problem(at: TextPos, path: &str, what: impl Into<String>, mend: impl Into<String>) -> Problem {
    Problem {
        file: None,
        path: path.to_string(),
        line: at.row as usize,
        column: at.col as usize,
        what: what.into(),
        mend: mend.into(),
    }
}

/// Collects the mistakes of a file.
#[derive(Debug, Default)]
pub(super) struct Mistakes(pub(super) Vec<Problem>);

impl Mistakes {
    /// Adds a mistake of a whole element.
    pub(super) fn element(&mut self, at: Element<'_>, what: impl Into<String>, mend: impl Into<String>) {
        let place = at.document().text_pos_at(at.range().start);
        self.0.push(problem(place, &path(at), what, mend));
    }

    /// Adds a mistake in an attribute.
    pub(super) fn attribute(
        &mut self,
        at: Element<'_>,
        attribute: &Attribute<'_, '_>,
        what: impl Into<String>,
        mend: impl Into<String>,
    ) {
        let place = at.document().text_pos_at(attribute.range_value().start);
        self.0.push(problem(place, &format!("{}.{}", path(at), attribute.name()), what, mend));
    }

    /// Text of a required attribute.
    pub(super) fn required<'a>(&mut self, at: Element<'a>, name: &str) -> Option<&'a str> {
        let value = at.attribute(name);
        if value.is_none() {
            self.element(at, format!("the attribute `{name}` is missing"), format!("write {name}=\"..\""));
        }
        value
    }

    /// Exactly `N` numbers; `None` if the attribute is missing or wrong.
    pub(super) fn numbers<const N: usize>(&mut self, at: Element<'_>, name: &str) -> Option<[f64; N]> {
        let list = self.list(at, name)?;
        let count = list.len();
        let array: Option<[f64; N]> = list.try_into().ok();
        if array.is_none() {
            self.count(at, name, count, &N.to_string());
        }
        array
    }

    /// Adds a mistake in the count of numbers.
    pub(super) fn count(&mut self, at: Element<'_>, name: &str, count: usize, expected: &str) {
        let Some(attribute) = find(at, name) else { return };
        let mend = format!("write {expected} number(s), with blanks between them");
        self.attribute(at, &attribute, format!("{count} number(s) stand here"), mend);
    }

    /// All numbers of an attribute; `None` if the attribute is missing or wrong.
    pub(super) fn list(&mut self, at: Element<'_>, name: &str) -> Option<Vec<f64>> {
        let attribute = find(at, name)?;
        let mut numbers = Vec::new();
        for word in attribute.value().split_whitespace() {
            match word.parse::<f64>() {
                Ok(number) if number.is_finite() => numbers.push(number),
                _ => {
                    let shown: String = word.chars().take(40).collect();
                    let mend = match word.contains("${") || word.contains("$(") {
                        true => "this is xacro: expand the file with `xacro FILE > robot.urdf` first",
                        false => "write a decimal number",
                    };
                    self.attribute(at, &attribute, format!("`{shown}` is no finite number"), mend);
                    return None;
                }
            }
        }
        Some(numbers)
    }

    /// A position in space, m.
    pub(super) fn place(&mut self, at: Element<'_>, name: &str) -> Option<[f64; 3]> {
        let place = self.numbers::<3>(at, name)?;
        let Some(far) = place.iter().find(|x| x.abs() > FARTHEST) else { return Some(place) };
        let attribute = find(at, name)?;
        self.attribute(at, &attribute, format!("{far:e} m is beyond any arm"), "correct the number; lengths are in m");
        None
    }

    /// A single number.
    pub(super) fn number(&mut self, at: Element<'_>, name: &str) -> Option<f64> {
        self.numbers::<1>(at, name).map(|[number]| number)
    }
}

fn find<'a>(at: Element<'a>, name: &str) -> Option<Attribute<'a, 'a>> {
    at.attributes().find(|a| a.name() == name && a.namespace().is_none())
}

/// Path of an element from the nearest one with a name, such as `joint "elbow" limit`.
pub(super) fn path(at: Element<'_>) -> String {
    let mut words = Vec::new();
    for node in at.ancestors().filter(|n| n.is_element()) {
        let name = node.attribute("name");
        words.push(match name {
            Some(name) => format!("{} \"{name}\"", node.tag_name().name()),
            None => node.tag_name().name().to_string(),
        });
        if name.is_some() {
            break;
        }
    }
    words.reverse();
    words.join(" ")
}

/// Child elements with this name.
pub(super) fn children<'a>(at: Element<'a>, name: &'static str) -> impl Iterator<Item = Element<'a>> {
    at.children().filter(move |n| n.is_element() && n.tag_name().name() == name)
}

/// The first child element with this name.
pub(super) fn child<'a>(at: Element<'a>, name: &'static str) -> Option<Element<'a>> {
    children(at, name).next()
}
