//! Exact angles: a rational multiple of pi is kept as such until its sine and cosine are evaluated.

use core::f64::consts::{FRAC_PI_2, PI};

use crate::runtime::Scalar;

/// An angle in rad with its exact multiple of pi, if it has one.
#[derive(Debug, Clone, PartialEq)]
pub struct Angle {
    /// Value, rad.
    pub value: f64,
    /// Exact multiple of pi: `Some((p, q))` means `p/q * pi`, reduced, `q > 0`.
    pub pi_multiple: Option<(i64, i64)>,
    /// Text of the angle in the file.
    pub text: String,
}

impl Angle {
    /// The angle zero.
    pub fn zero() -> Self {
        Self::pi_fraction(0, 1)
    }

    /// The exact angle `p/q * pi`.
    pub fn pi_fraction(p: i64, q: i64) -> Self {
        let g = gcd(p.unsigned_abs(), q.unsigned_abs()).max(1) as i64 * q.signum();
        let (p, q) = (p / g, q / g);
        let text = match (p, q) {
            (0, _) => "0".to_string(),
            (1, 1) => "pi".to_string(),
            (-1, 1) => "-pi".to_string(),
            (p, 1) => format!("{p}*pi"),
            (1, q) => format!("pi/{q}"),
            (-1, q) => format!("-pi/{q}"),
            (p, q) => format!("{p}*pi/{q}"),
        };
        Self { value: p as f64 * PI / q as f64, pi_multiple: Some((p, q)), text }
    }

    /// A measured angle, rad, without an exact multiple of pi unless it is 0.
    pub fn radians(value: f64) -> Self {
        if value == 0.0 {
            return Self::zero();
        }
        Self { value, pi_multiple: None, text: format!("{value}") }
    }

    /// Number of quarter turns, if the angle is an exact multiple of one.
    pub fn quarter_turns(&self) -> Option<i64> {
        match self.pi_multiple {
            Some((p, 1)) => p.checked_mul(2),
            Some((p, 2)) => Some(p),
            _ => None,
        }
    }

    /// Sine and cosine; 0, 1 and -1 without rounding error at quarter turns, 1/2 at sixths.
    pub fn sin_cos(&self) -> (f64, f64) {
        let Some((p, q)) = self.pi_multiple else { return everywhere_alike(self.value) };
        // Reduces to [-pi/4, pi/4] exactly: angle = k * pi/2 + rest.
        let k = (2 * p as i128 + (q as i128) / 2).div_euclid(q as i128);
        let rest = 2 * p as i128 - k * q as i128; // rest / (2 q) * pi
        let (s, c) = if rest == 0 {
            (0.0, 1.0)
        } else if 6 * rest.abs() == 2 * q as i128 {
            (0.5 * rest.signum() as f64, 0.75f64.sqrt())
        } else {
            everywhere_alike(rest as f64 / q as f64 * FRAC_PI_2)
        };
        match k.rem_euclid(4) {
            0 => (s, c),
            1 => (c, -s),
            2 => (-s, -c),
            _ => (-c, s),
        }
    }
}

/// Sine and cosine by the runtime's polynomials, since those of the library, and hence the
/// generated code, would differ between machines.
fn everywhere_alike(angle: f64) -> (f64, f64) {
    let ([sin], [cos]) = f64::sin_cos_all(&[angle]);
    (sin, cos)
}

fn gcd(a: u64, b: u64) -> u64 {
    if b == 0 { a } else { gcd(b, a % b) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quarter_turns_are_exact() {
        for k in -9i64..9 {
            let (s, c) = Angle::pi_fraction(k, 2).sin_cos();
            let expected = [(0.0, 1.0), (1.0, 0.0), (0.0, -1.0), (-1.0, 0.0)][k.rem_euclid(4) as usize];
            assert_eq!((s, c), expected, "{k}");
            assert_eq!(Angle::pi_fraction(k, 2).quarter_turns(), Some(k));
        }
    }

    #[test]
    fn other_fractions_agree_with_libm() {
        for p in -30i64..30 {
            for q in 1i64..13 {
                let a = Angle::pi_fraction(p, q);
                let (s, c) = a.sin_cos();
                // libm sees the rounded product p/q * pi, so its error grows with the angle.
                let bound = 1e-15 + 3e-16 * a.value.abs();
                assert!((s - a.value.sin()).abs() < bound && (c - a.value.cos()).abs() < bound, "{p}/{q}");
            }
        }
        assert_eq!(Angle::pi_fraction(1, 6).sin_cos().0, 0.5);
        assert_eq!(Angle::pi_fraction(1, 3).sin_cos().1, 0.5);
    }
}
