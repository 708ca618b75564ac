//! `encoder_offset`: a joint's zero is wrong.

use super::super::scene::Scene;
use super::backlash::both_ways;
use super::{Cause, Kind, Shape, Sign, Term};

/// True angle `q + QO`.
pub struct EncoderOffset;

impl Cause for EncoderOffset {
    fn name(&self) -> &'static str {
        "encoder_offset"
    }

    fn kind(&self) -> Kind {
        Kind::Measurement
    }

    fn shape(&self) -> &'static [Shape] {
        &[Shape { symbol: "step", unit: "rad", range: [-1.0, 1.0], step: None }]
    }

    fn grid(&self, _: &Scene<'_>, _: &[usize], _: &[Vec<f64>]) -> Vec<Vec<f64>> {
        [1e-3, 0.1, -0.1, 0.5, -0.5].iter().map(|step| vec![*step]).collect()
    }

    fn terms(&self, scene: &Scene<'_>, place: &[usize], shape: &[f64]) -> Vec<Term> {
        let j = place[0];
        let column = scene.column(scene.shifted(j, &vec![1.0; scene.len], shape[0]));
        if column.rows.is_empty() {
            return Vec::new();
        }
        vec![Term::new("QO", column, Sign::Any)]
    }

    fn secant(&self) -> bool {
        true
    }

    fn rests_on_model(&self) -> bool {
        true
    }

    fn twins(&self, scene: &Scene<'_>, place: &[usize]) -> &'static [&'static str] {
        // A gap that always lies to the same side.
        if both_ways(scene, place[0]) { &[] } else { &["backlash"] }
    }

    fn says(&self) -> &'static str {
        "the joint's zero is not where the file says"
    }

    fn shown_by(&self) -> &'static str {
        "static poses over the whole travel, or a calibration of the kinematics"
    }
}
