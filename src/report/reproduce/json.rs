//! The paper's experiments as JSON.

use serde_json::{Value, json};

use crate::apps::paper::{Experiment, fig6, table3};
use crate::report::reproduce::diagnosis;
use crate::report::reproduce::excitation;
use crate::report::reproduce::force;
use crate::report::reproduce::on_real;
use crate::report::reproduce::painting;
use crate::report::reproduce::text::Parts;

/// One key per part of the paper.
pub fn reproduce_json(parts: &Parts) -> Value {
    json!({
        "excitation": parts.excitation.as_ref().map(excitation::to_json),
        "identification": parts.identification.as_ref().map(identification),
        "painting": parts.painting.as_ref().map(painting::to_json),
        "force": parts.force.as_ref().map(force::to_json),
        "diagnosis": parts.diagnosis.as_ref().map(diagnosis::to_json),
        "on_real": parts.on_real.as_ref().map(on_real::to_json),
    })
}

fn identification(found: &Experiment) -> Value {
    let bars = |b: &fig6::Bars| json!({ "rms": b.rms, "nrms": b.nrms, "mean": b.mean(), "uncertainty": b.uncertainty });
    let [order, paper_order] = fig6::order(&found.fig6);
    json!({
        "runs": found.settings.runs,
        "seed": found.settings.seed,
        "control": "position",
        "torque_noise": found.noise,
        "noise_floor": found.floor,
        "motions": found.motions.iter().map(|m| json!({
            "name": m.name, "seconds": m.seconds, "condition_number": m.condition, "log_det": m.log_det, "speed": m.speed,
        })).collect::<Vec<_>>(),
        "fig6": { "order": order, "paper_order": paper_order, "rows": found.fig6.iter().map(|r| json!({
            "criterion": r.criterion, "paper": r.paper, "noise_only": bars(&r.noise_only), "unmodelled": bars(&r.unmodelled),
            "true_parameters": r.true_parameters, "above_floor": r.above_floor(), "explained": r.explained(),
            "at_floor": r.at_floor().to_string(), "verdict": r.verdict().to_string(),
        })).collect::<Vec<_>>() },
        "missing": found.missing.iter().map(|m| json!({ "effect": m.effect.name(), "rms": m.rms })).collect::<Vec<_>>(),
        "table2": found.table2.iter().map(|r| json!({
            "name": r.printed.name, "true": r.truth, "value": r.noise_only[0], "std": r.noise_only[1],
            "relative_std_percent": r.percent(), "unmodelled": { "value": r.unmodelled[0], "std": r.unmodelled[1], "textbook_std": r.textbook },
            "paper": { "value": r.printed.paper[0], "relative_std_percent": r.printed.paper[1], "cad": r.printed.cad },
            "jubien": { "value": r.printed.jubien[0], "relative_std_percent": r.printed.jubien[1] },
            "verdict": r.verdict().to_string(),
            "textbook_percent": finite(r.textbook_percent()), "like_for_like": r.like_for_like().to_string(),
        })).collect::<Vec<_>>(),
        "within_three_unmodelled": found.within_unmodelled,
        "honesty": found.honesty.as_ref().map(|h| json!({
            "runs": h.runs, "within_three": h.within_three, "within_95": h.within_band, "spread": h.spread, "held_out_by_floor": h.held_out,
            "parameters": h.parameters.iter().map(|(name, share, spread)| json!({
                "name": name, "within_three": share, "spread": spread,
            })).collect::<Vec<_>>(),
        })),
        "table3": found.table3.iter().map(|c| json!({
            "tool": c.tool,
            "mass_error_percent": c.mass_error_percent,
            "center_error": finite(c.center_error),
            "center_std": finite(c.center_std),
            "rows": c.rows.iter().map(|r| json!({
                "name": r.name, "true": r.truth, "value": r.ours[0], "std": finite(r.ours[1]),
                "paper": { "value": r.paper[0], "std": r.paper[1] }, "verdict": table3::verdict(r).to_string(),
            })).collect::<Vec<_>>(),
        })).collect::<Vec<_>>(),
        "table3_repeated": found.rollers.iter().map(|r| json!({
            "logs": r.case.logs, "scale": r.case.scale, "runs": r.center_within.all, "mass_within": r.mass_within.value(), "center_rms": finite(r.center_rms),
            "center_std": finite(r.center_std), "center_worst": finite(r.center_worst), "center_within": r.center_within.value(),
            "center_within_interval": r.center_within.interval(), "spread": finite(r.spread), "holds": r.holds(),
        })).collect::<Vec<_>>(),
        "fig10": {
            "rms": found.fig10.errors.with_tool.rms,
            "torque_rms": found.fig10.errors.with_tool.torque_rms,
            "mass": found.fig10.mass[0],
            "true_mass": found.fig10.mass[1],
            "verdict": (0..found.floor.len()).map(|j| found.fig10.verdict(j).to_string()).collect::<Vec<_>>(),
        },
    })
}

fn finite(x: f64) -> Option<f64> {
    x.is_finite().then_some(x)
}
