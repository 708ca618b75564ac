//! The same text as one module: what the macro expands to.

use super::krate::parts;
use crate::robot::Robot;

/// The crate's files folded into nested inline modules (tests left out).
pub fn module(robot: &Robot, source: &str) -> String {
    let parts = parts(robot, source, &[]);
    let root = parts.root.replace("#[cfg(test)]\nmod tests;\n", "");
    let body = inlined(&root, "", &|path| parts.files.get(path).cloned());
    format!("{}\n{body}", parts.header)
}

/// Replaces each `mod x;` by `mod x { text of x.rs }`.
fn inlined(text: &str, folder: &str, file: &dyn Fn(&str) -> Option<String>) -> String {
    let mut out = String::with_capacity(text.len());
    for line in text.lines() {
        let declared = line.trim_end().strip_suffix(';').and_then(|l| {
            let name =
                l.trim_start().trim_start_matches("pub(super) ").trim_start_matches("pub ").strip_prefix("mod ")?;
            Some((l.to_string(), name.to_string()))
        });
        match declared.and_then(|(head, name)| Some((head, file(&format!("{folder}{name}.rs"))?, name))) {
            Some((head, inner, name)) => {
                let inner = inlined(&inner, &format!("{folder}{name}/"), file);
                out += &format!("{head} {{\n{inner}}}\n");
            }
            None => {
                out += line;
                out.push('\n');
            }
        }
    }
    out
}
