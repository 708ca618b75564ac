//! How sure a cause is: a logistic map of its evidence, fitted to what `denavit reproduce
//! diagnosis` hid (docs/diagnose.md says on which seeds, and how it does on others).
//!
//! `p = 1 / (1 + exp(-(a + b ln(1 + support) / 5 + c ln(1 + margin) / 5 + d share)))`, `b`, `c`,
//! `d` not negative: more support, more distance from the next best cause, more of the error never
//! make a cause less likely.

/// `[a, b, c, d]` of causes that add columns.
const CAUSE: [f64; 4] = [-3.5, 1.6, 2.0, 2.6];
/// Of plain friction and offsets.
const PLAIN: [f64; 4] = [-4.3, 2.3, 0.0, 0.8];

/// Structure without a name, where nothing else gains more.
pub const UNKNOWN_FIRST: f64 = 0.7;
/// Structure beside a cause that gains more: often what that cause's law does not fit.
pub const UNKNOWN_BESIDE: f64 = 0.1;
/// That links are wrong, where all base parameters were taken anew.
pub const LINKS: f64 = 0.5;

/// A margin beyond which more of it says nothing.
const FAR: f64 = 100.0;

/// Of a cause, or of a plain term of friction, with this evidence.
pub fn probability(plain: bool, support: f64, margin: f64, share: f64) -> f64 {
    let [a, b, c, d] = if plain { PLAIN } else { CAUSE };
    let log = |x: f64| x.max(0.0).ln_1p() / 5.0;
    let sum = a + b * log(support) + c * log(margin.min(FAR)) + d * share.max(0.0);
    // Never quite certain.
    (1.0 / (1.0 + (-sum).exp())).min(0.995)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn more_evidence_is_never_less_likely() {
        for plain in [false, true] {
            let mut last = 0.0;
            for k in 0..50 {
                let x = f64::from(k);
                let now = probability(plain, 20.0 * x, 2.0 * x, x / 50.0);
                assert!(now >= last && now < 1.0);
                last = now;
            }
            assert!(probability(plain, -3.0, -1.0, -1.0) > 0.0);
        }
    }
}
