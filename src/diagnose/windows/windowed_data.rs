//! Recordings as windows: torque and motion averaged at the rate at which causes are distinguished.
//!
//! Averaging is a linear operation applied to the measured torque and to every column alike, so no
//! filter separates the two. White noise stays white, and steps of friction keep their size.
//! Windows in which a joint reverses are not used for that joint's own torque, since the sign of
//! its velocity is noise there.

use std::borrow::Cow;
use std::ops::Index;
use std::sync::{Arc, Mutex, PoisonError};

use crate::data::signal::{Band, central};
use crate::model::{Change, DriveTerm, PerturbableArm, StandardParameter, States};
use crate::numerics::parallel::{parallel, threads_for};

use super::earlier::earlier;
use super::postures::Postures;
use super::recording::{Recording, Stretch};
use super::torque_noise::torque_noise;

/// Time cut off both ends of every stretch, s, so that a delayed state exists for each sample.
const EDGE: f64 = 0.15;

/// Part of a series, taken `by` samples earlier; empty if not recorded. Unshifted data are
/// borrowed, since all models read the same recording.
fn recorded(series: &[f64], span: std::ops::Range<usize>, by: f64) -> Cow<'_, [f64]> {
    match (series.is_empty(), by == 0.0) {
        (true, _) => Cow::Borrowed(&[]),
        (_, true) => Cow::Borrowed(&series[span]),
        _ => Cow::Owned(earlier(series, span, by)),
    }
}

/// Number of samples cut off both ends of the used part of a stretch; `len`: samples of that part.
pub(in crate::diagnose) fn edge(stretch: &Stretch, len: usize) -> usize {
    if len as f64 * stretch.period > 1.0 { (EDGE / stretch.period).ceil() as usize } else { 0 }
}

/// The largest delay in the search, s.
pub const MOST_DELAY: f64 = 0.14;

/// Number of parts of the data for cross-validation. Each is made of pieces from everywhere, so
/// that left-out data lie within the range of the others.
pub const BLOCKS: usize = 8;

/// Length of a piece, s: longer than the autocorrelation time of residuals.
const PIECE: f64 = 1.0;

/// Number of windows whose base regressor is computed at once: a whole long log would take as much
/// memory as everything else.
const PART: usize = 1024;

/// The same for torques, which are fewer: one task of a thread.
const BATCH: usize = 1 << 11;

/// Number of joints whose slopes are cached: a few threads search one joint after the other.
const SLOPES: usize = 2;

/// Signs of a velocity, one byte each: -1, 0 or 1.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Signs(Vec<i8>);

impl Signs {
    /// Iterates over the signs in order.
    pub fn iter(&self) -> impl Iterator<Item = f64> + '_ {
        self.0.iter().map(|s| f64::from(*s))
    }
}

impl Index<usize> for Signs {
    type Output = f64;

    fn index(&self, k: usize) -> &f64 {
        match self.0[k] {
            0 => &0.0,
            1.. => &1.0,
            _ => &-1.0,
        }
    }
}

/// Motion of one joint during one stretch, at the rate of the log.
#[derive(Debug, Clone)]
pub struct JointSeries<'r> {
    /// Position, rad.
    pub q: Cow<'r, [f64]>,
    /// Velocity, rad/s.
    pub v: Cow<'r, [f64]>,
    /// Sign of the velocity, 0 inside its noise.
    pub sign: Signs,
    /// Whether a law of the velocity applies: the velocity exceeds its noise, and the joint does
    /// not stick.
    pub moves: Vec<bool>,
    /// Acceleration, rad/s^2.
    pub a: Cow<'r, [f64]>,
    /// Temperature, deg C; empty if not recorded.
    pub temperature: Cow<'r, [f64]>,
    /// Position of the motor, rad; empty if not recorded.
    pub motor: Cow<'r, [f64]>,
    /// Low-pass filters of the position.
    pub filters: Band,
    /// Share of the wider low-pass; see [`Band`].
    share: Cow<'r, [f64]>,
    /// Sampling period, s.
    pub period: f64,
    /// Time of the stretch's first sample since the recording began, s.
    start: f64,
    /// Index of the first sample in the stretch, and the delay of its torque in samples.
    since: [f64; 2],
    /// Torque of the rigid model over all windows, N m; empty until it is computed.
    rigid: Arc<Vec<f64>>,
    /// Rotor inertia of the file, kg m^2.
    rotor: f64,
    first: usize,
    windows: usize,
    per: usize,
}

impl JointSeries<'_> {
    /// Time of a sample since the recording began, s.
    pub fn t(&self, k: usize) -> f64 {
        let [first, by] = self.since;
        self.start + (first + k as f64 - by) * self.period
    }

    /// Torque of the rigid model without the file's rotor, which the gear transmits, N m.
    pub fn load(&self, k: usize) -> f64 {
        match self.rigid.get(self.first..self.first + self.windows) {
            Some(rigid) => between(rigid, self.per, k) - self.rotor * self.a[k],
            None => 0.0,
        }
    }

    /// Effect of the low-pass on a series of samples, and two derivatives; see [`Band::seen`].
    fn seen(&self, x: &[f64]) -> [Vec<f64>; 3] {
        Band { share: self.share.to_vec(), ..self.filters.clone() }.seen(0, x, self.period)
    }
}

/// Torques per unit of one unknown: for each joint on which it acts, a series averaged over the
/// windows.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Column {
    /// Joint and series (`len` numbers), sorted by joint; shared between sums of columns.
    pub rows: Vec<(usize, Arc<Vec<f64>>)>,
}

impl Column {
    /// A column of these joints and series.
    pub fn new(rows: Vec<(usize, Vec<f64>)>) -> Self {
        Self { rows: rows.into_iter().map(|(joint, series)| (joint, Arc::new(series))).collect() }
    }

    /// A column on one joint alone.
    pub fn on(joint: usize, series: Vec<f64>) -> Self {
        Self::new(vec![(joint, series)])
    }
}

/// Sensitivity of the rigid torques to one joint's motion: a series over the windows for each
/// joint's torque.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Slopes {
    /// With respect to its position, N m/rad.
    pub position: Vec<Vec<f64>>,
    /// With respect to its velocity, N m s/rad.
    pub velocity: Vec<Vec<f64>>,
    /// With respect to its acceleration, kg m^2.
    pub acceleration: Vec<Vec<f64>>,
}

/// Windows of one stretch.
struct Cut<'r> {
    stretch: &'r Stretch,
    /// Samples that are used.
    span: std::ops::Range<usize>,
    /// Samples per window.
    per: usize,
    /// Index of its first window.
    first: usize,
    windows: usize,
    /// Start time of the recording, s.
    begin: f64,
}

/// Samples per window at `rate` windows per second.
pub(super) fn samples_of_window(rate: f64, period: f64) -> usize {
    ((1.0 / (rate * period)).round() as usize).max(1)
}

/// The stretches that are long enough, in order.
fn cuts(recordings: &[Recording], rate: f64) -> Vec<Cut<'_>> {
    let mut all: Vec<Cut<'_>> = Vec::new();
    let mut first = 0;
    for recording in recordings {
        for stretch in &recording.stretches {
            let per = samples_of_window(rate, stretch.period);
            let len = stretch.states.len;
            let edge = edge(stretch, len);
            let windows = len.saturating_sub(2 * edge) / per;
            if windows > 0 {
                let span = edge..edge + windows * per;
                all.push(Cut { stretch, span, per, first, windows, begin: recording.begin });
                first += windows;
            }
        }
    }
    all
}

impl<'r> Cut<'r> {
    /// Middle of each window, s since the recording began.
    fn time(&self) -> impl Iterator<Item = f64> + '_ {
        let (start, period) = (self.stretch.start - self.begin, self.stretch.period);
        let mid = 0.5 * (self.per - 1) as f64;
        (0..self.windows).map(move |w| start + (self.span.start as f64 + (w * self.per) as f64 + mid) * period)
    }

    /// Torque of a joint averaged over the windows, N m.
    fn torque(&self, j: usize) -> Vec<f64> {
        average(&self.stretch.of(&self.stretch.tau, j)[self.span.clone()], self.per)
    }

    /// Measured torque of a joint behind its gear, averaged over the windows, N m.
    fn load(&self, j: usize) -> Vec<f64> {
        average(&self.stretch.of(&self.stretch.load, j)[self.span.clone()], self.per)
    }

    /// Motion of a joint whose torque has a delay of `delay` s.
    fn joint(&self, j: usize, delay: f64, signed: &SpeedSign) -> JointSeries<'r> {
        let (stretch, span): (&'r Stretch, _) = (self.stretch, &self.span);
        let (len, by) = (stretch.states.len, delay / stretch.period);
        let own = |x: &'r [f64], by: f64| recorded(x.chunks_exact(len).nth(j).unwrap_or(&[]), span.clone(), by);
        let v = own(&stretch.states.dq, by);
        let sticks = |k: usize| {
            let then = (k as f64 - by).round().clamp(0.0, (len - 1) as f64) as usize;
            !stretch.stuck.is_empty() && stretch.of(&stretch.stuck, j)[then]
        };
        let SpeedSign { zone, stands, .. } = *signed;
        JointSeries {
            q: own(&stretch.states.q, by),
            a: own(&stretch.states.ddq, by),
            temperature: own(&stretch.temperature, 0.0),
            motor: own(&stretch.motor, by),
            filters: stretch.band.of(j, Vec::new()),
            share: own(&stretch.band.share, by),
            period: stretch.period,
            start: stretch.start - self.begin,
            since: [span.start as f64, by],
            rigid: Arc::default(),
            rotor: 0.0,
            moves: span.clone().zip(&*v).map(|(k, v)| v.abs() > zone && (stands || !sticks(k))).collect(),
            sign: Signs(v.iter().map(|v| signed.of(*v)).collect()),
            v,
            first: self.first,
            windows: self.windows,
            per: self.per,
        }
    }
}

/// Sign of a joint's velocity where it is above the noise.
struct SpeedSign {
    /// Speed below which the sign is noise, rad/s.
    zone: f64,
    /// Whether the joint is at rest most of the time.
    stands: bool,
    /// Whether every sample counts.
    all: bool,
}

impl SpeedSign {
    /// Sign of a velocity. If every sample counts, it is that of the file's laws, so that their
    /// output is evaluated; for a joint at rest the sign is pure noise.
    fn of(&self, v: f64) -> i8 {
        let known = if self.all && !self.stands { v != 0.0 } else { v.abs() > self.zone };
        if known { v.signum() as i8 } else { 0 }
    }

    /// Windows of a joint that are used.
    fn live(&self, own: &JointSeries<'_>) -> Vec<bool> {
        let one_way = |w: &[i8]| w.iter().all(|s| *s != 0) && w.iter().all(|s| *s == w[0]);
        own.sign.0.chunks_exact(own.per).map(|w| self.all || self.stands || one_way(w)).collect()
    }
}

/// Measured torques behind the gears, by joint; empty where they are not known throughout.
fn loads(cuts: &[Cut<'_>], dof: usize) -> Vec<Vec<f64>> {
    if cuts.iter().any(|cut| cut.stretch.load.is_empty()) {
        return Vec::new();
    }
    (0..dof).map(|j| cuts.iter().flat_map(|cut| cut.load(j)).collect()).collect()
}

/// Motion of all joints averaged over the windows, `delay` s earlier.
fn states_at(cuts: &[Cut<'_>], dof: usize, delay: f64) -> States {
    let len: usize = cuts.iter().map(|c| c.windows).sum();
    let series = || Vec::with_capacity(dof * len);
    let mut states = States { len, q: series(), dq: series(), ddq: series() };
    for j in 0..dof {
        for Cut { stretch, span, per, .. } in cuts {
            let mean = |x: &[f64]| average(&earlier(stretch.of(x, j), span.clone(), delay / stretch.period), *per);
            states.q.extend(mean(&stretch.states.q));
            states.dq.extend(mean(&stretch.states.dq));
            states.ddq.extend(mean(&stretch.states.ddq));
        }
    }
    states
}

/// Windowed data on which causes are evaluated.
pub struct WindowedData<'a> {
    /// The arm.
    pub plant: &'a dyn PerturbableArm,
    /// Number of windows.
    pub len: usize,
    /// Measured torque, per joint, N m.
    pub y: Vec<Arc<Vec<f64>>>,
    /// Motion, once for each distinct delay.
    pub states: Vec<Arc<States>>,
    /// Index into [`WindowedData::states`] of the state of a joint's torque.
    pub state_of_joint: Vec<usize>,
    /// Time of each window since its recording began, s.
    pub time: Vec<f64>,
    /// Whether a window is used for a joint's torque.
    pub live: Vec<Vec<bool>>,
    /// Index of the part of the data, for cross-validation, per window.
    pub block: Vec<usize>,
    /// Ranges of contiguous windows.
    pub runs: Vec<std::ops::Range<usize>>,
    /// Motion of each joint at the rate of the log, by stretch.
    pub own: Vec<Vec<JointSeries<'a>>>,
    /// Torque of the rigid model, per joint, N m. Where torques are those of the gears alone, plus
    /// the measured torque behind the gears.
    pub rigid: Vec<Arc<Vec<f64>>>,
    /// Measured torques behind the gears, per joint, N m; empty where `y` contains them.
    load: Vec<Vec<f64>>,
    /// Torque of the whole model, per joint, N m.
    pub whole: Vec<Arc<Vec<f64>>>,
    /// The same without Coulomb friction, which is discontinuous.
    pub smooth: Vec<Arc<Vec<f64>>>,
    /// Base parameters of the rigid model; friction entries zero.
    pub beta: Vec<f64>,
    /// Standard parameters with the base parameters `beta`; `None` if unknown.
    pub standard: Option<Vec<f64>>,
    /// Spacing of the windows, s.
    pub step: f64,
    /// Speed below which a joint's sign is noise, rad/s.
    pub velocity_noise_limit: Vec<f64>,
    /// Whether a joint is at rest most of the time.
    stands: Vec<bool>,
    /// Smallest and largest position of each joint, rad.
    pub travel: Vec<[f64; 2]>,
    /// Largest speed of each joint, rad/s.
    pub fastest: Vec<f64>,
    /// Assumed delay of each joint's torque, s.
    pub delays: Vec<f64>,
    /// Rotor inertias of the file, kg m^2.
    pub rotors: Vec<f64>,
    /// Largest torque of each joint, N m: its limit in the file, or one and a half times the
    /// largest one measured, whichever is larger.
    pub rated: Vec<f64>,
    /// Standard deviation of the noise of a window's torque, per joint, N m.
    pub noise: Vec<f64>,
    /// Longest sampling period of the logs, s.
    pub period: f64,
    /// Whether every window counts, as where models are evaluated and not fitted.
    pub all: bool,
    /// Cached [`WindowedData::slopes`] of the last joints, with their indices.
    slopes: Mutex<Vec<(usize, Arc<Slopes>)>>,
    /// Cached quantities of the posture.
    pub(super) postures: Postures,
}

impl<'a> WindowedData<'a> {
    /// Windows of about `1 / rate` seconds (at least a sample). Torques are assumed late by
    /// `delays` (one per joint, s).
    ///
    /// With `all`, every window counts, whatever the joint's speed.
    pub fn new(
        plant: &'a dyn PerturbableArm,
        recordings: &'a [Recording],
        rate: f64,
        delays: &[f64],
        all: bool,
    ) -> Self {
        let dof = plant.dof();
        let cuts = cuts(recordings, rate);
        let len = cuts.last().map_or(0, |c| c.first + c.windows);
        let step = cuts.last().map_or(1.0 / rate, |c| c.per as f64 * c.stretch.period);
        let period = longest_period(recordings);
        let dead = dead_zones(recordings, dof);
        let time = cuts.iter().flat_map(Cut::time).collect();
        let zero = Arc::new(vec![0.0; len]);
        let mut windowed = Self {
            y: vec![Arc::default(); dof],
            live: vec![Vec::new(); dof],
            own: vec![Vec::new(); dof],
            states: Vec::new(),
            state_of_joint: Vec::new(),
            block: (0..len)
                .map(|w| (w as f64 * step / PIECE.min(len as f64 * step / BLOCKS as f64)) as usize % BLOCKS)
                .collect(),
            rigid: vec![zero.clone(); dof],
            load: loads(&cuts, dof),
            whole: vec![zero.clone(); dof],
            smooth: vec![zero; dof],
            beta: vec![0.0; plant.base_parameters().len()],
            standard: None,
            velocity_noise_limit: dead.iter().map(|d| d.0).collect(),
            stands: dead.iter().map(|d| d.1).collect(),
            travel: vec![[f64::INFINITY, f64::NEG_INFINITY]; dof],
            fastest: vec![0.0; dof],
            delays: vec![f64::NAN; dof],
            rotors: rotors(plant),
            rated: rated(plant, recordings),
            noise: torque_noise(recordings.iter().flat_map(|r| &r.stretches), dof)
                .iter()
                .map(|s| s / (step / period).max(1.0).sqrt())
                .collect(),
            period,
            all,
            slopes: Mutex::default(),
            postures: Postures::default(),
            runs: cuts.iter().map(|c| c.first..c.first + c.windows).collect(),
            plant,
            len,
            time,
            step,
        };
        windowed.take_delays(&cuts, delays);
        windowed
    }

    /// Changes the delays of the torques, and recomputes the dependent rigid torques. `recordings`,
    /// `rate`: those of [`WindowedData::new`].
    pub fn delayed_by(&mut self, recordings: &'a [Recording], rate: f64, delays: &[f64]) {
        let before = self.delays.clone();
        self.take_delays(&cuts(recordings, rate), delays);
        let moved: Vec<bool> = before.iter().zip(delays).map(|(a, b)| a != b).collect();
        let mut fresh = self.torques_where(&self.beta, &moved, |_, _| {});
        self.with_load(&mut fresh);
        for (j, torque) in fresh.into_iter().enumerate().filter(|(j, _)| moved[*j]) {
            self.rigid[j] = Arc::new(torque);
        }
        self.model_changed();
    }

    /// Recomputes motion and torque of the joints whose delay has changed.
    fn take_delays(&mut self, cuts: &[Cut<'a>], delays: &[f64]) {
        let dof = self.dof();
        let mut distinct: Vec<f64> = Vec::new();
        let of_joint: Vec<usize> = delays
            .iter()
            .map(|d| {
                distinct.iter().position(|x| x == d).unwrap_or_else(|| {
                    distinct.push(*d);
                    distinct.len() - 1
                })
            })
            .collect();
        let mut before = std::mem::take(&mut self.states);
        let states = distinct.iter().map(|delay| {
            let known = self.delays.iter().zip(&self.state_of_joint).find(|(d, _)| *d == delay);
            match known {
                Some((_, &index)) => std::mem::take(&mut before[index]),
                None => Arc::new(states_at(cuts, dof, *delay)),
            }
        });
        self.states = states.collect();
        self.state_of_joint = of_joint;
        self.postures = Postures::default();
        for j in (0..dof).filter(|&j| self.delays[j] != delays[j]) {
            let (zone, stands) = (self.velocity_noise_limit[j], self.stands[j]);
            let signed = SpeedSign { zone, stands, all: self.all };
            self.own[j] = cuts.iter().map(|cut| cut.joint(j, delays[j], &signed)).collect();
            self.live[j] = self.joined(self.own[j].iter().map(|own| signed.live(own)));
            let all = || self.own[j].iter().flat_map(|own| own.q.iter().copied());
            self.travel[j] = [all().fold(f64::INFINITY, f64::min), all().fold(f64::NEG_INFINITY, f64::max)];
            self.fastest[j] = self.own[j].iter().flat_map(|own| own.v.iter()).fold(0.0, |m, v| v.abs().max(m));
            let mut y = self.joined(cuts.iter().map(|cut| cut.torque(j)));
            self.masked(j, &mut y);
            self.y[j] = Arc::new(y);
        }
        self.delays = delays.to_vec();
    }

    /// A series over the windows, concatenated from its stretches. Allocated once: a growing vector
    /// would take up to twice its length.
    pub fn joined<T>(&self, stretches: impl Iterator<Item = Vec<T>>) -> Vec<T> {
        let mut all = Vec::with_capacity(self.len);
        stretches.for_each(|stretch| all.extend(stretch));
        all
    }

    /// Number of degrees of freedom.
    pub fn dof(&self) -> usize {
        self.y.len()
    }

    /// A column that acts on joint `j` alone, from that joint's motion at the log's rate.
    pub fn own_column(&self, j: usize, f: impl Fn(&JointSeries<'_>) -> Vec<f64>) -> Column {
        Column::on(j, self.own_series(j, f))
    }

    /// The series of [`WindowedData::own_column`].
    pub fn own_series(&self, j: usize, f: impl Fn(&JointSeries<'_>) -> Vec<f64>) -> Vec<f64> {
        let mut series = self.joined(self.own[j].iter().map(|own| average(&f(own), own.per)));
        self.masked(j, &mut series);
        series
    }

    /// [`WindowedData::own_column`] of a function without memory.
    pub fn pointwise(&self, j: usize, f: impl Fn(&JointSeries<'_>, usize) -> f64) -> Column {
        self.own_column(j, |own| (0..own.v.len()).map(|k| f(own, k)).collect())
    }

    /// Averages of `f` (index of the sample in the stretch) over one stretch's windows.
    pub fn average_of(&self, own: &JointSeries<'_>, f: impl Fn(usize) -> f64) -> Vec<f64> {
        average(&(0..own.v.len()).map(f).collect::<Vec<_>>(), own.per)
    }

    /// A series over the windows, delayed by `by` seconds, interpolated within each run.
    pub fn delayed(&self, series: &[f64], by: f64) -> Vec<f64> {
        let mut out = vec![0.0; series.len()];
        for run in &self.runs {
            out[run.clone()].copy_from_slice(&earlier(&series[run.clone()], 0..run.len(), by / self.step));
        }
        out
    }

    /// Difference quotient of the torques for a change of the arm of size `scale`.
    pub fn changed(&self, change: &Change, standard: &[f64], scale: f64) -> Vec<Vec<f64>> {
        let mut rows = vec![vec![0.0; self.len]; self.dof()];
        for (index, states) in self.states.iter().enumerate() {
            let (mut one, mut other) = (vec![0.0; self.dof() * self.len], vec![0.0; self.dof() * self.len]);
            self.plant.changed_dynamics(change, states, standard, &mut one);
            self.plant.inverse_dynamics(states, standard, &mut other);
            for (j, row) in rows.iter_mut().enumerate().filter(|(j, _)| self.state_of_joint[*j] == index) {
                let span = j * self.len..(j + 1) * self.len;
                row.iter_mut()
                    .zip(one[span.clone()].iter().zip(&other[span]))
                    .for_each(|(r, (a, b))| *r = (a - b) / scale);
            }
        }
        rows
    }

    /// Sets a series to zero where the window is not used for joint `j`.
    pub fn masked(&self, j: usize, series: &mut [f64]) {
        series.iter_mut().zip(&self.live[j]).filter(|(_, live)| !**live).for_each(|(x, _)| *x = 0.0);
    }

    /// Several joints' series as one column, masked; joints on which nothing acts are left out.
    pub fn column(&self, rows: Vec<Vec<f64>>) -> Column {
        let mut column = Column::default();
        for (j, mut series) in rows.into_iter().enumerate() {
            self.masked(j, &mut series);
            if series.iter().any(|x| *x != 0.0) {
                column.rows.push((j, Arc::new(series)));
            }
        }
        column
    }

    /// Entries of the base regressor that belong to the torque of each `wanted` joint: `(base
    /// parameter, series)`.
    pub fn base_rows(&self, wanted: &[bool]) -> Vec<Vec<(usize, Vec<f64>)>> {
        let pattern = self.plant.base_pattern();
        let mut rows: Vec<Vec<(usize, Vec<f64>)>> = vec![Vec::new(); self.dof()];
        // Position of each entry in its row, for rows that use these states.
        let mut places = vec![(0, 0); pattern.len()];
        for index in 0..self.states.len() {
            let own = |row: usize| self.state_of_joint[row] == index && wanted[row];
            if !(0..self.dof()).any(own) {
                continue;
            }
            for (place, &(row, column)) in places.iter_mut().zip(pattern) {
                if own(row) {
                    *place = (row, rows[row].len());
                    rows[row].push((column, vec![0.0; self.len]));
                }
            }
            self.base_parts(index, |entry, &(row, _), first, part| {
                if own(row) {
                    let (row, at) = places[entry];
                    rows[row][at].1[first..first + part.len()].copy_from_slice(part);
                }
            });
        }
        rows
    }

    /// Entries of the base regressor, each joint's over its own states, in parts of the windows to
    /// limit memory: joint and base parameter, first window, values.
    pub fn base_entries(&self, mut take: impl FnMut((usize, usize), usize, &[f64])) {
        for index in 0..self.states.len() {
            self.base_parts(index, |_, &(row, column), first, part| {
                if self.state_of_joint[row] == index {
                    take((row, column), first, part);
                }
            });
        }
    }

    /// Entries of the base regressor over the states of one delay, in parts of the windows: index
    /// and pattern of the entry, first window, values.
    fn base_parts(&self, index: usize, mut take: impl FnMut(usize, &(usize, usize), usize, &[f64])) {
        let pattern = self.plant.base_pattern();
        let mut out = vec![0.0; pattern.len() * PART.min(self.len)];
        for first in (0..self.len).step_by(PART) {
            let states = self.states[index].part(first, (first + PART).min(self.len));
            let out = &mut out[..pattern.len() * states.len];
            self.plant.base_regressor(&states, out);
            for (entry, (part, at)) in out.chunks_exact(states.len).zip(pattern).enumerate() {
                take(entry, at, first, part);
            }
        }
    }

    /// Torques of the rigid arm with these base parameters, N m, of the `wanted` joints; zero for
    /// the others. Each window's motion is first changed by `change` (a part of the motion, and its
    /// range of windows).
    fn torques_where(
        &self,
        base: &[f64],
        wanted: &[bool],
        change: impl Fn(&mut States, std::ops::Range<usize>) + Sync,
    ) -> Vec<Vec<f64>> {
        let mut rows = vec![vec![0.0; self.len]; self.dof()];
        let used = |index: &usize| self.state_of_joint.iter().zip(wanted).any(|(own, wanted)| own == index && *wanted);
        for index in (0..self.states.len()).filter(used) {
            let span = |k: usize| k * BATCH..((k + 1) * BATCH).min(self.len);
            let parts = parallel(threads_for(self.len * self.dof()), self.len.div_ceil(BATCH), |k| {
                let mut states = self.states[index].part(span(k).start, span(k).end);
                change(&mut states, span(k));
                let mut out = vec![0.0; self.dof() * states.len];
                self.plant.base_torques(&states, base, &mut out);
                out
            });
            for (k, part) in parts.iter().enumerate() {
                let own = rows.iter_mut().zip(part.chunks_exact(span(k).len())).zip(&self.state_of_joint);
                own.filter(|(_, own)| **own == index)
                    .for_each(|((row, torque), _)| row[span(k)].copy_from_slice(torque));
            }
        }
        rows
    }

    /// Torques of the rigid arm with these base parameters, N m, of the `wanted` joints; zero for
    /// the others.
    pub fn base_torques(&self, base: &[f64], wanted: &[bool]) -> Vec<Vec<f64>> {
        self.torques_where(base, wanted, |_, _| {})
    }

    /// Torque of the rigid model with each window's motion first changed by `change`.
    fn rigid_with(&self, change: impl Fn(&mut States, std::ops::Range<usize>) + Sync) -> Vec<Vec<f64>> {
        let mut rows = self.torques_where(&self.beta, &vec![true; self.dof()], change);
        self.with_load(&mut rows);
        rows
    }

    /// Adds the measured torques behind the gears, if there are any.
    fn with_load(&self, rows: &mut [Vec<f64>]) {
        for (row, load) in rows.iter_mut().zip(&self.load) {
            row.iter_mut().zip(load).for_each(|(torque, load)| *torque += load);
        }
    }

    /// Position, velocity and acceleration of joint `j` at the time of its own torque, over the
    /// windows, rad, rad/s, rad/s^2.
    pub fn motion_of(&self, j: usize) -> [&[f64]; 3] {
        let States { q, dq, ddq, .. } = &*self.states[self.state_of_joint[j]];
        [q, dq, ddq].map(|x| &x[j * self.len..(j + 1) * self.len])
    }

    /// Torque that the gear of joint `j` transmits if its link moves like its motor, over the
    /// windows, N m: that of the rigid model without the file's rotor.
    pub fn transmitted(&self, j: usize) -> Vec<f64> {
        let [_, _, acceleration] = self.motion_of(j);
        self.rigid[j].iter().zip(acceleration).map(|(t, a)| t - self.rotors[j] * a).collect()
    }

    /// Part of the rigid model's torque that follows from the recorded motion, of a joint, N m.
    pub fn by_motion(&self, j: usize) -> Vec<f64> {
        let load = |w: usize| self.load.get(j).map_or(0.0, |load| load[w]);
        self.rigid[j].iter().enumerate().map(|(w, torque)| torque - load(w)).collect()
    }

    /// Sets the base parameters (friction entries zero) of the rigid model.
    pub fn set_model(&mut self, beta: Vec<f64>, standard: Option<Vec<f64>>) {
        (self.beta, self.standard) = (beta, standard);
        self.rigid = self.rigid_with(|_, _| {}).into_iter().map(Arc::new).collect();
        self.model_changed();
    }

    /// Updates everything that depends on the rigid torques.
    fn model_changed(&mut self) {
        self.slopes = Mutex::default();
        for (j, stretches) in self.own.iter_mut().enumerate() {
            for own in stretches {
                (own.rigid, own.rotor) = (self.rigid[j].clone(), self.rotors[j]);
            }
        }
    }

    /// Visible part of a change of joint `j`'s position, given as a function of a series over the
    /// windows, after the low-pass of its positions. Returns the change (rad) and its two
    /// derivatives, over the windows.
    pub fn seen_through(&self, j: usize, series: &[f64], change: impl Fn(f64) -> f64) -> [Vec<f64>; 3] {
        let mut out: [Vec<f64>; 3] = std::array::from_fn(|_| Vec::with_capacity(self.len));
        for own in &self.own[j] {
            let fine = spread(&series[own.first..own.first + own.windows], own.per);
            let changed: Vec<f64> = fine.into_iter().map(&change).collect();
            for (out, seen) in out.iter_mut().zip(own.seen(&changed)) {
                out.extend(average(&seen, own.per));
            }
        }
        out
    }

    /// Difference quotient of the rigid torque when joint `j` actually moves by `scale` times these
    /// (position, velocity, acceleration over the windows) more. Returns the torques per unit of
    /// `scale`, all joints.
    pub fn moved(&self, j: usize, by: &[Vec<f64>; 3], scale: f64) -> Vec<Vec<f64>> {
        let mut rows = self.rigid_with(|states, part| {
            let own = j * part.len()..(j + 1) * part.len();
            for (x, by) in [&mut states.q, &mut states.dq, &mut states.ddq].into_iter().zip(by) {
                x[own.clone()].iter_mut().zip(&by[part.clone()]).for_each(|(x, by)| *x += scale * by);
            }
        });
        for (row, rigid) in rows.iter_mut().zip(&self.rigid) {
            row.iter_mut().zip(&**rigid).for_each(|(a, b)| *a = (*a - b) / scale);
        }
        rows
    }

    /// Frees caches.
    pub fn forget(&mut self) {
        self.slopes = Mutex::default();
        self.postures = Postures::default();
    }

    /// Sensitivities of the rigid torques to joint `j`'s motion.
    pub fn slopes(&self, j: usize) -> Arc<Slopes> {
        let lock = || self.slopes.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, known)) = lock().iter().find(|(joint, _)| *joint == j) {
            return known.clone();
        }
        let by = |step: f64, what: fn(&mut States) -> &mut Vec<f64>| {
            let mut rows = self.rigid_with(|states, part| {
                let own = j * part.len()..(j + 1) * part.len();
                what(states)[own].iter_mut().for_each(|x| *x += step);
            });
            for (row, rigid) in rows.iter_mut().zip(&self.rigid) {
                row.iter_mut().zip(&**rigid).for_each(|(a, b)| *a = (*a - b) / step);
            }
            rows
        };
        let made = Arc::new(Slopes {
            position: by(1e-3, |s| &mut s.q),
            velocity: by(1e-2, |s| &mut s.dq),
            acceleration: by(1.0, |s| &mut s.ddq),
        });
        let mut held = lock();
        held.push((j, made.clone()));
        if held.len() > SLOPES {
            held.remove(0);
        }
        made
    }

    /// Time derivative of a series over the windows, by central differences within each run.
    pub fn rate_of(&self, series: &[f64]) -> Vec<f64> {
        let mut out = Vec::with_capacity(series.len());
        for run in &self.runs {
            out.extend(central(&series[run.clone()], self.step));
        }
        out
    }

    /// Difference quotient of the rigid torque when joint `j` is actually at `q + scale * shift`
    /// (`shift` a series over the windows). Returns the torques per unit of `scale`, all joints.
    pub fn shifted(&self, j: usize, shift: &[f64], scale: f64) -> Vec<Vec<f64>> {
        let rate = self.rate_of(shift);
        let second = self.rate_of(&rate);
        self.moved(j, &[shift.to_vec(), rate, second], scale)
    }
}

/// Means of consecutive groups of `per` samples.
fn average(x: &[f64], per: usize) -> Vec<f64> {
    x.chunks_exact(per).map(|w| w.iter().sum::<f64>() / per as f64).collect()
}

/// Linear interpolation from windows back to samples, between the windows' middles.
fn spread(x: &[f64], per: usize) -> Vec<f64> {
    (0..x.len() * per).map(|k| between(x, per, k)).collect()
}

/// The same at one sample.
fn between(x: &[f64], per: usize, k: usize) -> f64 {
    let last = x.len().saturating_sub(1);
    let at = ((k as f64 - 0.5 * (per - 1) as f64) / per as f64).clamp(0.0, last as f64);
    let (i, f) = (at.floor() as usize, at.fract());
    x[i] + f * (x[(i + 1).min(last)] - x[i])
}

/// Rotor inertia of each joint in the file, kg m^2.
fn rotors(plant: &dyn PerturbableArm) -> Vec<f64> {
    let of = |row: &usize| {
        let rotor = StandardParameter::Drive(*row, DriveTerm::IA);
        plant.standard_parameters().iter().position(|p| *p == rotor).map_or(0.0, |at| plant.given_drive(at))
    };
    plant.rows().iter().map(of).collect()
}

/// Longest sampling period, s.
fn longest_period(recordings: &[Recording]) -> f64 {
    recordings.iter().flat_map(|r| &r.stretches).map(|s| s.period).fold(0.0, f64::max).max(1e-9)
}

/// Largest torque of each joint, N m: the larger of its limit and one and a half times the largest
/// measured torque.
fn rated(plant: &dyn PerturbableArm, recordings: &[Recording]) -> Vec<f64> {
    let stretches = || recordings.iter().flat_map(|r| &r.stretches);
    let seen = |j: usize| stretches().flat_map(|s| s.of(&s.tau, j)).fold(0.0_f64, |m, t| m.max(t.abs()));
    let limits = plant.torque_limits();
    (0..plant.dof()).map(|j| limits[j].unwrap_or(0.0).max(1.5 * seen(j))).collect()
}

/// Speed below which each joint's sign is noise, rad/s, and whether it is at rest (below that speed
/// most of the time).
pub(in crate::diagnose) fn dead_zones(recordings: &[Recording], dof: usize) -> Vec<(f64, bool)> {
    let stretches = || recordings.iter().flat_map(|r| &r.stretches);
    (0..dof)
        .map(|j| {
            let noise = stretches().map(|s| s.velocity_noise[j]).fold(0.0, f64::max);
            let fastest = stretches().flat_map(|s| s.of(&s.states.dq, j)).fold(0.0_f64, |m, v| m.max(v.abs()));
            let zone = (3.0 * noise).max(0.01 * fastest).max(1e-4);
            let (mut inside, mut all) = (0, 0);
            for v in stretches().flat_map(|s| s.of(&s.states.dq, j)) {
                inside += usize::from(v.abs() <= zone);
                all += 1;
            }
            (zone, 2 * inside > all)
        })
        .collect()
}
