//! Estimation of a [`Series`] of wrenches from motions.

use nalgebra::DMatrix;

use super::bias::{Bias, inside, within};
use super::consistency::Checker;
use super::contact::ContactDetector;
use super::method::{MOST_JOINTS, Method, Row, Steps, Tuning, steps};
use super::momentum::white_speed;
use super::sample::Scale;
use super::series::Series;
use super::stiction::breakaway;
use super::torques::Torques;
use super::uncertainty::Uncertainty;
use super::verdict::Verdict;
use crate::control::estimate::residual_torque::{ResidualTorque, pick};
use crate::data::signal::{Filter, Motion};
use crate::identify::regression::rows::Rows;
use crate::model::{Arm, Dynamics, States, ToolState};

/// Settings of the estimation.
#[derive(Debug, Clone, PartialEq)]
pub struct EstimationSettings {
    /// Estimator.
    pub method: Method,
    /// Low-pass of the residual torque; that of the identification, whose noise is used. The
    /// observers do not use it.
    pub filter: Option<Filter>,
    /// Gain of the momentum observer, 1/s. Default 2 pi 10 Hz.
    pub gain: f64,
    /// Prior size of wrenches.
    pub scale: Scale,
    /// Largest random-walk rate of the wrench, for the Kalman filter. Default 20 N and 2 N m in a
    /// second.
    pub wander: Scale,
    /// Stretches without contact, start and end, s.
    pub free: Vec<[f64; 2]>,
    /// Whether there is no contact at any time.
    pub nothing_touches: bool,
    /// Bias to subtract.
    pub bias: Option<Bias>,
}

impl Default for EstimationSettings {
    fn default() -> Self {
        Self {
            method: Method::Residual,
            filter: Some(Filter::default()),
            gain: 62.8,
            scale: Scale::default(),
            wander: Scale { force: 20.0, moment: 2.0 },
            free: Vec::new(),
            nothing_touches: false,
            bias: None,
        }
    }
}

/// Model of the arm.
pub struct Known<'a> {
    /// Regressor and inertias.
    pub arm: &'a dyn Arm,
    /// Standard parameters (`P`).
    pub standard: &'a [f64],
    /// Torque model without contact, as the sensors read it.
    pub torques: &'a dyn Torques,
    /// Uncertainty of the model.
    pub uncertainty: &'a Uncertainty,
    /// Torque limit of each joint, N m; infinite or missing where unknown. Where the model has no
    /// dry friction, the limit bounds the static friction.
    pub torque_limits: &'a [f64],
}

impl Known<'_> {
    /// Largest static friction of a joint with this Coulomb level, N m.
    fn breakaway(&self, joint: usize, coulomb: f64) -> f64 {
        let limit = self.torque_limits.get(joint).copied().unwrap_or(f64::INFINITY);
        breakaway(coulomb, self.torques.breakaway(joint), limit)
    }
}

/// An arm with no joints or more than [`MOST_JOINTS`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("an arm with {0} joints: the estimators are made for 1 to {MOST_JOINTS}")]
pub struct TooManyJoints(pub usize);

/// Builds a [`Series`] from motions with raw torques and margins (`Prepare { raw_torque: true,
/// margins: true, .. }`).
pub struct Run<'a> {
    known: Known<'a>,
    tool: &'a mut dyn Dynamics,
    settings: EstimationSettings,
    rows: Rows,
    /// Root of the parameters' covariance, `B x rank`, and its product with the bias' mean
    /// regressor.
    root: DMatrix<f64>,
    mean: DMatrix<f64>,
    /// Squared Coulomb level of each joint.
    coulomb: Vec<f64>,
    /// Largest static friction of each joint, N m.
    breakaway: Vec<f64>,
    estimator: Option<Box<dyn Steps>>,
    detector: ContactDetector,
    /// Stretches of `EstimationSettings::free` without the margins into which the low-pass smears.
    judged: Vec<[f64; 2]>,
    free: Checker,
    anywhere: Checker,
    series: Series,
    state: ToolState,
    measured: bool,
}

impl<'a> Run<'a> {
    /// Creates a run for a log of this name. `tool` computes the tool's frame.
    pub fn new(
        name: &str,
        known: Known<'a>,
        tool: &'a mut dyn Dynamics,
        settings: EstimationSettings,
    ) -> Result<Self, TooManyJoints> {
        let (arm, n) = (known.arm, known.arm.dof());
        if n == 0 || n > MOST_JOINTS {
            return Err(TooManyJoints(n));
        }
        let root = known.uncertainty.root();
        let mean = settings.bias.as_ref().map_or_else(|| DMatrix::zeros(n, root.ncols()), |b| &b.regressor * &root);
        let rows = Rows::new(arm);
        let level = |j: usize| {
            let column = rows.columns[j][rows.coulomb[j]?];
            let coefficients = &arm.base_parameters()[column].coefficients;
            let level: f64 = coefficients.iter().map(|&(i, k)| k * known.standard[i]).sum();
            Some(level * level)
        };
        let coulomb: Vec<f64> = (0..n).map(|j| level(j).unwrap_or(0.0)).collect();
        let breakaway: Vec<f64> = (0..n).map(|j| known.breakaway(j, coulomb[j].sqrt())).collect();
        let no_friction = |j: &usize| coulomb[*j] == 0.0 && breakaway[*j] > 0.0;
        let assumed = (0..n).filter(no_friction).map(|j| (j + 1, breakaway[j])).collect();
        // Spacing well above the filter's memory, which is about one over its cutoff.
        let spacing = settings.filter.map_or(0.1, |f| 2.0 / f.cutoff);
        let series = Series {
            name: name.into(),
            method: settings.method,
            bias: settings.bias.as_ref().map_or_else(Vec::new, |b| b.torque.clone()),
            assumed_friction: assumed,
            ..Series::default()
        };
        Ok(Self {
            known,
            tool,
            rows,
            root,
            mean,
            coulomb,
            breakaway,
            estimator: None,
            detector: ContactDetector::default(),
            judged: within(&settings.free, settings.filter),
            settings,
            free: Checker::new(spacing),
            anywhere: Checker::new(spacing),
            series,
            state: ToolState::default(),
            measured: true,
        })
    }

    /// Number of samples estimated so far.
    pub fn samples(&self) -> usize {
        self.series.time.len()
    }

    /// Estimates a segment of motion.
    pub fn absorb(&mut self, motion: &Motion) {
        let (n, len) = (self.known.arm.dof(), motion.states.len);
        let picked = pick(self.known.arm, &self.rows, self.known.torques, motion, self.settings.filter);
        let count = picked.samples.len();
        if self.series.segment.last() != Some(&motion.segment) {
            self.estimator = None;
            self.detector.reset();
        }
        let observes = self.settings.method.observes();
        let mut estimator = match self.estimator.take() {
            Some(estimator) => estimator,
            None => match self.tuned(motion) {
                Some(estimator) => estimator,
                None => return,
            },
        };
        let mass = if observes { masses(self.known.arm, self.known.standard, &motion.states) } else { Vec::new() };
        let nothing = vec![0.0; n];
        let taken = self.settings.bias.as_ref().map_or(&nothing, |b| &b.torque).clone();
        let mut row = Row { covariance: vec![0.0; n * n], ..Row::default() };
        let mut sample = motion.core.start;
        for s in 0..count {
            let (model, variance) = self.errors(&picked, s);
            let covariance = &model * model.transpose();
            let still = |j: usize| picked.still[j * count + s];
            row.static_friction = (0..n).map(|j| if still(j) { self.coulomb[j].sqrt() } else { 0.0 }).collect();
            row.breakaway =
                (0..n).map(|j| if picked.near_rest[j * count + s] { self.breakaway[j] } else { 0.0 }).collect();
            // The usual noise is already part of the estimator.
            let more =
                |j: usize| variance[j] - self.known.uncertainty.noise[j].powi(2) - row.static_friction[j].powi(2);
            for i in 0..n {
                for j in 0..n {
                    row.covariance[i * n + j] = covariance[(i, j)] + if i == j { more(i).max(0.0) } else { 0.0 };
                }
            }
            let external: Vec<f64> = (0..n).map(|j| picked.external[j * count + s] - taken[j]).collect();
            let estimate = if observes {
                let mut estimate = None;
                while sample <= picked.samples[s] {
                    let at = |values: &[f64], j: usize| values[j * len + sample];
                    let now = |values: &[f64]| -> Vec<f64> { (0..n).map(|j| at(values, j)).collect() };
                    self.place(&now(&motion.states.q));
                    (row.tau, row.dq, row.jacobian) = (now(&picked.tau), now(&motion.states.dq), self.jacobian());
                    row.mass = (0..n * n).map(|k| mass[k * len + sample]).collect();
                    let accelerating = |j: usize| (0..n).map(|k| row.mass[j * n + k] * at(&picked.ddq, k)).sum::<f64>();
                    row.bias = (0..n).map(|j| at(&picked.model, j) - accelerating(j) - taken[j]).collect();
                    row.dt = motion.period;
                    estimate = Some(estimator.step(&row));
                    sample += 1;
                }
                estimate
            } else {
                let q: Vec<f64> = (0..n).map(|j| motion.states.q[j * len + picked.samples[s]]).collect();
                self.place(&q);
                (row.jacobian, row.model, row.tau) = (self.jacobian(), external.clone(), nothing.clone());
                Some(estimator.step(&row))
            };
            let Some(estimate) = estimate else { continue };
            let time = picked.time[s];
            let free = self.settings.nothing_touches || inside(&self.settings.free, time);
            let contact = self.detector.step(&estimate, motion.period * motion.stride.max(1) as f64);
            let series = &mut self.series;
            series.stale += usize::from(!estimate.fresh);
            series.time.push(time);
            series.segment.push(motion.segment);
            series.wrench.push(estimate.wrench);
            series.half.push(std::array::from_fn(|i| estimate.half_width(i)));
            series.observable.push(estimate.observable);
            series.deviate.push(contact.deviate);
            series.touching.push(contact.touching);
            series.undecided.push(contact.undecided);
            series.free.push(free);
            series.dexterity.push(dexterity(&row.jacobian, n));
            if picked.measured.is_empty() {
                self.measured = false;
            } else {
                series.measured.push(std::array::from_fn(|i| picked.measured[i * count + s]));
            }
            let judged = self.settings.nothing_touches || inside(&self.judged, time);
            if judged && self.free.takes(motion.segment, time) {
                self.free.add(&external, &model, &variance, None);
            }
            if n > 6 && self.anywhere.takes(motion.segment, time) {
                let jacobian = &row.jacobian;
                let push = DMatrix::from_fn(n, 6, |j, i| jacobian[i * n + j]);
                self.anywhere.add(&external, &model, &variance, Some(push));
            }
        }
        self.estimator = Some(estimator);
    }

    /// Creates the estimator for motions like this one.
    fn tuned(&self, motion: &Motion) -> Option<Box<dyn Steps>> {
        let EstimationSettings { method, filter, gain, scale, wander, .. } = self.settings;
        let noise = &self.known.uncertainty.noise;
        let left = filter.map_or(1.0, |f| f.noise_gain(motion.period.recip()));
        let density: Vec<f64> = noise.iter().map(|s| (s / left).powi(2) * motion.period).collect();
        let velocity: Vec<f64> = match (method, filter) {
            (Method::Momentum, Some(filter)) => {
                let unit = filter.velocity_noise(1.0, motion.period.recip());
                let white = white_speed(gain, motion.period, &filter.velocity_response(motion.period));
                let position = |j: usize| motion.position_noise.get(j).copied().unwrap_or(f64::INFINITY);
                // The part of the positions that the low-pass removed is also motion, where the arm
                // starts and stops.
                motion.velocity_noise.iter().enumerate().map(|(j, v)| position(j).min(v / unit) * white).collect()
            }
            // At least the rounding of an encoder; otherwise the filter would overrate the accuracy
            // of the velocities.
            _ => motion.velocity_noise.iter().map(|v| v.max(1e-5)).collect(),
        };
        let tuning = Tuning { noise, density: &density, velocity: &velocity, gain, scale, wander };
        steps(self.known.arm.dof(), method, &tuning)
    }

    /// Torque error at a used sample: root of the parameters' part, `n x rank`, and the variances
    /// of the rest.
    fn errors(&self, picked: &ResidualTorque, s: usize) -> (DMatrix<f64>, Vec<f64>) {
        let (n, rank, count) = (self.known.arm.dof(), self.root.ncols(), picked.samples.len());
        let mut model = -self.mean.clone();
        for (k, &(row, column)) in self.known.arm.base_pattern().iter().enumerate() {
            let w = picked.entries[k * count + s];
            if w != 0.0 {
                (0..rank).for_each(|r| model[(row, r)] += w * self.root[(column, r)]);
            }
        }
        // Noise of a mean over this many seconds: about two independent values in each period of
        // the cutoff.
        let independent =
            |b: &Bias| 1.0 + 1.0 / (2.0 * b.seconds * self.settings.filter.map_or(100.0, |f| f.cutoff)).max(1.0);
        let more = self.settings.bias.as_ref().map_or(1.0, independent);
        let variance = |j: usize| {
            let standing = if picked.still[j * count + s] { self.coulomb[j] } else { 0.0 };
            let smear = if self.settings.method.observes() { 0.0 } else { picked.smear[j * count + s] };
            self.known.uncertainty.noise[j].powi(2) * more + standing + smear * smear
        };
        (model, (0..n).map(variance).collect())
    }

    fn place(&mut self, q: &[f64]) {
        self.tool.tool(q, &mut self.state);
    }

    /// Jacobian in the tool's axes, `6 x n`, row-major.
    fn jacobian(&self) -> Vec<f64> {
        let (n, ToolState { pose, jacobian }) = (self.known.arm.dof(), &self.state);
        let turned = |part: usize, axis: usize, j: usize| -> f64 {
            (0..3).map(|k| pose[4 * k + axis] * jacobian[(3 * part + k) * n + j]).sum()
        };
        (0..6).flat_map(|i| (0..n).map(move |j| (i, j))).map(|(i, j)| turned(i / 3, i % 3, j)).collect()
    }

    /// Returns the series with its consistency checks and verdict.
    pub fn finish(mut self) -> Series {
        if !self.measured {
            self.series.measured.clear();
        }
        self.series.in_free = self.free.finish();
        self.series.unexplained = self.anywhere.finish();
        let (free, spare) = (self.series.in_free.as_ref(), self.series.unexplained.as_ref());
        self.series.verdict = Verdict::of(free, spare, self.known.uncertainty.source);
        self.series
    }
}

/// Smallest singular value of a Jacobian (`6 x n`), angular rows scaled by half a metre.
fn dexterity(jacobian: &[f64], n: usize) -> f64 {
    let scaled = DMatrix::from_fn(6, n, |i, j| jacobian[i * n + j] * if i < 3 { 1.0 } else { 0.5 });
    (&scaled * scaled.transpose()).symmetric_eigenvalues().min().max(0.0).sqrt()
}

/// Mass matrices, rotors included: entry `(j, k)` at sample `s` at `(j * n + k) * len + s`. Columns
/// are the torques of unit accelerations.
fn masses(arm: &dyn Arm, standard: &[f64], states: &States) -> Vec<f64> {
    let (n, len) = (arm.dof(), states.len);
    let zero = vec![0.0; n * len];
    let mut still = States { len, q: states.q.clone(), dq: zero.clone(), ddq: zero.clone() };
    let (mut weight, mut torque) = (zero.clone(), zero);
    arm.inverse_dynamics(&still, standard, &mut weight);
    let mut mass = vec![0.0; n * n * len];
    for k in 0..n {
        still.ddq.fill(0.0);
        still.ddq[k * len..(k + 1) * len].fill(1.0);
        arm.inverse_dynamics(&still, standard, &mut torque);
        for j in 0..n {
            for s in 0..len {
                mass[(j * n + k) * len + s] = torque[j * len + s] - weight[j * len + s];
            }
        }
    }
    mass
}
