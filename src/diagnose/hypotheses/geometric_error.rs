//! `geometric_error`: a length or twist of the DH table is wrong.

use dh_codegen::robot::EffectKind;
use dh_codegen::robot::effects::{self, Key};

use crate::model::Change;

use super::Hypothesis;
use super::Kind;
use super::Shape;
use super::Sign;
use super::Symbol;
use super::Term;
use crate::diagnose::windows::windowed_data::WindowedData;

/// One of `DALPHA`, `DD`, `DR` of the joint's row. (`DTHETA` is `encoder_offset`.)
pub struct GeometricError;

/// Keys of the row with their steps, rad or m.
const WHICH: [(Key, f64); 3] =
    [(effects::GeometricError::DALPHA, 1e-4), (effects::GeometricError::DD, 1e-4), (effects::GeometricError::DR, 1e-4)];

/// The largest error of a length, as a share of the arm's reach, and of a twist, rad.
const LENGTH: f64 = 0.15;
const TWIST: f64 = 0.35;

impl Hypothesis for GeometricError {
    fn effect(&self) -> EffectKind {
        EffectKind::GeometricError
    }

    fn kind(&self) -> Kind {
        Kind::Body
    }

    fn shape(&self) -> &'static [Shape] {
        &[
            Shape { symbol: Symbol::Own("step"), unit: "", range: [-1.0, 1.0], step: None },
            Shape { symbol: Symbol::Own("which"), unit: "", range: [0.0, 2.0], step: None },
        ]
    }

    fn grid(&self, _: &WindowedData<'_>, _: &[usize], _: &[Vec<f64>]) -> Vec<Vec<f64>> {
        (0..3).map(|k| vec![WHICH[k].1, k as f64]).collect()
    }

    fn terms(&self, scene: &WindowedData<'_>, place: &[usize], shape: &[f64]) -> Vec<Term> {
        let Some(standard) = &scene.standard else { return Vec::new() };
        let which = shape[1] as usize;
        let by = |k: usize| if k == which { shape[0] } else { 0.0 };
        let change = Change::Row { row: scene.plant.rows()[place[0]], alpha: by(0), d: by(1), theta: 0.0, r: by(2) };
        let column = scene.column(scene.changed(&change, standard, shape[0]));
        if column.rows.is_empty() {
            return Vec::new();
        }
        vec![Term::new(WHICH[which].0, column, Sign::Any)]
    }

    /// A length error beyond a share of the arm's reach, or a clearly visible twist, is another
    /// error that these columns absorb.
    fn plausible(&self, scene: &WindowedData<'_>, _: &[usize], shape: &[f64], x: &[f64]) -> bool {
        let most = if shape[1] == 0.0 { TWIST } else { (LENGTH * scene.reach()).max(0.02) };
        x.iter().all(|x| x.abs() <= most)
    }

    fn finite_difference(&self) -> bool {
        true
    }

    fn rests_on_model(&self) -> bool {
        true
    }

    fn says(&self) -> &'static str {
        "a length or twist of the DH table is not what the file says"
    }

    fn shown_by(&self) -> &'static str {
        "a calibration of the kinematics; torques show lengths only through gravity and inertia"
    }
}
