//! A recording in memory: filtered motion, and the unfiltered measured torque.

use std::borrow::Cow;

use crate::data::signal::{Band, Filter, Motion, Prepare};
use crate::model::{PerturbableArm, States};

/// Highest cutoff of positions, Hz.
pub const HIGHEST: f64 = 15.0;

/// Ratio of the second cutoff of positions to the first: see [`Prepare::bursts`]. After breaking
/// away, a joint catches up with the bandwidth of its loop, some 10 Hz, in shorter steps.
const BURSTS: f64 = 8.0 / 3.0;

/// Preparation of samples for a recording: torques stay raw, and the band of each joint's positions
/// is determined from the log, below `highest`, Hz.
pub fn preparation(highest: f64) -> Prepare {
    Prepare { adaptive: true, bursts: Some(BURSTS * highest), margins: true, ..fixed_preparation(highest) }
}

/// The same with one low-pass, of `cutoff`, Hz, for the positions of all joints.
pub fn fixed_preparation(cutoff: f64) -> Prepare {
    Prepare {
        filter: Some(Filter { order: 4, cutoff }),
        raw_torque: true,
        temperature: true,
        motor_positions: true,
        ..Prepare::default()
    }
}

/// An uninterrupted, evenly sampled stretch of a log.
#[derive(Debug, Clone, PartialEq)]
pub struct Stretch {
    /// Time of the first sample, s.
    pub start: f64,
    /// Sampling period, s.
    pub period: f64,
    /// Motion, joint-major.
    pub states: States,
    /// Measured torque, joint-major, N m.
    pub tau: Vec<f64>,
    /// Temperature, joint-major, deg C; empty if not recorded.
    pub temperature: Vec<f64>,
    /// Positions of the motors as recorded, joint-major, rad; empty if not recorded.
    pub motor: Vec<f64>,
    /// Torques of the joints behind the gears, joint-major, N m, where `tau` is that of the gears
    /// alone; otherwise empty.
    pub load: Vec<f64>,
    /// Standard deviation of the velocity error due to the noise of the positions, rad/s, per
    /// joint.
    pub velocity_noise: Vec<f64>,
    /// Standard deviations of the errors of position, velocity and acceleration, rad, rad/s,
    /// rad/s^2, per joint; empty if unknown.
    pub error: Vec<[f64; 3]>,
    /// Standard deviation of the torques' noise, N m, per joint; empty if it is to be estimated
    /// from `tau`.
    pub torque_noise: Vec<f64>,
    /// Standard deviation of the remaining error of the sample times, s.
    pub clock_error: f64,
    /// Whether each joint sticks, joint-major; empty if unknown.
    pub stuck: Vec<bool>,
    /// Effect of the low-pass on the positions.
    pub band: Band,
    /// Positions just before and just after the stretch, joint-major, rad, so that a further
    /// low-pass does not err at its ends; may be empty.
    pub beside: [Vec<f64>; 2],
}

/// A log.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Recording {
    /// Name of the log.
    pub name: String,
    /// Time stamp of its first sample, s, from which times are counted. Stretches begin later,
    /// after the filters have settled.
    pub begin: f64,
    /// Stretches, in time order.
    pub stretches: Vec<Stretch>,
}

impl Recording {
    /// An empty recording.
    pub fn new(name: &str) -> Self {
        Self { name: name.into(), begin: 0.0, stretches: Vec::new() }
    }

    /// Adds a stretch of motion. Long stretches arrive in parts, each of which becomes a separate
    /// stretch: its windows do not overlap the next, and it is split separately.
    pub fn absorb(&mut self, motion: &Motion) {
        if self.stretches.is_empty() {
            self.begin = motion.segment_start;
        }
        self.stretches.push(Stretch::new(motion));
    }

    /// Duration of the motion, s.
    pub fn seconds(&self) -> f64 {
        self.stretches.iter().map(|s| s.states.len as f64 * s.period).sum()
    }

    /// The first `share` of each stretch, and the rest.
    pub fn split(&self, share: f64) -> [Self; 2] {
        let part = |which: usize| {
            let cut = |s: &Stretch| {
                let (at, len) = (s.at(share), s.states.len);
                s.cut(if which == 0 { 0..at } else { at..len })
            };
            Self { name: self.name.clone(), begin: self.begin, stretches: self.stretches.iter().map(cut).collect() }
        };
        [part(0), part(1)]
    }
}

/// Recordings with the effects of the file subtracted from the torques. The remaining torques are
/// those of the plain arm and of unmodelled effects.
pub fn unexplained<'a>(plant: &dyn PerturbableArm, recordings: &'a [Recording]) -> Cow<'a, [Recording]> {
    let mut all = Vec::with_capacity(recordings.len());
    for recording in recordings {
        let mut recording = recording.clone();
        // Evaluate over all stretches, so that the drives continue to warm up.
        let dof = plant.dof();
        let len: usize = recording.stretches.iter().map(|s| s.states.len).sum();
        let time: Vec<f64> = recording
            .stretches
            .iter()
            .flat_map(|s| (0..s.states.len).map(move |k| s.start + k as f64 * s.period))
            .collect();
        let joined = |of: fn(&Stretch) -> &[f64]| -> Vec<f64> {
            if recording.stretches.iter().any(|s| of(s).len() != dof * s.states.len) {
                return Vec::new();
            }
            (0..dof)
                .flat_map(|j| recording.stretches.iter().flat_map(move |s| s.of(of(s), j).iter().copied()))
                .collect()
        };
        let states =
            States { len, q: joined(|s| &s.states.q), dq: joined(|s| &s.states.dq), ddq: joined(|s| &s.states.ddq) };
        let mut known = vec![0.0; dof * len];
        let laws = plant.known(recording.begin, &time, &states, &joined(|s| &s.temperature), &mut known);
        let of_load = plant.add_laws_of_load(&states, &joined(|s| &s.load), &mut known);
        if !laws && !of_load {
            return Cow::Borrowed(recordings);
        }
        let mut first = 0;
        for stretch in &mut recording.stretches {
            let n = stretch.states.len;
            for j in 0..dof {
                let tau = &mut stretch.tau[j * n..(j + 1) * n];
                // A sensor that was off carries no information.
                if tau.iter().any(|t| *t != 0.0) {
                    let known = &known[j * len + first..j * len + first + n];
                    tau.iter_mut().zip(known).for_each(|(tau, known)| *tau -= known);
                }
            }
            first += n;
        }
        settle(&mut recording, &plant.settling());
        all.push(recording);
    }
    Cow::Owned(all)
}

/// Largest share of a stretch that is dropped at its beginning.
const BEGINNING: f64 = 0.3;

/// Ratio of a joint's largest velocity to its velocity noise above which it moves in a stretch.
const MOVES: f64 = 10.0;

/// Drops the beginning of each stretch, until each joint has travelled the given distance.
fn settle(recording: &mut Recording, travel: &[f64]) {
    for stretch in &mut recording.stretches {
        let len = stretch.states.len;
        let settled = |(j, travel): (usize, &f64)| {
            let q = stretch.of(&stretch.states.q, j);
            let mut gone = 0.0;
            let mut steps = q.windows(2).map(|w| (w[1] - w[0]).abs());
            steps.position(|step| {
                gone += step;
                gone >= *travel
            })
        };
        let all = travel.iter().enumerate().filter(|(_, t)| **t > 0.0).map(|j| settled(j).unwrap_or(len));
        let first = all.max().unwrap_or(0).min((BEGINNING * len as f64) as usize);
        if first > 0 {
            *stretch = stretch.cut(first..len);
        }
    }
}

/// Duration of the positions that are kept beside a stretch, s: the transient of a low-pass of
/// 2 Hz.
const BESIDE: f64 = 0.5;

/// The part of each joint's positions just before and just after a range, rad, joint-major.
fn beside(q: &[f64], dof: usize, range: &std::ops::Range<usize>, period: f64) -> [Vec<f64>; 2] {
    let (len, most) = (q.len() / dof.max(1), (BESIDE / period) as usize);
    let after = range.end..(range.end + most).min(len);
    [range.start.saturating_sub(most)..range.start, after].map(|range| part(q, dof, len, range))
}

/// A range of samples of each joint of a joint-major series; empty if the series has another
/// length.
fn part<T: Clone>(x: &[T], dof: usize, len: usize, range: std::ops::Range<usize>) -> Vec<T> {
    if x.len() != dof * len || len == 0 {
        return Vec::new();
    }
    x.chunks_exact(len).flat_map(|row| row[range.clone()].to_vec()).collect()
}

impl Stretch {
    /// The usable samples of a motion.
    pub(super) fn new(motion: &Motion) -> Self {
        let (dof, len) = (motion.dof(), motion.states.len);
        let core = motion.core.clone();
        let cut = |x: &[f64]| part(x, dof, len, core.clone());
        let states = motion.states.part(core.start, core.end);
        let (mut tau, load) = (cut(&motion.tau), cut(&motion.load));
        // If the sensor behind the gear was off, the gear's torque is unknown.
        let off = load.chunks_exact(core.len().max(1)).map(|load| load.iter().all(|t| *t == 0.0));
        for (tau, _) in tau.chunks_exact_mut(core.len().max(1)).zip(off).filter(|(_, off)| *off) {
            tau.fill(0.0);
        }
        Self {
            start: motion.time(core.start),
            period: motion.period,
            states,
            tau,
            temperature: cut(&motion.temperature),
            motor: cut(&motion.motor),
            load,
            velocity_noise: motion.velocity_noise.clone(),
            error: motion.error.clone(),
            torque_noise: if motion.clock_error > 0.0 { motion.torque_noise.clone() } else { Vec::new() },
            clock_error: motion.clock_error,
            stuck: part(&motion.stuck, dof, len, core.clone()),
            band: motion.band.cut(len, core.clone()),
            beside: beside(&motion.states.q, dof, &core, motion.period),
        }
    }

    /// A range of its samples.
    pub(in crate::diagnose) fn cut(&self, range: std::ops::Range<usize>) -> Self {
        let (dof, len) = (self.velocity_noise.len(), self.states.len);
        let take = |x: &[f64]| part(x, dof, len, range.clone());
        let before = self.beside[0].len() / dof.max(1);
        let around = before + range.start..before + range.end;
        Self {
            start: self.start + range.start as f64 * self.period,
            period: self.period,
            states: self.states.part(range.start, range.end),
            tau: take(&self.tau),
            temperature: take(&self.temperature),
            motor: take(&self.motor),
            load: take(&self.load),
            velocity_noise: self.velocity_noise.clone(),
            error: self.error.clone(),
            torque_noise: self.torque_noise.clone(),
            clock_error: self.clock_error,
            stuck: part(&self.stuck, dof, len, range.clone()),
            band: self.band.cut(len, range.clone()),
            beside: beside(&self.all_positions(), dof, &around, self.period),
        }
    }

    /// Joint-major positions of the stretch with those beside it.
    fn all_positions(&self) -> Vec<f64> {
        (0..self.velocity_noise.len()).flat_map(|j| self.positions_around(j)).collect()
    }

    /// Positions of joint `j` in the stretch and beside it.
    pub(super) fn positions_around(&self, j: usize) -> Vec<f64> {
        let [before, after] = [0, 1].map(|side| {
            let all = &self.beside[side];
            let len = all.len() / self.velocity_noise.len().max(1);
            &all[j * len..(j + 1) * len]
        });
        [before, self.of(&self.states.q, j), after].concat()
    }

    /// Sample at which this share of the stretch ends: of its time, or where the rest would then hold
    /// less than half as much motion as its time, of its motion. A log of motions with rests between
    /// them may end each stretch with a rest, which shows nothing that depends on motion.
    pub(in crate::diagnose) fn at(&self, share: f64) -> usize {
        let len = self.states.len;
        let by_time = (share * len as f64).round() as usize;
        let mut path = vec![0.0; len + 1];
        for j in 0..self.velocity_noise.len() {
            let dq = self.of(&self.states.dq, j);
            let fastest = dq.iter().fold(0.0, |most: f64, v| most.max(v.abs()));
            if fastest > MOVES * self.velocity_noise[j] {
                path[1..].iter_mut().zip(dq).for_each(|(sum, v)| *sum += v.abs() / fastest);
            }
        }
        (1..=len).for_each(|k| path[k] += path[k - 1]);
        let whole = path[len];
        if whole - path[by_time.min(len)] >= 0.5 * (1.0 - share) * whole {
            return by_time;
        }
        path.partition_point(|sum| *sum < share * whole).saturating_sub(1)
    }

    /// Joint `j`'s part of a joint-major series.
    pub fn of<'a, T>(&self, series: &'a [T], j: usize) -> &'a [T] {
        &series[j * self.states.len..(j + 1) * self.states.len]
    }
}
