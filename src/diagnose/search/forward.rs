//! Finds what changed relative to the robot file: forward selection from the unchanged file.
//!
//! Friction that the file has is fixed until one of its terms is the best candidate of a round, so
//! that a changed level competes with every other cause. In the best place, the candidate with the
//! fewest unknowns is preferred where it gains nearly as much. It is accepted if it removes enough
//! of a joint's error, in the fit and on left-out stretches of the logs. It must make no other
//! joint worse there.

use super::alone::is_an_error_of_contact;
use super::baseline_friction::BaselineFriction;
use super::candidate::{Candidate, candidates, evaluate, plain, price, refine, rivals, unknowns};
use super::driving_friction::level_drives;
use super::judge::{Accepted, Judge, THROUGHOUT, adopt, chosen_of};
use super::levels_instead::levels_instead;
use super::merge_levels::merge_levels;
use super::next_candidate::{PLAINER, best};
use super::over_all_joints::pays_as_a_whole;
use super::shorter_push::shorter_push;
use super::sufficient::Tried;
use super::support::{gained, shows_on_other_joints};
use super::{SearchSettings, equivalent_robot_cause, simplify};
use crate::diagnose::fit::model::{Chosen, Fitted, ModelUnderTest, given_friction};
use crate::diagnose::fit::regulariser::Regulariser;
use crate::diagnose::fit::white_errors::{log_ratios, white_gain};
use crate::diagnose::hypotheses::{Hypothesis, Kind, PLAIN, laws};
use crate::diagnose::select::model_choice::LeftOut;
use dh_codegen::robot::EffectKind;

/// Number of candidates rejected before a round ends.
const REFUSED: usize = 8;

/// Largest relative growth of a joint's squared error on left-out stretches.
const SPOILT: f64 = 0.3;

/// The same limit for a body that [`pays_as_a_whole`].
const SPOILT_BY_BODY: f64 = 1.0;

/// Evidence for one cause at the time it was accepted.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::diagnose) struct Evidence {
    pub(in crate::diagnose) effect: EffectKind,
    pub(in crate::diagnose) place: Vec<usize>,
    /// Its shape then; empty for plain friction.
    pub(in crate::diagnose) shape: Vec<f64>,
    /// Whether it acts in a part of a log: of contacts, a push and not a wall.
    pub(in crate::diagnose) local: bool,
    /// Share of the squared error of its main joint that the cause removes. For a local cause: the
    /// share within the part of the log where it acts.
    pub(in crate::diagnose) share: f64,
}

/// Share of the first cause's score above which a candidate in another place may be the true cause,
/// and share of its own score below which the first cause explains it.
const RIVAL: f64 = 0.8;
const EXPLAINED: f64 = 0.5;

/// Result of the forward selection.
pub(in crate::diagnose) struct Found {
    pub(in crate::diagnose) accepted: Vec<Accepted>,
    /// Evidence for each cause, in the order of acceptance.
    pub(in crate::diagnose) evidence: Vec<Evidence>,
    /// Terms of plain friction that changed, with their alternatives; by joint.
    pub(in crate::diagnose) friction: Vec<BaselineFriction>,
    /// The first cause, if a cause in another place gained nearly as much and is explained by it. The
    /// search may then have started at the wrong one of the two.
    pub(in crate::diagnose) other_start: Option<Placed>,
}

/// A law of a cause that was refused. Each of several laws of one cause is tried.
#[derive(PartialEq)]
struct Law {
    says: &'static str,
    place: Vec<usize>,
    coefficients: usize,
    local: bool,
}

fn law(Candidate { cause, place, gain, .. }: &Candidate) -> Law {
    Law { says: cause.says(), place: place.clone(), coefficients: gain.x.len(), local: cause.local() }
}

/// An effect in a place.
pub(in crate::diagnose) type Placed = (EffectKind, Vec<usize>);

/// Forward selection until no candidate is accepted, without those `excluded`. Leaves `tested` with
/// the friction terms that were found free, and all others of the file fixed.
pub(in crate::diagnose) fn forward(
    tested: &mut ModelUnderTest<'_>,
    noise: &[f64],
    settings: &SearchSettings,
    excluded: &[Placed],
    progress: &(dyn Fn(&str) + Sync),
) -> Found {
    // Friction that the file lacks is an unknown, not a change.
    let given = given_friction(tested.plant);
    tested.frozen = given.iter().flatten().map(Option::is_some).collect();
    tested.regulariser = Some(Regulariser::none());
    let mut search = Forward {
        tested,
        noise,
        settings,
        excluded,
        chosen: Vec::new(),
        accepted: Vec::new(),
        friction: Vec::new(),
        evidence: Vec::new(),
        rivals_of_first: Vec::new(),
        other_start: None,
    };
    let mut fitted = search.tested.fit(&mut []);
    let mut refused = Vec::new();
    loop {
        progress(&format!("{} found, looking for more", search.evidence.len()));
        let Some(next) = search.round(&fitted, &mut refused) else { break };
        fitted = next;
    }
    progress("whether other laws explain several causes at once");
    search.unite(&mut fitted);
    search.without_errors_of_contact(&mut fitted);
    search.with_shorter_pushes(&mut fitted);
    search.prune(&mut fitted);
    let Forward { mut accepted, friction, mut evidence, other_start, .. } = search;
    simplify(tested, &mut accepted, &mut fitted);
    let mut chosen = chosen_of(&accepted);
    let fitted = tested.fit_regularised_beside(&mut chosen);
    adopt(&mut accepted, &chosen);
    let fitted = levels_instead(tested, &mut accepted, fitted, &mut evidence);
    merge_levels(tested, &accepted, &fitted, &mut evidence);
    Found { accepted, evidence, friction, other_start }
}

/// A part of the model: one of the causes, or a term of friction.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Part {
    Cause(usize),
    Friction(usize),
}

pub(super) struct Forward<'s, 'a> {
    pub(super) tested: &'s mut ModelUnderTest<'a>,
    pub(super) noise: &'s [f64],
    settings: &'s SearchSettings,
    excluded: &'s [Placed],
    pub(super) chosen: Vec<Chosen>,
    accepted: Vec<Accepted>,
    friction: Vec<BaselineFriction>,
    evidence: Vec<Evidence>,
    /// Candidates in other places with nearly the score of the first cause, with their scores.
    rivals_of_first: Vec<(Placed, f64)>,
    /// See [`Found::other_start`].
    other_start: Option<Placed>,
}

/// Candidates in other places that gain nearly as much as this one, with their scores.
fn rivals_elsewhere(ranked: &[Candidate], first: &Candidate) -> Vec<(Placed, f64)> {
    let elsewhere = |c: &&Candidate| {
        c.place != first.place && plain(c).is_none() && !c.cause.local() && c.score > RIVAL * first.score
    };
    ranked.iter().filter(elsewhere).map(|c| ((c.cause.effect(), c.place.clone()), c.score)).collect()
}

impl Forward<'_, '_> {
    /// Sets [`Found::other_start`] in the round after the first cause was accepted.
    fn compare_with_first(&mut self, ranked: &[Candidate]) {
        let [first] = &self.evidence[..] else { return };
        let score = |(effect, place): &Placed| {
            let same = ranked.iter().filter(|c| c.cause.effect() == *effect && c.place == *place);
            same.map(|c| c.score).fold(0.0, f64::max)
        };
        if self.rivals_of_first.drain(..).any(|(rival, before)| score(&rival) < EXPLAINED * before) {
            self.other_start = Some((first.effect, first.place.clone()));
        }
    }

    /// Adds the best cause that is accepted; `None` where there is none.
    fn round(&mut self, fitted: &Fitted, refused: &mut Vec<Law>) -> Option<Fitted> {
        let ranked = self.ranked(fitted, refused);
        self.compare_with_first(&ranked);
        let before = self.tested.left_out(&self.chosen, fitted);
        let mut tried: Vec<usize> = Vec::new();
        while tried.len() < REFUSED {
            let first = best(&ranked, &tried)?;
            let other = match self.that_suffices(&ranked, first, fitted, &before) {
                Tried::Itself => self.link_that_predicts_better((&ranked, first), fitted, &before),
                Tried::Instead(other) => Some(other),
                Tried::Neither => {
                    tried.push(first);
                    refused.push(law(&ranked[first]));
                    continue;
                }
            };
            let at = other.filter(|i| !tried.contains(i)).unwrap_or(first);
            tried.push(at);
            if let Some(next) = self.accept(&ranked, at, fitted, &before) {
                // A local cause may stand out from the smaller residual.
                refused.retain(|law| !law.local);
                return Some(next);
            }
            refused.push(law(&ranked[at]));
        }
        None
    }

    /// Replaces a cause, and all causes of its joints alone, by another law of that cause where it
    /// explains as much. The law that was accepted first may have been a part of it, with the
    /// remainder taken for friction of those joints.
    fn unite(&mut self, fitted: &mut Fitted) {
        for index in 0..self.accepted.len() {
            let Some(own) = self.accepted.get(index).map(|a| a.chosen.clone()) else { break };
            let inside = |place: &[usize]| !place.is_empty() && place.iter().all(|j| own.place.contains(j));
            let beside = |i: usize, a: &Accepted| i != index && inside(&a.chosen.place);
            let others: Vec<usize> =
                (0..self.accepted.len()).filter(|&i| i != index && !beside(i, &self.accepted[i])).collect();
            let given = given_friction(self.tested.plant);
            let constant = own.cause.has_constant();
            let free = |k: usize| !self.tested.frozen[k] && given[k / 3][k % 3].is_some() && !(constant && k % 3 == 2);
            let terms: Vec<usize> =
                (0..self.tested.frozen.len()).filter(|&k| free(k) && own.place.contains(&(k / 3))).collect();
            if own.cause.moves_time() || others.len() + 1 == self.accepted.len() && terms.is_empty() {
                continue;
            }
            terms.iter().for_each(|&k| self.tested.frozen[k] = true);
            let mut rest: Vec<Chosen> = others.iter().map(|&i| self.accepted[i].chosen.clone()).collect();
            let without = self.tested.fit(&mut rest);
            let saved = self.accepted.len() - others.len() - 1 + terms.len();
            match self.united(&own, &rest, &without, (saved, fitted)) {
                Some((trial, next)) => {
                    let mut kept: Vec<Accepted> = others.iter().map(|&i| self.accepted[i].clone()).collect();
                    kept.push(self.accepted[index].clone());
                    self.evidence
                        .retain(|e| e.effect == own.cause.effect() && e.place == own.place || !inside(&e.place));
                    self.friction.retain(|f| !own.place.contains(&f.joint));
                    (self.accepted, self.chosen, *fitted) = (kept, trial, next);
                    adopt(&mut self.accepted, &self.chosen);
                    return self.unite(fitted);
                }
                None => terms.iter().for_each(|&k| self.tested.frozen[k] = false),
            }
        }
        *fitted = self.tested.fit(&mut self.chosen);
        adopt(&mut self.accepted, &self.chosen);
    }

    /// Removes pushes that a wall found later explains up to an error of its law.
    fn without_errors_of_contact(&mut self, fitted: &mut Fitted) {
        let other = |i: usize| self.chosen.iter().enumerate().filter(move |(k, _)| *k != i).map(|(_, c)| c);
        let error = |i: &usize| is_an_error_of_contact(&self.tested.scene, &self.chosen[*i], other(*i));
        let errors: Vec<usize> = (0..self.chosen.len()).filter(error).collect();
        if errors.is_empty() {
            return;
        }
        errors.into_iter().rev().for_each(|i| self.without_push(i));
        *fitted = self.tested.fit(&mut self.chosen);
        adopt(&mut self.accepted, &self.chosen);
    }

    /// Removes a push with its evidence.
    fn without_push(&mut self, i: usize) {
        let gone = self.chosen.remove(i);
        self.accepted.remove(i);
        // The evidence of several pushes has one name; the last belongs to the one found last.
        let of_it = |e: &Evidence| e.local && e.effect == gone.cause.effect() && e.place == gone.place;
        if let Some(at) = self.evidence.iter().position(of_it) {
            self.evidence.remove(at);
        }
    }

    /// Replaces two pushes of which one takes back a part of the other by one shorter push.
    fn with_shorter_pushes(&mut self, fitted: &mut Fitted) {
        if self.chosen.iter().filter(|c| c.cause.local()).count() < 2 {
            return;
        }
        while let Some(shorter) = shorter_push(self.tested, &self.chosen, fitted) {
            self.without_push(shorter.needless);
            (self.chosen, *fitted) = (shorter.chosen, shorter.fitted);
        }
        *fitted = self.tested.fit(&mut self.chosen);
        adopt(&mut self.accepted, &self.chosen);
    }

    /// Removes parts, the smallest share first, that take less than the least gain of a joint's
    /// error beside all others. Such a part was accepted in place of a cause found later.
    fn prune(&mut self, fitted: &mut Fitted) {
        loop {
            let parts = self.parts();
            if parts.len() < 2 {
                break;
            }
            let shares: Vec<(f64, Part)> = parts.into_iter().map(|part| (self.share_of(part, fitted), part)).collect();
            let least = shares.iter().min_by(|a, b| a.0.total_cmp(&b.0));
            let Some((_, part)) = least.filter(|(share, _)| *share < self.settings.least_gain) else { break };
            self.remove(self.law_for_a_level(*part, &shares).unwrap_or(*part));
            *fitted = self.tested.fit(&mut self.chosen);
            adopt(&mut self.accepted, &self.chosen);
        }
        *fitted = self.tested.fit(&mut self.chosen);
        adopt(&mut self.accepted, &self.chosen);
    }

    /// Finds a law that follows reversals and has degenerated to a level of its joint: it contains
    /// the level and hardly more. It is removed instead of the level, which has fewer unknowns.
    fn law_for_a_level(&self, part: Part, shares: &[(f64, Part)]) -> Option<Part> {
        let Part::Friction(k) = part else { return None };
        let hardly_more = |(share, other): &&(f64, Part)| match other {
            Part::Cause(i) => {
                let Chosen { cause, place, .. } = &self.chosen[*i];
                *place == [k / 3] && cause.follows_reversals() && *share < PLAINER
            }
            Part::Friction(_) => false,
        };
        shares.iter().find(hardly_more).map(|(_, law)| *law)
    }

    /// Parts that can be removed. Delays are excluded because they have shifted the data, and so
    /// are causes that act in a part of a log.
    fn parts(&self) -> Vec<Part> {
        let of = |e: &Evidence| {
            if let Some(which) = PLAIN.iter().position(|p| p.effect() == e.effect) {
                let k = 3 * e.place.first()? + which;
                return (!self.tested.frozen[k]).then_some(Part::Friction(k));
            }
            let here = |c: &Chosen| c.cause.effect() == e.effect && c.place == e.place && !c.cause.local();
            let index = self.chosen.iter().position(here).filter(|_| !e.local)?;
            (!self.chosen[index].cause.moves_time()).then_some(Part::Cause(index))
        };
        self.evidence.iter().filter_map(of).collect()
    }

    /// Share of its main joint's squared error that a part removes beside all others.
    fn share_of(&mut self, part: Part, fitted: &Fitted) -> f64 {
        let mut rest = self.chosen.clone();
        match part {
            Part::Cause(index) => drop(rest.remove(index)),
            Part::Friction(k) => self.tested.frozen[k] = true,
        }
        let without = self.tested.fit(&mut rest);
        if let Part::Friction(k) = part {
            self.tested.frozen[k] = false;
        }
        let joint = main_joint(&without, fitted);
        let [a, b] = [&without, fitted].map(|f| f.solution.rss[joint]);
        if a > 0.0 { 1.0 - b / a } else { 0.0 }
    }

    /// Removes a part with its evidence. The caller refits.
    fn remove(&mut self, part: Part) {
        let (effect, place) = match part {
            Part::Cause(index) => {
                self.chosen.remove(index);
                let gone = self.accepted.remove(index).chosen;
                (gone.cause.effect(), gone.place)
            }
            Part::Friction(k) => {
                self.tested.frozen[k] = true;
                (PLAIN[k % 3].effect(), vec![k / 3])
            }
        };
        self.evidence.retain(|e| e.local || e.effect != effect || e.place != place);
    }

    /// The best law of a cause beside the `rest`, if its loss is below the cost of the unknowns
    /// that it replaces. `saved` is the number of replaced causes and terms of the whole model.
    fn united(
        &mut self,
        own: &Chosen,
        rest: &[Chosen],
        without: &Fitted,
        (saved, whole): (usize, &Fitted),
    ) -> Option<(Vec<Chosen>, Fitted)> {
        let of = |cause: &'static dyn Hypothesis| {
            let shapes = cause.grid(&self.tested.scene, &own.place, &without.residual);
            let tried = shapes.iter().filter_map(|shape| evaluate(self.tested, without, cause, &own.place, shape));
            tried.max_by(|a, b| a.score.total_cmp(&b.score))
        };
        let mut best = laws(own.cause.effect()).filter_map(of).max_by(|a, b| a.score.total_cmp(&b.score))?;
        refine(self.tested, without, &mut best);
        let mut trial = [rest, &[best.chosen()]].concat();
        let next = self.tested.fit(&mut trial);
        let lost = white_gain(&next.solution.rss, &whole.solution.rss, whole.solution.counts.iter().copied());
        let more = unknowns(best.cause, &best.shape, best.gain.x.len()) - unknowns(own.cause, &own.shape, own.x.len());
        let pays = saved as f64 > more && lost < (saved as f64 - more.max(0.0)) * price(whole);
        (pays && self.judge().stands(trial.last()?, &next)).then_some((trial, next))
    }

    /// All candidates including plain friction, best first. Once the maximum number of causes that
    /// act throughout is reached, only local ones remain, which the others cannot replace.
    fn ranked(&self, fitted: &Fitted, refused: &[Law]) -> Vec<Candidate> {
        let full = self.chosen.iter().filter(|c| !c.cause.local()).count() >= self.settings.most;
        let wanted = |cause: &'static dyn Hypothesis, place: &[usize]| {
            let same = |c: &&Chosen| c.cause.name() == cause.name() && c.place == place;
            let excluded = self.excluded.iter().any(|(effect, at)| *effect == cause.effect() && at == place);
            !excluded && (cause.local() || !full) && self.chosen.iter().filter(same).count() < cause.most()
        };
        let mut all = candidates(self.tested, fitted, &wanted);
        for (k, _) in self.tested.frozen.iter().enumerate().filter(|(_, frozen)| **frozen) {
            let (cause, place) = (PLAIN[k % 3], [k / 3]);
            if wanted(cause, &place) {
                all.extend(evaluate(self.tested, fitted, cause, &place, &[]));
            }
        }
        all.retain(|c| !refused.contains(&law(c)));
        // Stable sort: keeps the order of `candidates` among equals.
        all.sort_by(|a, b| b.score.total_cmp(&a.score));
        all
    }

    /// Makes a term of plain friction an unknown.
    pub(super) fn free(&mut self, k: usize, candidate: &Candidate) {
        // Beside a friction law the level counts as a part of that law.
        let law = |c: &Chosen| c.place == candidate.place && c.cause.kind() == Kind::Friction;
        self.tested.separate[k] = !self.chosen.iter().any(law);
        self.tested.frozen[k] = false;
    }

    /// Adds a candidate if it is accepted; otherwise restores the model.
    fn accept(&mut self, ranked: &[Candidate], at: usize, fitted: &Fitted, before: &LeftOut) -> Option<Fitted> {
        let candidate = &ranked[at];
        let delays = self.tested.scene.delays.clone();
        let friction = plain(candidate);
        let mut trial = self.chosen.clone();
        match friction {
            Some(k) => self.free(k, candidate),
            None => trial.push(candidate.chosen()),
        }
        let next = self.tested.fit(&mut trial);
        if let Some(evidence) = self.holds((ranked, at), &trial, [fitted, &next], before) {
            match friction {
                Some(k) => self.adopt_friction(k / 3, ranked, at, &next),
                None => self.adopt_cause(&mut trial, ranked, at, [fitted, &next]),
            }
            // A body on the last link has become a payload.
            let name = |last: &Chosen| (last.cause.effect(), last.place.clone());
            let (effect, place) = match friction {
                Some(_) => (evidence.effect, evidence.place),
                None => trial.last().map_or((evidence.effect, evidence.place), name),
            };
            if self.evidence.is_empty() && friction.is_none() {
                self.rivals_of_first = rivals_elsewhere(ranked, candidate);
            }
            self.evidence.push(Evidence { effect, place, ..evidence });
            self.chosen = trial;
            adopt(&mut self.accepted, &self.chosen);
            return Some(next);
        }
        if let Some(k) = friction {
            self.tested.frozen[k] = true;
        }
        self.tested.restore(&delays, fitted);
        None
    }

    /// Evidence for a fitted candidate; `None` if it is rejected. It is the last of `trial` unless
    /// it is plain friction; `after` is the fit with it.
    pub(super) fn holds(
        &self,
        (ranked, at): (&[Candidate], usize),
        trial: &[Chosen],
        [before, after]: [&Fitted; 2],
        left: &LeftOut,
    ) -> Option<Evidence> {
        let judge = self.judge();
        let candidate = &ranked[at];
        let Candidate { cause, place, .. } = candidate;
        let evidence = |share: f64| {
            let shape = candidate.shape.clone();
            Some(Evidence { effect: cause.effect(), place: place.clone(), shape, local: cause.local(), share })
        };
        let stands = match plain(candidate) {
            Some(k) => !level_drives(self.tested, k, after, self.noise[k / 3]),
            None => trial.last().is_some_and(|last| judge.stands(last, after) && !judge.drives(trial, [before, after])),
        };
        if !stands {
            return None;
        }
        if cause.local() {
            let last = trial.last()?;
            let share = judge.share_within(last, before, after)?;
            let holds = gained(self.tested, last, ranked.len(), [before, after]) > 0.0
                && shows_on_other_joints(self.tested, last, [before, after])
                && judge.is_alone(last, before);
            return if holds { evidence(share) } else { None };
        }
        if !judge.matters(*cause, before, after) || judge.overshadowed(*cause, place, before, after) {
            return None;
        }
        let now = self.tested.left_out(trial, after);
        let squares = |l: &LeftOut, j: usize| l.joint_rms(j).powi(2);
        let share = |j: usize| match squares(left, j) {
            known if known > 0.0 => 1.0 - squares(&now, j) / known,
            _ => 0.0,
        };
        let main = main_joint(before, after);
        let shares: Vec<f64> = (0..self.noise.len()).map(share).collect();
        let worst = shares.iter().copied().fold(0.0, f64::min);
        let spoilt = if cause.within_links() && pays_as_a_whole(&shares) { SPOILT_BY_BODY } else { SPOILT };
        if share(main) <= 0.6 * self.settings.least_gain || worst <= -spoilt {
            return None;
        }
        if !shows_on_its_gear(*cause, place, &shares) {
            return None;
        }
        let taken = 1.0 - after.solution.rss[main] / before.solution.rss[main].max(f64::MIN_POSITIVE);
        evidence(taken)
    }

    fn judge(&self) -> Judge<'_> {
        Judge { tested: self.tested, noise: self.noise, settings: self.settings, accepted: &self.accepted, tried: 1 }
    }

    fn adopt_friction(&mut self, joint: usize, ranked: &[Candidate], at: usize, next: &Fitted) {
        let rivals = rivals(ranked, at, next);
        match self.friction.iter_mut().find(|f| f.joint == joint) {
            Some(known) => known.rivals = rivals,
            None => self.friction.push(BaselineFriction { joint, rivals }),
        }
    }

    fn adopt_cause(&mut self, trial: &mut [Chosen], ranked: &[Candidate], at: usize, [before, after]: [&Fitted; 2]) {
        let Some(last) = trial.last_mut() else { return };
        let terms = after.terms.last().map_or(&[][..], |t| t.as_slice());
        if let Some(other) = equivalent_robot_cause(self.tested, last, terms) {
            *last = other;
        }
        let of = |f: &Fitted| {
            f.solution.rss.iter().zip(&f.solution.counts).map(|(r, n)| r / n.max(1.0)).collect::<Vec<f64>>()
        };
        let variance = of(before).iter().zip(of(after)).map(|(a, b)| (a - b).max(0.0)).sum();
        self.accepted.push(Accepted {
            chosen: last.clone(),
            // Left-out stretches have decided, so the support is at least this.
            support: gained(self.tested, last, ranked.len(), [before, after]).max(THROUGHOUT),
            tried: ranked.len(),
            confirmed: 1.0,
            rivals: rivals(ranked, at, after),
            variance,
        });
    }
}

/// Whether a cause in a gear reduces the error of a joint of that gear; true of all other causes.
/// `shares`: of each joint's squared error on left-out stretches that it removes.
fn shows_on_its_gear(cause: &dyn Hypothesis, place: &[usize], shares: &[f64]) -> bool {
    cause.kind() != Kind::Transmission || place.iter().any(|&j| shares[j] > 0.0)
}

/// The joint with the largest gain.
pub(super) fn main_joint(before: &Fitted, after: &Fitted) -> usize {
    let gains: Vec<f64> = log_ratios(&before.solution.rss, &after.solution.rss)
        .zip(&before.solution.counts)
        .map(|(l, n)| l * n)
        .collect();
    (0..gains.len()).max_by(|&a, &b| gains[a].total_cmp(&gains[b])).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnose::hypotheses::by_name;

    #[test]
    fn an_error_of_a_gear_shows_on_its_joints() {
        let [elasticity, coupling, friction] =
            ["joint_elasticity", "gear_coupling", "coulomb_friction"].map(|name| by_name(name).unwrap());
        assert!(!shows_on_its_gear(elasticity, &[1], &[0.6, -0.1, 0.2]));
        assert!(shows_on_its_gear(elasticity, &[1], &[0.6, 0.1, 0.2]));
        assert!(shows_on_its_gear(coupling, &[1, 2], &[0.6, -0.1, 0.2]));
        assert!(shows_on_its_gear(friction, &[1], &[0.6, -0.1, 0.2]));
    }
}
