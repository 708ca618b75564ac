//! Measured data: files are read as blocks of rows, the quality check examines each row, and
//! accepted rows are passed on.
//!
//! [`Table`] (CSV, Parquet, MCAP, npz, mat) -> [`Reading`] (names to roles, units to SI) ->
//! [`Source`] of [`Block`]s -> [`QualityCheck`] -> rows in segments. This module opens no files;
//! the caller passes bytes. It depends on the columns of a log and on joint names, not on robots.

mod acceptance;
mod arrays;
mod block;
mod column;
pub mod csv;
mod digest;
mod error;
mod finding;
mod fingerprint;
mod gzip;
mod inspect;
mod limits;
mod malformed;
mod mapping;
mod mapping_error;
mod matlab;
mod npz;
mod open;
pub mod parquet;
mod quality_check;
mod replay;
pub(crate) mod ros;
mod rounded;
mod smallest_hashes;
mod table;
mod unit;
mod utf16;
mod whole;

pub use acceptance::Acceptance;
pub use block::{BadCell, Block, Source};
pub use column::{Layout, Quantity, Role};
pub use digest::{Digest, Digested, hexadecimal};
pub use error::LogError;
pub use finding::{Clock, Explanation, Finding, Kind, Severity, Unexplained};
pub use fingerprint::{Common, Fingerprint, Fingerprinted};
pub use inspect::{ChannelSummary, ClockSummary, Proposal, propose};
pub use limits::{Limits, beyond_limits, torque_unit};
pub use malformed::{Malformed, TooManyNumbers};
pub use mapping::{Channel, Mapping, Reading, SourceJoint};
pub use mapping_error::MappingError;
pub use matlab::MatError;
pub use npz::NpzError;
#[cfg(feature = "rosbag2")]
pub use open::open_sqlite;
pub use open::{Format, open, open_parquet, open_table, open_with, source};
pub use quality_check::{QualityCheck, Reached, Verdict};
pub use replay::Replay;
pub use ros::{CdrError, McapError};
pub use table::Table;
pub use unit::UnitError;
pub use whole::{Log, Passed, each_block};

#[cfg(test)]
mod tests;
