//! Criteria to minimise: functions of `G = W' P W` (Pukelsheim, *Optimal Design of Experiments*,
//! chapter 6; Sun and Tsoi for Hadamard).
//!
//! The condition number is not differentiable where its largest or smallest singular value is
//! multiple, which is where minima tend to lie. Power means replace both:
//! `log l_max <= log(sum l^p) / p`, and the same for `1 / l_min`. The bound is smooth and tight up
//! to `log(B) / p`, and `p` grows while the solver runs.

use nalgebra::DMatrix;

/// Criterion of a motion; lower is better.
#[derive(Debug, Clone, PartialEq)]
pub enum Criterion {
    /// Condition number of `W`.
    Condition,
    /// `-log det(W' W)` (D-optimal: volume of the confidence ellipsoid).
    LogDet,
    /// `-log` of the product of the squared column norms.
    Hadamard,
    /// Trace of `(W' W)^-1` (A-optimal: sum of variances).
    Trace,
    /// `1 / l_min(W' W)` (E-optimal: largest variance of any combination).
    Smallest,
    /// Separation of two groups of columns: `-log det` of the part of each group that the columns
    /// outside it can't explain. The other columns belong to both.
    Separation(Vec<usize>, Vec<usize>),
}

/// Derivative with respect to `G`.
pub(super) enum Slope {
    Dense(DMatrix<f64>),
    /// Factored form, `u diag(d) u'`.
    Factored {
        u: DMatrix<f64>,
        d: Vec<f64>,
    },
}

impl Criterion {
    /// Name on the command line.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Condition => "cond",
            Self::LogDet => "logdet",
            Self::Hadamard => "hadamard",
            Self::Trace => "trace",
            Self::Smallest => "smallest",
            Self::Separation(..) => "separation",
        }
    }

    /// Powers of the smooth form, in ascending order; a single 1 if the criterion is already
    /// smooth.
    pub(super) fn powers(&self) -> &'static [f64] {
        match self {
            Self::Condition | Self::Smallest => &[4.0, 16.0, 64.0],
            _ => &[1.0],
        }
    }

    /// Whether the criterion can be evaluated from `G` without a spectrum, where products are
    /// accurate enough.
    pub(super) fn by_gram(&self) -> bool {
        self.ignores_scale() || *self == Self::Trace
    }

    /// Whether a factor per column only adds a constant.
    pub(super) fn ignores_scale(&self) -> bool {
        matches!(self, Self::LogDet | Self::Hadamard | Self::Separation(..))
    }

    /// Smooth value to minimise, from `G` without a spectrum.
    pub(super) fn of_gram(&self, gram: &DMatrix<f64>) -> Option<(f64, Slope)> {
        let n = gram.ncols();
        match self {
            Self::Hadamard => {
                let slope = DMatrix::from_fn(n, n, |i, k| if i == k { -1.0 / gram[(i, i)] } else { 0.0 });
                Some((-gram.diagonal().iter().map(|g| g.ln()).sum::<f64>(), Slope::Dense(slope)))
            }
            Self::LogDet => {
                let (log, inverse) = log_det(gram)?;
                Some((-log, Slope::Dense(-inverse)))
            }
            Self::Trace => {
                let (_, inverse) = log_det(gram)?;
                let trace = inverse.trace();
                Some((trace.ln(), Slope::Dense(&inverse * &inverse / -trace)))
            }
            Self::Separation(first, second) => {
                let (all, inverse) = log_det(gram)?;
                let (mut value, mut slope) = (-2.0 * all, -2.0 * inverse);
                for group in [first, second] {
                    let rest: Vec<usize> = (0..n).filter(|k| !group.contains(k)).collect();
                    let (log, inverse) = log_det(&gram.select_rows(&rest).select_columns(&rest))?;
                    value += log;
                    for (a, &i) in rest.iter().enumerate() {
                        for (b, &k) in rest.iter().enumerate() {
                            slope[(i, k)] += inverse[(a, b)];
                        }
                    }
                }
                Some((value, Slope::Dense(slope)))
            }
            _ => None,
        }
    }

    /// Smooth value to minimise with this power, from the singular values and right singular
    /// vectors of `W diag(scale)`.
    pub(super) fn of_spectrum(
        &self,
        sigma: &[f64],
        v: &DMatrix<f64>,
        scale: &[f64],
        gram: &DMatrix<f64>,
        p: f64,
    ) -> Option<(f64, Slope)> {
        let n = sigma.len();
        let lambda: Vec<f64> = sigma.iter().map(|s| s * s).collect();
        let (least, most) = lambda.iter().fold((f64::INFINITY, 0.0_f64), |(l, h), x| (l.min(*x), h.max(*x)));
        if !(least > 0.0 && most.is_finite()) {
            return None;
        }
        let high: Vec<f64> = lambda.iter().map(|l| (l / most).powf(p)).collect();
        let low: Vec<f64> = lambda.iter().map(|l| (least / l).powf(p)).collect();
        let (sum_high, sum_low) = (high.iter().sum::<f64>(), low.iter().sum::<f64>());
        // `d[i]`: lambda times the derivative with respect to lambda.
        let (value, d): (f64, Vec<f64>) = match self {
            Self::Condition => (
                0.5 * ((sum_high.ln() + sum_low.ln()) / p + most.ln() - least.ln()),
                (0..n).map(|i| 0.5 * (high[i] / sum_high - low[i] / sum_low)).collect(),
            ),
            Self::Smallest => (sum_low.ln() / p - least.ln(), (0..n).map(|i| -low[i] / sum_low).collect()),
            Self::Trace => {
                let sum: f64 = lambda.iter().map(|l| 1.0 / l).sum();
                (sum.ln(), lambda.iter().map(|l| -1.0 / (l * sum)).collect())
            }
            Self::LogDet => {
                let log_scale: f64 = scale.iter().map(|s| s.ln()).sum();
                (2.0 * log_scale - lambda.iter().map(|l| l.ln()).sum::<f64>(), vec![-1.0; n])
            }
            Self::Hadamard | Self::Separation(..) => return self.of_gram(gram),
        };
        let u = DMatrix::from_fn(n, n, |i, k| scale[i] * v[(i, k)] / sigma[k]);
        Some((value, Slope::Factored { u, d }))
    }

    /// Value for reports, from the spectrum or from the minimised value.
    pub fn reported(&self, conditions: &super::Conditions, minimised: f64) -> f64 {
        match self {
            Self::Condition => conditions.condition,
            Self::LogDet => -conditions.log_det,
            Self::Hadamard => -conditions.hadamard,
            Self::Trace | Self::Smallest => minimised.exp(),
            Self::Separation(..) => minimised,
        }
    }
}

/// `log det` and inverse, computed with columns scaled to unit norm.
pub(super) fn log_det(gram: &DMatrix<f64>) -> Option<(f64, DMatrix<f64>)> {
    let n = gram.ncols();
    let scale: Vec<f64> = gram.diagonal().iter().map(|g| 1.0 / g.sqrt()).collect();
    if scale.iter().any(|s| !s.is_finite()) {
        return None;
    }
    let unit = DMatrix::from_fn(n, n, |i, k| gram[(i, k)] * scale[i] * scale[k]);
    let factor = unit.cholesky()?;
    let log = 2.0 * factor.l_dirty().diagonal().iter().map(|l| l.ln()).sum::<f64>();
    let inverse = factor.inverse();
    let value = log - 2.0 * scale.iter().map(|s| s.ln()).sum::<f64>();
    Some((value, DMatrix::from_fn(n, n, |i, k| inverse[(i, k)] * scale[i] * scale[k])))
}
