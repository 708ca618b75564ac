//! Logs that are not what they are taken for.

use super::*;
use crate::identify::planar::motion;
use crate::log::{Finding, Kind};

fn log(arm: &Planar, seed: u64, change: impl Fn(&mut Motion)) -> Factors {
    let mut motion = motion(arm, 10.0, 200.0, 0.7 * seed as f64);
    change(&mut motion);
    add_noise(&mut motion, [0.1, 0.05], false, seed);
    Factors { name: format!("log{seed}.csv"), ..factors(arm, &[motion]) }
}

fn found(arm: &Planar, logs: &[Factors]) -> Vec<Finding> {
    solve(arm, logs, &[], &IdentifySettings::default()).unwrap().findings
}

#[test]
fn logs_of_one_robot_agree_and_another_ones_is_named() {
    let arm = Planar::new();
    let [a, b, c] = [1, 2, 3].map(|seed| log(&arm, seed, |_| {}));
    assert!(found(&arm, &[a.clone(), b.clone(), c.clone()]).is_empty());
    // Half as heavy, or in other units.
    let other = log(&arm, 4, |m| m.tau.iter_mut().for_each(|t| *t *= 0.5));
    let disagree = |found: Vec<Finding>| {
        found.into_iter().find_map(|f| match f.kind {
            Kind::Disagree { times, worst } => Some((times, worst)),
            _ => None,
        })
    };
    let (times, worst) = disagree(found(&arm, &[a.clone(), other.clone(), b])).unwrap();
    assert!(times > 5.0 && worst.as_deref() == Some("log4.csv"), "{times} {worst:?}");
    // Of two, neither can be blamed.
    assert_eq!(disagree(found(&arm, &[a, other])).unwrap().1, None);
}

#[test]
fn exchanged_torques_are_not_explained() {
    let arm = Planar::new();
    let exchanged = log(&arm, 5, |m| {
        let len = m.states.len;
        let (first, second) = m.tau.split_at_mut(len);
        first.swap_with_slice(second);
    });
    let findings = found(&arm, &[exchanged]);
    assert!(findings.iter().any(|f| matches!(f.kind, Kind::Unexplained { .. } | Kind::Sign { .. })), "{findings:?}");
}
