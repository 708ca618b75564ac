//! Checks a written motion from any source. Shares no code with the designer: torques and frames
//! come from the numeric recursion, the motion between rows from quintic Hermite pieces, pairs of
//! spheres from the robot file.

use super::error::MotionError;
use dh_codegen::arm::param;
use dh_codegen::robot::{JointKind, Robot};
use nalgebra::{Matrix4, Point3};

use crate::model::rigid_body::Numeric;

/// A motion as in a file: one row per time.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Written {
    /// Times, s.
    pub t: Vec<f64>,
    /// Positions per row, rad or m.
    pub q: Vec<Vec<f64>>,
    /// Velocities per row; if empty, taken from differences.
    pub dq: Vec<Vec<f64>>,
    /// Accelerations per row; if empty, taken from differences.
    pub ddq: Vec<Vec<f64>>,
}

/// Tightest value of one condition relative to its limit.
#[derive(Debug, Clone, PartialEq)]
pub struct Finding {
    /// `position`, `velocity`, `acceleration`, `jerk`, `torque`, `ground`, `self_collision`, `box`,
    /// `rest`, `consistency`.
    pub kind: &'static str,
    /// Name of the joint, frame or pair.
    pub who: String,
    /// Time of the tightest value, s.
    pub time: f64,
    /// Value at that time.
    pub value: f64,
    /// Limit to keep.
    pub limit: f64,
    /// Whether the limit is violated.
    pub broken: bool,
}

/// Result of a check.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Verdict {
    /// The tightest finding for each kind and joint (pair, frame).
    pub findings: Vec<Finding>,
    /// Limits that could not be checked, with reasons.
    pub unchecked: Vec<String>,
    /// Checks against a limit that is not in the file.
    pub assumed: Vec<String>,
    /// Number of instants checked.
    pub instants: usize,
}

impl Verdict {
    /// Whether all limits are kept.
    pub fn feasible(&self) -> bool {
        self.findings.iter().all(|f| !f.broken)
    }
}

/// Tolerance for numbers that were rounded when written, as a share of a limit.
const ROUNDING: f64 = 1e-5;
/// Number of instants per interval between rows.
const BETWEEN: usize = 4;

/// Keeps the tightest value of one condition.
struct Tightest {
    finding: Finding,
    excess: f64,
}

impl Tightest {
    fn new(kind: &'static str, who: String, limit: f64) -> Self {
        let finding = Finding { kind, who, time: 0.0, value: 0.0, limit, broken: false };
        Self { finding, excess: f64::NEG_INFINITY }
    }

    /// Updates the finding; a positive `excess` is a violation, up to `slack`.
    fn see(&mut self, time: f64, value: f64, excess: f64, slack: f64) {
        if excess > self.excess || excess.is_nan() {
            self.excess = excess;
            self.finding.time = time;
            self.finding.value = value;
            self.finding.broken = excess.is_nan() || excess > slack;
        }
    }
}

/// Checks a motion against a robot file. `acceleration_time`, s, replaces missing acceleration
/// limits: the time in which full speed may be reached. With `None` acceleration is not checked
/// there.
///
/// # Errors
/// Returns an error if the rows are no motion of this robot: too few, of the wrong width, times not
/// ascending.
pub fn check(robot: &Robot, motion: &Written, acceleration_time: Option<f64>) -> Result<Verdict, MotionError> {
    let n = robot.dof();
    let rows = motion.t.len();
    if rows < 3 {
        return Err(MotionError::Rows(rows));
    }
    if let Some(at) = motion.t.windows(2).position(|w| w[1].partial_cmp(&w[0]) != Some(std::cmp::Ordering::Greater)) {
        return Err(MotionError::Time { row: at + 2, time: motion.t[at + 1], before: motion.t[at] });
    }
    if motion
        .q
        .iter()
        .chain(&motion.dq)
        .chain(&motion.ddq)
        .any(|row| row.len() != n || row.iter().any(|v| !v.is_finite()))
    {
        return Err(MotionError::Width(n));
    }
    let dq = if motion.dq.is_empty() { differences(&motion.t, &motion.q) } else { motion.dq.clone() };
    let ddq = if motion.ddq.is_empty() { differences(&motion.t, &dq) } else { motion.ddq.clone() };
    let mut verdict = Verdict::default();
    let moving = robot.moving();
    let name = |j: usize| robot.joints[moving[j]].name.clone();

    let mut joints: Vec<[Option<Tightest>; 5]> = Vec::new();
    for j in 0..n {
        let limits = &robot.joints[moving[j]].limits;
        let make = |kind, limit: Option<f64>| limit.map(|l| Tightest::new(kind, name(j), l));
        let assumed = match (limits.velocity, acceleration_time) {
            (Some(v), Some(time)) => Some(v / time),
            _ => None,
        };
        for (limit, there) in [
            ("position", limits.position.is_some()),
            ("velocity", limits.velocity.is_some()),
            ("torque", limits.torque.is_some()),
        ] {
            if !there {
                verdict.unchecked.push(format!("{limit} of {}: no limit in the file", name(j)));
            }
        }
        if limits.acceleration.is_none() {
            match assumed {
                Some(a) => verdict.assumed.push(format!("{} {a:.3}", name(j))),
                None => verdict.unchecked.push(format!("acceleration of {}: no limit in the file", name(j))),
            }
        }
        joints.push([
            make("position", limits.position.map(|p| p[1])),
            make("velocity", limits.velocity),
            make("acceleration", limits.acceleration.or(assumed)),
            make("jerk", limits.jerk),
            make("torque", limits.torque),
        ]);
    }
    let numeric = Numeric::new(robot);
    let phi = param::standard_values(robot);
    if phi.is_none() {
        verdict.unchecked.push("torque: the file has no inertial parameters of all links".into());
    }
    if robot.collision.ground.is_none() {
        verdict.unchecked.push("ground: the file has none".into());
    }
    if robot.collision.spheres.is_empty() {
        verdict.unchecked.push("self-collision: the file has no spheres".into());
    }
    let mut around = Around::new(robot, &numeric);

    let mut rest: Vec<Tightest> = Vec::new();
    for j in 0..n {
        for (k, when) in [(0, "start"), (rows - 1, "end")] {
            let mut speed = Tightest::new("rest", format!("speed of {} at the {when}", name(j)), 0.0);
            let scale = robot.joints[moving[j]].limits.velocity.unwrap_or(1.0);
            speed.see(motion.t[k], dq[k][j], dq[k][j].abs() - 1e-3 * scale, 0.0);
            let mut acceleration = Tightest::new("rest", format!("acceleration of {} at the {when}", name(j)), 0.0);
            acceleration.see(motion.t[k], ddq[k][j], ddq[k][j].abs() - 2e-2 * scale, 0.0);
            rest.extend([speed, acceleration]);
        }
    }

    let mut consistency: Vec<Tightest> =
        (0..n).map(|j| Tightest::new("consistency", format!("q, dq and ddq of {}", name(j)), 1.0)).collect();
    for k in 0..rows - 1 {
        let h = motion.t[k + 1] - motion.t[k];
        for j in 0..n {
            let (q0, q1, v0, v1) = (motion.q[k][j], motion.q[k + 1][j], dq[k][j], dq[k + 1][j]);
            let (a0, a1) = (ddq[k][j], ddq[k + 1][j]);
            // Euler-Maclaurin: position changes from the velocities, and velocity changes from the
            // accelerations.
            let by_speed = (q1 - q0) - h * (v0 + v1) / 2.0 - h * h * (a0 - a1) / 12.0;
            let by_acceleration = (v1 - v0) - h * (a0 + a1) / 2.0;
            let scale = 1e-6 + h * (v0.abs().max(v1.abs()) + h * a0.abs().max(a1.abs()) + 0.02);
            let other = 1e-6 + h * (a0.abs().max(a1.abs()) + 0.1);
            let worst = (by_speed.abs() / (0.02 * scale)).max(by_acceleration.abs() / (0.1 * other));
            consistency[j].see(motion.t[k], worst, worst - 1.0, 0.0);
            if let Some(jerk) = &mut joints[j][3] {
                let mean = (a1 - a0) / h;
                let limit = jerk.finding.limit;
                jerk.see(motion.t[k], mean, mean.abs() / limit - 1.0, 1e-3);
            }
        }
        let last = if k + 2 == rows { BETWEEN } else { BETWEEN - 1 };
        for step in 0..=last {
            let s = step as f64 / BETWEEN as f64;
            let time = motion.t[k] + s * h;
            let mut state = [vec![0.0; n], vec![0.0; n], vec![0.0; n]];
            for j in 0..n {
                let ends = [motion.q[k][j], dq[k][j], ddq[k][j], motion.q[k + 1][j], dq[k + 1][j], ddq[k + 1][j]];
                let at = hermite(ends, h, s);
                (0..3).for_each(|d| state[d][j] = at[d]);
                let [position, velocity, acceleration, ..] = &mut joints[j];
                if let (Some(seen), Some([low, high])) = (position, robot.joints[moving[j]].limits.position) {
                    let excess = (at[0] - high).max(low - at[0]);
                    seen.see(time, at[0], excess, ROUNDING * (high - low));
                    if seen.finding.time == time {
                        seen.finding.limit = if at[0] - high > low - at[0] { high } else { low };
                    }
                }
                for (seen, value) in [(velocity, at[1]), (acceleration, at[2])] {
                    if let Some(seen) = seen {
                        let limit = seen.finding.limit;
                        seen.see(time, value, value.abs() / limit - 1.0, ROUNDING * 10.0);
                    }
                }
            }
            if let Some(phi) = &phi {
                let torque = numeric.inverse_dynamics(&state[0], &state[1], &state[2], phi);
                for j in 0..n {
                    if let Some(seen) = &mut joints[j][4] {
                        let limit = seen.finding.limit;
                        seen.see(time, torque[j], torque[j].abs() / limit - 1.0, ROUNDING);
                    }
                }
            }
            around.see(&numeric, &state[0], time);
            verdict.instants += 1;
        }
    }
    let torque_known = phi.is_some();
    let kept = joints.into_iter().flatten().flatten().filter(|t| torque_known || t.finding.kind != "torque");
    let all = kept.chain(rest).chain(consistency).chain(around.finish());
    verdict.findings = all.map(|t| t.finding).collect();
    Ok(verdict)
}

/// Checks of ground, spheres and boxes.
struct Around<'r> {
    robot: &'r Robot,
    ground: Vec<(usize, Tightest)>,
    pairs: Vec<(usize, usize, Tightest)>,
    boxes: Vec<(usize, usize, Tightest)>,
}

impl<'r> Around<'r> {
    fn new(robot: &'r Robot, numeric: &Numeric) -> Self {
        let spheres = &robot.collision.spheres;
        // A property that is the same in these postures is taken as constant.
        let postures: Vec<Vec<f64>> = (0..12)
            .map(|k| (0..robot.dof()).map(|j| (1.7 * k as f64 + 2.3 * j as f64).sin() * 1.5).collect())
            .collect();
        let frames: Vec<Vec<Matrix4<f64>>> = postures.iter().map(|q| all_frames(robot, numeric, q)).collect();
        let varies = |f: &dyn Fn(&[Matrix4<f64>]) -> f64| {
            let values: Vec<f64> = frames.iter().map(|frames| f(frames)).collect();
            values.iter().any(|v| (v - values[0]).abs() > 1e-9)
        };
        let moves =
            |from: usize, to: usize| robot.joints[from..to].iter().filter(|j| j.kind != JointKind::Fixed).count();
        let count = frames[0].len();
        let ground = robot.collision.ground.map_or_else(Vec::new, |z| {
            let rises = |&f: &usize| varies(&|frames| frames[f][(2, 3)]);
            (0..count).filter(rises).map(|f| (f, Tightest::new("ground", format!("frame {}", f + 1), z))).collect()
        });
        let (mut pairs, mut boxes) = (Vec::new(), Vec::new());
        for a in 0..spheres.len() {
            for b in a + 1..spheres.len() {
                let (low, high) = (spheres[a].link.min(spheres[b].link), spheres[a].link.max(spheres[b].link));
                let gap = |frames: &[Matrix4<f64>]| (place(robot, frames, a) - place(robot, frames, b)).norm();
                if moves(low, high) >= 2 && varies(&gap) {
                    let who = format!(
                        "spheres {} (link {}) and {} (link {})",
                        a + 1,
                        spheres[a].link,
                        b + 1,
                        spheres[b].link
                    );
                    pairs.push((a, b, Tightest::new("self_collision", who, spheres[a].radius + spheres[b].radius)));
                }
            }
            for (b, cuboid) in robot.collision.boxes.iter().enumerate() {
                if (0..3).any(|i| varies(&|frames| place(robot, frames, a)[i])) {
                    let who = format!("sphere {} (link {}) and box {}", a + 1, spheres[a].link, cuboid.name);
                    boxes.push((a, b, Tightest::new("box", who, spheres[a].radius)));
                }
            }
        }
        Self { robot, ground, pairs, boxes }
    }

    fn see(&mut self, numeric: &Numeric, q: &[f64], time: f64) {
        if self.ground.is_empty() && self.pairs.is_empty() && self.boxes.is_empty() {
            return;
        }
        let frames = all_frames(self.robot, numeric, q);
        for (f, seen) in &mut self.ground {
            let z = frames[*f][(2, 3)];
            seen.see(time, z, seen.finding.limit - z, 1e-6);
        }
        for (a, b, seen) in &mut self.pairs {
            let d = (place(self.robot, &frames, *a) - place(self.robot, &frames, *b)).norm();
            seen.see(time, d, seen.finding.limit - d, 1e-6);
        }
        for (a, b, seen) in &mut self.boxes {
            let (p, cuboid) = (place(self.robot, &frames, *a), &self.robot.collision.boxes[*b]);
            let nearest = Point3::from(std::array::from_fn(|i| p[i].clamp(cuboid.min[i], cuboid.max[i])));
            let mut d = (p - nearest).norm();
            if d == 0.0 {
                d = (0..3).map(|i| (cuboid.min[i] - p[i]).max(p[i] - cuboid.max[i])).fold(f64::NEG_INFINITY, f64::max);
            }
            seen.see(time, d, seen.finding.limit - d, 1e-6);
        }
    }

    fn finish(self) -> impl Iterator<Item = Tightest> {
        let pairs = self.pairs.into_iter().map(|p| p.2).chain(self.boxes.into_iter().map(|b| b.2));
        self.ground.into_iter().map(|g| g.1).chain(pairs)
    }
}

fn all_frames(robot: &Robot, numeric: &Numeric, q: &[f64]) -> Vec<Matrix4<f64>> {
    let mut frames = numeric.frames(q);
    if robot.tool.is_some() {
        frames.push(numeric.tool(q));
    }
    frames
}

/// Centre of a sphere in the world frame, m.
fn place(robot: &Robot, frames: &[Matrix4<f64>], sphere: usize) -> Point3<f64> {
    let sphere = &robot.collision.spheres[sphere];
    let center = Point3::from(sphere.center);
    match sphere.link {
        0 => robot.base.as_ref().map_or(center, |base| Point3::from(base.point(sphere.center))),
        link => frames[link - 1].transform_point(&center),
    }
}

/// Central differences over time, one-sided at the ends.
fn differences(t: &[f64], rows: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let last = t.len() - 1;
    (0..=last)
        .map(|k| {
            let (a, b) = (k.saturating_sub(1), (k + 1).min(last));
            rows[a].iter().zip(&rows[b]).map(|(x, y)| (y - x) / (t[b] - t[a])).collect()
        })
        .collect()
}

/// Position, velocity and acceleration at share `s` of a step `h`, s, by the quintic through
/// position, velocity and acceleration at both ends.
fn hermite([q0, v0, a0, q1, v1, a1]: [f64; 6], h: f64, s: f64) -> [f64; 3] {
    let (v0, v1, a0, a1) = (v0 * h, v1 * h, a0 * h * h, a1 * h * h);
    let d = q1 - q0;
    let c = [
        q0,
        v0,
        0.5 * a0,
        10.0 * d - 6.0 * v0 - 4.0 * v1 - 1.5 * a0 + 0.5 * a1,
        -15.0 * d + 8.0 * v0 + 7.0 * v1 + 1.5 * a0 - a1,
        6.0 * d - 3.0 * (v0 + v1) - 0.5 * (a0 - a1),
    ];
    let position = c.iter().rev().fold(0.0, |sum, c| sum * s + c);
    let velocity = (1..6).rev().fold(0.0, |sum, k| sum * s + k as f64 * c[k]);
    let acceleration = (2..6).rev().fold(0.0, |sum, k| sum * s + (k * (k - 1)) as f64 * c[k]);
    [position, velocity / h, acceleration / (h * h)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hermite_is_the_quintic() {
        let p = |t: f64| {
            [
                1.0 + t - 2.0 * t.powi(2) + 0.5 * t.powi(3) - t.powi(4) + 0.25 * t.powi(5),
                1.0 - 4.0 * t + 1.5 * t.powi(2) - 4.0 * t.powi(3) + 1.25 * t.powi(4),
                -4.0 + 3.0 * t - 12.0 * t.powi(2) + 5.0 * t.powi(3),
            ]
        };
        let (start, h) = (0.3, 0.7);
        let (a, b) = (p(start), p(start + h));
        for k in 0..=10 {
            let s = k as f64 / 10.0;
            let (got, expected) = (hermite([a[0], a[1], a[2], b[0], b[1], b[2]], h, s), p(start + s * h));
            (0..3).for_each(|d| assert!((got[d] - expected[d]).abs() < 1e-12));
        }
    }
}
