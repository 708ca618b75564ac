//! Tests of `denavit bundle` and `denavit replay`.

use std::io::{Cursor, Read, Write};

use super::*;

/// A simulated log of two joints, and its folder.
fn log(name: &str) -> (PathBuf, String) {
    let folder = folder(name);
    let motion: Vec<Vec<f64>> =
        (0..=50).map(|k| vec![f64::from(k) * 0.1, 0.3 * (f64::from(k) * 0.1).sin(), 0.2]).collect();
    let motion = file(&folder, "motion.csv", csv(&["t".into(), "q1".into(), "q2".into()], &motion));
    let log = folder.join("log.csv").display().to_string();
    let run = denavit(&["simulate", "robots/planar2r.yaml", "--trajectory", &motion, "--seed", "1", "--out", &log]);
    assert_eq!(run.status, Some(0), "{}", run.err);
    (folder, log)
}

/// Files of a zip.
fn unzipped(path: &str) -> Vec<(String, Vec<u8>)> {
    let mut zip = zip::ZipArchive::new(Cursor::new(std::fs::read(path).unwrap())).unwrap();
    (0..zip.len())
        .map(|k| {
            let mut file = zip.by_index(k).unwrap();
            let mut bytes = Vec::new();
            file.read_to_end(&mut bytes).unwrap();
            (file.name().unwrap().into_owned(), bytes)
        })
        .collect()
}

fn zipped(path: &str, files: &[(String, Vec<u8>)]) {
    let mut zip = zip::ZipWriter::new(Cursor::new(Vec::new()));
    for (name, bytes) in files {
        zip.start_file(name.as_str(), zip::write::SimpleFileOptions::default()).unwrap();
        zip.write_all(bytes).unwrap();
    }
    std::fs::write(path, zip.finish().unwrap().into_inner()).unwrap();
}

#[test]
fn a_run_is_repeated_bit_by_bit_from_its_bundle_alone() {
    let (folder, log) = log("bundle-repeated");
    let archive = folder.join("run.zip").display().to_string();
    let out = folder.join("identified.yaml");
    let out = out.to_str().unwrap();
    let verb = ["identify", "robots/planar2r.yaml", &log, "--out", out, "--json", "i.json"];
    let run = denavit(&[&["bundle", &archive, "--"][..], &verb].concat());
    assert_eq!(run.status, Some(0), "{}", run.err);
    // The results are in the bundle, not at the paths of the command line.
    assert!(!std::path::Path::new(out).exists());
    std::fs::remove_file(&log).unwrap();
    let names: Vec<String> = unzipped(&archive).into_iter().map(|(name, _)| name).collect();
    let expected = [
        "bundle.json",
        "inputs/0/planar2r.yaml",
        "inputs/1/log.csv",
        "outputs/i.json",
        "outputs/identified.yaml",
        "stderr.txt",
        "stdout.txt",
    ];
    assert_eq!(names, expected);
    let again = denavit(&["replay", &archive]);
    assert_eq!(again.status, Some(0), "{}", again.err);
    assert!(
        again.out.starts_with("the same exit status, messages and bits: 2 results of `denavit identify"),
        "{}",
        again.out
    );
}

#[test]
fn a_window_of_the_log_and_a_failing_run_are_bundled() {
    let (folder, log) = log("bundle-window");
    let archive = folder.join("run.zip").display().to_string();
    let verb = ["identify", "robots/planar2r.yaml", &log, "--torque", "current", "--json", "-"];
    let run = denavit(&[&["bundle", &archive, "--window", "1,2", "--"][..], &verb].concat());
    assert_eq!(run.status, Some(0), "{}", run.err);
    assert!(run.out.starts_with("ended with 2;"), "{}", run.out);
    let files = unzipped(&archive);
    let (_, rows) = files.iter().find(|(name, _)| name == "inputs/1/log.csv").unwrap();
    let rows = String::from_utf8(rows.clone()).unwrap();
    assert_eq!(rows.lines().count(), 1 + 1001, "{}", rows.lines().next().unwrap());
    assert_eq!(denavit(&["replay", &archive]).status, Some(0));
}

#[test]
fn other_results_are_named_and_foreign_archives_refused() {
    let (folder, log) = log("bundle-other");
    let archive = folder.join("run.zip").display().to_string();
    let run = denavit(&["bundle", &archive, "--", "log", "inspect", &log, "--json", "x.json"]);
    assert_eq!(run.status, Some(0), "{}", run.err);
    let good = unzipped(&archive);
    let replayed = |change: &dyn Fn(&mut String, &mut Vec<u8>)| {
        let mut files = good.clone();
        files.iter_mut().for_each(|(name, bytes)| change(name, bytes));
        zipped(&archive, &files);
        let run = denavit(&["replay", &archive]);
        (run.status, run.err)
    };
    let put = |from: &str, to: &str, bytes: &mut Vec<u8>| {
        *bytes = String::from_utf8(bytes.clone()).unwrap().replace(from, to).into_bytes();
    };
    // A command other than that of the results.
    let (status, err) = replayed(&|name, bytes| {
        if name == "bundle.json" {
            put("\"inspect\"", "\"convert\"", bytes);
        }
    });
    assert!(status == Some(1) && err.contains("outputs/x.json was not written again"), "{err}");
    let (status, err) = replayed(&|name, bytes| {
        if name == "outputs/x.json" {
            bytes.push(b' ');
        }
    });
    assert!(status == Some(2) && err.contains("not those that were written"), "{err}");
    let (status, err) = replayed(&|name, _| *name = name.replace("inputs/0", "inputs/../.."));
    assert!(status == Some(2) && err.contains("is no name of a file in it"), "{err}");
    let (status, err) = replayed(&|name, bytes| {
        if name == "bundle.json" {
            put("outputs/x.json", "/tmp/x.json", bytes);
        }
    });
    assert!(status == Some(2), "{err}");
    let refused = denavit(&["replay", &log]);
    assert!(refused.status == Some(2) && refused.err.contains("denavit bundle"), "{}", refused.err);
}
