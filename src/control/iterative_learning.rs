//! Iterative learning control: the force errors of one coat give a displacement for the next (S.
//! Arimoto, S. Kawamura and F. Miyazaki, J. Robotic Systems 1, 1984; with the model inverted where
//! it is valid: D. Bristow, M. Tharayil and A. Alleyne, IEEE Control Systems 26, 2006).
//!
//! A force loop cannot follow fast errors because of its low-pass and the arm's mass on the wall.
//! These errors repeat at the same place of the same motion: gear ripple, friction at reversals,
//! drag. `T(w)` is the linear model's response of the force to a displacement added to the closed
//! loop. The error `e` of a coat (desired minus feedback force) adds `L e` on the next,
//! `L = g Q T* / (|T|^2 + r^2)`. The filter is non-causal, as learning takes place after the coat.
//! Of an error that follows the model, `1 - g Q |T|^2 / (|T|^2 + r^2)` remains. With `g` of 0.6 the
//! error still decreases where the arm's response is up to three times its model's, or 60 degrees
//! off in phase. `Q` ends where the model of rigid joints does.
//!
//! Learning is outside the loop, so gains and margins do not change. `T` varies along a motion; it
//! is interpolated between the neighbouring postures.

use std::f64::consts::{PI, TAU};

use nalgebra::Complex;

use super::gains::ForcePlant;

/// Displacement along the normal learned from a coat, over the time since painting began.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Learned {
    /// Time between values, s.
    pub period: f64,
    /// Displacement at each instant, m.
    pub displacement: Vec<f64>,
}

/// Shortest time between values, s: ten values or more in a period of the highest learned
/// frequency.
const PERIOD: f64 = 0.01;
/// Frequency up to which errors are learned in full, and that above which they are not, Hz.
const BAND: [f64; 2] = [3.0, 6.0];
/// Speed of the fastest joint below which nothing is learned, and above which errors are learned in
/// full, rad/s. The learned displacement moves joints by some 0.02 rad/s. Where the plan is not
/// much faster, friction reverses, sticks and breaks away, which a linear model does not describe.
const PACE: [f64; 2] = [0.05, 0.15];
/// Share of the model's correction that a coat receives, `g`: learning converges for an arm whose
/// response is up to three times its model's.
const SHARE: f64 = 0.6;
/// Regularisation `r`, relative to the largest response.
const FLOOR: f64 = 0.05;
/// Largest learned displacement, m; beyond it the cause is no model error.
const MOST: f64 = 5e-3;
/// Reach of an error's effect to either side, s. [`EDGE`] is the time in which the learned
/// displacement rises at its beginning and falls at its end, s.
const REACH: f64 = 4.0;
const EDGE: f64 = 0.2;

impl Learned {
    /// Displacement at a time, m; zero before and after the coat.
    pub fn at(&self, t: f64) -> f64 {
        let x = t / self.period;
        if !(0.0..self.displacement.len() as f64).contains(&x) {
            return 0.0;
        }
        let k = x as usize;
        let value = |k: usize| self.displacement.get(k).copied().unwrap_or(0.0);
        value(k) + (x - k as f64) * (value(k + 1) - value(k))
    }
}

/// Computes the displacement for the next coat: that of this one (`before`) plus the correction
/// from its errors. `error`, N, has one value per `period` s; values that are not finite are
/// skipped. `pace` is the planned speed of the fastest joint at the same instants, rad/s. `plants`
/// are evenly spaced in time along the motion, under the force loop's gains `kp`, `ki`. `None`
/// without a model, or where no displacement changes the force.
pub fn learned(
    plants: &[ForcePlant],
    [kp, ki]: [f64; 2],
    error: &[f64],
    pace: &[f64],
    period: f64,
    before: Option<&Learned>,
) -> Option<Learned> {
    let block = ((PERIOD / period).round() as usize).max(1);
    let step = block as f64 * period;
    let reach = (REACH / step) as i64;
    let kernels: Option<Vec<Vec<f64>>> = plants.iter().map(|plant| kernel(plant, [kp, ki], step, reach)).collect();
    let kernels = kernels.filter(|k| !k.is_empty())?;
    // A mean belongs to the middle of its block: the value at `k` is that of the two halves around
    // it.
    let half = block / 2;
    let mean = |k: usize| {
        let part =
            &error[(k * block).saturating_sub(half).min(error.len())..(k * block + block - half).min(error.len())];
        let sum: f64 = part.iter().filter(|e| e.is_finite()).sum();
        sum / part.len().max(1) as f64
    };
    let count = error.len().div_ceil(block);
    let means: Vec<f64> = (0..count)
        .map(|k| {
            let now = pace.get(k * block).copied().unwrap_or(0.0);
            rise((now - PACE[0]) / (PACE[1] - PACE[0])) * mean(k)
        })
        .collect();
    let displacement = (0..count).map(|k| {
        let along = (kernels.len() - 1) as f64 * k as f64 / count as f64;
        let (first, share) = (along as usize, along.fract());
        let of = |kernel: &Vec<f64>| -> f64 {
            (-reach..=reach)
                .filter_map(|m| {
                    let from = usize::try_from(k as i64 - m).ok()?;
                    Some(kernel[(m + reach) as usize] * means.get(from)?)
                })
                .sum()
        };
        let more = (1.0 - share) * of(&kernels[first]) + share * kernels.get(first + 1).map_or(0.0, of);
        let t = k as f64 * step;
        let edge = rise(t.min((count - 1) as f64 * step - t) / EDGE);
        (before.map_or(0.0, |b| b.at(t)) + edge * more).clamp(-MOST, MOST)
    });
    Some(Learned { period: step, displacement: displacement.collect() })
}

/// Smooth step from 0 at 0 to 1 at 1, with zero slope at both.
fn rise(x: f64) -> f64 {
    let x = x.clamp(0.0, 1.0);
    x * x * (3.0 - 2.0 * x)
}

/// `L` in the time domain: weights of the errors from `reach` steps later (first) to `reach` steps
/// earlier.
fn kernel(plant: &ForcePlant, [kp, ki]: [f64; 2], step: f64, reach: i64) -> Option<Vec<f64>> {
    // Frequency spacing so small that the kernel's end does not overlap its beginning.
    let apart = PI / (reach as f64 * step);
    let frequencies: Vec<f64> = (1..).map(|k| f64::from(k) * apart).take_while(|w| *w < TAU * BAND[1]).collect();
    let answers = plant.response_to_displacement(kp, ki, &frequencies)?;
    let most = answers.iter().map(|t| t.norm()).fold(0.0, f64::max);
    if !(most > 0.0 && most.is_finite()) {
        return None;
    }
    let inverse: Vec<Complex<f64>> = frequencies
        .iter()
        .zip(&answers)
        .map(|(w, t)| {
            let within = rise((BAND[1] - w / TAU) / (BAND[1] - BAND[0]));
            t.conj() * (SHARE * within / (t.norm_sqr() + (FLOOR * most).powi(2)))
        })
        .collect();
    let at = |m: i64| {
        let t = m as f64 * step;
        let window = 0.5 * (1.0 + (PI * m as f64 / reach as f64).cos());
        let sum: f64 = frequencies.iter().zip(&inverse).map(|(w, l)| l.re * (w * t).cos() - l.im * (w * t).sin()).sum();
        window * sum * apart * step / PI
    };
    Some((-reach..=reach).map(at).collect())
}
