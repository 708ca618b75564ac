//! The arm with a tool in its hand: played, recorded, and identified together with an empty hand
//! (equation 7).

use dh_codegen::robot::Tool;

use super::ReproduceError;
use super::chain::{factors, request};
use super::lwr::{Lwr, Unmodelled};
use super::motions::PaperMotion;
use crate::data::log::Log;
use crate::identify::Factors;
use crate::identify::tool::{Carried, Carrying, ToolSettings, catalogue, identify_tool};
use crate::simulate::{Recording, Simulator};

/// Recording and estimate.
pub struct Loaded {
    /// The true tool.
    pub tool: Tool,
    /// With the tool.
    pub recording: Recording,
    /// Its ten parameters, in the last frame, and the robot's.
    pub carried: Carried,
}

/// Plays a motion with a tool of the catalogue in the hand.
pub fn carry(
    lwr: &Lwr,
    motion: &PaperMotion,
    name: &str,
    which: &[Unmodelled],
    seed: u64,
) -> Result<(Tool, Recording), ReproduceError> {
    let tool = catalogue().into_iter().find(|t| t.name == name);
    let tool = tool.ok_or_else(|| ReproduceError::NoTool(name.into()))?;
    let mut robot = lwr.robot.clone();
    robot.tool = Some(tool.clone());
    let simulator = Simulator::new(&robot, &lwr.effects(which)?)?;
    let recording = simulator.run(&motion.played, &request(seed), &mut |_| {})?;
    Ok((tool, recording))
}

/// The factors of a log with an empty hand and of one with a tool, on every `stride`th sample after
/// the low-pass.
pub fn stacked(lwr: &Lwr, unloaded: &Log, loaded: &Log, stride: usize) -> Result<(Factors, Factors), ReproduceError> {
    let (without, with) = (Carrying::new(&lwr.arm, false), Carrying::new(&lwr.arm, true));
    Ok((factors("unloaded", &without, unloaded, stride)?, factors("loaded", &with, loaded, stride)?))
}

/// Equation (7).
pub fn together(lwr: &Lwr, unloaded: &[Factors], loaded: &[Factors]) -> Result<Carried, ReproduceError> {
    Ok(identify_tool(&lwr.arm, unloaded, loaded, &ToolSettings::default())?)
}

/// Plays a motion with a tool and identifies it; `unloaded` was recorded with an empty hand, of
/// whatever motion.
pub fn loaded(
    lwr: &Lwr,
    motion: &PaperMotion,
    name: &str,
    unloaded: &Recording,
    which: &[Unmodelled],
    seed: u64,
) -> Result<Loaded, ReproduceError> {
    let (tool, recording) = carry(lwr, motion, name, which, seed)?;
    let (empty, full) = stacked(lwr, &unloaded.log, &recording.log, 1)?;
    let carried = together(lwr, &[empty], &[full])?;
    Ok(Loaded { tool, recording, carried })
}
