//! Converts accepted causes and their measured errors to reported causes with probabilities, and
//! lists the causes that cannot be separated from them.

use super::calibration::{self, Change, Features};
use super::evidence;
use super::evidence::Shown;
use super::maps::View;
use super::reported_cause::{Item, friction_values, place_of};
use super::result::{Cause, Curve, Refutation, measured_on};
use crate::diagnose::fit::body_limits::Body;
use crate::diagnose::fit::model::{Chosen, Fitted, ModelUnderTest, given_friction};
use crate::diagnose::fit::moments::Moments;
use crate::diagnose::fit::uncertainty::{Uncertainty, parameters};
use crate::diagnose::hypotheses::{Hypothesis as _, Kind, Named, PLAIN, Quantity};
use crate::diagnose::search::alone::is_brief;
use crate::diagnose::search::baseline_friction::BaselineFriction;
use crate::diagnose::search::driving_friction::friction_drives;
use crate::diagnose::search::forward::Evidence;
use crate::diagnose::search::judge::{Accepted, chosen_of};
use crate::diagnose::search::over_all_joints::pays_over_all;
use crate::diagnose::select::beside::Shares;
use crate::diagnose::select::measure::{Figures, Measured, share, taken_of};
use dh_codegen::robot::effects::{LinkInertiaError, Payload};
use dh_codegen::robot::{EffectKind, effects};

/// A model whose causes are assigned probabilities.
pub(in crate::diagnose) struct Attribution<'a> {
    pub(in crate::diagnose) tested: &'a ModelUnderTest<'a>,
    pub(in crate::diagnose) fitted: &'a Fitted,
    pub(in crate::diagnose) uncertainty: &'a Uncertainty,
    pub(in crate::diagnose) accepted: &'a [Accepted],
    /// Alternatives to plain friction.
    pub(in crate::diagnose) rivals: &'a [BaselineFriction],
    pub(in crate::diagnose) noise: &'a [f64],
    /// Whether the validating data are separate logs.
    pub(in crate::diagnose) own_validation: bool,
    /// The equations in stretches of one piece each.
    pub(in crate::diagnose) stretches: &'a Moments,
    /// Evidence of the search that started from the unchanged file.
    pub(in crate::diagnose) evidence: &'a [Evidence],
}

impl Attribution<'_> {
    /// Converts an item to a reported cause, from the errors without it and with it, `on` the
    /// fitted logs (`fit`) or the validating ones (`validate`).
    pub(in crate::diagnose) fn attribute(
        &self,
        item: &Item,
        [without, with]: [&Figures; 2],
        shares: Shares,
        interval: [f64; 2],
        on: &'static str,
    ) -> Cause {
        let Self { tested, fitted, uncertainty, accepted: all, rivals: plain_rivals, noise, .. } = *self;
        let keys = self.keys(item);
        let of_joint = |key: &Named| key.of_joint(item.place.first().map(|j| j + 1));
        let parameters: Vec<Quantity> = keys.iter().map(of_joint).collect();
        let accepted = item.accepted.map(|a| &all[a]);
        let near = near(item, accepted, plain_rivals);
        let margin = near.iter().map(|r| r.2.max(0.0)).fold(MOST_MARGIN, f64::min);
        let part = shares.within.unwrap_or_else(|| share(&without.steady, &with.steady, noise, &item.place));
        let support =
            accepted.map_or_else(|| plain_support(fitted, &uncertainty.covariance, &item.friction), |a| a.support);
        let recurrence = self.recurrence(item, &keys);
        let pays = item.hypothesis.within_links() && pays_over_all(&without.steady, &with.steady, noise);
        let confirmed = on != "fit" && (part > SHOWN || pays) || item.hypothesis.local() || shares.recurs_far();
        let rivals = confusable(tested, item, accepted, plain_rivals);
        let refuted = self.refutation(item, accepted, (part, pays, on), shares);
        let features = Features { support, margin, share: shares.counted(part), recurrence, confirmed };
        Cause {
            joints: item.place.iter().map(|j| j + 1).collect(),
            probability: self.probability(item, &features, refuted),
            shape: accepted.map_or_else(Vec::new, |a| a.chosen.shape.clone()),
            refuted,
            support,
            margin,
            share: part,
            recurrence,
            evidence: evidence::sentence(&Shown {
                cause: item.hypothesis,
                shape: accepted.map(|a| a.chosen.shape.as_slice()),
                place: &item.place,
                parameters: &parameters,
                all: [&without.rms, &with.rms],
                moving: [&without.steady, &with.steady],
                noise,
                on: measured_on(on, self.own_validation),
                confirmed: accepted.map(|a| a.confirmed),
                repeats: shares.repeats,
            }) + &self.notes(item, near),
            curve: item.accepted.and_then(|index| evidence::curve(tested, fitted, index, &all[index].chosen)),
            parameters,
            keys,
            interval,
            rms_before: without.rms.clone(),
            rms_after: with.rms.clone(),
            on,
            decided_by: self.decided_by(item, &rivals),
            not_distinguished_from: rivals,
            shown_by: item.hypothesis.shown_by(),
            ..Cause::of_effect(item.hypothesis.effect())
        }
    }
}

impl Attribution<'_> {
    /// What refutes a cause, from the share (`part`) of its joints' error that it removes `on` some
    /// data, whether a body pays over all joints there, whether its joint is worse there than with
    /// the unchanged file, and whether it removes next to nothing there.
    fn refutation(
        &self,
        item: &Item,
        accepted: Option<&Accepted>,
        (part, pays, on): (f64, bool, &str),
        shares: Shares,
    ) -> Option<Refutation> {
        let throughout = !item.hypothesis.local();
        // Beside the other causes, its own joint may err as much without it on the fitted data, too.
        let in_a_gear = item.hypothesis.kind() == Kind::Transmission;
        match on {
            "fit" if throughout && in_a_gear && part < SHOWN => Some(Refutation::OwnJoints),
            "fit" if throughout && shares.nothing => Some(Refutation::OwnJoints),
            on if throughout && on != "fit" && other_data_refute(part, pays, shares) => Some(Refutation::OtherData),
            _ => self.implausible_size(accepted),
        }
    }

    /// A refutation if the size of a cause became implausible beside the others.
    fn implausible_size(&self, accepted: Option<&Accepted>) -> Option<Refutation> {
        let of = |c: &Chosen| !c.x.is_empty() && !c.cause.plausible(&self.tested.scene, &c.place, &c.shape, &c.x);
        accepted.filter(|accepted| of(&accepted.chosen)).map(|_| Refutation::Size)
    }

    /// Information that separates an item from its only rival where no motion does. With several
    /// rivals a motion is proposed instead.
    fn decided_by(&self, item: &Item, rivals: &[&'static str]) -> Option<&'static str> {
        let [_] = rivals else { return None };
        item.hypothesis.decided_by(&self.tested.scene, &item.place)
    }

    /// The file's levels of plain friction that an item changes, in words.
    fn in_the_file(&self, item: &Item) -> String {
        let given = given_friction(self.tested.plant);
        let level = |k: &usize| {
            let (joint, which) = (k / 3, k % 3);
            let symbol = [effects::ViscousFriction::FV, effects::CoulombFriction::FC].get(which)?.name();
            Some(format!("{symbol}{} = {}", joint + 1, evidence::short(given[joint][which]?)))
        };
        let levels: Vec<String> = match item.accepted {
            Some(_) => Vec::new(),
            None => item.friction.iter().filter_map(level).collect(),
        };
        if levels.is_empty() { String::new() } else { format!("; the file has {}", levels.join(", ")) }
    }

    /// A note on a link whose mass is not identifiable and for which the file's mass is impossible.
    fn assumed(&self, item: &Item) -> String {
        let (tested, fitted) = (self.tested, self.fitted);
        let mass = item.accepted.and_then(|index| {
            let chosen = &self.accepted[index].chosen;
            Body::of(&tested.scene, chosen, &fitted.terms[index])?.assumed_mass(&chosen.x)
        });
        mass.map_or_else(String::new, |mass| {
            let mass = evidence::short(mass);
            format!(
                "; the motion does not show the link's mass, with the file's it can't be, and {mass} kg are assumed"
            )
        })
    }

    /// What the evidence says beside its figures.
    fn notes(&self, item: &Item, near: &[(&'static str, Vec<usize>, f64)]) -> String {
        [elsewhere(item, near), self.in_the_file(item), self.assumed(item), self.driving(item)].concat()
    }

    /// A note on a friction law with which the friction of its joint would do positive work.
    fn driving(&self, item: &Item) -> String {
        let law = item.accepted.is_some() && item.hypothesis.kind() == Kind::Friction;
        let drives =
            |joint| friction_drives(self.tested, joint, &chosen_of(self.accepted), self.fitted, self.noise[joint]);
        match item.place[..] {
            [joint] if law && drives(joint) => {
                "; the whole friction of the joint would then drive it in a part of the motion: the file's level is too low, or the error is not friction but has this form".into()
            }
            _ => String::new(),
        }
    }

    /// Parameters of an item under the keys of a robot file.
    fn keys(&self, item: &Item) -> Vec<Named> {
        let Self { tested, fitted, uncertainty, accepted: all, .. } = *self;
        let friction = friction_values(tested, fitted, &uncertainty.covariance, item);
        let Some(index) = item.accepted else { return friction };
        let mut keys = parameters(tested, fitted, uncertainty, index, &all[index].chosen);
        for named in friction {
            if keys.iter().all(|k| k.symbol != named.symbol) {
                keys.push(named);
            }
        }
        keys
    }

    /// Probability of an item with these features, less where it is refuted, or a link for which
    /// another body would do.
    fn probability(&self, item: &Item, features: &Features, refuted: Option<Refutation>) -> f64 {
        let near = near(item, item.accepted.map(|at| &self.accepted[at]), self.rivals);
        let another = may_be_another_body(item.hypothesis.name(), &item.place, near);
        let place = if another { calibration::ANOTHER_BODY } else { 1.0 };
        self.likely(item, features) * place * refuted.map_or(1.0, |_| calibration::REFUTED)
    }

    /// The same from its features alone. For a cause found by the search from the unchanged file, it
    /// follows from the evidence of that search. Of several friction terms in one item, the least
    /// certain one counts.
    fn likely(&self, item: &Item, features: &Features) -> f64 {
        if item.hypothesis.local() {
            let brief = item.accepted.is_some_and(|at| is_brief(&self.accepted[at].chosen));
            return calibration::local(features.support, brief);
        }
        let of = |effect: EffectKind| {
            let found = self.evidence_of(effect, item)?;
            let (wald, margin, confirmed) = (self.wald(item), features.margin, features.confirmed);
            Some(calibration::change(&Change { share: found.share, wald, margin, confirmed }))
        };
        let plain = |k: &usize| of(PLAIN[k % 3].effect());
        let terms = || item.friction.iter().map(plain).collect::<Option<Vec<f64>>>();
        let several = || terms().and_then(|all| all.into_iter().reduce(f64::min));
        of(item.hypothesis.effect())
            .or_else(several)
            .unwrap_or_else(|| calibration::probability(item.accepted.is_none(), features))
    }

    /// Evidence for an effect in an item's place: of several ripples of a joint that of its order.
    fn evidence_of(&self, effect: EffectKind, item: &Item) -> Option<&Evidence> {
        let shape = item.accepted.map_or(&[][..], |at| &self.accepted[at].chosen.shape);
        let of_it = || self.evidence.iter().filter(|e| !e.local && e.effect == effect && e.place == item.place);
        of_it().find(|e| item.hypothesis.same_law(&e.shape, shape)).or_else(|| of_it().next_back())
    }

    /// Wald statistic of an item's parameters; for several friction terms the largest.
    fn wald(&self, item: &Item) -> f64 {
        let Self { tested, fitted, uncertainty, accepted, .. } = *self;
        match item.accepted {
            Some(at) => uncertainty.wald(tested, fitted, at, &accepted[at].chosen),
            None => plain_support(fitted, &uncertainty.covariance, &item.friction),
        }
    }

    /// Recurrence of an item in stretches of the fitted logs. It is 1 for a local cause, which
    /// cannot recur.
    fn recurrence(&self, item: &Item, keys: &[Named]) -> f64 {
        let fitted = self.fitted;
        if item.hypothesis.local() {
            return 1.0;
        }
        // A delay has shifted the data, and only a remainder of it is fitted.
        let delay = keys.first().filter(|_| item.hypothesis.moves_time());
        let size = |k: usize| delay.map_or(fitted.solution.x[k], |delay| delay.value);
        let own: Vec<(usize, f64)> = item.unknowns(fitted).into_iter().map(|k| (k, size(k))).collect();
        self.stretches.recurrence(&fitted.solution, &own)
    }
}

/// Error removed by a cause: the logarithm of the ratio of root mean squares without and with it,
/// noise added to both, summed over joints. Joints with large torques thus do not dominate.
pub(in crate::diagnose) fn taken(cause: &Cause, noise: &[f64]) -> f64 {
    taken_of(&cause.rms_before, &cause.rms_after, noise)
}

/// Least share of a joint's squared error above the noise that a cause must remove on unfitted data
/// to be confirmed by them, and a cause in a gear on the fitted data.
const SHOWN: f64 = 0.05;

/// Share below which unfitted data refute a cause: their error is larger with it than without it.
const REFUTED: f64 = -0.2;

/// Whether data that were not fitted refute a cause that removes the share `part` of its joints'
/// error there. One joint does not refute a body that `pays` over all.
fn other_data_refute(part: f64, pays: bool, Shares { worse, nothing, .. }: Shares) -> bool {
    part < REFUTED && !pays || worse || nothing
}

/// Margin above which a larger value carries no information.
pub(in crate::diagnose) const MOST_MARGIN: f64 = 1e4;

/// Support of plain friction terms, given by their indices: the largest of their squared values
/// divided by their variances.
pub(in crate::diagnose) fn plain_support(fitted: &Fitted, covariance: &nalgebra::DMatrix<f64>, terms: &[usize]) -> f64 {
    let squares = terms.iter().map(|k| {
        let at = fitted.friction + k;
        let variance = covariance[(at, at)];
        if variance > 0.0 { fitted.solution.x[at].powi(2) / variance } else { 0.0 }
    });
    squares.fold(0.0, f64::max)
}

/// Near alternatives of an item: cause, place, difference of support.
pub(in crate::diagnose) fn near<'a>(
    item: &Item,
    accepted: Option<&'a Accepted>,
    plain: &'a [BaselineFriction],
) -> &'a [(&'static str, Vec<usize>, f64)] {
    match accepted {
        Some(accepted) => accepted.rivals.as_slice(),
        None => plain.iter().find(|p| item.place == [p.joint]).map(|p| p.rivals.as_slice()).unwrap_or_default(),
    }
}

/// Whether a link is one of several bodies that explain nearly as much. A payload is not: an arm
/// carries one more often than a link of its file is wrong.
fn may_be_another_body(cause: &str, place: &[usize], near: &[(&'static str, Vec<usize>, f64)]) -> bool {
    let bodies = [LinkInertiaError::NAME, Payload::NAME];
    let close = |(name, other, margin): &(&'static str, Vec<usize>, f64)| {
        bodies.contains(name) && other != place && *margin < calibration::NEARLY_AS_MUCH
    };
    cause == LinkInertiaError::NAME && near.iter().any(close)
}

/// The same cause in other places that would explain nearly as much, in words.
fn elsewhere(item: &Item, near: &[(&'static str, Vec<usize>, f64)]) -> String {
    let same = near.iter().filter(|r| r.0 == item.hypothesis.name() && r.1 != item.place);
    same.map(|r| format!("; the same {} would explain nearly as much", place_of(&r.1))).collect()
}

/// Causes that these data, or any data, cannot separate from a cause.
pub(in crate::diagnose) fn confusable(
    tested: &ModelUnderTest<'_>,
    item: &Item,
    accepted: Option<&Accepted>,
    plain: &[BaselineFriction],
) -> Vec<&'static str> {
    let mut names: Vec<&'static str> = near(item, accepted, plain).iter().map(|r| r.0).collect();
    names.extend(item.hypothesis.indistinguishable(&tested.scene, &item.place));
    // One cause that replaces several plain ones.
    if item.accepted.is_none() && item.friction.len() > 1 {
        names.extend(item.friction.iter().map(|k| PLAIN[k % 3].name()));
    }
    names.sort_unstable();
    names.dedup();
    names.retain(|n| *n != item.hypothesis.name());
    names
}

/// Torque and errors over time, at most 2,000 points.
pub(in crate::diagnose) fn curve(j: usize, after: &Measured, view: &View, before: &[Vec<f64>]) -> Curve {
    let n = after.error[j].len().min(before[j].len());
    let every = n.div_ceil(2000).max(1);
    let fine = |x: &[f64]| -> Vec<f64> { x[..n].iter().step_by(every).copied().collect() };
    Curve {
        t: fine(&view.clock()),
        measured: fine(&view.torque[j]),
        before: fine(&before[j]),
        after: fine(&after.error[j]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_link_may_be_another_body() {
        let near = |cause, margin| may_be_another_body(LinkInertiaError::NAME, &[4], &[(cause, vec![5], margin)]);
        assert!(near(LinkInertiaError::NAME, 0.5) && near(Payload::NAME, 2.4) && !near(Payload::NAME, 2.6));
        assert!(!near(effects::GeometricError::NAME, 0.5));
        assert!(!may_be_another_body(Payload::NAME, &[], &[(LinkInertiaError::NAME, vec![5], 0.0)]));
        let same = [(LinkInertiaError::NAME, vec![4], 0.0)];
        assert!(!may_be_another_body(LinkInertiaError::NAME, &[4], &same), "another law of that link");
    }

    /// A link takes most of joint 2's error, and its own joint errs a little more with it.
    #[test]
    fn one_joint_does_not_refute_a_body() {
        let shares =
            Shares { within: None, far: None, repeats: None, beside_levels: None, worse: false, nothing: false };
        assert!(other_data_refute(-0.43, false, shares));
        assert!(!other_data_refute(-0.43, true, shares) && !other_data_refute(-0.1, false, shares));
        assert!(other_data_refute(0.5, true, Shares { worse: true, ..shares }));
        assert!(other_data_refute(0.5, true, Shares { nothing: true, ..shares }));
    }
}
