//! Tests causes found with the file's links again beside refitted links.
//!
//! If the file's links are wrong altogether, the search that keeps them accepts the causes that
//! resemble their errors best: a shared motor, a tilt, a spring. Refitted links explain those
//! errors, and beside them such a cause gains nothing. A true cause still does.

use super::model_choice::LeftOut;
use super::offer::Rival;
use super::refine_and_select::{Selected, Session};
use super::remark::Remark;
use super::suspects::remember;
use crate::diagnose::findings::attribution::plain_support;
use crate::diagnose::findings::calibration::{self, Change};
use crate::diagnose::findings::links::ONE_BODY;
use crate::diagnose::findings::result::Cause;
use crate::diagnose::fit::model::{Chosen, Fitted, Mode, ModelUnderTest, given_friction};
use crate::diagnose::fit::uncertainty::Uncertainty;
use crate::diagnose::hypotheses::{Hypothesis as _, Kind, PLAIN, by_name};
use crate::diagnose::search::candidate::candidates;
use crate::diagnose::search::judge::chosen_of;

/// Least joint error above the noise by which a share is divided, in units of the noise.
const LEAST: f64 = 0.5;

/// Share of a joint's squared error on left-out stretches that a body must remove for the joint to
/// count when it is compared with refitted links.
const SHOWN: f64 = 0.1;

/// Evidence for a cause beside everything else in a model.
pub(in crate::diagnose) struct Worth {
    /// Largest share of the squared error of one of its joints, above the noise, that it removes on
    /// left-out stretches of the fitted logs.
    share: f64,
    /// Wald statistic, see [`Change::wald`].
    wald: f64,
}

impl Worth {
    /// Probability of a cause that nothing else explains and other data confirm.
    pub(in crate::diagnose) fn probability(&self) -> f64 {
        let Self { share, wald } = *self;
        calibration::change(&Change { share, wald, margin: f64::INFINITY, confirmed: true })
    }
}

impl<'a> Session<'a> {
    /// Merges the suspects of the searches with the file's and with refitted links, each with its
    /// probability beside the offered model. One of joints that the file's links predict as well
    /// (`rival`) keeps its probability beside those links.
    pub(in crate::diagnose) fn suspected(
        &self,
        [mut of_file, of_refit]: [Vec<Cause>; 2],
        model: &mut Selected<'a>,
        rival: Option<&Rival>,
        why: &mut Vec<Remark>,
    ) -> Vec<Cause> {
        if model.tested.mode == Mode::Refitted {
            let (kept, mut others): (Vec<Cause>, Vec<Cause>) =
                of_file.into_iter().partition(|c| rival.is_some_and(|rival| rival.suffices(c, &model.left_out)));
            self.beside_other_links(model, &mut others, why);
            of_file = [kept, others].concat();
        }
        remember(&mut of_file, &of_refit);
        of_file
    }

    /// Limits the probability of suspects of the file's links to that beside the refitted links of
    /// the offered model. Adds to `why` a sentence on each that is not named for this reason.
    fn beside_other_links(&self, model: &mut Selected<'a>, suspects: &mut [Cause], why: &mut Vec<Remark>) {
        let named = |s: &Cause| s.probability >= calibration::NAMED && s.window().is_none();
        for suspect in suspects.iter_mut().filter(|s| named(s)) {
            let place: Vec<usize> = suspect.joints.iter().map(|j| j - 1).collect();
            let Some(cause) = by_name(suspect.cause) else { continue };
            let most = match cause.within_links() {
                true => suspect.probability * self.part_of_links(model, suspect.cause, &place),
                false => self.likely_beside(model, suspect.cause, &place),
            };
            suspect.probability = suspect.probability.min(most);
            if most < calibration::NAMED && !model.causes.iter().any(|c| c.is(suspect)) {
                let predicate = format!(
                    "is not named: beside refitted links its probability is {most:.2}; the file's links ask for it."
                );
                why.push(Remark::on(suspect.cause, &place, &predicate).with_probability(most));
            }
        }
        model.tested.update_model(&model.fitted);
    }

    /// Probability of a cause that is no body, beside the model's links.
    fn likely_beside(&self, model: &mut Selected<'a>, name: &str, place: &[usize]) -> f64 {
        let Selected { tested, accepted, .. } = model;
        let (frozen, delays) = (tested.frozen.clone(), tested.scene.delays.clone());
        let mut others = chosen_of(accepted);
        others.retain(|c| c.cause.name() != name || c.place != place);
        let worth = worth(tested, &mut others, (name, place), self.noise);
        tested.frozen = frozen;
        tested.set_delays(&delays);
        worth.map_or(0.0, |worth| worth.probability())
    }

    /// Gain of one body of the file's links on left-out stretches, relative to the gain of the
    /// refitted links and to [`ONE_BODY`]; at most 1. Only joints that the body improves count: what
    /// refitted links gain on the others has a cause of its own.
    fn part_of_links(&self, model: &Selected<'a>, name: &str, place: &[usize]) -> f64 {
        let Selected { tested, accepted, .. } = model;
        let mut believed =
            ModelUnderTest::new(self.plant, self.fit, self.rate(), Mode::Trusted, &tested.scene.delays, false);
        believed.frozen = tested.frozen.clone();
        let mut others = chosen_of(accepted);
        let file = believed.fit(&mut others);
        let known = believed.left_out(&others, &file);
        let body = candidates(&believed, &file, &|c, p| c.name() == name && p == place);
        let Some(body) = body.first() else { return 0.0 };
        others.push(body.chosen());
        let with = believed.fit(&mut others);
        let with = believed.left_out(&others, &with);
        let shown: Vec<usize> = (0..self.ground.len()).filter(|&j| shows(&known, &with, self.ground, j)).collect();
        if shown.is_empty() {
            return 0.0;
        }
        let (known, ground) = (known.of(&shown), shown.iter().map(|&j| self.ground[j]).collect::<Vec<f64>>());
        let [body, links] = [&with, &model.left_out].map(|m| m.of(&shown).less(&known, &ground));
        if links.gain > 0.0 { (body.gain / links.gain / ONE_BODY).clamp(0.0, 1.0) } else { 1.0 }
    }
}

/// Evidence for a cause beside a model with the causes `others`; `None` where no plausible size of
/// it gains anything. `noise`: of each joint's torque, N m. Leaves `tested` with the cause, its
/// friction included.
pub(in crate::diagnose) fn worth(
    tested: &mut ModelUnderTest<'_>,
    others: &mut Vec<Chosen>,
    (name, place): (&str, &[usize]),
    noise: &[f64],
) -> Option<Worth> {
    let plain = PLAIN.iter().position(|p| p.name() == name).zip(place.first()).map(|(which, j)| 3 * j + which);
    match plain {
        Some(term) => tested.frozen[term] = true,
        None if by_name(name)?.kind() == Kind::Friction => keep_friction(tested, place),
        None => {}
    }
    let before = tested.fit(others);
    let known = left_out(tested, others, &before);
    match plain {
        Some(term) => tested.frozen[term] = false,
        None => others.push(candidates(tested, &before, &|c, p| c.name() == name && p == place).first()?.chosen()),
    }
    let after = tested.fit(others);
    let wald = match (plain, others.last()) {
        (Some(term), _) => plain_support(&after, &after.covariance(), &[term]),
        (None, last) => Uncertainty::of(tested, &after, others).wald(tested, &after, others.len() - 1, last?),
    };
    let out = left_out(tested, others, &after);
    let share = |j: usize| {
        let ([a, b], noise) = ([&known, &out].map(|m| m.joint_rms(j).powi(2)), noise[j].powi(2));
        (a - b) / (a - noise).max(LEAST.powi(2) * noise).max(f64::MIN_POSITIVE)
    };
    let own = |j: &usize| place.is_empty() || place.contains(j);
    let share = (0..noise.len()).filter(own).map(share).fold(0.0, f64::max);
    Some(Worth { share, wald })
}

/// Whether the errors of joint `j` on left-out stretches are smaller with a body than without it.
fn shows(without: &LeftOut, with: &LeftOut, ground: &[f64], j: usize) -> bool {
    let [a, b] = [without, with].map(|out| out.joint_rms(j).powi(2));
    a - b > SHOWN * (a + ground[j].powi(2))
}

/// Fixes the file's friction of the joints of a place: a friction law is a change of it.
fn keep_friction(tested: &mut ModelUnderTest<'_>, place: &[usize]) {
    let given = given_friction(tested.plant);
    for &j in place {
        for which in (0..3).filter(|which| given[j][*which].is_some()) {
            tested.frozen[3 * j + which] = true;
        }
    }
}

/// Errors on left-out stretches, from the fit within physical limits where it exists.
fn left_out(tested: &ModelUnderTest<'_>, chosen: &[Chosen], fitted: &Fitted) -> LeftOut {
    tested.possible_left_out(chosen, fitted).unwrap_or_else(|_| tested.left_out(chosen, fitted))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Joint 1 errs half as much with the body, joint 2 by 2.5 % less, joint 3 below its noise.
    #[test]
    fn a_body_counts_on_the_joints_that_it_improves() {
        let of = |squares: [f64; 3]| LeftOut::new(&[squares.to_vec(), squares.to_vec()], &vec![vec![1.0; 3]; 2]);
        let (without, with) = (of([4.0, 4.0, 0.01]), of([1.0, 3.8, 0.001]));
        let shown: Vec<usize> = (0..3).filter(|&j| shows(&without, &with, &[0.5; 3], j)).collect();
        assert_eq!(shown, [0]);
        // On that joint alone the gain is not diluted by the others.
        let [own, all] = [&[0][..], &[0, 1, 2]]
            .map(|joints| with.of(joints).less(&without.of(joints), &vec![0.5; joints.len()]).gain);
        assert!(own > 2.0 * all && all > 0.0, "{own} {all}");
    }
}
