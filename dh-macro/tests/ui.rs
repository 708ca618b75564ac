//! Messages of the compiler for uses that the derive refuses: each `ui/*.rs` with its `.stderr`.

use std::path::Path;

#[test]
fn mistakes_are_told_at_the_path() {
    // trybuild compiles in a crate of its own under the target folder, where the macro then looks
    // for robot files.
    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).parent().unwrap();
    let robots = target.join("tests/trybuild/dh-macro/robots");
    std::fs::create_dir_all(&robots).unwrap();
    for name in ["broken.yaml", "no-tool.yaml"] {
        let from = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/ui/robots").join(name);
        std::fs::copy(from, robots.join(name)).unwrap();
    }
    trybuild::TestCases::new().compile_fail("tests/ui/*.rs");
}
