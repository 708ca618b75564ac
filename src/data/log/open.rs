//! Detects the format of a log from its first bytes and opens the matching reader.

use std::io::{Cursor, Read};

use ::parquet::file::reader::ChunkReader;

use super::LogError;
use super::Reading;
use super::Source;
use super::Table;
use super::csv::CsvTable;
use super::gzip::Unpacked;
use super::matlab::MatTable;
use super::npz::NpzTable;
use super::parquet::ParquetTable;
use super::ros::{McapMessages, Recording};
use super::table::MappedTable;
use super::utf16::Utf16;

/// Format of a log file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// CSV in UTF-8.
    Csv,
    /// CSV in UTF-16.
    CsvUtf16,
    /// Gzipped CSV text.
    CsvGz,
    /// Parquet file.
    Parquet,
    /// MCAP recording of ROS 2 messages.
    Mcap,
    /// NumPy arrays of `np.savez`.
    Npz,
    /// MATLAB variables, version 5 to 7.
    Mat,
    /// SQLite recording of ROS 2.
    Sqlite,
    /// A recognised format that is not read, with advice.
    Foreign(&'static str),
}

impl Format {
    /// Detects the format from the first bytes, sixteen if there are as many.
    pub fn of(magic: &[u8]) -> Self {
        match magic {
            [0x1f, 0x8b, ..] => Self::CsvGz,
            [0xff, 0xfe, ..] | [0xfe, 0xff, ..] => Self::CsvUtf16,
            [b'P', b'A', b'R', b'1', ..] => Self::Parquet,
            [0x89, b'M', b'C', b'A', b'P', ..] => Self::Mcap,
            [b'P', b'K', 3, 4, ..] => Self::Npz,
            _ if magic.starts_with(b"MATLAB 5.0 MAT-") => Self::Mat,
            _ if magic.starts_with(b"MATLAB 7.3 MAT-") || magic.starts_with(b"\x89HDF\r\n") => Self::Foreign(
                "this is HDF5 (MATLAB 7.3 writes it), which is not read; save it with `save('x.mat', '-v7')`, or as CSV",
            ),
            _ if magic.starts_with(b"\x93NUMPY") => Self::Foreign(
                "this is one NumPy array without names; save the columns by name with `np.savez('x.npz', t=t, q=q, tau=tau)`",
            ),
            _ if magic.starts_with(b"SQLite format 3") => Self::Sqlite,
            _ if magic.starts_with(b"\x28\xb5\x2f\xfd") => {
                Self::Foreign("this is packed with zstd; unpack it with `zstd -d`")
            }
            _ if magic.starts_with(b"#ROSBAG") => Self::Foreign(
                "this is a recording of ROS 1, which is not read; turn it into MCAP with `rosbags-convert`",
            ),
            _ if magic.starts_with(b"ULog") => {
                Self::Foreign("this is a ULog, which is not read; turn it into CSV with `ulog2csv`")
            }
            _ if is_matlab_4(magic) => Self::Foreign(
                "this is a file of MATLAB 4, which is not read; save it with `save('x.mat', '-v7')`, or as CSV",
            ),
            _ => Self::Csv,
        }
    }
}

/// Whether the bytes are the header of a MATLAB 4 matrix, which begins with four 4-byte numbers:
/// type, rows, columns, and whether there are imaginary parts.
fn is_matlab_4(magic: &[u8]) -> bool {
    let numbers = |read: fn([u8; 4]) -> u32| -> Option<[u32; 4]> {
        let mut all = magic.chunks_exact(4).filter_map(|b| Some(read(b.try_into().ok()?)));
        Some([all.next()?, all.next()?, all.next()?, all.next()?])
    };
    // Digits of the type: thousands, byte order; tens, number format; ones, text or sparse.
    let header = |[kind, rows, columns, imaginary]: [u32; 4], order: u32| {
        let size = 1..100_000_000;
        let known = kind / 1000 == order && (kind % 1000) / 10 <= 5 && kind % 10 <= 2;
        known && size.contains(&rows) && size.contains(&columns) && imaginary <= 1
    };
    numbers(u32::from_le_bytes).is_some_and(|n| header(n, 0))
        || numbers(u32::from_be_bytes).is_some_and(|n| header(n, 1))
}

/// Advice for an SQLite recording.
const SQLITE: &str = if cfg!(feature = "rosbag2") {
    "an SQLite recording of ROS 2 is read from its file, not through a pipe; name the file"
} else {
    "this is an SQLite recording of ROS 2, which this build does not read; build it with `cargo install --path . --features rosbag2`, \
     or turn the recording into MCAP with `ros2 bag convert`"
};

/// Largest file that is read into memory, bytes.
const MOST_BYTES: u64 = 64 << 20;

/// Opens a log as a table whose columns keep the names of the file. `file` is the name for
/// messages. CSV and MCAP are read as streams; other formats are read into memory, up to 64 MiB.
/// [`open_parquet`] reads Parquet of any length.
///
/// # Errors
/// If the bytes can't be read, or their format is not supported.
pub fn open_table<'a, R: Read + Send + 'a>(
    file: &str,
    mut input: R,
    reading: &Reading,
) -> Result<Box<dyn Table + 'a>, LogError> {
    let failed = |source| LogError::Read { file: file.into(), line: 1, source };
    let mut magic = Vec::with_capacity(16);
    input.by_ref().take(16).read_to_end(&mut magic).map_err(failed)?;
    let format = Format::of(&magic);
    let mut whole = Cursor::new(magic).chain(input);
    let mut read = || {
        let mut bytes = Vec::new();
        whole.by_ref().take(MOST_BYTES + 1).read_to_end(&mut bytes).map_err(failed)?;
        if bytes.len() as u64 > MOST_BYTES {
            let what = match format {
                Format::Parquet => {
                    "Parquet that comes through a pipe is taken into memory, up to 64 MiB; name its file"
                }
                _ => "a file of this kind is taken into memory, up to 64 MiB; write CSV or Parquet in its place",
            };
            return Err(LogError::Foreign { file: file.into(), what: what.into() });
        }
        Ok(bytes)
    };
    Ok(match format {
        Format::Parquet => Box::new(ParquetTable::new(file, bytes::Bytes::from(read()?))?),
        Format::Npz => Box::new(NpzTable::new(file, read()?)?),
        Format::Mat => Box::new(MatTable::new(file, &read()?)?),
        Format::Sqlite => return Err(LogError::Foreign { file: file.into(), what: SQLITE.into() }),
        Format::Foreign(what) => return Err(LogError::Foreign { file: file.into(), what: what.into() }),
        Format::Csv => Box::new(CsvTable::new(file, whole)?),
        Format::CsvUtf16 => Box::new(CsvTable::new(file, Utf16::new(whole))?),
        Format::CsvGz => Box::new(CsvTable::new(file, Unpacked::new(whole))?),
        Format::Mcap => {
            let arrival = reading.mapping.as_ref().is_some_and(|m| m.arrival);
            Box::new(Recording::new(file, "MCAP", McapMessages::new(whole), arrival)?)
        }
    })
}

/// Opens a Parquet log as a table, read by seeking.
///
/// # Errors
/// If the bytes can't be read.
pub fn open_parquet<C: ChunkReader + 'static>(file: &str, chunks: C) -> Result<Box<dyn Table>, LogError> {
    Ok(Box::new(ParquetTable::new(file, chunks)?))
}

/// Opens an SQLite recording of ROS 2 as a table.
///
/// # Errors
/// If the tables are not those of rosbag2, or have no message with numbers.
#[cfg(feature = "rosbag2")]
pub fn open_sqlite(
    file: &str,
    connection: rusqlite::Connection,
    reading: &Reading,
) -> Result<Box<dyn Table>, LogError> {
    let failed = |e| LogError::malformed(file, "SQLite", super::Malformed::OtherTables(e));
    let messages = super::ros::SqliteMessages::new(connection).map_err(failed)?;
    let arrival = reading.mapping.as_ref().is_some_and(|m| m.arrival);
    Ok(Box::new(Recording::new(file, "SQLite", messages, arrival)?))
}

/// Source of a table's rows, with the roles given by joint names and mapping.
///
/// # Errors
/// If a required column is missing.
pub fn source<'a>(file: &str, table: Box<dyn Table + 'a>, reading: &Reading) -> Result<Box<dyn Source + 'a>, LogError> {
    Ok(Box::new(MappedTable::new(file, table, reading)?))
}

/// Opens a log in any supported format whose columns have the names of the log format.
///
/// # Errors
/// As [`open_with`].
pub fn open<'a, R: Read + Send + 'a>(file: &str, input: R) -> Result<Box<dyn Source + 'a>, LogError> {
    open_with(file, input, &Reading::default())
}

/// Opens a log in any supported format; `reading` maps its columns to roles.
///
/// # Errors
/// If the bytes can't be read, or a required column is missing.
pub fn open_with<'a, R: Read + Send + 'a>(
    file: &str,
    input: R,
    reading: &Reading,
) -> Result<Box<dyn Source + 'a>, LogError> {
    source(file, open_table(file, input, reading)?, reading)
}
