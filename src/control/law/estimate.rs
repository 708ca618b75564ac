//! The force without a sensor, equation (14): `F = (J')^+ (Gamma - Gamma_dyn)`, sample by sample.
//!
//! Positions and torques pass the same low-pass before anything else, so that model and measurement stay in step; velocity and acceleration
//! are backward differences of what comes out.

use super::least::{damped, solve};
use super::model::Body;

/// How the force is estimated.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EstimatorSettings<const N: usize> {
    /// Time between samples, s.
    pub period: f64,
    /// Corner of the low-pass (three equal poles), Hz.
    pub corner: f64,
    /// Weight of each joint's torque: one over the variance of its error.
    pub weights: [f64; N],
    /// Part of the mean eigenvalue of `J W J'` that is added to all: bounds the estimate near singular postures.
    pub damping: f64,
    /// Whether the contact may carry a moment. The paper's six components need it; a point or a roller that turns freely has none, and
    /// without it the force is better known.
    pub moment: bool,
}

/// What runs along with the arm.
#[derive(Debug, Clone)]
pub struct Estimator<B, const N: usize> {
    body: B,
    settings: EstimatorSettings<N>,
    /// Each pole of the low-pass moves by this share of the way in a period.
    share: f64,
    q: [[f64; N]; 3],
    tau: [[f64; N]; 3],
    before: [f64; N],
    speed: [f64; N],
    bias: [f64; N],
    seen: u32,
}

impl<B: Body<N>, const N: usize> Estimator<B, N> {
    /// With a model of the arm.
    pub fn new(body: B, settings: EstimatorSettings<N>) -> Self {
        // A pole at -w, by the backward rule: w T / (1 + w T).
        let turn = core::f64::consts::TAU * settings.corner * settings.period;
        Self {
            body,
            settings,
            share: turn / (1.0 + turn),
            q: [[0.0; N]; 3],
            tau: [[0.0; N]; 3],
            before: [0.0; N],
            speed: [0.0; N],
            bias: [0.0; N],
            seen: 0,
        }
    }

    /// The model, to look at or to change.
    pub fn body(&mut self) -> &mut B {
        &mut self.body
    }

    /// Torques that are to be taken for zero, N m: what was left in free motion.
    pub fn set_bias(&mut self, bias: [f64; N]) {
        self.bias = bias;
    }

    /// Torques of the environment at the joints, `Gamma - Gamma_dyn`, of a sample; `None` until the differences are there, and for a sample
    /// that is no number.
    pub fn external(&mut self, q: &[f64; N], tau: &[f64; N]) -> Option<[f64; N]> {
        if q.iter().chain(tau).any(|x| !x.is_finite()) {
            return None;
        }
        if self.seen == 0 {
            (self.q, self.tau, self.before) = ([*q; 3], [*tau; 3], *q);
        }
        let period = self.settings.period;
        for j in 0..N {
            for (stages, new) in [(&mut self.q, q[j]), (&mut self.tau, tau[j])] {
                let mut from = new;
                for stage in stages {
                    stage[j] += self.share * (from - stage[j]);
                    from = stage[j];
                }
            }
        }
        let (place, torque) = (self.q[2], self.tau[2]);
        let speed: [f64; N] = core::array::from_fn(|j| (place[j] - self.before[j]) / period);
        let change: [f64; N] = core::array::from_fn(|j| (speed[j] - self.speed[j]) / period);
        (self.before, self.speed) = (place, speed);
        self.seen = self.seen.saturating_add(1);
        let model = self.body.torques(&place, &speed, &change, period);
        (self.seen > 3).then(|| core::array::from_fn(|j| torque[j] - model[j] - self.bias[j]))
    }

    /// Wrench of the tool on what it touches, base axes, about the point of contact: force (N) and moment (N m).
    pub fn step(&mut self, q: &[f64; N], tau: &[f64; N]) -> Option<[f64; 6]> {
        let external = self.external(q, tau)?;
        let tool = self.body.tool(&self.before);
        let EstimatorSettings { weights, damping, moment, .. } = &self.settings;
        let mut right = [0.0; 6];
        for i in 0..6 {
            right[i] = (0..N).map(|j| tool.jacobian[i][j] * weights[j] * external[j]).sum();
        }
        if *moment {
            return damped(&tool.jacobian, weights, &right, *damping);
        }
        let mut a = [[0.0; 3]; 3];
        for i in 0..3 {
            for k in 0..=i {
                a[i][k] = (0..N).map(|j| tool.jacobian[i][j] * weights[j] * tool.jacobian[k][j]).sum();
            }
        }
        let trace: f64 = (0..3).map(|i| a[i][i]).sum();
        for i in 0..3 {
            a[i][i] += damping * trace / 3.0;
        }
        let force = solve(&mut a, &[right[0], right[1], right[2]], trace)?;
        Some([force[0], force[1], force[2], 0.0, 0.0, 0.0])
    }
}
