//! `friction_drift`: friction that changes over time, as grease warms up, or with the temperature where that was recorded.

use super::super::scene::Scene;
use super::{Cause, Kind, Shape, Sign, Term, geometric, moves};

/// `(DC sign(v) + DV v) exp(-t / DT)`; with a temperature column the exponential gives way to `temp - mean`.
pub struct FrictionDrift;

impl FrictionDrift {
    fn temperature(scene: &Scene<'_>, j: usize) -> Option<(f64, f64)> {
        let all: Vec<f64> = scene.own[j].iter().flat_map(|o| o.temperature.iter().copied()).collect();
        let samples: usize = scene.own[j].iter().map(|o| o.v.len()).sum();
        if all.is_empty() || all.len() != samples {
            return None;
        }
        let mean = all.iter().sum::<f64>() / all.len() as f64;
        let spread = all.iter().fold(0.0_f64, |m, t| m.max((t - mean).abs()));
        (spread > 0.5).then_some((mean, spread))
    }
}

impl Cause for FrictionDrift {
    fn name(&self) -> &'static str {
        "friction_drift"
    }

    fn kind(&self) -> Kind {
        Kind::Friction
    }

    fn shape(&self) -> &'static [Shape] {
        &[Shape { symbol: "DT", unit: "s", range: [0.05, 1e5], step: Some(0.3) }]
    }

    fn grid(&self, scene: &Scene<'_>, place: &[usize], _: &[Vec<f64>]) -> Vec<Vec<f64>> {
        let long = scene.time.iter().fold(0.0_f64, |m, t| m.max(*t)).max(1.0);
        let mut grid: Vec<Vec<f64>> = geometric(0.08 * long, 2.0 * long, 6).into_iter().map(|t| vec![t]).collect();
        if Self::temperature(scene, place[0]).is_some() {
            grid.push(vec![0.0]);
        }
        grid
    }

    fn terms(&self, scene: &Scene<'_>, place: &[usize], shape: &[f64]) -> Vec<Term> {
        let j = place[0];
        if !moves(scene, j) {
            return Vec::new();
        }
        if shape[0] == 0.0 {
            let Some((mean, _)) = Self::temperature(scene, j) else { return Vec::new() };
            let warm = |k: usize, o: &super::super::scene::Own| o.temperature[k] - mean;
            return vec![
                Term::new("DCK", scene.pointwise(j, |o, k| o.sign[k] * warm(k, o)), Sign::Any),
                Term::new("DVK", scene.pointwise(j, |o, k| o.v[k] * warm(k, o)), Sign::Any),
            ];
        }
        let fade = |t: f64| (-t / shape[0]).exp();
        vec![
            Term::new("DC", scene.pointwise(j, |o, k| o.sign[k] * fade(o.t[k])), Sign::Any),
            Term::new("DV", scene.pointwise(j, |o, k| o.v[k] * fade(o.t[k])), Sign::Any),
        ]
    }

    fn says(&self) -> &'static str {
        "friction changes over the recording, as it does while grease warms up"
    }

    fn shown_by(&self) -> &'static str {
        "the same motion repeated from cold until it no longer changes, with the temperature recorded"
    }
}
