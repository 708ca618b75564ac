//! `torque_saturation`: the torque is clipped.

use dh_codegen::robot::EffectKind;
use dh_codegen::robot::effects;

use super::Estimate;
use super::Hypothesis;
use super::Kind;
use super::Named;
use super::Over;
use super::Shape;
use super::Sign;
use super::Symbol;
use super::Term;
use crate::diagnose::windows::windowed_data::{Column, WindowedData};

/// `clip(tau, +-TM) - tau`, with a coefficient near 1.
pub struct TorqueSaturation;

impl Hypothesis for TorqueSaturation {
    fn effect(&self) -> EffectKind {
        EffectKind::TorqueSaturation
    }

    fn kind(&self) -> Kind {
        Kind::Measurement
    }

    fn shape(&self) -> &'static [Shape] {
        &[Shape {
            symbol: Symbol::Key(effects::TorqueSaturation::TM),
            unit: "N m",
            range: [1e-3, 1e5],
            step: Some(0.02),
        }]
    }

    fn grid(&self, scene: &WindowedData<'_>, place: &[usize], _: &[Vec<f64>]) -> Vec<Vec<f64>> {
        // A clipped torque is at its bound for some of the time.
        let mut sizes: Vec<f64> = scene.y[place[0]].iter().map(|t| t.abs()).filter(|t| *t > 0.0).collect();
        sizes.sort_by(f64::total_cmp);
        let at = |share: f64| sizes.get((share * sizes.len() as f64) as usize).copied();
        [0.7, 0.8, 0.9, 0.95, 0.98, 0.995].into_iter().filter_map(at).map(|t| vec![t]).collect()
    }

    fn shows(&self, scene: &WindowedData<'_>, place: &[usize], shape: &[f64]) -> bool {
        let j = place[0];
        scene.whole[j].iter().zip(&scene.live[j]).filter(|(t, live)| **live && t.abs() > shape[0]).count() >= 5
    }

    fn terms(&self, scene: &WindowedData<'_>, place: &[usize], shape: &[f64]) -> Vec<Term> {
        let (j, bound) = (place[0], shape[0]);
        let mut series: Vec<f64> = scene.whole[j].iter().map(|t| t.clamp(-bound, bound) - t).collect();
        scene.masked(j, &mut series);
        vec![Term::new(Symbol::Own("clip"), Column::on(j, series), Sign::Positive)]
    }

    fn rests_on_model(&self) -> bool {
        true
    }

    fn rests_on_friction(&self) -> bool {
        true
    }

    /// Hardly any measured torque exceeds the bound, apart from noise.
    fn plausible(&self, scene: &WindowedData<'_>, place: &[usize], shape: &[f64], x: &[f64]) -> bool {
        let j = place[0];
        let most = shape[0] + (0.02 * shape[0]).max(4.0 * scene.noise[j]);
        let above = scene.y[j].iter().filter(|t| t.abs() > most).count();
        (0.6..1.4).contains(&x[0]) && (above as f64) < 0.01 * scene.len as f64
    }

    fn named(&self, found: &Estimate<'_>) -> Vec<Named> {
        vec![Named::new(effects::TorqueSaturation::TM, found.shape[0], found.shape_std[0])]
    }

    fn over(&self) -> Over {
        Over::Torque
    }

    fn says(&self) -> &'static str {
        "the torque is clipped at a bound"
    }

    fn shown_by(&self) -> &'static str {
        "the same motion slower, so that the torque stays below the bound"
    }
}
