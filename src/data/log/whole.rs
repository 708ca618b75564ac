//! A log in memory, for callers that need all rows at once.

use super::Acceptance;
use super::Block;
use super::Finding;
use super::Layout;
use super::LogError;
use super::QualityCheck;
use super::Quantity;
use super::Role;
use super::Source;
use super::Verdict;

/// Rows accepted by the quality check, in segments.
#[derive(Debug, Clone, PartialEq)]
pub struct Log {
    /// Layout of the columns.
    pub layout: Layout,
    /// Values, one vector per used column, in the order of [`Layout::roles`].
    pub columns: Vec<Vec<f64>>,
    /// Index of the first row of each segment.
    pub starts: Vec<usize>,
    /// Findings of the quality check.
    pub findings: Vec<Finding>,
}

impl Log {
    /// Reads the whole log.
    pub fn read(source: &mut dyn Source, torque: Quantity, keep: Acceptance) -> Result<Self, LogError> {
        let layout = source.layout().clone();
        let (mut columns, mut starts) = (vec![Vec::new(); layout.roles.len()], Vec::new());
        let passed = each_block(source, torque, keep, |rows, starting| {
            let before = columns.first().map_or(0, Vec::len);
            starts.extend(starting.iter().map(|row| before + row));
            columns.iter_mut().zip(rows).for_each(|(to, from)| to.extend_from_slice(from));
            Ok::<(), LogError>(())
        })?;
        Ok(Self { layout, columns, starts, findings: passed.findings })
    }

    /// Number of rows.
    pub fn len(&self) -> usize {
        self.columns.first().map_or(0, Vec::len)
    }

    /// Whether the log has no rows.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Column with this role.
    pub fn column(&self, role: Role) -> Option<&[f64]> {
        self.layout.find(role).map(|i| self.columns[i].as_slice())
    }

    /// Column of a joint quantity.
    pub fn joint(&self, quantity: Quantity, joint: usize) -> Option<&[f64]> {
        self.column(Role::Joint(quantity, joint))
    }
}

/// Summary of a log that was streamed.
#[derive(Debug, Clone, PartialEq)]
pub struct Passed {
    /// Layout of the columns.
    pub layout: Layout,
    /// Number of accepted rows.
    pub rows: usize,
    /// Number of segments.
    pub segments: usize,
    /// Findings of the quality check.
    pub findings: Vec<Finding>,
}

/// Passes the accepted rows on to `sink`, one block at a time: one vector per column, and the rows
/// of the block that start a segment. A rejected log returns its error only after the last row.
///
/// # Errors
/// If the log can't be used, and the errors of `sink`.
pub fn each_block<E: From<LogError>>(
    source: &mut dyn Source,
    torque: Quantity,
    keep: Acceptance,
    mut sink: impl FnMut(&[Vec<f64>], &[usize]) -> Result<(), E>,
) -> Result<Passed, E> {
    let layout = source.layout().clone();
    let mut check = QualityCheck::new(&layout, &[torque], keep);
    let (mut block, mut verdicts) = (Block::default(), Vec::new());
    let (mut rows, mut segments) = (0, 0);
    loop {
        source.next_block(8192, &mut block)?;
        if block.is_empty() {
            break;
        }
        check.admit(&block, &mut verdicts);
        let mut starts = Vec::new();
        let mut columns: Vec<Vec<f64>> = vec![Vec::new(); layout.roles.len()];
        for (row, verdict) in verdicts.iter().enumerate().filter(|(_, v)| **v != Verdict::Drop) {
            if *verdict == Verdict::Start {
                starts.push(columns.first().map_or(0, Vec::len));
            }
            columns.iter_mut().zip(&block.columns).for_each(|(to, from)| to.push(from[row]));
        }
        rows += columns.first().map_or(0, Vec::len);
        segments += starts.len();
        sink(&columns, &starts)?;
    }
    let findings = check.finish();
    if findings.iter().any(Finding::is_fatal) {
        return Err(LogError::Rejected { file: layout.file, findings }.into());
    }
    Ok(Passed { layout, rows, segments, findings })
}
