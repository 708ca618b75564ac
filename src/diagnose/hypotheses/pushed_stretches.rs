//! Stretches of the data in which a constant force may act.

use std::ops::Range;

use nalgebra::{Matrix3, Vector3};

use super::external_contact::{BRIEFEST, CONSTANT};
use crate::diagnose::windows::postures::parts;
use crate::diagnose::windows::windowed_data::WindowedData;
use crate::model::Contact;
use crate::numerics::median::median;

/// A stretch in which a constant force may act.
pub(super) struct Stretch {
    pub(super) windows: Range<usize>,
    pub(super) contact: Contact,
    /// Its gain there relative to that of a force in most other stretches of the same length.
    pub(super) worth: f64,
}

/// Begin and end of a range of windows, s.
pub(super) fn ends(scene: &WindowedData<'_>, windows: &Range<usize>) -> [f64; 2] {
    [windows.start, windows.end].map(|w| w as f64 * scene.step)
}

/// Begin and end of a swelling push that resembles a constant one in these windows, within their
/// recording, s.
pub(super) fn swelling(scene: &WindowedData<'_>, windows: &Range<usize>) -> [f64; 2] {
    let [start, end] = ends(scene, windows);
    let lead = 0.5 * (1.0 / CONSTANT - 1.0) * (end - start);
    let run = scene.runs.iter().find(|run| run.start <= windows.start && windows.end <= run.end);
    let [first, last] = run.map_or([start, end], |run| ends(scene, run));
    [(start - lead).max(first), (end + lead).min(last)]
}

/// The best of the possible stretches of each length (begin and end in s). Its gain is compared with
/// the upper quartile of all stretches of the same length, and penalised by their number.
pub(super) fn pushed_stretches(
    scene: &WindowedData<'_>,
    residual: &[Vec<f64>],
    contact: Contact,
    possible: &dyn Fn([f64; 2]) -> bool,
) -> Vec<Stretch> {
    let (n, dof) = (scene.len, scene.dof());
    let weight: Vec<f64> = residual.iter().map(|row| quiet(row)).collect();
    let mut sums: Vec<(Matrix3<f64>, Vector3<f64>)> = Vec::with_capacity(n + 1);
    let mut sum = (Matrix3::zeros(), Vector3::zeros());
    sums.push(sum);
    for part in parts(n) {
        let unit = scene.wrenches(part.clone(), contact);
        for w in part.clone() {
            for j in (0..dof).filter(|&j| scene.live[j][w]) {
                let row = Vector3::from_fn(|c, _| -unit[(c * dof + j) * part.len() + w - part.start]);
                sum.0 += weight[j] * row * row.transpose();
                sum.1 += weight[j] * residual[j][w] * row;
            }
            sums.push(sum);
        }
    }
    let least = sum.0.trace() * 1e-6 / n.max(1) as f64;
    let gain = |start: usize, length: usize| {
        let (normal, right) = (sums[start + length].0 - sums[start].0, sums[start + length].1 - sums[start].1);
        let normal = normal + Matrix3::identity() * (least * length as f64 + f64::MIN_POSITIVE);
        normal.cholesky().map_or(0.0, |l| right.dot(&l.solve(&right)))
    };
    let mut found = Vec::new();
    let mut length = (BRIEFEST / scene.step).ceil().max(4.0) as usize;
    while length <= n / 2 {
        let starts =
            |run: &Range<usize>| (run.start..(run.end + 1).saturating_sub(length)).step_by((length / 8).max(1));
        let mut all: Vec<(f64, usize)> =
            scene.runs.iter().flat_map(starts).map(|start| (gain(start, length), start)).collect();
        all.sort_by(|a, b| a.0.total_cmp(&b.0));
        let is_possible = |start: usize| possible(ends(scene, &(start..start + length)));
        if let Some(&(gain, start)) = all.iter().rev().find(|(_, start)| is_possible(*start)) {
            let usual = all[all.len() * 3 / 4].0 * (1.0 + n as f64 / length as f64).ln();
            let worth = gain / usual.max(f64::MIN_POSITIVE);
            found.push(Stretch { windows: start..start + length, contact, worth });
        }
        length = (length * 4 / 3).max(length + 1);
    }
    found
}

/// Inverse of the median of a joint's squared residual, which a short push does not affect.
pub(super) fn quiet(row: &[f64]) -> f64 {
    let mut sizes: Vec<f64> = row.iter().map(|e| e * e).filter(|e| *e > 0.0).collect();
    median(&mut sizes).map_or(0.0, |median| 1.0 / median)
}
