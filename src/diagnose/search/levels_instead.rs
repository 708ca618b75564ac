//! Replaces a friction law beside a directional asymmetry by plain friction levels.
//!
//! More friction in one direction is an asymmetry plus changed plain levels. The search takes one
//! cause at a time, and a law with two unknowns (a power of the speed, a slowly fading level)
//! approximates both levels at once. Where the levels themselves fit as well by Schwarz's
//! criterion, they are the friction that changed.

use super::candidate::unknowns;
use super::forward::Evidence;
use super::judge::{Accepted, adopt, chosen_of};
use super::merge_levels::hand_over;
use super::simplest_laws::costs_less;
use crate::diagnose::fit::model::{Fitted, ModelUnderTest, given_friction};
use dh_codegen::robot::EffectKind;

/// Laws that approximate two levels.
const NEAR: [EffectKind; 2] = [EffectKind::NonlinearViscousFriction, EffectKind::FrictionDrift];

/// Replaces such a law beside a joint's asymmetric friction by the joint's plain levels, which
/// become a part of the asymmetry. Their evidence is the share that both remove together.
pub(in crate::diagnose) fn levels_instead(
    tested: &mut ModelUnderTest<'_>,
    accepted: &mut Vec<Accepted>,
    mut fitted: Fitted,
    evidence: &mut Vec<Evidence>,
) -> Fitted {
    let given = given_friction(tested.plant);
    while let Some((index, joint)) =
        beside_a_difference(accepted, |joint| given[joint][0].is_some() && given[joint][1].is_some())
    {
        let frozen = tested.frozen.clone();
        let levels = 3 * joint..3 * joint + 2;
        let freed = frozen[levels.clone()].iter().filter(|f| **f).count() as f64;
        tested.frozen[levels.clone()].fill(false);
        let mut trial = chosen_of(accepted);
        let law = trial.remove(index);
        let next = tested.fit_regularised_beside(&mut trial);
        if !costs_less(&next, &fitted, unknowns(law.cause, &law.shape, law.x.len()) - freed) {
            tested.frozen = frozen;
            break;
        }
        tested.separate[levels].fill(false);
        accepted.remove(index);
        adopt(accepted, &trial);
        hand_over(evidence, joint, [law.cause.effect(), EffectKind::AsymmetricFriction]);
        fitted = next;
    }
    fitted
}

/// Finds a law that approximates levels on a joint with asymmetric friction: its index among the
/// accepted, and the joint.
fn beside_a_difference(accepted: &[Accepted], has_levels: impl Fn(usize) -> bool) -> Option<(usize, usize)> {
    let differs = |place: &[usize]| {
        accepted.iter().any(|a| a.chosen.cause.effect() == EffectKind::AsymmetricFriction && a.chosen.place == place)
    };
    accepted.iter().enumerate().find_map(|(index, a)| match a.chosen.place[..] {
        [joint] if NEAR.contains(&a.chosen.cause.effect()) && differs(&[joint]) && has_levels(joint) => {
            Some((index, joint))
        }
        _ => None,
    })
}
