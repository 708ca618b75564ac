//! Tests with logs that are wrongly recorded or labelled.

use super::*;
use crate::data::log::{Finding, Kind};
use crate::identify::planar::motion;

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
    // Of two logs, neither can be blamed.
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

fn signs(findings: &[Finding]) -> Vec<&str> {
    findings.iter().filter(|f| matches!(f.kind, Kind::Sign { .. })).filter_map(|f| f.column.as_deref()).collect()
}

/// Joint 2 stands (except for the tremble of size `tremble`), joint 1 moves.
fn standing(arm: &Planar, seconds: f64, phase: f64, tremble: f64, change: impl Fn(&mut [f64])) -> Motion {
    let mut m = motion(arm, seconds, 200.0, phase);
    let len = m.states.len;
    for s in 0..len {
        let w = std::f64::consts::TAU * 4.0;
        let (sin, cos) = (w * s as f64 / 200.0).sin_cos();
        m.states.q[len + s] = 0.4 + tremble * sin;
        m.states.dq[len + s] = tremble * w * cos;
        m.states.ddq[len + s] = -tremble * w * w * sin;
    }
    m.tau = vec![0.0; 2 * len];
    crate::identify::planar::torque(arm, &m.states, &arm.beta(), &mut m.tau);
    change(&mut m.tau[len..]);
    add_noise(&mut m, [0.05, 0.02], false, 7);
    m
}

#[test]
fn a_joint_that_stands_tells_no_sign_by_its_offset() {
    let arm = Planar::new();
    let fit = log(&arm, 6, |_| {});
    // Gravity of joint 2 is carried by something else, and a small torque of the opposite sign
    // remains.
    let other = standing(&arm, 8.0, 0.0, 0.0, |tau| tau.iter_mut().for_each(|t| *t *= -0.1));
    let said = |m: Motion| {
        let log = Factors { name: "other.csv".into(), ..factors(&arm, &[m]) };
        solve(&arm, std::slice::from_ref(&fit), &[log], &IdentifySettings::default()).unwrap().findings
    };
    let found = said(other);
    assert!(signs(&found).is_empty(), "{found:?}");
    // A reversed sign is reported, since the joint carries the arm's weight.
    let found = said(standing(&arm, 8.0, 0.0, 0.0, |tau| tau.iter_mut().for_each(|t| *t = -*t)));
    assert_eq!(signs(&found), ["tau2"], "{found:?}");
}

#[test]
fn friction_of_a_joint_that_only_trembles_has_no_sign() {
    let arm = Planar::new();
    // A millimetre at the tip: there friction acts as a spring with hysteresis, here one with lead.
    let lead = |m: &mut Motion| {
        let len = m.states.len;
        for s in len..2 * len {
            m.tau[s] -= 2.5 * m.states.dq[s].signum() + 1.5 * m.states.dq[s] + 0.5 * m.states.ddq[s];
        }
    };
    let mut m = standing(&arm, 12.0, 0.3, 2e-3, |_| {});
    lead(&mut m);
    let found = solve(&arm, &[factors(&arm, &[m])], &[], &IdentifySettings::default()).unwrap();
    assert!(signs(&found.findings).is_empty(), "{:?}", found.findings);
    // The same for a joint that slides is reported.
    let mut m = standing(&arm, 12.0, 0.3, 0.2, |_| {});
    lead(&mut m);
    let found = solve(&arm, &[factors(&arm, &[m])], &[], &IdentifySettings::default()).unwrap();
    assert_eq!(signs(&found.findings), ["tau2"], "{:?}", found.findings);
}
