//! Joint refinement of the nonlinear numbers of all laws, by Gauss-Newton steps with everything
//! else refitted.
//!
//! The search refines each law separately, beside those found before. Strongly correlated numbers
//! (a Stribeck speed and its exponent, two orders of ripple) stop short of their optimum there.

use super::model::{Chosen, Fitted, ModelUnderTest};
use super::moments::Solution;
use super::uncertainty::derivative;
use crate::diagnose::hypotheses::{Sign, at_edge};
use crate::diagnose::windows::windowed_data::Column;

/// Maximum number of steps, and the shares of a step that are tried.
const STEPS: usize = 6;
const SHARES: [f64; 3] = [1.0, 0.4, 0.15];

/// Decrease of the misfit below which the iteration ends.
const LEAST: f64 = 0.1;

/// Largest change of a number in one step: this share of a number that is refined in relative
/// steps, or this many first steps of another.
const FARTHEST: f64 = 0.5;
const MOST_STEPS: f64 = 5.0;

/// Position of a number: index of its cause in the model, and index in the shape.
type Number = (usize, usize);

impl ModelUnderTest<'_> {
    /// Minimises the misfit over these numbers, and updates the causes. Sizes that are part of a
    /// shape are refined separately ([`ModelUnderTest::polish`]).
    pub(super) fn polish_shapes(&mut self, chosen: &mut [Chosen], mut fitted: Fitted) -> Fitted {
        for _ in 0..STEPS {
            let Some(step) = self.step(&fitted, chosen) else { break };
            let known = misfit(&fitted);
            let better = SHARES.into_iter().find_map(|share| {
                let mut trial = chosen.to_vec();
                for ((index, k), by) in &step {
                    let number = &trial[*index].cause.shape()[*k];
                    let value = &mut trial[*index].shape[*k];
                    let most = match number.step {
                        Some(first) if first > 0.0 => FARTHEST * value.abs(),
                        first => MOST_STEPS * first.unwrap_or(0.0).abs(),
                    };
                    *value = (*value + (share * by).clamp(-most, most)).clamp(number.range[0], number.range[1]);
                }
                self.better(trial, known)
            });
            let Some((trial, next)) = better else { break };
            let gained = known - misfit(&next);
            chosen.clone_from_slice(&trial);
            fitted = next;
            if gained < LEAST {
                break;
            }
        }
        fitted
    }

    /// A model with its fit, if its misfit is below `known` and each of its causes remains valid.
    fn better(&mut self, mut trial: Vec<Chosen>, known: f64) -> Option<(Vec<Chosen>, Fitted)> {
        let shows = |c: &Chosen| !at_edge(c.cause, &c.shape) && c.cause.shows(&self.scene, &c.place, &c.shape);
        if !trial.iter().all(shows) || self.unresolved(&trial) {
            return None;
        }
        let next = self.fit(&mut trial);
        let stands = trial.iter().zip(&next.terms).all(|(c, terms)| {
            let signed = terms.iter().zip(&c.x).all(|(term, x)| term.sign != Sign::Positive || *x > 0.0);
            !terms.is_empty() && signed && c.cause.plausible(&self.scene, &c.place, &c.shape, &c.x)
        });
        (stands && misfit(&next) < known).then_some((trial, next))
    }

    /// Whether two of these laws are one to the data.
    pub(in crate::diagnose) fn unresolved(&self, chosen: &[Chosen]) -> bool {
        let same = |a: &Chosen, b: &Chosen| {
            a.cause.name() == b.cause.name()
                && a.place == b.place
                && a.shape.len() == b.shape.len()
                && a.cause.unresolved(&self.scene, &a.place, &a.shape, &b.shape)
        };
        (0..chosen.len()).any(|k| chosen[..k].iter().any(|other| same(other, &chosen[k])))
    }

    /// The Gauss-Newton step of all numbers; `None` where there are none.
    fn step(&self, fitted: &Fitted, chosen: &[Chosen]) -> Option<Vec<(Number, f64)>> {
        let (mut numbers, mut columns): (Vec<Number>, Vec<Column>) = (Vec::new(), Vec::new());
        for (index, c) in chosen.iter().enumerate().filter(|(_, c)| moves(c)) {
            for (k, number) in c.cause.shape().iter().enumerate() {
                // An integer order stays an integer.
                let Some(first) = number.step.filter(|_| !c.integer(k)) else { continue };
                if let Some(column) = derivative(self, fitted, index, c, k, first) {
                    numbers.push((index, k));
                    columns.push(column);
                }
            }
        }
        if numbers.is_empty() {
            return None;
        }
        let columns: Vec<&Column> = columns.iter().collect();
        let solution = fitted.moments.with(&columns).solve(Some(&fitted.solution.weights));
        let behind = fitted.solution.x.len();
        let step: Vec<(Number, f64)> = numbers.into_iter().zip(solution.x.iter().skip(behind).copied()).collect();
        step.iter().all(|(_, by)| by.is_finite()).then_some(step)
    }
}

/// Whether the numbers of a cause are refined here.
fn moves(chosen: &Chosen) -> bool {
    let cause = chosen.cause;
    !cause.unit() && !cause.moves_time() && !cause.local() && !chosen.x.is_empty()
}

/// Twice the negative log-likelihood, up to a constant.
pub(super) fn misfit(fitted: &Fitted) -> f64 {
    let Solution { rss, counts, .. } = &fitted.solution;
    rss.iter().zip(counts).map(|(r, n)| n * r.max(1e-290).ln()).sum()
}
