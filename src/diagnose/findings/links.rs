//! Reports wrong links and rotors as causes, when all base parameters are refitted.

use super::attribution::MOST_MARGIN;
use super::calibration;
use super::evidence;
use super::result::{Cause, measured_on};
use crate::diagnose::fit::model::{Chosen, Mode, ModelUnderTest, inertial, local};
use crate::diagnose::fit::moments::Solution;
use crate::diagnose::fit::uncertainty::{Uncertainty, parameters};
use crate::diagnose::hypotheses::{Hypothesis, Named, Quantity, laws};
use crate::diagnose::search::equivalent_robot_cause;
use crate::diagnose::search::judge::chosen_of;
use crate::diagnose::search::merge_bodies::single_bodies;
use crate::diagnose::select::measure::{Measured, Meter, bootstrap, matters, share, taken_of};
use crate::diagnose::select::model_choice::{LeftOut, Paired};
use crate::diagnose::select::offer::Rival;
use crate::diagnose::select::refine_and_select::{Selected, Session};
use crate::model::{DriveTerm, StandardParameter};
use crate::numerics::sums::root_mean_square;
use dh_codegen::robot::{EffectKind, effects};

/// Share of the gain of all refitted links on left-out stretches that a single body must reach to
/// be reported instead.
pub(in crate::diagnose) const ONE_BODY: f64 = 0.85;

/// Least probability for one of many refitted links to be named: the refit has all of them.
const LIKELY: f64 = 0.5;

/// A single body that replaces the refitted links.
struct Body {
    cause: &'static str,
    joints: Vec<usize>,
    parameters: Vec<Quantity>,
    /// Share of the refitted links' gain on left-out stretches.
    share: f64,
}

impl Session<'_> {
    /// Causes for base parameters that differ from the file's, where the file's links with
    /// everything else that was found are worse. Their probability is limited by that of their
    /// model against the best model of the file's links, which has causes of its own.
    pub(in crate::diagnose) fn links(&self, model: &Selected<'_>, rival: Option<&Rival>) -> Vec<Cause> {
        let mut causes = self.other_links(model);
        if let Some(rival) = rival {
            causes.iter_mut().for_each(|cause| no_surer(cause, rival));
        }
        causes.retain(|cause| cause.probability >= calibration::NAMED_BY_SIZE);
        causes
    }

    fn other_links(&self, model: &Selected<'_>) -> Vec<Cause> {
        let [links, rotors] = evidence::changed_links(&model.tested, &model.fitted, &model.fitted.covariance());
        if links.is_empty() && rotors.is_empty() {
            return Vec::new();
        }
        // Fit the file's links with all other causes.
        let delays = &model.tested.scene.delays;
        let mut believed = ModelUnderTest::new(self.plant, self.fit, self.rate(), Mode::Trusted, delays, false);
        believed.frozen = model.tested.frozen.clone();
        let mut others = chosen_of(&model.accepted);
        let trusting = believed.fit(&mut others);
        let without = Meter::new(self.plant, self.validate, &believed).of(&believed, &trusting, &others, true);
        let after = &model.after;
        let known = believed.left_out(&others, &trusting);
        let refit = model.left_out.less(&known, self.ground);
        // The refit has to pay like any other model.
        let gains = taken_of(&without.steady, &after.steady, self.scale) > 0.0;
        if !(refit.worth_refit(0) && gains && matters(&without.steady, &after.steady, self.noise, self.motion)) {
            return Vec::new();
        }
        let rotors = self.needed(model, &rotors, true);
        let mut causes: Vec<Cause> = rotors.iter().map(|(j, gain)| self.rotor(model, &without, *j, *gain)).collect();
        if links.is_empty() {
            return causes;
        }
        let [missed, now] = [&without, after].map(|m| evidence::short(root_mean_square(&m.rms)));
        let on = measured_on("validate", self.own_validation);
        let figures = format!(
            "with the file's own and everything else that was found {missed} N m are missed on {on} (RMS over joints), with these {now} N m"
        );
        if let Some(body) = self.one_body(&mut believed, &others, &known, refit.gain) {
            let evidence = format!(
                "one body says {:.0} % of what other base parameters of {} gain on stretches that were left out; {figures}",
                100.0 * body.share.min(1.0),
                of_joints(&links)
            );
            causes.push(Cause {
                cause: body.cause,
                joints: body.joints,
                parameters: body.parameters,
                probability: calibration::links(refit.gain, refit.error),
                evidence,
                ..self.refitted(model, &without)
            });
            return causes;
        }
        let link = |(j, gain): (usize, Paired)| Cause {
            joints: vec![j],
            probability: calibration::links(gain.gain, gain.error),
            evidence: format!(
                "base parameters of link {j} differ from the file's by more than five of their standard deviations, and the file's beside \
                 all others lose {:.0} +- {:.0} % of the squared error on stretches that were left out; all changed links together: {figures}",
                200.0 * gain.gain,
                200.0 * gain.error
            ),
            ..self.refitted(model, &without)
        };
        causes.extend(self.needed(model, &links, false).into_iter().map(link));
        causes
    }

    /// Links or rotors (joints, from 1) that a refit needs, with the gain of each.
    fn needed(&self, model: &Selected<'_>, joints: &[usize], rotor: bool) -> Vec<(usize, Paired)> {
        let likely = |gain: &Paired| gain.gain > 0.0 && calibration::links(gain.gain, gain.error) >= LIKELY;
        let all = joints.iter().map(|&j| (j, self.without_changes(model, j, rotor)));
        all.filter(|(_, gain)| likely(gain)).collect()
    }

    /// Gain of a refit on left-out stretches over the same with the file's base parameters of one
    /// joint's link, or rotor (`j`, from 1).
    fn without_changes(&self, model: &Selected<'_>, j: usize, rotor: bool) -> Paired {
        let (plant, fitted) = (model.tested.plant, &model.fitted);
        let (base, row) = (plant.base_parameters(), plant.rows()[j - 1]);
        let own = |leader: StandardParameter| match leader {
            StandardParameter::Link(of, _) => !rotor && of == row,
            StandardParameter::Drive(of, _) => rotor && of == row,
            _ => false,
        };
        let chosen = chosen_of(&model.accepted);
        let stretches = model.tested.stretches(fitted);
        let (counts, local) = (stretches.counts(), local(&chosen, fitted));
        let (mut file, mut fixed) = (fitted.solution.clone(), local.clone());
        for (at, b) in inertial(plant).into_iter().enumerate().filter(|(_, b)| own(base[*b].leader)) {
            let given = |i: &usize| plant.given().map_or(0.0, |g| g[*i]);
            file.x[at] = base[b].coefficients.iter().map(|(i, k)| k * given(i)).sum();
            fixed.push(at);
        }
        let of = |solution: &Solution, fixed: &[usize]| {
            LeftOut::new(&stretches.cross_validated_without(solution, &[], fixed), &counts)
        };
        of(&fitted.solution, &local).less(&of(&file, &fixed), self.ground)
    }

    /// Common part of all causes of refitted parameters.
    fn refitted(&self, model: &Selected<'_>, without: &Measured) -> Cause {
        Cause {
            support: MOST_MARGIN,
            margin: MOST_MARGIN,
            share: share(&without.rms, &model.after.rms, self.noise, &[]),
            interval: bootstrap(without, &model.after, &[]),
            rms_before: without.rms.clone(),
            rms_after: model.after.rms.clone(),
            on: "validate",
            ..Cause::blank(effects::LinkInertiaError::NAME, "an exciting motion for the base parameters")
        }
    }

    /// The rotor of joint `j` (from 1) as a cause: the file has another value, or none.
    fn rotor(&self, model: &Selected<'_>, without: &Measured, j: usize, gain: Paired) -> Cause {
        let plant = model.tested.plant;
        let rotor = StandardParameter::Drive(plant.rows()[j - 1], DriveTerm::IA);
        let at = plant.standard_parameters().iter().position(|p| *p == rotor);
        let value = at.and_then(|at| model.tested.scene.standard.as_ref().map(|s| s[at])).unwrap_or(0.0);
        Cause {
            cause: effects::RotorInertia::NAME,
            probability: calibration::links(gain.gain, gain.error),
            joints: vec![j],
            parameters: vec![Named::new(effects::RotorInertia::IA, value, None).of_joint(Some(j))],
            evidence: format!(
                "joint {j}: beside {} the torque has a part in proportion to the joint's own acceleration, {} kg m^2, that the file lacks or has otherwise",
                if plant.has_bodies() { "other links" } else { "friction" },
                evidence::short(value)
            ),
            ..self.refitted(model, without)
        }
    }

    /// The body that explains nearly as much as the refitted links, if there is one. `known`:
    /// errors with the file's links; `gain`: gain of the refit over them.
    fn one_body(
        &self,
        believed: &mut ModelUnderTest<'_>,
        others: &[Chosen],
        known: &LeftOut,
        gain: f64,
    ) -> Option<Body> {
        let mut best: Option<(f64, Vec<Chosen>)> = None;
        let laws: Vec<&'static dyn Hypothesis> = laws(EffectKind::LinkInertiaError).collect();
        for body in single_bodies(believed, &laws) {
            let mut trial = others.to_vec();
            trial.push(body);
            let fitted = believed.fit(&mut trial);
            let gained = believed.left_out(&trial, &fitted).less(known, self.ground).gain;
            if best.as_ref().is_none_or(|b| gained > b.0) {
                best = Some((gained, trial));
            }
        }
        let (gained, mut trial) = best.filter(|(gained, _)| *gained >= ONE_BODY * gain)?;
        let fitted = believed.fit(&mut trial);
        let (body, index) = (trial.last()?, trial.len() - 1);
        let uncertainty = Uncertainty::of(believed, &fitted, &trial);
        let found = parameters(believed, &fitted, &uncertainty, index, body);
        let named = equivalent_robot_cause(believed, body, &fitted.terms[index]);
        let cause = named.as_ref().unwrap_or(body);
        let joints: Vec<usize> = cause.place.iter().map(|j| j + 1).collect();
        let parameters = found.into_iter().map(|key| key.of_joint(joints.first().copied())).collect();
        Some(Body { cause: cause.cause.name(), joints, parameters, share: gained / gain })
    }
}

/// Limits the probability of a refitted link to that of all of them being better than the file's
/// links with other causes. Names those causes beside it.
fn no_surer(cause: &mut Cause, rival: &Rival) {
    let Rival { gain, causes: rivals, .. } = rival;
    let better = calibration::links(gain.gain, gain.error);
    if better >= cause.probability {
        return;
    }
    cause.probability = better;
    let mut names: Vec<&'static str> = rivals.iter().map(|r| r.cause).filter(|name| *name != cause.cause).collect();
    names.extend(cause.not_distinguished_from.iter());
    names.sort_unstable();
    names.dedup();
    cause.not_distinguished_from = names;
    let of = |r: &Cause| {
        if r.joints.is_empty() { r.cause.to_string() } else { format!("{} of {}", r.cause, of_joints(&r.joints)) }
    };
    let others: Vec<String> = rivals.iter().map(of).collect();
    cause.evidence += &format!(
        "; the file's links with {} err {:.0} +- {:.0} % of the squared error more on stretches that were left out",
        if others.is_empty() { "nothing else".to_string() } else { others.join(", ") },
        200.0 * gain.gain,
        200.0 * gain.error
    );
}

/// Joints in words: `joint 3`, `joints 3, 4`.
fn of_joints(joints: &[usize]) -> String {
    let numbers: Vec<String> = joints.iter().map(usize::to_string).collect();
    format!("joint{} {}", if joints.len() > 1 { "s" } else { "" }, numbers.join(", "))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cause(name: &'static str, joints: &[usize], probability: f64) -> Cause {
        Cause { joints: joints.to_vec(), probability, ..Cause::blank(name, "") }
    }

    /// A model with refitted links that errs hardly less than one of the file's links with a
    /// spring. The link is no more certain than that model, and the spring is named beside it.
    #[test]
    fn a_link_is_no_surer_than_its_model() {
        let rival = |gain: f64| Rival {
            gain: Paired { gain, error: 0.04, whole: true },
            causes: vec![cause("joint_elasticity", &[1], 0.7), cause("payload", &[], 0.3)],
            left_out: LeftOut::new(&[], &[]),
        };
        let capped = |rival: &Rival| {
            let mut link = cause("link_inertia_error", &[2], 0.95);
            no_surer(&mut link, rival);
            link
        };
        let doubtful = capped(&rival(0.12));
        assert!((doubtful.probability - 0.2).abs() < 1e-12);
        assert_eq!(doubtful.not_distinguished_from, ["joint_elasticity", "payload"]);
        assert!(
            doubtful.evidence.contains("joint_elasticity of joint 1, payload err 24 +- 8 %"),
            "{}",
            doubtful.evidence
        );
        assert!((capped(&rival(-0.2)).probability).abs() < 1e-12);
        let sure = capped(&rival(1.2));
        assert!(sure.probability == 0.95 && sure.not_distinguished_from.is_empty());
    }
}
