//! Selects the terms of the extended model: causes and friction that are significant and hold on
//! left-out stretches.

use super::measure::{delays_without, reduced};
use super::model_choice::{LeftOut, Paired};
use super::remark::Remark;
use crate::diagnose::findings::reported_cause::{Item, items};
use crate::diagnose::fit::likelihood::gain;
use crate::diagnose::fit::model::{Chosen, Fitted, Mode, ModelUnderTest, given_friction, local};
use crate::diagnose::fit::moments::Moments;
use crate::diagnose::fit::uncertainty::Uncertainty;
use crate::diagnose::search::judge::{Accepted, SURE, adopt, chosen_of};
use crate::diagnose::windows::recording::Recording;
use crate::model::PerturbableArm;

/// Restores the file's delays for the joints of a removed delay cause.
fn take_back_delay(tested: &mut ModelUnderTest<'_>, gone: &Chosen) {
    if gone.cause.moves_time() {
        tested.set_delays(&delays_without(tested.plant, &tested.scene.delays, gone.cause, &gone.place));
    }
}

/// Removes some accepted causes from the model and refits it.
pub(in crate::diagnose) fn without(
    tested: &mut ModelUnderTest<'_>,
    accepted: &mut Vec<Accepted>,
    out: &[usize],
) -> Fitted {
    out.iter().for_each(|&i| take_back_delay(tested, &accepted[i].chosen));
    let mut index = 0;
    accepted.retain(|_| {
        index += 1;
        !out.contains(&(index - 1))
    });
    let mut chosen = chosen_of(accepted);
    let fitted = tested.fit(&mut chosen);
    adopt(accepted, &chosen);
    fitted
}

/// Gain on left-out stretches of a fitted model over the same model without one of its causes,
/// which must not be a delay.
pub(in crate::diagnose) fn gain_on_left_out(
    stretches: &Moments,
    fitted: &Fitted,
    chosen: &[Chosen],
    item: &Item,
    ground: &[f64],
) -> Paired {
    let (counts, local) = (stretches.counts(), local(chosen, fitted));
    let of = |out: &[usize]| LeftOut::new(&stretches.cross_validated_without(&fitted.solution, out, &local), &counts);
    of(&[]).less(&of(&item.unknowns(fitted)), ground)
}

/// Removes, one after the other, causes that increase the error on stretches of the fitted logs
/// that are left out in turn.
pub(in crate::diagnose) fn backward_eliminate(
    plant: &dyn PerturbableArm,
    fit: &[Recording],
    tested: &mut ModelUnderTest<'_>,
    accepted: &mut Vec<Accepted>,
    mut fitted: Fitted,
    ground: &[f64],
    why: &mut Vec<Remark>,
) -> Fitted {
    for round in 0..12 {
        let chosen = chosen_of(accepted);
        let items = items(tested, accepted, &fitted);
        let stretches = tested.stretches(&fitted);
        let mut worst: Option<(&Item, Paired)> = None;
        for item in items.iter().filter(|i| !i.hypothesis.local()) {
            let paired = if item.hypothesis.moves_time() {
                if round > 0 {
                    continue;
                }
                let (reduced, others, fitted_without) = reduced(plant, fit, tested, &chosen, item);
                tested.left_out(&chosen, &fitted).less(&reduced.left_out(&others, &fitted_without), ground)
            } else {
                gain_on_left_out(&stretches, &fitted, &chosen, item, ground)
            };
            if paired.gain < -1e-6 && worst.as_ref().is_none_or(|(_, least)| paired.gain < least.gain) {
                worst = Some((item, paired));
            }
        }
        let Some((item, paired)) = worst else { break };
        let predicate = format!(
            "is not in the model: without it the squared error of stretches of the fitted logs that were left out is {:.1} +- {:.1} % less.",
            -200.0 * paired.gain,
            200.0 * paired.error
        );
        why.push(Remark::on(item.hypothesis.name(), &item.place, &predicate));
        item.friction.iter().for_each(|&k| tested.frozen[k] = true);
        let out: Vec<usize> = item.accepted.into_iter().collect();
        fitted = without(tested, accepted, &out);
    }
    fitted
}

/// Removes causes whose parameters are zero within their uncertainty, the least significant first.
pub(in crate::diagnose) fn drop_insignificant(
    tested: &mut ModelUnderTest<'_>,
    accepted: &mut Vec<Accepted>,
    mut fitted: Fitted,
    noise: &[f64],
) -> Fitted {
    loop {
        let chosen = chosen_of(accepted);
        let uncertainty = Uncertainty::of(tested, &fitted, &chosen);
        let least = (0..chosen.len())
            .map(|index| (index, uncertainty.exceeds_zero(tested, &fitted, index, &chosen[index])))
            .min_by(|a, b| a.1.total_cmp(&b.1));
        let Some((index, _)) = least.filter(|l| l.1 < 0.0) else { return fitted };
        let gone = accepted.remove(index).chosen;
        // Plain friction may have been dropped in favour of the removed cause.
        gone.place.iter().for_each(|j| tested.frozen[3 * j..3 * j + 3].fill(false));
        take_back_delay(tested, &gone);
        fitted = fix_friction(tested, accepted, noise);
    }
}

/// Fixes friction parameters at the file's values where the data do not support a change.
pub(in crate::diagnose) fn fix_friction(
    tested: &mut ModelUnderTest<'_>,
    accepted: &mut [Accepted],
    noise: &[f64],
) -> Fitted {
    let mut chosen = chosen_of(accepted);
    let mut fitted = tested.fit(&mut chosen);
    let given = given_friction(tested.plant);
    for _ in 0..4 {
        let covariance = fitted.covariance();
        let mut changed = false;
        for j in 0..tested.scene.dof() {
            // Fix one at a time: of two nearly equivalent terms, neither appears significant while
            // the other is free.
            let mut least: Option<(usize, f64)> = None;
            for which in 0..3 {
                let k = 3 * j + which;
                if tested.frozen[k] {
                    continue;
                }
                let at = fitted.friction + k;
                let (value, std) = (fitted.solution.x[at], covariance[(at, at)].max(0.0).sqrt());
                // Torque RMS of this column that no other column explains: 1 / sqrt(inverse
                // diagonal) is that column's own size.
                let own = fitted.solution.inverse[(at, at)];
                let weight = fitted.solution.weights[j] * fitted.solution.counts[j];
                let effect = if own > 0.0 && weight > 0.0 { value.abs() / (own * weight).sqrt() } else { 0.0 };
                let small = value.abs() < 0.04 * given[j][which].unwrap_or(0.0).abs();
                // Friction that drives the joint is rejected. Where the file has some, the
                // constrained fit ends at zero.
                let file = given[j][which].unwrap_or(0.0);
                let drives = which < 2 && file <= 0.0 && file + value < 0.0;
                let mut sure = if std > 0.0 { value.abs() / std } else { 0.0 };
                if sure < SURE && effect >= 0.2 * noise[j] && !small && !drives {
                    sure = sure.max(beside_slow(tested, &fitted, at));
                }
                if (sure < SURE || effect < 0.2 * noise[j] || small || drives) && least.is_none_or(|(_, s)| sure < s) {
                    least = Some((k, sure));
                }
            }
            if let Some((k, _)) = least {
                tested.frozen[k] = true;
                changed = true;
            }
        }
        if !changed {
            break;
        }
        fitted = tested.fit(&mut chosen);
    }
    adopt(accepted, &chosen);
    fitted
}

/// Standard deviations from 0 of an unknown, with autoregressive errors.
fn beside_slow(tested: &ModelUnderTest<'_>, fitted: &Fitted, at: usize) -> f64 {
    let inverse = &fitted.solution.inverse;
    let own = inverse[(at, at)];
    if own <= 0.0 {
        return 0.0;
    }
    // The solution with this unknown at 0.
    let x = &fitted.solution.x - inverse.column(at) * (fitted.solution.x[at] / own);
    gain(&fitted.moments.residual(&x), &fitted.residual, &tested.scene.live).max(0.0).sqrt()
}

/// Frees all friction if all base parameters are unknown, so that the model is never less than a
/// plain refit. This includes terms fixed at the file's values because they are too small or too
/// uncertain to be named. Friction that would drive a joint ends at zero in the constrained fit.
pub(in crate::diagnose) fn free_friction(
    tested: &mut ModelUnderTest<'_>,
    accepted: &mut [Accepted],
    fitted: Fitted,
) -> Fitted {
    if tested.mode != Mode::Refitted {
        return fitted;
    }
    let frozen = tested.frozen.clone();
    let mut chosen = chosen_of(accepted);
    tested.quiet.clone_from(&frozen);
    tested.frozen.iter_mut().for_each(|f| *f = false);
    let fitted = tested.fit(&mut chosen);
    adopt(accepted, &chosen);
    fitted
}
