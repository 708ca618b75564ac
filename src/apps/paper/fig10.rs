//! Fig. 10: measured and estimated torques of the arm with the large roller, on the motion that
//! identified it.

use super::ReproduceError;
use super::Watch;
use super::loaded::{Loaded, loaded};
use super::lwr::{Lwr, Unmodelled};
use super::motions::PaperMotion;
use super::verdict::Verdict;
use crate::data::log::Replay;
use crate::data::signal::{Prepare, each_motion};
use crate::identify::tool::{Carrying, LogError};
use crate::identify::{Trace, Tracer};
use crate::simulate::Recording;

/// Abstract: "joint torques were estimated with an RMS difference lower than 1 N.m".
pub const PAPER_RMS: f64 = 1.0;
/// Bound on the seventh joint's torque, N m, which "was very small, inferior to 0.5 Nm" (section
/// VI.A).
pub const PAPER_SEVENTH: f64 = 0.5;

/// Torque curves and their errors.
#[derive(Debug, Clone, PartialEq)]
pub struct Fig10 {
    /// Measured and estimated torques over the loaded log.
    pub trace: Trace,
    /// Errors with the roller's parameters, and without them.
    pub errors: LogError,
    /// Identified and true mass, kg.
    pub mass: [f64; 2],
}

impl Fig10 {
    /// A joint's RMS difference compared with the paper's claim.
    pub fn verdict(&self, joint: usize) -> Verdict {
        Verdict::at_most(self.errors.with_tool.rms[joint], PAPER_RMS)
    }
}

/// Plays the motion with the roller and effects that the model lacks, and identifies arm and roller
/// together. `unloaded` is the log without a tool.
pub fn fig10(
    lwr: &Lwr,
    motion: &PaperMotion,
    unloaded: &Recording,
    which: &[Unmodelled],
    seed: u64,
    watch: Watch<'_>,
) -> Result<Fig10, ReproduceError> {
    watch("with the large roller", 0.0);
    let Loaded { tool, recording, carried } = loaded(lwr, motion, "large-roller", unloaded, which, seed)?;
    watch("with the large roller", 0.5);
    let with = Carrying::new(&lwr.arm, true);
    let mut tracer = Tracer::new("with the large roller", false, &with, &carried.beta);
    each_motion(&mut Replay::new(&recording.log), lwr.robot.dof(), &Prepare::default(), |motion| {
        tracer.absorb(motion)
    })?;
    let errors = carried.logs.iter().find(|l| l.loaded).cloned();
    let errors = errors.ok_or(ReproduceError::Missing("log with the roller in the hand"))?;
    Ok(Fig10 { trace: tracer.finish(), errors, mass: [carried.values[0], tool.inertia.map_or(f64::NAN, |i| i.m)] })
}
