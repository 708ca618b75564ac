//! Blocks of rows read from a file, so that an hour at 1 kHz needs no more memory than a minute.

use super::Layout;
use super::LogError;

/// Consecutive rows: one vector per used column, in the order of [`Layout::roles`].
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Block {
    /// Line of each row in the file, counted from 1 (the header). For Parquet it is the row number
    /// plus 1.
    pub lines: Vec<u64>,
    /// Values, one vector per used column; NaN for a cell without a number.
    pub columns: Vec<Vec<f64>>,
    /// Cells that are not numbers.
    pub bad: Vec<BadCell>,
}

/// A cell that is not a number.
#[derive(Debug, Clone, PartialEq)]
pub struct BadCell {
    /// Row within the block.
    pub row: usize,
    /// Index into the block's columns; `None` if the row has another number of cells than the
    /// header.
    pub column: Option<usize>,
    /// Text of the cell (truncated to 40 characters), or the number of cells.
    pub text: String,
}

impl Block {
    /// Number of rows.
    pub fn len(&self) -> usize {
        self.lines.len()
    }

    /// Whether the block has no rows.
    pub fn is_empty(&self) -> bool {
        self.lines.is_empty()
    }

    /// Removes all rows and keeps the allocated memory.
    pub fn clear(&mut self, columns: usize) {
        self.lines.clear();
        self.bad.clear();
        self.columns.resize_with(columns, Vec::new);
        self.columns.iter_mut().for_each(Vec::clear);
    }
}

/// A log read from front to back, on its own thread where several threads are used.
pub trait Source: Send {
    /// Columns of the log.
    fn layout(&self) -> &Layout;

    /// Replaces the content of `block` by the next rows, at most `rows`. An empty block marks the
    /// end of the log.
    fn next_block(&mut self, rows: usize, block: &mut Block) -> Result<(), LogError>;
}
