//! Writes a changed robot into the text of its file; unchanged parts keep their text, comments,
//! order and format.

use core::ops::Range;

use super::torque_law::Law;
use super::write::{self, Field};
use super::yaml::{self, Kind, Node, Word};
use super::{Drive, Files, Joint, Robot};

/// Longest line to which an entry is appended.
const WIDTH: usize = 140;

/// A command run that changed a robot file; [`Robot::rewritten`] adds it to the file's
/// `provenance`.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Run {
    /// Command in a form that can be repeated.
    pub command: String,
    /// Version of the program.
    pub version: String,
    /// All options with their values.
    pub options: Vec<String>,
    /// Files that were read: purpose, path, SHA-256.
    pub files: Vec<[String; 3]>,
    /// Findings, one sentence each.
    pub found: Vec<String>,
}

impl Robot {
    /// Text of a file that reads as this robot, made from `text`, the robot's file before the
    /// change. `files` returns the text of the files that it references, as for
    /// [`Robot::from_yaml`]; `there` does so at the location of the result.
    ///
    /// Changed values are replaced in place, new keys follow their neighbours, and `run` is added
    /// to `provenance`. If this is not possible (all of it in one line, for instance), the file is
    /// written in this crate's own form, with its `source`.
    pub fn rewritten(&self, text: &str, files: &Files<'_>, there: &Files<'_>, run: &Run) -> String {
        let edited = self.edited(text, files, there).map(|text| with_run(&text, run));
        // Guards against missed edits: the text must read as this robot.
        let same =
            |text: &String| Self::from_yaml(text, there).is_ok_and(|reading| reading.robot.to_yaml() == self.to_yaml());
        edited.filter(same).unwrap_or_else(|| {
            let source = Self::from_yaml(text, files).ok().and_then(|reading| reading.source);
            let plain = self.to_yaml_with_source(source.as_deref());
            with_run(&[earlier_comments(text).as_str(), plain.as_str()].concat(), run)
        })
    }

    fn edited(&self, text: &str, files: &Files<'_>, there: &Files<'_>) -> Option<String> {
        let before = Self::from_yaml(text, files).ok()?.robot;
        let root = yaml::parse(text).ok()?;
        let mut editor = Editor::new(text);
        let top = root.fields()?;
        let scope = before.scope();
        editor.mapping(&root, &write::head_fields(&before), &write::head_fields(self));
        let base = |robot: &Self| robot.base.as_ref().map(|base| write::pose_fields(&base.xyz, &base.rpy, &scope));
        editor.section(&root, "base", base(&before), base(self));
        let rows = child(top, "joints")?.items()?;
        if before.joints.len() != self.joints.len() || rows.len() != self.joints.len() {
            return None;
        }
        let kinds = before.moving_kinds();
        let words = Law { joints: &kinds, scope: &scope };
        for (node, (old, new)) in rows.iter().zip(before.joints.iter().zip(&self.joints)) {
            editor.joint(node, old, new, &words);
        }
        editor.links(&root, &before, self);
        let tool = |robot: &Self| robot.tool.as_ref().map(|tool| write::tool_fields(tool, &scope));
        match child(top, "tool").map(|node| (node, &node.kind)) {
            // The tool file differs, or is missing, at the location of the result.
            Some((node, Kind::Scalar { text, .. }))
                if files(text).ok() != there(text).ok() && self.tool == before.tool =>
            {
                editor.replace(node.span.clone(), write::flow(&tool(self)?, 6));
            }
            _ => editor.section(&root, "tool", tool(&before), tool(self)),
        }
        let effects = |robot: &Self| -> Option<Vec<Field>> {
            (!robot.effects.is_empty()).then(|| robot.effects.iter().map(write::effect_field).collect())
        };
        editor.section(&root, "effects", effects(&before), effects(self));
        Some(editor.applied())
    }
}

impl Node {
    fn fields(&self) -> Option<&[(Word, Node)]> {
        if let Kind::Map(fields) = &self.kind { Some(fields) } else { None }
    }

    fn items(&self) -> Option<&[Node]> {
        if let Kind::List(items) = &self.kind { Some(items) } else { None }
    }
}

fn child<'a>(fields: &'a [(Word, Node)], name: &str) -> Option<&'a Node> {
    fields.iter().find(|(word, _)| word.text == name).map(|(_, node)| node)
}

fn value<'a>(fields: &'a [Field], key: &str) -> Option<&'a str> {
    fields.iter().find(|(k, _)| k == key).map(|(_, text)| text.as_str())
}

/// Replacements in a text, indexed by characters.
struct Editor {
    characters: Vec<char>,
    edits: Vec<(Range<usize>, String)>,
}

impl Editor {
    fn new(text: &str) -> Self {
        Self { characters: text.strip_prefix('\u{feff}').unwrap_or(text).chars().collect(), edits: Vec::new() }
    }

    /// Text with all replacements; those at the same position keep their order.
    fn applied(mut self) -> String {
        self.edits.sort_by_key(|(range, _)| range.start);
        let (mut out, mut at) = (String::new(), 0);
        for (range, text) in &self.edits {
            out.extend(self.characters.get(at..range.start).unwrap_or_default());
            out += text;
            at = range.end.max(at);
        }
        out.extend(self.characters.get(at..).unwrap_or_default());
        out
    }

    fn replace(&mut self, range: Range<usize>, text: impl Into<String>) {
        self.edits.push((range, text.into()));
    }

    /// End of the line that contains `at`.
    fn line_end(&self, at: usize) -> usize {
        let rest = self.characters[at.min(self.characters.len())..].iter();
        let end = at + rest.take_while(|c| **c != '\n').count();
        if end > at && self.characters.get(end - 1) == Some(&'\r') { end - 1 } else { end }
    }

    fn line_start(&self, at: usize) -> usize {
        let before = self.characters[..at.min(self.characters.len())].iter().rev();
        at - before.take_while(|c| **c != '\n').count()
    }

    fn new_line(&self) -> &'static str {
        if self.characters.windows(2).any(|pair| pair == ['\r', '\n']) { "\r\n" } else { "\n" }
    }

    fn is_flow(&self, node: &Node) -> bool {
        matches!(self.characters.get(node.span.start), Some('{' | '['))
    }

    /// Edits the mapping at `node` from the entries `old` to `new`.
    fn mapping(&mut self, node: &Node, old: &[Field], new: &[Field]) {
        let Some(fields) = node.fields() else { return };
        let mut further = Vec::new();
        for (key, text) in new {
            match child(fields, key) {
                _ if value(old, key) == Some(text.as_str()) => {}
                Some(place) => self.replace(place.span.clone(), text),
                None => further.push((key.clone(), text.clone())),
            }
        }
        self.append(node, &further);
        for (key, _) in old.iter().filter(|(key, _)| value(new, key).is_none()) {
            self.delete(node, key);
        }
    }

    /// Appends new entries after the last one.
    fn append(&mut self, node: &Node, entries: &[Field]) {
        let (Some(fields), false) = (node.fields(), entries.is_empty()) else { return };
        let list: Vec<String> = entries.iter().map(|(key, text)| format!("{key}: {text}")).collect();
        let Some((first, last)) = fields.first().zip(fields.last()) else {
            return self.replace(node.span.clone(), format!("{{ {} }}", list.join(", ")));
        };
        let (at, indent) = (last.1.span.end, first.0.start - self.line_start(first.0.start));
        let new_line = format!("{}{}", self.new_line(), " ".repeat(indent));
        if !self.is_flow(node) {
            let text: String = list.iter().map(|entry| format!("{new_line}{entry}")).collect();
            let at = self.line_end(at);
            return self.replace(at..at, text);
        }
        let text = list.join(", ");
        let used = at - self.line_start(at);
        let between = if used + text.len() > WIDTH { format!(",{new_line}") } else { ", ".to_string() };
        self.replace(at..at, between + &text);
    }

    /// Deletes an entry.
    fn delete(&mut self, node: &Node, key: &str) {
        let Some(fields) = node.fields() else { return };
        let Some(k) = fields.iter().position(|(word, _)| word.text == key) else { return };
        let (word, place) = &fields[k];
        let range = match (self.is_flow(node), fields.get(k + 1), k.checked_sub(1)) {
            (_, None, None) => return self.replace(node.span.clone(), "{}"),
            (_, Some((next, _)), _) => word.start..next.start,
            (true, None, Some(before)) => fields[before].1.span.end..place.span.end,
            (false, None, Some(_)) => {
                let end = self.line_end(place.span.end);
                self.line_start(word.start).saturating_sub(1)..end
            }
        };
        self.replace(range, "");
    }

    /// Edits a mapping at the top of the file, which may be new or removed.
    fn section(&mut self, root: &Node, key: &str, old: Option<Vec<Field>>, new: Option<Vec<Field>>) {
        let node = root.fields().and_then(|top| child(top, key));
        match (old, new, node) {
            (old, new, _) if old == new => {}
            (Some(old), Some(new), Some(node)) if node.fields().is_some() => self.mapping(node, &old, &new),
            (_, Some(new), Some(node)) => self.replace(node.span.clone(), write::flow(&new, 4)),
            (_, Some(new), None) => {
                let lines: Vec<String> = new.iter().map(|(key, text)| format!("  {key}: {text}")).collect();
                self.append_section(key, &lines);
            }
            (_, None, Some(_)) => self.delete(root, key),
            (_, None, None) => {}
        }
    }

    /// Appends the lines of a new section at the end of the file.
    fn append_section(&mut self, key: &str, lines: &[String]) {
        let new_line = self.new_line();
        let end = self.characters.len();
        let begun = if self.characters.last() == Some(&'\n') { "" } else { new_line };
        let lines: String = lines.iter().map(|line| format!("{line}{new_line}")).collect();
        self.replace(end..end, format!("{begun}{new_line}{key}:{new_line}{lines}"));
    }

    fn joint(&mut self, node: &Node, old: &Joint, new: &Joint, words: &Law<'_>) {
        let fields = |joint: &Joint| {
            let row = [write::row_fields(joint, words.scope), write::limit_fields(joint)].concat();
            [row, write::law_fields(joint, words), write::source_field(joint)].concat()
        };
        self.mapping(node, &fields(old), &fields(new));
        let Some(drive) = node.fields().and_then(|fields| child(fields, "drive")).filter(|d| d.fields().is_some())
        else {
            return self.mapping(node, &write::drive_field(old), &write::drive_field(new));
        };
        self.drive(drive, &old.drive, &new.drive);
    }

    /// Edits a drive, whose laws are in the drive itself or in its `friction`.
    fn drive(&mut self, node: &Node, old: &Drive, new: &Drive) {
        let friction = node.fields().and_then(|fields| child(fields, "friction")).filter(|f| f.fields().is_some());
        let (old, new) = (Parts::of(old), Parts::of(new));
        let Some(friction) = friction else {
            // Plain friction is stated beside the other keys, or not yet at all.
            let beside = |fields: &[Field]| {
                let stands = |(key, _): &&Field| node.fields().is_some_and(|f| child(f, key).is_some());
                fields.iter().filter(stands).cloned().collect::<Vec<_>>()
            };
            let apart = |fields: &[Field]| {
                let stands = |(key, _): &&Field| node.fields().is_none_or(|f| child(f, key).is_none());
                let rest: Vec<Field> = fields.iter().filter(stands).cloned().collect();
                if rest.is_empty() { vec![] } else { vec![("friction".to_string(), write::braces(&rest))] }
            };
            let all = |parts: &Parts| [parts.own.clone(), beside(&parts.friction), apart(&parts.friction)].concat();
            return self.mapping(node, &all(&old), &all(&new));
        };
        let inside = |key: &str| friction.fields().is_some_and(|fields| child(fields, key).is_some());
        let outside = |key: &str| node.fields().is_some_and(|fields| child(fields, key).is_some());
        let split = |parts: &Parts| -> (Vec<Field>, Vec<Field>) {
            let laws = parts.own.iter().map(|field| (field, inside(&field.0)));
            let plain = parts.friction.iter().map(|field| (field, !outside(&field.0)));
            let (within, without): (Vec<_>, Vec<_>) = laws.chain(plain).partition(|(_, within)| *within);
            let fields = |list: Vec<(&Field, bool)>| list.into_iter().map(|(field, _)| field.clone()).collect();
            (fields(within), fields(without))
        };
        let ((old_within, old_without), (new_within, new_without)) = (split(&old), split(&new));
        self.mapping(friction, &old_within, &new_within);
        self.mapping(node, &old_without, &new_without);
    }

    fn links(&mut self, root: &Node, old: &Robot, new: &Robot) {
        if old.links == new.links {
            return;
        }
        let text = |link: &Option<super::Inertia>| {
            link.as_ref().map_or("null".to_string(), |inertia| write::flow(&write::inertia_fields(inertia), 4))
        };
        let Some(items) = root.fields().and_then(|top| child(top, "links")).and_then(Node::items) else {
            let lines: Vec<String> = new.links.iter().map(|link| format!("  - {}", text(link))).collect();
            return self.append_section("links", &lines);
        };
        for (node, (old, new)) in items.iter().zip(old.links.iter().zip(&new.links)) {
            match (old, new) {
                (old, new) if old == new => {}
                (Some(old), Some(new)) => {
                    self.mapping(node, &write::inertia_fields(old), &write::inertia_fields(new));
                }
                _ => self.replace(node.span.clone(), text(new)),
            }
        }
    }
}

/// Fields of a drive: its own, and those of plain friction.
struct Parts {
    own: Vec<Field>,
    friction: Vec<Field>,
}

impl Parts {
    fn of(drive: &Drive) -> Self {
        let plain = write::friction_fields(drive);
        let own = write::drive_fields(drive).into_iter().filter(|(key, _)| key != "friction").collect();
        Self { own, friction: plain }
    }
}

/// Files read by the runs in the `provenance` of a robot file's text: purpose, path, SHA-256.
pub fn files_of_runs(text: &str) -> Vec<[String; 3]> {
    let word = |file: &Node, key: &str| -> Option<String> {
        match &child(file.fields()?, key)?.kind {
            Kind::Scalar { text, .. } => Some(text.clone()),
            _ => None,
        }
    };
    let of_run = |run: &Node| -> Option<Vec<[String; 3]>> {
        let files = child(run.fields()?, "files")?.items()?.iter();
        Some(files.filter_map(|file| Some([word(file, "for")?, word(file, "path")?, word(file, "sha256")?])).collect())
    };
    let root = yaml::parse(text).ok();
    let runs = root.as_ref().and_then(Node::fields).and_then(|top| child(top, "provenance")).and_then(Node::items);
    runs.unwrap_or_default().iter().filter_map(of_run).flatten().collect()
}

/// Text with one more run in its `provenance`.
fn with_run(text: &str, run: &Run) -> String {
    if *run == Run::default() {
        return text.to_string();
    }
    let mut editor = Editor::new(text);
    let lines = run_lines(run);
    let root = yaml::parse(text).ok();
    let present = root.as_ref().and_then(Node::fields).and_then(|top| child(top, "provenance"));
    match present.and_then(|node| Some((node, node.items()?.last()?))) {
        Some((node, last)) if !editor.is_flow(node) => {
            let indent = " ".repeat(node.span.start - editor.line_start(node.span.start));
            let at = editor.line_end(last.span.end);
            let new_line = editor.new_line();
            let lines: String = lines.iter().map(|line| format!("{new_line}{indent}{}", &line[2..])).collect();
            editor.replace(at..at, lines);
        }
        Some((node, last)) => {
            let at = last.span.end;
            editor.replace(at..at, format!(", {}", write::flow(&run_fields(run), node.mark.column)));
        }
        None => editor.append_section("provenance", &lines),
    }
    editor.applied()
}

/// The run as an item of a list, in lines indented by two blanks.
fn run_lines(run: &Run) -> Vec<String> {
    let mut lines = vec![
        format!("  - command: {}", write::word(&run.command)),
        format!("    version: {}", write::text(&run.version)),
    ];
    if !run.options.is_empty() {
        lines.push("    options: [".to_string());
        for option in run.options.iter().map(|option| write::text(option)) {
            let last = lines.len() - 1;
            match lines[last].len() + option.len() {
                _ if lines[last].ends_with('[') => lines[last] += &option,
                width if width > WIDTH => {
                    lines[last] += ",";
                    lines.push(format!("      {option}"));
                }
                _ => lines[last] += &format!(", {option}"),
            }
        }
        lines.last_mut().into_iter().for_each(|line| line.push(']'));
    }
    if !run.files.is_empty() {
        lines.push("    files:".to_string());
        lines.extend(run.files.iter().map(|file| format!("      - {}", write::braces(&file_fields(file)))));
    }
    if !run.found.is_empty() {
        lines.push("    found:".to_string());
        lines.extend(run.found.iter().map(|sentence| format!("      - {}", write::text(sentence))));
    }
    lines
}

/// The run as fields of an item in a bracketed list.
fn run_fields(run: &Run) -> Vec<Field> {
    let list = |items: Vec<String>| format!("[{}]", items.join(", "));
    let texts = |items: &[String]| list(items.iter().map(|item| write::text(item)).collect());
    let files = list(run.files.iter().map(|file| write::braces(&file_fields(file))).collect());
    [
        ("command", write::text(&run.command)),
        ("version", write::text(&run.version)),
        ("options", texts(&run.options)),
        ("files", files),
        ("found", texts(&run.found)),
    ]
    .map(|(key, text)| (key.to_string(), text))
    .to_vec()
}

fn file_fields([purpose, path, sha256]: &[String; 3]) -> Vec<Field> {
    [("for", purpose), ("path", path), ("sha256", sha256)]
        .map(|(key, text)| (key.to_string(), write::text(text)))
        .to_vec()
}

/// Comments at the head of a file, except the editor line, which is written separately.
fn earlier_comments(text: &str) -> String {
    let head = text.lines().take_while(|line| line.trim_start().starts_with('#'));
    head.filter(|line| !line.contains("yaml-language-server")).map(|line| format!("{line}\n")).collect()
}
