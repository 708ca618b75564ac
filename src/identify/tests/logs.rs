//! Tests from the bytes of a file to the parameters.

use super::*;
use crate::data::log::{LogError, Quantity, csv, open};
use crate::data::signal::{DeadZone, Filter, Prepare, PrepareError, each_motion};
use crate::identify::budget::BudgetCollector;
use crate::identify::planar::{log, motion};

fn bytes(motion: &Motion) -> Vec<u8> {
    let mut out = Vec::new();
    csv::write(&log(motion), &mut out).unwrap();
    out
}

fn from_bytes(
    arm: &Planar,
    csv: &[u8],
    prepare: &Prepare,
    settings: AccumulatorSettings,
) -> Result<Identification, PrepareError> {
    let mut source = open("planar.csv", csv)?;
    let mut stack = QrAccumulator::new("planar.csv", arm, settings);
    each_motion(source.as_mut(), 2, prepare, |m| stack.absorb(m))?;
    Ok(solve(arm, &[stack.finish()], &[], &IdentifySettings::default()).unwrap())
}

/// Largest error of the parameters, weighted by their torque: 1 kg m^2 counts as 1 N m.
fn worst(arm: &Planar, found: &Identification) -> f64 {
    found.parameters.iter().zip(arm.beta()).map(|(p, t)| (p.value - t).abs()).fold(0.0, f64::max)
}

#[test]
fn positions_and_torques_suffice() {
    let arm = Planar::new();
    let m = motion(&arm, 20.0, 1000.0, 0.0);
    let prepare = Prepare::default();
    let found = from_bytes(&arm, &bytes(&m), &prepare, AccumulatorSettings::default()).unwrap();
    // The low-pass rounds the steps of the Coulomb torque; the parallel filter rounds its column
    // alike.
    assert!(worst(&arm, &found) < 0.06, "{}", worst(&arm, &found));
    let parallel = AccumulatorSettings { parallel: Some((5, 10.0)), ..Default::default() };
    let unfiltered = Prepare { margins: true, filter: None, dead_zone: DeadZone::Off, ..prepare.clone() };
    let better = from_bytes(&arm, &bytes(&m), &unfiltered, parallel).unwrap();
    assert!(worst(&arm, &better) < 0.003, "{}", worst(&arm, &better));
}

#[test]
fn chunks_do_not_show() {
    let arm = Planar::new();
    let mut m = motion(&arm, 20.0, 200.0, 0.0);
    add_noise(&mut m, [0.3, 0.1], false, 5);
    let csv = bytes(&m);
    let whole = from_bytes(&arm, &csv, &Prepare::default(), AccumulatorSettings::default()).unwrap();
    for chunk in [100, 777] {
        for stride in [1, 5] {
            let once = Prepare { stride, dead_zone: DeadZone::Fixed(0.01), ..Prepare::default() };
            let pieces = Prepare { chunk, ..once.clone() };
            let a = from_bytes(&arm, &csv, &once, AccumulatorSettings::default()).unwrap();
            let b = from_bytes(&arm, &csv, &pieces, AccumulatorSettings::default()).unwrap();
            assert_eq!(a.samples, b.samples);
            for ((a, b), w) in a.parameters.iter().zip(&b.parameters).zip(&whole.parameters) {
                // Only the velocity noise, estimated chunk by chunk, differs.
                assert!((a.value - b.value).abs() < 0.3 * a.std, "{}: {} {}", a.name, a.value, b.value);
                assert!((a.value - w.value).abs() < 3.0 * w.std);
            }
        }
    }
}

#[test]
fn chunks_are_filtered_as_the_whole_is() {
    let arm = Planar::new();
    let mut m = motion(&arm, 20.0, 200.0, 0.0);
    add_noise(&mut m, [0.3, 0.1], false, 5);
    let csv = bytes(&m);
    let all = |chunk: usize| {
        let (mut q, mut ddq, mut tau, mut times) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        let prepare = Prepare { chunk, stride: 3, ..Prepare::default() };
        each_motion(open("x", &csv[..]).unwrap().as_mut(), 2, &prepare, |m| {
            let mut block = crate::data::signal::MotionBlock::default();
            let n = m.gather(0, usize::MAX, &mut block);
            q.extend_from_slice(&block.states.q[n..]);
            ddq.extend_from_slice(&block.states.ddq[n..]);
            tau.extend_from_slice(&block.tau[..n]);
            times.extend(m.picks().map(|s| m.time(s)));
        })
        .unwrap();
        [q, ddq, tau, times]
    };
    let whole = all(1 << 20);
    assert_eq!(whole[0].len(), 1307); // 4000 samples less 2 * 40, every third
    for chunk in [90, 1000] {
        for (a, b) in whole.iter().flatten().zip(all(chunk).iter().flatten()) {
            assert!((a - b).abs() < 1e-8, "{a} {b}");
        }
    }
}

/// White noise on the recorded torque, from the file to the result: the truth is within the stated
/// standard deviations.
#[test]
fn honest_from_the_file_on() {
    let arm = Planar::new();
    let clean = motion(&arm, 10.0, 500.0, 0.0);
    let (mut within, mut all) = (0, 0);
    for seed in 0..30 {
        let mut m = clean.clone();
        add_noise(&mut m, [6.0, 2.0], false, 700 + seed);
        let found = from_bytes(&arm, &bytes(&m), &Prepare::default(), AccumulatorSettings::default()).unwrap();
        within += found.parameters.iter().zip(arm.beta()).filter(|(p, t)| (p.value - t).abs() < 2.0 * p.std).count();
        all += found.parameters.len();
    }
    let share = within as f64 / all as f64;
    assert!((0.92..0.985).contains(&share), "{share}");
}

#[test]
fn a_late_torque_is_moved_back() {
    let arm = Planar::new();
    let mut m = motion(&arm, 20.0, 500.0, 0.0);
    let len = m.states.len;
    let late = 17; // samples: 34 ms
    for row in m.tau.chunks_mut(len) {
        row.copy_within(..len - late, late);
    }
    let csv = bytes(&m);
    let as_is = from_bytes(&arm, &csv, &Prepare::default(), AccumulatorSettings::default()).unwrap();
    let moved = Prepare { torque_delay: 0.034, chunk: 3000, ..Prepare::default() };
    let mended = from_bytes(&arm, &csv, &moved, AccumulatorSettings::default()).unwrap();
    assert!(worst(&arm, &as_is) > 0.5 && worst(&arm, &mended) < 0.06, "{}", worst(&arm, &mended));
}

#[test]
fn currents_become_torques() {
    let arm = Planar::new();
    let m = motion(&arm, 20.0, 500.0, 0.0);
    let mut log = log(&m);
    log.layout = crate::data::log::Layout::new("currents.csv", &["t", "q1", "q2", "i1", "i2"]).unwrap();
    log.columns[3].iter_mut().for_each(|tau| *tau /= 8.0);
    log.columns[4].iter_mut().for_each(|tau| *tau /= -2.0);
    let mut csv = Vec::new();
    csv::write(&log, &mut csv).unwrap();
    let without = from_bytes(&arm, &csv, &Prepare::default(), AccumulatorSettings::default()).unwrap_err().to_string();
    assert!(without.contains("`torque_constant`"), "{without}");
    let prepare = Prepare { torque: Quantity::Current, torque_gains: vec![8.0, -2.0], ..Prepare::default() };
    assert!(worst(&arm, &from_bytes(&arm, &csv, &prepare, AccumulatorSettings::default()).unwrap()) < 0.06);
}

#[test]
fn noise_in_torque_and_position() {
    let arm = Planar::new();
    let mut m = motion(&arm, 20.0, 1000.0, 0.0);
    add_noise(&mut m, [1.0, 0.5], false, 6);
    let mut normal = Normal::new(12);
    m.states.q.iter_mut().for_each(|q| *q += 2e-5 * normal.next());
    let found = from_bytes(&arm, &bytes(&m), &Prepare::default(), AccumulatorSettings::default()).unwrap();
    assert!(worst(&arm, &found) < 0.1, "{}", worst(&arm, &found));
}

#[test]
fn a_cutoff_beyond_the_rate_says_so() {
    let arm = Planar::new();
    let csv = bytes(&motion(&arm, 10.0, 15.0, 0.0));
    let error = from_bytes(&arm, &csv, &Prepare::default(), AccumulatorSettings::default()).unwrap_err();
    assert!(error.to_string().contains("10 Hz"), "{error}");
    let low = Prepare { filter: Some(Filter { order: 5, cutoff: 4.0 }), ..Prepare::default() };
    assert!(from_bytes(&arm, &csv, &low, AccumulatorSettings::default()).is_ok());
    let coarse = Prepare { stride: 3, ..low.clone() };
    assert!(matches!(
        from_bytes(&arm, &csv, &coarse, AccumulatorSettings::default()),
        Err(PrepareError::Stride { most: 1, .. })
    ));
}

#[test]
fn another_robots_log() {
    let error = open("x.csv", &b"t,q1,tau1\n0,0,0\n"[..])
        .map_err(PrepareError::from)
        .and_then(|mut s| each_motion(s.as_mut(), 2, &Prepare::default(), |_| ()));
    assert!(matches!(error, Err(PrepareError::Log(LogError::Joints { found: 1, expected: 2, .. }))));
}

#[test]
fn many_logs_share_their_batches() {
    let arm = Planar::new();
    let mut m = motion(&arm, 60.0, 200.0, 0.0);
    add_noise(&mut m, [0.3, 0.1], true, 5);
    let whole = factors(&arm, std::slice::from_ref(&m));
    let mut few = whole.clone();
    few.shrink(8);
    assert!(few.joints.iter().all(|joint| joint.batches.grams.len() <= 8));
    let [whole, few] = [whole, few].map(|log| solve(&arm, &[log], &[], &IdentifySettings::default()).unwrap());
    for (a, b) in whole.parameters.iter().zip(&few.parameters) {
        assert_eq!(a.value, b.value);
        assert!((0.5..2.0).contains(&(a.std / b.std)), "{}: {} {}", a.name, a.std, b.std);
    }
}

#[test]
fn a_budget_keeps_as_much_of_a_thousand_stretches_as_of_some() {
    let arm = Planar::new();
    let mut m = motion(&arm, 5.0, 200.0, 0.0);
    m.error = vec![[1e-4, 1e-3, 1e-1]; 2];
    let budget = |stretches: usize| {
        let mut parts = BudgetCollector::default();
        (0..stretches).for_each(|_| parts.absorb(&m));
        assert!(parts.kept() <= 64);
        parts.finish(&arm, &arm.beta(), &[1.0; 2]).unwrap().motion
    };
    let [some, many] = [10, 1000].map(budget);
    some.iter().zip(&many).for_each(|(a, b)| assert!((a / b - 1.0).abs() < 0.1, "{a} {b}"));
}

/// Torques shifted back by more than the low-pass's settling time: chunk boundaries have no effect.
#[test]
fn a_long_delay_crosses_the_chunks() {
    let arm = Planar::new();
    let mut m = motion(&arm, 10.0, 200.0, 0.0);
    add_noise(&mut m, [0.3, 0.1], false, 6);
    let csv = bytes(&m);
    for delay in [0.6, -0.6] {
        let all = |chunk: usize| {
            let (mut tau, mut times) = (Vec::new(), Vec::new());
            let prepare = Prepare { chunk, torque_delay: delay, ..Prepare::default() };
            each_motion(open("x", &csv[..]).unwrap().as_mut(), 2, &prepare, |m| {
                let mut block = crate::data::signal::MotionBlock::default();
                let n = m.gather(0, usize::MAX, &mut block);
                tau.extend_from_slice(&block.tau[..n]);
                times.extend(m.picks().map(|s| m.time(s)));
            })
            .unwrap();
            [tau, times]
        };
        let whole = all(1 << 20);
        assert!(whole[0].len() > 1500, "{}", whole[0].len());
        for chunk in [60, 300] {
            let pieces = all(chunk);
            assert_eq!(whole[0].len(), pieces[0].len());
            for (a, b) in whole.iter().flatten().zip(pieces.iter().flatten()) {
                assert!((a - b).abs() < 1e-8, "{delay} {chunk}: {a} {b}");
            }
        }
    }
}
