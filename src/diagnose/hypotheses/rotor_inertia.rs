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
use super::payload::body_columns;
use crate::diagnose::windows::windowed_data::WindowedData;

/// `IA ddq`.
pub struct RotorInertia;

/// Part of the largest acceleration by which two columns of the same series differ at most.
const ROUNDED: f64 = 1e-6;

/// Whether nothing but this joint accelerates its link: a parameter of the link gives the torque that
/// a rotor gives, and no other, as the inertia of the first link about its axis does.
fn turns_alone(scene: &WindowedData<'_>, j: usize) -> bool {
    let own = scene.pointwise(j, |o, k| o.a[k]);
    let Some((_, own)) = own.rows.first() else { return false };
    let least = ROUNDED * own.iter().fold(0.0, |most: f64, a| most.max(a.abs()));
    body_columns(scene, scene.plant.rows()[j]).into_iter().any(|torques| {
        let column = scene.column(torques);
        let alone = column.rows.len() == 1 && column.rows[0].0 == j;
        alone && column.rows[0].1.iter().zip(&**own).all(|(a, b)| (a - b).abs() <= least)
    })
}

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

    fn indistinguishable(&self, scene: &WindowedData<'_>, place: &[usize]) -> &'static [&'static str] {
        if turns_alone(scene, place[0]) { &[effects::LinkInertiaError::NAME] } else { &[] }
    }

    fn decided_by(&self, scene: &WindowedData<'_>, place: &[usize]) -> &'static str {
        if turns_alone(scene, place[0]) { "the rotor's inertia in the drive's data sheet" } else { self.shown_by() }
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
