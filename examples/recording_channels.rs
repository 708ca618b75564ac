//! A recording with columns of its own: lists its channels, takes the proposed mapping, and reads
//! it as a log. The samples are those of a real Staubli TX40 in `data/`, under a recorder's names.
//!
//! `cargo run --example recording_channels`

use std::error::Error;
use std::fs::File;
use std::io::Read;

use denavit::data::log::{Acceptance, LogError, Quantity, Reading, each_block, open_table, open_with, propose};
use flate2::read::MultiGzDecoder;

fn main() -> Result<(), Box<dyn Error>> {
    let path = format!("{}/data/staubli-tx40/first.csv.gz", env!("CARGO_MANIFEST_DIR"));
    let mut text = String::new();
    MultiGzDecoder::new(File::open(path)?).read_to_string(&mut text)?;
    let (_, rows) = text.split_once('\n').ok_or("a header and rows")?;
    let joints = |what: &str| (0..6).map(|j| format!(",arm/joint_{j}/{what}")).collect::<String>();
    let text = format!("timestamp [s]{}{}\n{rows}", joints("position [rad]"), joints("effort [Nm]"));

    let channels = open_table("run.csv", text.as_bytes(), &Reading::default())?.summarise()?;
    for c in channels.iter().filter(|c| c.name.contains("joint_3") || c.clock.is_none()) {
        println!("{}: {} samples from {:.3} to {:.3}", c.name, c.samples, c.range[0], c.range[1]);
    }
    let proposal = propose(&channels, &[]);
    proposal.reasons.iter().take(3).for_each(|reason| println!("{reason}"));

    let reading = Reading { mapping: Some(proposal.mapping), ..Reading::default() };
    let mut log = open_with("run.csv", text.as_bytes(), &reading)?;
    let count = |_: &[Vec<f64>], _: &[usize]| Ok::<(), LogError>(());
    let passed = each_block(log.as_mut(), Quantity::Tau, Acceptance::default(), count)?;
    println!("{} joints, {} rows that pass the quality check", passed.layout.dof, passed.rows);
    assert_eq!(passed.layout.dof, 6);
    Ok(())
}
