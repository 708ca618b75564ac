//! Identifies a robot from a table of `denavit factor`, without its recordings.
//!
//! ```sh
//! cargo run --release -- factor data/kuka-iiwa14/*.csv.gz --robot robots/kuka-iiwa14.yaml --out /tmp/factors.parquet
//! cargo run --release --example merge_factors -- robots/kuka-iiwa14.yaml /tmp/factors.parquet
//! ```

use std::error::Error;
use std::fs::File;

use denavit::identify::{FactorError, IdentifySettings, KeyedFactors, RecordingFactor, solve};
use denavit::model::coupled::Coupled;
use denavit::model::interpreted::Interpreted;
use denavit::model::robot_edit;
use denavit::robot::Robot;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::RowAccessor;

/// Factors of a table by the SHA-256 of their recordings.
fn factors(path: &str) -> Result<KeyedFactors, Box<dyn Error>> {
    let mut all = KeyedFactors::default();
    for row in SerializedFileReader::new(File::open(path)?)?.get_row_iter(None)? {
        let row = row?;
        let at = |name: &str| row.get_column_iter().position(|(n, _)| n == name).ok_or(format!("no column {name}"));
        if let Ok(bytes) = row.get_bytes(at("factor")?) {
            let factor = RecordingFactor::from_bytes(row.get_string(at("file")?)?, bytes.data())?;
            all.insert(row.get_string(at("sha256")?)?.clone(), factor)?;
        }
    }
    Ok(all)
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [robot, table] = arguments.as_slice() else { return Err("give a robot file and a table of factors".into()) };
    let robot = Robot::open(robot)?;
    let bodies = Interpreted::new(&robot, &[]);
    let couplings = robot_edit::couplings(&robot).into_iter().map(|(coupling, _)| coupling).collect();
    let arm = Coupled::new(&bodies, couplings);
    let merged: Result<Option<RecordingFactor>, FactorError> = factors(table)?.fold(table);
    let merged = merged?.ok_or("the table has no factor")?;
    let found = solve(&arm, &[merged.factors], &[], &IdentifySettings::default())?;
    for parameter in &found.parameters {
        println!("{} {} {}", parameter.name, parameter.value, parameter.std);
    }
    Ok(())
}
