//! Interpolates samples from their time stamps to an even clock.

/// Value at time `at` of the cubic through the four samples around it (Lagrange). `t` is ascending
/// with `t[1] <= at <= t[2]`, except at the ends of a record; fewer samples give a line or a
/// constant.
pub fn resample(t: &[f64], x: &[f64], at: f64) -> f64 {
    let n = t.len().min(x.len());
    match n {
        0 => f64::NAN,
        1 => x[0],
        _ => {
            let after = t[..n].partition_point(|&s| s < at);
            if let Some(&s) = t.get(after)
                && s == at
            {
                return x[after];
            }
            let first = after.saturating_sub(2).min(n.saturating_sub(4));
            let window = first..(first + 4).min(n);
            window
                .clone()
                .map(|i| {
                    let weight: f64 = window.clone().filter(|&k| k != i).map(|k| (at - t[k]) / (t[i] - t[k])).product();
                    weight * x[i]
                })
                .sum()
        }
    }
}

/// Whether samples are smoother if taken as evenly spaced than at their stamps. A recorder that
/// stamps late does not sample late: its stamps jitter, and the motion does not. Compares the sums
/// of squared second differences.
pub(super) fn smoother_evenly(t: &[f64], channels: &[&[f64]], period: f64) -> bool {
    let (mut even_sum, mut stamp_sum) = (0.0, 0.0);
    for x in channels {
        let (mut e, mut s) = (0.0, 0.0);
        for k in 1..t.len().saturating_sub(1) {
            let (h0, h1) = (t[k] - t[k - 1], t[k + 1] - t[k]);
            let stamped = 2.0 * ((x[k + 1] - x[k]) / h1 - (x[k] - x[k - 1]) / h0) / (h0 + h1);
            let evenly = (x[k + 1] - 2.0 * x[k] + x[k - 1]) / (period * period);
            s += stamped * stamped;
            e += evenly * evenly;
        }
        let both = s + e;
        if both > 0.0 {
            even_sum += e / both;
            stamp_sum += s / both;
        }
    }
    even_sum <= stamp_sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cubic_is_met_exactly() {
        let t = [0.0, 0.9, 2.1, 3.0, 4.2, 5.0];
        let f = |t: f64| 1.0 - 2.0 * t + 0.5 * t * t - 0.1 * t * t * t;
        let x = t.map(f);
        for at in [0.0, 0.4, 1.5, 2.1, 2.5, 4.9, 5.0] {
            assert!((resample(&t, &x, at) - f(at)).abs() < 1e-12);
        }
        assert_eq!(resample(&[1.0], &[3.0], 7.0), 3.0);
    }

    #[test]
    fn jitter_of_the_stamps_and_of_the_sampling_are_told_apart() {
        let stamps: Vec<f64> = (0..400).map(|k| 0.005 * k as f64 + 0.001 * (7.3 * k as f64).sin()).collect();
        let by_stamp: Vec<f64> = stamps.iter().map(|t| (3.0 * t).sin()).collect();
        let by_count: Vec<f64> = (0..400).map(|k| (0.015 * k as f64).sin()).collect();
        assert!(!smoother_evenly(&stamps, &[&by_stamp], 0.005));
        assert!(smoother_evenly(&stamps, &[&by_count], 0.005));
    }
}
