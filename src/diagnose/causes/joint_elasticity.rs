//! `joint_elasticity`: the measured angle is the motor's, and a spring lies between it and the link.

use super::super::scene::Scene;
use super::{Cause, Estimate, Kind, Named, Over, Shape, Sign, Term};

/// Link angle `q - CE tau`, `CE = 1 / KE`.
pub struct JointElasticity;

impl Cause for JointElasticity {
    fn name(&self) -> &'static str {
        "joint_elasticity"
    }

    fn kind(&self) -> Kind {
        Kind::Transmission
    }

    fn shape(&self) -> &'static [Shape] {
        &[Shape { symbol: "step", unit: "rad/N m", range: [1e-9, 1.0], step: None }]
    }

    fn grid(&self, scene: &Scene<'_>, place: &[usize], _: &[Vec<f64>]) -> Vec<Vec<f64>> {
        let peak = scene.rigid[place[0]].iter().fold(0.0_f64, |m, t| m.max(t.abs())).max(1e-9);
        [1e-4, 2e-3, 1e-2].iter().map(|angle| vec![(angle / peak).clamp(1e-9, 1.0)]).collect()
    }

    fn terms(&self, scene: &Scene<'_>, place: &[usize], shape: &[f64]) -> Vec<Term> {
        let (j, compliance) = (place[0], shape[0]);
        if scene.rigid[j].iter().all(|t| *t == 0.0) {
            return Vec::new();
        }
        // The spring carries the link where the spring lets it be, and not where the motor is: one round of that.
        let first: Vec<f64> = scene.rigid[j].iter().map(|t| -t).collect();
        let change = scene.shifted(j, &first, compliance);
        let wound: Vec<f64> = scene.rigid[j].iter().zip(&change[j]).map(|(t, d)| -(t + compliance * d)).collect();
        vec![Term::new("CE", scene.column(scene.shifted(j, &wound, compliance)), Sign::Positive)]
    }

    fn secant(&self) -> bool {
        true
    }

    fn rests_on_model(&self) -> bool {
        true
    }

    fn named(&self, found: &Estimate<'_>) -> Vec<Named> {
        let compliance = found.x[0];
        vec![Named::new("KE", 1.0 / compliance, Some(found.std(0) / (compliance * compliance)))]
    }

    fn over(&self) -> Over {
        Over::Torque
    }

    fn says(&self) -> &'static str {
        "the link lags behind the measured angle in proportion to its torque, as behind a spring"
    }

    fn shown_by(&self) -> &'static str {
        "high accelerations with a payload, or the joint's resonance in a chirp"
    }
}
