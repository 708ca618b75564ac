//! Drives without bodies: losses of gears, synthetic, with a load that no file describes.

use super::columns::{self, PERIOD};
use super::mechanisms::planar;
use crate::diagnose::windows::recording::{Recording, Stretch};
use crate::diagnose::{Settings, Verdict, diagnose};
use crate::model::States;
use crate::model::drives_alone::DrivesAlone;
use crate::numerics::prng::Random;

const LEN: usize = 3000;

/// Two joints on sines of three frequencies each. `gear`: torque loss of each by position,
/// velocity, acceleration and load, N m, with noise of 0.02 N m.
fn recording(seed: u64, gear: impl Fn(usize, [f64; 3], f64) -> f64) -> Recording {
    let mut random = Random::new(seed);
    let waves: Vec<[f64; 3]> =
        (0..6).map(|i| [0.7 + 0.9 * f64::from(i % 3), 0.5 / f64::from(1 + i % 3), random.uniform(0.0, 6.0)]).collect();
    let at = |j: usize, k: usize| -> [f64; 3] {
        let t = PERIOD * k as f64;
        let sum = |f: &dyn Fn(f64, f64, f64) -> f64| {
            waves[3 * j..3 * j + 3].iter().map(|[w, a, p]| f(*w, *a, w * t + p)).sum()
        };
        [sum(&|_, a, x| a * x.sin()), sum(&|w, a, x| a * w * x.cos()), sum(&|w, a, x| -a * w * w * x.sin())]
    };
    let load = |j: usize, k: usize| 5.0 * (0.9 * PERIOD * k as f64 + j as f64).sin() + 3.0 * at(1 - j, k)[0];
    let series = |f: &dyn Fn(usize, usize) -> f64| -> Vec<f64> {
        (0..2).flat_map(|j| (0..LEN).map(move |k| (j, k))).map(|(j, k)| f(j, k)).collect()
    };
    let mut tau = series(&|j, k| gear(j, at(j, k), load(j, k)));
    tau.iter_mut().for_each(|t| *t += 0.02 * (0..12).map(|_| random.uniform(-0.5, 0.5)).sum::<f64>());
    let stretch = Stretch {
        states: States {
            len: LEN,
            q: series(&|j, k| at(j, k)[0]),
            dq: series(&|j, k| at(j, k)[1]),
            ddq: series(&|j, k| at(j, k)[2]),
        },
        tau,
        load: series(&load),
        torque_noise: vec![0.02; 2],
        ..columns::recording().stretches.remove(0)
    };
    Recording { name: "gears".into(), begin: 0.0, stretches: vec![stretch] }
}

/// A level, friction under load and a rotor that the file lacks are recovered beside the viscous
/// friction that it has. For a gear as in the file nothing is wrong.
#[test]
fn rotors_and_friction_of_gears_come_back() {
    let mut robot = planar();
    for (joint, viscous) in robot.joints.iter_mut().zip([1.5, 0.8]) {
        joint.drive.viscous_friction = Some(viscous);
        joint.drive.coulomb_friction = Some(0.0);
        joint.drive.offset = Some(0.0);
    }
    let plant = DrivesAlone::new(&robot);
    let as_in_file = |j: usize, dq: f64| [1.5, 0.8][j] * dq;
    let other = |j: usize, [_, dq, ddq]: [f64; 3], load: f64| {
        as_in_file(j, dq) + if j == 0 { 0.07 * load.abs() * dq.signum() } else { 0.4 * dq.signum() + 0.12 * ddq }
    };
    let of = |gear: &dyn Fn(usize, [f64; 3], f64) -> f64| {
        diagnose(&plant, &[recording(1, gear)], &[recording(2, gear)], &Settings::default(), &|_| {}).unwrap()
    };
    let found = of(&other);
    let mut named: Vec<(&str, usize)> = found.causes.iter().map(|c| (c.cause, c.joints[0])).collect();
    named.sort_unstable();
    assert_eq!(named, [("coulomb_friction", 2), ("load_dependent_friction", 1), ("rotor_inertia", 2)]);
    let value = |symbol: &str| {
        found.causes.iter().flat_map(|c| &c.parameters).find(|p| p.symbol == symbol).map_or(f64::NAN, |p| p.value)
    };
    assert!((value("FL1") - 0.07).abs() < 1e-3 && (value("FC2") - 0.4).abs() < 0.01, "{:?}", found.causes);
    assert!((value("IA2") - 0.12).abs() < 2e-3, "{}", value("IA2"));
    assert!(found.transmission && !found.links_refitted && found.verdict == Verdict::Explained);
    let nothing = of(&|j, [_, dq, _], _| as_in_file(j, dq));
    assert_eq!((nothing.verdict, nothing.causes.len()), (Verdict::NothingWrong, 0));
}
