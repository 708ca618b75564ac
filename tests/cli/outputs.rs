//! Tests of outputs: files are complete or absent, and nothing is destroyed that was not named.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

use super::*;

const PLANAR: &str = "robots/planar2r.yaml";

fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> =
        fs::read_dir(folder).unwrap().map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

fn refused(status: i32, arguments: &[&str], parts: &[&str]) {
    let run = denavit(arguments);
    assert_eq!(run.status, Some(status), "{arguments:?}: {}", run.err);
    assert!(!run.err.contains("panicked"), "{}", run.err);
    for part in parts {
        assert!(run.err.contains(part), "{arguments:?}: no `{part}` in: {}", run.err);
    }
}

#[test]
fn folders_are_not_made() {
    let folder = folder("outputs-folders");
    let page = folder.join("missing/x.html").display().to_string();
    // Checked before the long work: experiments of an hour are not started.
    refused(1, &["reproduce", "--report", &page], &["missing", "create it"]);
    let out = folder.join("missing/x.json").display().to_string();
    refused(1, &["check", PLANAR, "--json", &out], &["missing", "create it"]);
    let krate = folder.join("missing/crate").display().to_string();
    refused(1, &["generate", PLANAR, "--out", &krate], &["missing", "create it"]);
    assert_eq!(names(&folder), Vec::<String>::new());
    let krate = folder.join("crate").display().to_string();
    assert_eq!(denavit(&["generate", PLANAR, "--out", &krate]).status, Some(0));
    assert!(folder.join("crate/src/lib.rs").is_file());
}

#[test]
fn two_outputs_and_inputs_are_apart() {
    let folder = folder("outputs-apart");
    let one = folder.join("one").display().to_string();
    let same = folder.join("../outputs-apart/one").display().to_string();
    refused(2, &["reproduce", "--report", &one, "--json", &same], &["--report", "same place"]);
    let robot = file(&folder, "robot.yaml", fs::read(PLANAR).unwrap());
    refused(2, &["check", &robot, "--json", &robot], &["read by this command"]);
    assert_eq!(fs::read(&robot).unwrap(), fs::read(PLANAR).unwrap());
    assert_eq!(names(&folder), ["robot.yaml"]);
}

#[cfg(unix)]
mod unix {
    use std::os::unix::fs::{FileTypeExt, PermissionsExt, symlink};

    use super::*;

    #[test]
    fn links_modes_and_neighbours_are_kept() {
        let folder = folder("outputs-kept");
        let old = file(&folder, "old.json", "old");
        fs::set_permissions(&old, fs::Permissions::from_mode(0o600)).unwrap();
        file(&folder, "old.json.tmp", "somebody's");
        let link = folder.join("link.json");
        symlink("old.json", &link).unwrap();
        assert_eq!(denavit(&["check", PLANAR, "--json", link.to_str().unwrap()]).status, Some(0));
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        assert!(fs::read_to_string(&old).unwrap().contains("base_parameters"));
        assert_eq!(fs::metadata(&old).unwrap().permissions().mode() & 0o777, 0o600);
        assert_eq!(fs::read_to_string(folder.join("old.json.tmp")).unwrap(), "somebody's");
        // A dangling link creates its target.
        let dangling = folder.join("dangling.json");
        symlink("new.json", &dangling).unwrap();
        assert_eq!(denavit(&["check", PLANAR, "--json", dangling.to_str().unwrap()]).status, Some(0));
        assert!(fs::symlink_metadata(&dangling).unwrap().is_symlink());
        assert_eq!(names(&folder), ["dangling.json", "link.json", "new.json", "old.json", "old.json.tmp"]);
    }

    #[test]
    fn what_is_read_only_stays() {
        let folder = folder("outputs-read-only");
        let file = file(&folder, "kept.json", "kept");
        fs::set_permissions(&file, fs::Permissions::from_mode(0o444)).unwrap();
        refused(1, &["check", PLANAR, "--json", &file], &["kept.json", "read-only"]);
        assert_eq!(fs::read_to_string(&file).unwrap(), "kept");
        let inner = folder.join("inner");
        fs::create_dir(&inner).unwrap();
        fs::set_permissions(&inner, fs::Permissions::from_mode(0o555)).unwrap();
        refused(1, &["check", PLANAR, "--json", inner.join("x.json").to_str().unwrap()], &["read-only"]);
        assert_eq!(names(&inner), Vec::<String>::new());
        fs::set_permissions(&inner, fs::Permissions::from_mode(0o755)).unwrap();
    }

    #[test]
    fn pipes_and_devices_are_written_to() {
        let folder = folder("outputs-devices");
        let pipe = folder.join("pipe");
        assert!(Command::new("mkfifo").arg(&pipe).status().unwrap().success());
        let reader = pipe.clone();
        let reading = std::thread::spawn(move || fs::read_to_string(reader).unwrap());
        assert_eq!(denavit(&["check", PLANAR, "--json", pipe.to_str().unwrap()]).status, Some(0));
        assert!(reading.join().unwrap().contains("base_parameters"));
        assert!(fs::metadata(&pipe).unwrap().file_type().is_fifo());
        assert_eq!(denavit(&["check", PLANAR, "--json", "/dev/null"]).status, Some(0));
        assert!(fs::metadata("/dev/null").unwrap().file_type().is_char_device());
        for stdout in ["-", "/dev/stdout", "/dev/fd/1"] {
            let run = denavit(&["check", PLANAR, "--json", stdout]);
            assert_eq!(run.status, Some(0), "{}", run.err);
            assert!(serde_json::from_str::<serde_json::Value>(&run.out).is_ok(), "{stdout}: nothing but JSON");
        }
        assert_eq!(names(&folder), ["pipe"]);
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn full_disks_and_closed_pipes_are_errors_in_words() {
        refused(1, &["check", PLANAR, "--json", "/dev/full"], &["/dev/full", "No space left"]);
        let command = |arguments: &[&str]| {
            let mut command = Command::new(env!("CARGO_BIN_EXE_denavit"));
            command.args(arguments).current_dir(env!("CARGO_MANIFEST_DIR")).stderr(Stdio::piped());
            command
        };
        let full = || fs::File::options().write(true).open("/dev/full").unwrap();
        let asked: [&[&str]; 3] = [&["check", PLANAR], &["check", PLANAR, "--json", "-"], &["--help"]];
        for arguments in asked {
            let out = command(arguments).stdout(full()).output().unwrap();
            let said = String::from_utf8(out.stderr).unwrap();
            assert_eq!(out.status.code(), Some(1), "{arguments:?}: {said}");
            assert!(said.contains("standard output can't be written"), "{said}");
            // The reader is gone before the command starts, so that nothing fits into the pipe.
            let (reader, writer) = std::io::pipe().unwrap();
            drop(reader);
            let out = command(arguments).stdout(writer).output().unwrap();
            let said = String::from_utf8(out.stderr).unwrap();
            assert_eq!(out.status.code(), Some(1), "{arguments:?}: {said}");
            assert!(said.contains("standard output can't be written"), "{said}");
        }
        // Without standard error nothing panics either.
        let gone = command(&["check", "none.yaml"]).stderr(full()).output().unwrap();
        assert_eq!(gone.status.code(), Some(2));
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn a_killed_process_leaves_nothing() {
        let folder = folder("outputs-killed");
        let states = csv(&["q1".into(), "q2".into()], &vec![vec![0.1, 0.2]; 200_000]);
        let states = file(&folder, "states.csv", states);
        let out = folder.join("out.json");
        for delay in [50, 150, 400] {
            let mut child = Command::new(env!("CARGO_BIN_EXE_denavit"))
                .args(["eval", PLANAR, "--quantity", "mass_matrix", "--states", &states])
                .args(["--json", out.to_str().unwrap()])
                .current_dir(env!("CARGO_MANIFEST_DIR"))
                .spawn()
                .unwrap();
            std::thread::sleep(std::time::Duration::from_millis(delay));
            let _ = child.kill();
            child.wait().unwrap();
            if out.exists() {
                assert!(serde_json::from_slice::<serde_json::Value>(&fs::read(&out).unwrap()).is_ok(), "whole");
                fs::remove_file(&out).unwrap();
            }
            assert_eq!(names(&folder), ["states.csv"]);
        }
    }
}

#[test]
fn control_characters_are_shown() {
    let folder = folder("outputs-control");
    let robot = fs::read_to_string(PLANAR).unwrap().replacen("name: ", "name: \"a\\e[2Jb\\u009b\" # ", 1);
    let robot = file(&folder, "robot.yaml", robot);
    let joint = fs::read_to_string(PLANAR).unwrap().replacen("name: shoulder", "name: \"j\\e]0;x\\a\"", 1);
    let joint = file(&folder, "joint.yaml", joint);
    let states = file(&folder, "states.csv", "q1\u{1b}[31m,q2\nx\u{1b}[2J,1\n");
    let path = folder.join("pa\u{1b}th.yaml").display().to_string();
    for arguments in [
        vec!["check", &robot],
        vec!["check", &joint],
        vec!["check", &joint, "--json", "-"],
        vec!["check", &path],
        vec!["eval", PLANAR, "--quantity", "gravity", "--states", &states],
        vec!["check\u{1b}[2J", PLANAR],
    ] {
        let run = denavit(&arguments);
        let raw = |text: &str| text.chars().any(|c| c.is_control() && c != '\n' && c != '\t');
        assert!(!raw(&run.out) && !raw(&run.err), "{arguments:?}: {:?} {:?}", run.out, run.err);
    }
}

/// Names of joints and files are text in a page, never markup.
#[test]
fn names_are_no_markup() {
    let folder = folder("outputs-markup");
    let robot = fs::read_to_string(PLANAR).unwrap().replacen("name: shoulder", "name: \"<u>joint\\e\"", 1);
    let robot = file(&folder, "robot<u>.yaml", robot);
    let path = |name: &str| folder.join(name).display().to_string();
    let page = path("page.html");
    let without_markup = |arguments: &[&str]| {
        let run = denavit(&[arguments, &["--report", &page]].concat());
        assert_eq!(run.status, Some(0), "{}", run.err);
        let text = fs::read_to_string(&page).unwrap();
        // The script's input is JSON, in which only `</` matters.
        let data = text.find("<script id=data").unwrap();
        let end = data + text[data..].find("</script>").unwrap();
        let markup = format!("{}{}", &text[..data], &text[end..]);
        assert!(!markup.contains("<u>") && !markup.contains('\u{1b}'), "{arguments:?}");
        assert!(markup.contains("&lt;u&gt;"), "{arguments:?}");
    };
    let (motion, log) = (path("motion.csv"), path("log<u>.csv"));
    without_markup(&["excite", &robot, "--duration", "6", "--starts", "1", "--out", &motion]);
    assert_eq!(denavit(&["simulate", &robot, "--trajectory", &motion, "--out", &log]).status, Some(0));
    without_markup(&["identify", &robot, &log]);
    without_markup(&["diagnose", &robot, &log]);
    without_markup(&["force", &robot, &log]);
    without_markup(&["tool", &robot, "--loaded", &log]);
}
