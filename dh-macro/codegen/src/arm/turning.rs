//! Describes how a link turns if at most two directions of axes contribute, which needs fewer
//! operations than a general rotation.
//!
//! With one direction only the rate counts. With two perpendicular ones, `e` (of the inner joints)
//! and the link's own `z`, the angular velocity is `r e + s z`, and `e` turns with the link's angle
//! alone. So only moments along `e` and `z` are required. Lagrange's equations of these two angles
//! need fewer operations than Euler's equations of the body.

use super::chain::Link;
use crate::robot::JointKind;
use crate::sym::{Ex, Vec3};

/// Rotation about joints with parallel axes.
#[derive(Clone, Copy)]
pub(super) struct Spin<'g> {
    /// Unit vector along the axes, in the link's frame.
    pub axis: Vec3<'g>,
    /// Sum of the joint velocities, rad/s.
    pub rate: Ex<'g>,
    /// Sum of the joint accelerations, rad/s^2.
    pub acceleration: Ex<'g>,
    /// Row of the outermost of these joints.
    pub row: usize,
}

/// Directions about which a link turns.
#[derive(Clone, Copy)]
pub(super) enum Turning<'g> {
    Still,
    One(Spin<'g>),
    /// Two perpendicular directions, inner joints first.
    Two(Spin<'g>, Spin<'g>),
    Any,
}

/// `1` or `-1` if `v` is exactly along z or opposite to it.
fn along_z(v: Vec3<'_>) -> Option<f64> {
    let [x, y, z] = v.0;
    let sign = z.as_constant().filter(|c| c.abs() == 1.0)?;
    (x.is_zero() && y.is_zero()).then_some(sign)
}

impl<'g> Turning<'g> {
    /// Rotation of the next link outwards, from its row and the included parts of its velocity and
    /// acceleration.
    pub fn next(self, link: &Link<'g>, row: usize, dq: Ex<'g>, ddq: Ex<'g>) -> Self {
        let seen = |s: Spin<'g>| Spin { axis: link.inward(s.axis), ..s };
        let carried = match self {
            Self::One(s) => Self::One(seen(s)),
            Self::Two(first, second) => Self::Two(seen(first), seen(second)),
            other => other,
        };
        if link.kind != JointKind::Revolute {
            return carried;
        }
        let own = Spin { axis: link.axis(), rate: dq, acceleration: ddq, row };
        let with = |s: Spin<'g>, sign: f64| Spin {
            rate: s.rate * sign + dq,
            acceleration: s.acceleration * sign + ddq,
            ..own
        };
        match carried {
            Self::Still => Self::One(own),
            Self::One(s) => match along_z(s.axis) {
                Some(sign) => Self::One(with(s, sign)),
                None if s.axis.0[2].is_zero() => Self::Two(s, own),
                None => Self::Any,
            },
            Self::Two(first, second) => match along_z(second.axis) {
                Some(sign) => Self::Two(first, with(second, sign)),
                None => Self::Any,
            },
            Self::Any => Self::Any,
        }
    }

    /// The two directions, if the second is the link's own z.
    pub fn two(self) -> Option<(Spin<'g>, Spin<'g>)> {
        match self {
            Self::Two(first, second) if along_z(second.axis) == Some(1.0) => Some((first, second)),
            _ => None,
        }
    }
}

/// Moments along `first` and `own` (the link's z) due to a body's tensor about the origin, N m.
/// These are Lagrange's equations of `T = (e.I e) r^2 / 2 + (e.I z) r s + (z.I z) s^2 / 2` with
/// `de/ds = e x z`.
pub(super) fn moments<'g>(first: &Spin<'g>, own: &Spin<'g>, params: &[Ex<'g>; 10]) -> (Ex<'g>, Ex<'g>) {
    let [_, _, _, _, xx, yy, zz, xy, xz, yz] = *params;
    let [x, y, _] = first.axis.0;
    let (r, a, s, b) = (first.rate, first.acceleration, own.rate, own.acceleration);
    // e.I e = x k + YY and half its derivative y k - XY, because x^2 + y^2 = 1.
    let k = (xx - yy) * x + (xy + xy) * y;
    let half = y * k - xy;
    let across = xz * x + yz * y;
    let turned = xz * y - yz * x;
    let along_first = k * (x * a) + yy * a + (half + half) * (r * s) + (across * b + turned * (s * s));
    let along_own = zz * b + across * a - half * (r * r);
    (along_first, along_own)
}
