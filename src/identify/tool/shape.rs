//! Ten inertial parameters of homogeneous solids, and their assembly to tools.
//!
//! Moments of the elementary solids are in any handbook, such as D. T. Greenwood, *Principles of
//! Dynamics*, appendix; Steiner's theorem is [`Inertia::moved`].

use dh_codegen::robot::Inertia;

/// Symmetry axis of a solid.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Axis {
    /// x
    X,
    /// y
    Y,
    /// z
    Z,
}

impl Axis {
    /// Moments `[along, across, across]` in the order x, y, z.
    fn place(self, along: f64, across: f64) -> [f64; 3] {
        match self {
            Self::X => [along, across, across],
            Self::Y => [across, along, across],
            Self::Z => [across, across, along],
        }
    }
}

/// Bodies rigidly connected to each other.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Assembly {
    /// Inertia of all bodies, in the tool frame, about its origin.
    pub inertia: Inertia,
}

impl Assembly {
    /// Empty assembly.
    pub fn new() -> Self {
        Self::default()
    }

    fn at(mut self, mass: f64, moments: [f64; 3], center: [f64; 3]) -> Self {
        let identity = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let [xx, yy, zz] = moments;
        let body = Inertia { m: mass, ms: [0.0; 3], i: [xx, yy, zz, 0.0, 0.0, 0.0] };
        self.inertia = self.inertia.plus(&body.moved(&identity, &center));
        self
    }

    /// Adds a tube (a full cylinder for `inner` 0) of this mass, kg, outer and inner radius and
    /// length, m, centred at `center`, m.
    pub fn tube(self, mass: f64, [outer, inner]: [f64; 2], length: f64, axis: Axis, center: [f64; 3]) -> Self {
        let squares = outer * outer + inner * inner;
        let moments = axis.place(mass * squares / 2.0, mass * (squares / 4.0 + length * length / 12.0));
        self.at(mass, moments, center)
    }

    /// Adds a cuboid of this mass, kg, and size, m, centred at `center`, m.
    pub fn cuboid(self, mass: f64, [x, y, z]: [f64; 3], center: [f64; 3]) -> Self {
        let twelfth = |a: f64, b: f64| mass * (a * a + b * b) / 12.0;
        self.at(mass, [twelfth(y, z), twelfth(x, z), twelfth(x, y)], center)
    }

    /// Adds a ball of this mass, kg, and radius, m, centred at `center`, m.
    pub fn ball(self, mass: f64, radius: f64, center: [f64; 3]) -> Self {
        self.at(mass, [0.4 * mass * radius * radius; 3], center)
    }

    /// Adds a round wire of mass `per_metre`, kg/m, and this radius, m, along axis-parallel
    /// segments between points, m.
    pub fn wire(self, per_metre: f64, radius: f64, points: &[[f64; 3]]) -> Self {
        points.windows(2).fold(self, |all, ends| {
            let [from, to] = [ends[0], ends[1]];
            let axis = [Axis::X, Axis::Y, Axis::Z]
                .into_iter()
                .zip(from.iter().zip(to).map(|(a, b)| (b - a).abs()))
                .max_by(|a, b| a.1.total_cmp(&b.1));
            let Some((axis, length)) = axis else { return all };
            let center = std::array::from_fn(|k| 0.5 * (from[k] + to[k]));
            all.tube(per_metre * length, [radius, 0.0], length, axis, center)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::prng::Random;

    /// Compares each solid with a cloud of random points inside it.
    #[test]
    fn solids_have_the_moments_of_their_points() {
        let mut random = Random::new(3);
        let inside = |solid: usize, p: [f64; 3]| {
            let [x, y, z] = p;
            match solid {
                0 => (0.1 * 0.1..0.3 * 0.3).contains(&(y * y + z * z)) && x.abs() < 0.4,
                1 => x.abs() < 0.3 && y.abs() < 0.1 && z.abs() < 0.4,
                _ => x * x + y * y + z * z < 0.09,
            }
        };
        let at = [0.2, -0.1, 0.5];
        let assemblies = [
            Assembly::new().tube(0.7, [0.3, 0.1], 0.8, Axis::X, at),
            Assembly::new().cuboid(0.7, [0.6, 0.2, 0.8], at),
            Assembly::new().ball(0.7, 0.3, at),
        ];
        for (solid, assembly) in assemblies.iter().enumerate() {
            let (mut sum, mut count) = ([0.0; 10], 0);
            while count < 40_000 {
                let p: [f64; 3] = std::array::from_fn(|_| random.even(0.5));
                if inside(solid, p) {
                    let [x, y, z]: [f64; 3] = std::array::from_fn(|k| p[k] + at[k]);
                    let point = [1.0, x, y, z, y * y + z * z, x * x + z * z, x * x + y * y, -x * y, -x * z, -y * z];
                    sum.iter_mut().zip(point).for_each(|(s, v)| *s += v);
                    count += 1;
                }
            }
            for (k, (sum, exact)) in sum.iter().zip(assembly.inertia.to_array()).enumerate() {
                let cloud = 0.7 * sum / count as f64;
                assert!((cloud - exact).abs() < 0.005 * 0.7, "solid {solid}, parameter {k}: {cloud} {exact}");
            }
        }
    }
}
