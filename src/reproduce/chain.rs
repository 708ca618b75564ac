//! The paper's chain: play a motion, record at 1 kHz, low-pass, differentiate, weigh, solve (section III.E).

use super::ReproduceError;
use super::lwr::{Lwr, Unmodelled};
use super::motions::Motion;
use crate::arm::Arm;
use crate::identify::{Factors, Identification, IdentifySettings, Stack, StackSettings, solve};
use crate::log::{Log, Replay};
use crate::signal::{Filter, Prepare, each_motion, low_pass};
use crate::simulate::{Recording, Request, Simulator};

/// Plays a motion in the position loop and records it.
pub fn play(lwr: &Lwr, motion: &Motion, which: &[Unmodelled], seed: u64) -> Result<Recording, ReproduceError> {
    let simulator = Simulator::new(&lwr.robot, &lwr.effects(which)?)?;
    let request = Request { sensors: Lwr::sensors(), seed, ..Request::default() };
    Ok(simulator.run(&motion.played, &request, &mut |_| {})?)
}

/// Filtered, differentiated and factored; every `stride`th sample after the low-pass.
pub fn factors(name: &str, arm: &dyn Arm, log: &Log, stride: usize) -> Result<Factors, ReproduceError> {
    let mut stack = Stack::new(name, arm, StackSettings::default());
    let prepare = Prepare { stride, ..Prepare::default() };
    each_motion(&mut Replay::new(log), arm.dof(), &prepare, |motion| stack.absorb(motion))?;
    Ok(stack.finish())
}

/// Weighted least squares; nothing is known beforehand.
pub fn fit(lwr: &Lwr, fit: &Factors, validate: &Factors) -> Result<Identification, ReproduceError> {
    let one = std::slice::from_ref;
    Ok(solve(&lwr.arm, one(fit), one(validate), &IdentifySettings::default())?)
}

/// What the low-pass leaves of white noise: root of the energy of its impulse response, forward and backward.
pub fn noise_gain(rate: f64) -> f64 {
    let Filter { order, cutoff } = Filter::default();
    let Ok(sos) = low_pass(order, cutoff, rate) else { return 1.0 };
    let half = 2 * sos.settling();
    let mut impulse = vec![0.0; 2 * half + 1];
    impulse[half] = 1.0;
    sos.forward_backward(&mut impulse, 0);
    impulse.iter().map(|x| x * x).sum::<f64>().sqrt()
}
