//! Identifies the payload from two logs of one motion, without and with it.
//!
//! `cargo run --release --example carried_tool`

use std::error::Error;
use std::fs::read_to_string;

use denavit::data::log::{Log, Replay};
use denavit::data::signal::{Prepare, each_motion};
use denavit::identify::tool::{Carrying, ToolSettings, identify_tool, names};
use denavit::identify::{AccumulatorSettings, Factors, QrAccumulator};
use denavit::model::Arm;
use denavit::model::interpreted::Interpreted;
use denavit::simulate::{Request, Sensors, Simulator, Trajectory};
use dh_codegen::arm::Function;
use dh_codegen::robot::{Effects, Robot, no_files};

/// A body of 1 kg, 0.1 m before the last frame.
const TOOL: &str = "tool: { name: weight, M: 1, MS: [0, 0, 0.1], I: [0.012, 0.012, 0.002, 0, 0, 0] }\n";

fn main() -> Result<(), Box<dyn Error>> {
    let text = read_to_string(format!("{}/robots/kuka-lwr4.yaml", env!("CARGO_MANIFEST_DIR")))?;
    let read = |text: &str| Robot::from_yaml(text, &no_files);
    let (empty, holding) = (read(&text)?.robot, read(&format!("{text}\n{TOOL}"))?.robot);
    let (unloaded, loaded) = (play(&empty)?, play(&holding)?);

    let arm = Interpreted::new(&empty, &[Function::PayloadRegressor]);
    let factors = |log: &Log, loaded: bool| -> Result<Factors, Box<dyn Error>> {
        let carrying = Carrying::new(&arm, loaded);
        let mut stack = QrAccumulator::new("simulated", &carrying, AccumulatorSettings::default());
        each_motion(&mut Replay::new(log), arm.dof(), &Prepare::default(), |motion| stack.absorb(motion))?;
        Ok(stack.finish())
    };
    let (unloaded, loaded) = (factors(&unloaded, false)?, factors(&loaded, true)?);
    let found = identify_tool(&arm, &[unloaded], &[loaded], &ToolSettings::default())?;
    for ((name, value), std) in names().iter().zip(found.values).zip(found.std) {
        println!("{name:<4} {value:>9.5} +- {std:.5}");
    }
    assert!((found.values[0] - 1.0).abs() < 0.1);
    Ok(())
}

/// Ten seconds of sines on all joints, recorded at 500 Hz.
fn play(robot: &Robot) -> Result<Log, Box<dyn Error>> {
    let (n, len) = (robot.dof(), 1001);
    let t: Vec<f64> = (0..len).map(|s| 0.01 * s as f64).collect();
    let q = (0..n).flat_map(|j| {
        let rate = 0.6 + 0.17 * j as f64;
        t.iter().map(move |t| 0.8 * (rate * t).sin() * (1.0 - (-t).exp()).powi(3))
    });
    let motion = Trajectory::new(n, t.clone(), q.collect(), None, None)?;
    let sensors = Sensors { rate: 500.0, torque_noise: vec![0.02], ..Sensors::default() };
    let request = Request { sensors, ..Request::default() };
    Ok(Simulator::new(robot, &Effects::default())?.run(&motion, &request, &mut |_| {})?.log)
}
