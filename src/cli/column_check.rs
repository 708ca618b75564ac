//! Whether the torque columns of a log are what their names say, before anything is concluded from
//! them.

use dh_codegen::robot::Robot;

use super::Failure;
use super::known_effects::without;
use crate::data::log::{Acceptance, Finding, LogError, Severity};
use crate::data::signal::{Motion, Prepared};
use crate::identify::recording::moving;
use crate::identify::{KnownEffects, Reference, TorqueColumns};
use crate::model::Arm;

/// Samples per second that suffice to distinguish columns.
const RATE: f64 = 50.0;

/// References for the torques of logs.
pub(super) struct ColumnCheck<'a> {
    arm: &'a dyn Arm,
    /// Base parameters of the robot file, where it has links.
    model: Option<Vec<f64>>,
    /// Effects of the robot file, whose torque is no matter of columns.
    known: Option<KnownEffects<'a>>,
    gears: Vec<Option<f64>>,
    allowed: bool,
}

impl<'a> ColumnCheck<'a> {
    /// `standard`: parameters of the robot file, in the arm's order.
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

    /// For one log.
    pub(super) fn columns(&self) -> TorqueColumns<'a> {
        TorqueColumns::new(self.arm)
    }

    /// Takes in a stretch of motion, thinned.
    pub(super) fn absorb(&self, columns: &mut TorqueColumns<'_>, motion: &Motion) {
        let mut thin = without(self.known.as_ref(), motion).into_owned();
        thin.stride = ((motion.period * RATE).recip().round() as usize).max(1);
        columns.absorb(&thin);
    }

    /// Adds another reading of the columns that explains the log far better to what was found in
    /// it.
    ///
    /// # Errors
    /// Where there is one, and that is not allowed.
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
