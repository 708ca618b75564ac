//! Gains and losses of a change of the model over all joints.

/// Factor by which the gain of a body on some joints must exceed its loss on others.
const WHOLE: f64 = 2.0;

/// Whether a body with these gains (shares of the joints' squared errors) pays over all joints. It
/// acts on every joint, beside errors that each joint has of its own.
pub(super) fn pays_as_a_whole(shares: &[f64]) -> bool {
    let gains = || shares.iter().map(|share| -(1.0 - share).max(1e-3).ln());
    let (won, lost): (f64, f64) = (gains().map(|g| g.max(0.0)).sum(), gains().map(|g| (-g).max(0.0)).sum());
    won > WHOLE * lost
}

/// Whether what a change of the joints' errors, N m, wins over all joints outweighs what it loses.
/// Errors below `scale`, N m, do not count.
pub(in crate::diagnose) fn pays_over_all(before: &[f64], after: &[f64], scale: &[f64]) -> bool {
    let square = |error: &f64, s: &f64| (error * error + s * s).max(1e-24);
    let share = |((b, a), s): ((&f64, &f64), &f64)| 1.0 - square(a, s) / square(b, s);
    pays_as_a_whole(&before.iter().zip(after).zip(scale).map(share).collect::<Vec<f64>>())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Errors of a KUKA LWR 4+ without and with a payload: three joints improve, one errs more,
    /// because another error had cancelled a part of it.
    #[test]
    fn a_cause_that_pays_over_all_joints_is_not_removed() {
        let scale = [0.023, 0.546, 0.057, 0.210, 0.025, 0.012, 0.004];
        let without = [0.292, 0.460, 0.298, 0.338, 0.251, 0.104, 0.027];
        let with = [0.289, 0.289, 0.342, 0.203, 0.250, 0.084, 0.024];
        assert!(pays_over_all(&without, &with, &scale) && !pays_over_all(&with, &without, &scale));
        // What improves nothing, or loses more than half of what it wins, does not pay.
        assert!(!pays_over_all(&without, &without, &scale));
        let worse = [0.292, 0.460, 0.398, 0.238, 0.251, 0.104, 0.027];
        assert!(!pays_over_all(&without, &worse, &scale));
        assert!(!pays_over_all(&[1.0], &[2.0], &[10.0]) && !pays_over_all(&[0.0], &[0.0], &[0.0]));
    }

    #[test]
    fn a_body_may_spoil_a_joint_for_what_it_gains_on_the_others() {
        assert!(pays_as_a_whole(&[0.4, 0.5, -0.36, 0.3]));
        assert!(!pays_as_a_whole(&[0.4, -0.36, 0.0]) && !pays_as_a_whole(&[0.9, -2.5]));
        assert!(!pays_as_a_whole(&[0.0, 0.0]));
    }

    /// A joint that errs ten times as much counts with the whole of it.
    #[test]
    fn what_is_gained_on_some_joints_does_not_make_up_for_one_that_is_lost() {
        let (without, with) = ([1.0, 1.0, 1.0, 1.0], [10.0, 0.5, 0.5, 0.5]);
        assert!(!pays_over_all(&without, &with, &[0.0; 4]));
        assert!(pays_over_all(&without, &[1.2, 0.5, 0.5, 0.5], &[0.0; 4]));
    }
}
