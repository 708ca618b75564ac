//! Where the bytes of a file are not those of its format.

use super::matlab::MatError;
use super::npz::NpzError;
use super::ros::{CdrError, McapError};

/// Where the bytes of a file are not those of its format, or hold no numbers.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Malformed {
    /// No array that is a column.
    #[error("it has no array of numbers")]
    NoArray,
    /// A variable of MATLAB.
    #[error(transparent)]
    Mat(#[from] MatError),
    /// The zip around arrays of NumPy.
    #[error(transparent)]
    Zip(#[from] zip::result::ZipError),
    /// An array of NumPy.
    #[error("array `{array}`: {source}")]
    Npz {
        /// Its name.
        array: String,
        /// What is wrong with it.
        source: NpzError,
    },
    /// A record of an MCAP file.
    #[error(transparent)]
    Mcap(#[from] McapError),
    /// A message of rosbag2's SQLite.
    #[cfg(feature = "rosbag2")]
    #[error(transparent)]
    Sqlite(#[from] rusqlite::Error),
    /// SQLite of another program.
    #[cfg(feature = "rosbag2")]
    #[error("its tables are not those of rosbag2: {0}")]
    OtherTables(#[source] rusqlite::Error),
    /// A recording of text or images alone.
    #[error("it has no message with numbers{}{}", if .passed_over.is_empty() { "" } else { ": " }, .passed_over.join("; "))]
    NoNumbers {
        /// Topics that can't be decoded.
        passed_over: Vec<String>,
    },
    /// Too many messages of a recording are damaged.
    #[error("{count} messages can't be decoded, the last on {topic}: {source}")]
    Damaged {
        /// Messages.
        count: usize,
        /// Topic of the last one.
        topic: String,
        /// What is wrong with it.
        source: CdrError,
    },
}

/// More numbers than are taken into memory.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("there are more numbers than are taken into memory (8 million in all); write Parquet in place of it")]
pub struct TooManyNumbers;
