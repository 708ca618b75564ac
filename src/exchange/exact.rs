//! Rounding of decimals to exact values: fractions of pi, quarter turns, short decimals.

use core::f64::consts::PI;

use dh_codegen::robot::{Angle, Length, Pose};

use super::displacement::Displacement;

/// Angles are compared with multiples of pi over this: half degrees.
const PARTS: f64 = 360.0;

/// Rounding to exact values, with a record of the changes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Snap {
    /// Distance within which an angle of the source is replaced by the exact one, rad.
    pub tolerance: f64,
    /// Number of changed values.
    pub count: usize,
    /// Largest change, rad.
    pub largest: f64,
}

impl Snap {
    /// Starts with no changes.
    pub fn new(tolerance: f64) -> Self {
        Self { tolerance, count: 0, largest: 0.0 }
    }

    fn note(&mut self, change: f64) {
        // Changes of one rounding are not counted.
        if change.abs() > 1e-15 {
            self.count += 1;
            self.largest = self.largest.max(change.abs());
        }
    }

    /// Returns the multiple of half a degree within the tolerance of the angle, or the angle
    /// itself; the tolerance is relative for angles above 1 rad.
    pub fn angle(&mut self, value: f64) -> Angle {
        let angle = exact_angle(value, self.tolerance);
        if angle.pi_multiple.is_some() {
            self.note(angle.value - value);
        }
        angle
    }

    /// Unit vector of a direction; components within the tolerance of zero become zero.
    pub fn direction(&mut self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        let length = x.hypot(y).hypot(z);
        let unit = [x, y, z].map(|c| c / length);
        let cleared = unit.map(|c| if c.abs() <= self.tolerance { 0.0 } else { c });
        unit.iter().zip(&cleared).for_each(|(a, b)| self.note(a - b));
        let [x, y, z] = cleared;
        let length = x.hypot(y).hypot(z);
        // A single non-zero component becomes exactly one.
        cleared.map(|c| if c.abs() == length { c.signum() } else { c / length })
    }

    /// Returns the rotation of a cube's 24 within the tolerance, or the rotation itself.
    pub fn rotation(&mut self, at: Displacement) -> Displacement {
        let rounded = at.rotation.map(f64::round);
        let change = (at.rotation - rounded).amax();
        if change > self.tolerance || rounded.determinant() != 1.0 {
            return at;
        }
        self.note(change);
        // Removes the sign of negative zeros.
        Displacement { rotation: rounded.map(|c| c + 0.0), ..at }
    }
}

/// The exact multiple of half a degree within `tolerance`, or the number itself.
pub(super) fn exact_angle(value: f64, tolerance: f64) -> Angle {
    let parts = (value * PARTS / PI).round();
    let near = parts * PI / PARTS;
    match (value - near).abs() <= tolerance * near.abs().max(1.0) && parts.abs() < 1e9 {
        true => Angle::pi_fraction(parts as i64, PARTS as i64),
        false => Angle::radians(value),
    }
}

/// The shortest decimal within `slack`, m: removes rounding errors from a value that was written
/// with few digits.
pub(super) fn short(value: f64, slack: f64) -> f64 {
    let shorter = |digits: usize| format!("{value:.digits$}").parse::<f64>().ok();
    let near = (0..16).filter_map(shorter).find(|short| (short - value).abs() <= slack);
    near.unwrap_or(value) + 0.0
}

/// Length rounded to the shortest decimal within `slack`, m.
pub(super) fn length(value: f64, slack: f64) -> Length {
    Length::meters(short(value, slack))
}

/// Pose with exact angles where they are exact to rounding.
pub(super) fn pose(at: &Displacement, slack: f64) -> Pose {
    let r = &at.rotation;
    let across = r[(0, 0)].hypot(r[(1, 0)]);
    let pitch = (-r[(2, 0)]).atan2(across);
    // At a pitch of a quarter turn, roll and yaw share one axis: all of it is yaw.
    let yaw = if across > 1e-15 { r[(1, 0)].atan2(r[(0, 0)]) } else { (-r[(0, 1)]).atan2(r[(1, 1)]) };
    let (s, c) = yaw.sin_cos();
    // The roll that remains after this very yaw: near a pitch of a quarter turn it compensates the
    // error of the yaw.
    let roll = (s * r[(0, 2)] - c * r[(1, 2)]).atan2(c * r[(1, 1)] - s * r[(0, 1)]);
    let angle = |value: f64| exact_angle(value, 1e-14);
    Pose { xyz: at.origin.map(|x| short(x, slack)).into(), rpy: [roll, pitch, yaw].map(angle) }
}

#[cfg(test)]
#[allow(clippy::approx_constant)] // rounded constants are what is tested
mod tests {
    use super::*;
    use crate::numerics::prng::Random;

    #[test]
    fn angles_are_exact_within_the_tolerance_only() {
        let mut snap = Snap::new(1e-9);
        assert_eq!(snap.angle(1.57079632679).pi_multiple, Some((1, 2)));
        assert_eq!((snap.count, snap.largest < 5e-12), (1, true));
        assert_eq!(snap.angle(1.5708).pi_multiple, None, "4e-6 off");
        assert_eq!(snap.angle(-0.7853981633974483).pi_multiple, Some((-1, 4)));
        assert_eq!(snap.count, 1, "a rounded pi/4 is no change");
        assert_eq!(Snap::new(1e-5).angle(-1.5708).pi_multiple, Some((-1, 2)));
    }

    #[test]
    fn poses_come_back_from_their_angles() {
        let mut random = Random::new(11);
        for k in 0..200 {
            let turn = |random: &mut Random| (random.uniform(-2.0, 2.0) * if k % 2 == 0 { 1.0 } else { 2.0 }).round();
            let angles: [f64; 3] = core::array::from_fn(|_| match k % 3 {
                0 => random.uniform(-3.0, 3.0),
                _ => turn(&mut random) * core::f64::consts::FRAC_PI_2 + if k % 3 == 1 { 0.0 } else { 1e-10 },
            });
            let given = Pose { xyz: [0.1, -0.2, 0.3], rpy: angles.map(|a| exact_angle(a, 1e-14)) };
            let at = Displacement::new(given.rotation(), given.xyz);
            let back = pose(&at, 1e-15);
            let again = Displacement::new(back.rotation(), back.xyz);
            assert!((again.rotation - at.rotation).amax() < 1e-14, "{angles:?}");
        }
    }

    #[test]
    fn directions_and_rotations_of_a_cube_are_exact() {
        let mut snap = Snap::new(1e-9);
        assert_eq!(snap.direction([0.0, -3.0, 1e-12]), [0.0, -1.0, 0.0]);
        let quarter = Displacement::turn(&nalgebra::Vector3::x(), core::f64::consts::FRAC_PI_2);
        assert_eq!(snap.rotation(quarter).rotation[(1, 1)], 0.0);
        assert_eq!(short(0.31050000000000005, 1e-15), 0.3105);
    }
}
