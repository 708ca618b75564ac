//! Merges equal delays of several joints into one.

use super::judge::{Accepted, adopt, chosen_of};
use crate::diagnose::fit::model::{Fitted, ModelUnderTest};
use crate::diagnose::fit::white_errors::{cost_of_unknown, lost_by};

/// Replaces the delays of several joints that agree within their uncertainty by one common delay,
/// as of a clock or a bus. It is accepted if it loses less than the cost of the unknowns that it
/// saves.
pub(in crate::diagnose) fn merge_common_delay(
    tested: &mut ModelUnderTest<'_>,
    accepted: &mut Vec<Accepted>,
    fitted: &mut Fitted,
) {
    let late: Vec<usize> = (0..accepted.len())
        .filter(|&i| accepted[i].chosen.cause.moves_time() && accepted[i].chosen.place.len() == 1)
        .collect();
    let common = accepted.iter().any(|a| a.chosen.cause.moves_time() && a.chosen.place.is_empty());
    if late.len() < 2 || common {
        return;
    }
    let covariance = fitted.covariance();
    // Joint, delay, variance: at least that of half a sample.
    let of = |i: usize| {
        let (joint, at) = (accepted[i].chosen.place[0], fitted.first[i]);
        let sampled = (0.5 * tested.scene.period).powi(2) / 3.0;
        (joint, tested.scene.delays[joint], covariance[(at, at)].max(0.0) + sampled)
    };
    let alike = |i: usize, k: usize| {
        let ((_, a, va), (_, b, vb)) = (of(i), of(k));
        (a - b).abs() <= 3.0 * (va + vb).sqrt()
    };
    // The largest group of delays that agree with one of them.
    let company = |i: usize| late.iter().copied().filter(|&k| alike(i, k)).collect::<Vec<usize>>();
    let Some(group) = late.iter().map(|&i| company(i)).max_by_key(Vec::len).filter(|g| g.len() > 1) else { return };
    let weight: f64 = group.iter().map(|&i| 1.0 / of(i).2).sum();
    let mean = group.iter().map(|&i| of(i).1 / of(i).2).sum::<f64>() / weight;
    let own: Vec<usize> = late.iter().map(|&i| of(i).0).collect();
    let members: Vec<usize> = group.iter().map(|&i| of(i).0).collect();
    let before = tested.scene.delays.clone();
    let wanted = |(j, was): (usize, &f64)| if own.contains(&j) && !members.contains(&j) { *was } else { mean };
    tested.set_delays(&before.iter().enumerate().map(wanted).collect::<Vec<f64>>());
    let mut kept: Vec<Accepted> =
        accepted.iter().enumerate().filter(|(i, _)| !group.contains(i)).map(|(_, a)| a.clone()).collect();
    let mut one = accepted[group[0]].clone();
    one.chosen.place = Vec::new();
    one.chosen.x = vec![0.0];
    one.support = group.iter().map(|&i| accepted[i].support).fold(f64::NEG_INFINITY, f64::max);
    one.variance = group.iter().map(|&i| accepted[i].variance).sum();
    kept.insert(group[0].min(kept.len()), one);
    let mut chosen = chosen_of(&kept);
    let next = tested.fit(&mut chosen);
    let (lost, independent) = lost_by(fitted, &next, &next);
    let saved = (group.len() - 1) as f64 * cost_of_unknown(independent);
    if lost < saved {
        adopt(&mut kept, &chosen);
        (*accepted, *fitted) = (kept, next);
        return;
    }
    tested.set_delays(&before);
    let mut chosen = chosen_of(accepted);
    *fitted = tested.fit(&mut chosen);
    adopt(accepted, &chosen);
}
