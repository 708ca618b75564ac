//! Report of `denavit import` as text.

use core::fmt::Write;

use crate::exchange::import::{REQUIRED, STATES};
use crate::exchange::{Imported, Neighbours};
use crate::report::parts::number::counted;

/// Result of the import, its accuracy, and unknown values.
pub fn import_text(made: &Imported) -> String {
    let robot = &made.robot;
    let mut t = format!(
        "{}: {} `{}`, {} joints from `{}` to `{}`\n",
        robot.name,
        made.format,
        made.model,
        robot.dof(),
        made.base,
        made.tip
    );
    let _ = writeln!(
        t,
        "  forward kinematics against the source at {STATES} random states: {:.1e} m, {:.1e} in the rotation{}",
        made.error.position,
        made.error.rotation,
        import_reason(made).map_or(String::new(), |reason| format!("\n    {reason}"))
    );
    let snap = &made.snap;
    if snap.count > 0 {
        let _ = writeln!(
            t,
            "  {} taken for exact ones (fractions of pi, axes), {:.1e} rad off at most",
            counted(snap.count, "angle or direction was", "angles or directions were"),
            snap.largest
        );
    }
    let _ = writeln!(t, "  neighbouring axes: {}", neighbours(made));
    if robot.base.is_some() {
        let _ = writeln!(t, "  row 1 does not start from `{}`: the file has a `base`", made.base);
    }
    let fixed = robot.joints.len() - robot.dof();
    if fixed > 0 {
        let _ = writeln!(
            t,
            "  {} between axes that are nearly parallel; \
             where the source only rounded its angles, --snap 1e-5 makes them parallel",
            counted(fixed, "row that does not move leads", "rows that do not move lead")
        );
    }
    t += "  positions are the source's own (sign 1, offset 0), torques too\n";
    if !made.held.is_empty() {
        let list: Vec<String> = made.held.iter().map(|(name, q)| format!("{name} = {q}")).collect();
        let _ = writeln!(t, "  held beside the arm: {}", list.join(", "));
    }
    list(&mut t, "unknown, and left open in the file", &made.unknown);
    list(&mut t, "cannot be", &made.impossible);
    list(&mut t, "notes", &made.notes);
    t
}

/// Reason why the result differs from the source by more than rounding; `None` otherwise.
pub fn import_reason(made: &Imported) -> Option<String> {
    if made.error.position <= REQUIRED && made.error.rotation <= REQUIRED {
        return None;
    }
    let off = made
        .neighbours
        .iter()
        .filter(|(case, _)| matches!(case, Neighbours::Parallel | Neighbours::AntiParallel | Neighbours::OneLine));
    let off = off.map(|(_, angle)| angle.min(core::f64::consts::PI - angle)).fold(0.0f64, f64::max);
    Some(format!(
        "more than {REQUIRED:.0e}: angles of the source were up to {:.1e} rad off exact ones, and axes {off:.1e} rad off parallel",
        made.snap.largest
    ))
}

fn neighbours(made: &Imported) -> String {
    let kinds = [
        (Neighbours::Skew, "skew"),
        (Neighbours::Crossing, "crossing"),
        (Neighbours::Parallel, "parallel"),
        (Neighbours::AntiParallel, "anti-parallel"),
        (Neighbours::OneLine, "on one line"),
    ];
    let count = |kind: Neighbours| made.neighbours.iter().filter(|(case, _)| *case == kind).count();
    let mut words: Vec<String> = kinds
        .iter()
        .map(|(kind, word)| (count(*kind), word))
        .filter(|(n, _)| *n > 0)
        .map(|(n, w)| format!("{n} {w}"))
        .collect();
    for (k, (_, angle)) in
        made.neighbours.iter().enumerate().filter(|(_, (case, _))| *case == Neighbours::NearlyParallel)
    {
        let off = angle.min(core::f64::consts::PI - angle);
        words.push(format!("{} and {} off parallel by {off:.1e} rad", k + 1, k + 2));
    }
    if words.is_empty() { "none".into() } else { words.join(", ") }
}

fn list(t: &mut String, title: &str, sentences: &[String]) {
    if !sentences.is_empty() {
        let _ = writeln!(t, "  {title}:");
    }
    for sentence in sentences {
        let _ = writeln!(t, "    {sentence}");
    }
}
