//! Checks a robot file, exports it to URDF, and imports it again.
//!
//! `cargo run --example import_and_check`

use std::error::Error;
use std::fs::read_to_string;

use denavit::exchange::{ImportOptions, ModelFormat, export, import};
use denavit::model::Arm;
use denavit::model::interpreted::Interpreted;
use denavit::robot::{Robot, no_files};

fn main() -> Result<(), Box<dyn Error>> {
    let text = read_to_string(format!("{}/robots/puma560.yaml", env!("CARGO_MANIFEST_DIR")))?;
    let reading = Robot::from_yaml(&text, &no_files)?;
    reading.notes.iter().for_each(|note| println!("{note}"));
    let arm = Interpreted::new(&reading.robot, &[]);
    for base in arm.base_parameters() {
        println!("{}", base.grouping);
    }

    let urdf = export(&reading.robot, ModelFormat::Urdf);
    let back = import(&urdf.text, &ImportOptions::default())?;
    println!("{} from {} to {}", back.format, back.base, back.tip);
    println!("left out: {}", urdf.left_out.join("; "));
    println!("poses of both differ by {:.0e} m at most", back.error.position);
    assert!(back.robot.dof() == arm.dof() && back.error.position < 1e-9);
    Ok(())
}
