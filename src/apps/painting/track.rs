//! Postures along a straight leg, by the closed-form inverse: every branch, followed from point to
//! point.

use dh_codegen::ik::{Displacement, Status};
use nalgebra::DMatrix;

use crate::model::inverse_kinematics::Ask;

use super::strokes::Phase;
use super::surface::Roller;
use super::task::Task;

/// A way point: coordinates on the wall, distance from it (m), and swivel angle (rad) or position
/// of the joint that is given.
pub(super) type Way = [f64; 4];

/// A leg in the space of way points: straight in all four.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Line {
    pub phase: Phase,
    pub from: Way,
    pub to: Way,
}

impl Line {
    /// At a share `s` of the way.
    pub(super) fn at(&self, s: f64) -> Way {
        std::array::from_fn(|i| if s == 1.0 { self.to[i] } else { self.from[i] + s * (self.to[i] - self.from[i]) })
    }

    /// Only the place.
    pub(super) fn place(&self, s: f64) -> [f64; 3] {
        let [y, z, off, _] = self.at(s);
        [y, z, off]
    }
}

/// All postures at some points of a leg.
#[derive(Debug, Clone, Default)]
pub(super) struct Postures {
    /// Per point, all of them.
    pub lists: Vec<Vec<Vec<f64>>>,
    /// How far the worst point is out of reach, m and rad, and which it is.
    pub distance: [f64; 2],
    pub farthest: usize,
}

/// The farthest a joint may go between neighbouring points, rad or m: more is another branch.
const STEP: f64 = 0.5;

impl Task<'_> {
    /// The last DH frame where the roller is at a way point.
    pub(super) fn last_frame(&self, roller: &Roller, way: &Way) -> [[f64; 4]; 3] {
        let tool = Displacement::from_rows(&roller.pose(&self.surface, [way[0], way[1], way[2]]));
        let last = tool.after(&self.mount.inverse());
        std::array::from_fn(|i| {
            let [x, y, z] = last.rotation[i];
            [x, y, z, last.shift[i]]
        })
    }

    /// All postures of one way point; empty where it is out of reach or singular.
    pub(super) fn postures_at(&self, roller: &Roller, way: &Way) -> (Vec<Vec<f64>>, [f64; 2]) {
        let ask = Ask { redundancy: way[3], reference: self.reference, ..Ask::default() };
        match self.inverse.solve(&self.last_frame(roller, way), &ask) {
            Ok(found) if found.status == Status::Ok => (found.list.into_iter().map(|p| p.q).collect(), [0.0; 2]),
            // Singular: some joints are free there, and neighbours of the point decide. Nothing is
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

    /// The posture of a list nearest to another, whole turns taken off; `None` where all are far.
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

    /// The whole turn of a joint that is nearest to a position.
    fn turned(&self, joint: usize, q: f64, near: f64) -> f64 {
        use std::f64::consts::TAU;
        if self.slides[joint] { q } else { q + TAU * ((near - q) / TAU).round() }
    }

    /// One branch along the points, from a posture; the point where it was lost.
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
