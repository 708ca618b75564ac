//! Trial of other orders and units of the torque columns of logs.

use std::path::Path;

use dh_codegen::robot::Robot;

use super::Failure;
use super::known_effects::without;
use super::prepare::pass;
use crate::data::log::Finding;
use crate::data::signal::Prepare;
use crate::identify::recording::moving;
use crate::identify::{Identification, KnownEffects, Reference, TorqueColumns};
use crate::model::Arm;

/// Findings of other interpretations of the columns, over the logs tried.
pub(super) struct Tried<'a> {
    prepare: &'a Prepare,
    known: Option<&'a KnownEffects<'a>>,
    gears: Vec<Option<f64>>,
    explained: Vec<(String, Finding)>,
    distinguish: bool,
}

impl<'a> Tried<'a> {
    pub(super) fn new(robot: &Robot, prepare: &'a Prepare, known: Option<&'a KnownEffects<'a>>) -> Self {
        let gears = moving(robot).map(|joint| joint.drive.gear_ratio).collect();
        Self { prepare, known, gears, explained: Vec::new(), distinguish: true }
    }

    /// Makes another pass over a log, for an arm that may carry a load.
    pub(super) fn log(&mut self, path: &Path, arm: &dyn Arm, references: &[Reference<'_>]) -> Result<(), Failure> {
        let mut columns = TorqueColumns::new(arm);
        pass(path, arm.dof(), self.prepare, |motion| columns.absorb(&without(self.known, motion)))?;
        self.distinguish &= columns.distinguishes();
        let finding = references.iter().find_map(|r| columns.explained(*r, &self.gears));
        self.explained.extend(finding.map(|finding| (path.display().to_string(), finding)));
        Ok(())
    }

    /// Replaces the suspicions by the findings.
    pub(super) fn tell(self, found: &mut Identification) {
        if self.explained.is_empty() && self.distinguish {
            found.rule_out_columns();
        }
        found.take_explanations(self.explained);
    }
}
