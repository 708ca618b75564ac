//! Sequential quadratic programming with an exact penalty and a trust region (Fletcher's
//! S-l-infinity-QP; Nocedal and Wright, *Numerical Optimization*, section 18.5).
//!
//! The bounds of position, velocity, acceleration and jerk are linear and hold at every iterate.
//! The other constraints may be violated on the way: the merit is `f + penalty * max(0, c)`. The
//! Hessian of the Lagrangian is a BFGS matrix with Powell's damping.

use nalgebra::{DMatrix, DVector};

use super::program::{Bound, Program, Watched};
use super::subproblem::{self, Row, Step};

/// Bounds that this share of a step's reach could violate are passed to the subproblem at once.
const NEAR: f64 = 0.25;
/// Smallest factor by which an update shrinks the curvature matrix.
const SHRINK: f64 = 0.85;

/// Settings of one run.
#[derive(Debug, Clone, Copy)]
pub(super) struct Settings {
    pub(super) iterations: usize,
    /// Number of consecutive iterations with a gain below `gain` per column after which the run
    /// stops.
    pub(super) patience: usize,
    pub(super) gain: f64,
}

/// State of a run that can be continued: on a finer grid or with another power the curvature is
/// similar.
#[derive(Debug, Clone)]
pub(super) struct Search {
    pub(super) point: Point,
    hessian: Option<DMatrix<f64>>,
    /// Trust radius, rad or m.
    radius: f64,
    penalty: f64,
}

impl Search {
    /// Starts from variables within the bounds, with this trust radius.
    pub(super) fn new(x: Vec<f64>, radius: f64) -> Self {
        let point = Point { x, value: f64::INFINITY, worst: f64::INFINITY };
        Self { point, hessian: None, radius, penalty: 1.0 }
    }
}

/// Current point of a run.
#[derive(Debug, Clone)]
pub(super) struct Point {
    pub(super) x: Vec<f64>,
    pub(super) value: f64,
    /// Largest constraint value; not positive if feasible.
    pub(super) worst: f64,
}

/// Minimises from the search's point. `visit` receives every accepted point and returns whether to
/// continue.
pub(super) fn minimise(
    program: &Program<'_>,
    search: &mut Search,
    power: f64,
    settings: &Settings,
    visit: &mut dyn FnMut(&Point) -> bool,
) {
    let mut x = search.point.x.clone();
    let n = x.len();
    let Some((mut value, mut gradient)) = program.objective(&x, power) else {
        search.point = Point { worst: f64::INFINITY, value: f64::INFINITY, x };
        return;
    };
    let mut guarded = program.guarded(&x);
    let mut worst = largest(&guarded);
    let mut best: Option<Point> = None;
    let (mut radius, mut penalty) = (search.radius, search.penalty);
    let mut fresh = search.hessian.is_none();
    let mut hessian = search.hessian.take().unwrap_or_else(|| {
        let size = norm(&gradient).max(1e-12);
        DMatrix::<f64>::identity(n, n) * (size / radius).max(1e-8)
    });
    let mut also: Vec<Watched> = Vec::new();
    let mut idle = 0;
    for _ in 0..settings.iterations {
        let watched = watch(program, &guarded, &also, radius);
        let slopes = program.gradients(&x, &watched);
        let len = program.guard.times.len();
        let mut rows: Vec<Row> = Vec::new();
        let mut kept: Vec<Watched> = Vec::new();
        for (&(c, s), slope) in watched.iter().zip(slopes) {
            let now = guarded[c * len + s];
            if now + radius * slope.iter().map(|v| v.abs()).sum::<f64>() > 0.0 {
                rows.push(Row { first: 0, values: slope, bound: -now, soft: true });
                kept.push((c, s));
            }
        }
        let Some(step) = bounded(program, &x, &hessian, &gradient, rows, penalty, radius) else {
            radius *= 0.25;
            hessian = DMatrix::identity(n, n) * (norm(&gradient).max(1e-12) / radius);
            fresh = true;
            if radius < 1e-6 {
                break;
            }
            continue;
        };
        // Penalty update: the slack must decrease where the model allows it.
        let violation = worst.max(0.0);
        let lambda = &step.multipliers[..kept.len()];
        let total: f64 = lambda.iter().sum();
        if step.slack > 1e-6 && step.slack > 0.9 * violation && penalty < 1e4 {
            penalty *= 4.0;
        } else if penalty < 1.2 * total {
            penalty = 1.5 * total;
        }
        let mut d = step.d;
        let room = program.room(&x, &d);
        d.iter_mut().for_each(|d| *d *= room);
        let trial: Vec<f64> = x.iter().zip(&d).map(|(x, d)| x + d).collect();
        let dv = DVector::from_column_slice(&d);
        let bend = 0.5 * dv.dot(&(&hessian * &dv));
        let slope: f64 = d.iter().zip(&gradient).map(|(d, g)| d * g).sum();
        let predicted = -(slope + bend) + penalty * (violation - step.slack.min(violation));
        let trial_guarded = program.guarded(&trial);
        let trial_worst = largest(&trial_guarded);
        let trial_value = program.objective(&trial, power);
        let merit = |f: f64, w: f64| f + penalty * w.max(0.0);
        let gained = trial_value.as_ref().map(|(f, _)| merit(value, worst) - merit(*f, trial_worst));
        let ratio = gained.map_or(-1.0, |g| g / predicted.max(1e-14));
        let reach = d.iter().fold(0.0_f64, |m, d| m.max(d.abs()));
        if let Some((_, g)) = &trial_value {
            // Change of the Lagrangian's gradient; a rejected step is the most informative.
            let mut y: Vec<f64> = g.iter().zip(&gradient).map(|(a, b)| a - b).collect();
            let (active, weights): (Vec<Watched>, Vec<f64>) =
                kept.iter().zip(lambda).filter(|(_, l)| **l > 1e-6).map(|(w, l)| (*w, *l)).unzip();
            let (after, before) =
                (program.weighted(&trial, &active, &weights), program.weighted(&x, &active, &weights));
            y.iter_mut().zip(after.iter().zip(&before)).for_each(|(y, (a, b))| *y += a - b);
            update(&mut hessian, &dv, &DVector::from_vec(y), &mut fresh);
        }
        match trial_value {
            Some((f, g)) if ratio > 0.02 => {
                let gain = merit(value, worst) - merit(f, trial_worst);
                (x, value, gradient, guarded, worst) = (trial, f, g, trial_guarded, trial_worst);
                also.clear();
                if ratio > 0.7 && reach > 0.8 * radius {
                    radius = (radius * 2.0).min(1.5);
                } else if ratio < 0.2 {
                    radius *= 0.5;
                }
                idle = if gain < settings.gain { idle + 1 } else { 0 };
                let point = Point { x: x.clone(), value, worst };
                let go_on = visit(&point);
                if best.as_ref().is_none_or(|b| better(&point, b)) {
                    best = Some(point);
                }
                if !go_on {
                    break;
                }
            }
            _ => {
                also.extend((0..trial_guarded.len()).filter(|&k| trial_guarded[k] > 0.0).map(|k| (k / len, k % len)));
                also.sort_unstable();
                also.dedup();
                radius = 0.4 * reach.min(radius);
                idle += 1;
            }
        }
        if radius < 1e-5 || idle >= settings.patience {
            break;
        }
    }
    let point = best.filter(|b| b.worst <= 0.0 || worst > 0.0).unwrap_or(Point { x, value, worst });
    let hessian = (!fresh).then_some(hessian);
    // A run that is stuck may progress again on another grid.
    *search = Search { point, hessian, radius: radius.clamp(0.02, 0.3), penalty };
}

/// Solves for the step. The subproblem first has the bounds that a fraction of the radius could
/// violate, then also those that the step violates. That takes fewer rows than all within reach,
/// and occasionally one more round.
fn bounded(
    program: &Program<'_>,
    x: &[f64],
    hessian: &DMatrix<f64>,
    gradient: &[f64],
    mut rows: Vec<Row>,
    penalty: f64,
    radius: f64,
) -> Option<Step> {
    let soft = rows.len();
    let (near, mut far): (Vec<_>, Vec<_>) = program.bounds(x, radius).into_iter().partition(|bound| bound.near(NEAR));
    rows.extend(near.iter().map(Bound::row));
    loop {
        let step = subproblem::solve(hessian, gradient, &rows, penalty, radius)?;
        let (more, rest): (Vec<_>, Vec<_>) = far.into_iter().partition(|bound| bound.broken(&step.d));
        if more.is_empty() {
            return Some(Step { multipliers: step.multipliers[..soft].to_vec(), ..step });
        }
        rows.extend(more.iter().map(Bound::row));
        far = rest;
    }
}

/// Whether `a` is better: feasible before infeasible, then the lower value, or the smaller
/// violation.
pub(super) fn better(a: &Point, b: &Point) -> bool {
    match (a.worst <= 0.0, b.worst <= 0.0) {
        (true, true) => a.value < b.value,
        (false, false) => a.worst < b.worst,
        (feasible, _) => feasible,
    }
}

/// Constraints near their limit, and those that the last step violated: only local maxima in time,
/// and all violated ones.
fn watch(program: &Program<'_>, guarded: &[f64], also: &[Watched], radius: f64) -> Vec<Watched> {
    let len = program.guard.times.len();
    let mut watched: Vec<Watched> = Vec::new();
    for (c, row) in guarded.chunks(len.max(1)).enumerate() {
        for s in 0..len {
            let (before, after) = (s.saturating_sub(1), (s + 1).min(len - 1));
            let peak = row[s] >= row[before] && row[s] >= row[after];
            if (peak && row[s] > -(0.1 + 2.0 * radius)) || row[s] > -0.02 {
                watched.push((c, s));
            }
        }
    }
    watched.extend(also);
    watched.sort_unstable();
    watched.dedup();
    watched
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(-1.0, |m: f64, v| if v.is_nan() { f64::INFINITY } else { m.max(*v) })
}

fn norm(x: &[f64]) -> f64 {
    x.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// BFGS with Powell's damping (Nocedal and Wright, procedure 18.2). The criteria have negative
/// curvature along most steps, and a positive definite matrix overestimates it. The matrix is
/// therefore scaled down first by the factor that the step shows (Oren and Luenberger, Management
/// Science 20, 1974).
fn update(hessian: &mut DMatrix<f64>, s: &DVector<f64>, y: &DVector<f64>, fresh: &mut bool) {
    let sy = s.dot(y);
    if *fresh && sy > 0.0 {
        // The first matrix is scaled to the curvature of the first step.
        let n = s.len();
        *hessian = DMatrix::identity(n, n) * (y.norm_squared() / sy).clamp(1e-6, 1e6);
        *fresh = false;
    }
    let mut bs = &*hessian * s;
    let mut sbs = s.dot(&bs);
    if sbs <= 0.0 || !sbs.is_finite() {
        return;
    }
    let scale = (sy / sbs).clamp(SHRINK, 1.0);
    *hessian *= scale;
    bs *= scale;
    sbs *= scale;
    let theta = if sy >= 0.2 * sbs { 1.0 } else { 0.8 * sbs / (sbs - sy) };
    let r = y * theta + &bs * (1.0 - theta);
    let sr = s.dot(&r);
    if sr <= 1e-14 * s.norm_squared() {
        return;
    }
    hessian.ger(1.0 / sr, &r, &r, 1.0);
    hessian.ger(-1.0 / sbs, &bs, &bs, 1.0);
    // Keeps both triangles bit-identical.
    hessian.fill_lower_triangle_with_upper_triangle();
}
