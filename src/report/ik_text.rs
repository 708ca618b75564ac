//! `ik` for people.

use core::fmt::Write;

use dh_codegen::arm::Inverse;
use dh_codegen::ik::{Family, Status};

use crate::inverse::Postures;

/// A table of postures for each pose.
pub fn text(name: &str, inverse: &Inverse, poses: &[Postures]) -> String {
    let redundant = matches!(inverse.family, Family::Swivel(_) | Family::Locked { .. });
    let mut t = format!("{name}: {} ({})\n", inverse.class, inverse.reason);
    for (k, pose) in poses.iter().enumerate() {
        let _ = match pose.status {
            Status::Unreachable => {
                let [p, r] = pose.distance;
                writeln!(t, "\npose {}: unreachable, by {p:.3e} m and {r:.3e} rad at the nearest posture found", k + 1)
            }
            status => {
                let word = super::ik_json::status(status);
                let at = if redundant { format!(", redundancy {:.5}", pose.redundancy) } else { String::new() };
                let lost = match pose.lost {
                    0 => String::new(),
                    _ if inverse.exact => String::new(),
                    n => format!(", {n} branches of the nominal arm not found"),
                };
                writeln!(t, "\npose {}: {word}, {} solutions{at}{lost}", k + 1, pose.list.len())
            }
        };
        for s in &pose.list {
            let q: Vec<String> = s.q.iter().map(|x| format!("{x:>9.5}")).collect();
            let limits = if s.within_limits { "" } else { "  beyond limits" };
            let free: Vec<String> = s.free.iter().map(|j| format!("q{}", j + 1)).collect();
            let free = if free.is_empty() { String::new() } else { format!("  free: {}", free.join(" ")) };
            let _ = writeln!(t, "  {}  {}{limits}{free}", q.join(" "), s.branch);
        }
    }
    t
}
