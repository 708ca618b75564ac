//! How sure a cause is: a logistic map of its evidence, fitted to causes that were added to real
//! recordings (docs/diagnose.md says to which, and how it does on others).
//!
//! `p = 1 / (1 + exp(-(a + b ln(1 + support) / 5 + c ln(1 + margin) / 5 + d share - e scatter)))`,
//! `b` to `e` not negative. More support, more distance from the next best cause, more of the
//! error, the same size in more stretches never make a cause less likely.

/// `[a, b, c, d, e]` of causes that add columns.
const CAUSE: [f64; 5] = [-5.2, 2.1, 2.3, 4.8, 9.2];
/// Of plain friction and offsets.
const PLAIN: [f64; 5] = [-6.3, 2.8, 0.0, 4.6, 5.9];

/// Factor of what the fitted logs alone show, since the validating ones are missed on its joints
/// with it and without it, or can't show it.
const UNCONFIRMED: f64 = 0.5;

/// Probability below which a cause is not named, nor in the model: it is likelier not to be there.
pub const NAMED: f64 = 0.5;

/// The same of what is likely by its size ([`structure`], [`links`]).
pub const NAMED_BY_SIZE: f64 = 0.3;

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

/// Evidence for a cause that changed the file, from the search that starts there and from the model
/// with all that it found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Change {
    /// Share of its main joint's squared error that it took as it was found, 0 to 1.
    pub share: f64,
    /// Wald's statistic of its parameters beside all other causes, with a covariance by independent
    /// windows and by how stretches differ.
    pub wald: f64,
    /// By how much less the next best cause has.
    pub margin: f64,
    /// Whether data that were not fitted show it.
    pub confirmed: bool,
}

/// A constant, weights of `share`, `ln(1 + wald) / 5` and `ln(1 + margin) / 5`, and what is taken
/// off where the validating data can't confirm a cause. Fitted to causes added to recordings of
/// five arms and to those of two simulators (docs/diagnose.md).
const CHANGE: [f64; 5] = [-4.3, 3.4, 3.7, 0.9, 1.2];

/// Wald's statistic beyond which more of it says nothing: a law that is nearly right has as much.
const SURE: f64 = 400.0;

/// Of a cause that changed the file.
pub fn change(found: &Change) -> f64 {
    let [a, b, c, d, e] = CHANGE;
    let log = |x: f64, most: f64| x.clamp(0.0, most).ln_1p() / 5.0;
    let sum = a + b * found.share.clamp(0.0, 1.0) + c * log(found.wald, SURE) + d * log(found.margin, FAR)
        - if found.confirmed { 0.0 } else { e };
    (1.0 / (1.0 + (-sum).exp())).min(0.995)
}

/// Support at which a change in a part of a log is as likely as not: of 17 that were found on
/// changed recordings with more than twice as much, one was not there.
const LOCAL: f64 = 12.5;

/// Factor of what acts for so short a time that errors of the motion last as long; chosen, since
/// no recording has pushes as brief.
const BRIEF: f64 = 0.5;

/// Of a change that acts in a part of a log, which no other part can confirm, by its support: twice
/// the gain in log-likelihood, in independent windows, less its cost.
pub fn local(support: f64, brief: bool) -> f64 {
    let factor = if brief { BRIEF } else { 1.0 };
    factor * (support.max(0.0) / (support.max(0.0) + LOCAL)).min(0.995)
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
/// stretches and its standard error: one half at six standard errors, for the links
/// that fit one motion best are often wrong on another.
pub fn links(gain: f64, error: f64) -> f64 {
    structure(gain.max(0.0), 6.0 * error)
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
        close(times(Features { support: 50.0, ..weak }), (51.0_f64 / 6.0).powf(CAUSE[1] / 5.0));
        close(times(Features { margin: 20.0, ..weak }), (21.0_f64 / 3.0).powf(CAUSE[2] / 5.0));
        // A margin beyond 100 says no more than one of 100.
        close(times(Features { margin: 1e6, ..weak }), (101.0_f64 / 3.0).powf(CAUSE[2] / 5.0));
        close(times(Features { share: 0.4, ..weak }), (CAUSE[3] * 0.3).exp());
        close(times(Features { recurrence: 0.2, ..weak }), (-CAUSE[4]).exp());
    }

    /// The odds of a change: each piece of evidence counts by itself; nothing is next to nothing.
    #[test]
    fn a_change_is_as_likely_as_its_evidence() {
        let some = Change { share: 0.5, wald: 50.0, margin: 20.0, confirmed: true };
        let odds = |found: Change| change(&found) / (1.0 - change(&found));
        let times = |found: Change| odds(found) / odds(some);
        let close = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-9, "{a} {b}");
        close(times(Change { share: 0.9, ..some }), (0.4 * CHANGE[1]).exp());
        close(times(Change { wald: 300.0, ..some }), (301.0_f64 / 51.0).powf(CHANGE[2] / 5.0));
        close(times(Change { margin: 1.0, ..some }), (2.0_f64 / 21.0).powf(CHANGE[3] / 5.0));
        close(times(Change { confirmed: false, ..some }), (-CHANGE[4]).exp());
        close(times(Change { wald: 1e6, ..some }), times(Change { wald: SURE, ..some }));
        let none = Change { share: 0.0, wald: f64::NEG_INFINITY, margin: -1.0, confirmed: true };
        assert!(change(&none) < 0.05);
        let long = |support: f64| local(support, false);
        assert!(long(0.0) == 0.0 && long(-3.0) == 0.0 && (long(LOCAL) - 0.5).abs() < 1e-12 && long(1e9) < 1.0);
        assert!(local(1e9, true) <= 0.5);
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
            assert!(structure(0.0, 1.0) == 0.0 && structure(4.0, 1.0) > 0.9 && (links(0.6, 0.1) - 0.5).abs() < 1e-9);
            let nothing = Features { support: -3.0, margin: -1.0, share: -1.0, recurrence: 0.0, confirmed: true };
            assert!(probability(plain, &nothing) > 0.0);
        }
    }
}
