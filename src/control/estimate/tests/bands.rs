//! Coverage of the bands for known wrenches, with the model identified again in every run.

use crate::apps::paper::force::{Case, Stage, alone, coverage};
use crate::apps::paper::lwr::Unmodelled;
use crate::control::estimate::{EstimationSettings, Method};

#[test]
fn of_200_runs_95_in_100_bands_hold_the_force() {
    let stage = Stage::new(11, 100.0, 20, 8, [0.7, 0.0], [&[]; 2]).unwrap();
    let all = coverage(&stage, &[Method::Residual], Case::Right, 200, 500, &|_, _| {}).unwrap();
    let c = &all[0];
    assert!((0.93..0.97).contains(&c.whole), "{c:?}");
    assert!(c.components.iter().all(|share| (0.93..0.97).contains(share)), "{c:?}");
    assert!(c.found_right > 0.98, "{c:?}");
    let all = coverage(&stage, &[Method::Momentum, Method::Kalman], Case::Right, 30, 1500, &|_, _| {}).unwrap();
    assert!(all.iter().all(|c| (0.91..0.98).contains(&c.whole)), "{all:?}");
    // The momentum observer's are exact; the Kalman filter's depend on the rate that it finds.
    assert!(all[0].components.iter().all(|share| (0.92..0.98).contains(share)), "{all:?}");
    assert!(all[1].components.iter().all(|share| (0.87..0.99).contains(share)), "{all:?}");
}

#[test]
fn a_wrong_model_is_found_out() {
    let stage = Stage::new(12, 100.0, 20, 8, [0.7, 0.0], [&[], &Unmodelled::ALL]).unwrap();
    let all = coverage(&stage, &[Method::Residual], Case::New, 10, 900, &|_, _| {}).unwrap();
    assert!(all[0].found_right < 0.3 && all[0].whole < 0.93, "{:?}", all[0]);
}

#[test]
fn all_six_components_moving_and_standing() {
    let stage = Stage::new(13, 200.0, 30, 10, [1.2, 0.8], [&[]; 2]).unwrap();
    let found = stage.identify(3).unwrap();
    for (name, method) in Method::ALL {
        let series =
            stage.estimate(&found, 4, 4, &EstimationSettings { method, ..EstimationSettings::default() }).unwrap();
        let all = series.against_measured().unwrap();
        assert!(series.stale <= 1); // an observer has no first step
        // Against amplitudes of 30 N and 4 N m; there are singularities in the workspace.
        for (i, c) in all.iter().enumerate() {
            assert!(c.inside > 0.8, "{name} {i}: {c:?}");
        }
    }
}

/// Bands without an identification are neither too narrow nor too wide, on arms with heavy and with
/// light links. The log's contacts also begin and end in steps.
#[test]
fn bands_of_a_right_file_alone_hold_95_in_100() {
    for stage in alone(21).unwrap() {
        for c in coverage(&stage, &[Method::Residual, Method::Momentum], Case::FileAlone, 20, 700, &|_, _| {}).unwrap()
        {
            assert!((0.92..0.98).contains(&c.whole), "{c:?}");
            assert!(c.components.iter().all(|share| *share > 0.9), "{c:?}");
        }
    }
}
