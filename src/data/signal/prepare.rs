//! Converts rows of a log to motions in bounded memory: even clock, zero-phase low-pass,
//! derivatives -> [`Motion`]s.
//!
//! A segment longer than a chunk is filtered in overlapping chunks. The overlap covers the filter's
//! transient (to 1e-12), so the result equals that of filtering the whole segment at once.

use super::Band;
use super::Motion;
use super::central;
use super::clock;
use super::deserved::{Deserved, deserved, steps};
use super::even::Resampler;
use super::low_pass;
use super::noise_between_reversals;
use super::resample;
use super::rest;
use super::rest::DeadZone;
use super::white_noise;
use crate::data::log::{
    Acceptance, Block, Clock, Finding, Kind, Layout, LogError, QualityCheck, Quantity, Reached, Reading, Role,
    Severity, Source, Verdict,
};
use crate::data::signal::breakaway_band::Derived;
use crate::data::signal::resample::smoother_evenly;
use crate::data::signal::stiction::{Stiction, sticks, stuck};
use crate::model::{States, VelocitySum};
use crate::numerics::sos::{Filtered, Sos, forward_backward_each};
use crate::numerics::sums::squared_differences;

/// A zero-phase Butterworth low-pass.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Filter {
    /// Order of one pass; filtering forward and backward doubles it.
    pub order: usize,
    /// Frequency at which one pass has -3 dB, Hz.
    pub cutoff: f64,
}

impl Default for Filter {
    /// Filter of the paper: order 5, 10 Hz (section III.E).
    fn default() -> Self {
        Self { order: 5, cutoff: 10.0 }
    }
}

impl Filter {
    /// Gain for white noise at `rate`, Hz, forward and backward: the root of the energy of the
    /// impulse response. It is 1 if the cutoff does not fit the rate, since nothing is filtered
    /// then.
    pub fn noise_gain(self, rate: f64) -> f64 {
        let Ok(sos) = low_pass(self.order, self.cutoff, rate) else { return 1.0 };
        let half = 2 * sos.settling();
        let mut impulse = vec![0.0; 2 * half + 1];
        impulse[half] = 1.0;
        sos.forward_backward(&mut impulse, 0);
        impulse.iter().map(|x| x * x).sum::<f64>().sqrt()
    }
}

impl Filter {
    /// Response of the velocity, 1/s, to a unit error in one recorded position, sample by sample.
    pub fn velocity_response(self, period: f64) -> Vec<f64> {
        let sos = low_pass(self.order, self.cutoff, period.recip()).ok();
        let half = sos.as_ref().map_or(4, |sos| 2 * sos.settling());
        let mut impulse = vec![0.0; 2 * half + 1];
        impulse[half] = 1.0;
        if let Some(sos) = sos {
            sos.forward_backward(&mut impulse, 0);
        }
        central(&impulse, period)
    }

    /// Standard deviation of a velocity, 1/s, whose positions have white noise of standard
    /// deviation `position`. The noise has density `s^2 / (rate / 2)` per Hz and is differentiated
    /// up to the cutoff, `s_v = 2 pi s sqrt(2 fc^3 / (3 rate))`.
    pub fn velocity_noise(self, position: f64, rate: f64) -> f64 {
        std::f64::consts::TAU * position * (2.0 * self.cutoff.powi(3) / (3.0 * rate)).sqrt()
    }
}

/// Source of velocities and accelerations.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Derivatives {
    /// Central differences of the filtered positions. Recorded velocities are often filtered and
    /// delayed.
    #[default]
    FromPosition,
    /// The log's `dq`, filtered, and its `ddq` or the central difference of `dq`.
    Recorded,
    /// Zero, for a log of static poses.
    AtRest,
}

/// Settings for converting samples to motion.
#[derive(Debug, Clone, PartialEq)]
pub struct Prepare {
    /// Low-pass for positions and torques; `None`: unfiltered.
    pub filter: Option<Filter>,
    /// Whether each joint's positions get the cutoff, at most that of [`Prepare::filter`], that
    /// minimises the expected error of their acceleration. The torques get the highest of these
    /// cutoffs. Default false: the filter's own cutoff.
    pub adaptive: bool,
    /// A second, higher cutoff, Hz. Positions between the two cutoffs are passed where they exceed
    /// the noise, as in a breakaway after a reversal. Not used if the log is sampled too slowly for
    /// it. If a joint's noise requires a cutoff below the filter's, its two cutoffs are its own and
    /// the filter's. The reason is that an otherwise smooth motion may be rough for a moment.
    /// Default `None`: never.
    pub bursts: Option<f64>,
    /// Source of velocities and accelerations.
    pub derivatives: Derivatives,
    /// Definition of rest. Default: derived from the noise of the log.
    pub dead_zone: DeadZone,
    /// Time removed at both ends of each segment, s, where filter and differences are one-sided.
    /// Default: two periods of the default cutoff.
    pub trim: f64,
    /// Delay of the recorded torque against the motion, s, which is compensated. Default 0.
    pub torque_delay: f64,
    /// Interval between used samples, after the low-pass. Default 1.
    pub stride: usize,
    /// Whether samples that are closer than a low-passed signal needs (a twelfth of the cutoff's
    /// period) are thinned to that spacing, since they carry no further information. Default false.
    pub thinned: bool,
    /// Torque columns. Default `tau`.
    pub torque: Quantity,
    /// Factor of each joint's torque column: N m per A if the columns are currents. Default empty:
    /// 1 for all.
    pub torque_gains: Vec<f64>,
    /// Torque constant of each joint, N m at the joint per A of the motor, if known. Currents are
    /// converted if `torque` selects them and [`Prepare::torque_gains`] is empty, or if it selects
    /// `tau` and the log has currents alone. Default empty: none known.
    pub torque_constants: Vec<Option<f64>>,
    /// Mapping of the log's columns.
    pub reading: Reading,
    /// Accepted findings.
    pub keep: Acceptance,
    /// Samples filtered at once. Default 65,536. Bounds the memory; a chunk is also the stretch
    /// over which the noise of `q` is estimated.
    pub chunk: usize,
    /// Whether motions contain samples around their core, for filtering quantities computed from
    /// them.
    pub margins: bool,
    /// Whether the torque stays unfiltered; [`Motion::sign`] is then not low-passed either.
    pub raw_torque: bool,
    /// Sums of velocities whose signs follow those of the joints in a motion.
    pub sums: Vec<VelocitySum>,
    /// Whether motions contain the temperatures, `temp1..`, if the log has them.
    pub temperature: bool,
    /// Whether motions contain the motor positions, `qm1..`, if the log has them.
    pub motor_positions: bool,
    /// Whether the torque of motions is that of the gears: `torque` minus the joints' `tau`, which
    /// is stored as [`Motion::load`]. Requires both columns.
    pub transmission: bool,
    /// Whether motions contain the external wrench, `fx .. mz`, if the log has it.
    pub wrench: bool,
}

impl Default for Prepare {
    fn default() -> Self {
        Self {
            filter: Some(Filter::default()),
            adaptive: false,
            bursts: None,
            derivatives: Derivatives::FromPosition,
            dead_zone: DeadZone::FromNoise,
            trim: 0.2,
            torque_delay: 0.0,
            stride: 1,
            thinned: false,
            torque: Quantity::Tau,
            torque_gains: Vec::new(),
            torque_constants: Vec::new(),
            reading: Reading::default(),
            keep: Acceptance::default(),
            chunk: 1 << 16,
            margins: false,
            raw_torque: false,
            sums: Vec::new(),
            temperature: false,
            motor_positions: false,
            transmission: false,
            wrench: false,
        }
    }
}

/// Highest sampling rate of a recording, Hz: the memory of filters is proportional to it.
const FASTEST: f64 = 1e6;

/// Samples per period of the cutoff that fully represent a low-passed signal: at half their rate
/// the default low-pass, forward and backward, leaves `(1 / 6)^10` of an amplitude.
const ENOUGH: f64 = 12.0;

/// Number of samples in a time, s, rounded up and bounded, so that sums do not overflow.
fn samples(seconds: f64, period: f64) -> usize {
    (seconds / period).ceil().min(1e15) as usize
}

impl Prepare {
    /// Settings with the torque columns that a log of this layout has, and the gains of currents.
    fn for_layout(&self, layout: &Layout) -> Result<Self, LogError> {
        let currents = match self.torque {
            Quantity::Current => self.torque_gains.is_empty(),
            Quantity::Tau if layout.has(Quantity::Tau) => false,
            Quantity::Tau if layout.has(Quantity::Current) => true,
            Quantity::Tau => return Err(layout.without_torque()),
            _ => false,
        };
        if !currents {
            return Ok(self.clone());
        }
        let constant = |joint: usize| self.torque_constants.get(joint).copied().flatten();
        let joints: Vec<usize> = (0..layout.dof).filter(|&j| constant(j).is_none()).map(|j| j + 1).collect();
        if !joints.is_empty() {
            return Err(LogError::NoTorqueConstant { file: layout.file.clone(), joints });
        }
        let torque_gains = (0..layout.dof).filter_map(constant).collect();
        Ok(Self { torque: Quantity::Current, torque_gains, ..self.clone() })
    }

    /// Quantities of the torque columns that are used.
    fn torques(&self) -> &[Quantity] {
        match (self.torque, self.transmission) {
            (Quantity::Current, true) => &[Quantity::Current, Quantity::Tau],
            (_, true) => &[Quantity::Taum, Quantity::Tau],
            (Quantity::Current, false) => &[Quantity::Current],
            (Quantity::Taum, false) => &[Quantity::Taum],
            (_, false) => &[Quantity::Tau],
        }
    }

    /// Interval between used samples, given their `period`, s.
    fn every(&self, period: f64) -> usize {
        // Static poses are no signal and are not thinned.
        let thinned = self.thinned && self.derivatives != Derivatives::AtRest;
        let enough = self.filter.filter(|_| thinned).map(|f| (period * ENOUGH * f.cutoff).recip() as usize);
        self.stride.max(1) * enough.unwrap_or(1).max(1)
    }

    /// Converts the ranges of current columns to torques, N m.
    fn in_torque(&self, mut reached: Vec<Reached>) -> Vec<Reached> {
        let prefix = self.torque.prefix();
        for (gain, joint) in self.torque_gains.iter().zip(1..) {
            for column in reached.iter_mut().filter(|r| r.column == format!("{prefix}{joint}")) {
                let ends = column.range.map(|end| end * gain);
                column.range = [ends[0].min(ends[1]), ends[0].max(ends[1])];
            }
        }
        reached
    }
}

/// Reason why a log can't be prepared.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum PrepareError {
    /// The log can't be used.
    #[error(transparent)]
    Log(#[from] LogError),
    /// The filter does not fit the sampling rate.
    #[error("{file}: {source}")]
    Cutoff {
        /// File name.
        file: String,
        /// Mismatch of cutoff and rate.
        source: super::CutoffError,
    },
    /// Decimation would alias frequencies that the low-pass passes.
    #[error(
        "{file}: one of {stride} samples of {rate:.1} Hz is too few for a low-pass of {cutoff} Hz; give a --stride of at most {most}"
    )]
    Stride {
        /// File name.
        file: String,
        /// Requested stride.
        stride: usize,
        /// Sampling rate, Hz.
        rate: f64,
        /// Cutoff, Hz.
        cutoff: f64,
        /// Largest stride that keeps the rate above 2.5 times the cutoff.
        most: usize,
    },
    /// The sampling rate is higher than that of any recording of an arm.
    #[error(
        "{file}: rows are {period:.3e} s apart, and more than 1 MHz is no recording of an arm; correct the column `t`, or give its \
         unit by --map"
    )]
    Rate {
        /// File name.
        file: String,
        /// Time between two rows, s.
        period: f64,
    },
    /// No samples are left.
    #[error(
        "{file}: nothing is left of {samples} samples after filtering and cutting {trim} s off both ends of each segment; record longer stretches or lower the trim"
    )]
    NothingLeft {
        /// File name.
        file: String,
        /// Number of samples in the log.
        samples: usize,
        /// Time removed at each end, s.
        trim: f64,
    },
}

/// Summary of a prepared log.
#[derive(Debug, Clone, PartialEq)]
pub struct Prepared {
    /// File name.
    pub file: String,
    /// Findings of the quality check and of the clock.
    pub findings: Vec<Finding>,
    /// Number of usable rows of the log.
    pub rows: usize,
    /// Number of samples passed on.
    pub samples: usize,
    /// Number of segments.
    pub segments: usize,
    /// Usual sampling rate, Hz.
    pub rate: f64,
    /// Ranges of positions and torques.
    pub reached: Vec<Reached>,
    /// Whether the log has both motor and joint torques.
    pub both_torques: bool,
}

/// Number of rows read at once.
pub(super) const ROWS: usize = 8192;

/// Reads a log to its end and passes each [`Motion`] to `sink`.
pub(super) fn motions(
    source: &mut dyn Source,
    dof: usize,
    prepare: &Prepare,
    mut sink: impl FnMut(Motion),
) -> Result<Prepared, PrepareError> {
    let layout = source.layout().clone();
    if layout.dof != dof {
        return Err(LogError::Joints { file: layout.file, found: layout.dof, expected: dof }.into());
    }
    let prepare = &prepare.for_layout(&layout)?;
    let mut preparer = Preparer::new(&layout, dof, prepare)?;
    let mut check = QualityCheck::new(&layout, prepare.torques(), prepare.keep);
    let (mut block, mut verdicts) = (Block::default(), Vec::new());
    let (mut rows, mut samples) = (0, 0);
    let mut hand_on = |motions: Vec<Motion>| {
        for motion in motions {
            samples += motion.picks().len();
            sink(motion);
        }
    };
    loop {
        source.next_block(ROWS, &mut block)?;
        if block.is_empty() {
            break;
        }
        check.admit(&block, &mut verdicts);
        preparer.nominal = check.period();
        for run in runs(&verdicts) {
            if verdicts[run.start] == Verdict::Start {
                hand_on(preparer.end_segment().map_err(|e| explained(e, &check, &layout.file))?);
            }
            rows += run.len();
            preparer.push(&block, run);
        }
        hand_on(preparer.advance().map_err(|e| explained(e, &check, &layout.file))?);
    }
    hand_on(preparer.end_segment().map_err(|e| explained(e, &check, &layout.file))?);
    let reached = prepare.in_torque(check.reached());
    let mut findings = check.finish();
    findings.append(&mut preparer.findings);
    if prepare.torque == Quantity::Current {
        let kind = Kind::FromCurrents { gains: prepare.torque_gains.clone() };
        findings.push(Finding { kind, severity: Severity::Note, line: None, column: None, count: 1 });
    }
    if findings.iter().any(Finding::is_fatal) {
        return Err(LogError::Rejected { file: layout.file, findings }.into());
    }
    if samples == 0 {
        return Err(PrepareError::NothingLeft { file: layout.file, samples: rows, trim: prepare.trim });
    }
    Ok(Prepared {
        findings,
        rows,
        samples,
        segments: preparer.segment,
        rate: preparer.nominal.map_or(0.0, f64::recip),
        reached,
        both_torques: layout.has(Quantity::Tau) && layout.has(Quantity::Taum),
        file: layout.file,
    })
}

/// Replaces an error by the quality check's findings on the clock, if there are any. Times that
/// decrease or repeat give a rate that fits no filter.
fn explained(error: PrepareError, check: &QualityCheck, file: &str) -> PrepareError {
    let clock = |f: &Finding| f.is_fatal() && f.column.as_deref() == Some("t");
    let findings: Vec<Finding> = check.clone().finish().into_iter().filter(clock).collect();
    if findings.is_empty() { error } else { LogError::Rejected { file: file.into(), findings }.into() }
}

/// Runs of used rows, each up to the next row that is left out or starts a segment.
fn runs(verdicts: &[Verdict]) -> impl Iterator<Item = std::ops::Range<usize>> {
    let mut from = 0;
    std::iter::from_fn(move || {
        from += verdicts[from..].iter().take_while(|v| **v == Verdict::Drop).count();
        let follow = verdicts.get(from + 1..)?.iter().take_while(|v| **v == Verdict::Continue);
        let run = from..from + 1 + follow.count();
        from = run.end;
        Some(run)
    })
}

/// State between the rows of a log and its motions.
pub struct Preparer {
    settings: Prepare,
    file: String,
    dof: usize,
    /// Index of `t` among a block's columns.
    time: usize,
    /// Indices of the channels among a block's columns: `q`, `tau`, then `dq`, `ddq`, `temp` and
    /// the others if they are used.
    sources: Vec<usize>,
    /// Index of the first temperature among the channels.
    temperature: Option<usize>,
    /// Index of the first motor position among the channels.
    motor: Option<usize>,
    /// Index of the first joint torque among the channels, if the torques of the gears are wanted.
    load: Option<usize>,
    /// Index of the external wrench among the channels.
    wrench: Option<usize>,
    /// Whether accelerations are among the channels.
    recorded_ddq: bool,
    /// Usual step of the log, s.
    nominal: Option<f64>,
    segment: usize,
    findings: Vec<Finding>,
    /// Rows that are not resampled yet.
    raw_time: Vec<f64>,
    raw: Vec<Vec<f64>>,
    clock: Option<SegmentClock>,
    /// Noise statistics of rows whose times were estimated.
    rows_noise: Option<RowsNoise>,
    /// Evenly sampled values that are still needed, and the number of the first of them in the
    /// segment.
    evened: Vec<Vec<f64>>,
    first: usize,
    /// Samples of the segment that were passed on.
    done: usize,
    /// Low-pass at the segment's rate.
    filter: Option<Sos>,
    /// Low-pass of [`Prepare::bursts`].
    wide: Option<(Filter, Sos)>,
    /// Filter of each joint's positions; empty until the segment is long enough to choose it.
    narrow: Vec<Narrow>,
    /// Filter of torques and signs.
    torque_filter: Option<(Filter, Sos)>,
}

/// Low-pass of one joint's positions.
struct Narrow {
    filter: Filter,
    sos: Sos,
    /// Standard deviations of the errors behind it; `None` if the segment is too short.
    error: Option<[f64; 3]>,
    /// Standard deviation of the positions' white noise, rad.
    noise: f64,
}

/// Noise of the rows of a segment whose times were estimated.
#[derive(Debug, Clone)]
struct RowsNoise {
    /// Standard deviations of the positions, rad.
    position: Vec<f64>,
    /// Standard deviations of the torques, in the column's unit.
    torque: Vec<f64>,
    /// Ratio of the white noise of resampled rows to that of the rows.
    gain: f64,
    /// Standard deviation of the estimated times, s.
    time: f64,
}

#[derive(Debug, Clone, Copy)]
struct SegmentClock {
    start: f64,
    period: f64,
    resample: bool,
    /// Whether rows were sampled at other times than their stamps.
    errs: bool,
    /// Number of samples produced.
    produced: usize,
    last: f64,
}

/// Rows from which the clock of a segment is judged.
const JUDGE: usize = 1024;
/// Rows whose times are estimated at once, and those at each end that have neighbours on one side
/// only.
const TIMED: usize = 16_384;
const TIMED_EDGE: usize = 512;

impl Preparer {
    /// Creates the preparer for logs with this layout.
    pub fn new(layout: &Layout, dof: usize, prepare: &Prepare) -> Result<Self, LogError> {
        if layout.dof != dof {
            return Err(LogError::Joints { file: layout.file.clone(), found: layout.dof, expected: dof });
        }
        let mut sources = layout.require_all(Quantity::Q, dof)?;
        sources.extend(layout.require_all(prepare.torque, dof)?);
        if prepare.derivatives == Derivatives::Recorded {
            sources.extend(layout.require_all(Quantity::Dq, dof)?);
            if layout.has(Quantity::Ddq) {
                sources.extend(layout.require_all(Quantity::Ddq, dof)?);
            }
        }
        let recorded_ddq = prepare.derivatives == Derivatives::Recorded && layout.has(Quantity::Ddq);
        let mut further = |wanted: bool, quantity: Quantity| -> Result<Option<usize>, LogError> {
            let columns = if wanted { layout.require_all(quantity, dof)? } else { Vec::new() };
            sources.extend(columns);
            Ok(wanted.then(|| sources.len() - dof))
        };
        let temperature = further(prepare.temperature && layout.has(Quantity::Temperature), Quantity::Temperature)?;
        let motor = further(prepare.motor_positions && layout.has(Quantity::Qm), Quantity::Qm)?;
        let load = further(prepare.transmission, Quantity::Tau)?;
        let mut wrench = None;
        let components: Option<Vec<usize>> = (0..6).map(|i| layout.find(Role::Wrench(i))).collect();
        if let Some(components) = components.filter(|_| prepare.wrench) {
            wrench = Some(sources.len());
            sources.extend(components);
        }
        Ok(Self {
            settings: prepare.clone(),
            file: layout.file.clone(),
            dof,
            temperature,
            motor,
            load,
            wrench,
            recorded_ddq,
            time: layout.require(Role::Time)?,
            raw: vec![Vec::new(); sources.len()],
            evened: vec![Vec::new(); sources.len()],
            sources,
            nominal: None,
            segment: 0,
            findings: Vec::new(),
            raw_time: Vec::new(),
            clock: None,
            rows_noise: None,
            first: 0,
            done: 0,
            filter: None,
            wide: None,
            narrow: Vec::new(),
            torque_filter: None,
        })
    }

    fn push(&mut self, block: &Block, rows: std::ops::Range<usize>) {
        self.raw_time.extend_from_slice(&block.columns[self.time][rows.clone()]);
        for (to, &column) in self.raw.iter_mut().zip(&self.sources) {
            to.extend_from_slice(&block.columns[column][rows.clone()]);
        }
        let Some(load) = self.load else { return };
        for joint in 0..self.dof {
            let gain = self.settings.torque_gains.get(joint).copied().unwrap_or(1.0);
            let (motors, joints) = self.raw.split_at_mut(load);
            let from = joints[joint].len() - rows.len();
            let own = motors[self.dof + joint][from..].iter_mut().zip(&joints[joint][from..]);
            own.for_each(|(motor, joint)| *motor -= joint / gain);
        }
    }

    /// Motions available from the rows so far.
    fn advance(&mut self) -> Result<Vec<Motion>, PrepareError> {
        if self.raw_time.len() < JUDGE {
            return Ok(Vec::new());
        }
        self.even_out(false)?;
        self.motions(false)
    }

    /// Motions of the rest of the segment; the next row starts another segment.
    fn end_segment(&mut self) -> Result<Vec<Motion>, PrepareError> {
        let mut motions = Vec::new();
        if !self.raw_time.is_empty() || self.clock.is_some() {
            self.even_out(true)?;
            motions = self.motions(true)?;
            self.segment += 1;
        }
        self.raw_time.clear();
        self.raw.iter_mut().for_each(Vec::clear);
        self.evened.iter_mut().for_each(Vec::clear);
        (self.clock, self.first, self.done) = (None, 0, 0);
        (self.rows_noise, self.torque_filter) = (None, None);
        self.narrow.clear();
        Ok(motions)
    }

    /// Decides from the segment's first rows how its clock is made even.
    fn judge_clock(&mut self) -> Result<SegmentClock, PrepareError> {
        let t = &self.raw_time;
        let nominal = self.nominal.unwrap_or(1.0);
        let usual: Vec<f64> = t.windows(2).map(|w| w[1] - w[0]).filter(|d| *d < 1.5 * nominal).collect();
        let far = t.windows(2).filter(|w| (w[1] - w[0] - nominal).abs() > 0.5 * nominal).count();
        let mean = if usual.is_empty() { nominal } else { usual.iter().sum::<f64>() / usual.len() as f64 };
        let rms = (usual.iter().map(|d| (d - mean) * (d - mean)).sum::<f64>() / usual.len().max(1) as f64).sqrt();
        let mut resample = 20 * far > t.len().max(20);
        if !resample && rms > 0.01 * mean {
            let channels: Vec<&[f64]> = self.raw[..self.dof].iter().map(Vec::as_slice).collect();
            resample = !smoother_evenly(t, &channels, mean);
        }
        let period = if resample { nominal } else { mean };
        let errs = self.found_times(resample, period).is_some();
        if !errs && (resample || rms > 0.01 * mean) {
            self.note_clock(if resample { Clock::Resampled } else { Clock::Even });
        }
        if period.is_nan() || period.recip() > FASTEST {
            return Err(PrepareError::Rate { file: self.file.clone(), period });
        }
        // A single row has no rate; too few rows are reported elsewhere.
        if let Some(filter) = self.settings.filter.filter(|_| self.raw_time.len() > 1) {
            let rate = period.recip();
            let sos = low_pass(filter.order, filter.cutoff, rate)
                .map_err(|source| PrepareError::Cutoff { file: self.file.clone(), source })?;
            let most = ((rate / (2.5 * filter.cutoff)) as usize).max(1);
            if self.settings.stride > most {
                let (file, stride) = (self.file.clone(), self.settings.stride);
                return Err(PrepareError::Stride { file, stride, rate, cutoff: filter.cutoff, most });
            }
            self.filter = Some(sos);
            self.wide = self
                .settings
                .bursts
                .filter(|cutoff| *cutoff > filter.cutoff)
                .and_then(|cutoff| Some((Filter { cutoff, ..filter }, low_pass(filter.order, cutoff, rate).ok()?)));
        }
        let start = self.raw_time[0];
        Ok(SegmentClock { start, period, resample, errs, produced: 0, last: start })
    }

    fn note_clock(&mut self, clock: Clock) {
        let alike = |a: &Clock| std::mem::discriminant(a) == std::mem::discriminant(&clock);
        let same = |f: &&mut Finding| matches!(&f.kind, Kind::Evened { clock } if alike(clock));
        match self.findings.iter_mut().find(same) {
            Some(known) => {
                if let (Kind::Evened { clock: Clock::Found { rms } }, Clock::Found { rms: now }) =
                    (&mut known.kind, clock)
                {
                    *rms = rms.max(now);
                }
                known.count += 1;
            }
            None => {
                let (kind, column) = (Kind::Evened { clock }, Some("t".to_string()));
                self.findings.push(Finding { kind, severity: Severity::Note, line: None, column, count: 1 });
            }
        }
    }

    /// Times of the rows that are not resampled yet, estimated from the positions of all joints;
    /// `None` if the clock needs no correction.
    fn found_times(&self, resample: bool, period: f64) -> Option<clock::Times> {
        if self.settings.derivatives != Derivatives::FromPosition {
            return None;
        }
        let q: Vec<&[f64]> = self.raw[..self.dof].iter().map(Vec::as_slice).collect();
        clock::times(&self.stamps(resample, period), &q, period)
    }

    /// Times of the rows that are not resampled yet, from their stamps or their count.
    fn stamps(&self, resample: bool, period: f64) -> Vec<f64> {
        if resample || self.raw_time.windows(2).any(|w| w[1] - w[0] > 1.5 * period) {
            return self.raw_time.clone();
        }
        let counted = |k: usize| k as f64 * period;
        let late: f64 = self.raw_time.iter().enumerate().map(|(k, t)| t - counted(k)).sum();
        let start = late / self.raw_time.len().max(1) as f64;
        (0..self.raw_time.len()).map(|k| start + counted(k)).collect()
    }

    /// Resamples rows whose stamps err, each at its estimated time.
    fn even_found(&mut self, clock: &mut SegmentClock, end: bool) {
        let n = self.raw_time.len();
        if !end && n < TIMED {
            return;
        }
        let found = self.found_times(clock.resample, clock.period);
        let noise = |j: usize| {
            let (q, torque) = (&self.raw[j], &self.raw[self.dof + j]);
            let mut way: Vec<f64> = q.windows(2).map(|q| q[1] - q[0]).collect();
            way.extend(way.last().copied());
            noise_between_reversals([(&torque[..], &way[..])].into_iter(), clock.period.recip())
        };
        let torque = (0..self.dof).map(noise).collect();
        let known = self.rows_noise.take();
        let (times, position, time) = match found {
            Some(found) => {
                self.note_clock(Clock::Found { rms: found.rms });
                (found.at, found.noise, found.left)
            }
            None => {
                let (position, time) = known.map_or((vec![0.0; self.dof], 0.0), |n| (n.position, n.time));
                (self.stamps(clock.resample, clock.period), position, time)
            }
        };
        if clock.produced == 0 {
            clock.start = times[0];
        }
        let before = ((times[0] - clock.start) / clock.period).floor().max(0.0) as usize;
        let count = ((times[n - 1] - clock.start) / clock.period).ceil() as usize + 2 - before;
        let evener = Resampler::new(&times, clock.start + before as f64 * clock.period, clock.period, count.max(4));
        self.rows_noise = Some(RowsNoise { position, torque, gain: evener.noise_gain(), time });
        let known = if end { n - 1 } else { n - TIMED_EDGE };
        let last = ((times[known] - clock.start) / clock.period) as usize;
        for (to, from) in self.evened.iter_mut().zip(&self.raw) {
            let grid = evener.even(from);
            to.extend_from_slice(&grid[(clock.produced - before).min(grid.len())..(last + 1 - before).min(grid.len())]);
        }
        clock.produced = clock.produced.max(last + 1);
        // Rows that are needed as neighbours of the next ones keep their stamps.
        let keep_from = if end { n } else { n - 2 * TIMED_EDGE };
        self.raw_time.drain(..keep_from);
        self.raw.iter_mut().for_each(|x| drop(x.drain(..keep_from)));
    }

    fn even_out(&mut self, end: bool) -> Result<(), PrepareError> {
        if self.raw_time.is_empty() {
            return Ok(());
        }
        let mut clock = match self.clock {
            Some(clock) => clock,
            None => self.judge_clock()?,
        };
        if clock.errs {
            self.even_found(&mut clock, end);
        } else if clock.resample {
            let n = self.raw_time.len();
            let limit = if end { n } else { n.saturating_sub(2) };
            let mut used = 0;
            loop {
                let at = clock.start + clock.produced as f64 * clock.period;
                // A sample a few ulps past the last stamp still belongs to it.
                if limit == 0 || at > self.raw_time[limit - 1] + 1e-9 * clock.period {
                    break;
                }
                while used + 1 < n && self.raw_time[used + 1] < at {
                    used += 1;
                }
                let window = used.saturating_sub(2)..(used + 4).min(n);
                for (to, from) in self.evened.iter_mut().zip(&self.raw) {
                    to.push(resample(&self.raw_time[window.clone()], &from[window.clone()], at));
                }
                clock.produced += 1;
            }
            let keep_from = used.saturating_sub(3);
            self.raw_time.drain(..keep_from);
            self.raw.iter_mut().for_each(|x| drop(x.drain(..keep_from)));
        } else {
            let mut taken = 0;
            for row in 0..self.raw_time.len() {
                let step = self.raw_time[row] - clock.last;
                // Interpolates a sample that the recorder missed linearly between its neighbours.
                if clock.produced > 0 && step > 1.5 * clock.period {
                    for (to, from) in self.evened.iter_mut().zip(&self.raw) {
                        to.extend_from_slice(&from[taken..row]);
                        let before = to.last().copied().unwrap_or(from[row]);
                        to.push(0.5 * (before + from[row]));
                    }
                    taken = row;
                    clock.produced += 1;
                }
                clock.produced += 1;
                clock.last = self.raw_time[row];
            }
            for (to, from) in self.evened.iter_mut().zip(&self.raw) {
                to.extend_from_slice(&from[taken..]);
            }
            self.raw_time.clear();
            self.raw.iter_mut().for_each(Vec::clear);
        }
        self.clock = Some(clock);
        Ok(())
    }

    fn motions(&mut self, end: bool) -> Result<Vec<Motion>, PrepareError> {
        let Some(clock) = self.clock else { return Ok(Vec::new()) };
        let late = samples(self.settings.torque_delay.abs(), clock.period);
        let produced = self.first + self.evened[0].len();
        if self.narrow.is_empty() {
            if !end && produced < self.settings.chunk {
                return Ok(Vec::new());
            }
            self.choose_bands(clock.period);
        }
        let settling = self.narrow.iter().map(|n| n.sos.settling() + 4).max();
        let settle = settling.unwrap_or(4) + late;
        let margin = if self.settings.margins { settle } else { 0 };
        let trim = self.trim(clock.period);
        let stride = self.settings.every(clock.period);
        let chunk = self.settings.chunk.max(stride).next_multiple_of(stride);
        let mut motions = Vec::new();
        if self.done == 0 {
            self.done = trim;
        }
        loop {
            let whole = self.done + chunk + settle + margin;
            let core_end = if produced >= whole {
                self.done + chunk
            } else if end {
                produced.saturating_sub(trim)
            } else {
                break;
            };
            if core_end <= self.done {
                if motions.is_empty() && self.done == trim {
                    self.note_short(produced);
                }
                break;
            }
            motions.push(self.motion(clock, self.done..core_end, margin));
            self.done = core_end;
            // Removes rows that the next chunk no longer needs.
            let obsolete = self.done.saturating_sub(settle + margin).saturating_sub(self.first);
            self.evened.iter_mut().for_each(|x| drop(x.drain(..obsolete.min(x.len()))));
            self.first += obsolete;
        }
        Ok(motions)
    }

    /// Number of samples removed at both ends of a segment.
    fn trim(&self, period: f64) -> usize {
        if self.settings.derivatives == Derivatives::AtRest {
            return 0;
        }
        let differences = 3;
        // The end effects of a low-pass reach farther if its cutoff is low.
        let lowest = self.narrow.iter().map(|n| n.filter.cutoff).fold(f64::INFINITY, f64::min);
        let own =
            if self.settings.adaptive && self.settings.trim > 0.0 { (SETTLED / lowest).min(MOST_TRIM) } else { 0.0 };
        let filtered = if self.filter.is_some() { self.settings.trim.max(own) } else { 0.0 };
        let seconds = filtered.max(self.settings.torque_delay.abs());
        samples(seconds, period).max(differences)
    }

    /// Selects the low-passes of a segment from its first chunk: one for each joint's positions,
    /// and one for the torques, whose band is not below that of any joint.
    fn choose_bands(&mut self, period: f64) {
        let (Some(filter), Some(plain)) = (self.settings.filter, self.filter.clone()) else { return };
        let from_position = self.settings.derivatives == Derivatives::FromPosition;
        let free = self.settings.adaptive && from_position;
        for joint in 0..self.dof {
            let floor = self.rows_noise.as_ref().map_or(0.0, |noise| noise.position[joint]);
            let found = deserved(&self.evened[joint], period, filter, floor, free).filter(|_| from_position);
            let own = Filter { cutoff: found.map_or(filter.cutoff, |d: Deserved| d.cutoff), ..filter };
            let sos = low_pass(own.order, own.cutoff, period.recip()).unwrap_or_else(|_| plain.clone());
            let (error, noise) = (found.map(|d| d.error), found.map_or(0.0, |d| d.noise));
            self.narrow.push(Narrow { filter: own, sos, error, noise });
        }
        let widest = self.narrow.iter().max_by(|a, b| a.filter.cutoff.total_cmp(&b.filter.cutoff));
        self.torque_filter = widest.map(|n| (n.filter, n.sos.clone()));
    }

    /// Filters of the positions; the wider ones have no weight yet.
    fn band(&self) -> Band {
        if self.settings.derivatives != Derivatives::FromPosition {
            return Band::default();
        }
        let wide: Option<Vec<Filter>> = self.narrow.iter().map(|own| Some(self.wider(own)?.0)).collect();
        Band {
            narrow: self.narrow.iter().map(|n| n.filter).collect(),
            wide: wide.unwrap_or_default(),
            share: Vec::new(),
        }
    }

    /// Wider low-pass of a joint, blended in for short and fast motion: that of bursts, or the
    /// highest of motion if the joint's own is lower.
    fn wider(&self, own: &Narrow) -> Option<(Filter, &Sos)> {
        let (bursts, highest) = (self.wide.as_ref()?, self.settings.filter?);
        match own.filter == highest {
            true => Some((bursts.0, &bursts.1)),
            false => Some((highest, self.filter.as_ref()?)),
        }
    }

    fn note_short(&mut self, rows: usize) {
        match self.findings.iter_mut().find(|f| matches!(f.kind, Kind::ShortSegments { .. })) {
            Some(Finding { kind: Kind::ShortSegments { samples }, count, .. }) => {
                *samples += rows;
                *count += 1;
            }
            _ => {
                let kind = Kind::ShortSegments { samples: rows };
                self.findings.push(Finding { kind, severity: Severity::Warning, line: None, column: None, count: 1 });
            }
        }
    }

    /// Highest frequency that the low-pass leaves in the torque, Hz.
    fn bandwidth(&self) -> Option<f64> {
        self.torque_filter.as_ref().filter(|_| !self.settings.raw_torque).map(|(filter, _)| filter.cutoff)
    }

    /// Filters the available samples and cuts out the core (sample numbers of the segment) with its
    /// margin.
    fn motion(&self, clock: SegmentClock, core: std::ops::Range<usize>, margin: usize) -> Motion {
        let (n, dof, rate) = (self.evened[0].len(), self.dof, clock.period.recip());
        let mut positions = self.positions(clock.period).into_iter();
        let from = core.start.saturating_sub(margin).max(self.first) - self.first;
        let to = (core.end + margin - self.first).min(n);
        let mut motion = Motion {
            segment: self.segment,
            start: clock.start + (self.first + from) as f64 * clock.period,
            segment_start: clock.start,
            period: clock.period,
            core: core.start - self.first - from..core.end - self.first - from,
            stride: self.settings.every(clock.period),
            states: States { len: to - from, ..States::default() },
            tau: Vec::with_capacity(dof * (to - from)),
            velocity_noise: Vec::with_capacity(dof),
            bandwidth: self.bandwidth(),
            error: self.narrow.iter().filter_map(|n| n.error).collect(),
            clock_error: self.rows_noise.as_ref().map_or(0.0, |noise| noise.time),
            band: self.band(),
            ..Motion::default()
        };
        let (mut speeds, mut reversals) = (Vec::with_capacity(dof), Vec::new());
        for joint in 0..dof {
            let own = self.narrow.get(joint);
            let Some(mut q) = positions.next() else { break };
            let (dq, ddq) = match self.settings.derivatives {
                Derivatives::FromPosition => {
                    let mut narrow = Derived::of(q, clock.period);
                    let share = own.map_or_else(Vec::new, |own| self.rough(joint, own, &mut narrow, clock.period));
                    if !share.is_empty() {
                        motion.band.share.resize(dof * (to - from), 0.0);
                        let own = joint * (to - from)..(joint + 1) * (to - from);
                        motion.band.share[own].copy_from_slice(&share[from..to]);
                    }
                    q = narrow.q;
                    (narrow.dq, narrow.ddq)
                }
                Derivatives::AtRest => (vec![0.0; n], vec![0.0; n]),
                Derivatives::Recorded => {
                    let dq = self.smooth(&self.evened[2 * dof + joint], clock.period);
                    let ddq = match self.evened.get(3 * dof + joint).filter(|_| self.recorded_ddq) {
                        Some(ddq) => self.smooth(ddq, clock.period),
                        None => central(&dq, clock.period),
                    };
                    (dq, ddq)
                }
            };
            motion.velocity_noise.push(match (own.map(|n| n.filter), self.settings.derivatives) {
                (Some(filter), Derivatives::FromPosition) => {
                    let held = self.held(joint, &q, filter, clock.period);
                    motion.stuck.extend_from_slice(&stuck(&held, n)[from..to]);
                    reversals.push(held);
                    velocity_noise(&self.evened[joint], &q, filter, rate)
                }
                _ => 0.0,
            });
            motion.states.q.extend_from_slice(&q[from..to]);
            motion.states.dq.extend_from_slice(&dq[from..to]);
            motion.states.ddq.extend_from_slice(&ddq[from..to]);
            motion.torque_noise.push(self.torque_noise(joint, &dq, rate));
            speeds.push(dq);
        }
        self.rests(&mut motion, &speeds, &reversals, from..to);
        let torques = self.treated(&self.evened[dof..2 * dof], clock.period);
        for (joint, mut tau) in torques.into_iter().enumerate() {
            if let Some(gain) = self.settings.torque_gains.get(joint) {
                tau.iter_mut().for_each(|t| *t *= gain);
            }
            let tau = later(tau, self.settings.torque_delay / clock.period);
            motion.tau.extend_from_slice(&tau[from..to]);
            self.carry(&mut motion, joint, from..to);
        }
        if let Some(first) = self.wrench {
            let wrench = self.treated(&self.evened[first..first + 6], clock.period);
            wrench.iter().for_each(|treated| motion.wrench.extend_from_slice(&treated[from..to]));
        }
        motion
    }

    /// Appends a joint's recorded channels that motions contain.
    fn carry(&self, motion: &mut Motion, joint: usize, range: std::ops::Range<usize>) {
        let channels = [
            (self.temperature, &mut motion.temperature),
            (self.motor, &mut motion.motor),
            (self.load, &mut motion.load),
        ];
        for (first, out) in channels {
            out.extend(first.iter().flat_map(|first| &self.evened[first + joint][range.clone()]));
        }
    }

    /// Passes rough motion of a joint where it exceeds the noise, and returns the weight of the
    /// wider low-pass at each sample; empty if there is none.
    fn rough(&self, joint: usize, own: &Narrow, narrow: &mut Derived, period: f64) -> Vec<f64> {
        let Some((filter, sos)) = self.wider(own) else { return Vec::new() };
        let behind =
            |x: &[f64], filter: Filter, sos: &Sos| Derived::of(through(x, Some((filter, sos)), period), period);
        let positions = &self.evened[joint];
        let highest = self.settings.filter.unwrap_or(own.filter);
        let steps = steps(positions, own.noise, highest, period);
        let steps = steps.map(|e| [behind(&e, own.filter, &own.sos), behind(&e, filter, sos)]);
        narrow.let_through(&behind(positions, filter, sos), [own.filter.cutoff, filter.cutoff], steps, period)
    }

    /// Samples at which a joint sticks at a reversal; empty if the detection of rest is switched
    /// off.
    fn held(&self, joint: usize, q: &[f64], filter: Filter, period: f64) -> Vec<Stiction> {
        match self.settings.dead_zone {
            DeadZone::Off => Vec::new(),
            _ => sticks(&self.evened[joint], q, filter.cutoff, period),
        }
    }

    /// Appends rest and velocity signs of joints and velocity sums for the samples `span`.
    /// `reversals`: where each joint sticks at a reversal.
    fn rests(
        &self,
        motion: &mut Motion,
        speeds: &[Vec<f64>],
        reversals: &[Vec<Stiction>],
        span: std::ops::Range<usize>,
    ) {
        if self.settings.derivatives == Derivatives::AtRest {
            return;
        }
        motion.dead_zone = self.settings.dead_zone;
        let noise: Vec<rest::Noise> =
            (0..self.dof).map(|j| self.noise(j, motion.velocity_noise[j], motion.period)).collect();
        if self.settings.derivatives == Derivatives::FromPosition {
            motion.position_noise = noise.iter().map(|n| n.position).collect();
        }
        let sums = self.settings.sums.iter().map(|sum| {
            let of = |part: fn(&rest::Noise) -> f64| {
                let of = sum.joints.map(|j| noise.get(j).map_or(0.0, part));
                of[0].hypot(sum.ratio * of[1])
            };
            let noise = rest::Noise { speed: of(|n| n.speed), white: of(|n| n.white), position: of(|n| n.position) };
            (sum.at(|j| speeds.get(j).map(Vec::as_slice)), noise)
        });
        let sums: Vec<(Vec<f64>, rest::Noise)> = sums.collect();
        let own = speeds.iter().zip(&noise);
        let all = own.chain(sums.iter().map(|(dq, noise)| (dq, noise)));
        let mut every = Vec::with_capacity(self.dof + sums.len());
        for (row, (dq, noise)) in all.enumerate() {
            let resting = rest::rests(dq, *noise, motion.period, self.settings.dead_zone);
            let sign = |(v, rests): (&f64, &bool)| if *rests || *v == 0.0 { 0.0 } else { v.signum() };
            let mut signs: Vec<f64> = dq.iter().zip(&resting).map(sign).collect();
            if !self.settings.raw_torque {
                // The low-pass spreads the friction of a held joint to neighbouring rows.
                reversals.get(row).into_iter().flatten().for_each(|stick| stick.put_friction(&mut signs));
            }
            every.push(signs);
            motion.resting.extend_from_slice(&resting[span.clone()]);
        }
        for signs in self.treated(&every, motion.period) {
            motion.sign.extend_from_slice(&signs[span.clone()]);
        }
    }

    /// Positions, each joint's filtered by its own low-pass.
    fn positions(&self, period: f64) -> Vec<Vec<f64>> {
        let own = |j: usize| (&self.evened[j][..], self.narrow.get(j).map(|n| (n.filter, &n.sos)));
        through_each(&(0..self.dof).map(own).collect::<Vec<_>>(), period)
    }

    /// Torques and signs, low-passed unless raw torques are requested.
    fn treated(&self, series: &[Vec<f64>], period: f64) -> Vec<Vec<f64>> {
        let filter = self.torque_filter.as_ref().filter(|_| !self.settings.raw_torque);
        let filter = filter.map(|(filter, sos)| (*filter, sos));
        through_each(&series.iter().map(|x| (&x[..], filter)).collect::<Vec<_>>(), period)
    }

    /// One series filtered by the low-pass of the torques.
    fn smooth(&self, x: &[f64], period: f64) -> Vec<f64> {
        through(x, self.torque_filter.as_ref().map(|(filter, sos)| (*filter, sos)), period)
    }

    /// Standard deviation of the sensor's noise in a joint's treated torque, N m; `dq`: joint
    /// speed, rad/s.
    fn torque_noise(&self, joint: usize, dq: &[f64], rate: f64) -> f64 {
        let low_pass = self.torque_filter.as_ref().filter(|_| !self.settings.raw_torque);
        let passed = low_pass.map_or(1.0, |(filter, _)| filter.noise_gain(rate));
        let gain = self.settings.torque_gains.get(joint).map_or(1.0, |gain| gain.abs());
        match &self.rows_noise {
            // Resampling and a low-pass both remove high frequencies, so their gains don't multiply.
            Some(noise) => noise.torque[joint] * gain * passed.min(noise.gain),
            None => {
                noise_between_reversals([(&self.evened[self.dof + joint][..], dq)].into_iter(), rate) * gain * passed
            }
        }
    }

    /// Noise of a joint's filtered velocity. `speed`: velocity error derived from what the low-pass
    /// removed from the positions, rad/s.
    fn noise(&self, joint: usize, speed: f64, period: f64) -> rest::Noise {
        let rate = period.recip();
        if self.settings.derivatives == Derivatives::Recorded {
            let recorded = white_noise([&self.evened[2 * self.dof + joint][..]].into_iter());
            let white = recorded * self.settings.filter.map_or(1.0, |f| f.noise_gain(rate));
            return rest::Noise { speed: white, white, position: 0.0 };
        }
        let floor = self.rows_noise.as_ref().map_or(0.0, |noise| noise.position[joint]);
        let position = white_noise([&self.evened[joint][..]].into_iter()).max(floor);
        match self.narrow.get(joint).map(|n| n.filter) {
            Some(filter) => rest::Noise { speed, white: filter.velocity_noise(position, rate), position },
            // A central difference divides the difference of two errors by two periods.
            None => {
                let white = position * rate * 0.5_f64.sqrt();
                rest::Noise { speed: white, white, position }
            }
        }
    }
}

/// Periods of the cutoff after which the end effects of a low-pass have faded, and the longest time
/// that is removed for them, s.
const SETTLED: f64 = 2.0;
const MOST_TRIM: f64 = 1.0;

/// Filters a series forward and backward, if there is a low-pass.
fn through(x: &[f64], filter: Option<(Filter, &Sos)>, period: f64) -> Vec<f64> {
    through_each(&[(x, filter)], period).pop().unwrap_or_default()
}

/// A series and its low-pass, if there is one.
type Passed<'a> = (&'a [f64], Option<(Filter, &'a Sos)>);

/// Filters several series, each by its low-pass. Either all have one, or none has.
fn through_each(series: &[Passed<'_>], period: f64) -> Vec<Vec<f64>> {
    let filtered = |&(x, filter): &(_, Option<(Filter, _)>)| {
        let (filter, sos): (Filter, &Sos) = filter?;
        let pad = (1.0 / (period * filter.cutoff)).ceil() as usize;
        Some(Filtered { x, sos, pad: pad.max(sos.scipy_padding()) })
    };
    match series.iter().map(filtered).collect::<Option<Vec<_>>>() {
        Some(lanes) => forward_backward_each(&lanes),
        None => series.iter().map(|(x, _)| x.to_vec()).collect(),
    }
}

/// Shifts a signal by `by` samples, so that sample `k` becomes that at `k + by`. Interpolates
/// linearly between samples, which are smooth by now; the end values are held.
fn later(x: Vec<f64>, by: f64) -> Vec<f64> {
    if by == 0.0 || !by.is_finite() {
        return x;
    }
    let last = x.len().saturating_sub(1);
    let whole = by.floor();
    let at = |k: usize| x[(k as f64 + whole).clamp(0.0, last as f64) as usize];
    (0..x.len()).map(|k| at(k) + (by - whole) * (at(k + 1) - at(k))).collect()
}

/// Standard deviation of the velocity error, from what the filter removed from the position.
fn velocity_noise(raw: &[f64], smooth: &[f64], filter: Filter, rate: f64) -> f64 {
    filter.velocity_noise((squared_differences(raw, smooth) / raw.len().max(1) as f64).sqrt(), rate)
}
