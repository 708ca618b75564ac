//! Second moments of consecutive batches of samples, from which standard deviations under time
//! correlation are computed.

use crate::identify::regression::r_factor::{dot, dots};

/// Most batches that are kept; one more, and neighbours are merged pairwise. Bounds the memory for
/// logs of any length.
pub(in crate::identify) const MOST: usize = 64;

/// Gram matrices of `[W_j tau_j]` over consecutive batches of equal length.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::identify) struct Batches {
    /// Gram matrices, column-major, `(n + 1)^2` each.
    pub(in crate::identify) grams: Vec<Vec<f64>>,
    /// Number of batches of the original length in each one.
    pub(in crate::identify) size: usize,
    /// Number of original batches collected for the next one.
    waiting: usize,
    /// Upper triangle of the next batch's Gram matrix; empty before its first row.
    open: Vec<f64>,
}

impl Batches {
    pub(in crate::identify) fn new() -> Self {
        Self { grams: Vec::new(), size: 1, waiting: 0, open: Vec::new() }
    }

    /// Adds rows of `n` columns, column-major, to the current batch of the original length.
    pub(in crate::identify) fn add(&mut self, rows: &[f64], n: usize) {
        self.open.resize(n * n, 0.0);
        add_products(&mut self.open, rows, n);
    }

    /// Ends a batch of the original length with `n` columns.
    pub(in crate::identify) fn end_one(&mut self, n: usize) {
        self.open.resize(n * n, 0.0);
        self.waiting += 1;
        if self.waiting == self.size {
            self.keep();
            if self.grams.len() >= MOST {
                self.halve();
            }
        }
    }

    fn keep(&mut self) {
        let mut gram = std::mem::take(&mut self.open);
        let n = gram.len().isqrt();
        for k in 0..n {
            (0..k).for_each(|i| gram[k + i * n] = gram[i + k * n]);
        }
        self.grams.push(gram);
        self.waiting = 0;
    }

    /// Closes an incomplete batch.
    pub(in crate::identify) fn close(&mut self) {
        if self.waiting > 0 {
            self.keep();
        }
    }

    /// Merges neighbours until there are at most `most` batches. No more batches can be added
    /// afterwards.
    pub(in crate::identify) fn shrink(&mut self, most: usize) {
        while self.grams.len() > most.max(1) {
            self.halve();
        }
        self.grams.shrink_to_fit();
    }

    fn halve(&mut self) {
        let old = std::mem::take(&mut self.grams);
        let mut pairs = old.into_iter();
        while let Some(mut first) = pairs.next() {
            if let Some(second) = pairs.next() {
                add(&mut first, &second);
            }
            self.grams.push(first);
        }
        self.size *= 2;
    }
}

fn add(to: &mut [f64], from: &[f64]) {
    to.iter_mut().zip(from).for_each(|(a, b)| *a += b);
}

/// Adds the products of the columns of a column-major block to the upper triangle of `gram`. Uses
/// the widest registers of the processor, with bit-identical results.
#[multiversion::multiversion(targets("x86_64+avx2"))]
fn add_products(gram: &mut [f64], block: &[f64], n: usize) {
    let rows = block.len() / n.max(1);
    if rows == 0 {
        return;
    }
    let mut columns = block.chunks_exact(rows);
    for k in 0..n {
        let Some(own) = columns.next() else { return };
        let (fours, left) = gram[k * n..=k * n + k].as_chunks_mut::<4>();
        for (sums, others) in fours.iter_mut().zip(block.chunks_exact(4 * rows)) {
            let products = dots(own, others, rows);
            for i in 0..4 {
                sums[i] += products[i];
            }
        }
        let from = (k + 1 - left.len()) * rows;
        for (sum, other) in left.iter_mut().zip(block[from..].chunks_exact(rows)) {
            *sum += dot(own, other);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Batches of uneven blocks hold the products of their rows; merged, they hold those of all
    /// rows.
    #[test]
    fn batches_are_products_of_their_rows() {
        let n = 3;
        let value = |row: usize, k: usize| ((7 * row + 3 * k) % 11) as f64 - 4.0;
        let product = |rows: std::ops::Range<usize>, i: usize, k: usize| -> f64 {
            rows.map(|row| value(row, i) * value(row, k)).sum()
        };
        let mut batches = Batches::new();
        for batch in 0..130 {
            for block in [10 * batch..10 * batch + 3, 10 * batch + 3..10 * batch + 10] {
                let rows: Vec<f64> = (0..n).flat_map(|k| block.clone().map(move |row| value(row, k))).collect();
                batches.add(&rows, n);
            }
            batches.end_one(n);
        }
        batches.close();
        // 64 batches are merged to 32 of two, and 64 of these to 32 of four.
        assert_eq!((batches.size, batches.grams.len()), (4, 33));
        for (b, gram) in batches.grams.iter().enumerate() {
            for i in 0..n {
                for k in 0..n {
                    assert_eq!(gram[i + k * n], product(40 * b..(40 * b + 40).min(1300), i, k));
                }
            }
        }
    }
}
