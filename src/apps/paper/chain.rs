//! The paper's processing chain: play a motion, record at 1 kHz, low-pass, differentiate, weight,
//! solve (section III.E).

use super::ReproduceError;
use super::lwr::{Lwr, Unmodelled};
use super::motions::PaperMotion;
use crate::data::log::{Log, Replay};
use crate::data::signal::{Prepare, each_motion};
use crate::identify::{AccumulatorSettings, Factors, Identification, IdentifySettings, QrAccumulator, solve};
use crate::model::Arm;
use crate::simulate::{Recording, Request, Simulator, Solver};

/// Tolerance of the integration of motions. At 1e-5 the low-passed loop torques of the first joints
/// are off by 0.012 N m, a quarter of the noise floor. At this tolerance they are off by 0.004, the
/// low-pass's own effect on torques and motion. The simulator's default, 1e-7, takes twice as long.
const TOLERANCE: f64 = 1e-6;

/// Simulation request for playing and recording a motion.
pub fn request(seed: u64) -> Request {
    let solver = Solver { tolerance: TOLERANCE, ..Solver::default() };
    Request { sensors: Lwr::sensors(), seed, solver, ..Request::default() }
}

/// Plays a motion in the position loop and records it.
pub fn play(lwr: &Lwr, motion: &PaperMotion, which: &[Unmodelled], seed: u64) -> Result<Recording, ReproduceError> {
    let simulator = Simulator::new(&lwr.robot, &lwr.effects(which)?)?;
    Ok(simulator.run(&motion.played, &request(seed), &mut |_| {})?)
}

/// Filters, differentiates and factors a log; uses every `stride`th sample after the low-pass.
pub fn factors(name: &str, arm: &dyn Arm, log: &Log, stride: usize) -> Result<Factors, ReproduceError> {
    let mut stack = QrAccumulator::new(name, arm, AccumulatorSettings::default());
    let prepare = Prepare { stride, ..Prepare::default() };
    each_motion(&mut Replay::new(log), arm.dof(), &prepare, |motion| stack.absorb(motion))?;
    Ok(stack.finish())
}

/// Weighted least squares without prior knowledge.
pub fn fit(lwr: &Lwr, fit: &Factors, validate: &Factors) -> Result<Identification, ReproduceError> {
    let one = std::slice::from_ref;
    Ok(solve(&lwr.arm, one(fit), one(validate), &IdentifySettings::default())?)
}
