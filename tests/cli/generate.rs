use super::*;

#[test]
fn a_fresh_crate_passes_the_check_and_a_touched_one_is_named() {
    let crate_folder = folder("generate").join("planar2r");
    let out = crate_folder.display().to_string();
    let verb = ["generate", "robots/planar2r.yaml", "--out", &out];
    let check = [&verb[..], &["--check"]].concat();

    let missing = denavit(&check);
    assert_eq!(missing.status, Some(1), "nothing is there yet");
    assert!(!crate_folder.exists(), "a check writes nothing");

    assert_eq!(denavit(&verb).status, Some(0));
    assert_eq!(denavit(&check).status, Some(0));

    let path = crate_folder.join("src/lib.rs");
    let text = std::fs::read_to_string(&path).unwrap();
    std::fs::write(&path, format!("{text}// touched\n")).unwrap();
    let touched = denavit(&check);
    assert_eq!(touched.status, Some(1));
    assert!(touched.err.contains("src/lib.rs") && touched.err.contains("denavit generate"), "{}", touched.err);
    assert!(!touched.err.contains("Cargo.toml"), "only the touched file: {}", touched.err);

    let again = json(&[&verb[..], &["--json", "-"]].concat());
    assert_eq!(strings(&again["written"]), ["src/lib.rs"]);
    assert_eq!(std::fs::read_to_string(&path).unwrap(), text);
}

#[test]
fn the_crates_in_the_repository_are_fresh() {
    let run = denavit(&["generate", "robots/kuka-lwr4.yaml", "--out", "generated/kuka-lwr4", "--check"]);
    assert_eq!((run.status, run.err.as_str()), (Some(0), ""));
}

#[test]
fn adjoints_are_written_when_asked_for() {
    let crate_folder = folder("generate_adjoints").join("planar2r");
    let out = crate_folder.display().to_string();
    let verb = ["generate", "robots/planar2r.yaml", "--out", &out];
    assert_eq!(denavit(&[&verb[..], &["--adjoints"]].concat()).status, Some(0));
    let text = std::fs::read_to_string(crate_folder.join("src/lib.rs")).unwrap();
    assert!(text.contains("pub fn base_regressor_adjoint<S: Scalar>("), "{text}");
    assert!(crate_folder.join("src/kernel/frames_adjoint.rs").exists());
    let plain = denavit(&[&verb[..], &["--check"]].concat());
    assert!(plain.status == Some(1) && plain.err.contains("src/lib.rs"), "another crate: {}", plain.err);
}

/// All files below a folder, with their bytes.
fn contents(folder: &std::path::Path) -> Vec<(std::path::PathBuf, Vec<u8>)> {
    let mut all = Vec::new();
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        match path.is_dir() {
            true => all.extend(contents(&path)),
            false => all.push((path.clone(), std::fs::read(&path).unwrap())),
        }
    }
    all.sort();
    all
}

#[test]
fn a_folder_with_something_else_is_refused_and_left_alone() {
    let own = folder("generate_foreign");
    std::fs::create_dir_all(own.join("src")).unwrap();
    file(&own, "Cargo.toml", "[package]\nname = \"mine\"\n");
    file(&own.join("src"), "lib.rs", "// mine\n");
    let before = contents(&own);
    let out = own.display().to_string();
    let verb = ["generate", "robots/planar2r.yaml", "--out", &out];
    for arguments in [verb.to_vec(), [&verb[..], &["--check"]].concat()] {
        let run = denavit(&arguments);
        assert_eq!(run.status, Some(2), "{}", run.err);
        assert!(run.err.contains("Cargo.toml") && run.err.contains("--force"), "{}", run.err);
        assert_eq!(contents(&own), before);
    }
    std::fs::remove_file(own.join("Cargo.toml")).unwrap();
    assert_eq!(denavit(&verb).status, Some(2), "a folder without a manifest is somebody's too");

    assert_eq!(denavit(&[&verb[..], &["--force"]].concat()).status, Some(0));
    assert_eq!(denavit(&[&verb[..], &["--check"]].concat()).status, Some(0));
    assert_eq!(denavit(&verb).status, Some(0), "now it is the generator's own");
}

#[test]
fn empty_and_generated_folders_are_written_to() {
    let own = folder("generate_empty");
    let out = own.display().to_string();
    assert_eq!(denavit(&["generate", "robots/planar2r.yaml", "--out", &out]).status, Some(0));
    file(&own, "notes.txt", "mine");
    let other = denavit(&["generate", "robots/scara.yaml", "--out", &out]);
    assert_eq!(other.status, Some(0), "{}", other.err);
    assert!(std::fs::read_to_string(own.join("Cargo.toml")).unwrap().contains("name = \"scara\""));
    assert_eq!(std::fs::read_to_string(own.join("notes.txt")).unwrap(), "mine");
}

/// A file that can't be written stops the update midway.
#[test]
fn an_interrupted_update_does_not_compile_and_is_finished_by_the_next() {
    let own = folder("generate_interrupted");
    let out = own.display().to_string();
    let verb = |robot: &'static str| ["generate", robot, "--out", &out].map(String::from);
    let run = |robot: &'static str| denavit(&verb(robot).iter().map(String::as_str).collect::<Vec<_>>());
    assert_eq!(run("robots/planar2r.yaml").status, Some(0));
    let kernel = own.join("src/kernel/regressor.rs");
    std::fs::remove_file(&kernel).unwrap();
    std::fs::create_dir(&kernel).unwrap();
    assert_eq!(run("robots/scara.yaml").status, Some(1));
    assert!(std::fs::read_to_string(own.join("src/lib.rs")).unwrap().contains("compile_error!"));
    std::fs::remove_dir(&kernel).unwrap();
    assert_eq!(run("robots/scara.yaml").status, Some(0));
    assert!(!std::fs::read_to_string(own.join("src/lib.rs")).unwrap().contains("compile_error!"));
}

/// Files that the crate no longer has are removed; everything else in the folder is kept.
#[test]
fn files_of_an_earlier_run_are_removed() {
    let own = folder("generate_again");
    let out = own.display().to_string();
    let run = |more: &[&str]| denavit(&[&["generate", "robots/planar2r.yaml", "--out", &out], more].concat());
    assert_eq!(run(&["--adjoints"]).status, Some(0));
    file(&own.join("src/kernel"), "frames_mine.rs", "// mine");
    file(&own.join("src/ik"), "mine.rs", "// mine");
    let adjoint = own.join("src/kernel/frames_adjoint.rs");
    assert!(adjoint.exists());

    let stale = run(&["--check"]);
    assert!(stale.status == Some(1) && stale.err.contains("src/kernel/frames_adjoint.rs (no longer written)"));
    assert!(adjoint.exists(), "a check removes nothing");
    let again = json(&["generate", "robots/planar2r.yaml", "--out", &out, "--json", "-"]);
    assert!(strings(&again["removed"]).contains(&"src/kernel/frames_adjoint.rs"), "{again}");
    assert!(!adjoint.exists());
    assert_eq!(run(&["--check"]).status, Some(0));

    // With the runtime crate the copy of the runtime is removed, but not the files beside it.
    assert_eq!(run(&["--runtime", "crate"]).status, Some(0));
    assert!(!own.join("src/runtime").exists() && !own.join("src/ik.rs").exists());
    for kept in ["src/kernel/frames_mine.rs", "src/ik/mine.rs"] {
        assert_eq!(std::fs::read_to_string(own.join(kept)).unwrap(), "// mine", "{kept}");
    }
}

/// A list that names files outside the folder has no effect there.
#[test]
fn nothing_outside_the_folder_is_removed() {
    let own = folder("generate_outside");
    let crate_folder = own.join("planar2r");
    let out = crate_folder.display().to_string();
    let verb = ["generate", "robots/planar2r.yaml", "--out", &out];
    assert_eq!(denavit(&verb).status, Some(0));
    let beside = file(&own, "beside.txt", "mine");
    let manifest = crate_folder.join("Cargo.toml");
    let text = std::fs::read_to_string(&manifest).unwrap();
    let list = format!("files = [\n    \"../beside.txt\",\n    {beside:?},\n");
    std::fs::write(&manifest, text.replace("files = [\n", &list)).unwrap();
    assert_eq!(denavit(&verb).status, Some(0));
    assert_eq!(std::fs::read_to_string(&beside).unwrap(), "mine");
}

#[test]
fn a_new_crate_is_whole_or_absent() {
    let own = folder("generate_whole");
    let crate_folder = own.join("planar2r");
    assert_eq!(
        denavit(&["generate", "robots/planar2r.yaml", "--out", &crate_folder.display().to_string()]).status,
        Some(0)
    );
    let beside: Vec<_> = std::fs::read_dir(&own).unwrap().collect();
    assert_eq!(beside.len(), 1, "{beside:?}");
    let at_a_file = file(&own, "file", "");
    let run = denavit(&["generate", "robots/planar2r.yaml", "--out", &at_a_file]);
    assert!(run.status == Some(2) && run.err.contains("name a folder"), "{}", run.err);
}

/// With `denavit-runtime` a crate contains no runtime of its own; a repeated check uses its
/// options.
#[test]
fn a_crate_on_the_runtime_crate_names_it() {
    let folder = folder("generate_runtime");
    let out = folder.join("planar").display().to_string();
    let arguments = ["generate", "robots/planar2r.yaml", "--out", &out, "--runtime", "crate"];
    let with = |more: &[&str]| denavit(&[&arguments[..], more].concat());
    assert_eq!(with(&["--runtime-path", "../../dh-macro/runtime"]).status, Some(0));
    let read = |path: &str| std::fs::read_to_string(folder.join("planar").join(path)).unwrap();
    assert!(read("Cargo.toml").contains("denavit-runtime = { path = \"../../dh-macro/runtime\" }"));
    assert!(read("src/lib.rs").contains("pub use ::denavit_runtime::{ik, robot, runtime};"));
    assert!(!folder.join("planar/src/ik.rs").exists());
    let checked = with(&["--runtime-version", "0.1", "--check"]);
    assert!(
        checked.status == Some(1) && checked.err.contains("--runtime crate --runtime-version 0.1"),
        "{}",
        checked.err
    );
    let refused = denavit(&["generate", "robots/planar2r.yaml", "--out", &out, "--runtime-version", "0.1"]);
    assert!(refused.status == Some(2) && refused.err.contains("add --runtime crate"), "{}", refused.err);
    for wrong in ["nonsense", "", "1.2.3.4", "0.1 || 0.2"] {
        let refused = with(&["--runtime-version", wrong]);
        assert!(refused.status == Some(2) && refused.err.contains("no version"), "{wrong}: {}", refused.err);
    }
    assert_eq!(with(&["--runtime-version", ">=0.1, <0.3"]).status, Some(0));
    let early = with(&["--runtime-path", "../not/there"]);
    assert!(early.status == Some(0) && early.err.contains("no crate in"), "{}", early.err);
}

/// A drop-in crate contains the family of its robot and no other.
#[test]
fn a_drop_in_crate_ships_one_family() {
    let files = |robot: &str| {
        let text = std::fs::read_to_string(format!("robots/{robot}.yaml")).unwrap();
        let robot = dh_codegen::robot::Robot::from_yaml(&text, &dh_codegen::robot::no_files).unwrap().robot;
        dh_codegen::krate(&robot, &text)
    };
    let planar = files("planar2r");
    assert!(planar.contains_key("src/ik/plane.rs"));
    for other in ["quartic", "homotopy", "six", "regional", "swivel", "interval", "numerical", "nearby", "orient"] {
        assert!(!planar.contains_key(&format!("src/ik/{other}.rs")), "{other}");
    }
    let marked = |text: &String| text.lines().any(|line| line.trim_start().starts_with("// ["));
    assert!(!planar.values().any(marked), "markers are left out");
    let names = |robot: &str, family: &str| files(robot).contains_key(&format!("src/ik/{family}.rs"));
    assert!(names("kuka-lwr4", "swivel") && !names("kuka-lwr4", "six"));
}
