//! Merges a changed viscous level and a directional asymmetry on the same joint into one cause:
//! friction levels that differ with the direction.

use super::forward::Evidence;
use super::judge::Accepted;
use crate::diagnose::fit::model::{Fitted, ModelUnderTest};
use dh_codegen::robot::EffectKind;

/// Least ratio of the smaller to the larger of level and asymmetry. More friction in one direction
/// changes both alike; an asymmetry that follows another error is small.
const ALIKE: f64 = 0.5;

/// Makes a changed viscous level a part of the asymmetric friction found beside it, if both are of
/// similar size. The evidence is the share that both remove together.
pub(in crate::diagnose) fn merge_levels(
    tested: &mut ModelUnderTest<'_>,
    accepted: &[Accepted],
    fitted: &Fitted,
    evidence: &mut Vec<Evidence>,
) {
    for chosen in accepted.iter().map(|a| &a.chosen).filter(|c| c.cause.effect() == EffectKind::AsymmetricFriction) {
        let [joint] = chosen.place[..] else { continue };
        let viscous = 3 * joint;
        if tested.frozen[viscous] || !tested.separate[viscous] {
            continue;
        }
        let sizes = [fitted.solution.x[fitted.friction + viscous], chosen.x.first().copied().unwrap_or(0.0)];
        let [small, large] = [f64::min, f64::max].map(|of| of(sizes[0].abs(), sizes[1].abs()));
        if small >= ALIKE * large && hand_over(evidence, joint, EffectKind::ViscousFriction) {
            tested.separate[viscous] = false;
        }
    }
}

/// Merges the evidence for an effect into that for asymmetric friction on the same joint. Returns
/// whether both were present.
pub(super) fn hand_over(evidence: &mut Vec<Evidence>, joint: usize, from: EffectKind) -> bool {
    let at = |effect: EffectKind| evidence.iter().position(|e| e.effect == effect && e.place == [joint]);
    let (Some(gone), Some(own)) = (at(from), at(EffectKind::AsymmetricFriction)) else { return false };
    evidence[own].share = 1.0 - (1.0 - evidence[gone].share) * (1.0 - evidence[own].share);
    evidence.remove(gone);
    true
}
