//! Tests of `denavit factor`: factors of recordings as a table, and identification from it.

use denavit::identify::{IdentifySettings, KeyedFactors, RecordingFactor, solve};
use denavit::model::interpreted::Interpreted;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::{Row, RowAccessor};

use super::*;

const ROBOT: &str = "robots/kuka-iiwa14.yaml";
const LOGS: [&str; 2] = ["data/kuka-iiwa14/motion_j3j4.csv.gz", "data/kuka-iiwa14/motion_j2toj7.csv.gz"];

fn rows(path: &str) -> Vec<Row> {
    let file = SerializedFileReader::new(std::fs::File::open(path).unwrap()).unwrap();
    file.get_row_iter(None).unwrap().map(Result::unwrap).collect()
}

/// Index of a column of the table.
fn at(name: &str) -> usize {
    let names = ["robot", "day", "file", "sha256", "samples", "seconds", "verdict", "temperature", "factor", "why"];
    names.iter().position(|n| *n == name).unwrap()
}

#[test]
fn the_table_gives_what_identify_finds_in_the_logs() {
    let folder = folder("factor");
    let [out, damaged] = [folder.join("f.parquet").display().to_string(), file(&folder, "bad.csv", "t,q1\n0,zero\n")];
    let run = denavit(&["factor", LOGS[0], &damaged, LOGS[1], "--robot", ROBOT, "--out", &out]);
    assert_eq!(run.status, Some(0), "{}", run.err);
    assert!(
        run.err.contains("bad.csv: no factor: ") && run.out.contains("3 recordings, 1 without"),
        "{}{}",
        run.err,
        run.out
    );
    let table = rows(&out);
    assert_eq!(table.len(), 3);
    assert!(table[1].get_bytes(at("factor")).is_err() && !table[1].get_string(at("why")).unwrap().is_empty());
    assert_eq!(table[1].get_string(at("verdict")).unwrap(), "refused");
    assert_eq!(table[1].get_string(at("sha256")).unwrap().len(), 64);
    let mut all = KeyedFactors::default();
    for row in [&table[0], &table[2]] {
        assert!(row.get_long(at("samples")).unwrap() > 1000 && row.get_double(at("seconds")).unwrap() > 1.0);
        let factor = RecordingFactor::from_bytes("x", row.get_bytes(at("factor")).unwrap().data()).unwrap();
        all.insert(row.get_string(at("sha256")).unwrap().clone(), factor).unwrap();
    }
    let robot = read_robot(ROBOT);
    let merged = all.fold("all").unwrap().unwrap();
    let found = solve(&Interpreted::new(&robot, &[]), &[merged.factors], &[], &IdentifySettings::default()).unwrap();
    let said = json(&["identify", ROBOT, LOGS[0], LOGS[1], "--consistent=never", "--json", "-"]);
    let parameters = said["parameters"].as_array().unwrap();
    assert_eq!(parameters.len(), found.parameters.len());
    for (said, found) in parameters.iter().zip(&found.parameters) {
        let Some(value) = said["value"].as_f64() else { continue };
        assert!((value - found.value).abs() < 1e-8 * value.abs().max(1.0), "{}: {value} {}", found.name, found.value);
    }
}

#[test]
fn nothing_but_damaged_logs_ends_with_2_and_still_has_a_table() {
    let folder = folder("factor-none");
    let [out, bad] = [folder.join("f.parquet").display().to_string(), file(&folder, "bad.csv", "")];
    let run = denavit(&["factor", &bad, "missing.csv", "--robot", ROBOT, "--out", &out]);
    assert_eq!(run.status, Some(2), "{}", run.out);
    assert!(run.err.contains("missing.csv: no factor") && run.err.contains("no recording has a factor"), "{}", run.err);
    assert_eq!(rows(&out).len(), 2);
}

/// A log with calendar times has a day, and the mean of its temperatures.
#[test]
fn day_temperature_and_json() {
    let folder = folder("factor-day");
    let stamps = 1_795_000_000.0; // 2026-11-18
    let text: Vec<String> = super::identify::record(8, 5)
        .lines()
        .enumerate()
        .map(|(row, line)| match (row, line.split_once(',')) {
            (0, _) => format!("{line},{}", columns(&["temp"], 7).join(",")),
            (_, Some((t, rest))) => {
                format!("{:.3},{rest},30,30,30,30,30,30,44", stamps + t.parse::<f64>().unwrap())
            }
            _ => line.to_string(),
        })
        .collect();
    let log = file(&folder, "log.csv", text.join("\n") + "\n");
    let out = folder.join("f.parquet").display().to_string();
    let said = json(&["factor", &log, "--robot", "robots/kuka-lwr4.yaml", "--out", &out, "--json", "-"]);
    let row = &said["recordings"][0];
    assert_eq!((row["day"].as_i64(), row["temperature"].as_f64()), (Some(20_775), Some(32.0)), "{said}");
    assert_eq!(said["without_factor"], 0);
    assert!(said["provenance"]["command"].as_str().unwrap().starts_with("denavit factor "));
    assert!(rows(&out)[0].get_double(at("temperature")).unwrap() == 32.0);
}
