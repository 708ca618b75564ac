//! Lines in space, with tolerances for parallel and intersecting ones.

use crate::ik::Axis;

pub(super) type Vector = [f64; 3];

pub(super) fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) fn add(a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|i| a[i] + b[i])
}

pub(super) fn sub(a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|i| a[i] - b[i])
}

pub(super) fn scale(k: f64, a: Vector) -> Vector {
    a.map(|x| k * x)
}

pub(super) fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(super) fn norm(a: Vector) -> f64 {
    dot(a, a).sqrt()
}

pub(super) fn unit(a: Vector) -> Vector {
    scale(1.0 / norm(a), a)
}

/// Two unit vectors perpendicular to a unit vector.
pub(super) fn beside(h: Vector) -> (Vector, Vector) {
    let k = (0..3).fold(0, |b, k| if h[k].abs() < h[b].abs() { k } else { b });
    let mut e = [0.0; 3];
    e[k] = 1.0;
    let x = unit(sub(e, scale(dot(e, h), h)));
    (x, cross(h, x))
}

pub(super) fn reversed(a: &Axis) -> Axis {
    Axis { h: scale(-1.0, a.h), ..*a }
}

/// Lines of an arm, with tolerances.
pub(super) struct Lines {
    pub axes: Vec<Axis>,
    /// Tolerance of an angle (its sine), rad.
    pub angle: f64,
    /// Tolerance of a length, m.
    pub length: f64,
    /// Size of the arm, m.
    pub size: f64,
    exact: bool,
}

impl Lines {
    /// Lines with tolerances for rounding only.
    pub fn exact(axes: &[Axis]) -> Self {
        Self { axes: axes.to_vec(), angle: 1e-11, length: 1e-11, size: size(axes, [0.0; 3]), exact: true }
    }

    /// Lines with tolerances of 1.2 degrees and three hundredths of the arm's size, which cover
    /// assembly errors and small offsets of built arms.
    pub fn loose(axes: &[Axis], tip: Vector) -> Self {
        // Points of the lines near the arm: in a calibrated table they may be far away.
        let middle = scale(0.5, tip);
        let near: Vec<Axis> =
            axes.iter().map(|a| Axis { c: add(a.c, scale(dot(a.h, sub(middle, a.c)), a.h)), ..*a }).collect();
        let size = size(&near, tip);
        Self { axes: near, angle: 0.02, length: 0.03 * size, size, exact: false }
    }

    pub fn is_exact(&self) -> bool {
        self.exact
    }

    pub fn parallel(&self, i: usize, j: usize) -> bool {
        self.parallel_axes(&self.axes[i], &self.axes[j])
    }

    pub fn parallel_axes(&self, a: &Axis, b: &Axis) -> bool {
        norm(cross(a.h, b.h)) <= self.angle
    }

    /// Point between two lines that are not parallel, if they are near enough to each other.
    pub fn meet(&self, a: &Axis, b: &Axis) -> Option<Vector> {
        if a.slides || b.slides {
            return None;
        }
        let n = cross(a.h, b.h);
        let n2 = dot(n, n);
        if n2.sqrt() <= 0.1f64.max(self.angle) {
            return None;
        }
        let d = sub(b.c, a.c);
        if (dot(d, n) / n2.sqrt()).abs() > self.length {
            return None;
        }
        let s = dot(cross(d, b.h), n) / n2;
        let t = dot(cross(d, a.h), n) / n2;
        let (p, q) = (add(a.c, scale(s, a.h)), add(b.c, scale(t, b.h)));
        Some(if self.exact { p } else { scale(0.5, add(p, q)) })
    }

    /// Intersection of three neighbouring lines.
    pub fn meet_of(&self, a: &Axis, b: &Axis, c: &Axis) -> Option<Vector> {
        let (p, q) = (self.meet(a, b)?, self.meet(b, c)?);
        let gap = norm(sub(p, q));
        // Rounding errors grow if lines meet at a small angle.
        (gap <= self.length.max(1e-10 * self.size)).then(|| if self.exact { p } else { scale(0.5, add(p, q)) })
    }

    pub fn meet3(&self, first: usize) -> Option<Vector> {
        let [a, b, c] = self.axes.get(first..first + 3)? else { return None };
        self.meet_of(a, b, c)
    }
}

fn size(axes: &[Axis], tip: Vector) -> f64 {
    axes.iter().map(|a| norm(sub(a.c, axes[0].c))).fold(norm(sub(tip, axes[0].c)), f64::max).max(1e-3)
}
