//! Removes causes from a model that errs more on validating logs with its causes than without any.
//!
//! One cause that does not carry over does not refute the others. A cause that pays over all joints
//! stays although one joint's error grows with it: other errors of that joint had cancelled a part.

use super::measure::{Meter, leave_out, taken_of};
use super::reduction::without;
use super::refine_and_select::{Found, Selected, Session};
use crate::diagnose::findings::reported_cause::{Item, items, place_of};
use crate::diagnose::search::forward::pays_as_a_whole;
use crate::diagnose::search::judge::chosen_of;
use crate::identify::ConsistentError;

/// Maximum number of causes removed from one model.
const MOST: usize = 6;

/// Result of pruning a model on the validating logs.
pub(super) enum Pruned<'a> {
    Holds(Box<Selected<'a>>),
    /// No model is left; a sentence on why.
    Fails(String),
}

impl<'a> Session<'a> {
    /// A model that does not fail beside the same links without causes (`bare`: their errors per
    /// log and joint, N m), or a sentence on why none is left. Causes are removed one after the
    /// other, first the one whose removal reduces the error on the validating logs most.
    pub(super) fn pruned(&self, mut model: Selected<'a>, bare: &[Vec<f64>]) -> Result<Pruned<'a>, ConsistentError> {
        let Some(sentence) = self.fails_on(&model, bare) else { return Ok(Pruned::Holds(Box::new(model))) };
        for _ in 0..MOST {
            (self.progress)("without what does not carry over to the validating logs");
            let Some(item) = self.least_missed(&mut model) else {
                let errors = self.errors_by_log(&model);
                let pays = errors.iter().zip(bare).all(|(own, bare)| pays_over_all(bare, own, self.scale));
                return Ok(if pays { Pruned::Holds(Box::new(model)) } else { Pruned::Fails(sentence) });
            };
            let Selected { mut tested, mut accepted, rivals, mut why, evidence, suspects, .. } = model;
            why.push(format!(
                "{} {} is not in the model: the validating logs are predicted better without it.",
                item.hypothesis.name(),
                place_of(&item.place)
            ));
            item.friction.iter().for_each(|&k| tested.frozen[k] = true);
            let out: Vec<usize> = item.accepted.into_iter().collect();
            let fitted = without(&mut tested, &mut accepted, &out);
            model = self.validated(tested, accepted, fitted, Found { rivals, why, evidence, suspects })?;
            if model.accepted.is_empty() {
                return Ok(Pruned::Fails(sentence));
            }
            if self.fails_on(&model, bare).is_none() {
                return Ok(Pruned::Holds(Box::new(model)));
            }
        }
        Ok(Pruned::Fails(sentence))
    }

    /// The cause whose removal gives the smallest error on the validating logs, of those that do not
    /// pay there. The model is left unchanged.
    fn least_missed(&self, model: &mut Selected<'a>) -> Option<Item> {
        let Selected { tested, accepted, fitted, after, .. } = model;
        let chosen = chosen_of(accepted);
        let mut meter = Meter::new(self.plant, self.validate, tested);
        let mut best: Option<(f64, Item)> = None;
        for item in items(tested, accepted, fitted) {
            let other = leave_out(self.plant, self.fit, &mut meter, tested, &chosen, &item, true);
            let gain = taken_of(&after.steady, &other.steady, self.scale);
            if !pays_over_all(&other.steady, &after.steady, self.scale)
                && best.as_ref().is_none_or(|(most, _)| gain > *most)
            {
                best = Some((gain, item));
            }
        }
        tested.fit(&mut chosen_of(accepted));
        best.map(|(_, item)| item)
    }
}

/// Whether what a change of the joints' errors, N m, wins over all joints outweighs what it loses.
/// Errors below `scale`, N m, do not count.
fn pays_over_all(before: &[f64], after: &[f64], scale: &[f64]) -> bool {
    let square = |error: &f64, s: &f64| (error * error + s * s).max(1e-24);
    let share = |((b, a), s): ((&f64, &f64), &f64)| 1.0 - square(a, s) / square(b, s);
    pays_as_a_whole(&before.iter().zip(after).zip(scale).map(share).collect::<Vec<f64>>())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Errors of a KUKA LWR 4+ without and with a payload: three joints improve, one errs more,
    /// because another error had cancelled a part of it.
    #[test]
    fn a_cause_that_pays_over_all_joints_is_not_removed() {
        let scale = [0.023, 0.546, 0.057, 0.210, 0.025, 0.012, 0.004];
        let without = [0.292, 0.460, 0.298, 0.338, 0.251, 0.104, 0.027];
        let with = [0.289, 0.289, 0.342, 0.203, 0.250, 0.084, 0.024];
        assert!(pays_over_all(&without, &with, &scale) && !pays_over_all(&with, &without, &scale));
        // What improves nothing, or loses more than half of what it wins, does not pay.
        assert!(!pays_over_all(&without, &without, &scale));
        let worse = [0.292, 0.460, 0.398, 0.238, 0.251, 0.104, 0.027];
        assert!(!pays_over_all(&without, &worse, &scale));
        assert!(!pays_over_all(&[1.0], &[2.0], &[10.0]) && !pays_over_all(&[0.0], &[0.0], &[0.0]));
    }
}
