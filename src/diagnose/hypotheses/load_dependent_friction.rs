//! `load_dependent_friction`: friction that grows with the torque that the gear transmits.

use dh_codegen::robot::EffectKind;
use dh_codegen::robot::effects;

use super::Hypothesis;
use super::Kind;
use super::Law;
use super::Over;
use super::Shape;
use super::Sign;
use super::Symbol;
use super::Term;
use super::moves;
use crate::diagnose::windows::windowed_data::WindowedData;

/// `FL |tau_load| sign(v)`; optionally with `FLB` in place of `FL` where the load drives the motor.
pub struct LoadDependentFriction;

impl Hypothesis for LoadDependentFriction {
    fn effect(&self) -> EffectKind {
        EffectKind::LoadDependentFriction
    }

    fn kind(&self) -> Kind {
        Kind::Friction
    }

    fn shape(&self) -> &'static [Shape] {
        &[Shape { symbol: Symbol::Own("quadrants"), unit: "", range: [0.0, 1.0], step: None }]
    }

    fn grid(&self, _: &WindowedData<'_>, _: &[usize], _: &[Vec<f64>]) -> Vec<Vec<f64>> {
        vec![vec![0.0], vec![1.0]]
    }

    fn simpler(&self, _: &WindowedData<'_>, _: &[usize], shape: &[f64]) -> Vec<Law> {
        if shape[0] == 0.0 { Vec::new() } else { vec![(&Self, vec![vec![0.0]])] }
    }

    fn shows(&self, scene: &WindowedData<'_>, place: &[usize], _: &[f64]) -> bool {
        moves(scene, place[0])
    }

    fn terms(&self, scene: &WindowedData<'_>, place: &[usize], shape: &[f64]) -> Vec<Term> {
        let j = place[0];
        let among = |wanted: &dyn Fn(f64) -> bool| {
            scene.pointwise(j, |o, k| if wanted(o.load(k) * o.sign[k]) { o.sign[k] * o.load(k).abs() } else { 0.0 })
        };
        if shape.first() == Some(&0.0) {
            return vec![Term::new(effects::LoadDependentFriction::FL, among(&|_| true), Sign::Positive)];
        }
        vec![
            Term::new(effects::LoadDependentFriction::FL, among(&|power| power >= 0.0), Sign::Positive),
            Term::new(effects::LoadDependentFriction::FLB, among(&|power| power < 0.0), Sign::Positive),
        ]
    }

    /// A gear that loses as much torque as it transmits is locked.
    fn plausible(&self, _: &WindowedData<'_>, _: &[usize], _: &[f64], x: &[f64]) -> bool {
        x.iter().all(|x| *x < 1.0)
    }

    fn rests_on_model(&self) -> bool {
        true
    }

    fn over(&self) -> Over {
        Over::Torque
    }

    fn says(&self) -> &'static str {
        "friction grows with the transmitted torque"
    }

    fn shown_by(&self) -> &'static str {
        "the same speeds with and without a payload, or in stretched and in folded postures"
    }
}
