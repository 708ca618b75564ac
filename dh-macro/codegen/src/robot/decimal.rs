//! Detects decimals that are rounded or truncated multiples of pi/2.

use core::f64::consts::FRAC_PI_2;

/// pi/2 times 10^35, truncated.
const HALF_PI: u128 = 157_079_632_679_489_661_923_132_169_163_975_144;
/// Decimal places of [`HALF_PI`].
const PLACES: i64 = 35;
/// Number of significant digits from which a match is not accidental.
const ENOUGH: usize = 4;
/// Most quarter turns that are considered: beyond it, four digits match by chance too often.
const MOST_TURNS: f64 = 64.0;

/// Result of comparing a decimal with quarter turns.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum QuarterTurns {
    /// All digits agree with this number of quarter turns.
    All(u32),
    /// All digits agree, but they are too few to be certain.
    Maybe(u32),
    /// The decimal is another number.
    No,
}

/// Compares an unsigned decimal, such as `1.5708` or `15708e-4`, with quarter turns.
pub(super) fn quarter_turns(literal: &str) -> QuarterTurns {
    match whole_turns(literal) {
        Some((turns, digits)) if digits >= ENOUGH => QuarterTurns::All(turns),
        Some((turns, digits)) if digits + 1 == ENOUGH => QuarterTurns::Maybe(turns),
        _ => QuarterTurns::No,
    }
}

/// Number of quarter turns and of significant digits, if all digits agree.
fn whole_turns(literal: &str) -> Option<(u32, usize)> {
    let value: f64 = literal.parse().ok()?;
    let turns = (value / FRAC_PI_2).round();
    if !(1.0..=MOST_TURNS).contains(&turns) {
        return None;
    }
    let (mantissa, exponent) = literal.split_once(['e', 'E']).unwrap_or((literal, "0"));
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits = format!("{whole}{fraction}");
    let significant = digits.trim_start_matches('0');
    let kept: String = significant.chars().take(PLACES as usize).collect();
    let dropped = (significant.len() - kept.len()) as i64;
    let places = (fraction.len() as i64).checked_sub(exponent.parse::<i64>().ok()?)?.checked_sub(dropped)?;
    let (turns, written) = (turns as u32, kept.parse::<u128>().ok()?);
    let fits = match (0..=PLACES).contains(&places) {
        true => {
            let (exact, step) = (HALF_PI * u128::from(turns), 10u128.pow((PLACES - places) as u32));
            written == exact / step || written == (exact + step / 2) / step
        }
        false => false,
    };
    (fits || value == f64::from(turns) * FRAC_PI_2).then_some((turns, significant.len()))
}

#[cfg(test)]
mod tests {
    use super::{QuarterTurns::*, *};
    use core::f64::consts::PI;

    #[test]
    fn every_digit_must_fit() {
        for (literal, expected) in [
            ("1.5708", All(1)),
            ("1.5707", All(1)),
            ("1.571", All(1)),
            ("1.570", All(1)),
            ("1.570796326794897", All(1)),
            ("1.57079632679489661923", All(1)),
            ("1.57079632679489661923132169163975144209858469968", All(1)),
            ("15708e-4", All(1)),
            ("0.15708E1", All(1)),
            ("3.1416", All(2)),
            ("3.141592653589793", All(2)),
            ("3.14159", All(2)),
            ("4.7124", All(3)),
            ("6.28319", All(4)),
            ("1.57", Maybe(1)),
            ("3.14", Maybe(2)),
            ("1.5712", No),
            ("1.5709", No),
            ("1.5", No),
            ("1.6", No),
            ("0", No),
            ("0.0000", No),
            ("0.7854", No),
            ("3.1414", No),
            ("1e300", No),
            ("157e-99999999999999999999", No),
        ] {
            assert_eq!(quarter_turns(literal), expected, "{literal}");
        }
        for turns in 1..=MOST_TURNS as u32 {
            assert_eq!(quarter_turns(&format!("{}", PI / 2.0 * f64::from(turns))), All(turns));
        }
    }
}
