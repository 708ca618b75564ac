//! Probability of a cause: a logistic function of its evidence, fitted to causes that were added to
//! real recordings (docs/diagnose.md lists them, and the results on others).
//!
//! `p = 1 / (1 + exp(-(a + b ln(1 + support) / 5 + c ln(1 + margin) / 5 + d share - e scatter)))`,
//! with `b` to `e` not negative. More support, a larger margin to the next best cause, a larger
//! share of the error, or a more constant size over stretches therefore never makes a cause less
//! likely.

/// `[a, b, c, d, e]` of causes that add columns.
const CAUSE: [f64; 5] = [-5.2, 2.1, 2.3, 4.8, 9.2];
/// `[a, b, c, d, e]` of plain friction and offsets.
const PLAIN: [f64; 5] = [-6.3, 2.8, 0.0, 4.6, 5.9];

/// Factor for causes that only the fitted logs confirm: the validating logs cannot show them, or
/// have large errors on their joints with and without them.
const UNCONFIRMED: f64 = 0.5;

/// Factor of a cause that unfitted data refute, or whose size beside the others is implausible, so that
/// it is not named; chosen.
pub const REFUTED: f64 = 0.4;

/// Factor for a link beside which another link, or a payload, explains nearly as much; chosen.
pub const ANOTHER_BODY: f64 = 0.75;

/// Difference of support below which another body explains nearly as much.
pub const NEARLY_AS_MUCH: f64 = 2.5;

/// Probability below which a cause is neither named nor in the model: its absence is more likely.
pub const NAMED: f64 = 0.5;

/// The same for probabilities derived from a size ([`structure`], [`links`]).
pub const NAMED_BY_SIZE: f64 = 0.3;

/// Margin above which a larger value carries no information.
const FAR: f64 = 100.0;

/// Evidence for a cause.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Features {
    /// Twice the gain in log-likelihood over independent windows, less its cost.
    pub support: f64,
    /// Difference of support to the next best cause.
    pub margin: f64,
    /// Share of the squared error above the noise that it removes.
    pub share: f64,
    /// Recurrence in disjoint stretches, 0 to 1.
    pub recurrence: f64,
    /// Whether it was measured on unfitted data, or acts in a part of a log only.
    pub confirmed: bool,
}

/// Evidence for a change relative to the file, from the search that starts at the file and from the
/// model with all its findings.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Change {
    /// Share of its main joint's squared error that it removed when it was found, 0 to 1.
    pub share: f64,
    /// Wald statistic of its parameters beside all other causes. The covariance accounts for
    /// independent windows and for the scatter between stretches.
    pub wald: f64,
    /// Difference of support to the next best cause.
    pub margin: f64,
    /// Whether unfitted data confirm it.
    pub confirmed: bool,
}

/// Constant, weights of `share`, `ln(1 + wald) / 5` and `ln(1 + margin) / 5`, and deduction if the
/// validating data cannot confirm a cause. Fitted to causes added to recordings of five arms and to
/// those of two simulators (docs/diagnose.md).
const CHANGE: [f64; 5] = [-4.3, 3.4, 3.7, 0.9, 1.2];

/// Wald statistic above which a larger value carries no information: a nearly correct law also
/// reaches it.
const SURE: f64 = 400.0;

/// Probability of a cause that changed the file.
pub fn change(found: &Change) -> f64 {
    let [a, b, c, d, e] = CHANGE;
    let log = |x: f64, most: f64| x.clamp(0.0, most).ln_1p() / 5.0;
    let sum = a + b * found.share.clamp(0.0, 1.0) + c * log(found.wald, SURE) + d * log(found.margin, FAR)
        - if found.confirmed { 0.0 } else { e };
    (1.0 / (1.0 + (-sum).exp())).min(0.995)
}

/// Support at which a change in a part of a log has even odds. Of 17 that were found on changed
/// recordings with more than twice as much support, one was false.
const LOCAL: f64 = 12.5;

/// The same for causes as brief as errors of the recorded motion. On a recording of a Panda,
/// stretches of 0.4 s in which nothing pushes have supports of up to 71.
const LOCAL_BRIEF: f64 = 75.0;

/// Probability of a change in a part of a log, which no other part can confirm, by its support:
/// twice the gain in log-likelihood, in independent windows, less its cost.
pub fn local(support: f64, brief: bool) -> f64 {
    let even = if brief { LOCAL_BRIEF } else { LOCAL };
    (support.max(0.0) / (support.max(0.0) + even)).min(0.995)
}

/// Share of a probability beyond one half that is left for a cause that none, one or two excerpts of
/// the fitted logs lack. Chosen by hand: of causes above 0.8 that an excerpt lacks, less than two
/// thirds are found in other parts of a recording (docs/results/diagnosis.md).
const LEFT: [f64; 3] = [1.0, 0.6, 0.4];

/// Probability of a cause that was sought again in excerpts of the fitted logs: found in the first
/// number of as many as the second. It stays named.
pub fn sought_again(probability: f64, [found, of]: [usize; 2]) -> f64 {
    let left = LEFT[of.saturating_sub(found).min(LEFT.len() - 1)];
    if probability > NAMED { NAMED + left * (probability - NAMED) } else { probability }
}

/// Relative deviation of a cause's size between stretches, from its recurrence `1 / (1 + s^2)`.
fn scatter(recurrence: f64) -> f64 {
    (1.0 / recurrence.clamp(1e-3, 1.0) - 1.0).sqrt()
}

/// Probability of a cause, or of a plain friction term, with this evidence.
pub fn probability(plain: bool, found: &Features) -> f64 {
    let [a, b, c, d, e] = if plain { PLAIN } else { CAUSE };
    let log = |x: f64| x.max(0.0).ln_1p() / 5.0;
    let sum = a + b * log(found.support) + c * log(found.margin.min(FAR)) + d * found.share.clamp(-1.0, 1.0)
        - e * scatter(found.recurrence);
    let factor = if found.confirmed { 1.0 } else { UNCONFIRMED };
    // Limit below certainty.
    (factor / (1.0 + (-sum).exp())).min(0.995)
}

/// Probability of structure of this size with this noise: its share of the sum of their squares.
pub fn structure(size: f64, noise: f64) -> f64 {
    (size * size / (size * size + noise * noise).max(f64::MIN_POSITIVE)).min(0.995)
}

/// Probability of wrong links if all base parameters were refitted, from the gain on left-out
/// stretches and its standard error. It is one half at six standard errors, since links fitted to
/// one motion are often wrong on another.
pub fn links(gain: f64, error: f64) -> f64 {
    structure(gain.max(0.0), 6.0 * error)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// In odds, the formula of the module is a product: each piece of evidence contributes a
    /// factor.
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
        // A margin beyond 100 has the same effect as one of 100.
        close(times(Features { margin: 1e6, ..weak }), (101.0_f64 / 3.0).powf(CAUSE[2] / 5.0));
        close(times(Features { share: 0.4, ..weak }), (CAUSE[3] * 0.3).exp());
        close(times(Features { recurrence: 0.2, ..weak }), (-CAUSE[4]).exp());
    }

    /// Each piece of evidence for a change contributes a factor to its odds; without evidence the
    /// probability is near 0.
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
        assert!(local(71.0, true) < NAMED && local(180.0, true) > NAMED && local(1e9, true) < 1.0);
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
