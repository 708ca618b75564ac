//! A run against the wall as text, JSON and CSV.

use std::fmt::Write;

use serde_json::{Value, json};

use crate::apps::painting::run::Run;
use crate::control::law::{Fault, Status};
use crate::report::paint::run_page::Painted;
use crate::report::parts::number::digits;

pub(in crate::report) fn status(run: &Run) -> String {
    words(run.status)
}

/// Outcome of the run, as the end of a sentence.
pub fn paint_run_ended(run: &Run) -> String {
    status(run)
}

fn words(status: Status) -> String {
    match status {
        Status::Free | Status::Pressing => "painted to the end".into(),
        Status::Waiting => "ended before there was a target within the limits".into(),
        Status::Approaching => "ended before it reached the wall".into(),
        Status::Lost => "ended while it looked for the wall".into(),
        Status::Holding => "ended while it waited for samples".into(),
        Status::Leaving(fault) => format!("left the wall: {}", reason(fault)),
        Status::Stopping(fault) => format!("ended while it came to rest: {}", reason(fault)),
        Status::Stopped(fault) => format!("stopped: {}", reason(fault)),
    }
}

fn reason(fault: Fault) -> &'static str {
    match fault {
        Fault::Position => "no positions for too long",
        Fault::Frozen => "a joint's position is frozen",
        Fault::Clock => "time stamps and steps disagree",
        Fault::Model => "the model gives no numbers",
        Fault::Joint => "a joint is beyond its range",
        Fault::Speed => "a joint is too fast",
        Fault::Torque => "torques are at their limits for too long",
        Fault::Plan => "the plan is beyond the limits",
        Fault::Reach => "no posture for the target",
        Fault::Excess => "too much force",
        Fault::Stuck => "the force is stuck",
        Fault::Force => "no force for too long",
        Fault::Contact => "no contact for too long",
    }
}

/// Note if no force could be compared.
pub(in crate::report) const NOT_COMPARED: &str =
    "It did not press within the plan, so that no force can be compared with the desired one.";

/// Gain margin, dB, or a phrase if it is infinite.
pub(in crate::report) fn gain_margin(decibels: f64) -> String {
    match decibels.is_finite() {
        true => format!("gain margin {} dB", digits(decibels, 3)),
        false => "stable at any higher gain".into(),
    }
}

/// Root mean square differences of the forces, N.
pub(in crate::report) fn differences(run: &Run) -> [(&'static str, f64); 3] {
    let a = &run.accuracy;
    [
        ("estimated less measured", a.estimated_measured),
        ("estimated less desired", a.estimated_desired),
        ("measured less desired", a.measured_desired),
    ]
}

/// Summary for the terminal.
pub fn paint_run_text(painted: &Painted<'_>) -> String {
    let Painted { run, force, coats, warnings, .. } = *painted;
    let mut text = format!("{}; {} s without pressing\n\n", status(run), digits(run.off, 3));
    let compared = |(_, value): &(&str, f64)| value.is_finite();
    if !differences(run).iter().any(compared) {
        let _ = writeln!(text, "  {NOT_COMPARED}");
    }
    for (name, value) in differences(run).into_iter().filter(compared) {
        let _ = writeln!(text, "  {name:<24} {:>7} N  {:>6} %", digits(value, 3), digits(100.0 * value / force, 3));
    }
    if run.tracking.is_finite() {
        let _ = writeln!(text, "  {:<24} {:>7} mm", "aside of the plan", digits(1e3 * run.tracking, 3));
    }
    if coats.len() > 1 {
        let each: Vec<String> = coats.iter().map(|a| digits(a.estimated_desired, 3)).collect();
        let _ = writeln!(text, "  estimated less desired, coat by coat: {} N", each.join(", "));
    }
    let f = &run.tuning.force;
    let _ = writeln!(
        text,
        "\ngains: Kp {} m/N, Ki {} m/(N s); crossover {} rad/s, phase margin {} deg, {}",
        digits(f.kp, 3),
        digits(f.ki, 3),
        digits(f.margins.crossover, 3),
        digits(f.margins.phase, 3),
        gain_margin(f.margins.gain)
    );
    for (j, p) in run.tuning.joints.iter().enumerate() {
        let _ = writeln!(text, "  joint {}: Kp {} N m/rad, Kd {} N m s/rad", j + 1, digits(p.kp, 3), digits(p.kd, 3));
    }
    text + &warnings.text()
}

/// The run as JSON.
pub fn paint_run_json(painted: &Painted<'_>) -> Value {
    let Painted { run, force, coats, warnings, .. } = *painted;
    let a = &run.accuracy;
    let f = &run.tuning.force;
    let finite = |x: f64| x.is_finite().then_some(x);
    json!({
        "status": status(run),
        "warnings": warnings.json(),
        "force": force,
        "rms": {
            "estimated_measured": finite(a.estimated_measured), "estimated_desired": finite(a.estimated_desired),
            "measured_desired": finite(a.measured_desired),
        },
        "coats": coats.iter().map(|a| json!({
            "estimated_measured": finite(a.estimated_measured), "estimated_desired": finite(a.estimated_desired),
            "measured_desired": finite(a.measured_desired),
        })).collect::<Vec<_>>(),
        "tracking": finite(run.tracking),
        "seconds": run.trace.t.last(),
        "seconds_off": run.off,
        "gains": {
            "force": { "kp": f.kp, "ki": f.ki, "crossover": f.margins.crossover, "phase_margin": f.margins.phase, "gain_margin": finite(f.margins.gain) },
            "joints": run.tuning.joints.iter().map(|j| json!({ "kp": j.kp, "kd": j.kd })).collect::<Vec<_>>(),
        },
    })
}

/// One row per sample.
pub fn paint_run_csv(run: &Run) -> String {
    let mut text = String::from("t,estimated,measured,true,displacement,planned_x,planned_y,planned_z,x,y,z\n");
    let trace = &run.trace;
    for k in 0..trace.t.len() {
        let ([a, b, c], [x, y, z]) = (trace.planned[k], trace.actual[k]);
        let _ = writeln!(
            text,
            "{:.6},{:.5},{:.5},{:.5},{:.7},{a:.6},{b:.6},{c:.6},{x:.6},{y:.6},{z:.6}",
            trace.t[k], trace.estimated[k], trace.measured[k], trace.truth[k], trace.displacement[k]
        );
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_end_is_said_in_words() {
        assert_eq!(words(Status::Leaving(Fault::Excess)), "left the wall: too much force");
        assert_eq!(words(Status::Stopped(Fault::Position)), "stopped: no positions for too long");
        assert_eq!(gain_margin(f64::INFINITY), "stable at any higher gain");
        assert_eq!(gain_margin(12.34), "gain margin 12.3 dB");
    }
}
