//! Runs that are killed and repeated: nothing is lost, nothing is there twice.

#[cfg(feature = "cluster")]
mod listening;

use std::io::{Read, Write};
use std::path::{Path, PathBuf};
#[cfg(feature = "cluster")]
use std::process::Output;
use std::process::{Command, Stdio};
use std::time::Duration;

use datafusion::arrow::array::AsArray;
use datafusion::arrow::datatypes::Int64Type;
use denavit_fleet::Fleet;
use denavit_fleet::store::Store;
use denavit_fleet::watch::TABLE;
#[cfg(feature = "cluster")]
use listening::Listening;

const RECORDINGS: usize = 10;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// Recordings that differ: one of an iiwa, shortened more and more; and a damaged one.
fn logs(folder: &Path) {
    let file = std::fs::File::open(root().join("data/kuka-iiwa14/chirp_j2.csv.gz")).unwrap();
    let mut text = String::new();
    flate2::read::GzDecoder::new(file).read_to_string(&mut text).unwrap();
    let lines: Vec<&str> = text.lines().collect();
    for k in 0..RECORDINGS {
        let mut out = std::fs::File::create(folder.join(format!("{k:02}.csv"))).unwrap();
        out.write_all(lines[..lines.len() - 10 * k].join("\n").as_bytes()).unwrap();
    }
    std::fs::write(folder.join("damaged.csv"), "t,q1\n0,a\n").unwrap();
}

fn factor(logs: &Path, out: &Path, workers: &str) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_denavit-fleet"));
    command.arg("factor").arg(logs).arg("--robot").arg(root().join("robots/kuka-iiwa14.yaml")).arg("--out").arg(out);
    command.args(["--workers", workers, "--threads", "1"]).stdout(Stdio::piped()).stderr(Stdio::piped());
    command
}

/// Rows, different recordings, and the factor of all.
fn contents(out: &Path) -> (i64, i64, Vec<u8>) {
    let runtime = tokio::runtime::Runtime::new().unwrap();
    runtime.block_on(async {
        let fleet = Fleet::new(2);
        fleet.factors(&out.display().to_string()).await.unwrap();
        let query = format!("SELECT count(*), count(DISTINCT sha256), merge_factor(sha256, factor) FROM {TABLE}");
        let rows = fleet.context.sql(&query).await.unwrap().collect().await.unwrap();
        let number = |k: usize| rows[0].column(k).as_primitive::<Int64Type>().value(0);
        (number(0), number(1), rows[0].column(2).as_binary::<i32>().value(0).to_vec())
    })
}

fn rows(out: &Path) -> usize {
    std::fs::read_dir(out.join("unfinished")).map_or(0, |folder| {
        folder.filter(|entry| entry.as_ref().is_ok_and(|e| e.path().extension().is_some_and(|e| e == "row"))).count()
    })
}

/// Ends one worker of a run as soon as a row is there.
fn kill_a_worker(parent: u32, out: &Path) {
    while rows(out) == 0 {
        std::thread::sleep(Duration::from_millis(5));
    }
    let children = std::fs::read_to_string(format!("/proc/{parent}/task/{parent}/children")).unwrap();
    let worker = children.split_whitespace().next().expect("a worker runs").to_string();
    assert!(Command::new("kill").args(["-9", &worker]).status().unwrap().success());
}

#[test]
fn a_killed_worker_loses_nothing_and_repeats_only_what_is_missing() {
    let (folder, undisturbed, killed) =
        (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
    logs(folder.path());
    let done = factor(folder.path(), undisturbed.path(), "1").output().unwrap();
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    let process = factor(folder.path(), killed.path(), "2").spawn().unwrap();
    kill_a_worker(process.id(), killed.path());
    let done = process.wait_with_output().unwrap();
    assert_eq!(done.status.code(), Some(1));
    println!("{}", String::from_utf8_lossy(&done.stderr));
    let before = rows(killed.path());
    assert!((1..=RECORDINGS).contains(&before), "{before} rows are there");
    let done = factor(folder.path(), killed.path(), "2").output().unwrap();
    let said = String::from_utf8_lossy(&done.stdout).into_owned();
    println!("{before} rows were there; {said}");
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    assert!(said.contains(&format!("{} of {} recordings were missing", RECORDINGS + 1 - before, RECORDINGS + 1)));
    assert_eq!(contents(killed.path()), contents(undisturbed.path()));
    assert_eq!(contents(killed.path()).0, RECORDINGS as i64 + 1);
    assert_eq!(rows(killed.path()), 0);
    // A third run has nothing to do.
    let done = factor(folder.path(), killed.path(), "1").output().unwrap();
    assert!(String::from_utf8_lossy(&done.stdout).starts_with("0 of 11 recordings"));
    assert_eq!(contents(killed.path()).0, RECORDINGS as i64 + 1);
}

#[test]
fn two_runs_of_one_folder_are_kept_apart() {
    let [folder, out] = [(); 2].map(|()| tempfile::tempdir().unwrap());
    logs(folder.path());
    // As a run does that lasts.
    let first = Store::new(out.path()).unwrap();
    let claim = first.claim().unwrap();
    let second = |words: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_denavit-fleet"));
        command.arg("factor").arg(folder.path()).arg("--robot").arg(root().join("robots/kuka-iiwa14.yaml"));
        command.arg("--out").arg(out.path()).args(words).output().unwrap()
    };
    for words in [["--workers", "1"], ["--workers", "2"], ["--share", "1/2"]] {
        let done = second(&words);
        assert_eq!(done.status.code(), Some(1));
        assert!(String::from_utf8_lossy(&done.stderr).contains("another run writes to"));
    }
    assert_eq!(rows(out.path()), 0);
    // Shares go together, and no table is made beside them.
    claim.shared().unwrap();
    assert!(second(&["--share", "1/2"]).status.success());
    assert_eq!(second(&["--workers", "1"]).status.code(), Some(1));
    drop(claim);
    assert!(second(&["--workers", "2"]).status.success());
    assert_eq!(contents(out.path()).0, RECORDINGS as i64 + 1);
}

#[test]
fn rows_that_were_left_beside_their_table_are_there_once() {
    let [folder, out, kept] = [(); 3].map(|()| tempfile::tempdir().unwrap());
    logs(folder.path());
    let unfinished = out.path().join("unfinished");
    let mut share = factor(folder.path(), out.path(), "1");
    share.args(["--share", "1/1"]);
    // `--share` and `--workers` exclude each other.
    assert_eq!(share.output().unwrap().status.code(), Some(2));
    let mut share = Command::new(env!("CARGO_BIN_EXE_denavit-fleet"));
    share.arg("factor").arg(folder.path()).arg("--robot").arg(root().join("robots/kuka-iiwa14.yaml"));
    assert!(share.arg("--out").arg(out.path()).args(["--share", "1/1"]).output().unwrap().status.success());
    assert_eq!(rows(out.path()), RECORDINGS + 1);
    let copy = |from: &Path, to: &Path, some: usize| {
        let names = std::fs::read_dir(from).unwrap().map(|entry| entry.unwrap().file_name());
        for name in names.filter(|name| name.to_string_lossy().ends_with(".row")).take(some) {
            std::fs::copy(from.join(&name), to.join(&name)).unwrap();
        }
    };
    copy(&unfinished, kept.path(), usize::MAX);
    assert!(factor(folder.path(), out.path(), "1").output().unwrap().status.success());
    let whole = contents(out.path());
    assert_eq!(whole.0, RECORDINGS as i64 + 1);
    // As if the run had been killed when the table was there, and some rows were removed or none.
    for some in [usize::MAX, 4] {
        copy(kept.path(), &unfinished, some);
        assert!(factor(folder.path(), out.path(), "1").output().unwrap().status.success());
        assert_eq!((rows(out.path()), contents(out.path())), (0, whole.clone()));
    }
}

#[cfg(feature = "cluster")]
fn said(done: &Output) -> String {
    String::from_utf8_lossy(&done.stderr).into_owned() + &String::from_utf8_lossy(&done.stdout)
}

#[cfg(feature = "cluster")]
#[test]
fn workers_on_other_machines_give_the_same_bits_and_the_rest_of_one_that_dies_is_done_by_the_others() {
    let [folder, alone, shared, killed] = [(); 4].map(|()| tempfile::tempdir().unwrap());
    logs(folder.path());
    assert!(factor(folder.path(), alone.path(), "1").output().unwrap().status.success());
    let (first, mut second) = (Listening::start("127.0.0.1:0"), Listening::start("127.0.0.1:0"));
    let both = format!("{},{}", first.address, second.address);
    // Undisturbed; and one worker alone.
    let mut read = Vec::new();
    for workers in [&both, &first.address] {
        let done = factor(folder.path(), shared.path(), workers).output().unwrap();
        assert!(done.status.success(), "{}", said(&done));
        assert!(said(&done).contains("11 of 11 recordings were missing"), "{}", said(&done));
        assert_eq!(contents(shared.path()), contents(alone.path()));
        std::fs::remove_dir_all(shared.path()).unwrap();
        read.push([first.done(), second.done()]);
    }
    println!("recordings that each worker has read, after a run by both and one by the first: {read:?}");
    // Shares of 6 and 5; then all eleven by one.
    let (first_share, second_share) = (read[0][0], read[0][1]);
    assert!(matches!((first_share, second_share), (5, 6) | (6, 5)), "{read:?}");
    assert_eq!(read[1], [first_share + RECORDINGS + 1, second_share]);
    // One dies while it works.
    let process = factor(folder.path(), killed.path(), &both).spawn().unwrap();
    while rows(killed.path()) == 0 {
        std::thread::sleep(Duration::from_millis(5));
    }
    second.kill();
    let done = process.wait_with_output().unwrap();
    println!("{}", said(&done));
    assert!(done.status.success(), "{}", said(&done));
    assert!(said(&done).contains(&format!("{} does not answer", second.address)), "{}", said(&done));
    assert!(said(&done).contains("once more, for "), "{}", said(&done));
    assert_eq!(contents(killed.path()), contents(alone.path()));
    assert_eq!(contents(killed.path()).0, RECORDINGS as i64 + 1);
    // The dead one is named; there is nothing left to do.
    let done = factor(folder.path(), killed.path(), &both).output().unwrap();
    assert!(said(&done).contains(&format!("{} does not answer", second.address)), "{}", said(&done));
    assert!(said(&done).contains("0 of 11 recordings"), "{}", said(&done));
}

#[cfg(feature = "cluster")]
#[test]
fn without_any_worker_a_run_ends_and_is_repeated_for_what_is_missing() {
    let [folder, alone, killed] = [(); 3].map(|()| tempfile::tempdir().unwrap());
    logs(folder.path());
    assert!(factor(folder.path(), alone.path(), "1").output().unwrap().status.success());
    let mut only = Listening::start("127.0.0.1:0");
    let process = factor(folder.path(), killed.path(), &only.address).spawn().unwrap();
    while rows(killed.path()) == 0 {
        std::thread::sleep(Duration::from_millis(5));
    }
    only.kill();
    let done = process.wait_with_output().unwrap();
    assert_eq!(done.status.code(), Some(1), "{}", said(&done));
    assert!(said(&done).contains("no worker answers"), "{}", said(&done));
    let before = rows(killed.path());
    assert!((1..=RECORDINGS).contains(&before), "{before} rows are there");
    // At the same address, as a machine that comes back.
    let again = Listening::start(&only.address);
    let done = factor(folder.path(), killed.path(), &again.address).output().unwrap();
    println!("{before} rows were there; {}", said(&done));
    assert!(done.status.success(), "{}", said(&done));
    let missing = format!("{} of 11 recordings were missing", RECORDINGS + 1 - before);
    assert!(said(&done).contains(&missing), "{}", said(&done));
    assert_eq!(contents(killed.path()), contents(alone.path()));
}

#[cfg(feature = "cluster")]
#[test]
fn sql_is_shared_by_workers_and_has_the_same_bits() {
    let [folder, table] = [(); 2].map(|()| tempfile::tempdir().unwrap());
    logs(folder.path());
    assert!(factor(folder.path(), table.path(), "1").output().unwrap().status.success());
    let (first, second) = (Listening::start("127.0.0.1:0"), Listening::start("127.0.0.1:0"));
    let robot = root().join("robots/kuka-iiwa14.yaml").display().to_string();
    let query = format!(
        "SELECT verdict, count(*) AS n, encode(merge_factor(sha256, factor), 'hex') AS f \
         FROM recordings('{}', '{robot}') GROUP BY verdict ORDER BY verdict",
        folder.path().display()
    );
    let asked = |words: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_denavit-fleet"));
        let done = command.args(["sql", &query, "--threads", "2"]).args(words).output().unwrap();
        assert!(done.status.success(), "{}", said(&done));
        said(&done)
    };
    let both = format!("{},{}", first.address, second.address);
    assert_eq!(asked(&["--workers", &both]), asked(&[]));
    let read = [first.done(), second.done()];
    println!("recordings that each worker has read: {read:?}");
    assert!(matches!(read, [5, 6] | [6, 5]), "{read:?}");
}

#[cfg(feature = "cluster")]
#[test]
fn a_worker_of_another_version_is_named_and_gets_no_work() {
    use datafusion_distributed::Worker;
    use tonic::transport::Server;
    use tonic::transport::server::TcpIncoming;
    let [folder, out] = [(); 2].map(|()| tempfile::tempdir().unwrap());
    logs(folder.path());
    let runtime = tokio::runtime::Runtime::new().unwrap();
    let listener = runtime.block_on(tokio::net::TcpListener::bind("127.0.0.1:0")).unwrap();
    let older = listener.local_addr().unwrap().to_string();
    let service = Worker::default().with_version("0.0.9").into_worker_server();
    runtime.spawn(Server::builder().add_service(service).serve_with_incoming(TcpIncoming::from(listener)));
    let done = factor(folder.path(), out.path(), &older).output().unwrap();
    let why = format!("{older} is of version 0.0.9, this program of {}", env!("CARGO_PKG_VERSION"));
    assert_eq!(done.status.code(), Some(1));
    assert!(said(&done).contains(&why), "{}", said(&done));
    // Beside one that fits.
    let fitting = Listening::start("127.0.0.1:0");
    let done = factor(folder.path(), out.path(), &format!("{older},{}", fitting.address)).output().unwrap();
    assert!(done.status.success() && said(&done).contains(&why), "{}", said(&done));
    assert_eq!((contents(out.path()).0, fitting.done()), (RECORDINGS as i64 + 1, RECORDINGS + 1));
}
