//! `rotor_inertia`: reflected inertia of the drive.

use dh_codegen::robot::EffectKind;
use dh_codegen::robot::effects;

use super::Estimate;
use super::Hypothesis;
use super::Kind;
use super::Named;
use super::Over;
use super::Sign;
use super::Term;
use super::moves;
use crate::diagnose::windows::windowed_data::WindowedData;

/// `IA ddq`.
pub struct RotorInertia;

impl Hypothesis for RotorInertia {
    fn effect(&self) -> EffectKind {
        EffectKind::RotorInertia
    }

    fn kind(&self) -> Kind {
        Kind::Body
    }

    fn shows(&self, scene: &WindowedData<'_>, place: &[usize], _: &[f64]) -> bool {
        moves(scene, place[0])
    }

    fn terms(&self, scene: &WindowedData<'_>, place: &[usize], _: &[f64]) -> Vec<Term> {
        let j = place[0];
        vec![Term::new(effects::RotorInertia::IA, scene.pointwise(j, |o, k| o.a[k]), Sign::Any)]
    }

    /// No rotor has less than none.
    fn plausible(&self, scene: &WindowedData<'_>, place: &[usize], _: &[f64], x: &[f64]) -> bool {
        x.iter().all(|x| scene.rotors[place[0]] + x >= 0.0)
    }

    fn named(&self, found: &Estimate<'_>) -> Vec<Named> {
        vec![Named::new(effects::RotorInertia::IA, found.scene.rotors[found.place[0]] + found.x[0], Some(found.std(0)))]
    }

    fn over(&self) -> Over {
        Over::Acceleration
    }

    fn says(&self) -> &'static str {
        "the torque has a part in proportion to the joint's own acceleration that the given model lacks or has wrong"
    }

    fn shown_by(&self) -> &'static str {
        "high accelerations of this joint alone"
    }
}
