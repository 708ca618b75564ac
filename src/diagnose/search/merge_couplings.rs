//! Merges couplings of one pair of joints that belong to the same motor.

use super::judge::{Accepted, adopt, chosen_of};
use crate::diagnose::fit::model::{Chosen, Fitted, ModelUnderTest};
use dh_codegen::robot::EffectKind;

/// Merges couplings found from either joint of a pair into one cause: a motor that turns with `dq_m
/// + KC dq_k`, `KC` 1 or -1, has the same form from both.
pub(in crate::diagnose) fn merge_couplings(
    tested: &mut ModelUnderTest<'_>,
    accepted: &mut Vec<Accepted>,
    fitted: &mut Fitted,
) {
    let before = accepted.len();
    while let Some((first, second)) = same_motor(accepted) {
        let other = accepted.remove(second);
        let kept = &mut accepted[first];
        let parts = |c: &Chosen| c.shape[1] as u32;
        kept.chosen.shape[1] = f64::from(parts(&kept.chosen) | parts(&other.chosen));
        kept.support = kept.support.max(other.support);
        kept.variance += other.variance;
    }
    if accepted.len() < before {
        let mut chosen = chosen_of(accepted);
        *fitted = tested.fit(&mut chosen);
        adopt(accepted, &chosen);
    }
}

/// Indices of two couplings of the same motor, the earlier one first.
fn same_motor(accepted: &[Accepted]) -> Option<(usize, usize)> {
    let turned = |a: &[usize], b: &[usize]| a.iter().eq(b.iter().rev());
    let same = |a: &Chosen, b: &Chosen| match (&a.shape[..], &b.shape[..]) {
        ([one, _], [other, _]) => one == other && one.abs() == 1.0 && turned(&a.place, &b.place),
        _ => false,
    };
    let coupling = |i: &usize| accepted[*i].chosen.cause.effect() == EffectKind::GearCoupling;
    let all: Vec<usize> = (0..accepted.len()).filter(coupling).collect();
    let pairs = all.iter().flat_map(|&i| all.iter().map(move |&k| (i, k))).filter(|(i, k)| i < k);
    pairs.into_iter().find(|(i, k)| same(&accepted[*i].chosen, &accepted[*k].chosen))
}
