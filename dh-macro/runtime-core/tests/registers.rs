//! Registers, the only `unsafe` of the runtime, against one number at a time. Runs under Miri:
//! `cargo +nightly miri test -p denavit-runtime-core --features dispatch --test registers`, once more
//! with `RUSTFLAGS="-C target-feature=+avx2,+bmi1,+bmi2,+lzcnt"`.

use denavit_runtime_core::runtime::{Block, Pack, Scalar, square_root};

/// Signs, zeros, the smallest and largest numbers, infinities and NaN.
const A: [f64; 8] = [1.5, -2.25, 0.0, -0.0, 1e-308, -1e300, f64::INFINITY, f64::NAN];
const B: [f64; 8] = [-0.5, 3.0, -0.0, 7.0, 1e-10, 2.0, -1.0, 1.0];

fn bits(x: [f64; 8]) -> [u64; 8] {
    // Any NaN is as good as another.
    x.map(|x| if x.is_nan() { u64::MAX } else { x.to_bits() })
}

fn each(f: impl Fn(f64, f64) -> f64) -> [u64; 8] {
    bits(std::array::from_fn(|k| f(A[k], B[k])))
}

#[test]
fn a_pack_computes_as_eight_numbers_do() {
    let (a, b) = (Pack::new(A), Pack::from(B));
    assert_eq!(bits(a.to_array()), bits(A));
    assert_eq!(bits((a + b).to_array()), each(|a, b| a + b));
    assert_eq!(bits((a - b).to_array()), each(|a, b| a - b));
    assert_eq!(bits((a * b).to_array()), each(|a, b| a * b));
    assert_eq!(bits((a / b).to_array()), each(|a, b| a / b));
    assert_eq!(bits((-a).to_array()), each(|a, _| -a));
    assert_eq!(bits(a.sign().to_array()), each(|a, _| a.sign()));
    assert_eq!(Pack::constant(2.5).to_array(), [2.5; 8]);
    assert_eq!(Pack::default().to_array(), [0.0; 8]);
}

#[test]
fn sines_of_a_pack_are_those_of_its_numbers() {
    let angles = [0.0, 0.7, -1.6, 3.2, -3.0, 40.0, 1e-9, 1e5];
    let ([sine], [cosine]) = Pack::sin_cos_all(&[Pack::new(angles)]);
    let (sines, cosines) = f64::sin_cos_all(&angles);
    assert_eq!((bits(sine.to_array()), bits(cosine.to_array())), (bits(sines), bits(cosines)));
    for (k, angle) in angles.iter().enumerate() {
        assert!((sines[k] - angle.sin()).abs() < 1e-11 && (cosines[k] - angle.cos()).abs() < 1e-11, "{angle}");
    }
}

#[test]
fn a_root_is_rounded_correctly() {
    for x in [0.0, 2.0, 1e-310, 5e-324, 0.25, 1e300, f64::MAX, f64::INFINITY] {
        assert_eq!(square_root(x).to_bits(), x.sqrt().to_bits(), "{x}");
    }
    assert!(square_root(-1.0).is_nan());
}

/// Eight numbers through blocks of whatever width.
fn blocks(f: impl Fn(Block, Block) -> Block) -> [f64; 8] {
    let mut out = [0.0; 8];
    for k in 0..Block::COUNT {
        let of = |x: &[f64; 8]| Block::from_fn(|l| x[k * Block::WIDTH + l]);
        f(of(&A), of(&B)).store(k, &mut out);
    }
    out
}

#[test]
fn a_block_computes_as_its_numbers_do() {
    assert_eq!(bits(blocks(|a, b| a + b)), each(|a, b| a + b));
    assert_eq!(bits(blocks(|a, b| a - b)), each(|a, b| a - b));
    assert_eq!(bits(blocks(|a, b| a * b)), each(|a, b| a * b));
    assert_eq!(bits(blocks(|a, b| a / b)), each(|a, b| a / b));
    assert_eq!(bits(blocks(|a, _| a.abs())), each(|a, _| a.abs()));
    // Not for NaN, and zeros of either sign are equal.
    let (least, most) = (blocks(Block::min), blocks(Block::max));
    for k in 0..7 {
        assert!(least[k] == A[k].min(B[k]) && most[k] == A[k].max(B[k]), "{k}");
    }
    let less = blocks(|a, b| a.only_where_less(a, b));
    let turned = blocks(|a, b| a.negative_where_less(a, b));
    for k in 0..7 {
        assert_eq!(less[k], if A[k] < B[k] { A[k] } else { 0.0 }, "{k}");
        assert_eq!(turned[k], if A[k] < B[k] { -A[k] } else { A[k] }, "{k}");
    }
}

#[test]
fn a_block_picks_and_puts() {
    let numbers: [f64; 16] = std::array::from_fn(|k| 10.0 + k as f64);
    // Only the last four bits of a place count.
    let places: [u8; 16] = std::array::from_fn(|k| (17 * (15 - k)) as u8);
    for first in (0..16).step_by(Block::WIDTH) {
        let mut out = [0.0; 3];
        Block::pick(&numbers, &places, first).put(&mut out);
        for (l, x) in out.iter().enumerate().take(Block::WIDTH) {
            assert_eq!(*x, numbers[usize::from(places[first + l] & 15)]);
        }
    }
    let mut all = [0.0; 8];
    (0..Block::COUNT).for_each(|k| Block::constant(4.0).store(k, &mut all));
    assert_eq!(all, [4.0; 8]);
}

#[cfg(feature = "dispatch")]
mod dispatched {
    use super::{A, B, bits, each};
    use denavit_runtime_core::runtime::Scalar;
    use denavit_runtime_core::runtime::dispatch::{Level, Numbers, Set, Work, eights, sines_and_cosines};

    /// Operations on numbers of one kind.
    #[inline(always)]
    fn computed<V: Numbers>(into: &mut Vec<[u64; 8]>) {
        let mut all = [[0.0; 8]; 6];
        for k in (0..8).step_by(V::WIDTH) {
            let (a, b) = (V::load(&A[k..]), V::load(&B[k..]));
            let results = [a + b, a - b, a * b, a / b, -a, a.sign()];
            for (row, result) in all.iter_mut().zip(results) {
                result.store(&mut row[k..]);
            }
        }
        into.extend(all.map(bits));
    }

    /// All that a set has: registers of each width, sines, lists of eights.
    struct Everything;

    impl Work for Everything {
        type Result = Vec<[u64; 8]>;
        #[inline(always)]
        fn run<S: Set>(self) -> Self::Result {
            let mut found = Vec::new();
            computed::<S::One>(&mut found);
            computed::<S::Eight>(&mut found);
            computed::<S::Many>(&mut found);
            // Not as many as a register holds.
            let (sines, cosines) = sines_and_cosines::<S, 11>(&std::array::from_fn(|k| k as f64 - 4.7));
            found.extend([&sines, &cosines].map(|x| bits(std::array::from_fn(|k| x[k + 3]))));
            for eight in eights::<S, 2>(&[A, B]) {
                let mut out = [0.0; 8];
                eight.store(&mut out);
                found.push(bits(out));
            }
            found
        }
    }

    /// A level that the processor lacks is the highest that it has.
    #[test]
    fn every_level_computes_as_single_numbers_do() {
        let plain = [
            each(|a, b| a + b),
            each(|a, b| a - b),
            each(|a, b| a * b),
            each(|a, b| a / b),
            each(|a, _| -a),
            each(|a, _| a.sign()),
        ];
        let angles: [f64; 11] = std::array::from_fn(|k| k as f64 - 4.7);
        let (sines, cosines) = f64::sin_cos_all(&angles);
        let expected: Vec<_> = (0..3)
            .flat_map(|_| plain)
            .chain([sines, cosines].map(|x| bits(std::array::from_fn(|k| x[k + 3]))))
            .chain([A, B].map(bits))
            .collect();
        for level in [Level::Build, Level::V3, Level::V4] {
            assert_eq!(level.run(Everything), expected, "{level:?} of {:?}", Level::highest());
        }
    }
}
