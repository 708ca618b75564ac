//! Detects structure in residuals beyond noise that no cause explains.

use nalgebra::{DMatrix, DVector};

use super::evidence::short;
use crate::diagnose::fit::moments::pseudo_inverse;
use crate::diagnose::windows::windowed_data::{BLOCKS, JointSeries, WindowedData};

/// Part of one joint's residual that is not noise.
#[derive(Debug, Clone, PartialEq)]
pub struct Structure {
    /// Joint, from 0.
    pub joint: usize,
    /// Root mean square, N m.
    pub rms: f64,
    /// Description: the quantity with which it correlates.
    pub description: String,
}

/// Finds structure in residuals (zero where a window is not used). `noise`: standard deviation of
/// the raw torque, N m; `torque`: its root mean square, N m.
pub fn structure(scene: &WindowedData<'_>, residual: &[Vec<f64>], noise: &[f64], torque: &[f64]) -> Vec<Structure> {
    (0..scene.dof())
        .filter_map(|j| {
            let live: Vec<usize> = (0..scene.len).filter(|&w| scene.live[j][w]).collect();
            if live.len() < 100 {
                return None;
            }
            let e = &residual[j];
            let total = (live.iter().map(|&w| e[w] * e[w]).sum::<f64>() / live.len() as f64).sqrt();
            let least = (0.35 * noise[j]).max(0.004 * torque[j]);
            let slow = slow_part(scene, j, e);
            let maps = maps(scene, j);
            let mut best: Option<(f64, &'static str)> = None;
            for (name, columns) in &maps {
                let share = predicted_share(scene, &live, e, columns);
                if best.is_none_or(|(b, _)| share > b) {
                    best = Some((share, name));
                }
            }
            let (share, name) = best?;
            let mapped = total * share.max(0.0).sqrt();
            if mapped > least && share > 0.12 {
                let description = format!("{:.0} % of what is left of joint {} goes with {name}", 100.0 * share, j + 1);
                return Some(Structure { joint: j, rms: mapped, description });
            }
            if slow > (0.7 * noise[j]).max(0.006 * torque[j]) {
                let frequency = loudest(scene, j, e);
                let description = format!(
                    "joint {} keeps {} N m of slow error, strongest near {frequency:.2} Hz, that goes with nothing measured",
                    j + 1,
                    short(slow)
                );
                return Some(Structure { joint: j, rms: slow, description });
            }
            None
        })
        .collect()
}

/// Root mean square of the error that persists from one tenth of a second to the next, from the
/// covariance of consecutive means. Noise correlated over some hundredths only contributes nothing,
/// however much of it remains in each mean.
fn slow_part(scene: &WindowedData<'_>, j: usize, e: &[f64]) -> f64 {
    let m = ((0.1 / scene.step).round() as usize).max(3);
    let mean = |w: usize| {
        let span = w..w + m;
        scene.live[j][span.clone()].iter().all(|l| *l).then(|| e[span].iter().sum::<f64>() / m as f64)
    };
    let pairs = scene.runs.iter().flat_map(|run| (run.start..(run.end + 1).saturating_sub(2 * m)).step_by(m));
    let products: Vec<f64> = pairs.filter_map(|w| Some(mean(w)? * mean(w + m)?)).collect();
    if products.len() < 10 {
        return 0.0;
    }
    (products.iter().sum::<f64>() / products.len() as f64).max(0.0).sqrt()
}

/// Frequency of the largest line of the residual below 5 Hz, in the longest run, Hz.
fn loudest(scene: &WindowedData<'_>, j: usize, e: &[f64]) -> f64 {
    let Some(run) = scene.runs.iter().max_by_key(|r| r.len()) else { return 0.0 };
    let e: Vec<f64> = run.clone().map(|w| if scene.live[j][w] { e[w] } else { 0.0 }).collect();
    let seconds = e.len() as f64 * scene.step;
    let power = |f: f64| {
        let (mut c, mut s) = (0.0, 0.0);
        for (k, e) in e.iter().enumerate() {
            let (sin, cos) = (std::f64::consts::TAU * f * k as f64 * scene.step).sin_cos();
            (c, s) = (c + e * cos, s + e * sin);
        }
        c * c + s * s
    };
    (1..200)
        .map(|i| 0.5 * f64::from(i) / seconds)
        .take_while(|f| *f < 5.0)
        .max_by(|a, b| power(*a).total_cmp(&power(*b)))
        .unwrap_or(0.0)
}

/// A function of one joint's motion and the index of the sample.
type Of = fn(&JointSeries<'_>, usize) -> f64;

/// General families of functions of the measured quantities.
fn maps(scene: &WindowedData<'_>, j: usize) -> Vec<(&'static str, Vec<Vec<f64>>)> {
    let series =
        |f: &dyn Fn(&JointSeries<'_>, usize) -> f64| scene.own_series(j, |o| (0..o.v.len()).map(|k| f(o, k)).collect());
    let fastest = scene.fastest[j].max(1e-9);
    let load = scene.rigid[j].iter().fold(1e-9_f64, |m, t| m.max(t.abs()));
    let long = scene.time.iter().fold(1.0_f64, |m, t| m.max(*t));
    let mut maps = vec![(
        "its position",
        (1..=4)
            .flat_map(|k| {
                [series(&|o, s| (f64::from(k) * o.q[s]).sin()), series(&|o, s| (f64::from(k) * o.q[s]).cos())]
            })
            .collect::<Vec<_>>(),
    )];
    maps.push((
        "its position and direction",
        (1..=4)
            .flat_map(|k| {
                [
                    series(&|o, s| o.sign[s] * (f64::from(k) * o.q[s]).sin()),
                    series(&|o, s| o.sign[s] * (f64::from(k) * o.q[s]).cos()),
                ]
            })
            .collect(),
    ));
    let hat = |v: f64, i: i32| (1.0 - (6.0 * v / fastest - f64::from(i)).abs()).max(0.0);
    maps.push(("its velocity", (-6..=6).map(|i| series(&|o, s| hat(o.v[s], i))).collect()));
    maps.push((
        "its load",
        (1..=3)
            .flat_map(|k| {
                [
                    series(&|o, s| (o.load(s) / load).powi(k)),
                    series(&|o, s| o.sign[s] * (o.load(s) / load).abs().powi(k)),
                ]
            })
            .collect(),
    ));
    maps.push((
        "time",
        (1..=4)
            .flat_map(|k| {
                let phase = f64::from(k) * std::f64::consts::PI / long;
                [series(&|o, s| (phase * o.t(s)).cos()), series(&|o, s| o.sign[s] * (phase * o.t(s)).cos())]
            })
            .collect(),
    ));
    let own_acceleration = series(&|o, s| o.a[s]);
    let mut others = vec![own_acceleration];
    for k in (0..scene.dof()).filter(|k| *k != j) {
        for f in [(|o: &JointSeries<'_>, s: usize| o.sign[s]) as Of, |o, s| o.v[s], |o, s| o.a[s]] {
            let mut column: Vec<f64> = Vec::with_capacity(scene.len);
            for own in &scene.own[k] {
                column.extend(scene.average_of(own, |s| f(own, s)));
            }
            scene.masked(j, &mut column);
            others.push(column);
        }
    }
    maps.push(("the motion of other joints", others));
    maps
}

/// Share of the variance that a family predicts in each part of the data from the other parts.
fn predicted_share(scene: &WindowedData<'_>, live: &[usize], e: &[f64], columns: &[Vec<f64>]) -> f64 {
    let n = columns.len();
    let mut grams = vec![(DMatrix::<f64>::zeros(n, n), DVector::<f64>::zeros(n), 0.0); BLOCKS];
    let mut row = vec![0.0; n];
    for &w in live {
        for (r, c) in row.iter_mut().zip(columns) {
            *r = c[w];
        }
        let (gram, with, squares) = &mut grams[scene.block[w]];
        for i in 0..n {
            with[i] += row[i] * e[w];
            for k in 0..=i {
                gram[(i, k)] += row[i] * row[k];
            }
        }
        *squares += e[w] * e[w];
    }
    for (gram, ..) in &mut grams {
        for i in 0..n {
            for k in 0..i {
                gram[(k, i)] = gram[(i, k)];
            }
        }
    }
    let (mut left, mut all) = (0.0, 0.0);
    for part in 0..BLOCKS {
        let (mut gram, mut with) = (DMatrix::zeros(n, n), DVector::zeros(n));
        for (other, (g, b, _)) in grams.iter().enumerate() {
            if other != part {
                gram += g;
                with += b;
            }
        }
        // A ridge of a thousandth bounds the coefficients of nearly constant columns.
        for i in 0..n {
            gram[(i, i)] *= 1.001;
        }
        let x = pseudo_inverse(&gram) * with;
        let (g, b, squares) = &grams[part];
        left += squares - 2.0 * x.dot(b) + x.dot(&(g * &x));
        all += squares;
    }
    if all > 0.0 { 1.0 - left / all } else { 0.0 }
}
