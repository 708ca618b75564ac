//! Learning on a slider on a spring, simulated here independently: mass, sampled
//! proportional-derivative loop, low-pass, integral force loop.

use std::f64::consts::TAU;

use nalgebra::{Complex, DMatrix, DVector};

use super::gains::ForcePlant;
use crate::control::iterative_learning::{Learned, learned};
use crate::numerics::sums::root_mean_square;

const PERIOD: f64 = 1e-3;
const SECONDS: f64 = 10.0;
const MASS: f64 = 5.0;
/// Gains and parameters of the joint loop, wall, low-pass and force loop, SI units.
const KP: f64 = 2e4;
const KD: f64 = 400.0;
const STIFFNESS: f64 = 8e3;
const DAMPING: f64 = 60.0;
const CORNER: f64 = 10.0;
const FKP: f64 = 2e-5;
const FKI: f64 = 1e-3;

fn plant(mass: f64) -> ForcePlant {
    let one = |x: f64| DVector::from_element(1, x);
    ForcePlant {
        period: PERIOD,
        mass: DMatrix::from_element(1, 1, mass),
        drives: vec![[0.0, f64::INFINITY, 0.0]],
        viscous: one(0.0),
        kp: one(KP),
        kd: one(KD),
        along: one(1.0),
        inverse: one(1.0),
        stiffness: STIFFNESS,
        damping: DAMPING,
        corner: CORNER,
    }
}

/// Apparent force that is not real: 3 N at 1 Hz and 2 N at 2.3 Hz, between 2 s and 8 s.
fn ripple(t: f64) -> f64 {
    let swell = ((t - 2.0).min(8.0 - t) / 0.5).clamp(0.0, 1.0);
    swell * (3.0 * (TAU * t).sin() + 2.0 * (TAU * 2.3 * t).cos())
}

/// Simulates a coat with a feed-forward displacement `ahead`; force errors, N, one per period.
fn coat(ahead: &dyn Fn(f64) -> f64) -> Vec<f64> {
    const STEPS: usize = 20;
    let (mut x, mut v, mut before, mut sent, mut sum) = (0.0, 0.0, 0.0, 0.0, 0.0);
    let mut low = [0.0; 3];
    let turn = TAU * CORNER * PERIOD;
    let share = turn / (1.0 + turn);
    (0..(SECONDS / PERIOD) as usize)
        .map(|k| {
            let t = k as f64 * PERIOD;
            let mut from = STIFFNESS * x + DAMPING * v + ripple(t);
            for stage in &mut low {
                *stage += share * (from - *stage);
                from = *stage;
            }
            let error = -low[2];
            sum += FKI * error * PERIOD;
            let send = FKP * error + sum + ahead(t);
            let torque = KP * (send - x) + KD * ((send - sent) - (x - before)) / PERIOD;
            (before, sent) = (x, send);
            for _ in 0..STEPS {
                let h = PERIOD / STEPS as f64;
                v += h * (torque - STIFFNESS * x - DAMPING * v) / MASS;
                x += h * v;
            }
            error
        })
        .collect()
}

fn next(mass: f64, error: &[f64], before: Option<&Learned>) -> Learned {
    learned(&[plant(mass), plant(mass)], [FKP, FKI], error, &vec![1.0; error.len()], PERIOD, before).unwrap()
}

#[test]
fn what_comes_again_is_learned_and_in_its_time() {
    let first = coat(&|_| 0.0);
    assert!(root_mean_square(&first) > 1.0);
    // With the right model, and with one that is half or twice as heavy.
    for (mass, most) in [(MASS, 0.1), (0.5 * MASS, 0.2), (2.0 * MASS, 0.2)] {
        let (mut before, mut error, mut left) = (None, first.clone(), vec![root_mean_square(&first)]);
        for _ in 0..5 {
            let now = next(mass, &error, before.as_ref());
            error = coat(&|t| now.at(t));
            left.push(root_mean_square(&error));
            before = Some(now);
        }
        assert!(left[1] < 0.6 * left[0] && left[5] < most * left[0], "{mass}: {left:?}");
    }
    let now = next(MASS, &first, None);
    let on_time = root_mean_square(&coat(&|t| now.at(t)));
    for late in [-0.15, 0.15] {
        assert!(root_mean_square(&coat(&|t| now.at(t - late))) > 1.5 * on_time);
    }
}

#[test]
fn what_is_learned_is_bounded_and_ends() {
    // Errors that no displacement corrects, repeated.
    let wild: Vec<f64> = (0..4000).map(|k| if k % 500 < 250 { 1e6 } else { f64::NAN }).collect();
    let mut before = None;
    for _ in 0..5 {
        let now = next(MASS, &wild, before.as_ref());
        assert!(now.displacement.iter().all(|x| x.abs() <= 5e-3));
        assert!([-1e-9, -1.0, 4.0, 99.0, f64::INFINITY, f64::NAN].iter().all(|t| now.at(*t) == 0.0));
        assert!(now.at(0.0).abs() < 1e-9 && now.at(3.99).abs() < 1e-4, "{}", now.at(3.99));
        before = Some(now);
    }
    // Nothing is learned where the arm hardly moves.
    let slow = learned(&[plant(MASS)], [FKP, FKI], &coat(&|_| 0.0), &[0.0; 10_000], PERIOD, None).unwrap();
    assert!(slow.displacement.iter().all(|x| *x == 0.0));
    assert_eq!(Learned::default().at(0.0), 0.0);
    assert!(learned(&[], [FKP, FKI], &wild, &[1.0; 4000], PERIOD, None).is_none());
}

/// Errors of one frequency: the increment is `L` of the model at this frequency, blurred with its
/// two neighbours by the end of the kernel. Slow errors, which the loop itself corrects, are
/// limited by the regularisation.
#[test]
fn each_frequency_is_learned_by_its_own_answer() {
    const FAST: f64 = 4e-3;
    const APART: f64 = 0.125;
    let count = 47;
    let frequencies: Vec<f64> = (1..=count).map(|k| TAU * APART * f64::from(k)).collect();
    let answers = plant(MASS).response_to_displacement(FKP, FAST, &frequencies).unwrap();
    let most = answers.iter().map(|t| t.norm()).fold(0.0, f64::max);
    // Full learning up to 3 Hz, none from 6 Hz on.
    let asked = |k: usize| match k {
        0 => Complex::from(0.0),
        _ => answers[k - 1].conj() * (0.6 / (answers[k - 1].norm_sqr() + (0.05 * most).powi(2))),
    };
    assert!(answers[0].norm() < 0.05 * most, "{} {most}", answers[0].norm());
    for k in [1, 2, 8, 20] {
        let wave = |t: f64| (TAU * APART * k as f64 * t).cos();
        let error: Vec<f64> = (0..40_000).map(|i| wave(1e-3 * f64::from(i))).collect();
        let plants = [plant(MASS), plant(MASS)];
        let found = learned(&plants, [FKP, FAST], &error, &vec![1.0; error.len()], PERIOD, None).unwrap();
        // Eight seconds in the middle contain whole periods.
        let (first, last) = (1600, 2400);
        let sum: Complex<f64> = (first..last)
            .map(|i| {
                let angle = TAU * APART * k as f64 * found.period * i as f64;
                Complex::from_polar(found.displacement[i], -angle)
            })
            .sum();
        let amplitude = sum * 2.0 / (last - first) as f64;
        let expected = asked(k) * 0.5 + (asked(k - 1) + asked(k + 1)) * 0.25;
        let off = (amplitude - expected).norm() / expected.norm();
        assert!(off < 0.02, "{k}: {amplitude} {expected}");
    }
}
