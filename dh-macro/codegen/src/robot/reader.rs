//! Reads mappings by the tables of [`super::keys`] and collects all problems.

use super::expression::Scope;
use super::keys::{Key, Shape, Table};
use super::problem::{Note, Problem, Problems, closest};
use super::value::Value;
use super::yaml::{Kind, Mark, Node, Word, shortened};
use super::{Angle, EffectKind, Length};

/// Problems and notes found so far, with the named constants.
#[derive(Debug, Default)]
pub struct Findings {
    /// Name of the file being read, unless it is the robot file.
    pub(super) file: Option<String>,
    pub(super) problems: Vec<Problem>,
    pub(super) notes: Vec<Note>,
    pub(super) scope: Scope,
}

impl Findings {
    /// Adds a mistake at this place, with advice.
    pub fn problem(&mut self, mark: Mark, path: &str, what: impl Into<String>, mend: impl Into<String>) {
        self.problems.push(Problem {
            file: self.file.clone(),
            path: path.to_string(),
            line: mark.line,
            column: mark.column,
            what: what.into(),
            mend: mend.into(),
        });
    }

    /// Returns the notes if there are no mistakes.
    ///
    /// # Errors
    /// All mistakes, in the order of their places.
    pub fn finish(mut self) -> Result<Vec<Note>, Problems> {
        if self.problems.is_empty() {
            return Ok(self.notes);
        }
        self.problems.sort_by_key(|p| (p.line, p.column));
        Err(Problems(self.problems))
    }

    pub(super) fn note(&mut self, mark: Mark, path: &str, what: impl Into<String>) {
        let (file, path) = (self.file.clone(), path.to_string());
        self.notes.push(Note { file, path, line: mark.line, column: mark.column, what: what.into() });
    }

    /// Reads the mapping at `node` and checks its keys against the table.
    pub(super) fn fields<'a>(&mut self, node: &'a Node, path: &str, table: &'static Table) -> Option<Fields<'a>> {
        let Kind::Map(fields) = &node.kind else {
            let expected = format!("a {} is a mapping with the keys {}", table.what, table.names().join(", "));
            self.problem(node.mark, path, format!("{} stands here", node.kind.describe()), expected);
            return None;
        };
        for (word, _) in fields {
            if table.key(&word.text).is_none() && !(table.effects && EffectKind::of(&word.text).is_some()) {
                self.unknown_key(word, path, table);
            }
        }
        for key in table.keys.iter().filter(|key| key.required) {
            if !fields.iter().any(|(word, _)| word.text == key.name) {
                let mend = format!("add `{}:` with {}{}", key.name, key.shape.describe(), unit(key));
                self.problem(node.mark, path, format!("the key `{}` is missing", key.name), mend);
            }
        }
        Some(Fields { fields, mark: node.mark, path: path.to_string(), table })
    }

    fn unknown_key(&mut self, word: &Word, path: &str, table: &Table) {
        let effects = if table.effects { EffectKind::ALL } else { &[] };
        let candidates = table.names().into_iter().chain(effects.iter().map(|kind| kind.name()));
        let mend = match closest(&word.text, candidates) {
            Some(close) => format!("did you mean `{close}`?"),
            None if table.effects => {
                format!("the keys here are {}, and the effects of robots/README.md", table.names().join(", "))
            }
            None => format!("the keys of a {} are {}", table.what, table.names().join(", ")),
        };
        let what = format!("`{}` is not a key of a {}", shortened(&word.text), table.what);
        self.problem(word.mark, &join(path, &shortened(&word.text)), what, mend);
    }

    /// Reads the items of a list.
    pub(super) fn list<'a>(&mut self, node: &'a Node, path: &str, expected: &str) -> Option<&'a [Node]> {
        if let Kind::List(items) = &node.kind {
            return Some(items);
        }
        self.problem(node.mark, path, format!("{} stands here", node.kind.describe()), format!("write {expected}"));
        None
    }

    /// Value and text of the expression at `node`.
    pub(super) fn value<'a>(&mut self, node: &'a Node, path: &str, expected: &str) -> Option<(Value, &'a str)> {
        let Kind::Scalar { text, quoted } = &node.kind else {
            self.problem(node.mark, path, format!("{} stands here", node.kind.describe()), format!("write {expected}"));
            return None;
        };
        match self.scope.evaluate(text) {
            Ok(value) => Some((value, text.trim())),
            Err(error) => {
                let column = node.mark.column + error.offset + usize::from(*quoted);
                let mark = Mark { line: node.mark.line, column };
                self.problem(mark, path, error.what, error.mend);
                None
            }
        }
    }

    /// Value of the expression at `node` as a number.
    pub fn number(&mut self, node: &Node, path: &str, expected: &str) -> Option<f64> {
        self.value(node, path, expected).map(|(value, _)| value.number)
    }

    fn angle(&mut self, node: &Node, path: &str, expected: &str) -> Option<Angle> {
        let (value, text) = self.value(node, path, expected)?;
        let (angle, reading) = value.angle(text);
        if let Some(reading) = reading {
            self.note(node.mark, path, reading);
        } else if angle.pi_multiple.is_none() && angle.value.abs() > 7.0 {
            let turns = angle.value / core::f64::consts::TAU;
            self.note(
                node.mark,
                path,
                format!("{text} rad is {turns:.1} turns; if degrees are meant, write {text}deg"),
            );
        }
        Some(angle)
    }
}

/// Unit in brackets, ` (m)`, or an empty string.
fn unit(key: &Key) -> String {
    if key.unit.is_empty() { String::new() } else { format!(" ({})", key.unit) }
}

/// Joins a path and a key: `joints[3]` and `alpha` give `joints[3].alpha`.
pub fn join(path: &str, name: &str) -> String {
    if path.is_empty() { name.to_string() } else { format!("{path}.{name}") }
}

/// A mapping with checked keys. Getters return `None` if the key is absent or invalid.
pub(super) struct Fields<'a> {
    pub(super) fields: &'a [(Word, Node)],
    pub(super) mark: Mark,
    pub(super) path: String,
    table: &'static Table,
}

impl<'a> Fields<'a> {
    /// Value of a key with its path, a description of the expected value, and its shape.
    fn get(&self, name: &str) -> Option<(&'a Node, String, String, Shape)> {
        let key = self.table.key(name)?;
        let node = &self.fields.iter().find(|(word, _)| word.text == name)?.1;
        let about = format!("{}{}: {}", key.shape.describe(), unit(key), key.doc.trim_end_matches('.'));
        Some((node, join(&self.path, name), about, key.shape))
    }

    /// Value of a key and its path.
    pub(super) fn node(&self, name: &str) -> Option<(&'a Node, String)> {
        self.get(name).map(|(node, path, ..)| (node, path))
    }

    /// Location of the key itself, for problems of its presence, and its path.
    pub(super) fn key(&self, name: &str) -> Option<(Mark, String)> {
        let (word, _) = self.fields.iter().find(|(word, _)| word.text == name)?;
        Some((word.mark, join(&self.path, name)))
    }

    pub(super) fn has(&self, name: &str) -> bool {
        self.fields.iter().any(|(word, _)| word.text == name)
    }

    pub(super) fn text(&self, name: &str, to: &mut Findings) -> Option<String> {
        let (node, path, about, _) = self.get(name)?;
        match &node.kind {
            Kind::Scalar { text, .. } if !text.trim().is_empty() => Some(text.trim().to_string()),
            other => {
                to.problem(node.mark, &path, format!("{} stands here", other.describe()), format!("write {about}"));
                None
            }
        }
    }

    /// Checks a list of texts.
    pub(super) fn texts(&self, name: &str, to: &mut Findings) {
        let Some((node, path, about, _)) = self.get(name) else { return };
        for item in to.list(node, &path, &about).unwrap_or_default() {
            if !matches!(item.kind, Kind::Scalar { .. }) {
                to.problem(item.mark, &path, format!("{} stands here", item.kind.describe()), "write text");
            }
        }
    }

    /// Reads a choice among the words in the key's table entry.
    pub(super) fn choice(&self, name: &str, to: &mut Findings) -> Option<&'static str> {
        let (node, path, _, shape) = self.get(name)?;
        let text = self.text(name, to)?;
        let Shape::Choice(words) = shape else { return None };
        let found = words.iter().copied().find(|word| *word == text);
        if found.is_none() {
            let mend = match closest(&text, words.iter().copied()) {
                Some(close) => format!("did you mean `{close}`?"),
                None => format!("write {}", words.join(" or ")),
            };
            to.problem(node.mark, &path, format!("`{}` is not a {name}", shortened(&text)), mend);
        }
        found
    }

    pub(super) fn flag(&self, name: &str, to: &mut Findings) -> Option<bool> {
        let (node, path, about, _) = self.get(name)?;
        match &node.kind {
            Kind::Scalar { text, quoted: false } if text == "true" => Some(true),
            Kind::Scalar { text, quoted: false } if text == "false" => Some(false),
            other => {
                to.problem(node.mark, &path, format!("{} stands here", other.describe()), format!("write {about}"));
                None
            }
        }
    }

    /// Reads an integer from 0.
    pub(super) fn count(&self, name: &str, to: &mut Findings) -> Option<usize> {
        let (node, path, about, _) = self.get(name)?;
        let value = to.number(node, &path, &about)?;
        if value.fract() == 0.0 && (0.0..=1e6).contains(&value) {
            return Some(value as usize);
        }
        to.problem(node.mark, &path, format!("{value} is not a whole number from 0"), format!("write {about}"));
        None
    }

    /// Reads a number within the bounds of its table entry.
    pub(super) fn number(&self, name: &str, to: &mut Findings) -> Option<f64> {
        let (node, path, about, shape) = self.get(name)?;
        let (value, text) = to.value(node, &path, &about)?;
        let wrong = match shape {
            Shape::Positive if value.number < 0.0 => "must not be negative",
            Shape::Positive if value.number == 0.0 => "must not be 0",
            _ => return Some(value.number),
        };
        to.problem(node.mark, &path, format!("{name} {wrong}; it is {text}"), format!("write its size, {about}"));
        None
    }

    pub(super) fn angle(&self, name: &str, to: &mut Findings) -> Option<Angle> {
        let (node, path, about, _) = self.get(name)?;
        to.angle(node, &path, &about)
    }

    pub(super) fn length(&self, name: &str, to: &mut Findings) -> Option<Length> {
        let (node, path, about, _) = self.get(name)?;
        let (value, text) = to.value(node, &path, &about)?;
        if value.number.abs() > 20.0 {
            let mend = format!("{} m is long for a robot; if mm are meant, write {text}/1000", value.number);
            to.note(node.mark, &path, mend);
        }
        Some(value.length(text))
    }

    /// Items of a list of exactly `N`, with their paths.
    fn items<const N: usize>(&self, name: &str, to: &mut Findings) -> Option<[(&'a Node, String, String); N]> {
        let (node, path, about, _) = self.get(name)?;
        let items = to.list(node, &path, &about)?;
        if items.len() != N {
            to.problem(
                node.mark,
                &path,
                format!("{} values stand here, not {N}", items.len()),
                format!("write {about}"),
            );
            return None;
        }
        Some(core::array::from_fn(|k| (&items[k], format!("{path}[{}]", k + 1), about.clone())))
    }

    pub(super) fn vector<const N: usize>(&self, name: &str, to: &mut Findings) -> Option<[f64; N]> {
        let items = self.items::<N>(name, to)?;
        let values = items.map(|(node, path, about)| to.number(node, &path, &about));
        values.iter().all(Option::is_some).then(|| values.map(Option::unwrap_or_default))
    }

    pub(super) fn angles<const N: usize>(&self, name: &str, to: &mut Findings) -> Option<[Angle; N]> {
        let items = self.items::<N>(name, to)?;
        let angles = items.map(|(node, path, about)| to.angle(node, &path, &about));
        angles.iter().all(Option::is_some).then(|| angles.map(|angle| angle.unwrap_or_else(Angle::zero)))
    }

    /// Reads a number or a list of numbers; empty if the key is absent.
    pub(super) fn numbers(&self, name: &str, to: &mut Findings) -> Vec<f64> {
        let Some((node, path, about, _)) = self.get(name) else { return Vec::new() };
        match &node.kind {
            Kind::List(items) => items.iter().filter_map(|item| to.number(item, &path, &about)).collect(),
            _ => to.number(node, &path, &about).into_iter().collect(),
        }
    }

    /// Mapping of a key.
    pub(super) fn map(&self, name: &str, to: &mut Findings) -> Option<Fields<'a>> {
        let (node, path, _, shape) = self.get(name)?;
        let (Shape::Map(table) | Shape::MapOrFile(table)) = shape else { return None };
        to.fields(node, &path, table)
    }

    /// List of a key: its items with their paths, `joints[1]`, `joints[2]`.
    pub(super) fn rows(&self, name: &str, to: &mut Findings) -> Option<Vec<(&'a Node, String)>> {
        let (node, path, about, _) = self.get(name)?;
        let items = to.list(node, &path, &about)?;
        Some(items.iter().enumerate().map(|(k, item)| (item, format!("{path}[{}]", k + 1))).collect())
    }

    /// Mapping of a row of a list, checked against the table of the list's key.
    pub(super) fn row(&self, name: &str, node: &'a Node, path: &str, to: &mut Findings) -> Option<Fields<'a>> {
        let (Shape::Rows(table) | Shape::RowsOrNull(table)) = self.table.key(name)?.shape else { return None };
        to.fields(node, path, table)
    }
}
