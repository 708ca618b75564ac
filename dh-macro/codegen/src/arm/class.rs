//! The kinematic class, from the exact geometry: which closed-form inverse an arm has, and why.

use super::chain::{Chain, Row};
use crate::robot::JointKind;

/// A class with its reason.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Class {
    /// Joint letters, base to tip: `RRPRRR`.
    pub joints: String,
    /// Short name, `none` where no closed form is known.
    pub name: &'static str,
    /// What in the table makes it so.
    pub reason: String,
}

/// Two neighbouring axes: how the second lies to the first.
fn parallel(row: &Row) -> bool {
    row.alpha.0 == 0.0
}

/// Three axes `first, first + 1, first + 2` that meet in one point and are not parallel.
fn spherical(rows: &[Row], first: usize) -> bool {
    let Some([a, b, c]) = rows.get(first..first + 3) else { return false };
    let turning = [a, b, c].iter().all(|r| r.kind == JointKind::Revolute);
    turning && b.d == 0.0 && c.d == 0.0 && b.r == 0.0 && !parallel(b) && !parallel(c)
}

/// Axes `first` to `last` all parallel.
fn all_parallel(rows: &[Row], first: usize, last: usize) -> bool {
    rows[first + 1..=last].iter().all(parallel)
}

/// Recognises the class of a chain.
pub fn classify(chain: &Chain) -> Class {
    let joints: String = chain
        .rows
        .iter()
        .map(|r| match r.kind {
            JointKind::Revolute => 'R',
            JointKind::Prismatic => 'P',
            JointKind::Fixed => 'F',
        })
        .collect();
    // Fixed rows at the tip do not matter; one in between makes the neighbours' relation more than one row of the table.
    let moving = joints.trim_end_matches('F').len();
    let rows = &chain.rows[..moving];
    let class = |name: &'static str, reason: &str| Class { joints: joints.clone(), name, reason: reason.to_string() };
    if rows.iter().any(|r| r.kind == JointKind::Fixed) {
        return class("none", "a fixed row stands between moving ones");
    }
    let kinds = &joints[..moving];
    match kinds {
        "RRRRRRR"
            if spherical(rows, 0) && spherical(rows, 4) && rows[3].d == 0.0 && rows[4].d == 0.0 && rows[3].r == 0.0 =>
        {
            class("srs", "axes 1-3 meet in a shoulder, 5-7 in a wrist, and axis 4 meets both upper and lower arm")
        }
        "RRRRRRR" if spherical(rows, 0) && rows[5].d == 0.0 => {
            class("7r-offset", "axes 1-3 meet in a shoulder; elbow or wrist have offsets, so one joint is given")
        }
        "RRRRRR" if spherical(rows, 3) => class("6r-spherical-wrist", "axes 4-6 meet in one point"),
        "RRRRRR" if all_parallel(rows, 1, 3) => class("6r-three-parallel", "axes 2-4 are parallel"),
        "RRPRRR" if spherical(rows, 3) => class("stanford", "axes 4-6 meet in one point, joint 3 slides"),
        "RRRP" | "RRPR" | "PRRR" if all_parallel(rows, 0, moving - 1) => {
            class("scara", "all axes are parallel, one joint slides")
        }
        k if k.chars().all(|c| c == 'R') && moving <= 3 && moving > 0 && all_parallel(rows, 0, moving - 1) => {
            class("planar", "all axes are parallel")
        }
        _ => class("none", "neither a spherical wrist or shoulder nor three parallel axes was found in the table"),
    }
}
