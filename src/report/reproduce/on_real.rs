//! Report on causes added to real recordings: tables, a verdict, the cases as JSON.

use serde_json::{Value, json};

use super::diagnosis::{binned, percent, share};
use crate::apps::paper::diagnosis::Claim;
use crate::apps::paper::diagnosis::real::{Figures, RealBattery, RealCase, calibration_error, reliability};
use crate::diagnose::{Cause, Diagnosis};
use crate::report::parts::number::digits;
use crate::report::reproduce::text::Table;

/// Required share of cases in which the right cause is named first, by its size.
fn wanted(size: f64) -> f64 {
    if size >= 3.0 {
        0.95
    } else if size >= 1.0 {
        0.85
    } else {
        0.60
    }
}

fn claims(found: &RealBattery) -> Vec<Claim> {
    found.figures.iter().flat_map(|f| f.claims.iter().copied()).collect()
}

/// The verdict in one paragraph.
pub(in crate::report) fn verdict(found: &RealBattery) -> String {
    let each = |f: &Figures| format!("{} at {} residuals", percent(f.first), f.size);
    format!(
        "Causes added to recordings of {} arms from seed {}; of those whose size an informed fit recovers, named first among the new causes: {}. Expected calibration error {}.",
        found.untouched.len(),
        found.settings.seed,
        found.figures.iter().map(each).collect::<Vec<_>>().join(", "),
        calibration_error(&claims(found)).map_or("–".into(), |e| digits(e, 2)),
    )
}

/// Figures by size, reliability of probabilities, stability, wrong cases.
pub(in crate::report) fn tables(found: &RealBattery) -> Vec<Table> {
    let row = |f: &Figures| {
        vec![
            f.size.to_string(),
            percent(f.recovered),
            percent(f.named),
            percent(f.first),
            format!("{:.0} %", 100.0 * wanted(f.size)),
            percent(f.sure),
            percent(f.place),
            percent(f.within_three),
            digits(f.false_new, 2),
        ]
    };
    let figures = Table {
        title: "Causes added to real recordings".into(),
        note: format!(
            "Sizes in root mean squares of the identified model's residual; all columns behind the second are of the cases whose size an informed fit recovers within 20 %, false new causes of all.{}",
            found.skipped.iter().map(|s| format!(" Skipped: {s}.")).collect::<String>()
        ),
        head: vec![
            "size",
            "recovered by an informed fit",
            "named in place",
            "first",
            "wanted",
            "above 0.5",
            "right joint",
            "within 3 std",
            "false new per case",
        ],
        rows: found.figures.iter().map(row).collect(),
    };
    vec![figures, probabilities(found), stability(found), misses(found)]
}

/// Stated probabilities against true shares.
fn probabilities(found: &RealBattery) -> Table {
    Table {
        title: "Stated probability of new causes and share true".into(),
        note: "All new causes of all sizes; right: added, and there.".into(),
        head: vec!["probability", "mean", "right"],
        rows: reliability(&claims(found))
            .into_iter()
            .map(|(low, high, mean, share)| vec![format!("{low:.1} to {high:.1}"), digits(mean, 3), percent(share)])
            .collect(),
    }
}

/// Causes of the untouched logs that recur in halves of the excerpt.
fn stability(found: &RealBattery) -> Table {
    Table {
        title: "Causes of the untouched logs".into(),
        note: format!(
            "In how many halves of the excerpt the same cause is found; above 0.8 in both: {}.",
            percent(found.stability.sure)
        ),
        head: vec!["arm", "cause", "joints", "probability", "in halves"],
        rows: found
            .stability
            .causes
            .iter()
            .map(|(arm, cause, joints, p, there)| {
                vec![
                    arm.clone(),
                    (*cause).into(),
                    format!("{joints:?}"),
                    format!("{p:.2}"),
                    format!("{} of {}", there.good, there.all),
                ]
            })
            .collect(),
    }
}

/// Cases in which another cause came first.
fn misses(found: &RealBattery) -> Table {
    let wrong = |c: &&RealCase| c.recovered() && !c.fresh().next().is_some_and(|cause| c.right(cause));
    Table {
        title: "Cases that went wrong".into(),
        note: "What was added, and all that was named beyond the causes of the untouched logs.".into(),
        head: vec!["arm", "size", "added", "named"],
        rows: found
            .cases
            .iter()
            .filter(wrong)
            .map(|c| {
                let named: Vec<String> =
                    c.fresh().map(|f| format!("{} {:?} {:.2}", f.cause, f.joints, f.probability)).collect();
                let added = format!("{} {:?}", c.added.cause, c.added.joints);
                vec![
                    c.arm.clone(),
                    c.size.to_string(),
                    added,
                    format!("{}: {}", c.found.verdict.word(), named.join("; ")),
                ]
            })
            .collect(),
    }
}

/// Settings, figures and cases as JSON.
pub(in crate::report) fn to_json(found: &RealBattery) -> Value {
    json!({
        "settings": { "cases": found.settings.cases, "seed": found.settings.seed, "sizes": found.settings.sizes, "seconds": found.settings.seconds },
        "figures": found.figures.iter().map(|f| json!({
            "size": f.size, "recovered_by_informed_fit": share(f.recovered), "named_in_place": share(f.named),
            "first_among_new": share(f.first), "above_one_half": share(f.sure), "right_joint": share(f.place),
            "within_three": share(f.within_three), "false_new_per_case": f.false_new,
        })).collect::<Vec<_>>(),
        "calibration_error": calibration_error(&claims(found)),
        "reliability": binned(&reliability(&claims(found))),
        "stable_above_0.8": share(found.stability.sure),
        "untouched": found.untouched.iter().map(|u| json!({
            "arm": u.arm, "residual": u.residual, "diagnosis": diagnosis(&u.whole),
            "halves": u.halves.iter().map(|h| h.as_ref().map(diagnosis)).collect::<Vec<_>>(),
        })).collect::<Vec<_>>(),
        "skipped": found.skipped,
        "cases": found.cases.iter().map(case).collect::<Vec<_>>(),
    })
}

fn diagnosis(found: &Diagnosis) -> Value {
    json!({
        "verdict": found.verdict.word(), "offered": found.offer.offered.word(), "noise_floor": found.noise_floor,
        "baseline": found.baseline.validate, "refitted": found.refitted.validate, "extended": found.extended.validate,
        "causes": found.causes.iter().map(|c| cause(c, None)).collect::<Vec<_>>(),
    })
}

fn case(c: &RealCase) -> Value {
    let parameters: Vec<Value> =
        c.parameters().iter().map(|(symbol, truth, value, std)| json!([symbol, truth, value, std])).collect();
    json!({
        "arm": c.arm, "size": c.size, "cause": c.added.cause, "joints": c.added.joints,
        "truth": c.added.truth.iter().map(|(symbol, value)| json!([symbol, value])).collect::<Vec<_>>(),
        "added_rms": c.added.rms, "informed": c.informed, "recovered": c.recovered(), "parameters": parameters,
        "diagnosis": diagnosis(&c.found),
        "new": c.fresh().map(|f| cause(f, Some(c.right(f)))).collect::<Vec<_>>(),
    })
}

fn cause(c: &Cause, right: Option<bool>) -> Value {
    let parameters: Vec<Value> = c.parameters.iter().map(|p| json!([p.symbol, p.value, p.std])).collect();
    json!({
        "cause": c.cause, "joints": c.joints, "probability": c.probability, "right": right, "support": c.support,
        "margin": c.margin, "share": c.share, "recurrence": c.recurrence, "found_in_excerpts": c.found_again, "parameters": parameters, "not_distinguished_from": c.not_distinguished_from,
        "rms_before": c.rms_before, "rms_after": c.rms_after, "in_extended": c.in_extended,
    })
}
