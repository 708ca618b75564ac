//! The wall, its two axes, and how a roller stands on it.

use super::vector::{Vector, add, cross, dot, norm, scale};

/// A rectangle to be painted. A point of its plane has two coordinates, `[y, z]`: along
/// [`Surface::across`] and [`Surface::up`], counted from the origin of the world frame. For the
/// paper's wall they are y and z of the world frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Surface {
    /// Middle of the rectangle, world axes, m.
    pub center: [f64; 3],
    /// Unit normal, out of the wall, world axes.
    pub normal: [f64; 3],
    /// Unit vector of the strokes, in the plane: "up".
    pub up: [f64; 3],
    /// Extent across the strokes, m.
    pub width: f64,
    /// Extent along them, m.
    pub height: f64,
}

/// Reason why numbers describe no wall.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SurfaceError {
    /// Place or directions are not finite, or too large.
    #[error("the wall's place and directions must be finite numbers, at most 1000")]
    Numbers,
    /// An extent is out of range.
    #[error("the wall's {name} is {size} m; from 0.001 to 100 m")]
    Size {
        /// `width` or `height`.
        name: &'static str,
        /// Its value, m.
        size: f64,
    },
    /// The normal is zero.
    #[error("the wall's normal is zero")]
    Normal,
    /// The upward direction is along the normal.
    #[error("the wall's up is along its normal; name a direction in the plane of the wall")]
    Up,
}

impl Surface {
    /// From any normal and any vector that is not along it (its part in the plane counts as up).
    ///
    /// # Errors
    /// Says which number can't be.
    pub fn new(
        center: [f64; 3],
        normal: [f64; 3],
        up: [f64; 3],
        width: f64,
        height: f64,
    ) -> Result<Self, SurfaceError> {
        if center.iter().chain(&normal).chain(&up).any(|x| x.is_nan() || x.abs() > 1e3) {
            return Err(SurfaceError::Numbers);
        }
        for (name, size) in [("width", width), ("height", height)] {
            if !(1e-3..=100.0).contains(&size) {
                return Err(SurfaceError::Size { name, size });
            }
        }
        let length = norm(normal);
        if length < 1e-9 {
            return Err(SurfaceError::Normal);
        }
        let normal = scale(1.0 / length, normal);
        let along = add(up, scale(-dot(up, normal), normal));
        let rest = norm(along);
        if rest < 1e-6 * norm(up).max(1e-300) || rest < 1e-9 {
            return Err(SurfaceError::Up);
        }
        Ok(Self { center, normal, up: scale(1.0 / rest, along), width, height })
    }

    /// The unit vector across the strokes: up x normal.
    pub fn across(&self) -> [f64; 3] {
        cross(self.up, self.normal)
    }

    /// Coordinates of the middle, m.
    pub fn middle(&self) -> [f64; 2] {
        [dot(self.across(), self.center), dot(self.up, self.center)]
    }

    /// Least and largest coordinate across, m.
    pub fn sides(&self) -> [f64; 2] {
        let y = self.middle()[0];
        [y - 0.5 * self.width, y + 0.5 * self.width]
    }

    /// Least and largest coordinate along, m.
    pub fn ends(&self) -> [f64; 2] {
        let z = self.middle()[1];
        [z - 0.5 * self.height, z + 0.5 * self.height]
    }

    /// The point at two coordinates and at a distance from the plane, in world axes, m.
    pub fn point(&self, [y, z, off]: [f64; 3]) -> [f64; 3] {
        let plane = dot(self.normal, self.center) + off;
        add(add(scale(y, self.across()), scale(z, self.up)), scale(plane, self.normal))
    }

    /// A direction with these three parts, in world axes.
    pub fn direction(&self, [y, z, off]: [f64; 3]) -> [f64; 3] {
        add(add(scale(y, self.across()), scale(z, self.up)), scale(off, self.normal))
    }
}

/// The paint roller: its axis is along x of the tool frame, and its line of contact lies `length`
/// along z of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Roller {
    /// From the origin of the tool frame to what touches the wall, m.
    pub length: f64,
    /// Along its axis, m: `w_L` of equation (12).
    pub width: f64,
    /// Does its axis (x of the tool) point against [`Surface::across`]? It paints the same either
    /// way; the arm's posture differs.
    pub turned: bool,
}

impl Roller {
    /// The tool frame with the middle of the roller's face at a point (wall coordinates and
    /// distance), held perpendicular to the wall. It is given as the top three rows of the
    /// homogeneous matrix in world axes, m.
    pub fn pose(&self, surface: &Surface, at: [f64; 3]) -> [[f64; 4]; 3] {
        let z = scale(-1.0, surface.normal);
        let x = if self.turned { scale(-1.0, surface.across()) } else { surface.across() };
        let y: Vector = cross(z, x);
        let origin = add(surface.point(at), scale(self.length, surface.normal));
        std::array::from_fn(|i| [x[i], y[i], z[i], origin[i]])
    }
}
