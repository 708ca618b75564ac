//! Shifts a series to an earlier time by Lagrange cubic interpolation.

/// Samples of `x` at `span`, each interpolated `by` samples earlier. Before the first sample the
/// first value is used, after the last one the last.
pub(super) fn earlier(x: &[f64], span: std::ops::Range<usize>, by: f64) -> Vec<f64> {
    if by == 0.0 {
        return x[span].to_vec();
    }
    // All samples share one fraction: each lies `back` samples earlier, plus `f` towards the next.
    let (f, back, last) = (by.ceil() - by, by.ceil() as isize, (x.len() as isize - 1).max(0));
    let weights = [
        -f * (f - 1.0) * (f - 2.0) / 6.0,
        (f * f - 1.0) * (f - 2.0) / 2.0,
        -f * (f + 1.0) * (f - 2.0) / 2.0,
        f * (f * f - 1.0) / 6.0,
    ];
    let sum = |four: &[f64; 4]| four.iter().zip(&weights).map(|(x, w)| x * w).sum::<f64>();
    let at_an_end = |k: isize| {
        let get = |at: isize| x[at.clamp(0, last) as usize];
        match k - back {
            at if at < 0 => get(0),
            at if at >= last => get(last),
            at => sum(&[get(at - 1), get(at), get(at + 1), get(at + 2)]),
        }
    };
    let (start, end) = (span.start as isize, span.end as isize);
    let from = (back + 1).clamp(start, end);
    let to = (last - 1 + back).clamp(from, end);
    let mut out = Vec::with_capacity(span.len());
    out.extend((start..from).map(at_an_end));
    if from < to {
        let inside = &x[(from - back - 1) as usize..(to - back + 2) as usize];
        out.extend(inside.array_windows().map(sum));
    }
    out.extend((to..end).map(at_an_end));
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A cubic is reproduced inside, integer shifts return the samples, and end values are held.
    /// Part of a series equals that part of the whole.
    #[test]
    fn cubics_are_met_and_ends_stand() {
        let cubic = |t: f64| 0.3 * t * t * t - 2.0 * t * t + t - 4.0;
        let x: Vec<f64> = (0..30).map(|k| cubic(f64::from(k))).collect();
        for by in [0.0, 0.37, 1.0, 2.6, -0.25, -3.0, 40.0, -40.0] {
            let all = earlier(&x, 0..x.len(), by);
            for (k, found) in all.iter().enumerate() {
                let at = k as f64 - by;
                let wanted = match at {
                    _ if at <= 0.0 => x[0],
                    _ if at >= 29.0 => x[29],
                    _ => cubic(at),
                };
                let inside = (1.0..28.0).contains(&at) || at <= 0.0 || at >= 29.0 || at.fract() == 0.0;
                assert!(!inside || (found - wanted).abs() < 1e-9, "{by} at {k}: {found} for {wanted}");
            }
            let part = earlier(&x, 8..20, by);
            assert!(part.iter().zip(&all[8..20]).all(|(a, b)| a == b), "{by}");
        }
    }
}
