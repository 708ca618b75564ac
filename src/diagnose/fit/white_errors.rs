//! Gain in log-likelihood with white errors. Slow errors are counted in independent windows: the
//! number of windows divided by the autocorrelation time of the residual.

use super::model::Fitted;

/// Logarithm of the ratio of each joint's residual sums of squares, `before` to `after`; 0 where
/// one of them is zero.
pub(in crate::diagnose) fn log_ratios<'a>(before: &'a [f64], after: &'a [f64]) -> impl Iterator<Item = f64> + 'a {
    before.iter().zip(after).map(|(a, b)| if *a > 1e-290 && *b > 1e-290 { (a / b).ln() } else { 0.0 })
}

/// Twice the gain in log-likelihood from residual sums of squares `before` to `after`, per joint,
/// over the given number of windows of each joint.
pub(in crate::diagnose) fn white_gain(before: &[f64], after: &[f64], windows: impl Iterator<Item = f64>) -> f64 {
    log_ratios(before, after).zip(windows).map(|(l, n)| l * n).sum()
}

/// Number of independent windows of each joint. `counts`: windows that count; `memory`:
/// autocorrelation time of the residual, windows.
pub(in crate::diagnose) fn independent_windows<'a>(
    counts: &'a [f64],
    memory: &'a [f64],
) -> impl Iterator<Item = f64> + 'a {
    counts.iter().zip(memory).map(|(n, m)| n / m)
}

/// Cost of one unknown by Schwarz's criterion: the logarithm of the number of windows.
pub(in crate::diagnose) fn cost_of_unknown(windows: f64) -> f64 {
    windows.max(2.0).ln()
}

/// Loss of log-likelihood from one fit to the next, and the number of independent windows, which
/// are those of the fit `of`.
pub(in crate::diagnose) fn lost_by(fitted: &Fitted, next: &Fitted, of: &Fitted) -> (f64, f64) {
    let windows = || independent_windows(&of.solution.counts, &of.memory);
    let gain = white_gain(&fitted.solution.rss, &next.solution.rss, windows());
    (-gain, windows().sum())
}
