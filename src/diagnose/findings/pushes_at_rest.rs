//! Pushes on an arm that stands.
//!
//! Dry friction at rest is not a function of the motion, so the search leaves these parts of a log
//! out. While nothing touches a standing arm, its torques hardly change, whatever is wrong with the
//! model. A push changes them, and they return. The change is compared with those in all other parts
//! at rest that last as long, and with what friction may bear.

use std::ops::Range;

use super::calibration;
use super::course_of_push::{BESIDE, Course};
use super::evidence::short;
use super::force_at_rest::{Force, Usual};
use super::result::Cause;
use crate::control::estimate::stiction::breakaway;
use crate::diagnose::fit::model::given_friction;
use crate::diagnose::fit::white_errors::cost_of_unknown;
use crate::diagnose::hypotheses::external_contact::{BRIEFEST, LONGEST_SWELL, ON_TOOL, touchable};
use crate::diagnose::hypotheses::{Hypothesis as _, Named, Quantity};
use crate::diagnose::search::alone::ALONE;
use crate::diagnose::select::measure::share;
use crate::diagnose::select::refine_and_select::Selected;
use crate::diagnose::windows::pauses::{Pause, pauses};
use crate::diagnose::windows::recording::Recording;
use crate::diagnose::windows::windowed_data::dead_zones;
use crate::model::{Contact, PerturbableArm};
use crate::numerics::median::median;
use dh_codegen::robot::EffectKind;
use dh_codegen::robot::effects::ExternalContact;

/// Ratio of successive lengths that are tried.
const LONGER: f64 = 1.15;

/// Least number of parts at rest, as long as the push, with which it is compared, and the number
/// above which more do not count.
const COMPARED: [f64; 2] = [2.0, 30.0];

/// Quantile of the gains elsewhere that a push must exceed.
const NEARLY_ALL: f64 = 0.9;

/// Largest mean of a joint's torque, in its noise, at which its motor may be off: its brake holds it.
const OFF: f64 = 3.0;

/// Breakaway level of a joint, relative to its Coulomb level. A standing motor's torque may go from one
/// sign to the other.
const BREAKAWAY: f64 = 1.5;

/// Number of changes, the largest first, that are tried for each course of a push.
const TRIED: usize = 30;

/// Maximum number of changes elsewhere for which a force is fitted.
const COMPARABLE: usize = 400;

/// Least share of the squared change of the torques that a force explains.
const MOSTLY: f64 = 0.5;

/// Most pushes of all logs.
const MOST: usize = 4;

/// A push on an arm that stands.
struct Push {
    pause: usize,
    course: Course,
    /// Its first block.
    start: usize,
    force: Force,
    /// Changes of the torques, N m.
    sizes: Vec<f64>,
    usual: Usual,
    /// Twice the gain in log-likelihood, less its cost.
    support: f64,
    /// Squared torque that it removes, relative to the noise.
    removed: f64,
}

/// Change of the torques at rest that a push may be.
struct Change {
    pause: usize,
    start: usize,
    /// Per joint, N m.
    sizes: Vec<f64>,
}

/// Whether two ranges have a block in common.
fn overlap(a: &Range<usize>, b: &Range<usize>) -> bool {
    a.start < b.end && b.start < a.end
}

/// Pauses of the logs, and what is known of the arm.
struct Rest<'a> {
    pauses: Vec<Pause>,
    /// Change of the torques that friction at rest may bear, N m.
    friction: Vec<f64>,
    /// Noise of a torque sample, N m.
    noise: &'a [f64],
    contacts: Vec<Contact>,
    /// Per pause and contact: torques of unit forces.
    units: Vec<Vec<Vec<f64>>>,
    /// Whether a force, N, may be a push.
    plausible: &'a dyn Fn(&[f64]) -> bool,
    /// Pushes that were found: pause and blocks.
    taken: Vec<(usize, Range<usize>)>,
}

impl<'a> Rest<'a> {
    fn new(
        plant: &dyn PerturbableArm,
        pauses: Vec<Pause>,
        friction: Vec<f64>,
        noise: &'a [f64],
        plausible: &'a dyn Fn(&[f64]) -> bool,
    ) -> Self {
        let links = touchable(plant.rows()).iter().copied().map(Some);
        let contacts: Vec<Contact> =
            core::iter::once(None).chain(links).map(|link| Contact { link, in_base: true }).collect();
        let unit = |pause: &Pause, contact: &Contact| {
            let mut out = vec![0.0; 6 * noise.len()];
            plant.wrench_columns(&pause.posture, *contact, &mut out);
            out
        };
        let units = pauses.iter().map(|pause| contacts.iter().map(|contact| unit(pause, contact)).collect()).collect();
        Self { pauses, friction, noise, contacts, units, plausible, taken: Vec::new() }
    }

    /// Changes of the torques with a course, wherever no known push overlaps it.
    fn changes(&self, course: &Course) -> Vec<Change> {
        let free = |pause: usize, blocks: Range<usize>| {
            !self.taken.iter().any(|(p, other)| *p == pause && overlap(other, &blocks))
        };
        let of = |(pause, data): (usize, &Pause)| {
            let starts: Vec<usize> = course.starts(data).filter(|start| free(pause, course.blocks(*start))).collect();
            starts.into_iter().map(move |start| Change { pause, start, sizes: course.sizes(data, start) }).collect()
        };
        self.pauses.iter().enumerate().flat_map(|one| -> Vec<Change> { of(one) }).collect()
    }

    /// Usual changes of the torques with this course, `apart` from a push; `None` if there is too
    /// little to compare.
    fn usual(&self, course: &Course, apart: &[&Change]) -> Option<Usual> {
        let whole = course.length + 2 * course.margin;
        let long = self.pauses.iter().map(Pause::len).filter(|len| *len >= whole);
        let parts = long.sum::<usize>() as f64 / whole as f64 - 1.0;
        let per = self.pauses.iter().map(|pause| pause.per).min()? as f64;
        let typical = |j: usize| {
            let mut all: Vec<f64> = apart.iter().map(|change| change.sizes[j].abs()).collect();
            let floor = self.noise[j] / (per * course.square).sqrt();
            // A sensor without noise measures nothing.
            if self.noise[j] > 0.0 { (1.4826 * median(&mut all).unwrap_or(0.0)).max(floor) } else { f64::INFINITY }
        };
        (parts >= COMPARED[0] && !apart.is_empty())
            .then(|| Usual { size: (0..self.noise.len()).map(typical).collect(), parts: parts.min(COMPARED[1]) })
    }

    /// The force that explains changes of these sizes in a pause best.
    fn force(&self, usual: &Usual, friction: &[f64], pause: usize, sizes: &[f64]) -> Option<Force> {
        let of = |(contact, unit): (&Contact, &Vec<f64>)| usual.force(sizes, friction, *contact, unit);
        let all = self.contacts.iter().zip(&self.units[pause]).filter_map(of);
        let all = all.filter(|force| (self.plausible)(force.newtons.as_slice()));
        all.max_by(|a, b| a.gain.total_cmp(&b.gain))
    }

    /// The push of any length that removes most.
    fn next(&self) -> Option<Push> {
        let longest = self.pauses.iter().map(Pause::len).max()? as f64 / (1.0 + 2.0 * BESIDE);
        let block = self.pauses.first()?.block;
        let first = (BRIEFEST / block).ceil();
        let lengths = (0..).map(|k| (first * LONGER.powi(k)).round()).take_while(|length| *length <= longest);
        let courses = lengths.flat_map(|length| {
            let swells = [true, false].into_iter().filter(move |swells| !swells || length * block <= LONGEST_SWELL);
            swells.map(move |swells| Course::new(length as usize, swells))
        });
        let all = courses.filter_map(|course| self.with_course(course));
        all.max_by(|a, b| a.removed.total_cmp(&b.removed))
    }

    /// The push with this course that removes most: of the largest changes the first that a force
    /// explains, and that is far larger than nearly all others.
    fn with_course(&self, course: Course) -> Option<Push> {
        let mut all = self.changes(&course);
        let none = vec![0.0; self.noise.len()];
        all.sort_by(|a, b| self.removed(&b.sizes, &none).total_cmp(&self.removed(&a.sizes, &none)));
        let mut tried: Vec<(usize, Range<usize>)> = Vec::new();
        for change in &all {
            let Change { pause, start, sizes } = change;
            let known = |(p, blocks): &(usize, Range<usize>)| p == pause && overlap(blocks, &course.blocks(*start));
            if tried.iter().any(known) || self.may_be_none(&course, *pause, *start, sizes) {
                continue;
            }
            if tried.len() == TRIED {
                break;
            }
            tried.push((*pause, course.blocks(*start)));
            let own = course.blocks(*start);
            let is_apart = |other: &&Change| other.pause != *pause || !overlap(&own, &course.blocks(other.start));
            let apart: Vec<&Change> = all.iter().filter(is_apart).collect();
            let usual = self.usual(&course, &apart)?;
            let Some(force) = self.force(&usual, &self.friction, *pause, sizes) else { continue };
            let cost = cost_of_unknown(usual.parts * self.noise.len() as f64);
            let support = force.gain - (force.unknowns + 2.0) * cost - 2.0 * (self.contacts.len() as f64).ln();
            let shows = force.elsewhere > (force.unknowns - 1.0) * cost && force.share >= MOSTLY;
            if shows && support > 0.0 && self.is_alone(change, &usual, &apart) {
                let removed = course.square * self.removed(sizes, &force.left);
                return Some(Push {
                    pause: *pause,
                    start: *start,
                    sizes: sizes.clone(),
                    course,
                    force,
                    usual,
                    support,
                    removed,
                });
            }
        }
        None
    }

    /// Squares of changes less squares of what is left of them, relative to the torques' noise.
    fn removed(&self, sizes: &[f64], left: &[f64]) -> f64 {
        let squares = sizes.iter().zip(left).map(|(size, left)| size * size - left * left);
        let all = squares.zip(self.noise).filter(|(_, noise)| **noise > 0.0);
        all.map(|(squares, noise)| squares / (noise * noise)).sum()
    }

    /// Whether friction may bear a change, or the motors are off.
    fn may_be_none(&self, course: &Course, pause: usize, start: usize, sizes: &[f64]) -> bool {
        let off = |(row, noise): (&Vec<f64>, &f64)| {
            let sum = row[start..start + course.length].iter().sum::<f64>();
            (sum / course.length as f64).abs() <= OFF * noise
        };
        sizes.iter().zip(&self.friction).all(|(size, friction)| size.abs() <= *friction)
            || self.pauses[pause].torque.iter().zip(self.noise).all(off)
    }

    /// Whether a change gains far more by a force than nearly all other changes at rest, whatever
    /// friction may bear of either.
    fn is_alone(&self, change: &Change, usual: &Usual, apart: &[&Change]) -> bool {
        let none = vec![0.0; self.noise.len()];
        let gain =
            |change: &Change| self.force(usual, &none, change.pause, &change.sizes).map_or(0.0, |force| force.gain);
        let mut gains: Vec<f64> = apart.iter().step_by(1 + apart.len() / COMPARABLE).map(|other| gain(other)).collect();
        gains.sort_by(f64::total_cmp);
        let rank = (NEARLY_ALL * gains.len().saturating_sub(1) as f64).round() as usize;
        gains.get(rank).is_some_and(|usual| gain(change) > ALONE * usual.max(0.0))
    }

    /// A push as a cause. A brief one is as likely as a long one: at rest the recorded motion has no
    /// errors. `rms`: error of each joint, N m, in `samples` samples.
    fn cause(&self, push: &Push, rms: &[f64], samples: f64) -> Cause {
        let Push { course, start, force, sizes, usual, support, .. } = push;
        let pause = &self.pauses[push.pause];
        let [from, to] = [*start, start + course.length].map(|b| pause.start + b as f64 * pause.block);
        let square = course.square * pause.per as f64 / samples;
        let less = |((rms, size), left): ((&f64, &f64), &f64)| {
            (rms * rms - square * (size * size - left * left)).max(0.0).sqrt()
        };
        let after: Vec<f64> = rms.iter().zip(sizes).zip(&force.left).map(less).collect();
        let ends = [Named::new(ExternalContact::START, from, None), Named::new(ExternalContact::END, to, None)];
        let rise = course.swells.then(|| Named::new(ExternalContact::RISE, 0.5 * (to - from), None));
        let of_axis = |(key, c): (_, usize)| Named::new(key, force.newtons[c], Some(force.std[c]));
        let newtons = ExternalContact::WRENCH.into_iter().zip(0..3).map(of_axis);
        let link = force.contact.link.map(|row| Named::new(ExternalContact::LINK, (row + 1) as f64, None));
        let base = Named::new(ExternalContact::BASE, 1.0, None);
        let keys: Vec<Named> = ends.into_iter().chain(rise).chain(newtons).chain([base]).chain(link).collect();
        let parameters: Vec<Quantity> = keys.iter().map(|key| key.of_joint(None)).collect();
        let most = (0..sizes.len()).max_by(|&a, &b| sizes[a].abs().total_cmp(&sizes[b].abs())).unwrap_or(0);
        let on = force.contact.link.map_or_else(|| "the tool".into(), |row| format!("link {}", row + 1));
        let all: Vec<usize> = (0..sizes.len()).collect();
        Cause {
            probability: calibration::local(*support, false),
            support: *support,
            share: share(rms, &after, self.noise, &all),
            evidence: format!(
                "while the arm stands, from {} s to {} s, its torques change and return, joint {}'s most, by {} N m; \
                 {:.0} % of the squared change is that of a force of {} N on {on}. In as long a time joint {} changes \
                 by {} N m elsewhere at rest. The extended model does not play it",
                short(from),
                short(to),
                most + 1,
                short(sizes[most].abs()),
                100.0 * force.share,
                short(force.newtons.norm()),
                most + 1,
                short(usual.size[most]),
            ),
            in_extended: false,
            parameters,
            keys,
            rms_before: rms.to_vec(),
            rms_after: after,
            ..Cause::of_effect(EffectKind::ExternalContact)
        }
    }
}

/// Pushes on the arm while it stands, in the fitted logs.
pub(in crate::diagnose) fn pushes_at_rest(model: &Selected<'_>, fit: &[Recording], noise: &[f64]) -> Vec<Cause> {
    let (tested, dof) = (&model.tested, noise.len());
    if !tested.plant.has_bodies() {
        return Vec::new();
    }
    let given = given_friction(tested.plant);
    let bears = |j: usize| match model.fitted.friction_levels(&given[j], j) {
        [_, dry] if dry > 0.0 => 2.0 * BREAKAWAY * dry,
        _ => 2.0 * breakaway(0.0, None, tested.scene.rated[j]),
    };
    let friction = (0..dof).map(bears).collect();
    let plausible = |newtons: &[f64]| ON_TOOL.plausible(&tested.scene, &[], &[], newtons);
    let mut rest = Rest::new(tested.plant, pauses(fit, &zones(fit, dof)), friction, noise, &plausible);
    let samples: f64 = fit.iter().flat_map(|r| &r.stretches).map(|s| s.states.len as f64).sum();
    let mut causes = Vec::new();
    while causes.len() < MOST {
        let Some(push) = rest.next() else { break };
        causes.push(rest.cause(&push, &model.after_fit.rms, samples));
        rest.taken.push((push.pause, push.start..push.start + push.course.length));
    }
    causes
}

/// Speed of each joint up to which it is at rest, rad/s.
fn zones(fit: &[Recording], dof: usize) -> Vec<f64> {
    dead_zones(fit, dof).into_iter().map(|(zone, _)| zone).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::States;
    use crate::model::perturbable_robot::PerturbableRobot;
    use crate::model::rigid_body::Numeric;
    use crate::numerics::prng::Random;
    use dh_codegen::robot::{Robot, no_files};

    const BLOCK: f64 = 0.03;
    const NOISE: [f64; 7] = [0.02; 7];

    fn lwr() -> Robot {
        let text = include_str!("../../../robots/kuka-lwr4.yaml");
        Robot::from_yaml(text, &no_files).unwrap().robot
    }

    fn posture(k: usize) -> [f64; 7] {
        core::array::from_fn(|j| ((3 * j + 5 * k) as f64).sin())
    }

    /// Three pauses of 4 s whose torques wander a little. In the second one they change by `change`
    /// at most, from 1.5 s to 2.1 s.
    fn pauses_with(change: [f64; 7]) -> Vec<Pause> {
        let mut random = Random::new(5);
        let mut made = |k: usize| {
            let len = (4.0 / BLOCK) as usize;
            let mut row = |j: usize| -> Vec<f64> {
                let mut slow = 0.0;
                let at = |b: usize| {
                    slow += random.uniform(-0.01, 0.01);
                    let place = (b as f64 * BLOCK - 1.5) / 0.6;
                    let inside = k == 1 && (0.0..1.0).contains(&place);
                    let course = if inside { (std::f64::consts::PI * place).sin() } else { 0.0 };
                    (j + k) as f64 + slow + random.uniform(-0.01, 0.01) + course * change[j]
                };
                (0..len).map(at).collect()
            };
            let torque = (0..7).map(&mut row).collect();
            let posture = States { len: 1, q: posture(k).to_vec(), dq: vec![0.0; 7], ddq: vec![0.0; 7] };
            Pause { start: 10.0 * k as f64, block: BLOCK, per: 3, torque, posture }
        };
        (0..3).map(&mut made).collect()
    }

    fn found(change: [f64; 7], friction: f64) -> Option<Cause> {
        let robot = lwr();
        let plant = PerturbableRobot::new(&robot);
        let rest = Rest::new(&plant, pauses_with(change), vec![friction; 7], &NOISE, &|_| true);
        rest.next().map(|push| rest.cause(&push, &[0.1; 7], 1200.0))
    }

    /// Torques of a force on a point near the wrist, by the numeric Jacobian.
    fn pushed(newtons: [f64; 3]) -> [f64; 7] {
        let (_, jacobian) = Numeric::new(&lwr()).point_and_jacobian(&posture(1), 4, [0.03, 0.02, -0.03]);
        core::array::from_fn(|j| -(0..3).map(|c| newtons[c] * jacobian[(c, j)]).sum::<f64>())
    }

    #[test]
    fn a_push_on_a_standing_arm() {
        let cause = found(pushed([6.0, -8.0, 5.0]), 0.1).unwrap();
        let value = |key: &str| cause.parameters.iter().find(|p| p.symbol == key).map(|p| p.value);
        let (start, end) = (value("start").unwrap(), value("end").unwrap());
        assert!((start - 11.5).abs() < 0.2 && (end - 12.1).abs() < 0.2, "{start} {end}");
        assert!(cause.probability > 0.8 && cause.share > 0.0, "{cause:?}");
        assert!(cause.rms_after.iter().zip(&cause.rms_before).all(|(after, before)| *after <= *before + 1e-9));
    }

    /// Neither a change of one joint alone is a push, nor what friction may bear, nor what happens in
    /// the pauses of any log.
    #[test]
    fn other_changes_are_no_pushes() {
        let mut one = [0.0; 7];
        one[1] = 2.0;
        assert!(found(one, 0.1).is_none());
        assert!(found(pushed([6.0, -8.0, 5.0]), 10.0).is_none());
        assert!(found([0.0; 7], 0.0).is_none());
        // A link's force does not load the joints beyond it, whatever they do.
        let mut two = one;
        two[6] = 0.45;
        assert!(found(two, 0.1).is_none());
    }

    #[test]
    fn without_parts_to_compare_nothing_is_known() {
        let robot = lwr();
        let plant = PerturbableRobot::new(&robot);
        let mut pauses = pauses_with(pushed([6.0, -8.0, 5.0]));
        pauses = vec![pauses.remove(1)];
        pauses[0].torque.iter_mut().for_each(|row| *row = row[42..80].to_vec());
        assert!(Rest::new(&plant, pauses, vec![0.1; 7], &NOISE, &|_| true).next().is_none());
    }
}
