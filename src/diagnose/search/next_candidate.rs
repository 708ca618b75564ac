//! The candidate that is tried next: the one that gains most, or a simpler one in its place that
//! gains nearly as much.

use super::candidate::{Candidate, plain, unknowns};
use crate::diagnose::hypotheses::{Hypothesis as _, Kind, OFFSET, Over};

/// Share of its score by which a candidate with fewer unknowns in the same place may lag behind.
const SIMPLER: f64 = 0.05;

/// The same share for plain friction against a law with memory or of position, which follows any
/// error that reverses with the motion. It also applies to an offset against ripple or a spring,
/// which are nearly constant where a joint hardly moves.
pub(super) const PLAINER: f64 = 0.2;

/// Share of its score by which a candidate may lag behind an equivalent one.
const SAME: f64 = 1e-3;

/// The candidate to try next: the best one, or one in its place with fewer unknowns that gains
/// nearly as much. Plain friction goes first among equivalent causes, such as a level and a
/// difference by direction on a motion in one direction.
pub(super) fn best(ranked: &[Candidate], tried: &[usize]) -> Option<usize> {
    let left = || (0..ranked.len()).filter(|i| !tried.contains(i));
    let first = left().next().filter(|&i| ranked[i].score > 0.0)?;
    let top = &ranked[first];
    let count = |c: &Candidate| unknowns(c.cause, &c.shape, c.gain.x.len());
    let place = |c: &Candidate| c.place == top.place || c.place.is_empty() || top.place.is_empty();
    let follows = top.cause.follows_reversals();
    let level = top.cause.over() == Over::Position && top.cause.kind() == Kind::Transmission;
    let near = |c: &Candidate| {
        let friction = c.cause.kind() == Kind::Friction && plain(c).is_some();
        let offset = c.cause.effect() == OFFSET.effect();
        let lag = if follows && friction || level && offset { PLAINER } else { SIMPLER };
        c.score > (1.0 - lag) * top.score
    };
    let same = |c: &Candidate| plain(c).is_some() && count(c) <= count(top) && c.score > (1.0 - SAME) * top.score;
    let simpler = |c: &Candidate| place(c) && (count(c) < count(top) && near(c) || same(c));
    let fewest = |a: &usize, b: &usize| {
        let [a, b] = [&ranked[*a], &ranked[*b]];
        let plainer = plain(b).is_some().cmp(&plain(a).is_some());
        count(a).total_cmp(&count(b)).then(plainer).then(b.score.total_cmp(&a.score))
    };
    Some(left().filter(|&i| simpler(&ranked[i])).min_by(fewest).unwrap_or(first))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnose::fit::moments::Gain;
    use crate::diagnose::hypotheses::by_name;

    fn candidate(name: &str, joint: usize, score: f64) -> Candidate {
        let gain = Gain { x: vec![1.0], rss: Vec::new() };
        Candidate { cause: by_name(name).unwrap(), place: vec![joint], shape: Vec::new(), gain, score }
    }

    /// Of equivalent causes of a joint, the level of plain friction is tried first.
    #[test]
    fn plain_friction_goes_first_among_equivalent_causes() {
        let of = |level: &str, joint: usize, score: f64| {
            best(&[candidate("torque_gain_error", 2, 1000.0), candidate(level, joint, score)], &[])
        };
        assert_eq!(of("viscous_friction", 2, 999.5), Some(1));
        assert_eq!(of("viscous_friction", 2, 990.0), Some(0));
        assert_eq!(of("viscous_friction", 1, 999.5), Some(0));
        // Each is tried once.
        assert_eq!(best(&[candidate("torque_gain_error", 2, 1000.0)], &[0]), None);
        assert_eq!(best(&[candidate("torque_gain_error", 2, -1.0)], &[]), None);
    }
}
