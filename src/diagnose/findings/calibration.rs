//! How sure a cause is: a logistic map of its evidence, fitted to causes that were added to real
//! recordings (docs/diagnose.md says to which, and how it does on others).
//!
//! `p = 1 / (1 + exp(-(a + b ln(1 + support) / 5 + c ln(1 + margin) / 5 + d share - e scatter)))`,
//! `b` to `e` not negative. More support, more distance from the next best cause, more of the
//! error, the same size in more stretches never make a cause less likely.

/// `[a, b, c, d, e]` of causes that add columns.
const CAUSE: [f64; 5] = [-2.5, 1.2, 1.3, 2.7, 5.2];
/// Of plain friction and offsets.
const PLAIN: [f64; 5] = [-3.1, 1.6, 0.0, 2.6, 3.3];

/// Factor of what the fitted logs alone show, since the validating ones are missed on its joints
/// with it and without it, or can't show it.
const UNCONFIRMED: f64 = 0.5;

/// Probability below which a cause is not named, nor in the model: of those below it one in twenty
/// was right on real recordings.
pub const NAMED: f64 = 0.2;

/// A margin beyond which more of it says nothing.
const FAR: f64 = 100.0;

/// Evidence for a cause.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Features {
    /// Twice the gain in log-likelihood over independent windows, less its cost.
    pub support: f64,
    /// By how much less the next best cause has.
    pub margin: f64,
    /// Part of the squared error above the noise that it takes.
    pub share: f64,
    /// How it recurs in disjoint stretches, 0 to 1.
    pub recurrence: f64,
    /// Whether it was measured on data that were not fitted, or acts in a part of a log only.
    pub confirmed: bool,
}

/// Relative deviation of a cause's size between stretches, from its recurrence `1 / (1 + s^2)`.
fn scatter(recurrence: f64) -> f64 {
    (1.0 / recurrence.clamp(1e-3, 1.0) - 1.0).sqrt()
}

/// Of a cause, or of a plain term of friction, with this evidence.
pub fn probability(plain: bool, found: &Features) -> f64 {
    let [a, b, c, d, e] = if plain { PLAIN } else { CAUSE };
    let log = |x: f64| x.max(0.0).ln_1p() / 5.0;
    let sum = a + b * log(found.support) + c * log(found.margin.min(FAR)) + d * found.share.clamp(-1.0, 1.0)
        - e * scatter(found.recurrence);
    let factor = if found.confirmed { 1.0 } else { UNCONFIRMED };
    // Never quite certain.
    (factor / (1.0 + (-sum).exp())).min(0.995)
}

/// Probability of structure of this size beside this noise: its part of the sum of their squares.
pub fn structure(size: f64, noise: f64) -> f64 {
    (size * size / (size * size + noise * noise).max(f64::MIN_POSITIVE)).min(0.995)
}

/// Probability of wrong links if all base parameters were refitted, by the gain on left-out
/// stretches and its standard error: one half at three standard errors.
pub fn links(gain: f64, error: f64) -> f64 {
    structure(gain, 3.0 * error)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The law of the first comment, in odds: each piece of evidence multiplies them by its own.
    #[test]
    fn each_piece_of_evidence_counts_by_itself() {
        let odds = |found: &Features| {
            let p = probability(false, found);
            p / (1.0 - p)
        };
        let weak = Features { support: 5.0, margin: 2.0, share: 0.1, recurrence: 0.5, confirmed: true };
        let times = |found: Features| odds(&found) / odds(&weak);
        let close = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-9, "{a} {b}");
        close(times(Features { support: 50.0, ..weak }), (51.0_f64 / 6.0).powf(1.2 / 5.0));
        close(times(Features { margin: 20.0, ..weak }), (21.0_f64 / 3.0).powf(1.3 / 5.0));
        // A margin beyond 100 says no more than one of 100.
        close(times(Features { margin: 1e6, ..weak }), (101.0_f64 / 3.0).powf(1.3 / 5.0));
        close(times(Features { share: 0.4, ..weak }), (2.7 * 0.3_f64).exp());
        close(times(Features { recurrence: 0.2, ..weak }), (-5.2 * (2.0 - 1.0_f64)).exp());
    }

    #[test]
    fn more_evidence_is_never_less_likely() {
        for plain in [false, true] {
            let mut last = 0.0;
            for k in 0..50 {
                let x = f64::from(k);
                let share = x / 50.0;
                let at = Features { support: 20.0 * x, margin: 2.0 * x, share, recurrence: share, confirmed: true };
                let now = probability(plain, &at);
                assert!(now >= last && now < 1.0);
                last = now;
            }
            let at = Features { support: 500.0, margin: 50.0, share: 0.9, recurrence: 1.0, confirmed: false };
            assert!(probability(plain, &at) < 0.5);
            assert!(structure(0.0, 1.0) == 0.0 && structure(4.0, 1.0) > 0.9 && (links(0.3, 0.1) - 0.5).abs() < 1e-9);
            let nothing = Features { support: -3.0, margin: -1.0, share: -1.0, recurrence: 0.0, confirmed: true };
            assert!(probability(plain, &nothing) > 0.0);
        }
    }
}
