//! An exciting motion as text, JSON, CSV and ROS trajectory.

use std::fmt::Write;

use serde_json::{Value, json};

use crate::data::trajectory::Trajectory;
use crate::excite::{Design, Expected, Missing, Task};
use crate::report::Warnings;
use crate::report::excite::saved::trajectory_json;
use crate::report::parts::number::{figure, percent};

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
            // Enough digits for numerical differentiation; `+ 0.0` replaces -0 by 0.
            (0..n).for_each(|j| {
                let _ = write!(out, ",{:.12}", part[j * times.len() + s] + 0.0);
            });
        }
        out.push('\n');
    }
    out
}

/// A designed motion with its context.
pub struct Outcome<'a> {
    /// The design task.
    pub task: &'a Task<'a>,
    /// The designed motion.
    pub found: &'a Design,
    /// Expected precision of the parameters.
    pub expected: &'a [Expected],
    /// Durations that were tried, s, with the largest relative standard deviation, percent; `None`
    /// without a feasible motion.
    pub tried: &'a [(f64, Option<f64>)],
    /// Run time, s.
    pub seconds: f64,
    /// Warnings that precede the figures.
    pub warnings: &'a Warnings,
}

/// `trajectory_msgs/JointTrajectory` as YAML, `rate` points per second.
pub fn joint_trajectory(motion: &Trajectory, names: &[String], rate: f64) -> String {
    let (times, states) = motion.sampled(rate);
    let quoted: Vec<String> = names.iter().map(|n| format!("{n:?}")).collect();
    let mut out = format!(
        "header: {{ stamp: {{ sec: 0, nanosec: 0 }}, frame_id: '' }}\njoint_names: [{}]\npoints:\n",
        quoted.join(", ")
    );
    for (s, t) in times.iter().enumerate() {
        let list = |part: &[f64]| {
            let all: Vec<String> =
                (0..motion.dof()).map(|j| format!("{:.9}", part[j * times.len() + s] + 0.0)).collect();
            all.join(", ")
        };
        let nanoseconds = (t * 1e9).round() as u64;
        let _ = writeln!(
            out,
            "  - {{ positions: [{}], velocities: [{}], accelerations: [{}], effort: [], time_from_start: {{ sec: {}, nanosec: {} }} }}",
            list(&states.q),
            list(&states.dq),
            list(&states.ddq),
            nanoseconds / 1_000_000_000,
            nanoseconds % 1_000_000_000
        );
    }
    out
}

/// The result with the keys of docs/excite.md.
pub fn excite_json(outcome: &Outcome<'_>) -> Value {
    let Outcome { task, found, expected, tried, seconds, warnings } = *outcome;
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
        "warnings": warnings.json(),
        "assumed": task.missing.iter().map(|m| json!({"joint": m.joint, "limit": m.limit, "taken": m.taken, "value": m.value})).collect::<Vec<_>>(),
        "starts": found.starts,
        "stopped": found.stopped,
        "expected": expected.iter().map(|e| json!({"name": e.name, "value": e.value, "std": e.std, "relative_std_percent": e.relative_percent(), "essential": e.essential})).collect::<Vec<_>>(),
        "tried": tried.iter().map(|(s, p)| json!({"duration": s, "relative_std_percent": p})).collect::<Vec<_>>(),
        "trajectory": trajectory_json(&found.trajectory),
    })
}

fn finite(x: f64) -> Value {
    if x.is_finite() { json!(x) } else { Value::Null }
}

/// Values missing in the file, one line per kind and remedy.
pub fn missing_text(missing: &[Missing]) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    let mut reported: Vec<(&str, &str)> = Vec::new();
    for first in missing {
        if reported.contains(&(first.limit, first.taken.as_str())) {
            continue;
        }
        reported.push((first.limit, &first.taken));
        let alike: Vec<String> = missing
            .iter()
            .filter(|m| (m.limit, &m.taken) == (first.limit, &first.taken) && !m.joint.is_empty())
            .map(|m| m.value.map_or(m.joint.clone(), |v| format!("{} {}", m.joint, figure(v))))
            .collect();
        let whose = if alike.is_empty() { String::new() } else { format!(" ({})", alike.join(", ")) };
        lines.push(format!("{}: {}{whose}", first.limit, first.taken));
    }
    lines
}

/// Summary for the terminal.
pub fn excite_text(outcome: &Outcome<'_>) -> String {
    let Outcome { task, found, expected, tried, seconds, warnings } = *outcome;
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
        "condition number {}, log det {}, log of Hadamard's bound {} (unscaled columns)",
        figure(found.plain.condition),
        figure(found.plain.log_det),
        figure(found.plain.hadamard)
    );
    for (duration, percent) in tried {
        let _ = match percent {
            Some(p) => writeln!(out, "tried {duration} s: {p:.2} % at worst"),
            None => writeln!(out, "tried {duration} s: no feasible motion"),
        };
    }
    let known = expected.iter().filter(|e| e.essential == Some(true));
    if let Some((e, p)) = known.filter_map(|e| Some((e, e.relative_percent()?))).max_by(|a, b| a.1.total_cmp(&b.1)) {
        let _ = if p < 100.0 {
            writeln!(
                out,
                "expected: every essential parameter has a relative standard deviation within {} % ({} is the worst)",
                percent(p),
                e.name
            )
        } else {
            writeln!(
                out,
                "expected: too short for {}, whose relative standard deviation is {} %; allow a longer --duration",
                e.name,
                percent(p)
            )
        };
    }
    if found.stopped {
        out.push_str("stopped early: this is the best motion so far\n");
    }
    for worst in &found.closest {
        let _ = writeln!(out, "closest: {} at {:.2} s", worst.what, worst.time);
    }
    out + &warnings.text()
}
