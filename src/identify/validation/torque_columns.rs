//! Detects torque columns of a log in another order, with other signs or in another unit, and
//! position columns in another order.
//!
//! Ordinary factors combine each joint's regressor with its own torque alone. Here it is combined
//! with all torques, `[W_j tau_1 .. tau_n]`, so that every pairing of equations and columns can be
//! tried without reading the log again.

use crate::data::log::{Explanation, Finding, Kind, Severity};
use crate::data::signal::{Motion, MotionBlock};
use crate::identify::regression::r_factor::RFactor;
use crate::identify::regression::rows::Rows;
use crate::identify::regression::wls::{JointSystem, stacked};
use crate::model::{Arm, States};

mod positions;

/// Number of samples evaluated at once.
const BLOCK: usize = 256;
/// An explanation must leave less than this share of the residual of the log as recorded (root mean
/// square), and of the best reading that changes signs only.
const FAR_BETTER: f64 = 0.5;
/// An explanation must also leave less than this share of the torques.
const EXPLAINED: f64 = 0.35;
/// Ratio of residuals below which a fit can't distinguish two orders: light wrists have little more
/// than friction.
const ALIKE_LEFT: f64 = 1.3;
/// Least correlation with the given model at which sizes can be compared.
const ALIKE: f64 = 0.8;
/// Ratio of sizes that is within the error of a rough model.
const ROUGH: f64 = 2.5;
/// The same if fewer than half of the joints, but at least two, agree with the model: a payload may
/// make their torques several times as large.
const ROUGH_OF_FEW: f64 = 10.0;
/// Least travel of a joint at which its torque identifies its column, rad or m.
const TRAVEL: f64 = 0.1;
/// Factor within which the sizes of the joints' torques must agree on a unit.
const AGREE: f64 = 2.0;
/// Most joints for which all pairings are searched.
const MOST_JOINTS: usize = 14;

/// Reference with which the torques are compared.
#[derive(Debug, Clone, Copy)]
pub enum Reference<'a> {
    /// Best parameters for this log.
    Fit,
    /// Given base parameters.
    Model(&'a [f64]),
}

/// Second moments of a log's torque columns together with every joint's regressor.
pub struct TorqueColumns<'a> {
    arm: &'a dyn Arm,
    rows: Rows,
    /// Factor of `[W_j tau_1 .. tau_n]` for each joint.
    factors: Vec<RFactor>,
    /// The same factors with positions taken as degrees.
    degrees: Vec<RFactor>,
    /// Smallest and largest position of each joint, rad or m.
    range: Vec<[f64; 2]>,
    samples: usize,
    seconds: f64,
    kept: positions::Kept,
}

/// Column from which each joint's torque is read, and its sign.
#[derive(Debug, Clone, PartialEq)]
struct Reading {
    column: Vec<usize>,
    negated: Vec<bool>,
}

impl Reading {
    fn as_recorded(joints: usize) -> Self {
        Self { column: (0..joints).collect(), negated: vec![false; joints] }
    }

    fn is_permuted(&self) -> bool {
        self.column.iter().enumerate().any(|(joint, column)| joint != *column)
    }

    /// Readings that differ by one step: two columns exchanged, or one negated.
    fn neighbours(&self) -> impl Iterator<Item = Self> + '_ {
        let n = self.column.len();
        let exchanged = (0..n).flat_map(move |a| (0..a).map(move |b| (a, b))).map(|(a, b)| {
            let mut next = self.clone();
            next.column.swap(a, b);
            next.negated.swap(a, b);
            next
        });
        let negated = (0..n).map(|a| {
            let mut next = self.clone();
            next.negated[a] = !next.negated[a];
            next
        });
        exchanged.chain(negated)
    }
}

impl<'a> TorqueColumns<'a> {
    /// Creates empty moments for a log of this arm.
    pub fn new(arm: &'a dyn Arm) -> Self {
        let rows = Rows::new(arm);
        let empty = || rows.columns.iter().map(|c| RFactor::new(c.len() + arm.dof())).collect();
        let range = vec![[f64::INFINITY, f64::NEG_INFINITY]; arm.dof()];
        let kept = positions::Kept::default();
        Self { arm, factors: empty(), degrees: empty(), range, samples: 0, seconds: 0.0, kept, rows }
    }

    /// Adds a stretch of motion.
    pub fn absorb(&mut self, motion: &Motion) {
        let (mut block, mut from) = (MotionBlock::default(), 0);
        loop {
            let count = motion.gather(from, BLOCK, &mut block);
            if count == 0 {
                break;
            }
            from += count;
            absorb(&mut self.factors, self.arm, &self.rows, &block, &block.states);
            let turn = |x: &[f64]| x.iter().map(|x| x.to_radians()).collect();
            let States { len, q, dq, ddq } = &block.states;
            for (range, q) in self.range.iter_mut().zip(q.chunks_exact(*len)) {
                *range = q.iter().fold(*range, |[low, high], q| [low.min(*q), high.max(*q)]);
            }
            let radians = States { len: *len, q: turn(q), dq: turn(dq), ddq: turn(ddq) };
            absorb(&mut self.degrees, self.arm, &self.rows, &block, &radians);
            self.kept.absorb(&block);
            self.samples += count;
            self.seconds += count as f64 * motion.period * motion.stride.max(1) as f64;
        }
    }

    /// Whether the reference leaves a large part of the recorded torques unexplained; otherwise no
    /// explanation is needed.
    pub fn is_suspicious(&self, reference: Reference<'_>) -> bool {
        self.samples > 0
            && self.unexplained(&self.factors, self.samples, &Reading::as_recorded(self.arm.dof()), reference)
                > EXPLAINED
    }

    /// Whether half of the joints travel: an arm at rest gives only a few distinct torques, which
    /// another order can match by chance.
    fn travels(&self) -> bool {
        2 * self.range.iter().filter(|[low, high]| high - low > TRAVEL).count() >= self.range.len()
    }

    /// Whether the log suffices to distinguish readings of the columns by a fit.
    pub fn distinguishes(&self) -> bool {
        self.samples > 0 && !self.is_short() && self.travels()
    }

    /// Whether the log is too short to distinguish a fit from a coincidence, at 20 independent
    /// values per second and joint.
    fn is_short(&self) -> bool {
        self.seconds * 20.0 * self.arm.dof() as f64 <= 3.0 * self.arm.base_parameters().len() as f64
    }

    /// Reading that explains the torques far better than the recorded columns, with its evidence.
    /// `gears`: ratio of each joint, if known.
    pub fn explained(&self, reference: Reference<'_>, gears: &[Option<f64>]) -> Option<Finding> {
        let n = self.arm.dof();
        if self.samples == 0 || (self.is_short() && matches!(reference, Reference::Fit)) {
            return None;
        }
        let as_recorded = Reading::as_recorded(n);
        let recorded = self.unexplained(&self.factors, self.samples, &as_recorded, reference);
        if !self.travels() {
            return match reference {
                Reference::Model(beta) => self.in_unit(beta, gears),
                Reference::Fit => None,
            };
        }
        let signs = self.best_signs(&as_recorded, reference);
        let (best, left) = self.simplest(self.search(reference), reference);
        // With a model each joint's error is separate: joints whose columns stay have no
        // information on the order.
        let [recorded_there, signs_there, left_there] = match reference {
            Reference::Fit => [recorded, signs, left],
            Reference::Model(beta) => self.of_the_moved(beta, &best),
        };
        let far_better =
            |left: f64, recorded: f64, signs: f64| left < EXPLAINED && left < FAR_BETTER * recorded.min(signs);
        let torques = best.is_permuted() && far_better(left_there, recorded_there, signs_there);
        if let Some(order) = self.best_positions(reference) {
            let alike = left < ALIKE_LEFT * order.left && order.left < ALIKE_LEFT * left;
            if torques && alike {
                let joints = (0..n).filter(|&j| order.columns[j] != j).map(|j| j + 1).collect();
                return Some(finding(Explanation::PositionsOrTorques { joints }, recorded, order.left));
            }
            let far = order.shows_on_several() && far_better(order.left, order.recorded, signs);
            if far && !(torques && left < order.left) {
                let columns = order.columns.iter().map(|c| c + 1).collect();
                return Some(finding(Explanation::Positions { columns }, order.recorded, order.left));
            }
        }
        if torques {
            let columns = best.column.iter().map(|c| c + 1).collect();
            let explanation = Explanation::Order { columns, negated: best.negated };
            return Some(finding(explanation, recorded_there, left_there));
        }
        let degrees = self.unexplained(&self.degrees, self.samples, &as_recorded, reference);
        if far_better(degrees, recorded, signs) {
            return Some(finding(Explanation::Degrees, recorded, degrees));
        }
        match reference {
            Reference::Model(beta) => self.in_unit(beta, gears),
            Reference::Fit => None,
        }
    }

    /// Residual shares of the torques (root mean square) of a model over the joints whose column
    /// changes in `reading`: as recorded, with the best signs, and with this reading.
    fn of_the_moved(&self, beta: &[f64], reading: &Reading) -> [f64; 3] {
        let moved: Vec<usize> = (0..reading.column.len()).filter(|&j| reading.column[j] != j).collect();
        let left = |j: usize, column: usize, negated: bool| self.left_by_model(&self.factors, beta, j, column, negated);
        let mean =
            |of: &dyn Fn(usize) -> f64| (moved.iter().map(|&j| of(j)).sum::<f64>() / moved.len().max(1) as f64).sqrt();
        [
            mean(&|j| left(j, j, false)),
            mean(&|j| left(j, j, false).min(left(j, j, true))),
            mean(&|j| left(j, reading.column[j], reading.negated[j])),
        ]
    }

    /// Residual share of the torques (root mean square, joints equally weighted). `samples`: number
    /// of samples in the factors.
    fn unexplained(&self, factors: &[RFactor], samples: usize, reading: &Reading, reference: Reference<'_>) -> f64 {
        self.unexplained_beside(None, (factors, samples), reading, reference)
    }

    /// The same over all joints but one. `factors`, with the number of samples in them.
    fn unexplained_beside(
        &self,
        joint: Option<usize>,
        (factors, samples): (&[RFactor], usize),
        reading: &Reading,
        reference: Reference<'_>,
    ) -> f64 {
        match reference {
            Reference::Fit => self.left_by_fit(joint, (factors, samples), reading),
            Reference::Model(beta) => {
                let of = |j: usize| self.left_by_model(factors, beta, j, reading.column[j], reading.negated[j]);
                let squares: Vec<f64> = (0..self.arm.dof()).filter(|j| joint != Some(*j)).map(of).collect();
                (squares.iter().sum::<f64>() / squares.len().max(1) as f64).sqrt()
            }
        }
    }

    fn left_by_fit(&self, without: Option<usize>, (factors, samples): (&[RFactor], usize), reading: &Reading) -> f64 {
        let systems: Vec<JointSystem> = (0..self.arm.dof())
            .map(|j| self.system(&factors[j], samples, j, (reading.column[j], reading.negated[j])))
            .collect();
        let scale = |(j, s): (usize, &JointSystem)| match s.torque_rms {
            rms if rms > 0.0 && without != Some(j) => rms.recip(),
            _ => 0.0,
        };
        let scale: Vec<f64> = systems.iter().enumerate().map(scale).collect();
        let parameters = self.arm.base_parameters().len();
        let active: Vec<usize> = (0..parameters).collect();
        let triangle = stacked(&systems, &scale, &active, parameters);
        let live = scale.iter().filter(|s| **s > 0.0).count().max(1);
        triangle.get(parameters, parameters).abs() / ((live * samples) as f64).sqrt()
    }

    /// Squared share of a column's torque that a joint's model leaves unexplained.
    fn left_by_model(&self, factors: &[RFactor], beta: &[f64], joint: usize, column: usize, negated: bool) -> f64 {
        let [torque, model, product] = self.moments(&factors[joint], beta, joint, column);
        let product = if negated { -product } else { product };
        if torque > 0.0 { ((torque - 2.0 * product + model) / torque).max(0.0) } else { 1.0 }
    }

    /// Sums of squares of a column's torque and of a joint's model, and of their product.
    fn moments(&self, factor: &RFactor, beta: &[f64], joint: usize, column: usize) -> [f64; 3] {
        let m = self.rows.columns[joint].len();
        let size = factor.columns();
        let mut of_torque = vec![0.0; size];
        of_torque[m + column] = 1.0;
        let mut of_model = vec![0.0; size];
        self.rows.columns[joint].iter().enumerate().for_each(|(i, &c)| of_model[i] = beta[c]);
        let (torque, model) = (factor.apply(&of_torque), factor.apply(&of_model));
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        [dot(&torque, &torque), dot(&model, &model), dot(&torque, &model)]
    }

    /// Equations of a joint with the torque of one column.
    fn system(&self, factor: &RFactor, samples: usize, joint: usize, (column, negated): (usize, bool)) -> JointSystem {
        let m = self.rows.columns[joint].len();
        let size = factor.columns();
        let mut block = Vec::with_capacity(size * (m + 1));
        for k in (0..m).chain([m + column]) {
            block.extend((0..size).map(|row| if row <= k { factor.get(row, k) } else { 0.0 }));
        }
        let mut triangle = RFactor::new(m + 1);
        triangle.absorb(&mut block, size);
        if negated {
            triangle.negate_last();
        }
        let mut last = vec![0.0; m + 1];
        last[m] = 1.0;
        JointSystem {
            columns: self.rows.columns[joint].clone(),
            torque_rms: triangle.norm_of(&last) / (samples.max(1) as f64).sqrt(),
            triangle,
            gram: Vec::new(),
            samples,
            independent: 0.0,
            travel: 0.0,
            batches: Vec::new(),
        }
    }

    /// Residual of the best choice of signs with unchanged columns.
    fn best_signs(&self, from: &Reading, reference: Reference<'_>) -> f64 {
        let mut reading = from.clone();
        let mut left = self.unexplained(&self.factors, self.samples, &reading, reference);
        for joint in 0..reading.column.len() {
            reading.negated[joint] = true;
            match self.unexplained(&self.factors, self.samples, &reading, reference) {
                better if better < left => left = better,
                _ => reading.negated[joint] = false,
            }
        }
        left
    }

    /// Best reading found by steps from the recorded order, or from the best pairing of rows.
    fn search(&self, reference: Reference<'_>) -> (Reading, f64) {
        let n = self.arm.dof();
        let paired = (n <= MOST_JOINTS).then(|| self.best_pairing(reference));
        let starts = std::iter::once(Reading::as_recorded(n)).chain(paired);
        let climbed = starts.map(|start| {
            let mut left = self.unexplained(&self.factors, self.samples, &start, reference);
            let mut reading = start;
            loop {
                let next = reading
                    .neighbours()
                    .map(|next| (self.unexplained(&self.factors, self.samples, &next, reference), next));
                match next.min_by(|a, b| a.0.total_cmp(&b.0)) {
                    // A step with a negligible gain is not taken.
                    Some((better, next)) if better < 0.9 * left => (left, reading) = (better, next),
                    _ => return (reading, left),
                }
            }
        });
        climbed.min_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or((Reading::as_recorded(n), f64::INFINITY))
    }

    /// Reading nearest to the recorded columns whose residual is hardly larger.
    fn simplest(&self, (mut reading, left): (Reading, f64), reference: Reference<'_>) -> (Reading, f64) {
        let n = reading.column.len();
        let mut last = left;
        loop {
            let fits = |next: Reading| {
                let now = self.unexplained(&self.factors, self.samples, &next, reference);
                (now < 1.1 * left).then_some((now, next))
            };
            let mut tried = Vec::new();
            if reading.negated.contains(&true) {
                tried.push(Reading { negated: vec![false; n], ..reading.clone() });
            }
            for joint in 0..n {
                let mut next = reading.clone();
                if let Some(other) = next.column.iter().position(|&c| c == joint).filter(|&other| other != joint) {
                    next.column.swap(joint, other);
                    tried.push(next);
                } else if next.negated[joint] {
                    next.negated[joint] = false;
                    tried.push(next);
                }
            }
            match tried.into_iter().find_map(fits) {
                Some((now, next)) => (last, reading) = (now, next),
                None => return (reading, last),
            }
        }
    }

    /// Pairing of equations and columns with the least residual of the rows, each on its own:
    /// dynamic programming over sets of columns (Held and Karp 1962).
    fn best_pairing(&self, reference: Reference<'_>) -> Reading {
        let n = self.arm.dof();
        let cost: Vec<Vec<(f64, bool)>> =
            (0..n).map(|j| (0..n).map(|k| self.row_cost(j, k, reference)).collect()).collect();
        let mut best: Vec<(f64, usize)> = vec![(f64::INFINITY, 0); 1 << n];
        best[0] = (0.0, 0);
        for set in 0..1usize << n {
            let joint = set.count_ones() as usize;
            for column in (0..n).filter(|c| joint < n && set >> c & 1 == 0) {
                let sum = best[set].0 + cost[joint][column].0;
                let next = &mut best[set | 1 << column];
                if sum < next.0 {
                    *next = (sum, column);
                }
            }
        }
        let mut reading = Reading::as_recorded(n);
        let mut set = (1usize << n) - 1;
        for joint in (0..n).rev() {
            let column = best[set].1;
            (reading.column[joint], reading.negated[joint]) = (column, cost[joint][column].1);
            set &= !(1 << column);
        }
        reading
    }

    /// Logarithm of the residual share of a row for a column, and whether the sign is reversed.
    fn row_cost(&self, joint: usize, column: usize, reference: Reference<'_>) -> (f64, bool) {
        let (share, negated) = match reference {
            Reference::Fit => {
                let system = self.system(&self.factors[joint], self.samples, joint, (column, false));
                let m = system.columns.len();
                let left = system.triangle.get(m, m).abs() / (self.samples as f64).sqrt();
                (if system.torque_rms > 0.0 { left / system.torque_rms } else { 1.0 }, false)
            }
            Reference::Model(beta) => {
                let of = |negated| self.left_by_model(&self.factors, beta, joint, column, negated).sqrt();
                let (plain, negated) = (of(false), of(true));
                (plain.min(negated), negated < plain)
            }
        };
        (share.max(1e-3).ln(), negated)
    }

    /// Detects torques that agree with the model except for their scale.
    fn in_unit(&self, beta: &[f64], gears: &[Option<f64>]) -> Option<Finding> {
        let n = self.arm.dof();
        let moments: Vec<[f64; 3]> = (0..n).map(|j| self.moments(&self.factors[j], beta, j, j)).collect();
        // Ratio of torque to model, for joints whose torque correlates with the model.
        let alike = |[torque, model, product]: &[f64; 3]| {
            let correlation = product.abs() / (torque * model).sqrt();
            (correlation > ALIKE).then(|| (torque / model).sqrt())
        };
        let sizes: Vec<Option<f64>> = moments.iter().map(alike).collect();
        let count = sizes.iter().flatten().count();
        if count < n.min(2) {
            return None;
        }
        let rough = if 2 * count < n { ROUGH_OF_FEW } else { ROUGH };
        let explained = || moments.iter().zip(&sizes).filter(|(_, size)| size.is_some()).map(|(moments, _)| moments);
        let left = (explained().map(|[t, m, p]| 1.0 - (p * p / (t * m)).min(1.0)).sum::<f64>() / count as f64).sqrt();
        let recorded = (explained().map(|[t, m, p]| (t - 2.0 * p + m) / t).sum::<f64>() / count as f64).sqrt();
        let common = |times: &dyn Fn(usize) -> Option<f64>| -> Option<f64> {
            let logs: Vec<f64> =
                (0..n).filter_map(|j| Some((sizes[j]? * times(j)?).ln())).filter(|x| x.is_finite()).collect();
            let mean = logs.iter().sum::<f64>() / logs.len().max(1) as f64;
            let spread = logs.iter().map(|x| (x - mean).abs()).fold(0.0, f64::max);
            (logs.len() >= n.min(2) && spread < AGREE.ln()).then(|| mean.exp())
        };
        let off = |size: f64, rough: f64| !(rough.recip()..rough).contains(&size);
        let plain = common(&|_| Some(1.0));
        let geared = common(&|j| gears.get(j).copied().flatten().map(f64::abs));
        let explanation = match (plain, geared) {
            (Some(size), _) if !off(size, rough) => return None,
            (_, Some(size)) if !off(size, ROUGH) => Explanation::MotorSide,
            (Some(size), _) => Explanation::Unit { times: size },
            _ => return None,
        };
        Some(finding(explanation, recorded, left))
    }
}

fn absorb(factors: &mut [RFactor], arm: &dyn Arm, rows: &Rows, block: &MotionBlock, states: &States) {
    let (len, mut regressor) = (states.len, Vec::new());
    rows.evaluate(arm, states, &block.sign, &mut regressor);
    for (joint, factor) in factors.iter_mut().enumerate() {
        let entries = rows.offsets[joint] * len..rows.offsets[joint + 1] * len;
        let mut work = [&regressor[entries], &block.tau[..]].concat();
        factor.absorb(&mut work, len);
    }
}

fn finding(explanation: Explanation, recorded: f64, left: f64) -> Finding {
    let percent = [recorded, left].map(|share| 100.0 * share);
    let kind = Kind::Misread { explanation, log: None, percent };
    Finding { kind, severity: Severity::Warning, line: None, column: None, count: 1 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::identify::planar::Normal;
    use crate::model::interpreted::Interpreted;
    use dh_codegen::arm::param;

    /// A robot of the repository with its file's values, in motion; torques with noise.
    fn recorded(text: &str, seed: u64) -> (Interpreted, Vec<f64>, Motion) {
        let robot = dh_codegen::robot::Robot::from_yaml(text, &dh_codegen::robot::no_files).unwrap().robot;
        let arm = Interpreted::new(&robot, &[]);
        let standard = param::standard_values(&robot).unwrap();
        let (n, len, rate) = (arm.dof(), 600, 50.0);
        let wave = |joint: usize, s: usize, derivative: i32| -> f64 {
            let lead = f64::from(derivative) * std::f64::consts::FRAC_PI_2;
            let of =
                |w: f64| 0.5 * w.powi(derivative) * (w * s as f64 / rate + (joint as u64 + seed) as f64 + lead).sin();
            of(0.9 + 0.31 * joint as f64) + 0.5 * of(2.3 - 0.17 * joint as f64)
        };
        let all = |d: i32| (0..n).flat_map(|j| (0..len).map(move |s| (j, s))).map(|(j, s)| wave(j, s, d)).collect();
        let states = States { len, q: all(0), dq: all(1), ddq: all(2) };
        let mut tau = vec![0.0; n * len];
        arm.inverse_dynamics(&states, &standard, &mut tau);
        let mut normal = Normal::new(seed);
        tau.iter_mut().for_each(|t| *t += 0.05 * normal.next());
        let velocity_noise = vec![0.0; n];
        let motion =
            Motion { period: 1.0 / rate, states, tau, core: 0..len, stride: 1, velocity_noise, ..Motion::default() };
        let beta = crate::identify::regression::recover::base_of(&arm, &standard);
        (arm, beta, motion)
    }

    fn read(
        arm: &Interpreted,
        motion: &Motion,
        reference: Reference<'_>,
        gears: &[Option<f64>],
    ) -> Option<Explanation> {
        let mut columns = TorqueColumns::new(arm);
        columns.absorb(motion);
        match columns.explained(reference, gears)?.kind {
            Kind::Misread { explanation, percent, .. } => {
                assert!(percent[1] < 0.5 * percent[0], "{percent:?}");
                Some(explanation)
            }
            other => panic!("{other:?}"),
        }
    }

    /// The motion with each joint's torque moved to the given column (from 0).
    fn in_columns(motion: &Motion, columns: &[usize]) -> Motion {
        let (len, mut out) = (motion.states.len, motion.clone());
        for (joint, &column) in columns.iter().enumerate() {
            out.tau[column * len..(column + 1) * len].copy_from_slice(&motion.tau[joint * len..(joint + 1) * len]);
        }
        out
    }

    #[test]
    fn exchanged_positions_are_no_other_order_of_the_torques() {
        let (arm, beta, motion) = recorded(PUMA, 3);
        let len = motion.states.len;
        for columns in [[0, 1, 2, 5, 4, 3], [2, 1, 0, 3, 4, 5], [1, 2, 0, 3, 4, 5]] {
            let mut log = motion.clone();
            let States { q, dq, ddq, .. } = &motion.states;
            for (of, to) in [(q, &mut log.states.q), (dq, &mut log.states.dq), (ddq, &mut log.states.ddq)] {
                for (joint, &column) in columns.iter().enumerate() {
                    let (from, to_rows) = (joint * len..(joint + 1) * len, column * len..(column + 1) * len);
                    to[to_rows].copy_from_slice(&of[from]);
                }
            }
            let named: Vec<usize> = columns.iter().map(|c| c + 1).collect();
            for reference in [Reference::Fit, Reference::Model(&beta)] {
                match read(&arm, &log, reference, &[]) {
                    Some(Explanation::Positions { columns }) => assert_eq!(columns, named, "{reference:?}"),
                    // For the light wrist a fit determines friction alone.
                    Some(Explanation::PositionsOrTorques { joints }) => {
                        assert!(joints == [4, 6] && matches!(reference, Reference::Fit), "{reference:?} {joints:?}");
                    }
                    other => panic!("{reference:?}: {other:?}"),
                }
            }
        }
    }

    const PUMA: &str = include_str!("../../../robots/puma560.yaml");

    #[test]
    fn exchanged_columns_are_named_whatever_their_order() {
        let (arm, beta, motion) = recorded(PUMA, 3);
        for columns in [[0, 3, 2, 1, 4, 5], [2, 1, 0, 3, 5, 4]] {
            let log = in_columns(&motion, &columns);
            let named: Vec<usize> = columns.iter().map(|c| c + 1).collect();
            for reference in [Reference::Fit, Reference::Model(&beta)] {
                match read(&arm, &log, reference, &[]) {
                    Some(Explanation::Order { columns, negated }) => {
                        assert_eq!(columns[..3], named[..3], "{reference:?}");
                        assert!(negated.iter().all(|n| !n), "{reference:?} {negated:?}");
                    }
                    other => panic!("{reference:?}: {other:?}"),
                }
            }
        }
        for reference in [Reference::Fit, Reference::Model(&beta)] {
            assert_eq!(read(&arm, &motion, reference, &[]), None);
        }
    }

    /// For an arm at rest, six numbers are compared with six: a matching order proves nothing.
    #[test]
    fn an_arm_that_stands_tells_no_order() {
        let (arm, beta, motion) = recorded(PUMA, 3);
        let model = Reference::Model(&beta);
        let mut log = in_columns(&motion, &[0, 3, 2, 1, 4, 5]);
        let mut columns = TorqueColumns::new(&arm);
        columns.absorb(&log);
        assert!(columns.is_suspicious(model));
        let len = log.states.len;
        for row in [&mut log.states.q, &mut log.states.dq, &mut log.states.ddq, &mut log.tau] {
            row.chunks_exact_mut(len).for_each(|row| row.fill(row[0]));
        }
        assert_eq!(read(&arm, &log, model, &[]), None);
        let mut columns = TorqueColumns::new(&arm);
        columns.absorb(&motion);
        assert!(!columns.is_suspicious(model) && !columns.is_suspicious(Reference::Fit));
    }

    #[test]
    fn a_negated_column_is_no_other_order() {
        let (arm, beta, mut motion) = recorded(PUMA, 5);
        let len = motion.states.len;
        motion.tau[len..2 * len].iter_mut().for_each(|t| *t = -*t);
        for reference in [Reference::Fit, Reference::Model(&beta)] {
            assert_eq!(read(&arm, &motion, reference, &[]), None);
        }
    }

    #[test]
    fn units_are_named_by_the_model() {
        let (arm, beta, motion) = recorded(PUMA, 7);
        let model = Reference::Model(&beta);
        let scaled = |by: &dyn Fn(usize) -> f64| {
            let (len, mut out) = (motion.states.len, motion.clone());
            out.tau.iter_mut().enumerate().for_each(|(k, t)| *t *= by(k / len));
            out
        };
        match read(&arm, &scaled(&|_| 1000.0), model, &[]) {
            Some(Explanation::Unit { times }) => assert!((times / 1000.0 - 1.0).abs() < 0.2, "{times}"),
            other => panic!("{other:?}"),
        }
        let gears = [62.6, 107.8, 53.7, 76.0, 71.9, 76.7];
        let known = gears.map(Some);
        assert_eq!(read(&arm, &scaled(&|j| 1.0 / gears[j]), model, &known), Some(Explanation::MotorSide));
        let mut degrees = motion.clone();
        for x in [&mut degrees.states.q, &mut degrees.states.dq, &mut degrees.states.ddq] {
            x.iter_mut().for_each(|x| *x = x.to_degrees());
        }
        assert_eq!(read(&arm, &degrees, Reference::Fit, &[]), Some(Explanation::Degrees));
    }

    /// Joints that the model predicts poorly, like light wrists on real arms, hide neither an
    /// exchange of others nor a unit.
    #[test]
    fn poorly_modelled_joints_hide_nothing() {
        let (arm, beta, mut motion) = recorded(PUMA, 9);
        let len = motion.states.len;
        let mut normal = Normal::new(77);
        for joint in [0, 3, 4, 5] {
            let own = &mut motion.tau[joint * len..(joint + 1) * len];
            let size = (own.iter().map(|t| t * t).sum::<f64>() / len as f64).sqrt();
            own.iter_mut().for_each(|t| *t += 2.0 * size * normal.next());
        }
        let model = Reference::Model(&beta);
        assert_eq!(read(&arm, &motion, model, &[]), None);
        match read(&arm, &in_columns(&motion, &[0, 2, 1, 3, 4, 5]), model, &[]) {
            Some(Explanation::Order { columns, .. }) => assert_eq!(columns, [1, 3, 2, 4, 5, 6]),
            other => panic!("{other:?}"),
        }
        motion.tau.iter_mut().for_each(|t| *t *= 57.29578);
        match read(&arm, &motion, model, &[]) {
            Some(Explanation::Unit { times }) => assert!((times / 57.3 - 1.0).abs() < 0.2, "{times}"),
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn an_alphabetical_order_is_called_so() {
        let columns: Vec<usize> = vec![1, 4, 5, 6, 7, 8, 9, 10, 11, 2, 3];
        let finding = finding(Explanation::Order { columns, negated: vec![false; 11] }, 0.8, 0.02);
        assert!(finding.to_string().contains("sorted as text"), "{finding}");
    }
}
