//! A painting motion as text, JSON and CSV.

use std::fmt::Write;

use serde_json::{Value, json};

use crate::apps::painting::{Moment, Plan, Swivel, Task, joint_torques};
use crate::report::Warnings;
use crate::report::paint::saved::plan_json;
use crate::report::parts::number::{counted, figure};

/// A plan with its context.
pub struct Planned<'a> {
    /// The painting task.
    pub task: &'a Task<'a>,
    /// The planned motion.
    pub plan: &'a Plan,
    /// Run time, s.
    pub seconds: f64,
    /// Warnings that precede the figures.
    pub warnings: &'a Warnings,
}

/// Worst utilisation of a joint's limits.
pub(in crate::report) struct Use {
    /// Distance to the nearer end of its travel, rad or m.
    pub margin: f64,
    /// Largest speed, acceleration and torque (with the force on the wall).
    pub peak: [f64; 3],
}

/// Utilisation of every joint's limits, sampled at 200 Hz.
pub(in crate::report) fn uses(task: &Task<'_>, plan: &Plan) -> Vec<Use> {
    let moments: Vec<Moment> = plan.sampled(200.0).into_iter().map(|(_, m)| m).collect();
    let (n, len) = (task.dof(), moments.len());
    let (states, torque) = (Moment::states(n, &moments), joint_torques(task, &moments));
    (0..n)
        .map(|j| {
            let peak = |part: &[f64]| part[j * len..(j + 1) * len].iter().fold(0.0f64, |m, x| m.max(x.abs()));
            let [low, high] = task.limits[j].position;
            let q = &states.q[j * len..(j + 1) * len];
            let margin = q.iter().map(|q| (q - low).min(high - q)).fold(f64::INFINITY, f64::min);
            Use { margin, peak: [peak(&states.dq), peak(&states.ddq), peak(&torque)] }
        })
        .collect()
}

/// `t, q1.., dq1.., ddq1..`, `rate` rows per second.
pub fn paint_csv(plan: &Plan, rate: f64) -> String {
    let n = plan.motion.dof();
    let mut out = String::from("t");
    for name in ["q", "dq", "ddq"] {
        (1..=n).for_each(|j| {
            let _ = write!(out, ",{name}{j}");
        });
    }
    out.push('\n');
    for (t, m) in plan.sampled(rate) {
        let _ = write!(out, "{t:.6}");
        for x in m.q.iter().chain(&m.dq).chain(&m.ddq) {
            let _ = write!(out, ",{:.12}", x + 0.0);
        }
        out.push('\n');
    }
    out
}

/// Path of the roller: `t`, middle of its face `x y z` and on the wall `wall_y wall_z distance`
/// (m), velocity `vx vy vz` (m/s), tool pose (twelve numbers), `swivel`, `phase`.
pub fn paint_path_csv(plan: &Plan, rate: f64) -> String {
    let mut out = String::from(
        "t,x,y,z,wall_y,wall_z,distance,vx,vy,vz,r11,r12,r13,px,r21,r22,r23,py,r31,r32,r33,pz,swivel,phase\n",
    );
    for (t, m) in plan.sampled(rate) {
        let _ = write!(out, "{t:.6}");
        let numbers = m.point.iter().chain(&m.place).chain(&m.velocity).chain(&m.pose).chain([&m.swivel]);
        for x in numbers {
            let _ = write!(out, ",{:.12}", x + 0.0);
        }
        let _ = writeln!(out, ",{}", m.phase.name());
    }
    out
}

/// The complete result, with the plan under `plan`.
pub fn paint_json(planned: &Planned<'_>) -> Value {
    let Planned { task, plan, seconds, warnings } = *planned;
    let s = &plan.strokes;
    let cover = plan.coverage();
    let joints: Vec<Value> = uses(task, plan)
        .iter()
        .zip(&task.limits)
        .map(|(u, l)| {
            json!({
                "name": l.name, "position_margin": u.margin,
                "velocity": u.peak[0], "velocity_limit": l.velocity,
                "acceleration": u.peak[1], "acceleration_limit": l.acceleration,
                "torque": task.standard.as_ref().map(|_| u.peak[2]), "torque_limit": l.torque,
            })
        })
        .collect();
    json!({
        "robot": plan.robot,
        "warnings": warnings.json(),
        "feasible": true,
        "seconds": seconds,
        "contact_seconds": plan.contact,
        "duration": plan.duration(),
        "jerk": plan.jerk,
        "area": task.area(s),
        "cost": plan.cost,
        "cost_constant_swivel": plan.cost_constant,
        "weights": {"jerk": task.weights.jerk, "area": task.weights.area},
        "x": {"T_C": plan.contact, "Z_u": s.upper, "Z_l": s.lower, "Y_0": s.first, "dY": s.step,
              "swivel": plan.spans.iter().map(|s| s.to[3]).collect::<Vec<_>>()},
        "lanes": s.lanes,
        "roller": {"length": plan.roller.length, "width": plan.roller.width, "turned": plan.roller.turned},
        "painted": cover.painted,
        "overlapped": cover.overlapped,
        "sides": plan.sides.iter().map(|s| json!({"side": s.side, "gap": s.gap, "bound": s.bound})).collect::<Vec<_>>(),
        "joints": joints,
        "assumed": task.missing.iter().map(|m| json!({"joint": m.joint, "limit": m.limit, "taken": m.taken})).collect::<Vec<_>>(),
        "plan": plan_json(plan),
    })
}

/// Summary for the terminal.
pub fn paint_text(planned: &Planned<'_>) -> String {
    let Planned { task, plan, seconds, warnings } = *planned;
    let (s, cover) = (&plan.strokes, plan.coverage());
    let mut out = String::new();
    let _ = writeln!(
        out,
        "{}: {:.1} % of the wall in {:.3} s of contact ({:.3} s with approach and retreat), found in {seconds:.1} s",
        plan.robot,
        100.0 * cover.painted,
        plan.contact,
        plan.duration()
    );
    let _ = writeln!(
        out,
        "{}, dY = {:.4} m (roller {:.4} m), Y_0 = {:.4}, Z_l = {:.4}, Z_u = {:.4} m; {:.1} % of the wall on two lanes",
        counted(s.lanes, "lane", "lanes"),
        s.step,
        plan.roller.width,
        s.first,
        s.lower,
        s.upper,
        100.0 * cover.overlapped
    );
    if task.redundancy().is_some() {
        let all: Vec<f64> = plan.spans.iter().flat_map(|s| [s.from[3], s.to[3]]).collect();
        let (low, high) = all.iter().fold((f64::MAX, f64::MIN), |(l, h), x| (l.min(*x), h.max(*x)));
        let _ = match task.swivel {
            Swivel::Constant => writeln!(out, "swivel {low:.4} rad"),
            Swivel::Spline => writeln!(out, "swivel from {low:.4} to {high:.4} rad"),
        };
    }
    let _ = writeln!(
        out,
        "cost of equation (12): {} s = {} s + {} x {} rad^2/s^5 + {} / {} m^2",
        figure(plan.cost),
        figure(plan.contact),
        task.weights.jerk,
        figure(plan.jerk),
        task.weights.area,
        figure(task.area(s))
    );
    if let Some(plain) = plan.cost_constant {
        let _ = writeln!(out, "with one swivel angle: {} s", figure(plain));
    }
    for side in &plan.sides {
        let _ = writeln!(out, "{} side: {:.3} m are not painted; {}", side.side, side.gap, side.bound);
    }
    let mut bounds: Vec<(&str, usize)> = Vec::new();
    for span in plan.spans.iter().filter(|s| s.phase.contact()) {
        match bounds.iter_mut().find(|b| b.0 == span.bound) {
            Some(b) => b.1 += 1,
            None => bounds.push((&span.bound, 1)),
        }
    }
    for (bound, count) in bounds {
        let _ = writeln!(out, "{count} legs in contact could be faster but for: {bound}");
    }
    for (u, l) in uses(task, plan).iter().zip(&task.limits) {
        let torque = match (task.standard.is_some(), l.torque) {
            (true, Some(limit)) => format!(", torque {} of {} N m", figure(u.peak[2]), figure(limit)),
            _ => String::new(),
        };
        let _ = writeln!(
            out,
            "  {}: {} from the end of its travel, speed {} of {}, acceleration {} of {}{torque}",
            l.name,
            figure(u.margin),
            figure(u.peak[0]),
            figure(l.velocity),
            figure(u.peak[1]),
            figure(l.acceleration)
        );
    }
    out + &warnings.text()
}
