//! Detects position columns of a log in another order.
//!
//! Unlike another order of the torques this changes the regressor, so some of the samples are kept
//! and evaluated again for each order that is tried.

use super::{FAR_BETTER, Reading, Reference, TorqueColumns, absorb};
use crate::data::signal::MotionBlock;
use crate::identify::regression::r_factor::RFactor;
use crate::model::States;

/// Most samples that are kept.
const MOST: usize = 800;
/// A step to another order must leave less than this share of the previous residual.
const STEP: f64 = 0.9;

/// Every `every`-th sample of a log.
#[derive(Debug, Clone)]
pub(super) struct Kept {
    samples: Vec<Sample>,
    every: usize,
    seen: usize,
}

/// One sample: motion and torque of each joint.
#[derive(Debug, Clone)]
struct Sample {
    motion: Vec<[f64; 3]>,
    tau: Vec<f64>,
}

impl Default for Kept {
    fn default() -> Self {
        Self { samples: Vec::new(), every: 1, seen: 0 }
    }
}

impl Kept {
    /// Adds samples; if there are too many, every second kept one is discarded.
    pub(super) fn absorb(&mut self, block: &MotionBlock) {
        let States { len, q, dq, ddq } = &block.states;
        let joints = q.len() / (*len).max(1);
        for s in 0..*len {
            if self.seen.is_multiple_of(self.every) {
                let at = |joint: usize| joint * len + s;
                let motion = (0..joints).map(|j| [q[at(j)], dq[at(j)], ddq[at(j)]]).collect();
                self.samples.push(Sample { motion, tau: (0..joints).map(|j| block.tau[at(j)]).collect() });
                if self.samples.len() > 2 * MOST {
                    let mut place = 0..;
                    self.samples.retain(|_| place.next().is_some_and(|k: usize| k.is_multiple_of(2)));
                    self.every *= 2;
                }
            }
            self.seen += 1;
        }
    }

    /// The samples with each joint's motion read from the given column (from 0).
    fn read(&self, columns: &[usize]) -> MotionBlock {
        let all = |of: &dyn Fn(&Sample, usize) -> f64| -> Vec<f64> {
            (0..columns.len()).flat_map(|joint| self.samples.iter().map(move |s| of(s, joint))).collect()
        };
        let [q, dq, ddq] = [0, 1, 2].map(|d| all(&|s, joint| s.motion[columns[joint]][d]));
        let states = States { len: self.samples.len(), q, dq, ddq };
        MotionBlock { states, tau: all(&|s, joint| s.tau[joint]), ..MotionBlock::default() }
    }
}

/// Another order of the position columns, with the residual shares of the torques as recorded and
/// in this order.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Order {
    /// For each joint, the column that holds its position, from 0.
    pub(super) columns: Vec<usize>,
    pub(super) recorded: f64,
    pub(super) left: f64,
    /// The same without the joint that is explained worst as recorded. Positions in another order
    /// show on several joints, a fault of one joint (a cable, friction) on that joint alone.
    pub(super) beside_the_worst: [f64; 2],
}

impl Order {
    /// Whether the order explains the other joints far better, too, without the one that is
    /// explained worst as recorded.
    pub(super) fn shows_on_several(&self) -> bool {
        let [recorded, left] = self.beside_the_worst;
        left < FAR_BETTER * recorded
    }
}

impl TorqueColumns<'_> {
    /// Best order of the position columns reachable by successive exchanges of two; the best
    /// exchange first.
    pub(super) fn best_positions(&self, reference: Reference<'_>) -> Option<Order> {
        if self.kept.samples.is_empty() {
            return None;
        }
        let n = self.arm.dof();
        let mut columns: Vec<usize> = (0..n).collect();
        let as_recorded = self.factors(&columns);
        let left_of = |factors: &[RFactor], beside: Option<usize>| {
            let samples = self.kept.samples.len();
            self.unexplained_beside(beside, (factors, samples), &Reading::as_recorded(n), reference)
        };
        let recorded = left_of(&as_recorded, None);
        let mut left = recorded;
        // Any order is at most n - 1 exchanges away.
        for _ in 1..n {
            let exchanges = (0..n).flat_map(|a| (0..a).map(move |b| (a, b)));
            let next = exchanges.map(|(a, b)| {
                let mut next = columns.clone();
                next.swap(a, b);
                (left_of(&self.factors(&next), None), next)
            });
            match next.min_by(|a, b| a.0.total_cmp(&b.0)) {
                Some((better, next)) if better < STEP * left => (left, columns) = (better, next),
                _ => break,
            }
        }
        let moved = columns.iter().enumerate().any(|(joint, column)| joint != *column);
        moved.then(|| {
            let known: Vec<f64> = (0..n).map(|joint| left_of(&as_recorded, Some(joint))).collect();
            let worst = (0..n).min_by(|a, b| known[*a].total_cmp(&known[*b])).unwrap_or(0);
            let beside_the_worst = [known[worst], left_of(&self.factors(&columns), Some(worst))];
            Order { columns, recorded, left, beside_the_worst }
        })
    }

    /// Factors of each joint's rows, with its motion read from the given column.
    fn factors(&self, columns: &[usize]) -> Vec<RFactor> {
        let block = self.kept.read(columns);
        let mut factors: Vec<RFactor> =
            self.rows.columns.iter().map(|c| RFactor::new(c.len() + self.arm.dof())).collect();
        absorb(&mut factors, self.arm, &self.rows, &block, &block.states);
        factors
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A cable on joint 1 is most of that joint's torque. Another order of the positions imitates it,
    /// but the other joints are explained as recorded.
    #[test]
    fn a_fault_of_one_joint_is_no_other_order() {
        let order =
            |beside_the_worst| Order { columns: vec![3, 1, 2, 0], recorded: 0.29, left: 0.14, beside_the_worst };
        assert!(!order([0.05, 0.12]).shows_on_several() && !order([0.05, 0.03]).shows_on_several());
        assert!(order([0.28, 0.12]).shows_on_several());
    }
}
