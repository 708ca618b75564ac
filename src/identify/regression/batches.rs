//! Second moments of consecutive batches of samples: the input of standard deviations with
//! correlation in time.

use crate::identify::regression::r_factor::RFactor;

/// The most batches that are kept; one more, and neighbours are joined pairwise. Bounds the memory
/// for logs of any length.
pub(in crate::identify) const MOST: usize = 64;

/// Gram matrices of `[W_j tau_j]` over consecutive batches of equal length.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::identify) struct Batches {
    /// Column-major, `(n + 1)^2` each.
    pub(in crate::identify) grams: Vec<Vec<f64>>,
    /// How many batches of the original length each one holds.
    pub(in crate::identify) size: usize,
    /// Batches of the original length that wait to fill one.
    waiting: usize,
    open: Vec<f64>,
}

impl Batches {
    pub(in crate::identify) fn new() -> Self {
        Self { grams: Vec::new(), size: 1, waiting: 0, open: Vec::new() }
    }

    /// Adds the next batch of the original length.
    pub(in crate::identify) fn push(&mut self, triangle: &RFactor) {
        let gram = triangle.gram();
        if self.waiting == 0 {
            self.open = gram;
        } else {
            add(&mut self.open, &gram);
        }
        self.waiting += 1;
        if self.waiting == self.size {
            self.grams.push(std::mem::take(&mut self.open));
            self.waiting = 0;
            if self.grams.len() >= MOST {
                self.halve();
            }
        }
    }

    /// Closes a batch that is not full.
    pub(in crate::identify) fn close(&mut self) {
        if self.waiting > 0 {
            self.grams.push(std::mem::take(&mut self.open));
            self.waiting = 0;
        }
    }

    /// Joins neighbours until there are `most` at most. No more batches can be pushed then.
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
