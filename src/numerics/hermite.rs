//! Cubics by values and slopes at both ends (Hermite).

/// Value at share `s` of a step, 0 to 1. `values`: at its start and end; `slopes`: there, times the
/// length of the step, so that all have one unit.
#[inline]
pub(crate) fn cubic([start, end]: [f64; 2], [left, right]: [f64; 2], s: f64) -> f64 {
    let rise = end - start;
    start + s * (left + s * (3.0 * rise - 2.0 * left - right + s * (left + right - 2.0 * rise)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cubic_is_met_exactly() {
        let (f, slope) = (|t: f64| 1.0 - 2.0 * t + 0.5 * t * t * t, |t: f64| -2.0 + 1.5 * t * t);
        let (start, step) = (0.5, 1.5);
        let (values, slopes) = ([start, start + step].map(f), [start, start + step].map(|t| step * slope(t)));
        for s in [0.0, 0.25, 0.7, 1.0] {
            assert!((cubic(values, slopes, s) - f(start + s * step)).abs() < 1e-14, "{s}");
        }
    }
}
