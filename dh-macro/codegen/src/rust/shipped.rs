//! Selects the modules of the runtime that a crate contains: those that its robot needs.

use denavit_runtime_core::sources::{FILES, Source, WITH_EFFECTS};

use crate::arm::Inverse;
use crate::ik::Family;

/// Attributes that silence lints of code left unused when other families are removed.
const ALLOW: &str = "// Without the other families some of it is unused.
#![allow(unused, irrefutable_let_patterns)]
";

/// Families of the inverse kinematics that an arm needs, as named in the sources.
fn families(inverse: &Inverse) -> Vec<&'static str> {
    let family = match inverse.family {
        Family::Six(_) | Family::Locked { .. } => Some("six"),
        Family::Swivel(_) => Some("swivel"),
        Family::Plane(_) => Some("plane"),
        Family::General(_) => Some("general"),
        Family::Numerical => Some("numerical"),
        Family::Slides => None,
    };
    let nearby = !inverse.exact && !matches!(inverse.family, Family::Numerical);
    family.into_iter().chain(nearby.then_some("nearby")).collect()
}

/// Path below `src/` and text of each module.
pub(super) fn files(inverse: &Inverse, effects: bool) -> Vec<(String, String)> {
    let families = families(inverse);
    let laws: &[Source] = if effects { WITH_EFFECTS } else { &[] };
    let needed = |of: &str| of.is_empty() || of.split('|').any(|family| families.contains(&family));
    let sources = FILES.iter().chain(laws).filter(|(_, _, of)| needed(of));
    sources.map(|(path, text, _)| (path.to_string(), pruned(path, text, &needed))).collect()
}

/// Text without its markers, and without the regions of other families.
fn pruned(path: &str, text: &str, needed: &dyn Fn(&str) -> bool) -> String {
    let mut out = String::with_capacity(text.len());
    let mut kept = true;
    for line in text.split_inclusive('\n') {
        let marker = line.trim().strip_prefix("// [").and_then(|rest| rest.strip_suffix(']'));
        match marker.map(|word| (word.strip_prefix('/'), word)) {
            Some((Some(_), _)) => kept = true,
            Some((None, of)) => kept = needed(of),
            None if kept => out += line,
            None => {}
        }
    }
    if path == "ik.rs" {
        let front: usize = out.split_inclusive('\n').take_while(|l| l.starts_with("//!")).map(str::len).sum();
        out.insert_str(front, &format!("\n{ALLOW}"));
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn regions_of_other_families_are_left_out() {
        let text = "a\n// [six]\nb\n// [/six]\n    // [six|swivel]\nc\n    // [/six|swivel]\nd\n";
        let of = |family: &'static str| pruned("x.rs", text, &|of| of.split('|').any(|f| f == family));
        assert_eq!(of("six"), "a\nb\nc\nd\n");
        assert_eq!(of("swivel"), "a\nc\nd\n");
        assert_eq!(of("plane"), "a\nd\n");
    }

    #[test]
    fn every_region_ends_and_has_a_known_family() {
        for (path, text, of) in FILES.iter().chain(WITH_EFFECTS) {
            let known = |of: &str| {
                of.split('|').all(|f| ["six", "swivel", "plane", "general", "numerical", "nearby"].contains(&f))
            };
            assert!(of.is_empty() || known(of), "{path}: {of}");
            let mut open = None;
            for line in text.lines() {
                let Some(word) = line.trim().strip_prefix("// [").and_then(|r| r.strip_suffix(']')) else { continue };
                match word.strip_prefix('/') {
                    Some(end) => assert_eq!(open.take(), Some(end), "{path}"),
                    None => {
                        assert!(known(word) && open.is_none(), "{path}: {word}");
                        open = Some(word);
                    }
                }
            }
            assert_eq!(open, None, "{path}");
        }
    }
}
