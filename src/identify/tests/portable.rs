//! Tests of serialised factors and of merging.

use proptest::prelude::*;

use super::*;
use crate::identify::planar::motion;
use crate::identify::{FactorError, KeyedFactors, RecordingFactor};

const ROBOT: [u8; 32] = [7; 32];

fn noisy(arm: &Planar, seconds: f64, phase: f64, seed: u64) -> Motion {
    let mut motion = motion(arm, seconds, 100.0, phase);
    add_noise(&mut motion, [0.3, 0.1], false, seed);
    motion
}

fn recording(arm: &Planar, motions: &[Motion]) -> RecordingFactor {
    RecordingFactor { robot: ROBOT, factors: factors(arm, motions) }
}

/// Serialises and parses the factor.
fn carried(factor: &RecordingFactor) -> RecordingFactor {
    RecordingFactor::from_bytes("carried", &factor.to_bytes()).unwrap()
}

fn values(arm: &Planar, factor: &RecordingFactor) -> Vec<f64> {
    solve(arm, std::slice::from_ref(&factor.factors), &[], &IdentifySettings::default()).unwrap().values()
}

/// Largest difference of `R' R` relative to the norms of the columns.
fn apart(a: &Factors, b: &Factors) -> f64 {
    let of = |(a, b): (&crate::identify::JointFactor, &crate::identify::JointFactor)| {
        let (n, x, y) = (a.triangle.columns(), a.triangle.gram(), b.triangle.gram());
        let scale = |i: usize, k: usize| (x[i + i * n] * x[k + k * n]).sqrt().max(f64::MIN_POSITIVE);
        (0..n * n).map(|e| (x[e] - y[e]).abs() / scale(e % n, e / n)).fold(0.0, f64::max)
    };
    a.joints.iter().zip(&b.joints).map(of).fold(0.0, f64::max)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn the_factor_of_two_recordings_is_that_of_both_merged(
        (a, b) in (3.0..12.0, 3.0..12.0), phase in 0.0..6.0, seed in any::<u64>(),
    ) {
        let arm = Planar::new();
        let parts = [noisy(&arm, a, phase, seed), noisy(&arm, b, phase + 2.0, seed ^ 1)];
        let at_once = recording(&arm, &parts);
        let [mut merged, second] = parts.map(|part| carried(&recording(&arm, &[part])));
        merged.merge(&second).unwrap();
        prop_assert!(apart(&at_once.factors, &merged.factors) < 1e-12);
        let counts = |f: &Factors| f.joints.iter().map(|j| (j.samples, j.range, j.reach)).collect::<Vec<_>>();
        prop_assert_eq!(counts(&at_once.factors), counts(&merged.factors));
        for (x, y) in values(&arm, &at_once).iter().zip(values(&arm, &merged)) {
            prop_assert!((x - y).abs() < 1e-10 * x.abs().max(1.0), "{} {}", x, y);
        }
    }

    #[test]
    fn order_and_repetition_do_not_change_a_bit(order in Just((0..6).collect::<Vec<usize>>()).prop_shuffle(), twice in 0..6_usize) {
        let arm = Planar::new();
        let of = |i: usize| carried(&recording(&arm, &[noisy(&arm, 4.0, i as f64, i as u64)]));
        let folded = |order: &[usize]| {
            let mut all = KeyedFactors::default();
            order.iter().for_each(|&i| all.insert(format!("{i}"), of(i)).unwrap());
            all.fold("all").unwrap().unwrap().to_bytes()
        };
        let other: Vec<usize> = order.iter().copied().chain([twice]).collect();
        prop_assert_eq!(folded(&[0, 1, 2, 3, 4, 5]), folded(&other));
    }

    #[test]
    fn no_bytes_make_it_panic(mut bytes in proptest::collection::vec(any::<u8>(), 0..400), version in 0..3_u16) {
        let _ = RecordingFactor::from_bytes("x", &bytes);
        let head = [b"DNVFACTR".as_slice(), &version.to_le_bytes()].concat();
        bytes.splice(..0, head);
        let _ = RecordingFactor::from_bytes("x", &bytes);
    }

    #[test]
    fn no_damage_makes_it_panic(at in any::<prop::sample::Index>(), value in any::<u8>(), cut in any::<prop::sample::Index>()) {
        let arm = Planar::new();
        let mut bytes = recording(&arm, &[noisy(&arm, 3.0, 0.0, 1)]).to_bytes();
        let end = cut.index(bytes.len());
        prop_assert!(RecordingFactor::from_bytes("x", &bytes[..end]).is_err());
        let at = at.index(bytes.len());
        bytes[at] = value;
        if let Ok(read) = RecordingFactor::from_bytes("x", &bytes) {
            let _ = solve(&arm, &[read.factors], &[], &IdentifySettings::default());
        }
    }
}

#[test]
fn bytes_hold_all_but_the_batches() {
    let arm = Planar::new();
    let whole = recording(&arm, &[noisy(&arm, 6.0, 0.0, 3)]);
    let read = carried(&whole);
    assert_eq!(read.to_bytes(), whole.to_bytes());
    assert_eq!(apart(&whole.factors, &read.factors), 0.0);
    assert_eq!(values(&arm, &whole), values(&arm, &read));
    let mut long = whole.to_bytes();
    long.push(0);
    assert_eq!(RecordingFactor::from_bytes("x", &long), Err(FactorError::Long(1)));
}

/// A count of four thousand million columns in a file of some bytes allocates no memory.
#[test]
fn counts_are_checked_against_the_length() {
    let mut bytes = recording(&Planar::new(), &[noisy(&Planar::new(), 3.0, 0.0, 1)]).to_bytes();
    bytes[12..16].copy_from_slice(&u32::MAX.to_le_bytes());
    bytes[56..60].copy_from_slice(&u32::MAX.to_le_bytes());
    assert!(matches!(RecordingFactor::from_bytes("x", &bytes), Err(FactorError::Short { what: "columns", .. })));
}

#[test]
fn other_robots_and_other_contents_are_refused() {
    let arm = Planar::new();
    let one = recording(&arm, &[noisy(&arm, 4.0, 0.0, 1)]);
    let foreign = RecordingFactor { robot: [8; 32], ..one.clone() };
    assert!(matches!(one.clone().merge(&foreign), Err(FactorError::OtherRobot { .. })));
    let mut all = KeyedFactors::default();
    assert_eq!(all.fold("none"), Ok(None));
    all.insert("a".into(), one.clone()).unwrap();
    let other = recording(&arm, &[noisy(&arm, 4.0, 0.0, 2)]);
    assert_eq!(all.insert("a".into(), other), Err(FactorError::Conflict { key: "a".into() }));
    all.insert("b".into(), foreign).unwrap();
    assert_eq!(all.fold("all"), Err(FactorError::OtherRobot { key: "b".into() }));
}
