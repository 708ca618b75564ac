//! Recordings of `tests/recordings/`, written by other programs (`write.py` there), contain one
//! motion of two joints; every format gives it back.

use std::fs::File;
use std::io::BufReader;

use denavit::data::log::{
    Acceptance, Channel, Log, LogError, Mapping, Quantity, Reading, SourceJoint, open_table, open_with, propose,
};

fn path(name: &str) -> String {
    format!("{}/tests/recordings/{name}", env!("CARGO_MANIFEST_DIR"))
}

fn joints(names: &[&str]) -> Vec<SourceJoint> {
    names.iter().map(|n| SourceJoint { name: (*n).into(), sign: 1.0, offset: 0.0 }).collect()
}

fn by_name() -> Reading {
    Reading { mapping: None, joints: joints(&["shoulder", "elbow"]) }
}

fn read(name: &str, reading: &Reading) -> Result<Log, LogError> {
    let mut source = open_with(name, BufReader::new(File::open(path(name)).unwrap()), reading)?;
    let keep = Acceptance { bad_rows: true, ..Acceptance::default() };
    Log::read(&mut *source, Quantity::Tau, keep)
}

/// The motion defined in `write.py`.
fn truth(t: f64) -> ([f64; 2], [f64; 2]) {
    let q = [0.8 * (2.0 * t).sin(), 0.5 * (3.0 * t).cos()];
    (q, [10.0 * q[0], 10.0 * q[1] + 1.0])
}

fn assert_motion(log: &Log, rows: usize, error: f64) {
    assert_eq!(log.layout.dof, 2);
    assert!(log.len() >= rows, "{} rows", log.len());
    let t = log.column(denavit::data::log::Role::Time).unwrap();
    let start = if (t[0] - 1.7e9).abs() < 10.0 { 1.7e9 } else { 0.0 };
    for row in 0..log.len() {
        let (q, tau) = truth(t[row] - start);
        for joint in 0..2 {
            let measured = log.joint(Quantity::Q, joint).unwrap()[row];
            assert!((measured - q[joint]).abs() < error, "row {row}, q{joint}: {measured} and {}", q[joint]);
            let measured = log.joint(Quantity::Tau, joint).unwrap()[row];
            assert!((measured - tau[joint]).abs() < 10.0 * error, "row {row}, tau{joint}: {measured}, {}", tau[joint]);
        }
    }
}

#[test]
fn joint_states_are_matched_by_name() {
    for name in ["joint_state.mcap", "joint_state_lz4.mcap", "joint_state_big_endian.mcap"] {
        let log = read(name, &by_name()).unwrap();
        assert_motion(&log, 200, 1e-9);
        assert!(log.joint(Quantity::Dq, 1).is_some(), "{name}");
    }
}

#[test]
fn interfaces_of_joints_in_xcdr2() {
    assert_motion(&read("dynamic_joint_state_xcdr2.mcap", &by_name()).unwrap(), 200, 1e-9);
}

#[test]
fn a_cut_recording_is_read_as_far_as_it_goes() {
    let log = read("cut.mcap", &by_name()).unwrap();
    assert!(log.len() > 50 && log.len() < 200, "{}", log.len());
    assert_motion(&log, 50, 1e-9);
}

#[test]
fn torques_of_another_clock_are_aligned_by_their_stamps() {
    let columns = [("q*", "/joint_states/position/{joint}"), ("tau*", "/torques/data[{index}]")];
    let channel = |name: &str| Channel { name: name.into(), unit: None, gain: Vec::new(), offset: Vec::new() };
    let columns = columns.map(|(column, name)| (column.to_string(), channel(name))).to_vec();
    // These messages carry no stamp: the recorder's clock is used for both.
    let mapping = Some(Mapping { columns, arrival: true });
    let log = read("two_clocks.mcap", &Reading { mapping, ..by_name() }).unwrap();
    // Linear between samples that are 4 ms apart: 10 * 0.8 * 2^2 * 0.004^2 / 8 = 6e-5.
    assert_motion(&log, 195, 1e-5);
    // Without a mapping the torques have no joint.
    assert!(read("two_clocks.mcap", &by_name()).unwrap().joint(Quantity::Tau, 0).is_none());
}

#[test]
fn other_names_and_no_names_are_questions() {
    let reading = Reading { mapping: None, joints: joints(&["joint1", "joint2"]) };
    let error = read("joint_state.mcap", &reading).unwrap_err().to_string();
    for word in ["elbow", "shoulder", "joint1", "--map"] {
        assert!(error.contains(word), "{error}");
    }
    let error = read("joint_state.mcap", &Reading::default()).unwrap_err().to_string();
    assert!(error.contains("--robot"), "{error}");
}

#[test]
fn signs_and_zeros_of_the_source_are_taken_back() {
    let mut joints = joints(&["shoulder", "elbow"]);
    joints[1] = SourceJoint { name: "elbow".into(), sign: -1.0, offset: 0.25 };
    let log = read("joint_state.mcap", &Reading { mapping: None, joints }).unwrap();
    let plain = read("joint_state.mcap", &by_name()).unwrap();
    let column = |log: &Log, q| log.joint(q, 1).unwrap().to_vec();
    for (turned, straight) in column(&log, Quantity::Q).iter().zip(column(&plain, Quantity::Q)) {
        assert!((turned - (0.25 - straight)).abs() < 1e-15);
    }
    assert_eq!(column(&log, Quantity::Tau)[7], -column(&plain, Quantity::Tau)[7]);
}

#[test]
fn arrays_of_numpy_and_matlab() {
    for name in ["arrays.npz", "arrays_compressed.npz", "arrays.mat", "lists.parquet"] {
        assert_motion(&read(name, &Reading::default()).unwrap_or_else(|e| panic!("{name}: {e}")), 200, 1e-12);
    }
    let error = read("pickle.npz", &Reading::default()).unwrap_err().to_string();
    assert!(error.contains("pickle"), "{error}");
}

fn mapping(columns: &[(&str, &str, Option<&str>)]) -> Reading {
    let columns = columns
        .iter()
        .map(|(column, name, unit)| {
            let channel =
                Channel { name: (*name).into(), unit: unit.map(String::from), gain: Vec::new(), offset: Vec::new() };
            (column.to_string(), channel)
        })
        .collect();
    Reading { mapping: Some(Mapping { columns, arrival: false }), joints: Vec::new() }
}

#[test]
fn structures_lists_and_spreadsheets_by_a_mapping() {
    let structure = [("t", "log.t", None), ("q*", "log.q[{index}]", None), ("tau*", "log.tau[{index}]", None)];
    assert_motion(&read("structure.mat", &mapping(&structure)).unwrap(), 200, 1e-12);
    let lerobot = [
        ("t", "timestamp", None),
        ("seg", "episode_index", None),
        ("q*", "observation.state[{index}]", None),
        ("tau*", "observation.effort[{index}]", None),
    ];
    assert_motion(&read("lerobot.parquet", &mapping(&lerobot)).unwrap(), 200, 1e-6);
    let german = [
        ("t", "Zeit", Some("ms")),
        ("q*", "Achse {number} Position [deg]", Some("deg")),
        ("tau*", "Achse {number} Moment", Some("N mm")),
    ];
    assert_motion(&read("german.csv", &mapping(&german)).unwrap(), 200, 1e-8);
    let wrong = [("t", "Zeit", Some("deg")), ("q*", "Achse {number}", None)];
    let error = read("german.csv", &mapping(&wrong)).unwrap_err().to_string();
    assert!(error.contains("no unit for `t`"), "{error}");
    let absent = [("t", "Zeit", Some("ms")), ("q*", "Achse {number}", None)];
    let error = read("german.csv", &mapping(&absent)).unwrap_err().to_string();
    assert!(error.contains("Achse 1 Position"), "{error}");
}

#[test]
fn channels_have_rates_and_a_mapping_is_proposed() {
    let inspect = |name: &str| {
        let mut table = open_table(name, BufReader::new(File::open(path(name)).unwrap()), &Reading::default()).unwrap();
        table.summarise().unwrap()
    };
    let channels = inspect("two_clocks.mcap");
    let rate = |name: &str| channels.iter().find(|c| c.name == name).unwrap().rate().unwrap();
    assert!((rate("/joint_states/position/elbow") - 100.0).abs() < 0.1);
    assert!((rate("/torques/data[0]") - 250.0).abs() < 1.0);

    let proposal = propose(&inspect("lerobot.parquet"), &[]);
    let column = |c: &str| proposal.mapping.columns.iter().find(|(name, _)| name == c).map(|(_, c)| c.name.clone());
    assert_eq!(column("tau*").as_deref(), Some("observation.effort[{index}]"));
    assert_eq!(column("t").as_deref(), Some("timestamp"));
}

/// Damaged files end in an error or in fewer rows, never in a panic or an endless loop.
#[test]
fn damaged_recordings_are_errors() {
    let mut state = 1_u64;
    let mut next = move || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 33) as usize
    };
    for name in ["joint_state.mcap", "joint_state_lz4.mcap", "arrays_compressed.npz", "structure.mat", "lists.parquet"]
    {
        let whole = std::fs::read(path(name)).unwrap();
        for round in 0..120 {
            let mut bytes = whole.clone();
            if round % 3 == 0 {
                bytes.truncate(next() % whole.len());
            } else {
                for _ in 0..1 + round % 4 {
                    let at = next() % bytes.len();
                    bytes[at] = next() as u8;
                }
            }
            if let Ok(mut source) = open_with(name, bytes.as_slice(), &by_name()) {
                let _ = Log::read(&mut *source, Quantity::Tau, Acceptance::all());
            }
        }
    }
}

#[cfg(not(feature = "rosbag2"))]
#[test]
fn sqlite_is_refused_with_the_way_to_read_it() {
    let error = read("rosbag2/bag.db3", &by_name()).unwrap_err().to_string();
    assert!(error.contains("--features rosbag2") && error.contains("ros2 bag convert"), "{error}");
}

#[cfg(feature = "rosbag2")]
#[test]
fn sqlite_is_read_as_mcap_is() {
    let connection = rusqlite::Connection::open(path("rosbag2/bag.db3")).unwrap();
    let table = denavit::data::log::open_sqlite("bag.db3", connection, &by_name()).unwrap();
    let mut source = denavit::data::log::source("bag.db3", table, &by_name()).unwrap();
    let log = Log::read(&mut *source, Quantity::Tau, Acceptance::default()).unwrap();
    assert_motion(&log, 200, 1e-9);
    let other = rusqlite::Connection::open_in_memory().unwrap();
    let error = denavit::data::log::open_sqlite("empty.db3", other, &by_name()).err().unwrap().to_string();
    assert!(error.contains("its tables are not those of rosbag2"), "{error}");
}

#[test]
fn more_rows_than_a_file_can_hold_are_refused() {
    use denavit::data::log::parquet::ParquetWriter;
    let layout = denavit::data::log::Layout::new("still.csv", &["t", "q1", "tau1"]).unwrap();
    let mut bytes = Vec::new();
    let mut writer = ParquetWriter::new(&layout, &mut bytes).unwrap();
    let rows = vec![vec![1.0; 1 << 15]; 3];
    (0..150).for_each(|_| writer.rows(&rows).unwrap());
    writer.finish().unwrap();
    let error = open_with("still.parquet", &bytes[..], &Reading::default()).err().unwrap().to_string();
    assert!(error.contains("it claims 4915200 rows"), "{error}");
}

#[test]
fn rows_are_the_same_in_groups_of_any_size() {
    use denavit::data::log::csv::CsvWriter;
    use denavit::data::log::parquet::ParquetWriter;
    let layout = denavit::data::log::Layout::new("run.csv", &["t", "q1", "tau1"]).unwrap();
    let number = |k: usize| [k as f64 * 0.001, (k as f64 * 0.01).sin(), (k as f64 * 0.013).cos()];
    let columns: Vec<Vec<f64>> = (0..3).map(|c| (0..70_000).map(|k| number(k)[c]).collect()).collect();
    let (mut parquet, mut csv) = (Vec::new(), Vec::new());
    let mut to_parquet = ParquetWriter::new(&layout, &mut parquet).unwrap();
    let mut to_csv = CsvWriter::new(&layout, &mut csv).unwrap();
    for part in [0..1, 1..40_000, 40_000..70_000] {
        let rows: Vec<Vec<f64>> = columns.iter().map(|c| c[part.clone()].to_vec()).collect();
        to_parquet.rows(&rows).unwrap();
        to_csv.rows(&rows).unwrap();
    }
    to_parquet.finish().unwrap();
    to_csv.finish().unwrap();
    for bytes in [parquet, csv] {
        let mut source = open_with("run", &bytes[..], &Reading::default()).unwrap();
        let log = Log::read(&mut *source, Quantity::Tau, Acceptance::all()).unwrap();
        assert_eq!(log.columns, columns);
    }
}

#[test]
fn stamps_of_parquet_are_seconds_and_packings_are_unpacked_or_named() {
    for name in ["stamps_gzip.parquet", "stamps_lz4.parquet"] {
        let log = read(name, &Reading::default()).unwrap();
        assert_motion(&log, 200, 1e-9);
    }
    match read("stamps_zstd.parquet", &Reading::default()) {
        Ok(log) => assert_motion(&log, 200, 1e-9),
        Err(error) => assert!(error.to_string().contains("--features parquet-zstd"), "{error}"),
    }
}

#[test]
fn a_damaged_chunk_is_refused_by_its_checksum() {
    let mut bytes = std::fs::read(path("joint_state_big_endian.mcap")).unwrap();
    // A digit of a position, so that the message keeps its length.
    let middle = bytes.len() / 2;
    bytes[middle] ^= 0x10;
    let read = open_with("damaged.mcap", &bytes[..], &by_name())
        .and_then(|mut source| Log::read(&mut *source, Quantity::Tau, Acceptance::all()));
    assert!(read.unwrap_err().to_string().contains("checksum"));
}
