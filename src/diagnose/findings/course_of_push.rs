//! Course in time of a push on a standing arm.

use std::ops::Range;

use crate::diagnose::windows::pauses::Pause;

/// Part at rest before and after a push, as a share of its length. Its torques vary linearly without
/// the push.
pub(super) const BESIDE: f64 = 0.25;

/// Course of a push over blocks, and what is at rest beside it.
pub(super) struct Course {
    /// Number of blocks of the push.
    pub(super) length: usize,
    /// Number of blocks before it, and after it.
    pub(super) margin: usize,
    /// Whether it rises to its middle and falls from there on; otherwise it is constant.
    pub(super) swells: bool,
    /// Weights of the torques whose sum is the size of the push, beside any line in time.
    weights: Vec<f64>,
    /// Sum of squares of the course beside that line.
    pub(super) square: f64,
}

impl Course {
    /// A course of `length` blocks.
    pub(super) fn new(length: usize, swells: bool) -> Self {
        let margin = ((BESIDE * length as f64).ceil() as usize).max(3);
        let all = length + 2 * margin;
        let at = |b: usize| {
            let place = (b as f64 + 0.5 - margin as f64) / length as f64;
            match (0.0..1.0).contains(&place) {
                true if swells => (std::f64::consts::PI * place).sin().powi(2),
                inside => f64::from(u8::from(inside)),
            }
        };
        let mut course: Vec<f64> = (0..all).map(at).collect();
        // Its mean; by symmetry it has no slope.
        let mean = course.iter().sum::<f64>() / all as f64;
        course.iter_mut().for_each(|c| *c -= mean);
        let square = course.iter().map(|c| c * c).sum::<f64>();
        Self { length, margin, swells, weights: course.iter().map(|c| c / square).collect(), square }
    }

    /// Blocks at which it may begin in a pause.
    pub(super) fn starts(&self, pause: &Pause) -> impl Iterator<Item = usize> + use<> {
        let last = (pause.len() + 1).saturating_sub(self.length + self.margin);
        (self.margin..last).step_by((self.length / 10).max(1))
    }

    /// Blocks of the push and beside it.
    pub(super) fn blocks(&self, start: usize) -> Range<usize> {
        start - self.margin..start + self.length + self.margin
    }

    /// Change of each joint's torque, N m.
    pub(super) fn sizes(&self, pause: &Pause, start: usize) -> Vec<f64> {
        let size = |row: &Vec<f64>| row[self.blocks(start)].iter().zip(&self.weights).map(|(y, w)| y * w).sum();
        pause.torque.iter().map(size).collect()
    }
}
