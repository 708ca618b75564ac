//! Tests that undetermined parameters are reported by name.

use super::*;
use crate::identify::{Essential, Standing, planar::motion};

/// Joint 1 at rest at zero.
fn first_joint_at_rest(arm: &Planar) -> Motion {
    let mut m = motion(arm, 10.0, 100.0, 0.0);
    let len = m.states.len;
    for x in [&mut m.states.q, &mut m.states.dq, &mut m.states.ddq] {
        x[..len].fill(0.0);
    }
    let states = m.states.clone();
    crate::identify::planar::torque(arm, &states, &arm.beta(), &mut m.tau);
    m
}

#[test]
fn a_joint_at_rest() {
    let arm = Planar::new();
    let mut m = first_joint_at_rest(&arm);
    add_noise(&mut m, [0.1, 0.1], false, 1);
    let found = identify(&arm, &[m]);
    let mut groups: Vec<(Vec<String>, usize)> = found.confused.iter().map(|c| (c.parameters.clone(), c.open)).collect();
    groups.sort();
    // Without effect: ZZ1R, MSY1, FV1, FC1. Only as a sum: MSX1R (gravity at q1 = 0) with the
    // offset FO1.
    let expected: Vec<(Vec<String>, usize)> =
        [(vec!["FC1"], 1), (vec!["FV1"], 1), (vec!["MSX1R", "FO1"], 1), (vec!["MSY1"], 1), (vec!["ZZ1R"], 1)]
            .map(|(g, n)| (g.into_iter().map(String::from).collect(), n))
            .to_vec();
    assert_eq!(groups, expected);
    for p in &found.parameters {
        let identified = !groups.iter().any(|(g, _)| g.contains(&p.name));
        assert_eq!(p.standing == Standing::Identified, identified, "{}", p.name);
        assert_eq!(p.std.is_finite(), identified);
    }
    assert!(found.fit.rms.iter().all(|r| *r < 0.12));
    let truth = arm.beta();
    assert!(found.parameters.iter().zip(&truth).all(|(p, t)| !p.std.is_finite() || (p.value - t).abs() < 5.0 * p.std));
}

#[test]
fn the_prior_stands_where_the_data_say_nothing() {
    let arm = Planar::new();
    let prior = Some(crate::identify::planar::STANDARD.to_vec());
    let f = [factors(&arm, &[first_joint_at_rest(&arm)])];
    let found = solve(&arm, &f, &[], &IdentifySettings { prior, ..Default::default() }).unwrap();
    for (p, truth) in found.parameters.iter().zip(arm.beta()) {
        assert!((p.value - truth).abs() < 1e-7, "{}", p.name);
    }
}

#[test]
fn essential_of_what_is_told() {
    let arm = Planar::new();
    let mut m = first_joint_at_rest(&arm);
    add_noise(&mut m, [0.1, 0.1], true, 4);
    let settings = IdentifySettings { essential: Some(Essential::default()), ..Default::default() };
    let found = solve(&arm, &[factors(&arm, &[m])], &[], &settings).unwrap();
    assert!(found.parameters.iter().any(|p| p.standing == Standing::Identified));
    assert!(found.fit.rms.iter().all(|r| r.is_finite()));
}

#[test]
fn a_dead_torque_sensor_takes_no_part() {
    let arm = Planar::new();
    let mut m = motion(&arm, 10.0, 100.0, 0.0);
    let len = m.states.len;
    m.tau[..len].fill(0.0);
    let found = identify(&arm, &[m]);
    let truth = arm.beta();
    for (p, truth) in found.parameters.iter().zip(truth) {
        let seen = ["ZZ2", "MSX2", "MSY2", "IA2", "FV2", "FC2", "FO2"].contains(&p.name.as_str());
        assert_eq!(p.standing == Standing::Identified, seen, "{}", p.name);
        assert!(!seen || (p.value - truth).abs() < 1e-8, "{}: {}", p.name, p.value);
    }
    assert!(found.fit.rms[0].is_nan() && found.fit.rms[1] < 1e-8);
}

#[test]
fn no_motion_at_all() {
    let arm = Planar::new();
    let mut m = motion(&arm, 5.0, 100.0, 0.0);
    for x in [&mut m.states.q, &mut m.states.dq, &mut m.states.ddq, &mut m.tau] {
        x.fill(0.0);
    }
    let error = solve(&arm, &[factors(&arm, &[m.clone()])], &[], &IdentifySettings::default()).unwrap_err();
    assert!(error.to_string().contains("zero"), "{error}");
    m.tau.fill(1.0);
    // Only the sum of the holding torque and the offsets is determined.
    let found = identify(&arm, &[m]);
    assert!(found.parameters.iter().all(|p| p.standing == Standing::NotIdentifiable));
    assert!(found.fit.rms.iter().all(|r| *r < 1e-9));
}
