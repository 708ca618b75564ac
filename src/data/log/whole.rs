//! A log in memory, for those who need all of it at once.

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

/// Rows that passed the doctor, in segments.
#[derive(Debug, Clone, PartialEq)]
pub struct Log {
    /// The columns.
    pub layout: Layout,
    /// Values, one vector per used column, in the order of [`Layout::roles`].
    pub columns: Vec<Vec<f64>>,
    /// First row of each segment.
    pub starts: Vec<usize>,
    /// What the doctor found.
    pub findings: Vec<Finding>,
}

impl Log {
    /// Reads all of it.
    pub fn read(source: &mut dyn Source, torque: Quantity, keep: Acceptance) -> Result<Self, LogError> {
        let layout = source.layout().clone();
        let mut doctor = QualityCheck::new(&layout, torque, keep);
        let mut columns: Vec<Vec<f64>> = vec![Vec::new(); layout.roles.len()];
        let (mut block, mut verdicts, mut starts) = (Block::default(), Vec::new(), Vec::new());
        loop {
            source.next_block(8192, &mut block)?;
            if block.is_empty() {
                break;
            }
            doctor.admit(&block, &mut verdicts);
            for (row, verdict) in verdicts.iter().enumerate().filter(|(_, v)| **v != Verdict::Drop) {
                if *verdict == Verdict::Start {
                    starts.push(columns.first().map_or(0, Vec::len));
                }
                for (to, from) in columns.iter_mut().zip(&block.columns) {
                    to.push(from[row]);
                }
            }
        }
        let findings = doctor.finish();
        if findings.iter().any(Finding::is_fatal) {
            return Err(LogError::Rejected { file: layout.file, findings });
        }
        Ok(Self { layout, columns, starts, findings })
    }

    /// Number of rows.
    pub fn len(&self) -> usize {
        self.columns.first().map_or(0, Vec::len)
    }

    /// Whether there is no row.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// A column by its role.
    pub fn column(&self, role: Role) -> Option<&[f64]> {
        self.layout.find(role).map(|i| self.columns[i].as_slice())
    }

    /// A joint's column.
    pub fn joint(&self, quantity: Quantity, joint: usize) -> Option<&[f64]> {
        self.column(Role::Joint(quantity, joint))
    }
}
