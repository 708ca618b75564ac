//! Whether the bands of a log can be relied upon: one verdict of all checks.

use super::consistency::Consistency;
use super::uncertainty::NoiseSource;

/// Of the bands of a log.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Verdict {
    /// Every check that could be made agrees with the predicted covariance.
    Hold {
        /// Least probability of errors as large as those of a check, for a model that errs as
        /// predicted.
        probability: f64,
    },
    /// No check failed, but errors are larger than a right model's commonly are.
    Doubtful {
        /// Least probability of errors as large as those of a check, for a model that errs as
        /// predicted.
        probability: f64,
        /// Errors of that check by their prediction (root mean square): a factor for the bands.
        widen: f64,
    },
    /// A check failed: bands are too narrow.
    TooWrong {
        /// Factor by which bands would have to be wider: the largest of all failed checks.
        widen: f64,
        /// Joint whose errors exceed their prediction most, from 1, with the factor; `None` if no
        /// check separates the joints.
        joint: Option<(usize, f64)>,
    },
    /// The noise was taken from the samples that would have to judge it.
    Circular,
    /// There is nothing to judge with: no stretch is known to be free of contact, and the arm has
    /// no spare joint.
    #[default]
    NotJudged,
}

impl Verdict {
    /// Of torque errors where nothing touches, and of those that no wrench explains (arms with more
    /// than six joints).
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
        // The part that no wrench explains is judged by the same noise.
        let least = checks.into_iter().min_by(|a, b| a.probability.total_cmp(&b.probability));
        match (circular, least) {
            (true, _) => Self::Circular,
            (false, Some(c)) if c.is_common() => Self::Hold { probability: c.probability },
            (false, Some(c)) => Self::Doubtful { probability: c.probability, widen: c.widen() },
            (false, None) => Self::NotJudged,
        }
    }

    /// Whether bands are too narrow.
    pub fn is_too_wrong(&self) -> bool {
        matches!(self, Self::TooWrong { .. })
    }

    /// Whether bands are in doubt.
    pub fn is_doubtful(&self) -> bool {
        matches!(self, Self::Doubtful { .. })
    }

    /// The one that says least good of several logs.
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

    /// One failed check is enough, whichever it is.
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
        // Errors that a right model makes in one run of two hundred are no reason to rely on it.
        let rare = check(4.0, 0.0046, &[1.0, 2.0]);
        let doubtful = Verdict::Doubtful { probability: 0.0046, widen: 2.0 };
        assert_eq!(Verdict::of(Some(&good), Some(&rare), known), doubtful);
        assert_eq!(Verdict::of(Some(&rare), None, known), doubtful);
        // Noise that was taken from the free stretch can't judge itself, but a model that the spare
        // joint contradicts is wrong all the same.
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
