//! Check of whether the torque columns of a log match their names, before they are used.

use dh_codegen::robot::Robot;

use super::Failure;
use super::known_effects::without;
use crate::data::log::{Acceptance, Finding, LogError, Severity};
use crate::data::signal::{Motion, Prepared};
use crate::identify::recording::moving;
use crate::identify::{KnownEffects, Reference, TorqueColumns};
use crate::model::Arm;

/// Sampling rate that suffices to distinguish columns, Hz.
const RATE: f64 = 50.0;

/// Reference torques for the columns of logs.
pub(super) struct ColumnCheck<'a> {
    arm: &'a dyn Arm,
    /// Base parameters of the robot file, if it has links.
    model: Option<Vec<f64>>,
    /// Effects of the robot file, whose torque must not be mistaken for that of other columns.
    known: Option<KnownEffects<'a>>,
    gears: Vec<Option<f64>>,
    allowed: bool,
}

impl<'a> ColumnCheck<'a> {
    /// Creates a check; `standard` are the parameters of the robot file, in the arm's order.
    pub(super) fn new(
        robot: &Robot,
        arm: &'a dyn Arm,
        standard: Option<&[f64]>,
        known: Option<KnownEffects<'a>>,
        keep: Acceptance,
    ) -> Self {
        let base = |standard: &[f64]| -> Vec<f64> {
            arm.base_parameters().iter().map(|b| b.coefficients.iter().map(|&(i, k)| k * standard[i]).sum()).collect()
        };
        let model = standard.map(base).filter(|beta| beta.iter().any(|v| *v != 0.0));
        let gears = moving(robot).map(|joint| joint.drive.gear_ratio).collect();
        Self { arm, model, known, gears, allowed: keep.misread }
    }

    /// Creates the accumulator for one log.
    pub(super) fn columns(&self) -> TorqueColumns<'a> {
        TorqueColumns::new(self.arm)
    }

    /// Adds a segment of motion, thinned.
    pub(super) fn absorb(&self, columns: &mut TorqueColumns<'_>, motion: &Motion) {
        let mut thin = without(self.known.as_ref(), motion).into_owned();
        thin.stride = ((motion.period * RATE).recip().round() as usize).max(1);
        columns.absorb(&thin);
    }

    /// Adds a finding to the log if another interpretation of its columns explains it far better.
    ///
    /// # Errors
    /// Returns an error if there is one and it is not accepted.
    pub(super) fn finish(&self, columns: &TorqueColumns<'_>, log: &mut Prepared) -> Result<(), Failure> {
        let model = self.model.as_ref().map(|beta| Reference::Model(beta));
        if !columns.is_suspicious(model.unwrap_or(Reference::Fit)) {
            return Ok(());
        }
        let mut references = std::iter::once(Reference::Fit).chain(model);
        let Some(finding) = references.find_map(|r| columns.explained(r, &self.gears)) else { return Ok(()) };
        let severity = if self.allowed { Severity::Warning } else { Severity::Fatal };
        let finding = Finding { severity, ..finding };
        if finding.is_fatal() {
            return Err(Failure::input(LogError::Rejected { file: log.file.clone(), findings: vec![finding] }));
        }
        log.findings.insert(0, finding);
        Ok(())
    }
}
