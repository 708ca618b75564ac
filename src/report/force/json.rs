//! Report of `denavit force` as JSON, and the uncertainty read from `identify --json`.

use nalgebra::DMatrix;
use serde_json::{Value, json};

use crate::control::estimate::{COMPONENTS, Comparison, Consistency, NoiseSource, Uncertainty, Verdict, covariance};
use crate::data::signal::Prepared;
use crate::model::BaseParameter;
use crate::report::Provenance;
use crate::report::force::text::{Forces, verdict, warnings};
use crate::report::parts::fields::{FieldError, rule};

/// The result as one JSON object; wrenches per sample are in the CSV.
pub fn force_json(outcome: &Forces<'_>, prepared: &[Prepared], provenance: &Provenance) -> Value {
    let compared = |all: &[Comparison; 6]| -> Value {
        let one = |(i, c): (usize, &Comparison)| {
            let told = |x: f64| (c.samples > 0).then_some(x);
            let values = json!({
                "rms": told(c.rms), "mean": told(c.mean), "largest": told(c.largest), "half_width": told(c.half),
                "inside": told(c.inside), "told": c.observable,
            });
            (COMPONENTS[i].to_string(), values)
        };
        Value::Object(all.iter().enumerate().map(one).collect())
    };
    let consistent = |c: &Consistency| {
        json!({
            "holds": c.holds(), "ratio": c.ratio, "probability": c.probability, "widen": c.widen(), "joints": c.joints,
            "instants": c.instants,
        })
    };
    let logs: Vec<Value> = outcome
        .found
        .iter()
        .map(|s| {
            json!({
                "name": s.name,
                "estimator": s.method.name(),
                "samples": s.time.len(),
                "not_used": s.stale,
                "half_width": (0..6).map(|i| Comparison::of(s.half.iter().zip(&s.observable).map(|(h, told)| (0.0, h[i], told[i]))).half).collect::<Vec<_>>(),
                "told": (0..6).map(|i| s.observable.iter().filter(|t| t[i]).count() as f64 / s.observable.len().max(1) as f64).collect::<Vec<_>>(),
                "rms": (0..6).map(|i| Comparison::of(s.wrench.iter().map(|f| (f[i], 0.0, true))).rms).collect::<Vec<_>>(),
                "against_measured": s.against_measured().as_ref().map(compared),
                "phantom": s.phantom().as_ref().map(compared),
                "touching": s.touching.iter().filter(|t| **t).count(),
                "undecided": s.undecided.iter().filter(|t| **t).count(),
                "assumed_static_friction": s.assumed_friction.iter().map(|(j, level)| json!({ "joint": j, "at_most": level })).collect::<Vec<_>>(),
                "false_contact": s.free.iter().any(|f| *f).then(|| s.touch_share(true)),
                "verdict": judged(&s.verdict),
                "consistency": {
                    "free": s.in_free.as_ref().filter(|_| !outcome.circular()).map(consistent),
                    "unexplained": s.unexplained.as_ref().map(consistent),
                },
                "bias": s.bias,
            })
        })
        .collect();
    let provenance: serde_json::Map<String, Value> = provenance.iter().map(|(k, v)| (k.clone(), json!(v))).collect();
    json!({
        "robot": outcome.robot,
        "warnings": warnings(outcome, prepared).json(),
        "components": COMPONENTS,
        "units": { "fx": "N", "fy": "N", "fz": "N", "mx": "N m", "my": "N m", "mz": "N m", "noise": "N m", "bias": "N m" },
        "meaning": meaning(),
        "noise": outcome.uncertainty.noise,
        "known_from": outcome.known_from,
        "verdict": outcome.verdict().map(judged),
        "not_in_band": outcome.uncertainty.open,
        "logs": logs,
        "provenance": provenance,
    })
}

/// Verdict on the bands.
fn judged(v: &Verdict) -> Value {
    let (bands, widen, probability, joint) = match v {
        Verdict::Hold { probability } => ("hold", None, Some(*probability), None),
        Verdict::Doubtful { probability, widen } => ("doubtful", Some(*widen), Some(*probability), None),
        Verdict::TooWrong { widen, joint } => ("too_narrow", Some(*widen), None, joint.map(|(j, _)| j)),
        Verdict::Circular | Verdict::NotJudged => ("not_judged", None, None, None),
    };
    json!({ "bands": bands, "widen": widen, "probability": probability, "joint": joint, "sentence": verdict(v) })
}

/// Explanation of the keys, so that the file is self-explanatory.
fn meaning() -> Value {
    json!({
        "wrench": "of the surroundings on the tool, about the origin of the tool's frame, in its axes; what the tool does to them has the other sign",
        "noise": "standard deviation of each joint's torque noise after the low-pass, joint by joint",
        "known_from": "where noise and the parameters' uncertainty come from; it decides what the bands mean",
        "not_in_band": "base parameters whose errors are in no band, as nothing is known of them",
        "name": "the log",
        "estimator": "how it was estimated: --estimator",
        "samples": "instants with an estimate",
        "not_used": "those of them whose sample could not be used: the estimate is that of the sample before",
        "half_width": "mean half-width of the 95 % band, component by component",
        "told": "share of the samples in which the component is observable (near a singularity, and with fewer than six joints, some are not)",
        "rms": "root mean square of the estimate itself, component by component",
        "against_measured": "estimate less the log's fx..mz, low-passed alike, where the component is observable: rms, mean and largest error, mean half-width, share of samples inside their band; null where the log has none",
        "phantom": "the same against zero, in the stretches in which nothing touches (--free, --against nothing); null where none is known",
        "touching": "samples in which something is said to touch",
        "undecided": "samples in which static friction or contact can't be told apart: a joint is at rest, and friction within its breakaway level explains the residual torque",
        "assumed_static_friction": "joints without dry friction in the robot file, and the largest static friction assumed there, N m: in the question of contact, in no band",
        "false_contact": "share of the samples in which nothing touches that are said to touch; null where none is known",
        "consistency": "whether torque errors are as large as their predicted covariance: `free` where nothing touches, `unexplained` those that no wrench explains (more than six joints). ratio: squared errors by prediction; probability: of a larger ratio if the model is right; holds: not less than one in a thousand; widen: factor by which bands would have to be wider; joints: root mean square of each joint's error by its prediction; instants: how many were judged",
        "verdict": "whether the bands can be relied upon, of all checks together. bands: `hold`, `doubtful` (errors as large have a probability below one in twenty for a right model), `too_narrow` (the model is too wrong for them), `not_judged` (nothing to judge with, or the noise was taken from the samples that would judge it); widen: factor by which they would have to be wider; probability: the least of the checks; joint: whose errors exceed their prediction most, from 1; sentence: the same in words. At the top: of the log that fares worst",
        "bias": "torque that was taken off, joint by joint (--bias); empty if none was",
    })
}

/// Upper limit of a standard deviation: its square remains finite, and no body or drive has a
/// larger one.
const MOST: f64 = 1e12;
/// Rounding error of a correlation.
const ROUNDING: f64 = 1e-6;

/// Reads standard deviations, correlations and noise of `identify --json` for an arm with these
/// base parameters. Parameters missing in the identification are taken as exact and listed as open.
/// A robot file that was extended since has more friction, for example.
///
/// # Errors
/// The missing or invalid key, in words.
pub fn uncertainty_of_json(json: &Value, base: &[BaseParameter], dof: usize) -> Result<Uncertainty, FieldError> {
    let parameters = json["parameters"].as_array().ok_or(FieldError::Absent("parameters"))?;
    let names: Vec<&str> = parameters.iter().filter_map(|p| p["name"].as_str()).collect();
    if names.len() != parameters.len() {
        return Err(FieldError::Absent("parameters[].name"));
    }
    if let Some(k) = (1..names.len()).find(|&k| names[..k].contains(&names[k])) {
        return Err(rule("parameters[].name", format!("must be there once: {}", names[k])));
    }
    if let Some(unknown) = names.iter().find(|name| !base.iter().any(|b| b.name == **name)) {
        return Err(FieldError::Parameter((*unknown).into()));
    }
    let rows = json["correlation"].as_array().ok_or(FieldError::Absent("correlation"))?;
    let numbers = |value: &Value| -> Vec<f64> {
        value.as_array().map_or_else(Vec::new, |all| all.iter().map(|v| v.as_f64().unwrap_or(f64::NAN)).collect())
    };
    let correlation: Vec<Vec<f64>> = rows.iter().map(numbers).collect();
    if correlation.len() != names.len() || correlation.iter().any(|row| row.len() != names.len()) {
        return Err(FieldError::Absent("correlation"));
    }
    let noise = numbers(&json["noise"]["sigma"]);
    if noise.len() != dof || !noise.iter().all(|s| (0.0..MOST).contains(s)) {
        return Err(rule(
            "noise.sigma",
            format!("must have a number for each of the {dof} joints, from 0 to {MOST:e}"),
        ));
    }
    deviations_and_correlations(parameters, &names, &correlation)?;
    let place: Vec<Option<usize>> = base.iter().map(|b| names.iter().position(|n| *n == b.name)).collect();
    let told = |k: usize| parameters[k]["std"].as_f64().filter(|s| s.is_finite());
    let std: Vec<f64> = place.iter().map(|at| at.and_then(told).unwrap_or(0.0)).collect();
    let n = base.len();
    let mut all = vec![0.0; n * n];
    for i in 0..n {
        for j in 0..n {
            if let (Some(a), Some(b)) = (place[i], place[j]) {
                all[i * n + j] = correlation[a][b];
            }
        }
    }
    let open = base.iter().zip(&place).filter(|(_, at)| at.and_then(told).is_none()).map(|(b, _)| b.name.clone());
    Ok(Uncertainty {
        covariance: covariance(&std, &all),
        noise: noise.into_iter().map(|s| s.max(1e-9)).collect(),
        source: NoiseSource::Identification,
        open: open.collect(),
    })
}

/// Checks that this is a covariance: deviations from 0, correlations from -1 to 1, symmetric, and
/// no sum of parameters with a negative variance. A `null` deviation marks a parameter that the
/// data do not determine; its correlations are not checked.
fn deviations_and_correlations(
    parameters: &[Value],
    names: &[&str],
    correlation: &[Vec<f64>],
) -> Result<(), FieldError> {
    let std = |k: usize| &parameters[k]["std"];
    let good = |k: usize| std(k).is_null() || std(k).as_f64().is_some_and(|s| (0.0..MOST).contains(&s));
    if let Some(k) = (0..names.len()).find(|k| !good(*k)) {
        let said = format!("must be from 0 to {MOST:e}, or null: {} is {}", names[k], std(k));
        return Err(rule("parameters[].std", said));
    }
    let told: Vec<usize> = (0..names.len()).filter(|k| std(*k).as_f64().is_some_and(|s| s > 0.0)).collect();
    for &i in &told {
        for &k in &told {
            let (here, there) = (correlation[i][k], correlation[k][i]);
            // NaN lies in no range.
            let what = if !(-1.0 - ROUNDING..=1.0 + ROUNDING).contains(&here) {
                "from -1 to 1"
            } else if i == k && here < 1.0 - ROUNDING {
                "1 of a parameter with itself"
            } else if !(-ROUNDING..=ROUNDING).contains(&(here - there)) {
                "the same both ways"
            } else {
                continue;
            };
            return Err(rule("correlation", format!("must be {what}: that of {} and {} is not", names[i], names[k])));
        }
    }
    let size = told.len();
    if size == 0 {
        return Ok(());
    }
    let matrix = DMatrix::from_fn(size, size, |i, k| correlation[told[i]][told[k]]);
    let least = matrix.symmetric_eigenvalues().min();
    if least < -ROUNDING * size as f64 {
        let said = format!("must be positive semidefinite: its least eigenvalue is {least:.2e}");
        return Err(rule("correlation", said));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::identify::planar::Planar;
    use crate::model::Arm;

    fn base(names: [&str; 3]) -> Vec<BaseParameter> {
        let mut base = Planar::new().base_parameters()[..3].to_vec();
        base.iter_mut().zip(names).for_each(|(parameter, name)| parameter.name = name.into());
        base
    }

    fn said(change: impl Fn(&mut Value)) -> Result<Uncertainty, FieldError> {
        let parameter = |name: &str, std: f64| json!({ "name": name, "std": std });
        let mut json = json!({
            "parameters": [parameter("a", 0.1), parameter("b", 0.2), parameter("c", 0.3)],
            "correlation": [[1.0, 0.9, 0.8], [0.9, 1.0, 0.7], [0.8, 0.7, 1.0]],
            "noise": { "sigma": [0.1, 0.2] },
        });
        change(&mut json);
        uncertainty_of_json(&json, &base(["a", "b", "c"]), 2)
    }

    #[test]
    fn an_uncertainty_must_be_one() {
        let known = said(|_| {}).unwrap();
        assert!((known.covariance[1] - 0.9 * 0.1 * 0.2).abs() < 1e-15 && known.open.is_empty());
        let both = |json: &mut Value, i: usize, k: usize, r: Value| {
            (json["correlation"][i][k], json["correlation"][k][i]) = (r.clone(), r);
        };
        // Not determined by the data: no correlation with others.
        let open = said(|json| {
            json["parameters"][1]["std"] = Value::Null;
            both(json, 0, 1, Value::Null);
        });
        assert!(open.is_ok_and(|known| known.open == ["b"] && known.covariance[1] == 0.0));
        let refused = |change: &dyn Fn(&mut Value), what: &str| {
            let error = said(change).unwrap_err().to_string();
            assert!(error.contains(what), "{error}");
        };
        for std in [json!(-0.1), json!(1e300), json!("0.1"), json!(true)] {
            refused(&|json| json["parameters"][0]["std"] = std.clone(), "`parameters[].std` must be from 0 to 1e12");
        }
        refused(&|json| both(json, 0, 1, json!(1.1)), "from -1 to 1: that of a and b");
        refused(&|json| both(json, 0, 2, json!(-1e9)), "from -1 to 1: that of a and c");
        refused(&|json| both(json, 0, 1, Value::Null), "from -1 to 1: that of a and b");
        refused(&|json| json["correlation"][0][1] = json!(0.5), "the same both ways");
        refused(&|json| json["correlation"][2][2] = json!(0.5), "1 of a parameter with itself");
        // Each pair is possible, all three together are not.
        refused(&|json| both(json, 1, 2, json!(-0.9)), "positive semidefinite: its least eigenvalue is -");
        refused(&|json| json["correlation"][1] = json!([1.0]), "`correlation`");
        refused(&|json| json["noise"]["sigma"] = json!([0.1]), "noise.sigma");
        refused(&|json| json["noise"]["sigma"] = json!([0.1, -0.2]), "noise.sigma");
        refused(&|json| json["parameters"][2]["name"] = json!("a"), "must be there once: a");
    }
}
