//! Replaces a push and an opposite one over its begin or end by one shorter push.
//!
//! Slow errors extend a push beyond its end, and so does the rule that a short push is none near an
//! end of a recording. A second push then takes the excess back.

use crate::diagnose::fit::model::{Chosen, Fitted, ModelUnderTest};
use crate::diagnose::fit::white_errors::white_gain;
use crate::diagnose::hypotheses::external_contact::{BRIEFEST, swells};

/// Time within which two pushes end, or begin, together, s.
const TOGETHER: f64 = 0.05;

/// Least share of what the second push gains that the shorter one gains without it.
const MOST_OF_IT: f64 = 0.8;

/// A push that ends where another does.
pub(in crate::diagnose) struct Shorter {
    /// Index of the other push, which is not needed.
    pub(in crate::diagnose) needless: usize,
    /// The causes without it, with the shorter push.
    pub(in crate::diagnose) chosen: Vec<Chosen>,
    /// Their fit.
    pub(in crate::diagnose) fitted: Fitted,
}

/// The first pair of pushes that one shorter push replaces; `fitted` is the fit of all `chosen`.
/// Leaves `tested` with another fit.
pub(in crate::diagnose) fn shorter_push(
    tested: &mut ModelUnderTest<'_>,
    chosen: &[Chosen],
    fitted: &Fitted,
) -> Option<Shorter> {
    // A push that rises and falls has no length that another one takes back.
    let acts = |i: usize| chosen[i].cause.acts(&chosen[i].shape).filter(|_| !swells(&chosen[i].shape));
    let pairs = (0..chosen.len()).flat_map(|long| (0..chosen.len()).map(move |short| (long, short)));
    for (long, needless) in pairs.filter(|(long, short)| long != short) {
        let Some([start, end]) = remainder(acts(long), acts(needless)) else { continue };
        if end - start < BRIEFEST {
            continue;
        }
        let mut without = chosen.to_vec();
        without.remove(needless);
        let mut trial = without.clone();
        let push = &mut trial[long - usize::from(needless < long)];
        (push.shape[0], push.shape[1]) = (start, end);
        let before = tested.fit(&mut without);
        let shorter = tested.fit(&mut trial);
        let gain = |after: &Fitted| {
            white_gain(&before.solution.rss, &after.solution.rss, before.solution.counts.iter().copied())
        };
        if gain(&shorter) >= MOST_OF_IT * gain(fitted) {
            return Some(Shorter { needless, chosen: trial, fitted: shorter });
        }
    }
    None
}

/// The part of one interval that another one, which begins or ends with it, does not have.
fn remainder(one: Option<[f64; 2]>, other: Option<[f64; 2]>) -> Option<[f64; 2]> {
    let ([start, end], [from, to]) = (one?, other?);
    if (end - to).abs() < TOGETHER && from > start + TOGETHER {
        return Some([start, from]);
    }
    ((start - from).abs() < TOGETHER && to < end - TOGETHER).then_some([to, end])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_left_of_an_interval() {
        let rest = |one, other| remainder(Some(one), Some(other));
        assert_eq!(rest([1.0, 3.0], [2.0, 3.01]), Some([1.0, 2.0]));
        assert_eq!(rest([1.0, 3.0], [1.02, 1.5]), Some([1.5, 3.0]));
        for other in [[1.5, 2.5], [1.0, 3.0], [0.5, 3.0], [4.0, 5.0]] {
            assert_eq!(rest([1.0, 3.0], other), None);
        }
        assert_eq!(remainder(None, Some([0.0, 1.0])), None);
    }
}
