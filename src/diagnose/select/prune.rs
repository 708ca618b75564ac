//! Removes causes from a model that errs more on validating logs with its causes than without any.
//!
//! One cause that does not carry over does not refute the others. A cause that pays over all joints
//! stays although one joint's error grows with it: other errors of that joint had cancelled a part.

use super::measure::{Meter, leave_out, taken_of};
use super::reduction::without;
use super::refine_and_select::{Found, Selected, Session};
use super::remark::Remark;
use crate::diagnose::findings::reported_cause::{Item, items};
use crate::diagnose::search::judge::chosen_of;
use crate::diagnose::search::over_all_joints::pays_over_all;
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
            why.push(Remark::on(
                item.hypothesis.name(),
                &item.place,
                "is not in the model: the validating logs are predicted better without it.",
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
