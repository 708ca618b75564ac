//! Reads Parquet files with columns of numbers and of lists of numbers, and writes Parquet.

mod directory;
mod thrift;

use std::cell::Cell;
use std::sync::Arc;

use super::BadCell;
use super::Block;
use super::Layout;
use super::Log;
use super::LogError;
use super::Table;
use directory::{DirectoryError, Shared};

use ::parquet::{
    basic::{ConvertedType, LogicalType, Repetition, TimeUnit},
    column::reader::{ColumnReader, ColumnReaderImpl},
    data_type::{DataType, DoubleType, FloatType, Int32Type, Int64Type},
    errors::ParquetError,
    file::{
        properties::WriterProperties,
        reader::{ChunkReader, FileReader, Length, SerializedFileReader},
        writer::SerializedFileWriter,
    },
    schema::{parser::parse_message_type, types::ColumnDescriptor},
};

/// A column of the file: numbers, or lists of numbers with the same length in every row.
struct Leaf {
    name: String,
    /// Maximum repetition and definition level: `(0, 0 or 1)` for a number, `(1, n)` for a list.
    levels: (i16, i16),
    /// Whether an element of a list may be null.
    nullable: bool,
    /// Number of elements of the first list; 1 for a number.
    width: usize,
    /// For a time stamp column: seconds per count, and the first count, which is subtracted.
    stamp: Option<(f64, Cell<Option<i64>>)>,
}

/// A Parquet file read row group by row group, one block of rows at a time. A list column becomes
/// as many columns as its first list has elements: `state[0]`, `state[1]`, ..
pub struct ParquetTable<C: ChunkReader + 'static> {
    file: String,
    reader: SerializedFileReader<Shared<C>>,
    chunks: Shared<C>,
    leaves: Vec<Leaf>,
    names: Vec<String>,
    /// Leaf and element of each column name.
    owner: Vec<(usize, usize)>,
    /// Leaves that are read, and for each selected column its index among them and its element.
    wanted: Vec<usize>,
    selected: Vec<(usize, usize)>,
    group: usize,
    left: usize,
    columns: Vec<ColumnReader>,
    row: u64,
}

impl<C: ChunkReader + 'static> ParquetTable<C> {
    /// Reads the schema.
    ///
    /// # Errors
    /// If the file is not Parquet, has no columns, or claims more rows than it can hold.
    pub fn new(file: &str, chunks: C) -> Result<Self, LogError> {
        let chunks = Shared::new(chunks);
        let refused = |e: DirectoryError| LogError::Parquet { file: file.into(), what: e.to_string() };
        directory::readable(&chunks).map_err(refused)?;
        let reader = SerializedFileReader::new(chunks.clone()).map_err(|e| failed(file, e))?;
        directory::possible(reader.metadata(), Length::len(&chunks)).map_err(refused)?;
        let schema = reader.metadata().file_metadata().schema_descr_ptr();
        let mut table = Self {
            file: file.into(),
            reader,
            chunks,
            leaves: Vec::new(),
            names: Vec::new(),
            owner: Vec::new(),
            wanted: Vec::new(),
            selected: Vec::new(),
            group: 0,
            left: 0,
            columns: Vec::new(),
            row: 1,
        };
        for (index, column) in schema.columns().iter().enumerate() {
            let levels = (column.max_rep_level(), column.max_def_level());
            let parts = column.path().parts();
            // The list's own name precedes `.list.element` or `.bag.array_element`.
            let name = if levels.0 == 1 {
                parts[..parts.len().saturating_sub(2).max(1)].join(".")
            } else {
                column.path().string()
            };
            // The library's `is_optional` holds for a repeated element, too.
            let element = column.self_type().get_basic_info();
            let nullable = element.has_repetition() && element.repetition() == Repetition::OPTIONAL;
            let width = if levels.0 == 1 { table.first_length(index, levels, nullable)? } else { 1 };
            for element in 0..width {
                table.owner.push((index, element));
                table.names.push(if levels.0 == 1 { format!("{name}[{element}]") } else { name.clone() });
            }
            let stamp = stamp(column).map(|seconds| (seconds, Cell::new(None)));
            table.leaves.push(Leaf { name, levels, nullable, width, stamp });
        }
        if table.names.is_empty() {
            return Err(LogError::Empty { file: file.into() });
        }
        Ok(table)
    }

    /// Number of elements of the first list of a column; 0 if they are not numbers, or too many.
    fn first_length(&self, index: usize, levels: (i16, i16), nullable: bool) -> Result<usize, LogError> {
        for group in 0..self.reader.num_row_groups() {
            let mut list = Lists::new(levels, nullable, LONGEST_LIST);
            let [reader] = &mut self.columns(group, &[index])?[..] else { return Ok(0) };
            if list.read(reader, 1).map_err(|e| failed(&self.file, e))?.is_none() {
                return Ok(0);
            }
            if let Some(first) = list.rows.first() {
                return Ok(if first.len() <= LONGEST_LIST { first.len() } else { 0 });
            }
        }
        Ok(0)
    }

    /// Readers for columns of a row group, counted from 0.
    fn columns(&self, group: usize, columns: &[usize]) -> Result<Vec<ColumnReader>, LogError> {
        directory::pages(&self.chunks, self.reader.metadata(), group, columns)
            .map_err(|e| LogError::Parquet { file: self.file.clone(), what: e.to_string() })?;
        let row_group = self.reader.get_row_group(group).map_err(|e| failed(&self.file, e))?;
        let readers: Result<Vec<ColumnReader>, _> =
            columns.iter().map(|&column| row_group.get_column_reader(column)).collect();
        readers.map_err(|e| failed(&self.file, e))
    }

    /// Opens the next row group that has rows; false at the end.
    fn open_group(&mut self) -> Result<bool, LogError> {
        while self.left == 0 {
            if self.group >= self.reader.num_row_groups() {
                return Ok(false);
            }
            self.left = usize::try_from(self.reader.metadata().row_group(self.group).num_rows()).unwrap_or(0);
            self.columns = self.columns(self.group, &self.wanted)?;
            self.group += 1;
        }
        Ok(true)
    }

    /// Appends `take` rows of the `k`-th selected leaf to the block.
    fn pull(&mut self, k: usize, take: usize, block: &mut Block) -> Result<(), LogError> {
        let leaf = &self.leaves[self.wanted[k]];
        let file = self.file.as_str();
        let no_numbers =
            || LogError::Parquet { file: file.into(), what: format!("the column `{}` holds no numbers", leaf.name) };
        // A directory that promises more rows than there are would cause an endless loop.
        let short = |n: usize| {
            let what = format!("the column `{}` ends {} rows before its row group", leaf.name, take - n);
            LogError::Parquet { file: file.into(), what }
        };
        let targets = || self.selected.iter().enumerate().filter(|(_, (place, _))| *place == k);
        let start = block.lines.len();
        if leaf.levels.0 == 0 {
            let Some((column, _)) = targets().next() else { return Ok(()) };
            let out = &mut block.columns[column];
            match numbers(&mut self.columns[k], leaf, take, out).map_err(|e| failed(file, e))? {
                Some(n) if n == take => Ok(()),
                Some(n) => Err(short(n)),
                None => Err(no_numbers()),
            }
        } else {
            let mut lists = Lists::new(leaf.levels, leaf.nullable, leaf.width);
            let n = lists.read(&mut self.columns[k], take).map_err(|e| failed(file, e))?.ok_or_else(no_numbers)?;
            if n != take {
                return Err(short(n));
            }
            for (row, list) in lists.rows.iter().enumerate() {
                if list.len() != leaf.width {
                    let text =
                        format!("{} elements in `{}` where the first row has {}", list.len(), leaf.name, leaf.width);
                    block.bad.push(BadCell { row: start + row, column: None, text });
                }
                for (column, (_, element)) in targets() {
                    block.columns[column].push(list.get(*element).copied().unwrap_or(f64::NAN));
                }
            }
            Ok(())
        }
    }
}

impl<C: ChunkReader + 'static> Table for ParquetTable<C> {
    fn names(&self) -> &[String] {
        &self.names
    }

    fn is_numeric(&self, position: usize) -> bool {
        let column = self.reader.metadata().file_metadata().schema_descr().column(self.owner[position].0);
        use ::parquet::basic::Type;
        matches!(column.physical_type(), Type::DOUBLE | Type::FLOAT | Type::INT32 | Type::INT64)
            && (column.max_rep_level() == 1 || column.max_def_level() <= 1)
    }

    fn select(&mut self, positions: &[usize], _clock: usize) -> Result<(), LogError> {
        self.wanted.clear();
        self.selected.clear();
        for &position in positions {
            let (leaf, element) = self.owner[position];
            if self.leaves[leaf].levels.0 == 0 && self.leaves[leaf].levels.1 > 1 {
                let what = format!("the column `{}` is nested; write plain numbers", self.leaves[leaf].name);
                return Err(LogError::Parquet { file: self.file.clone(), what });
            }
            let place = self.wanted.iter().position(|w| *w == leaf).unwrap_or_else(|| {
                self.wanted.push(leaf);
                self.wanted.len() - 1
            });
            self.selected.push((place, element));
        }
        Ok(())
    }

    fn next_rows(&mut self, rows: usize, block: &mut Block) -> Result<(), LogError> {
        while block.len() < rows && self.open_group()? {
            let take = self.left.min(rows - block.len());
            for k in 0..self.wanted.len() {
                self.pull(k, take, block)?;
            }
            block.lines.extend((0..take as u64).map(|i| self.row + i + 1));
            self.row += take as u64;
            self.left -= take;
        }
        Ok(())
    }
}

/// Longest list whose elements become columns.
const LONGEST_LIST: usize = 128;

/// Appends `take` rows of a numeric column and returns how many there were; `None` if not numeric.
fn numbers(
    reader: &mut ColumnReader,
    leaf: &Leaf,
    take: usize,
    out: &mut Vec<f64>,
) -> Result<Option<usize>, ParquetError> {
    let before = out.len();
    match (reader, &leaf.stamp) {
        // Differences of ns are exact; differences of seconds since an epoch are not.
        (ColumnReader::Int64ColumnReader(r), Some((seconds, first))) => {
            pull::<Int64Type>(r, take, out, |v| {
                let from = first.get().unwrap_or(v);
                first.set(Some(from));
                v.wrapping_sub(from) as f64 * seconds
            })?;
            Ok(Some(out.len() - before))
        }
        (reader, _) => plain_numbers(reader, leaf.levels.1 > 0, take, out),
    }
}

/// Does the same for a column whose values are in the unit of its role.
fn plain_numbers(
    reader: &mut ColumnReader,
    nullable: bool,
    take: usize,
    out: &mut Vec<f64>,
) -> Result<Option<usize>, ParquetError> {
    let before = out.len();
    match reader {
        // Non-nullable doubles are read directly to their destination.
        ColumnReader::DoubleColumnReader(r) if !nullable => {
            let mut left = take;
            while left > 0 {
                let (records, ..) = r.read_records(left, None, None, out)?;
                if records == 0 {
                    break;
                }
                left -= records;
            }
        }
        ColumnReader::DoubleColumnReader(r) => pull::<DoubleType>(r, take, out, |v| v)?,
        ColumnReader::FloatColumnReader(r) => pull::<FloatType>(r, take, out, f64::from)?,
        ColumnReader::Int32ColumnReader(r) => pull::<Int32Type>(r, take, out, f64::from)?,
        ColumnReader::Int64ColumnReader(r) => pull::<Int64Type>(r, take, out, |v| v as f64)?,
        _ => return Ok(None),
    }
    Ok(Some(out.len() - before))
}

/// Rows of a list column.
struct Lists {
    levels: (i16, i16),
    /// Whether an element may be null.
    nullable: bool,
    /// Number of elements kept of each list.
    width: usize,
    rows: Vec<Vec<f64>>,
}

impl Lists {
    fn new(levels: (i16, i16), nullable: bool, width: usize) -> Self {
        Self { levels, nullable, width, rows: Vec::new() }
    }

    /// Reads `take` lists and returns how many there were; `None` if the elements are not numbers.
    fn read(&mut self, reader: &mut ColumnReader, take: usize) -> Result<Option<usize>, ParquetError> {
        match reader {
            ColumnReader::DoubleColumnReader(r) => self.pull::<DoubleType>(r, take, |v| v)?,
            ColumnReader::FloatColumnReader(r) => self.pull::<FloatType>(r, take, f64::from)?,
            ColumnReader::Int32ColumnReader(r) => self.pull::<Int32Type>(r, take, f64::from)?,
            ColumnReader::Int64ColumnReader(r) => self.pull::<Int64Type>(r, take, |v| v as f64)?,
            _ => return Ok(None),
        }
        Ok(Some(self.rows.len()))
    }

    fn pull<T: DataType>(
        &mut self,
        reader: &mut ColumnReaderImpl<T>,
        take: usize,
        convert: impl Fn(T::T) -> f64,
    ) -> Result<(), ParquetError>
    where
        T::T: Clone,
    {
        while self.rows.len() < take {
            let (mut values, mut defined, mut repeated) = (Vec::new(), Vec::new(), Vec::new());
            let wanted = take - self.rows.len();
            let (records, ..) = reader.read_records(wanted, Some(&mut defined), Some(&mut repeated), &mut values)?;
            if records == 0 {
                break;
            }
            let mut next = values.into_iter();
            for (d, r) in defined.iter().zip(&repeated) {
                if *r == 0 {
                    self.rows.push(Vec::new());
                }
                let Some(row) = self.rows.last_mut() else { continue };
                let full = *d == self.levels.1;
                let value = if full { next.next().map_or(f64::NAN, &convert) } else { f64::NAN };
                // One level below a value is a null element (NaN), if elements may be null; lower
                // levels are empty lists.
                if (full || self.nullable && *d + 1 == self.levels.1) && row.len() <= self.width {
                    row.push(value);
                }
            }
        }
        Ok(())
    }
}

/// Appends `take` rows of a column, with NaN for nulls.
fn pull<T: DataType>(
    reader: &mut ColumnReaderImpl<T>,
    take: usize,
    out: &mut Vec<f64>,
    convert: impl Fn(T::T) -> f64,
) -> Result<(), ParquetError>
where
    T::T: Clone,
{
    let mut done = 0;
    while done < take {
        let (mut values, mut defined) = (Vec::with_capacity(take - done), Vec::new());
        let (records, found, _) = reader.read_records(take - done, Some(&mut defined), None, &mut values)?;
        if records == 0 {
            break;
        }
        let mut next = values.into_iter().take(found);
        if defined.is_empty() {
            out.extend(next.map(&convert));
        } else {
            let full = defined.iter().copied().max().unwrap_or(0).max(1);
            out.extend(
                defined.iter().map(|&d| if d == full { next.next().map_or(f64::NAN, &convert) } else { f64::NAN }),
            );
        }
        done += records;
    }
    Ok(())
}

fn failed(file: &str, error: ParquetError) -> LogError {
    let said = error.to_string();
    let what = match said.rsplit_once("Disabled feature at compile time: ") {
        Some((_, "zstd")) => "its columns are packed with zstd, which this build does not unpack; build it with `cargo install --path . --features \
                              parquet-zstd`, or write the file with compression snappy"
            .into(),
        Some((_, other)) => {
            format!("its columns are packed with {other}, which is not unpacked; write it with compression snappy")
        }
        None => said,
    };
    LogError::Parquet { file: file.into(), what }
}

/// Seconds per count of a time stamp column; `None` for other columns.
fn stamp(column: &ColumnDescriptor) -> Option<f64> {
    if let Some(LogicalType::Timestamp(stamp)) = column.logical_type_ref() {
        return Some(match stamp.unit {
            TimeUnit::MILLIS => 1e-3,
            TimeUnit::MICROS => 1e-6,
            TimeUnit::NANOS => 1e-9,
        });
    }
    match column.converted_type() {
        ConvertedType::TIMESTAMP_MILLIS => Some(1e-3),
        ConvertedType::TIMESTAMP_MICROS => Some(1e-6),
        _ => None,
    }
}

/// Writes a log as a Parquet file of doubles.
///
/// # Errors
/// Errors of the writer.
pub fn write<W: std::io::Write + Send>(log: &Log, out: W) -> Result<(), LogError> {
    let mut writer = ParquetWriter::new(&log.layout, out)?;
    writer.rows(&log.columns)?;
    writer.finish()
}

/// Rows of a row group: a few MB.
const GROUP: usize = 1 << 15;

/// Writes rows as a Parquet file of doubles incrementally.
pub struct ParquetWriter<W: std::io::Write + Send> {
    file: String,
    writer: SerializedFileWriter<W>,
    /// Buffered rows of the next row group.
    group: Vec<Vec<f64>>,
}

impl<W: std::io::Write + Send> ParquetWriter<W> {
    /// Starts the file.
    ///
    /// # Errors
    /// Errors of the writer.
    pub fn new(layout: &Layout, out: W) -> Result<Self, LogError> {
        let file = layout.file.clone();
        let fields: String = layout.roles.iter().map(|r| format!("REQUIRED DOUBLE {};", r.name())).collect();
        let schema =
            Arc::new(parse_message_type(&format!("message log {{ {fields} }}")).map_err(|e| failed(&file, e))?);
        let properties = WriterProperties::builder().set_compression(::parquet::basic::Compression::SNAPPY).build();
        let writer = SerializedFileWriter::new(out, schema, Arc::new(properties)).map_err(|e| failed(&file, e))?;
        Ok(Self { file, writer, group: vec![Vec::new(); layout.roles.len()] })
    }

    /// Writes rows: one vector per column.
    ///
    /// # Errors
    /// Errors of the writer.
    pub fn rows(&mut self, columns: &[Vec<f64>]) -> Result<(), LogError> {
        for (to, from) in self.group.iter_mut().zip(columns) {
            to.extend_from_slice(from);
        }
        while self.group.first().is_some_and(|column| column.len() >= GROUP) {
            self.write_group(GROUP)?;
        }
        Ok(())
    }

    /// Writes the buffered rows and the footer of the file.
    ///
    /// # Errors
    /// Errors of the writer.
    pub fn finish(mut self) -> Result<(), LogError> {
        let left = self.group.first().map_or(0, Vec::len);
        if left > 0 {
            self.write_group(left)?;
        }
        let Self { file, writer, .. } = self;
        writer.close().map(|_| ()).map_err(|e| failed(&file, e))
    }

    fn write_group(&mut self, rows: usize) -> Result<(), LogError> {
        let mut put = || -> Result<(), ParquetError> {
            let mut group = self.writer.next_row_group()?;
            for column in &mut self.group {
                if let Some(mut target) = group.next_column()? {
                    target.typed::<DoubleType>().write_batch(&column[..rows], None, None)?;
                    target.close()?;
                }
                column.drain(..rows);
            }
            group.close().map(|_| ())
        };
        put().map_err(|e| failed(&self.file, e))
    }
}
