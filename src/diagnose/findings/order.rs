//! Sorts causes by the error that they remove, weighted by their odds.

use dh_codegen::robot::effects;

use super::attribution::taken;
use super::result::Cause;

/// Probability above which a larger value does not move a cause forward.
const SURE: f64 = 0.99;

/// Sorts causes by gain times odds, largest first. A cause that removes twice the error of another
/// comes after it if the other's odds are more than twice its own. Values of links come after
/// errors of the robot as a whole.
pub(in crate::diagnose) fn in_order(causes: &mut Vec<Cause>, scale: &[f64]) {
    let odds = |c: &Cause| c.probability.min(SURE) / (1.0 - c.probability.min(SURE));
    let weighed = |c: &Cause| odds(c) * taken(c, scale);
    causes.sort_by(|a, b| weighed(b).total_cmp(&weighed(a)));
    values_last(causes, scale);
}

/// Places errors that no link parameter explains before link parameters. Condition: they explain
/// half of the squared error of a joint, or a quarter of that of all joints. Such an error belongs
/// to the recording or the arm as a whole, whatever the file contains. If all parameters were
/// refitted by default, this applies to every cause.
fn values_last(causes: &mut Vec<Cause>, noise: &[f64]) {
    let Some(at) = causes.iter().position(|c| c.cause == effects::LinkInertiaError::NAME) else { return };
    let refitted = causes[at].keys.is_empty();
    let structure = |c: &Cause| {
        let joints = c.rms_before.iter().zip(&c.rms_after).zip(noise);
        let shares: Vec<f64> = joints.map(|((b, a), s)| (b * b - a * a) / (b * b + s * s).max(1e-24)).collect();
        let most = shares.iter().copied().fold(0.0, f64::max);
        most > 0.5 || shares.iter().sum::<f64>() > 0.25 * shares.len() as f64
    };
    let value = |c: &Cause| [effects::LinkInertiaError::NAME, effects::Payload::NAME, "unknown"].contains(&c.cause);
    let tail = causes.split_off(at);
    let (first, rest): (Vec<Cause>, Vec<Cause>) =
        tail.into_iter().partition(|c| !value(c) && (refitted || c.joints.is_empty()) && structure(c));
    causes.extend(first);
    causes.extend(rest);
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A cause that reduces the error of the only joint, 1 N m, to `left`.
    fn cause(cause: &'static str, joints: &[usize], probability: f64, left: f64) -> Cause {
        let rms = |x: f64| vec![x];
        Cause {
            joints: joints.to_vec(),
            probability,
            rms_before: rms(1.0),
            rms_after: rms(left),
            ..Cause::blank(cause, "")
        }
    }

    fn names(mut causes: Vec<Cause>) -> Vec<&'static str> {
        in_order(&mut causes, &[0.01]);
        causes.iter().map(|c| c.cause).collect()
    }

    #[test]
    fn a_sure_cause_comes_before_a_doubtful_one_that_takes_more() {
        let doubtful = || cause("torque_ripple", &[1], 0.4, 0.2);
        assert_eq!(names(vec![doubtful(), cause("backlash", &[1], 0.9, 0.7)]), ["backlash", "torque_ripple"]);
        // A negligible error stays last.
        assert_eq!(names(vec![cause("backlash", &[1], 0.9, 0.99), doubtful()]), ["torque_ripple", "backlash"]);
        // Of two practically certain causes, the larger one is first.
        let sure = [cause("backlash", &[1], 1.0, 0.9), cause("stribeck_friction", &[1], 0.99, 0.2)];
        assert_eq!(names(sure.to_vec()), ["stribeck_friction", "backlash"]);
    }

    /// A delay of the recording explains half of a joint's error, whatever the file's links are.
    #[test]
    fn values_of_links_come_after_errors_of_the_whole() {
        let link = || cause("link_inertia_error", &[1], 0.95, 0.1);
        assert_eq!(names(vec![link(), cause("time_delay", &[], 0.6, 0.5)]), ["time_delay", "link_inertia_error"]);
        assert_eq!(names(vec![link(), cause("time_delay", &[], 0.6, 0.9)]), ["link_inertia_error", "time_delay"]);
        assert_eq!(names(vec![link(), cause("payload", &[], 0.6, 0.1)]), ["link_inertia_error", "payload"]);
    }
}
