//! Postures along a straight leg from the closed-form inverse kinematics: every branch, followed
//! from point to point.

use dh_codegen::ik::{Displacement, Status};
use nalgebra::DMatrix;

use crate::model::inverse_kinematics::Ask;

use super::strokes::Phase;
use super::surface::Roller;
use super::task::Task;

/// A way point: wall coordinates and distance (m), and swivel angle (rad) or position of the locked
/// joint.
pub(super) type Way = [f64; 4];

/// A leg in the space of way points: straight in all four coordinates.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Line {
    pub phase: Phase,
    pub from: Way,
    pub to: Way,
}

impl Line {
    /// Way point at a share `s` of the leg.
    pub(super) fn at(&self, s: f64) -> Way {
        std::array::from_fn(|i| if s == 1.0 { self.to[i] } else { self.from[i] + s * (self.to[i] - self.from[i]) })
    }

    /// Position at a share `s` of the leg: wall coordinates and distance, m.
    pub(super) fn place(&self, s: f64) -> [f64; 3] {
        let [y, z, off, _] = self.at(s);
        [y, z, off]
    }
}

/// All postures at a set of points of a leg.
#[derive(Debug, Clone, Default)]
pub(super) struct Postures {
    /// All postures of each point.
    pub lists: Vec<Vec<Vec<f64>>>,
    /// Distance by which the worst point is out of reach, m and rad; `farthest` is its index.
    pub distance: [f64; 2],
    pub farthest: usize,
}

/// Largest change of a joint between neighbouring points, rad or m; more means another branch.
const STEP: f64 = 0.5;

impl Task<'_> {
    /// Pose of the last DH frame with the roller at a way point.
    pub(super) fn last_frame(&self, roller: &Roller, way: &Way) -> [[f64; 4]; 3] {
        let tool = Displacement::from_rows(&roller.pose(&self.surface, [way[0], way[1], way[2]]));
        let last = tool.after(&self.mount.inverse());
        std::array::from_fn(|i| {
            let [x, y, z] = last.rotation[i];
            [x, y, z, last.shift[i]]
        })
    }

    /// All postures of one way point and its distance out of reach; empty if it is out of reach.
    pub(super) fn postures_at(&self, roller: &Roller, way: &Way) -> (Vec<Vec<f64>>, [f64; 2]) {
        let ask = Ask { redundancy: way[3], reference: self.reference, ..Ask::default() };
        match self.inverse.solve(&self.last_frame(roller, way), &ask) {
            Ok(found) if found.status == Status::Ok => (found.list.into_iter().map(|p| p.q).collect(), [0.0; 2]),
            // Singular: some joints are free there, and the neighbouring points decide. Nothing is
            // out of reach.
            Ok(found) if found.status == Status::Singular => (found.list.into_iter().map(|p| p.q).collect(), [0.0; 2]),
            Ok(found) => (Vec::new(), found.distance),
            Err(_) => (Vec::new(), [1e3, 0.0]),
        }
    }

    /// All postures at these shares of a leg.
    pub(super) fn postures(&self, roller: &Roller, line: &Line, points: &[f64]) -> Postures {
        let mut all = Postures::default();
        for (k, &s) in points.iter().enumerate() {
            let (list, distance) = self.postures_at(roller, &line.at(s));
            if distance[0] + distance[1] > all.distance[0] + all.distance[1] {
                all.distance = distance;
                all.farthest = k;
            }
            all.lists.push(list);
        }
        all
    }

    /// Posture of a list nearest to another, up to whole turns; `None` if all are too far.
    pub(super) fn nearest(&self, list: &[Vec<f64>], near: &[f64]) -> Option<Vec<f64>> {
        let mut best: Option<(f64, Vec<f64>)> = None;
        for q in list {
            let q: Vec<f64> = (0..q.len()).map(|j| self.turned(j, q[j], near[j])).collect();
            let far = q.iter().zip(near).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            if best.as_ref().is_none_or(|b| far < b.0) {
                best = Some((far, q));
            }
        }
        best.filter(|b| b.0 <= STEP).map(|b| b.1)
    }

    /// Position of a joint, up to whole turns, nearest to another position.
    fn turned(&self, joint: usize, q: f64, near: f64) -> f64 {
        use std::f64::consts::TAU;
        if self.slides[joint] { q } else { q + TAU * ((near - q) / TAU).round() }
    }

    /// Follows one branch along the points from a posture; the error is the point where it was
    /// lost.
    pub(super) fn follow(&self, all: &Postures, start: &[f64]) -> Result<DMatrix<f64>, usize> {
        let mut q = DMatrix::zeros(all.lists.len(), start.len());
        let mut last = start.to_vec();
        for (k, list) in all.lists.iter().enumerate() {
            last = self.nearest(list, &last).ok_or(k)?;
            last.iter().enumerate().for_each(|(j, x)| q[(k, j)] = *x);
        }
        Ok(q)
    }
}
