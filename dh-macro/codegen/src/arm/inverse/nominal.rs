//! Moves lines to the nominal geometry of a family, and adds joints to complete an arm to six.
//! Lines of an exact arm are not moved.

use super::lines::{Lines, Vector, add, beside, cross, dot, norm, scale, sub, unit};
use crate::ik::{Axis, Method, Regional};

/// An axis and the index of its joint; `None`: an added joint, fixed at zero.
pub(super) type Joint = (Axis, Option<u8>);
/// Axes, method, and description of the method.
pub(super) type Plan = (Vec<Joint>, Method, &'static str);

fn through(axis: Axis, point: Vector) -> Axis {
    Axis { c: point, ..axis }
}

fn towards(axis: Axis, direction: Vector) -> Axis {
    Axis { h: scale(if dot(axis.h, direction) < 0.0 { -1.0 } else { 1.0 }, unit(direction)), ..axis }
}

/// Axes of an arm whose shoulder, elbow and wrist are nearly nominal.
pub(super) fn swivel(a: [Axis; 7], shoulder: Vector, elbow: Vector, wrist: Vector) -> [Axis; 7] {
    let (upper, fore) = (sub(elbow, shoulder), sub(wrist, elbow));
    // Normal to both if they are not collinear; otherwise the previous direction, orthogonalised.
    let normal = if norm(cross(upper, fore)) > 0.1 * norm(upper) * norm(fore) {
        cross(upper, fore)
    } else {
        sub(a[3].h, scale(dot(a[3].h, upper) / dot(upper, upper), upper))
    };
    [
        through(a[0], shoulder),
        through(a[1], shoulder),
        towards(through(a[2], shoulder), upper),
        towards(through(a[3], elbow), normal),
        towards(through(a[4], wrist), fore),
        through(a[5], wrist),
        through(a[6], wrist),
    ]
}

/// A direction at another angle to `h` than `other`, so that an added joint is never collinear with
/// a real one.
fn oblique(h: Vector, other: Vector) -> Vector {
    let (x, _) = beside(h);
    let c = dot(h, other).abs();
    // At 45 degrees, unless the other is near that angle.
    if (c - 0.5f64.sqrt()).abs() < 0.3 { x } else { unit(add(h, x)) }
}

/// Arms with three joints and a spherical wrist, including added joints.
pub(super) fn wrist(lines: &Lines, order: &[Joint]) -> Vec<Plan> {
    let n = order.len();
    if n < 3 || order[3..].iter().any(|(a, _)| a.slides) {
        return Vec::new();
    }
    let axis = |k: usize| order[k].0;
    let (center, added): (Vector, Vec<Vector>) = match n {
        3 => {
            let h = axis(2).h;
            let (x, y) = beside(h);
            (add(axis(2).c, add(scale(0.4, x), scale(0.3, h))), vec![h, x, y])
        }
        4 => {
            let h = axis(3).h;
            let (x, y) = beside(h);
            (add(axis(3).c, scale(0.37, h)), vec![x, y])
        }
        5 => match lines.meet(&axis(3), &axis(4)) {
            Some(p) => (p, vec![oblique(axis(4).h, axis(3).h)]),
            None => return Vec::new(),
        },
        _ => match lines.meet_of(&axis(3), &axis(4), &axis(5)) {
            Some(p) => (p, Vec::new()),
            None => return Vec::new(),
        },
    };
    let mut axes: Vec<Joint> = order.to_vec();
    if !lines.is_exact() {
        for (a, _) in &mut axes[3..] {
            *a = through(*a, center);
        }
    }
    axes.extend(added.into_iter().map(|h| (Axis { slides: false, h, c: center }, None)));
    regionals(lines, &[axis(0), axis(1), axis(2)])
        .into_iter()
        .map(|(first, regional, why)| {
            let mut axes = axes.clone();
            for (k, a) in first.into_iter().enumerate() {
                axes[k].0 = a;
            }
            (axes, Method::Wrist { center, regional }, why)
        })
        .collect()
}

/// Decompositions of three joints.
fn regionals(lines: &Lines, a: &[Axis; 3]) -> Vec<([Axis; 3], Regional, &'static str)> {
    let kinds: String = a.iter().map(|a| if a.slides { 'P' } else { 'R' }).collect();
    let mut all = Vec::new();
    let mut push = |axes: [Axis; 3], regional: Regional, why: &'static str| all.push((axes, regional, why));
    let aligned = |i: usize, j: usize| {
        let mut axes = *a;
        if !lines.is_exact() {
            let sign = if dot(a[i].h, a[j].h) < 0.0 { -1.0 } else { 1.0 };
            let h = unit(add(a[i].h, scale(sign, a[j].h)));
            (axes[i].h, axes[j].h) = (h, scale(sign, h));
        }
        axes
    };
    let joined = |i: usize, j: usize, p: Vector| {
        let mut axes = *a;
        if !lines.is_exact() {
            (axes[i].c, axes[j].c) = (p, p);
        }
        axes
    };
    let (par12, par23) = (lines.parallel_axes(&a[0], &a[1]), lines.parallel_axes(&a[1], &a[2]));
    let (meet12, meet23) = (lines.meet(&a[0], &a[1]), lines.meet(&a[1], &a[2]));
    match kinds.as_str() {
        "RRR" => {
            if par23 {
                push(
                    aligned(1, 2),
                    Regional::Parallel { mirrored: true },
                    "the second and third of the other three are parallel",
                );
            }
            if par12 {
                push(aligned(0, 1), Regional::Parallel { mirrored: false }, "the first two of the others are parallel");
            }
            if let Some(at) = meet12 {
                push(joined(0, 1, at), Regional::Meet { mirrored: false, at }, "and so do the first two of the others");
            }
            if let Some(at) = meet23 {
                push(
                    joined(1, 2, at),
                    Regional::Meet { mirrored: true, at },
                    "and so do the second and third of the others",
                );
            }
            // A nominal arm with a quartic would be the arm itself.
            push(*a, Regional::General { mirrored: false }, "the other three lie anyhow");
            push(*a, Regional::General { mirrored: true }, "the other three lie anyhow");
        }
        "RRP" => {
            if par12 {
                push(
                    aligned(0, 1),
                    Regional::Parallel { mirrored: false },
                    "the third joint of the others slides, the first two are parallel",
                );
            }
            if let Some(at) = meet12 {
                push(
                    joined(0, 1, at),
                    Regional::Meet { mirrored: false, at },
                    "joint 3 of the others slides, the first two meet",
                );
            }
            push(*a, Regional::General { mirrored: false }, "the third joint of the others slides");
        }
        "PRR" => {
            if par23 {
                push(
                    aligned(1, 2),
                    Regional::Parallel { mirrored: true },
                    "the first joint of the others slides, the next two are parallel",
                );
            }
            if let Some(at) = meet23 {
                push(
                    joined(1, 2, at),
                    Regional::Meet { mirrored: true, at },
                    "the first joint of the others slides, the next two meet",
                );
            }
            push(*a, Regional::General { mirrored: true }, "the first joint of the others slides");
        }
        "RPR" => push(*a, Regional::TurnSlideTurn, "the middle joint of the others slides"),
        "RPP" => push(*a, Regional::TurnSlides { mirrored: false }, "the others turn once and slide twice"),
        "PPR" => push(*a, Regional::TurnSlides { mirrored: true }, "the others slide twice and turn once"),
        "PRP" => push(*a, Regional::SlideTurnSlide, "the others slide, turn and slide"),
        _ => push(*a, Regional::Slides, "the others slide"),
    }
    all
}

/// Arms with joints 2, 3 and 4 of six parallel; `front`: number of joints added before the first.
pub(super) fn three_parallel(lines: &Lines, order: &[Joint], front: usize) -> Option<Plan> {
    if order.iter().any(|(a, _)| a.slides) {
        return None;
    }
    let at = |k: usize| order.get((k + 1).checked_sub(front + 1)?).map(|j| j.0);
    let (two, three, four) = (at(1)?, at(2)?, at(3)?);
    if !lines.parallel_axes(&two, &three) || !lines.parallel_axes(&three, &four) {
        return None;
    }
    let sign = |a: &Axis| if dot(a.h, two.h) < 0.0 { -1.0 } else { 1.0 };
    let h = if lines.is_exact() {
        two.h
    } else {
        unit(add(two.h, add(scale(sign(&three), three.h), scale(sign(&four), four.h))))
    };
    let mut axes: Vec<Joint> = Vec::new();
    if front == 1 {
        let (x, y) = beside(h);
        axes.push((Axis { slides: false, h: x, c: add(two.c, add(scale(0.31, y), scale(0.23, h))) }, None));
    }
    axes.extend(order);
    for k in 1..4 {
        let s = sign(&axes[k].0);
        axes[k].0.h = scale(s, h);
    }
    if axes.len() == 4 {
        let (x, _) = beside(h);
        axes.push((Axis { slides: false, h: x, c: add(four.c, scale(0.29, h)) }, None));
    }
    if axes.len() == 5 {
        let five = axes[4].0;
        axes.push((Axis { slides: false, h: oblique(five.h, h), c: five.c }, None));
    }
    if axes.len() != 6 {
        return None;
    }
    let (five, six) = (axes[4].0, axes[5].0);
    let meet = if lines.parallel_axes(&five, &six) { None } else { lines.meet(&five, &six) };
    if let (false, Some(p)) = (lines.is_exact(), meet) {
        (axes[4].0.c, axes[5].0.c) = (p, p);
    }
    let why = match meet {
        Some(_) => "and the two at their end meet",
        None => "and the two at their end do not meet",
    };
    Some((axes, Method::ThreeParallel { meet }, why))
}
