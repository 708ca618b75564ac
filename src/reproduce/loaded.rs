//! The arm with a tool in its hand: played, recorded, and identified together with an empty hand (equation 7).

use dh_codegen::robot::Tool;

use super::ReproduceError;
use super::chain::factors;
use super::lwr::{Lwr, Unmodelled};
use super::motions::Motion;
use crate::simulate::{Recording, Request, Simulator};
use crate::tool::{Carried, Carrying, ToolSettings, catalogue, identify_tool};

/// What was recorded and found.
pub struct Loaded {
    /// The tool as it is.
    pub tool: Tool,
    /// With the tool.
    pub recording: Recording,
    /// Its ten parameters, in the last frame, and the robot's.
    pub carried: Carried,
}

/// Plays a motion with a tool of the catalogue; `unloaded` was recorded with an empty hand, of whatever motion.
pub fn loaded(
    lwr: &Lwr,
    motion: &Motion,
    name: &str,
    unloaded: &Recording,
    which: &[Unmodelled],
    seed: u64,
) -> Result<Loaded, ReproduceError> {
    let tool = catalogue().into_iter().find(|t| t.name == name);
    let tool = tool.ok_or_else(|| ReproduceError::Robot(format!("there is no tool `{name}`")))?;
    let mut robot = lwr.robot.clone();
    robot.tool = Some(tool.clone());
    let simulator = Simulator::new(&robot, &lwr.effects(which)?)?;
    let request = Request { sensors: Lwr::sensors(), seed, ..Request::default() };
    let recording = simulator.run(&motion.played, &request, &mut |_| {})?;
    let (without, with) = (Carrying::new(&lwr.arm, false), Carrying::new(&lwr.arm, true));
    let carried = identify_tool(
        &lwr.arm,
        &[factors("unloaded", &without, &unloaded.log, 1)?],
        &[factors("loaded", &with, &recording.log, 1)?],
        &ToolSettings::default(),
    )?;
    Ok(Loaded { tool, recording, carried })
}
