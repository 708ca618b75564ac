//! A joint as what it does to space: a turn about a line or a slide along it (product of
//! exponentials; Brockett 1984, Lynch and Park, 4.1). Tool, offsets and the convention of the table
//! are all in the lines.

use super::pose::Displacement;
use super::vector::{IDENTITY, Turn, Vector, add, scale, sub};

/// The line of a joint when all `q` are zero, in world axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Axis {
    /// Does the joint slide?
    pub slides: bool,
    /// Unit vector along the line.
    pub h: Vector,
    /// A point of the line, m.
    pub c: Vector,
}

/// Position of a joint: the turn of a revolute one, the way of a prismatic one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Value {
    pub turn: Turn,
    /// m.
    pub way: f64,
}

impl Value {
    pub const ZERO: Self = Self { turn: Turn::NONE, way: 0.0 };

    #[inline(always)]
    pub fn turn(turn: Turn) -> Self {
        Self { turn, way: 0.0 }
    }

    #[inline(always)]
    pub fn way(way: f64) -> Self {
        Self { turn: Turn::NONE, way }
    }

    #[inline(always)]
    pub fn back(self) -> Self {
        Self { turn: self.turn.back(), way: -self.way }
    }
}

/// Both turns.
#[inline(always)]
pub(super) fn turns([a, b]: [Turn; 2]) -> [Value; 2] {
    [Value::turn(a), Value::turn(b)]
}

impl Axis {
    /// A direction turned about the axis: with few products where that is a base axis.
    #[inline(always)]
    pub(super) fn spun(&self, Turn { c, s }: Turn, [x, y, z]: Vector) -> Vector {
        let h = self.h;
        if h[2].abs() == 1.0 {
            let s = s * h[2];
            [c * x - s * y, s * x + c * y, z]
        } else if h[1].abs() == 1.0 {
            let s = s * h[1];
            [c * x + s * z, y, c * z - s * x]
        } else if h[0].abs() == 1.0 {
            let s = s * h[0];
            [x, c * y - s * z, s * y + c * z]
        } else {
            Turn { c, s }.about(h, [x, y, z])
        }
    }

    /// Image of a point under the joint.
    #[inline(always)]
    pub(super) fn point(&self, v: Value, x: Vector) -> Vector {
        if self.slides { add(x, scale(v.way, self.h)) } else { add(self.c, self.spun(v.turn, sub(x, self.c))) }
    }

    /// Image of a direction.
    #[inline(always)]
    pub(super) fn direction(&self, v: Value, x: Vector) -> Vector {
        if self.slides { x } else { self.spun(v.turn, x) }
    }

    /// The whole displacement.
    #[inline]
    pub(super) fn displacement(&self, v: Value) -> Displacement {
        // Columns of the rotation are the images of the base vectors.
        let [x, y, z] = IDENTITY;
        let columns = [self.direction(v, x), self.direction(v, y), self.direction(v, z)];
        Displacement { rotation: super::vector::transposed(&columns), shift: self.point(v, [0.0; 3]) }
    }

    /// The same joint carried along by a displacement.
    #[inline]
    pub(super) fn carried(&self, by: &Displacement) -> Self {
        Self { slides: self.slides, h: super::vector::times(&by.rotation, self.h), c: by.point(self.c) }
    }

    /// The joint that undoes it.
    #[inline(always)]
    pub(super) fn reversed(&self) -> Self {
        Self { h: scale(-1.0, self.h), ..*self }
    }
}
