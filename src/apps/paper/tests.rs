//! Checks of the experiments' parts by other methods; the complete experiment in release, on
//! request.

use super::chain::play;
use super::honesty::{ASKED, honesty};
use super::lwr::{Lwr, Unmodelled};
use super::motions::designed;
use super::*;
use crate::apps::paper::tool::PAPER_TORQUE_NOISE;
use crate::data::signal::{Filter, low_pass};
use crate::excite::{Criterion, Effort};
use crate::model::Arm;
use crate::model::differentiated::Differentiated;

/// Parseval's theorem: the energy of the impulse response is the mean of the squared gain over all
/// frequencies, forward and backward.
#[test]
fn the_noise_floor_is_the_filters_energy() {
    let Filter { order, cutoff } = Filter::default();
    let sos = low_pass(order, cutoff, 1000.0).unwrap();
    let n = 20_000;
    let mean = (0..n).map(|k| sos.gain((f64::from(k) + 0.5) * 500.0 / f64::from(n), 1000.0).powi(4)).sum::<f64>();
    let expected = (mean / f64::from(n)).sqrt();
    assert!(
        (Filter::default().noise_gain(1000.0) / expected - 1.0).abs() < 1e-6,
        "{} {expected}",
        Filter::default().noise_gain(1000.0)
    );
}

/// The published base parameters (Gaz, Flacco and De Luca 2014), with 9.80665 m/s^2 there.
#[test]
fn the_simulated_robot_is_the_published_one() {
    let lwr = Lwr::new().unwrap();
    let published = [
        ("XX2R", 1.247_624_85),
        ("ZZ2R", 1.252_426_80),
        ("MSY2R", 3.456_788_67),
        ("XX4R", 0.413_207_015),
        ("ZZ4R", 0.417_623_970),
        ("MSY4R", -1.334_022_50),
        ("MSY5R", 0.040_687_974_0),
        ("MSY6R", 0.028_637_178_4),
        ("MSY7", 0.000_954_515_526),
        ("FC5", 0.34),
    ];
    for (name, value) in published {
        let c = lwr.arm.base_parameters().iter().position(|b| b.name == name).unwrap();
        assert!((lwr.truth[c] - value).abs() < 1e-8 * (1.0 + value.abs()), "{name}: {} {value}", lwr.truth[c]);
    }
    for row in &table2::TABLE_TWO {
        assert!(lwr.arm.base_parameters().iter().any(|b| b.name == row.name), "{}", row.name);
    }
    for which in [&[][..], &Unmodelled::ALL] {
        assert_eq!(lwr.effects(which).unwrap().joints.is_empty(), which.is_empty());
    }
}

#[test]
fn verdicts() {
    assert_eq!(Verdict::less(0.5, 1.0), Verdict::Better);
    assert_eq!(Verdict::less(1.04, 1.0), Verdict::Within);
    assert_eq!(Verdict::less(1.5, 1.0).to_string(), "short by 50 %");
    assert_eq!(Verdict::less(1.0, 0.0), Verdict::Open);
    assert!(Verdict::at_most(0.9, 1.0).holds() && !Verdict::at_most(1.01, 1.0).holds());
    assert_eq!(Verdict::less(f64::NAN, 1.0), Verdict::Open);
}

/// One motion and a few runs: errors match the stated standard deviations, and the held-out error
/// is near the floor.
#[test]
fn standard_deviations_are_honest() {
    let lwr = Lwr::new().unwrap();
    let arm = Differentiated::new(&lwr.robot);
    let effort = Effort { starts: 1, iterations: 12, finalists: 1, ..Effort::default() };
    let motion = designed(&lwr, &arm, "logdet", Criterion::LogDet, 10.0, effort, &|_| {}).unwrap();
    let recording = play(&lwr, &motion, &[], 3).unwrap();
    let floor: Vec<f64> = PAPER_TORQUE_NOISE.iter().map(|s| Filter::default().noise_gain(1000.0) * s).collect();
    let runs = 12;
    let found = honesty(&lwr, &recording, &recording, &floor, runs, 5, &|_, _| {}).unwrap();
    assert_eq!((found.runs, found.parameters.len()), (runs, lwr.truth.len()));
    assert!(found.within_three > 0.98 && (0.8..1.3).contains(&found.spread), "{} {}", found.within_three, found.spread);
    assert!((0.9..1.2).contains(&found.held_out), "{}", found.held_out);
    // Standard deviations that are too small by half would be detected: the limits are not too
    // wide.
    let far = found.parameters.iter().filter(|(_, _, spread)| *spread > 0.6).count();
    assert!(far > 45, "{far}");
}

/// The complete experiment: a minute in release.
#[test]
#[ignore = "the whole experiment: cargo test --release -p denavit --lib reproduce -- --ignored"]
fn the_papers_identification() {
    let found = identification(&IdentificationSettings::default(), &|_, _| {}).unwrap();
    let honesty = found.honesty.unwrap();
    assert!(honesty.within_three >= ASKED, "{}", honesty.within_three);
    assert!(honesty.held_out <= 1.0 + fig6::ABOVE_FLOOR, "{}", honesty.held_out);
    for row in &found.fig6 {
        // The parameters' uncertainty explains the error above the floor, to the accuracy of one
        // log; the processing chain adds next to nothing.
        let [chain, uncertainty] = row.explained();
        let off = (row.above_floor() - chain - uncertainty).abs();
        assert!(off < 0.05_f64.max(0.3 * uncertainty), "{} {}", row.criterion, row.above_floor());
        assert!(chain.abs() < 0.015, "{chain}");
        assert!(row.criterion != "logdet" || row.at_floor().holds(), "{}", row.above_floor());
    }
    let of = |name: &str| found.fig6.iter().find(|r| r.criterion == name).map(|r| r.unmodelled.mean()).unwrap();
    assert!(of("logdet") < of("cond") && (0.3..0.7).contains(&of("logdet")), "{} {}", of("logdet"), of("cond"));
    assert!(found.table2.iter().filter(|r| r.verdict().holds()).count() >= 11);
    // 99.5 % of all errors are within three standard deviations: of fifteen, at most one is beyond,
    // and not by far.
    let far = found.table2.iter().filter(|r| r.off().abs() > 3.0).count();
    assert!(far <= 1 && found.table2.iter().all(|r| r.off().abs() < 4.0), "{far}");
    let large = &found.table3[0];
    assert!(large.mass_error_percent.abs() < table3::ASKED[0] && large.center_error < 3.0 * large.center_std);
    for many in &found.rollers {
        assert!(many.mass_within.value() == Some(1.0) && (0.7..1.4).contains(&many.spread), "{many:?}");
    }
    let of = |logs: [usize; 2], weighed: bool| {
        found.rollers.iter().find(|r| r.case.logs == logs && r.case.scale.is_some() == weighed).unwrap()
    };
    let (one, two, four) = (of([1, 1], false), of([2, 2], false), of([4, 4], false));
    assert!(one.center_rms < table3::ASKED[1] && two.center_rms < one.center_rms, "{one:?} {two:?}");
    assert!(four.holds(), "{four:?}");
    // Effect of the robot's own logs and of a scale in addition to one loaded log.
    assert!(of([4, 1], false).center_rms < one.center_rms && of([1, 1], true).center_rms < one.center_rms);
    let weighed = of([4, 1], true);
    assert!(weighed.center_within.value() >= Some(0.95) && weighed.center_rms < 1e-3, "{weighed:?}");
    // The textbook's formula at the paper's residual gives the paper's deviations, except for FC3.
    assert!(found.table2.iter().filter(|r| r.textbook_percent() < 2.0 * r.printed.paper[1]).count() >= 13);
    assert!((0..7).all(|j| found.fig10.verdict(j).holds()));
}

/// Diagnosis of effects hidden in the simulator: one case of each kind, short logs.
/// `denavit reproduce diagnosis` is the complete test.
#[test]
#[cfg_attr(debug_assertions, ignore = "slow without optimisation: cargo test --release --lib")]
fn hidden_effects_are_named() {
    use super::diagnosis::{DiagnosisSettings, battery};
    use crate::simulate::Mode;
    let settings = DiagnosisSettings {
        from: 4001,
        seconds: [7.0, 5.0],
        rate: 200.0,
        arms: 3,
        control: Mode::Exact,
        ..DiagnosisSettings::default()
    };
    let found = battery(&settings, &|_, _| {}).unwrap();
    let scores = &found.scores;
    let wrong: Vec<String> = found
        .outcomes
        .iter()
        .filter(|o| !o.right())
        .map(|o| {
            let named: Vec<&str> = o.found.causes.iter().map(|c| c.cause).collect();
            format!("{} {}: {named:?}", o.seed, o.label())
        })
        .collect();
    // Thresholds allow for chance: 28 cases with one effect, 8 with two, 3 outside the vocabulary,
    // 1 with nothing.
    assert_eq!(found.outcomes.len(), 40);
    assert_eq!(scores.false_alarms.good, 0, "{wrong:#?}");
    assert!(scores.first.value().unwrap() >= 0.7, "{:?} {wrong:#?}", scores.first);
    assert!(scores.place.value().unwrap() >= 0.85, "{:?} {wrong:#?}", scores.place);
    assert!(scores.both.value().unwrap() >= 0.25, "{:?} {wrong:#?}", scores.both);
    assert!(scores.gained.value().unwrap() >= 0.7, "{:?}", scores.gained);
    // The same seeds give the same figures.
    let again = battery(&DiagnosisSettings { cases: 2, ..settings }, &|_, _| {}).unwrap();
    assert_eq!(format!("{:?}", again.outcomes), format!("{:?}", &found.outcomes[..2]));
}
