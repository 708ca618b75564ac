//! Tests whether the model is accurate enough for the uncertainty band to hold.
//!
//! The residual torque without contact, whitened by the predicted covariance as `z = L^-1 e`, has a
//! mean square of 1 per joint. Its mean over a run is less certain than that many samples suggest,
//! as a parameter error is the same at every sample. The mean's variance is
//! `2 sum_ts |L_t^-1 C_ts L_s^-T|^2 / M^2`, `C_ts = W_t C W_s' + [t = s] S`, over `M` instants
//! spaced far apart compared with the filter's memory. The mean is compared with the chi-square
//! distribution of the same mean and variance (Satterthwaite 1946). An arm with more than six
//! joints can also be checked during contact, on the part of the residual that no wrench explains.

use nalgebra::{DMatrix, DVector};
use statrs::distribution::{ContinuousCDF, Gamma};

/// Maximum number of instants; beyond it, every second one is dropped.
const MOST: usize = 128;
/// Probability below which the check fails: a correct model falls below it in one run of a
/// thousand.
const IMPROBABLE: f64 = 1e-3;
/// Probability below which the bands are in doubt: a correct model falls below it in one run of
/// twenty.
const UNCOMMON: f64 = 0.05;

/// Comparison of torque errors with their predicted covariance.
#[derive(Debug, Clone, PartialEq)]
pub struct Consistency {
    /// Number of instants compared.
    pub instants: usize,
    /// Mean square error relative to its prediction: 1 for a model that errs as predicted.
    pub ratio: f64,
    /// Probability of a ratio at least this large if the model errs as predicted.
    pub probability: f64,
    /// Root mean square of each joint's error relative to its prediction; zero where the check was
    /// not per joint.
    pub joints: Vec<f64>,
}

impl Consistency {
    /// Whether the model is accurate enough for the band to hold.
    pub fn holds(&self) -> bool {
        self.probability >= IMPROBABLE
    }

    /// Whether errors this large are common for a model that errs as predicted.
    pub fn is_common(&self) -> bool {
        self.probability >= UNCOMMON
    }

    /// Factor by which the band would have to be wider.
    pub fn widen(&self) -> f64 {
        self.ratio.max(0.0).sqrt()
    }
}

struct Instant {
    error: DVector<f64>,
    /// Parameter part of the error, `W L`, `n x rank`.
    model: DMatrix<f64>,
    variance: DVector<f64>,
    /// `J'`, `n x 6`, if only the part that no wrench explains is checked.
    push: Option<DMatrix<f64>>,
}

/// Collects instants for a [`Consistency`].
pub(super) struct Checker {
    spacing: f64,
    next: f64,
    segment: usize,
    instants: Vec<Instant>,
}

impl Checker {
    /// Creates an empty checker whose instants are at least `spacing` s apart.
    pub fn new(spacing: f64) -> Self {
        Self { spacing, next: f64::NEG_INFINITY, segment: usize::MAX, instants: Vec::new() }
    }

    /// Whether an instant at this time, s, is to be added.
    pub fn takes(&mut self, segment: usize, time: f64) -> bool {
        if segment != self.segment || time < self.next - 2.0 * self.spacing {
            (self.segment, self.next) = (segment, f64::NEG_INFINITY);
        }
        let wanted = time >= self.next;
        if wanted {
            self.next = time + self.spacing;
        }
        wanted
    }

    pub fn add(&mut self, error: &[f64], model: &DMatrix<f64>, variance: &[f64], push: Option<DMatrix<f64>>) {
        self.instants.push(Instant {
            error: DVector::from_column_slice(error),
            model: model.clone(),
            variance: DVector::from_column_slice(variance),
            push,
        });
        if self.instants.len() >= MOST {
            let mut keep = false;
            self.instants.retain(|_| {
                keep = !keep;
                keep
            });
            self.spacing *= 2.0;
        }
    }

    /// Compares the errors; `None` for fewer than three instants and without any information.
    pub fn finish(self) -> Option<Consistency> {
        let m = self.instants.len();
        let n = self.instants.first()?.error.len();
        if m < 3 {
            return None;
        }
        // Per instant: Q L^-1 W root, Q L^-1 S^(1/2); Q removes the part that a wrench explains.
        let (mut freedom, mut total) = (0.0, 0.0);
        let (mut models, mut noises) = (Vec::new(), Vec::new());
        let mut joints = vec![0.0; n];
        for i in &self.instants {
            let noise = DMatrix::from_diagonal(&i.variance);
            let covariance = &i.model * i.model.transpose() + &noise;
            let root = covariance.clone().cholesky()?.unpack();
            let solve = |b: &DMatrix<f64>| root.solve_lower_triangular(b);
            let mut white = DMatrix::from_column_slice(n, 1, i.error.as_slice());
            white = solve(&white)?;
            let mut model = solve(&i.model)?;
            let mut rest = solve(&noise.map(f64::sqrt))?;
            let mut rank = n as f64;
            if let Some(push) = &i.push {
                let left = solve(push)?.svd(true, false);
                let most = left.singular_values.max();
                let u = left.u?;
                for k in (0..left.singular_values.len()).filter(|&k| left.singular_values[k] > 1e-9 * most) {
                    let axis = u.column(k).into_owned();
                    for part in [&mut white, &mut model, &mut rest] {
                        let along = axis.transpose() * &*part;
                        *part -= &axis * along;
                    }
                    rank -= 1.0;
                }
            } else {
                for (j, sum) in joints.iter_mut().enumerate() {
                    *sum += i.error[j] * i.error[j] / covariance[(j, j)] / m as f64;
                }
            }
            freedom += rank;
            total += white.norm_squared();
            models.push(model);
            noises.push(rest);
        }
        if freedom <= 0.0 {
            return None;
        }
        let mut spread = 0.0;
        for t in 0..m {
            for s in 0..=t {
                let mut shared = &models[t] * models[s].transpose();
                if s == t {
                    shared += &noises[t] * noises[t].transpose();
                }
                spread += if s == t { 1.0 } else { 2.0 } * shared.norm_squared();
            }
        }
        let ratio = total / freedom;
        let variance = 2.0 * spread / (freedom * freedom);
        let probability = Gamma::new(1.0 / variance, 1.0 / variance).map_or(1.0, |law| law.sf(ratio));
        joints.iter_mut().for_each(|j| *j = j.sqrt());
        (ratio.is_finite()).then_some(Consistency { instants: m, ratio, probability, joints })
    }
}
