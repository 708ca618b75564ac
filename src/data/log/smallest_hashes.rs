//! The rows of a log with the smallest hashes (Broder 1997, min-wise sampling). Two logs therefore
//! select the same rows wherever they share some, in bounded memory.

use std::collections::HashMap;

/// A kept row.
#[derive(Debug, Clone, Copy)]
pub(super) struct Row {
    pub hash: u64,
    pub index: u64,
    /// Time, s.
    pub time: f64,
}

/// The `MOST` rows with the smallest hashes.
#[derive(Debug, Clone)]
pub(super) struct SmallestHashes<const MOST: usize> {
    /// Largest hash up to which rows were kept.
    limit: u64,
    /// Kept rows; once shrunk, sorted by hash, of equal rows the first.
    kept: Vec<Row>,
}

impl<const MOST: usize> Default for SmallestHashes<MOST> {
    fn default() -> Self {
        Self { limit: u64::MAX, kept: Vec::new() }
    }
}

impl<const MOST: usize> SmallestHashes<MOST> {
    /// Adds the next row.
    #[inline]
    pub fn push(&mut self, row: Row) {
        if row.hash <= self.limit {
            self.kept.push(row);
            if self.kept.len() >= 2 * MOST {
                self.thin(MOST);
            }
        }
    }

    /// Keeps at most `most` rows, and no more memory than they need.
    pub fn shrink(&mut self, most: usize) {
        self.thin(most.min(MOST));
        self.kept.shrink_to_fit();
    }

    /// Keeps the rows with the smallest hashes, without duplicates.
    fn thin(&mut self, most: usize) {
        self.kept.sort_unstable_by_key(|row| (row.hash, row.index));
        self.kept.dedup_by_key(|row| row.hash);
        if self.kept.len() > most {
            self.kept.truncate(most);
            self.limit = self.kept.last().map_or(0, |row| row.hash);
        }
    }

    /// Rows of this log, in order, that the other one would have kept, too, and the indices of the
    /// other's rows by their hashes.
    pub fn beside(&self, other: &Self) -> (Vec<Row>, HashMap<u64, u64>) {
        let limit = self.limit.min(other.limit);
        let within = |row: &&Row| row.hash <= limit;
        let mut rows: Vec<Row> = self.kept.iter().filter(within).copied().collect();
        rows.sort_unstable_by_key(|row| row.index);
        (rows, other.kept.iter().filter(within).map(|row| (row.hash, row.index)).collect())
    }
}
