//! From what a search found to a model that holds on data which were not used; and which of several
//! such models is offered.

use super::beside::{Beside, Without};
use super::contenders::Refit;
use super::measure::{Measured, Meter, matters, taken_of, takes};
use super::model_choice::LeftOut;
use super::reduction::{backward_eliminate, drop_insignificant, fix_friction, free_friction, without};
use crate::diagnose::findings::attribution::Attribution;
use crate::diagnose::findings::evidence;
use crate::diagnose::findings::reported_cause::items;
use crate::diagnose::findings::result::{Cause, Offered};
use crate::diagnose::fit::model::{Fitted, Mode, ModelUnderTest};
use crate::diagnose::fit::uncertainty::Uncertainty;
use crate::diagnose::run::Settings;
use crate::diagnose::search::baseline_friction::{BaselineFriction, reconsider};
use crate::diagnose::search::judge::{Accepted, adopt, chosen_of};
use crate::diagnose::search::search;
use crate::diagnose::windows::recording::Recording;
use crate::identify::ConsistentError;
use crate::model::PerturbableArm;

/// Data of a diagnosis and what is measured by.
#[derive(Clone, Copy)]
pub(in crate::diagnose) struct Session<'a> {
    pub(in crate::diagnose) plant: &'a dyn PerturbableArm,
    pub(in crate::diagnose) fit: &'a [Recording],
    pub(in crate::diagnose) validate: &'a [Recording],
    /// Whether these are logs of their own.
    pub(in crate::diagnose) own_validation: bool,
    /// Of the torques, per joint, N m.
    pub(in crate::diagnose) noise: &'a [f64],
    /// Torque errors due to errors of the recorded motion, per joint, N m.
    pub(in crate::diagnose) motion: &'a [f64],
    /// Error below which a model need not predict better, per joint, N m.
    pub(in crate::diagnose) ground: &'a [f64],
    /// Unit of a gain, per joint, N m.
    pub(in crate::diagnose) scale: &'a [f64],
    pub(in crate::diagnose) settings: &'a Settings,
    pub(in crate::diagnose) progress: &'a dyn Fn(&str),
}

/// The offered model, why, and what differs between the logs.
pub(in crate::diagnose) struct Choice<'a> {
    pub(in crate::diagnose) offered: Offered,
    pub(in crate::diagnose) why: Vec<String>,
    /// Joints, from 0, that one model does not predict on fitted and validating logs.
    pub(in crate::diagnose) changed: Vec<usize>,
    /// [`Diagnosis::file_holds`](crate::diagnose::findings::result::Diagnosis::file_holds).
    pub(in crate::diagnose) file_holds: bool,
    pub(in crate::diagnose) model: Selected<'a>,
}

/// Least share of a joint's squared error that a cause takes where it acts, if that is a part of a
/// log only: no other stretch can confirm it.
const LOCAL_SHARE: f64 = 0.25;

/// The fit inside what is possible; the accepted causes have its values.
fn inside(
    tested: &mut ModelUnderTest<'_>,
    accepted: &mut [Accepted],
    fitted: &Fitted,
) -> Result<Fitted, ConsistentError> {
    let mut chosen = chosen_of(accepted);
    let fitted = tested.possible(&mut chosen, fitted)?;
    adopt(accepted, &chosen);
    Ok(fitted)
}

/// A model of which everything holds.
pub(in crate::diagnose) struct Selected<'a> {
    pub(in crate::diagnose) tested: ModelUnderTest<'a>,
    pub(in crate::diagnose) accepted: Vec<Accepted>,
    pub(in crate::diagnose) fitted: Fitted,
    /// Errors on the validating data.
    pub(in crate::diagnose) after: Measured,
    /// The same on the fitted.
    pub(in crate::diagnose) after_fit: Measured,
    pub(in crate::diagnose) causes: Vec<Cause>,
    /// Errors on stretches of the fitted data that are left out in turn.
    pub(in crate::diagnose) left_out: LeftOut,
    /// Alternatives to plain friction.
    pub(in crate::diagnose) rivals: Vec<BaselineFriction>,
    /// Causes that left the model, and why: sentences.
    pub(in crate::diagnose) why: Vec<String>,
}

impl<'a> Session<'a> {
    fn tested(&self, mode: Mode) -> ModelUnderTest<'a> {
        let mut tested =
            ModelUnderTest::new(self.plant, self.fit, self.settings.rate, mode, &self.plant.delays(), false);
        tested.motion_error = self.motion.to_vec();
        tested
    }

    /// The model with all causes that hold.
    pub(in crate::diagnose) fn searched(&self, mode: Mode) -> Result<Selected<'a>, ConsistentError> {
        let mut tested = self.tested(mode);
        let accepted = search(&mut tested, self.noise, &self.settings.search, self.progress);
        self.select(tested, accepted)
    }

    /// All parameters refitted, and no further cause.
    pub(in crate::diagnose) fn plain(&self) -> Result<Selected<'a>, ConsistentError> {
        let mut tested = self.tested(Mode::Refitted);
        let fitted = fix_friction(&mut tested, &mut [], self.noise);
        let fitted = free_friction(&mut tested, &mut [], fitted);
        self.validated(tested, Vec::new(), fitted, Vec::new(), Vec::new())
    }

    /// The unchanged file.
    pub(in crate::diagnose) fn file(&self) -> Result<Selected<'a>, ConsistentError> {
        let mut tested = self.tested(Mode::Trusted);
        tested.frozen.iter_mut().for_each(|f| *f = true);
        let fitted = tested.fit(&mut []);
        self.validated(tested, Vec::new(), fitted, Vec::new(), Vec::new())
    }

    fn select(
        &self,
        mut tested: ModelUnderTest<'a>,
        mut accepted: Vec<Accepted>,
    ) -> Result<Selected<'a>, ConsistentError> {
        if accepted.iter().any(|a| a.chosen.cause.unit()) {
            let mut chosen = chosen_of(&accepted);
            tested.polish(&mut chosen);
            accepted.iter_mut().zip(chosen).for_each(|(a, c)| a.chosen = c);
        }
        let fitted = fix_friction(&mut tested, &mut accepted, self.noise);
        (self.progress)("what else plain friction might be");
        let (fitted, rivals) = reconsider(&mut tested, &mut accepted, fitted, self.noise, &self.settings.search);
        let fitted = drop_insignificant(&mut tested, &mut accepted, fitted, self.noise);
        let fitted = free_friction(&mut tested, &mut accepted, fitted);
        (self.progress)("what holds on stretches that were left out");
        let mut why = Vec::new();
        let fitted =
            backward_eliminate(self.plant, self.fit, &mut tested, &mut accepted, fitted, self.ground, &mut why);
        self.validated(tested, accepted, fitted, rivals, why)
    }

    /// Takes out what does not hold on data that were not used, and measures; all of it of the
    /// model inside what is possible.
    pub(super) fn validated(
        &self,
        mut tested: ModelUnderTest<'a>,
        mut accepted: Vec<Accepted>,
        mut fitted: Fitted,
        rivals: Vec<BaselineFriction>,
        why: Vec<String>,
    ) -> Result<Selected<'a>, ConsistentError> {
        for round in 0.. {
            (self.progress)("measuring on data that was not used");
            fitted = inside(&mut tested, &mut accepted, &fitted)?;
            let chosen = chosen_of(&accepted);
            let items = items(&tested, &accepted, &fitted);
            let [mut far, mut near] = [self.validate, self.fit].map(|data| Meter::new(self.plant, data, &tested));
            let after = far.of(&tested, &fitted, &chosen, true);
            let after_fit = near.of(&tested, &fitted, &chosen, false);
            let mut beside = Beside { session: self, far, near, after: &after, after_fit: &after_fit };
            let others: Vec<Without> = items.iter().map(|item| beside.without(&mut tested, &chosen, item)).collect();
            fitted = without(&mut tested, &mut accepted, &[]);
            fitted = inside(&mut tested, &mut accepted, &fitted)?;
            let weighing = Attribution {
                tested: &tested,
                fitted: &fitted,
                uncertainty: &Uncertainty::of(&tested, &fitted, &chosen_of(&accepted)),
                accepted: &accepted,
                rivals: &rivals,
                noise: self.noise,
                own_validation: self.own_validation,
                stretches: &tested.stretches(&chosen_of(&accepted)),
            };
            let causes: Vec<Cause> = items
                .iter()
                .zip(&others)
                .map(|(item, other)| {
                    let (with, on) = if other.near { (&after_fit, "fit") } else { (&after, "validate") };
                    weighing.attribute(item, [&other.measured, with], other.shares(), other.interval, on)
                })
                .collect();
            // A cause that loses on data that was not used is no cause, and not in the model.
            let holds = |i: usize| {
                let (without, with) = (&others[i].alike(&after), &after.steady);
                taken_of(without, with, self.scale) > 0.0 && matters(without, with, self.noise, self.motion)
            };
            // A cause that acts in a part of a log, or on joints that differ between the logs, must
            // still stand out beside everything else.
            let out = |i: usize| takes(&others[i].measured.rms, &after_fit.rms, self.settings.search.least_gain);
            let stands = |i: usize| match items[i].hypothesis.local() {
                true => others[i].within.is_some_and(|share| share >= LOCAL_SHARE) && !others[i].may_be_chance(),
                false => !others[i].differs(&items[i].place) || out(i),
            };
            let failed: Vec<usize> =
                (0..causes.len()).filter(|&i| if causes[i].on == "fit" { !stands(i) } else { !holds(i) }).collect();
            if failed.is_empty() || round >= 3 {
                let left_out = tested.possible_left_out(&chosen_of(&accepted), &fitted)?;
                return Ok(Selected { tested, accepted, fitted, after, after_fit, causes, left_out, rivals, why });
            }
            for &k in failed.iter().flat_map(|&i| &items[i].friction) {
                let which = if tested.mode == Mode::Refitted { &mut tested.quiet } else { &mut tested.frozen };
                which[k] = true;
            }
            let out: Vec<usize> = failed.iter().filter_map(|&i| items[i].accepted).collect();
            fitted = without(&mut tested, &mut accepted, &out);
        }
        unreachable!("the loop returns")
    }

    /// Choice of the offered model, by its predictions of stretches of the fitted logs that are
    /// left out in turn; and the reason. `models`: with the file's links, with all base parameters
    /// refitted, either or both; `file`: errors of the unchanged file.
    pub(in crate::diagnose) fn choose(
        &self,
        models: Vec<Selected<'a>>,
        file: &LeftOut,
        refitted: &Refit<'_>,
    ) -> Result<Choice<'a>, ConsistentError> {
        let refit = &refitted.left_out;
        let [mut believing, mut free] = [None, None];
        for model in models {
            match model.tested.mode {
                Mode::Trusted => believing = Some(model),
                Mode::Refitted => free = Some(model),
            }
        }
        let mut said = Vec::new();
        // Of two models that are as good the one with fewer unknowns.
        if let Some(all) = free.take_if(|f| !f.accepted.is_empty() && !f.left_out.less(refit, self.ground).sure()) {
            said.push(self.says(
                "a plain refit predicts as well as one with further causes, or better",
                refit,
                &all.left_out,
            ));
            free = Some(self.plain()?);
        }
        let mut model = self.better_links(believing, free, refitted, &mut said)?;
        let refitted = model.tested.mode == Mode::Refitted;
        let changed = refitted || !model.accepted.is_empty() || model.tested.frozen.iter().any(|f| !f);
        let mut offered = match (changed, refitted && model.accepted.is_empty()) {
            (false, _) => Offered::File,
            (_, true) => Offered::Refitted,
            _ => Offered::Extended,
        };
        // No other part can predict a cause that acts in one part of a log; it must only stand out
        // there.
        let local = model.accepted.iter().any(|a| a.chosen.cause.local());
        if changed && !local && !model.left_out.less(file, self.ground).sure() {
            said.push(self.says("nothing predicts surely better than the unchanged file", &model.left_out, file));
            let why = std::mem::take(&mut model.why);
            (offered, model) = (Offered::File, Selected { why, ..self.file()? });
        } else if let Some((file, sentence)) = self.holding_file(changed, &model)? {
            let differ = self.changed(&model, self.noise);
            said.push(sentence);
            let mut why = std::mem::take(&mut model.why);
            why.extend(said);
            return Ok(Choice { offered: Offered::File, why, changed: differ, file_holds: true, model: file });
        } else if changed {
            let what = match offered {
                Offered::Extended => "the extended model predicts better than the file",
                _ => "the refitted file predicts better than the unchanged file",
            };
            said.push(self.says(what, &model.left_out, file));
        }
        let mut why = std::mem::take(&mut model.why);
        why.extend(said);
        let changed = if self.own_validation { self.changed(&model, self.noise) } else { Vec::new() };
        Ok(Choice { offered, why, changed, file_holds: false, model })
    }

    /// The unchanged file and a sentence, where it errs less over all joints on every validating
    /// log than a model for which the fitted logs ask. (One joint that a model makes worse beside
    /// others that it halves is a matter of that joint's causes.)
    fn holding_file(
        &self,
        changed: bool,
        model: &Selected<'a>,
    ) -> Result<Option<(Selected<'a>, String)>, ConsistentError> {
        if !changed || !self.own_validation {
            return Ok(None);
        }
        let file = self.file()?;
        if !self.worse_as_a_whole(model, &self.by_log_of(&file)) {
            return Ok(None);
        }
        let gap = |j: &usize| (model.after.steady[*j] - file.after.steady[*j]) / self.scale[*j];
        let joint = (0..self.scale.len()).max_by(|a, b| gap(a).total_cmp(&gap(b))).unwrap_or(0);
        let [here, there] = [&file, model].map(|m| evidence::short(m.after.steady[joint]));
        let sentence = format!(
            "The fitted logs ask for another model, but the unchanged file errs less than it on every validating log \
             (joint {}: {here} N m against {there}), so the file is offered. Either something changed between the logs, or the \
             fitted ones show too little.",
            joint + 1
        );
        Ok(Some((file, sentence)))
    }

    /// The file's links with further causes, or all base parameters refitted with further causes.
    fn better_links(
        &self,
        believing: Option<Selected<'a>>,
        free: Option<Selected<'a>>,
        refit: &Refit<'_>,
        said: &mut Vec<String>,
    ) -> Result<Selected<'a>, ConsistentError> {
        Ok(match (believing, free) {
            (Some(few), Some(all)) if all.left_out.less(&few.left_out, self.ground).worth_refit() => {
                said.push(self.says(
                    "all base parameters refitted predict better than the file's links with further causes",
                    &all.left_out,
                    &few.left_out,
                ));
                all
            }
            (Some(few), Some(all))
                if self.worse_than(&few, refit) && !few.left_out.less(&all.left_out, self.ground).sure() =>
            {
                said.push(self.says(
                    "all base parameters refitted predict as well as the file's links with further causes, and err less on a validating log",
                    &all.left_out,
                    &few.left_out,
                ));
                all
            }
            (Some(few), _) => few,
            (None, Some(all)) => all,
            (None, None) => self.file()?,
        })
    }

    fn says(&self, what: &str, a: &LeftOut, b: &LeftOut) -> String {
        let (paired, joint) = (a.less(b, self.ground), a.most_changed(b, self.ground));
        // The gain is a difference by a sum: 2 g / (1 + g) by the other's square.
        let percent = |g: f64| 200.0 * g.clamp(-0.9, 1.0) / (1.0 + g.clamp(-0.9, 1.0));
        let sense = if paired.gain < 0.0 { "more" } else { "less" };
        let one = if paired.gain < 0.0 { -1.0 } else { 1.0 };
        let ends = [-one, one].map(|side| one * percent(paired.gain + side * paired.error));
        let (of, whole) =
            ([a, b].map(|m| evidence::short(m.joint_rms(joint))), [a, b].map(|m| evidence::short(m.rms())));
        format!(
            "On stretches of the fitted logs that were left out in turn {what}. The error of joint {}, which differs most, is {} N m against {} N m; \
             over all joints (RMS) it is {} N m against {} N m. With every joint counting alike its square is {:.0} ({:.0} to {:.0}) % {sense}.",
            joint + 1,
            of[0],
            of[1],
            whole[0],
            whole[1],
            percent(paired.gain).abs(),
            ends[0],
            ends[1],
        )
    }
}
