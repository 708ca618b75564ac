//! The arm with a tool: played, recorded, and identified together with a log without a tool
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

/// Recording with a tool, and the estimate from it.
pub struct Loaded {
    /// The true tool.
    pub tool: Tool,
    /// Recording with the tool.
    pub recording: Recording,
    /// Identified parameters of the tool (ten, in the last frame) and of the robot.
    pub carried: Carried,
}

/// Plays a motion with a tool of the catalogue.
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

/// Factors of a log without a tool and of one with a tool, from every `stride`th sample after the
/// low-pass.
pub fn stacked(lwr: &Lwr, unloaded: &Log, loaded: &Log, stride: usize) -> Result<(Factors, Factors), ReproduceError> {
    let (without, with) = (Carrying::new(&lwr.arm, false), Carrying::new(&lwr.arm, true));
    Ok((factors("unloaded", &without, unloaded, stride)?, factors("loaded", &with, loaded, stride)?))
}

/// Identifies robot and tool together: equation (7).
pub fn together(lwr: &Lwr, unloaded: &[Factors], loaded: &[Factors]) -> Result<Carried, ReproduceError> {
    Ok(identify_tool(&lwr.arm, unloaded, loaded, &ToolSettings::default())?)
}

/// Plays a motion with a tool and identifies it; `unloaded` is a log without a tool, of any motion.
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
