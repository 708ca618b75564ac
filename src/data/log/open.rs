//! Chooses the reader of a log by its first bytes.

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

/// Format of a log's bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// Text.
    Csv,
    /// Text of two bytes a letter.
    CsvUtf16,
    /// Gzipped text.
    CsvGz,
    /// Parquet.
    Parquet,
    /// Recording of ROS 2 messages.
    Mcap,
    /// Arrays of NumPy, `np.savez`.
    Npz,
    /// Variables of MATLAB, version 5 to 7.
    Mat,
    /// Recording of ROS 2 in SQLite.
    Sqlite,
    /// Something that is known and not read, with what to do about it.
    Foreign(&'static str),
}

impl Format {
    /// From the first bytes, sixteen where there are as many.
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

/// Has it the header of a matrix of MATLAB 4? It begins with four numbers of four bytes: type,
/// rows, columns, and whether there are imaginary parts.
fn is_matlab_4(magic: &[u8]) -> bool {
    let numbers = |read: fn([u8; 4]) -> u32| -> Option<[u32; 4]> {
        let mut all = magic.chunks_exact(4).filter_map(|b| Some(read(b.try_into().ok()?)));
        Some([all.next()?, all.next()?, all.next()?, all.next()?])
    };
    // Thousands of the type: byte order; tens: type of number; ones: numbers, text or sparse.
    let header = |[kind, rows, columns, imaginary]: [u32; 4], order: u32| {
        let size = 1..100_000_000;
        let known = kind / 1000 == order && (kind % 1000) / 10 <= 5 && kind % 10 <= 2;
        known && size.contains(&rows) && size.contains(&columns) && imaginary <= 1
    };
    numbers(u32::from_le_bytes).is_some_and(|n| header(n, 0))
        || numbers(u32::from_be_bytes).is_some_and(|n| header(n, 1))
}

/// What to do with an SQLite recording.
const SQLITE: &str = if cfg!(feature = "rosbag2") {
    "an SQLite recording of ROS 2 is read from its file, not through a pipe; name the file"
} else {
    "this is an SQLite recording of ROS 2, which this build does not read; build it with `cargo install --path . --features rosbag2`, \
     or turn the recording into MCAP with `ros2 bag convert`"
};

/// Bytes of a file that is taken into memory at most.
const MOST_BYTES: u64 = 64 << 20;

/// A log as a table: its columns by the names that the file gives them. `file` is its name for
/// messages. CSV and MCAP are read as streams; the others are taken into memory, up to 64 MiB.
/// [`open_parquet`] reads Parquet of any length.
///
/// # Errors
/// Where the bytes can't be read, or are of a format that is not read.
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

/// A Parquet log as a table, read by seeking.
///
/// # Errors
/// Where the bytes can't be read.
pub fn open_parquet<C: ChunkReader + 'static>(file: &str, chunks: C) -> Result<Box<dyn Table>, LogError> {
    Ok(Box::new(ParquetTable::new(file, chunks)?))
}

/// A recording of ROS 2 in SQLite as a table.
///
/// # Errors
/// Where the tables are not those of rosbag2, or have no message with numbers.
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

/// The rows of a table in the roles that joints' names and mapping give them.
///
/// # Errors
/// Where a column that must be there is not.
pub fn source<'a>(file: &str, table: Box<dyn Table + 'a>, reading: &Reading) -> Result<Box<dyn Source + 'a>, LogError> {
    Ok(Box::new(MappedTable::new(file, table, reading)?))
}

/// A reader for a log in any of the formats, whose columns have the log format's names.
///
/// # Errors
/// As [`open_with`].
pub fn open<'a, R: Read + Send + 'a>(file: &str, input: R) -> Result<Box<dyn Source + 'a>, LogError> {
    open_with(file, input, &Reading::default())
}

/// A reader for a log in any of the formats; joints' names and mapping say what its columns are.
///
/// # Errors
/// Where the bytes can't be read, or a column that must be there is not.
pub fn open_with<'a, R: Read + Send + 'a>(
    file: &str,
    input: R,
    reading: &Reading,
) -> Result<Box<dyn Source + 'a>, LogError> {
    source(file, open_table(file, input, reading)?, reading)
}
