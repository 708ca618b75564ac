//! A run against the wall as text, JSON and CSV.

use std::fmt::Write;

use serde_json::{Value, json};

use crate::apps::painting::run::Run;
use crate::control::law::Status;
use crate::report::paint::run_page::Painted;
use crate::report::parts::number::digits;

pub(in crate::report) fn status(run: &Run) -> String {
    match run.status {
        Status::Free | Status::Pressing => "painted to the end".into(),
        Status::Approaching => "on the way to the wall".into(),
        Status::Lost => "looking for the wall".into(),
        Status::Holding => "waiting for samples".into(),
        Status::Leaving(fault) => format!("left the wall: {fault:?}").to_lowercase(),
        Status::Stopped(fault) => format!("stopped: {fault:?}").to_lowercase(),
    }
}

/// Root mean square differences, N.
pub(in crate::report) fn differences(run: &Run) -> [(&'static str, f64); 3] {
    let a = &run.accuracy;
    [
        ("estimated less measured", a.estimated_measured),
        ("estimated less desired", a.estimated_desired),
        ("measured less desired", a.measured_desired),
    ]
}

/// Some lines.
pub fn paint_run_text(painted: &Painted<'_>) -> String {
    let Painted { run, force, coats, warnings, .. } = *painted;
    let mut text = format!("{}; {} s without pressing\n\n", status(run), digits(run.off, 3));
    for (name, value) in differences(run) {
        let _ = writeln!(text, "  {name:<24} {:>7} N  {:>6} %", digits(value, 3), digits(100.0 * value / force, 3));
    }
    let _ = writeln!(text, "  {:<24} {:>7} mm", "aside of the plan", digits(1e3 * run.tracking, 3));
    if coats.len() > 1 {
        let each: Vec<String> = coats.iter().map(|a| digits(a.estimated_desired, 3)).collect();
        let _ = writeln!(text, "  estimated less desired, coat by coat: {} N", each.join(", "));
    }
    let f = &run.tuning.force;
    let _ = writeln!(
        text,
        "\ngains: Kp {} m/N, Ki {} m/(N s); crossover {} rad/s, phase margin {} deg, gain margin {} dB",
        digits(f.kp, 3),
        digits(f.ki, 3),
        digits(f.margins.crossover, 3),
        digits(f.margins.phase, 3),
        digits(f.margins.gain, 3)
    );
    for (j, p) in run.tuning.joints.iter().enumerate() {
        let _ = writeln!(text, "  joint {}: Kp {} N m/rad, Kd {} N m s/rad", j + 1, digits(p.kp, 3), digits(p.kd, 3));
    }
    text + &warnings.text()
}

/// The same.
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
