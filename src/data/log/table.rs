//! A log as its file has it: named columns of numbers, before they have a role.

use super::Block;
use super::ChannelSummary;
use super::Layout;
use super::LogError;
use super::Quantity;
use super::Reading;
use super::Role;
use super::Source;
use super::inspect::summarise_rows;

/// Named columns of numbers that are read from front to back.
pub trait Table: Send {
    /// Names of the columns, as the file has them.
    fn names(&self) -> &[String];

    /// Whether a column holds numbers, as far as the file says.
    fn is_numeric(&self, position: usize) -> bool {
        let _ = position;
        true
    }

    /// Looks at all columns of numbers, from front to back.
    ///
    /// # Errors
    /// Where the bytes can't be read.
    fn summarise(&mut self) -> Result<Vec<ChannelSummary>, LogError> {
        summarise_rows(self)
    }

    /// Chooses the columns that are read, by their index into [`names`](Self::names), and the one
    /// whose clock the rows have where columns have clocks of their own.
    ///
    /// # Errors
    /// Where a column holds no numbers.
    fn select(&mut self, positions: &[usize], clock: usize) -> Result<(), LogError>;

    /// Appends up to `rows` rows of the selected columns to `block`; none at the end.
    ///
    /// # Errors
    /// Where the bytes can't be read.
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

/// A table whose columns have roles, in SI units.
pub struct MappedTable<T> {
    layout: Layout,
    table: T,
    /// Scale and offset of each used column; `None`: none has any.
    conversions: Option<Vec<[f64; 2]>>,
}

impl<T: Table> MappedTable<T> {
    /// Gives the columns their roles.
    ///
    /// # Errors
    /// Where a column that must be there is missing, or one that is there is ambiguous.
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
