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
use super::payload::body_terms;
use crate::diagnose::windows::windowed_data::WindowedData;

/// `IA ddq`.
pub struct RotorInertia;

/// Largest difference between two equal columns, as a share of the largest acceleration. Right
/// angles that a file has rounded leave such remainders in place of 0.
const ROUNDED: f64 = 1e-4;

/// Information that separates a rotor from a link that [`shows_as_a_rotor`].
pub(super) const DATA_SHEET: &str = "the rotor's inertia in the drive's data sheet";

/// Whether a joint's link acts on the torques like a rotor only, as the inertia of a first link
/// about its vertical axis does.
pub(super) fn shows_as_a_rotor(scene: &WindowedData<'_>, j: usize) -> bool {
    let own = scene.pointwise(j, |o, k| o.a[k]);
    let link = body_terms(scene, scene.plant.rows()[j], effects::LinkInertiaError::BODY);
    let [(_, own)] = &own.rows[..] else { return false };
    let least = ROUNDED * own.iter().fold(0.0, |most: f64, a| most.max(a.abs()));
    let rows = || link.iter().flat_map(|term| &term.column.rows);
    let shown: Vec<_> = rows().filter(|(_, torque)| torque.iter().any(|x| x.abs() > least)).collect();
    let alike = |torque: &[f64]| torque.iter().zip(&**own).all(|(a, b)| (a - b).abs() <= least);
    matches!(shown[..], [(joint, torque)] if *joint == j && alike(torque))
}

impl Hypothesis for RotorInertia {
    fn effect(&self) -> EffectKind {
        EffectKind::RotorInertia
    }

    fn kind(&self) -> Kind {
        Kind::Body
    }

    fn in_the_drive(&self) -> bool {
        true
    }

    fn shows(&self, scene: &WindowedData<'_>, place: &[usize], _: &[f64]) -> bool {
        moves(scene, place[0])
    }

    fn terms(&self, scene: &WindowedData<'_>, place: &[usize], _: &[f64]) -> Vec<Term> {
        let j = place[0];
        vec![Term::new(effects::RotorInertia::IA, scene.pointwise(j, |o, k| o.a[k]), Sign::Any)]
    }

    /// The total rotor inertia must not be negative.
    fn plausible(&self, scene: &WindowedData<'_>, place: &[usize], _: &[f64], x: &[f64]) -> bool {
        x.iter().all(|x| scene.rotors[place[0]] + x >= 0.0)
    }

    fn named(&self, found: &Estimate<'_>) -> Vec<Named> {
        vec![Named::new(effects::RotorInertia::IA, found.scene.rotors[found.place[0]] + found.x[0], Some(found.std(0)))]
    }

    fn indistinguishable(&self, scene: &WindowedData<'_>, place: &[usize]) -> &'static [&'static str] {
        if shows_as_a_rotor(scene, place[0]) { &[effects::LinkInertiaError::NAME] } else { &[] }
    }

    fn decided_by(&self, scene: &WindowedData<'_>, place: &[usize]) -> Option<&'static str> {
        shows_as_a_rotor(scene, place[0]).then_some(DATA_SHEET)
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
