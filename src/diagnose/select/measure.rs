//! Errors of models on recordings, every sample counted, and what a cause takes of them.

use std::sync::Arc;

use crate::diagnose::findings::maps::View;
use crate::diagnose::findings::reported_cause::Item;
use crate::diagnose::fit::model::{Chosen, Fitted, ModelUnderTest};
use crate::diagnose::windows::recording::Recording;
use crate::diagnose::windows::windowed_data::WindowedData;
use crate::model::PerturbableArm;

/// Errors per joint and sample at the logs' own rate.
pub(in crate::diagnose) struct Measured {
    pub(in crate::diagnose) rms: Vec<f64>,
    /// The same where the joint moves. At reversals the sign of a velocity inside its noise, or of
    /// a joint that sticks, errs by twice the Coulomb level, whatever the cause.
    pub(in crate::diagnose) steady: Vec<f64>,
    /// The same where it moves swiftly; of all samples where it hardly does.
    pub(in crate::diagnose) swift: Vec<f64>,
    pub(in crate::diagnose) error: Vec<Vec<f64>>,
    pub(in crate::diagnose) time: Vec<f64>,
    /// Samples that follow each other without a gap.
    pub(in crate::diagnose) runs: Vec<std::ops::Range<usize>>,
    /// Torque of the model, per joint, N m.
    model: Vec<Arc<Vec<f64>>>,
    /// Delays for which the motion was taken, s.
    delays: Vec<f64>,
    /// Whether this data can show each of the chosen causes.
    pub(in crate::diagnose) shown: Vec<bool>,
    /// Samples at which each joint moves.
    moves: Vec<Vec<bool>>,
}

/// [`Measured::rms`] and [`Measured::steady`]: what is kept of a model that was only tried.
pub(in crate::diagnose) struct Figures {
    pub(in crate::diagnose) rms: Vec<f64>,
    pub(in crate::diagnose) steady: Vec<f64>,
}

impl Measured {
    /// Errors of a joint, of this model and of `other`, where it moves; all of them where that is less
    /// than half.
    pub(in crate::diagnose) fn where_it_moves(&self, other: &Self, joint: usize) -> [Vec<f64>; 2] {
        [self, other].map(|m| moving(&m.error[joint], &self.moves[joint]))
    }

    /// The figures alone, without series.
    pub(in crate::diagnose) fn figures(&self) -> Figures {
        Figures { rms: self.rms.clone(), steady: self.steady.clone() }
    }

    /// Motion and torques that go with the errors. They are not held with them, since they are the
    /// same for all models. `recordings`: those that were measured on.
    pub(in crate::diagnose) fn view(&self, plant: &dyn PerturbableArm, recordings: &[Recording]) -> View {
        View::of(&WindowedData::new(plant, recordings, RAW, &self.delays, true), &self.model)
    }

    /// Takes a torque on one joint, N m, out of what is missed. `velocity`: of the joint, rad/s.
    pub(in crate::diagnose) fn explain(&mut self, joint: usize, torque: &[f64], velocity: &[f64]) {
        let error = &mut self.error[joint];
        error.iter_mut().zip(torque).for_each(|(e, t)| *e -= t);
        self.rms[joint] = root_mean_square(error);
        self.steady[joint] = where_it_moves(error, &self.moves[joint]);
        self.swift[joint] = swift(error, velocity, self.steady[joint]);
    }
}

/// Least speed of a joint, by its fastest, at which its error counts as excess: about a reversal
/// dry friction is no function of the recorded velocity.
const SWIFT: f64 = 0.05;

/// Error of a joint where it moves swiftly, root mean square, N m; `steady` where it hardly does.
fn swift(error: &[f64], velocity: &[f64], steady: f64) -> f64 {
    let fastest = velocity.iter().fold(0.0_f64, |most, v| most.max(v.abs()));
    let pairs = error.iter().zip(velocity).filter(|(_, v)| v.abs() > SWIFT * fastest);
    let swift: Vec<f64> = pairs.map(|(e, _)| *e).collect();
    if 2 * swift.len() < error.len() { steady } else { root_mean_square(&swift) }
}

/// An error where the joint moves; all of it where that is less than half.
fn moving(error: &[f64], moves: &[bool]) -> Vec<f64> {
    let moving: Vec<f64> = error.iter().zip(moves).filter(|(_, moves)| **moves).map(|(e, _)| *e).collect();
    if 2 * moving.len() < error.len() { error.to_vec() } else { moving }
}

/// Root mean square of that.
fn where_it_moves(error: &[f64], moves: &[bool]) -> f64 {
    root_mean_square(&moving(error, moves))
}

pub(in crate::diagnose) const RAW: f64 = 1e9;

/// Measures models on recordings, every sample counted.
pub(in crate::diagnose) struct Meter<'a> {
    pub(in crate::diagnose) fine: ModelUnderTest<'a>,
}

impl<'a> Meter<'a> {
    /// For models with the mode and the delays of `tested`.
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
        self.errors(error)
    }

    /// Errors of a fitted model. `elsewhere`: not on the recordings that it was fitted to, so that
    /// what acted in a part of them does not act here.
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
        Measured { shown, ..self.errors(self.fine.predict(&x, chosen)) }
    }

    pub(in crate::diagnose) fn errors(&self, predicted: Vec<Vec<f64>>) -> Measured {
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
        let steady: Vec<f64> = error.iter().zip(&moves).map(|(error, moves)| where_it_moves(error, moves)).collect();
        let velocity = |j: usize| &scene.states[scene.state_of_joint[j]].dq[j * scene.len..(j + 1) * scene.len];
        let swift = (0..error.len()).map(|j| swift(&error[j], velocity(j), steady[j])).collect();
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
            shown: Vec::new(),
        }
    }
}

pub(in crate::diagnose) fn root_mean_square(x: &[f64]) -> f64 {
    (x.iter().map(|x| x * x).sum::<f64>() / x.len().max(1) as f64).sqrt()
}

/// Whether a cause is measured on the fitted logs: it acts in a part of one of them, or the
/// validating ones can't show it, and so can't refute it.
pub(in crate::diagnose) fn here(item: &Item, after: &Measured) -> bool {
    // A sensor that was off shows nothing.
    let off = !item.place.is_empty() && item.place.iter().all(|&j| after.rms[j] == 0.0);
    off || item.hypothesis.local() || item.accepted.is_some_and(|index| !after.shown[index])
}

/// Errors of the model that is fitted without one of its causes; the model under test is left with
/// that.
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
    let mut others: Vec<Chosen> =
        chosen.iter().enumerate().filter(|(i, _)| item.accepted != Some(*i)).map(|(_, c)| c.clone()).collect();
    let fitted = tested.fit(&mut others);
    let fitted = tested.possible(&mut others, &fitted).unwrap_or(fitted);
    let measured = match tested.scene.delays == meter.fine.scene.delays {
        true => meter.of(tested, &fitted, &others, elsewhere),
        // Without this the delay is another.
        false => Meter::new(plant, meter.fine.recordings, tested).of(tested, &fitted, &others, elsewhere),
    };
    tested.frozen = frozen;
    measured
}

/// The model that is fitted without one of its causes.
pub(in crate::diagnose) fn reduced<'a>(
    plant: &'a dyn PerturbableArm,
    fit: &'a [Recording],
    tested: &ModelUnderTest<'_>,
    chosen: &[Chosen],
    item: &Item,
) -> (ModelUnderTest<'a>, Vec<Chosen>, Fitted) {
    let mut delays = tested.scene.delays.clone();
    if item.hypothesis.moves_time() {
        // The delay's own part of the shift goes.
        let own: Vec<usize> = if item.place.is_empty() { (0..delays.len()).collect() } else { item.place.clone() };
        let given = plant.delays();
        own.iter().for_each(|&j| delays[j] = given[j]);
    }
    let mut reduced = ModelUnderTest::new(plant, fit, tested.rate, tested.mode, &delays, false);
    (reduced.frozen, reduced.quiet, reduced.regulariser) =
        (tested.frozen.clone(), tested.quiet.clone(), tested.regulariser.clone());
    reduced.motion_error.clone_from(&tested.motion_error);
    item.friction.iter().for_each(|&k| reduced.frozen[k] = true);
    let mut others: Vec<Chosen> =
        chosen.iter().enumerate().filter(|(i, _)| item.accepted != Some(*i)).map(|(_, c)| c.clone()).collect();
    let fitted = reduced.fit(&mut others);
    (reduced, others, fitted)
}

/// Whether a cause takes this share of the squared error of some joint.
pub(in crate::diagnose) fn takes(before: &[f64], after: &[f64], share: f64) -> bool {
    before.iter().zip(after).any(|(a, b)| a * a - b * b > share * a * a)
}

/// Whether a cause takes as much on some joint as a torque of half of the noise would, and more
/// than errors of the recorded motion can make.
pub(in crate::diagnose) fn matters(before: &[f64], after: &[f64], noise: &[f64], motion: &[f64]) -> bool {
    let joints = before.iter().zip(after).zip(noise.iter().zip(motion));
    joints.map(|((a, b), (s, m))| a * a - b * b - (0.5 * s).max(*m).powi(2)).any(|x| x > 0.0)
}

/// The same of errors without and with it.
pub(in crate::diagnose) fn taken_of(before: &[f64], after: &[f64], noise: &[f64]) -> f64 {
    let joints = before.iter().zip(after).zip(noise);
    joints.map(|((a, b), s)| 0.5 * ((a * a + s * s).max(1e-24) / (b * b + s * s).max(1e-24)).ln()).sum()
}

/// 90 % interval of the share of the squared error on the main joint that the cause takes where that
/// moves: moving blocks of half a second (Kuensch 1989).
pub(in crate::diagnose) fn bootstrap(without: &Measured, with: &Measured, place: &[usize]) -> [f64; 2] {
    let main = place.first().copied().unwrap_or_else(|| {
        let gain = |j: &usize| without.steady[*j].powi(2) - with.steady[*j].powi(2);
        (0..with.steady.len()).max_by(|a, b| gain(a).total_cmp(&gain(b))).unwrap_or(0)
    });
    if main >= with.error.len() {
        return [f64::NAN; 2];
    }
    let [b, a] = with.where_it_moves(without, main);
    let step = with.time.windows(2).map(|w| w[1] - w[0]).find(|d| *d > 0.0).unwrap_or(0.01);
    let length = ((0.5 / step) as usize).max(1);
    let n = a.len().min(b.len());
    let sums: Vec<[f64; 2]> = (0..n / length)
        .map(|i| {
            let span = i * length..(i + 1) * length;
            [a[span.clone()].iter().map(|e| e * e).sum(), b[span].iter().map(|e| e * e).sum()]
        })
        .collect();
    if sums.len() < 4 {
        return [f64::NAN; 2];
    }
    let mut random = crate::numerics::prng::Random::new(1);
    let mut shares: Vec<f64> = (0..400)
        .map(|_| {
            let (mut before, mut after) = (0.0, 0.0);
            for _ in 0..sums.len() {
                let pick = sums[random.below(sums.len())];
                before += pick[0];
                after += pick[1];
            }
            if before > 0.0 { 1.0 - after / before } else { 0.0 }
        })
        .collect();
    shares.sort_by(f64::total_cmp);
    [shares[20], shares[379]]
}

/// Part of the squared error above the noise that goes: of the main joint, or of the one with the
/// most to gain.
pub(in crate::diagnose) fn share(before: &[f64], after: &[f64], noise: &[f64], place: &[usize]) -> f64 {
    let gain = |j: usize| before[j].powi(2) - after[j].powi(2);
    let joint = (0..before.len())
        .max_by(|a, b| (gain(*a) / noise[*a].powi(2).max(1e-12)).total_cmp(&(gain(*b) / noise[*b].powi(2).max(1e-12))));
    let joint = place.first().copied().or(joint).unwrap_or(0);
    // Where the noise is said to be nearly all of an error, it is not known well enough for that.
    let above = (before[joint].powi(2) - noise[joint].powi(2)).max(0.5 * before[joint].powi(2));
    if above > 0.0 { (gain(joint) / above).clamp(-1.0, 1.0) } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_joint_that_hardly_moves_is_measured_at_rest_too() {
        let error = [1.0, 2.0, 3.0, 4.0];
        assert_eq!(moving(&error, &[true, false, true, true]), [1.0, 3.0, 4.0]);
        assert_eq!(moving(&error, &[false, false, true, false]), error);
    }
}
