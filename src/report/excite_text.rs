//! An exciting motion for people, as JSON and as CSV.

use std::fmt::Write;

use serde_json::{Value, json};

use super::number::figure;
use crate::excite::{Design, Task};
use crate::trajectory::Trajectory;

/// `t, q1.., dq1.., ddq1..`, `rate` rows per second.
pub fn motion_csv(motion: &Trajectory, rate: f64) -> String {
    let (times, states) = motion.sampled(rate);
    let n = motion.dof();
    let mut out = String::from("t");
    for name in ["q", "dq", "ddq"] {
        (1..=n).for_each(|j| {
            let _ = write!(out, ",{name}{j}");
        });
    }
    out.push('\n');
    for (s, t) in times.iter().enumerate() {
        let _ = write!(out, "{t:.6}");
        for part in [&states.q, &states.dq, &states.ddq] {
            // The digits that no derivative by differences can miss; `+ 0.0` turns -0 round.
            (0..n).for_each(|j| {
                let _ = write!(out, ",{:.12}", part[j * times.len() + s] + 0.0);
            });
        }
        out.push('\n');
    }
    out
}

/// Contract section 4, and more.
pub fn excite_json(task: &Task<'_>, found: &Design, seconds: f64) -> Value {
    json!({
        "robot": task.arm.name(),
        "criterion": found.criterion,
        "value": finite(found.value),
        "condition_number": finite(found.plain.condition),
        "log_det": finite(found.plain.log_det),
        "hadamard": finite(found.plain.hadamard),
        "condition_number_weighted": finite(found.scaled.condition),
        "feasible": found.feasible,
        "seconds": seconds,
        "duration": found.trajectory.duration(),
        "columns": task.columns().names(),
        "rate": task.rate,
        "closest": found.closest.iter().map(|w| json!({"what": w.what, "time": w.time, "excess": w.excess})).collect::<Vec<_>>(),
        "assumed": task.missing.iter().map(|m| json!({"joint": m.joint, "limit": m.limit, "taken": m.taken})).collect::<Vec<_>>(),
        "starts": found.starts,
        "stopped": found.stopped,
        "trajectory": found.trajectory.to_json(),
    })
}

fn finite(x: f64) -> Value {
    if x.is_finite() { json!(x) } else { Value::Null }
}

/// A summary.
pub fn excite_text(task: &Task<'_>, found: &Design, seconds: f64) -> String {
    let mut out = String::new();
    let _ = writeln!(
        out,
        "{}: {} s, {} joints, {} columns, {} = {} after {seconds:.1} s",
        task.arm.name(),
        found.trajectory.duration(),
        task.dof(),
        task.columns().count(),
        found.criterion,
        figure(found.value)
    );
    let _ = writeln!(
        out,
        "condition number {}, log det {}, log of Hadamard's bound {} (columns as they are)",
        figure(found.plain.condition),
        figure(found.plain.log_det),
        figure(found.plain.hadamard)
    );
    for worst in &found.closest {
        let _ = writeln!(out, "closest: {} at {:.2} s", worst.what, worst.time);
    }
    out
}
