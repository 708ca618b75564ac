//! What a change of a robot would look like, one number at a time, and how much of it a factor
//! shows.
//!
//! A channel is a direction in which the torques of a robot may leave those of its reference: a
//! friction level, an offset, the gain of a torque sensor, the mass or a first moment of a link.
//! With the residual `e = tau - W beta` of the reference and the torque `b` of a unit change, the
//! estimate of the change alone is `b'e / b'b`, both weighted by the noise of the joints. `R` has
//! the inner products of both.

use denavit::identify::{Factors, JointFactor};
use denavit::model::{Arm, DriveTerm, Inertial, StandardParameter};
use nalgebra::{DMatrix, DVector};
use serde::{Deserialize, Serialize};

use crate::attribution::{DayEvidence, JointEvidence};
use crate::reference::Reference;

/// Kind of a change.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub enum Kind {
    /// Friction of a joint.
    Friction,
    /// Offset of a joint's torque.
    Offset,
    /// Gain of a joint's torque.
    Gain,
    /// The load, or another tool.
    Payload,
    /// Mass on another link.
    Link,
}

impl Kind {
    /// In reports and SQL.
    pub fn name(self) -> &'static str {
        match self {
            Self::Friction => "friction",
            Self::Offset => "offset",
            Self::Gain => "gain",
            Self::Payload => "payload",
            Self::Link => "link",
        }
    }
}

/// How torques change with one unit.
#[derive(Debug, Clone, PartialEq)]
enum Direction {
    /// Changes of base parameters.
    Base(Vec<(usize, f64)>),
    /// The reference's own torque at one joint (from 0).
    Torque(usize),
}

/// One direction.
#[derive(Debug, Clone, PartialEq)]
pub struct Channel {
    /// Kind.
    pub kind: Kind,
    /// Joint or link, from 1.
    pub joint: usize,
    /// `FC3`, `gain3`, `MSX7`.
    pub parameter: String,
    /// Unit of the estimate.
    pub unit: &'static str,
    direction: Direction,
}

#[cfg(test)]
impl Channel {
    /// One that changes no torque.
    pub(crate) fn unplaced(kind: Kind, joint: usize) -> Self {
        let direction = Direction::Base(Vec::new());
        Self { kind, joint, parameter: format!("{}{joint}", kind.name()), unit: "", direction }
    }
}

/// The channels of an arm.
#[derive(Debug, Clone, PartialEq)]
pub struct Channels {
    /// In a fixed order: joint by joint, then link by link.
    pub list: Vec<Channel>,
    parameters: usize,
}

/// An estimate of one channel alone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ChannelEstimate {
    /// Change against the reference.
    pub value: f64,
    /// Its variance by noise, and by the reference's own uncertainty; infinite where the recording
    /// does not show the channel.
    pub variance: f64,
    /// Weighted sum of squares of the torque of a unit change.
    pub information: f64,
}

/// A residual of the reference, and the torques of unit changes, in the rows of the triangles.
struct Projected {
    /// Per joint, weighted.
    residual: Vec<Vec<f64>>,
    /// Per channel: joint, weighted torque.
    torques: Vec<Vec<(usize, Vec<f64>)>>,
}

impl Channels {
    /// Of an arm.
    pub fn of(arm: &dyn Arm) -> Self {
        let standard = arm.standard_parameters();
        let direction = |parameter: StandardParameter| -> Option<Direction> {
            let at = standard.iter().position(|p| *p == parameter)?;
            let factor = |(b, base): (usize, &denavit::model::BaseParameter)| {
                base.coefficients.iter().find(|(index, _)| *index == at).map(|(_, factor)| (b, *factor))
            };
            let base: Vec<(usize, f64)> = arm.base_parameters().iter().enumerate().filter_map(factor).collect();
            (!base.is_empty()).then_some(Direction::Base(base))
        };
        let mut list = Vec::new();
        let mut push = |kind, joint, parameter: String, unit, direction: Option<Direction>| {
            list.extend(direction.map(|direction| Channel { kind, joint, parameter, unit, direction }));
        };
        let mut rows: Vec<usize> = standard.iter().filter_map(|p| row_of(*p)).collect();
        rows.sort_unstable();
        rows.dedup();
        for &row in &rows {
            for (term, kind, unit) in [
                (DriveTerm::FC, Kind::Friction, "N m"),
                (DriveTerm::FV, Kind::Friction, "N m s/rad"),
                (DriveTerm::FO, Kind::Offset, "N m"),
            ] {
                let parameter = StandardParameter::Drive(row, term);
                push(kind, row + 1, parameter.to_string(), unit, direction(parameter));
            }
        }
        for joint in 0..arm.dof() {
            let row = rows.get(joint).copied().unwrap_or(joint);
            push(Kind::Gain, row + 1, format!("gain{}", row + 1), "", Some(Direction::Torque(joint)));
        }
        let last = rows.last().copied();
        for &row in &rows {
            let kind = if Some(row) == last { Kind::Payload } else { Kind::Link };
            for which in [Inertial::M, Inertial::MSX, Inertial::MSY, Inertial::MSZ] {
                let parameter = StandardParameter::Link(row, which);
                let unit = if which == Inertial::M { "kg" } else { "kg m" };
                push(kind, row + 1, parameter.to_string(), unit, direction(parameter));
            }
        }
        Self { list, parameters: arm.base_parameters().len() }
    }

    /// Each channel alone, on the factors of a recording.
    pub fn estimates(&self, factors: &Factors, reference: &Reference) -> Vec<ChannelEstimate> {
        let projected = self.projected(factors, reference);
        let slow: Vec<f64> =
            factors.joints.iter().map(|j| (j.samples as f64 / j.independent.max(1.0)).max(1.0)).collect();
        let one = |torques: &Vec<(usize, Vec<f64>)>| {
            let (mut score, mut information, mut noise) = (0.0, 0.0, 0.0);
            let mut leverage = vec![0.0; self.parameters];
            for (joint, torque) in torques {
                let square = dot(torque, torque);
                score += dot(torque, &projected.residual[*joint]);
                (information, noise) = (information + square, noise + slow[*joint] * square);
                let JointFactor { columns, triangle, .. } = &factors.joints[*joint];
                let root = reference.weights[*joint].sqrt();
                for (k, &column) in columns.iter().enumerate() {
                    leverage[column] += root * dot(&triangle.column(k)[..=k], &torque[..=k]);
                }
            }
            if information <= 0.0 {
                return ChannelEstimate { value: 0.0, variance: f64::INFINITY, information: 0.0 };
            }
            leverage.iter_mut().for_each(|c| *c /= information);
            let variance = noise / (information * information) + reference.variance(&leverage);
            ChannelEstimate { value: score / information, variance, information }
        };
        projected.torques.iter().map(one).collect()
    }

    /// What a recording shows of all channels together.
    pub fn evidence(&self, factors: &Factors, reference: &Reference) -> DayEvidence {
        let projected = self.projected(factors, reference);
        let joint = |joint: usize| {
            let live = reference.weights[joint] > 0.0 && factors.joints[joint].is_live();
            let own = |(k, torques): (usize, &Vec<(usize, Vec<f64>)>)| {
                torques.iter().position(|(j, _)| *j == joint && live).map(|at| (k, at))
            };
            let found: Vec<(usize, usize)> = projected.torques.iter().enumerate().filter_map(own).collect();
            let shown: Vec<(usize, &[f64])> =
                found.iter().map(|&(k, at)| (k, projected.torques[k][at].1.as_slice())).collect();
            let residual = if live { projected.residual[joint].as_slice() } else { &[] };
            JointEvidence {
                channels: shown.iter().map(|(k, _)| *k).collect(),
                gram: DMatrix::from_fn(shown.len(), shown.len(), |a, b| dot(shown[a].1, shown[b].1)),
                score: DVector::from_fn(shown.len(), |a, _| dot(shown[a].1, residual)),
                square: dot(residual, residual),
                rows: residual.len(),
            }
        };
        DayEvidence((0..factors.joints.len()).map(joint).collect())
    }

    fn projected(&self, factors: &Factors, reference: &Reference) -> Projected {
        let residual = |(joint, weight): (&JointFactor, &f64)| {
            let mut x: Vec<f64> = joint.columns.iter().map(|&c| -reference.beta[c]).collect();
            x.push(1.0);
            let mut e = joint.triangle.apply(&x);
            // What no parameter explains.
            e.truncate(joint.columns.len());
            e.iter_mut().for_each(|e| *e *= weight.sqrt());
            e
        };
        let residual = factors.joints.iter().zip(&reference.weights).map(residual).collect();
        let torque = |change: &[f64], joint: usize| {
            let JointFactor { columns, triangle, .. } = &factors.joints[joint];
            let mut b = vec![0.0; columns.len()];
            let root = reference.weights[joint].sqrt();
            for (k, &column) in columns.iter().enumerate().filter(|(_, c)| change[**c] != 0.0) {
                b.iter_mut().zip(triangle.column(k)).for_each(|(b, r)| *b += root * change[column] * r);
            }
            b
        };
        let torques = |channel: &Channel| -> Vec<(usize, Vec<f64>)> {
            match &channel.direction {
                Direction::Torque(joint) => vec![(*joint, torque(&reference.beta, *joint))],
                Direction::Base(changes) => {
                    let mut change = vec![0.0; self.parameters];
                    changes.iter().for_each(|&(b, factor)| change[b] = factor);
                    let touched = |j: &usize| factors.joints[*j].columns.iter().any(|&c| change[c] != 0.0);
                    (0..factors.joints.len()).filter(touched).map(|j| (j, torque(&change, j))).collect()
                }
            }
        };
        Projected { residual, torques: self.list.iter().map(torques).collect() }
    }
}

/// The row of a drive or a link.
fn row_of(parameter: StandardParameter) -> Option<usize> {
    match parameter {
        StandardParameter::Link(row, _) | StandardParameter::Drive(row, _) => Some(row),
        StandardParameter::Coupling(..) | StandardParameter::Payload(_) => None,
    }
}

/// Inner product with four running sums, which the compiler can keep in vector registers.
fn dot(a: &[f64], b: &[f64]) -> f64 {
    let (a, b) = (&a[..a.len().min(b.len())], &b[..a.len().min(b.len())]);
    let (fours, others) = (a.chunks_exact(4), b.chunks_exact(4));
    let rest: f64 = fours.remainder().iter().zip(others.remainder()).map(|(x, y)| x * y).sum();
    let mut sums = [0.0; 4];
    for (x, y) in fours.zip(others) {
        for k in 0..4 {
            sums[k] += x[k] * y[k];
        }
    }
    sums.iter().sum::<f64>() + rest
}
