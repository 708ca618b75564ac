//! Estimates the force on the tool from joint torques: a simulated LWR is pushed for a second, and
//! the estimate is compared with the push.
//!
//! `cargo run --example contact_force`

use std::error::Error;

use denavit::control::estimate::{EstimationSettings, Known, Linear, NoisePass, NoiseSource, Run, Uncertainty};
use denavit::data::log::Replay;
use denavit::data::signal::{Prepare, each_motion};
use denavit::model::interpreted::Interpreted;
use denavit::robot::Robot;
use denavit::simulate::{Control, Mode, Request, Sensors, SimulationFile, Simulator, Trajectory};
use dh_codegen::arm::param::standard_values;

fn main() -> Result<(), Box<dyn Error>> {
    let robot = Robot::open(concat!(env!("CARGO_MANIFEST_DIR"), "/robots/kuka-lwr4.yaml"))?;
    let push = "effects: { external_contact: { start: 2, end: 3, fx: 15, fy: 0, fz: -10 } }";
    let push = SimulationFile::from_yaml(push, &robot)?;

    // Five seconds through an elbow posture, all joints moving.
    let n = robot.dof();
    let t: Vec<f64> = (0..=50).map(|k| 0.1 * f64::from(k)).collect();
    let start = [0.2, 0.7, -0.3, -1.2, 0.4, 0.9, 0.1];
    let q: Vec<f64> = (0..n).flat_map(|j| t.iter().map(move |t| start[j] + 0.2 * (0.9 * t + j as f64).sin())).collect();
    let motion = Trajectory::new(n, t, q, None, None)?;
    let sensors = Sensors { rate: 200.0, torque_noise: vec![0.05], wrench: true, ..Sensors::default() };
    let control = Control { mode: Mode::Exact, ..Control::default() };
    let request = Request { sensors, control, ..Request::default() };
    let log = Simulator::new(&robot, &push.effects)?.run(&motion, &request, &mut |_| {})?.log;

    // The model is the robot file's. There is no contact in the first two seconds, whose residual
    // torque counts as noise.
    let arm = Interpreted::new(&robot, &Interpreted::BODIES);
    let standard = standard_values(&robot).ok_or("the robot file has the parameters of every link")?;
    let beta = arm.model().base().values(&standard);
    let torques = Linear::new(&arm, &beta);
    let free = vec![[0.0, 2.0]];
    let prepare = Prepare { raw_torque: true, margins: true, wrench: true, ..Prepare::default() };
    let mut noise = NoisePass::new(&arm, &torques, prepare.filter, &free, false);
    each_motion(&mut Replay::new(&log), n, &prepare, |motion| noise.absorb(motion))?;
    let noise = noise.left(false).ok_or("the log has samples before the push")?;
    let uncertainty = Uncertainty::noise(noise, NoiseSource::Free, beta.len());

    let known =
        Known { arm: &arm, standard: &standard, torques: &torques, uncertainty: &uncertainty, torque_limits: &[] };
    let mut tool = arm.bodies(&standard);
    let mut run = Run::new("pushed", known, &mut tool, EstimationSettings { free, ..EstimationSettings::default() })?;
    each_motion(&mut Replay::new(&log), n, &prepare, |motion| run.absorb(motion))?;
    let found = run.finish();

    let middle = found.time.iter().position(|t| *t >= 2.5).ok_or("the log goes on after the push")?;
    let [fx, fy, fz, ..] = found.wrench[middle];
    let [bx, by, bz, ..] = found.half[middle];
    println!("at 2.5 s: fx {fx:.1} ± {bx:.1}, fy {fy:.1} ± {by:.1}, fz {fz:.1} ± {bz:.1} N");
    let all = found.against_measured().ok_or("the simulated log has the wrench")?;
    println!("root mean square error of the forces: {:.2} {:.2} {:.2} N", all[0].rms, all[1].rms, all[2].rms);
    assert!((fx - 15.0).abs() < 3.0 && (fz + 10.0).abs() < 3.0);
    Ok(())
}
