//! Replays a log in memory from front to back, like a file.

use super::Block;
use super::Layout;
use super::Log;
use super::LogError;
use super::Source;

/// Source that replays a [`Log`].
pub struct Replay<'a> {
    log: &'a Log,
    at: usize,
}

impl<'a> Replay<'a> {
    /// Starts at the first row.
    pub fn new(log: &'a Log) -> Self {
        Self { log, at: 0 }
    }
}

impl Source for Replay<'_> {
    fn layout(&self) -> &Layout {
        &self.log.layout
    }

    fn next_block(&mut self, rows: usize, block: &mut Block) -> Result<(), LogError> {
        block.clear(self.log.columns.len());
        let end = (self.at + rows).min(self.log.len());
        block.lines.extend((self.at..end).map(|row| row as u64 + 2));
        for (to, from) in block.columns.iter_mut().zip(&self.log.columns) {
            to.extend_from_slice(&from[self.at..end]);
        }
        self.at = end;
        Ok(())
    }
}
