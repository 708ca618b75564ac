//! SQL over real recordings of the repository: laws of merging, bits, damaged files.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use datafusion::arrow::array::{Array, AsArray};
use datafusion::arrow::datatypes::Float64Type;
use datafusion::arrow::record_batch::RecordBatch;
use denavit::identify::RecordingFactor;
use denavit_fleet::Fleet;
use object_store::memory::InMemory;
use object_store::{ObjectStoreExt, PutPayload};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn robot() -> String {
    root().join("robots/kuka-iiwa14.yaml").display().to_string()
}

/// Recordings of an iiwa, three of them.
fn recordings() -> Vec<PathBuf> {
    let folder = std::fs::read_dir(root().join("data/kuka-iiwa14")).unwrap();
    let mut files: Vec<PathBuf> = folder.map(|entry| entry.unwrap().path()).collect();
    files.retain(|path| path.to_string_lossy().ends_with(".csv.gz"));
    files.sort();
    files.truncate(3);
    files
}

/// A folder with copies under these names.
fn folder(names: &[&str]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (name, path) in names.iter().zip(recordings()) {
        std::fs::copy(path, folder.path().join(name)).unwrap();
    }
    folder
}

fn run(fleet: &Fleet, query: &str) -> Vec<RecordBatch> {
    let runtime = tokio::runtime::Builder::new_multi_thread().worker_threads(2).enable_all().build().unwrap();
    runtime.block_on(async { fleet.context.sql(query).await.unwrap().collect().await.unwrap() })
}

fn bytes(batches: &[RecordBatch]) -> Vec<Vec<u8>> {
    let column = |batch: &RecordBatch| {
        batch.column(0).as_binary::<i32>().iter().map(|b| b.unwrap().to_vec()).collect::<Vec<_>>()
    };
    batches.iter().flat_map(column).collect()
}

fn merged(partitions: usize, place: &str) -> Vec<u8> {
    let fleet = Fleet::new(partitions);
    let query = format!("SELECT merge_factor(sha256, factor) FROM recordings('{place}', '{}')", robot());
    bytes(&run(&fleet, &query)).remove(0)
}

#[test]
fn any_partitioning_and_any_order_of_files_give_the_same_bits() {
    let (one, other) = (folder(&["a.csv.gz", "b.csv.gz", "c.csv.gz"]), folder(&["z.csv.gz", "y.csv.gz", "x.csv.gz"]));
    let first = merged(1, &one.path().display().to_string());
    for partitions in [2, 4] {
        assert_eq!(merged(partitions, &one.path().display().to_string()), first, "{partitions} partitions");
        assert_eq!(merged(partitions, &other.path().display().to_string()), first, "another order");
    }
    // The same recording twice counts once.
    std::fs::copy(one.path().join("a.csv.gz"), one.path().join("d.csv.gz")).unwrap();
    assert_eq!(merged(2, &one.path().display().to_string()), first);
}

/// Squares of the residuals per joint and in all: what a factor is good for.
fn grams(factor: &RecordingFactor) -> Vec<f64> {
    factor.factors.joints.iter().flat_map(|joint| joint.triangle.gram()).collect()
}

#[test]
fn the_factor_of_all_is_that_of_the_parts_merged() {
    let all = folder(&["a.csv.gz", "b.csv.gz", "c.csv.gz"]);
    let fleet = Fleet::new(2);
    let place = all.path().display();
    let query = format!("SELECT factor FROM recordings('{place}', '{}') ORDER BY sha256", robot());
    let parts = bytes(&run(&fleet, &query));
    let read = |bytes: &Vec<u8>| RecordingFactor::from_bytes("part", bytes).unwrap();
    let mut sum = grams(&read(&parts[0]));
    for part in &parts[1..] {
        sum.iter_mut().zip(grams(&read(part))).for_each(|(sum, x)| *sum += x);
    }
    let whole = grams(&read(&merged(2, &place.to_string())));
    let scale = sum.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    for (a, b) in whole.iter().zip(&sum) {
        assert!((a - b).abs() <= 1e-12 * scale, "{a} {b}");
    }
}

#[test]
fn a_damaged_file_is_a_row_with_its_reason() {
    let folder = folder(&["a.csv.gz", "b.csv.gz"]);
    let whole = std::fs::read(folder.path().join("a.csv.gz")).unwrap();
    std::fs::write(folder.path().join("cut.csv.gz"), &whole[..whole.len() / 2]).unwrap();
    std::fs::write(folder.path().join("no.parquet"), b"PAR1 and nothing else").unwrap();
    std::os::unix::fs::symlink("nowhere", folder.path().join("gone.csv")).unwrap();
    // No recordings: a pipe that nobody writes, and links back.
    assert!(std::process::Command::new("mkfifo").arg(folder.path().join("pipe.csv")).status().unwrap().success());
    std::os::unix::fs::symlink(".", folder.path().join("back")).unwrap();
    std::os::unix::fs::symlink(".", folder.path().join("again")).unwrap();
    let place = folder.path().display();
    let query = format!(
        "SELECT file, why, factor IS NULL AS empty, sha256 IS NULL FROM recordings('{place}', '{}') ORDER BY file",
        robot()
    );
    let rows = run(&Fleet::new(2), &query);
    let all: Vec<(String, Option<String>, bool)> = rows
        .iter()
        .flat_map(|batch| {
            let (files, whys) = (batch.column(0).as_string::<i32>(), batch.column(1).as_string::<i32>());
            let empty = batch.column(2).as_boolean();
            let row =
                |k: usize| (files.value(k).into(), (!whys.is_null(k)).then(|| whys.value(k).into()), empty.value(k));
            (0..batch.num_rows()).map(row).collect::<Vec<_>>()
        })
        .collect();
    assert_eq!(all.len(), 5, "{all:?}");
    for (file, why, empty) in all {
        println!("{file}: {why:?}");
        let sound = file.ends_with("a.csv.gz") || file.ends_with("b.csv.gz");
        assert_eq!(why.is_none(), sound);
        assert_eq!(empty, !sound);
    }
}

#[test]
fn models_errors_and_drifts_are_columns() {
    let folder = folder(&["a.csv.gz", "b.csv.gz", "c.csv.gz"]);
    let fleet = Fleet::new(2);
    let table = format!("recordings('{}', '{}')", folder.path().display(), robot());
    let query = format!(
        "WITH logs AS (SELECT * FROM {table}), whole AS (SELECT merge_factor(sha256, factor) AS f FROM logs)
         SELECT predict_error(factor, solve(f)) AS error, predict_error(factor, solve(factor)) AS own FROM logs, whole
         WHERE cardinality(drift(factor, f)) > 0"
    );
    let rows = run(&fleet, &query);
    let mut count = 0;
    for batch in &rows {
        let [errors, own] = [0, 1].map(|k| batch.column(k).as_primitive::<Float64Type>());
        for (error, own) in errors.iter().zip(own) {
            let (error, own) = (error.unwrap(), own.unwrap());
            println!("{error} %, with the recording's own model {own} %");
            // A model of this recording alone errs less on it than one of all, and neither is exact.
            assert!(own > 0.1 && own < error, "{own} % {error} %");
            count += 1;
        }
    }
    assert_eq!(count, 3);
}

#[test]
fn an_object_store_gives_the_bits_of_a_folder() {
    let folder = folder(&["a.csv.gz", "b.csv.gz", "c.csv.gz"]);
    let fleet = Fleet::new(2);
    let store = Arc::new(InMemory::new());
    let runtime = tokio::runtime::Runtime::new().unwrap();
    for entry in std::fs::read_dir(folder.path()).unwrap() {
        let path = entry.unwrap().path();
        let name = format!("monday/{}", path.file_name().unwrap().to_string_lossy());
        let bytes = PutPayload::from(std::fs::read(&path).unwrap());
        runtime.block_on(store.put(&name.into(), bytes)).unwrap();
    }
    let url = datafusion::execution::object_store::ObjectStoreUrl::parse("fleet://bucket").unwrap();
    fleet.context.register_object_store(url.as_ref(), store);
    let query = format!("SELECT merge_factor(sha256, factor) FROM recordings('fleet://bucket/monday/', '{}')", robot());
    let remote = bytes(&run(&fleet, &query)).remove(0);
    assert_eq!(remote, merged(1, &folder.path().display().to_string()));
}
