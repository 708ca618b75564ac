//! Painting plans as a JSON file, written and read back.

use serde_json::{Value, json};

use crate::apps::painting::{PaintingMotion, Pattern, Phase, Plan, Roller, Span, Strokes, Surface};
use crate::report::parts::fields::{FieldError, array, field, number, numbers, rows, rule, text};

/// A plan; [`plan_of_json`] gives the same plan without its unpainted sides.
pub fn plan_json(plan: &Plan) -> Value {
    let (s, r, l) = (&plan.surface, &plan.roller, &plan.strokes);
    json!({
        "kind": "paint_plan",
        "robot": plan.robot,
        "wall": {"center": s.center, "normal": s.normal, "up": s.up, "width": s.width, "height": s.height},
        "roller": {"length": r.length, "width": r.width, "turned": r.turned},
        "strokes": {
            "upper": l.upper, "lower": l.lower, "first": l.first, "step": l.step, "lanes": l.lanes,
            "pattern": if l.pattern == Pattern::Cycle { "cycle" } else { "snake" },
        },
        "contact_seconds": plan.contact, "jerk": plan.jerk, "cost": plan.cost, "cost_constant_swivel": plan.cost_constant,
        "spans": plan.spans.iter().map(|s| json!({
            "phase": s.phase.name(), "from": s.from, "to": s.to, "time": s.time, "bound": s.bound,
        })).collect::<Vec<_>>(),
        "motion": {"times": plan.motion.times, "q": plan.motion.q, "dq": plan.motion.dq, "ddq": plan.motion.ddq},
    })
}

/// Reads the output of [`plan_json`], also under the key `plan`. Unpainted sides are not included.
///
/// # Errors
/// The key that is missing or has the wrong shape.
pub fn plan_of_json(value: &Value) -> Result<Plan, FieldError> {
    let value = value.get("plan").unwrap_or(value);
    if value.get("kind").and_then(Value::as_str) != Some("paint_plan") {
        return Err(rule("kind", "is not `paint_plan`; this is not what `denavit paint plan --plan` writes"));
    }
    let wall = field(value, "wall")?;
    let surface = Surface::new(
        array(wall, "center")?,
        array(wall, "normal")?,
        array(wall, "up")?,
        number(wall, "width")?,
        number(wall, "height")?,
    )?;
    let held = field(value, "roller")?;
    let turned = held.get("turned").and_then(Value::as_bool);
    let turned = turned.ok_or_else(|| rule("roller.turned", "must be true or false"))?;
    Ok(Plan {
        robot: text(value, "robot")?,
        surface,
        roller: Roller { length: number(held, "length")?, width: number(held, "width")?, turned },
        strokes: strokes(field(value, "strokes")?)?,
        spans: spans(field(value, "spans")?)?,
        motion: motion(field(value, "motion")?)?,
        contact: number(value, "contact_seconds")?,
        jerk: number(value, "jerk")?,
        cost: number(value, "cost")?,
        cost_constant: value.get("cost_constant_swivel").and_then(Value::as_f64),
        sides: Vec::new(),
    })
}

fn strokes(value: &Value) -> Result<Strokes, FieldError> {
    let lanes = value.get("lanes").and_then(Value::as_u64).filter(|n| (1..=1000).contains(n));
    Ok(Strokes {
        upper: number(value, "upper")?,
        lower: number(value, "lower")?,
        first: number(value, "first")?,
        step: number(value, "step")?,
        lanes: lanes.ok_or_else(|| rule("strokes.lanes", "must be a whole number from 1 to 1000"))? as usize,
        pattern: match value.get("pattern").and_then(Value::as_str) {
            Some("cycle") => Pattern::Cycle,
            Some("snake") => Pattern::Snake,
            _ => return Err(rule("strokes.pattern", "must be cycle or snake")),
        },
    })
}

fn spans(value: &Value) -> Result<Vec<Span>, FieldError> {
    let span = |s: &Value| {
        let name = text(s, "phase")?;
        let phase = Phase::named(&name).ok_or_else(|| rule(&name, "is no phase"))?;
        let (from, to, time) = (array(s, "from")?, array(s, "to")?, array(s, "time")?);
        Ok(Span { phase, from, to, time, bound: text(s, "bound")? })
    };
    let list = value.as_array().ok_or_else(|| rule("spans", "must be a list"))?;
    let spans = list.iter().map(span).collect::<Result<Vec<Span>, FieldError>>()?;
    if spans.is_empty() || spans.windows(2).any(|w| (w[0].time[1] - w[1].time[0]).abs() > 1e-9) {
        return Err(rule("spans", "must follow each other in time"));
    }
    Ok(spans)
}

fn motion(value: &Value) -> Result<PaintingMotion, FieldError> {
    let times = numbers(value, "times").map_err(|_| rule("motion.times", "must be a list of numbers"))?;
    let list = |key: &str| {
        rows(value, key).ok_or_else(|| rule(&format!("motion.{key}"), "must be a list of lists of numbers"))
    };
    let motion = PaintingMotion { q: list("q")?, dq: list("dq")?, ddq: list("ddq")?, times };
    let n = motion.dof();
    let whole = [&motion.q, &motion.dq, &motion.ddq]
        .iter()
        .all(|rows| rows.len() == motion.times.len() && rows.iter().all(|r| r.len() == n));
    if !whole || n == 0 || motion.times.len() < 2 || motion.times[0] != 0.0 {
        return Err(rule("motion", "needs as many rows of q, dq and ddq as it has times, from 0, all of one length"));
    }
    if motion.times.windows(2).any(|w| w[1] <= w[0]) {
        return Err(rule("motion.times", "must ascend"));
    }
    Ok(motion)
}
