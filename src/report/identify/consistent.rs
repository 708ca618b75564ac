//! Report on physically possible bodies: their cost, as text and as JSON.

use std::fmt::Write;

use dh_codegen::robot::effects::{GearCoupling, RotorInertia};
use serde_json::{Value, json};

use crate::data::signal::Prepared;
use crate::identify::{
    Accuracy, Better, Consistent, ConsistentError, Extrapolation, Factors, Identification, LeftOutError, Nonnegative,
    Preference, Source, Standing, Underdetermined, accuracy,
};
use crate::report::Warnings;
use crate::report::parts::number::{figure, pad, percent};

const ROTOR: &str = RotorInertia::NAME;
const COUPLING: &str = GearCoupling::NAME;

/// Result of the search for possible bodies.
#[derive(Debug, Clone)]
pub struct Possible<'a> {
    /// The bodies, or the reason why there are none.
    pub result: Result<&'a Consistent, &'a ConsistentError>,
    /// Whether the robot file contains their values (`None` if none was written).
    pub written: Option<bool>,
    /// Whether the written bodies have exactly the plain solution's base parameters, because that
    /// is possible itself.
    pub plain: bool,
    /// If the validating logs prefer the plain solution: comparison on parts of the fitted logs
    /// that were left out in turn.
    pub left_out: Option<&'a Result<Preference, LeftOutError>>,
}

fn source(source: Source) -> &'static str {
    match source {
        Source::File => "file",
        Source::Thickened => "file, thickened",
        Source::Geometric => "geometric",
        Source::Impossible => "geometric, the file's is impossible",
    }
}

/// `"consistent"` of `identify --json`.
pub fn consistent_json(possible: &Possible<'_>) -> Value {
    let c = match possible.result {
        Ok(c) => c,
        Err(error) => {
            let status = match error {
                ConsistentError::Contradiction { .. } => "contradiction",
                _ => "failed",
            };
            return json!({ "status": status, "reason": error.to_string(), "written": possible.written });
        }
    };
    let preference = |p: &Preference| {
        let better = match p.better() {
            Better::First => "plain",
            Better::Second => "bodies",
            Better::Open => "open",
        };
        json!({ "percent": p.percent, "interval": p.interval, "stretches": p.stretches, "independent": p.independent, "better": better })
    };
    let each = |pick: fn(&Accuracy) -> &Vec<f64>| {
        json!({
            "fit": pick(&c.cost.fit),
            "validate": c.cost.validation.as_ref().map(pick),
            "fit_possible": pick(&c.possible.fit),
            "validate_possible": c.possible.validation.as_ref().map(pick),
        })
    };
    json!({
        "status": "possible",
        "written": possible.written,
        "written_is_plain": possible.plain,
        "parameters": c.names.iter().zip(&c.base).map(|(name, value)| json!({"name": name, "value": value})).collect::<Vec<_>>(),
        "standard": c.standard,
        "rms": each(|a| &a.rms),
        "nrms": each(|a| &a.nrms),
        "growth_percent": { "possible": c.possible.growth_percent, "with_prior": c.cost.growth_percent, "significant": c.significant, "allowed": c.most_cost_percent },
        "prior": {
            "weight": c.prior_weight,
            "sources": c.sources.iter().map(|s| source(*s)).collect::<Vec<_>>(),
            "distances": c.distances,
        },
        "against_plain": {
            "validate": c.against_plain.as_ref().map(preference),
            "left_out": possible.left_out.and_then(|l| l.as_ref().ok()).map(preference),
        },
        "margin": c.margin,
        "margins": c.margins,
        "at_the_edge": c.at_the_edge,
        "total_mass": c.total_mass,
        "steps": c.steps,
    })
}

/// Cost of physical consistency and of the prior, in a sentence.
pub(in crate::report) fn paid(c: &Consistent) -> String {
    format!(
        "Links that are possible bodies leave {} % more weighted residual than free parameters, {}; with the prior (weight {}) {} %. Together they weigh {} kg.",
        percent(c.possible.growth_percent.max(0.0)),
        if c.significant {
            "more than noise explains: an effect that the model lacks may be the reason (`denavit diagnose`)"
        } else {
            "no more than noise explains"
        },
        figure(c.prior_weight),
        percent(c.cost.growth_percent.max(0.0)),
        figure(c.total_mass)
    )
}

/// The bodies' error relative to the plain fit's: `9.7 % larger (95 %: +2.1 to +18 %)`.
fn beside(p: &Preference) -> String {
    let [low, high] = p.interval;
    let word = if p.percent < 0.0 { "smaller" } else { "larger" };
    format!("{} % {word} (95 %: {} to {} %)", percent(p.percent.abs()), signed(low), signed(high))
}

fn signed(x: f64) -> String {
    let size = percent(x.abs());
    if size == "0.00" { size } else { format!("{}{size}", if x < 0.0 { "-" } else { "+" }) }
}

/// The three parameters in which the plain solution is furthest from the bodies, in its own
/// standard deviations: `XY7 = 0.366 ± 0.081 (bodies: 0)`.
fn furthest(found: &Identification, c: &Consistent) -> String {
    let mut all: Vec<_> =
        found.parameters.iter().zip(&c.base).filter(|(p, _)| p.standing == Standing::Identified).collect();
    let far = |(p, bodies): &(&_, &f64)| -> f64 {
        let p: &crate::identify::Estimate = p;
        (p.value - **bodies).abs() / p.std
    };
    all.sort_by(|a, b| far(b).total_cmp(&far(a)));
    let one = |(p, bodies): &(&crate::identify::Estimate, &f64)| {
        format!("{} = {} ± {} (bodies: {})", p.name, figure(p.value), figure(p.std), figure(**bodies))
    };
    all.iter().take(3).map(one).collect::<Vec<_>>().join(", ")
}

/// Whether bodies or the plain solution predict the validating logs better, and the consequence.
pub(in crate::report) fn preferred(found: &Identification, c: &Consistent, possible: &Possible<'_>) -> Option<String> {
    let against = c.against_plain.as_ref()?;
    let error =
        format!("On the validating logs the error of the bodies is {} than that of the plain fit", beside(against));
    Some(match against.better() {
        Better::Second => format!("{error}: bodies predict better."),
        Better::Open => format!("{error}: these logs can't decide which is better."),
        Better::First => {
            let wants = format!("{error}: no possible body explains the data, above all in {}.", furthest(found, c));
            let elsewhere = match possible.left_out {
                Some(Ok(p)) if p.better() == Better::First => format!(
                    " On parts of the fitted logs that were left out in turn it is {} too: the model lacks something. `denavit diagnose` looks for it; a drive of which the \
                     torque is the motor's needs `{ROTOR}: 0` in the robot file, a wrist with coupled gears `{COUPLING}`. `--consistent=never` keeps the plain values where links that could be built have them.",
                    beside(p)
                ),
                Some(Ok(p)) if p.better() == Better::Second => format!(
                    " On parts of the fitted logs that were left out in turn it is {}: bodies predict better where the motion is new. The validating logs most likely repeat fitted motion, and reward the plain fit for fitting errors of the model. Validate on another motion; `denavit diagnose` looks for those errors.",
                    beside(p)
                ),
                Some(Ok(p)) => format!(
                    " Parts of the fitted logs that were left out in turn can't decide: {}. `denavit diagnose` looks for what the model lacks.",
                    beside(p)
                ),
                _ => " `denavit diagnose` looks for what the model lacks.".into(),
            };
            wants + &elsewhere
        }
    })
}

/// Section for the terminal.
pub fn consistent_text(found: &Identification, possible: &Possible<'_>) -> String {
    let mut out = String::from("\nPossible bodies\n");
    let c = match possible.result {
        Ok(c) => c,
        Err(error) => {
            let _ = writeln!(out, "  none: {error}.");
            return out;
        }
    };
    let _ = writeln!(out, "  {}", paid(c));
    if !c.at_the_edge.is_empty() {
        let links: Vec<String> = c.at_the_edge.iter().map(usize::to_string).collect();
        let _ = writeln!(
            out,
            "  Without the prior the data push link {} to the edge of what a body can be.",
            links.join(", ")
        );
    }
    if let Some(text) = at_zero(found) {
        let _ = writeln!(out, "  {text}");
    }
    for (source, what) in [
        (Source::Geometric, "The robot file has no body for link"),
        (Source::Impossible, "The robot file has what no body can be for link"),
    ] {
        let guessed: Vec<String> =
            (1..).zip(&c.sources).filter(|(_, s)| **s == source).map(|(i, _)| i.to_string()).collect();
        if !guessed.is_empty() {
            let _ = writeln!(
                out,
                "  {what} {}: where torques don't show it, a cylinder of the density of water stands in.",
                guessed.join(", ")
            );
        }
    }
    let cell = |text: String| pad(&text, 10, true);
    let _ = write!(out, "  RMS, N m   {}{}", cell("fit plain".into()), cell("bodies".into()));
    let validation = found.validation.as_ref().zip(c.cost.validation.as_ref());
    if validation.is_some() {
        let _ = write!(out, "{}{}", pad("validate plain", 16, true), cell("bodies".into()));
    }
    out.push('\n');
    for joint in 0..found.fit.rms.len() {
        let _ = write!(
            out,
            "  joint {}{}{}",
            pad(&(joint + 1).to_string(), 5, false),
            cell(figure(found.fit.rms[joint])),
            cell(figure(c.cost.fit.rms[joint]))
        );
        if let Some((plain, bodies)) = validation {
            let _ = write!(out, "{}{}", pad(&figure(plain.rms[joint]), 16, true), cell(figure(bodies.rms[joint])));
        }
        out.push('\n');
    }
    if let Some(preferred) = preferred(found, c, possible) {
        let _ = writeln!(out, "  {preferred}");
    }
    if possible.written == Some(true) {
        out.push_str(match possible.plain {
            true => "  The plain parameters are those of possible bodies; the robot file has such, with exactly these parameters.\n",
            false => "  The robot file has these bodies.\n",
        });
    }
    out
}

/// `"carry_over"` of `identify --json`.
pub fn extrapolation_json(carry: &Extrapolation) -> Value {
    json!({ "torque_std": carry.torque_std, "ratio": carry.ratio, "doubtful_joints": carry.doubtful() })
}

/// Warnings that precede the figures of an identification.
pub fn identify_warnings(
    found: &Identification,
    logs: &[Prepared],
    carry: Option<&Extrapolation>,
    possible: Option<&Possible<'_>>,
) -> Warnings {
    let mut warnings = Warnings::default();
    let underdetermined = underdetermined_text(found);
    // The predicted accuracy needs standard deviations, which too few equations do not give.
    let fitted = underdetermined.is_none();
    if let Some(text) = underdetermined {
        warnings.push(text);
    }
    warnings.findings(&found.findings);
    if let Some(Possible { result: Err(error), .. }) = possible {
        warnings.push(format!("no possible bodies: {error}"));
    }
    if let Some(text) = carry.filter(|_| fitted).and_then(|carry| extrapolation_text(found, carry)) {
        warnings.push(text);
    }
    warnings.logs(logs);
    warnings
}

/// Effect of drive parameters held at their bound on the written plain values.
pub fn held_text(bounded: &Nonnegative, fit: &[Factors], validate: &[Factors]) -> String {
    let error = |logs: &[Factors]| {
        let all: Vec<&Factors> = logs.iter().collect();
        percent(accuracy(&all, &bounded.base).relative_error_percent())
    };
    let elsewhere = if validate.is_empty() { String::new() } else { format!(", validation {} %", error(validate)) };
    format!(
        "{} came out negative, or below the bound of friction in its weaker direction, which no drive has: held at that bound in the robot file, the \
         other parameters fitted again (error on the fitted logs {} %{elsewhere})",
        bounded.held.join(", "),
        error(fit)
    )
}

/// Rotor inertias and friction levels that possible bodies hold at their bound of zero because the
/// plain fit makes them negative.
fn at_zero(found: &Identification) -> Option<String> {
    let one = |p: &crate::identify::Estimate| format!("{} (plain: {} ± {})", p.name, figure(p.value), figure(p.std));
    let names: Vec<String> =
        found.parameters.iter().filter(|p| p.leader.is_level() && p.value < 0.0).map(one).collect();
    (!names.is_empty()).then(|| format!("At their bound of 0: {}.", names.join(", ")))
}

/// A warning if the data do not determine the parameters, with advice.
fn underdetermined_text(found: &Identification) -> Option<String> {
    let why = match found.underdetermined()? {
        Underdetermined::Equations { samples, independent, unknowns } => format!(
            "{samples} samples (over all joints) hold about {independent:.0} independent equations for {unknowns} unknowns, so the fit follows the noise"
        ),
        Underdetermined::Spread { unknowns } => {
            format!("each of the {unknowns} unknowns has a standard deviation larger than itself")
        }
    };
    Some(format!(
        "underdetermined: {why}. No value here is a measurement. Record a longer motion of all joints (`denavit excite` designs one), or give a robot file \
         with the links of the CAD model: possible bodies near these can be written"
    ))
}

/// A warning if the plain fit does not carry over to other motions; `None` otherwise.
fn extrapolation_text(found: &Identification, carry: &Extrapolation) -> Option<String> {
    let doubtful = carry.doubtful();
    if doubtful.is_empty() {
        return None;
    }
    let list: Vec<String> = doubtful
        .iter()
        .map(|&j| match carry.torque_std[j - 1].is_finite() && found.fit.rms[j - 1].is_finite() {
            true => format!(
                "joint {j} ± {} N m (residual here {})",
                figure(carry.torque_std[j - 1]),
                figure(found.fit.rms[j - 1])
            ),
            false => format!("joint {j} open"),
        })
        .collect();
    let unknown: Vec<&str> = found
        .parameters
        .iter()
        .filter(|p| p.relative_std_percent().is_nan() || p.relative_std_percent() >= 50.0)
        .map(|p| p.name.as_str())
        .collect();
    // From measured logs: beyond three residuals, two joints of three are wrong elsewhere by more
    // than twice the fit's residual, below three two of five (docs/consistency.md).
    let surely = doubtful.iter().any(|&j| carry.ratio[j - 1] > 3.0);
    Some(format!(
        "this fit {} carry over to other motions. All over the arm's range its torques are uncertain by more than its residual: {}. \
         {} of {} parameters are not known to 50 %: {}. Condition number {} with columns of unit norm. Record a richer motion, or use the possible \
         bodies with a prior from CAD (`--prior cad --prior-weight 100` gives its bodies a relative standard deviation of 10 %).",
        if surely { "will not" } else { "may not" },
        list.join(", "),
        unknown.len(),
        found.parameters.len(),
        unknown.join(" "),
        figure(found.condition.scaled)
    ))
}
