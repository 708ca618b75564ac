//! A force that explains changes of the torques of a standing arm.

use nalgebra::{Matrix3, Vector3};

use crate::diagnose::select::measure::LEVER;
use crate::model::Contact;

/// What a change of the torques at rest is compared with.
pub(super) struct Usual {
    /// Typical size of such a change, N m, per joint.
    pub(super) size: Vec<f64>,
    /// Number of parts at rest without the push.
    pub(super) parts: f64,
}

/// A force that explains changes of the torques at rest.
#[derive(Debug, Clone)]
pub(super) struct Force {
    pub(super) contact: Contact,
    /// Along the axes of the base, N.
    pub(super) newtons: Vector3<f64>,
    /// Standard deviations, N.
    pub(super) std: Vector3<f64>,
    /// Torques that it leaves, N m.
    pub(super) left: Vec<f64>,
    /// Twice its gain in log-likelihood.
    pub(super) gain: f64,
    /// The same without the joint on which it gains most.
    pub(super) elsewhere: f64,
    /// Share of the squared change that it explains.
    pub(super) share: f64,
    /// Number of its unknowns.
    pub(super) unknowns: f64,
}

impl Usual {
    /// Twice the loss in log-likelihood by a change of joint `j` that friction does not bear: those of
    /// other parts at rest have a Student distribution. `lever`: further error of its torque, N m.
    fn loss(&self, j: usize, size: f64, friction: &[f64], lever: f64) -> f64 {
        let beyond = (size.abs() - friction[j]).max(0.0) / self.size[j].hypot(lever);
        (self.parts + 1.0) * (beyond * beyond / self.parts).ln_1p()
    }

    /// The force at `contact` that explains changes best. `unit`: torques of unit forces, by axis.
    pub(super) fn force(&self, sizes: &[f64], friction: &[f64], contact: Contact, unit: &[f64]) -> Option<Force> {
        let dof = sizes.len();
        // Where on its link a push acts is known roughly.
        let lever = LEVER * sizes.iter().fold(0.0_f64, |most, size| most.max(size.abs()));
        let row = |j: usize| Vector3::from_fn(|c, _| -unit[c * dof + j]);
        let weight = |j: usize| 1.0 / (self.size[j].powi(2) + friction[j].powi(2) + lever * lever);
        let (mut normal, mut right) = (Matrix3::zeros(), Vector3::zeros());
        for j in 0..dof {
            normal += weight(j) * row(j) * row(j).transpose();
            right += weight(j) * sizes[j] * row(j);
        }
        let inverse = (normal + Matrix3::identity() * (1e-9 * normal.trace())).try_inverse()?;
        let newtons = inverse * right;
        let left: Vec<f64> = (0..dof).map(|j| sizes[j] - row(j).dot(&newtons)).collect();
        // The tolerance for the lever is no gain: a joint gains by the share that the force explains.
        let explained = |j: usize| (1.0 - (left[j] / sizes[j]).powi(2)).max(0.0);
        let gain = |j: usize| match self.loss(j, sizes[j], friction, 0.0) - self.loss(j, left[j], friction, lever) {
            gain if gain > 0.0 => gain * explained(j),
            loss => loss,
        };
        let gains: Vec<f64> = (0..dof).map(gain).collect();
        let squares = |x: &[f64]| x.iter().enumerate().map(|(j, x)| weight(j) * x * x).sum::<f64>();
        let gain: f64 = gains.iter().sum();
        Some(Force {
            contact,
            newtons,
            std: inverse.diagonal().map(|variance| variance.max(0.0).sqrt()),
            gain,
            elsewhere: gain - gains.iter().copied().fold(0.0, f64::max),
            share: 1.0 - squares(&left) / squares(sizes).max(f64::MIN_POSITIVE),
            unknowns: (0..dof).filter(|&j| row(j).norm() > 0.0).count().min(3) as f64,
            left,
        })
    }
}
