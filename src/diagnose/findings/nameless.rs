//! Errors that match no known cause: closed-form laws that explain them, and the remaining
//! structure.

use super::attribution::{MOST_MARGIN, taken};
use super::calibration;
use super::formula::{self, Formula, formula};
use super::maps::View;
use super::result::{Cause, Errors, measured_on};
use super::structure::Structure;
use crate::diagnose::fit::model::{Fitted, ModelUnderTest};
use crate::diagnose::select::measure::{Measured, share, taken_of};
use crate::diagnose::select::refine_and_select::Session;
use crate::diagnose::select::suspects::without_neighbours;
use dh_codegen::robot::effects;

impl Session<'_> {
    /// Adds closed-form laws for the structure that is `left` to the causes, and subtracts them
    /// from the `errors` of the offered model, on fitted and validating logs. Returns the remaining
    /// structure. If the unchanged file is offered (`file_holds`), the laws are only reported.
    /// `torque`: root mean square of each joint's torque, N m.
    pub(in crate::diagnose) fn explained_by_formulas(
        &self,
        causes: &mut Vec<Cause>,
        left: Vec<Structure>,
        model: (&ModelUnderTest<'_>, &Fitted),
        [fit, validate]: [&mut Measured; 2],
        file_holds: bool,
        torque: &[f64],
    ) -> Vec<Structure> {
        if left.is_empty() {
            return left;
        }
        let views = [fit.view(self.plant, self.fit), validate.view(self.plant, self.validate)];
        let errors = [&mut *fit, &mut *validate];
        let laws = with_formulas(causes, &left, errors, &views, self.noise, self.own_validation, !file_holds);
        if laws.is_empty() || file_holds {
            return left;
        }
        let of_others = laws.iter().filter(|law| law.is_of_other_joints()).map(|law| law.joint);
        without_neighbours(causes, &of_others.collect::<Vec<usize>>());
        self.beyond(&laws, left, model, [fit, validate], torque)
    }

    /// Structure that remains with the laws, and that of other joints. `errors`: those with the
    /// laws.
    fn beyond(
        &self,
        laws: &[Formula],
        left: Vec<Structure>,
        model: (&ModelUnderTest<'_>, &Fitted),
        errors: [&Measured; 2],
        torque: &[f64],
    ) -> Vec<Structure> {
        let (scene, mut residual) = (&model.0.scene, model.1.residual.clone());
        for law in laws {
            let mut taken = law.along(&scene.states[scene.state_of_joint[law.joint]].by_joint());
            scene.masked(law.joint, &mut taken);
            residual[law.joint].iter_mut().zip(&taken).for_each(|(e, t)| *e -= t);
        }
        let lawful = |s: &Structure| laws.iter().any(|law| law.joint == s.joint);
        let others = left.into_iter().filter(|s| !lawful(s));
        let again = self.left_of(scene, &residual, errors, torque).into_iter().filter(lawful);
        others.chain(again).collect()
    }
}

/// Adds the remaining structure as a cause without a name. `errors`: of the file and of the model;
/// `floor`: noise of each joint's torque, N m; `noise`: unit of a gain, N m.
pub(in crate::diagnose) fn unknown(
    causes: &mut Vec<Cause>,
    left: &[Structure],
    errors: [&Errors; 2],
    floor: &[f64],
    noise: &[f64],
) {
    if left.is_empty() {
        return;
    }
    // A cause that acts in a part of a fitted log is visible there alone.
    let here = causes.iter().any(|c| c.on == "fit");
    let [baseline, rms] = errors.map(|e| if here { &e.fit[..] } else { &e.validate[..] });
    let mut left = left.to_vec();
    left.sort_by(|a, b| (b.rms / noise[b.joint].max(1e-12)).total_cmp(&(a.rms / noise[a.joint].max(1e-12))));
    let mut joints: Vec<usize> = Vec::new();
    left.iter().map(|s| s.joint + 1).for_each(|j| {
        if !joints.contains(&j) {
            joints.push(j)
        }
    });
    let sentences: Vec<&str> = left.iter().map(|s| s.description.as_str()).collect();
    let mut after = rms.to_vec();
    for s in &left {
        after[s.joint] = (rms[s.joint].powi(2) - s.rms.powi(2)).max(0.0).sqrt();
    }
    let entry = Cause {
        share: share(rms, &after, noise, &[]),
        joints,
        probability: left.iter().map(|s| calibration::structure(s.rms, floor[s.joint])).fold(0.0, f64::max),
        evidence: format!("structure is left that no listed cause explains: {}", sentences.join("; ")),
        rms_before: rms.to_vec(),
        rms_after: after,
        ..nameless()
    };
    // First, if more remains than the causes explain; else last, since it gains nothing.
    let most = causes.iter().map(|c| taken(c, noise)).fold(taken_of(baseline, rms, noise), f64::max);
    if taken(&entry, noise) > most {
        causes.insert(0, entry);
    } else {
        causes.push(entry);
    }
}

/// Adds laws of errors without a known cause to the causes, and subtracts them from the model's
/// errors; `left`: the structure of these errors. `floor`: noise of each joint's torque, N m.
/// `offered`: whether the offered model has the laws; otherwise they are only reported.
fn with_formulas(
    causes: &mut Vec<Cause>,
    left: &[Structure],
    [after_fit, after]: [&mut Measured; 2],
    views: &[View; 2],
    floor: &[f64],
    own_validation: bool,
    offered: bool,
) -> Vec<Formula> {
    let mut joints: Vec<usize> = left.iter().map(|s| s.joint).collect();
    joints.sort_unstable();
    joints.dedup();
    // With an encoder offset, the file would evaluate the law at another angle.
    let shifted = |j: usize| causes.iter().any(|c| c.cause == effects::EncoderOffset::NAME && c.joints == [j + 1]);
    joints.retain(|j| !shifted(*j));
    let law = |j: usize| {
        let [fit, validate] = [(&*after_fit, &views[0]), (&*after, &views[1])].map(|(m, v)| (v.motion(j), &m.error[j]));
        let errors = |(motion, error)| formula::Errors { motion, error };
        formula(j, errors((&fit.0[..], &fit.1[..])), errors((&validate.0[..], &validate.1[..])))
    };
    let found: Vec<Formula> = joints.into_iter().filter_map(law).collect();
    for law in &found {
        let before = after.rms.clone();
        if offered {
            for (measured, view) in [&mut *after_fit, &mut *after].into_iter().zip(views) {
                let motion = view.motion(law.joint);
                measured.explain(law.joint, &law.along(&motion), motion[law.joint][1]);
            }
        }
        let mut rms_after = before.clone();
        rms_after[law.joint] = law.validate[1];
        let size = (law.validate[0].powi(2) - law.validate[1].powi(2)).max(0.0).sqrt();
        causes.push(Cause {
            share: share(&before, &rms_after, floor, &[law.joint]),
            recurrence: law.stability,
            joints: vec![law.joint + 1],
            probability: calibration::structure(size, floor[law.joint]),
            evidence: law.sentence(measured_on("validate", own_validation)),
            rms_before: before,
            rms_after,
            on: "validate",
            law: Some(law.text.clone()),
            in_extended: offered,
            ..nameless()
        });
    }
    found
}

/// Common part of causes without a name.
fn nameless() -> Cause {
    let blank = Cause::blank("unknown", "a longer recording with slow and fast motion of the named joints");
    Cause { support: MOST_MARGIN, margin: MOST_MARGIN, ..blank }
}
