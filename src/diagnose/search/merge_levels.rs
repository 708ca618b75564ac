//! Merges levels on one joint that are one cause: a changed viscous level and a directional asymmetry
//! are friction levels that differ with the direction; an offset and a linear spring are a spring
//! that rests elsewhere.

use super::forward::Evidence;
use super::judge::Accepted;
use crate::diagnose::fit::model::{Fitted, ModelUnderTest};
use dh_codegen::robot::EffectKind;

/// Least ratio of the smaller to the larger of level and asymmetry. More friction in one direction
/// changes both alike; an asymmetry that follows another error is small.
const ALIKE: f64 = 0.5;

/// Makes a changed viscous level a part of the asymmetric friction found beside it, if both are of
/// similar size, and a changed offset a part of a linear spring. The evidence is the share that both
/// remove together.
pub(in crate::diagnose) fn merge_levels(
    tested: &mut ModelUnderTest<'_>,
    accepted: &[Accepted],
    fitted: &Fitted,
    evidence: &mut Vec<Evidence>,
) {
    for chosen in accepted.iter().map(|a| &a.chosen) {
        let [joint] = chosen.place[..] else { continue };
        let [viscous, offset] = [3 * joint, 3 * joint + 2];
        // No motion separates the offset from the rest position of a spring without a shape.
        let spring = chosen.cause.effect() == EffectKind::JointSpring && chosen.shape.is_empty();
        if spring && hand_over(evidence, joint, [EffectKind::TorqueOffset, EffectKind::JointSpring]) {
            tested.separate[offset] = false;
        }
        if chosen.cause.effect() != EffectKind::AsymmetricFriction {
            continue;
        }
        if tested.frozen[viscous] || !tested.separate[viscous] {
            continue;
        }
        let sizes = [fitted.solution.x[fitted.friction + viscous], chosen.x.first().copied().unwrap_or(0.0)];
        let [small, large] = [f64::min, f64::max].map(|of| of(sizes[0].abs(), sizes[1].abs()));
        if small >= ALIKE * large
            && hand_over(evidence, joint, [EffectKind::ViscousFriction, EffectKind::AsymmetricFriction])
        {
            tested.separate[viscous] = false;
        }
    }
}

/// Merges the evidence for one effect into that for another on the same joint. Returns whether both
/// were present.
pub(super) fn hand_over(evidence: &mut Vec<Evidence>, joint: usize, [from, to]: [EffectKind; 2]) -> bool {
    let at = |effect: EffectKind| evidence.iter().position(|e| e.effect == effect && e.place == [joint]);
    let (Some(gone), Some(own)) = (at(from), at(to)) else { return false };
    evidence[own].share = 1.0 - (1.0 - evidence[gone].share) * (1.0 - evidence[own].share);
    evidence.remove(gone);
    true
}
