//! The wall, its two axes, and the pose of a roller on it.

use super::vector::{Vector, add, cross, dot, norm, scale};

/// A rectangle to be painted. A point of its plane has two coordinates, `[y, z]`: along
/// [`Surface::across`] and [`Surface::up`], from the origin of the world frame. For the paper's
/// wall they are y and z of the world frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Surface {
    /// Centre of the rectangle, world axes, m.
    pub center: [f64; 3],
    /// Unit normal, out of the wall, world axes.
    pub normal: [f64; 3],
    /// Unit vector of the strokes, in the plane: "up".
    pub up: [f64; 3],
    /// Extent across the strokes, m.
    pub width: f64,
    /// Extent along the strokes, m.
    pub height: f64,
}

/// Reason why values do not define a wall.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SurfaceError {
    /// Position or directions are not finite, or too large.
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
    /// Creates a wall from any normal and any vector not along it (its part in the plane is taken
    /// as up).
    ///
    /// # Errors
    /// Returns which value is invalid.
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

    /// Unit vector across the strokes: up x normal.
    pub fn across(&self) -> [f64; 3] {
        cross(self.up, self.normal)
    }

    /// Wall coordinates of the centre, m.
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

    /// World coordinates, m, of the point with two wall coordinates and a distance from the plane,
    /// m.
    pub fn point(&self, [y, z, off]: [f64; 3]) -> [f64; 3] {
        let plane = dot(self.normal, self.center) + off;
        add(add(scale(y, self.across()), scale(z, self.up)), scale(plane, self.normal))
    }

    /// Direction in world axes with these three components.
    pub fn direction(&self, [y, z, off]: [f64; 3]) -> [f64; 3] {
        add(add(scale(y, self.across()), scale(z, self.up)), scale(off, self.normal))
    }
}

/// The paint roller: its axis is x of the tool frame, and its line of contact lies at `length`
/// along z of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Roller {
    /// Distance from the origin of the tool frame to the line of contact, m.
    pub length: f64,
    /// Width along its axis, m: `w_L` of equation (12).
    pub width: f64,
    /// Whether its axis (x of the tool) points against [`Surface::across`]. It paints the same
    /// either way; the arm's posture differs.
    pub turned: bool,
}

impl Roller {
    /// Pose of the tool frame with the middle of the roller's face at a point (wall coordinates and
    /// distance, m), held perpendicular to the wall. Returns the top three rows of the homogeneous
    /// matrix in world axes, m.
    pub fn pose(&self, surface: &Surface, at: [f64; 3]) -> [[f64; 4]; 3] {
        let z = scale(-1.0, surface.normal);
        let x = if self.turned { scale(-1.0, surface.across()) } else { surface.across() };
        let y: Vector = cross(z, x);
        let origin = add(surface.point(at), scale(self.length, surface.normal));
        std::array::from_fn(|i| [x[i], y[i], z[i], origin[i]])
    }
}
