//! Checks that `generated/` is up to date. With `DENAVIT_REGENERATE=1` in the environment stale
//! files are rewritten.

use std::collections::BTreeMap;
use std::path::Path;

use dh_codegen::Runtime;
use dh_codegen::robot::{Robot, no_files};

/// Environment variable that makes the test rewrite stale files.
const SWITCH: &str = "DENAVIT_REGENERATE";
/// Crates without dependencies.
const CRATES: [&str; 6] = ["planar2r", "kuka-lwr4", "franka-panda", "ur10e", "kinova-gen3", "stanford"];
/// Crates with `denavit-runtime`; `RUNTIME` is its entry in their `Cargo.toml`.
const ON_RUNTIME: [&str; 2] = ["puma560", "scara"];
const RUNTIME: &str = "{ path = \"../../dh-macro/runtime\" }";

#[test]
fn generated_crates_are_fresh() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let rewrite = std::env::var_os(SWITCH).is_some_and(|value| value == "1");
    let mut stale = Vec::new();
    for name in CRATES.into_iter().chain(ON_RUNTIME) {
        let text = std::fs::read_to_string(root.join(format!("robots/{name}.yaml"))).unwrap();
        let robot = Robot::from_yaml(&text, &no_files).unwrap().robot;
        assert_eq!(robot.name, name);
        let runtime = match ON_RUNTIME.contains(&name) {
            true => Runtime::Crate(RUNTIME.to_string()),
            false => Runtime::Shipped,
        };
        let expected = dh_codegen::krate_on(&robot, &text, &[], &runtime);
        let folder = root.join("generated").join(name);
        for path in orphans(&folder, &expected) {
            if rewrite {
                std::fs::remove_file(folder.join(&path)).unwrap();
            }
            stale.push(format!("{name}/{path} (no longer written)"));
        }
        for (path, expected) in expected {
            let file = folder.join(&path);
            if std::fs::read(&file).ok().as_deref() != Some(expected.as_bytes()) {
                if rewrite {
                    std::fs::create_dir_all(file.parent().unwrap()).unwrap();
                    std::fs::write(&file, expected).unwrap();
                }
                stale.push(format!("{name}/{path}"));
            }
        }
    }
    let hint = if rewrite { "(rewritten; look at the diff)" } else { "(rewrite them with DENAVIT_REGENERATE=1)" };
    assert!(stale.is_empty(), "stale files {hint}: {stale:#?}");
}

/// Sources on disk that the generator does not write.
fn orphans(folder: &Path, expected: &BTreeMap<String, String>) -> Vec<String> {
    let mut found = Vec::new();
    let mut folders = vec![folder.join("src")];
    while let Some(next) = folders.pop() {
        for entry in std::fs::read_dir(next).into_iter().flatten() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else {
                found.push(path.strip_prefix(folder).unwrap().to_str().unwrap().to_string());
            }
        }
    }
    found.retain(|path| !expected.contains_key(path));
    found
}

#[test]
fn every_generated_crate_is_watched() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("generated");
    for entry in std::fs::read_dir(root).unwrap() {
        let entry = entry.unwrap();
        if entry.path().join("Cargo.toml").exists() {
            let name = entry.file_name().into_string().unwrap();
            assert!(
                CRATES.iter().chain(&ON_RUNTIME).any(|c| *c == name),
                "{name} is not in the list of tests/fresh.rs"
            );
        }
    }
}

#[test]
fn the_same_file_gives_the_same_bytes() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("robots/ur10e.yaml");
    let text = std::fs::read_to_string(path).unwrap();
    let read = || Robot::from_yaml(&text, &no_files).unwrap().robot;
    assert_eq!(dh_codegen::krate(&read(), &text), dh_codegen::krate(&read(), &text));
}
