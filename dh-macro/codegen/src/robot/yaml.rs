//! Parses YAML to a tree in which every node has its line and column. The only file that uses the
//! YAML library.

use core::ops::Range;

use saphyr_parser::{Event, Parser, ScalarStyle};

use super::problem::Problem;

/// Longest file that is read, bytes.
const LARGEST: usize = 1 << 20;
/// Deepest nesting that is read; a robot file needs six.
const DEEPEST: usize = 32;
/// Longest list or mapping that is read.
const MOST_ENTRIES: usize = 1000;
/// Most problems of the text itself that are reported; further ones would be noise.
const MOST_PROBLEMS: usize = 50;

/// A location in a file; line and column count from 1, columns in characters.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Mark {
    /// Line, counted from 1.
    pub line: usize,
    /// Column in characters, counted from 1.
    pub column: usize,
}

/// A value with its location.
#[derive(Debug, Clone)]
pub struct Node {
    /// Location of the value.
    pub mark: Mark,
    /// Range of characters from the start of the text, without a byte order mark.
    pub(super) span: Range<usize>,
    /// Content of the value.
    pub kind: Kind,
}

/// Content of a node.
#[derive(Debug, Clone)]
pub enum Kind {
    /// Empty, `null` or `~`.
    Null,
    /// Scalar. Unquoted text may be a number or a flag; quoted text is text or an expression.
    Scalar {
        /// Text without the quotes.
        text: String,
        /// Whether it was quoted.
        quoted: bool,
    },
    /// List: `[a, b]`, or lines with dashes.
    List(Vec<Node>),
    /// Mapping: `{ key: value }`, or lines `key: value`, in the file's order.
    Map(Vec<(Word, Node)>),
}

/// A key with its location.
#[derive(Debug, Clone)]
pub struct Word {
    /// Location of the key.
    pub mark: Mark,
    /// Start of the key, in characters.
    pub(super) start: usize,
    /// Text of the key.
    pub text: String,
}

impl Kind {
    /// Description of what the author wrote, for messages.
    pub fn describe(&self) -> String {
        match self {
            Self::Null => "nothing".to_string(),
            Self::Scalar { text, .. } => format!("`{}`", shortened(text)),
            Self::List(items) => format!("a list of {}", items.len()),
            Self::Map(_) => "a mapping".to_string(),
        }
    }
}

/// At most 40 characters of a text, on one line.
pub fn shortened(text: &str) -> String {
    let line: String = text.chars().map(|c| if c.is_control() { ' ' } else { c }).take(40).collect();
    if text.chars().nth(40).is_some() { format!("{line}...") } else { line }
}

/// Reads one YAML document.
pub(super) fn parse(text: &str) -> Result<Node, Vec<Problem>> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    refuse_unreadable(text)?;
    let mut tree = Tree::default();
    for event in Parser::new_from_str(text) {
        match event {
            Err(e) => {
                let mark = Mark { line: e.marker().line(), column: e.marker().col() + 1 };
                tree.problem(mark, what_for(e.info()), mend_for(e.info()));
                break;
            }
            Ok((event, span)) => {
                let mark = Mark { line: span.start.line(), column: span.start.col() + 1 };
                let range = span.start.index()..span.end.index();
                if tree.take(event, mark, range).is_err() || tree.problems.len() >= MOST_PROBLEMS {
                    break;
                }
            }
        }
    }
    match tree.root {
        Some(root) if tree.problems.is_empty() => Ok(root),
        None if tree.problems.is_empty() => Err(vec![empty()]),
        _ => Err(tree.problems),
    }
}

fn at(mark: Mark, what: impl Into<String>, mend: impl Into<String>) -> Problem {
    let Mark { line, column } = mark;
    Problem { file: None, path: String::new(), line, column, what: what.into(), mend: mend.into() }
}

fn empty() -> Problem {
    at(Mark { line: 1, column: 1 }, "the file is empty", "start with `name:`; robots/README.md shows a whole file")
}

/// Message of the YAML library, or a clearer one.
fn what_for(info: &str) -> String {
    if info.contains("recursion") {
        format!("more than {DEEPEST} levels of nesting")
    } else {
        format!("this is not YAML: {info}")
    }
}

fn mend_for(info: &str) -> &'static str {
    if info.contains("recursion") {
        "a robot file needs six; check the brackets"
    } else if info.contains("anchor") {
        "aliases (`*name`) are not read: write the value out"
    } else if info.contains("flow") || info.contains("':'") || info.contains("']'") || info.contains("'}'") {
        "look for a `[`, `{` or `,` too many or too few, here or just above"
    } else if info.contains("quote") || info.contains("scalar") {
        "look for a quote that is not closed"
    } else {
        "check the indentation and the `key: value` form of this line and the one above"
    }
}

/// Detects mistakes that the YAML library would report late, or with unhelpful messages.
fn refuse_unreadable(text: &str) -> Result<(), Vec<Problem>> {
    let start = Mark { line: 1, column: 1 };
    if text.len() > LARGEST {
        let what = format!("the file has {} bytes; a robot file has at most {LARGEST}", text.len());
        return Err(vec![at(start, what, "this does not look like a robot file")]);
    }
    if text.trim().is_empty() {
        return Err(vec![empty()]);
    }
    let mut problems = Vec::new();
    for (row, line) in text.lines().enumerate() {
        let line_number = row + 1;
        let indent = line.chars().take_while(|c| c.is_whitespace()).collect::<String>();
        if let Some(column) = indent.chars().position(|c| c == '\t')
            && !line.trim().is_empty()
        {
            let mark = Mark { line: line_number, column: column + 1 };
            problems.push(at(mark, "a tab indents this line", "YAML indents with blanks: replace the tab by two"));
        }
        if let Some(column) = line.chars().position(|c| c.is_control() && c != '\t' && c != '\r') {
            let mark = Mark { line: line_number, column: column + 1 };
            problems.push(at(mark, "a control character stands here", "delete it; is this a text file?"));
        }
        if problems.len() >= MOST_PROBLEMS {
            break;
        }
    }
    if problems.is_empty() { Ok(()) } else { Err(problems) }
}

/// A list or mapping that is not closed yet.
enum Open {
    List(Mark, usize, Vec<Node>),
    /// Mapping; the last field is a key without its value yet.
    Map(Mark, usize, Vec<(Word, Node)>, Option<Word>),
}

#[derive(Default)]
struct Tree {
    open: Vec<Open>,
    root: Option<Node>,
    documents: usize,
    problems: Vec<Problem>,
}

/// Marker: the rest of the file can't be parsed.
struct Stop;

impl Tree {
    fn problem(&mut self, mark: Mark, what: impl Into<String>, mend: impl Into<String>) {
        self.problems.push(at(mark, what, mend));
    }

    fn take(&mut self, event: Event<'_>, mark: Mark, span: Range<usize>) -> Result<(), Stop> {
        let entries = match self.open.last() {
            Some(Open::List(_, _, items)) => items.len(),
            Some(Open::Map(_, _, fields, _)) => fields.len(),
            None => 0,
        };
        if entries > MOST_ENTRIES {
            let what = format!("more than {MOST_ENTRIES} entries in a list or mapping");
            self.problem(mark, what, "this does not look like a robot file");
            return Err(Stop);
        }
        match event {
            Event::Nothing | Event::StreamStart | Event::StreamEnd | Event::DocumentEnd => {}
            Event::DocumentStart(_) => {
                self.documents += 1;
                if self.documents > 1 {
                    self.problem(
                        mark,
                        "a second document starts here",
                        "keep one robot per file; delete the `---` line",
                    );
                    return Err(Stop);
                }
            }
            Event::Alias(_) => {
                self.problem(mark, "an alias (`*name`) stands here", "write the values out; aliases are not read");
                self.value(Node { mark, span, kind: Kind::Null });
            }
            Event::Scalar(text, style, anchor, tag) => {
                self.refuse_decoration(mark, anchor, tag.is_some());
                let quoted = style != ScalarStyle::Plain;
                let kind = match &*text {
                    "" | "~" | "null" | "Null" | "NULL" if !quoted => Kind::Null,
                    _ => Kind::Scalar { text: text.into_owned(), quoted },
                };
                self.scalar(mark, span, kind)?;
            }
            Event::SequenceStart(anchor, tag) => {
                self.refuse_decoration(mark, anchor, tag.is_some());
                self.opened(Open::List(mark, span.start, Vec::new()), mark)?;
            }
            Event::MappingStart(anchor, tag) => {
                self.refuse_decoration(mark, anchor, tag.is_some());
                self.opened(Open::Map(mark, span.start, Vec::new(), None), mark)?;
            }
            Event::SequenceEnd | Event::MappingEnd => match self.open.pop() {
                Some(Open::List(mark, start, items)) => {
                    let last = items.last().map_or(start, |item| item.span.end);
                    self.value(Node { mark, span: start..closed(last, &span), kind: Kind::List(items) });
                }
                Some(Open::Map(mark, start, fields, _)) => {
                    let last = fields.last().map_or(start, |(_, value)| value.span.end);
                    self.value(Node { mark, span: start..closed(last, &span), kind: Kind::Map(fields) });
                }
                None => return Err(Stop),
            },
        }
        Ok(())
    }

    fn refuse_decoration(&mut self, mark: Mark, anchor: usize, tag: bool) {
        if anchor > 0 {
            self.problem(mark, "an anchor (`&name`) stands here", "write the values out; anchors are not read");
        }
        if tag {
            self.problem(mark, "a tag (`!name`) stands here", "delete it; tags are not read");
        }
    }

    fn opened(&mut self, open: Open, mark: Mark) -> Result<(), Stop> {
        if let Some(Open::Map(_, _, _, key @ None)) = self.open.last_mut() {
            // The value would follow; the structure of the rest is unreliable.
            *key = Some(Word { mark, start: 0, text: String::new() });
            self.problem(mark, "a key is a list or a mapping", "a key is a word, followed by `: ` and its value");
            return Err(Stop);
        }
        if self.open.len() >= DEEPEST {
            self.problem(
                mark,
                format!("more than {DEEPEST} levels of nesting"),
                "a robot file needs six; check the brackets",
            );
            return Err(Stop);
        }
        self.open.push(open);
        Ok(())
    }

    /// Adds a scalar: a key if the current mapping expects one, otherwise a value.
    fn scalar(&mut self, mark: Mark, span: Range<usize>, kind: Kind) -> Result<(), Stop> {
        let Some(Open::Map(_, _, fields, key @ None)) = self.open.last_mut() else {
            self.value(Node { mark, span, kind });
            return Ok(());
        };
        let Kind::Scalar { text, .. } = kind else {
            self.problem(mark, "a value without a key", "write `key: value`");
            return Err(Stop);
        };
        let first = fields.iter().find(|(word, _)| word.text == text).map(|(word, _)| word.mark.line);
        let merge = text == "<<";
        let name = shortened(&text);
        *key = Some(Word { mark, start: span.start, text });
        if merge {
            self.problem(mark, "a merge key (`<<`) stands here", "write the values out; merge keys are not read");
        } else if let Some(line) = first {
            self.problem(
                mark,
                format!("the key `{name}` stands a second time; the first is in line {line}"),
                "keep one of the two",
            );
        }
        Ok(())
    }

    fn value(&mut self, node: Node) {
        match self.open.last_mut() {
            None => self.root = Some(node),
            Some(Open::List(_, _, items)) => items.push(node),
            Some(Open::Map(_, _, fields, key)) => {
                if let Some(word) = key.take() {
                    fields.push((word, node));
                }
            }
        }
    }
}

/// End of a list or mapping: its bracket or, in block style, its last entry.
fn closed(last: usize, end: &Range<usize>) -> usize {
    if end.is_empty() { last } else { end.end }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn first(text: &str) -> String {
        parse(text).map(|_| String::new()).unwrap_or_else(|problems| problems[0].to_string())
    }

    #[test]
    fn nodes_know_their_places() {
        let Ok(root) = parse("a: 1\nb:\n  - { c: x y }\n") else { panic!("it is good YAML") };
        let Kind::Map(fields) = root.kind else { panic!("a mapping") };
        let Kind::List(items) = &fields[1].1.kind else { panic!("a list") };
        let Kind::Map(inner) = &items[0].kind else { panic!("a mapping") };
        assert_eq!((inner[0].0.mark, inner[0].1.mark), (Mark { line: 3, column: 7 }, Mark { line: 3, column: 10 }));
    }

    #[test]
    fn deep_and_large_input_is_refused_quietly() {
        assert!(first(&"[".repeat(100_000)).contains("nesting"));
        assert!(first(&"{a: ".repeat(100)).contains("nesting"));
        assert!(first(&"- ".repeat(5_000)).contains("nesting"));
        assert!(first(&"a".repeat(2 << 20)).contains("bytes"));
        assert!(first(&"- a\n".repeat(200_000)).contains("entries"));
        let many: String = (0..50_000).map(|k| format!("k{k}: 1\n")).collect();
        assert!(first(&many).contains("entries"));
        assert!(first(" \n\n").contains("empty"));
        assert!(first("# only a comment\n").contains("empty"));
    }
}
