//! A complete session as a library: design a motion, play it on a simulated arm with a hidden
//! effect, identify, and diagnose what the model lacks.
//!
//! `cargo run --release --example one_sitting`

use std::error::Error;
use std::sync::atomic::AtomicBool;

use denavit::data::log::Replay;
use denavit::data::signal::{Prepare, each_motion};
use denavit::diagnose::{self, Recording, diagnose};
use denavit::excite::{Effort, Task, Watch, design};
use denavit::identify::{AccumulatorSettings, IdentifySettings, QrAccumulator, solve};
use denavit::model::Arm;
use denavit::model::differentiated::Differentiated;
use denavit::model::interpreted::Interpreted;
use denavit::model::perturbable_robot::PerturbableRobot;
use denavit::robot::Robot;
use denavit::simulate::{Request, Sensors, SimulationFile, Simulator, Trajectory};

fn main() -> Result<(), Box<dyn Error>> {
    let robot = Robot::open(concat!(env!("CARGO_MANIFEST_DIR"), "/robots/kuka-lwr4.yaml"))?;
    let hidden = "joints: { 4: { torque_ripple: { RN: 20, RC: 0.4, RS: 0.3 } } }";
    let hidden = SimulationFile::from_yaml(hidden, &robot).map_err(|p| p.in_file("effects").to_string())?;

    // Two motions: one to fit, one to validate. A few starts suffice for an example.
    let designer = Differentiated::new(&robot);
    let simulator = Simulator::new(&robot, &hidden.effects)?;
    let mut logs = Vec::new();
    for (seconds, seed) in [(10.0, 1), (6.0, 2)] {
        let task = Task::new(&designer, &robot, seconds, 0.5)?;
        let (stop, effort) = (AtomicBool::new(false), Effort { starts: 2, seed, iterations: 15, ..Effort::default() });
        let found = design(&task, &effort, &Watch { stop: &stop, progress: &|_| {} })?;
        println!("{seconds} s of motion, condition number {:.0}, feasible: {}", found.plain.condition, found.feasible);
        let (t, states) = found.trajectory.sampled(100.0);
        let played = Trajectory::new(robot.dof(), t, states.q, Some(states.dq), Some(states.ddq))?;
        let sensors = Sensors { rate: 500.0, torque_noise: vec![0.05], ..Sensors::default() };
        logs.push(simulator.run(&played, &Request { sensors, seed, ..Request::default() }, &mut |_| {})?.log);
    }

    // Residual of a plain identification.
    let arm = Interpreted::new(&robot, &[]);
    let mut factors = Vec::new();
    for log in &logs {
        let mut stack = QrAccumulator::new("simulated", &arm, AccumulatorSettings::default());
        each_motion(&mut Replay::new(log), arm.dof(), &Prepare::default(), |motion| stack.absorb(motion))?;
        factors.push(stack.finish());
    }
    let found = solve(&arm, &factors[..1], &factors[1..], &IdentifySettings::default())?;
    let held_out = found.validation.ok_or("there was a second log")?.rms;
    println!("held-out error of the identified model, N m: {held_out:.3?}");

    // Causes of the residual.
    let plant = PerturbableRobot::new(&robot);
    let mut recordings = Vec::new();
    for log in &logs {
        let mut recording = Recording::new("simulated");
        let prepare = Prepare { raw_torque: true, ..Prepare::default() };
        each_motion(&mut Replay::new(log), arm.dof(), &prepare, |motion| recording.absorb(motion))?;
        recordings.push(recording);
    }
    let settings = diagnose::Settings::default();
    let verdict = diagnose(&plant, &recordings[..1], &recordings[1..], &settings, &|_| {})?;
    for cause in &verdict.causes {
        let joints: Vec<String> = cause.joints.iter().map(usize::to_string).collect();
        println!("{} on joint {}: {}", cause.cause, joints.join(", "), cause.evidence);
    }
    assert!(verdict.causes.iter().any(|cause| cause.cause == "torque_ripple" && cause.joints == [4]));
    Ok(())
}
