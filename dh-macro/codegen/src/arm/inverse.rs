//! Selects the inverse kinematics of an arm from the lines of its joint axes. It is exact if the
//! axes meet or are parallel, otherwise that of a nearby nominal arm, or by elimination.
//!
//! Lines are compared instead of table entries, because the same arm has different tables.
//! Calibrated parallel axes have their common normal hundreds of metres away, and a fixed row in
//! between hides that two axes meet.

use super::chain::Chain;
use crate::ik::{Arm, Axis, Displacement, Family, Method, Plane, Query, Reference, Regional, Six, Swivel};
use crate::robot::JointKind;

use lines::{Lines, Vector};

mod general;
mod lines;
mod nominal;

/// Class, reason, and constants of the solver.
#[derive(Debug, Clone, PartialEq)]
pub struct Inverse {
    /// Joint types as letters, base to tip: `RRPRRR`.
    pub joints: String,
    /// Short name; `none` if no closed form is known.
    pub class: &'static str,
    /// Geometric reason for the choice.
    pub reason: String,
    /// Lines of the moving joints, at `q = 0`.
    pub axes: Vec<Axis>,
    /// Last DH frame at `q = 0`.
    pub home: Displacement,
    /// Whether the solver is that of the arm itself. Otherwise it is that of a nearby nominal arm,
    /// or there is none ([`Family::Numerical`]).
    pub exact: bool,
    /// Family of the solver, with its constants.
    pub family: Family,
}

/// Result of one submodule.
pub(super) struct Found {
    class: &'static str,
    reason: String,
    family: Family,
}

impl Inverse {
    /// Inverse of a chain.
    pub fn new(chain: &Chain) -> Self {
        let joints = letters(chain);
        let (axes, home) = at_zero(chain);
        let inverse = |found: Found, exact: bool| Self::of(&joints, &axes, home, found, exact);
        for lines in [Lines::exact(&axes), Lines::loose(&axes, home.shift)] {
            for found in candidates(&lines) {
                let exact = lines.is_exact();
                let made = inverse(found, exact);
                if made.works() {
                    return if exact { made } else { made.near() };
                }
            }
        }
        if let Some(made) = Self::by_elimination(chain) {
            return made;
        }
        let why = match axes.len() {
            0..=6 => "neither a spherical wrist or shoulder nor three parallel axes were found, exactly or nearly",
            7 => {
                "neither shoulder, elbow and wrist of a swivel arm nor six joints with a closed form beside a locked one were found"
            }
            _ => "an arm with more than seven joints has no closed form here",
        };
        let reason = format!("{why}; the numerical solver is used");
        inverse(Found { class: "none", reason, family: Family::Numerical }, false)
    }

    /// Inverse of a chain of six joints, or seven of which one is given, as if no two axes met or
    /// were parallel. `None` if no choice of the hidden joint finds the test postures.
    pub fn by_elimination(chain: &Chain) -> Option<Self> {
        let (joints, (axes, home)) = (letters(chain), at_zero(chain));
        let made = |found: Found| Self::of(&joints, &axes, home, found, true);
        general::candidates(&axes).into_iter().map(made).find(Self::works)
    }

    fn of(joints: &str, axes: &[Axis], home: Displacement, found: Found, exact: bool) -> Self {
        let Found { class, reason, family } = found;
        Self { joints: joints.into(), class, reason, axes: axes.to_vec(), home, exact, family }
    }

    /// Whether a query must specify a redundancy: a swivel angle, or the position of a locked
    /// joint.
    pub fn is_redundant(&self) -> bool {
        matches!(self.family, Family::Swivel(_)) || self.family.locked().is_some()
    }

    fn near(mut self) -> Self {
        self.reason =
            format!("nearly: {}; closed form of that nominal arm, each branch refined by Newton's steps", self.reason);
        self
    }

    /// Solver for an arm with `N` joints; `None` if it has another number.
    pub fn arm<const N: usize>(&self, limits: &[Option<[f64; 2]>]) -> Option<Arm<N>> {
        let axes = self.axes.as_slice().try_into().ok()?;
        let limits = limits.try_into().ok()?;
        Some(Arm { axes, home: self.home, limits, exact: self.exact, family: self.family })
    }

    /// Whether it finds the test postures: a check by trial that no geometric case was overlooked.
    fn works(&self) -> bool {
        match self.axes.len() {
            1 => self.tried::<1>(),
            2 => self.tried::<2>(),
            3 => self.tried::<3>(),
            4 => self.tried::<4>(),
            5 => self.tried::<5>(),
            6 => self.tried::<6>(),
            7 => self.tried::<7>(),
            _ => false,
        }
    }

    fn tried<const N: usize>(&self) -> bool {
        const TRIALS: usize = 40;
        let Some(arm) = self.arm::<N>(&[None; N]) else { return false };
        let mut state = 7u64;
        let mut missed = 0;
        for _ in 0..TRIALS {
            let q: [f64; N] = core::array::from_fn(|i| {
                state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                let unit = (state >> 11) as f64 / (1u64 << 53) as f64 * 2.0 - 1.0;
                unit * if arm.axes[i].slides { 0.7 } else { 3.1 }
            });
            let redundancy = arm.redundancy(&q, &Reference::UP);
            let solutions = arm.solve(&arm.forward(&q), &Query { redundancy, ..Query::default() });
            let close = |s: &[f64; N]| {
                (0..N).all(|i| {
                    let d = s[i] - q[i];
                    let d = if arm.axes[i].slides {
                        d
                    } else {
                        d - (d / core::f64::consts::TAU).round() * core::f64::consts::TAU
                    };
                    d.abs() < 1e-5
                })
            };
            missed += usize::from(!solutions.is_ok_and(|s| s.as_slice().iter().any(|s| close(&s.q))));
        }
        missed * if self.exact { 40 } else { 5 } <= TRIALS
    }
}

/// Letters of the joint types, base to tip.
fn letters(chain: &Chain) -> String {
    let letter = |kind: JointKind| match kind {
        JointKind::Revolute => 'R',
        JointKind::Prismatic => 'P',
        JointKind::Fixed => 'F',
    };
    chain.rows.iter().map(|row| letter(row.kind)).collect()
}

/// Lines of the joints and the last frame, with all `q` zero.
fn at_zero(chain: &Chain) -> (Vec<Axis>, Displacement) {
    let about_x = |(s, c): (f64, f64), d: f64| Displacement {
        rotation: [[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]],
        shift: [d, 0.0, 0.0],
    };
    let at_world = Displacement::NONE;
    let mut here = chain.base.map_or(at_world, |(rotation, shift)| Displacement { rotation, shift });
    let mut axes = Vec::new();
    for row in &chain.rows {
        let (s, c) = row.angle.sin_cos();
        let (s, c) = match row.quarter_turns.rem_euclid(4) {
            0 => (s, c),
            1 => (c, -s),
            2 => (-s, -c),
            _ => (-c, s),
        };
        let turned = Displacement { rotation: [[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]], shift: [0.0, 0.0, row.r] };
        here = here.after(&about_x(row.alpha, row.d)).after(&turned);
        if row.dof.is_some() {
            let h = here.rotation.map(|r| r[2]);
            axes.push(Axis { slides: row.kind == JointKind::Prismatic, h, c: here.shift });
        }
    }
    if let Some((d, twist)) = chain.rows.last().and_then(|r| r.body) {
        here = here.after(&about_x(twist, d));
    }
    (axes, here)
}

/// All possible decompositions of the arm, the best first.
fn candidates(lines: &Lines) -> Vec<Found> {
    let n = lines.axes.len();
    let mut all = Vec::new();
    all.extend(plane(lines));
    if (1..=6).contains(&n) {
        all.extend(six(lines, None));
    }
    if n == 7 {
        all.extend(swivel(lines));
        for joint in [6usize, 0] {
            all.extend(six(lines, Some(joint)));
        }
    }
    all
}

/// Arms with all revolute axes parallel, or without a revolute axis.
fn plane(lines: &Lines) -> Option<Found> {
    let axes = &lines.axes;
    if axes.iter().all(|a| a.slides) {
        return (axes.len() <= 3).then(|| Found {
            class: "cartesian",
            reason: "all joints slide: the pose is linear in them".into(),
            family: Family::Slides,
        });
    }
    let first = (0..axes.len()).find(|&k| !axes[k].slides)?;
    let h = axes[first].h;
    if axes.len() > 4 || !(0..axes.len()).all(|k| axes[k].slides || lines.parallel(first, k)) {
        return None;
    }
    let mut three = Vec::new();
    let mut lift = None;
    for (k, axis) in axes.iter().enumerate() {
        if axis.slides && lines::dot(axis.h, h).abs() > lines.angle {
            if lift.is_some() {
                return None;
            }
            lift = Some((*axis, k as u8, three.len() as u8));
        } else {
            // Made exactly parallel; the joint keeps its own sense of rotation.
            let sign = if lines::dot(axis.h, h) < 0.0 { -1.0 } else { 1.0 };
            let axis = if axis.slides || lines.is_exact() { *axis } else { Axis { h: h.map(|x| sign * x), ..*axis } };
            three.push((axis, Some(k as u8)));
        }
    }
    let m = three.len();
    if m > 3 {
        return None;
    }
    let (x, y) = lines::beside(h);
    while three.len() < 3 {
        // Offset in another direction each time, so that no joint coincides with the next.
        let last = three.last().map_or(axes[first].c, |t| t.0.c);
        let aside = if three.len() == 1 { x } else { lines::add(x, y) };
        three.push((Axis { slides: false, h, c: lines::add(last, aside.map(|a| 0.5 * a)) }, None));
    }
    let family = Family::Plane(Plane {
        h,
        axes: core::array::from_fn(|k| three[k].0),
        joints: core::array::from_fn(|k| three[k].1),
        lift,
    });
    Some(match lift {
        Some(_) => Found {
            class: "scara",
            reason: "all turning axes are parallel, one joint slides along or across them".into(),
            family,
        },
        None => Found {
            class: "planar",
            reason: "all turning axes are parallel, everything moves in one plane".into(),
            family,
        },
    })
}

/// Arms with spherical shoulder, elbow, and spherical wrist.
fn swivel(lines: &Lines) -> Option<Found> {
    if lines.axes.iter().any(|a| a.slides) {
        return None;
    }
    let (shoulder, wrist) = (lines.meet3(0)?, lines.meet3(4)?);
    let elbow = lines.meet3(2)?;
    let (upper, fore) = (lines::sub(elbow, shoulder), lines::sub(wrist, elbow));
    let size = lines.size;
    let square = |v: Vector| {
        let n = lines::norm(v);
        n > 1e-3 * size && (lines::dot(v, lines.axes[3].h) / n).abs() <= lines.angle.max(lines.length / n)
    };
    if !square(upper) || !square(fore) {
        return None;
    }
    let axes: [Axis; 7] = lines.axes.as_slice().try_into().ok()?;
    let axes = if lines.is_exact() { axes } else { nominal::swivel(axes, shoulder, elbow, wrist) };
    Some(Found {
        class: "srs",
        reason:
            "axes 1-3 meet in a shoulder, 5-7 in a wrist, and axis 4 meets both upper and lower arm: by swivel angle"
                .into(),
        family: Family::Swivel(Swivel { axes, shoulder, elbow, wrist }),
    })
}

/// Arms with six joints or fewer, or seven with one of them locked.
fn six(lines: &Lines, locked: Option<usize>) -> Vec<Found> {
    let mut found = Vec::new();
    let real: Vec<(Axis, Option<u8>)> =
        (0..lines.axes.len()).filter(|&k| Some(k) != locked).map(|k| (lines.axes[k], Some(k as u8))).collect();
    for reversed in [false, true] {
        let order: Vec<(Axis, Option<u8>)> =
            if reversed { real.iter().rev().map(|(a, j)| (lines::reversed(a), *j)).collect() } else { real.clone() };
        let spare = 6 - order.len();
        let plans = nominal::wrist(lines, &order)
            .into_iter()
            .chain((0..=spare.min(1)).filter_map(|front| nominal::three_parallel(lines, &order, front)));
        for (axes, method, why) in plans {
            let six = Six {
                axes: core::array::from_fn(|k| axes[k].0),
                joints: core::array::from_fn(|k| axes[k].1),
                reversed,
                method,
            };
            found.push(named(lines, six, why, locked));
        }
    }
    found
}

fn named(lines: &Lines, six: Six, why: &str, locked: Option<usize>) -> Found {
    let n = lines.axes.len();
    let slides = lines.axes.iter().any(|a| a.slides);
    let kinds: String = lines.axes.iter().map(|a| if a.slides { 'P' } else { 'R' }).collect();
    let quartic = matches!(
        six.method,
        Method::Wrist { regional: Regional::General { .. } | Regional::TurnSlideTurn, .. }
            | Method::ThreeParallel { meet: None }
    );
    let class = match (n, &six.method) {
        (7, _) => "7r-offset",
        (6, Method::ThreeParallel { .. }) => "6r-three-parallel",
        (6, Method::Wrist { .. }) if kinds == "RRPRRR" => "stanford",
        (6, Method::Wrist { .. }) if slides => "6-spherical-wrist",
        (6, Method::Wrist { .. }) => "6r-spherical-wrist",
        (5, _) => "5-axis",
        (4, _) => "4-axis",
        _ => "3-axis",
    };
    let joint = |k: usize| six.joints[k].map_or("an added one".to_string(), |j| (j + 1).to_string());
    let mut reason = match six.method {
        Method::Wrist { .. } if n >= 6 => {
            let (a, b) = (joint(3), joint(5));
            let (low, high) = if six.reversed { (b, a) } else { (a, b) };
            format!("axes {low}-{high} meet in one point, {why}")
        }
        Method::Wrist { .. } => why.to_string(),
        Method::ThreeParallel { .. } => {
            let (a, b) = (joint(1), joint(3));
            let (low, high) = if six.reversed { (b, a) } else { (a, b) };
            format!("axes {low}-{high} are parallel, {why}")
        }
    };
    if let Some(joint) = locked {
        reason += &format!("; joint {} is the redundancy", joint + 1);
    }
    if quartic {
        reason += ": a quartic";
    }
    let family = match locked {
        Some(joint) => Family::Locked { joint: joint as u8, six },
        None => Family::Six(six),
    };
    Found { class, reason, family }
}
