//! Exponentials, logarithms and the like of the shipped text against the platform's library,
//! special values, and lane against scalar; and what the expression graph makes of them.

use dh_codegen::elementary::Real;
use dh_codegen::runtime::{Pack, Scalar};
use dh_codegen::sym::{Call, Evaluator, Graph, Tape, adjoint};

/// Distance in units of the last place of the library's value.
fn ulps(a: f64, b: f64) -> f64 {
    if a.to_bits() == b.to_bits() {
        return 0.0;
    }
    let ulp = f64::from_bits(b.abs().to_bits() + 1) - b.abs();
    (a - b).abs() / ulp
}

/// Numbers from 0 to 1, always the same.
fn numbers(len: usize) -> impl Iterator<Item = f64> {
    let mut state = 0x9E37_79B9_7F4A_7C15_u64;
    (0..len).map(move |_| {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1u64 << 53) as f64
    })
}

#[test]
fn within_one_ulp_of_the_library() {
    let mut worst = [0.0_f64; 2];
    for (k, u) in numbers(200_000).enumerate() {
        let x = if k % 2 == 0 { 2.0 * u - 1.0 } else { 1400.0 * u - 700.0 };
        worst[0] = worst[0].max(ulps(Real::exp(x), x.exp()));
        let y = if k % 2 == 0 { 0.5 + u } else { (1400.0 * u - 700.0).exp() };
        worst[1] = worst[1].max(ulps(Real::ln(y), y.ln()));
    }
    assert!(worst.iter().all(|w| *w <= 1.0), "exp, ln: {worst:?} units of the last place");
}

#[test]
fn special_values() {
    let (inf, nan) = (f64::INFINITY, f64::NAN);
    for (x, e) in [(0.0, 1.0), (-0.0, 1.0), (inf, inf), (-inf, 0.0), (710.0, inf), (-746.0, 0.0)] {
        assert_eq!(Real::exp(x), e, "exp({x})");
    }
    for x in [-708.5, -720.0, -745.0, 709.7] {
        assert!(ulps(Real::exp(x), f64::exp(x)) <= 1.0, "{x}");
    }
    for (x, l) in [(1.0, 0.0), (0.0, -inf), (-0.0, -inf), (inf, inf)] {
        assert_eq!(Real::ln(x), l, "ln({x})");
    }
    for x in [5e-324, 1e-310, f64::MAX, f64::MIN_POSITIVE] {
        assert!(ulps(Real::ln(x), f64::ln(x)) <= 1.0, "{x}");
    }
    assert!([Real::ln(-1.0), Real::ln(nan), Real::exp(nan), Real::sqrt(-1.0)].iter().all(|x: &f64| x.is_nan()));
    assert_eq!([Real::abs(-2.0), Real::abs(-0.0), Real::min(1.0, -2.0), Real::max(1.0, -2.0)], [2.0, 0.0, -2.0, 1.0]);
}

#[test]
fn lanes_are_scalars() {
    let x = [0.3, 2.0, 1e-9, 700.0, 0.0, 5.5, 1e5, 0.999];
    let pack = Pack::new(x);
    for l in 0..8 {
        let lane = |p: Pack| p.to_array()[l].to_bits();
        assert_eq!(lane(pack.exp()), Real::exp(x[l]).to_bits());
        assert_eq!(lane(pack.ln()), Real::ln(x[l]).to_bits());
        assert_eq!(lane(pack.sqrt()), Real::sqrt(x[l]).to_bits());
        assert_eq!(lane(Real::sin(pack)), Real::sin(x[l]).to_bits());
        assert_eq!(lane((-pack).abs()), x[l].to_bits());
        assert_eq!(lane(pack.min(Pack::constant(1.0))), Real::min(x[l], 1.0).to_bits());
        assert_eq!(lane(pack.max(Pack::constant(1.0))), Real::max(x[l], 1.0).to_bits());
    }
    assert!((f64::from(Real::exp(1.0_f32)) - core::f64::consts::E).abs() < 1e-6);
}

fn value(tape: &Tape, inputs: &[f64]) -> Vec<f64> {
    let mut out = vec![0.0; tape.outputs.len()];
    Evaluator::new(tape).run_one(inputs, &mut Vec::new(), &mut out);
    out
}

/// Signs float through sums and products, but not through an exponential.
#[test]
fn expressions_keep_their_meaning() {
    let g = Graph::new();
    let [x, y, z] = [0, 1, 2].map(|i| g.input(i));
    let roots = [
        (-(x - y)).call(Call::Exp) * z,
        (-x).least(y - z).most(-(z * z)),
        (x * -y).call(Call::Abs) - (-z).call(Call::Cos),
        -((y - x).call(Call::Sin) * (x - y)),
        ((x - y) * (x - y)).call(Call::Sqrt) + (z * z + 1.0).call(Call::Ln),
        (-(x * y) - z).call(Call::Exp),
    ];
    let tape = Tape::new(&g, &roots);
    for (a, b, c) in [(0.3, -0.8, 1.7), (-1.2, 0.4, -0.6), (2.0, 2.5, 0.1)] {
        let expected = [
            f64::exp(b - a) * c,
            f64::max(f64::min(-a, b - c), -(c * c)),
            (a * b).abs() - c.cos(),
            -((b - a).sin() * (a - b)),
            (a - b).abs() + (c * c + 1.0).ln(),
            f64::exp(-a * b - c),
        ];
        for (k, (found, expected)) in value(&tape, &[a, b, c]).iter().zip(expected).enumerate() {
            assert!((found - expected).abs() < 1e-14 * (1.0 + expected.abs()), "{k}: {found} {expected}");
        }
    }
    assert_eq!(g.constant(-2.0).call(Call::Abs).as_constant(), Some(2.0));
    assert_eq!(x.call(Call::Sin), -((-x).call(Call::Sin)));
}

#[test]
fn derivatives_are_difference_quotients() {
    let g = Graph::new();
    let [x, y] = [0, 1].map(|i| g.input(i));
    let square = x * x + 1.0;
    let roots = [
        (x * y).call(Call::Exp),
        square.call(Call::Ln) + square.call(Call::Sqrt) * y,
        (x - y).call(Call::Abs) + (x * 3.0).call(Call::Sin) * y.call(Call::Cos),
        x.least(y * 2.0) * x.most(-y),
    ];
    let tape = Tape::new(&g, &roots);
    for k in 0..roots.len() {
        let h = Graph::new();
        let by = adjoint(&h, &tape, &[k], &[h.input(2)]);
        let derivatives: Vec<_> = (0..2).map(|i| by.get(&i).copied().unwrap_or(h.constant(0.0))).collect();
        let derivatives = Tape::new(&h, &derivatives);
        for at in [[0.4, -0.7], [-1.1, 0.3], [0.9, 0.2]] {
            let found = value(&derivatives, &[at[0], at[1], 1.0]);
            for i in 0..2 {
                let step = 1e-6;
                let moved = |by: f64| {
                    let mut inputs = at;
                    inputs[i] += by;
                    value(&tape, &inputs)[k]
                };
                let quotient = (moved(step) - moved(-step)) / (2.0 * step);
                assert!((found[i] - quotient).abs() < 1e-8, "output {k}, input {i}: {} {quotient}", found[i]);
            }
        }
    }
}
