//! Evidence for plain friction of drives that are diagnosed without bodies.
//!
//! Beside a robot's bodies a friction level absorbs a part of the error of a wrong link, so it must
//! be found by the search from the file. A gear alone has no links. A term without which the rest
//! does not predict its joint has changed.

use crate::diagnose::fit::model::{Chosen, Fitted, ModelUnderTest};
use crate::diagnose::hypotheses::{Hypothesis as _, PLAIN};
use crate::diagnose::search::forward::Evidence;

/// Evidence for each plain term that is fitted and reported: the share of its joint's squared error
/// that it removes beside all others. `fitted` is the model with all of them.
pub(super) fn evidence(tested: &mut ModelUnderTest<'_>, chosen: &[Chosen], fitted: &Fitted) -> Vec<Evidence> {
    let mut found = Vec::new();
    for k in (0..tested.frozen.len()).filter(|&k| !tested.frozen[k] && !tested.quiet[k]).collect::<Vec<_>>() {
        let joint = k / 3;
        tested.frozen[k] = true;
        let without = tested.fit(&mut chosen.to_vec());
        tested.frozen[k] = false;
        let [with, without] = [fitted, &without].map(|f| f.solution.rss[joint]);
        let share = if without > 0.0 { 1.0 - with / without } else { 0.0 };
        found.push(Evidence {
            effect: PLAIN[k % 3].effect(),
            place: vec![joint],
            shape: Vec::new(),
            local: false,
            share,
        });
    }
    tested.update_model(fitted);
    found
}
