//! `position_dependent_friction`: friction that varies along the joint's travel.

use dh_codegen::robot::EffectKind;
use dh_codegen::robot::effects;

use super::Hypothesis;
use super::Kind;
use super::Over;
use super::Shape;
use super::Sign;
use super::Symbol;
use super::Term;
use super::moves;
use super::nearly_one_order;
use crate::diagnose::windows::windowed_data::WindowedData;

/// `sign(v) (PC cos(PN q) + PS sin(PN q))`.
pub struct PositionDependentFriction;

impl Hypothesis for PositionDependentFriction {
    fn effect(&self) -> EffectKind {
        EffectKind::PositionDependentFriction
    }

    fn kind(&self) -> Kind {
        Kind::Friction
    }

    fn shape(&self) -> &'static [Shape] {
        &[Shape {
            symbol: Symbol::Key(effects::PositionDependentFriction::PN),
            unit: "1/turn",
            range: [0.3, 30.0],
            step: Some(0.1),
        }]
    }

    fn grid(&self, scene: &WindowedData<'_>, place: &[usize], _: &[Vec<f64>]) -> Vec<Vec<f64>> {
        let [low, high] = scene.travel[place[0]];
        // At least a third of a period must lie within the travel.
        let least = (2.0 / (high - low).max(0.1)).max(1.0);
        [1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 10.0, 12.0]
            .into_iter()
            .filter(|n| *n >= least)
            .map(|n| vec![n])
            .collect()
    }

    fn shows(&self, scene: &WindowedData<'_>, place: &[usize], shape: &[f64]) -> bool {
        let [low, high] = scene.travel[place[0]];
        moves(scene, place[0]) && shape[0] * (high - low) >= 2.0
    }

    /// A travel of less than a period resolves orders coarsely.
    fn same_law(&self, a: &[f64], b: &[f64]) -> bool {
        nearly_one_order(a, b, 1.6)
    }

    fn integer_shape(&self) -> Option<usize> {
        Some(0)
    }

    fn terms(&self, scene: &WindowedData<'_>, place: &[usize], shape: &[f64]) -> Vec<Term> {
        let (j, n) = (place[0], shape[0]);
        vec![
            Term::new(
                effects::PositionDependentFriction::PC,
                scene.pointwise(j, |o, k| o.sign[k] * (n * o.q[k]).cos()),
                Sign::Any,
            ),
            Term::new(
                effects::PositionDependentFriction::PS,
                scene.pointwise(j, |o, k| o.sign[k] * (n * o.q[k]).sin()),
                Sign::Any,
            ),
        ]
    }

    /// Friction that varies by more than the joint can overcome is implausible.
    fn plausible(&self, scene: &WindowedData<'_>, place: &[usize], _: &[f64], x: &[f64]) -> bool {
        x.iter().map(|x| x * x).sum::<f64>().sqrt() <= 0.5 * scene.rated[place[0]]
    }

    fn most(&self) -> usize {
        2
    }

    fn over(&self) -> Over {
        Over::Position
    }

    fn follows_reversals(&self) -> bool {
        true
    }

    fn says(&self) -> &'static str {
        "friction varies along the joint's travel"
    }

    fn shown_by(&self) -> &'static str {
        "slow constant speed through the whole travel, forward and backward"
    }
}
