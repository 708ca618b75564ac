//! Prints the `Cargo.toml` of a generated crate. It lists the other files, so that the next run
//! removes those that it no longer writes, and never a file from another source.

use std::collections::BTreeMap;

use super::krate::Runtime;
use super::words;
use crate::robot::crate_name;

/// First words of the `Cargo.toml` of every generated crate, which identify a folder as written by
/// the generator.
pub const MARK: &str = "# Written by `denavit generate`.";

/// Line before the list of files, and line after it.
const LIST: [&str; 2] = ["files = [", "]"];

/// Text of `Cargo.toml`; `files`: the other files of the crate.
pub(super) fn print(robot: &str, runtime: &Runtime, files: &BTreeMap<String, String>) -> String {
    let name = crate_name(robot);
    let description = words::toml(&format!("Closed-form kinematics and dynamics of {robot}"));
    let (place, dependencies, dispatch) = match runtime {
        Runtime::Shipped => ("A folder of its own: copy it anywhere.", String::new(), ""),
        Runtime::Crate(line) => {
            ("It runs on denavit-runtime.", format!("denavit-runtime = {line}\n"), "\"denavit-runtime/dispatch\"")
        }
    };
    let list: String = files.keys().map(|path| format!("    {},\n", words::toml(path))).collect();
    format!(
        "{MARK} {place}\n[package]\nname = \"{name}\"\nversion = \"0.1.0\"\nedition = \"2024\"\nlicense = \"MIT OR Apache-2.0\"\ndescription = {description}\nreadme = \"README.md\"\npublish = false\n\n# Files of the generator: the next run removes those that it no longer writes.\n[package.metadata.denavit]\n{}\n{list}{}\n\n[features]\n# Module `dispatch`: instructions that the processor picks at run time. Needs `std`.\ndispatch = [{dispatch}]\n\n[dependencies]\n{dependencies}\n[workspace]\n",
        LIST[0], LIST[1]
    )
}

/// Files listed in a generated `Cargo.toml`; empty for any other text.
pub fn listed(manifest: &str) -> Vec<&str> {
    if !manifest.starts_with(MARK) {
        return Vec::new();
    }
    let list = manifest.lines().skip_while(|line| *line != LIST[0]).skip(1).take_while(|line| *line != LIST[1]);
    list.filter_map(|line| line.trim().strip_prefix('"')?.strip_suffix("\",")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_list_is_read_as_it_was_written() {
        let files = ["README.md", "src/ik/plane.rs", "src/lib.rs"];
        let crate_files = files.iter().map(|path| (path.to_string(), String::new())).collect();
        let text = print("arm", &Runtime::Shipped, &crate_files);
        assert_eq!(listed(&text), files);
        assert_eq!(listed(&text.replace(MARK, "# Mine.")), Vec::<&str>::new());
        assert_eq!(listed(&format!("{MARK}\n[package]\n")), Vec::<&str>::new(), "before there was a list");
    }
}
