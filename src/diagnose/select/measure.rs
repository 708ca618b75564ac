//! Errors of models on recordings at every sample, and the share of them that a cause removes.

use std::ops::Range;
use std::sync::Arc;

use crate::data::signal::noise_with_memory;
use crate::diagnose::findings::maps::View;
use crate::diagnose::findings::reported_cause::Item;
use crate::diagnose::fit::model::{Chosen, Fitted, ModelUnderTest, given_friction};
use crate::diagnose::hypotheses::{Hypothesis, Kind, Term};
use crate::diagnose::windows::recording::Recording;
use crate::diagnose::windows::windowed_data::WindowedData;
use crate::model::{PerturbableArm, States};
use crate::numerics::sums::root_mean_square;
use dh_codegen::robot::EffectKind;

/// Errors per joint and sample at the logs' own rate.
pub(in crate::diagnose) struct Measured {
    pub(in crate::diagnose) rms: Vec<f64>,
    /// Root mean square where the joint moves, N m. At reversals the sign of a velocity within its
    /// noise, or of a joint that sticks, errs by twice the Coulomb level, whatever the cause. For a
    /// joint that hardly moves: the error that dry friction at rest cannot explain, see
    /// [`at_rest`].
    pub(in crate::diagnose) steady: Vec<f64>,
    /// The same where the joint moves fast; `steady` where it hardly does.
    pub(in crate::diagnose) swift: Vec<f64>,
    pub(in crate::diagnose) error: Vec<Vec<f64>>,
    pub(in crate::diagnose) time: Vec<f64>,
    /// Ranges of contiguous samples.
    pub(in crate::diagnose) runs: Vec<Range<usize>>,
    /// Torque of the model, per joint, N m.
    model: Vec<Arc<Vec<f64>>>,
    /// Delays for which the motion was evaluated, s.
    delays: Vec<f64>,
    /// Whether each of the chosen causes is observable in these data.
    pub(in crate::diagnose) shown: Vec<bool>,
    /// Samples at which each joint moves.
    moves: Vec<Vec<bool>>,
    /// Coulomb level of the model, per joint, N m.
    coulomb: Vec<f64>,
    /// Motion of all joints, once per delay, and the index of the one that belongs to a joint's
    /// torque.
    states: Vec<Arc<States>>,
    state_of_joint: Vec<usize>,
}

/// [`Measured::rms`] and [`Measured::steady`], kept of a model that was only tried.
pub(in crate::diagnose) struct Figures {
    pub(in crate::diagnose) rms: Vec<f64>,
    pub(in crate::diagnose) steady: Vec<f64>,
}

impl Measured {
    /// Errors of a joint, of this model and of `other`, where it moves; all samples if it hardly
    /// does.
    pub(in crate::diagnose) fn where_it_moves(&self, other: &Self, joint: usize) -> [Vec<f64>; 2] {
        [self, other].map(|m| moving(&m.error[joint], &self.moves[joint]))
    }

    /// Number of samples in `seconds`.
    fn samples_of(&self, seconds: f64) -> usize {
        (seconds / self.step()) as usize
    }

    /// Sampling period, s.
    fn step(&self) -> f64 {
        self.time.windows(2).map(|w| w[1] - w[0]).find(|d| *d > 0.0).unwrap_or(0.01)
    }

    /// Noise of a joint's torque, N m, where its error is pure noise ([`noise_with_memory`]).
    pub(in crate::diagnose) fn noise(&self, joint: usize) -> Option<f64> {
        let [_, velocity, _] = self.states.get(*self.state_of_joint.get(joint)?)?.by_joint()[joint];
        let parts = self.runs.iter().map(|run| (&self.error[joint][run.clone()], &velocity[run.clone()]));
        noise_with_memory(parts, self.step().recip())
    }

    /// The same for two recordings: the smaller value where the errors on both are noise.
    pub(in crate::diagnose) fn noise_of_both(measured: [&Self; 2], joint: usize) -> Option<f64> {
        let [one, other] = measured.map(|m| m.noise(joint));
        Some(one?.min(other?))
    }

    /// Begin and end, s, and root mean square error, N m, of the stretches of length `seconds` in
    /// which a joint moves throughout.
    pub(in crate::diagnose) fn stretches(&self, joint: usize, seconds: f64) -> impl Iterator<Item = ([f64; 2], f64)> {
        let length = self.samples_of(seconds).max(1);
        let starts = self
            .runs
            .iter()
            .flat_map(move |run| (run.start..run.end).step_by(length).filter(move |s| s + length <= run.end));
        let spans = starts
            .map(move |start| start..start + length)
            .filter(move |span| self.moves[joint][span.clone()].iter().all(|m| *m));
        spans.map(move |span| {
            ([self.time[span.start], self.time[span.end - 1]], root_mean_square(&self.error[joint][span]))
        })
    }

    /// Whether some joint's error in a span of samples exceeds another model's by more than dry
    /// friction at rest can explain (a joint at rest bears a push), and more than the unknown point
    /// of contact on a link can.
    pub(in crate::diagnose) fn is_worse_within(&self, span: Range<usize>, other: &Self, noise: &[f64]) -> bool {
        let part = |m: &Self, j: usize| m.error[j].get(span.clone()).map_or(0.0, root_mean_square);
        let taken = |j: usize| (part(other, j).powi(2) - part(self, j).powi(2)).max(0.0).sqrt();
        let lever = LEVER * (0..noise.len()).map(taken).fold(0.0, f64::max);
        let borne = |j: usize| part(other, j).max(self.coulomb[j].abs() + noise[j]).hypot(lever);
        (0..noise.len()).any(|j| part(self, j) > WORSE_WITHIN * borne(j))
    }

    /// Whether some joint's error between two times, s since a log began, is larger than elsewhere.
    pub(in crate::diagnose) fn stands_out(&self, [start, end]: [f64; 2]) -> bool {
        let inside = |t: f64| (start..=end).contains(&t);
        let larger = |(error, usual): (&Vec<f64>, &f64)| {
            let part: Vec<f64> = error.iter().zip(&self.time).filter(|(_, t)| inside(**t)).map(|(e, _)| *e).collect();
            root_mean_square(&part) > STANDS_OUT * usual
        };
        self.error.iter().zip(&self.steady).any(larger)
    }

    /// The figures without the series.
    pub(in crate::diagnose) fn figures(&self) -> Figures {
        Figures { rms: self.rms.clone(), steady: self.steady.clone() }
    }

    /// Motion and torques that belong to the errors. They are recomputed instead of stored, since
    /// all models share them. `recordings`: those that were measured.
    pub(in crate::diagnose) fn view(&self, plant: &dyn PerturbableArm, recordings: &[Recording]) -> View {
        View::of(&WindowedData::new(plant, recordings, RAW, &self.delays, true), &self.model)
    }

    /// Subtracts a torque on one joint, N m, from its error. `velocity`: of the joint, rad/s.
    pub(in crate::diagnose) fn explain(&mut self, joint: usize, torque: &[f64], velocity: &[f64]) {
        let error = &mut self.error[joint];
        error.iter_mut().zip(torque).for_each(|(e, t)| *e -= t);
        self.rms[joint] = root_mean_square(error);
        self.steady[joint] = where_it_moves(error, &self.moves[joint], self.coulomb[joint]);
        self.swift[joint] = swift(error, velocity, self.steady[joint]);
    }
}

/// Ratio of a joint's error in a part of a log to that where it moves, above which it stands out.
const STANDS_OUT: f64 = 1.5;

/// Factor by which an error may grow in a part of a log.
const WORSE_WITHIN: f64 = 1.2;

/// Uncertainty of a push's lever about one joint, as a share of its longest lever.
pub(in crate::diagnose) const LEVER: f64 = 0.25;

/// Least speed of a joint, relative to its maximum, at which its error counts as excess. About a
/// reversal dry friction is no function of the recorded velocity.
const SWIFT: f64 = 0.05;

/// Root mean square error of a joint where it moves fast, N m; `steady` where it hardly does.
fn swift(error: &[f64], velocity: &[f64], steady: f64) -> f64 {
    let fastest = velocity.iter().fold(0.0_f64, |most, v| most.max(v.abs()));
    let pairs = error.iter().zip(velocity).filter(|(_, v)| v.abs() > SWIFT * fastest);
    let swift: Vec<f64> = pairs.map(|(e, _)| *e).collect();
    if hardly(swift.len(), error) { steady } else { root_mean_square(&swift) }
}

/// Least share of samples in which a joint moves for these to represent it: in a point-to-point
/// motion it rests most of the time.
const MOVES: f64 = 0.1;

/// Whether a joint moves in too few samples.
fn hardly(moving: usize, all: &[f64]) -> bool {
    (moving as f64) < MOVES * all.len() as f64
}

/// The error where the joint moves; all samples if it hardly does.
fn moving(error: &[f64], moves: &[bool]) -> Vec<f64> {
    let moving: Vec<f64> = error.iter().zip(moves).filter(|(_, moves)| **moves).map(|(e, _)| *e).collect();
    if hardly(moving.len(), error) { error.to_vec() } else { moving }
}

/// Part of an error that cannot be dry friction of a joint at rest, which is any torque up to its
/// Coulomb level.
fn at_rest(error: f64, coulomb: f64) -> f64 {
    (error.abs() - coulomb.abs()).max(0.0)
}

/// Root mean square of an error where the joint moves. If it hardly does: of all samples, those at
/// rest less what dry friction explains.
fn where_it_moves(error: &[f64], moves: &[bool], coulomb: f64) -> f64 {
    let part = moving(error, moves);
    if part.len() < error.len() {
        return root_mean_square(&part);
    }
    let beyond = |(e, moves): (&f64, &bool)| if *moves { *e } else { at_rest(*e, coulomb) };
    root_mean_square(&error.iter().zip(moves).map(beyond).collect::<Vec<f64>>())
}

pub(in crate::diagnose) const RAW: f64 = 1e9;

/// Measures models on recordings at every sample.
pub(in crate::diagnose) struct Meter<'a> {
    pub(in crate::diagnose) fine: ModelUnderTest<'a>,
}

impl<'a> Meter<'a> {
    /// A meter for models with the mode and the delays of `tested`.
    pub(in crate::diagnose) fn new(
        plant: &'a dyn PerturbableArm,
        recordings: &'a [Recording],
        tested: &ModelUnderTest<'_>,
    ) -> Self {
        Self { fine: ModelUnderTest::new(plant, recordings, RAW, tested.mode, &tested.scene.delays, true) }
    }

    /// Errors of the unchanged file.
    pub(in crate::diagnose) fn of_the_file(&self) -> Measured {
        let error = vec![vec![0.0; self.fine.scene.len]; self.fine.scene.dof()];
        self.errors(error, self.levels(|_| 0.0))
    }

    /// Errors of a fitted model. `elsewhere`: on recordings other than the fitted ones, where local
    /// causes do not act.
    pub(in crate::diagnose) fn of(
        &mut self,
        tested: &ModelUnderTest<'_>,
        fitted: &Fitted,
        chosen: &[Chosen],
        elsewhere: bool,
    ) -> Measured {
        self.fine.adopt(tested, fitted);
        let mut x = fitted.solution.x.clone();
        for (c, first) in chosen.iter().zip(&fitted.first).filter(|(c, _)| elsewhere && c.cause.local()) {
            (0..c.x.len()).for_each(|k| x[first + k] = 0.0);
        }
        let shown = chosen.iter().map(|c| c.cause.shows(&self.fine.scene, &c.place, &c.shape)).collect();
        let levels = self.levels(|j| fitted.solution.x[fitted.friction + 3 * j + 1]);
        let levels = levels.into_iter().enumerate().map(|(j, level)| level + dry_laws(fitted, chosen, j)).collect();
        Measured { shown, ..self.errors(self.fine.predict(&x, chosen), levels) }
    }

    /// Coulomb level of each joint, N m: the file's plus the change that was `found`.
    fn levels(&self, found: impl Fn(usize) -> f64) -> Vec<f64> {
        let given = given_friction(self.fine.plant).into_iter().enumerate();
        given.map(|(j, given)| (given[1].unwrap_or(0.0) + found(j)).abs()).collect()
    }

    /// Errors of predicted torques. `coulomb`: dry friction level of each joint, N m.
    pub(in crate::diagnose) fn errors(&self, predicted: Vec<Vec<f64>>, coulomb: Vec<f64>) -> Measured {
        let mut error = predicted;
        for (e, y) in error.iter_mut().zip(self.fine.target()) {
            e.iter_mut().zip(y).for_each(|(e, y)| *e = y - *e);
        }
        // A joint whose sensor was off has no error.
        for (j, e) in error.iter_mut().enumerate() {
            if self.fine.recordings.iter().flat_map(|r| &r.stretches).all(|s| s.of(&s.tau, j).iter().all(|t| *t == 0.0))
            {
                e.iter_mut().for_each(|e| *e = 0.0);
            }
        }
        let rms = error.iter().map(|e| root_mean_square(e)).collect();
        let scene = &self.fine.scene;
        let moves: Vec<Vec<bool>> =
            scene.own.iter().map(|own| scene.joined(own.iter().map(|own| own.moves.clone()))).collect();
        let steady = (0..error.len()).map(|j| where_it_moves(&error[j], &moves[j], coulomb[j]));
        let steady: Vec<f64> = steady.collect();
        let swift = (0..error.len()).map(|j| swift(&error[j], scene.motion_of(j)[1], steady[j])).collect();
        let (time, runs, model) = (scene.time.clone(), scene.runs.clone(), scene.whole.clone());
        Measured {
            rms,
            steady,
            swift,
            error,
            time,
            runs,
            model,
            delays: scene.delays.clone(),
            moves,
            coulomb,
            states: scene.states.clone(),
            state_of_joint: scene.state_of_joint.clone(),
            shown: Vec::new(),
        }
    }
}

/// Dry friction of a joint by the chosen laws, N m: root mean square where they act on the fitted
/// logs.
fn dry_laws(fitted: &Fitted, chosen: &[Chosen], joint: usize) -> f64 {
    let of = |(c, terms): (&Chosen, &Arc<Vec<Term>>)| {
        let dry = c.cause.kind() == Kind::Friction && c.cause.effect() != EffectKind::NonlinearViscousFriction;
        let rows = terms.iter().zip(&c.x).filter(|_| dry);
        let mut torque: Vec<f64> = Vec::new();
        for (x, (_, series)) in rows.flat_map(|(t, x)| t.column.rows.iter().map(move |row| (x, row))) {
            torque.resize(series.len(), 0.0);
            torque.iter_mut().zip(series.iter()).for_each(|(t, s)| *t += x * s);
        }
        torque.retain(|t| *t != 0.0);
        root_mean_square(&torque)
    };
    chosen.iter().zip(&fitted.terms).filter(|(c, _)| c.place == [joint]).map(of).sum()
}

/// Whether a cause is measured on the fitted logs. Either it acts in a part of one of them, or it
/// is not observable in the validating logs, which then cannot refute it.
pub(in crate::diagnose) fn here(item: &Item, after: &Measured) -> bool {
    // A sensor that was off measures nothing.
    let off = !item.place.is_empty() && item.place.iter().all(|&j| after.rms[j] == 0.0);
    off || item.hypothesis.local() || item.accepted.is_some_and(|index| !after.shown[index])
}

/// Errors of the model fitted without one of its causes. Leaves `tested` with that fit.
pub(in crate::diagnose) fn leave_out<'a>(
    plant: &'a dyn PerturbableArm,
    fit: &'a [Recording],
    meter: &mut Meter<'a>,
    tested: &mut ModelUnderTest<'_>,
    chosen: &[Chosen],
    item: &Item,
    elsewhere: bool,
) -> Measured {
    if item.hypothesis.moves_time() {
        let (mut reduced, mut others, fitted) = reduced(plant, fit, tested, chosen, item);
        let fitted = reduced.possible(&mut others, &fitted).unwrap_or(fitted);
        return Meter::new(plant, meter.fine.recordings, &reduced).of(&reduced, &fitted, &others, elsewhere);
    }
    let frozen = tested.frozen.clone();
    item.friction.iter().for_each(|&k| tested.frozen[k] = true);
    let mut others = item.others(chosen);
    let fitted = tested.fit(&mut others);
    let fitted = tested.possible(&mut others, &fitted).unwrap_or(fitted);
    let measured = match tested.scene.delays == meter.fine.scene.delays {
        true => meter.of(tested, &fitted, &others, elsewhere),
        // Without this cause the delays differ from the meter's.
        false => Meter::new(plant, meter.fine.recordings, tested).of(tested, &fitted, &others, elsewhere),
    };
    tested.frozen = frozen;
    measured
}

/// Delays of the joints' torques, s, without a cause in its place: a cause that moves time leaves
/// the file's delays there.
pub(in crate::diagnose) fn delays_without(
    plant: &dyn PerturbableArm,
    delays: &[f64],
    cause: &dyn Hypothesis,
    place: &[usize],
) -> Vec<f64> {
    let gone = |j: usize| cause.moves_time() && (place.is_empty() || place.contains(&j));
    let both = delays.iter().zip(plant.delays()).enumerate();
    both.map(|(j, (delay, given))| if gone(j) { given } else { *delay }).collect()
}

/// The model fitted without one of its causes.
pub(in crate::diagnose) fn reduced<'a>(
    plant: &'a dyn PerturbableArm,
    fit: &'a [Recording],
    tested: &ModelUnderTest<'_>,
    chosen: &[Chosen],
    item: &Item,
) -> (ModelUnderTest<'a>, Vec<Chosen>, Fitted) {
    let delays = delays_without(plant, &tested.scene.delays, item.hypothesis, &item.place);
    let mut reduced = ModelUnderTest::new(plant, fit, tested.rate, tested.mode, &delays, false);
    (reduced.frozen, reduced.quiet, reduced.regulariser) =
        (tested.frozen.clone(), tested.quiet.clone(), tested.regulariser.clone());
    reduced.motion_error.clone_from(&tested.motion_error);
    item.friction.iter().for_each(|&k| reduced.frozen[k] = true);
    let mut others = item.others(chosen);
    let fitted = reduced.fit(&mut others);
    (reduced, others, fitted)
}

/// Whether a cause removes this share of the squared error of some joint.
pub(in crate::diagnose) fn takes(before: &[f64], after: &[f64], share: f64) -> bool {
    before.iter().zip(after).any(|(a, b)| a * a - b * b > share * a * a)
}

/// Whether a cause removes as much on some joint as a torque of half of the noise, and more than
/// errors of the recorded motion can produce.
pub(in crate::diagnose) fn matters(before: &[f64], after: &[f64], noise: &[f64], motion: &[f64]) -> bool {
    let joints = before.iter().zip(after).zip(noise.iter().zip(motion));
    joints.map(|((a, b), (s, m))| a * a - b * b - (0.5 * s).max(*m).powi(2)).any(|x| x > 0.0)
}

/// Sum over joints of the logarithms of error ratios without and with a cause, regularised by the
/// noise.
pub(in crate::diagnose) fn taken_of(before: &[f64], after: &[f64], noise: &[f64]) -> f64 {
    let joints = before.iter().zip(after).zip(noise);
    joints.map(|((a, b), s)| 0.5 * ((a * a + s * s).max(1e-24) / (b * b + s * s).max(1e-24)).ln()).sum()
}

/// 90 % interval of the share of the squared error on the main joint that the cause removes where
/// that joint moves: moving blocks of half a second (Kuensch 1989).
pub(in crate::diagnose) fn bootstrap(without: &Measured, with: &Measured, place: &[usize]) -> [f64; 2] {
    let main = place.first().copied().unwrap_or_else(|| {
        let gain = |j: &usize| without.steady[*j].powi(2) - with.steady[*j].powi(2);
        (0..with.steady.len()).max_by(|a, b| gain(a).total_cmp(&gain(b))).unwrap_or(0)
    });
    if main >= with.error.len() {
        return [f64::NAN; 2];
    }
    let [after, before] = with.where_it_moves(without, main);
    interval(&before, &after, with.samples_of(BLOCK))
}

/// The same for a local cause within its span, on the joint where it removes most: blocks over the
/// whole log would often miss it.
pub(in crate::diagnose) fn bootstrap_within(span: Range<usize>, without: &Measured, with: &Measured) -> [f64; 2] {
    let part = |m: &Measured, j: usize| m.error[j].get(span.clone()).unwrap_or(&[]).to_vec();
    let taken = |j: &usize| {
        let [before, after] = [without, with].map(|m| root_mean_square(&part(m, *j)).powi(2));
        if before > 0.0 { 1.0 - after / before } else { 0.0 }
    };
    let main = (0..with.error.len()).max_by(|a, b| taken(a).total_cmp(&taken(b))).unwrap_or(0);
    interval(&part(without, main), &part(with, main), with.samples_of(BLOCK).min(span.len() / LEAST_BLOCKS))
}

/// Length of the blocks, s, and their least number in a part of a log.
const BLOCK: f64 = 0.5;
const LEAST_BLOCKS: usize = 8;

/// 90 % interval of the share of a squared error that is removed, by blocks of `block` samples.
fn interval(before: &[f64], after: &[f64], block: usize) -> [f64; 2] {
    let square = |part: &[f64]| part.iter().map(|e| e * e).sum::<f64>();
    let both = before.chunks_exact(block.max(1)).zip(after.chunks_exact(block.max(1)));
    let sums: Vec<[f64; 2]> = both.map(|(before, after)| [square(before), square(after)]).collect();
    if sums.len() < 4 {
        return [f64::NAN; 2];
    }
    let mut random = crate::numerics::prng::Random::new(1);
    let mut draw = |_| {
        let (mut before, mut after) = (0.0, 0.0);
        for _ in 0..sums.len() {
            let pick = sums[random.below(sums.len())];
            before += pick[0];
            after += pick[1];
        }
        if before > 0.0 { 1.0 - after / before } else { 0.0 }
    };
    let mut shares: Vec<f64> = (0..400).map(&mut draw).collect();
    shares.sort_by(f64::total_cmp);
    [shares[20], shares[379]]
}

/// Share of the squared error above the noise that is removed: of the main joint, or of the joint
/// with the largest gain.
pub(in crate::diagnose) fn share(before: &[f64], after: &[f64], noise: &[f64], place: &[usize]) -> f64 {
    let gain = |j: usize| before[j].powi(2) - after[j].powi(2);
    let joint = (0..before.len())
        .max_by(|a, b| (gain(*a) / noise[*a].powi(2).max(1e-12)).total_cmp(&(gain(*b) / noise[*b].powi(2).max(1e-12))));
    let joint = place.first().copied().or(joint).unwrap_or(0);
    // A noise estimate near the whole error is too uncertain to subtract: keep at least half of it.
    let above = (before[joint].powi(2) - noise[joint].powi(2)).max(0.5 * before[joint].powi(2));
    if above > 0.0 { (gain(joint) / above).clamp(-1.0, 1.0) } else { 0.0 }
}

#[cfg(test)]
impl Measured {
    /// Given errors, sampled at 0.01 s, of joints that move where given, with a Coulomb level of 1
    /// N m.
    pub(in crate::diagnose) fn made(error: Vec<Vec<f64>>, moves: Vec<Vec<bool>>) -> Self {
        let samples = error[0].len();
        let steady: Vec<f64> = error.iter().zip(&moves).map(|(e, m)| where_it_moves(e, m, 1.0)).collect();
        Self {
            rms: error.iter().map(|e| root_mean_square(e)).collect(),
            swift: steady.clone(),
            steady,
            coulomb: vec![1.0; error.len()],
            error,
            time: (0..samples).map(|k| 0.01 * k as f64).collect(),
            runs: std::iter::once(0..samples).collect(),
            model: Vec::new(),
            delays: Vec::new(),
            shown: Vec::new(),
            moves,
            states: Vec::new(),
            state_of_joint: Vec::new(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A push of 1 s in a log of 30 s that removes nine tenths of an error there: most blocks of
    /// the whole log miss it.
    #[test]
    fn a_push_is_weighed_where_it_acts() {
        let wave = |k: usize| 0.1 * (k as f64).sin();
        let before: Vec<f64> = (0..3000).map(|k| wave(k) + f64::from((1000..1100).contains(&k)) * 0.3).collect();
        let after: Vec<f64> = (0..3000).map(wave).collect();
        let of = |error: &[f64]| Measured::made(vec![error.to_vec()], vec![vec![true; 3000]]);
        let (without, with) = (of(&before), of(&after));
        let [low, high] = bootstrap_within(1000..1100, &without, &with);
        assert!(low > 0.8 && high < 1.0, "{low} {high}");
        assert!(bootstrap(&without, &with, &[])[0] < 0.2);
        // The same push on a joint at rest, 3 N m more than its friction bears.
        let stands = |error: f64| Measured::made(vec![vec![error; 3000]], vec![vec![false; 3000]]);
        assert!(stands(4.0).is_worse_within(1000..1100, &stands(0.5), &[0.1]));
        assert!(!stands(1.0).is_worse_within(1000..1100, &stands(0.5), &[0.1]));
        assert!(without.stands_out([10.2, 10.8]) && !with.stands_out([10.2, 10.8]));
    }

    /// A push removes 2 N m of one joint's error and adds 1.4 to another's: 1.1 by friction and
    /// noise, the rest by a lever that is known to a quarter of the first joint's.
    #[test]
    fn a_lever_is_known_roughly() {
        let of = |errors: [f64; 2]| Measured::made(errors.map(|e| vec![e; 300]).to_vec(), vec![vec![false; 300]; 2]);
        let without = of([2.0, 0.1]);
        let worse = |errors: [f64; 2]| of(errors).is_worse_within(100..200, &without, &[0.1, 0.1]);
        assert!(!worse([0.1, 1.4]));
        assert!(worse([0.1, 1.6]));
        assert!(worse([1.9, 1.4]), "a push that explains less has a shorter lever");
    }

    #[test]
    fn a_joint_that_hardly_moves_is_measured_at_rest_too() {
        let error = [1.0, 2.0, 3.0, -4.0];
        assert_eq!(moving(&error, &[true, false, true, false]), [1.0, 3.0]);
        assert_eq!(moving(&error, &[false; 4]), error);
        // At rest, dry friction of 3 N m is any torque up to that.
        assert_eq!(where_it_moves(&error, &[true, false, true, false], 3.0), 5.0_f64.sqrt());
        assert_eq!(where_it_moves(&error, &[false; 4], 3.0), 0.5);
        let long: Vec<f64> = (0..20).map(|k| f64::from(k == 3 || k == 7)).collect();
        let moves: Vec<bool> = (0..20).map(|k| k == 3).collect();
        assert_eq!(where_it_moves(&long, &moves, 1.0), (1.0_f64 / 20.0).sqrt());
    }
}
