//! Overall verdict of all checks: whether the bands of a log can be relied upon.

use super::consistency::Consistency;
use super::uncertainty::NoiseSource;

/// Verdict on the bands of a log.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Verdict {
    /// Every check that could be made agrees with the predicted covariance.
    Hold {
        /// Lowest probability, over the checks, of errors at least this large for a model that errs
        /// as predicted.
        probability: f64,
    },
    /// No check failed, but the errors are larger than a correct model's usually are.
    Doubtful {
        /// Lowest probability, over the checks, of errors at least this large for a model that errs
        /// as predicted.
        probability: f64,
        /// Root mean square of that check's errors relative to prediction: a factor for the bands.
        widen: f64,
    },
    /// A check failed: the bands are too narrow.
    TooWrong {
        /// Factor by which the bands would have to be wider: the largest over all failed checks.
        widen: f64,
        /// Joint, from 1, whose errors exceed their prediction most, with the factor; `None` if no
        /// check separates the joints.
        joint: Option<(usize, f64)>,
    },
    /// The noise was taken from the same samples that would have to check it.
    Circular,
    /// No check is possible: no stretch is known to be free of contact, and the arm has no
    /// redundant joint.
    #[default]
    NotJudged,
}

impl Verdict {
    /// Combines the consistency of the torque errors without contact and of those that no wrench
    /// explains (arms with more than six joints).
    pub(super) fn of(free: Option<&Consistency>, unexplained: Option<&Consistency>, source: NoiseSource) -> Self {
        let circular = source == NoiseSource::Free && free.is_some();
        let checks: Vec<&Consistency> = free.filter(|_| !circular).into_iter().chain(unexplained).collect();
        let failed = checks.iter().filter(|c| !c.holds()).map(|c| c.widen());
        if let Some(widen) = failed.reduce(f64::max) {
            let worst = |c: &&Consistency| {
                let (joint, factor) = c.joints.iter().copied().enumerate().max_by(|a, b| a.1.total_cmp(&b.1))?;
                (factor > 0.0).then_some((joint + 1, factor))
            };
            return Self::TooWrong { widen, joint: checks.iter().filter(|c| !c.holds()).find_map(worst) };
        }
        // The part that no wrench explains is judged with the same noise.
        let least = checks.into_iter().min_by(|a, b| a.probability.total_cmp(&b.probability));
        match (circular, least) {
            (true, _) => Self::Circular,
            (false, Some(c)) if c.is_common() => Self::Hold { probability: c.probability },
            (false, Some(c)) => Self::Doubtful { probability: c.probability, widen: c.widen() },
            (false, None) => Self::NotJudged,
        }
    }

    /// Whether the bands are too narrow.
    pub fn is_too_wrong(&self) -> bool {
        matches!(self, Self::TooWrong { .. })
    }

    /// Whether the bands are in doubt.
    pub fn is_doubtful(&self) -> bool {
        matches!(self, Self::Doubtful { .. })
    }

    /// The worst verdict over several logs; `None` if there are none.
    pub fn worst<'a>(all: impl Iterator<Item = &'a Self>) -> Option<&'a Self> {
        let rank = |v: &Self| match v {
            Self::TooWrong { widen, .. } => (4, *widen),
            Self::Circular => (3, 0.0),
            Self::NotJudged => (2, 0.0),
            Self::Doubtful { probability, .. } => (1, -probability),
            Self::Hold { probability } => (0, -probability),
        };
        all.max_by(|a, b| rank(a).0.cmp(&rank(b).0).then(rank(a).1.total_cmp(&rank(b).1)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(ratio: f64, probability: f64, joints: &[f64]) -> Consistency {
        Consistency { instants: 50, ratio, probability, joints: joints.to_vec() }
    }

    /// One failed check suffices, whichever it is.
    #[test]
    fn one_verdict_of_all_checks() {
        let good = check(1.0, 0.4, &[1.0, 0.9]);
        let bad = check(9.0, 1e-6, &[0.0, 0.0]);
        let known = NoiseSource::Identification;
        assert_eq!(Verdict::of(Some(&good), None, known), Verdict::Hold { probability: 0.4 });
        assert_eq!(Verdict::of(Some(&good), Some(&bad), known), Verdict::TooWrong { widen: 3.0, joint: None });
        let worst = Verdict::TooWrong { widen: 3.0, joint: Some((2, 4.0)) };
        assert_eq!(Verdict::of(Some(&check(9.0, 1e-6, &[1.0, 4.0])), Some(&good), known), worst);
        assert_eq!(Verdict::of(None, None, known), Verdict::NotJudged);
        // Errors that a correct model makes in one run of two hundred do not support relying on it.
        let rare = check(4.0, 0.0046, &[1.0, 2.0]);
        let doubtful = Verdict::Doubtful { probability: 0.0046, widen: 2.0 };
        assert_eq!(Verdict::of(Some(&good), Some(&rare), known), doubtful);
        assert_eq!(Verdict::of(Some(&rare), None, known), doubtful);
        // Noise taken from the free stretch cannot check itself, but a model that the redundant
        // joint contradicts is still wrong.
        assert_eq!(Verdict::of(Some(&bad), Some(&good), NoiseSource::Free), Verdict::Circular);
        assert!(Verdict::of(Some(&good), Some(&bad), NoiseSource::Free).is_too_wrong());
    }

    #[test]
    fn the_worst_of_several_logs() {
        let hold = |probability| Verdict::Hold { probability };
        let wrong = |widen| Verdict::TooWrong { widen, joint: None };
        let all = [hold(0.5), wrong(1.5), hold(0.1), wrong(2.5), Verdict::NotJudged];
        assert_eq!(Verdict::worst(all.iter()), Some(&all[3]));
        assert_eq!(Verdict::worst([hold(0.5), hold(0.1)].iter()), Some(&hold(0.1)));
        let doubtful = Verdict::Doubtful { probability: 0.01, widen: 2.0 };
        assert_eq!(Verdict::worst([hold(0.5), doubtful].iter()), Some(&doubtful));
        assert_eq!(Verdict::worst([].iter()), None);
    }
}
