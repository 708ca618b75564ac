//! Exact fractions.

/// A reduced fraction, `q > 0`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Ratio {
    pub(super) p: i64,
    pub(super) q: i64,
}

impl Ratio {
    pub(super) fn new(p: i128, q: i128) -> Option<Self> {
        let (mut a, mut b) = (p.unsigned_abs(), q.unsigned_abs());
        while b != 0 {
            (a, b) = (b, a % b);
        }
        let g = i128::try_from(a).ok().filter(|&g| q != 0 && g != 0)? * q.signum();
        // A fraction that f64 does not represent exactly is useless as an exact one.
        let exact = |v: i128| i64::try_from(v).ok().filter(|v| v.unsigned_abs() <= 1 << 53);
        Some(Self { p: exact(p / g)?, q: exact(q / g)? })
    }

    pub(super) fn add(self, b: Self) -> Option<Self> {
        let (ap, aq, bp, bq) = (self.p as i128, self.q as i128, b.p as i128, b.q as i128);
        Self::new(ap * bq + bp * aq, aq * bq)
    }

    pub(super) fn mul(self, b: Self) -> Option<Self> {
        Self::new(self.p as i128 * b.p as i128, self.q as i128 * b.q as i128)
    }

    pub(super) fn div(self, b: Self) -> Option<Self> {
        Self::new(self.p as i128 * b.q as i128, self.q as i128 * b.p as i128)
    }

    /// Fraction of an unsigned decimal literal.
    pub(super) fn literal(text: &str) -> Option<Self> {
        let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
        let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        let fraction = fraction.trim_end_matches('0');
        let exponent: i32 = exponent.parse().ok()?;
        let digits: i128 = format!("0{whole}{fraction}").parse().ok().filter(|&d| d < 1 << 60)?;
        let power = exponent.checked_sub(i32::try_from(fraction.len()).ok()?)?;
        let scale = 10i128.checked_pow(power.unsigned_abs()).filter(|&s| s < 1 << 60)?;
        if power < 0 { Self::new(digits, scale) } else { Self::new(digits * scale, 1) }
    }
}
