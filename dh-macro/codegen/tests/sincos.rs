//! Sines and cosines of the runtime against 40-digit values (the program that made them stands
//! beside the table), against the platform's library, and lane against scalar.

use dh_codegen::runtime::{Pack, Scalar};

fn ulp(x: f64) -> f64 {
    let next = f64::from_bits(x.abs().to_bits() + 1);
    next - x.abs()
}

fn one(x: f64) -> (f64, f64) {
    let (s, c) = f64::sin_cos_all(&[x]);
    (s[0], c[0])
}

#[test]
fn within_one_ulp_of_the_true_value() {
    let mut worst = 0.0f64;
    for line in include_str!("data/sincos_reference.csv").lines().skip(1) {
        let cells: Vec<&str> = line.split(',').collect();
        let x = f64::from_bits(u64::from_str_radix(cells[0], 16).unwrap());
        let [sh, sl, ch, cl] = [1, 2, 3, 4].map(|i| cells[i].parse::<f64>().unwrap());
        let (s, c) = one(x);
        for (got, high, low) in [(s, sh, sl), (c, ch, cl)] {
            let error = ((got - high) - low).abs() / ulp(high);
            assert!(error <= 1.0, "{x:e}: {got:e} is {error} ulp from {high:e}");
            worst = worst.max(error);
        }
    }
    println!("largest error {worst:.3} ulp");
    assert!(worst > 0.4, "a table that shows no rounding shows nothing");
}

#[test]
fn a_million_angles_agree_with_the_platform_to_an_ulp() {
    let mut state = 3u64;
    for i in 0..1_000_000 {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let unit = (state >> 11) as f64 / (1u64 << 53) as f64 * 2.0 - 1.0;
        let x = if i % 2 == 0 { 7.0 * unit } else { 1e5 * unit };
        let (s, c) = one(x);
        let (ps, pc) = x.sin_cos();
        assert!((s - ps).abs() <= ulp(ps) && (c - pc).abs() <= ulp(pc), "{x:e}: {s:e} {ps:e} {c:e} {pc:e}");
    }
}

#[test]
fn lanes_scalars_and_symmetry_agree_bit_for_bit() {
    let x = [-0.0, 1.0, -2.5, 1e4, 3e7, 1e300, core::f64::consts::FRAC_PI_2, 5e5];
    let (s, c) = Pack::sin_cos_all(&[Pack::new(x)]);
    for l in 0..8 {
        let (one_s, one_c) = one(x[l]);
        assert_eq!(s[0].to_array()[l].to_bits(), one_s.to_bits());
        assert_eq!(c[0].to_array()[l].to_bits(), one_c.to_bits());
        let (minus_s, minus_c) = one(-x[l]);
        assert_eq!((minus_s.to_bits(), minus_c.to_bits()), ((-one_s).to_bits(), one_c.to_bits()));
    }
    assert_eq!(one(0.0), (0.0, 1.0));
    assert!(one(-0.0).0.is_sign_negative());
    for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert!(one(x).0.is_nan() && one(x).1.is_nan());
    }
}

#[test]
fn signs() {
    assert_eq!([2.0, -3.0, 0.0, -0.0].map(Scalar::sign), [1.0, -1.0, 0.0, 0.0]);
    assert!(f64::NAN.sign().is_nan());
}
