//! Error above the noise, and error that occurs on the validating logs and not on the fitted ones.

use super::measure::{Measured, Meter, taken_of};
use super::refine_and_select::{Selected, Session};
use crate::diagnose::findings::evidence::short;
use crate::diagnose::findings::result::Cause;
use crate::diagnose::findings::structure::Structure;
use crate::diagnose::fit::model::{Chosen, Fitted, Mode, ModelUnderTest};
use crate::diagnose::search::judge::chosen_of;
use crate::diagnose::windows::recording::Recording;
use crate::model::PerturbableArm;
use crate::numerics::sums::root_mean_square;

/// Ratio of error to noise floor above which it is more than noise.
pub(in crate::diagnose) const EXCESS: f64 = 1.5;

/// The same ratio over all samples where the joint moves, including those about its reversals.
const ABOUT_REVERSALS: f64 = 2.5;

/// Ratio of the error on the validating logs to that on the worst left-out stretch of the fitted
/// ones, above which the logs may be of different robots.
pub(in crate::diagnose) const CHANGED: f64 = 1.6;

/// The same ratio for one model fitted to all logs, above which they are of different robots.
const APART: f64 = 1.3;

/// Share of a joint's squared error above which it is nearly all explained.
const NEARLY: f64 = 0.8;

/// Sum over joints of the logarithms of error ratios above which a model is worse.
pub(super) const WORSE: f64 = 0.02;

/// Joints whose error exceeds the floor on fitted and validating logs alike. `floor`: error of each
/// joint's torque with a correct model, N m.
pub(in crate::diagnose) fn excess([fit, validate]: [&Measured; 2], floor: &[f64]) -> Vec<Structure> {
    let joint = |j: usize| {
        let least = |of: &dyn Fn(&Measured) -> f64| of(validate).min(of(fit));
        let rms = least(&|m| m.swift[j]).max(least(&|m| m.steady[j]) * EXCESS / ABOUT_REVERSALS);
        (rms > EXCESS * floor[j]).then(|| Structure {
            joint: j,
            rms: (rms * rms - floor[j] * floor[j]).sqrt(),
            description: format!(
                "joint {} is missed by {} N m where noise explains {}",
                j + 1,
                short(rms),
                short(floor[j])
            ),
        })
    };
    (0..floor.len()).filter_map(joint).collect()
}

/// Local misfit: ratio of error to floor in a stretch in which a joint moves, length of a stretch,
/// s, and least total length of such stretches, s.
const WITHIN: f64 = 5.0;
const STRETCH: f64 = 0.25;
const TOGETHER: f64 = 0.5;

/// Joints with large errors in some stretches of the fitted logs although the whole looks like
/// noise, such as backlash that shows when the load reverses.
pub(in crate::diagnose) fn here_and_there(fit: &Measured, floor: &[f64]) -> Vec<Structure> {
    let joint = |j: usize| {
        let stretches = fit.stretches(j, STRETCH).filter(|(_, rms)| *rms > WITHIN * floor[j]);
        let found: Vec<([f64; 2], f64)> = stretches.collect();
        let [first, last] = [found.first()?.0[0], found.last()?.0[1]];
        let rms = (found.iter().map(|(_, rms)| rms * rms).sum::<f64>() / found.len() as f64).sqrt();
        (found.len() as f64 * STRETCH >= TOGETHER).then(|| Structure {
            joint: j,
            rms,
            description: format!(
                "joint {} is missed by {} N m in {} s between {} and {} s of the fitted logs, where noise explains {}",
                j + 1,
                short(rms),
                short(found.len() as f64 * STRETCH),
                short(first),
                short(last),
                short(floor[j])
            ),
        })
    };
    (0..floor.len()).filter_map(joint).collect()
}

/// Adds joints that have excess error but no structure.
pub(in crate::diagnose) fn with_excess(mut found: Vec<Structure>, more: Vec<Structure>) -> Vec<Structure> {
    let there: Vec<usize> = found.iter().map(|s| s.joint).collect();
    found.extend(more.into_iter().filter(|m| !there.contains(&m.joint)));
    found
}

/// Drops structure of joints where one of these causes explains nearly all of the error.
pub(in crate::diagnose) fn explained(left: Vec<Structure>, by: &[Cause]) -> Vec<Structure> {
    let none = |s: &Structure| by.iter().any(|c| c.joints == [s.joint + 1] && c.share > NEARLY);
    left.into_iter().filter(|s| !none(s)).collect()
}

/// Errors of a model on each log separately, where joints move, N m.
pub(in crate::diagnose) fn by_log(
    plant: &dyn PerturbableArm,
    logs: &[Recording],
    tested: &ModelUnderTest<'_>,
    fitted: &Fitted,
    chosen: &[Chosen],
) -> Vec<Vec<f64>> {
    let of =
        |log: &Recording| Meter::new(plant, std::slice::from_ref(log), tested).of(tested, fitted, chosen, true).steady;
    logs.iter().map(of).collect()
}

impl Session<'_> {
    /// Joints, from 0, that differ between fitted and validating logs. Their error on the latter is
    /// far larger than on any left-out stretch of the former, also with one model fitted to both.
    /// Without that second test, a joint that the fitted logs hardly excite would count.
    pub(in crate::diagnose) fn changed(&self, model: &Selected<'_>, floor: &[f64]) -> Vec<usize> {
        let elsewhere = |j: usize| model.left_out.worst(j).max(model.after_fit.steady[j]).max(EXCESS * floor[j]);
        let missed: Vec<usize> = (0..floor.len()).filter(|&j| model.after.steady[j] > CHANGED * elsewhere(j)).collect();
        if missed.is_empty() {
            return missed;
        }
        let all = [self.fit, self.validate].concat();
        let mut tested =
            ModelUnderTest::new(self.plant, &all, self.rate(), Mode::Refitted, &model.tested.scene.delays, false);
        let mut chosen = chosen_of(&model.accepted);
        let fitted = tested.fit(&mut chosen);
        let of = |logs| Meter::new(self.plant, logs, &tested).of(&tested, &fitted, &chosen, true).steady;
        let [fit, validate] = [of(self.fit), of(self.validate)];
        missed.into_iter().filter(|&j| fit[j].max(validate[j]) > APART * elsewhere(j)).collect()
    }

    /// Structure of joints that differ between the fitted part of the logs and the last part, which
    /// was kept out of the fit; none if there are validating logs.
    pub(in crate::diagnose) fn late(&self, model: &Selected<'_>) -> Vec<Structure> {
        if self.own_validation {
            return Vec::new();
        }
        let structure = |joint: usize| {
            let [rms, before] = [model.after.steady[joint], model.after_fit.steady[joint]];
            Structure {
                joint,
                rms: (rms * rms - before * before).max(0.0).sqrt(),
                description: format!(
                    "joint {} is missed by {} N m on the last part of the logs and by {} on the part that was fitted: \
                     the robot or its motion is another there",
                    joint + 1,
                    short(rms),
                    short(before)
                ),
            }
        };
        self.changed(model, self.noise).into_iter().map(structure).collect()
    }

    /// Validating logs, by name, on which a model errs more than a plain refit (its errors by log).
    /// The limit is a fiftieth over all joints in units of `scale`, or on one joint a tenth and the
    /// noise.
    pub(in crate::diagnose) fn worse_on(&self, model: &Selected<'_>, refit: &[Vec<f64>]) -> Vec<String> {
        let own = self.errors_by_log(model);
        let pairs = own.iter().zip(refit).zip(self.validate);
        let worse = pairs.filter(|((own, refit), _)| worse(own, refit, self.scale, self.noise));
        worse.map(|(_, log)| log.name.clone()).collect()
    }

    /// Whether a model errs more than another (its errors by log) on every validating log, over all
    /// joints.
    pub(super) fn worse_as_a_whole(&self, model: &Selected<'_>, other: &[Vec<f64>]) -> bool {
        let own = self.errors_by_log(model);
        own.iter().zip(other).all(|(own, other)| taken_of(own, other, self.scale) > WORSE)
    }

    /// Errors of a model on each validating log, per joint, N m.
    pub(super) fn errors_by_log(&self, model: &Selected<'_>) -> Vec<Vec<f64>> {
        by_log(self.plant, self.validate, &model.tested, &model.fitted, &chosen_of(&model.accepted))
    }
}

/// Error ratio above which a model is worse whatever the joint: logs differ by a tenth.
pub(super) const TENTH: f64 = 1.1;

/// Whether errors `own` exceed `times` the others on every log, root mean square over joints.
pub(super) fn exceed(own: &[Vec<f64>], other: &[Vec<f64>], times: f64) -> bool {
    own.iter().zip(other).all(|(own, other)| root_mean_square(own) > times * root_mean_square(other))
}

/// Whether errors `own` are larger than those of a refit, N m per joint.
fn worse(own: &[f64], refit: &[f64], scale: &[f64], noise: &[f64]) -> bool {
    let joint = |((a, b), s): ((&f64, &f64), &f64)| a * a > 1.21 * b * b + s * s;
    taken_of(own, refit, scale) > WORSE || own.iter().zip(refit).zip(noise).any(joint)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An error of ten times the noise for half a second in 30 s is found where the joint moves. A
    /// single stretch is not.
    #[test]
    fn a_stretch_that_is_missed_by_far_is_said() {
        let of = |wrong: usize, moves: bool| {
            let error =
                |k: usize| if (1000..1000 + wrong).contains(&k) { 1.0 } else { 0.1 * (-1.0_f64).powi(k as i32) };
            Measured::made(vec![(0..3000).map(error).collect()], vec![vec![moves; 3000]])
        };
        let found = here_and_there(&of(50, true), &[0.1]);
        assert!(found.len() == 1 && found[0].description.contains("in 0.500 s between 10.00 and 10.49 s"), "{found:?}");
        assert!(here_and_there(&of(25, true), &[0.1]).is_empty() && here_and_there(&of(50, false), &[0.1]).is_empty());
    }

    #[test]
    fn a_tenth_on_every_log_is_worse() {
        let refit = [vec![1.0, 0.1], vec![2.0, 0.1]];
        assert!(exceed(&[vec![1.2, 0.1], vec![2.3, 0.1]], &refit, TENTH));
        assert!(!exceed(&[vec![1.2, 0.1], vec![2.1, 0.1]], &refit, TENTH));
        // A joint with small torques decides nothing.
        assert!(!exceed(&[vec![1.0, 0.3], vec![2.0, 0.3]], &refit, TENTH));
    }

    #[test]
    fn one_joint_that_is_much_worse_counts() {
        let (scale, noise) = ([0.1; 3], [0.05; 3]);
        assert!(!worse(&[1.0; 3], &[1.0; 3], &scale, &noise));
        assert!(worse(&[0.2, 0.2, 1.3], &[1.0; 3], &scale, &noise));
        assert!(worse(&[1.05; 3], &[1.0; 3], &scale, &noise));
        // Differences within the noise do not count.
        assert!(!worse(&[0.0, 0.0, 0.04], &[0.0; 3], &[1.0; 3], &noise));
    }
}
