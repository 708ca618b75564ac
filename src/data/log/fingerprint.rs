//! Recognises samples of one log in another, independently of the file format.
//!
//! A row is hashed by its measurements: positions and torques, not time. Of each log the rows with
//! the smallest hashes are kept ([`super::smallest_hashes`]). Order of columns, format,
//! compression, shifted time stamps and omitted rows make no difference. A copy with fewer digits
//! is recognised by [`super::rounded`].

use std::hash::{BuildHasher, Hash, Hasher};

use foldhash::quality::{FixedState, FoldHasher};

use super::Block;
use super::Layout;
use super::LogError;
use super::Quantity;
use super::Role;
use super::Source;
use super::rounded::Rounded;
use super::smallest_hashes::{Row, SmallestHashes};

/// Most rows kept per log: all rows of two minutes at 1 kHz, every 28th row of an hour; 3 MB.
const MOST_ROWS: usize = 1 << 17;

/// Consecutive kept rows that must all be found in the other log, in the same order. Coarse sensors
/// and motions that are played twice repeat single rows, but never this many.
const SHORTEST_RUN: usize = 20;

/// Rows whose cells are transposed at once.
const TILE: usize = 64;

/// Share of the shorter log below which common samples are ignored.
const LEAST_SHARE: f64 = 0.01;

/// Fingerprint by which a log is recognised.
#[derive(Debug, Clone)]
pub struct Fingerprint {
    /// Hash of all rows, in order.
    digest: u64,
    rows: u64,
    /// First and last time, s.
    span: [f64; 2],
    kept: SmallestHashes<MOST_ROWS>,
    /// Kept rows at reduced precision.
    rounded: Rounded,
}

/// Common rows of two logs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Common {
    /// Both logs have the same samples in the same order.
    All,
    /// Stretches of one log are in the other; their duration, s.
    Stretch(f64),
    /// Stretches of one log are in the other after both are rounded to the precision of the coarser
    /// one; their duration, s.
    Rounded(f64),
}

impl Fingerprint {
    /// Duration of the log, s.
    pub fn duration(&self) -> f64 {
        (self.span[1] - self.span[0]).max(0.0)
    }

    /// Keeps at most `rows` rows, to save memory. Common stretches that are short are then missed.
    pub fn shrink(&mut self, rows: usize) {
        self.kept.shrink(rows);
        self.rounded.shrink(rows / (MOST_ROWS / super::rounded::MOST_ROWS));
    }

    /// Common rows of this log and another one; `None` if there are none, or too few to report.
    ///
    /// A stretch counts if at least 20 consecutive kept rows are in the other log in the same
    /// order. Equal rows at rest count once, since an arm at rest looks alike in unrelated logs.
    pub fn common(&self, other: &Self) -> Option<Common> {
        if self.rows == other.rows && self.digest == other.digest && self.rows > 0 {
            return Some(Common::All);
        }
        // A log without every second row is found in the whole one, but not vice versa.
        let seconds = self.found_in(other).max(other.found_in(self));
        let shorter = self.duration().min(other.duration());
        let counts = |seconds: f64| seconds > 0.0 && seconds >= LEAST_SHARE * shorter;
        if counts(seconds) {
            return Some(Common::Stretch(seconds));
        }
        let seconds = self.rounded.shared(&other.rounded);
        counts(seconds).then_some(Common::Rounded(seconds))
    }

    /// Duration of this log that is contained in the other one, s.
    fn found_in(&self, other: &Self) -> f64 {
        let (rows, there) = self.kept.beside(&other.kept);
        let mut seconds = 0.0;
        // Start time of the run, its length, and the index of its last row in the other log.
        let mut run: Option<(f64, usize, u64)> = None;
        let mut last = 0.0;
        let mut close = |run: Option<(f64, usize, u64)>, end: f64| {
            if let Some((start, length, _)) = run
                && length >= SHORTEST_RUN
            {
                seconds += (end - start).max(0.0);
            }
        };
        for row in &rows {
            run = match (there.get(&row.hash), run) {
                (Some(&at), Some((start, length, before))) if at > before => Some((start, length + 1, at)),
                (found, open) => {
                    close(open, last);
                    found.map(|&at| (row.time, 1, at))
                }
            };
            last = row.time;
        }
        close(run, last);
        seconds
    }
}

/// A log source that computes the fingerprint while it is read.
pub struct Fingerprinted<'a> {
    source: &'a mut (dyn Source + 'a),
    /// Columns whose values are hashed: positions, then torques, by joint.
    columns: [Vec<usize>; 2],
    time: Option<usize>,
    print: Fingerprint,
    all: FoldHasher,
}

impl<'a> Fingerprinted<'a> {
    /// Reads `source`, which must be at its start.
    pub fn new(source: &'a mut (dyn Source + 'a)) -> Self {
        let layout = source.layout().clone();
        let column = |role: Role| layout.roles.iter().position(|r| *r == role);
        let first_of = |quantities: &[Quantity]| -> Vec<usize> {
            let of = |quantity: Quantity| -> Vec<usize> {
                (0..layout.dof).filter_map(|joint| column(Role::Joint(quantity, joint))).collect()
            };
            quantities.iter().map(|q| of(*q)).find(|columns| !columns.is_empty()).unwrap_or_default()
        };
        let positions = first_of(&[Quantity::Q, Quantity::Qm]);
        let torques = first_of(&[Quantity::Tau, Quantity::Taum, Quantity::Current]);
        let (columns, time) = ([positions, torques], column(Role::Time));
        let print = Fingerprint {
            digest: 0,
            rows: 0,
            span: [0.0; 2],
            kept: SmallestHashes::default(),
            rounded: Rounded::new(),
        };
        Self { source, columns, time, print, all: hasher() }
    }

    /// Fingerprint of all rows that were read.
    pub fn finish(mut self) -> Fingerprint {
        self.print.digest = self.all.finish();
        self.print.shrink(MOST_ROWS);
        self.print
    }
}

impl Source for Fingerprinted<'_> {
    fn layout(&self) -> &Layout {
        self.source.layout()
    }

    fn next_block(&mut self, rows: usize, block: &mut Block) -> Result<(), LogError> {
        self.source.next_block(rows, block)?;
        let columns: Vec<&[f64]> = self.columns.iter().flatten().map(|&c| &block.columns[c][..]).collect();
        let (width, split) = (columns.len(), self.columns[0].len());
        let times = self.time.map(|column| &block.columns[column]);
        let mut tile = vec![0.0; TILE * width];
        for from in (0..block.len()).step_by(TILE) {
            let count = TILE.min(block.len() - from);
            for (k, column) in columns.iter().enumerate() {
                tile[k..].iter_mut().step_by(width).zip(&column[from..from + count]).for_each(|(to, x)| *to = *x);
            }
            for row in 0..count {
                let values = &tile[row * width..(row + 1) * width];
                let hash = mixed(values.iter().map(|&value| u64::from(single(value))));
                hash.hash(&mut self.all);
                let print = &mut self.print;
                let time = times.map_or(print.rows as f64, |times| times[from + row]);
                if print.rows == 0 {
                    print.span[0] = time;
                }
                print.span[1] = time;
                print.kept.push(Row { hash, index: print.rows, time });
                let (positions, torques) = values.split_at(split);
                print.rounded.push(print.rows, time, positions, torques);
                print.rows += 1;
            }
        }
        Ok(())
    }
}

/// A hasher with the same seed for all logs of a run, and uniform enough to select rows by it.
pub(super) fn hasher() -> FoldHasher {
    FixedState::with_seed(0).build_hasher()
}

/// Hash of a row's numbers.
#[inline]
pub(super) fn mixed(numbers: impl Iterator<Item = u64>) -> u64 {
    // An odd number with about as many ones as zeros, so that each bit affects many others.
    const SPREAD: u64 = 0x9E37_79B9_7F4A_7C15;
    let all = numbers.fold(SPREAD, |all, number| (all.rotate_left(23) ^ number).wrapping_mul(SPREAD));
    let mut hasher = hasher();
    all.hash(&mut hasher);
    hasher.finish()
}

/// Bits in single precision, as some files store it; both zeros map to one value, and so does any
/// NaN.
fn single(value: f64) -> u32 {
    let value = value as f32;
    if value.is_nan() {
        u32::MAX
    } else if value == 0.0 {
        0
    } else {
        value.to_bits()
    }
}
