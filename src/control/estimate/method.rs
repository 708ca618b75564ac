//! Estimators for an arm whose number of joints is known only at run time.

use super::Kalman;
use super::Momentum;
use super::Residual;
use super::Weights;
use super::sample::{Estimate, EstimatorInput, ForceEstimator, Scale};

/// Estimator of the wrench.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Method {
    /// Equation (14), joints weighted by their uncertainty.
    #[default]
    Residual,
    /// Equation (14) with equal joint weights, as in the paper.
    Plain,
    /// The generalised-momentum observer.
    Momentum,
    /// The Kalman filter.
    Kalman,
}

impl Method {
    /// All methods with their names.
    pub const ALL: [(&'static str, Self); 4] =
        [("residual", Self::Residual), ("plain", Self::Plain), ("momentum", Self::Momentum), ("kalman", Self::Kalman)];

    /// Name of the method.
    pub fn name(self) -> &'static str {
        Self::ALL.iter().find(|(_, m)| *m == self).map_or("", |(name, _)| name)
    }

    /// Whether the method is an observer: it reads every sample and needs no acceleration.
    pub fn observes(self) -> bool {
        matches!(self, Self::Momentum | Self::Kalman)
    }
}

/// Maximum number of joints.
pub const MOST_JOINTS: usize = 12;

/// Tuning of the estimators; slices have one entry per joint.
pub(super) struct Tuning<'a> {
    pub noise: &'a [f64],
    pub density: &'a [f64],
    pub velocity: &'a [f64],
    pub gain: f64,
    pub scale: Scale,
    pub wander: Scale,
}

/// One sample as slices: like [`EstimatorInput`], matrices row-major.
#[derive(Default, Clone)]
pub(super) struct Row {
    pub dt: f64,
    pub tau: Vec<f64>,
    pub dq: Vec<f64>,
    pub model: Vec<f64>,
    pub bias: Vec<f64>,
    pub mass: Vec<f64>,
    pub jacobian: Vec<f64>,
    pub covariance: Vec<f64>,
    pub static_friction: Vec<f64>,
    pub breakaway: Vec<f64>,
}

pub(super) trait Steps {
    fn step(&mut self, row: &Row) -> Estimate;
}

struct Fixed<const N: usize, E>(E);

fn vector<const N: usize>(values: &[f64]) -> [f64; N] {
    std::array::from_fn(|j| values.get(j).copied().unwrap_or(0.0))
}

impl<const N: usize, E: ForceEstimator<N>> Steps for Fixed<N, E> {
    fn step(&mut self, row: &Row) -> Estimate {
        self.0.step(&EstimatorInput {
            dt: row.dt,
            tau: vector(&row.tau),
            dq: vector(&row.dq),
            model: vector(&row.model),
            bias: vector(&row.bias),
            mass: std::array::from_fn(|i| vector(row.mass.get(i * N..).unwrap_or(&[]))),
            jacobian: std::array::from_fn(|i| vector(row.jacobian.get(i * N..).unwrap_or(&[]))),
            covariance: std::array::from_fn(|i| vector(row.covariance.get(i * N..).unwrap_or(&[]))),
            static_friction: vector(&row.static_friction),
            breakaway: vector(&row.breakaway),
        })
    }
}

fn fixed<const N: usize>(method: Method, t: &Tuning<'_>) -> Box<dyn Steps> {
    let mut residual = Residual::<N>::new(vector(t.noise), t.scale);
    match method {
        Method::Residual => Box::new(Fixed::<N, _>(residual)),
        Method::Plain => {
            // Moments scaled by half a metre: only singularities have singular values as small.
            residual.weights = Weights::Equal { damping: 0.01 };
            Box::new(Fixed::<N, _>(residual))
        }
        Method::Momentum => {
            Box::new(Fixed::<N, _>(Momentum::<N>::new(t.gain, vector(t.density), vector(t.velocity), t.scale)))
        }
        Method::Kalman => {
            Box::new(Fixed::<N, _>(Kalman::<N>::new(vector(t.density), vector(t.velocity), t.scale, t.wander)))
        }
    }
}

/// Creates the estimator for `dof` joints; `None` for 0 and for more than [`MOST_JOINTS`].
pub(super) fn steps(dof: usize, method: Method, tuning: &Tuning<'_>) -> Option<Box<dyn Steps>> {
    let make = match dof {
        1 => fixed::<1>,
        2 => fixed::<2>,
        3 => fixed::<3>,
        4 => fixed::<4>,
        5 => fixed::<5>,
        6 => fixed::<6>,
        7 => fixed::<7>,
        8 => fixed::<8>,
        9 => fixed::<9>,
        10 => fixed::<10>,
        11 => fixed::<11>,
        12 => fixed::<12>,
        _ => return None,
    };
    Some(make(method, tuning))
}
