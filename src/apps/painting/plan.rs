//! The painting plan: the motion found, and its evaluation at any instant.

use crate::data::trajectory::times;

use super::motion::PaintingMotion;
use super::search::{Progress, Search};
use super::strokes::{Phase, Strokes, rest_to_rest};
use super::surface::{Roller, Surface};
use super::task::{Cover, Task};
use super::vector::{Vector, add, dot, norm, scale};
use crate::apps::painting::cost::{From, Scored};
use crate::apps::painting::coverage::Coverage;
use crate::apps::painting::leg_timing::{Bound, Broken};
use crate::model::States;

/// A leg of a plan.
#[derive(Debug, Clone, PartialEq)]
pub struct Span {
    /// Action of the roller.
    pub phase: Phase,
    /// Start: wall coordinates and distance from the wall, m, and swivel angle, rad (or position of
    /// the locked joint).
    pub from: [f64; 4],
    /// End, in the same coordinates.
    pub to: [f64; 4],
    /// Start and end time, s.
    pub time: [f64; 2],
    /// Description of the limit that determines its time.
    pub bound: String,
}

/// A side of the wall that is not painted to its end.
#[derive(Debug, Clone, PartialEq)]
pub struct Side {
    /// `upper`, `lower`, `left` (least y) or `right`.
    pub side: &'static str,
    /// Width left unpainted there, m.
    pub gap: f64,
    /// Description of the limits that are violated when the lanes are widened by a centimetre to
    /// this side.
    pub bound: String,
}

/// A painting motion.
#[derive(Debug, Clone, PartialEq)]
pub struct Plan {
    /// Name of the robot.
    pub robot: String,
    /// The wall.
    pub surface: Surface,
    /// The roller with its orientation.
    pub roller: Roller,
    /// The lanes.
    pub strokes: Strokes,
    /// The legs in order.
    pub spans: Vec<Span>,
    /// Joint motion.
    pub motion: PaintingMotion,
    /// Time in contact `T_C`, s.
    pub contact: f64,
    /// Integral of the squared joint jerks over the time in contact, rad^2/s^5.
    pub jerk: f64,
    /// Cost of equation (12), s.
    pub cost: f64,
    /// Cost of equation (12) with the best single swivel angle, if the plan has a spline, s.
    pub cost_constant: Option<f64>,
    /// Sides of the wall that are not painted to their end.
    pub sides: Vec<Side>,
}

/// State of arm and roller at an instant.
#[derive(Debug, Clone, PartialEq)]
pub struct Moment {
    /// Positions, rad or m.
    pub q: Vec<f64>,
    /// Velocities, rad/s or m/s.
    pub dq: Vec<f64>,
    /// Accelerations, rad/s^2 or m/s^2.
    pub ddq: Vec<f64>,
    /// Top three rows of the tool frame's homogeneous matrix in world axes, row-major, m.
    pub pose: [f64; 12],
    /// Middle of the roller's face, world axes, m.
    pub point: [f64; 3],
    /// Velocity of that point, world axes, m/s.
    pub velocity: [f64; 3],
    /// Acceleration of that point, world axes, m/s^2.
    pub acceleration: [f64; 3],
    /// The same point in wall coordinates, with its distance, m.
    pub place: [f64; 3],
    /// Unit normal out of the wall, world axes.
    pub normal: [f64; 3],
    /// Swivel angle, rad, or position of the locked joint.
    pub swivel: f64,
    /// Action of the roller.
    pub phase: Phase,
    /// Index of the leg.
    pub span: usize,
}

impl Moment {
    /// Positions, velocities and accelerations of `n` joints at these moments.
    pub fn states(n: usize, moments: &[Self]) -> States {
        let part = |of: fn(&Self) -> &Vec<f64>| (0..n).flat_map(|j| moments.iter().map(move |m| of(m)[j])).collect();
        States { len: moments.len(), q: part(|m| &m.q), dq: part(|m| &m.dq), ddq: part(|m| &m.ddq) }
    }
}

/// Reason why there is no plan.
#[derive(Debug, Clone, PartialEq)]
pub struct Infeasible {
    /// Description of violated limits with figures, worst first.
    pub reasons: Vec<String>,
    /// Whether the worst of them is a torque that a joint exceeds even at rest.
    pub too_weak: bool,
}

impl std::fmt::Display for Infeasible {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}", self.reasons.join("; "))
    }
}

impl std::error::Error for Infeasible {}

/// Solves equation (12).
///
/// # Errors
/// Describes which limit binds, by how much and where, for the candidate with the smallest
/// violation.
pub fn plan(task: &Task<'_>, progress: Progress<'_>) -> Result<Plan, Infeasible> {
    if let Some(reason) = ground_above_the_wall(task) {
        return Err(Infeasible { reasons: vec![reason], too_weak: false });
    }
    if let Some(reason) = beyond_the_stretched_arm(task) {
        return Err(Infeasible { reasons: vec![reason], too_weak: false });
    }
    let widest = task.widest();
    if task.cover == Cover::Whole {
        let [a, b, ..] = widest.painted(task.roller.width);
        let short = task.surface.width - (b - a);
        if short > 1e-9 {
            let reason = format!(
                "{} of {} m {} {short:.4} m of the wall's width of {} m unpainted; {} lanes are needed",
                if task.lanes == 1 { "1 lane".into() } else { format!("{} lanes", task.lanes) },
                task.roller.width,
                if task.lanes == 1 { "leaves" } else { "leave" },
                task.surface.width,
                Strokes::fewest(&task.surface, task.roller.width)
            );
            return Err(Infeasible { reasons: vec![reason], too_weak: false });
        }
    }
    let search = Search::new(task, progress);
    let (best, plain) = search.run();
    if !best.feasible() {
        return Err(search.infeasible(&best));
    }
    progress("knots", 0.0);
    let motion =
        PaintingMotion::new(task, &best).map_err(|e| Infeasible { reasons: vec![e.to_string()], too_weak: false })?;
    let mut begin = 0.0;
    let spans = best
        .legs
        .iter()
        .zip(&best.times)
        .map(|(leg, (time, bound))| {
            let (from, to) = (begin, begin + time);
            begin = to;
            let bound = search.name(*bound);
            Span { phase: leg.line.phase, from: leg.line.from, to: leg.line.to, time: [from, to], bound }
        })
        .collect();
    Ok(Plan {
        robot: task.arm.name().to_string(),
        surface: task.surface,
        roller: best.roller,
        strokes: best.strokes,
        spans,
        motion,
        contact: best.contact,
        jerk: best.jerk,
        cost: best.cost,
        cost_constant: plain.filter(Scored::feasible).map(|p| p.cost),
        sides: search.sides(&best),
    })
}

/// Message for a wall that lies entirely below the ground.
fn ground_above_the_wall(task: &Task<'_>) -> Option<String> {
    let ground = task.bodies.ground.as_ref()?.0;
    let [sides, ends] = [task.surface.sides(), task.surface.ends()];
    let corners = sides.iter().flat_map(|y| ends.iter().map(|z| task.surface.point([*y, *z, 0.0])[2]));
    let highest = corners.fold(f64::NEG_INFINITY, f64::max);
    (highest < ground).then(|| format!("the ground, at {ground} m, is above the wall's upper end, at {highest:.3} m"))
}

/// Message for a wall that no point of the tool frame can be brought to, whatever its direction.
fn beyond_the_stretched_arm(task: &Task<'_>) -> Option<String> {
    let (pivot, length) = stretched(task);
    let place = |along: [f64; 3]| dot(along, pivot);
    let ([left, right], [low, high]) = (task.surface.sides(), task.surface.ends());
    let nearest = [place(task.surface.across()).clamp(left, right), place(task.surface.up).clamp(low, high)];
    let wrist = task.surface.point([nearest[0], nearest[1], task.roller.length]);
    let distance = norm(add(wrist, scale(-1.0, pivot)));
    (distance > length).then(|| {
        format!(
            "out of reach by {:.4} m: the tool's frame must come to {distance:.3} m from the first joint, and the \
             stretched arm reaches {length:.3} m",
            distance - length
        )
    })
}

/// A point on the axis of the first joint, world axes, m, and the largest distance of the tool
/// frame's origin from it, m: distances between successive frames do not depend on revolute joints.
pub(super) fn stretched(task: &Task<'_>) -> ([f64; 3], f64) {
    let dof = task.limits.len();
    let frames = |first: f64| {
        let mut states = States::zeros(dof, 1);
        states.q[0] = first;
        let mut out = vec![0.0; 12 * task.arm.frame_count()];
        task.arm.frames(&states, &mut out);
        out.chunks_exact(12).map(|m| [m[3], m[7], m[11]]).collect::<Vec<Vector>>()
    };
    let apart = |a: Vector, b: Vector| norm(add(a, scale(-1.0, b)));
    let straight = frames(0.0);
    let turned = if task.slides[0] { straight[0] } else { frames(std::f64::consts::PI)[0] };
    let pivot = scale(0.5, add(straight[0], turned));
    let links = straight.windows(2).map(|pair| apart(pair[0], pair[1])).sum::<f64>();
    let slides = task.limits.iter().zip(&task.slides).filter(|(_, slides)| **slides);
    let travel = slides.map(|(limit, _)| limit.position[0].abs().max(limit.position[1].abs())).sum::<f64>();
    (pivot, apart(straight[0], pivot) + links + travel)
}

impl Search<'_> {
    /// Describes the limits that a candidate violates.
    fn infeasible(&self, best: &Scored) -> Infeasible {
        let mut broken = best.broken.clone();
        broken.sort_by(|a, b| b.weight.total_cmp(&a.weight));
        let mut reasons: Vec<String> = Vec::new();
        for b in &broken {
            let text = self.describe(b);
            if reasons.len() < 4 && !reasons.contains(&text) {
                reasons.push(text);
            }
        }
        let too_weak = broken.first().is_some_and(|b| matches!(b.bound, Bound::Torque(_)));
        Infeasible { reasons, too_weak }
    }

    /// Name of a limit in messages.
    fn name(&self, bound: Bound) -> String {
        let joint = |j: usize| self.judge.task.limits[j].name.clone();
        match bound {
            Bound::OutOfReach => "reach".into(),
            Bound::Direction => "direction of the roller".into(),
            Bound::Singular => "singularity".into(),
            Bound::Position(j) => format!("travel of {}", joint(j)),
            Bound::Velocity(j) => format!("speed of {}", joint(j)),
            Bound::Acceleration(j) => format!("acceleration of {}", joint(j)),
            Bound::Jerk(j) => format!("jerk of {}", joint(j)),
            Bound::Torque(j) => format!("torque of {}", joint(j)),
            Bound::Clearance(which) => format!("distance: {}", self.judge.around.describe(which)),
            Bound::Duration => "duration".into(),
            Bound::Weight => "weight of the jerk".into(),
            Bound::Shared => "duration that was given".into(),
        }
    }

    /// Describes a violated limit with figures.
    fn describe(&self, broken: &Broken) -> String {
        let [y, z, off] = broken.at;
        let place = if off > 1e-9 {
            format!("at y {y:.3}, z {z:.3}, {off:.3} m before the wall")
        } else {
            format!("at y {y:.3}, z {z:.3} m on the wall")
        };
        let task = self.judge.task;
        let unit = |j: usize| if task.slides[j] { "m" } else { "rad" };
        let amount = broken.amount;
        match broken.bound {
            Bound::OutOfReach => format!("out of reach by {amount:.4} m {place}"),
            Bound::Direction => format!("the arm can't point the roller there: {amount:.4} rad off {place}"),
            Bound::Singular => format!("the posture can't be followed (singularity, or its branch ends) {place}"),
            Bound::Position(j) => {
                let [low, high] = task.limits[j].position;
                format!(
                    "joint {} goes {amount:.4} {} beyond its travel of {low:.4} to {high:.4} {place}",
                    task.limits[j].name,
                    unit(j)
                )
            }
            Bound::Torque(j) => format!(
                "joint {} needs {amount:.3} N m more than its {} N m even at rest {place}",
                task.limits[j].name,
                task.limits[j].torque.unwrap_or(0.0)
            ),
            Bound::Clearance(which) => format!(
                "{}: {amount:.4} m short of the {} m that are kept, {place}",
                self.judge.around.describe(which),
                task.distance_margin
            ),
            Bound::Duration => format!(
                "the strokes need {amount:.3} s more than the {} s that were given",
                task.duration.unwrap_or(0.0)
            ),
            other => format!("{} is broken by {amount:.4} {place}", self.name(other)),
        }
    }

    /// Uncovered sides of the wall, with reasons.
    fn sides(&self, best: &Scored) -> Vec<Side> {
        let task = self.judge.task;
        let ([left, right], [low, high]) = (task.surface.sides(), task.surface.ends());
        let [a, b, lower, upper] = best.strokes.painted(task.roller.width);
        let gaps = [("upper", high - upper), ("lower", lower - low), ("left", a - left), ("right", right - b)];
        let wider = |side: &str| {
            let (mut s, more) = (best.strokes, 0.01);
            let lanes = s.lanes.saturating_sub(1).max(1) as f64;
            match side {
                "upper" => s.upper += more,
                "lower" => s.lower -= more,
                "left" => (s.first, s.step) = (s.first - more, s.step + if s.lanes > 1 { more / lanes } else { 0.0 }),
                _ if s.lanes > 1 => s.step += more / lanes,
                _ => s.first += more,
            }
            s
        };
        gaps.into_iter()
            .filter(|(_, gap)| *gap > 1e-3)
            .map(|(side, gap)| {
                let strokes = wider(side);
                let from = From::Near(&best.start);
                let found = self.judge.cost(&self.coarse, &strokes, &best.angles, &best.roller, from);
                let bound = match found.first().and_then(Scored::worst) {
                    Some(worst) => format!("a centimetre more: {}", self.describe(&worst)),
                    None if strokes.lanes > 1 && strokes.step.abs() > task.roller.width + 1e-9 => {
                        format!("the lanes lie a roller's width ({} m) apart already", task.roller.width)
                    }
                    None => "no limit: the cost of equation (12) is larger with more".into(),
                };
                Side { side, gap, bound }
            })
            .collect()
    }
}

impl Plan {
    /// Duration with approach and retreat, s.
    pub fn duration(&self) -> f64 {
        self.motion.duration()
    }

    /// Times at which the roller meets and leaves the wall, s.
    pub fn contact_span(&self) -> [f64; 2] {
        let mut touching = self.spans.iter().filter(|s| s.phase.contact());
        let start = touching.next().map_or(0.0, |s| s.time[0]);
        let end = touching.next_back().map_or(self.duration(), |s| s.time[1]);
        [start, end]
    }

    /// Evaluates the plan at time `t`, s; the arm is at rest before the start and after the end.
    pub fn at(&self, t: f64) -> Moment {
        let joints = self.motion.at(t);
        let time = if t.is_finite() { t.clamp(0.0, self.duration()) } else { 0.0 };
        let span = self.spans.partition_point(|s| s.time[1] <= time).min(self.spans.len().saturating_sub(1));
        let (mut place, mut rate, mut second, mut swivel, mut phase) =
            ([0.0; 3], [0.0; 3], [0.0; 3], 0.0, Phase::Approach);
        if let Some(s) = self.spans.get(span) {
            let length = (s.time[1] - s.time[0]).max(1e-12);
            let [x, v, a, _] = rest_to_rest(((time - s.time[0]) / length).clamp(0.0, 1.0));
            let way: [f64; 4] = std::array::from_fn(|i| s.from[i] + x * (s.to[i] - s.from[i]));
            place = [way[0], way[1], way[2]];
            swivel = way[3];
            rate = std::array::from_fn(|i| v / length * (s.to[i] - s.from[i]));
            second = std::array::from_fn(|i| a / (length * length) * (s.to[i] - s.from[i]));
            phase = s.phase;
        }
        let rows = self.roller.pose(&self.surface, place);
        Moment {
            q: joints.q,
            dq: joints.dq,
            ddq: joints.ddq,
            pose: std::array::from_fn(|k| rows[k / 4][k % 4]),
            point: self.surface.point(place),
            velocity: self.surface.direction(rate),
            acceleration: self.surface.direction(second),
            place,
            normal: self.surface.normal,
            swivel,
            phase,
            span,
        }
    }

    /// Times, s, and moments at `rate` per second, the end included.
    pub fn sampled(&self, rate: f64) -> Vec<(f64, Moment)> {
        times(self.duration(), rate).into_iter().map(|t| (t, self.at(t))).collect()
    }

    /// Painted area of the wall.
    pub fn coverage(&self) -> Coverage {
        Coverage::new(&self.surface, &self.strokes, self.roller.width)
    }
}
