//! Checks names of robots, which are also crate names.

/// Words that can't name a crate.
const RESERVED: &[&str] = &[
    "abstract", "as", "async", "await", "become", "box", "break", "const", "continue", "core", "crate", "do", "dyn",
    "else", "enum", "extern", "false", "final", "fn", "for", "gen", "if", "impl", "in", "let", "loop", "macro",
    "match", "mod", "move", "mut", "override", "priv", "pub", "ref", "return", "self", "static", "std", "struct",
    "super", "test", "trait", "true", "try", "type", "typeof", "unsafe", "unsized", "use", "virtual", "where", "while",
    "yield",
];
/// Longest name of a crate, characters.
pub(super) const LONGEST: usize = 64;

fn is_good(c: char) -> bool {
    c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-' || c == '_'
}

/// Whether the name is a reserved word of Rust or Cargo.
pub(super) fn is_reserved(name: &str) -> bool {
    RESERVED.contains(&name)
}

/// Whether the name has only lower-case letters, digits, dashes and underscores, and starts with a
/// letter.
pub(super) fn is_well_formed(name: &str) -> bool {
    name.starts_with(|c: char| c.is_ascii_lowercase()) && name.chars().all(is_good)
}

/// Nearest valid crate name; a valid name is not changed.
pub fn crate_name(name: &str) -> String {
    if is_reserved(name) {
        return format!("{name}-robot");
    }
    let mut slug = name.to_string();
    if !is_well_formed(name) {
        slug = name.to_lowercase().chars().map(|c| if is_good(c) { c } else { '-' }).collect();
        slug = slug.trim_matches('-').to_string();
        if !slug.starts_with(|c: char| c.is_ascii_lowercase()) {
            slug = format!("robot-{slug}").trim_end_matches('-').to_string();
        }
    }
    slug.truncate(LONGEST);
    slug
}
