//! Forward selection of causes: each candidate is compared with all others, until none is
//! supported.
//!
//! A candidate is a cause in a place. Its gain is the logarithm of the ratio of the joints'
//! residual sums of squares without and with it, all other unknowns refitted. Windows are counted
//! in units of the autocorrelation time of the residuals. A candidate is accepted under three
//! conditions:
//!
//! - Its gain exceeds the cost of its unknowns and of the number of candidates.
//! - Parts of the data that were not used to fit it confirm it.
//! - Its effect is large enough beside the noise.

pub(super) mod alone;
pub(super) mod baseline_friction;
pub(super) mod candidate;
pub(super) mod driving_friction;
pub(super) mod forward;
pub(super) mod judge;
pub(super) mod levels_instead;
pub(super) mod merge_bodies;
mod merge_common_delay;
pub(super) mod merge_couplings;
pub(super) mod merge_levels;
mod next_candidate;
pub(super) mod over_all_joints;
pub(super) mod position_band;
pub(super) mod shorter_push;
mod simplest_laws;
mod stepwise_exchange;
mod sufficient;
pub(super) mod support;

use super::fit::model::{Chosen, Fitted, Mode, ModelUnderTest};
use super::hypotheses::Hypothesis;
use candidate::{Candidate, candidates, rivals, sparest_first};
use judge::{Accepted, Judge, adopt};
use merge_bodies::merge_bodies;
use merge_common_delay::merge_common_delay;
use merge_couplings::merge_couplings;
use simplest_laws::simplest_laws;
use stepwise_exchange::stepwise_exchange;

/// Thresholds of the search.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SearchSettings {
    /// Maximum number of causes.
    pub most: usize,
    /// Least effect of a cause, as a share of the joint's raw torque noise.
    pub least_effect: f64,
    /// Least share of a joint's residual variance that a cause must remove, in the fit and in
    /// cross-validation.
    pub least_gain: f64,
    /// Least share of the variance removed by an earlier cause of the same kind on the same joint.
    /// A smaller gain is taken for the misfit of that earlier cause's law.
    pub least_share: f64,
}

impl Default for SearchSettings {
    fn default() -> Self {
        Self { most: 8, least_effect: 0.25, least_gain: 0.08, least_share: 0.03 }
    }
}

/// Autocorrelation time, in windows, above which a residual counts as slow: 10 windows, 0.1 s.
const SLOW: f64 = 10.0;

/// Number of best candidates that are tried, on whatever joints they act.
const BEST: usize = 4;

/// Whether the residual of one of these joints is slow.
fn slow(fitted: &Fitted, joints: &[usize]) -> bool {
    joints.iter().any(|&j| fitted.memory[j] > SLOW)
}

/// Forward selection from an empty model, followed by exchange and simplification of the causes.
pub fn search(
    tested: &mut ModelUnderTest<'_>,
    noise: &[f64],
    settings: &SearchSettings,
    progress: &(dyn Fn(&str) + Sync),
) -> Vec<Accepted> {
    let mut chosen: Vec<Chosen> = Vec::new();
    let mut accepted: Vec<Accepted> = Vec::new();
    let mut fitted = tested.fit(&mut []);
    while accepted.len() < settings.most {
        progress(&format!("{} found, looking for more", accepted.len()));
        let free = |cause: &'static dyn Hypothesis, place: &[usize]| {
            chosen.iter().filter(|c| c.cause.name() == cause.name() && c.place == place).count() < cause.most()
        };
        let wanted = |cause: &'static dyn Hypothesis, place: &[usize]| free(cause, place) && makes_sense(tested, cause);
        let mut ranked = candidates(tested, &fitted, &wanted);
        sparest_first(&mut ranked, tested, &chosen, &fitted);
        let tried = ranked.len().max(1);
        let mut taken = None;
        for (rank, candidate) in in_turn(&ranked) {
            let mut trial = [chosen.as_slice(), &[candidate.chosen()]].concat();
            let delays = tested.scene.delays.clone();
            let mut next = tested.fit(&mut trial);
            let mut judged =
                Judge { tested, noise, settings, accepted: &accepted, tried }.judge(&fitted, &next, &trial);
            if judged.is_none() && slow(&fitted, &candidate.place) {
                let held = tested.regulariser.clone();
                tested.release_joints(&candidate.place);
                next = tested.fit(&mut trial);
                let judge = Judge { tested, noise, settings, accepted: &accepted, tried };
                judged = judge.judge(&fitted, &next, &trial).filter(|_| !slow(&next, &candidate.place));
                if judged.is_none() {
                    tested.regulariser = held;
                }
            }
            match judged {
                Some(mut judged) => {
                    judged.rivals = rivals(&ranked, rank, &next);
                    let terms = next.terms.last().map_or(&[][..], |t| t.as_slice());
                    if let Some(other) = equivalent_robot_cause(tested, &judged.chosen, terms)
                        && let Some(last) = trial.last_mut()
                    {
                        *last = other.clone();
                        judged.chosen = other;
                    }
                    taken = Some((judged, trial));
                    break;
                }
                None if delays != tested.scene.delays => {
                    // Undo the delay of the rejected trial.
                    tested.set_delays(&delays);
                    fitted = tested.fit(&mut chosen);
                }
                None => {}
            }
        }
        let Some((judged, trial)) = taken else {
            let judge = Judge { tested: &*tested, noise, settings, accepted: &accepted, tried };
            if !judge.leaves_more_than_noise(&fitted) {
                break;
            }
            let Some((pair, trial, next)) = together(tested, &chosen, &fitted, &ranked, noise, settings, &accepted)
            else {
                fitted = tested.fit(&mut chosen);
                break;
            };
            accepted.extend(pair);
            (chosen, fitted) = (trial, next);
            adopt(&mut accepted, &chosen);
            continue;
        };
        chosen = trial;
        accepted.push(judged);
        fitted = tested.fit_regularised_beside(&mut chosen);
        adopt(&mut accepted, &chosen);
    }
    progress("weighing the causes against each other");
    stepwise_exchange(tested, &mut accepted, &mut fitted, noise, settings);
    simplify(tested, &mut accepted, &mut fitted);
    accepted
}

/// The order in which candidates are tried: the best ones, then the best on each further joint. A
/// large slow residual on one joint carries no information on the others.
fn in_turn(ranked: &[Candidate]) -> Vec<(usize, &Candidate)> {
    let mut order: Vec<(usize, &Candidate)> = ranked.iter().enumerate().take(BEST).collect();
    for (rank, candidate) in ranked.iter().enumerate().skip(BEST) {
        let new = order.iter().all(|(_, known)| known.place.first() != candidate.place.first());
        if new && candidate.score > 0.0 {
            order.push((rank, candidate));
        }
    }
    // If a body with ten parameters is rejected, one with fewer may be accepted.
    let simpler = |of: &Candidate| {
        let fewer = |c: &Candidate| {
            c.cause.name() == of.cause.name() && c.place == of.place && c.gain.x.len() < of.gain.x.len()
        };
        of.cause.within_links().then(|| ranked.iter().enumerate().find(|(_, c)| fewer(c))).flatten()
    };
    let mut all: Vec<(usize, &Candidate)> = Vec::new();
    for (rank, candidate) in order {
        for next in std::iter::once((rank, candidate)).chain(simpler(candidate)) {
            if all.iter().all(|(known, _)| *known != next.0) {
                all.push(next);
            }
        }
    }
    all
}

/// Merges bodies into one body, delays into one delay and couplings into one motor, and replaces
/// laws by simpler ones.
fn simplify(tested: &mut ModelUnderTest<'_>, accepted: &mut Vec<Accepted>, fitted: &mut Fitted) {
    merge_bodies(tested, accepted, fitted);
    merge_common_delay(tested, accepted, fitted);
    merge_couplings(tested, accepted, fitted);
    simplest_laws(tested, accepted, fitted);
}

/// Finds two causes that share a joint, neither of which is supported alone: without the other, the
/// residual is autocorrelated for so long that few windows count as independent. Each must be
/// accepted in the presence of the other.
fn together(
    tested: &mut ModelUnderTest<'_>,
    chosen: &[Chosen],
    fitted: &Fitted,
    ranked: &[Candidate],
    noise: &[f64],
    settings: &SearchSettings,
    accepted: &[Accepted],
) -> Option<([Accepted; 2], Vec<Chosen>, Fitted)> {
    let with = |others: &[Chosen], one: &Chosen| others.iter().chain([one]).cloned().collect::<Vec<Chosen>>();
    let first = |c: &&Candidate| !c.place.is_empty() && !c.cause.moves_time() && !c.cause.local();
    let held = tested.regulariser.clone();
    for first in ranked.iter().filter(first).take(3) {
        let was_slow = slow(fitted, &first.place);
        tested.regulariser.clone_from(&held);
        if was_slow {
            tested.release_joints(&first.place);
        }
        let mut alone = with(chosen, &first.chosen());
        let one = tested.fit(&mut alone);
        let first = alone.last()?.clone();
        let wanted = |cause: &'static dyn Hypothesis, place: &[usize]| {
            place.iter().any(|j| first.place.contains(j))
                && (cause.name() != first.cause.name() || place != first.place)
                && chosen.iter().all(|c| c.cause.name() != cause.name() || c.place != place)
                && !cause.moves_time()
                && !cause.local()
                && makes_sense(tested, cause)
        };
        let seconds = candidates(tested, &one, &wanted);
        let tried = ranked.len() * seconds.len().max(1);
        for (rank, second) in seconds.iter().take(2).enumerate() {
            let mut both = with(&alone, &second.chosen());
            let two = tested.fit(&mut both);
            if was_slow && slow(&two, &first.place) {
                continue;
            }
            let judge = Judge { tested: &*tested, noise, settings, accepted, tried };
            let Some(mut other) = judge.judge(&one, &two, &both) else { continue };
            let mut turned = with(chosen, &other.chosen);
            let without = tested.fit(&mut turned);
            turned.push(first.clone());
            let again = tested.fit(&mut turned);
            let judge = Judge { tested: &*tested, noise, settings, accepted, tried };
            let Some(own) = judge.judge(&without, &again, &turned) else { continue };
            other.rivals = rivals(&seconds, rank, &two);
            let two = tested.fit(&mut both);
            return Some(([own, other], both, two));
        }
    }
    tested.regulariser = held;
    None
}

/// The equivalent cause of the whole robot; `None` where there is none.
pub(super) fn equivalent_robot_cause(
    tested: &ModelUnderTest<'_>,
    chosen: &Chosen,
    terms: &[crate::diagnose::hypotheses::Term],
) -> Option<Chosen> {
    let cause = chosen.cause.equivalent_robot_cause(&tested.scene, &chosen.place, terms, &chosen.x)?;
    Some(Chosen { cause, place: Vec::new(), ..chosen.clone() })
}

/// Whether a cause is identifiable in this mode: link errors are not where all base parameters are
/// unknown.
pub(super) fn makes_sense(tested: &ModelUnderTest<'_>, cause: &dyn Hypothesis) -> bool {
    tested.mode == Mode::Trusted || !cause.within_links()
}
