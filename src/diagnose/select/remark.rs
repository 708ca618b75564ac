//! Sentences on the choice of the model, and on causes that it lacks.

use crate::diagnose::findings::reported_cause::place_of;
use crate::diagnose::findings::result::Cause;

/// A sentence on the offered model, or on a cause that it lacks.
#[derive(Debug, Clone)]
pub(in crate::diagnose) struct Remark {
    text: String,
    /// The cause and its joints, from 0.
    on: Option<(&'static str, Vec<usize>)>,
}

impl From<String> for Remark {
    fn from(text: String) -> Self {
        Self { text, on: None }
    }
}

impl Remark {
    /// A sentence whose subject is a cause at joints (from 0), with its predicate.
    pub(in crate::diagnose) fn on(cause: &'static str, place: &[usize], predicate: &str) -> Self {
        Self { text: format!("{cause} {} {predicate}", place_of(place)), on: Some((cause, place.to_vec())) }
    }
}

/// The sentences to report beside `causes`. Of several on one cause, which was weighed in several
/// models or with several shapes, the last one; none on a cause that is reported.
pub(in crate::diagnose) fn said_beside(causes: &[Cause], remarks: &[Remark]) -> Vec<String> {
    let reported = |(name, place): &(&'static str, Vec<usize>)| {
        causes.iter().any(|c| c.cause == *name && c.joints.iter().map(|j| j - 1).eq(place.iter().copied()))
    };
    let kept = |(at, remark): (usize, &Remark)| {
        let again = || remarks[at + 1..].iter().any(|later| later.on == remark.on);
        remark.on.as_ref().is_none_or(|on| !reported(on) && !again()).then(|| remark.text.clone())
    };
    remarks.iter().enumerate().filter_map(kept).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cause_is_rejected_once_and_not_beside_itself() {
        let ripple = |predicate| Remark::on("torque_ripple", &[4], predicate);
        let remarks = [
            ripple("is not named: 0.1."),
            Remark::on("payload", &[6], "is not named."),
            "The refit is offered.".to_string().into(),
            ripple("is not named: 0.2."),
        ];
        let named = Cause { joints: vec![7], ..Cause::blank("payload", "") };
        assert_eq!(
            said_beside(&[named], &remarks),
            ["The refit is offered.", "torque_ripple of joint 5 is not named: 0.2."]
        );
    }
}
