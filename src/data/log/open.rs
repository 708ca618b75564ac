//! Which reader a log needs, seen from its first bytes.

use std::io::{Cursor, Read};

use super::LogError;
use super::Source;
use super::csv::CsvSource;
use super::parquet::ParquetSource;

/// Format of a log's bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// Text.
    Csv,
    /// Gzipped text.
    CsvGz,
    /// Parquet.
    Parquet,
}

impl Format {
    /// From the first four bytes.
    pub fn of(magic: &[u8]) -> Self {
        match magic {
            [0x1f, 0x8b, ..] => Self::CsvGz,
            [b'P', b'A', b'R', b'1', ..] => Self::Parquet,
            _ => Self::Csv,
        }
    }
}

/// A reader for a log in any of the formats. `file` is its name for messages. CSV is read as a
/// stream; a Parquet file, which is read from its end, is taken into memory as it is (compressed).
pub fn open<'a, R: Read + 'a>(file: &str, mut input: R) -> Result<Box<dyn Source + 'a>, LogError> {
    let failed = |source| LogError::Read { file: file.into(), line: 1, source };
    let mut magic = Vec::with_capacity(4);
    input.by_ref().take(4).read_to_end(&mut magic).map_err(failed)?;
    let format = Format::of(&magic);
    let mut whole = Cursor::new(magic).chain(input);
    Ok(match format {
        Format::Csv => Box::new(CsvSource::new(file, whole)?),
        Format::CsvGz => Box::new(CsvSource::new(file, flate2::read::MultiGzDecoder::new(whole))?),
        Format::Parquet => {
            let mut bytes = Vec::new();
            whole.read_to_end(&mut bytes).map_err(failed)?;
            Box::new(ParquetSource::new(file, bytes.into())?)
        }
    })
}
