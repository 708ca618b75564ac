//! Selects the offered model: the file's links with further causes, all base parameters refitted,
//! or the unchanged file.

use super::contenders::Refit;
use super::excess::WORSE;
use super::measure::{taken_of, takes};
use super::model_choice::{LeftOut, Paired};
use super::refine_and_select::{Selected, Session};
use super::remark::Remark;
use crate::diagnose::findings::evidence;
use crate::diagnose::findings::result::{Cause, Offered};
use crate::diagnose::fit::model::Mode;
use crate::identify::ConsistentError;

/// The offered model, the reasons for it, and the joints that differ between the logs.
pub(in crate::diagnose) struct Choice<'a> {
    pub(in crate::diagnose) offered: Offered,
    pub(in crate::diagnose) why: Vec<Remark>,
    /// Joints, from 0, that no single model predicts on both fitted and validating logs.
    pub(in crate::diagnose) changed: Vec<usize>,
    /// See [`Diagnosis::file_holds`](crate::diagnose::findings::result::Diagnosis::file_holds).
    pub(in crate::diagnose) file_holds: bool,
    pub(in crate::diagnose) model: Selected<'a>,
    /// The best model of the file's links, if the offered one has other links.
    pub(in crate::diagnose) rival: Option<Rival>,
}

/// The best model of the file's links, beside one with other links.
pub(in crate::diagnose) struct Rival {
    /// Gain of the model with other links over this one on left-out stretches.
    pub(in crate::diagnose) gain: Paired,
    pub(in crate::diagnose) causes: Vec<Cause>,
    /// Its errors on left-out stretches.
    pub(in crate::diagnose) left_out: LeftOut,
}

impl Rival {
    /// Whether this model has a cause of single joints, and predicts each of them at least as well
    /// as one with the errors `other`. Other links then explain nothing there that the cause does not.
    /// A push counts on the joints that it eases: links that were fitted to it seem to explain it,
    /// but not where they are fitted to other stretches.
    pub(in crate::diagnose) fn suffices(&self, cause: &Cause, other: &LeftOut) -> bool {
        let joints = if cause.window().is_some() { eased(cause) } else { cause.joints.clone() };
        let as_well = |j: &usize| self.left_out.joint_rms(j - 1) <= other.joint_rms(j - 1);
        !joints.is_empty() && joints.iter().all(as_well) && self.causes.iter().any(|c| c.is(cause))
    }
}

/// Least share of a joint's squared error that a push removes from a joint that it eases.
const EASED: f64 = 0.25;

/// Joints, from 1, on which a push explains a considerable part of the error.
fn eased(push: &Cause) -> Vec<usize> {
    let pairs = push.rms_before.iter().zip(&push.rms_after).enumerate();
    pairs.filter(|(_, (before, after))| takes(&[**before], &[**after], EASED)).map(|(j, _)| j + 1).collect()
}

/// Which of the nested models this one is.
fn offer(model: &Selected<'_>) -> Offered {
    let refitted = model.tested.mode == Mode::Refitted;
    let changed = refitted || !model.accepted.is_empty() || model.tested.frozen.iter().any(|f| !f);
    match (changed, refitted && model.accepted.is_empty()) {
        (false, _) => Offered::File,
        (_, true) => Offered::Refitted,
        _ => Offered::Extended,
    }
}

impl<'a> Session<'a> {
    /// Chooses the offered model by its predictions of stretches of the fitted logs that are left
    /// out in turn. `models`: with the file's links, with all base parameters refitted, either or
    /// both; `file`: errors of the unchanged file. Returns the choice with its reasons.
    pub(in crate::diagnose) fn choose(
        &self,
        models: Vec<Selected<'a>>,
        file: &LeftOut,
        refitted: &Refit,
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
        // Prefer, of two equally good models, the one with fewer unknowns.
        if let Some(all) = free.take_if(|f| !f.accepted.is_empty() && !self.pays(f, refit, &refitted.errors.moving)) {
            said.push(self.says(
                "a plain refit predicts as well as one with further causes, or better",
                refit,
                &all.left_out,
            ));
            free = Some(self.plain()?);
        }
        let mut models = self.by_preference(believing, free, refitted, &mut said);
        let unchanged = self.file()?;
        // A local cause cannot be confirmed by other parts of the logs; it need only stand out in
        // its own.
        let local = |m: &Selected<'_>| m.accepted.iter().any(|a| a.chosen.cause.local());
        let pays = |m: &Selected<'_>| local(m) || self.pays(m, file, &unchanged.after.steady);
        let Some(at) = models.iter().position(|m| offer(m) != Offered::File && pays(m)) else {
            return Ok(self.unchanged(unchanged, models.into_iter().next(), file, said));
        };
        let mut model = models.swap_remove(at);
        let offered = offer(&model);
        let rival = self.rival(&model, &models);
        if let Some(sentence) = self.holding(&unchanged, &model) {
            let differ = self.changed(&model, self.noise);
            said.push(sentence.into());
            let mut why = std::mem::take(&mut model.why);
            why.extend(said);
            return Ok(Choice {
                offered: Offered::File,
                why,
                changed: differ,
                file_holds: true,
                model: unchanged,
                rival: None,
            });
        }
        let what = match offered {
            Offered::Extended => "the extended model predicts better than the file",
            _ => "the refitted file predicts better than the unchanged file",
        };
        said.push(self.says(what, &model.left_out, file));
        let mut why = std::mem::take(&mut model.why);
        why.extend(said);
        let changed = if self.own_validation { self.changed(&model, self.noise) } else { Vec::new() };
        Ok(Choice { offered, why, changed, file_holds: false, model, rival })
    }

    /// The best model of the file's links, if the chosen one has other links.
    fn rival(&self, model: &Selected<'_>, others: &[Selected<'_>]) -> Option<Rival> {
        let refitted = model.tested.mode == Mode::Refitted;
        let other = others.iter().find(|m| refitted && m.tested.mode == Mode::Trusted)?;
        let gain = model.left_out.less(&other.left_out, self.ground);
        Some(Rival { gain, causes: other.causes.clone(), left_out: other.left_out.clone() })
    }

    /// The choice of the unchanged file, because the `best` other model does not pay beside it.
    fn unchanged(
        &self,
        model: Selected<'a>,
        best: Option<Selected<'a>>,
        file: &LeftOut,
        said: Vec<Remark>,
    ) -> Choice<'a> {
        let mut why = Vec::new();
        if let Some(best) = best {
            let changed = offer(&best) != Offered::File;
            let sentence = || {
                self.says("nothing predicts surely better than the unchanged file, nor better here and on the validating data", &best.left_out, file)
            };
            let sentence = changed.then(sentence);
            why.extend(best.why.into_iter().chain(said).chain(sentence));
        } else {
            why.extend(said);
        }
        let changed = if self.own_validation { self.changed(&model, self.noise) } else { Vec::new() };
        Choice { offered: Offered::File, why, changed, file_holds: false, model, rival: None }
    }

    /// Whether a model pays beside a simpler one. It must be significantly better on left-out
    /// stretches of the fitted logs, or not worse there and better on the validating data.
    /// `simpler` and `validated` are the simpler model's errors there; the latter where joints
    /// move, N m.
    fn pays(&self, model: &Selected<'_>, simpler: &LeftOut, validated: &[f64]) -> bool {
        let paired = model.left_out.less(simpler, self.ground);
        paired.sure() || paired.gain > 0.0 && taken_of(validated, &model.after.steady, self.scale) > WORSE
    }

    /// A sentence if the unchanged file errs less over all joints on every validating log than the
    /// model that the fitted logs support. One joint that a model makes worse beside others that it
    /// halves is decided by that joint's causes.
    fn holding(&self, file: &Selected<'a>, model: &Selected<'a>) -> Option<String> {
        if !self.own_validation || !self.worse_as_a_whole(model, &self.by_log_of(file)) {
            return None;
        }
        let gap = |j: &usize| (model.after.steady[*j] - file.after.steady[*j]) / self.scale[*j];
        let joint = (0..self.scale.len()).max_by(|a, b| gap(a).total_cmp(&gap(b))).unwrap_or(0);
        let [here, there] = [file, model].map(|m| evidence::short(m.after.steady[joint]));
        let sentence = format!(
            "The fitted logs ask for another model, but the unchanged file errs less than it on every validating log \
             (joint {}: {here} N m against {there}), so the file is offered. Either something changed between the logs, or the \
             fitted ones show too little.",
            joint + 1
        );
        Some(sentence)
    }

    /// Models in order of preference: the file's links with further causes, and all base parameters
    /// refitted with further causes. Only one remains where the other does not pay.
    fn by_preference(
        &self,
        believing: Option<Selected<'a>>,
        free: Option<Selected<'a>>,
        refit: &Refit,
        said: &mut Vec<Remark>,
    ) -> Vec<Selected<'a>> {
        match (believing, free) {
            (Some(few), Some(all)) if all.left_out.less(&few.left_out, self.ground).worth_refit(few.causes.len()) => {
                let count = few.causes.len();
                said.push(self.says(
                    &format!(
                        "all base parameters refitted are better than the file's links with further causes ({count})"
                    ),
                    &all.left_out,
                    &few.left_out,
                ));
                vec![all, few]
            }
            (Some(few), Some(all)) if self.worse_throughout(&few, refit) => {
                said.push(
                    "On every validating log the file with further causes errs a tenth more than a refit, and more than the \
                     unchanged file, so the refit goes before it: the fitted logs show too little, or something changed \
                     between the logs."
                        .to_string()
                        .into(),
                );
                vec![all, few]
            }
            (Some(few), Some(all))
                if self.worse_than(&few, refit) && !few.left_out.less(&all.left_out, self.ground).sure() =>
            {
                said.push(self.says(
                    "all base parameters refitted predict as well as the file's links with further causes, and err less on a validating log",
                    &all.left_out,
                    &few.left_out,
                ));
                vec![all, few]
            }
            (believing, free) => believing.or(free).into_iter().collect(),
        }
    }

    fn says(&self, what: &str, a: &LeftOut, b: &LeftOut) -> Remark {
        let (paired, joint) = (a.less(b, self.ground), a.most_changed(b, self.ground));
        // The gain g is a difference by a sum: 2 g / (1 + g) relative to the other's square.
        let percent = |g: f64| 200.0 * g.clamp(-0.9, 1.0) / (1.0 + g.clamp(-0.9, 1.0));
        let sense = if paired.gain < 0.0 { "more" } else { "less" };
        let one = if paired.gain < 0.0 { -1.0 } else { 1.0 };
        let ends = [-one, one].map(|side| one * percent(paired.gain + side * paired.error));
        let (of, whole) =
            ([a, b].map(|m| evidence::short(m.joint_rms(joint))), [a, b].map(|m| evidence::short(m.rms())));
        format!(
            "On stretches of the fitted logs that were left out in turn {what}. The error of joint {}, which differs most, is {} N m against {} N m; \
             over all joints (RMS) it is {} N m against {} N m. With all joints weighted alike the squared error is {:.0} % ({:.0} to {:.0} %) {sense}.",
            joint + 1,
            of[0],
            of[1],
            whole[0],
            whole[1],
            percent(paired.gain).abs(),
            ends[0],
            ends[1],
        )
        .into()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnose::hypotheses::Named;
    use dh_codegen::robot::effects;

    /// The file's links with an offset of joint 2 predict that joint better than other links do.
    #[test]
    fn other_links_hide_nothing_that_the_files_links_predict_as_well() {
        let errors = |squares: [f64; 2]| LeftOut::new(&[squares.to_vec()], &[vec![1.0; 2]]);
        let cause = |name: &'static str, joints: &[usize]| Cause { joints: joints.to_vec(), ..Cause::blank(name, "") };
        let rival = Rival {
            gain: Paired { gain: 0.2, error: 0.1, whole: true },
            causes: vec![cause("torque_offset", &[2]), cause("payload", &[])],
            left_out: errors([4.0, 1.0]),
        };
        let offset = cause("torque_offset", &[2]);
        assert!(rival.suffices(&offset, &errors([1.0, 1.1])) && !rival.suffices(&offset, &errors([1.0, 0.9])));
        assert!(!rival.suffices(&cause("viscous_friction", &[2]), &errors([1.0, 1.1])), "not in that model");
        assert!(!rival.suffices(&cause("payload", &[]), &errors([9.0, 9.0])), "no joint of its own");
    }

    /// A push that eases joint 2 stands where other links predict that joint worse.
    #[test]
    fn other_links_hide_no_push_that_they_do_not_predict() {
        let errors = |squares: [f64; 2]| LeftOut::new(&[squares.to_vec()], &[vec![1.0; 2]]);
        let keys = [(effects::ExternalContact::START, 1.0), (effects::ExternalContact::END, 2.0)];
        let push = |rms_after: [f64; 2]| Cause {
            keys: keys.map(|(key, at)| Named::new(key, at, None)).to_vec(),
            rms_before: vec![2.0, 2.0],
            rms_after: rms_after.to_vec(),
            ..Cause::blank(effects::ExternalContact::NAME, "")
        };
        let gain = Paired { gain: 0.2, error: 0.1, whole: true };
        let rival = Rival { gain, causes: vec![push([1.9, 1.0])], left_out: errors([4.0, 1.0]) };
        assert!(rival.suffices(&push([1.9, 1.0]), &errors([1.0, 1.1])));
        assert!(!rival.suffices(&push([1.9, 1.0]), &errors([1.0, 0.9])), "other links predict joint 2 better");
        assert!(!rival.suffices(&push([1.9, 1.8]), &errors([9.0, 9.0])), "it eases no joint");
    }
}
