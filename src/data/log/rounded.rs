//! Recognises a copy of a log that was written with fewer digits.
//!
//! A rounded copy equals the original rounded to the same precision. Rows are therefore hashed at
//! every precision that is usual in files, and two logs are compared at the coarser of their own
//! precisions. At each precision the rows with the smallest hashes are kept.

use std::hash::{Hash, Hasher};

use super::fingerprint::{hasher, mixed};
use super::smallest_hashes::{Row, SmallestHashes};

/// Decimal places that are tried, separately for positions and torques.
const PLACES: [usize; 7] = [1, 2, 3, 4, 5, 6, 7];
/// Decimal places of the positions by which rows are preselected.
const CELL: usize = 2;
/// Numbers of significant digits that are tried.
const DIGITS: [usize; 6] = [3, 4, 5, 6, 7, 8];
/// Most rows kept at each precision: 5 MB in all.
pub(super) const MOST_ROWS: usize = 1 << 12;
/// Rows of one log that must be found in the other, in order, with at most [`MISSES`] in between.
const SHORTEST_RUN: usize = 20;
/// Rows that may be missed in a run, since programs round ties differently.
const MISSES: usize = 5;
/// Fewest different rows for a comparison, since an arm at rest looks alike in unrelated logs.
const LEAST_ROWS: usize = 2 * SHORTEST_RUN;

/// Kept rows at one precision.
type Rows = SmallestHashes<MOST_ROWS>;

/// Duration of a log that is contained in the other one, s.
fn found_in(log: &Rows, other: &Rows) -> f64 {
    let (rows, there) = log.beside(other);
    if rows.len() < LEAST_ROWS {
        return 0.0;
    }
    let (mut seconds, mut run) = (0.0, Run::default());
    for row in &rows {
        match there.get(&row.hash) {
            Some(&at) if run.matches > 0 && at > run.at => run.extend(at, row.time),
            Some(&at) => {
                seconds += run.seconds();
                run = Run { start: row.time, end: row.time, matches: 1, at, missed: 0 };
            }
            None => {
                run.missed += 1;
                if run.missed > MISSES {
                    seconds += run.seconds();
                    run = Run::default();
                }
            }
        }
    }
    seconds + run.seconds()
}

/// A run of rows found in the same order in the other log.
#[derive(Debug, Clone, Copy, Default)]
struct Run {
    start: f64,
    end: f64,
    matches: usize,
    at: u64,
    missed: usize,
}

impl Run {
    fn extend(&mut self, at: u64, time: f64) {
        (self.at, self.end, self.missed) = (at, time, 0);
        self.matches += 1;
    }

    fn seconds(&self) -> f64 {
        if self.matches >= SHORTEST_RUN { (self.end - self.start).max(0.0) } else { 0.0 }
    }
}

/// Fingerprint by which a log is recognised in a copy with fewer digits.
#[derive(Debug, Clone)]
pub(super) struct Rounded {
    /// Rows by decimal places: number of places of positions, then of torques.
    places: Vec<Rows>,
    /// Rows by the number of significant digits of positions and torques.
    digits: Vec<Rows>,
    /// Indices of the fewest places (positions, torques) and digits that preserve every value.
    own: [usize; 3],
}

impl Rounded {
    pub(super) fn new() -> Self {
        let places = vec![Rows::default(); PLACES.len() * PLACES.len()];
        Self { places, digits: vec![Rows::default(); DIGITS.len()], own: [0; 3] }
    }

    /// Adds the next row, number `index`, at `time`, s.
    pub(super) fn push(&mut self, index: u64, time: f64, positions: &[f64], torques: &[f64]) {
        // Hashes one cell of the joint space in eight: sufficient, and eight times as fast.
        if hashed(positions.iter().copied(), |x| to_places(x, CELL)) & 7 != 0 {
            return;
        }
        let mut hashes = [[0; PLACES.len()]; 2];
        for (k, values) in [positions, torques].into_iter().enumerate() {
            for (hash, places) in hashes[k].iter_mut().zip(PLACES) {
                *hash = hashed(values.iter().copied(), |x| to_places(x, places));
            }
            let exact = |&at: &usize| values.iter().all(|&x| is_rounded(x, |x| to_places(x, PLACES[at])));
            self.own[k] = (self.own[k]..PLACES.len()).find(exact).unwrap_or(PLACES.len());
        }
        for (a, position) in hashes[0].iter().enumerate() {
            for (b, torque) in hashes[1].iter().enumerate() {
                let mut both = hasher();
                (position, torque).hash(&mut both);
                self.places[a * PLACES.len() + b].push(Row { hash: both.finish(), index, time });
            }
        }
        let all = || positions.iter().chain(torques).copied();
        let leads: Vec<i32> = all().map(lead).collect();
        for (rows, digits) in self.digits.iter_mut().zip(DIGITS) {
            let mut leads = leads.iter();
            let hash = hashed(all(), |x| with_lead(x, digits, leads.next().copied().unwrap_or(0)));
            rows.push(Row { hash, index, time });
        }
        let exact = |&at: &usize| all().all(|x| is_rounded(x, |x| to_digits(x, DIGITS[at])));
        self.own[2] = (self.own[2]..DIGITS.len()).find(exact).unwrap_or(DIGITS.len());
    }

    /// Keeps at most `most` rows of each precision.
    pub(super) fn shrink(&mut self, most: usize) {
        for rows in self.places.iter_mut().chain(&mut self.digits) {
            rows.shrink(most);
        }
    }

    /// Duration that both logs share after the finer one is rounded like the other, s.
    pub(super) fn shared(&self, other: &Self) -> f64 {
        let own: [usize; 3] = std::array::from_fn(|k| self.own[k].min(other.own[k]));
        let both = |a: &Rows, b: &Rows| found_in(a, b).max(found_in(b, a));
        let mut seconds = 0.0_f64;
        if own[0] < PLACES.len() && own[1] < PLACES.len() {
            let at = own[0] * PLACES.len() + own[1];
            seconds = both(&self.places[at], &other.places[at]);
        }
        if own[2] < DIGITS.len() {
            seconds = seconds.max(both(&self.digits[own[2]], &other.digits[own[2]]));
        }
        seconds
    }
}

fn hashed(values: impl Iterator<Item = f64>, mut round: impl FnMut(f64) -> f64) -> u64 {
    // Adding 0 maps both zeros to the same bits.
    mixed(values.map(|x| (round(x) + 0.0).to_bits()))
}

/// Whether rounding preserves the value, up to single precision.
fn is_rounded(x: f64, round: impl Fn(f64) -> f64) -> bool {
    x.is_nan() || (round(x) as f32) == (x as f32)
}

/// Powers of ten that are exact in double precision.
const POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20,
    1e21, 1e22,
];

/// Rounds to at most 22 decimal places, ties as they are printed.
#[inline]
fn to_places(x: f64, places: usize) -> f64 {
    let scale = POWERS[places];
    let scaled = x * scale;
    if scaled.is_nan() || scaled.abs() > 1e15 {
        return x;
    }
    // Adding this number rounds, since doubles beyond it are integers. It needs no function call on
    // processors without a rounding instruction.
    const WHOLE: f64 = 3.0 * (1u64 << 51) as f64;
    let rounded = (scaled + WHOLE) - WHOLE;
    if ((scaled - rounded).abs() - 0.5).abs() < 1e-6 {
        return beside_a_tie(x, places);
    }
    rounded / scale
}

/// Rounds a value so close to a tie that `x * scale` may be on the wrong side.
#[cold]
fn beside_a_tie(x: f64, places: usize) -> f64 {
    let (x, sign, scale) = (x.abs(), x.signum(), POWERS[places]);
    let scaled = x * scale;
    let below = scaled.floor();
    // Both are exact: distance of the product above the tie, and rounding error of the product.
    let (above, left_out) = (scaled - below - 0.5, x.mul_add(scale, -scaled));
    let rounded = match (above + left_out).total_cmp(&0.0) {
        _ if above == -left_out => match format!("{x:.places$}").parse::<f64>() {
            Ok(printed) => (printed * scale).round(),
            Err(_) => scaled.round(),
        },
        std::cmp::Ordering::Less => below,
        _ => below + 1.0,
    };
    sign * rounded / scale
}

/// Rounds to this many significant digits.
fn to_digits(x: f64, digits: usize) -> f64 {
    with_lead(x, digits, lead(x))
}

/// Decimal exponent of the first significant digit.
fn lead(x: f64) -> i32 {
    let size = x.abs();
    match POWERS.iter().position(|power| size < *power) {
        Some(0) if size >= 1e-6 => {
            let below = [1e-1, 1e-2, 1e-3, 1e-4, 1e-5].iter().take_while(|power| size < **power);
            -1 - below.count() as i32
        }
        Some(above) if above > 0 => above as i32 - 1,
        _ => size.log10().floor() as i32,
    }
}

/// Rounds to this many significant digits, given the decimal exponent `lead` of the first.
fn with_lead(x: f64, digits: usize, lead: i32) -> f64 {
    if x == 0.0 || !x.is_finite() {
        return x;
    }
    let places = digits as i32 - 1 - lead;
    if places >= 0 {
        return to_places(x, places.min(20) as usize);
    }
    let scale = 10f64.powi(-places);
    (x / scale).round() * scale
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ties_are_rounded_as_they_are_printed() {
        let mut random = crate::numerics::prng::Random::new(3);
        // Decimals that end in a five, and their neighbouring doubles.
        let mut ties = move || ((random.uniform(-3e4, 3e4)).floor() + 0.5) * [1e-2, 1e-3, 1e-5][random.below(3)];
        let beside = |x: f64| [x, x.next_up(), x.next_down()];
        let many: Vec<f64> = (0..300).flat_map(|_| beside(ties())).collect();
        let few = [0.12345, 2.5, 0.25, 0.375, -0.000_05, 1.005, 123.456_789, 0.0, 1e-9, 0.099_999, 9.9999, 1e-5, 1e21];
        for x in few.into_iter().chain(many) {
            for places in PLACES {
                let printed: f64 = format!("{x:.places$}").parse().unwrap();
                assert_eq!(to_places(x, places), printed, "{x} {places}");
            }
            for digits in DIGITS {
                let printed: f64 = format!("{x:.*e}", digits - 1).parse().unwrap();
                assert!((to_digits(x, digits) - printed).abs() <= 1e-15 * printed.abs(), "{x} {digits}");
            }
        }
    }
}
