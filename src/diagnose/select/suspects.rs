//! Suspects: the probabilities of causes beside everything else that was found.
//!
//! A model is reduced until each of its causes is likely and it pays as a whole. A removed cause
//! leaves its share of the error to the others, which then seem to explain less. Each cause
//! therefore keeps the probability that it has beside all others. A model that is not offered is
//! still evidence: refitted links may hide what the file's links show, and vice versa.

use crate::diagnose::findings::calibration;
use crate::diagnose::findings::result::Cause;
use crate::diagnose::select::measure::Measured;
use dh_codegen::robot::effects;

/// Keeps the largest probability of each known cause, and adds new ones.
pub(in crate::diagnose) fn remember<'c>(known: &mut Vec<Cause>, causes: impl IntoIterator<Item = &'c Cause>) {
    for cause in causes {
        match known.iter_mut().find(|k| k.is(cause)) {
            Some(k) if k.probability < cause.probability => *k = cause.clone(),
            Some(_) => {}
            None => known.push(cause.clone()),
        }
    }
}

/// Raises the probability of causes to the value that they had beside everything else.
pub(in crate::diagnose) fn raise(causes: &mut [Cause], known: &[Cause]) {
    for cause in causes {
        let before = known.iter().filter(|k| k.is(cause)).map(|k| k.probability);
        cause.probability = before.fold(cause.probability, f64::max);
    }
}

/// Adds the causes of a round that did not fail (`failed` by index) to the suspects, and raises all
/// causes of the round to their largest probability.
pub(in crate::diagnose) fn beside_the_rest(suspects: &mut Vec<Cause>, causes: &mut [Cause], failed: &[usize]) {
    remember(suspects, causes.iter().enumerate().filter(|(i, _)| !failed.contains(i)).map(|(_, cause)| cause));
    raise(causes, suspects);
}

/// Refitted links that are likelier than any body beside the file's links. One body that is
/// likelier explains the same with fewer causes.
pub(in crate::diagnose) fn likelier(links: Vec<Cause>, suspects: &[Cause]) -> Vec<Cause> {
    let body = |c: &&Cause| [effects::Payload::NAME, effects::LinkInertiaError::NAME].contains(&c.cause);
    let likeliest = suspects.iter().filter(body).map(|c| c.probability).fold(0.0, f64::max);
    links.into_iter().filter(|c| c.probability > likeliest).collect()
}

/// Drops suspected pushes where the offered model leaves no larger error than elsewhere on the
/// fitted logs (`after_fit`): they were errors of a model that lacks its causes. Those that are
/// `shown` nevertheless stay.
pub(in crate::diagnose) fn not_explained(
    suspects: Vec<Cause>,
    after_fit: &Measured,
    shown: impl Fn(&Cause) -> bool,
) -> Vec<Cause> {
    let left = |s: &Cause| s.window().is_none_or(|window| after_fit.stands_out(window)) || shown(s);
    suspects.into_iter().filter(left).collect()
}

/// Adds the suspects that are likely enough to be named and not in the offered model. If one acts
/// on the joints of a cause of that model, no model has both, and the data do not separate them. Of
/// two explanations of one error at most one is true, so it is not named beside a likelier one.
/// Pushes are not named beside a wall: they are contacts with it in a model without the wall.
pub(in crate::diagnose) fn name(causes: &mut Vec<Cause>, suspects: Vec<Cause>) {
    raise(causes, &suspects);
    let offered = causes.len();
    let contact = |c: &Cause| c.cause == effects::ExternalContact::NAME;
    let walled = causes.iter().any(|c| contact(c) && c.window().is_none());
    for mut suspect in suspects.into_iter().filter(|s| !(walled && contact(s))) {
        if suspect.probability < calibration::NAMED || causes.iter().any(|c| c.is(&suspect)) {
            continue;
        }
        if causes[..offered].iter().any(|c| has_its_level(c, &suspect) || has_its_constant(c, &suspect)) {
            continue;
        }
        let joints = suspect.joints.clone();
        let mut likeliest = true;
        for rival in causes[..offered].iter_mut().filter(|c| !joints.is_empty() && c.joints == joints) {
            likeliest &= rival.probability <= suspect.probability;
            let names = [rival.cause, suspect.cause];
            for (one, other) in [(&mut suspect, names[0]), (rival, names[1])] {
                if !one.not_distinguished_from.contains(&other) {
                    one.not_distinguished_from.push(other);
                }
            }
        }
        if likeliest {
            causes.push(Cause { in_extended: false, ..suspect });
        }
    }
}

/// Whether a cause is the same plain friction as a suspect under another name: it has one of its
/// levels on the same joint.
fn has_its_level(cause: &Cause, suspect: &Cause) -> bool {
    let plain = [
        effects::CoulombFriction::NAME,
        effects::ViscousFriction::NAME,
        effects::TorqueOffset::NAME,
        effects::AsymmetricFriction::NAME,
    ];
    let level = |c: &Cause, symbol: &str| c.parameters.iter().any(|p| p.symbol == symbol);
    [cause, suspect].iter().all(|c| plain.contains(&c.cause))
        && cause.joints == suspect.joints
        && suspect.parameters.iter().any(|p| level(cause, &p.symbol))
}

/// Whether a cause is a spring whose rest position is a suspected offset of the same joint.
fn has_its_constant(cause: &Cause, suspect: &Cause) -> bool {
    let names = [effects::JointSpring::NAME, effects::TorqueOffset::NAME];
    [cause.cause, suspect.cause] == names && suspect.joints == cause.joints
}

/// Removes suspects of a joint for which the offered model has a law that no cause of that joint
/// expresses: they only approximate it. One that is likelier than the law stays.
pub(in crate::diagnose) fn without_neighbours(causes: &mut Vec<Cause>, joints: &[usize]) {
    let of_others = |c: &Cause| c.law.is_some() && c.joints.first().is_some_and(|j| joints.contains(&(j - 1)));
    let laws: Vec<(Vec<usize>, f64)> =
        causes.iter().filter(|c| of_others(c)).map(|c| (c.joints.clone(), c.probability)).collect();
    let unlikely = |c: &Cause| {
        let law = laws.iter().find(|(joints, _)| *joints == c.joints);
        law.is_some_and(|(_, likely)| c.probability <= *likely)
    };
    causes.retain(|c| c.in_extended || c.law.is_some() || !unlikely(c));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnose::hypotheses::{Named, Quantity};

    fn cause(cause: &'static str, joints: &[usize], probability: f64) -> Cause {
        Cause { joints: joints.to_vec(), probability, on: "validate", ..Cause::blank(cause, "") }
    }

    #[test]
    fn a_cause_has_the_probability_that_it_had_beside_all_others() {
        let mut known = Vec::new();
        remember(&mut known, &[cause("payload", &[], 0.6), cause("torque_offset", &[2], 0.1)]);
        remember(&mut known, &[cause("payload", &[], 0.3), cause("torque_offset", &[2], 0.4)]);
        assert_eq!(known.iter().map(|c| c.probability).collect::<Vec<f64>>(), [0.6, 0.4]);
        let mut left = [cause("payload", &[], 0.2), cause("torque_offset", &[3], 0.1)];
        raise(&mut left, &known);
        assert_eq!(left.map(|c| c.probability), [0.6, 0.1]);
    }

    /// Two ripples of one joint differ in order, and laws by position and of speed likewise. Orders of
    /// a short travel are coarse.
    #[test]
    fn each_of_several_has_its_probability() {
        let of = |name, shape: &[f64], p| Cause { shape: shape.to_vec(), ..cause(name, &[5], p) };
        for (name, one, same, other) in [
            ("torque_ripple", vec![31.0], vec![31.4], vec![62.0]),
            ("position_dependent_friction", vec![1.0], vec![1.5], vec![4.0]),
            ("nonlinear_viscous_friction", vec![0.4, 0.0], vec![1.0, 0.3], vec![3.0, 0.0]),
        ] {
            let mut known = Vec::new();
            remember(&mut known, &[of(name, &one, 0.6), of(name, &other, 0.2), of(name, &same, 0.5)]);
            assert_eq!(known.iter().map(|c| c.probability).collect::<Vec<f64>>(), [0.6, 0.2], "{name}");
            let mut left = [of(name, &same, 0.1), of(name, &other, 0.1), of(name, &[], 0.1)];
            raise(&mut left, &known);
            assert_eq!(left.map(|c| c.probability), [0.6, 0.2, 0.6], "{name}");
        }
    }

    #[test]
    fn a_push_is_neither_another_one_nor_a_wall() {
        let push = |window: [f64; 2], probability| {
            let keys = [effects::ExternalContact::START, effects::ExternalContact::END];
            let keys = keys.into_iter().zip(window).map(|(key, at)| Named::new(key, at, None)).collect();
            Cause { keys, ..cause("external_contact", &[], probability) }
        };
        let wall = || cause("external_contact", &[], 0.9);
        let mut causes = [push([1.0, 2.0], 0.4), push([1.9, 4.0], 0.5), wall()];
        let mut known = Vec::new();
        remember(&mut known, &causes);
        assert_eq!(known.len(), 3);
        raise(&mut causes, &[push([1.1, 2.1], 0.6), push([7.0, 8.0], 0.8)]);
        assert_eq!(causes.map(|c| c.probability), [0.6, 0.5, 0.9]);
        // Contacts with the wall, taken for pushes by a model without it, are not named beside it.
        for (model, named) in [(wall(), 1), (push([1.0, 2.0], 0.4), 2)] {
            let mut causes = vec![model];
            name(&mut causes, vec![push([5.0, 6.0], 0.7)]);
            assert_eq!(causes.len(), named);
        }
    }

    #[test]
    fn a_likely_body_stands_for_refitted_links() {
        let links = || vec![cause("link_inertia_error", &[2], 0.9), cause("link_inertia_error", &[3], 0.6)];
        assert_eq!(likelier(links(), &[cause("viscous_friction", &[2], 0.95)]).len(), 2);
        let left = likelier(links(), &[cause("payload", &[], 0.8), cause("link_inertia_error", &[1], 0.3)]);
        assert_eq!(left.iter().map(|c| &c.joints[..]).collect::<Vec<_>>(), [[2]]);
    }

    /// A push where the offered model leaves an error stays suspected, elsewhere not. Causes that
    /// act throughout stay.
    #[test]
    fn a_push_that_the_offered_model_explains_is_none() {
        let error = |k: usize| if (200..300).contains(&k) { 0.5 } else { 0.1 };
        let after = Measured::made(vec![(0..1000).map(error).collect()], vec![vec![true; 1000]]);
        let push = |window: [f64; 2]| {
            let keys = [effects::ExternalContact::START, effects::ExternalContact::END];
            let keys = keys.into_iter().zip(window).map(|(key, at)| Named::new(key, at, None)).collect();
            Cause { keys, ..cause("external_contact", &[], 0.9) }
        };
        let suspects = || vec![push([2.1, 2.9]), push([6.0, 7.0]), cause("payload", &[], 0.5)];
        let left = not_explained(suspects(), &after, |_| false);
        assert_eq!(
            left.iter().map(|c| (c.cause, c.window())).collect::<Vec<_>>(),
            [("external_contact", Some([2.1, 2.9])), ("payload", None)]
        );
        assert_eq!(not_explained(suspects(), &after, |_| true).len(), 3);
    }

    #[test]
    fn a_suspect_beside_a_cause_of_its_joint_is_not_distinguished_from_it() {
        let mut causes = vec![cause("presliding_hysteresis", &[6], 0.5), cause("joint_spring", &[7], 0.5)];
        let suspects = vec![
            cause("joint_spring", &[7], 0.7),
            cause("viscous_friction", &[6], 0.6),
            cause("torque_offset", &[6], 0.1),
        ];
        name(&mut causes, suspects);
        let named: Vec<(&str, bool, f64)> = causes.iter().map(|c| (c.cause, c.in_extended, c.probability)).collect();
        assert_eq!(
            named,
            [("presliding_hysteresis", true, 0.5), ("joint_spring", true, 0.7), ("viscous_friction", false, 0.6)]
        );
        assert_eq!(causes[0].not_distinguished_from, ["viscous_friction"]);
        assert_eq!(causes[2].not_distinguished_from, ["presliding_hysteresis"]);
        assert!(causes[1].not_distinguished_from.is_empty());
        // Beside a nearly certain cause it is not named, but listed as not distinguished.
        let mut sure = vec![cause("presliding_hysteresis", &[6], 0.95)];
        name(&mut sure, vec![cause("viscous_friction", &[6], 0.8)]);
        assert!(sure.len() == 1 && sure[0].not_distinguished_from == ["viscous_friction"]);
    }

    /// A Coulomb level with and without an offset is one level.
    #[test]
    fn a_level_has_one_name() {
        let of = |name: &'static str, symbols: &[&str], probability| {
            let quantity = |s: &&str| Quantity { symbol: s.to_string(), value: 1.0, std: None };
            Cause { parameters: symbols.iter().map(quantity).collect(), ..cause(name, &[3], probability) }
        };
        let suspects = || vec![of("asymmetric_friction", &["FC3", "TO3"], 0.9), of("viscous_friction", &["FV3"], 0.9)];
        for (offered, left) in
            [(of("coulomb_friction", &["FC3"], 0.8), 2), (of("stribeck_friction", &["FC3", "FS3"], 0.8), 3)]
        {
            let mut causes = vec![offered];
            name(&mut causes, suspects());
            assert_eq!(causes.len(), left, "{causes:?}");
        }
    }

    /// The constant of a spring is no offset beside it.
    #[test]
    fn a_rest_position_is_no_offset() {
        let mut causes = vec![cause("joint_spring", &[4], 0.8)];
        name(&mut causes, vec![cause("torque_offset", &[4], 0.9), cause("torque_offset", &[3], 0.9)]);
        let named: Vec<(&str, &[usize])> = causes.iter().map(|c| (c.cause, &c.joints[..])).collect();
        assert_eq!(named, [("joint_spring", &[4][..]), ("torque_offset", &[3])]);
    }

    /// A law of other joints' motion replaces a suspect of its joint that approximates it, but not
    /// a cause of the offered model or of another joint.
    #[test]
    fn what_comes_near_to_a_law_is_not_named_beside_it() {
        let suspect = |joints: &[usize]| Cause { in_extended: false, ..cause("asymmetric_friction", joints, 0.6) };
        let law = |joints: &[usize]| Cause { law: Some("0.04*sin(2*q1)*dq7".into()), ..cause("unknown", joints, 0.9) };
        let mut causes = vec![suspect(&[7]), suspect(&[6]), cause("viscous_friction", &[7], 0.6), law(&[7])];
        without_neighbours(&mut causes, &[6]);
        let left: Vec<(&str, &[usize])> = causes.iter().map(|c| (c.cause, &c.joints[..])).collect();
        assert_eq!(left, [("asymmetric_friction", &[6][..]), ("viscous_friction", &[7]), ("unknown", &[7])]);
        // A law of the joint's own motion replaces none of these.
        let mut own = vec![suspect(&[7]), law(&[7])];
        without_neighbours(&mut own, &[]);
        assert_eq!(own.len(), 2);
    }
}
