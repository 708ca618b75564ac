//! Named arrays in memory, as saved by NumPy and MATLAB, read as a table.

use super::{Block, LogError, Malformed, Table};

/// Most numbers read into memory: 8 million, 64 MB.
pub(super) const MOST_NUMBERS: usize = 8_000_000;

/// An array of one or two dimensions.
pub(super) struct Array {
    pub(super) name: String,
    /// Rows and columns; one column for a vector.
    pub(super) shape: [usize; 2],
    /// Values in row-major order.
    pub(super) values: Vec<f64>,
}

/// Columns of equal length. A one-dimensional array is one column; a two-dimensional array `q`
/// becomes the columns `q[0]`, `q[1]`, ..
pub(super) struct ArrayTable {
    names: Vec<String>,
    columns: Vec<Vec<f64>>,
    selected: Vec<usize>,
    row: usize,
}

impl ArrayTable {
    /// Uses the arrays whose longer side is as long as the time array (`t`, `time` or `timestamp`)
    /// or, without one, as the longest array.
    pub(super) fn new(file: &str, format: &'static str, arrays: Vec<Array>) -> Result<Self, LogError> {
        let time = arrays.iter().find(|a| matches!(a.name.as_str(), "t" | "time" | "timestamp"));
        let longest = |a: &Array| a.shape[0].max(a.shape[1]);
        let rows = time.map_or_else(|| arrays.iter().map(longest).max().unwrap_or(0), longest);
        let (mut names, mut columns) = (Vec::new(), Vec::new());
        for array in arrays {
            let [r, c] = array.shape;
            let by_rows = r == rows;
            if !(by_rows || c == rows) || rows == 0 {
                continue;
            }
            let width = if by_rows { c } else { r };
            for k in 0..width {
                names.push(if width == 1 { array.name.clone() } else { format!("{}[{k}]", array.name) });
                let at = |i: usize| if by_rows { i * c + k } else { k * c + i };
                columns.push((0..rows).map(|i| array.values[at(i)]).collect());
            }
        }
        if names.is_empty() {
            return Err(LogError::malformed(file, format, Malformed::NoArray));
        }
        Ok(Self { names, columns, selected: Vec::new(), row: 0 })
    }
}

impl Table for ArrayTable {
    fn names(&self) -> &[String] {
        &self.names
    }

    fn select(&mut self, positions: &[usize], _clock: usize) -> Result<(), LogError> {
        self.selected = positions.to_vec();
        Ok(())
    }

    fn next_rows(&mut self, rows: usize, block: &mut Block) -> Result<(), LogError> {
        let end = (self.row + rows).min(self.columns.first().map_or(0, Vec::len));
        for (out, &column) in block.columns.iter_mut().zip(&self.selected) {
            out.extend(&self.columns[column][self.row..end]);
        }
        block.lines.extend((self.row..end).map(|row| row as u64 + 2));
        self.row = end;
        Ok(())
    }
}
