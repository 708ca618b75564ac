//! Rows on their way from a file: a block at a time, so that an hour at 1 kHz needs no more memory
//! than a minute.

use super::Layout;
use super::LogError;

/// Some rows, one vector per used column (in the order of [`Layout::roles`]).
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Block {
    /// Line of each row in the file, from 1 (the header); for Parquet the row number plus 1.
    pub lines: Vec<u64>,
    /// Values, one vector per used column; a cell without a number is NaN.
    pub columns: Vec<Vec<f64>>,
    /// Cells that are not numbers.
    pub bad: Vec<BadCell>,
}

/// A cell that is not a number.
#[derive(Debug, Clone, PartialEq)]
pub struct BadCell {
    /// Row within the block.
    pub row: usize,
    /// Index into the block's columns; `None`: the row has not as many cells as the header.
    pub column: Option<usize>,
    /// Text of the cell (cut to 40 characters), or the number of cells.
    pub text: String,
}

impl Block {
    /// Number of rows.
    pub fn len(&self) -> usize {
        self.lines.len()
    }

    /// Whether there is no row.
    pub fn is_empty(&self) -> bool {
        self.lines.is_empty()
    }

    /// Removes the rows, keeps the memory.
    pub fn clear(&mut self, columns: usize) {
        self.lines.clear();
        self.bad.clear();
        self.columns.resize_with(columns, Vec::new);
        self.columns.iter_mut().for_each(Vec::clear);
    }
}

/// A log that is read from front to back; on a thread of its own where there are several.
pub trait Source: Send {
    /// Its columns.
    fn layout(&self) -> &Layout;

    /// Puts the next rows, at most `rows`, into `block` in place of what was there. No row: the log
    /// is at its end.
    fn next_block(&mut self, rows: usize, block: &mut Block) -> Result<(), LogError>;
}
