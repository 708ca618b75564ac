//! Table of named numeric columns as in the file, before roles are assigned.

use super::Block;
use super::ChannelSummary;
use super::Layout;
use super::LogError;
use super::Quantity;
use super::Reading;
use super::Role;
use super::Source;
use super::inspect::summarise_rows;

/// Named numeric columns, read from front to back.
pub trait Table: Send {
    /// Names of the columns in the file.
    fn names(&self) -> &[String];

    /// Whether a column is numeric, as far as the file states it.
    fn is_numeric(&self, position: usize) -> bool {
        let _ = position;
        true
    }

    /// Summarises all numeric columns, reading the whole table.
    ///
    /// # Errors
    /// If the bytes can't be read.
    fn summarise(&mut self) -> Result<Vec<ChannelSummary>, LogError> {
        summarise_rows(self)
    }

    /// Selects the columns to read, by index into [`names`](Self::names), and the column whose
    /// clock defines the rows if columns have separate clocks.
    ///
    /// # Errors
    /// If a column is not numeric.
    fn select(&mut self, positions: &[usize], clock: usize) -> Result<(), LogError>;

    /// Appends up to `rows` rows of the selected columns to `block`; none at the end.
    ///
    /// # Errors
    /// If the bytes can't be read.
    fn next_rows(&mut self, rows: usize, block: &mut Block) -> Result<(), LogError>;
}

impl<T: Table + ?Sized> Table for Box<T> {
    fn names(&self) -> &[String] {
        (**self).names()
    }

    fn is_numeric(&self, position: usize) -> bool {
        (**self).is_numeric(position)
    }

    fn summarise(&mut self) -> Result<Vec<ChannelSummary>, LogError> {
        (**self).summarise()
    }

    fn select(&mut self, positions: &[usize], clock: usize) -> Result<(), LogError> {
        (**self).select(positions, clock)
    }

    fn next_rows(&mut self, rows: usize, block: &mut Block) -> Result<(), LogError> {
        (**self).next_rows(rows, block)
    }
}

/// A table whose columns have roles, converted to SI units.
pub struct MappedTable<T> {
    layout: Layout,
    table: T,
    /// Scale and offset of each used column; `None` if no column needs a conversion.
    conversions: Option<Vec<[f64; 2]>>,
}

impl<T: Table> MappedTable<T> {
    /// Assigns roles to the columns.
    ///
    /// # Errors
    /// If a required column is missing, or a column is ambiguous.
    pub fn new(file: &str, mut table: T, reading: &Reading) -> Result<Self, LogError> {
        let (layout, conversions) = reading.layout(file, table.names())?;
        let clock = layout.find(Role::Joint(Quantity::Q, 0)).unwrap_or(0);
        table.select(&layout.positions, layout.positions[clock])?;
        let plain = conversions.iter().all(|c| *c == [1.0, 0.0]);
        Ok(Self { layout, table, conversions: (!plain).then_some(conversions) })
    }
}

impl<T: Table> Source for MappedTable<T> {
    fn layout(&self) -> &Layout {
        &self.layout
    }

    fn next_block(&mut self, rows: usize, block: &mut Block) -> Result<(), LogError> {
        block.clear(self.layout.roles.len());
        self.table.next_rows(rows, block)?;
        if let Some(conversions) = &self.conversions {
            for (column, [scale, offset]) in block.columns.iter_mut().zip(conversions) {
                column.iter_mut().for_each(|value| *value = *value * scale + offset);
            }
        }
        Ok(())
    }
}
