//! Independent differentiation of recorded positions: a cubic through the neighbours of each sample
//! (Savitzky and Golay 1964, at the samples' own times).

use nalgebra::{Matrix4, Vector4};

use crate::model::States;

/// Half-width of the neighbourhood, s; `LEAST` is the smallest number of samples in it.
const HALF: f64 = 0.06;
const LEAST: usize = 5;

/// States of samples at times `t`, s, with positions `q`, one row per joint; a segment begins at
/// each of `starts`.
pub(super) fn states(t: &[f64], q: &[Vec<f64>], starts: &[usize]) -> States {
    let (len, dof) = (t.len(), q.len());
    let mut states = States { len, q: q.concat(), dq: vec![0.0; dof * len], ddq: vec![0.0; dof * len] };
    for segment in segments(starts, len) {
        let (mut low, mut high) = (segment.start, segment.start);
        for k in segment.clone() {
            while t[k] - t[low] > HALF && k - low > LEAST {
                low += 1;
            }
            while high < segment.end && (t[high] - t[k] <= HALF || high <= k + LEAST) {
                high += 1;
            }
            // About fifty neighbours are as accurate as five hundred.
            let step = ((high - low) / 50).max(1);
            let at: Vec<usize> = (low..high).step_by(step).collect();
            let scale = (t[high - 1] - t[k]).max(t[k] - t[low]).max(1e-9);
            let Some(rows) = slopes(t, k, &at, scale) else { continue };
            for (j, q) in q.iter().enumerate() {
                let [mut first, mut second] = [0.0; 2];
                for (&i, row) in at.iter().zip(&rows) {
                    first += row[0] * (q[i] - q[k]);
                    second += row[1] * (q[i] - q[k]);
                }
                states.dq[j * len + k] = first / scale;
                states.ddq[j * len + k] = 2.0 * second / (scale * scale);
            }
        }
    }
    states
}

/// Ranges of samples between the starts.
pub(super) fn segments(starts: &[usize], len: usize) -> Vec<std::ops::Range<usize>> {
    let mut edges: Vec<usize> = std::iter::once(0).chain(starts.iter().copied()).chain([len]).collect();
    edges.sort_unstable();
    edges.dedup();
    edges.windows(2).map(|w| w[0]..w[1]).collect()
}

/// Contribution of each neighbour to the linear and the quadratic coefficient of the cubic about
/// sample `k`.
fn slopes(t: &[f64], k: usize, at: &[usize], scale: f64) -> Option<Vec<[f64; 2]>> {
    let powers = |i: usize| {
        let u = (t[i] - t[k]) / scale;
        (Vector4::new(1.0, u, u * u, u * u * u), (1.0 - 0.9 * u.abs().powi(3)).powi(3))
    };
    let normal: Matrix4<f64> = at.iter().map(|&i| powers(i)).map(|(p, w)| p * p.transpose() * w).sum();
    let inverse = normal.try_inverse()?;
    let rows = at.iter().map(|&i| powers(i)).map(|(p, w)| {
        let c = inverse * p * w;
        [c[1], c[2]]
    });
    Some(rows.collect())
}
