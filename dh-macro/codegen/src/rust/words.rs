//! Converts words of a robot file for Rust: identifiers, comments, the manifest.
//!
//! A word of the file never becomes an identifier beside the printer's own. Its constants are items
//! of the module `constants`, which contains nothing else, and kernels use `k_<word>`: no other
//! name in a kernel starts like this.

use core::fmt::Write;
use std::collections::BTreeSet;

/// Prefix of the names of a file's constants within kernels.
pub(super) const LOCAL: &str = "k_";

/// Keywords of all editions, including reserved ones.
const KEYWORDS: &[&str] = &[
    "abstract", "as", "async", "await", "become", "box", "break", "const", "continue", "do", "dyn", "else", "enum",
    "extern", "false", "final", "fn", "for", "gen", "if", "impl", "in", "let", "loop", "macro", "match", "mod", "move",
    "mut", "override", "priv", "pub", "ref", "return", "static", "struct", "trait", "true", "try", "type", "typeof",
    "unsafe", "unsized", "use", "virtual", "where", "while", "yield",
];
/// Words that are no identifiers, not even raw ones.
const NEVER: &[&str] = &["_", "Self", "crate", "self", "super"];

/// A constant of the robot file in printed code.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Constant {
    /// Word in the file.
    pub word: String,
    /// Name of its item in the module `constants`.
    pub item: String,
    /// Name of its variable in kernels.
    pub local: String,
    pub value: f64,
}

/// Distinct identifiers for the constants of a file; a word that is a valid identifier is not
/// changed.
pub(super) fn constants(named: &[(String, f64)]) -> Vec<Constant> {
    let is_own = |word: &str| identifier(word) == word;
    let mut taken: BTreeSet<String> = named.iter().map(|(word, _)| word.clone()).filter(|word| is_own(word)).collect();
    let mut list: Vec<Constant> = Vec::with_capacity(named.len());
    for (word, value) in named {
        let mut name = identifier(word);
        let repeated = list.iter().any(|c| c.word == *word);
        while (!is_own(word) || repeated) && taken.contains(&name) {
            name.push('_');
        }
        taken.insert(name.clone());
        let item = if KEYWORDS.contains(&name.as_str()) { format!("r#{name}") } else { name.clone() };
        list.push(Constant { word: word.clone(), item, local: format!("{LOCAL}{name}"), value: *value });
    }
    list
}

/// Identifier of ASCII letters, digits and `_`; any other character is replaced by its number.
fn identifier(word: &str) -> String {
    let mut name = String::with_capacity(word.len());
    for c in word.chars() {
        match c {
            'a'..='z' | 'A'..='Z' | '0'..='9' | '_' => name.push(c),
            _ => {
                let _ = write!(name, "_u{:x}", c as u32);
            }
        }
    }
    if name.is_empty() || name.starts_with(|c: char| c.is_ascii_digit()) {
        name.insert(0, '_');
    }
    if NEVER.contains(&name.as_str()) {
        name.push('_');
    }
    name
}

/// A word as code within a comment: on one line, without characters that change the direction of
/// the text.
pub(super) fn code(word: &str) -> String {
    let plain: String = word.chars().map(visible).collect();
    if plain.contains('`') { format!("`` {plain} ``") } else { format!("`{plain}`") }
}

fn visible(c: char) -> String {
    match c {
        '"' | '\'' | '\\' => c.to_string(),
        _ => c.escape_debug().to_string(),
    }
}

/// String literal of a TOML file.
pub(super) fn toml(text: &str) -> String {
    let one = |c: char| match c {
        '"' | '\\' => format!("\\{c}"),
        c if c.is_control() => format!("\\u{:04x}", c as u32),
        c => c.to_string(),
    };
    format!("\"{}\"", text.chars().map(one).collect::<String>())
}

/// Text of `src/constants.rs`.
pub(super) fn module(constants: &[Constant]) -> String {
    let mut t =
        String::from("//! Named constants of the robot file, m and rad.\n\n#![allow(non_upper_case_globals)]\n");
    for c in constants {
        let _ = writeln!(t, "\n/// {} of the robot file.\npub const {}: f64 = {:?};", code(&c.word), c.item, c.value);
    }
    t
}

#[cfg(test)]
mod tests {
    use super::*;

    fn items(words: &[&str]) -> Vec<String> {
        constants(&words.iter().map(|w| (w.to_string(), 1.0)).collect::<Vec<_>>()).into_iter().map(|c| c.item).collect()
    }

    #[test]
    fn words_are_kept_where_they_are_identifiers() {
        assert_eq!(items(&["L1", "l1", "_x", "type", "f64"]), ["L1", "l1", "_x", "r#type", "f64"]);
        assert_eq!(items(&["_", "self", "Self", "2x", ""]), ["__", "self_", "Self_", "_2x", "___"]);
    }

    #[test]
    fn escaped_words_never_meet() {
        assert_eq!(items(&["self", "self_", "self__"]), ["self___", "self_", "self__"]);
        assert_eq!(items(&["\u{f6}", "_uf6", "o\u{308}"]), ["_uf6_", "_uf6", "o_u308"]);
        assert_eq!(items(&["a b", "a-b", "a_u20b"]), ["a_u20b_", "a_u2db", "a_u20b"]);
    }

    #[test]
    fn comments_stay_on_their_line() {
        assert_eq!(code("a\n*/ \u{202e}`"), "`` a\\n*/ \\u{202e}` ``");
        assert_eq!(toml("a\"\n"), "\"a\\\"\\u000a\"");
    }
}
