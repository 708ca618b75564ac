//! Raw logs of the simulator to factors: rates beside that of reading alone.

#[cfg(feature = "cluster")]
mod listening;

use std::fs::File;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Arc;
use std::time::Instant;

use datafusion::arrow::array::{ArrayRef, Float64Array};
use datafusion::arrow::record_batch::RecordBatch;
use datafusion::parquet::arrow::ArrowWriter;
use datafusion::parquet::arrow::arrow_reader::ParquetRecordBatchReaderBuilder;
use denavit::data::log::Log;
use denavit::robot::Robot;
use denavit::simulate::{Control, Effects, Mode, Recording, Request, Sensors, Simulator, Trajectory};
#[cfg(feature = "cluster")]
use listening::Listening;

const SECONDS: f64 = 60.0;
const RATE: f64 = 500.0;

fn robot_file() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../robots/kinova-gen3.yaml")
}

/// Sums of three sines per joint, with other periods for each motion.
fn motion(number: usize, joints: usize) -> Trajectory {
    let rows = (SECONDS * 100.0) as usize + 1;
    let t: Vec<f64> = (0..rows).map(|i| i as f64 / 100.0).collect();
    let mut columns = [Vec::new(), Vec::new(), Vec::new()];
    for joint in 0..joints {
        let terms = (1..=3).map(|k| {
            let turns = (7 * k + 3 * joint + 2 * number) as f64 % 17.0 + k as f64;
            (0.25 / k as f64, std::f64::consts::TAU * turns / SECONDS, (joint * k + number) as f64)
        });
        let terms: Vec<(f64, f64, f64)> = terms.collect();
        for &t in &t {
            let sum = |of: fn(f64, f64, f64) -> f64| terms.iter().map(|(a, w, p)| of(*a, *w, w * t + p)).sum::<f64>();
            columns[0].push(sum(|a, _, x| a * x.sin()));
            columns[1].push(sum(|a, w, x| a * w * x.cos()));
            columns[2].push(sum(|a, w, x| -a * w * w * x.sin()));
        }
    }
    let [q, dq, ddq] = columns;
    Trajectory::new(joints, t, q, Some(dq), Some(ddq)).unwrap()
}

/// A log as Parquet with Snappy: `t, q1.., tau1..`.
fn write(log: &Log, path: &Path) {
    let columns = log.layout.roles.iter().zip(&log.columns);
    let columns = columns.map(|(role, values)| (role.name(), Arc::new(Float64Array::from(values.clone())) as ArrayRef));
    let batch = RecordBatch::try_from_iter(columns).unwrap();
    let packed = datafusion::parquet::basic::Compression::SNAPPY;
    let properties = datafusion::parquet::file::properties::WriterProperties::builder().set_compression(packed).build();
    let mut writer = ArrowWriter::try_new(File::create(path).unwrap(), batch.schema(), Some(properties)).unwrap();
    writer.write(&batch).unwrap();
    writer.close().unwrap();
}

/// So many recordings: eight motions, each with other noise.
fn recordings(folder: &Path, count: usize) {
    let robot = Robot::open(robot_file()).unwrap();
    let simulator = Simulator::new(&robot, &Effects::default()).unwrap();
    let sensors = Sensors { rate: RATE, desired: false, ..Sensors::default() };
    let control = Control { mode: Mode::Exact, ..Control::default() };
    let request = Request { sensors: sensors.clone(), control, ..Request::default() };
    let played = |number| simulator.run(&motion(number, robot.dof()), &request, &mut |_| {}).unwrap();
    let played: Vec<Recording> = (0..8.min(count)).map(played).collect();
    for k in 0..count {
        write(&played[k % played.len()].seen_by(&sensors, k as u64), &folder.join(format!("{k:03}.parquet")));
    }
}

/// Reads every column of every file on one thread: rows, bytes on disk, bytes of numbers.
fn read(folder: &Path) -> (usize, u64, usize) {
    let (mut rows, mut disk, mut numbers) = (0, 0, 0);
    for entry in std::fs::read_dir(folder).unwrap() {
        let file = File::open(entry.unwrap().path()).unwrap();
        disk += file.metadata().unwrap().len();
        for batch in ParquetRecordBatchReaderBuilder::try_new(file).unwrap().build().unwrap() {
            let batch = batch.unwrap();
            rows += batch.num_rows();
            numbers += 8 * batch.num_rows() * batch.num_columns();
        }
    }
    (rows, disk, numbers)
}

/// Seconds of the command and, by the kernel's count, of its processors.
fn factored(folder: &Path, workers: &str) -> (f64, f64) {
    let out = tempfile::tempdir().unwrap();
    let before = processor()[1];
    let start = Instant::now();
    let mut command = Command::new(env!("CARGO_BIN_EXE_denavit-fleet"));
    command.arg("factor").arg(folder).arg("--robot").arg(robot_file()).arg("--out").arg(out.path());
    command.args(["--workers", workers, "--threads", "1"]);
    assert!(command.status().unwrap().success());
    (start.elapsed().as_secs_f64(), processor()[1] - before)
}

/// Processor time of this process and of its ended children, s.
fn processor() -> [f64; 2] {
    let stat = std::fs::read_to_string("/proc/self/stat").unwrap();
    let fields: Vec<f64> = stat.rsplit(')').next().unwrap().split_whitespace().filter_map(|f| f.parse().ok()).collect();
    // Of proc(5): utime to cstime are fields 14 to 17, in hundredths; here the first three are left out.
    [(fields[10] + fields[11]) / 100.0, (fields[12] + fields[13]) / 100.0]
}

fn measure(count: usize) {
    let folder = tempfile::tempdir().unwrap();
    recordings(folder.path(), count);
    read(folder.path());
    let (start, before) = (Instant::now(), processor()[0]);
    let (rows, disk, numbers) = read(folder.path());
    let (seconds, alone) = (start.elapsed().as_secs_f64(), processor()[0] - before);
    let (disk, numbers) = (disk as f64 / 1e6, numbers as f64 / 1e6);
    assert_eq!(rows, count * ((SECONDS * RATE) as usize + 1));
    println!("{count} recordings, {rows} rows, {disk:.0} MB of Parquet, {numbers:.0} MB of numbers");
    let rate = |what: &str, seconds: f64, processor: f64| {
        println!(
            "{what}: {seconds:.1} s ({processor:.1} s of processor time), {:.1} MB/s of Parquet, {:.1} MB/s of numbers, \
             {:.2} recordings/s",
            disk / seconds,
            numbers / seconds,
            count as f64 / seconds
        );
    };
    rate("reading alone, one thread", seconds, alone);
    for (what, workers) in [("factors, one process", "1"), ("factors, two processes", "2")] {
        let (seconds, processor) = factored(folder.path(), workers);
        rate(what, seconds, processor);
    }
    #[cfg(feature = "cluster")]
    for (what, workers) in [("factors, one worker by its address", 1), ("factors, two workers by their addresses", 2)] {
        let workers: Vec<Listening> = (0..workers).map(|_| Listening::start("127.0.0.1:0")).collect();
        let addresses: Vec<&str> = workers.iter().map(|worker| worker.address.as_str()).collect();
        let theirs = || workers.iter().map(Listening::processor).sum::<f64>();
        let before = theirs();
        let (seconds, processor) = factored(folder.path(), &addresses.join(","));
        rate(what, seconds, processor + theirs() - before);
        println!("of it the asker: {processor:.1} s of processor time");
        assert_eq!(workers.iter().map(Listening::done).sum::<usize>(), count);
    }
}

#[test]
fn recordings_of_the_simulator_have_factors() {
    measure(2);
}

/// `cargo test --release --test throughput -- --ignored --nocapture`
#[test]
#[ignore = "gigabytes, minutes"]
fn two_hundred_recordings_of_a_minute() {
    measure(200);
}
