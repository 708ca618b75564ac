//! Replaces a cause by a law of other joints' motion that it approximated.
//!
//! The vocabulary has no friction that depends on the position of another joint. For such an error
//! the search accepts the nearest law of the joint's own position or direction, and a formula then
//! takes the remainder. If the formula alone leaves no larger error, it is the cause.

use super::measure::{Measured, Meter, leave_out};
use super::reduction::without;
use super::refine_and_select::{Found, Selected, Session};
use super::remark::Remark;
use crate::diagnose::findings::formula::{Errors, Formula, formula};
use crate::diagnose::findings::maps::View;
use crate::diagnose::findings::reported_cause::{Item, items};
use crate::diagnose::findings::result::Cause;
use crate::diagnose::search::judge::chosen_of;
use crate::identify::ConsistentError;

/// Factor by which the error with a law alone may exceed that with a cause beside it.
const AS_GOOD: f64 = 1.05;

/// Least ratio of the error with a cause alone to that with a law alone. A cause that errs less has
/// its name: where two joints move alike, a law of the other joint fits as well.
const WORSE_ALONE: f64 = 1.1;

impl<'a> Session<'a> {
    /// The model without causes of single joints that a law replaces; these are no longer suspects.
    /// `torque`: root mean square of each joint's torque, N m; `said`: sentences on what is not in
    /// the model.
    pub(in crate::diagnose) fn law_instead(
        &self,
        mut model: Selected<'a>,
        torque: &[f64],
        suspects: &mut Vec<Cause>,
        said: &mut Vec<Remark>,
    ) -> Result<Selected<'a>, ConsistentError> {
        while let Some((item, law)) = self.near_a_law(&mut model, torque) {
            let Selected { mut tested, mut accepted, rivals, why, mut evidence, suspects: mut known, .. } = model;
            let predicate = format!("is not in the model: {} says as much in its place.", law.text);
            said.push(Remark::on(item.hypothesis.name(), &item.place, &predicate));
            let is_it = |c: &Cause| c.cause == item.hypothesis.name() && c.joints == [law.joint + 1];
            suspects.retain(|c| !is_it(c));
            known.retain(|c| !is_it(c));
            evidence.retain(|e| e.effect != item.hypothesis.effect() || e.place != item.place);
            item.friction.iter().for_each(|&k| tested.frozen[k] = true);
            let out: Vec<usize> = item.accepted.into_iter().collect();
            let fitted = without(&mut tested, &mut accepted, &out);
            model = self.validated(tested, accepted, fitted, Found { rivals, why, evidence, suspects: known })?;
            said.append(&mut model.why);
        }
        Ok(model)
    }

    /// A cause on a joint with remaining structure that a law can replace. The model is left
    /// unchanged.
    fn near_a_law(&self, model: &mut Selected<'a>, torque: &[f64]) -> Option<(Item, Formula)> {
        let missed: Vec<usize> = self.left(model, torque).iter().map(|s| s.joint).collect();
        let Selected { tested, accepted, fitted, after, after_fit, .. } = model;
        let chosen = chosen_of(accepted);
        let near = |item: &Item| {
            let here = item.place.len() == 1 && missed.contains(&item.place[0]);
            here && item.accepted.is_some() && !item.hypothesis.local() && !item.hypothesis.moves_time()
        };
        let near: Vec<Item> = items(tested, accepted, fitted).into_iter().filter(near).collect();
        if near.is_empty() {
            return None;
        }
        let mut meters = [self.fit, self.validate].map(|data| Meter::new(self.plant, data, tested));
        let views = [after_fit.view(self.plant, self.fit), after.view(self.plant, self.validate)];
        let mut found = None;
        for item in near {
            let joint = item.place[0];
            let known = law(joint, &views, [after_fit, after]).map_or(after.rms[joint], |law| law.validate[1]);
            let [fit, validate] = &mut meters;
            let mut alone = |meter: &mut Meter<'a>, elsewhere| {
                leave_out(self.plant, self.fit, meter, tested, &chosen, &item, elsewhere)
            };
            let others = [alone(fit, false), alone(validate, true)];
            let same = |j: usize| j == joint || others[1].rms[j] <= AS_GOOD * after.rms[j];
            let stands = |law: &Formula| law.is_of_other_joints() && replaces(law.validate[1], known, after.rms[joint]);
            let instead = law(joint, &views, [&others[0], &others[1]]).filter(stands);
            if let Some(law) = instead.filter(|_| (0..after.rms.len()).all(same)) {
                found = Some((item, law));
                break;
            }
        }
        // Restore the scene's model, which is that of the last fit.
        tested.update_model(fitted);
        found
    }
}

/// Whether a law replaces a cause, by the errors of its joint with the law alone, with a law beside
/// the cause (`both`), and with the cause alone, N m.
fn replaces(law: f64, both: f64, cause: f64) -> bool {
    law <= AS_GOOD * both && WORSE_ALONE * law <= cause
}

/// The law of a joint's errors on fitted and validating logs.
fn law(joint: usize, [fit, validate]: &[View; 2], errors: [&Measured; 2]) -> Option<Formula> {
    let motion = [fit.motion(joint), validate.motion(joint)];
    let of = |k: usize| Errors { motion: &motion[k], error: &errors[k].error[joint] };
    formula(joint, of(0), of(1))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A law replaces a cause that only came near to it: alone the cause errs more. One that errs as
    /// much is not replaced.
    #[test]
    fn a_cause_that_suffices_keeps_its_name() {
        assert!(replaces(0.2, 0.2, 0.5));
        assert!(!replaces(0.2, 0.2, 0.2) && !replaces(0.2, 0.2, 0.21));
        assert!(!replaces(0.3, 0.2, 0.5));
    }
}
