//! `encoder_offset`: the zero of a joint's encoder is wrong.

use dh_codegen::robot::EffectKind;
use dh_codegen::robot::effects;

use super::Hypothesis;
use super::Kind;
use super::Shape;
use super::Sign;
use super::Symbol;
use super::Term;
use super::backlash::both_ways;
use crate::diagnose::windows::windowed_data::WindowedData;

/// True angle `q + QO`.
pub struct EncoderOffset;

impl Hypothesis for EncoderOffset {
    fn effect(&self) -> EffectKind {
        EffectKind::EncoderOffset
    }

    fn kind(&self) -> Kind {
        Kind::Measurement
    }

    fn in_the_drive(&self) -> bool {
        false
    }

    fn shape(&self) -> &'static [Shape] {
        &[Shape { symbol: Symbol::Own("step"), unit: "rad", range: [-1.0, 1.0], step: None }]
    }

    fn grid(&self, _: &WindowedData<'_>, _: &[usize], _: &[Vec<f64>]) -> Vec<Vec<f64>> {
        [1e-3, 0.1, -0.1, 0.5, -0.5].iter().map(|step| vec![*step]).collect()
    }

    fn terms(&self, scene: &WindowedData<'_>, place: &[usize], shape: &[f64]) -> Vec<Term> {
        let j = place[0];
        let column = scene.column(scene.shifted(j, &vec![1.0; scene.len], shape[0]));
        if column.rows.is_empty() {
            return Vec::new();
        }
        vec![Term::new(effects::EncoderOffset::QO, column, Sign::Any)]
    }

    fn finite_difference(&self) -> bool {
        true
    }

    fn rests_on_model(&self) -> bool {
        true
    }

    fn indistinguishable(&self, scene: &WindowedData<'_>, place: &[usize]) -> &'static [&'static str] {
        // A gap that always lies to the same side has the same column.
        if both_ways(scene, place[0]) { &[] } else { &[effects::Backlash::NAME] }
    }

    fn says(&self) -> &'static str {
        "the joint's zero is not where the file says"
    }

    fn shown_by(&self) -> &'static str {
        "static poses over the whole travel, or a calibration of the kinematics"
    }
}
