//! `joint_elasticity`: the measured angle is the motor's, and a spring lies between it and the link.

use super::super::scene::Scene;
use super::{Cause, Kind, Shape, Sign, Term};

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

    fn grid(&self, _: &Scene<'_>, _: &[usize], _: &[Vec<f64>]) -> Vec<Vec<f64>> {
        vec![vec![1e-5]]
    }

    fn terms(&self, scene: &Scene<'_>, place: &[usize], shape: &[f64]) -> Vec<Term> {
        let j = place[0];
        let wound: Vec<f64> = scene.rigid[j].iter().map(|t| -t).collect();
        if wound.iter().all(|t| *t == 0.0) {
            return Vec::new();
        }
        let column = scene.column(scene.shifted(j, &wound, shape[0]));
        vec![Term::new("CE", column, Sign::Positive)]
    }

    fn secant(&self) -> bool {
        true
    }

    fn rests_on_model(&self) -> bool {
        true
    }

    fn says(&self) -> &'static str {
        "the link lags behind the measured angle in proportion to its torque, as behind a spring"
    }

    fn shown_by(&self) -> &'static str {
        "high accelerations with a payload, or the joint's resonance in a chirp"
    }
}
