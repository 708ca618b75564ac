//! The model with the file's links: searched from the unchanged file, measured, and searched again
//! without causes that diluted others.
//!
//! A law accepted on a joint after another absorbs a part of the error that the first one
//! explained. If it does not hold on unused data, it leaves the model, and the first one may have
//! left before it. Such a law is excluded, and the search repeated.

use super::reduction::without;
use super::refine_and_select::{Attributed, FAR_BELOW, Selected, Session, inside};
use super::suspects::remember;
use crate::diagnose::findings::calibration;
use crate::diagnose::findings::reported_cause::Item;
use crate::diagnose::findings::result::Cause;
use crate::diagnose::fit::model::{Mode, ModelUnderTest};
use crate::diagnose::hypotheses::{Hypothesis as _, PLAIN};
use crate::diagnose::search::baseline_friction::BaselineFriction;
use crate::diagnose::search::forward::{Evidence, Found, Placed, forward};
use crate::diagnose::search::judge::{Accepted, chosen_of};
use crate::identify::ConsistentError;

/// Maximum number of searches, each without the causes that diluted others in the previous one.
const SEARCHES: usize = 2;

/// Least gain on left-out stretches for which a search with another first cause is preferred.
const BETTER: f64 = 0.05;

/// Share of its joint's squared error from which a cause can be diluted.
const MOST_OF_IT: f64 = 0.5;

/// Causes that diluted another: they are unlikely, and were accepted later on a joint with a cause
/// that explained most of the error and is unlikely now. `probability`: of each cause, beside all
/// others.
fn diluting(evidence: &[Evidence], probability: &[f64]) -> Vec<Placed> {
    let lost = |k: usize| evidence[k].share >= MOST_OF_IT && probability[k] < calibration::NAMED;
    let later = |i: usize| {
        let joints = &evidence[i].place;
        (0..i).any(|k| lost(k) && evidence[k].place.iter().any(|j| joints.contains(j)))
    };
    let found = (0..evidence.len()).filter(|&i| probability[i] < FAR_BELOW && later(i));
    found.map(|i| (evidence[i].effect, evidence[i].place.clone())).collect()
}

/// Whether an item is the cause of this evidence, or has its friction term.
fn is_of(item: &Item, e: &Evidence) -> bool {
    let term = |k: &usize| PLAIN[k % 3].effect() == e.effect;
    item.place == e.place
        && item.hypothesis.local() == e.local
        && (item.hypothesis.effect() == e.effect || item.friction.iter().any(term))
}

impl<'a> Session<'a> {
    /// The file's links with the causes that hold.
    pub(super) fn searched_from_file(&self) -> Result<Selected<'a>, ConsistentError> {
        let (mut excluded, mut known, mut searches) = (Vec::new(), Vec::new(), 0);
        loop {
            let (mut tested, mut found) = self.started(&excluded);
            // Only once, because a search takes long.
            if let Some(first) = found.other_start.take().filter(|_| searches == 0) {
                let (mut other, instead) = self.started(&[&excluded[..], std::slice::from_ref(&first)].concat());
                let [known, left] = [(&mut tested, &found), (&mut other, &instead)].map(|(tested, found)| {
                    let mut chosen = chosen_of(&found.accepted);
                    let fitted = tested.fit(&mut chosen);
                    tested.left_out(&chosen, &fitted)
                });
                let better = left.less(&known, self.ground);
                if better.sure() && better.gain > BETTER {
                    (tested, found) = (other, instead);
                    excluded.push(first);
                }
            }
            let (mut accepted, changes) = (found.accepted, (found.friction, found.evidence));
            let (causes, diluting) = self.found(&mut tested, &mut accepted, &changes)?;
            remember(&mut known, &causes);
            searches += 1;
            if diluting.is_empty() || searches == SEARCHES {
                return self.select(tested, accepted, Some(changes), known);
            }
            excluded.extend(diluting);
        }
    }

    /// A search from the unchanged file without what is `excluded`.
    fn started(&self, excluded: &[Placed]) -> (ModelUnderTest<'a>, Found) {
        let mut tested = self.tested(Mode::Trusted);
        let found = forward(&mut tested, self.noise, &self.settings.search, excluded, self.progress);
        tested.forget();
        (tested, found)
    }

    /// Measures the found causes before any of them leaves the model. Returns the causes, and those
    /// to exclude from a repeated search.
    fn found(
        &self,
        tested: &mut ModelUnderTest<'a>,
        accepted: &mut Vec<Accepted>,
        (friction, evidence): &(Vec<BaselineFriction>, Vec<Evidence>),
    ) -> Result<(Vec<Cause>, Vec<Placed>), ConsistentError> {
        (self.progress)("measuring what was found");
        let fitted = without(tested, accepted, &[]);
        let fitted = inside(tested, accepted, &fitted)?;
        let Attributed { items, causes, stands_out, .. } =
            self.attributed(tested, accepted, fitted, friction, evidence)?;
        let likely = |e: &Evidence| {
            let of = (0..items.len()).filter(|&i| stands_out[i] >= 0.0 && is_of(&items[i], e));
            of.map(|i| causes[i].probability).fold(0.0, f64::max)
        };
        let diluting = diluting(evidence, &evidence.iter().map(likely).collect::<Vec<f64>>());
        let here = |c: &Cause| {
            let same =
                |e: &Evidence| e.effect.name() == c.cause && e.place.iter().map(|j| j + 1).eq(c.joints.iter().copied());
            evidence.iter().any(same)
        };
        let causes = causes.into_iter().zip(stands_out).filter(|(c, stands)| *stands >= 0.0 && here(c));
        Ok((causes.map(|c| c.0).collect(), diluting))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use dh_codegen::robot::EffectKind;

    #[test]
    fn what_is_unlikely_is_excluded_where_it_diluted_a_cause() {
        let of = |effect, place: &[usize], share| Evidence {
            effect,
            place: place.to_vec(),
            shape: Vec::new(),
            local: false,
            share,
        };
        let evidence = [
            of(EffectKind::CoulombFriction, &[2], 0.6),
            of(EffectKind::TimeDelay, &[2], 0.3),
            of(EffectKind::TorqueRipple, &[4], 0.3),
            of(EffectKind::GearCoupling, &[1, 2], 0.2),
            of(EffectKind::JointSpring, &[4], 0.2),
        ];
        let excluded = |probability: [f64; 5]| -> Vec<EffectKind> {
            diluting(&evidence, &probability).iter().map(|e| e.0).collect()
        };
        assert_eq!(excluded([0.0; 5]), [EffectKind::TimeDelay, EffectKind::GearCoupling]);
        assert_eq!(excluded([0.04, 0.04, 0.0, 0.5, 0.0]), [EffectKind::TimeDelay]);
        // A cause that is still likely was not diluted.
        assert!(excluded([0.7, 0.0, 0.0, 0.0, 0.0]).is_empty());
    }
}
