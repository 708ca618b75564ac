//! Tests whether another cause suffices in place of a wrong link or a push.

use super::candidate::{Candidate, evaluate, plain, unknowns};
use super::forward::{Forward, main_joint};
use crate::diagnose::fit::model::{Chosen, Fitted};
use crate::diagnose::hypotheses::Kind;
use crate::diagnose::select::model_choice::LeftOut;
use dh_codegen::robot::EffectKind;

/// Maximum number of unknowns of a cause that counts as simple beside a link.
const FEW: f64 = 3.0;

/// Share of a link's score by which a payload may lag behind it.
const SAME_BODY: f64 = 0.05;

/// Number of alternative causes tried, those with the largest gain.
const TRIED: usize = 4;

/// Least share of a push's score for a cause that acts throughout to be tried in its place.
const LASTING: f64 = 0.5;

fn body(candidate: &Candidate) -> bool {
    candidate.cause.kind() == Kind::Body
}

fn count(candidate: &Candidate) -> f64 {
    unknowns(candidate.cause, &candidate.shape, candidate.gain.x.len())
}

/// Alternatives to a wrong link, the fewest unknowns first. They are causes with few unknowns on
/// the joint where the link gains most, or a payload that gains nearly as much. A link's ten
/// unknowns also absorb other errors of several joints, so it gains more than the cause whose error
/// it absorbs.
fn simpler(ranked: &[Candidate], link: &Candidate, main: usize) -> Vec<usize> {
    let simple = |c: &Candidate| {
        let steady = !c.cause.moves_time() && !c.cause.local() && !body(c);
        let few = steady && c.place == [main] && count(c) <= FEW;
        // A payload has as many unknowns as a link.
        let payload = c.cause.effect() == EffectKind::Payload && c.score > (1.0 - SAME_BODY) * link.score;
        c.score > 0.0 && few || payload
    };
    let mut tried: Vec<usize> = (0..ranked.len()).filter(|&i| simple(&ranked[i])).take(TRIED).collect();
    tried.sort_by(|&a, &b| count(&ranked[a]).total_cmp(&count(&ranked[b])));
    tried
}

/// Alternatives to a push, the best first: causes that act throughout the logs. Where an arm
/// accelerates most, three components of a force absorb more of a body's error than that body's
/// parameters, which must also fit the rest. A wall must gain more than the push: it also has the
/// freedom to touch where the push acts.
fn lasting(ranked: &[Candidate], push: &Candidate) -> Vec<usize> {
    let least = |c: &Candidate| if c.cause.effect() == push.cause.effect() { 1.0 } else { LASTING };
    let lasts = |c: &Candidate| !c.cause.local() && !c.cause.moves_time() && c.score > least(c) * push.score;
    (0..ranked.len()).filter(|&i| lasts(&ranked[i])).take(TRIED).collect()
}

/// Standard errors by which a link must predict better than a payload, which is likelier a priori.
const LINK: f64 = 2.5;

/// Which candidate is tried where one is the best.
pub(super) enum Tried {
    /// The best one itself.
    Itself,
    /// Another one in its place.
    Instead(usize),
    /// Neither: it is not accepted by itself.
    Neither,
}

impl Forward<'_, '_> {
    /// The first alternative to the link or the push at `at` beside which that candidate is no
    /// longer accepted.
    pub(super) fn that_suffices(
        &mut self,
        ranked: &[Candidate],
        at: usize,
        fitted: &Fitted,
        before: &LeftOut,
    ) -> Tried {
        let own = &ranked[at];
        let link = own.cause.effect() == EffectKind::LinkInertiaError;
        if !link && !own.cause.local() {
            return Tried::Itself;
        }
        let Some((main, left)) = self.held((ranked, at), fitted, before) else { return Tried::Neither };
        let others = if link { simpler(ranked, own, main) } else { lasting(ranked, own) };
        let other = others.into_iter().find(|&i| self.suffices((ranked, i), (own, &left), fitted, before));
        other.map_or(Tried::Itself, Tried::Instead)
    }

    /// The best link in place of a payload at `at`, if it gains more and is significantly better on
    /// left-out stretches. A payload has fewer unknowns, and approximates a link of the wrist.
    pub(super) fn link_that_predicts_better(
        &mut self,
        (ranked, at): (&[Candidate], usize),
        fitted: &Fitted,
        before: &LeftOut,
    ) -> Option<usize> {
        let own = Some(&ranked[at]).filter(|c| c.cause.effect() == EffectKind::Payload)?;
        let better = |c: &Candidate| c.cause.effect() == EffectKind::LinkInertiaError && c.score > own.score;
        let link = ranked.iter().position(better)?;
        let [(_, left), (_, others)] =
            [self.held((ranked, at), fitted, before)?, self.held((ranked, link), fitted, before)?];
        others.less(&left, self.noise).outweighs(LINK).then_some(link)
    }

    /// The joint on which a candidate gains most, and the errors of the model with it on left-out
    /// stretches; `None` where it is rejected.
    fn held(
        &mut self,
        (ranked, at): (&[Candidate], usize),
        fitted: &Fitted,
        before: &LeftOut,
    ) -> Option<(usize, LeftOut)> {
        self.with(&[&ranked[at]], fitted, |search, trial, after| {
            let holds = search.holds((ranked, at), trial, [fitted, after], before);
            holds.map(|_| (main_joint(fitted, after), search.tested.left_out(trial, after)))
        })
    }

    /// Whether a candidate is accepted, and the `other` is not in its presence. `others` are the
    /// errors with the latter on left-out stretches. A body that replaces a body must also predict
    /// as well.
    fn suffices(
        &mut self,
        (ranked, i): (&[Candidate], usize),
        (other, others): (&Candidate, &LeftOut),
        fitted: &Fitted,
        before: &LeftOut,
    ) -> bool {
        let worth = self.with(&[&ranked[i]], fitted, |search, trial, with| {
            search.holds((ranked, i), trial, [fitted, with], before)?;
            let again = evaluate(search.tested, with, other.cause, &other.place, &other.shape);
            Some((with.clone(), search.tested.left_out(trial, with), again.filter(|c| c.score > 0.0)))
        });
        let Some((with, left, again)) = worth else { return false };
        if body(&ranked[i]) && body(other) && others.less(&left, self.noise).sure() {
            return false;
        }
        let Some(again) = again else { return true };
        self.with(&[&ranked[i], &again], fitted, |search, trial, both| {
            search.holds((std::slice::from_ref(&again), 0), trial, [&with, both], &left).is_none()
        })
    }

    /// Evaluates `look` on the model with some candidates added, then restores the model, whose fit
    /// is `fitted`.
    fn with<T>(
        &mut self,
        parts: &[&Candidate],
        fitted: &Fitted,
        look: impl FnOnce(&Self, &[Chosen], &Fitted) -> T,
    ) -> T {
        let delays = self.tested.scene.delays.clone();
        let (frozen, separate) = (self.tested.frozen.clone(), self.tested.separate.clone());
        let mut trial = self.chosen.clone();
        for part in parts {
            match plain(part) {
                Some(k) => self.free(k, part),
                None => trial.push(part.chosen()),
            }
        }
        let with = self.tested.fit(&mut trial);
        let seen = look(self, &trial, &with);
        (self.tested.frozen, self.tested.separate) = (frozen, separate);
        self.tested.restore(&delays, fitted);
        seen
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnose::fit::moments::Gain;
    use crate::diagnose::hypotheses::{Hypothesis, by_name, laws};

    fn candidate(cause: &'static dyn Hypothesis, score: f64) -> Candidate {
        let gain = Gain { x: vec![1.0], rss: Vec::new() };
        Candidate { cause, place: Vec::new(), shape: Vec::new(), gain, score }
    }

    /// A wall must gain more than the push, a body half as much.
    #[test]
    fn alternatives_to_a_push() {
        let of = |local: bool| laws(EffectKind::ExternalContact).find(|c| c.local() == local).unwrap();
        let push = candidate(of(true), 100.0);
        let tried = |cause, score| !lasting(&[candidate(cause, score)], &push).is_empty();
        assert!(tried(of(false), 101.0) && !tried(of(false), 99.0));
        let payload = by_name("payload").unwrap();
        assert!(tried(payload, 51.0) && !tried(payload, 49.0));
        assert!(!tried(of(true), 500.0) && !tried(by_name("time_delay").unwrap(), 500.0));
    }
}
