//! Summary figures of a battery of cases.

use super::case::{CaseKind, Outcome};
use super::hidden::Hidden;
use crate::apps::paper::Tally;
use crate::diagnose::{Cause, Verdict};

/// A cause named by a diagnosis, and whether it was hidden there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Claim {
    /// Probability stated by the diagnosis.
    pub probability: f64,
    /// Whether it is one of the hidden ones, at its place.
    pub right: bool,
}

/// Summary figures.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Scores {
    /// One effect hidden: cases with the right cause first.
    pub first: Tally,
    /// The same, but the hidden cause may also be listed as not distinguished from the first,
    /// provided that the extended model leaves only noise.
    pub first_or_named: Tally,
    /// Share at the right place, of cases with the right cause first.
    pub place: Tally,
    /// Two effects hidden: cases with both among the causes, at their places.
    pub both: Tally,
    /// Nothing hidden: cases with a cause named.
    pub false_alarms: Tally,
    /// Structure outside the vocabulary: cases with `unknown` first, or with no cause while the
    /// verdict reports remaining structure.
    pub outside: Tally,
    /// Wrong causes beside the right ones, per case with an effect of the vocabulary hidden.
    pub beside: f64,
    /// Attained share of the possible gain on the validating log, mean over cases with a hidden
    /// effect of the vocabulary. It is the RMS removed, relative to the RMS above the file's error
    /// without hidden effects, on the joint with the largest error, where it moves.
    pub gain: f64,
    /// The same share over all samples.
    pub gain_of_all: f64,
    /// Cases that attain nine tenths of the possible gain where the joint moves.
    pub gained: Tally,
    /// Parameters of correctly named causes within three of their standard deviations.
    pub within_three: Tally,
    /// For each kind of hidden content: how often each answer came first, most frequent first.
    pub confusion: Vec<(String, Vec<(&'static str, usize)>)>,
    /// Every cause named, for the reliability of probabilities.
    pub claims: Vec<Claim>,
}

/// Answer of a diagnosis in one word.
pub fn answer(outcome: &Outcome) -> &'static str {
    match outcome.found.causes.first() {
        Some(cause) => cause.cause,
        None if outcome.found.verdict == Verdict::Unexplained => "unknown",
        None => "nothing_wrong",
    }
}

fn same_place(cause: &Cause, hidden: &Hidden) -> bool {
    let mut found = cause.joints.clone();
    let mut asked = hidden.joints.clone();
    found.sort_unstable();
    asked.sort_unstable();
    found == asked
}

fn same(cause: &Cause, hidden: &Hidden) -> bool {
    cause.cause == hidden.cause && same_place(cause, hidden)
}

/// Whether the extended model leaves only noise on the validating log.
fn only_noise(outcome: &Outcome) -> bool {
    outcome.found.extended.moving.iter().zip(&outcome.attainable[1]).all(|(e, s)| *e < 1.1 * s)
}

/// Attained share of the possible gain on the joint with the largest error; `None` if there is
/// none.
fn gained(before: &[f64], after: &[f64], attainable: &[f64]) -> Option<f64> {
    let above = |j: &usize| before[*j] / attainable[*j].max(1e-12);
    let j = (0..before.len()).max_by(|a, b| above(a).total_cmp(&above(b)))?;
    (above(&j) > 1.2).then(|| (before[j] - after[j]) / (before[j] - attainable[j]))
}

impl Outcome {
    /// Label of the hidden content.
    pub fn label(&self) -> String {
        match self.task {
            CaseKind::Nothing => "nothing_wrong".into(),
            CaseKind::One(wanted) => wanted.to_string(),
            CaseKind::NoLinks(name) => format!("{name}, no links in the file"),
            CaseKind::OneJoint(_) => "two effects, one joint".into(),
            CaseKind::TwoJoints(_) => "two effects, two joints".into(),
            CaseKind::WrongLinks(_) => "friction law and wrong link".into(),
            CaseKind::Outside(0) => "outside: a tone".into(),
            CaseKind::Outside(1) => "outside: cross talk".into(),
            CaseKind::Outside(_) => "outside: zero wanders".into(),
        }
    }

    /// Whether the first cause is the hidden one.
    pub fn right(&self) -> bool {
        match (self.task, self.hidden.first()) {
            (CaseKind::Nothing, _) => answer(self) == "nothing_wrong",
            (_, Some(hidden)) => answer(self) == hidden.cause,
            _ => false,
        }
    }

    /// The same, but the hidden cause may be listed as not distinguished from the first if only
    /// noise is left.
    pub fn right_or_named(&self) -> bool {
        let (Some(first), Some(hidden)) = (self.found.causes.first(), self.hidden.first()) else { return self.right() };
        self.right() || first.not_distinguished_from.contains(&hidden.cause) && only_noise(self)
    }

    /// Whether all hidden effects are named, at their places.
    pub fn complete(&self) -> bool {
        self.hidden.iter().all(|h| self.found.causes.iter().any(|c| same(c, h)))
    }

    /// Success criterion of the case: the right cause first; all of them if several are hidden.
    pub fn good(&self) -> bool {
        if self.hidden.len() > 1 { self.complete() } else { self.right() && self.complete() }
    }

    /// Whether a named cause was hidden.
    pub fn holds(&self, cause: &Cause) -> bool {
        self.hidden.iter().any(|h| if h.cause == "unknown" { cause.cause == "unknown" } else { same(cause, h) })
    }

    /// Attained share of the possible gain where the joint moves; `None` if there is none.
    pub fn gain(&self) -> Option<f64> {
        gained(&self.found.baseline.moving, &self.found.extended.moving, &self.attainable[1])
    }

    /// The same share over all samples: friction during stiction counts too, and the hidden effect
    /// may have prolonged the stiction.
    pub fn gain_of_all(&self) -> Option<f64> {
        gained(&self.found.baseline.validate, &self.found.extended.validate, &self.attainable[0])
    }

    /// Parameters of correctly named causes: symbol, truth, value, standard deviation.
    pub fn parameters(&self) -> Vec<(String, f64, f64, f64)> {
        let mut all = Vec::new();
        for hidden in &self.hidden {
            let Some(cause) = self.found.causes.iter().find(|c| same(c, hidden)) else { continue };
            for (symbol, truth) in &hidden.truth {
                let Some(p) = cause.parameters.iter().find(|p| p.symbol == *symbol) else { continue };
                if let Some(std) = p.std.filter(|s| s.is_finite() && *s > 0.0) {
                    all.push((symbol.clone(), *truth, p.value, std));
                }
            }
        }
        all
    }
}

impl Scores {
    pub(super) fn of(outcomes: &[Outcome]) -> Self {
        let mut scores = Self::default();
        let (mut gains, mut of_all, mut beside, mut with) = (Vec::new(), Vec::new(), 0, 0);
        for o in outcomes {
            match o.task {
                CaseKind::Nothing => scores.false_alarms.count(!o.right()),
                CaseKind::Outside(_) => scores.outside.count(answer(o) == "unknown"),
                CaseKind::One(_) | CaseKind::NoLinks(_) => {
                    scores.first.count(o.right());
                    scores.first_or_named.count(o.right_or_named());
                    if let (true, Some(c), Some(h)) = (o.right(), o.found.causes.first(), o.hidden.first()) {
                        scores.place.count(same_place(c, h));
                    }
                }
                CaseKind::OneJoint(_) | CaseKind::TwoJoints(_) | CaseKind::WrongLinks(_) => {
                    scores.both.count(o.complete())
                }
            }
            if !matches!(o.task, CaseKind::Nothing | CaseKind::Outside(_)) {
                with += 1;
                beside += o.found.causes.iter().filter(|c| !o.holds(c)).count();
                of_all.extend(o.gain_of_all());
                if let Some(gain) = o.gain() {
                    gains.push(gain);
                    scores.gained.count(gain >= 0.9);
                }
            }
            for (_, truth, value, std) in o.parameters() {
                scores.within_three.count((value - truth).abs() <= 3.0 * std);
            }
            let label = o.label();
            let row = match scores.confusion.iter_mut().position(|(l, _)| *l == label) {
                Some(at) => &mut scores.confusion[at].1,
                None => {
                    scores.confusion.push((label, Vec::new()));
                    let last = scores.confusion.len() - 1;
                    &mut scores.confusion[last].1
                }
            };
            match row.iter_mut().find(|(word, _)| *word == answer(o)) {
                Some(cell) => cell.1 += 1,
                None => row.push((answer(o), 1)),
            }
            scores
                .claims
                .extend(o.found.causes.iter().map(|c| Claim { probability: c.probability, right: o.holds(c) }));
        }
        for (_, row) in &mut scores.confusion {
            row.sort_by(|a, b| b.1.cmp(&a.1).then(a.0.cmp(b.0)));
        }
        let mean = |x: &[f64]| x.iter().sum::<f64>() / x.len().max(1) as f64;
        (scores.gain, scores.gain_of_all) = (mean(&gains), mean(&of_all));
        scores.beside = f64::from(beside as u32) / f64::from((with as u32).max(1));
        scores
    }

    /// Claims binned by probability: lower and upper edge, mean probability, number that were
    /// right.
    pub fn reliability(&self) -> Vec<(f64, f64, f64, Tally)> {
        binned(&self.claims, &[0.0, 0.5, 0.7, 0.85, 0.93, 0.98, 1.0])
    }
}

/// Claims binned by probability between neighbouring `edges`, the last of which is 1; bins without
/// a claim are left out.
pub(super) fn binned(claims: &[Claim], edges: &[f64]) -> Vec<(f64, f64, f64, Tally)> {
    let bin = |edge: &[f64]| {
        let here = |c: &&Claim| c.probability >= edge[0] && (c.probability < edge[1] || edge[1] == 1.0);
        let mut right = Tally::default();
        let mut sum = 0.0;
        for claim in claims.iter().filter(here) {
            right.count(claim.right);
            sum += claim.probability;
        }
        (right.all > 0).then(|| (edge[0], edge[1], sum / right.all as f64, right))
    };
    edges.windows(2).filter_map(bin).collect()
}
