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
