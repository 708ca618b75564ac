//! Positions that vibrate beyond what the torque shows, and their low-pass.

use super::columns::{PERIOD, recording};
use super::decisions::made;
use super::mechanisms::planar;
use crate::data::signal::Filter;
use crate::diagnose::search::position_band::position_band;
use crate::diagnose::windows::low_passed::{PositionBand, in_band};
use crate::diagnose::windows::recording::HIGHEST;
use crate::diagnose::{Recording, Settings, diagnose};
use crate::model::perturbable_robot::PerturbableRobot;

/// Adds a vibration of this amplitude (rad) and frequency (Hz) to the motion of both joints, behind
/// the usual low-pass. The ends are cut off, as those of a log are.
fn vibrating(mut recording: Recording, amplitude: f64, frequency: f64) -> Recording {
    let stretch = &mut recording.stretches[0];
    let (len, w) = (stretch.states.len, std::f64::consts::TAU * frequency);
    for at in 0..2 * len {
        let (sine, cosine) = (w * PERIOD * (at % len) as f64 + (at / len) as f64).sin_cos();
        stretch.states.q[at] += amplitude * sine;
        stretch.states.dq[at] += amplitude * w * cosine;
        stretch.states.ddq[at] -= amplitude * w * w * sine;
    }
    stretch.band.narrow = vec![Filter { order: 4, cutoff: HIGHEST }; 2];
    let [_, rest] = recording.split(0.1);
    let [inside, _] = rest.split(0.9);
    inside
}

/// The cutoff falls below a vibration that the torque does not show, however small the noise, and
/// stays where there is none or where the torque shows it.
#[test]
fn the_torque_sets_the_band() {
    let robot = planar();
    let plant = PerturbableRobot::new(&robot);
    let [plain] = made([0.05; 2], 1, &|_, _| 0.0);
    let chosen = |recording: Recording| position_band(&plant, &[recording], 1.0 / PERIOD);
    assert_eq!(chosen(vibrating(plain.clone(), 0.0, 12.0)), None);
    let PositionBand { cutoff, removes } = chosen(vibrating(plain.clone(), 2e-4, 12.0)).expect("a narrower band");
    assert!((3.0..11.0).contains(&cutoff) && removes > 0.15, "{cutoff} {removes}");
    // Positions without a low-pass of their own are left as they are.
    let mut raw = vibrating(plain, 2e-4, 12.0);
    raw.stretches[0].band.narrow.clear();
    assert_eq!(chosen(raw), None);
}

/// A diagnosis says which low-pass it chose, and an option that fixes the band is obeyed. With the
/// vibration the file seems to be wrong, without it nothing is.
#[test]
fn a_vibration_is_no_error_of_the_file() {
    let robot = planar();
    let plant = PerturbableRobot::new(&robot);
    let logs = |seed: u64| made([0.05; 2], seed, &|_, _| 0.0).map(|r| vibrating(r, 2e-4, 12.0));
    let said = |keep_band: bool| {
        let settings = Settings { keep_band, ..Settings::default() };
        diagnose(&plant, &logs(2), &logs(3), &settings, &|_| {}).unwrap()
    };
    let (narrow, kept) = (said(false), said(true));
    assert!(narrow.band.is_some_and(|band| band.cutoff < 11.0));
    assert_eq!(kept.band, None);
    assert!(narrow.baseline.validate.iter().all(|rms| *rms < 0.06), "{:?}", narrow.baseline);
    assert!(kept.baseline.validate[0] > 0.2, "{:?}", kept.baseline);
}

/// The low-pass passes the motion, removes the vibration and lowers the velocity's noise; a part of
/// a stretch is filtered as in the whole, up to its ends.
#[test]
fn a_part_is_filtered_like_the_whole() {
    let whole = vibrating(recording(), 2e-4, 12.0);
    let band = PositionBand { cutoff: 5.0, removes: 0.5 };
    let [before, after] = whole.split(0.6);
    let [all, first, last] = [whole, before, after].map(|log| in_band(&[log], Some(&band)).into_owned().remove(0));
    let (clean, all) = (vibrating(recording(), 0.0, 12.0).stretches.remove(0), &all.stretches[0]);
    let unlike = |k: usize| (all.states.ddq[k] - clean.states.ddq[k]).abs();
    assert!((0..2 * all.states.len).all(|k| unlike(k) < 0.02));
    assert!((all.velocity_noise[0] / clean.velocity_noise[0] - (5.0_f64 / HIGHEST).powf(1.5)).abs() < 1e-12);
    assert_eq!((all.band.narrow[0].cutoff, &all.tau), (5.0, &clean.tau));
    let mut at = 0;
    for part in [&first.stretches[0], &last.stretches[0]] {
        for j in 0..2 {
            for k in 0..part.states.len {
                let error = part.of(&part.states.ddq, j)[k] - all.of(&all.states.ddq, j)[at + k];
                assert!(error.abs() < 1e-2, "{error} at {k}");
            }
        }
        at += part.states.len;
    }
}
