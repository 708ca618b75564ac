//! Measured data: files become blocks of rows, the doctor looks at each row, and what passes goes
//! on.
//!
//! `Source` (CSV, Parquet) -> [`Block`] -> [`QualityCheck`] -> rows in segments. Nothing here opens
//! a file: the caller hands in bytes. Knows the columns of contract section 3; knows no robot.

mod acceptance;
mod block;
mod column;
pub mod csv;
mod error;
mod finding;
mod fingerprint;
mod limits;
mod open;
pub mod parquet;
mod quality_check;
mod replay;
mod rounded;
mod whole;

pub use acceptance::Acceptance;
pub use block::{BadCell, Block, Source};
pub use column::{Layout, Quantity, Role};
pub use error::LogError;
pub use finding::{Clock, Explanation, Finding, Kind, Severity};
pub use fingerprint::{Common, Fingerprint, Fingerprinted};
pub use limits::{Limits, beyond, torque_unit};
pub use open::{Format, open};
pub use quality_check::{QualityCheck, Reached, Verdict};
pub use replay::Replay;
pub use whole::Log;

#[cfg(test)]
mod tests;
