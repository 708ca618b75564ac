//! Reasons why the bytes of a file do not conform to its format.

use super::matlab::MatError;
use super::npz::NpzError;
use super::ros::{CdrError, McapError};

/// Reason why the bytes of a file do not conform to its format, or hold no numbers.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Malformed {
    /// The file has no array that is a column.
    #[error("it has no array of numbers")]
    NoArray,
    /// A variable of a MATLAB file is malformed.
    #[error(transparent)]
    Mat(#[from] MatError),
    /// The zip archive around NumPy arrays is malformed.
    #[error(transparent)]
    Zip(#[from] zip::result::ZipError),
    /// A NumPy array is malformed.
    #[error("array `{array}`: {source}")]
    Npz {
        /// Name of the array.
        array: String,
        /// Error of the array.
        source: NpzError,
    },
    /// A record of an MCAP file is malformed.
    #[error(transparent)]
    Mcap(#[from] McapError),
    /// The SQLite database of a rosbag2 recording can't be read.
    #[cfg(feature = "rosbag2")]
    #[error(transparent)]
    Sqlite(#[from] rusqlite::Error),
    /// The SQLite database was not written by rosbag2.
    #[cfg(feature = "rosbag2")]
    #[error("its tables are not those of rosbag2: {0}")]
    OtherTables(#[source] rusqlite::Error),
    /// The recording has only text or images.
    #[error("it has no message with numbers{}{}", if .passed_over.is_empty() { "" } else { ": " }, .passed_over.join("; "))]
    NoNumbers {
        /// Topics that can't be decoded.
        passed_over: Vec<String>,
    },
    /// Too many messages of a recording are damaged.
    #[error("{count} messages can't be decoded, the last on {topic}: {source}")]
    Damaged {
        /// Number of damaged messages.
        count: usize,
        /// Topic of the last damaged message.
        topic: String,
        /// Error of the last damaged message.
        source: CdrError,
    },
}

/// The file has more numbers than are read into memory.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("there are more numbers than are taken into memory (8 million in all); write Parquet in place of it")]
pub struct TooManyNumbers;
