//! Sentences on the choice of the model, and on causes that it lacks.

use crate::diagnose::findings::reported_cause::place_of;
use crate::diagnose::findings::result::{Cause, Rejected};

/// A sentence on the offered model, or on a cause that it lacks.
#[derive(Debug, Clone)]
pub(in crate::diagnose) struct Remark {
    text: String,
    on: Option<On>,
}

/// What a sentence is about.
#[derive(Debug, Clone)]
struct On {
    cause: &'static str,
    /// Joints, from 0.
    place: Vec<usize>,
    predicate: String,
    probability: Option<f64>,
}

impl On {
    fn same(&self, other: &Self) -> bool {
        self.cause == other.cause && self.place == other.place
    }

    fn joints(&self) -> Vec<usize> {
        self.place.iter().map(|j| j + 1).collect()
    }
}

impl From<String> for Remark {
    fn from(text: String) -> Self {
        Self { text, on: None }
    }
}

impl Remark {
    /// A sentence whose subject is a cause at joints (from 0), with its predicate.
    pub(in crate::diagnose) fn on(cause: &'static str, place: &[usize], predicate: &str) -> Self {
        let on = On { cause, place: place.to_vec(), predicate: predicate.into(), probability: None };
        Self { text: format!("{cause} {} {predicate}", place_of(place)), on: Some(on) }
    }

    /// The same for a cause with this probability.
    pub(in crate::diagnose) fn with_probability(mut self, probability: f64) -> Self {
        if let Some(on) = &mut self.on {
            on.probability = Some(probability);
        }
        self
    }
}

/// The remarks to report beside `causes`. Of several on one cause, which was weighed in several
/// models or with several shapes, the last one; none on a cause that is reported.
fn beside<'r>(causes: &'r [Cause], remarks: &'r [Remark]) -> impl Iterator<Item = &'r Remark> {
    let reported = |on: &On| causes.iter().any(|c| c.cause == on.cause && c.joints == on.joints());
    let again = |at: usize, on: &On| remarks[at + 1..].iter().any(|r| r.on.as_ref().is_some_and(|o| o.same(on)));
    let kept = move |(at, remark): &(usize, &Remark)| match &remark.on {
        Some(on) => !reported(on) && !again(*at, on),
        None => true,
    };
    remarks.iter().enumerate().filter(kept).map(|(_, remark)| remark)
}

/// The sentences to report beside `causes`, and the causes that were found and are not among these,
/// the likeliest first.
pub(in crate::diagnose) fn said_beside(causes: &[Cause], remarks: &[Remark]) -> (Vec<String>, Vec<Rejected>) {
    let of = |remark: &Remark| {
        let on = remark.on.as_ref()?;
        let why = on.predicate.clone();
        Some(Rejected { cause: on.cause, joints: on.joints(), probability: on.probability, why })
    };
    let mut found: Vec<Rejected> = beside(causes, remarks).filter_map(of).collect();
    let likely = |r: &Rejected| r.probability.unwrap_or(-1.0);
    found.sort_by(|a, b| likely(b).total_cmp(&likely(a)));
    (beside(causes, remarks).map(|remark| remark.text.clone()).collect(), found)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cause_is_rejected_once_and_not_beside_itself() {
        let ripple = |predicate| Remark::on("torque_ripple", &[4], predicate);
        let link = Remark::on("link_inertia_error", &[2], "is not in the model.");
        let remarks = [
            ripple("is not named: 0.1."),
            Remark::on("payload", &[6], "is not named."),
            "The refit is offered.".to_string().into(),
            ripple("is not named: 0.2.").with_probability(0.2),
            link,
            Remark::on("joint_spring", &[1], "is not named: 0.4.").with_probability(0.4),
        ];
        let named = Cause { joints: vec![7], ..Cause::blank("payload", "") };
        let (said, rejected) = said_beside(&[named], &remarks);
        assert_eq!(
            said,
            [
                "The refit is offered.",
                "torque_ripple of joint 5 is not named: 0.2.",
                "link_inertia_error of joint 3 is not in the model.",
                "joint_spring of joint 2 is not named: 0.4.",
            ]
        );
        let found: Vec<_> = rejected.iter().map(|r| (r.cause, &r.joints[..], r.probability)).collect();
        let expected: [(&str, &[usize], Option<f64>); 3] =
            [("joint_spring", &[2], Some(0.4)), ("torque_ripple", &[5], Some(0.2)), ("link_inertia_error", &[3], None)];
        assert_eq!(found, expected);
        assert_eq!(rejected[1].why, "is not named: 0.2.");
    }
}
