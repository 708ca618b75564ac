//! A wall: a second law of `external_contact`. It pushes the tool's origin along the wall's normal,
//! in proportion to its depth behind the wall.

use std::f64::consts::FRAC_1_SQRT_2;

use dh_codegen::robot::EffectKind;
use dh_codegen::robot::effects::ExternalContact as Keys;
use nalgebra::Vector3;

use super::Estimate;
use super::Hypothesis;
use super::Kind;
use super::Named;
use super::Over;
use super::Scope;
use super::Shape;
use super::Sign;
use super::Symbol;
use super::Term;
use super::external_contact::ON_TOOL;
use super::pushed_stretches::quiet;
use crate::diagnose::windows::windowed_data::WindowedData;

/// Force `k max(at - n'p, 0)` along `n`.
pub struct Wall;

/// Indices of the shape's numbers: one of [`directions`], two tilts of the normal from it in
/// radians, distance of the plane from the pivot along the normal in metres, pivot.
const DIRECTION: usize = 0;
const TILTS: [usize; 2] = [1, 2];
const BEYOND: usize = 3;
const PIVOT: usize = 4;

/// Candidate directions of the normal: along axes, edges and diagonals of a cube.
fn directions() -> impl Iterator<Item = Vector3<f64>> {
    let three = || [-1.0, 0.0, 1.0].into_iter();
    let all = three().flat_map(move |x| three().flat_map(move |y| three().map(move |z| Vector3::new(x, y, z))));
    all.filter(|n| n.norm() > 0.5).map(|n| n.normalize())
}

/// Largest tilt from a direction, rad: the angle to the next one is 0.62 to 0.79 rad.
const TILTED: f64 = 0.8;

/// Shares of the log behind the wall in the first trial of each direction.
const BEHIND: [f64; 6] = [0.05, 0.12, 0.22, 0.35, 0.5, 0.65];

/// Least and largest share of the log behind it. Permanent contact is a spring.
const SHARE: [f64; 2] = [0.02, 0.8];

/// Least time behind it, s.
const LEAST: f64 = 0.5;

/// Number of shapes tried with everything else refitted.
const TRIED: usize = 8;

/// Unit normal of a shape. For a planar arm it stays in the arm's plane, since a force normal to
/// that plane causes no torque.
fn normal(scene: &WindowedData<'_>, shape: &[f64]) -> Vector3<f64> {
    let middle = directions().nth(shape[DIRECTION].max(0.0) as usize).unwrap_or_else(Vector3::z);
    // An axis that is not parallel to it.
    let aside = if middle.x.abs() < FRAC_1_SQRT_2 { Vector3::x() } else { Vector3::y() };
    let first = middle.cross(&aside).normalize();
    let second = middle.cross(&first);
    let free = middle + first * shape[TILTS[0]].tan() + second * shape[TILTS[1]].tan();
    inside(scene, &free).unwrap_or(middle)
}

/// Normalised projection of a direction onto those in which a force causes torque; `None` where
/// little of it remains.
fn inside(scene: &WindowedData<'_>, direction: &Vector3<f64>) -> Option<Vector3<f64>> {
    let idle = scene.directions_without_torque();
    let across: Vector3<f64> = idle.iter().map(|across| across * across.dot(direction)).sum();
    (direction - across).try_normalize(LEAST_INSIDE * direction.norm())
}

/// Least share of a direction within the plane of an arm for the projection to be used.
const LEAST_INSIDE: f64 = 0.1;

/// The same for a candidate direction: one with a smaller share is close to another candidate.
const MOSTLY: f64 = 0.85;

/// Distance of the plane of a shape from the base along its normal, m.
fn distance(scene: &WindowedData<'_>, shape: &[f64]) -> f64 {
    shape[BEYOND] + normal(scene, shape).iter().zip(&shape[PIVOT..]).map(|(n, p)| n * p).sum::<f64>()
}

/// Position along the normal in one window, m.
fn height(positions: &[f64], normal: &Vector3<f64>, w: usize) -> f64 {
    (0..3).map(|c| normal[c] * positions[c * (positions.len() / 3) + w]).sum()
}

/// Depth behind the plane in every window, m.
fn depths(positions: &[f64], normal: &Vector3<f64>, at: f64) -> Vec<f64> {
    (0..positions.len() / 3).map(|w| (at - height(positions, normal, w)).max(0.0)).collect()
}

/// Torques of a unit force along the normal, `[joint][window]`, N m/N.
fn along(scene: &WindowedData<'_>, normal: &Vector3<f64>) -> Vec<Vec<f64>> {
    let (unit, dof, len) = (scene.forces(), scene.dof(), scene.len);
    let torque = |j: usize, w: usize| -(0..3).map(|c| normal[c] * unit[(c * dof + j) * len + w]).sum::<f64>();
    (0..dof).map(|j| (0..len).map(|w| torque(j, w)).collect()).collect()
}

/// A candidate plane, with the gain of its force.
struct Plane {
    direction: usize,
    normal: Vector3<f64>,
    at: f64,
    /// Weighted sums of its torques times the residual, and of its torques squared.
    sums: [f64; 2],
}

impl Plane {
    /// Candidate planes of one normal, each with a share of the log behind it.
    fn of(direction: usize, normal: Vector3<f64>, positions: &[f64]) -> impl Iterator<Item = Self> {
        let mut heights: Vec<f64> = (0..positions.len() / 3).map(|w| height(positions, &normal, w)).collect();
        heights.sort_by(f64::total_cmp);
        let at = move |share: f64| heights.get((share * heights.len() as f64) as usize).copied();
        BEHIND.into_iter().filter_map(at).map(move |at| Self { direction, normal, at, sums: [0.0; 2] })
    }

    fn add(&mut self, depth: f64, [with, own]: [f64; 2]) {
        self.sums[0] += depth * with;
        self.sums[1] += depth * depth * own;
    }

    /// The plane as a shape, which tilts about the mean position behind it: a tilt about a distant
    /// point would also move the plane.
    fn shape(&self, positions: &[f64]) -> Vec<f64> {
        let len = positions.len() / 3;
        let behind: Vec<usize> = (0..len).filter(|&w| height(positions, &self.normal, w) < self.at).collect();
        let mean = |c: usize| behind.iter().map(|w| positions[c * len + w]).sum::<f64>() / behind.len().max(1) as f64;
        let middle = Vector3::from_fn(|c, _| mean(c));
        let beyond = self.at - self.normal.dot(&middle);
        vec![self.direction as f64, 0.0, 0.0, beyond, middle.x, middle.y, middle.z]
    }

    /// Only a pushing force counts.
    fn gain(&self) -> f64 {
        let [with, own] = self.sums;
        if with > 0.0 && own > 0.0 { with * with / own } else { 0.0 }
    }
}

impl Hypothesis for Wall {
    fn effect(&self) -> EffectKind {
        EffectKind::ExternalContact
    }

    fn kind(&self) -> Kind {
        Kind::Outside
    }

    fn scope(&self) -> Scope {
        Scope::Robot
    }

    fn shape(&self) -> &'static [Shape] {
        const TILT: [f64; 2] = [-TILTED, TILTED];
        &[
            Shape { symbol: Symbol::Own("direction"), unit: "", range: [0.0, 25.0], step: None },
            Shape { symbol: Symbol::Own("first tilt"), unit: "rad", range: TILT, step: Some(-0.2) },
            Shape { symbol: Symbol::Own("second tilt"), unit: "rad", range: TILT, step: Some(-0.2) },
            Shape { symbol: Symbol::Own("beyond"), unit: "m", range: [-1e3, 1e3], step: Some(-0.03) },
            Shape { symbol: Symbol::Own("x"), unit: "m", range: [-1e3, 1e3], step: None },
            Shape { symbol: Symbol::Own("y"), unit: "m", range: [-1e3, 1e3], step: None },
            Shape { symbol: Symbol::Own("z"), unit: "m", range: [-1e3, 1e3], step: None },
        ]
    }

    /// The planes whose force takes most of the residual, with nothing else refitted.
    fn grid(&self, scene: &WindowedData<'_>, _: &[usize], residual: &[Vec<f64>]) -> Vec<Vec<f64>> {
        let positions = scene.tool_positions();
        let weight: Vec<f64> = residual.iter().map(|row| quiet(row)).collect();
        let mut planes: Vec<Plane> = directions()
            .enumerate()
            .filter_map(|(d, n)| Some((d, inside(scene, &n).filter(|unit| unit.dot(&n) >= MOSTLY)?)))
            .flat_map(|(d, n)| Plane::of(d, n, positions))
            .collect();
        for same in planes.chunk_by_mut(|a, b| a.direction == b.direction) {
            let torque = along(scene, &same[0].normal);
            for w in 0..scene.len {
                let at = height(positions, &same[0].normal, w);
                let live = (0..scene.dof()).filter(|&j| scene.live[j][w]);
                let sums = live.fold([0.0; 2], |[with, own], j| {
                    let torque = torque[j][w];
                    [with + weight[j] * torque * residual[j][w], own + weight[j] * torque * torque]
                });
                same.iter_mut().for_each(|plane| plane.add((plane.at - at).max(0.0), sums));
            }
        }
        planes.sort_by(|a, b| b.gain().total_cmp(&a.gain()));
        let found = planes.iter().filter(|plane| plane.gain() > 0.0).take(TRIED);
        found.map(|plane| plane.shape(positions)).collect()
    }

    fn touches(&self, scene: &WindowedData<'_>, shape: &[f64]) -> Vec<bool> {
        let depth = depths(scene.tool_positions(), &normal(scene, shape), distance(scene, shape));
        depth.into_iter().map(|depth| depth > 0.0).collect()
    }

    /// A plane that is never reached, or never left, is not a wall.
    fn shows(&self, scene: &WindowedData<'_>, _: &[usize], shape: &[f64]) -> bool {
        let behind = self.touches(scene, shape).into_iter().filter(|behind| *behind).count();
        let share = behind as f64 / scene.len.max(1) as f64;
        (SHARE[0]..=SHARE[1]).contains(&share) && behind as f64 * scene.step >= LEAST
    }

    fn terms(&self, scene: &WindowedData<'_>, _: &[usize], shape: &[f64]) -> Vec<Term> {
        let normal = normal(scene, shape);
        let depth = depths(scene.tool_positions(), &normal, distance(scene, shape));
        let mut rows = along(scene, &normal);
        rows.iter_mut().for_each(|row| row.iter_mut().zip(&depth).for_each(|(torque, depth)| *torque *= depth));
        let column = scene.column(rows);
        if column.rows.is_empty() { Vec::new() } else { vec![Term::new(Keys::K, column, Sign::Positive)] }
    }

    /// The force at the largest depth must be within what the motors can bear.
    fn plausible(&self, scene: &WindowedData<'_>, place: &[usize], shape: &[f64], x: &[f64]) -> bool {
        let deepest = depths(scene.tool_positions(), &normal(scene, shape), distance(scene, shape))
            .into_iter()
            .fold(0.0, f64::max);
        ON_TOOL.plausible(scene, place, shape, &[x[0] * deepest])
    }

    fn named(&self, found: &Estimate<'_>) -> Vec<Named> {
        let of = |shape: &[f64]| {
            let n = normal(found.scene, shape);
            [n.x, n.y, n.z, distance(found.scene, shape)]
        };
        let values = of(found.shape);
        // Vary each number by its standard deviation: about the pivot they are independent.
        let moved = (0..found.shape.len()).filter_map(|k| {
            let mut shape = found.shape.to_vec();
            shape[k] += found.shape_std[k]?;
            Some(of(&shape))
        });
        let moved: Vec<[f64; 4]> = moved.collect();
        let std = |c: usize| {
            let sum: f64 = moved.iter().map(|other| (other[c] - values[c]).powi(2)).sum();
            (sum > 0.0).then(|| sum.sqrt())
        };
        let keys = [Keys::NX, Keys::NY, Keys::NZ, Keys::AT].into_iter().enumerate();
        found.all_terms().chain(keys.map(|(c, key)| Named::new(key, values[c], std(c)))).collect()
    }

    fn over(&self) -> Over {
        Over::Position
    }

    fn says(&self) -> &'static str {
        "a force pushes the tool out of a half-space, in proportion to the depth in it, as a compliant wall does"
    }

    fn shown_by(&self) -> &'static str {
        ON_TOOL.shown_by()
    }
}
