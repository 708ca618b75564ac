//! Conversion of joint axes to a modified DH table: frames on common normals (Khalil and Dombre,
//! 3.2).
//!
//! Axis z of frame i lies on joint i, and its axis x on the common normal to joint i+1. There are
//! five cases of neighbouring axes: skew, crossing, parallel, anti-parallel, collinear. Where the
//! normal is free, frame i stays at the foot of the previous one, so that lengths vanish. The z
//! axis points as in the source, so positions are the source's own, and its zero goes into `theta`
//! (`r`).

use dh_codegen::robot::{Angle, JointKind};
use nalgebra::{Matrix3, Vector3};

use super::displacement::Displacement;

/// Sine of the angle below which axes count as parallel.
const PARALLEL: f64 = 1e-9;

/// Sine of the angle below which the common normal is farther away than any robot's size: a fixed
/// row is inserted.
const NEARLY_PARALLEL: f64 = 1e-2;

/// Sizes below this share of the robot's are rounding errors.
const ROUNDING: f64 = 1e-12;

/// Cosine below which a normal is perpendicular to the previous axis x, so that either direction is
/// possible.
const SQUARE: f64 = 1e-9;

/// Relation of the axes of neighbouring joints.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Neighbours {
    /// Neither intersecting nor parallel.
    Skew,
    /// Intersecting in a point.
    Crossing,
    /// Parallel at a distance.
    Parallel,
    /// Parallel and opposed: `alpha = pi`.
    AntiParallel,
    /// Collinear, in the same or the opposite direction.
    OneLine,
    /// Not parallel by an angle too small for a practical common normal, but larger than the
    /// rounding of doubles.
    NearlyParallel,
}

/// A joint's axis with all joints at their reference.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Line {
    /// A point on the axis, m.
    pub(super) point: Vector3<f64>,
    /// Unit vector of the axis.
    pub(super) axis: Vector3<f64>,
    /// Kind of joint; fixed for inserted rows.
    pub(super) kind: JointKind,
}

/// A row of the table.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct DhRow {
    /// Index into the lines; `None`: a fixed row.
    pub(super) line: Option<usize>,
    /// Twist, rad.
    pub(super) alpha: f64,
    /// Length, m.
    pub(super) d: f64,
    /// Joint angle at the reference, rad.
    pub(super) theta: f64,
    /// Offset, m.
    pub(super) r: f64,
    /// Pose of the frame with all joints at their reference.
    pub(super) frame: Displacement,
}

/// Rows of a table with the poses before and behind them.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct DhTable {
    /// Pose of frame 0; `None`: the frame in which the lines are given.
    pub(super) base: Option<Displacement>,
    /// Rows from base to tip.
    pub(super) rows: Vec<DhRow>,
    /// Pose of the tip in the last frame; `None`: the last frame is the tip's.
    pub(super) tool: Option<Displacement>,
    /// Relation of neighbouring lines, and the angle by which nearly parallel ones differ, rad.
    pub(super) neighbours: Vec<(Neighbours, f64)>,
}

/// A frame under construction: origin, axis x, axis z.
#[derive(Debug, Clone, Copy)]
struct Corner {
    origin: Vector3<f64>,
    x: Vector3<f64>,
    z: Vector3<f64>,
}

impl Corner {
    fn displacement(&self) -> Displacement {
        let z = self.z;
        // Orthogonal to the last digit, as theta is measured from it.
        let x = (self.x - z * z.dot(&self.x)).normalize();
        Displacement { rotation: Matrix3::from_columns(&[x, z.cross(&x), z]), origin: self.origin }
    }
}

/// A common normal: from `start` on this line to `end` on the next.
struct Normal {
    x: Vector3<f64>,
    start: Vector3<f64>,
    end: Vector3<f64>,
    case: Neighbours,
    angle: f64,
}

/// Table for lines that end in a tip frame, both in one frame; `size` is that of the robot, m.
pub(super) fn table(lines: &[Line], tip: &Displacement, size: f64) -> DhTable {
    let tiny = ROUNDING * size;
    let (base, foot) = first(&lines[0], tiny);
    let mut builder = Builder { rows: Vec::new(), neighbours: Vec::new(), before: base, foot };
    for (k, line) in lines.iter().enumerate() {
        let Some(next) = lines.get(k + 1) else {
            let at = last(line, &builder.foot, &builder.before.x, tip, tiny);
            builder.row(line, Some(k), &at);
            break;
        };
        let direct = normal(&builder.foot, &line.axis, &builder.before.x, next, tiny);
        builder.neighbours.push((direct.case, direct.angle));
        if direct.case != Neighbours::NearlyParallel {
            builder.row(line, Some(k), &direct);
            continue;
        }
        let between = bridge(&builder.foot, next, tiny);
        let at = normal(&builder.foot, &line.axis, &builder.before.x, &between, tiny);
        builder.row(line, Some(k), &at);
        let at = normal(&builder.foot, &between.axis, &builder.before.x, next, tiny);
        builder.row(&between, None, &at);
    }
    builder.finish(base, tip, tiny)
}

struct Builder {
    rows: Vec<DhRow>,
    neighbours: Vec<(Neighbours, f64)>,
    /// The last frame.
    before: Corner,
    /// Foot of its normal on the next line, m.
    foot: Vector3<f64>,
}

impl Builder {
    /// Adds the row from the last frame to one on a line, with the normal that leaves it.
    fn row(&mut self, line: &Line, index: Option<usize>, at: &Normal) {
        let (before, z) = (self.before, line.axis);
        let here = Corner { origin: at.start, x: at.x, z };
        let about = |axis: &Vector3<f64>, a: &Vector3<f64>, b: &Vector3<f64>| a.cross(b).dot(axis).atan2(a.dot(b));
        self.rows.push(DhRow {
            line: index,
            alpha: about(&before.x, &before.z, &z),
            d: (self.foot - before.origin).dot(&before.x),
            theta: about(&z, &before.x, &at.x),
            r: (at.start - self.foot).dot(&z),
            frame: here.displacement(),
        });
        (self.before, self.foot) = (here, at.end);
    }

    /// Completes the table: base, tool, and a first row of zeros if the base is the first frame.
    fn finish(mut self, base: Corner, tip: &Displacement, tiny: f64) -> DhTable {
        let in_world = base.z == Vector3::z() && base.x == Vector3::x() && base.origin == Vector3::zeros();
        let base = if in_world {
            None
        } else {
            let first = &mut self.rows[0];
            (first.alpha, first.d, first.theta, first.r) = (0.0, 0.0, 0.0, 0.0);
            Some(first.frame)
        };
        let tool = self.before.displacement().inverse().then(tip);
        let none = (tool.rotation - Matrix3::identity()).amax() < PARALLEL && tool.origin.amax() < tiny;
        DhTable { base, rows: self.rows, tool: (!none).then_some(tool), neighbours: self.neighbours }
    }
}

/// Frame 0, and the intersection of its axis x with the first line. It is the frame of the lines
/// itself if one row leads from it to the first joint.
fn first(line: &Line, tiny: f64) -> (Corner, Vector3<f64>) {
    let (x, z) = (Vector3::x(), Vector3::z());
    let world = Corner { origin: Vector3::zeros(), x, z };
    let across = line.axis.cross(&x);
    if line.axis.dot(&x).abs() < PARALLEL {
        // The line intersects the axis x if its point has no component across both.
        let off = if line.kind == JointKind::Prismatic { 0.0 } else { line.point.dot(&across) };
        if off.abs() < tiny {
            let d = if line.kind == JointKind::Prismatic { 0.0 } else { line.point.dot(&x) };
            return (world, x * d);
        }
    }
    let square = |v: Vector3<f64>| v - line.axis * line.axis.dot(&v);
    let side = [x, Vector3::y()].map(square).into_iter().find(|v| v.norm() > 0.5).unwrap_or_else(|| square(z));
    (Corner { origin: line.point, x: side.normalize(), z: line.axis }, line.point)
}

/// The last frame: the tip's own if it is on the joint's axis, else at the foot.
fn last(line: &Line, foot: &Vector3<f64>, x: &Vector3<f64>, tip: &Displacement, tiny: f64) -> Normal {
    let along: Vector3<f64> = tip.rotation.column(2).into();
    let way = tip.origin - foot;
    let off = way - line.axis * line.axis.dot(&way);
    let on_axis = (along - line.axis).norm() < PARALLEL && off.norm() < tiny;
    let (x, start) = if on_axis { (tip.rotation.column(0).into(), tip.origin) } else { (*x, *foot) };
    Normal { x, start, end: start, case: Neighbours::OneLine, angle: 0.0 }
}

/// The common normal from the line through `a` along `z` to the next line. `x` is the previous axis
/// x, which is kept, or turned by the smaller angle.
fn normal(a: &Vector3<f64>, z: &Vector3<f64>, x: &Vector3<f64>, next: &Line, tiny: f64) -> Normal {
    let cross = z.cross(&next.axis);
    let (sine, same) = (cross.norm(), z.dot(&next.axis) > 0.0);
    let free = next.kind == JointKind::Prismatic;
    // The line of a sliding joint may be shifted: it passes through the last foot.
    let to = if free { Vector3::zeros() } else { next.point - a };
    let angle = if same { sine.asin() } else { core::f64::consts::PI - sine.asin() };
    if sine < PARALLEL {
        let aside = to - z * z.dot(&to);
        let distance = aside.norm();
        if distance < tiny {
            return Normal { x: *x, start: *a, end: *a, case: Neighbours::OneLine, angle };
        }
        let case = if same { Neighbours::Parallel } else { Neighbours::AntiParallel };
        let along = aside / distance;
        let turned = along.dot(x) < -SQUARE;
        return Normal { x: if turned { -along } else { along }, start: *a, end: a + aside, case, angle };
    }
    let n = cross / sine;
    let distance = to.dot(&n);
    let start = a + z * (to.cross(&next.axis).dot(&cross) / (sine * sine));
    let end = a + to + next.axis * (to.cross(z).dot(&cross) / (sine * sine));
    let crossing = distance.abs() < tiny;
    // If both directions turn equally far: a positive twist, or a positive length.
    let positive = if crossing || distance > 0.0 { n } else { -n };
    let along = match positive.dot(x) {
        cosine if cosine < -SQUARE => -positive,
        _ => positive,
    };
    let case = match (sine < NEARLY_PARALLEL && !free, crossing) {
        (true, _) => Neighbours::NearlyParallel,
        (_, true) => Neighbours::Crossing,
        _ => Neighbours::Skew,
    };
    let end = if crossing { start } else { end };
    Normal { x: along, start, end, case, angle }
}

/// A line through the foot that intersects the next line at a right angle.
fn bridge(foot: &Vector3<f64>, next: &Line, tiny: f64) -> Line {
    let to = next.point - foot;
    let aside = to - next.axis * next.axis.dot(&to);
    let axis = if aside.norm() > tiny.max(1e-6 * to.norm()) {
        aside.normalize()
    } else {
        let square = |v: Vector3<f64>| v - next.axis * next.axis.dot(&v);
        let sides = [Vector3::x(), Vector3::y()].map(square);
        sides.into_iter().find(|v| v.norm() > 0.5).unwrap_or_else(Vector3::z).normalize()
    };
    Line { point: *foot, axis, kind: JointKind::Fixed }
}

/// The angle minus the position at which it holds.
pub(super) fn less(angle: Angle, reference: f64, tolerance: f64) -> Angle {
    if reference == 0.0 { angle } else { super::exact::exact_angle(angle.value - reference, tolerance) }
}
