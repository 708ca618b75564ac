//! Models among which one is offered: with the file's links, with all base parameters refitted, and
//! the plain refit beside which both have to hold on each validating log.

use super::excess::{TENTH, by_log, excess, with_excess};
use super::measure::{Measured, Meter};
use super::model_choice::LeftOut;
use super::prune::Pruned;
use super::refine_and_select::{Selected, Session};
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

/// A refit of all base parameters and friction, without any further cause: what remains is
/// structure.
pub(in crate::diagnose) struct Refit {
    /// Errors on stretches of the fitted logs that are left out in turn.
    pub(in crate::diagnose) left_out: LeftOut,
    pub(in crate::diagnose) errors: Errors,
    /// Errors on each validating log, where joints move, N m; empty without such logs.
    by_log: Vec<Vec<f64>>,
    /// Noise of each joint's torque where the residuals of fitted and validating logs are nothing else, N m:
    /// the smaller of both.
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
    /// Noise of each joint's torque, N m, where the residuals show more than was known.
    pub(in crate::diagnose) fn with_noise_seen(&self, known: Vec<f64>) -> Vec<f64> {
        known.into_iter().zip(&self.noise).map(|(known, seen)| seen.unwrap_or(0.0).max(known)).collect()
    }
}

/// The fit without a cause, inside what is possible where that can be, and its errors on left-out
/// stretches.
fn plainly(refit: &mut ModelUnderTest<'_>) -> Result<(Fitted, LeftOut), DiagnoseError> {
    let plain = refit.fit(&mut []);
    Ok(match refit.possible(&mut [], &plain) {
        Ok(possible) => {
            let out = refit.possible_left_out(&[], &possible)?;
            (possible, out)
        }
        // A refit that no arm can have is a yardstick; it is not offered.
        Err(_) => {
            let out = refit.left_out(&[], &plain);
            (plain, out)
        }
    })
}

/// Most samples of all joints of fitted and validating logs for two searches at once: of more they
/// would take over 200 MB.
const TWICE: usize = 150_000;

/// Result of the searches.
pub(in crate::diagnose) struct Searched<'a> {
    /// The models that hold.
    pub(in crate::diagnose) models: Vec<Selected<'a>>,
    /// Sentences on those that do not.
    pub(in crate::diagnose) said: Vec<String>,
    /// The causes that the model of the file's links had, and that the refitted one had.
    pub(in crate::diagnose) suspects: [Vec<Cause>; 2],
}

impl<'a> Session<'a> {
    /// Part of a model's residual that is not noise. `torque`: root mean square of each joint's, N
    /// m.
    pub(in crate::diagnose) fn left(&self, model: &Selected<'_>, torque: &[f64]) -> Vec<Structure> {
        self.left_of(&model.tested.scene, &model.fitted.residual, [&model.after_fit, &model.after], torque)
    }

    /// The same of a residual, per joint and window, and of errors on fitted and validating logs.
    pub(in crate::diagnose) fn left_of(
        &self,
        scene: &WindowedData<'_>,
        residual: &[Vec<f64>],
        errors: [&Measured; 2],
        torque: &[f64],
    ) -> Vec<Structure> {
        let of = |noise: &[f64]| with_excess(structure(scene, residual, noise, torque), excess(errors, noise));
        let found = of(self.noise);
        // A refit misses what the model has, which hides how large noise with a memory is.
        let mut noise = self.noise.to_vec();
        for j in found.iter().map(|s| s.joint) {
            let seen = errors.iter().filter_map(|errors| errors.noise(j)).reduce(f64::min);
            noise[j] = seen.map_or(noise[j], |seen| seen.max(noise[j]));
        }
        let mut found = if noise == self.noise { found } else { of(&noise) };
        found.retain(|s| calibration::structure(s.rms, noise[s.joint]) >= calibration::NAMED_BY_SIZE);
        found
    }

    /// Whether there is memory for two searches at once.
    fn fits_twice(&self) -> bool {
        let samples = |r: &Recording| r.stretches.iter().map(|s| s.tau.len()).sum::<usize>();
        self.fit.iter().chain(self.validate).map(samples).sum::<usize>() <= TWICE
    }

    /// The models that were searched. `file`: errors of the unchanged file on left-out stretches,
    /// where it has links.
    pub(in crate::diagnose) fn models(
        &self,
        file: Option<&LeftOut>,
        refit: &Refit,
        torque: &[f64],
    ) -> Result<Searched<'a>, ConsistentError> {
        let (mut models, mut said, mut suspects) = (Vec::new(), Vec::new(), [Vec::new(), Vec::new()]);
        let mut refitted = None;
        if let Some(file) = file {
            // What is likely to be needed is searched beside the other, on a processor of its own.
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
                Err(error) => said.push(format!("Refitted parameters are not offered: {error}.")),
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
                match self.pruned(model, &|model| self.fails_on(model, without))? {
                    Pruned::Holds(model) => holding.push(*model),
                    Pruned::Fails(sentence) => said.push(sentence),
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

    /// Refitted links go where they err more than the unchanged file on every validating log, and
    /// there is a model of the file's links with causes: the fitted logs show too little of them.
    fn without_poor_links(&self, models: &mut Vec<Selected<'a>>, file: &[Vec<f64>], said: &mut Vec<String>) {
        if !models.iter().any(|m| m.tested.mode == Mode::Trusted && !m.causes.is_empty()) {
            return;
        }
        let before = models.len();
        models.retain(|m| m.tested.mode == Mode::Trusted || !self.worse_as_a_whole(m, file));
        if models.len() < before {
            said.push("Refitted links err more than the file's on every validating log, and are not offered.".into());
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

    /// Whether it errs more on every validating log than a plain refit, by a tenth and more, and than the
    /// unchanged file: what its causes say of the fitted logs makes it worse elsewhere.
    pub(in crate::diagnose) fn worse_throughout(&self, model: &Selected<'_>, refit: &Refit) -> bool {
        self.own_validation
            && self.errs_more(model, &refit.by_log, TENTH)
            && self.file_by_log().is_ok_and(|file| self.errs_more(model, &file, 1.0))
    }

    /// Says so where a model errs more with further causes than without them on a validating log:
    /// `without`, errors of the same links without any, per log and joint, N m. Logs of different
    /// robots refute no model.
    fn fails_on(&self, model: &Selected<'_>, without: &[Vec<f64>]) -> Option<String> {
        let logs = self.worse_on(model, without);
        let holds = model.accepted.is_empty() || logs.is_empty() || !self.changed(model, self.noise).is_empty();
        (!holds).then(|| {
            let (count, logs) = (model.accepted.len(), logs.join(", "));
            let links = if model.tested.mode == Mode::Trusted { "the file's links" } else { "refitted links" };
            format!("A model of {links} with {count} further causes errs more on {logs} than without them, and is not offered.")
        })
    }
}
