//! `time_delay`: torque and motion are not sampled at the same time.

use dh_codegen::robot::EffectKind;
use dh_codegen::robot::effects;

use super::Estimate;
use super::Hypothesis;
use super::Kind;
use super::Named;
use super::Over;
use super::Scope;
use super::Shape;
use super::Sign;
use super::Symbol;
use super::Term;
use crate::diagnose::windows::windowed_data::{MOST_DELAY, WindowedData};

/// `tau(t)` belongs to the motion at `t - TD`: of one joint, or of all.
pub struct TimeDelay;

/// Median of the delays: that of most joints.
fn common(delays: &[f64]) -> f64 {
    let mut sorted = delays.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted.get(sorted.len() / 2).copied().unwrap_or(0.0)
}

impl Hypothesis for TimeDelay {
    fn effect(&self) -> EffectKind {
        EffectKind::TimeDelay
    }

    fn kind(&self) -> Kind {
        Kind::Measurement
    }

    fn follows_acceleration(&self) -> bool {
        true
    }

    fn scope(&self) -> Scope {
        Scope::JointOrRobot
    }

    fn shape(&self) -> &'static [Shape] {
        &[Shape { symbol: Symbol::Own("step"), unit: "s", range: [-MOST_DELAY, MOST_DELAY], step: None }]
    }

    fn grid(&self, _: &WindowedData<'_>, _: &[usize], _: &[Vec<f64>]) -> Vec<Vec<f64>> {
        [0.002, 0.01, 0.03, 0.06, -0.01, -0.03].iter().map(|d| vec![*d]).collect()
    }

    fn terms(&self, scene: &WindowedData<'_>, place: &[usize], shape: &[f64]) -> Vec<Term> {
        let rows = (0..scene.dof())
            .map(|j| {
                if !place.is_empty() && place[0] != j {
                    return vec![0.0; scene.len];
                }
                // With a delay shorter than a window, no step of friction enters a used window.
                let torque = if shape[0].abs() < scene.step { &scene.smooth[j] } else { &scene.whole[j] };
                let late = scene.delayed(torque, shape[0]);
                late.iter().zip(&**torque).map(|(a, b)| (a - b) / shape[0]).collect()
            })
            .collect();
        let column = scene.column(rows);
        if column.rows.is_empty() {
            return Vec::new();
        }
        vec![Term::new(effects::TimeDelay::TD, column, Sign::Any)]
    }

    fn finite_difference(&self) -> bool {
        true
    }

    fn rests_on_model(&self) -> bool {
        true
    }

    fn rests_on_friction(&self) -> bool {
        true
    }

    fn plausible(&self, scene: &WindowedData<'_>, place: &[usize], _: &[f64], x: &[f64]) -> bool {
        let own: Vec<usize> = if place.is_empty() { (0..scene.dof()).collect() } else { place.to_vec() };
        own.iter().all(|&j| (scene.delays[j] + x[0]).abs() <= MOST_DELAY)
            && self.above_resolution(scene, place, x)[0] > 0.0
    }

    /// Beyond half a sample, the resolution of sampling times; for one joint relative to the
    /// others.
    fn above_resolution(&self, scene: &WindowedData<'_>, place: &[usize], x: &[f64]) -> Vec<f64> {
        let late = match place {
            [] => common(&scene.delays) + x[0],
            [j, ..] => scene.delays[*j] + x[0] - common(&[&scene.delays[..*j], &scene.delays[j + 1..]].concat()),
        };
        vec![(late.abs() - 0.5 * scene.period).max(0.0)]
    }

    fn moves_time(&self) -> bool {
        true
    }

    fn named(&self, found: &Estimate<'_>) -> Vec<Named> {
        let delay = found.place.first().map_or_else(|| common(&found.scene.delays), |j| found.scene.delays[*j]);
        vec![Named::new(effects::TimeDelay::TD, delay + found.x[0], Some(found.std(0)))]
    }

    fn over(&self) -> Over {
        Over::Velocity
    }

    fn says(&self) -> &'static str {
        "the torque is late against the motion"
    }

    fn shown_by(&self) -> &'static str {
        "the same motion at half and at double the speed"
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_common_delay_is_that_of_most_joints() {
        assert_eq!(common(&[0.004, 0.004, 0.02, 0.004, -0.01]), 0.004);
        assert_eq!(common(&[]), 0.0);
    }
}
