//! `backlash`: a dead zone in the transmission: the link stands half the gap to the side to which its torque pushes it.

use super::super::scene::Scene;
use super::{Cause, Estimate, Kind, Named, Over, Shape, Sign, Term};

/// Link angle `q - (BL / 2) tanh(tau / TB)`; `TB` rounds the passage through the gap.
pub struct Backlash;

/// Whether the joint carries load to both sides, so that it passes through a gap.
pub(super) fn both_ways(scene: &Scene<'_>, j: usize) -> bool {
    let torque = &scene.rigid[j];
    let rms = (torque.iter().map(|t| t * t).sum::<f64>() / scene.len.max(1) as f64).sqrt();
    rms > 0.0 && torque.iter().any(|t| *t > 0.05 * rms) && torque.iter().any(|t| *t < -0.05 * rms)
}

impl Cause for Backlash {
    fn name(&self) -> &'static str {
        "backlash"
    }

    fn kind(&self) -> Kind {
        Kind::Transmission
    }

    fn shape(&self) -> &'static [Shape] {
        &[
            Shape { symbol: "step", unit: "rad", range: [1e-7, 1.0], step: None },
            Shape { symbol: "TB", unit: "", range: [1e-3, 0.4], step: Some(0.4) },
        ]
    }

    fn grid(&self, _: &Scene<'_>, _: &[usize], _: &[Vec<f64>]) -> Vec<Vec<f64>> {
        [0.02, 0.08, 0.3].iter().map(|share| vec![1e-4, *share]).collect()
    }

    fn shows(&self, scene: &Scene<'_>, place: &[usize], _: &[f64]) -> bool {
        both_ways(scene, place[0])
    }

    fn terms(&self, scene: &Scene<'_>, place: &[usize], shape: &[f64]) -> Vec<Term> {
        let j = place[0];
        let torque = &scene.rigid[j];
        let rms = (torque.iter().map(|t| t * t).sum::<f64>() / scene.len.max(1) as f64).sqrt();
        let gap: Vec<f64> = torque.iter().map(|t| -0.5 * (t / (shape[1] * rms).max(1e-12)).tanh()).collect();
        vec![Term::new("BL", scene.column(scene.shifted(j, &gap, shape[0])), Sign::Positive)]
    }

    fn secant(&self) -> bool {
        true
    }

    fn rests_on_model(&self) -> bool {
        true
    }

    fn named(&self, found: &Estimate<'_>) -> Vec<Named> {
        vec![found.term(0)]
    }

    fn over(&self) -> Over {
        Over::Torque
    }

    fn says(&self) -> &'static str {
        "the link jumps across a gap when the torque changes its direction"
    }

    fn shown_by(&self) -> &'static str {
        "motions in which the joint's torque changes its sign often, with and without a preload"
    }
}
