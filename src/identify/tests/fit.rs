//! Tests of values, weights, essential parameters and prior.

use super::*;
use crate::identify::{
    Accuracy, Essential, Standing, Tracer, accuracy,
    planar::{STANDARD, motion, torque},
    recover_standard,
};
use crate::model::Arm;

#[test]
fn exact_without_noise() {
    let arm = Planar::new();
    let found = identify(&arm, &[motion(&arm, 10.0, 200.0, 0.0)]);
    for (p, truth) in found.parameters.iter().zip(arm.beta()) {
        assert!((p.value - truth).abs() < 1e-9, "{}: {} against {truth}", p.name, p.value);
        assert_eq!(p.standing, Standing::Identified);
    }
    assert!(found.fit.rms.iter().all(|r| *r < 1e-9));
    assert!(found.condition.scaled > 1.0 && found.condition.scaled < 1e3);
    assert!(found.confused.is_empty() && found.findings.is_empty(), "{:?}", found.findings);
}

#[test]
fn blocks_and_order_do_not_matter() {
    let arm = Planar::new();
    let mut whole = motion(&arm, 10.0, 200.0, 0.0);
    add_noise(&mut whole, [0.5, 0.2], false, 1);
    let part = |from: usize, to: usize| Motion { core: from..to, ..whole.clone() };
    let streamed = identify(&arm, &[part(0, 1), part(1, 700), part(700, 713), part(713, 2000)]);
    let at_once = identify(&arm, &[whole.clone()]);
    let logs = [factors(&arm, &[part(0, 900)]), factors(&arm, &[part(900, 2000)])];
    let two_logs = solve(&arm, &logs, &[], &IdentifySettings::default()).unwrap();
    for ((a, b), c) in at_once.parameters.iter().zip(&streamed.parameters).zip(&two_logs.parameters) {
        assert!((a.value - b.value).abs() < 1e-7 * a.std && (a.value - c.value).abs() < 1e-7 * a.std);
    }
}

#[test]
fn agrees_with_a_dense_solution() {
    let arm = Planar::new();
    let mut m = motion(&arm, 5.0, 100.0, 0.3);
    add_noise(&mut m, [0.5, 0.5], false, 2);
    let settings = IdentifySettings { weighted: false, ..Default::default() };
    let found = solve(&arm, &[factors(&arm, &[m.clone()])], &[], &settings).unwrap();
    let n = m.states.len;
    let mut entries = vec![0.0; arm.base_pattern().len() * n];
    arm.base_regressor(&m.states, &mut entries);
    let mut w = nalgebra::DMatrix::zeros(2 * n, 13);
    for (k, &(row, column)) in arm.base_pattern().iter().enumerate() {
        (0..n).for_each(|s| w[(row * n + s, column)] = entries[k * n + s]);
    }
    let tau = nalgebra::DVector::from_column_slice(&m.tau);
    let dense = w.clone().svd(true, true).solve(&tau, 0.0).unwrap();
    let variance = (&tau - &w * &dense).norm_squared() / (2 * n - 13) as f64;
    let inverse = (w.transpose() * &w).try_inverse().unwrap();
    for (i, p) in found.parameters.iter().enumerate() {
        assert!((p.value - dense[i]).abs() < 1e-8);
        // White noise: the standard deviation is that of the textbook except for the inflation,
        // which is 1 within its own scatter.
        let ratio = p.std / (inverse[(i, i)] * variance).sqrt();
        assert!((0.95..1.4).contains(&ratio), "{}: {ratio}", p.name);
    }
    assert!((found.condition.plain / (w.singular_values().max() / w.singular_values().min()) - 1.0).abs() < 1e-6);
}

#[test]
fn weights_find_the_noise_and_help() {
    let arm = Planar::new();
    let (mut plain_error, mut weighted_error) = (0.0, 0.0);
    for seed in 0..12 {
        let mut m = motion(&arm, 10.0, 100.0, 0.0);
        add_noise(&mut m, [3.0, 0.03], false, seed);
        let f = [factors(&arm, &[m])];
        let weighted = solve(&arm, &f, &[], &IdentifySettings::default()).unwrap();
        let plain = solve(&arm, &f, &[], &IdentifySettings { weighted: false, ..Default::default() }).unwrap();
        assert!((weighted.noise.sigma[0] - 3.0).abs() < 0.25 && (weighted.noise.sigma[1] - 0.03).abs() < 0.0025);
        let error = |found: &Identification| (found.parameters[4].value - arm.beta()[4]).powi(2);
        (plain_error, weighted_error) = (plain_error + error(&plain), weighted_error + error(&weighted));
    }
    assert!(weighted_error < 0.01 * plain_error, "{weighted_error} against {plain_error}");
}

#[test]
fn prior_is_compared_and_a_sign_is_seen() {
    let arm = Planar::new();
    let settings = IdentifySettings { prior: Some(STANDARD.to_vec()), ..Default::default() };
    let mut m = motion(&arm, 10.0, 100.0, 0.0);
    add_noise(&mut m, [0.1, 0.1], false, 3);
    let found = solve(&arm, &[factors(&arm, &[m.clone()])], &[], &settings).unwrap();
    assert!((found.fit_before.unwrap().rms[0] - 0.1).abs() < 0.01);
    assert!(found.findings.is_empty());
    let len = m.states.len;
    m.tau[len..].iter_mut().for_each(|t| *t = -*t);
    for settings in [settings, IdentifySettings::default()] {
        let found = solve(&arm, &[factors(&arm, &[m.clone()])], &[], &settings).unwrap();
        assert_eq!(found.findings[0].column.as_deref(), Some("tau2"), "{:?}", found.findings);
        assert_eq!(found.findings.len(), 1);
    }
}

#[test]
fn validation_is_that_of_a_direct_prediction() {
    let arm = Planar::new();
    let (mut a, mut b) = (motion(&arm, 10.0, 100.0, 0.0), motion(&arm, 7.0, 100.0, 1.0));
    add_noise(&mut a, [0.3, 0.1], true, 4);
    add_noise(&mut b, [0.3, 0.1], true, 5);
    let mut stack = QrAccumulator::new("b", &arm, AccumulatorSettings::default());
    stack.absorb(&b);
    let b_factors = stack.finish();
    let found =
        solve(&arm, &[factors(&arm, &[a])], std::slice::from_ref(&b_factors), &IdentifySettings::default()).unwrap();
    let len = b.states.len;
    let mut predicted = vec![0.0; 2 * len];
    torque(&arm, &b.states, &found.values(), &mut predicted);
    let Accuracy { rms, nrms, torque_rms, .. } = found.validation.clone().unwrap();
    for joint in 0..2 {
        let (m, p) = (&b.tau[joint * len..][..len], &predicted[joint * len..][..len]);
        let direct = (m.iter().zip(p).map(|(m, p)| (m - p).powi(2)).sum::<f64>() / len as f64).sqrt();
        let range = m.iter().fold(f64::MIN, |a, b| a.max(*b)) - m.iter().fold(f64::MAX, |a, b| a.min(*b));
        assert!((rms[joint] - direct).abs() < 1e-9 && (nrms[joint] - direct / range).abs() < 1e-9);
        assert!((torque_rms[joint] - (m.iter().map(|m| m * m).sum::<f64>() / len as f64).sqrt()).abs() < 1e-9);
    }
    assert_eq!(accuracy(&[&b_factors], &found.values()), found.validation.unwrap());
    let mut tracer = Tracer::new("b", true, &arm, &found.parameters.iter().map(|p| p.value).collect::<Vec<_>>());
    tracer.absorb(&b);
    let trace = tracer.finish();
    assert_eq!(trace.time.len(), len);
    assert!((trace.joints[1].estimated[17][0] - predicted[len + 17]).abs() < 1e-12);
}

#[test]
fn thinned_traces_keep_their_spikes() {
    let arm = Planar::new();
    let mut m = motion(&arm, 100.0, 100.0, 0.0);
    m.tau[7777] += 1000.0;
    let mut tracer = Tracer::new("m", false, &arm, &arm.beta());
    tracer.absorb(&m);
    let trace = tracer.finish();
    assert!(trace.time.len() <= 2400 && trace.thinning == 8);
    let spike = trace.joints[0].residual.iter().position(|r| r[1] > 999.0).unwrap();
    assert!((trace.time[spike] - 77.77).abs() < 0.05);
}

#[test]
fn essential_parameters() {
    let mut standard = STANDARD;
    (standard[2], standard[6], standard[15]) = (0.0, 0.0, 0.0); // MSY1, MSY2, FO2
    let arm = Planar::new();
    let mut m = motion(&arm, 10.0, 100.0, 0.0);
    let beta = crate::identify::regression::recover::base_of(&arm, &standard);
    let (states, tau) = (m.states.clone(), &mut m.tau);
    torque(&arm, &states, &beta, tau);
    add_noise(&mut m, [0.1, 0.05], true, 8);
    let settings = IdentifySettings { essential: Some(Essential::default()), ..Default::default() };
    let found = solve(&arm, &[factors(&arm, &[m])], &[], &settings).unwrap();
    let mut gone: Vec<&str> = found.dropped.iter().map(|d| d.name.as_str()).collect();
    gone.sort_unstable();
    assert_eq!(gone, ["FO2", "MSY1", "MSY2"], "{:#?}", found.dropped);
    for p in found.parameters.iter().filter(|p| gone.contains(&p.name.as_str())) {
        assert_eq!((p.value, p.standing), (0.0, Standing::Dropped));
    }
    assert!(found.dropped.iter().all(|d| d.f < d.limit && d.residual_growth_percent < 1.0));
}

#[test]
fn an_essential_parameter_is_not_dropped_by_its_relative_deviation_alone() {
    let arm = Planar::new();
    let mut m = motion(&arm, 10.0, 100.0, 0.0);
    add_noise(&mut m, [0.01, 0.01], false, 9);
    let settings =
        IdentifySettings { essential: Some(Essential { percent: 0.001, ..Default::default() }), ..Default::default() };
    let found = solve(&arm, &[factors(&arm, &[m])], &[], &settings).unwrap();
    assert!(found.dropped.is_empty(), "{:?}", found.dropped);
}

#[test]
fn standard_parameters_predict_what_was_identified() {
    let arm = Planar::new();
    let beta: Vec<f64> = arm.beta().iter().enumerate().map(|(i, b)| b + 0.01 * i as f64).collect();
    for prior in [None, Some(&STANDARD[..])] {
        let standard = recover_standard(&arm, &beta, prior).unwrap();
        let back = crate::identify::regression::recover::base_of(&arm, &standard);
        assert!(back.iter().zip(&beta).all(|(a, b)| (a - b).abs() < 1e-13));
    }
    // Correct values are kept.
    let same = recover_standard(&arm, &arm.beta(), Some(&STANDARD)).unwrap();
    assert!(same.iter().zip(&STANDARD).all(|(a, b)| (a - b).abs() < 1e-13));
    assert!(recover_standard(&arm, &beta[1..], None).is_err());
}

#[test]
fn wrong_numbers_are_refused() {
    let arm = Planar::new();
    let f = factors(&arm, &[motion(&arm, 1.0, 100.0, 0.0)]);
    assert!(solve(&arm, &[], &[], &IdentifySettings::default()).is_err());
    let prior = IdentifySettings { prior: Some(vec![0.0; 3]), ..Default::default() };
    assert!(solve(&arm, std::slice::from_ref(&f), &[], &prior).is_err());
    let mut short = motion(&arm, 1.0, 100.0, 0.0);
    short.core = 0..5;
    assert!(solve(&arm, &[factors(&arm, &[short])], &[], &IdentifySettings::default()).is_err());
    let mut huge = motion(&arm, 1.0, 100.0, 0.0);
    huge.tau[3] = 1e300;
    assert!(solve(&arm, &[factors(&arm, &[huge])], &[], &IdentifySettings::default()).is_err());
}

/// The residual of few samples is smaller than the noise, since the parameters absorb part of it.
#[test]
fn noise_of_few_samples_is_not_too_small() {
    let arm = Planar::new();
    let (mut mean, runs) = ([0.0; 2], 80);
    for seed in 0..runs {
        let mut m = motion(&arm, 1.0, 60.0, 0.0);
        add_noise(&mut m, [0.5, 0.2], false, 40 + seed);
        let sigma = identify(&arm, &[m]).noise.sigma;
        (0..2).for_each(|j| mean[j] += (sigma[j] / [0.5, 0.2][j]).powi(2) / runs as f64);
    }
    assert!(mean.iter().all(|m| (m - 1.0).abs() < 0.1), "{mean:?}");
}

/// Low-passed noise gives the same inflation with four batches as with twenty.
#[test]
fn few_batches_show_the_same_inflation() {
    let arm = Planar::new();
    let (mut mean, runs) = ([0.0; 2], 40);
    for seed in 0..runs {
        let mut m = motion(&arm, 10.0, 200.0, 0.0);
        add_noise(&mut m, [2.0, 0.6], true, 300 + seed);
        for (mean, batch) in mean.iter_mut().zip([2.5, 0.5]) {
            let mut stack = QrAccumulator::new("test", &arm, AccumulatorSettings { batch, ..Default::default() });
            stack.absorb(&m);
            let found = solve(&arm, &[stack.finish()], &[], &IdentifySettings::default()).unwrap();
            *mean += found.noise.inflation.iter().sum::<f64>() / runs as f64;
        }
    }
    assert!((mean[0] / mean[1] - 1.0).abs() < 0.2, "{mean:?}");
}

/// Friction that changes over time increases its own standard deviation, and that of other
/// parameters less.
#[test]
fn what_changes_is_less_sure() {
    let arm = Planar::new();
    let mut m = motion(&arm, 20.0, 200.0, 0.0);
    add_noise(&mut m, [0.2, 0.1], false, 9);
    for k in 0..m.states.len {
        let up = if (k / 200) % 2 == 0 { 0.5 } else { -0.5 };
        m.tau[k] += up * m.states.dq[k].signum();
    }
    let found = identify(&arm, &[m]);
    let wider = |name: &str| {
        let p = found.parameters.iter().find(|p| p.name == name).unwrap();
        p.std / p.white_std
    };
    assert!(wider("FC1") > 1.15 * wider("ZZ1R"), "{} {}", wider("FC1"), wider("ZZ1R"));
}

#[test]
fn fewer_numbers_than_unknowns_determine_nothing() {
    let arm = Planar::new();
    let mut found = identify(&arm, &[motion(&arm, 10.0, 200.0, 0.0)]);
    assert!(found.underdetermined().is_none());
    found.independent = found.unknowns as f64;
    assert!(matches!(found.underdetermined(), Some(crate::identify::Underdetermined::Equations { .. })));
}

/// The least change with sizes `m`, `m l` and `m l^2` satisfies Lagrange's condition: changes
/// divided by their squared sizes are a linear combination of the constraints.
#[test]
fn standard_parameters_change_by_their_sizes() {
    use crate::model::StandardParameter;
    use dh_codegen::arm::param::Inertial;
    let arm = Planar::new();
    let mut prior = STANDARD.to_vec();
    let parameters = arm.standard_parameters();
    let mass = |row: usize| parameters.iter().position(|p| *p == StandardParameter::Link(row, Inertial::M)).unwrap();
    prior[mass(0)] = 12.0;
    let beta: Vec<f64> = arm.beta().iter().enumerate().map(|(k, b)| b + 0.1 + 0.02 * k as f64).collect();
    let found = recover_standard(&arm, &beta, Some(&prior)).unwrap();
    let pull: Vec<f64> = (0..prior.len())
        .map(|i| {
            let size = match parameters[i] {
                StandardParameter::Link(row, which) => {
                    let power = match which {
                        Inertial::M => 0,
                        Inertial::MSX | Inertial::MSY | Inertial::MSZ => 1,
                        _ => 2,
                    };
                    prior[mass(row)].max(1.0) * 0.2_f64.powi(power)
                }
                _ => prior[i].abs().max(0.1),
            };
            (found[i] - prior[i]) / (size * size)
        })
        .collect();
    let base = arm.base_parameters();
    let k = nalgebra::DMatrix::from_fn(prior.len(), base.len(), |i, row| {
        base[row].coefficients.iter().filter(|c| c.0 == i).map(|c| c.1).sum::<f64>()
    });
    let pull = nalgebra::DVector::from_vec(pull);
    let left = &pull - &k * k.clone().svd(true, true).solve(&pull, 1e-12).unwrap();
    assert!(pull.norm() > 0.1 && left.norm() < 1e-9 * pull.norm(), "{} {}", left.norm(), pull.norm());
}

/// Standard deviations scale linearly: twice the errors of the motion give twice those of the
/// torque.
#[test]
fn errors_of_the_motion_go_into_the_torque_as_they_are() {
    let arm = Planar::new();
    let states = motion(&arm, 2.0, 100.0, 0.0).states;
    let of = |size: f64| {
        let errors = [[1e-3, 2e-2, 0.3], [2e-3, 1e-2, 0.5]].map(|joint| joint.map(|e| size * e));
        crate::identify::budget::torque_of_errors(&arm, &arm.beta(), &states, &errors)
    };
    for (one, two) in of(1.0).iter().zip(of(2.0)) {
        assert!(*one > 0.0 && (two - 2.0 * one).abs() < 1e-9 * two, "{one} {two}");
    }
}

/// The F test has as many degrees of freedom as there are independent samples minus parameters,
/// which matters for a short log.
#[test]
fn few_samples_leave_few_degrees_of_freedom() {
    use statrs::distribution::{ContinuousCDF, FisherSnedecor};
    let mut standard = STANDARD;
    (standard[2], standard[6], standard[15]) = (0.0, 0.0, 0.0);
    let arm = Planar::new();
    let mut m = motion(&arm, 4.0, 10.0, 0.0);
    let beta = crate::identify::regression::recover::base_of(&arm, &standard);
    let (states, tau) = (m.states.clone(), &mut m.tau);
    torque(&arm, &states, &beta, tau);
    add_noise(&mut m, [0.1, 0.05], false, 8);
    let log = [factors(&arm, &[m])];
    let full = solve(&arm, &log, &[], &IdentifySettings::default()).unwrap();
    let settings = IdentifySettings { essential: Some(Essential::default()), ..Default::default() };
    let found = solve(&arm, &log, &[], &settings).unwrap();
    assert!(!found.dropped.is_empty());
    let freedom = full.noise.effective_samples.iter().sum::<f64>() - beta.len() as f64;
    assert!(freedom < 100.0, "{freedom}");
    for (k, dropped) in found.dropped.iter().enumerate() {
        let limit = FisherSnedecor::new((k + 1) as f64, freedom).unwrap().inverse_cdf(0.95);
        assert!((dropped.limit / limit - 1.0).abs() < 1e-3, "{}: {} {limit}", dropped.name, dropped.limit);
    }
}
