//! `nonlinear_viscous_friction`: the viscous part is not proportional to speed.

use dh_codegen::robot::EffectKind;
use dh_codegen::robot::effects;

use super::Estimate;
use super::Hypothesis;
use super::Kind;
use super::Named;
use super::Shape;
use super::Sign;
use super::Symbol;
use super::Term;
use super::geometric;
use super::moves;
use crate::diagnose::windows::windowed_data::WindowedData;

/// `FN |v|^EN sign(v)`, or the saturating `FN v / (|v| + VN)`.
pub struct NonlinearViscousFriction;

/// Least speed at half of the friction, relative to the joint's maximum. Below it the law is dry
/// friction whose sign changes smoothly.
const SLOWEST: f64 = 0.05;

impl Hypothesis for NonlinearViscousFriction {
    fn effect(&self) -> EffectKind {
        EffectKind::NonlinearViscousFriction
    }

    fn kind(&self) -> Kind {
        Kind::Friction
    }

    fn shape(&self) -> &'static [Shape] {
        &[
            Shape {
                symbol: Symbol::Key(effects::NonlinearViscousFriction::EN),
                unit: "",
                range: [0.2, 5.0],
                step: Some(0.15),
            },
            Shape {
                symbol: Symbol::Key(effects::NonlinearViscousFriction::VN),
                unit: "rad/s",
                range: [0.0, 1e3],
                step: Some(0.3),
            },
        ]
    }

    fn grid(&self, scene: &WindowedData<'_>, place: &[usize], _: &[Vec<f64>]) -> Vec<Vec<f64>> {
        let fast = scene.fastest[place[0]];
        let slow = (2.0 * scene.velocity_noise_limit[place[0]]).clamp(1.5 * SLOWEST * fast, 0.2 * fast);
        let powers = [0.4, 0.6, 1.5, 2.0, 3.0].iter().map(|e| vec![*e, 0.0]);
        powers.chain(geometric(slow, fast, 4).into_iter().map(|v| vec![1.0, v])).collect()
    }

    /// Law of a shape: 0 a power, 1 saturating.
    fn law(&self, shape: &[f64]) -> usize {
        usize::from(shape[1] > 0.0)
    }

    /// One of the two numbers is in use.
    fn free(&self, _: &[f64]) -> usize {
        1
    }

    /// Laws that are constant over nearly all speeds, or proportional to speed, are excluded.
    fn shows(&self, scene: &WindowedData<'_>, place: &[usize], shape: &[f64]) -> bool {
        let fast = scene.fastest[place[0]];
        let differs = match shape[1] {
            0.0 => (shape[0] - 1.0).abs() >= 0.05,
            half => (SLOWEST * fast..2.0 * fast).contains(&half),
        };
        moves(scene, place[0]) && differs
    }

    /// A speed at the lower end of the search range is no estimate.
    fn plausible(&self, scene: &WindowedData<'_>, place: &[usize], shape: &[f64], _: &[f64]) -> bool {
        shape[1] == 0.0 || shape[1] > 1.1 * SLOWEST * scene.fastest[place[0]]
    }

    fn terms(&self, scene: &WindowedData<'_>, place: &[usize], shape: &[f64]) -> Vec<Term> {
        let (j, power, half) = (place[0], shape[0], shape[1]);
        if half > 0.0 {
            let grown = |v: f64| v.abs() / (v.abs() + half);
            return vec![Term::new(
                effects::NonlinearViscousFriction::FN,
                scene.pointwise(j, |o, k| o.sign[k] * grown(o.v[k])),
                Sign::Positive,
            )];
        }
        vec![Term::new(
            effects::NonlinearViscousFriction::FN,
            scene.pointwise(j, |o, k| o.sign[k] * o.v[k].abs().powf(power)),
            Sign::Any,
        )]
    }

    /// Laws that bend to the same side are one: a saturating law bends like a root.
    fn same_law(&self, a: &[f64], b: &[f64]) -> bool {
        let like_a_root = |shape: &[f64]| matches!(*shape, [power, half] if half > 0.0 || power < 1.0);
        a.is_empty() || b.is_empty() || like_a_root(a) == like_a_root(b)
    }

    fn named(&self, found: &Estimate<'_>) -> Vec<Named> {
        let k = usize::from(found.shape[1] > 0.0);
        vec![found.term(0), Named::new(self.shape()[k].symbol, found.shape[k], found.shape_std[k])]
    }

    /// Gears show a root and a cube at once.
    fn most(&self) -> usize {
        2
    }

    fn says(&self) -> &'static str {
        "the viscous part of friction is not proportional to speed"
    }

    fn shown_by(&self) -> &'static str {
        "constant speeds up to the largest"
    }
}
