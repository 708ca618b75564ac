//! Candidate models for the offer: the file's links, all base parameters refitted, and a plain
//! refit with which both are compared on each validating log.

use super::excess::{TENTH, by_log, exceed, excess, with_excess};
use super::measure::{Measured, Meter};
use super::model_choice::LeftOut;
use super::prune::Pruned;
use super::refine_and_select::{Selected, Session};
use super::remark::Remark;
use super::suspects::remember;
use crate::diagnose::findings::calibration;
use crate::diagnose::findings::result::{Cause, Errors};
use crate::diagnose::findings::structure::{Structure, structure};
use crate::diagnose::fit::model::{Fitted, Mode, ModelUnderTest};
use crate::diagnose::run::DiagnoseError;
use crate::diagnose::windows::recording::Recording;
use crate::diagnose::windows::windowed_data::WindowedData;
use crate::identify::ConsistentError;
use crate::model::PerturbableArm;
use crate::numerics::parallel::{parallel, threads};

/// A refit of all base parameters and friction without any further cause, as a reference; its
/// remaining error is structure.
pub(in crate::diagnose) struct Refit {
    /// Errors on stretches of the fitted logs that are left out in turn.
    pub(in crate::diagnose) left_out: LeftOut,
    pub(in crate::diagnose) errors: Errors,
    /// Errors on each validating log, where joints move, N m; empty without such logs.
    by_log: Vec<Vec<f64>>,
    /// Noise of each joint's torque, N m, where the residuals of fitted and validating logs are
    /// pure noise: the smaller of the two.
    noise: Vec<Option<f64>>,
}

impl Refit {
    /// The refit, and the model that was fitted.
    pub(in crate::diagnose) fn new<'a>(
        plant: &'a dyn PerturbableArm,
        fit: &'a [Recording],
        validate: &'a [Recording],
        own_validation: bool,
        rate: f64,
    ) -> Result<(Self, ModelUnderTest<'a>), DiagnoseError> {
        let mut tested = ModelUnderTest::new(plant, fit, rate, Mode::Refitted, &plant.delays(), false);
        let (plain, left_out) = plainly(&mut tested)?;
        let after = Meter::new(plant, validate, &tested).of(&tested, &plain, &[], true);
        let fitted = Meter::new(plant, fit, &tested).of(&tested, &plain, &[], false);
        let noise = (0..plant.dof()).map(|j| Measured::noise_of_both([&fitted, &after], j)).collect();
        let fitted = fitted.rms;
        let by_log = if own_validation { by_log(plant, validate, &tested, &plain, &[]) } else { Vec::new() };
        let errors = Errors { fit: fitted, validate: after.rms, moving: after.steady };
        Ok((Self { left_out, errors, by_log, noise }, tested))
    }
}

impl Refit {
    /// Noise of each joint's torque, N m, raised to that of the residuals where these show more.
    pub(in crate::diagnose) fn with_noise_seen(&self, known: Vec<f64>) -> Vec<f64> {
        known.into_iter().zip(&self.noise).map(|(known, seen)| seen.unwrap_or(0.0).max(known)).collect()
    }
}

/// The fit without a cause, within physical limits where it exists, and its errors on left-out
/// stretches.
fn plainly(refit: &mut ModelUnderTest<'_>) -> Result<(Fitted, LeftOut), DiagnoseError> {
    let plain = refit.fit(&mut []);
    Ok(match refit.possible(&mut [], &plain) {
        Ok(possible) => {
            let out = refit.possible_left_out(&[], &possible)?;
            (possible, out)
        }
        // A physically inconsistent refit still serves as a reference; it is not offered.
        Err(_) => {
            let out = refit.left_out(&[], &plain);
            (plain, out)
        }
    })
}

/// Maximum number of samples of all joints, fitted and validating logs together, for two parallel
/// searches: more would take over 200 MB.
const TWICE: usize = 150_000;

/// Result of the searches.
pub(in crate::diagnose) struct Searched<'a> {
    /// Models that hold.
    pub(in crate::diagnose) models: Vec<Selected<'a>>,
    /// Sentences on models that do not hold.
    pub(in crate::diagnose) said: Vec<Remark>,
    /// Causes that were in the model with the file's links, and in the refitted one.
    pub(in crate::diagnose) suspects: [Vec<Cause>; 2],
}

impl<'a> Session<'a> {
    /// Part of a model's residual that is not noise. `torque`: root mean square of each joint's
    /// torque, N m.
    pub(in crate::diagnose) fn left(&self, model: &Selected<'_>, torque: &[f64]) -> Vec<Structure> {
        self.left_of(&model.tested.scene, &model.fitted.residual, [&model.after_fit, &model.after], torque)
    }

    /// The same for a residual, per joint and window, and errors on fitted and validating logs.
    pub(in crate::diagnose) fn left_of(
        &self,
        scene: &WindowedData<'_>,
        residual: &[Vec<f64>],
        errors: [&Measured; 2],
        torque: &[f64],
    ) -> Vec<Structure> {
        let of = |noise: &[f64]| with_excess(structure(scene, residual, noise, torque), excess(errors, noise));
        let found = of(self.noise);
        // A plain refit lacks the causes, which hides the size of autocorrelated noise.
        let mut noise = self.noise.to_vec();
        for j in found.iter().map(|s| s.joint) {
            let seen = errors.iter().filter_map(|errors| errors.noise(j)).reduce(f64::min);
            noise[j] = seen.map_or(noise[j], |seen| seen.max(noise[j]));
        }
        let mut found = if noise == self.noise { found } else { of(&noise) };
        found.retain(|s| calibration::structure(s.rms, noise[s.joint]) >= calibration::NAMED_BY_SIZE);
        found
    }

    /// Whether the logs are small enough for two parallel searches.
    fn fits_twice(&self) -> bool {
        let samples = |r: &Recording| r.stretches.iter().map(|s| s.tau.len()).sum::<usize>();
        self.fit.iter().chain(self.validate).map(samples).sum::<usize>() <= TWICE
    }

    /// Results of the searches. `file`: errors of the unchanged file on left-out stretches, if it
    /// has link parameters.
    pub(in crate::diagnose) fn models(
        &self,
        file: Option<&LeftOut>,
        refit: &Refit,
        torque: &[f64],
    ) -> Result<Searched<'a>, ConsistentError> {
        let (mut models, mut said, mut suspects) = (Vec::new(), Vec::new(), [Vec::new(), Vec::new()]);
        let mut refitted = None;
        if let Some(file) = file {
            // If the refit is likely to be needed, run both searches in parallel.
            let both = refit.left_out.less(file, self.ground).worth_refit(0) && threads() > 1 && self.fits_twice();
            (self.progress)(if both {
                "the file's links unchanged, and refitted"
            } else {
                "the file's links unchanged"
            });
            let modes = [Mode::Trusted, Mode::Refitted];
            let mut found = parallel(2, 1 + usize::from(both), |i| self.searched(modes[i])).into_iter();
            models.extend(found.next().transpose()?);
            refitted = found.next();
        }
        let refit_is_better = |m: &Selected<'_>| {
            refit.left_out.less(&m.left_out, self.ground).worth_refit(m.causes.len()) || self.worse_than(m, refit)
        };
        if !models.iter().any(|m| self.left(m, torque).is_empty() && !refit_is_better(m)) {
            let refitted = refitted.unwrap_or_else(|| {
                (self.progress)("all base parameters refitted");
                self.searched(Mode::Refitted)
            });
            match refitted {
                Ok(model) => models.push(model),
                Err(error) => said.push(format!("Refitted parameters are not offered: {error}.").into()),
            }
        }
        for model in &models {
            let refitted = usize::from(model.tested.mode == Mode::Refitted);
            remember(&mut suspects[refitted], &model.suspects);
        }
        if self.own_validation {
            let file = self.file_by_log()?;
            let mut holding = Vec::new();
            for model in models {
                let without = if model.tested.mode == Mode::Trusted { &file } else { &refit.by_log };
                match self.pruned(model, without)? {
                    Pruned::Holds(model) => holding.push(*model),
                    Pruned::Fails(sentence) => said.push(sentence.into()),
                }
            }
            models = holding;
            self.without_poor_links(&mut models, &file, &mut said);
            if models.is_empty() {
                models.extend(self.plain().ok());
            }
        }
        Ok(Searched { models, said, suspects })
    }

    /// Drops refitted links that err more than the unchanged file on every validating log: the
    /// fitted logs excite them too little. Requires a model of the file's links with causes.
    fn without_poor_links(&self, models: &mut Vec<Selected<'a>>, file: &[Vec<f64>], said: &mut Vec<Remark>) {
        if !models.iter().any(|m| m.tested.mode == Mode::Trusted && !m.causes.is_empty()) {
            return;
        }
        let before = models.len();
        models.retain(|m| m.tested.mode == Mode::Trusted || !self.worse_as_a_whole(m, file));
        if models.len() < before {
            said.push(
                "Refitted links err more than the file's on every validating log, and are not offered."
                    .to_string()
                    .into(),
            );
        }
    }

    /// Errors of the unchanged file on each validating log, where joints move, N m.
    fn file_by_log(&self) -> Result<Vec<Vec<f64>>, ConsistentError> {
        Ok(self.by_log_of(&self.file()?))
    }

    /// Errors of a model without causes on each validating log, where joints move, N m.
    pub(in crate::diagnose) fn by_log_of(&self, model: &Selected<'_>) -> Vec<Vec<f64>> {
        by_log(self.plant, self.validate, &model.tested, &model.fitted, &[])
    }

    /// Whether a model errs more than a plain refit on a validating log.
    pub(in crate::diagnose) fn worse_than(&self, model: &Selected<'_>, refit: &Refit) -> bool {
        self.own_validation && !self.worse_on(model, &refit.by_log).is_empty()
    }

    /// Whether a model errs at least a tenth more than a plain refit on every validating log, and
    /// more than the unchanged file. Causes found on the fitted logs then make it worse elsewhere.
    pub(in crate::diagnose) fn worse_throughout(&self, model: &Selected<'_>, refit: &Refit) -> bool {
        if !self.own_validation {
            return false;
        }
        let own = self.errors_by_log(model);
        exceed(&own, &refit.by_log, TENTH) && self.file_by_log().is_ok_and(|file| exceed(&own, &file, 1.0))
    }

    /// A sentence if a model errs more with its further causes than without them on a validating
    /// log. `without`: errors of the same links without any, per log and joint, N m.
    pub(super) fn fails_on(&self, model: &Selected<'_>, without: &[Vec<f64>]) -> Option<String> {
        let logs = self.worse_on(model, without);
        let whole = || self.worse_as_a_whole(model, without);
        let differ = || !self.changed(model, self.noise).is_empty();
        (!model.accepted.is_empty() && refuted(logs.len(), whole, differ)).then(|| {
            let (count, logs) = (model.accepted.len(), logs.join(", "));
            let links = if model.tested.mode == Mode::Trusted { "the file's links" } else { "refitted links" };
            format!("A model of {links} with {count} further causes errs more on {logs} than without them, and is not offered.")
        })
    }
}

/// Whether validating logs refute a model that errs more on `worse` of them. Logs of different
/// robots (`differ`) do so only if it errs more on every one of them over all joints (`whole`).
fn refuted(worse: usize, whole: impl FnOnce() -> bool, differ: impl FnOnce() -> bool) -> bool {
    worse > 0 && (whole() || !differ())
}

#[cfg(test)]
mod tests {
    use super::refuted;

    /// A gear of 1.6 N m s/rad that was found beside ripple of 38 N m made every joint worse.
    #[test]
    fn different_robots_refute_a_model_that_is_worse_as_a_whole() {
        let refutes = |worse, whole: bool, differ: bool| refuted(worse, || whole, || differ);
        assert!(refutes(1, true, true) && refutes(1, false, false));
        assert!(!refutes(1, false, true) && !refutes(0, false, false) && !refutes(0, true, false));
    }
}
