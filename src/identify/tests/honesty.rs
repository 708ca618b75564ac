//! Monte Carlo: the truth lies within two stated standard deviations in about 95 % of the runs,
//! whatever the noise's colour.

use super::*;
use crate::identify::planar::motion;

/// Share of (run, parameter) pairs within two standard deviations, and the root mean square of
/// error / deviation.
fn coverage(runs: u64, rate: f64, seconds: f64, filtered: bool) -> (f64, f64) {
    let arm = Planar::new();
    let truth = arm.beta();
    let clean = motion(&arm, seconds, rate, 0.0);
    let (mut within, mut squares, mut all) = (0, 0.0, 0);
    for seed in 0..runs {
        let mut m = clean.clone();
        add_noise(&mut m, [2.0, 0.6], filtered, 100 + seed);
        for (p, truth) in identify(&arm, &[m]).parameters.iter().zip(&truth) {
            let score = (p.value - truth) / p.std;
            within += usize::from(score.abs() < 2.0);
            squares += score * score;
            all += 1;
        }
    }
    (within as f64 / all as f64, (squares / all as f64).sqrt())
}

#[test]
fn filtered_noise() {
    let (within, spread) = coverage(150, 200.0, 10.0, true);
    assert!((0.93..0.985).contains(&within) && (0.85..1.1).contains(&spread), "{within} {spread}");
}

#[test]
fn white_noise() {
    let (within, spread) = coverage(100, 100.0, 10.0, false);
    assert!((0.93..0.985).contains(&within) && (0.85..1.1).contains(&spread), "{within} {spread}");
}

#[test]
fn short_record() {
    let (within, spread) = coverage(100, 200.0, 5.0, true);
    assert!((0.92..0.985).contains(&within) && (0.85..1.15).contains(&spread), "{within} {spread}");
}

/// What the white-noise formula would claim of the same data: its deviations are too small by the
/// root of the inflation.
#[test]
fn filtered_noise_is_told_from_white() {
    let arm = Planar::new();
    let mut m = motion(&arm, 10.0, 1000.0, 0.0);
    add_noise(&mut m, [2.0, 0.6], true, 7);
    let found = identify(&arm, &[m]);
    // A zero-phase low-pass at 10 Hz leaves about 2 * 9.5 Hz * 10 s independent numbers of 10,000.
    for joint in 0..2 {
        let n = found.noise.effective_samples[joint];
        assert!((110.0..350.0).contains(&n), "{n}");
    }
}
