//! Report of `denavit ik` as text.

use core::fmt::Write;

use dh_codegen::arm::Inverse;
use dh_codegen::ik::{Family, Status};

use crate::model::inverse_kinematics::{Answer, LockedRange, SwivelRange};

/// Pose error, m and rad, above which it is more than rounding.
const SHOWN: f64 = 1e-9;

/// A table of postures for each pose.
pub fn ik_text(name: &str, inverse: &Inverse, poses: &[Answer]) -> String {
    let mut t = format!("{name}: {} ({})\n", inverse.class, inverse.reason);
    let searched = matches!(inverse.family, Family::Numerical);
    for (k, answer) in poses.iter().enumerate() {
        let pose = &answer.postures;
        let _ = match pose.status {
            Status::Unreachable => {
                let [p, r] = pose.distance;
                let word = if inverse.exact && !pose.uncertain { "unreachable" } else { "not found" };
                // Rounded in its file, and the arm has too few joints to reach it.
                let mend = if p.max(r) < 1e-4 { "; a larger --tolerance would take it" } else { "" };
                writeln!(t, "\npose {}: {word}, by {p:.3e} m and {r:.3e} rad at the nearest posture found{mend}", k + 1)
            }
            status => {
                let word = crate::report::ik::json::status(status);
                let at = match &inverse.family {
                    Family::Swivel(_) => format!(", swivel angle {:.5} rad", pose.redundancy),
                    other => other
                        .locked()
                        .map_or(String::new(), |joint| format!(", q{} at {:.5}", joint + 1, pose.redundancy)),
                };
                let lost = match pose.lost {
                    _ if inverse.exact && pose.uncertain => String::from(", beside a singularity: one may be missing"),
                    _ if inverse.exact => String::new(),
                    0 if searched => String::from(", found by search: there may be more"),
                    n if searched => format!(", found by search: at least {n} is missing, their number being even"),
                    0 if pose.uncertain => String::from(", beside a singularity: one may be missing"),
                    0 => String::new(),
                    n => format!(", {n} branches of the nominal arm not found"),
                };
                let (count, s) = (pose.list.len(), if pose.list.len() == 1 { "" } else { "s" });
                writeln!(t, "\npose {}: {word}, {count} solution{s}{at}{lost}", k + 1)
            }
        };
        for s in &pose.list {
            let q: Vec<String> = s.q.iter().map(|x| format!("{x:>9.5}")).collect();
            let limits = if s.within_limits { "" } else { "  beyond limits" };
            let free: Vec<String> = s.free.iter().map(|j| format!("q{}", j + 1)).collect();
            let free = if free.is_empty() { String::new() } else { format!("  free: {}", free.join(" ")) };
            let [p, r] = [s.position_error, s.rotation_error];
            let off = if p.max(r) > SHOWN { format!("  off by {p:.3e} m and {r:.3e} rad") } else { String::new() };
            let _ = writeln!(t, "  {}  {}{limits}{free}{off}", q.join(" "), s.branch);
        }
        if let (Some(ranges), true) = (&answer.swivel, pose.status != Status::Unreachable) {
            swivel(&mut t, inverse, ranges);
        }
        if let (Some(range), Some(joint)) = (&answer.locked, inverse.family.locked()) {
            locked(&mut t, usize::from(joint) + 1, range);
        }
    }
    t
}

/// Positions of the locked joint within the limits.
fn locked(t: &mut String, joint: usize, range: &LockedRange) {
    if range.intervals.is_empty() {
        let _ = writeln!(t, "  at no position of q{joint} that was looked at a posture respects the limits");
        return;
    }
    let all: Vec<String> = range.intervals.iter().map(|[a, b]| format!("[{a:.5}, {b:.5}]")).collect();
    let best = match range.best {
        Some((at, margin)) if margin.is_finite() => format!("; best {at:.5}, {margin:.5} from them"),
        _ => String::new(),
    };
    let _ = writeln!(t, "  positions of q{joint} at which a posture respects the limits: {}{best}", all.join(" "));
}

/// Intervals of the swivel angle within the limits.
fn swivel(t: &mut String, inverse: &Inverse, ranges: &[SwivelRange]) {
    let whose = if inverse.exact { "" } else { " of the nominal arm" };
    if ranges.iter().all(|r| r.intervals.is_empty()) {
        let _ = writeln!(t, "  at no swivel angle a branch{whose} respects the limits");
        return;
    }
    let _ = writeln!(
        t,
        "  swivel angles, rad, at which a branch{whose} respects the limits; the best, and its distance from them:"
    );
    for range in ranges.iter().filter(|r| !r.intervals.is_empty()) {
        let all: Vec<String> = range.intervals.iter().map(|[a, b]| format!("[{a:.5}, {b:.5}]")).collect();
        let best = match range.best {
            Some((at, margin)) if margin.is_finite() => format!("; best {at:.5}, {margin:.5}"),
            _ => String::new(),
        };
        let _ = writeln!(t, "    {}  {}{best}", range.branch, all.join(" "));
    }
}
