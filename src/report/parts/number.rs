//! Formatting of numbers for readers.

/// Four significant digits; a dash for NaN and infinity.
pub(in crate::report) fn figure(x: f64) -> String {
    digits(x, 4)
}

/// Rounds to `digits` decimals, for data of pages.
pub(in crate::report) fn short(x: f64, digits: i32) -> f64 {
    let scale = 10f64.powi(digits);
    (x * scale).round() / scale
}

/// Percent with about two significant digits.
pub(in crate::report) fn percent(x: f64) -> String {
    match x {
        x if !x.is_finite() => "–".into(),
        x if x >= 1e4 => ">9999".into(),
        x if x >= 10.0 => format!("{x:.0}"),
        x if x >= 1.0 => format!("{x:.1}"),
        x => format!("{x:.2}"),
    }
}

/// This many significant digits, in plain notation where that is short.
pub(in crate::report) fn digits(x: f64, significant: i32) -> String {
    if !x.is_finite() {
        return "–".into();
    }
    if x == 0.0 {
        return "0".into();
    }
    let exponent = x.abs().log10().floor() as i32;
    if (-4..6).contains(&exponent) {
        format!("{x:.*}", (significant - 1 - exponent).max(0) as usize)
    } else {
        format!("{x:.*e}", (significant - 1) as usize)
    }
}

/// A number of things in words: "1 row", "2 rows".
pub(in crate::report) fn counted(count: usize, one: &str, more: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { more })
}

/// Pads text to a width in characters, not bytes; `right`: right-aligned.
pub(in crate::report) fn pad(text: &str, width: usize, right: bool) -> String {
    let fill = " ".repeat(width.saturating_sub(text.chars().count()));
    if right { format!("{fill}{text}") } else { format!("{text}{fill}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn four_digits() {
        for (x, text) in [
            (1.0, "1.000"),
            (-0.012345, "-0.01235"),
            (123456.7, "123457"),
            (1.5e9, "1.500e9"),
            (2e-7, "2.000e-7"),
            (0.0, "0"),
            (f64::NAN, "–"),
        ] {
            assert_eq!(figure(x), text);
        }
        assert_eq!((percent(0.123).as_str(), percent(5.04).as_str(), percent(99.7).as_str()), ("0.12", "5.0", "100"));
    }
}
