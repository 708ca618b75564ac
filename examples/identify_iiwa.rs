//! Identification as a library: logs in, base parameters out. Reads the excerpt in `data/`.
//!
//! `cargo run --release --example identify_iiwa`

use std::error::Error;
use std::fs::File;

use denavit::data::log;
use denavit::data::signal::{Prepare, each_motion};
use denavit::identify::{AccumulatorSettings, Factors, IdentifySettings, QrAccumulator, solve};
use denavit::model::Arm;
use denavit::model::interpreted::Interpreted;
use denavit::robot::Robot;

fn main() -> Result<(), Box<dyn Error>> {
    let root = env!("CARGO_MANIFEST_DIR");
    let robot = Robot::open(format!("{root}/robots/kuka-iiwa14.yaml"))?;
    let arm = Interpreted::new(&robot, &[]);

    // Order 5, 10 Hz, forward and backward; the torque of these recordings is 40 ms late.
    let prepare = Prepare { torque_delay: 0.04, ..Prepare::default() };
    let factors = |name: &str| -> Result<Factors, Box<dyn Error>> {
        let mut stack = QrAccumulator::new(name, &arm, AccumulatorSettings::default());
        let mut source = log::open(name, File::open(format!("{root}/data/kuka-iiwa14/{name}"))?)?;
        each_motion(source.as_mut(), arm.dof(), &prepare, |motion| stack.absorb(motion))?;
        Ok(stack.finish())
    };
    let fit = [factors("chirp_j2.csv.gz")?, factors("chirp_j6.csv.gz")?, factors("motion_j2toj7.csv.gz")?];
    let validate = [factors("motion_j3j4.csv.gz")?];

    let found = solve(&arm, &fit, &validate, &IdentifySettings::default())?;
    for name in ["MSY2R", "MSY4R", "MSY6R"] {
        if let Some(p) = found.parameters.iter().find(|p| p.name == name) {
            println!("{name} = {:.4} +- {:.4} {}   ({})", p.value, p.std, p.unit, p.grouping);
        }
    }
    let validation = found.validation.ok_or("there was a validation log")?;
    println!("held-out error: {:.1} % of the torque", validation.relative_error_percent());
    Ok(())
}
