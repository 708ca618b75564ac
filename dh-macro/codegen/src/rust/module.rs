//! Generates the same text as one module, to which the macro expands.

use super::krate::{Runtime, parts};
use super::{dispatch, implementations};
use crate::robot::Robot;

/// Expansion of the macro.
pub struct Module {
    /// Body of the module: the crate's files folded into nested inline modules, without tests.
    pub body: String,
    scalar: &'static str,
}

impl Module {
    /// Trait implementations for the type `of`; they call the functions of `module`, a path.
    pub fn implementations(&self, of: &str, module: &str) -> String {
        implementations::print(self.scalar, of, &format!("{module}::"))
    }
}

/// The robot as the body of a module that includes its runtime.
pub fn module(robot: &Robot, source: &str) -> String {
    module_on(robot, source, &Runtime::Shipped).body
}

/// The robot as a module, with a choice of the runtime.
pub fn module_on(robot: &Robot, source: &str, runtime: &Runtime) -> Module {
    let parts = parts(robot, source, &[], runtime);
    // Features are those of the crate that contains the module.
    let plain = |text: &str| text.replace(dispatch::DECLARED, "");
    let root = plain(&parts.root).replace("#[cfg(test)]\nmod tests;\n", "");
    let body = inlined(&root, "", &|path| parts.files.get(path).map(|text| plain(text)));
    Module { body: format!("{}\n{body}", parts.module), scalar: parts.scalar }
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
