//! `presliding_hysteresis`: friction with memory near reversals (Dahl 1968).

use dh_codegen::robot::EffectKind;
use dh_codegen::robot::effects;

use super::Hypothesis;
use super::Kind;
use super::Shape;
use super::Sign;
use super::Symbol;
use super::Term;
use super::geometric;
use super::moves;
use crate::diagnose::windows::windowed_data::{JointSeries, WindowedData};

/// `HC z`, `dz/dt = (v / HX) (1 - z sign v)`, which replaces a part of the Coulomb friction in the
/// fit.
pub struct PreslidingHysteresis;

/// Shortest presliding distance, relative to the joint's travel: a third of the first in the grid.
const SHORTEST: f64 = 1e-4;

/// State of the Dahl model, integrated in closed form over each sample: `z -> s + (z - s) exp(-|dq|
/// / HX)`.
pub fn bristle(own: &JointSeries<'_>, distance: f64) -> Vec<f64> {
    // Initially fully deflected in the direction of the first motion.
    let mut z = own.sign.iter().find(|s| *s != 0.0).unwrap_or(0.0);
    let mut last = own.q.first().copied().unwrap_or(0.0);
    own.q
        .iter()
        .map(|&q| {
            let moved = q - last;
            last = q;
            if moved != 0.0 {
                let s = moved.signum();
                z = s + (z - s) * (-moved.abs() / distance).exp();
            }
            z
        })
        .collect()
}

/// Least distance, by that of one sample at the largest speed: what a joint passes within a sample at
/// a usual speed is a Coulomb level.
const RESOLVED: f64 = 0.15;

impl Hypothesis for PreslidingHysteresis {
    fn effect(&self) -> EffectKind {
        EffectKind::PreslidingHysteresis
    }

    fn kind(&self) -> Kind {
        Kind::Friction
    }

    fn shape(&self) -> &'static [Shape] {
        &[Shape {
            symbol: Symbol::Key(effects::PreslidingHysteresis::HX),
            unit: "rad",
            range: [1e-5, 10.0],
            step: Some(0.3),
        }]
    }

    fn grid(&self, scene: &WindowedData<'_>, place: &[usize], _: &[Vec<f64>]) -> Vec<Vec<f64>> {
        let [low, high] = scene.travel[place[0]];
        geometric(3e-4 * (high - low), 0.12 * (high - low), 9).into_iter().map(|x| vec![x]).collect()
    }

    fn shows(&self, scene: &WindowedData<'_>, place: &[usize], shape: &[f64]) -> bool {
        let [low, high] = scene.travel[place[0]];
        let least = RESOLVED * scene.fastest[place[0]] * scene.period;
        moves(scene, place[0]) && (least..=0.2 * (high - low)).contains(&shape[0])
    }

    fn terms(&self, scene: &WindowedData<'_>, place: &[usize], shape: &[f64]) -> Vec<Term> {
        let j = place[0];
        vec![Term::new(
            effects::PreslidingHysteresis::HC,
            scene.own_column(j, |own| bristle(own, shape[0])),
            Sign::Positive,
        )]
    }

    /// Friction below what the joint can overcome, over a significant distance: otherwise it is a
    /// level.
    fn plausible(&self, scene: &WindowedData<'_>, place: &[usize], shape: &[f64], x: &[f64]) -> bool {
        let [low, high] = scene.travel[place[0]];
        shape[0] >= SHORTEST * (high - low) && x.iter().all(|level| *level <= scene.rated[place[0]])
    }

    fn follows_reversals(&self) -> bool {
        true
    }

    fn says(&self) -> &'static str {
        "friction has memory: after a reversal it builds up over a distance"
    }

    fn shown_by(&self) -> &'static str {
        "small oscillations about several positions, with amplitudes of the presliding distance"
    }
}
