//! `stribeck_friction`: friction falls from the breakaway to the Coulomb level as speed rises
//! (Armstrong-Helouvry, Dupont and Canudas de Wit 1994).

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

/// `(FS - FC) exp(-|v / VS|^DS) sign(v)`.
pub struct StribeckFriction;

impl Hypothesis for StribeckFriction {
    fn effect(&self) -> EffectKind {
        EffectKind::StribeckFriction
    }

    fn kind(&self) -> Kind {
        Kind::Friction
    }

    fn shape(&self) -> &'static [Shape] {
        &[
            Shape {
                symbol: Symbol::Key(effects::StribeckFriction::VS),
                unit: "rad/s",
                range: [1e-4, 1e3],
                step: Some(0.3),
            },
            Shape { symbol: Symbol::Key(effects::StribeckFriction::DS), unit: "", range: [0.5, 4.0], step: Some(0.3) },
        ]
    }

    fn grid(&self, scene: &WindowedData<'_>, place: &[usize], _: &[Vec<f64>]) -> Vec<Vec<f64>> {
        let (slow, fast) = (2.0 * scene.velocity_noise_limit[place[0]], 0.35 * scene.fastest[place[0]]);
        let speeds = geometric(slow.min(0.5 * fast), fast, 8);
        speeds.iter().flat_map(|&v| [vec![v, 2.0], vec![v, 1.0]]).collect()
    }

    fn shows(&self, scene: &WindowedData<'_>, place: &[usize], shape: &[f64]) -> bool {
        moves(scene, place[0]) && shape[0] <= 0.5 * scene.fastest[place[0]]
    }

    fn integer_shape(&self) -> Option<usize> {
        Some(1) // 1 (Tustin) or 2 (Gauss), unless the data contradict it
    }

    fn integer_prior_std(&self) -> Option<f64> {
        Some(0.5) // what was measured lies between 0.5 and 2 (Armstrong-Helouvry, Dupont and Canudas de Wit 1994)
    }

    fn terms(&self, scene: &WindowedData<'_>, place: &[usize], shape: &[f64]) -> Vec<Term> {
        let j = place[0];
        let (speed, power) = (shape[0], shape[1]);
        let column = scene.pointwise(j, |o, k| o.sign[k] * (-(o.v[k].abs() / speed).powf(power)).exp());
        vec![Term::new(effects::StribeckFriction::FS, column, Sign::Positive)]
    }

    fn named(&self, found: &Estimate<'_>) -> Vec<Named> {
        // The breakaway level: the sum of the Coulomb level and the decaying part.
        let [_, coulomb, _] = found.levels;
        vec![
            Named::new(effects::StribeckFriction::FS, coulomb + found.x[0], Some(found.std_with(0, 1))),
            Named::new(effects::StribeckFriction::VS, found.shape[0], found.shape_std[0]),
            Named::new(effects::StribeckFriction::DS, found.shape[1], found.shape_std[1]),
            Named::new(effects::CoulombFriction::FC, coulomb, None),
        ]
    }

    /// The joint must be able to overcome it.
    fn plausible(&self, scene: &WindowedData<'_>, place: &[usize], _: &[f64], x: &[f64]) -> bool {
        x.iter().all(|level| *level <= scene.rated[place[0]])
    }

    fn says(&self) -> &'static str {
        "friction falls from its breakaway level to the Coulomb level as speed rises"
    }

    fn shown_by(&self) -> &'static str {
        "slow constant speeds, from a hundredth to a tenth of the largest, in both directions"
    }
}
