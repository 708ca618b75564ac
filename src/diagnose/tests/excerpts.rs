//! Causes sought again in excerpts of the fitted logs.

use std::cell::RefCell;

use super::columns::recording;
use crate::diagnose::excerpts::seek_again;
use crate::diagnose::{Cause, Recording};

fn cause(name: &'static str, joint: usize) -> Cause {
    Cause { joints: vec![joint], probability: 0.9, ..Cause::blank(name, "") }
}

/// A cause in both excerpts keeps its probability; one that an excerpt lacks loses some of what it
/// has beyond one half.
#[test]
fn a_cause_that_an_excerpt_lacks_is_less_likely() {
    let logs = [recording(), recording()];
    let rare = Cause { probability: 0.3, ..cause("torque_offset", 1) };
    let mut causes =
        [cause("payload", 1), cause("joint_spring", 1), cause("joint_spring", 2), cause("unknown", 1), rare];
    let seen = RefCell::new(Vec::new());
    seek_again(&mut causes, &logs, |excerpt, rest| {
        let seconds = |logs: &[Recording]| logs.iter().map(Recording::seconds).sum::<f64>();
        assert!((seconds(excerpt) + seconds(rest) - seconds(&logs)).abs() < 0.02);
        seen.borrow_mut().push(excerpt.iter().map(Recording::seconds).collect::<Vec<f64>>());
        let first = seen.borrow().len() == 1;
        Some([cause("payload", 1)].into_iter().chain(first.then(|| cause("joint_spring", 1))).collect())
    });
    assert_eq!(causes.each_ref().map(|c| c.found_again), [[2, 2], [1, 2], [0, 2], [0, 0], [0, 2]]);
    let [sure, once, never, other, rare] = causes.map(|c| c.probability);
    assert!(sure == 0.9 && other == 0.9 && rare == 0.3, "{sure} {other} {rare}");
    assert!(0.5 < never && never < once && once < 0.8, "{once} {never}");
    // The first six tenths of both recordings, and the last six.
    let (seconds, seen) = (recording().seconds(), seen.into_inner());
    let [first, last] = [&seen[0], &seen[1]];
    assert!((first[0] - seconds).abs() < 0.02 && (first[1] - 0.2 * seconds).abs() < 0.02, "{first:?}");
    assert!((last[0] - 0.2 * seconds).abs() < 0.02 && (last[1] - seconds).abs() < 0.02, "{last:?}");
}

#[test]
fn excerpts_that_are_too_short_say_nothing() {
    let mut causes = [cause("payload", 1)];
    seek_again(&mut causes, &[recording()], |_, _| None);
    assert_eq!((causes[0].found_again, causes[0].probability), ([0, 0], 0.9));
    seek_again(&mut [cause("unknown", 1)], &[recording()], |_, _| panic!("nothing to seek"));
}
