//! `time_delay`: torque and motion are not sampled at the same time.

use super::super::scene::{MOST_DELAY, Scene};
use super::{Cause, Kind, Shape, Sign, Term};

/// `tau(t)` belongs to the motion at `t - TD`: of one joint, or of all.
pub struct TimeDelay;

impl Cause for TimeDelay {
    fn name(&self) -> &'static str {
        "time_delay"
    }

    fn kind(&self) -> Kind {
        Kind::Measurement
    }

    fn places(&self, scene: &Scene<'_>) -> Vec<Vec<usize>> {
        std::iter::once(Vec::new()).chain((0..scene.dof()).map(|j| vec![j])).collect()
    }

    fn shape(&self) -> &'static [Shape] {
        &[Shape { symbol: "step", unit: "s", range: [-MOST_DELAY, MOST_DELAY], step: None }]
    }

    fn grid(&self, _: &Scene<'_>, _: &[usize], _: &[Vec<f64>]) -> Vec<Vec<f64>> {
        [0.002, 0.01, 0.03, 0.06, -0.01, -0.03].iter().map(|d| vec![*d]).collect()
    }

    fn terms(&self, scene: &Scene<'_>, place: &[usize], shape: &[f64]) -> Vec<Term> {
        let rows = (0..scene.dof())
            .map(|j| {
                if !place.is_empty() && place[0] != j {
                    return vec![0.0; scene.len];
                }
                let late = scene.later(&scene.whole[j], shape[0]);
                late.iter().zip(&scene.whole[j]).map(|(a, b)| (a - b) / shape[0]).collect()
            })
            .collect();
        let column = scene.column(rows);
        if column.rows.is_empty() {
            return Vec::new();
        }
        vec![Term::new("TD", column, Sign::Any)]
    }

    fn secant(&self) -> bool {
        true
    }

    fn rests_on_model(&self) -> bool {
        true
    }

    fn rests_on_friction(&self) -> bool {
        true
    }

    fn plausible(&self, scene: &Scene<'_>, place: &[usize], _: &[f64], x: &[f64]) -> bool {
        let already = |j: usize| scene.delays[j];
        let all: Vec<usize> = if place.is_empty() { (0..scene.dof()).collect() } else { place.to_vec() };
        all.iter().all(|&j| (already(j) + x[0]).abs() <= MOST_DELAY)
    }

    fn moves_time(&self) -> bool {
        true
    }

    fn says(&self) -> &'static str {
        "the torque is late against the motion"
    }

    fn shown_by(&self) -> &'static str {
        "the same motion at half and at double the speed"
    }
}
