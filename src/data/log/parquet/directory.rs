//! Checks the claims of a Parquet file before the library reads it. The library trusts these
//! numbers: it allocates as much as they state, and panics if a column lies outside the file.

use std::sync::Arc;

use ::parquet::errors::ParquetError;
use ::parquet::file::metadata::{ColumnChunkMetaData, ParquetMetaData};
use ::parquet::file::reader::{ChunkReader, Length};

use super::thrift::{Compact, Value};

/// Longest directory, bytes: 1000 row groups of 60 columns need about 6 MB.
const LONGEST_DIRECTORY: u64 = 16 << 20;
/// Number of rows that a file of any size may have.
const LEAST_ROWS: u64 = 1 << 20;
/// Number of list elements that a row group of any size may have.
const LEAST_VALUES: u64 = 1 << 22;
/// Deepest nesting of columns.
const DEEPEST: usize = 16;
/// Bytes that contain the header of a page.
const PAGE_HEADER: u64 = 1 << 14;
/// Largest sum of unpacked pages held at once, one of each column, bytes.
const MOST_PAGES: u64 = 96 << 20;

/// Reason why the claims of a file are implausible.
#[derive(Debug, thiserror::Error)]
pub(super) enum DirectoryError {
    #[error("it does not end as a Parquet file does; it may have been cut")]
    End,
    #[error("its directory has {0} bytes; {LONGEST_DIRECTORY} are read at most")]
    Long(u64),
    #[error("its directory is damaged")]
    Damaged,
    #[error("it claims {rows} rows in {bytes} bytes, and no recording packs that well")]
    Rows { rows: i64, bytes: u64 },
    #[error("it claims {rows} rows in row group {group}, of {all} in all")]
    GroupRows { rows: i64, group: usize, all: i64 },
    #[error("its directory puts the column `{column}` of row group {group} outside of the file")]
    Outside { column: String, group: usize },
    #[error("the column `{column}` claims {values} elements of lists, and no recording packs that well")]
    Values { column: String, values: u64 },
    #[error("a page of the column `{0}` is damaged")]
    Page(String),
    #[error(
        "the pages of row group {group} have {megabytes} MB at once; {} are held at most: write it with smaller pages or row groups",
        MOST_PAGES >> 20
    )]
    Pages { group: usize, megabytes: u64 },
    #[error(transparent)]
    Read(#[from] ParquetError),
}

/// Bytes of a file, shared by the library and the checks.
pub(super) struct Shared<C>(Arc<C>);

impl<C> Shared<C> {
    pub(super) fn new(chunks: C) -> Self {
        Self(Arc::new(chunks))
    }
}

impl<C> Clone for Shared<C> {
    fn clone(&self) -> Self {
        Self(Arc::clone(&self.0))
    }
}

impl<C: Length> Length for Shared<C> {
    fn len(&self) -> u64 {
        self.0.len()
    }
}

impl<C: ChunkReader> ChunkReader for Shared<C> {
    type T = C::T;

    fn get_read(&self, start: u64) -> Result<Self::T, ParquetError> {
        self.0.get_read(start)
    }

    fn get_bytes(&self, start: u64, length: usize) -> Result<bytes::Bytes, ParquetError> {
        self.0.get_bytes(start, length)
    }
}

/// Checks that the directory can be read in bounded memory.
pub(super) fn readable(chunks: &impl ChunkReader) -> Result<(), DirectoryError> {
    let end = chunks.len().checked_sub(8).ok_or(DirectoryError::End)?;
    let tail = chunks.get_bytes(end, 8)?;
    let Some((length, magic)) = tail.split_first_chunk::<4>() else { return Err(DirectoryError::End) };
    let length = u64::from(u32::from_le_bytes(*length));
    if magic != b"PAR1" || length > end {
        return Err(DirectoryError::End);
    }
    if length > LONGEST_DIRECTORY {
        return Err(DirectoryError::Long(length));
    }
    let directory = chunks.get_bytes(end - length, length as usize)?;
    plausible(&directory).ok_or(DirectoryError::Damaged)
}

/// Parses the directory; `None` if it is malformed, or its columns are not a tree of moderate
/// depth.
fn plausible(directory: &[u8]) -> Option<()> {
    let mut compact = Compact::new(directory);
    let mut last = 0;
    while let Some((number, value)) = compact.field(last)? {
        match (number, value) {
            (2, Value::List(12, count)) => schema(&mut compact, count)?,
            _ => compact.pass(value, 1)?,
        }
        last = number;
    }
    Some(())
}

/// Parses the columns, each before its children.
fn schema(compact: &mut Compact<'_>, count: usize) -> Option<()> {
    // Number of children still to come for each ancestor of the current column.
    let mut open: Vec<usize> = Vec::new();
    for left in (0..count).rev() {
        let (mut last, mut children) = (0, 0);
        while let Some((number, value)) = compact.field(last)? {
            if let (5, Value::Number(n)) = (number, value) {
                children = usize::try_from(n).ok().filter(|n| *n <= left)?;
            }
            compact.pass(value, 2)?;
            last = number;
        }
        if let Some(siblings) = open.last_mut() {
            *siblings = siblings.checked_sub(1)?;
        }
        open.push(children);
        while open.pop_if(|n| *n == 0).is_some() {}
        if open.len() > DEEPEST {
            return None;
        }
    }
    Some(())
}

/// Checks that a file of `bytes` bytes can have the rows and columns that its directory claims.
pub(super) fn possible(directory: &ParquetMetaData, bytes: u64) -> Result<(), DirectoryError> {
    let all = directory.file_metadata().num_rows();
    // A column that changes needs more than a sixteenth of a byte per row.
    if u64::try_from(all).map_or(true, |rows| rows > LEAST_ROWS + 16 * bytes) {
        return Err(DirectoryError::Rows { rows: all, bytes });
    }
    let inside = |column: &ColumnChunkMetaData| {
        range(column).and_then(|(start, length)| start.checked_add(length)).is_some_and(|end| end <= bytes)
    };
    for (row_group, group) in directory.row_groups().iter().zip(1..) {
        if let Some(column) = row_group.columns().iter().find(|column| !inside(column)) {
            return Err(DirectoryError::Outside { column: column.column_path().string(), group });
        }
        let rows = row_group.num_rows();
        if !(0..=all).contains(&rows) {
            return Err(DirectoryError::GroupRows { rows, group, all });
        }
    }
    Ok(())
}

/// Start and length of a column in the file, bytes; `None` if one is negative.
fn range(column: &ColumnChunkMetaData) -> Option<(u64, u64)> {
    let start = column.dictionary_page_offset().unwrap_or(column.data_page_offset());
    let length = u64::try_from(column.compressed_size()).ok();
    u64::try_from(start).ok().filter(|_| column.data_page_offset() >= 0).zip(length)
}

/// Checks that the pages of these columns of a row group (from 0) fit into memory.
pub(super) fn pages(
    chunks: &impl ChunkReader,
    directory: &ParquetMetaData,
    group: usize,
    columns: &[usize],
) -> Result<(), DirectoryError> {
    let mut held = 0;
    for column in columns.iter().filter_map(|&k| directory.row_group(group).columns().get(k)) {
        let damaged = || DirectoryError::Page(column.column_path().string());
        let (mut at, length) = range(column).ok_or_else(damaged)?;
        let end = at.checked_add(length).ok_or_else(damaged)?;
        let (mut largest, mut dictionary, mut values) = (0, 0, 0);
        while at < end {
            let header = chunks.get_bytes(at, (end - at).min(PAGE_HEADER) as usize)?;
            let page = Page::of(&header).ok_or_else(damaged)?;
            let kept = if page.dictionary { &mut dictionary } else { &mut largest };
            *kept = page.unpacked.max(*kept);
            values += page.values;
            at = at.checked_add(page.packed).ok_or_else(damaged)?;
        }
        // One row may hold all of the values, and a row is read at once.
        if column.column_descr().max_rep_level() > 0 && values > LEAST_VALUES + chunks.len() {
            return Err(DirectoryError::Values { column: column.column_path().string(), values });
        }
        held += largest + dictionary;
    }
    match held > MOST_PAGES {
        true => Err(DirectoryError::Pages { group: group + 1, megabytes: held >> 20 }),
        false => Ok(()),
    }
}

/// Sizes of a page, bytes.
struct Page {
    dictionary: bool,
    unpacked: u64,
    /// Number of values in the page.
    values: u64,
    /// Packed size with the header.
    packed: u64,
}

impl Page {
    fn of(bytes: &[u8]) -> Option<Self> {
        let mut compact = Compact::new(bytes);
        let size = |n: i64| u64::try_from(n).ok().filter(|n| *n < 1 << 31);
        let (mut last, mut numbers, mut values) = (0, [0; 3], 0);
        while let Some((number, value)) = compact.field(last)? {
            match (number, value) {
                (1..=3, Value::Number(n)) => numbers[number as usize - 1] = size(n)?,
                // Headers of data pages begin with the number of values.
                (5 | 8, Value::Structure) => {
                    let mut inner = 0;
                    while let Some((number, value)) = compact.field(inner)? {
                        if let (1, Value::Number(n)) = (number, value) {
                            values = size(n)?;
                        }
                        compact.pass(value, 2)?;
                        inner = number;
                    }
                }
                _ => compact.pass(value, 1)?,
            }
            last = number;
        }
        let [kind, unpacked, packed] = numbers;
        Some(Self { dictionary: kind == 2, unpacked, values, packed: packed + compact.position() as u64 })
    }
}
