//! Items to be reported: an accepted cause with the friction that belongs to it, or a friction term
//! that changed by itself.

use super::result::Cause;
use crate::diagnose::fit::model::{Chosen, Fitted, ModelUnderTest, given_friction};
use crate::diagnose::hypotheses::{AsymmetricFriction, Hypothesis, Kind, Named, PLAIN};
use crate::diagnose::search::judge::Accepted;

/// A cause to be reported.
pub(in crate::diagnose) struct Item {
    pub(in crate::diagnose) hypothesis: &'static dyn Hypothesis,
    pub(in crate::diagnose) place: Vec<usize>,
    /// Index among the accepted causes; `None` for a friction parameter.
    pub(in crate::diagnose) accepted: Option<usize>,
    /// Indices of the friction unknowns that belong to it.
    pub(in crate::diagnose) friction: Vec<usize>,
}

impl Item {
    /// Its unknowns in a fit.
    pub(in crate::diagnose) fn unknowns(&self, fitted: &Fitted) -> Vec<usize> {
        let friction = self.friction.iter().map(|k| fitted.friction + k);
        let own = self.accepted.iter().flat_map(|&i| (0..fitted.terms[i].len()).map(move |t| fitted.first[i] + t));
        friction.chain(own).collect()
    }

    /// A law of friction without the plain levels that belong to it; `None` if it has none.
    pub(in crate::diagnose) fn law_alone(&self) -> Option<Self> {
        let law = self.accepted.is_some() && self.hypothesis.kind() == Kind::Friction && !self.friction.is_empty();
        law.then(|| Self { friction: Vec::new(), place: self.place.clone(), ..*self })
    }

    /// The causes of the model without its own.
    pub(in crate::diagnose) fn others(&self, chosen: &[Chosen]) -> Vec<Chosen> {
        chosen.iter().enumerate().filter(|(i, _)| self.accepted != Some(*i)).map(|(_, c)| c.clone()).collect()
    }
}

/// Place of an item, in words.
pub(in crate::diagnose) fn place_of(place: &[usize]) -> String {
    match place {
        [] => "of the whole robot".into(),
        [j] => format!("of joint {}", j + 1),
        many => format!("of joints {}", many.iter().map(|j| (j + 1).to_string()).collect::<Vec<_>>().join(" and ")),
    }
}

/// The accepted causes, and the changed friction parameters that belong to none of them.
pub(in crate::diagnose) fn items(tested: &ModelUnderTest<'_>, accepted: &[Accepted], fitted: &Fitted) -> Vec<Item> {
    let mut items: Vec<Item> = accepted
        .iter()
        .enumerate()
        .map(|(index, a)| Item {
            hypothesis: a.chosen.cause,
            place: a.chosen.place.clone(),
            accepted: Some(index),
            friction: Vec::new(),
        })
        .collect();
    let given = given_friction(tested.plant);
    for j in 0..tested.scene.dof() {
        for (which, hypothesis) in PLAIN.into_iter().enumerate() {
            let k = 3 * j + which;
            if tested.frozen[k] || tested.quiet[k] {
                continue;
            }
            // If a friction law was found, the plain terms of the file are part of it.
            let owner = items.iter_mut().find(|i| {
                let friction = i.hypothesis.kind() == Kind::Friction && which < 2 && given[j][which].is_some();
                let shift = which == 2 && i.hypothesis.has_constant();
                i.accepted.is_some() && i.place == [j] && (friction || shift) && !tested.separate[k]
            });
            match owner {
                Some(owner) => owner.friction.push(k),
                None => items.push(Item { hypothesis, place: vec![j], accepted: None, friction: vec![k] }),
            }
        }
    }
    one_for_two(items, tested, fitted)
}

/// Least ratio of the smaller to the larger of a level and an offset for both to be reported as
/// levels that differ by direction.
pub(in crate::diagnose) const BESIDE: f64 = 0.15;

/// Largest ratio of an offset to a level for both to be reported as levels that differ by
/// direction. The larger of the two levels is then five times the smaller one.
const MOST_APART: f64 = 2.0 / 3.0;

/// Merges a changed Coulomb level and an offset on one joint into one cause with as many unknowns:
/// levels that differ with the direction, if friction can differ by so much.
pub(in crate::diagnose) fn one_for_two(
    mut items: Vec<Item>,
    tested: &ModelUnderTest<'_>,
    fitted: &Fitted,
) -> Vec<Item> {
    let given = given_friction(tested.plant);
    for (j, given) in given.iter().enumerate() {
        let plain = |which: usize| {
            let here = |i: &Item| i.accepted.is_none() && i.friction == [3 * j + which];
            items.iter().position(here).map(|at| (at, fitted.solution.x[fitted.friction + 3 * j + which]))
        };
        let (Some((level_at, level)), Some((offset_at, offset))) = (plain(1), plain(2)) else { continue };
        let (small, large) = (level.abs().min(offset.abs()), level.abs().max(offset.abs()));
        if small < BESIDE * large || offset.abs() > MOST_APART * (given[1].unwrap_or(0.0) + level) {
            continue;
        }
        items[level_at] = Item {
            hypothesis: &AsymmetricFriction,
            place: vec![j],
            accepted: None,
            friction: vec![3 * j + 1, 3 * j + 2],
        };
        items.remove(offset_at);
    }
    items
}

/// Values of the friction parameters that belong to an item.
pub(in crate::diagnose) fn friction_values(
    tested: &ModelUnderTest<'_>,
    fitted: &Fitted,
    covariance: &nalgebra::DMatrix<f64>,
    item: &Item,
) -> Vec<Named> {
    let given = given_friction(tested.plant);
    item.friction
        .iter()
        .map(|&k| {
            let (j, which, at) = (k / 3, k % 3, fitted.friction + k);
            let base = if which == 2 && item.accepted.is_none() { 0.0 } else { given[j][which].unwrap_or(0.0) };
            let std = covariance[(at, at)].max(0.0).sqrt();
            Named::new(PLAIN[which].key(), base + fitted.solution.x[at], Some(std))
        })
        .collect()
}

/// Friction in the model that is not reported as a change; for the file.
pub(in crate::diagnose) fn quiet(tested: &ModelUnderTest<'_>, fitted: &Fitted) -> Vec<Cause> {
    let covariance = fitted.covariance();
    (0..tested.quiet.len())
        .filter(|&k| tested.quiet[k] && !tested.frozen[k])
        .map(|k| {
            let hypothesis: &'static dyn Hypothesis = PLAIN[k % 3];
            let item = Item { hypothesis, place: vec![k / 3], accepted: None, friction: vec![k] };
            Cause {
                joints: vec![k / 3 + 1],
                keys: friction_values(tested, fitted, &covariance, &item),
                ..Cause::blank(hypothesis.name(), hypothesis.shown_by())
            }
        })
        .collect()
}
